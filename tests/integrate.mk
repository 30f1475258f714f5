# tests of time integration and spectra
noinst_HEADERS += tests/integrate-models.h
INTEGRATE_TESTS = \
	tests/unit/test-integrate \
	tests/unit/test-integrate-spectrum \
	tests/unit/test-surge \
	tests/property/test-history \
	tests/property/test-motion \
	tests/property/test-integrate-long \
	tests/property/test-integrate-stiff \
	tests/property/test-integrate-swept \
	tests/property/test-integrate-tolerance \
	tests/extremes/test-integrate-late \
	tests/extremes/test-integrate-memory
check_PROGRAMS += $(INTEGRATE_TESTS)
TESTS += $(INTEGRATE_TESTS)
tests_unit_test_surge_SOURCES = tests/unit/test-surge.c tests/travel-chain.h
tests_unit_test_surge_LDADD = $(UPTO_RESPONSE)
tests_unit_test_integrate_SOURCES = tests/unit/test-integrate.c
tests_unit_test_integrate_LDADD = $(UPTO_RESPONSE)
tests_unit_test_integrate_spectrum_SOURCES = tests/unit/test-integrate-spectrum.c
tests_unit_test_integrate_spectrum_LDADD = $(UPTO_RESPONSE)
tests_property_test_integrate_long_SOURCES = tests/property/test-integrate-long.c
tests_property_test_integrate_long_LDADD = $(UPTO_RESPONSE) $(GSL_LIBS)
tests_property_test_integrate_stiff_SOURCES = tests/property/test-integrate-stiff.c
tests_property_test_integrate_stiff_LDADD = $(UPTO_RESPONSE)
tests_property_test_integrate_tolerance_SOURCES = tests/property/test-integrate-tolerance.c
tests_property_test_integrate_tolerance_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_integrate_late_SOURCES = tests/extremes/test-integrate-late.c
tests_extremes_test_integrate_late_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_integrate_memory_SOURCES = tests/extremes/test-integrate-memory.c
tests_extremes_test_integrate_memory_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/property/test-absorber-motion
TESTS += tests/property/test-absorber-motion
tests_property_test_absorber_motion_SOURCES = tests/property/test-absorber-motion.c
tests_property_test_absorber_motion_LDADD = $(UPTO_RESPONSE)
check_PROGRAMS += tests/property/test-rom-full-motion
TESTS += tests/property/test-rom-full-motion
tests_property_test_rom_full_motion_SOURCES = tests/property/test-rom-full-motion.c
tests_property_test_rom_full_motion_LDADD = $(UPTO_RESPONSE)
tests_property_test_integrate_swept_SOURCES = tests/property/test-integrate-swept.c
tests_property_test_integrate_swept_LDADD = $(UPTO_RESPONSE)
tests_property_test_history_SOURCES = tests/property/test-history.c
tests_property_test_history_LDADD = $(UPTO_RESPONSE)
check_PROGRAMS += tests/property/test-absorber-response
TESTS += tests/property/test-absorber-response
tests_property_test_absorber_response_SOURCES = tests/property/test-absorber-response.c
tests_property_test_absorber_response_LDADD = $(UPTO_RESPONSE)
tests_property_test_motion_SOURCES = tests/property/test-motion.c tests/lumped-chain.h
tests_property_test_motion_LDADD = $(UPTO_RESPONSE)
check_PROGRAMS += tests/property/test-lyapunov
TESTS += tests/property/test-lyapunov
tests_property_test_lyapunov_SOURCES = tests/property/test-lyapunov.c
tests_property_test_lyapunov_LDADD = $(UPTO_RESPONSE)
check_PROGRAMS += tests/property/test-torus
TESTS += tests/property/test-torus
tests_property_test_torus_SOURCES = tests/property/test-torus.c
tests_property_test_torus_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/property/test-tori
TESTS += tests/property/test-tori
tests_property_test_tori_SOURCES = tests/property/test-tori.c
tests_property_test_tori_LDADD = $(UPTO_RESPONSE)
