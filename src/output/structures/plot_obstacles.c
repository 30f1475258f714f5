/* output/structures/plot_obstacles.c - see structures.h. Heights are magnified against
 * distances, so that circles are ellipses on the page.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

#define WIDTH 16.0   /* cm */
#define HEIGHT 13.2  /* cm */
enum { PER_PIECE = 60, AROUND = 72 }; /* points of a piece of rope and of a circle */

static const char *const limit_colour[] = {"#009E73", "#D55E00"};

struct frame {
	const struct hawser_obstacles *scene;
	const struct hawser_obstacles_statics *st;
	struct hawser__axis x, y, T;
	double from, to;  /* m, heights shown */
	int clear, slide[2]; /* what is there to be drawn */
};

static void widen(struct frame *frame, double *most, const struct hawser_line_statics *st)
{
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];

		for (int k = 0; k <= PER_PIECE; k++) {
			double x[2];

			hawser_line_at(st, x, NULL, NULL, NULL, NULL,
			               piece->S0 + (piece->S1 - piece->S0)*k/PER_PIECE);
			frame->from = fmin(frame->from, x[1]);
			frame->to = fmax(frame->to, x[1]);
		}
		*most = fmax(*most, fmax(piece->T0, piece->T1));
	}
}

/* The rope and the part of the circles that is near it. */
static void measure(struct frame *frame)
{
	const struct hawser_line *line = &frame->scene->line;
	double most = 0.0, tall;

	frame->from = INFINITY;
	frame->to = -INFINITY;
	widen(frame, &most, &frame->st->st);
	if (frame->clear)
		widen(frame, &most, &frame->st->clear.st);
	for (int k = 0; k < 2; k++)
		if (frame->slide[k])
			widen(frame, &most, &frame->st->slide[k].st);
	tall = fmax(frame->to - frame->from, 0.02*(line->B[0] - line->A[0]));
	for (int i = 0; i < line->sheaves; i++) {
		const struct hawser_line_sheave *s = &line->sheave[i];
		double low = s->centre[1] - s->radius, high = s->centre[1] + s->radius;

		frame->from = fmin(frame->from, fmax(low, s->centre[1] + s->side*s->radius - tall));
		frame->to = fmax(frame->to, fmin(high, s->centre[1] + s->side*s->radius + tall));
	}
	tall = fmax(frame->to - frame->from, tall);
	frame->from -= 0.08*tall;
	frame->to += 0.08*tall;
	frame->x = hawser__axis_of("Distance {/:Italic x}", "m", 0.0);
	frame->y = hawser__axis_of("Height {/:Italic y}", "m", 0.0);
	frame->T = hawser__axis_of("Tension {/:Italic T}", "N", most);
}

void hawser__plot_rope(struct hawser__figure *figure, const struct hawser_line_statics *st, int tension,
                       int points)
{
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];

		for (int k = 0; k < points; k++) {
			double x[2], T;

			hawser_line_at(st, x, NULL, &T, NULL, NULL,
			               piece->S0 + (piece->S1 - piece->S0)*k/points);
			hawser__figure_put(figure, x[0], tension ? T : x[1]);
		}
		hawser__figure_put(figure, piece->x1[0], tension ? piece->T1 : piece->x1[1]);
	}
}

static void draw_circles(struct hawser__figure *figure, const struct hawser_line *line)
{
	for (int i = 0; i < line->sheaves; i++) {
		const struct hawser_line_sheave *s = &line->sheave[i];

		for (int k = 0; k <= AROUND; k++) {
			double turn = 2.0*acos(-1.0)*k/AROUND;

			hawser__figure_put(figure, s->centre[0] + s->radius*sin(turn),
			                   s->centre[1] + s->radius*cos(turn));
		}
		hawser__figure_gap(figure);
	}
	hawser__figure_draw(figure, NULL, "with filledcurves closed fs solid 1 noborder lc rgb '#dcdcdc'");
	hawser__figure_again(figure, NULL, "with lines lc rgb '#b5b5b5' lw 1");
	for (int i = 0; i < line->sheaves; i++)
		if (line->sheave[i].radius == 0.0)
			hawser__figure_put(figure, line->sheave[i].centre[0], line->sheave[i].centre[1]);
	hawser__figure_draw(figure, NULL, "with points pt 7 ps 0.6 lc rgb '#b5b5b5'");
}

/* The ropes that are there, as heights or tensions; those that slide with their tensions alone. */
static void draw_ropes(struct hawser__figure *figure, const struct frame *frame, int tension)
{
	static const char *const title[] = {"about to slide toward A", "about to slide toward B"};

	if (frame->clear)
		hawser__plot_rope(figure, &frame->st->clear.st, tension, PER_PIECE);
	hawser__figure_draw(figure, "without obstacles", "with lines lt 7 lw 1 dt (8,6)");
	for (int k = 0; k < 2; k++) {
		if (frame->slide[k] && tension)
			hawser__plot_rope(figure, &frame->st->slide[k].st, 1, PER_PIECE);
		hawser__figure_draw(figure, title[k], "with lines lc rgb '%s' lw 1", limit_colour[k]);
	}
	hawser__plot_rope(figure, &frame->st->st, tension, PER_PIECE);
	hawser__figure_draw(figure, "rope", "with lines lt 1");
}

enum hawser_status hawser__plot_obstacles(const char *path, const struct hawser_obstacles *scene,
                                          const struct hawser_obstacles_statics *st,
                                          struct hawser_report *report)
{
	const struct hawser_line *line = &scene->line;
	struct frame frame = {.scene = scene, .st = st, .clear = st->clear.status == HAWSER_OK};
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, WIDTH, HEIGHT, report);

	if (status)
		return status;
	for (int k = 0; k < 2; k++)
		frame.slide[k] = st->friction && st->slide[k].status == HAWSER_OK;
	measure(&frame);
	hawser__legend_once(&figure.legend, "rope", "with lines lt 1");
	hawser__legend_once(&figure.legend, "obstacles", "with lines lc rgb '#c8c8c8' lw 6");
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, 0.55, 0.97,
		.x = {&frame.x, line->A[0], line->B[0], .bare = 1}, .y = {.axis = &frame.y,
		.from = frame.from, .to = frame.to}});
	draw_circles(&figure, line);
	draw_ropes(&figure, &frame, 0);
	hawser__figure_put(&figure, line->A[0], line->A[1]);
	hawser__figure_put(&figure, line->B[0], line->B[1]);
	hawser__figure_draw(&figure, NULL, "with points pt 5 ps 0.7 lc rgb 'black'");
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, 0.22, 0.50,
		.x = {.axis = &frame.x, .from = line->A[0], .to = line->B[0]}, .y = {.axis = &frame.T}});
	draw_ropes(&figure, &frame, 1);
	return hawser__figure_finish(&figure, report);
}
