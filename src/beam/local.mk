noinst_LTLIBRARIES += %D%/libbeam.la
%C%_libbeam_la_SOURCES = \
	%D%/boundary.c \
	%D%/boundary_follow.c \
	%D%/change.c \
	%D%/critical.c \
	%D%/hermite.c \
	%D%/integrals.c \
	%D%/legendre.c \
	%D%/matrices.c \
	%D%/onset.c \
	%D%/sample.c \
	%D%/scale.c \
	%D%/sine.c \
	%D%/spectrum.c \
	%D%/sweep.c
