/* output/drawing/outline.c - see labels.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/drawing/labels.h"

enum { ROUND = 96, LINES = 6 }; /* sides of a circle; lines of a bed along x, and along z */
#define LEAST 0.3 /* of the larger side of the box: a plane is drawn no smaller */

void hawser__pen_put(const struct hawser__pen *pen, const double x[3])
{
	double to[2];

	hawser__eye_see(to, pen->eye, x);
	to[0] += pen->shift[0];
	to[1] += pen->shift[1];
	if (pen->figure)
		hawser__figure_put(pen->figure, to[0], to[1]);
	else if (pen->script)
		fprintf(pen->script, "%.7g %.7g\n", to[0], to[1]);
	else
		hawser__box_add(pen->seen, to, 2);
}

static void corner(const struct hawser__pen *pen, double x, double y, double z)
{
	hawser__pen_put(pen, (double[3]){x, y, z});
}

static void up(const struct hawser__pen *pen)
{
	if (pen->figure)
		hawser__figure_gap(pen->figure);
	else if (pen->script)
		fputs("\n", pen->script);
}

/* A plane: its part above the box's base or, of a steep one, beside the box's height. */
static void plane_data(const struct hawser__pen *pen, const struct hawser_surface *of,
                       const struct hawser__box *box)
{
	const double *n = of->normal;
	double low[3], high[3], size = fmax(box->high[0] - box->low[0], box->high[1] - box->low[1]);
	int upright = fabs(n[1]) < 0.3, flat = box->low[2] == box->high[2];

	for (int k = 0; k < 3; k++) {
		double narrow = k < 2 ? 0.5*fmax(LEAST*size - (box->high[k] - box->low[k]), 0.0) : 0.0;

		low[k] = box->low[k] - narrow;
		high[k] = box->high[k] + narrow;
	}

	for (int i = 0; i < (flat ? 2 : 5); i++) {
		double one = i == 1 || i == 2 ? 1.0 : 0.0, z = i == 2 || i == 3 ? high[2] : low[2];
		double x = low[0] + one*(high[0] - low[0]), y = low[1] + one*(high[1] - low[1]);
		double rest = n[0]*of->at[0] + n[1]*of->at[1] + n[2]*of->at[2] - n[2]*z;

		if (upright && fabs(n[0]) < 0.3)
			return;
		if (upright)
			corner(pen, (rest - n[1]*y)/n[0], y, z);
		else
			corner(pen, x, (rest - n[0]*x)/n[1], z);
	}
	up(pen);
}

/* A bed: lines along x and, of a net that is not in a plane, along z. */
static void bed_data(const struct hawser__pen *pen, const struct hawser_heights *of,
                     const struct hawser__box *box)
{
	int flat = box->low[2] == box->high[2];

	for (int i = 0; i < (flat ? 1 : 2*LINES); i++) {
		double part = (double)(i % LINES)/(LINES - 1);

		for (int j = 0; j <= ROUND; j++) {
			double along = (double)j/ROUND, x = i < LINES ? along : part, z = i < LINES ? part : along;

			x = box->low[0] + x*(box->high[0] - box->low[0]);
			z = box->low[2] + z*(box->high[2] - box->low[2]);
			corner(pen, x, hawser_heights_at(of, x, z), z);
		}
		up(pen);
	}
}

void hawser__pen_surface(const struct hawser__pen *pen, const struct hawser_surface *of,
                         const struct hawser__box *box)
{
	if (of->kind == HAWSER_SURFACE_PLANE) {
		plane_data(pen, of, box);
		return;
	}
	if (of->heights) {
		bed_data(pen, of->heights, box);
		return;
	}
	for (int side = 0; side < (box->low[2] == box->high[2] ? 1 : 2); side++) {
		double z = side ? box->high[2] : box->low[2];
		int circle = of->kind == HAWSER_SURFACE_CIRCLE;

		for (int i = 0; i <= (circle ? ROUND : 1); i++) {
			double angle = 2.0*acos(-1.0)*i/ROUND;

			if (circle)
				corner(pen, of->at[0] + of->radius*cos(angle),
				       of->at[1] + of->radius*sin(angle), z);
			else
				corner(pen, i ? of->to[0] : of->at[0], i ? of->to[1] : of->at[1], z);
		}
		up(pen);
	}
}
