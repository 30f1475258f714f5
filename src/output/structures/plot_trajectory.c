/* output/structures/plot_trajectory.c - see plot_trajectory.h.
 *
 * The path is seen from above, with equal scales: x to the right and z downwards, since y points to the
 * eye, so that a left turn is one. A panel of the height is there if it changes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/structures/plot_trajectory.h"
#include "output/drawing/style.h"

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

static const char *const component[3] = {"lc rgb '#0072b2' lw 1", "lc rgb '#009e73' lw 1 dt (10,4)",
                                         "lc rgb '#d55e00' lw 1 dt (4,4)"};

struct frame {
	const struct hawser__trajectory_picture *of;
	struct hawser__axis t, x, y, z, rate[2];
	double low[3], high[3], height;
	int climbs; /* 1: with a panel of the height */
};

static void measure(struct frame *frame)
{
	const struct hawser__trajectory_picture *of = frame->of;
	double extent = 0.0;

	for (int axis = 0; axis < 3; axis++) {
		frame->low[axis] = INFINITY;
		frame->high[axis] = -INFINITY;
		for (int i = 0; i < of->points; i++) {
			frame->low[axis] = fmin(frame->low[axis], of->point[i].state[0][axis]);
			frame->high[axis] = fmax(frame->high[axis], of->point[i].state[0][axis]);
		}
		extent = fmax(extent, frame->high[axis] - frame->low[axis]);
	}
	frame->climbs = frame->high[1] - frame->low[1] > LEVEL*extent;
	frame->height = TOP + PLAN + TITLE + (2 + frame->climbs)*(TALL + GAP) + HAWSER__LEGEND_CM - GAP;
	frame->t = hawser__axis_of("Time {/:Italic t}", "s", 0.0);
	frame->x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	frame->y = hawser__axis_of("Height {/:Italic y}", "m", 0.0);
	frame->z = hawser__axis_of("{/:Italic z}", "m", 0.0);
	frame->rate[0] = hawser__axis_of("Velocity", "m/s", 0.0);
	frame->rate[1] = hawser__axis_of("Acceleration", "m/s^2", 0.0);
}

/* $path: t, x, y, z, then components and norm of velocity and acceleration. */
static void data(FILE *script, const struct frame *frame)
{
	const struct hawser__trajectory_picture *of = frame->of;

	fputs("$path << END\n", script);
	for (int i = 0; i < of->points; i++) {
		const struct hawser__trajectory_point *p = &of->point[i];

		fprintf(script, "%.12g %.9g %.9g %.9g", p->t/frame->t.per, p->state[0][0]/frame->x.per,
		        p->state[0][1]/frame->y.per, p->state[0][2]/frame->z.per);
		for (int k = 1; k <= 2; k++) {
			const double *v = p->state[k];
			double per = frame->rate[k - 1].per;

			fprintf(script, " %.9g %.9g %.9g %.9g", v[0]/per, v[1]/per, v[2]/per,
			        hypot(hypot(v[0], v[1]), v[2])/per);
		}
		fputc('\n', script);
	}
	fputs("END\n$waypoints << END\nNaN NaN NaN NaN none\n", script);
	for (int i = 0; i < of->waypoints; i++) {
		const double *at = of->waypoint[i].at[0];

		fprintf(script, "%.12g %.9g %.9g %.9g %d\n", of->waypoint[i].t/frame->t.per,
		        at[0]/frame->x.per, at[1]/frame->y.per, at[2]/frame->z.per, of->first + i);
	}
	fputs("END\n", script);
}

/* Ranges of x and z with equal scales in a panel of this width and PLAN (cm). */
static void plan_ranges(double x[2], double z[2], const struct frame *frame, double width)
{
	double wide = (frame->high[0] - frame->low[0])/frame->x.per,
	       deep = (frame->high[2] - frame->low[2])/frame->z.per;
	double per_cm = 1.16*fmax(wide/width, deep/PLAN); /* a margin of 8 % on each side */
	double x_middle = 0.5*(frame->high[0] + frame->low[0])/frame->x.per,
	       z_middle = 0.5*(frame->high[2] + frame->low[2])/frame->z.per;

	if (!(per_cm > 0.0))
		per_cm = 0.1; /* a path straight upwards, or at rest: 1 m in 10 cm */
	x[0] = x_middle - 0.5*per_cm*width;
	x[1] = x_middle + 0.5*per_cm*width;
	z[0] = z_middle - 0.5*per_cm*PLAN;
	z[1] = z_middle + 0.5*per_cm*PLAN;
}

