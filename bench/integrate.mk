# work and precision of time integration
EXTRA_PROGRAMS += bench/integrate
bench_integrate_SOURCES = bench/integrate.c
bench_integrate_LDADD = $(UPTO_RESPONSE)
