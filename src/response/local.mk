noinst_LTLIBRARIES += %D%/libresponse.la
%C%_libresponse_la_SOURCES = \
	%D%/placeholder.c
