noinst_LTLIBRARIES += %D%/libstudy.la
%C%_libstudy_la_SOURCES = \
	%D%/chosen.c \
	%D%/chosen.h \
	%D%/closed.c \
	%D%/decay.c \
	%D%/half_power.c \
	%D%/half_power.h \
	%D%/half_power_one.c %D%/half_power_pair.c %D%/half_power_quotient.c \
	%D%/cost.c \
	%D%/cost.h \
	%D%/cost_auto.c \
	%D%/decide.c \
	%D%/estimate.c \
	%D%/family.c \
	%D%/fidelity.c \
	%D%/identify.c \
	%D%/identify.h \
	%D%/identify_match.c \
	%D%/identify_modes.c \
	%D%/identify_result.c \
	%D%/landmark.c \
	%D%/landmark.h \
	%D%/least_squares.c \
	%D%/least_squares.h \
	%D%/match.c \
	%D%/motions.c \
	%D%/motions.h \
	%D%/peaks.c \
	%D%/plan.c \
	%D%/primary.c \
	%D%/primary.h \
	%D%/primary_curve.c \
	%D%/respond.h \
	%D%/ridge.c \
	%D%/ridge.h \
	%D%/run.c \
	%D%/scales.c \
	%D%/scales.h \
	%D%/sharpen.c \
	%D%/span_motion.c \
	%D%/sizes.c \
	%D%/stencil.c \
	%D%/stencil.h \
	%D%/survey.h \
	%D%/trial.c \
	%D%/trial.h
# accuracy asked for
%C%_libstudy_la_SOURCES += \
	%D%/accuracy.c \
	%D%/accuracy.h \
	%D%/accuracy_full.c \
	%D%/curve.c \
	%D%/curve.h \
	%D%/distance.c \
	%D%/fixed.c \
	%D%/distance.h
# maps over two parameters
%C%_libstudy_la_SOURCES += \
	%D%/map.c \
	%D%/map.h \
	%D%/map_beam.c \
	%D%/map_cable.c \
	%D%/map_cable.h \
	%D%/map_checkpoint.c \
	%D%/map_doubt.c \
	%D%/map_edges.c \
	%D%/map_lines.c \
	%D%/map_memo.c \
	%D%/map_point.c \
	%D%/map_ridges.c \
	%D%/map_merge.c \
	%D%/map_quantity.c \
	%D%/map_ranks.c \
	%D%/map_quantity.h \
	%D%/basin.c \
	%D%/basin.h \
	%D%/basin_count.c \
	%D%/basin_form.c \
	%D%/map_basin.c \
	%D%/map_row.c \
	%D%/map_row_model.c \
	%D%/map_row_result.c \
	%D%/map_rows.c \
	%D%/map_rows.h \
	%D%/map_rows_file.c \
	%D%/map_rows_file.h \
	%D%/map_rows_mapper.h \
	%D%/map_rows_ranks.c \
	%D%/map_rows_lines.c \
	%D%/map_shift.c \
	%D%/map_structure.c \
	%D%/map_tree.c
# boundaries of stability by continuation
%C%_libstudy_la_SOURCES += \
	%D%/hill.c \
	%D%/hill.h \
	%D%/hill_count.c \
	%D%/hill_field.c \
	%D%/hill_lines.c \
	%D%/hill_ridges.c \
	%D%/hill_seed.c \
	%D%/hill_test.c \
	%D%/hill_track.c \
	%D%/mathieu.h \
	%D%/mathieu_matrix.c \
	%D%/mathieu_trace.c \
	%D%/mathieu.c
