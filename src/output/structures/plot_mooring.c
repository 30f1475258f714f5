/* output/structures/plot_mooring.c - a net in water: seen along z (y over x) and from above (z over x,
 * z downwards), both with the same scale along both axes. Cables are coloured by their tension.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

#define WIDTH 17.0   /* cm */
#define MOST 9.0     /* cm, height of a view */
#define LEAST 3.0    /* cm */
#define TITLE 1.6    /* cm below a panel: tics and title */
#define TOP 0.4      /* cm above all */
#define LEFT 0.12    /* where panels begin, part of the width */
#define RIGHT 0.84   /* and end: colours and their title are beside */
#define ROOM 0.04    /* of the larger range: beyond the net */
#define BESIDE 0.025 /* of the range of x: height of a name */
enum { NAMED = 30 }; /* most nodes whose names are shown */

struct frame {
	const struct hawser_net *net;
	const struct hawser_net_statics *st;
	struct hawser__axis x, y, z, T;
	struct hawser__box box;
	double tall[3], height; /* cm; tall [k]: of the view with axis k upwards */
	int flat;            /* 1: all is at one z, so that there is nothing to see from above */
};

static void measure(struct frame *frame)
{
	const struct hawser_net_statics *st = frame->st;
	double most = 0.0, size = 0.0, scale;

	for (int i = 0; i < st->points; i++)
		hawser__box_add(&frame->box, st->point[i].x, 3);
	for (int i = 0; i < st->nodes; i++)
		hawser__box_add(&frame->box, st->x[i], 3);
	frame->box.high[1] = fmax(frame->box.high[1], frame->net->water.surface);
	for (int k = 0; k < 3; k++)
		size = fmax(size, frame->box.high[k] - frame->box.low[k]);
	frame->flat = frame->box.high[2] - frame->box.low[2] < ROOM*size;
	for (int k = 0; k < 3; k++) {
		frame->box.low[k] -= ROOM*size;
		frame->box.high[k] += ROOM*size;
	}
	scale = (RIGHT - LEFT)*WIDTH/(frame->box.high[0] - frame->box.low[0]);
	for (int k = 1; k < 3; k++)
		frame->tall[k] = fmin(fmax(scale*(frame->box.high[k] - frame->box.low[k]), LEAST), MOST);
	for (int c = 0; c < st->cables; c++)
		most = fmax(most, st->member[c].T_max);
	frame->x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	frame->y = hawser__axis_of("{/:Italic y}", "m", 0.0);
	frame->z = hawser__axis_of("{/:Italic z}", "m", 0.0);
	frame->T = hawser__axis_of("Tension {/:Italic T}", "N", most);
	frame->height = TOP + frame->tall[1] + HAWSER__LEGEND_CM +
	                (frame->flat ? 0.0 : frame->tall[2] + TITLE);
}

/* The bed as the view along z cuts it in the middle of the net; the surface of the water. */
static void draw_levels(struct hawser__figure *figure, const struct frame *frame)
{
	const double surface = frame->net->water.surface, z = 0.5*(frame->box.low[2] + frame->box.high[2]);

	for (int i = 0; i < frame->net->surfaces; i++) {
		const struct hawser_surface *of = &frame->net->surface[i];

		if (of->heights)
			hawser__plot_bed_section(figure, of, frame->st, frame->box.low, frame->box.high);
		for (int end = 0; end < 2; end++) {
			double x = end ? frame->box.high[0] : frame->box.low[0];

			if (of->kind == HAWSER_SURFACE_SEGMENT)
				hawser__figure_put(figure, end ? of->to[0] : of->at[0], end ? of->to[1] : of->at[1]);
			else if (of->kind == HAWSER_SURFACE_PLANE && of->normal[1] != 0.0)
				hawser__figure_put(figure, x, of->at[1] - (of->normal[0]*(x - of->at[0]) +
				                   of->normal[2]*(z - of->at[2]))/of->normal[1]);
		}
		hawser__figure_gap(figure);
	}
	hawser__figure_draw(figure, "obstacles", "with lines lw 2.5 lc rgb '#a08060'");
	hawser__figure_put(figure, frame->box.low[0], surface);
	hawser__figure_put(figure, frame->box.high[0], surface);
	hawser__figure_draw(figure, "surface of the water", "with lines lw 1.5 lc rgb '#56b4e9'");
}

