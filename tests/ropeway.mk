# tests of ropes over sheaves
LINE_TESTS = tests/reference/test-line
check_PROGRAMS += $(LINE_TESTS)
TESTS += $(LINE_TESTS)
tests_reference_test_line_SOURCES = tests/reference/test-line.c
tests_reference_test_line_LDADD = $(UPTO_ROPEWAY)
