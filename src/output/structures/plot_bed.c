/* output/structures/plot_bed.c - beds with heights in the views of a mooring: below the cables, and as
 * contours from above. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

enum { ACROSS = 120, LEVELS = 8 }; /* cells along a view; most contours */

void hawser__plot_bed_section(struct hawser__figure *figure, const struct hawser_surface *bed,
                              const struct hawser_net_statics *st, const double low[3],
                              const double high[3])
{
	for (int i = 0; i <= ACROSS && bed->kind == HAWSER_SURFACE_PROFILE; i++) {
		double x = low[0] + i*(high[0] - low[0])/ACROSS;

		hawser__figure_put(figure, x, hawser_heights_at(bed->heights, x, 0.0));
	}
	for (int i = 0; i < st->points && bed->kind == HAWSER_SURFACE_GRID; i++) {
		const struct hawser_net_point *point = &st->point[i];

		if (i > 0 && point->cable != point[-1].cable)
			hawser__figure_gap(figure);
		hawser__figure_put(figure, point->x[0],
		                   hawser_heights_at(bed->heights, point->x[0], point->x[2]));
	}
	hawser__figure_gap(figure);
}

/* The part of a contour in a triangle with these corners [3] (x, z, height above the level). */
static void part(struct hawser__figure *figure, const double (*corner)[3])
{
	int ends = 0;

	for (int i = 0; i < 3; i++) {
		const double *a = corner[i], *b = corner[(i + 1) % 3];
		double way = a[2]/(a[2] - b[2]);

		if ((a[2] < 0.0) == (b[2] < 0.0))
			continue;
		hawser__figure_put(figure, a[0] + way*(b[0] - a[0]), a[1] + way*(b[1] - a[1]));
		ends++;
	}
	if (ends)
		hawser__figure_gap(figure);
}

/* 1, 2 or 5 times a power of 10, so that there are LEVELS contours at most. */
static double interval(double range)
{
	static const double nice[] = {1.0, 2.0, 5.0, 10.0};
	double power = pow(10.0, floor(log10(range/LEVELS)));
	int i = 0;

	while (i < 3 && nice[i]*power*LEVELS < range)
		i++;
	return nice[i]*power;
}

void hawser__plot_bed_contours(struct hawser__figure *figure, const struct hawser_surface *bed,
                               const double low[3], const double high[3])
{
	double h[2] = {INFINITY, -INFINITY}, step, d[2];

	for (int k = 0; k < 2; k++)
		d[k] = (high[2*k] - low[2*k])/ACROSS;
	for (int j = 0; j <= ACROSS; j++)
		for (int i = 0; i <= ACROSS; i++) {
			double y = hawser_heights_at(bed->heights, low[0] + i*d[0], low[2] + j*d[1]);

			h[0] = fmin(h[0], y);
			h[1] = fmax(h[1], y);
		}
	step = interval(h[1] - h[0]);
	if (!(h[1] - h[0] > 0.0))
		return;
	for (double level = ceil(h[0]/step)*step; level <= h[1]; level += step)
		for (int i = 0; i < ACROSS*ACROSS; i++) {
			double at[4][3];
			int beside = i % ACROSS, behind = i/ACROSS;

			for (int k = 0; k < 4; k++) {
				at[k][0] = low[0] + (beside + (k == 1 || k == 2))*d[0];
				at[k][1] = low[2] + (behind + (k >= 2))*d[1];
				at[k][2] = hawser_heights_at(bed->heights, at[k][0], at[k][1]) - level;
			}
			part(figure, (const double (*)[3])at);
			for (int k = 0; k < 3; k++)
				at[1][k] = at[0][k];
			part(figure, (const double (*)[3])at + 1);
		}
	hawser__figure_draw(figure, NULL, "with lines lw 0.7 lc rgb '#c0a888'");
	hawser__figure_label(figure, low[0], low[2], "left offset 0.5, 0.7 font ',8' tc rgb '#806040'",
	                     "contours of %s: every %g m, from %.4g to %.4g m", bed->name, step,
	                     ceil(h[0]/step)*step, floor(h[1]/step)*step);
}
