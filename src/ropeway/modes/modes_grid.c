/* ropeway/modes/modes_grid.c - grids of the pieces of a rope over sheaves, and its statics on them.
 *
 *   u        V/H; elements of a free piece have equal length in asinh u
 *   m        nodes of each element
 *   radius   of the largest ellipse with foci at the ends of an element in which the tension is
 *            analytic: sum of its half axes. sqrt(H^2 + V^2) has branch points at V = +-iH
 *
 * Gauss collocation with m nodes gives frequencies that have the error of 2m coefficients. A wave of
 * phase 2a on an element has coefficients that fall to round-off beyond a + c a^(1/3) (those of a plane
 * wave are Bessel functions J_m(a)), and those of the statics fall by 1/radius each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "ropeway/modes/modes.h"

/* Largest element, in asinh u: with it the radius is 3.4 or more. */
static const double longest = 1.25;
/* log of the relative accuracy that the grid is chosen for, 1e-16. */
static const double digits = 37.0;
/* Largest phase of a wave on an element: beyond it shorter elements are cheaper than more nodes. */
static const double longest_wave = 40.0;
enum { LEAST = 4, ARC_LEAST = 6, ELEMENTS_MOST = 128 };

void hawser__lmode_grid_clear(struct hawser__lmode_segment *segment)
{
	hawser__grid_clear(&segment->grid);
	hawser__reference_clear(&segment->table);
	free(segment->cosine);
	free(segment->sine);
	free(segment->sb);
	free(segment->k);
	free(segment->inverse);
	free(segment->unit[0]);
	free(segment->unit[1]);
	segment->cosine = segment->sine = segment->sb = segment->k = segment->inverse = NULL;
	segment->unit[0] = segment->unit[1] = NULL;
}

static double least_tension(const struct hawser__lmode_piece *piece)
{
	double last = piece->V + piece->delta*piece->length;

	if (piece->V*last <= 0.0)
		return fmax(fabs(piece->H), 1e-300);
	return hypot(piece->H, fmin(fabs(piece->V), fabs(last)));
}

/* Of waves that run upstream if the rope runs: they are the shortest of a frequency. */
static double phase_of(const struct hawser__lmode_piece *piece, const struct hawser__lmode *rope)
{
	double T = least_tension(piece), nu = fabs(rope->nu), c2;

	if (piece->sheave >= 0)
		return piece->length*sqrt(rope->epsilon);
	c2 = T/(1.0 + rope->epsilon*T);
	return piece->length*(sqrt(c2 + nu*nu) + nu)/c2;
}

double hawser__lmode_phase(const struct hawser__lmode_segment *segment,
                           const struct hawser__lmode *rope)
{
	return phase_of(segment->piece, rope);
}

/* The order that resolves the statics of an element from V to V + dV. */
static int order_of(double H, double V, double dV)
{
	double complex z;
	double radius;

	if (dV == 0.0)
		return LEAST;
	z = (2.0*H*I - 2.0*V - dV)/dV;
	radius = cabs(z + csqrt(z*z - 1.0));
	if (radius < 1.0)
		radius = 1.0/radius;
	return (int)ceil(0.5*digits/log(fmax(radius, 1.1)));
}

/* Length of a free piece in asinh u. */
static double range_of(const struct hawser__lmode_piece *piece)
{
	return piece->H == 0.0 ? 0.0 : asinh((piece->V + piece->delta*piece->length)/fabs(piece->H)) -
	                               asinh(piece->V/fabs(piece->H));
}

/* V at the edges of `elements` elements: of equal lengths if the slope allows it, since differences of
 * sinh would lose digits then. */
static double edge_of(const struct hawser__lmode_piece *piece, int e, int elements)
{
	double range = range_of(piece);

	if (e == elements)
		return piece->V + piece->delta*piece->length;
	if (range <= longest)
		return piece->V + piece->delta*piece->length*e/elements;
	return e == 0 ? piece->V : fabs(piece->H)*sinh(asinh(piece->V/fabs(piece->H)) + range*e/elements);
}

static int elements_of(const struct hawser__lmode_piece *piece, double phase)
{
	double elements = fmax(1.0, fmax(ceil(phase/longest_wave), ceil(range_of(piece)/longest)));

	return (int)fmin(ELEMENTS_MOST, elements);
}

static int waves(double a)
{
	return (int)ceil(a + 3.5*cbrt(a)) + 2;
}

enum hawser_status hawser__lmode_piece_grid(struct hawser_grid *grid,
                                           const struct hawser__lmode_piece *piece,
                                           const struct hawser__lmode *rope, double omega, int extra,
                                           struct hawser_report *report)
{
	int arc = piece->sheave >= 0, order = LEAST, elements;
	double edge[ELEMENTS_MOST + 1] = {0.0}, length[ELEMENTS_MOST], phase = omega*phase_of(piece, rope);

