# tests of geometrically exact rods
ROD_TESTS = tests/unit/test-rod-band tests/unit/test-rod-element tests/unit/test-rod-motion tests/unit/test-rod-winch tests/reference/test-rod-motion \
	tests/reference/test-rod-statics tests/property/test-rod tests/property/test-rod-winch tests/property/test-rod-cvode
check_PROGRAMS += $(ROD_TESTS)
TESTS += $(ROD_TESTS)
tests_unit_test_rod_band_SOURCES = tests/unit/test-rod-band.c
tests_unit_test_rod_band_LDADD = $(UPTO_ROD)
tests_unit_test_rod_element_SOURCES = tests/unit/test-rod-element.c
tests_unit_test_rod_element_LDADD = $(UPTO_ROD)
tests_reference_test_rod_statics_SOURCES = tests/reference/test-rod-statics.c
tests_reference_test_rod_statics_LDADD = $(UPTO_ROD)
tests_property_test_rod_SOURCES = tests/property/test-rod.c
tests_property_test_rod_LDADD = $(UPTO_ROD)
tests_unit_test_rod_motion_SOURCES = tests/unit/test-rod-motion.c
tests_unit_test_rod_motion_LDADD = $(UPTO_ROD)
tests_unit_test_rod_winch_SOURCES = tests/unit/test-rod-winch.c tests/rod-chain.h
tests_property_test_rod_winch_SOURCES = tests/property/test-rod-winch.c tests/rod-chain.h
tests_property_test_rod_winch_LDADD = $(UPTO_ROD)
tests_unit_test_rod_winch_LDADD = $(UPTO_ROD)
tests_reference_test_rod_motion_SOURCES = tests/reference/test-rod-motion.c
tests_reference_test_rod_motion_LDADD = $(UPTO_ROD)
tests_property_test_rod_cvode_SOURCES = tests/property/test-rod-cvode.c
tests_property_test_rod_cvode_LDADD = $(UPTO_ROD) $(SUNDIALS_LIBS) -lsundials_sunlinsolband -lsundials_sunmatrixband
