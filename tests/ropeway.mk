# tests of ropes over sheaves
LINE_TESTS = tests/reference/test-line tests/reference/test-line-closed tests/property/test-line-random
check_PROGRAMS += $(LINE_TESTS)
TESTS += $(LINE_TESTS)
tests_reference_test_line_SOURCES = tests/reference/test-line.c
tests_reference_test_line_LDADD = $(UPTO_ROPEWAY)
tests_reference_test_line_closed_SOURCES = tests/reference/test-line-closed.c
tests_reference_test_line_closed_LDADD = $(UPTO_ROPEWAY)
tests_property_test_line_random_SOURCES = tests/property/test-line-random.c
tests_property_test_line_random_LDADD = $(UPTO_ROPEWAY)
noinst_HEADERS += tests/line-judge.h tests/line-random.h

LINE_MODES_TESTS = tests/reference/test-line-modes tests/property/test-line-modes-gradient
check_PROGRAMS += $(LINE_MODES_TESTS)
TESTS += $(LINE_MODES_TESTS)
tests_reference_test_line_modes_SOURCES = tests/reference/test-line-modes.c
tests_reference_test_line_modes_LDADD = $(UPTO_ROPEWAY)
tests_property_test_line_modes_gradient_SOURCES = tests/property/test-line-modes-gradient.c
tests_property_test_line_modes_gradient_LDADD = $(UPTO_ROPEWAY)
noinst_HEADERS += tests/line-mesh.h
ROPEWAY_TESTS = tests/property/test-ropeway tests/property/test-transient
check_PROGRAMS += $(ROPEWAY_TESTS)
TESTS += $(ROPEWAY_TESTS)
tests_property_test_ropeway_SOURCES = tests/property/test-ropeway.c
tests_property_test_ropeway_LDADD = $(UPTO_ROPEWAY)
tests_property_test_transient_SOURCES = tests/property/test-transient.c
tests_property_test_transient_LDADD = $(UPTO_ROPEWAY)

# energy and nonlinear models of ropes over sheaves
LINE_ROM_TESTS = tests/property/test-line-carriers tests/property/test-line-expand tests/property/test-line-rom
check_PROGRAMS += $(LINE_ROM_TESTS)
TESTS += $(LINE_ROM_TESTS)
tests_property_test_line_carriers_SOURCES = tests/property/test-line-carriers.c
tests_property_test_line_carriers_LDADD = $(UPTO_ROM)
tests_property_test_line_expand_SOURCES = tests/property/test-line-expand.c
tests_property_test_line_expand_LDADD = $(UPTO_ROPEWAY)
tests_property_test_line_rom_SOURCES = tests/property/test-line-rom.c
tests_property_test_line_rom_LDADD = $(UPTO_RESPONSE)

OBSTACLES_TESTS = tests/reference/test-obstacles
check_PROGRAMS += $(OBSTACLES_TESTS)
TESTS += $(OBSTACLES_TESTS)
tests_reference_test_obstacles_SOURCES = tests/reference/test-obstacles.c
tests_reference_test_obstacles_LDADD = $(UPTO_ROPEWAY)
