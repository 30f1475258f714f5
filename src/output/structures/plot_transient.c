/* output/structures/plot_transient.c - see plot_transient.h. Panels over time, below one another.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/structures/plot_transient.h"

#define WIDTH 17.0 /* cm */
#define TALL 3.2   /* cm, height of a panel */
#define GAP 0.95   /* cm between two panels */
#define TOP 0.8    /* cm above all */
#define BELOW 1.5  /* cm below the last: tics and title of time */
#define LEFT 0.13  /* where panels begin, part of the width */
#define RIGHT 0.97 /* and its end */
enum { CURVES = 3, PANELS = 6 }; /* at most: of a panel, of a picture */

static const char *const style[CURVES] = {"lc rgb '#0072b2' lw 1.2", "lc rgb '#d55e00' lw 1.2 dt (8,4)",
                                          "lc rgb '#009e73' lw 1.2 dt (3,3)"};

/* Curves of one quantity; `column` are those of $run, counted from 1. */
struct panel {
	struct hawser__axis axis;
	int column[CURVES], curves;
	const char *title[CURVES];
	double level;              /* a line at this value; NAN: none */
	const char *level_title;
};

static double height_of(int panels)
{
	return TOP + panels*(TALL + GAP) - GAP + BELOW;
}

static void draw_panel(struct hawser__picture *picture, const struct panel *panel, int k, int panels,
                       double from, double to)
{
	const struct hawser__axis time = hawser__axis_of("Time {/:Italic t}", "s", 0.0);
	FILE *script = picture->script;
	double height = height_of(panels), top = height - TOP - k*(TALL + GAP);

	hawser__picture_panel(picture, LEFT, RIGHT, (top - TALL)/height, top/height);
	fputs("set key at graph 1, graph 1.03 bottom right horizontal maxrows 1 samplen 2 font ',9'\n",
	      script);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [*:*]\nset offsets 0,0,graph "
	                "0.04,graph 0.04\n"
	        "set ytics autofreq\nset format x '%s'\n", from/time.per, to/time.per,
	        k == panels - 1 ? "%g" : "");
	hawser__picture_tics(picture, 'x', from/time.per, to/time.per, 10);
	if (k == panels - 1)
		fprintf(script, "set xlabel '%s' offset 0,0.3\n", time.title);
	else
		fputs("unset xlabel\n", script);
	hawser__picture_ylabel(picture, "%s", panel->axis.title);
	fputs("plot ", script);
	for (int i = 0; i < panel->curves; i++)
		fprintf(script, "%s$run using ($1/%.9g):(column(%d)/%.9g) with lines %s title '%s'",
		        i ? ", " : "", time.per, panel->column[i], panel->axis.per, style[i], panel->title[i]);
	if (isfinite(panel->level))
		fprintf(script, ", %.9g with lines lc rgb 'black' lw 0.8 dt (2,4) title '%s'",
		        panel->level/panel->axis.per, panel->level_title);
	fputc('\n', script);
}

static enum hawser_status finish(struct hawser__picture *picture, const struct panel *panel, int panels,
                                 double from, double to, struct hawser_report *report)
{
	for (int k = 0; k < panels; k++)
		draw_panel(picture, &panel[k], k, panels, from, to);
	return hawser__picture_finish(picture, report);
}

static struct panel panel_of(const char *quantity, const char *unit, double largest)
{
	return (struct panel){.axis = hawser__axis_of(quantity, unit, largest), .level = NAN};
}

static void curve(struct panel *panel, int column, const char *title)
{
	panel->column[panel->curves] = column;
	panel->title[panel->curves++] = title;
}

static double most(const struct hawser_transient_range *range)
{
	return fmax(fabs(range->min), fabs(range->max));
}

enum hawser_status hawser__plot_transient(const char *path, const struct hawser_ropeway *rw,
                                          const struct hawser_transient *run,
                                          struct hawser_report *report)
{
	struct panel panel[PANELS];
	struct hawser__picture picture;
	int panels = 0;
	enum hawser_status status;

