noinst_LTLIBRARIES += %D%/libcore.la
%C%_libcore_la_SOURCES = \
	%D%/hot.h \
	%D%/report.h \
	%D%/status.c
