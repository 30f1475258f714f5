/* output/structures/plot_obstacles.c - see plot_obstacles.h. Heights are magnified against
 * distances, so that circles are ellipses on the page.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/structures/plot_obstacles.h"
#include "output/drawing/style.h"

#define WIDTH 16.0   /* cm */
#define HEIGHT 13.2  /* cm */
#define CIRCLE "lc rgb '#b5b5b5'"
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

static void rope_data(FILE *script, const struct frame *frame, const char *name,
                      const struct hawser_line_statics *st)
{
	fprintf(script, "$%s << END\n", name);
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];

		for (int k = 0; k < PER_PIECE; k++) {
			double x[2], T;

			hawser_line_at(st, x, NULL, &T, NULL, NULL,
			               piece->S0 + (piece->S1 - piece->S0)*k/PER_PIECE);
			fprintf(script, "%.9g %.9g %.9g\n", x[0]/frame->x.per, x[1]/frame->y.per, T/frame->T.per);
		}
		fprintf(script, "%.9g %.9g %.9g\n", piece->x1[0]/frame->x.per, piece->x1[1]/frame->y.per,
		        piece->T1/frame->T.per);
	}
	fputs("END\n", script);
}

static void circle_data(FILE *script, const struct frame *frame)
{
	const struct hawser_line *line = &frame->scene->line;

	fputs("$circles << END\n", script);
	for (int i = 0; i < line->sheaves; i++) {
		const struct hawser_line_sheave *s = &line->sheave[i];

		for (int k = 0; k <= AROUND; k++) {
			double turn = 2.0*acos(-1.0)*k/AROUND;

			fprintf(script, "%.9g %.9g\n", (s->centre[0] + s->radius*sin(turn))/frame->x.per,
			        (s->centre[1] + s->radius*cos(turn))/frame->y.per);
		}
		fputs("\n", script);
	}
	fputs("END\n$points << END\nNaN NaN\n", script);
	for (int i = 0; i < line->sheaves; i++)
		if (line->sheave[i].radius == 0.0)
			fprintf(script, "%.9g %.9g\n", line->sheave[i].centre[0]/frame->x.per,
			        line->sheave[i].centre[1]/frame->y.per);
	fprintf(script, "END\n$ends << END\n%.9g %.9g\n%.9g %.9g\nEND\n", line->A[0]/frame->x.per,
	        line->A[1]/frame->y.per, line->B[0]/frame->x.per, line->B[1]/frame->y.per);
}

static void draw_shape(FILE *script, const struct frame *frame)
{
	fprintf(script, "set yrange [%.9g:%.9g]\nplot $circles using 1:2 with filledcurves closed "
	        "fs solid 1 noborder lc rgb '#dcdcdc', $circles using 1:2 with lines " CIRCLE " lw 1, "
	        "$points using 1:2 with points pt 7 ps 0.6 " CIRCLE, frame->from/frame->y.per,
	        frame->to/frame->y.per);
	if (frame->clear)
		fputs(", $clear using 1:2 with lines lt 7 lw 1 dt (8,6)", script);
	fputs(", $rope using 1:2 with lines lt 1, $ends using 1:2 with points pt 5 ps 0.7 lc rgb 'black'\n"
	      "set yrange [*:*]\n", script);
}

static void draw_tension(FILE *script, const struct frame *frame)
{
	fputs("plot ", script);
	if (frame->clear)
		fputs("$clear using 1:3 with lines lt 7 lw 1 dt (8,6), ", script);
	for (int k = 0; k < 2; k++)
		if (frame->slide[k])
			fprintf(script, "$slide%d using 1:3 with lines lc rgb '%s' lw 1, ", k, limit_colour[k]);
	fputs("$rope using 1:3 with lines lt 1\n", script);
}

static struct hawser__legend legend(const struct frame *frame)
{
	static const char *const title[] = {"about to slide toward A", "about to slide toward B"};
	struct hawser__legend entries = {0};

	hawser__legend_add(&entries, "rope", "with lines lt 1");
	hawser__legend_add(&entries, "obstacles", "with lines lc rgb '#c8c8c8' lw 6");
	if (frame->clear)
		hawser__legend_add(&entries, "without obstacles", "with lines lt 7 lw 1 dt (8,6)");
	for (int k = 0; k < 2; k++)
		if (frame->slide[k])
			hawser__legend_add(&entries, title[k], "with lines lc rgb '%s' lw 1", limit_colour[k]);
	return entries;
}

enum hawser_status hawser__plot_obstacles(const char *path, const struct hawser_obstacles *scene,
                                          const struct hawser_obstacles_statics *st,
                                          struct hawser_report *report)
{
	struct frame frame = {.scene = scene, .st = st, .clear = st->clear.status == HAWSER_OK};
	struct hawser__legend entries;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, WIDTH, HEIGHT, report);
	FILE *script = picture.script;

	if (status)
		return status;
	for (int k = 0; k < 2; k++)
		frame.slide[k] = st->friction && st->slide[k].status == HAWSER_OK;
	measure(&frame);
	entries = legend(&frame);
	rope_data(script, &frame, "rope", &st->st);
	if (frame.clear)
		rope_data(script, &frame, "clear", &st->clear.st);
	for (int k = 0; k < 2; k++)
		if (frame.slide[k])
			rope_data(script, &frame, k ? "slide1" : "slide0", &st->slide[k].st);
	circle_data(script, &frame);
	fprintf(script, "set xrange [%.9g:%.9g]\nset format x ''\n", scene->line.A[0]/frame.x.per,
	        scene->line.B[0]/frame.x.per);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.55, 0.97);
	hawser__picture_ylabel(&picture, "%s", frame.y.title);
	draw_shape(script, &frame);
	fprintf(script, "set format x '%%g'\nset xlabel '%s'\n", frame.x.title);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.22, 0.50);
	hawser__picture_ylabel(&picture, "%s", frame.T.title);
	draw_tension(script, &frame);
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
