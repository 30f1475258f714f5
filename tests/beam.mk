# tests of the beam stage
BEAM_TESTS = tests/unit/test-beam-integrals
check_PROGRAMS += $(BEAM_TESTS)
TESTS += $(BEAM_TESTS)
tests_unit_test_beam_integrals_SOURCES = tests/unit/test-beam-integrals.c
tests_unit_test_beam_integrals_LDADD = $(UPTO_BEAM)