	panel[panels] = panel_of("Speed", "m/s", rw->speed);
	curve(&panel[panels], 2, "rope at the drive");
	curve(&panel[panels++], 3, "drive bullwheel");
	panel[panels] = panel_of("Force", "N", most(&run->force));
	curve(&panel[panels], 4, "bullwheel on rope");
	curve(&panel[panels++], 5, "drive or brake");
	if (rw->drive) {
		panel[panels] = panel_of("Slip arc", "rad", rw->wrap);
		curve(&panel[panels], 6, "slip arc");
		panel[panels].level = rw->wrap;
		panel[panels++].level_title = "wrap";
	}
	panel[panels] = panel_of("Tension", "N", run->T.max);
	curve(&panel[panels], 7, "up, at the drive");
	curve(&panel[panels], 8, "down, at the drive");
	curve(&panel[panels++], 9, "up, at the bottom");
	panel[panels] = panel_of("Carriage", "m", most(&run->travel));
	curve(&panel[panels++], 10, "travel towards the line");
	if (run->towers) {
		panel[panels] = panel_of("Battery", "N", run->tower[0].other.max);
		curve(&panel[panels++], 11, "least pressing force");
	}
	status = hawser__picture_begin(&picture, path, WIDTH, height_of(panels), report);
	if (status)
		return status;
	fputs("$run << END\n", picture.script);
	for (int i = 0; i < run->rows; i++) {
		const struct hawser_transient_row *row = &run->row[i];

		fprintf(picture.script, "%.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", row->t,
		        row->speed, row->wheel, row->force, row->motor, row->slip_arc, row->T_up, row->T_down,
		        row->T_bottom_up, row->travel, row->pressing);
	}
	fputs("END\n", picture.script);
	return finish(&picture, panel, panels, run->row[0].t, run->row[run->rows - 1].t, report);
}

enum hawser_status hawser__plot_carrier_passing(const char *path, const struct hawser_passing *passing,
                                        struct hawser_report *report)
{
	struct panel panel[PANELS];
	struct hawser__picture picture;
	double T = 0.0, pressing = 0.0;
	int panels = 0;
	enum hawser_status status;

	for (int i = 0; i < passing->rows; i++) {
		const struct hawser_ropeway_contact *c = &passing->row[i].contact;

		T = fmax(T, fmax(c->T_in, c->T_out));
		pressing = fmax(pressing, fabs(c->pressing));
	}
	panel[panels] = panel_of("Slope", "rad", 0.0);
	curve(&panel[panels], 2, "before the battery");
	curve(&panel[panels++], 3, "behind it");
	panel[panels] = panel_of("Wrap", "rad", 0.0);
	curve(&panel[panels++], 4, "angle of contact");
	panel[panels] = panel_of("Tension", "N", T);
	curve(&panel[panels], 5, "before the battery");
	curve(&panel[panels++], 6, "behind it");
	panel[panels] = panel_of("Battery", "N", pressing);
	curve(&panel[panels], 7, "pressing force");
	curve(&panel[panels++], 8, "carried weight of the carrier");
	status = hawser__picture_begin(&picture, path, WIDTH, height_of(panels), report);
	if (status)
		return status;
	fputs("$run << END\n", picture.script);
	for (int i = 0; i < passing->rows; i++) {
		const struct hawser_passing_row *row = &passing->row[i];
		const struct hawser_ropeway_contact *c = &row->contact;

		fprintf(picture.script, "%.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", row->t, c->angle_in,
		        c->angle_out, c->wrap, c->T_in, c->T_out, c->pressing, row->carried);
	}
	fputs("END\n", picture.script);
	return finish(&picture, panel, panels, passing->row[0].t, passing->row[passing->rows - 1].t,
	              report);
}
