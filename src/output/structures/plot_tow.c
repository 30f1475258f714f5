/* output/structures/plot_tow.c - see plot_tow.h.
 *
 * Seen along z (y over x) and from above (z over x, z downwards), both with equal scales, and the
 * tension over the length. A ring is drawn with the links from the end of the cable to four of its
 * points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/structures/plot_tow.h"
#include "output/drawing/style.h"

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
	double low[3], high[3], height;
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

static void add(struct frame *frame, const double *x)
{
	for (int k = 0; k < 3; k++) {
		frame->low[k] = fmin(frame->low[k], x[k]);
		frame->high[k] = fmax(frame->high[k], x[k]);
	}
}

static int has_ring(const struct frame *frame)
{
	return frame->tow->body.kind == HAWSER_TOW_RING;
}

static void measure(struct frame *frame)
{
	double x[3];

	for (int k = 0; k < 3; k++) {
		frame->low[k] = INFINITY;
		frame->high[k] = -INFINITY;
	}
	for (int i = 0; i < frame->steady->points; i++)
		add(frame, frame->steady->point[i].x);
	for (int i = 0; has_ring(frame) && i < AROUND; i++) {
		ring_point(x, frame, 2.0*acos(-1.0)*i/AROUND);
		add(frame, x);
	}
	frame->x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	frame->y = hawser__axis_of("{/:Italic y}", "m", 0.0);
	frame->z = hawser__axis_of("{/:Italic z}", "m", 0.0);
	frame->s = hawser__axis_of("Unstretched length from the towing point {/:Italic s}", "m", 0.0);
	frame->T = hawser__axis_of("Tension {/:Italic T}", "N", frame->steady->tension_top);
	frame->height = TOP + SIDE + ABOVE + TENSION + 2.0*TITLE + HAWSER__LEGEND_CM;
}

static void line(FILE *script, const struct frame *frame, const double *x)
{
	fprintf(script, "%.9g %.9g %.9g\n", x[0]/frame->x.per, x[1]/frame->y.per, x[2]/frame->z.per);
}

static void data(FILE *script, const struct frame *frame)
{
	const struct hawser_tow_steady *steady = frame->steady;
	double x[3];

	fputs("$cable << END\n", script);
	for (int i = 0; i < steady->points; i++) {
		const struct hawser_tow_point *p = &steady->point[i];

		fprintf(script, "%.9g %.9g %.9g %.9g %.9g\n", p->x[0]/frame->x.per, p->x[1]/frame->y.per,
		        p->x[2]/frame->z.per, p->s/frame->s.per, p->tension/frame->T.per);
	}
	fputs("END\n$body << END\n", script);
	line(script, frame, steady->centre);
	fputs("END\n$ring << END\nNaN NaN NaN\n", script);
	for (int i = 0; has_ring(frame) && i <= AROUND; i++) {
		ring_point(x, frame, 2.0*acos(-1.0)*i/AROUND);
		line(script, frame, x);
	}
	fputs("END\n$links << END\nNaN NaN NaN\n", script);
	for (int i = 0; has_ring(frame) && i < LINKS; i++) {
		line(script, frame, steady->end);
		ring_point(x, frame, 2.0*acos(-1.0)*i/LINKS);
		line(script, frame, x);
		fputs("\n", script);
	}
	fputs("END\n$orbit << END\nNaN NaN NaN\n", script);
	for (int i = 0; steady->spin != 0.0 && i <= AROUND; i++) {
		const struct hawser_path *path = &frame->tow->path;
		double angle = 2.0*acos(-1.0)*i/AROUND;

		x[0] = path->origin[0] + path->radius*cos(angle);
		x[1] = path->origin[1];
		x[2] = path->origin[2] + path->radius*sin(angle);
		line(script, frame, x);
	}
	fputs("END\n", script);
}

/* Ranges with equal scales for coordinates 0 and k in a panel of this height (cm). */
static void ranges(double x[2], double y[2], const struct frame *frame, int k, double height)
{
	double width = (RIGHT - LEFT)*WIDTH, per_y = k == 1 ? frame->y.per : frame->z.per;
	double wide = (frame->high[0] - frame->low[0])/frame->x.per,
	       tall = (frame->high[k] - frame->low[k])/per_y;
	double per_cm = 1.16*fmax(wide/width, tall/height); /* a margin of 8 % on each side */
	double x_middle = 0.5*(frame->high[0] + frame->low[0])/frame->x.per,
	       y_middle = 0.5*(frame->high[k] + frame->low[k])/per_y;

	if (!(per_cm > 0.0))
		per_cm = 0.1; /* a cable that hangs down, from above: 1 m in 10 cm */
	x[0] = x_middle - 0.5*per_cm*width;
	x[1] = x_middle + 0.5*per_cm*width;
	y[0] = y_middle - 0.5*per_cm*height;
	y[1] = y_middle + 0.5*per_cm*height;
}

