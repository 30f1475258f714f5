/* rom/condense/condense.c - static condensation in closed form.
 *
 *    a, b, c      derivative of a displacement in the local frame (e, n, z)
 *    eps          H/EA;  g static stretch |x'|;  k = sqrt(1+u^2)/g, the geometric stiffness
 *    alpha, beta, gamma   density of D^3V3[Phi_j, Phi_k, .] with respect to a, b, c:
 *                 alpha = (b_j b_k + c_j c_k)/(g^2 eps)
 *                 beta  = (a_j b_k + a_k b_j)/(g^2 eps),  gamma = (a_j c_k + a_k c_j)/(g^2 eps)
 *
 * w minimises the integral of a^2/(2 eps) + k (b^2 + c^2)/2 + alpha a + beta b + gamma c under the
 * only constraint on the strains, that the ends are fixed: the integral of a e + b n + c z
 * vanishes. With a multiplier lambda for it,
 *
 *      a = -eps (alpha + lambda.e)      b = -(beta + lambda.n)/k      c = -(gamma + lambda_z)/k
 *
 * and lambda solves a 2 by 2 system (in-plane) and a scalar equation (out of plane); it is the
 * change of the end force. This is exact up to quadrature, however stiff the cable is, while
 * Galerkin's method would need a converged basis. Finally the part along the kept modes is removed:
 * since K w = -D^3V3, w has the coordinate -T_jks/omega_s^2 along Phi_s. With springs of attachments
 * the force varies along the cable: ties.c. An absorber carries no static force, so that w has a stroke
 * only in the part along the kept modes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/terms/absorbers.h"
#include "rom/condense/bend.h"
#include "rom/condense/condense.h"
#include "rom/terms/ties.h"
#include "statics/frame.h"

struct work {
	const struct hawser_modes *modes;
	struct hawser__place *place; /* [points] */
	struct hawser__ties ties;
	struct hawser__bend *bend;       /* or NULL (bend.c) */
	struct hawser__springs *springs; /* or NULL (ties.c) */
	double *stretch;                 /* [pairs][springs] displacements of w_jk at the springs */
};

struct hawser__place hawser__place_at(const struct hawser_modes *modes, double s, double weight)
{
	struct hawser_frame_point at = hawser_statics_frame(&modes->statics, s);
	double chord = hypot(1.0, modes->statics.hs), c = 1.0/chord, sine = modes->statics.hs/chord;
	double g = 1.0 + at.strain;

	if (modes->statics.space)
		return hawser__space_place(modes, &at, weight);
	return (struct hawser__place){
		.weight = weight,
		.eps = modes->statics.epsilon,
		.k = sqrt(1.0 + at.u*at.u)/g,
		.g2 = g*g,
		/* in axes along and across the chord the matrix of a straight cable is graded, so that a
		 * tiny eps is not lost in round-off */
		.ex = at.ex*c + at.ey*sine,
		.ey = at.ey*c - at.ex*sine,
	};
}

void hawser__ties_add(struct hawser__ties *ties, const struct hawser__place *at)
{
	if (at->space) {
		hawser__space_ties_add(ties, at);
		return;
	}
	ties->m[0] += at->weight*(at->eps*at->ex*at->ex + at->ey*at->ey/at->k);
	ties->m[1] += at->weight*(at->eps - 1.0/at->k)*at->ex*at->ey;
	ties->m[2] += at->weight*(at->eps*at->ey*at->ey + at->ex*at->ex/at->k);
	ties->mz += at->weight/at->k;
}

void hawser__ties_solve(double lambda[3], const struct hawser__ties *ties, const double r[3])
{
	double det = ties->m[0]*ties->m[2] - ties->m[1]*ties->m[1];

	if (ties->space) {
		hawser__space_ties_solve(lambda, ties, r);
		return;
	}
	lambda[0] = (ties->m[2]*r[0] - ties->m[1]*r[1])/det;
	lambda[1] = (ties->m[0]*r[1] - ties->m[1]*r[0])/det;
	lambda[2] = r[2]/ties->mz;
}

