noinst_LTLIBRARIES += %D%/librom.la
%C%_librom_la_SOURCES = \
	%D%/auto.c \
	%D%/auto_text.c \
	%D%/auto_text.h \
	%D%/block.c \
	%D%/build.c \
	%D%/build.h \
	%D%/choose.c \
	%D%/compile.c \
	%D%/condense.c \
	%D%/condense.h \
	%D%/entries.c \
	%D%/entries.h \
	%D%/cycle.c \
	%D%/cycle.h \
	%D%/displaced.c \
	%D%/exact.c \
	%D%/exact.h \
	%D%/exact_block.c \
	%D%/exact_make.c \
	%D%/forced.c \
	%D%/full.c \
	%D%/gradient.c \
	%D%/kernel.c \
	%D%/kernel.h \
	%D%/model.c \
	%D%/model.h \
	%D%/open.c \
	%D%/panel.c \
	%D%/project.c \
	%D%/project.h \
	%D%/read.c \
	%D%/read.h \
	%D%/shapes.c \
	%D%/weigh.c \
	%D%/weigh.h \
	%D%/write.c
