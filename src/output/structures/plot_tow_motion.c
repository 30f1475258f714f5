/* output/structures/plot_tow_motion.c - see plot_tow_motion.h.
 *
 * The ways of towing point and body from above, with equal scales; tilt and tension at the towing point
 * over the time; and the range of the tension along the cable: least, mean and most.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/structures/plot_tow_motion.h"
#include "output/drawing/style.h"

#define WIDTH 17.0 /* cm */
#define ABOVE 6.0  /* cm, height of the view from above */
#define PANEL 3.4  /* cm, height of another panel */
#define TITLE 1.6  /* cm below a panel: tics and title */
#define TOP 0.3    /* cm above all */
#define LEFT 0.13  /* where panels begin, part of the width */
#define RIGHT 0.97 /* and end */
#define FLAT 1e-4  /* of the other range: a way that is narrower is drawn in one so wide */

struct frame {
	const struct hawser_tow_motion *motion;
	struct hawser__axis x, z, t, tilt, T, range, s;
	double low[2], high[2], height, below; /* of x and z; cm, of the picture and above the next panel */
};

static void measure(struct frame *frame)
{
	const struct hawser_tow_motion *motion = frame->motion;
	double most = 0.0, top = 0.0;

	for (int k = 0; k < 2; k++) {
		frame->low[k] = INFINITY;
		frame->high[k] = -INFINITY;
	}
	for (int i = 0; i < motion->samples; i++)
		for (int k = 0; k < 4; k++) {
			const struct hawser_tow_sample *at = &motion->sample[i];
			double value = (k < 2 ? at->top : at->body)[k % 2 ? 2 : 0];

			frame->low[k % 2] = fmin(frame->low[k % 2], value);
			frame->high[k % 2] = fmax(frame->high[k % 2], value);
			top = fmax(top, at->tension_top);
		}
	for (int e = 0; e < motion->elements; e++)
		most = fmax(most, motion->range[e].most);
	frame->x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	frame->z = hawser__axis_of("{/:Italic z}", "m", 0.0);
	frame->t = hawser__axis_of("Time {/:Italic t}", "s", 0.0);
	frame->tilt = hawser__axis_of("Tilt", "rad", 0.0);
	frame->T = hawser__axis_of("{/:Italic T} at the top", "N", top);
	frame->range = hawser__axis_of("Tension {/:Italic T}", "N", most);
	frame->s = hawser__axis_of("Unstretched length from the towing point {/:Italic s}", "m", 0.0);
	frame->height = TOP + ABOVE + 3.0*PANEL + 3.0*TITLE + HAWSER__LEGEND_CM;
	frame->below = frame->height - TOP;
}

static void data(FILE *script, const struct frame *frame)
{
	const struct hawser_tow_motion *motion = frame->motion;

	fputs("$time << END\n", script);
	for (int i = 0; i < motion->samples; i++) {
		const struct hawser_tow_sample *at = &motion->sample[i];

		fprintf(script, "%.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", at->t/frame->t.per,
		        at->top[0]/frame->x.per, at->top[2]/frame->z.per, at->body[0]/frame->x.per,
		        at->body[2]/frame->z.per, at->tilt/frame->tilt.per, at->tension_top/frame->T.per);
	}
	fputs("END\n$range << END\n", script);
	for (int e = 0; e < motion->elements; e++) {
		const struct hawser_tow_range *at = &motion->range[e];

		fprintf(script, "%.9g %.9g %.9g %.9g\n", at->s/frame->s.per, at->least/frame->range.per,
		        at->mean/frame->range.per, at->most/frame->range.per);
	}
	fputs("END\n", script);
}

/* The next panel downwards. */
static void panel(struct hawser__picture *picture, struct frame *frame, double tall)
{
	hawser__picture_panel(picture, LEFT, RIGHT, (frame->below - tall)/frame->height,
	                      frame->below/frame->height);
	frame->below -= tall + TITLE;
}

