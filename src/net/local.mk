noinst_LTLIBRARIES += %D%/libnet.la
%C%_libnet_la_SOURCES = \
	%D%/catenary.c \
	%D%/catenary.h \
	%D%/dual.c \
	%D%/dual.h \
	%D%/equilibria.c \
	%D%/exact.c \
	%D%/exact.h \
	%D%/exact_solution.c \
	%D%/form.c \
	%D%/interior.c \
	%D%/loads.c \
	%D%/integrate.c \
	%D%/mesh.c \
	%D%/mixed.c \
	%D%/modes.c \
	%D%/motion.c \
	%D%/motion.h \
	%D%/motion-chain.c \
	%D%/motion-klu.c \
	%D%/motion-law.c \
	%D%/motion-schemes.c \
	%D%/motion-state.c \
	%D%/motion-support.c \
	%D%/names.c \
	%D%/net.c \
	%D%/net.h \
	%D%/read.c \
	%D%/read.h \
	%D%/solution.c \
	%D%/solution.h \
	%D%/solve.h \
	%D%/span.c \
	%D%/sparse.c \
	%D%/statics.c
