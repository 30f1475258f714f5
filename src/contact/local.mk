noinst_LTLIBRARIES += %D%/libcontact.la
%C%_libcontact_la_SOURCES = \
	%D%/friction.c \
	%D%/friction-chain.c \
	%D%/friction-check.c \
	%D%/friction-corner.c \
	%D%/friction-law.c \
	%D%/friction-net.c \
	%D%/friction-newton.c \
	%D%/friction-start.c \
	%D%/friction-state.c \
	%D%/heights.c \
	%D%/heights_read.c \
	%D%/surface.c \
	%D%/surface_read.c
