/* modes/label.c - norm, sign, family, symmetry and participation of real modes
 * (doc/theory-modes.md, "Labels"), and the numbering of all modes.
 *
 *   share_f  integral of component f squared, over that of Phi.Phi: share of the kinetic energy;
 *            point masses are part of both integrals
 *   sigma    integral of f(s) f(l-s) over that of f(s)^2, f the component with the largest share:
 *            1 - 2*(share of the antisymmetric part), so 1 symmetric and -1 antisymmetric
 *   Gamma_i  integral of Phi.e_i in global axes; Gamma_i^2/l is the modal effective mass over
 *            rho*L. The sum over all modes is 1 (Parseval: the squared norm of the constant e_i is l)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/complex/gyroscopic.h"
#include "modes/label.h"
#include "modes/methods.h"

/* Least sigma of a symmetric mode: 99 % of the energy of its dominant component is symmetric. */
static const double symmetric_from = 0.98;
/* The sign is set where the dominant component first reaches this fraction of its maximum. That
 * point is neither near a zero nor after the first extremum, so that round-off cannot change the
 * sign. */
static const double sign_at = 0.3;

static double mirrored(const struct hawser_grid *grid, const double *shape, int f, int i)
{
	double all[3];

	if (grid->elements == 1)
		return shape[3*(grid->points - 1 - i) + f];
	hawser__grid_at(all, grid, shape, 3, 3, grid->edge[grid->elements] - grid->s[i]);
	return all[f];
}

static double mirror_product(const struct hawser_grid *grid, const double *shape, int f)
{
	double sum = 0.0;

	for (int i = 0; i < grid->points; i++)
		sum += grid->weight[i]*shape[3*i + f]*mirrored(grid, shape, f, i);
	return sum;
}

static double sign_of(const struct hawser_grid *grid, const double *shape, int f)
{
	double largest = 0.0;

	for (int i = 0; i < grid->points; i++)
		largest = fmax(largest, fabs(shape[3*i + f]));
	for (int i = 0; i < grid->points; i++)
		if (fabs(shape[3*i + f]) >= sign_at*largest)
			return shape[3*i + f] < 0.0 ? -1.0 : 1.0;
	return 1.0;
}

enum hawser_status hawser__modes_allocate(struct hawser_modes *modes, int n, int points,
                                          struct hawser_report *report)
{
	size_t values = (size_t)n*(size_t)points, parts = modes->gyroscopic ? 2 : 1;

	modes->n = n;
	modes->mode = calloc((size_t)n, sizeof *modes->mode);
	modes->shape = calloc(values, 3*parts*sizeof *modes->shape);
	modes->slope = calloc(values, 3*parts*sizeof *modes->slope);
	if (hawser__has_absorbers(&modes->statics) && !modes->gyroscopic) {
		modes->stroke = calloc((size_t)n*(size_t)modes->statics.attachments,
		                       sizeof *modes->stroke);
		if (!modes->stroke)
			return hawser__no_memory(report, "modes");
	}
	if (modes->mode && modes->shape && modes->slope)
		return HAWSER_OK;
	return hawser__no_memory(report, "modes");
}

double hawser__point_absorber(const struct hawser_statics *st, int i)
{
	return i < st->attachments ? st->attached[i].absorber : 0.0;
}

double hawser__point_bare(const struct hawser_statics *st, int i)
{
	return hawser__point(st, i).m - hawser__point_absorber(st, i);
}

void hawser__modes_absorber(double w[3], const struct hawser_modes *modes, int k, int i,
                            const double u[3])
{
	double stroke = hawser__stroke(modes, k, i);

	for (int c = 0; c < 3; c++)
		w[c] = u[c] + (stroke != 0.0 ? stroke*modes->statics.attached[i].absorber_axis[c] : 0.0);
}

int hawser__points(const struct hawser_statics *st)
{
	return st->attachments + 2*st->elastic;
}

struct hawser__point hawser__point(const struct hawser_statics *st, int i)
{
	if (i < st->attachments)
		return (struct hawser__point){st->attached[i].s, st->attached[i].m};
	i -= st->attachments;
	return (struct hawser__point){i > 0 ? st->l : 0.0, st->held[i].m};
}

/* Mass along an axis: the masses of elastic supports do not move in rigid directions. */
static double mass_along(const struct hawser_statics *st, int axis)
{
	double mass = hawser_statics_mass(st);

	for (int end = 0; end < 2 && st->elastic; end++)
		mass += isfinite(st->held[end].stiffness[axis]) ? st->held[end].m : 0.0;
	return mass;
}

void hawser__modes_attached(double u[3], const struct hawser_modes *modes, int k, int i)
{
	double s = hawser__point(&modes->statics, i).s, local[3];
	struct hawser_frame_point at = hawser_statics_frame(&modes->statics, s);

	hawser_modes_at(modes, local, NULL, k, s);
	u[0] = local[0]*at.ex - local[1]*at.ey;
	u[1] = local[0]*at.ey + local[1]*at.ex;
	u[2] = local[2];
	for (int c = 0; c < 3 && modes->statics.space; c++)
		u[c] = local[0]*at.axis[0][c] + local[1]*at.axis[1][c] + local[2]*at.axis[2][c];
}

