/* output/structures/plot_rod_motion.c - a rod in motion: its shape at some times; a place,
 * energies over time. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

#define WIDTH 16.0  /* cm */
#define HEIGHT 20.1 /* cm */
#define UP(y) (((y)*19.0 + 1.1)/HEIGHT) /* above the legend, as a part of the height */
enum { SHAPES = 13 }; /* more cannot be told apart */
#define STILL 1e-6  /* of the rod's way: a place that moves less along an axis is not drawn */

/* The row of shape `index` of those drawn. */
static int row_of(const struct hawser_rod_motion *motion, int index, int shapes)
{
	return shapes > 1 ? (int)floor((double)index*(motion->rows - 1)/(shapes - 1) + 0.5) : 0;
}

/* The way of the end, and the rod at some times, coloured by them. */
static void draw_shapes(struct hawser__figure *figure, const struct hawser_rod_motion *motion,
                        const struct hawser__axis *time)
{
	int shapes = motion->rows < SHAPES ? motion->rows : SHAPES;
	double from = motion->time[0]/time->per, to = motion->time[motion->rows - 1]/time->per;
	struct hawser__box box = {.any = 0};
	struct hawser__eye eye;

	for (int s = 0; s < shapes; s++)
		for (int i = 0; i < motion->nodes; i++)
			hawser__box_add(&box, motion->shape[(long)row_of(motion, s, shapes)*motion->nodes + i], 3);
	hawser__eye_look(&eye, &box, HAWSER__IN_SPACE, NULL);
	hawser__eye_axes(figure->out.script, &eye, &(struct hawser__corner){1.0, UP(0.57)*HEIGHT,
	                                                                    WIDTH, HEIGHT});
	fprintf(figure->out.script,
	        "set palette defined (0 '#c6d8ea', 1 '#0b3c6f')\nset cbrange [%.9g:%.9g]\n"
	        "set colorbox vertical user origin screen 0.82, screen up(%.4f) size screen 0.02, "
	        "screen 0.31\n"
	        "set cblabel '%s' offset 2.5,0\n", from, to > from ? to : from + 1.0, UP(0.60),
	        time->title);
	for (int row = 0; row < motion->rows; row++)
		hawser__figure_see(figure, &eye, motion->shape[(long)(row + 1)*motion->nodes - 1]);
	hawser__figure_draw(figure, NULL, "with lines lc rgb '#b0b0b0' lw 0.6");
	for (int s = 0; s < shapes; s++) {
		int row = row_of(motion, s, shapes);

		for (int i = 0; i < motion->nodes; i++) {
			double at[3] = {[2] = motion->time[row]/time->per};

			hawser__eye_see(at, &eye, motion->shape[(long)row*motion->nodes + i]);
			hawser__figure_row(figure, "xy.", at);
		}
		hawser__figure_gap(figure);
	}
	hawser__figure_draw(figure, NULL, "using 1:2:3 with lines palette lw 1.8");
}

/* The axes along which the probe moves, as a mask. */
static int moving(const struct hawser_rod_motion *motion, int probe)
{
	struct hawser__box box = {.any = 0};
	double most = 0.0;
	int mask = 0;

	for (int i = 0; i < motion->rows; i++)
		hawser__box_add(&box, motion->x[i*motion->probes + probe], 3);
	for (int k = 0; k < 3; k++)
		most = fmax(most, box.high[k] - box.low[k]);
	for (int k = 0; k < 3; k++)
		mask |= box.high[k] - box.low[k] > STILL*most ? 1 << k : 0;
	return mask ? mask : 1;
}

/* Coordinates of the probe, those along which it moves, and the length if it changes. */
static void draw_place(struct hawser__figure *figure, const struct hawser_rod_motion *motion,
                       int longer)
{
	static const char *const name[] = {"{/:Italic x}", "{/:Italic y}", "{/:Italic z}"};
	int mask = moving(motion, 0);
	const size_t step = (size_t)motion->probes*sizeof *motion->x;

	for (int k = 0; k < 3; k++) {
		if (mask & 1 << k)
			hawser__figure_bind(figure, motion->rows, motion->time, sizeof *motion->time,
			                    &motion->x[0][k],
			                    step);
		hawser__figure_draw(figure, name[k], "with lines lt %d", k + 1);
	}
	if (longer)
		hawser__figure_bind(figure, motion->rows, motion->time, sizeof *motion->time, motion->length,
		                    sizeof *motion->length);
	hawser__figure_draw(figure, "length", "with lines lt 4 dt (8,5)");
}

static void draw_energies(struct hawser__figure *figure, const struct hawser_rod_motion *motion,
                          double most)
{
	const double *value[] = {motion->kinetic, motion->strain, motion->height};
	static const char *const name[] = {"kinetic energy", "of strain", "of height"};
	int high = 0;

	for (int i = 0; i < motion->rows; i++)
		high |= fabs(motion->height[i] - motion->height[0]) > STILL*most;
	for (int k = 0; k < 2 + high; k++) {
		for (int i = 0; i < motion->rows; i++)
			hawser__figure_put(figure, motion->time[i], value[k][i] - (k == 2 ? motion->height[0]
			                                                           : 0.0));
		hawser__figure_draw(figure, name[k], "with lines lt %d", k + 5);
	}
}

enum hawser_status hawser__plot_rod_motion(const char *path, const struct hawser_rod_motion *motion,
                                           const char *probe, struct hawser_report *report)
{
	const struct hawser__axis time = hawser__axis_of("Time {/:Italic t}", "s", 0.0);
	struct hawser__axis energy, place = hawser__axis_of("length", "m", 0.0);
	struct hawser__panel_axis across = {&time, motion->time[0], motion->time[motion->rows - 1],
	                                    .bare = 1};
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, WIDTH, HEIGHT, report);
	double most = 0.0;
	int longer = 0;

	if (status)
		return status;
	for (int i = 0; i < motion->rows; i++) {
		most = fmax(most, fmax(motion->kinetic[i], motion->strain[i]));
		longer |= motion->length[i] != motion->length[0];
	}
	energy = hawser__axis_of("Energy", "J", most);
	snprintf(place.title, sizeof place.title, "Place at %.60s%s (%s)", probe, longer ? ", length" : "",
	         place.unit);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.05, 0.80, UP(0.55), UP(0.98),
	                                                            .view = 1});
	draw_shapes(&figure, motion, &time);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.95, UP(0.33), UP(0.49),
	                                                            .x = across,
		.y = {.axis = &place}});
	fputs("unset colorbox\n", figure.out.script);
	draw_place(&figure, motion, longer);
	across.bare = 0;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.95, UP(0.10), UP(0.29),
	                                                            .x = across,
		.y = {.axis = &energy}});
	draw_energies(&figure, motion, most);
	return hawser__figure_finish(&figure, report);
}
