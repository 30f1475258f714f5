/* ropeway/expand/expand_at.c - a displacement of the whole rope at a point of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "ropeway/expand/expand.h"

size_t hawser__lexpand_width(const struct hawser__lmode *rope)
{
	size_t width = 0;

	for (int i = 0; i < rope->systems; i++)
		width += (size_t)(rope->system[i].size + rope->system[i].strains);
	return width;
}

struct hawser__lexpand_part hawser__lexpand_part(const struct hawser__lmode *rope, double *row,
                                                 int system)
{
	struct hawser__lexpand_part part = {row, row};

	for (int i = 0; i < rope->systems; i++)
		part.strain += rope->system[i].size;
	for (int i = 0; i < system; i++) {
		part.x += rope->system[i].size;
		part.strain += rope->system[i].strains;
	}
	return part;
}

/* Strain c of a segment at s, as a slope. */
static double slope_at(const struct hawser__lmode_segment *s, const double *strain, int c, double at)
{
	double value, factor = s->sa;

	hawser__grid_at(&value, &s->grid, strain + c*s->grid.points, 1, 1, at);
	if (s->sb && (c > 0 || s->D == 1))
		hawser__grid_at(&factor, &s->grid, s->sb, 1, 1, at);
	return value*factor;
}

static void add_segment(double shape[3], double *slope, const struct hawser__lmode_segment *s,
                        const double *x, const double *strain, double at, double angle)
{
	double u[2] = {0.0}, reference = atan2(s->piece->reference[1], s->piece->reference[0]);

	for (int c = 0; c < s->D; c++)
		hawser__grid_at(&u[c], &s->grid, x + c*s->grid.points, 1, 1, at);
	if (s->D == 2) {
		double turn = angle - reference;

		shape[0] += cos(turn)*u[0] + sin(turn)*u[1];
		shape[1] += cos(turn)*u[1] - sin(turn)*u[0];
		if (slope) {
			slope[0] += slope_at(s, strain, 0, at);
			slope[1] += slope_at(s, strain, 1, at);
		}
		return;
	}
	shape[s->sb ? 2 : 0] += u[0];
	if (slope)
		slope[s->sb ? 2 : 0] += slope_at(s, strain, 0, at);
}

/* Add the part of one system. */
static void add_system(double shape[3], double *slope, const struct hawser__lmode_system *system,
                       const double *x, const double *strain, int piece, double s, double angle)
{
	for (int k = 0; k < system->segments; k++)
		if (system->segment[k].index == piece)
			add_segment(shape, slope, &system->segment[k], x + system->segment[k].at,
			            strain + system->segment[k].strain, s, angle);
}

static void none(double shape[3], double *slope)
{
	for (int c = 0; c < 3; c++) {
		shape[c] = 0.0;
		if (slope)
			slope[c] = 0.0;
	}
}

void hawser__lexpand_shape_at(double shape[3], double slope[3], const struct hawser__lexpand *t, int i,
                              int piece, double s, double angle)
{
	const struct hawser__lexpand_shape *own = &t->shape[i];

	none(shape, slope);
	add_system(shape, slope, &t->rope->system[own->system], own->x, own->strain, piece, s, angle);
}

void hawser__lexpand_field_at(double shape[3], double slope[3], const struct hawser__lmode *rope,
                              const double *row, int piece, double s, double angle)
{
	const double *x = row, *strain = row;

	none(shape, slope);
	for (int i = 0; i < rope->systems; i++)
		strain += rope->system[i].size;
	for (int i = 0; i < rope->systems; i++) {
		add_system(shape, slope, &rope->system[i], x, strain, piece, s, angle);
		x += rope->system[i].size;
		strain += rope->system[i].strains;
	}
}
