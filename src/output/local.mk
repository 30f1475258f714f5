noinst_LTLIBRARIES += %D%/liboutput.la
%C%_liboutput_la_SOURCES = \
	%D%/placeholder.c