static enum hawser_status prepare(struct work *work, struct hawser_report *report)
{
	const struct hawser_grid *grid = &work->modes->grid;
	enum hawser_status status;

	for (int p = 0; p < grid->points; p++) {
		work->place[p] = hawser__place_at(work->modes, grid->s[p], grid->weight[p]);
		hawser__ties_add(&work->ties, &work->place[p]);
	}
	status = hawser__bend_make(&work->bend, &work->modes->statics, grid->edge, grid->elements,
	                           grid->order, work->place, report);
	return status || !work->springs ? status
	       : hawser__springs_assemble(work->springs, work->bend, work->place, grid->s, grid->points,
	                                  report);
}

static int springs_of(const struct work *work)
{
	return work->springs ? work->springs->size - 3 + work->springs->joints : 0;
}

/* eps*alpha, eps*beta, eps*gamma at a point, for slopes x and y of two modes. */
static void force(double f[3], const struct hawser__place *at, const double *x, const double *y)
{
	f[0] = (x[1]*y[1] + x[2]*y[2])/at->g2;
	f[1] = (x[0]*y[1] + y[0]*x[1])/at->g2;
	f[2] = (x[0]*y[2] + y[0]*x[2])/at->g2;
}

/* The same as the end of answer() with springs: strains from the forces of the pair in `strain`. */
static void answer_springs(const struct work *work, double *strain, double *stretch)
{
	const struct hawser_grid *grid = &work->modes->grid;
	struct hawser__springs *springs = work->springs;

	memset(springs->z, 0, sizeof springs->z);
	for (int p = 0; p < grid->points; p++)
		for (int c = 0; c < 3; c++)
			strain[3*p + c] /= -work->place[p].eps;
	hawser__comply(work->bend, strain, work->place, grid->points);
	for (int p = 0; p < grid->points; p++)
		hawser__springs_load(springs, &work->place[p], grid->s[p], strain + 3*p);
	hawser__springs_solve(springs);
	hawser__springs_release(strain, springs, work->bend, work->place, grid->s, grid->points);
	for (int m = 0; m < springs_of(work); m++)
		stretch[m] = hawser__springs_stretch(springs, m);
}

/* Strains [points][3] of the response to the pair, and third[n] = T_jks for every kept mode s. */
static void answer(const struct work *work, double *strain, double *stretch, double *third, int j,
                   int k)
{
	const struct hawser_modes *modes = work->modes;
	int points = modes->grid.points;
	const double *x = modes->slope + (size_t)j*points*3, *y = modes->slope + (size_t)k*points*3;
	double r[3] = {0.0}, lambda[3];

	memset(third, 0, (size_t)modes->n*sizeof *third);
	for (int p = 0; p < points; p++) {
		const struct hawser__place *at = &work->place[p];
		double *f = strain + 3*p, across;

		force(f, at, x + 3*p, y + 3*p);
		for (int s = 0; s < modes->n; s++) {
			const double *z = modes->slope + ((size_t)s*points + p)*3;

			third[s] += at->weight/at->eps*(f[0]*z[0] + f[1]*z[1] + f[2]*z[2]);
		}
		across = f[1]/(at->eps*at->k);
		if (at->space) {
			const double free[3] = {f[0], across, f[2]/(at->eps*at->k)};

			hawser__space_reach(r, at, free, -at->weight);
			continue;
		}
		r[0] -= at->weight*(f[0]*at->ex - across*at->ey);
		r[1] -= at->weight*(f[0]*at->ey + across*at->ex);
		r[2] -= at->weight*f[2]/(at->eps*at->k);
	}
	if (work->springs) {
		answer_springs(work, strain, stretch);
		return;
	}
	hawser__ties_solve(lambda, &work->ties, r);
	for (int p = 0; p < points; p++) {
		const struct hawser__place *at = &work->place[p];
		double *f = strain + 3*p;

		if (at->space) {
			for (int c = 0; c < 3; c++)
				f[c] = c == 0 ? -f[0] - at->eps*hawser__space_along(at, lambda, 0)
				              : -(f[c]/at->eps + hawser__space_along(at, lambda, c))/at->k;
			continue;
		}
		f[0] = -f[0] - at->eps*(lambda[0]*at->ex + lambda[1]*at->ey);
		f[1] = -(f[1]/at->eps - lambda[0]*at->ey + lambda[1]*at->ex)/at->k;
		f[2] = -(f[2]/at->eps + lambda[2])/at->k;
	}
}

