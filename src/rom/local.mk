noinst_LTLIBRARIES += %D%/librom.la
%C%_librom_la_SOURCES = \
	%D%/build.c \
	%D%/compile.c \
	%D%/forced.c \
	%D%/kernel.c \
	%D%/kernel.h \
	%D%/model.c \
	%D%/model.h \
	%D%/project.c \
	%D%/project.h \
	%D%/shapes.c
