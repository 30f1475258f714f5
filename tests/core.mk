# tests of the core
test_programs += tests/core
tests_core_SOURCES = tests/cases.c \
	tests/unit/test-digits.c \
	tests/unit/test-progress.c \
	tests/unit/test-ranks.c \
	tests/unit/test-status.c
nodist_tests_core_SOURCES = tests/core-cases.c
tests_core_LDADD = $(UPTO_CORE)
