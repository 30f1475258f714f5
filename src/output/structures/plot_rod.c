/* output/structures/plot_rod.c - see plot_rod.h. A rod in a plane z = constant is seen from the front.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/drawing/axis.h"
#include "output/drawing/perspective.h"
#include "output/structures/plot_rod.h"
#include "output/drawing/style.h"

#define WIDTH 16.0  /* cm */
#define HEIGHT 17.0 /* cm */
#define SMALL 1e-9  /* of the largest one: forces and moments that are smaller are not drawn */

struct frame {
	const struct hawser_rod_statics *st;
	struct hawser__eye eye;
	struct hawser__box seen;
	struct hawser__axis s, N, M;
	int drawn[6]; /* forces along, moments about e1, e2, e3 */
};

static const char *const name[] = {"{/:Italic T}", "{/:Italic Q}_2", "{/:Italic Q}_3",
                                   "{/:Italic M}_1", "{/:Italic M}_2", "{/:Italic M}_3"};

static void measure(struct frame *frame)
{
	const struct hawser_rod_statics *st = frame->st;
	struct hawser__box box = {.any = 0};
	double most[6] = {0.0}, N = 0.0, M = 0.0;

	for (int i = 0; i < st->points; i++) {
		hawser__box_add(&box, st->point[i].x, 3);
		hawser__box_add(&box, st->rest[i], 3);
		for (int k = 0; k < 3; k++) {
			most[k] = fmax(most[k], fabs(st->point[i].N[k]));
			most[3 + k] = fmax(most[3 + k], fabs(st->point[i].M[k]));
		}
	}
	hawser__eye_look(&frame->eye, &box, HAWSER__IN_SPACE, NULL);
	for (int k = 0; k < 3; k++) {
		N = fmax(N, most[k]);
		M = fmax(M, most[3 + k]);
	}
	for (int k = 0; k < 6; k++)
		frame->drawn[k] = most[k] > SMALL*(k < 3 ? fmax(N, M/st->point[st->points - 1].s)
		                                         : fmax(M, N*st->point[st->points - 1].s*1e-6));
	frame->s = hawser__axis_of("Unstretched length {/:Italic s}", "m", 0.0);
	frame->N = hawser__axis_of("Force", "N", N);
	frame->M = hawser__axis_of("Moment", "N.m", M);
}

static void shape_data(FILE *script, struct frame *frame)
{
	const struct hawser_rod_statics *st = frame->st;
	double to[2];

	for (int rest = 0; rest < 2; rest++) {
		fprintf(script, "$%s << END\n", rest ? "rest" : "rod");
		for (int i = 0; i < st->points; i++) {
			hawser__eye_see(to, &frame->eye, rest ? st->rest[i] : st->point[i].x);
			hawser__box_add(&frame->seen, to, 2);
			fprintf(script, "%.7g %.7g\n", to[0], to[1]);
		}
		fputs("END\n", script);
	}
}

static void held_data(FILE *script, const struct frame *frame, const struct hawser_rod *rod)
{
	for (int hold = HAWSER_ROD_CLAMPED; hold <= HAWSER_ROD_HINGED; hold++) {
		fprintf(script, "$held%d << END\nNaN NaN\n", hold);
		for (int end = 0; end < 2; end++) {
			double to[2];

			hawser__eye_see(to, &frame->eye, frame->st->point[end ? frame->st->points - 1 : 0].x);
			if ((int)rod->hold[end] == hold)
				fprintf(script, "%.7g %.7g\n", to[0], to[1]);
		}
		fputs("END\n", script);
	}
}

static void force_data(FILE *script, const struct frame *frame)
{
	const struct hawser_rod_statics *st = frame->st;

	fputs("$forces << END\n", script);
	for (int i = 0; i < st->points; i++) {
		const struct hawser_rod_point *p = &st->point[i];

		fprintf(script, "%.9g", p->s/frame->s.per);
		for (int k = 0; k < 6; k++)
			fprintf(script, " %.9g", k < 3 ? p->N[k]/frame->N.per : p->M[k - 3]/frame->M.per);
		fputs("\n", script);
	}
	fputs("END\n", script);
}

