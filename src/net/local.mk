noinst_LTLIBRARIES += %D%/libnet.la
%C%_libnet_la_SOURCES = \
	%D%/form.c \
	%D%/interior.c \
	%D%/loads.c \
	%D%/mesh.c \
	%D%/mixed.c \
	%D%/names.c \
	%D%/net.c \
	%D%/net.h \
	%D%/read.c \
	%D%/solution.c \
	%D%/solve.h \
	%D%/sparse.c \
	%D%/statics.c \
	%D%/tree.c \
	%D%/tree.h \
	%D%/value.c \
	%D%/value.h
