/* output/structures/plot_tow.c - see structures.h.
 *
 * Seen along z (y over x) and from above (z over x, z downwards), both with equal scales, and the
 * tension over the length. A ring is drawn with the links from the end of the cable to four of its
 * points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

#define WIDTH 17.0   /* cm */
#define SIDE 8.5     /* cm, height of the view along z */
#define ABOVE 5.5    /* cm, height of the view from above */
#define TENSION 3.2  /* cm, height of the panel of the tension */
#define TITLE 1.6    /* cm below a panel: tics and title */
#define TOP 0.3      /* cm above all */
#define LEFT 0.13    /* where panels begin, part of the width */
#define RIGHT 0.97   /* and end */
#define BODY "lc rgb '#d55e00'"
enum { AROUND = 72, LINKS = 4 }; /* points of the ring; links drawn to it */

struct frame {
	const struct hawser_tow *tow;
	const struct hawser_tow_steady *steady;
	struct hawser__axis x, y, z, s, T;
	struct hawser__box box;
	double height;
};

static void ring_point(double x[3], const struct frame *frame, double angle)
{
	const double *a = frame->steady->axis;
	/* across the axis: e is horizontal */
	double side = hypot(a[0], a[2]), e[3] = {1.0, 0.0, 0.0}, g[3];

	if (side > 0.0) {
		e[0] = -a[2]/side;
		e[2] = a[0]/side;
	}
	g[0] = a[1]*e[2] - a[2]*e[1];
	g[1] = a[2]*e[0] - a[0]*e[2];
	g[2] = a[0]*e[1] - a[1]*e[0];
	for (int k = 0; k < 3; k++)
		x[k] = frame->steady->centre[k] +
		       frame->tow->body.ring.radius*(cos(angle)*e[k] + sin(angle)*g[k]);
}

static int has_ring(const struct frame *frame)
{
	return frame->tow->body.kind == HAWSER_TOW_RING;
}

static void measure(struct frame *frame)
{
	double x[3];

	for (int i = 0; i < frame->steady->points; i++)
		hawser__box_add(&frame->box, frame->steady->point[i].x, 3);
	for (int i = 0; has_ring(frame) && i < AROUND; i++) {
		ring_point(x, frame, 2.0*acos(-1.0)*i/AROUND);
		hawser__box_add(&frame->box, x, 3);
	}
	frame->x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	frame->y = hawser__axis_of("{/:Italic y}", "m", 0.0);
	frame->z = hawser__axis_of("{/:Italic z}", "m", 0.0);
	frame->s = hawser__axis_of("Unstretched length from the towing point {/:Italic s}", "m", 0.0);
	frame->T = hawser__axis_of("Tension {/:Italic T}", "N", frame->steady->tension_top);
	frame->height = TOP + SIDE + ABOVE + TENSION + 2.0*TITLE + HAWSER__LEGEND_CM;
}

/* A place as a view along z (k 1: y over x) or from above (2: z over x) shows it. */
static void put(struct hawser__figure *figure, const double *x, int k)
{
	hawser__figure_put(figure, x[0], x[k]);
}

static void draw_ring(struct hawser__figure *figure, const struct frame *frame, int k)
{
	double x[3];

	for (int i = 0; has_ring(frame) && i < LINKS; i++) {
		put(figure, frame->steady->end, k);
		ring_point(x, frame, 2.0*acos(-1.0)*i/LINKS);
		put(figure, x, k);
		hawser__figure_gap(figure);
	}
	hawser__figure_draw(figure, NULL, "with lines " BODY " lw 0.6");
	for (int i = 0; has_ring(frame) && i <= AROUND; i++) {
		ring_point(x, frame, 2.0*acos(-1.0)*i/AROUND);
		put(figure, x, k);
	}
	hawser__figure_draw(figure, "ring and links", "with lines " BODY " lw 2");
}

static void draw_orbit(struct hawser__figure *figure, const struct frame *frame, int k)
{
	const struct hawser_path *path = &frame->tow->path;

	for (int i = 0; frame->steady->spin != 0.0 && i <= AROUND; i++) {
		double angle = 2.0*acos(-1.0)*i/AROUND;
		const double x[] = {path->origin[0] + path->radius*cos(angle), path->origin[1],
		                    path->origin[2] + path->radius*sin(angle)};

		put(figure, x, k);
	}
	hawser__figure_draw(figure, "orbit of the towing point",
	                    "with lines lc rgb '#a0a0a0' lw 1 dt (6,5)");
}

static void draw_view(struct hawser__figure *figure, const struct frame *frame, int k)
{
	double tall = k == 1 ? SIDE : ABOVE, top = k == 1 ? TOP : TOP + SIDE + TITLE;
	struct hawser__panel_frame at = {LEFT, RIGHT, 1.0 - (top + tall)/frame->height,
	                                 1.0 - top/frame->height,
		.x = {&frame->x, .tics = 10}, .y = {k == 1 ? &frame->y : &frame->z, .tics = 6}};

	hawser__panel_even(&at, &frame->box, k, (RIGHT - LEFT)*WIDTH, tall);
	hawser__figure_panel(figure, &at);
	fprintf(figure->out.script, "set label '%s' at graph 0.985,%s right font ',9'\n",
	        k == 1 ? "seen along {/:Italic z}" : "seen from above", k == 1 ? "0.95" : "0.07");
	draw_orbit(figure, frame, k);
	draw_ring(figure, frame, k);
	for (int i = 0; i < frame->steady->points; i++)
		put(figure, frame->steady->point[i].x, k);
	hawser__figure_draw(figure, "cable", "with lines lt 7 lw 1.8");
	put(figure, frame->steady->point[0].x, k);
	hawser__figure_draw(figure, "towing point", "with points pt 7 ps 0.9 lc rgb 'black'");
	if (frame->tow->body.kind == HAWSER_TOW_MASS)
		put(figure, frame->steady->centre, k);
	hawser__figure_draw(figure, "body", "with points pt 7 ps 1.2 " BODY);
}

enum hawser_status hawser__plot_tow(const char *path, const struct hawser_tow *tow,
                                    const struct hawser_tow_steady *steady,
                                    struct hawser_report *report)
{
	struct frame frame = {.tow = tow, .steady = steady};
	struct hawser__figure figure = {0};
	double bottom, end = steady->point[steady->points - 1].s;
	enum hawser_status status;

	measure(&frame);
	status = hawser__figure_begin(&figure, path, WIDTH, frame.height, report);
	if (status)
		return status;
	draw_view(&figure, &frame, 1);
	draw_view(&figure, &frame, 2);
	bottom = HAWSER__LEGEND_CM/frame.height;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){LEFT, RIGHT, bottom,
		bottom + TENSION/frame.height, .x = {&frame.s, 0.0, end, .tics = 10},
		.y = {&frame.T, .zero = 1, .tics = 5, .open = 1}});
	hawser__figure_bind(&figure, steady->points, &steady->point[0].s, sizeof *steady->point,
	                    &steady->point[0].tension, sizeof *steady->point);
	hawser__figure_draw(&figure, NULL, "with lines lt 7 lw 1.8");
	return hawser__figure_finish(&figure, report);
}
