noinst_LTLIBRARIES += %D%/liboutput.la
%C%_liboutput_la_SOURCES = \
	%D%/drawing/animate.c \
	%D%/drawing/axis.c \
	%D%/fields/fields.c \
	%D%/fields/fields_json.c \
	%D%/fields/fields_read.c \
	%D%/fields/fields_table.c \
	%D%/drawing/figure.c \
	%D%/drawing/figure_marks.c \
	%D%/drawing/frames.c \
	%D%/drawing/gnuplot.c \
	%D%/report/html.c \
	%D%/fields/json.c \
	%D%/drawing/labels.c \
	%D%/drawing/latex.c \
	%D%/curves/map_tongues.c \
	%D%/drawing/panels.c \
	%D%/drawing/picture_choice.c \
	%D%/drawing/outline.c \
	%D%/drawing/perspective.c \
	%D%/cable/plot_compare.c \
	%D%/structures/plot_bed.c \
	%D%/structures/plot_mooring.c \
	%D%/structures/plot_net.c \
	%D%/structures/plot_net_modes.c \
	%D%/structures/plot_rod.c \
	%D%/structures/plot_rod_motion.c \
	%D%/structures/plot_obstacles.c \
	%D%/structures/plot_ropeway.c \
	%D%/structures/plot_ropeway_modes.c \
	%D%/curves/plot_map.c \
	%D%/cable/plot_modes.c \
	%D%/curves/plot_motions.c \
	%D%/cable/plot_precision.c \
	%D%/cable/plot_statics.c \
	%D%/structures/plot_tow.c \
	%D%/structures/plot_tow_motion.c \
	%D%/structures/plot_trajectory.c \
	%D%/report/sha256.c \
	%D%/structures/plot_transient.c \
	%D%/drawing/style.c \
	%D%/fields/table.c \
	%D%/fields/units.c \
	%D%/report/vtk.c

# The style and the script of reports, as lines of C.
EXTRA_DIST += %D%/report.css %D%/report.js
BUILT_SOURCES += %D%/report_page.h
CLEANFILES += %D%/report_page.h
%D%/report_page.h: %D%/report.css %D%/report.js src/lines.awk
	$(AM_V_GEN)$(MKDIR_P) %D% && { $(AWK) -v name=hawser__report_css -f $(srcdir)/src/lines.awk $(srcdir)/%D%/report.css && \
		$(AWK) -v name=hawser__report_js -f $(srcdir)/src/lines.awk $(srcdir)/%D%/report.js; } >$@.tmp && mv -f $@.tmp $@
%D%/report/html.lo: %D%/report_page.h
