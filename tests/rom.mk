# tests of the rom stage
check_PROGRAMS += tests/unit/test-rom-kernel
TESTS += tests/unit/test-rom-kernel
tests_unit_test_rom_kernel_SOURCES = tests/unit/test-rom-kernel.c
tests_unit_test_rom_kernel_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-energy
TESTS += tests/property/test-rom-energy
tests_property_test_rom_energy_SOURCES = tests/property/test-rom-energy.c
tests_property_test_rom_energy_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/unit/test-rom-memory
TESTS += tests/unit/test-rom-memory
tests_unit_test_rom_memory_SOURCES = tests/unit/test-rom-memory.c
tests_unit_test_rom_memory_LDADD =

check_PROGRAMS += tests/unit/test-rom-build
TESTS += tests/unit/test-rom-build
tests_unit_test_rom_build_SOURCES = tests/unit/test-rom-build.c
tests_unit_test_rom_build_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/unit/test-rom-file
TESTS += tests/unit/test-rom-file
tests_unit_test_rom_file_SOURCES = tests/unit/test-rom-file.c
tests_unit_test_rom_file_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/reference/rom-auto-export
tests_reference_rom_auto_export_SOURCES = tests/reference/rom-auto-export.c
tests_reference_rom_auto_export_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-auto
TESTS += tests/property/test-rom-auto
tests_property_test_rom_auto_SOURCES = tests/property/test-rom-auto.c
tests_property_test_rom_auto_LDADD = $(UPTO_ROM)

TESTS += tests/reference/rom-auto.sh
EXTRA_DIST += tests/reference/rom-auto.sh

check_PROGRAMS += tests/property/test-rom-functions
TESTS += tests/property/test-rom-functions
tests_property_test_rom_functions_SOURCES = tests/property/test-rom-functions.c
tests_property_test_rom_functions_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-answer tests/property/test-rom-condense
TESTS += tests/property/test-rom-answer tests/property/test-rom-condense
tests_property_test_rom_answer_SOURCES = tests/property/test-rom-answer.c tests/velocity.h
tests_property_test_rom_answer_LDADD = $(UPTO_ROM)
tests_property_test_rom_condense_SOURCES = tests/property/test-rom-condense.c
tests_property_test_rom_condense_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-inertia
TESTS += tests/property/test-rom-inertia
tests_property_test_rom_inertia_SOURCES = tests/property/test-rom-inertia.c
tests_property_test_rom_inertia_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-full
TESTS += tests/property/test-rom-full
tests_property_test_rom_full_SOURCES = tests/property/test-rom-full.c
tests_property_test_rom_full_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/unit/test-rom-full
TESTS += tests/unit/test-rom-full
tests_unit_test_rom_full_SOURCES = tests/unit/test-rom-full.c
tests_unit_test_rom_full_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-choose
TESTS += tests/property/test-choose
tests_property_test_choose_SOURCES = tests/property/test-choose.c
tests_property_test_choose_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-travel
TESTS += tests/property/test-rom-travel
tests_property_test_rom_travel_SOURCES = tests/property/test-rom-travel.c
tests_property_test_rom_travel_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-swung
TESTS += tests/property/test-rom-swung
tests_property_test_rom_swung_SOURCES = tests/property/test-rom-swung.c
tests_property_test_rom_swung_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-absorber
TESTS += tests/property/test-rom-absorber
tests_property_test_rom_absorber_SOURCES = tests/property/test-rom-absorber.c
tests_property_test_rom_absorber_LDADD = $(UPTO_ROM)
check_PROGRAMS += tests/property/test-rom-attached
TESTS += tests/property/test-rom-attached
tests_property_test_rom_attached_SOURCES = tests/property/test-rom-attached.c
tests_property_test_rom_attached_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-elastic
TESTS += tests/property/test-rom-elastic
tests_property_test_rom_elastic_SOURCES = tests/property/test-rom-elastic.c
tests_property_test_rom_elastic_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/property/test-rom-bending
TESTS += tests/property/test-rom-bending
tests_property_test_rom_bending_SOURCES = tests/property/test-rom-bending.c
tests_property_test_rom_bending_LDADD = $(UPTO_ROM)
check_PROGRAMS += tests/property/test-rom-space
TESTS += tests/property/test-rom-space
tests_property_test_rom_space_SOURCES = tests/property/test-rom-space.c
tests_property_test_rom_space_LDADD = $(UPTO_ROM)
check_PROGRAMS += tests/property/test-condense-bending
TESTS += tests/property/test-condense-bending
tests_property_test_condense_bending_SOURCES = tests/property/test-condense-bending.c
tests_property_test_condense_bending_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/unit/test-own-file
TESTS += tests/unit/test-own-file
tests_unit_test_own_file_SOURCES = tests/unit/test-own-file.c
tests_unit_test_own_file_LDADD = $(UPTO_ROM)

check_PROGRAMS += tests/reference/rom-export-values
tests_reference_rom_export_values_SOURCES = tests/reference/rom-export-values.c
tests_reference_rom_export_values_LDADD = $(UPTO_ROM)
TESTS += tests/reference/rom-export.sh
EXTRA_DIST += tests/reference/rom-export.sh
