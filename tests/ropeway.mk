# tests of ropes over sheaves
test_programs += tests/ropeway
tests_ropeway_SOURCES = tests/cases.c \
	tests/property/test-line-expand.c \
	tests/property/test-line-modes-gradient.c \
	tests/property/test-line-random.c \
	tests/property/test-ropeway.c \
	tests/property/test-transient.c \
	tests/reference/test-line-closed.c \
	tests/reference/test-line-modes.c \
	tests/reference/test-line.c \
	tests/reference/test-obstacles.c
nodist_tests_ropeway_SOURCES = tests/ropeway-cases.c
tests_ropeway_LDADD = $(UPTO_ROPEWAY)