static void view(struct hawser__picture *picture, const struct frame *frame, int k)
{
	FILE *script = picture->script;
	double tall = k == 1 ? SIDE : ABOVE, top = k == 1 ? TOP : TOP + SIDE + TITLE, x[2], y[2];

	ranges(x, y, frame, k, tall);
	hawser__picture_panel(picture, LEFT, RIGHT, 1.0 - (top + tall)/frame->height,
	                      1.0 - top/frame->height);
	fprintf(script, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\nset xlabel '%s' offset 0,0.3\n",
	        x[0], x[1], y[k == 1 ? 0 : 1], y[k == 1 ? 1 : 0], frame->x.title);
	hawser__picture_tics(picture, 'x', x[0], x[1], 10);
	hawser__picture_tics(picture, 'y', y[0], y[1], 6);
	hawser__picture_ylabel(picture, "%s", k == 1 ? frame->y.title : frame->z.title);
	fprintf(script, "set label 2 '%s' at graph 0.985,%s right font ',9'\n",
	        k == 1 ? "seen along {/:Italic z}" : "seen from above", k == 1 ? "0.95" : "0.07");
	fprintf(script, "plot $orbit using 1:%d with lines lc rgb '#a0a0a0' lw 1 dt (6,5), $links using "
	        "1:%d with lines " BODY " lw 0.6, $ring using 1:%d with lines " BODY " lw 2, $cable using "
	        "1:%d with lines lt 7 lw 1.8, $cable using 1:%d every ::::0 with points pt 7 ps 0.9 lc rgb "
	        "'black'", k + 1, k + 1, k + 1, k + 1, k + 1);
	if (frame->tow->body.kind == HAWSER_TOW_MASS)
		fprintf(script, ", $body using 1:%d with points pt 7 ps 1.2 " BODY, k + 1);
	fputs("\nunset label 2\n", script);
}

static void legend(struct hawser__picture *picture, const struct frame *frame)
{
	struct hawser__legend entries = {0};

	hawser__legend_add(&entries, "cable", "with lines lt 7 lw 1.8");
	hawser__legend_add(&entries, "towing point", "with points pt 7 ps 0.9 lc rgb 'black'");
	if (has_ring(frame))
		hawser__legend_add(&entries, "ring and links", "with lines " BODY " lw 2");
	else if (frame->tow->body.kind == HAWSER_TOW_MASS)
		hawser__legend_add(&entries, "body", "with points pt 7 ps 1.2 " BODY);
	if (frame->steady->spin != 0.0)
		hawser__legend_add(&entries, "orbit of the towing point",
		                   "with lines lc rgb '#a0a0a0' lw 1 dt (6,5)");
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_tow(const char *path, const struct hawser_tow *tow,
                                    const struct hawser_tow_steady *steady,
                                    struct hawser_report *report)
{
	struct frame frame = {.tow = tow, .steady = steady};
	struct hawser__picture picture;
	enum hawser_status status;
	double bottom;

	measure(&frame);
	status = hawser__picture_begin(&picture, path, WIDTH, frame.height, report);
	if (status)
		return status;
	data(picture.script, &frame);
	fputs("unset key\n", picture.script);
	view(&picture, &frame, 1);
	view(&picture, &frame, 2);
	bottom = HAWSER__LEGEND_CM/frame.height;
	hawser__picture_panel(&picture, LEFT, RIGHT, bottom, bottom + TENSION/frame.height);
	fprintf(picture.script, "set xrange [0:%.9g]\nset yrange [0:*]\n"
	        "set xlabel '%s' offset 0,0.3\n", steady->point[steady->points - 1].s/frame.s.per,
	        frame.s.title);
	hawser__picture_tics(&picture, 'x', 0.0, steady->point[steady->points - 1].s/frame.s.per, 10);
	hawser__picture_tics(&picture, 'y', 0.0, steady->tension_top/frame.T.per, 5);
	hawser__picture_ylabel(&picture, "%s", frame.T.title);
	fputs("plot $cable using 4:5 with lines lt 7 lw 1.8\n", picture.script);
	legend(&picture, &frame);
	return hawser__picture_finish(&picture, report);
}
