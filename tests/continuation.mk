# tests of the core of continuation
test_programs += tests/continuation
tests_continuation_SOURCES = tests/cases.c \
	tests/unit/test-continuation.c
nodist_tests_continuation_SOURCES = tests/continuation-cases.c
tests_continuation_LDADD = $(UPTO_CONTINUATION)