/* Share of the point masses in the norm of mode k, added to those of the components. */
static void add_masses(double share[3], const struct hawser_modes *modes, int k)
{
	const struct hawser_statics *st = &modes->statics;

	for (int i = 0; i < hawser__points(st); i++) {
		struct hawser__point point = hawser__point(st, i);
		double local[3], bare = hawser__point_bare(st, i), own = hawser__point_absorber(st, i);
		double stroke = hawser__stroke(modes, k, i);
		struct hawser_frame_point at = hawser_statics_frame(st, point.s);

		hawser_modes_at(modes, local, NULL, k, point.s);
		for (int c = 0; c < 3; c++)
			share[c] += bare*local[c]*local[c];
		if (own > 0.0) {
			const double *a = st->attached[i].absorber_axis;

			double b[3];

			hawser_statics_from_global(st, b, a);
			for (int c = 0; c < 3; c++)
				local[c] += stroke*(at.axis[c][0]*b[0] + at.axis[c][1]*b[1] + at.axis[c][2]*b[2]);
			for (int c = 0; c < 3; c++)
				share[c] += own*local[c]*local[c];
		}
	}
}

/* Gamma: generalised force of a unit acceleration of both supports along x, y or z. */
static void participate(struct hawser_mode *mode, const struct hawser_modes *modes, int k,
                        const double *shape)
{
	const struct hawser_grid *grid = &modes->grid;
	const struct hawser_statics *st = &modes->statics;
	double *Gamma = mode->participation;

	for (int i = 0; st->space && i < grid->points; i++) {
		struct hawser_frame_point at = hawser_statics_frame(st, grid->s[i]);

		for (int f = 0; f < 3; f++)
			for (int c = 0; c < 3; c++)
				Gamma[c] += grid->weight[i]*shape[3*i + f]*at.axis[f][c];
	}
	for (int i = 0; !st->space && i < grid->points; i++, shape += 3) {
		double u = st->attachments > 0 ? hawser_statics_frame(st, grid->s[i]).u
		                               : st->eta + st->delta*grid->s[i];
		double T = hypot(1.0, u), w = grid->weight[i];

		Gamma[0] += w*(shape[0] - u*shape[1])/T;
		Gamma[1] += w*(u*shape[0] + shape[1])/T;
		Gamma[2] += w*shape[2];
	}
	for (int i = 0; i < hawser__points(st); i++) {
		double u[3], w[3], m = hawser__point_bare(st, i), own = hawser__point_absorber(st, i);

		hawser__modes_attached(u, modes, k, i);
		hawser__modes_absorber(w, modes, k, i, u);
		for (int c = 0; c < 3; c++)
			Gamma[c] += m*u[c] + own*w[c];
	}
	hawser_statics_to_global(st, Gamma, Gamma);
	for (int c = 0; c < 3; c++)
		mode->effective_mass[c] = Gamma[c]*Gamma[c]/mass_along(st, c);
}

double hawser__mode_label(struct hawser_modes *modes, int k)
{
	const struct hawser_grid *grid = &modes->grid;
	struct hawser_mode *mode = modes->mode + k;
	double *shape = modes->shape + (size_t)k*3*(size_t)grid->points;
	double *slope = modes->slope + (size_t)k*3*(size_t)grid->points;
	double share[3] = {0.0}, all, scale, sigma, own;
	int f = 0;

	for (int i = 0; i < grid->points; i++)
		for (int c = 0; c < 3; c++)
			share[c] += grid->weight[i]*shape[3*i + c]*shape[3*i + c];
	for (int c = 1; c < 3; c++)
		if (share[c] > share[f])
			f = c;
	own = share[f];
	add_masses(share, modes, k);
	all = share[0] + share[1] + share[2];
	mode->axial_share = share[0]/all;
	mode->normal_share = share[1]/all;
	mode->out_of_plane_share = share[2]/all;
	if (modes->statics.space) /* by the larger share: the planes couple */
		mode->plane = mode->out_of_plane_share > 0.5 ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
	mode->condition = 1.0;
	mode->downstream = 0.5;
	mode->family = f == 0 ? HAWSER_LONGITUDINAL : HAWSER_TRANSVERSE;
	sigma = mirror_product(grid, shape, f)/own;
	mode->symmetry = sigma >= symmetric_from ? HAWSER_SYMMETRIC
	                 : sigma <= -symmetric_from ? HAWSER_ANTISYMMETRIC : HAWSER_MIXED;
	scale = sign_of(grid, shape, f)/sqrt(all);
	for (int i = 0; i < 3*grid->points; i++) {
		shape[i] *= scale;
		slope[i] *= scale;
	}
	for (int i = 0; modes->stroke && i < modes->statics.attachments; i++)
		if (modes->stroke[k*modes->statics.attachments + i] != 0.0)
			modes->stroke[k*modes->statics.attachments + i] *= scale;
	participate(mode, modes, k, shape);
	return sqrt(all);
}

enum hawser_status hawser__modes_label(struct hawser_modes *modes, struct hawser_report *report)
{
	int count[2] = {0};

	for (int k = 0; k < modes->n; k++) {
		const struct hawser_mode *mode = modes->mode + k;
		double norm = modes->gyroscopic ? hawser__complex_label(modes, k)
		                                : hawser__mode_label(modes, k);

		if (!(norm > 0.0 && isfinite(norm)) ||
		    (modes->gyroscopic && !isfinite(mode->omega + mode->downstream + mode->condition)))
			return hawser__fail(report, HAWSER_ERR_NAN, "modes",
			                    "the shape of mode %d came out as not a number: ask for "
			                    "fewer modes or a smaller basis", k + 1);
		modes->mode[k].place = k + 1;
		modes->mode[k].number = ++count[modes->mode[k].plane];
	}
	return HAWSER_OK;
}

double hawser__damping_ratio(const struct hawser_scene *scene, const struct hawser_mode *mode)
{
	int last = scene->damping.ratios, place = mode->number ? mode->place : last;

	if (last < 2 || place < 2)
		return scene->damping.ratio;
	return scene->damping.ratio_next[(place < last ? place : last) - 2];
}
