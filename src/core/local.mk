noinst_LTLIBRARIES += %D%/libcore.la
%C%_libcore_la_SOURCES = \
	%D%/append.c \
	%D%/bytes.c \
	%D%/columns.c \
	%D%/digits.c \
	%D%/file.c \
	%D%/hold.c \
	%D%/paths.c \
	%D%/progress.c \
	%D%/ranks.c \
	%D%/ranks_packet.c \
	%D%/ranks_serve.c \
	%D%/share.c \
	%D%/spelling.c \
	%D%/status.c \
	%D%/sundials.c
