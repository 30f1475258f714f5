noinst_LTLIBRARIES += %D%/libwater.la
%C%_libwater_la_SOURCES = \
	%D%/drag.c \
	%D%/water.c \
	%D%/wet.c \
	%D%/water.h
