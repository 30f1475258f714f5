# tests of tables, columns and axes
test_programs += tests/output
tests_output_SOURCES = tests/cases.c \
	tests/unit/test-axis.c \
	tests/unit/test-fields-computed.c \
	tests/unit/test-fields-read.c \
	tests/unit/test-fields.c \
	tests/unit/test-output.c \
	src/cli/model/axis.c
nodist_tests_output_SOURCES = tests/output-cases.c
tests_output_LDADD = src/output/.libs/liboutput.a $(UPTO_STUDY)