static void above(struct hawser__picture *picture, struct frame *frame)
{
	double wide = frame->high[0] - frame->low[0], deep = frame->high[1] - frame->low[1];
	double width = (RIGHT - LEFT)*WIDTH, x, z, per_cm;

	wide = fmax(wide, FLAT*deep);
	deep = fmax(deep, FLAT*wide);
	per_cm = 1.16*fmax(wide/width, deep/ABOVE); /* a margin of 8 % on each side */
	per_cm = per_cm > 0.0 ? per_cm : 0.1; /* at rest: 1 m in 10 cm */
	x = 0.5*(frame->low[0] + frame->high[0]);
	z = 0.5*(frame->low[1] + frame->high[1]);
	panel(picture, frame, ABOVE);
	fprintf(picture->script, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n"
	        "set xlabel '%s' offset 0,0.3\n", (x - 0.5*per_cm*width)/frame->x.per,
	        (x + 0.5*per_cm*width)/frame->x.per, (z + 0.5*per_cm*ABOVE)/frame->z.per,
	        (z - 0.5*per_cm*ABOVE)/frame->z.per, frame->x.title);
	hawser__picture_tics(picture, 'x', (x - 0.5*per_cm*width)/frame->x.per,
	                     (x + 0.5*per_cm*width)/frame->x.per, 10);
	hawser__picture_tics(picture, 'y', (z - 0.5*per_cm*ABOVE)/frame->z.per,
	                     (z + 0.5*per_cm*ABOVE)/frame->z.per, 6);
	hawser__picture_ylabel(picture, "%s", frame->z.title);
	fputs("set label 2 'seen from above' at graph 0.985,0.07 right font ',9'\n"
	      "plot $time using 2:3 with lines lt 7 lw 1.2 dt (6,5), "
	      "$time using 4:5 with lines lt 1 lw 1.8\n"
	      "unset label 2\n", picture->script);
}

static void over_time(struct hawser__picture *picture, struct frame *frame, const char *title,
                      int column)
{
	const struct hawser_tow_sample *sample = frame->motion->sample;
	double from = sample[0].t/frame->t.per, to = sample[frame->motion->samples - 1].t/frame->t.per;

	panel(picture, frame, PANEL);
	fprintf(picture->script, "set xrange [%.9g:%.9g]\nset yrange [*:*]\n"
	        "set xlabel '%s' offset 0,0.3\n", from, to, frame->t.title);
	hawser__picture_tics(picture, 'x', from, to, 10);
	fputs("set ytics autofreq\n", picture->script);
	hawser__picture_ylabel(picture, "%s", title);
	fprintf(picture->script, "plot $time using 1:%d with lines lt 1 lw 1.4\n", column);
}

static void along(struct hawser__picture *picture, struct frame *frame)
{
	panel(picture, frame, PANEL);
	fprintf(picture->script, "set xrange [0:*]\nset yrange [*:*]\nset xlabel '%s' offset 0,0.3\n",
	        frame->s.title);
	fputs("set xtics autofreq\nset ytics autofreq\n", picture->script);
	hawser__picture_ylabel(picture, "%s", frame->range.title);
	fputs("plot $range using 1:2:4 with filledcurves lc rgb '#d8e4f0', "
	      "$range using 1:2 with lines lt 3 lw 1.2, $range using 1:4 with lines lt 2 lw 1.2, "
	      "$range using 1:3 with lines lt 7 lw 1.8\n", picture->script);
}

enum hawser_status hawser__plot_tow_motion(const char *path, const struct hawser_tow_motion *motion,
                                           struct hawser_report *report)
{
	struct frame frame = {.motion = motion};
	struct hawser__picture picture;
	struct hawser__legend entries = {0};
	enum hawser_status status;

	measure(&frame);
	status = hawser__picture_begin(&picture, path, WIDTH, frame.height, report);
	if (status)
		return status;
	data(picture.script, &frame);
	fputs("unset key\n", picture.script);
	above(&picture, &frame);
	over_time(&picture, &frame, frame.tilt.title, 6);
	over_time(&picture, &frame, frame.T.title, 7);
	along(&picture, &frame);
	hawser__legend_add(&entries, "towing point", "with lines lt 7 lw 1.2 dt (6,5)");
	hawser__legend_add(&entries, "body", "with lines lt 1 lw 1.8");
	hawser__legend_add(&entries, "least", "with lines lt 3 lw 1.2");
	hawser__legend_add(&entries, "mean", "with lines lt 7 lw 1.8");
	hawser__legend_add(&entries, "most", "with lines lt 2 lw 1.2");
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
