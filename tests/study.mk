# tests of the study stage: fidelities, plans and comparisons
STUDY_TESTS = tests/property/test-study
check_PROGRAMS += $(STUDY_TESTS)
TESTS += $(STUDY_TESTS)
tests_property_test_study_SOURCES = tests/property/test-study.c
tests_property_test_study_LDADD = $(UPTO_STUDY)
