/* output/cable/plot_statics.c - the span: profile and chord above, tension along the cable
 * below; between them the view from above, if the cable hangs in another plane than the vertical
 * one. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/drawing/figure.h"

enum { X, Y, TENSION, Z };

/* A member of a spot, by axis. */
static double of_spot(const struct hawser__spot *at, int axis)
{
	return axis == Y ? at->y : axis == Z ? at->z : at->T;
}

/* The profile with both sides of each mass, at which the tension jumps. */
static void put_profile(struct hawser__figure *figure, const struct hawser__span_picture *of, int axis)
{
	for (int i = 0, next = 0; i < of->points; i++) {
		for (; next < 2*of->kinks && of->kink[next].S <= of->profile[i].S; next++)
			hawser__figure_put(figure, of->kink[next].x, of_spot(&of->kink[next], axis));
		hawser__figure_put(figure, of->profile[i].x, of_spot(&of->profile[i], axis));
	}
}

/* Chord, cable and attachments. */
static void draw_view(struct hawser__figure *figure, const struct hawser__span_picture *of, int axis)
{
	const struct hawser__spot *first = &of->profile[0], *last = &of->profile[of->points - 1];

	hawser__figure_put(figure, first->x, of_spot(first, axis));
	hawser__figure_put(figure, last->x, of_spot(last, axis));
	hawser__figure_draw(figure, "chord", "with lines lt 7 lw 0.8 dt (8,6)");
	put_profile(figure, of, axis);
	hawser__figure_draw(figure, "cable", "with lines lt 1");
	for (int i = 0; i < of->kinks; i++)
		hawser__figure_put(figure, of->kink[2*i].x, of_spot(&of->kink[2*i], axis));
	hawser__figure_draw(figure, "attachments", "with points pt 7 ps 0.7 lc rgb 'black'");
}

enum hawser_status hawser__plot_statics(const char *path, const struct hawser__span_picture *of,
                                        const struct hawser__axis *axis,
                                        struct hawser_report *report)
{
	static const int shown[2][3] = {{Y, TENSION}, {Y, Z, TENSION}};
	int count = of->turned ? 3 : 2;
	const double high = 0.97, foot = count == 2 ? 0.21 : 0.16, gap = count == 2 ? 0.06 : 0.04;
	double step = (high - foot + gap)/count, from = 0.0, to = of->scene->span.d;
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 16.0, of->turned ? 16.4 : 12.4,
	                                                 report);

	if (status)
		return status;
	/* a cable that hangs in another plane may be beside its ends in x too */
	for (int i = 0; i < of->points; i++) {
		from = fmin(from, of->profile[i].x);
		to = fmax(to, of->profile[i].x);
	}
	for (int k = 0; k < count; k++) {
		int y = shown[of->turned][k];

		hawser__figure_panel(&figure, &(struct hawser__panel_frame){
			0.13, 0.97, high - (k + 1)*step + gap, high - k*step,
			.x = {&axis[X], from, to, .bare = k + 1 < count}, .y = {.axis = &axis[y]}});
		if (y != TENSION) {
			draw_view(&figure, of, y);
			continue;
		}
		put_profile(&figure, of, y);
		hawser__figure_draw(&figure, NULL, "with lines lt 2");
	}
	return hawser__figure_finish(&figure, report);
}
