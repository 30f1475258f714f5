# tests of the stage rom
test_programs += tests/rom
tests_rom_SOURCES = tests/cases.c \
	tests/extremes/test-sweep-rom.c \
	tests/property/test-choose.c \
	tests/property/test-condense-bending.c \
	tests/property/test-line-answer.c \
	tests/property/test-line-loaded.c \
	tests/property/test-line-lanes.c \
	tests/property/test-line-carriers.c \
	tests/property/test-net-show.c \
	tests/property/test-net-span.c \
	tests/property/test-net-water-rom.c \
	tests/property/test-rom-absorber.c \
	tests/property/test-rom-answer.c \
	tests/property/test-rom-attached.c \
	tests/property/test-rom-auto.c \
	tests/property/test-rom-bending.c \
	tests/property/test-rom-condense.c \
	tests/property/test-rom-elastic.c \
	tests/property/test-rom-modal.c \
	tests/property/test-rom-energy.c \
	tests/property/test-rom-full.c \
	tests/property/test-rom-functions.c \
	tests/property/test-rom-inertia.c \
	tests/property/test-rom-loaded.c \
	tests/property/test-rom-space.c \
	tests/property/test-rom-swung.c \
	tests/property/test-rom-travel.c \
	tests/property/test-static-law.c \
	tests/unit/test-own-file.c \
	tests/unit/test-rom-build.c \
	tests/unit/test-rom-file.c \
	tests/unit/test-rom-full.c \
	tests/unit/test-rom-kernel.c \
	tests/unit/test-rom-memory.c
nodist_tests_rom_SOURCES = tests/rom-cases.c
tests_rom_LDADD = $(UPTO_ROM)
# What two scripts compare exported equations with.
test_helpers += tests/reference/rom-auto-export tests/reference/rom-export-values
tests_reference_rom_auto_export_SOURCES = tests/reference/rom-auto-export.c
tests_reference_rom_auto_export_LDADD = $(UPTO_ROM)
tests_reference_rom_export_values_SOURCES = tests/reference/rom-export-values.c
tests_reference_rom_export_values_LDADD = $(UPTO_ROM)
test_scripts += tests/reference/rom-auto.sh tests/reference/rom-export.sh