/* Remove the part along the kept modes. stroke: NULL without absorbers. */
static void remove_kept(const struct work *work, double *strain, double *stretch, double *stroke,
                        const double *third)
{
	const struct hawser_modes *modes = work->modes;
	int count = 3*modes->grid.points;

	for (int s = 0; s < modes->n; s++) {
		double part = third[s]/(modes->mode[s].omega*modes->mode[s].omega);

		cblas_daxpy(count, part, modes->slope + (size_t)s*count, 1, strain, 1);
		for (int i = 0; stroke && i < modes->statics.attachments; i++)
			stroke[i] += part*hawser__stroke(modes, s, i);
		for (int m = 0; m < springs_of(work); m++) {
			double u[3];

			hawser__modes_attached(u, modes, s, work->springs->spring[m].attachment);
			stretch[m] += part*cblas_ddot(3, u, 1, work->springs->spring[m].way, 1);
		}
	}
}

/* Strains, displacements at the springs and strokes, times the square roots of weight and stiffness;
 * their products form gram. */
static enum hawser_status set_gram(struct hawser__condensed *condensed, const struct work *work,
                                   struct hawser_report *report)
{
	const struct hawser_statics *st = &work->modes->statics;
	int pairs = condensed->pairs, springs = springs_of(work), points = condensed->points;
	int absorbers = condensed->stroke ? st->attachments : 0;
	int width = 3*points + springs + absorbers + hawser__bend_width(work->bend);
	double *scaled = malloc((size_t)pairs*width*sizeof *scaled);

	if (!scaled)
		return hawser__no_memory(report, "rom");
	for (int x = 0; x < pairs; x++) {
		double *to = scaled + (size_t)x*width;

		for (int p = 0; p < condensed->points; p++, to += 3) {
			const struct hawser__place *at = &work->place[p];
			const double *strain = condensed->strain + ((size_t)x*condensed->points + p)*3;

			/* filled for each point */
			/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult) */
			to[0] = sqrt(at->weight/at->eps)*strain[0];
			to[1] = sqrt(at->weight*at->k)*strain[1];
			to[2] = sqrt(at->weight*at->k)*strain[2];
		}
		for (int m = 0; m < springs; m++)
			to[m] = sqrt(work->springs->spring[m].k)*work->stretch[(size_t)x*springs + m];
		for (int i = 0; i < absorbers; i++)
			to[springs + i] = sqrt(hawser__absorber_stiffness(st, i))*
			                  condensed->stroke[(size_t)x*absorbers + i];
		if (work->bend)
			hawser__bend_rows(to + springs + absorbers, work->bend,
			                  condensed->strain + (size_t)x*points*3);
	}
	cblas_dsyrk(CblasRowMajor, CblasLower, CblasNoTrans, pairs, width, 1.0, scaled, width, 0.0,
	            condensed->gram, pairs);
	for (int x = 0; x < pairs; x++)
		for (int y = x + 1; y < pairs; y++)
			condensed->gram[(size_t)x*pairs + y] = condensed->gram[(size_t)y*pairs + x];
	free(scaled);
	return HAWSER_OK;
}

enum hawser_status hawser__condense(struct hawser__condensed *condensed,
                                    const struct hawser_modes *modes, int moving,
                                    struct hawser_report *report)
{
	int n = moving, pairs = n*(n + 1)/2, points = modes->grid.points;
	struct work work = {.modes = modes};
	enum hawser_status status = hawser__springs_make(&work.springs, modes, report);
	double *third = malloc((size_t)modes->n*sizeof *third);

