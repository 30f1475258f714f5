noinst_LTLIBRARIES += %D%/libresponse.la
%C%_libresponse_la_SOURCES = \
	%D%/floquet.c \
	%D%/floquet.h
