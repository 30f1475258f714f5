noinst_LTLIBRARIES += %D%/libbeam.la
%C%_libbeam_la_SOURCES = \
	%D%/hermite.c \
	%D%/integrals.c \
	%D%/integrals.h \
	%D%/legendre.c \
	%D%/matrices.c \
	%D%/sine.c \
	%D%/spectrum.c