	*condensed = (struct hawser__condensed){.n = n, .points = points, .pairs = pairs};
	condensed->strain = malloc((size_t)pairs*points*3*sizeof *condensed->strain);
	condensed->start = calloc((size_t)pairs, 3*sizeof *condensed->start);
	condensed->gram = malloc((size_t)pairs*pairs*sizeof *condensed->gram);
	if (modes->stroke)
		condensed->stroke = calloc((size_t)pairs*(size_t)modes->statics.attachments,
		                           sizeof *condensed->stroke);
	work.place = malloc((size_t)points*sizeof *work.place);
	work.stretch = malloc(((size_t)pairs*(size_t)springs_of(&work) + 1)*sizeof *work.stretch);
	if (status)
		goto done;
	if (!condensed->strain || !condensed->start || !condensed->gram ||
	    (modes->stroke && !condensed->stroke) ||
	    !work.place || !work.stretch || !third) {
		status = hawser__no_memory(report, "rom");
		goto done;
	}
	status = prepare(&work, report);
	for (int k = 0; k < n && !status; k++)
		for (int j = 0; j <= k; j++) {
			size_t pair = (size_t)(k*(k + 1)/2 + j);
			double *strain = condensed->strain + pair*points*3;
			double *stretch = work.stretch + pair*(size_t)springs_of(&work);

			answer(&work, strain, stretch, third, j, k);
			remove_kept(&work, strain, stretch, condensed->stroke ? condensed->stroke +
			            pair*(size_t)modes->statics.attachments : NULL, third);
			if (work.springs)
				hawser__springs_start(condensed->start + 3*pair, work.springs, stretch);
		}
	if (!status)
		status = set_gram(condensed, &work, report);
done:
	hawser__springs_free(work.springs);
	hawser__bend_free(work.bend);
	free(work.stretch);
	free(work.place);
	free(third);
	if (status)
		hawser__condensed_clear(condensed);
	return status;
}

void hawser__condensed_clear(struct hawser__condensed *condensed)
{
	free(condensed->strain);
	free(condensed->start);
	free(condensed->gram);
	free(condensed->stroke);
	*condensed = (struct hawser__condensed){0};
}

void hawser__global_slopes(double *global, const struct hawser_modes *modes, const double *strain)
{
	int points = modes->grid.points;

	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, modes->grid.s[p]);
		double v[3];

		hawser__frame_out(v, &at, strain + 3*p);
		for (int axis = 0; axis < 3; axis++)
			global[axis*points + p] = v[axis];
	}
}

enum hawser_status hawser__condensed_at(const struct hawser__condensed *condensed,
                                        const struct hawser_modes *modes, double *shape,
                                        double *slope, int stride, double s,
                                        struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	struct hawser_frame_point at = hawser_statics_frame(&modes->statics, s);
	struct hawser__reference reference;
	size_t points = (size_t)grid->points;
	double *global = malloc(6*points*sizeof *global), *along, u[3];
	enum hawser_status status = hawser__reference_init(&reference, grid, grid->order - 1, report);

	if (!status && !global) {
		hawser__reference_clear(&reference);
		status = hawser__no_memory(report, "rom");
	}
	for (int x = 0; !status && x < condensed->pairs; x++) {
		const double *strain = condensed->strain + (size_t)x*points*3;

		along = global + 3*points;
		hawser__global_slopes(global, modes, strain);
		for (int axis = 0; axis < 3; axis++) {
			hawser__grid_running(along + axis*points, grid, &reference,
			                     global + axis*points);
			hawser__grid_at(&u[axis], grid, along + axis*points, 1, 1, s);
			u[axis] += condensed->start[3*x + axis];
		}
		if (modes->statics.space)
			memcpy(shape + x*stride, u, sizeof u); /* as in set_probe of build.c */
		else
			hawser__frame_in(shape + x*stride, &at, u);
		hawser__grid_at(slope + x*stride, grid, strain, 3, 3, s);
	}
	if (!status)
		hawser__reference_clear(&reference);
	free(global);
	return status;
}
