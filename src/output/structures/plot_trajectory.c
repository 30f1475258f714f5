/* output/structures/plot_trajectory.c - see structures.h.
 *
 * The path is seen from above, with equal scales: x to the right and z downwards, since y points to the
 * eye, so that a left turn is one. A panel of the height is there if it changes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"
#include "output/drawing/figure.h"

#define WIDTH 17.0 /* cm */
#define PLAN 8.0   /* cm, height of the view from above */
#define TALL 3.4   /* cm, height of a panel over time */
#define GAP 0.7    /* cm between two panels over time */
#define TITLE 1.6  /* cm below the view from above: tics and title of x */
#define TOP 0.3    /* cm above all */
#define LEFT 0.13  /* where panels begin, part of the width */
#define RIGHT 0.97 /* and its end */
#define LEVEL 1e-9 /* a height that changes by less of the path's extent does not */
enum { NUMBERED = 30 /* waypoints that are marked by their number; more are points alone */ };

#define BEGIN "with points pt 6 ps 1.5 lc rgb 'black'"
#define WAYPOINTS "with points pt 7 ps 0.6 lc rgb 'black'"

static const char *const component[3] = {"lc rgb '#0072b2' lw 1", "lc rgb '#009e73' lw 1 dt (10,4)",
                                         "lc rgb '#d55e00' lw 1 dt (4,4)"};

struct frame {
	const struct hawser__trajectory_picture *of;
	struct hawser__axis t, x, y, z, rate[2];
	struct hawser__box box;
	double height;
	int climbs; /* 1: with a panel of the height */
};

static void measure(struct frame *frame)
{
	const struct hawser__trajectory_picture *of = frame->of;
	double extent = 0.0;

	for (int i = 0; i < of->points; i++)
		hawser__box_add(&frame->box, of->point[i].state[0], 3);
	for (int axis = 0; axis < 3; axis++)
		extent = fmax(extent, frame->box.high[axis] - frame->box.low[axis]);
	frame->climbs = frame->box.high[1] - frame->box.low[1] > LEVEL*extent;
	frame->height = TOP + PLAN + TITLE + (2 + frame->climbs)*(TALL + GAP) + HAWSER__LEGEND_CM - GAP;
	frame->t = hawser__axis_of("Time {/:Italic t}", "s", 0.0);
	frame->x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	frame->y = hawser__axis_of("Height {/:Italic y}", "m", 0.0);
	frame->z = hawser__axis_of("{/:Italic z}", "m", 0.0);
	frame->rate[0] = hawser__axis_of("Velocity", "m/s", 0.0);
	frame->rate[1] = hawser__axis_of("Acceleration", "m/s^2", 0.0);
}

static void draw_plan(struct hawser__figure *figure, const struct frame *frame)
{
	const struct hawser__trajectory_picture *of = frame->of;
	struct hawser__panel_frame at = {LEFT, RIGHT, 1.0 - (TOP + PLAN)/frame->height,
	                                 1.0 - TOP/frame->height,
		.x = {&frame->x, .tics = 10}, .y = {&frame->z, .tics = 6}};
	size_t step = sizeof *of->point;

	hawser__panel_even(&at, &frame->box, 2, (RIGHT - LEFT)*WIDTH, PLAN);
	hawser__figure_panel(figure, &at);
	fputs("set label 'seen from above' at graph 0.985,0.05 right font ',9'\n", figure->out.script);
	hawser__figure_bind(figure, of->points, &of->point->state[0][0], step, &of->point->state[0][2],
	                    step);
	hawser__figure_draw(figure, NULL, "with lines lt 7 lw 1.6");
	hawser__figure_put(figure, of->point->state[0][0], of->point->state[0][2]);
	hawser__figure_draw(figure, NULL, BEGIN);
	for (int i = 0; i < of->waypoints; i++) {
		const double *x = of->waypoint[i].at[0];

		hawser__figure_put(figure, x[0], x[2]);
		if (of->waypoints <= NUMBERED)
			hawser__figure_label(figure, x[0], x[2], "left offset 0.7,0.6 font ',9'", "%d",
			                     of->first + i);
	}
	hawser__figure_draw(figure, NULL, WAYPOINTS);
}

/* Panel k over time, counted from above: the height, or (order > 0) components and magnitude of
 * velocity or acceleration. */
static void draw_over_time(struct hawser__figure *figure, const struct frame *frame, int k, int order)
{
	static const char *const title[3] = {"along {/:Italic x}", "along {/:Italic y}",
	                                     "along {/:Italic z}"};
	const struct hawser__trajectory_picture *of = frame->of;
	double top = frame->height - TOP - PLAN - TITLE - k*(TALL + GAP);

	hawser__figure_panel(figure, &(struct hawser__panel_frame){LEFT, RIGHT, (top - TALL)/frame->height,
		top/frame->height, .y = {.axis = order ? &frame->rate[order - 1] : &frame->y},
		.x = {&frame->t, of->point[0].t, of->point[of->points - 1].t, .tics = 10, .bare = order < 2}});
	fputs("set xzeroaxis lt 7 lw 0.4\n", figure->out.script);
	for (int i = 0; i < of->waypoints && of->waypoints <= NUMBERED; i++)
		hawser__figure_upright(figure, NULL, of->waypoint[i].t, "back lc rgb '#b0b0b0' lw 0.6");
	hawser__legend_once(&figure->legend, "path, magnitude", "with lines lt 7 lw 1.6");
	for (int axis = 0; axis < 3 && order; axis++) {
		for (int i = 0; i < of->points && (axis != 1 || frame->climbs); i++)
			hawser__figure_put(figure, of->point[i].t, of->point[i].state[order][axis]);
		hawser__figure_draw(figure, title[axis], "with lines %s", component[axis]);
	}
	for (int i = 0; i < of->points; i++) {
		const double *v = of->point[i].state[order];

		hawser__figure_put(figure, of->point[i].t, order ? hypot(hypot(v[0], v[1]), v[2]) : v[1]);
	}
	hawser__figure_draw(figure, NULL, "with lines lt 7 lw 1.6");
}

enum hawser_status hawser__plot_trajectory(const char *path,
                                           const struct hawser__trajectory_picture *of,
                                           struct hawser_report *report)
{
	struct frame frame = {.of = of};
	struct hawser__figure figure = {0};
	enum hawser_status status;
	int k = 0;

	measure(&frame);
	status = hawser__figure_begin(&figure, path, WIDTH, frame.height, report);
	if (status)
		return status;
	draw_plan(&figure, &frame);
	for (int order = frame.climbs ? 0 : 1; order <= 2; order++)
		draw_over_time(&figure, &frame, k++, order);
	hawser__legend_once(&figure.legend, "begin", BEGIN);
	if (of->waypoints)
		hawser__legend_once(&figure.legend, "waypoints", WAYPOINTS);
	return hawser__figure_finish(&figure, report);
}
