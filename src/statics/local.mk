noinst_LTLIBRARIES += %D%/libstatics.la
%C%_libstatics_la_SOURCES = \
	%D%/placeholder.c
