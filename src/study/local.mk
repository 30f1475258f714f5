noinst_LTLIBRARIES += %D%/libstudy.la
%C%_libstudy_la_SOURCES = \
	%D%/fidelity.c
