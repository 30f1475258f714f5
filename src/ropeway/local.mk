noinst_LTLIBRARIES += %D%/libropeway.la
%C%_libropeway_la_SOURCES = \
	%D%/statics/ahead.c \
	%D%/statics/arc.c \
	%D%/statics/at.c \
	%D%/statics/check.c \
	%D%/expand/expand.c \
	%D%/expand/expand_answer.c \
	%D%/expand/expand_ends.c \
	%D%/expand/expand_follow.c \
	%D%/expand/expand_at.c \
	%D%/expand/expand_drive.c \
	%D%/expand/expand_modes.c \
	%D%/expand/expand_points.c \
	%D%/statics/flight.c \
	%D%/statics/given.c \
	%D%/statics/march.c \
	%D%/modes/modes.c \
	%D%/modes/modes_equations.c \
	%D%/modes/modes_fill.c \
	%D%/modes/modes_grid.c \
	%D%/modes/modes_iterate.c \
	%D%/modes/modes_label.c \
	%D%/modes/modes_pieces.c \
	%D%/modes/modes_plan.c \
	%D%/modes/modes_running.c \
	%D%/modes/modes_segment.c \
	%D%/modes/modes_static.c \
	%D%/modes/modes_systems.c \
	%D%/statics/path.c \
	%D%/statics/search.c \
	%D%/statics/solution.c \
	%D%/statics/trace.c

# The ropeway: its scene, and its two lanes as lines.
%C%_libropeway_la_SOURCES += \
	%D%/statics/contact.c \
	%D%/statics/frame.c \
	%D%/statics/lane.c \
	%D%/modes/loop_modes.c \
	%D%/transient/passing.c \
	%D%/read/read.c \
	%D%/statics/state.c \
	%D%/statics/sweep.c \
	%D%/read/towers.c \
	%D%/modes/track.c \
	%D%/modes/track_match.c \
	%D%/modes/track_sample.c \
	%D%/transient/transient.c \
	%D%/transient/transient_chain.c \
	%D%/transient/transient_rows.c \
	%D%/transient/transient_slow.c \
	%D%/transient/transient_step.c

# A span over obstacles: its scene, and the limits of friction.
%C%_libropeway_la_SOURCES += \
	%D%/statics/history.c \
	%D%/statics/obstacles.c \
	%D%/read/obstacles_read.c
# the tables of keys, data alone, which the library of the scene has
src_scene_libscene_la_SOURCES += %D%/read/obstacles_rows.c %D%/read/ropeway_rows.c
