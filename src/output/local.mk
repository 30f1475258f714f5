noinst_LTLIBRARIES += %D%/liboutput.la
%C%_liboutput_la_SOURCES = \
	%D%/fields.c \
	%D%/fields.h \
	%D%/fields_json.c \
	%D%/fields_table.c \
	%D%/fields_value.h \
	%D%/gnuplot.c \
	%D%/json.c \
	%D%/labels.c \
	%D%/labels.h \
	%D%/map_tongues.c \
	%D%/output.h \
	%D%/panels.c \
	%D%/panels.h \
	%D%/plot_beam.c \
	%D%/plot_beam_lines.c \
	%D%/plot_beam_motion.c \
	%D%/plot_campbell.c \
	%D%/plot_compare.c \
	%D%/plot_complex_modes.c \
	%D%/plot_curves.c \
	%D%/plot_energy.c \
	%D%/plot_folds.c \
	%D%/plot_frf.c \
	%D%/plot_frf.h \
	%D%/plot_frf_detail.c \
	%D%/plot_hill.c \
	%D%/plot_integrate.c \
	%D%/plot_irvine.c \
	%D%/plot_map.c \
	%D%/plot_modes.c \
	%D%/plot_precision.c \
	%D%/plot_speeds.c \
	%D%/plot_statics.c \
	%D%/style.c \
	%D%/style.h \
	%D%/table.c
