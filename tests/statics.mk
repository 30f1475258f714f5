# tests of the stage statics
test_programs += tests/statics
tests_statics_SOURCES = tests/cases.c \
	tests/extremes/test-statics-corners.c \
	tests/extremes/test-statics-sweep.c \
	tests/property/test-static-load.c \
	tests/property/test-statics-loaded.c \
	tests/property/test-statics-models.c \
	tests/property/test-statics-random.c \
	tests/property/test-statics-space.c \
	tests/property/test-travel.c \
	tests/reference/test-statics-cases.c \
	tests/reference/test-statics-spans.c \
	tests/unit/test-plausible.c \
	tests/unit/test-statics.c \
	tests/unit/test-wind.c
nodist_tests_statics_SOURCES = tests/statics-cases.c
tests_statics_LDADD = $(UPTO_STATICS)
EXTRA_DIST += tests/reference/statics-spans.tsv tests/reference/make-statics-spans.py
