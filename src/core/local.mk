noinst_LTLIBRARIES += %D%/libcore.la
%C%_libcore_la_SOURCES = \
	%D%/digits.c \
	%D%/digits.h \
	%D%/file.c \
	%D%/file.h \
	%D%/hot.h \
	%D%/paths.c \
	%D%/paths.h \
	%D%/progress.c \
	%D%/progress.h \
	%D%/report.h \
	%D%/rows3.h \
	%D%/settle.h \
	%D%/share.c \
	%D%/share.h \
	%D%/solve3.h \
	%D%/spelling.c \
	%D%/spelling.h \
	%D%/status.c \
	%D%/sundials.c \
	%D%/sundials.h
