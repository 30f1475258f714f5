noinst_LTLIBRARIES += %D%/libnet.la
%C%_libnet_la_SOURCES = \
	%D%/mesh.c \
	%D%/net.c \
	%D%/net.h \
	%D%/sparse.c
