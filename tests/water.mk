# tests of the loads of water
test_programs += tests/water
tests_water_SOURCES = tests/cases.c \
	tests/unit/test-drag.c \
	tests/unit/test-linear-drag.c \
	tests/unit/test-waves.c \
	tests/unit/test-wet.c
nodist_tests_water_SOURCES = tests/water-cases.c
tests_water_LDADD = $(UPTO_WATER)
