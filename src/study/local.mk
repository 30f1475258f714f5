noinst_LTLIBRARIES += %D%/libstudy.la
%C%_libstudy_la_SOURCES = \
	%D%/closed.c \
	%D%/fidelity.c \
	%D%/landmark.c \
	%D%/landmark.h \
	%D%/match.c \
	%D%/respond.h \
	%D%/run.c \
	%D%/scales.c \
	%D%/scales.h \
	%D%/sharpen.c