/* The forces (first 0) or the moments (3) that are not 0. */
static void curves(FILE *script, const struct frame *frame, int first)
{
	fputs("plot 0 with lines lc rgb '#909090' lw 0.6", script);
	for (int k = first; k < first + 3; k++)
		if (frame->drawn[k])
			fprintf(script, ", $forces using 1:%d with lines lt %d", k + 2, k - first + 1);
	fputs("\n", script);
}

static void draw_shape(FILE *script, struct frame *frame)
{
	fputs("unset border\nunset xtics\nunset ytics\nunset grid\n", script);
	hawser__eye_fit(script, &frame->seen, 0.90*WIDTH, 0.46*HEIGHT);
	hawser__eye_axes(script, &frame->eye, &(struct hawser__corner){1.0, 0.55*HEIGHT, WIDTH, HEIGHT});
	fputs("plot $rest using 1:2 with lines lt 7 lw 1 dt (8,6), $rod using 1:2 with lines lt 1 lw 2.5, "
	      "$held0 using 1:2 with points pt 5 ps 1 lc rgb 'black', "
	      "$held1 using 1:2 with points pt 6 ps 1.2 lc rgb 'black'\n"
	      "unset arrow\nunset label\nset border\nset xtics\nset ytics\nset grid\n"
	      "set yrange [*:*]\n", script);
}

static struct hawser__legend legend(const struct frame *frame, const struct hawser_rod *rod)
{
	struct hawser__legend entries = {0};

	hawser__legend_add(&entries, "under load", "with lines lt 1 lw 2.5");
	hawser__legend_add(&entries, "at rest", "with lines lt 7 lw 1 dt (8,6)");
	if (rod->hold[0] == HAWSER_ROD_CLAMPED || rod->hold[1] == HAWSER_ROD_CLAMPED)
		hawser__legend_add(&entries, "clamped", "with points pt 5 ps 1 lc rgb 'black'");
	if (rod->hold[0] == HAWSER_ROD_HINGED || rod->hold[1] == HAWSER_ROD_HINGED)
		hawser__legend_add(&entries, "hinged", "with points pt 6 ps 1.2 lc rgb 'black'");
	for (int k = 0; k < 3; k++) {
		char text[64];
		int both = frame->drawn[k] && frame->drawn[3 + k];

		if (!frame->drawn[k] && !frame->drawn[3 + k])
			continue;
		snprintf(text, sizeof text, "%s%s%s", frame->drawn[k] ? name[k] : "", both ? ", " : "",
		         frame->drawn[3 + k] ? name[3 + k] : "");
		hawser__legend_add(&entries, text, "with lines lt %d", k + 1);
	}
	return entries;
}

enum hawser_status hawser__plot_rod(const char *path, const struct hawser_rod *rod,
                                    const struct hawser_rod_statics *st, struct hawser_report *report)
{
	struct frame frame = {.st = st};
	struct hawser__legend entries;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, WIDTH, HEIGHT, report);
	FILE *script = picture.script;

	if (status)
		return status;
	measure(&frame);
	shape_data(script, &frame);
	held_data(script, &frame, rod);
	force_data(script, &frame);
	entries = legend(&frame, rod);
	hawser__picture_panel(&picture, 0.05, 0.95, 0.53, 0.99);
	draw_shape(script, &frame);
	fprintf(script, "set xrange [0:%.9g]\nset format x ''\n", st->point[st->points - 1].s/frame.s.per);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.35, 0.50);
	hawser__picture_ylabel(&picture, "%s", frame.N.title);
	curves(script, &frame, 0);
	fprintf(script, "set format x '%%g'\nset xlabel '%s'\n", frame.s.title);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.18, 0.33);
	hawser__picture_ylabel(&picture, "%s", frame.M.title);
	curves(script, &frame, 3);
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
