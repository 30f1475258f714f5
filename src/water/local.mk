noinst_LTLIBRARIES += %D%/libwater.la
%C%_libwater_la_SOURCES = \
	%D%/drag.c \
	%D%/line.h \
	%D%/linear.c \
	%D%/morison.c \
	%D%/morison.h \
	%D%/near.c \
	%D%/near.h \
	%D%/regular.c \
	%D%/sea.c \
	%D%/water.c \
	%D%/water.h \
	%D%/waves.c \
	%D%/wet.c
