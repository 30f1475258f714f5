noinst_LTLIBRARIES += %D%/librom.la
%C%_librom_la_SOURCES = \
	%D%/build.c \
	%D%/compile.c \
	%D%/forced.c \
	%D%/kernel.c \
	%D%/kernel.h \
	%D%/model.c \
	%D%/model.h \
	%D%/open.c \
	%D%/project.c \
	%D%/project.h \
	%D%/read.c \
	%D%/read.h \
	%D%/shapes.c \
	%D%/whole.c \
	%D%/whole.h \
	%D%/write.c