	elements = arc ? 1 : elements_of(piece, phase);
	phase /= elements;
	if (arc)
		order = ARC_LEAST + (int)ceil(3.0*fabs(piece->angle[1] - piece->angle[0]));
	for (int e = 0; e < elements; e++) {
		double first = edge_of(piece, e, elements);
		double dV = edge_of(piece, e + 1, elements) - first;
		int own = arc ? order : order_of(piece->H, first, dV);

		order = own > order ? own : order;
		length[e] = arc || range_of(piece) <= longest ? piece->length/elements
		                                              : dV/piece->delta;
		edge[e + 1] = e + 1 == elements ? piece->length : edge[e] + length[e];
	}
	order += waves(0.5*phase) + extra;
	if (order > HAWSER__ORDER_MOST)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "line modes", "the highest mode has some "
		                    "%.0f waves in a piece of %.4g m: ask for fewer modes", phase/(2.0*M_PI),
		                    piece->length*rope->length);
	return hawser__grid_init(grid, elements, order, edge, length, report);
}

static double *array(int n)
{
	return calloc((size_t)n, sizeof(double));
}

static enum hawser_status free_fields(struct hawser__lmode_segment *segment,
                                      const struct hawser__lmode *rope,
                                      struct hawser_report *report)
{
	const struct hawser__lmode_piece *piece = segment->piece;
	const struct hawser_grid *grid = &segment->grid;
	double Tr = hypot(piece->reference[0], piece->reference[1]), nu2 = rope->nu*rope->nu;
	int even = range_of(piece) <= longest;

	segment->sb = array(grid->points);
	segment->cosine = array(grid->points);
	segment->sine = array(grid->points);
	if (!segment->sb || !segment->cosine || !segment->sine)
		return hawser__no_memory(report, "line modes");
	for (int i = 0; i < grid->points; i++) {
		int e = i/grid->order;
		double first = edge_of(piece, e, grid->elements);
		double last = edge_of(piece, e + 1, grid->elements);
		double V = first + 0.5*(last - first)*(1.0 + grid->node[i%grid->order]);
		double T = hypot(piece->H, V), g = (1.0 + rope->epsilon*T)/(1.0 - rope->epsilon*nu2);
		double bent = piece->bent + (even ? piece->delta*grid->s[i] : V - piece->V);

		segment->sb[i] = sqrt(g/T);
		segment->cosine[i] = (piece->H*piece->reference[0] + V*piece->reference[1])/(T*Tr);
		segment->sine[i] = piece->reference[0]*bent/(T*Tr);
	}
	return HAWSER_OK;
}

/* On an arc: the stiffness of the weight, or what (3.109) has in its place, T kappa^2; out of the plane
 * the tension. */
static enum hawser_status arc_fields(struct hawser__lmode_segment *segment,
                                     const struct hawser__lmode *rope,
                                     enum hawser_plane plane, struct hawser_report *report)
{
	const struct hawser__lmode_piece *piece = segment->piece;
	const struct hawser_line_statics *st = rope->lane[piece->lane];
	const struct hawser_line_sheave *sheave = &st->line->sheave[piece->sheave];
	const struct hawser_grid *grid = &segment->grid;
	double **field = plane == HAWSER_IN_PLANE ? &segment->k : &segment->sb, nu2 = rope->nu*rope->nu;

	*field = array(grid->points);
	segment->sine = array(grid->points);
	if (!*field || !segment->sine)
		return hawser__no_memory(report, "line modes");
	for (int i = 0; i < grid->points; i++) {
		double angle, T, g, curvature;

		hawser_line_at(st, NULL, &angle, &T, &g, &curvature, (piece->s0 + grid->s[i])*rope->length);
		T = T/rope->force - nu2*g; /* apparent */
		segment->sine[i] = sin(angle);
		if (plane == HAWSER_OUT_OF_PLANE)
			(*field)[i] = sqrt(g/T);
		else if (rope->options.printed)
			(*field)[i] = T/g*curvature*curvature*rope->length*rope->length;
		else
			(*field)[i] = -piece->delta*sheave->side*cos(angle)*rope->length/sheave->radius;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__lmode_grids(struct hawser__lmode_system *system,
                                       const struct hawser__lmode *rope,
                                      double omega, int extra, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < system->segments && !status; i++) {
		struct hawser__lmode_segment *segment = &system->segment[i];

		hawser__lmode_grid_clear(segment);
		segment->sa = sqrt(rope->epsilon/(1.0 - rope->epsilon*rope->nu*rope->nu));
		status = hawser__lmode_piece_grid(&segment->grid, segment->piece, rope, omega, extra, report);
		if (!status)
			status = hawser__reference_init(&segment->table, &segment->grid, segment->grid.order - 1,
			                                report);
		if (!status)
			status = segment->arc ? arc_fields(segment, rope, system->plane, report)
			                      : free_fields(segment, rope, report);
	}
	return status;
}