static void plan(struct hawser__picture *picture, const struct frame *frame)
{
	FILE *script = picture->script;
	const struct hawser__trajectory_picture *of = frame->of;
	double bottom = 1.0 - (TOP + PLAN)/frame->height, x[2], z[2];

	plan_ranges(x, z, frame, (RIGHT - LEFT)*WIDTH);
	hawser__picture_panel(picture, LEFT, RIGHT, bottom, 1.0 - TOP/frame->height);
	fprintf(script, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\nset xlabel '%s' offset 0,0.3\n",
	        x[0], x[1], z[1], z[0], frame->x.title);
	hawser__picture_tics(picture, 'x', x[0], x[1], 10);
	hawser__picture_tics(picture, 'y', z[0], z[1], 6);
	hawser__picture_ylabel(picture, "%s", frame->z.title);
	fputs("set label 2 'seen from above' at graph 0.985,0.05 right font ',9'\n"
	      "plot $path using 2:4 with lines lt 7 lw 1.6, $path using 2:4 every ::::0 with points pt 6 "
	      "ps 1.5 lc rgb 'black'", script);
	if (of->waypoints)
		fputs(", $waypoints using 2:4 with points pt 7 ps 0.6 lc rgb 'black'", script);
	if (of->waypoints && of->waypoints <= NUMBERED)
		fputs(", $waypoints using 2:4:5 with labels left offset 0.7,0.6 font ',9'", script);
	fputs("\nunset label 2\n", script);
}

/* Panel k over time, counted from above; `last` has the tics of time. */
static void over_time(struct hawser__picture *picture, const struct frame *frame, int k,
                      const char *title, int last)
{
	FILE *script = picture->script;
	const struct hawser__trajectory_picture *of = frame->of;
	double top = frame->height - TOP - PLAN - TITLE - k*(TALL + GAP);
	double t0 = of->point[0].t/frame->t.per, t1 = of->point[of->points - 1].t/frame->t.per;

	hawser__picture_panel(picture, LEFT, RIGHT, (top - TALL)/frame->height, top/frame->height);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [*:*]\nset ytics autofreq\n"
	        "set format x '%s'\n", t0, t1, last ? "%g" : "");
	if (last)
		hawser__picture_tics(picture, 'x', t0, t1, 10);
	else
		fputs("set xtics autofreq\nunset xlabel\n", script);
	if (last)
		fprintf(script, "set xlabel '%s' offset 0,0.3\n", frame->t.title);
	hawser__picture_ylabel(picture, "%s", title);
	for (int i = 0; i < of->waypoints && of->waypoints <= NUMBERED; i++)
		fprintf(script, "set arrow %d from first %.12g, graph 0 to first %.12g, graph 1 nohead back "
		        "lc rgb '#b0b0b0' lw 0.6\n", i + 1, of->waypoint[i].t/frame->t.per,
		        of->waypoint[i].t/frame->t.per);
}

static void rates(FILE *script, const struct frame *frame, int order)
{
	int column = 5 + 4*(order - 1);

	fputs("plot ", script);
	for (int axis = 0; axis < 3; axis++)
		if (axis != 1 || frame->climbs)
			fprintf(script, "$path using 1:%d with lines %s, ", column + axis, component[axis]);
	fprintf(script, "$path using 1:%d with lines lt 7 lw 1.6\n", column + 3);
}

static void legend(struct hawser__picture *picture, const struct frame *frame)
{
	static const char *const title[3] = {"along {/:Italic x}", "along {/:Italic y}",
	                                     "along {/:Italic z}"};
	struct hawser__legend entries = {0};

	hawser__legend_add(&entries, "path, magnitude", "with lines lt 7 lw 1.6");
	for (int axis = 0; axis < 3; axis++)
		if (axis != 1 || frame->climbs)
			hawser__legend_add(&entries, title[axis], "with lines %s", component[axis]);
	hawser__legend_add(&entries, "begin", "with points pt 6 ps 1.5 lc rgb 'black'");
	if (frame->of->waypoints)
		hawser__legend_add(&entries, "waypoints", "with points pt 7 ps 0.6 lc rgb 'black'");
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_trajectory(const char *path,
                                           const struct hawser__trajectory_picture *of,
                                           struct hawser_report *report)
{
	struct frame frame = {.of = of};
	struct hawser__picture picture;
	enum hawser_status status;
	int k = 0;

	measure(&frame);
	status = hawser__picture_begin(&picture, path, WIDTH, frame.height, report);
	if (status)
		return status;
	data(picture.script, &frame);
	fputs("unset key\n", picture.script);
	plan(&picture, &frame);
	fputs("set xzeroaxis lt 7 lw 0.4\n", picture.script);
	if (frame.climbs) {
		over_time(&picture, &frame, k++, frame.y.title, 0);
		fputs("plot $path using 1:3 with lines lt 7 lw 1.6\n", picture.script);
	}
	over_time(&picture, &frame, k++, frame.rate[0].title, 0);
	rates(picture.script, &frame, 1);
	over_time(&picture, &frame, k, frame.rate[1].title, 1);
	rates(picture.script, &frame, 2);
	fprintf(picture.script, "unset arrow\n");
	legend(&picture, &frame);
	return hawser__picture_finish(&picture, report);
}
