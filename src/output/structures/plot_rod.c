/* output/structures/plot_rod.c - see structures.h. A rod in a plane z = constant is seen from the
 * front.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

#define WIDTH 16.0  /* cm */
#define HEIGHT 17.0 /* cm */
#define SMALL 1e-9  /* of the largest one: forces and moments that are smaller are not drawn */

struct frame {
	const struct hawser_rod_statics *st;
	struct hawser__eye eye;
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

static void draw_shape(struct hawser__figure *figure, const struct frame *frame,
                       const struct hawser_rod *rod)
{
	const struct hawser_rod_statics *st = frame->st;

	for (int i = 0; i < st->points; i++)
		hawser__figure_see(figure, &frame->eye, st->point[i].x);
	hawser__figure_draw(figure, "under load", "with lines lt 1 lw 2.5");
	for (int i = 0; i < st->points; i++)
		hawser__figure_see(figure, &frame->eye, st->rest[i]);
	hawser__figure_draw(figure, "at rest", "with lines lt 7 lw 1 dt (8,6)");
	for (int hinged = 0; hinged < 2; hinged++) {
		for (int end = 0; end < 2; end++)
			if (rod->hold[end] == (hinged ? HAWSER_ROD_HINGED : HAWSER_ROD_CLAMPED))
				hawser__figure_see(figure, &frame->eye, st->point[end ? st->points - 1 : 0].x);
		hawser__figure_draw(figure, hinged ? "hinged" : "clamped", hinged
		                    ? "with points pt 6 ps 1.2 lc rgb 'black'"
		                    : "with points pt 5 ps 1 lc rgb 'black'");
	}
}

/* The forces (first 0) or the moments (3) that are not 0. */
static void draw_forces(struct hawser__figure *figure, const struct frame *frame, int first)
{
	const struct hawser_rod_statics *st = frame->st;

	hawser__figure_function(figure, NULL, "0 with lines lc rgb '#909090' lw 0.6");
	for (int k = first; k < first + 3; k++) {
		for (int i = 0; i < st->points && frame->drawn[k]; i++)
			hawser__figure_put(figure, st->point[i].s, first ? st->point[i].M[k - 3]
			                   : st->point[i].N[k]);
		hawser__figure_draw(figure, NULL, "with lines lt %d", k - first + 1);
	}
}

/* A colour is of a force and of a moment. */
static void add_forces(struct hawser__legend *legend, const struct frame *frame)
{
	for (int k = 0; k < 3; k++) {
		char text[64];
		int both = frame->drawn[k] && frame->drawn[3 + k];

		snprintf(text, sizeof text, "%s%s%s", frame->drawn[k] ? name[k] : "", both ? ", " : "",
		         frame->drawn[3 + k] ? name[3 + k] : "");
		if (*text)
			hawser__legend_add(legend, text, "with lines lt %d", k + 1);
	}
}

enum hawser_status hawser__plot_rod(const char *path, const struct hawser_rod *rod,
                                    const struct hawser_rod_statics *st, struct hawser_report *report)
{
	struct frame frame = {.st = st};
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, WIDTH, HEIGHT, report);

	if (status)
		return status;
	measure(&frame);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.05, 0.95, 0.53, 0.99, .view = 1});
	hawser__eye_axes(figure.out.script, &frame.eye,
	                 &(struct hawser__corner){1.0, 0.55*HEIGHT, WIDTH, HEIGHT});
	draw_shape(&figure, &frame, rod);
	for (int moments = 0; moments < 2; moments++) {
		hawser__figure_panel(&figure, &(struct hawser__panel_frame){
			0.13, 0.97, moments ? 0.18 : 0.35, moments ? 0.33 : 0.50,
			.x = {&frame.s, 0.0, st->point[st->points - 1].s, .bare = !moments},
			.y = {.axis = moments ? &frame.M : &frame.N, .tics = 6, .room = 0.04}});
		draw_forces(&figure, &frame, 3*moments);
	}
	add_forces(&figure.legend, &frame);
	return hawser__figure_finish(&figure, report);
}
