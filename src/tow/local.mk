noinst_LTLIBRARIES += %D%/libtow.la
# Towed bodies: the path of the towing point.
%C%_libtow_la_SOURCES = \
	%D%/motion.c \
	%D%/motion_loads.c \
	%D%/motion_start.c \
	%D%/motion_state.c \
	%D%/read.c \
	%D%/read_cable.c \
	%D%/read_path.c \
	%D%/read_waypoints.c \
	%D%/steady.c \
	%D%/steady_rod.c \
	%D%/steady_rod_loads.c \
	%D%/steady_body.c \
	%D%/steady_orbit.c \
	%D%/steady_string.c \
	%D%/trajectory.c \
	%D%/trajectory_file.c \
	%D%/trajectory_flight.c \
	%D%/trajectory_largest.c \
	%D%/trajectory_pieces.c \
	%D%/trajectory_solve.c
# the table of keys, data alone, which the library of the scene has
src_scene_libscene_la_SOURCES += %D%/tow_rows.c
