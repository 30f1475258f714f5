# work and precision of time integration
bench_integrate_SOURCES = bench/integrate.c
bench_integrate_LDADD = $(UPTO_RESPONSE)
