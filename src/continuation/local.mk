noinst_LTLIBRARIES += %D%/libcontinuation.la
%C%_libcontinuation_la_SOURCES = \
	%D%/curve.h \
	%D%/false_position.h \
	%D%/follow.c \
	%D%/metric.c \
	%D%/metric.h \
	%D%/newton.c \
	%D%/newton.h \
	%D%/settings.c \
	%D%/step.c
