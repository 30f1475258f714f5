noinst_LTLIBRARIES += %D%/librod.la
%C%_librod_la_SOURCES = \
	%D%/balance.c \
	%D%/band.c \
	%D%/band.h \
	%D%/element.c \
	%D%/element.h \
	%D%/mesh.c \
	%D%/mesh.h \
	%D%/motion.c \
	%D%/motion.h \
	%D%/motion_form.c \
	%D%/motion_ledger.c \
	%D%/points.c \
	%D%/read.c \
	%D%/read.h \
	%D%/read_loads.c \
	%D%/so3.c \
	%D%/so3.h \
	%D%/solve.c \
	%D%/solve.h \
	%D%/statics.c