/* Cables by their tension, or the rods of bodies. */
static void draw_lines(struct hawser__figure *figure, const struct frame *frame, int k, int rods)
{
	for (int i = 0; i < frame->st->points; i++) {
		const struct hawser_net_point *point = &frame->st->point[i];
		const double row[3] = {point->x[0], point->x[k], point->T/frame->T.per};

		if (i > 0 && point->cable != frame->st->point[i - 1].cable)
			hawser__figure_gap(figure);
		if ((frame->net->cable[point->cable].rod != 0) == rods)
			hawser__figure_row(figure, "xy.", row);
	}
	if (rods)
		hawser__figure_draw(figure, "rods", "using 1:2 with lines lw 4 lc rgb '#404040'");
	else
		hawser__figure_draw(figure, NULL, "using 1:2:3 with lines lw 2 lc palette");
}

/* 1 if a node before it is so near that both names would be on each other. */
static int crowded(const struct frame *frame, int node, int k)
{
	const double near = BESIDE*(frame->box.high[0] - frame->box.low[0]);
	int is = 0;

	for (int i = 0; i < node && !is; i++)
		is = fabs(frame->st->x[i][0] - frame->st->x[node][0]) < 2.0*near &&
		     fabs(frame->st->x[i][k] - frame->st->x[node][k]) < near;
	return is;
}

static void draw_nodes(struct hawser__figure *figure, const struct frame *frame, int k)
{
	const struct hawser_net *net = frame->net;
	const struct hawser_net_statics *st = frame->st;

	for (int i = 0; i < st->contacts; i++)
		hawser__figure_put(figure, st->contact[i].x[0], st->contact[i].x[k]);
	hawser__figure_draw(figure, "touches", "with points pt 6 ps 0.35 lc rgb '#1A9850'");
	for (int support = 1; support >= 0; support--) {
		for (int i = 0; i < st->nodes; i++)
			if (net->node[i].support == support)
				hawser__figure_put(figure, st->x[i][0], st->x[i][k]);
		hawser__figure_draw(figure, NULL, support ? "with points pt 9 ps 1.0 lc rgb 'black'"
		                                          : "with points pt 7 ps 0.5 lc rgb 'black'");
	}
	for (int i = 0; i < st->nodes && st->nodes <= NAMED; i++)
		if (!crowded(frame, i, k))
			hawser__figure_name(figure, st->x[i][0], st->x[i][k],
			                    "left offset 0.5, 0.5 font ',9'", net->node[i].name);
}

static void colours(FILE *script, const struct frame *frame, double bottom, double tall)
{
	fprintf(script, "set cblabel '%s' offset 1, 0\n"
	        "set palette defined (0 '#4575B4', 1 '#91BFDB', 2 '#FEE090', 3 '#FC8D59', 4 '#D73027')\n"
	        "set colorbox user origin screen 0.87, screen %.4f size screen 0.02, screen %.4f\n",
	        frame->T.title, bottom/frame->height, tall/frame->height);
}

static void draw_view(struct hawser__figure *figure, const struct frame *frame, int k)
{
	double tall = frame->tall[k], top = k == 1 ? TOP : TOP + frame->tall[1] + TITLE;
	struct hawser__panel_frame at = {LEFT, RIGHT, 1.0 - (top + tall)/frame->height,
	                                 1.0 - top/frame->height,
		.x = {&frame->x, .tics = 10}, .y = {k == 1 ? &frame->y : &frame->z, .tics = 6}};

	hawser__panel_even(&at, &frame->box, k, (RIGHT - LEFT)*WIDTH, tall);
	hawser__figure_panel(figure, &at);
	if (k == 1)
		colours(figure->out.script, frame, frame->height - top - tall, tall);
	else
		fputs("unset colorbox\n", figure->out.script);
	if (k == 1)
		draw_levels(figure, frame);
	for (int i = 0; i < frame->net->surfaces && k == 2; i++)
		if (frame->net->surface[i].heights)
			hawser__plot_bed_contours(figure, &frame->net->surface[i], frame->box.low, frame->box.high);
	draw_lines(figure, frame, k, 1);
	draw_lines(figure, frame, k, 0);
	draw_nodes(figure, frame, k);
}

enum hawser_status hawser__plot_mooring(const char *path, const struct hawser_net *net,
                                        const struct hawser_net_statics *st,
                                        struct hawser_report *report)
{
	struct frame frame = {.net = net, .st = st};
	struct hawser__figure figure = {0};
	enum hawser_status status;

	measure(&frame);
	status = hawser__figure_begin(&figure, path, WIDTH, frame.height, report);
	if (status)
		return status;
	draw_view(&figure, &frame, 1);
	if (!frame.flat)
		draw_view(&figure, &frame, 2);
	return hawser__figure_finish(&figure, report);
}
