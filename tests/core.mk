# tests of the core and of the continuation
check_PROGRAMS += tests/unit/test-status
TESTS += tests/unit/test-status
tests_unit_test_status_SOURCES = tests/unit/test-status.c
tests_unit_test_status_LDADD = $(UPTO_CORE)

check_PROGRAMS += tests/unit/test-digits
TESTS += tests/unit/test-digits
tests_unit_test_digits_SOURCES = tests/unit/test-digits.c
tests_unit_test_digits_LDADD = $(UPTO_CORE) -lm

check_PROGRAMS += tests/unit/test-progress
TESTS += tests/unit/test-progress
tests_unit_test_progress_SOURCES = tests/unit/test-progress.c
tests_unit_test_progress_LDADD = $(UPTO_CORE)

check_PROGRAMS += tests/unit/test-ranks
TESTS += tests/unit/test-ranks
tests_unit_test_ranks_SOURCES = tests/unit/test-ranks.c
tests_unit_test_ranks_LDADD = $(UPTO_CORE)

check_PROGRAMS += tests/unit/test-continuation
TESTS += tests/unit/test-continuation
tests_unit_test_continuation_SOURCES = tests/unit/test-continuation.c
tests_unit_test_continuation_LDADD = $(UPTO_CONTINUATION)
