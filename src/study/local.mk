noinst_LTLIBRARIES += %D%/libstudy.la
%C%_libstudy_la_SOURCES = \
	%D%/accuracy/certificate.c \
	%D%/accuracy/certificate_mesh.c \
	%D%/accuracy/certificate_start.c \
	%D%/accuracy/certificate_span.c \
	%D%/accuracy/certify.c \
	%D%/accuracy/chosen.c \
	%D%/accuracy/closed.c \
	%D%/accuracy/draft.c \
	%D%/accuracy/draft_marks.c \
	%D%/identify/decay.c \
	%D%/identify/half_power.c \
	%D%/identify/half_power_one.c %D%/identify/half_power_pair.c %D%/identify/half_power_quotient.c \
	%D%/plan/cost.c \
	%D%/plan/decide.c \
	%D%/plan/foresee.c \
	%D%/plan/gallop.c \
	%D%/plan/own.c \
	%D%/accuracy/estimate.c \
	%D%/map/family.c \
	%D%/map/net_family.c \
	%D%/accuracy/fidelity.c \
	%D%/identify/identify.c \
	%D%/identify/identify_match.c \
	%D%/identify/identify_modes.c \
	%D%/identify/identify_result.c \
	%D%/accuracy/landmark.c \
	%D%/identify/least_squares.c \
	%D%/compare/match.c \
	%D%/accuracy/motions.c \
	%D%/accuracy/peaks.c \
	%D%/plan/plan.c \
	%D%/accuracy/primary.c \
	%D%/accuracy/primary_curve.c \
	%D%/map/ridge.c \
	%D%/map/ridge_find.c \
	%D%/accuracy/run.c \
	%D%/accuracy/scales.c \
	%D%/accuracy/sharpen.c \
	%D%/compare/span_motion.c \
	%D%/sizes.c \
	%D%/accuracy/stencil.c
# accuracy asked for
%C%_libstudy_la_SOURCES += \
	%D%/accuracy/accuracy.c \
	%D%/accuracy/accuracy_full.c \
	%D%/accuracy/full_bases.c \
	%D%/accuracy/carry.c \
	%D%/compare/curve.c \
	%D%/compare/distance.c \
	%D%/accuracy/fixed.c \
	%D%/accuracy/instead.c
# maps over two parameters
%C%_libstudy_la_SOURCES += \
	%D%/map/map.c \
	%D%/map/map_beam.c \
	%D%/map/map_cable.c \
	%D%/map/map_checkpoint.c \
	%D%/map/map_doubt.c \
	%D%/map/map_gallop.c \
	%D%/map/map_edges.c \
	%D%/map/map_guide.c \
	%D%/map/map_lines.c \
	%D%/map/map_memo.c \
	%D%/map/map_point.c \
	%D%/map/map_ridges.c \
	%D%/map/map_merge.c \
	%D%/map/map_quantity.c \
	%D%/map/map_ranks.c \
	%D%/basin/basin.c \
	%D%/basin/basin_count.c \
	%D%/basin/basin_form.c \
	%D%/basin/map_basin.c \
	%D%/map/map_row.c \
	%D%/map/map_row_model.c \
	%D%/map/map_row_result.c \
	%D%/map/map_rows.c \
	%D%/map/map_rows_across.c \
	%D%/map/map_rows_file.c \
	%D%/map/map_rows_ranks.c \
	%D%/map/map_rows_lines.c \
	%D%/map/map_shift.c \
	%D%/map/map_structure.c \
	%D%/map/map_tree.c
# boundaries of stability by continuation
%C%_libstudy_la_SOURCES += \
	%D%/hill/hill.c \
	%D%/hill/hill_count.c \
	%D%/hill/hill_field.c \
	%D%/hill/hill_lines.c \
	%D%/hill/hill_ridges.c \
	%D%/hill/hill_seed.c \
	%D%/hill/hill_test.c \
	%D%/hill/hill_track.c \
	%D%/hill/mathieu_matrix.c \
	%D%/hill/mathieu_trace.c \
	%D%/hill/mathieu.c
