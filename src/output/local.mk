noinst_LTLIBRARIES += %D%/liboutput.la
%C%_liboutput_la_SOURCES = \
	%D%/animate.c \
	%D%/animate.h \
	%D%/axis.c \
	%D%/axis.h \
	%D%/fields.c \
	%D%/fields.h \
	%D%/fields_json.c \
	%D%/fields_read.c \
	%D%/fields_table.c \
	%D%/fields_units.h %D%/fields_value.h %D%/visit.h \
	%D%/frames.c \
	%D%/frames.h \
	%D%/gnuplot.c \
	%D%/html.c \
	%D%/html.h \
	%D%/json.c \
	%D%/labels.c \
	%D%/labels.h \
	%D%/latex.c \
	%D%/latex.h \
	%D%/map_tongues.c \
	%D%/output.h \
	%D%/panels.c \
	%D%/picture_choice.c \
	%D%/picture_choice.h \
	%D%/panels.h \
	%D%/outline.c \
	%D%/outline.h \
	%D%/perspective.c \
	%D%/perspective.h \
	%D%/plot_beam.c \
	%D%/plot_beam_lines.c \
	%D%/plot_beam_motion.c \
	%D%/plot_campbell.c \
	%D%/plot_cases.c \
	%D%/plot_cases.h \
	%D%/plot_compare.c \
	%D%/plot_complex_modes.c \
	%D%/plot_curves.c \
	%D%/plot_damped.c \
	%D%/plot_damped.h \
	%D%/plot_energy.c \
	%D%/plot_folds.c \
	%D%/plot_equilibria.c \
	%D%/plot_equilibria.h \
	%D%/plot_net.c \
	%D%/plot_net.h \
	%D%/plot_net_modes.c \
	%D%/plot_net_modes.h \
	%D%/plot_rod.c \
	%D%/plot_rod.h \
	%D%/plot_rod_motion.c \
	%D%/plot_obstacles.c \
	%D%/plot_obstacles.h \
	%D%/plot_ropeway.c \
	%D%/plot_ropeway.h \
	%D%/plot_ropeway_modes.c \
	%D%/plot_ropeway_modes.h \
	%D%/plot_track.c \
	%D%/plot_track.h \
	%D%/plot_nnm.c %D%/plot_nnm.h \
	%D%/plot_locus.c \
	%D%/plot_locus.h \
	%D%/plot_frf.c \
	%D%/plot_frf.h \
	%D%/plot_frf_detail.c \
	%D%/plot_frf_tori.c \
	%D%/plot_hill.c \
	%D%/plot_identify.c \
	%D%/plot_integrate.c \
	%D%/plot_irvine.c \
	%D%/plot_map.c \
	%D%/plot_modes.c \
	%D%/plot_motions.c \
	%D%/plot_motions.h \
	%D%/plot_precision.c \
	%D%/plot_profile.c \
	%D%/plot_profile.h \
	%D%/plot_speeds.c \
	%D%/plot_statics.c \
	%D%/plot_sweep.c %D%/plot_sweep.h \
	%D%/plot_tow.c \
	%D%/plot_tow.h \
	%D%/plot_tow_motion.c \
	%D%/plot_tow_motion.h \
	%D%/plot_trajectory.c \
	%D%/plot_trajectory.h \
	%D%/sha256.c \
	%D%/sha256.h \
	%D%/plot_transient.c \
	%D%/plot_transient.h \
	%D%/style.c \
	%D%/style.h \
	%D%/table.c \
	%D%/units.c \
	%D%/units.h \
	%D%/vtk.c \
	%D%/vtk.h

# The style and the script of reports, as lines of C.
EXTRA_DIST += %D%/report.css %D%/report.js %D%/lines.awk
BUILT_SOURCES += %D%/report_page.h
CLEANFILES += %D%/report_page.h
%D%/report_page.h: %D%/report.css %D%/report.js %D%/lines.awk
	$(AM_V_GEN)$(MKDIR_P) %D% && { $(AWK) -v name=hawser__report_css -f $(srcdir)/%D%/lines.awk $(srcdir)/%D%/report.css && \
		$(AWK) -v name=hawser__report_js -f $(srcdir)/%D%/lines.awk $(srcdir)/%D%/report.js; } >$@.tmp && mv -f $@.tmp $@
%D%/html.lo: %D%/report_page.h
