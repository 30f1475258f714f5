noinst_LTLIBRARIES += %D%/libmodes.la
%C%_libmodes_la_SOURCES = \
	%D%/compare.c \
	%D%/compliance.c \
	%D%/compliance.h \
	%D%/grid.c \
	%D%/grid.h \
	%D%/label.c \
	%D%/label.h \
	%D%/methods.c \
	%D%/spectral.c \
	%D%/spectral.h
