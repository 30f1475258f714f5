# tests of the study stage: fidelities, plans and comparisons
STUDY_TESTS = tests/unit/test-study-landmarks tests/property/test-study tests/property/test-study-scales
check_PROGRAMS += $(STUDY_TESTS)
TESTS += $(STUDY_TESTS)
tests_unit_test_study_landmarks_SOURCES = tests/unit/test-study-landmarks.c
tests_unit_test_study_landmarks_LDADD = $(UPTO_STUDY)
tests_property_test_study_SOURCES = tests/property/test-study.c
tests_property_test_study_LDADD = $(UPTO_STUDY)
tests_property_test_study_scales_SOURCES = tests/property/test-study-scales.c
tests_property_test_study_scales_LDADD = $(UPTO_STUDY)

check_PROGRAMS += tests/property/test-accuracy
TESTS += tests/property/test-accuracy
tests_property_test_accuracy_SOURCES = tests/property/test-accuracy.c
tests_property_test_accuracy_LDADD = $(UPTO_STUDY)

check_PROGRAMS += tests/property/test-study-chosen
TESTS += tests/property/test-study-chosen
tests_property_test_study_chosen_SOURCES = tests/property/test-study-chosen.c
tests_property_test_study_chosen_LDADD = $(UPTO_STUDY)
check_PROGRAMS += tests/property/test-estimates
TESTS += tests/property/test-estimates
tests_property_test_estimates_SOURCES = tests/property/test-estimates.c $(ESTIMATES_SOURCES)
tests_property_test_estimates_LDADD = $(UPTO_STUDY)
MAP_TESTS = tests/unit/test-guards tests/unit/test-guards-branches tests/unit/test-linear tests/unit/test-map tests/property/test-map-threads tests/reference/test-map-mathieu
noinst_HEADERS += tests/map-fields.h
check_PROGRAMS += $(MAP_TESTS)
TESTS += $(MAP_TESTS)
tests_unit_test_linear_SOURCES = tests/unit/test-linear.c
tests_unit_test_linear_LDADD = $(UPTO_RESPONSE)
tests_unit_test_guards_SOURCES = tests/unit/test-guards.c
tests_unit_test_guards_LDADD = $(UPTO_STUDY)
tests_unit_test_guards_branches_SOURCES = tests/unit/test-guards-branches.c
tests_unit_test_guards_branches_LDADD = $(UPTO_STUDY)
tests_unit_test_map_SOURCES = tests/unit/test-map.c
tests_unit_test_map_LDADD = $(UPTO_STUDY)
tests_property_test_map_threads_SOURCES = tests/property/test-map-threads.c
tests_property_test_map_threads_LDADD = $(UPTO_STUDY)
tests_reference_test_map_mathieu_SOURCES = tests/reference/test-map-mathieu.c
tests_reference_test_map_mathieu_LDADD = $(UPTO_STUDY)
# boundaries of stability
check_PROGRAMS += tests/reference/test-hill
TESTS += tests/reference/test-hill
tests_reference_test_hill_SOURCES = tests/reference/test-hill.c
tests_reference_test_hill_LDADD = $(UPTO_STUDY)
check_PROGRAMS += tests/property/test-primary
TESTS += tests/property/test-primary
tests_property_test_primary_SOURCES = tests/property/test-primary.c
tests_property_test_primary_LDADD = $(UPTO_STUDY)
check_PROGRAMS += tests/property/test-decay
TESTS += tests/property/test-decay
tests_property_test_decay_SOURCES = tests/property/test-decay.c
tests_property_test_decay_LDADD = $(UPTO_STUDY)
# map, hill, frf: the same answers
check_PROGRAMS += tests/property/test-same-stability
TESTS += tests/property/test-same-stability
tests_property_test_same_stability_SOURCES = tests/property/test-same-stability.c
tests_property_test_same_stability_LDADD = $(UPTO_STUDY)
