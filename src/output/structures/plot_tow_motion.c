/* output/structures/plot_tow_motion.c - see structures.h.
 *
 * The ways of towing point and body from above, with equal scales; tilt and tension at the towing point
 * over the time; and the range of the tension along the cable: least, mean and most.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

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
	struct hawser__box box;
	double height, below; /* cm, of the picture and above the next panel */
};

static void measure(struct frame *frame)
{
	const struct hawser_tow_motion *motion = frame->motion;
	double most = 0.0, top = 0.0;

	for (int i = 0; i < motion->samples; i++) {
		const struct hawser_tow_sample *at = &motion->sample[i];

		hawser__box_add(&frame->box, at->top, 3);
		hawser__box_add(&frame->box, at->body, 3);
		top = fmax(top, at->tension_top);
	}
	for (int k = 0; k <= 2; k += 2) { /* a way that is too narrow is drawn in a range so wide */
		double *low = frame->box.low, *high = frame->box.high;
		double narrow = FLAT*(high[2 - k] - low[2 - k]) - (high[k] - low[k]);

		low[k] -= 0.5*fmax(narrow, 0.0);
		high[k] += 0.5*fmax(narrow, 0.0);
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

/* The next panel downwards. */
static void panel(struct hawser__figure *figure, struct frame *frame, double tall,
                  struct hawser__panel_frame *at)
{
	at->left = LEFT;
	at->right = RIGHT;
	at->bottom = (frame->below - tall)/frame->height;
	at->top = frame->below/frame->height;
	hawser__figure_panel(figure, at);
	frame->below -= tall + TITLE;
}

static void draw_above(struct hawser__figure *figure, struct frame *frame)
{
	const struct hawser_tow_sample *sample = frame->motion->sample;
	struct hawser__panel_frame at = {.x = {&frame->x, .tics = 10}, .y = {&frame->z, .tics = 6}};
	int count = frame->motion->samples;

	hawser__panel_even(&at, &frame->box, 2, (RIGHT - LEFT)*WIDTH, ABOVE);
	panel(figure, frame, ABOVE, &at);
	fputs("set label 'seen from above' at graph 0.985,0.07 right font ',9'\n", figure->out.script);
	hawser__figure_bind(figure, count, &sample->top[0], sizeof *sample, &sample->top[2],
	                    sizeof *sample);
	hawser__figure_draw(figure, "towing point", "with lines lt 7 lw 1.2 dt (6,5)");
	hawser__figure_bind(figure, count, &sample->body[0], sizeof *sample, &sample->body[2],
	                    sizeof *sample);
	hawser__figure_draw(figure, "body", "with lines lt 1 lw 1.8");
}

static void draw_over_time(struct hawser__figure *figure, struct frame *frame,
                           const struct hawser__axis *axis, const double *value)
{
	const struct hawser_tow_sample *sample = frame->motion->sample;
	int count = frame->motion->samples;

	panel(figure, frame, PANEL, &(struct hawser__panel_frame){
		.x = {&frame->t, sample[0].t, sample[count - 1].t, .tics = 10}, .y = {.axis = axis}});
	hawser__figure_bind(figure, count, &sample->t, sizeof *sample, value, sizeof *sample);
	hawser__figure_draw(figure, NULL, "with lines lt 1 lw 1.4");
}

static void draw_along(struct hawser__figure *figure, struct frame *frame)
{
	const struct hawser_tow_range *range = frame->motion->range;
	const struct {
		const char *title, *style;
		const double *value;
	} curve[] = {{"least", "lt 3 lw 1.2", &range->least}, {"most", "lt 2 lw 1.2", &range->most},
	             {"mean", "lt 7 lw 1.8", &range->mean}};

	panel(figure, frame, PANEL, &(struct hawser__panel_frame){.x = {&frame->s, .zero = 1},
		.y = {.axis = &frame->range}});
	for (int e = 0; e < frame->motion->elements; e++)
		hawser__figure_row(figure, "xyy", (double[]){range[e].s, range[e].least, range[e].most});
	hawser__figure_draw(figure, NULL, "using 1:2:3 with filledcurves lc rgb '#d8e4f0'");
	for (int k = 0; k < 3; k++) {
		hawser__figure_bind(figure, frame->motion->elements, &range->s, sizeof *range, curve[k].value,
		                    sizeof *range);
		hawser__figure_draw(figure, curve[k].title, "with lines %s", curve[k].style);
	}
}

enum hawser_status hawser__plot_tow_motion(const char *path, const struct hawser_tow_motion *motion,
                                           struct hawser_report *report)
{
	struct frame frame = {.motion = motion};
	struct hawser__figure figure = {0};
	enum hawser_status status;

	measure(&frame);
	status = hawser__figure_begin(&figure, path, WIDTH, frame.height, report);
	if (status)
		return status;
	draw_above(&figure, &frame);
	draw_over_time(&figure, &frame, &frame.tilt, &motion->sample->tilt);
	draw_over_time(&figure, &frame, &frame.T, &motion->sample->tension_top);
	draw_along(&figure, &frame);
	return hawser__figure_finish(&figure, report);
}
