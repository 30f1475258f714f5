noinst_LTLIBRARIES += %D%/librod.la
%C%_librod_la_SOURCES = \
	%D%/balance.c \
	%D%/band.c \
	%D%/begin.c \
	%D%/drive.c \
	%D%/element.c \
	%D%/integrate.c \
	%D%/mesh.c \
	%D%/motion.c \
	%D%/motion_form.c \
	%D%/motion_ledger.c \
	%D%/motion_newton.c \
	%D%/motion_state.c \
	%D%/motion_winch.c \
	%D%/points.c \
	%D%/read.c \
	%D%/read_loads.c \
	%D%/read_winch.c \
	%D%/rows.c \
	%D%/so3.c \
	%D%/solve.c \
	%D%/statics.c \
	%D%/water.c \
	%D%/winch.c
# the table of keys, data alone, which the library of the scene has
src_scene_libscene_la_SOURCES += %D%/rod_rows.c
