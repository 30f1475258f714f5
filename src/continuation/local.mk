noinst_LTLIBRARIES += %D%/libcontinuation.la
%C%_libcontinuation_la_SOURCES = \
	%D%/follow.c \
	%D%/metric.c \
	%D%/newton.c \
	%D%/settings.c \
	%D%/step.c
