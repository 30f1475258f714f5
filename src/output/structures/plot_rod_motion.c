/* output/structures/plot_rod_motion.c - a rod in motion: its shape at some times; a place,
 * energies over time. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/drawing/axis.h"
#include "output/drawing/perspective.h"
#include "output/structures/plot_rod.h"
#include "output/drawing/style.h"

#define WIDTH 16.0  /* cm */
#define HEIGHT 19.0 /* cm */
enum { SHAPES = 13 }; /* more cannot be told apart */
#define STILL 1e-6  /* of the rod's way: a place that moves less along an axis is not drawn */

/* The row of shape `index` of those drawn. */
static int row_of(const struct hawser_rod_motion *motion, int index, int shapes)
{
	return shapes > 1 ? (int)floor((double)index*(motion->rows - 1)/(shapes - 1) + 0.5) : 0;
}

static void shapes_data(FILE *script, struct hawser__eye *eye, struct hawser__box *seen,
                        const struct hawser_rod_motion *motion, int shapes, double per)
{
	struct hawser__box box = {.any = 0};
	double to[2];

	for (int s = 0; s < shapes; s++)
		for (int i = 0; i < motion->nodes; i++)
			hawser__box_add(&box, motion->shape[(long)row_of(motion, s, shapes)*motion->nodes + i], 3);
	hawser__eye_look(eye, &box, HAWSER__IN_SPACE, NULL);
	fputs("$shapes << END\n", script);
	for (int s = 0; s < shapes; s++) {
		int row = row_of(motion, s, shapes);

		for (int i = 0; i < motion->nodes; i++) {
			hawser__eye_see(to, eye, motion->shape[(long)row*motion->nodes + i]);
			hawser__box_add(seen, to, 2);
			fprintf(script, "%.7g %.7g %.9g\n", to[0], to[1], motion->time[row]/per);
		}
		fputs("\n", script);
	}
	fputs("END\n$path << END\n", script);
	for (int row = 0; row < motion->rows; row++) {
		hawser__eye_see(to, eye, motion->shape[(long)(row + 1)*motion->nodes - 1]);
		hawser__box_add(seen, to, 2);
		fprintf(script, "%.7g %.7g\n", to[0], to[1]);
	}
	fputs("END\n", script);
}

static void draw_shapes(FILE *script, const struct hawser_rod_motion *motion,
                        const struct hawser__axis *time)
{
	double from = motion->time[0]/time->per, to = motion->time[motion->rows - 1]/time->per;
	struct hawser__eye eye;
	struct hawser__box seen = {.any = 0};

	shapes_data(script, &eye, &seen, motion, motion->rows < SHAPES ? motion->rows : SHAPES,
	            time->per);
	fputs("unset border\nunset xtics\nunset ytics\nunset grid\n", script);
	hawser__eye_fit(script, &seen, 0.72*WIDTH, 0.40*HEIGHT);
	hawser__eye_axes(script, &eye, &(struct hawser__corner){1.0, 0.57*HEIGHT, WIDTH, HEIGHT});
	fprintf(script, "set palette defined (0 '#c6d8ea', 1 '#0b3c6f')\nset cbrange [%.9g:%.9g]\n"
	        "set colorbox vertical user origin screen 0.82, screen 0.60 size screen 0.02, screen 0.33\n"
	        "set cblabel '%s' offset 2.5,0\n"
	        "plot $path using 1:2 with lines lc rgb '#b0b0b0' lw 0.6, "
	        "$shapes using 1:2:3 with lines palette lw 1.8\n"
	        "unset colorbox\nunset arrow\nunset label\nset border\nset xtics\nset ytics\nset grid\n"
	        "set yrange [*:*]\n", from, to > from ? to : from + 1.0, time->title);
}

/* The axes along which the probe moves, as a mask. */
static int moving(const struct hawser_rod_motion *motion, int probe)
{
	double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
	double most = 0.0;
	int mask = 0;

	for (int i = 0; i < motion->rows; i++)
		for (int k = 0; k < 3; k++) {
			low[k] = fmin(low[k], motion->x[i*motion->probes + probe][k]);
			high[k] = fmax(high[k], motion->x[i*motion->probes + probe][k]);
		}
	for (int k = 0; k < 3; k++)
		most = fmax(most, high[k] - low[k]);
	for (int k = 0; k < 3; k++)
		mask |= high[k] - low[k] > STILL*most ? 1 << k : 0;
	return mask ? mask : 1;
}

enum hawser_status hawser__plot_rod_motion(const char *path, const struct hawser_rod_motion *motion,
                                           const char *probe, struct hawser_report *report)
{
	const struct hawser__axis time = hawser__axis_of("Time {/:Italic t}", "s", 0.0);
	struct hawser__axis energy, place = hawser__axis_of("length", "m", 0.0);
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, WIDTH, HEIGHT, report);
	FILE *script = picture.script;
	double most = 0.0;
	int first = 1, mask, high = 0, longer = 0;

	if (status)
		return status;
	hawser__picture_panel(&picture, 0.05, 0.80, 0.55, 0.98);
	draw_shapes(script, motion, &time);
	for (int i = 0; i < motion->rows; i++)
		most = fmax(most, fmax(motion->kinetic[i], motion->strain[i]));
	for (int i = 0; i < motion->rows; i++) {
		high |= fabs(motion->height[i] - motion->height[0]) > STILL*most;
		longer |= motion->length[i] != motion->length[0];
	}
	energy = hawser__axis_of("Energy", "J", most);
	fputs("$motion << END\n", script);
	for (int i = 0; i < motion->rows; i++) {
		const double *x = motion->x[(long)i*motion->probes];

		fprintf(script, "%.9g %.7g %.7g %.7g %.7g %.7g %.7g %.7g\n", motion->time[i]/time.per,
		        x[0]/place.per, x[1]/place.per, x[2]/place.per,
		        motion->kinetic[i]/energy.per, motion->strain[i]/energy.per,
		        (motion->height[i] - motion->height[0])/energy.per, motion->length[i]/place.per);
	}
	fprintf(script, "END\nset key at graph 1, graph 1.11 right center horizontal\n"
	        "set xrange [%.9g:%.9g]\n", motion->time[0]/time.per,
	        motion->time[motion->rows - 1]/time.per);
	mask = moving(motion, 0);
	hawser__picture_panel(&picture, 0.13, 0.95, 0.33, 0.49);
	hawser__picture_ylabel(&picture, "Place at %s%s (%s)", probe, longer ? ", length" : "",
	                       place.unit);
	fputs("set format x ''\nplot ", script);
	for (int k = 0; k < 3; k++)
		if (mask & 1 << k) {
			fprintf(script, "%s$motion using 1:%d with lines lt %d title '{/:Italic %c}'",
			        first ? "" : ", ", k + 2, k + 1, "xyz"[k]);
			first = 0;
		}
	if (longer)
		fputs(", $motion using 1:8 with lines lt 4 dt (8,5) title 'length'", script);
	fputs("\n", script);
	hawser__picture_panel(&picture, 0.13, 0.95, 0.08, 0.27);
	hawser__picture_ylabel(&picture, "%s", energy.title);
	fprintf(script, "set format x '%%g'\nset xlabel '%s'\nplot $motion using 1:5 "
	        "with lines lt 1 title 'kinetic', $motion using 1:6 with lines lt 2 title 'of strain'%s\n",
	        time.title, high ? ", $motion using 1:7 with lines lt 3 title 'of height'" : "");
	return hawser__picture_finish(&picture, report);
}
