# tests of the modes stage
noinst_HEADERS += %D%/extremes/modes-count.h %D%/extremes/modes-quad.h
noinst_HEADERS += %D%/modes-span.h %D%/modes-shooting.h %D%/modes-scene.h %D%/modes-third.h %D%/rom-condensed.h %D%/rom-eigenvalue.h
MODES_TESTS = \
	tests/unit/test-modes-grid \
	tests/property/test-modes \
	tests/property/test-modes-chain \
	tests/property/test-modes-methods \
	tests/property/test-modes-participation \
	tests/property/test-modes-compare \
	tests/property/test-modes-estimate \
	tests/reference/test-modes \
	tests/extremes/test-modes-extremes
check_PROGRAMS += $(MODES_TESTS)
TESTS += $(MODES_TESTS)
tests_unit_test_modes_grid_SOURCES = tests/unit/test-modes-grid.c
tests_unit_test_modes_grid_LDADD = $(UPTO_MODES)
tests_property_test_modes_SOURCES = tests/property/test-modes.c
tests_property_test_modes_LDADD = $(UPTO_MODES)
tests_property_test_modes_chain_SOURCES = tests/property/test-modes-chain.c
tests_property_test_modes_chain_LDADD = $(UPTO_MODES)
tests_property_test_modes_methods_SOURCES = tests/property/test-modes-methods.c
tests_property_test_modes_methods_LDADD = $(UPTO_MODES)
tests_property_test_modes_participation_SOURCES = tests/property/test-modes-participation.c
tests_property_test_modes_participation_LDADD = $(UPTO_MODES)
tests_property_test_modes_estimate_SOURCES = tests/property/test-modes-estimate.c
tests_property_test_modes_estimate_LDADD = $(UPTO_MODES)
tests_reference_test_modes_SOURCES = tests/reference/test-modes.c
tests_reference_test_modes_LDADD = $(UPTO_MODES)
tests_extremes_test_modes_extremes_SOURCES = tests/extremes/test-modes-extremes.c
tests_extremes_test_modes_extremes_LDADD = $(UPTO_MODES)
# sweeps
IRVINE_TESTS = tests/property/test-irvine tests/extremes/test-irvine tests/property/test-campbell
check_PROGRAMS += $(IRVINE_TESTS)
TESTS += $(IRVINE_TESTS)
tests_property_test_campbell_SOURCES = tests/property/test-campbell.c
tests_property_test_campbell_LDADD = $(UPTO_MODES)
tests_property_test_irvine_SOURCES = tests/property/test-irvine.c
tests_property_test_irvine_LDADD = $(UPTO_MODES)
tests_extremes_test_irvine_SOURCES = tests/extremes/test-irvine.c
tests_extremes_test_irvine_LDADD = $(UPTO_MODES)
tests_property_test_modes_compare_SOURCES = tests/property/test-modes-compare.c
tests_property_test_modes_compare_LDADD = $(UPTO_MODES)

check_PROGRAMS += tests/property/test-modes-basis
TESTS += tests/property/test-modes-basis
tests_property_test_modes_basis_SOURCES = tests/property/test-modes-basis.c
tests_property_test_modes_basis_LDADD = $(UPTO_MODES)

noinst_HEADERS += %D%/gyroscopic-shooting.h %D%/gyroscopic-span.h
GYROSCOPIC_TESTS = tests/unit/test-gyroscopic tests/property/test-gyroscopic
check_PROGRAMS += $(GYROSCOPIC_TESTS)
TESTS += $(GYROSCOPIC_TESTS)
tests_unit_test_gyroscopic_SOURCES = tests/unit/test-gyroscopic.c
tests_unit_test_gyroscopic_LDADD = $(UPTO_MODES)
tests_property_test_gyroscopic_SOURCES = tests/property/test-gyroscopic.c
tests_property_test_gyroscopic_LDADD = $(UPTO_MODES)

check_PROGRAMS += tests/property/test-quadratic
TESTS += tests/property/test-quadratic
tests_property_test_quadratic_SOURCES = tests/property/test-quadratic.c
tests_property_test_quadratic_LDADD = $(UPTO_MODES)

MODES_SWEEPS = tests/extremes/test-modes-sweep tests/extremes/test-gyroscopic-sweep
check_PROGRAMS += $(MODES_SWEEPS)
TESTS += $(MODES_SWEEPS)
tests_extremes_test_modes_sweep_SOURCES = tests/extremes/test-modes-sweep.c tests/extremes/modes-quad.c
tests_extremes_test_modes_sweep_LDADD = $(UPTO_MODES)
tests_extremes_test_gyroscopic_sweep_SOURCES = tests/extremes/test-gyroscopic-sweep.c
tests_extremes_test_gyroscopic_sweep_LDADD = $(UPTO_MODES)

noinst_HEADERS += %D%/extremes/traces-check.h %D%/extremes/traces-judge.h
check_PROGRAMS += tests/extremes/test-traces-sweep
TESTS += tests/extremes/test-traces-sweep
tests_extremes_test_traces_sweep_SOURCES = tests/extremes/test-traces-sweep.c
tests_extremes_test_traces_sweep_LDADD = $(UPTO_MODES)

check_PROGRAMS += tests/property/test-modes-attached
TESTS += tests/property/test-modes-attached
tests_property_test_modes_attached_SOURCES = tests/property/test-modes-attached.c
tests_property_test_modes_attached_LDADD = $(UPTO_MODES)

check_PROGRAMS += tests/property/test-modes-damped
TESTS += tests/property/test-modes-damped
tests_property_test_modes_damped_SOURCES = tests/property/test-modes-damped.c
tests_property_test_modes_damped_LDADD = $(UPTO_MODES)
check_PROGRAMS += tests/property/test-modes-absorber
TESTS += tests/property/test-modes-absorber
tests_property_test_modes_absorber_SOURCES = tests/property/test-modes-absorber.c
tests_property_test_modes_absorber_LDADD = $(UPTO_MODES)
check_PROGRAMS += tests/property/test-damped-bending
TESTS += tests/property/test-damped-bending
tests_property_test_damped_bending_SOURCES = tests/property/test-damped-bending.c
tests_property_test_damped_bending_LDADD = $(UPTO_MODES)
check_PROGRAMS += tests/property/test-modes-elastic
TESTS += tests/property/test-modes-elastic
tests_property_test_modes_elastic_SOURCES = tests/property/test-modes-elastic.c
tests_property_test_modes_elastic_LDADD = $(UPTO_MODES)

check_PROGRAMS += tests/property/test-modes-bending
TESTS += tests/property/test-modes-bending
tests_property_test_modes_bending_SOURCES = tests/property/test-modes-bending.c
tests_property_test_modes_bending_LDADD = $(UPTO_MODES)
check_PROGRAMS += tests/property/test-modes-space
TESTS += tests/property/test-modes-space
tests_property_test_modes_space_SOURCES = tests/property/test-modes-space.c tests/lumped-chain.h
tests_property_test_modes_space_LDADD = $(UPTO_MODES) $(LAPACKE_LIBS)

check_PROGRAMS += tests/property/test-statics-yield
TESTS += tests/property/test-statics-yield
tests_property_test_statics_yield_SOURCES = tests/property/test-statics-yield.c tests/lumped-chain.h
tests_property_test_statics_yield_LDADD = $(UPTO_MODES) $(LAPACKE_LIBS)
