# tests of the statics stage
noinst_HEADERS += tests/statics-draw.h tests/extremes/sweep.h tests/extremes/statics-quad.h
EXTRA_DIST += tests/reference/statics-spans.tsv tests/reference/make-statics-spans.py

STATICS_TESTS = tests/unit/test-statics tests/unit/test-plausible tests/property/test-statics-models \
	tests/property/test-statics-random tests/property/test-statics-loaded \
	tests/property/test-statics-space \
	tests/property/test-travel tests/property/test-static-load \
	tests/reference/test-statics-spans tests/reference/test-statics-cases \
	tests/extremes/test-statics-corners tests/extremes/test-statics-sweep
check_PROGRAMS += $(STATICS_TESTS)
TESTS += $(STATICS_TESTS)
tests_unit_test_plausible_SOURCES = tests/unit/test-plausible.c
tests_unit_test_plausible_LDADD = $(UPTO_STATICS)
tests_unit_test_statics_SOURCES = tests/unit/test-statics.c
tests_unit_test_statics_LDADD = $(UPTO_STATICS)
tests_property_test_statics_random_SOURCES = tests/property/test-statics-random.c
tests_property_test_statics_random_LDADD = $(UPTO_STATICS)
tests_reference_test_statics_spans_SOURCES = tests/reference/test-statics-spans.c
tests_reference_test_statics_spans_LDADD = $(UPTO_STATICS)
tests_reference_test_statics_cases_SOURCES = tests/reference/test-statics-cases.c
tests_reference_test_statics_cases_LDADD = $(UPTO_STATICS)
tests_extremes_test_statics_corners_SOURCES = tests/extremes/test-statics-corners.c
tests_extremes_test_statics_corners_LDADD = $(UPTO_STATICS)
tests_property_test_statics_models_SOURCES = tests/property/test-statics-models.c
tests_property_test_statics_models_LDADD = $(UPTO_STATICS)
tests_property_test_travel_SOURCES = tests/property/test-travel.c
tests_property_test_travel_LDADD = $(UPTO_STATICS)
tests_extremes_test_statics_sweep_SOURCES = tests/extremes/test-statics-sweep.c
tests_extremes_test_statics_sweep_LDADD = $(UPTO_STATICS)
tests_property_test_statics_loaded_SOURCES = tests/property/test-statics-loaded.c
tests_property_test_statics_loaded_LDADD = $(UPTO_STATICS)
tests_property_test_static_load_SOURCES = tests/property/test-static-load.c
tests_property_test_static_load_LDADD = $(UPTO_STATICS)
tests_property_test_statics_space_SOURCES = tests/property/test-statics-space.c
tests_property_test_statics_space_LDADD = $(UPTO_STATICS)
