/* output/structures/plot_transient.c - see structures.h. Panels over time, below one another.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

#define WIDTH 17.0 /* cm */
#define TALL 3.2   /* cm, height of a panel */
#define GAP 0.95   /* cm between two panels */
#define TOP 0.8    /* cm above all */
#define BELOW 1.5  /* cm below the last: tics and title of time */
#define LEFT 0.13  /* where panels begin, part of the width */
#define RIGHT 0.97 /* and its end */

/* Rows of a run over time, each `step` bytes after the one before. */
struct drawing {
	struct hawser__figure figure;
	struct hawser__axis time;
	const double *t;
	size_t step;
	int rows, panels, drawn; /* panels: of the picture */
};

static enum hawser_status begin(struct drawing *of, const char *path, struct hawser_report *report)
{
	of->time = hawser__axis_of("Time {/:Italic t}", "s", 0.0);
	return hawser__figure_begin(&of->figure, path, WIDTH,
	                            TOP + of->panels*(TALL + GAP) - GAP + BELOW, report);
}

/* The time of a row. */
static const double *time_of(const struct drawing *of, int row)
{
	return (const void *)((const char *)of->t + (size_t)row*of->step);
}

/* The next panel: a quantity, whose curves have up to three names. */
static void draw_panel(struct drawing *of, const char *quantity, const char *unit, double largest,
                       const char *const *title, const double *const *value)
{
	static const char *const style[] = {"lc rgb '#0072b2' lw 1.2", "lc rgb '#d55e00' lw 1.2 dt (8,4)",
	                                    "lc rgb '#009e73' lw 1.2 dt (3,3)"};
	const struct hawser__axis axis = hawser__axis_of(quantity, unit, largest);
	double height = of->figure.out.height, top = height - TOP - of->drawn++*(TALL + GAP);
	double last = *time_of(of, of->rows - 1);

	hawser__figure_panel(&of->figure, &(struct hawser__panel_frame){LEFT, RIGHT, (top - TALL)/height,
		top/height, .keys = 1, .x = {&of->time, of->t[0], last, .tics = 10,
		                             .bare = of->drawn < of->panels},
		.y = {&axis, .room = 0.06, .tics = 7}});
	for (int i = 0; i < 3 && title[i]; i++) {
		hawser__figure_bind(&of->figure, of->rows, of->t, of->step, value[i], of->step);
		hawser__figure_draw(&of->figure, title[i], "with lines %s", style[i]);
	}
}

/* A line at this value in the panel. */
static void draw_level(struct drawing *of, double level, const char *title)
{
	for (int i = 0; i < of->rows; i += of->rows > 1 ? of->rows - 1 : 1)
		hawser__figure_put(&of->figure, *time_of(of, i), level);
	hawser__figure_draw(&of->figure, title, "with lines lc rgb 'black' lw 0.8 dt (2,4)");
}

static double most(const struct hawser_transient_range *range)
{
	return fmax(fabs(range->min), fabs(range->max));
}

#define NAMES(...) (const char *const[4]){__VA_ARGS__}
#define VALUES(...) (const double *const[3]){__VA_ARGS__}

enum hawser_status hawser__plot_transient(const char *path, const struct hawser_ropeway *rw,
                                          const struct hawser_transient *run,
                                          struct hawser_report *report)
{
	const struct hawser_transient_row *row = run->row;
	struct drawing of = {.t = &row->t, .step = sizeof *row, .rows = run->rows,
	                     .panels = 4 + (rw->drive != 0) + (run->towers > 0)};
	enum hawser_status status = begin(&of, path, report);

	if (status)
		return status;
	draw_panel(&of, "Speed", "m/s", rw->speed, NAMES("rope at the drive", "drive bullwheel"),
	           VALUES(&row->speed, &row->wheel));
	draw_panel(&of, "Force", "N", most(&run->force), NAMES("bullwheel on rope", "drive or brake"),
	           VALUES(&row->force, &row->motor));
	if (rw->drive) {
		draw_panel(&of, "Slip arc", "rad", rw->wrap, NAMES("slip arc"), VALUES(&row->slip_arc));
		draw_level(&of, rw->wrap, "wrap");
	}
	draw_panel(&of, "Tension", "N", run->T.max,
	           NAMES("up, at the drive", "down, at the drive", "up, at the bottom"),
	           VALUES(&row->T_up, &row->T_down, &row->T_bottom_up));
	draw_panel(&of, "Carriage", "m", most(&run->travel), NAMES("travel towards the line"),
	           VALUES(&row->travel));
	if (run->towers)
		draw_panel(&of, "Battery", "N", run->tower[0].other.max, NAMES("least pressing force"),
		           VALUES(&row->pressing));
	return hawser__figure_finish(&of.figure, report);
}

enum hawser_status hawser__plot_carrier_passing(const char *path, const struct hawser_passing *passing,
                                        struct hawser_report *report)
{
	const struct hawser_passing_row *row = passing->row;
	const struct hawser_ropeway_contact *c = &row->contact;
	struct drawing of = {.t = &row->t, .step = sizeof *row, .rows = passing->rows, .panels = 4};
	double T = 0.0, pressing = 0.0;
	enum hawser_status status = begin(&of, path, report);

	if (status)
		return status;
	for (int i = 0; i < passing->rows; i++) {
		T = fmax(T, fmax(row[i].contact.T_in, row[i].contact.T_out));
		pressing = fmax(pressing, fabs(row[i].contact.pressing));
	}
	draw_panel(&of, "Slope", "rad", 0.0, NAMES("before the battery", "behind it"),
	           VALUES(&c->angle_in, &c->angle_out));
	draw_panel(&of, "Wrap", "rad", 0.0, NAMES("angle of contact"), VALUES(&c->wrap));
	draw_panel(&of, "Tension", "N", T, NAMES("before the battery", "behind it"),
	           VALUES(&c->T_in, &c->T_out));
	draw_panel(&of, "Battery", "N", pressing, NAMES("pressing force", "carried weight of the carrier"),
	           VALUES(&c->pressing, &row->carried));
	return hawser__figure_finish(&of.figure, report);
}
