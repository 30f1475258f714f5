# sweeps of the stages from the reduced model on: tests/extremes/sweep.h, with the oracle of taylor.c
RESPONSE_SWEEPS = tests/extremes/test-sweep-rom tests/extremes/test-sweep-hill tests/extremes/test-sweep-frf \
	tests/extremes/test-sweep-integrate tests/extremes/test-sweep-folds tests/extremes/test-sweep-mms \
	tests/extremes/test-sweep-curves tests/extremes/test-sweep-load
check_PROGRAMS += $(RESPONSE_SWEEPS)
TESTS += $(RESPONSE_SWEEPS)
noinst_HEADERS += tests/extremes/taylor.h tests/extremes/reflect.h
SWEEP_ORACLE = tests/extremes/taylor.c
tests_extremes_test_sweep_rom_SOURCES = tests/extremes/test-sweep-rom.c
tests_extremes_test_sweep_rom_LDADD = $(UPTO_ROM)
tests_extremes_test_sweep_hill_SOURCES = tests/extremes/test-sweep-hill.c $(SWEEP_ORACLE)
tests_extremes_test_sweep_hill_LDADD = $(UPTO_STUDY)
tests_extremes_test_sweep_frf_SOURCES = tests/extremes/test-sweep-frf.c $(SWEEP_ORACLE)
tests_extremes_test_sweep_frf_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_sweep_integrate_SOURCES = tests/extremes/test-sweep-integrate.c $(SWEEP_ORACLE)
tests_extremes_test_sweep_integrate_LDADD = $(UPTO_RESPONSE) $(GSL_LIBS)
tests_extremes_test_sweep_folds_SOURCES = tests/extremes/test-sweep-folds.c
tests_extremes_test_sweep_folds_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_sweep_mms_SOURCES = tests/extremes/test-sweep-mms.c $(SWEEP_ORACLE)
tests_extremes_test_sweep_mms_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_sweep_curves_SOURCES = tests/extremes/test-sweep-curves.c $(SWEEP_ORACLE)
tests_extremes_test_sweep_curves_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_sweep_load_SOURCES = tests/extremes/test-sweep-load.c
tests_extremes_test_sweep_load_LDADD = $(UPTO_RESPONSE)
