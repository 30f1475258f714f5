noinst_LTLIBRARIES += %D%/libmodes.la
%C%_libmodes_la_SOURCES = \
	%D%/placeholder.c
