# tests of the stage beam
test_programs += tests/beam
tests_beam_SOURCES = tests/cases.c \
	tests/extremes/test-beam-sweep.c \
	tests/extremes/test-beam.c \
	tests/property/test-beam.c \
	tests/reference/test-beam.c \
	tests/unit/test-beam-integrals.c
nodist_tests_beam_SOURCES = tests/beam-cases.c
tests_beam_LDADD = $(UPTO_BEAM)
