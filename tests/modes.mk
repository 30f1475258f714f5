# tests of the stage modes
test_programs += tests/modes
tests_modes_SOURCES = tests/cases.c \
	tests/extremes/modes-quad.c \
	tests/extremes/test-gyroscopic-sweep.c \
	tests/extremes/test-irvine.c \
	tests/extremes/test-modes-extremes.c \
	tests/extremes/test-modes-sweep.c \
	tests/extremes/test-traces-sweep.c \
	tests/property/test-campbell.c \
	tests/property/test-damped-bending.c \
	tests/property/test-gyroscopic.c \
	tests/property/test-irvine.c \
	tests/property/test-modes-absorber.c \
	tests/property/test-modes-attached.c \
	tests/property/test-modes-basis.c \
	tests/property/test-modes-bending.c \
	tests/property/test-modes-chain.c \
	tests/property/test-modes-compare.c \
	tests/property/test-modes-damped.c \
	tests/property/test-modes-elastic.c \
	tests/property/test-modes-estimate.c \
	tests/property/test-modes-methods.c \
	tests/property/test-modes-participation.c \
	tests/property/test-modes-space.c \
	tests/property/test-modes.c \
	tests/property/test-quadratic.c \
	tests/property/test-statics-yield.c \
	tests/reference/test-modes.c \
	tests/unit/test-gyroscopic.c \
	tests/unit/test-modes-grid.c
nodist_tests_modes_SOURCES = tests/modes-cases.c
tests_modes_LDADD = $(UPTO_MODES)
