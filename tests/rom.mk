# tests of the rom stage
check_PROGRAMS += tests/unit/test-rom-kernel
TESTS += tests/unit/test-rom-kernel
tests_unit_test_rom_kernel_SOURCES = tests/unit/test-rom-kernel.c
tests_unit_test_rom_kernel_LDADD = $(UPTO_ROM)
