# tests of the stage study
test_programs += tests/study
tests_study_SOURCES = tests/cases.c \
	tests/extremes/taylor.c \
	tests/extremes/test-sweep-hill.c \
	tests/property/test-accuracy.c \
	tests/property/test-accuracy-once.c \
	tests/property/test-basins.c \
	tests/property/test-carry.c \
	tests/property/test-decay.c \
	tests/property/test-estimates.c \
	tests/property/test-family.c \
	tests/property/test-fixed.c \
	tests/property/test-hill-boundaries.c \
	tests/property/test-identify-bending.c \
	tests/property/test-identify.c \
	tests/property/test-map-rows.c \
	tests/property/test-map-threads.c \
	tests/property/test-plan.c \
	tests/property/test-primary.c \
	tests/property/test-rom-known.c \
	tests/property/test-same-stability.c \
	tests/property/test-study-chosen.c \
	tests/property/test-study-scales.c \
	tests/property/test-study.c \
	tests/property/test-tongues.c \
	tests/reference/test-accuracy.c \
	tests/reference/test-certificate.c \
	tests/reference/test-hill.c \
	tests/reference/test-map-gallop.c \
	tests/reference/test-map-mathieu.c \
	tests/reference/test-span-motion.c \
	tests/reference/test-response-edges.c \
	tests/reference/test-tongues.c \
	tests/unit/test-estimate-truth.c \
	tests/unit/test-guards-branches.c \
	tests/unit/test-guards.c \
	tests/unit/test-map.c \
	tests/unit/test-study-landmarks.c \
	$(ESTIMATES_SOURCES)
nodist_tests_study_SOURCES = tests/study-cases.c
tests_study_LDADD = $(UPTO_STUDY)
