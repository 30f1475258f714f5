noinst_LTLIBRARIES += %D%/libwater.la
%C%_libwater_la_SOURCES = \
	%D%/drag.c \
	%D%/linear.c \
	%D%/morison.c \
	%D%/near.c \
	%D%/regular.c \
	%D%/sea.c \
	%D%/water.c \
	%D%/waves.c \
	%D%/wet.c
