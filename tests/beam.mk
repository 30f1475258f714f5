# tests of the beam stage, and of its motion
noinst_HEADERS += %D%/beam-near.h %D%/beam-shooting.h
BEAM_TESTS = tests/unit/test-beam-integrals tests/property/test-beam tests/property/test-beam-motion \
	tests/reference/test-beam tests/extremes/test-beam tests/extremes/test-beam-sweep
check_PROGRAMS += $(BEAM_TESTS)
TESTS += $(BEAM_TESTS)
tests_unit_test_beam_integrals_SOURCES = tests/unit/test-beam-integrals.c
tests_unit_test_beam_integrals_LDADD = $(UPTO_BEAM)
tests_property_test_beam_SOURCES = tests/property/test-beam.c
tests_property_test_beam_LDADD = $(UPTO_BEAM)
tests_property_test_beam_motion_SOURCES = tests/property/test-beam-motion.c
tests_property_test_beam_motion_LDADD = $(UPTO_RESPONSE)
tests_reference_test_beam_SOURCES = tests/reference/test-beam.c
tests_reference_test_beam_LDADD = $(UPTO_BEAM)
tests_extremes_test_beam_SOURCES = tests/extremes/test-beam.c
tests_extremes_test_beam_LDADD = $(UPTO_BEAM)
tests_extremes_test_beam_sweep_SOURCES = tests/extremes/test-beam-sweep.c
tests_extremes_test_beam_sweep_LDADD = $(UPTO_BEAM)
