noinst_LTLIBRARIES += %D%/libcore.la
%C%_libcore_la_SOURCES = \
	%D%/append.c \
	%D%/append.h \
	%D%/bytes.c \
	%D%/bytes.h \
	%D%/digits.c \
	%D%/digits.h \
	%D%/file.c \
	%D%/file.h \
	%D%/grow.h \
	%D%/hold.c \
	%D%/hold.h \
	%D%/hot.h \
	%D%/loaded.h \
	%D%/locale.h \
	%D%/order.h \
	%D%/paths.c \
	%D%/paths.h \
	%D%/progress.c \
	%D%/progress.h \
	%D%/random.h \
	%D%/ranks.c \
	%D%/ranks.h \
	%D%/ranks_packet.c \
	%D%/ranks_packet.h \
	%D%/ranks_serve.c \
	%D%/report.h \
	%D%/settle.h \
	%D%/share.c \
	%D%/share.h \
	%D%/vec3.h \
	%D%/spelling.c \
	%D%/spelling.h \
	%D%/status.c \
	%D%/sundials.c \
	%D%/sundials.h
