noinst_LTLIBRARIES += %D%/librom.la
%C%_librom_la_SOURCES = \
	%D%/placeholder.c
