/* cli/modes/campbell_draw.c - the Campbell diagram: one column per plane, imaginary parts above, real
 * parts below, as in B figure 5.5.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/modes/modes_result.h"
#include "output/drawing/figure.h"

#define EXCITATION "with lines lt 7 lw 0.7 dt (3,4)"
#define LIMIT "lc rgb '#909090' lw 1.2 dt (8,5)"
enum { COLOURS = 6 };
/* Of the largest imaginary part: where the numbers of the excitation are, and where the panel ends. */
static const double numbers = 1.05, roof = 1.12;

/* One plane: branches first..end-1. */
struct column {
	int first, end;
	const char *title;
	double left, right;
};

struct drawing {
	struct hawser__figure figure;
	const struct cli_campbell_result *result;
	struct hawser__axis speed, re, im;
	double from, to; /* of the speed */
	double top, low, high; /* of the imaginary parts, and of the real ones */
	int tics;
	int real; /* 1: an eigenvalue has a real part; without damping and below the first instability none
	           * has */
};

static void measure(struct drawing *of)
{
	const struct hawser_campbell *campbell = &of->result->campbell;

	of->speed = cli_campbell_axis("speed", of->result);
	of->re = cli_campbell_axis("re", of->result);
	of->im = cli_campbell_axis("im", of->result);
	for (int i = 0; i < campbell->stations*campbell->branches; i++) {
		double re = cli_campbell_in_unit(of->result, campbell->re[i]);

		of->top = fmax(of->top, fabs(cli_campbell_in_unit(of->result, campbell->im[i])));
		of->low = fmin(of->low, re);
		of->high = fmax(of->high, re);
	}
	of->real = of->low < 0.0 || of->high > 0.0;
	of->from = campbell->station[0].speed;
	of->to = campbell->criticals ? campbell->limit : campbell->station[campbell->stations - 1].speed;
	of->tics = campbell->in_plane > 0 && campbell->in_plane < campbell->branches &&
	           of->to - of->from < 0.05*of->to ? 4 : 8;
}

static void draw_branches(struct drawing *of, const struct column *column, const double *part)
{
	const struct hawser_campbell *campbell = &of->result->campbell;
	char title[32];

	for (int b = column->first; b < column->end; b++) {
		int number = b - column->first + 1;

		for (int i = 0; i < campbell->stations; i++)
			hawser__figure_put(&of->figure, campbell->station[i].speed,
			                   cli_campbell_in_unit(of->result, part[i*campbell->branches + b]));
		snprintf(title, sizeof title, "mode %d", number);
		hawser__figure_draw(&of->figure, number <= COLOURS ? title : NULL, "with lines lt %d lw 1.3",
		                    (number - 1) % COLOURS + 1);
	}
	if (campbell->criticals)
		hawser__figure_upright(&of->figure, NULL, campbell->limit, LIMIT);
}

/* Lines of the excitation, with their numbers where they leave the panel. */
static void draw_excitation(struct drawing *of)
{
	const struct hawser_campbell *campbell = &of->result->campbell;
	double last = campbell->criticals ? campbell->station[campbell->stations - 1].speed : of->to;

	for (int n = 1; n <= of->result->harmonics; n++) {
		double slope = cli_campbell_in_unit(of->result, n*2.0*M_PI/of->result->spacing);
		double speed = fmin(0.97*last, numbers*of->top/slope);

		hawser__figure_label(&of->figure, speed, slope*speed, "right offset -0.5,0.3 font ',9'",
		                     "%d", n);
		hawser__figure_function(&of->figure, NULL, "%.9g*x " EXCITATION,
		                        slope*of->speed.per/of->im.per);
	}
}

/* A mark on each of two branches where they are closest, if it is shown. */
static void draw_crossovers(struct drawing *of, int veers)
{
	const struct hawser_campbell *campbell = &of->result->campbell;

	for (int k = 0; k < campbell->crossovers; k++) {
		const struct hawser_campbell_crossover *at = &campbell->crossover[k];

		for (int end = 0; end < 2; end++)
			if ((at->kind == HAWSER_VEERING) == veers &&
			    (end ? at->above : at->below) <= campbell->in_plane)
				hawser__figure_put(&of->figure, at->speed, cli_campbell_in_unit(
					of->result, at->omega + (end ? 0.5 : -0.5)*at->gap));
	}
	if (veers)
		hawser__figure_draw(&of->figure, NULL, HAWSER__VEERING);
	else
		hawser__figure_draw(&of->figure, NULL, HAWSER__CROSSING);
}

static void draw_column(struct drawing *of, const struct column *column)
{
	double last = of->to + 0.02*(of->to - of->from), room = 0.1*(of->high - of->low);
	struct hawser__panel_axis speed = {&of->speed, of->from, last, .tics = of->tics, .bare = of->real};
	int beside = column->first > 0;

	hawser__figure_panel(&of->figure, &(struct hawser__panel_frame){column->left, column->right,
		of->real ? 0.44 : 0.31, 0.94, .x = speed,
		.y = {&of->im, 0.0, roof*of->top, .tics = 9, .untitled = beside}});
	fprintf(of->figure.out.script, "set label '%s%s' at graph 0.5,1.04 center\n", column->title,
	        of->real || beside ? "" : "; all real parts 0");
	draw_branches(of, column, of->result->campbell.im);
	draw_excitation(of);
	for (int veers = 0; veers < 2 && !beside; veers++)
		draw_crossovers(of, veers);
	if (!of->real)
		return;
	speed.bare = 0;
	hawser__figure_panel(&of->figure, &(struct hawser__panel_frame){column->left, column->right,
		0.25, 0.40,
		.x = speed, .y = {&of->re, of->low - room, of->high + room, .tics = 3, .untitled = beside}});
	draw_branches(of, column, of->result->campbell.re);
}

static void add_entries(struct hawser__legend *legend, const struct cli_campbell_result *result)
{
	int has[2] = {0};

	for (int k = 0; k < result->campbell.crossovers; k++)
		has[result->campbell.crossover[k].kind == HAWSER_VEERING] = 1;
	if (result->harmonics > 0)
		hawser__legend_once(legend, "excitation", EXCITATION);
	if (result->campbell.criticals)
		hawser__legend_once(legend, "limit speed", "with lines " LIMIT);
	if (has[0])
		hawser__legend_once(legend, "crossing", HAWSER__CROSSING);
	if (has[1])
		hawser__legend_once(legend, "veering", HAWSER__VEERING);
}

enum hawser_status cli_campbell_draw(const char *path, const void *context,
                                     struct hawser_report *report)
{
	struct drawing of = {.result = context};
	int in = of.result->campbell.in_plane, all = of.result->campbell.branches;
	const struct column column[] = {{0, in, "in plane", 0.13, in < all ? 0.54 : 0.97},
	                                {in, all, "out of plane", in > 0 ? 0.60 : 0.13, 0.97}};
	enum hawser_status status;

	measure(&of);
	status = hawser__figure_begin(&of.figure, path, 16.0, of.real ? 14.5 : 11.5, report);
	if (status)
		return status;
	for (int k = 0; k < 2; k++)
		if (column[k].end > column[k].first)
			draw_column(&of, &column[k]);
	add_entries(&of.figure.legend, of.result);
	return hawser__figure_finish(&of.figure, report);
}
