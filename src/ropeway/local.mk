noinst_LTLIBRARIES += %D%/libropeway.la
%C%_libropeway_la_SOURCES = \
	%D%/ahead.c \
	%D%/arc.c \
	%D%/at.c \
	%D%/check.c \
	%D%/expand.c \
	%D%/expand.h \
	%D%/expand_answer.c \
	%D%/expand_ends.c \
	%D%/expand_follow.c \
	%D%/expand_at.c \
	%D%/expand_drive.c \
	%D%/expand_modes.c \
	%D%/expand_modes.h \
	%D%/expand_points.c \
	%D%/flight.c \
	%D%/given.c \
	%D%/line.h \
	%D%/march.c \
	%D%/march.h \
	%D%/modes.c \
	%D%/modes.h \
	%D%/modes_equations.c \
	%D%/modes_fill.c \
	%D%/modes_grid.c \
	%D%/modes_iterate.c \
	%D%/modes_label.c \
	%D%/modes_pieces.c \
	%D%/modes_plan.c \
	%D%/modes_running.c \
	%D%/modes_segment.c \
	%D%/modes_speed.c \
	%D%/modes_static.c \
	%D%/modes_systems.c \
	%D%/path.c \
	%D%/plan.h \
	%D%/rope.h \
	%D%/running.h \
	%D%/search.c \
	%D%/segment.h \
	%D%/solution.c \
	%D%/trace.c

# The ropeway: its scene, and its two lanes as lines.
%C%_libropeway_la_SOURCES += \
	%D%/contact.c \
	%D%/frame.c \
	%D%/frame.h \
	%D%/lane.c \
	%D%/loop_modes.c \
	%D%/passing.c \
	%D%/read.c \
	%D%/read.h \
	%D%/read_drive.c \
	%D%/state.c \
	%D%/sweep.c \
	%D%/towers.c \
	%D%/track.c \
	%D%/track.h \
	%D%/track_match.c \
	%D%/track_sample.c \
	%D%/transient.c \
	%D%/transient.h \
	%D%/transient_chain.c \
	%D%/transient_rows.c \
	%D%/transient_slow.c \
	%D%/transient_step.c

# A span over obstacles: its scene, and the limits of friction.
%C%_libropeway_la_SOURCES += \
	%D%/history.c \
	%D%/history.h \
	%D%/obstacles.c \
	%D%/obstacles_read.c
