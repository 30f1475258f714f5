/* modes/complex/gyroscopic_spectral.c - hp Galerkin modes of a travelling cable, with error control.
 *
 *   omega_j, Phi_j   all modes of a polynomial basis of the apparent cable at rest (basis.c)
 *   B = 2 nu G       gyroscopic matrix, skew; G_jk the integral of Phi_j . Phi_k'
 *   k_j = 1/omega_j  the diagonal of K^-1/2
 *   S                [-k B k, -k; k, 0], real and skew: the inverse of the matrix of the
 *                    first-order system for (K^1/2 q, q')
 *
 * i omega is an eigenvalue of that system if and only if 1/omega is one of i S. i S is Hermitian,
 * so that i omega has no real part, for any round-off, order and speed. The lowest modes are the
 * largest eigenvalues of i S, which a Hermitian eigensolver computes to full relative accuracy,
 * however stiff the cable is. The direct form [0 K^1/2; -K^1/2 -B] has a norm of order 1/epsilon,
 * and the lowest eigenvalues would lose accuracy by that factor.
 *
 * The refinement is a step of inverse iteration with the exact operator, as for the modes at rest
 * (compliance.c). Then omega is the positive root of q*(K + i omega B - omega^2)q. This functional
 * is stationary at a mode, so that omega has twice as many correct digits as the shape
 * (complex_mode.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/cable.h"
#include "modes/complex/gyroscopic.h"
#include "modes/label.h"
#include "modes/spectral.h"

enum { BASIS_MAX = 400 };

/* Galerkin problem of one plane: `n` modes at rest as functions, the `count` lowest complex
 * modes. */
struct side {
	int plane, D, n, count;
	double *omega;            /* [n] frequencies of the modes at rest */
	double *field, *gradient; /* [n] columns of D*points: Phi_j and Phi_j', local frame */
	double *G;                /* [n] columns of n, 2 nu times G */
	double *gyroscopic;       /* [count] frequencies of the complex modes, ascending */
	double complex *q;        /* [count] columns of n, descending omega */
	struct hawser__hold hold;
};

struct attempt {
	struct hawser__cable cable;
	struct side side[HAWSER__PLANES];
	double nu;
};

static void attempt_clear(struct attempt *t)
{
	hawser__cable_clear(&t->cable);
	for (int q = 0; q < HAWSER__PLANES; q++)
		hawser__hold_clear(&t->side[q].hold);
	*t = (struct attempt){0};
}

/* --- Galerkin --- */

/* Store the basis modes of one plane as columns. */
static void gather(struct side *side, const struct hawser_modes *basis)
{
	int points = basis->grid.points, first = side->plane == HAWSER_OUT_OF_PLANE ? 2 : 0, j = 0;

	for (int k = 0; k < basis->n; k++) {
		const double *shape = basis->shape + (size_t)k*3*(size_t)points;
		const double *slope = basis->slope + (size_t)k*3*(size_t)points;
		size_t at = (size_t)j*(size_t)(side->D*points);

		if ((int)basis->mode[k].plane != side->plane)
			continue;
		side->omega[j++] = basis->mode[k].omega;
		for (int c = 0; c < side->D; c++)
			for (int i = 0; i < points; i++) {
				side->field[at + (size_t)(c*points + i)] = shape[3*i + first + c];
				side->gradient[at + (size_t)(c*points + i)] = slope[3*i + first + c];
			}
	}
}

/* Compute nu (I - I') into G, where I_jk is the integral of Phi_j . Phi_k': 2 nu times the matrix
 * of hawser_modes_convection, exactly skew. `work` has the size of `field`. */
static void convect(struct side *side, double *work, const struct hawser_grid *grid, double nu)
{
	int n = side->n, rows = side->D*grid->points;

	for (int k = 0; k < n; k++)
		for (int i = 0; i < rows; i++)
			work[(size_t)k*(size_t)rows + (size_t)i] =
				grid->weight[i%grid->points]*side->gradient[(size_t)k*(size_t)rows + (size_t)i];
	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, n, n, rows, 1.0, side->field, rows, work,
	            rows, 0.0, side->G, n);
	for (int j = 0; j < n; j++)
		for (int k = 0; k <= j; k++) {
			double *jk = side->G + j + (size_t)k*(size_t)n, *kj = side->G + k + (size_t)j*(size_t)n;

			*jk = nu*(*jk - *kj);
			*kj = -*jk;
		}
}

static enum hawser_status side_init(struct side *side, const struct hawser_modes *basis, int plane,
                                    int wanted, double nu, struct hawser_report *report)
{
	size_t rows = (size_t)basis->grid.points, n = 0;
	double *work;

	*side = (struct side){.plane = plane, .D = plane == HAWSER_IN_PLANE ? 2 : 1};
	for (int k = 0; k < basis->n; k++)
		n += (int)basis->mode[k].plane == plane;
	side->n = (int)n;
	side->count = wanted < side->n ? wanted : side->n;
	rows *= (size_t)side->D;
	side->omega = hawser__hold(&side->hold, n, sizeof *side->omega);
	side->field = hawser__hold(&side->hold, n*rows, sizeof *side->field);
	side->gradient = hawser__hold(&side->hold, n*rows, sizeof *side->gradient);
	side->G = hawser__hold(&side->hold, n*n, sizeof *side->G);
	side->gyroscopic = hawser__hold(&side->hold, (size_t)side->count, sizeof *side->gyroscopic);
	side->q = hawser__hold(&side->hold, (size_t)side->count*n, sizeof *side->q);
	work = hawser__hold(&side->hold, n*rows, sizeof *work);
	if (side->hold.short_of_memory)
		return hawser__no_memory(report, "modes");
	gather(side, basis);
	convect(side, work, &basis->grid, nu);
	return HAWSER_OK;
}

int hawser__gyroscopic_pairs(double *mu, double complex *z, int *found, int count, const double *G,
                             const double *omega, int n)
{
	size_t order = 2*(size_t)n, rows = (size_t)n;
	double complex *H = calloc(order*order + 1, sizeof *H);
	lapack_int *support = calloc(2*(size_t)count + 1, sizeof *support), have = 0;
	lapack_int info = H && support ? 0 : LAPACK_WORK_MEMORY_ERROR;

	for (size_t k = 0; k < rows && !info; k++) {
		for (size_t j = k; j < rows; j++)
			H[k*order + j] = -I*(G[k*rows + j]/(omega[j]*omega[k]));
		H[k*order + rows + k] = I/omega[k];
	}
	if (!info)
		info = LAPACKE_zheevr(LAPACK_COL_MAJOR, 'V', 'I', 'L', (int)order, H, (int)order, 0.0, 0.0,
		                      (int)order - count + 1, (int)order, 0.0, &have, mu, z, (int)order,
		                      support);
	*found = have;
	free(H);
	free(support);
	return info;
}

/* The largest eigenvalues of i S. */
static enum hawser_status eigen(struct side *side, struct hawser_report *report)
{
	size_t n = (size_t)side->n, order = 2*n, count = (size_t)side->count;
	double complex *z = calloc(order*count + 1, sizeof *z);
	double *mu = hawser__numbers(order, 1), largest = 1.0;
	int found = 0, info = z && mu ? hawser__gyroscopic_pairs(mu, z, &found, side->count, side->G,
	                                                         side->omega, side->n)
	                              : LAPACK_WORK_MEMORY_ERROR;
	enum hawser_status status = HAWSER_OK;

	if (!info && count)
		largest = mu[count - 1];
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(report, "modes");
	else if (info || found != side->count || !(largest > 0.0))
		status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                      "the eigenvalue solver met a not-a-number with %d modes of the cable "
		                      "at rest: check EA, rho, d, the speed and the tension of the span",
		                      side->n);
	for (size_t k = 0; k < count && !status; k++) {
		double one = mu[count - 1 - k];

		/* round-off, as in compliance.c */
		side->gyroscopic[k] = one > hawser__eigen_floor((int)order)*largest ? 1.0/one : HUGE_VAL;
		for (size_t j = 0; j < n; j++)
			side->q[k*n + j] = z[(count - 1 - k)*order + j]/side->omega[j];
	}
	free(z);
	free(mu);
	return status;
}

/* Shape and slope [2][points][3] of the k-th mode in the basis. work is D*points. */
static void unfold(double *shape, double *slope, const struct side *side, int k, int points,
                   double *work)
{
	int rows = side->D*points, first = side->plane == HAWSER_OUT_OF_PLANE ? 2 : 0;
	const double *q = (const double *)(side->q + (size_t)k*(size_t)side->n);

	for (int f = 0; f < 4; f++) {
		double *out = (f/2 ? slope : shape) + (f%2)*3*points;

		cblas_dgemv(CblasColMajor, CblasNoTrans, rows, side->n, 1.0,
		            f/2 ? side->gradient : side->field, rows, q + f%2, 2, 0.0, work, 1);
		for (int i = 0; i < rows; i++)
			out[3*(i%points) + first + i/points] = work[i];
	}
}

/* --- one attempt, and adaptation of the basis --- */

static enum hawser_status attempt_solve(struct attempt *t, const struct hawser_statics *st,
                                        int basis,
                                        int n, struct hawser_report *report)
{
	struct hawser_modes resting;
	int elements, p = hawser__cable_split(&elements, st, basis);
	enum hawser_status status = hawser_modes_basis(&resting, st, basis, basis, report);

	*t = (struct attempt){.nu = st->motion.nu};
	if (!status)
		status = hawser__cable_init(&t->cable, st, elements, p, report);
	for (int q = 0; q < HAWSER__PLANES && !status; q++) {
		status = side_init(&t->side[q], &resting, q, n, t->nu, report);
		if (!status)
			status = eigen(&t->side[q], report);
	}
	hawser_modes_clear(&resting);
	return status;
}

/* Mode `place` of the result from mode k of this side, by two steps with the exact operator; the
 * change by the first step estimates the error. */
static void fill(struct hawser_modes *modes, struct side *side, int place, int k,
                 const struct attempt *t, double *work)
{
	struct hawser_mode *mode = modes->mode + place;
	size_t at = (size_t)place*6*(size_t)t->cable.grid.points;
	struct hawser__complex iterate;

	hawser__complex_init(&iterate, &t->cable, side->plane, t->nu, work);
	unfold(modes->shape + at, modes->slope + at, side, k, t->cable.grid.points, iterate.scratch);
	hawser__complex_load(&iterate, modes->shape + at, modes->slope + at);
	iterate.omega = side->gyroscopic[k];
	hawser__complex_step(&iterate);
	mode->residual = hawser__spectral_estimate(fabs(iterate.omega/side->gyroscopic[k] - 1.0),
	                                           t->cable.grid.elements + 1);
	if (hawser__cable_coarse(&t->cable))
		mode->residual = fmax(mode->residual, 1.0);
	hawser__complex_step(&iterate);
	mode->condition = iterate.condition;
	mode->plane = (enum hawser_plane)side->plane;
	mode->omega = iterate.omega;
	hawser__complex_store(&iterate, modes->shape + at, modes->slope + at);
}

/* Refine the n lowest modes of both planes; *worst is the largest error estimate. */
static enum hawser_status collect(double *worst, struct hawser_modes *modes,
                                  struct attempt *t, int n, struct hawser_report *report)
{
	int points = t->cable.grid.points, next[HAWSER__PLANES] = {0};
	double *work = hawser__numbers((size_t)points, HAWSER__COMPLEX_WORK);
	enum hawser_status status;

	hawser_modes_clear(modes);
	modes->gyroscopic = 1;
	status = work ? hawser__modes_allocate(modes, n, points, report)
	              : hawser__no_memory(report, "modes");
	*worst = 0.0;
	for (int k = 0; k < n && !status; k++) {
		struct side *in = &t->side[HAWSER_IN_PLANE], *out = &t->side[HAWSER_OUT_OF_PLANE];
		int q = next[0] == in->count || (next[1] < out->count &&
		                                 out->gyroscopic[next[1]] < in->gyroscopic[next[0]]);

		if (isinf(t->side[q].gyroscopic[next[q]])) {
			status = hawser__eigen_lost(next[q] + 1, q == HAWSER_IN_PLANE, t->side[q].gyroscopic[0],
			                            report);
			break;
		}
		fill(modes, &t->side[q], k, next[q]++, t, work);
		*worst = fmax(*worst, modes->mode[k].residual);
	}
	free(work);
	return status;
}

static enum hawser_status try_basis(double *worst, struct hawser_modes *modes,
                                    const struct hawser_statics *st, int basis, int n,
                                    struct hawser_report *report)
{
	struct attempt t;
	enum hawser_status status = attempt_solve(&t, st, basis, n, report);

	if (!status)
		status = collect(worst, modes, &t, n, report);
	if (!status) {
		modes->grid = t.cable.grid;
		t.cable.grid = (struct hawser_grid){0};
		modes->basis = modes->grid.elements*(modes->grid.order/2) - 1;
	}
	attempt_clear(&t);
	return status;
}

/* The upstream wave of a mode has up to twice the wavenumber of the mode at rest. */
static int first_basis(const struct hawser_statics *st, int n)
{
	int elements = hawser__cable_elements(st);
	double nu = fabs(st->motion.nu), waves = n*(1.0 + nu/sqrt(1.0 + nu*nu));

	return elements*hawser__cable_degree(elements, (int)ceil(waves)) - 1;
}

static enum hawser_status adapt(struct hawser_modes *modes, const struct hawser_statics *st,
                                const struct hawser_modes_options *options,
                                struct hawser_report *report)
{
	int elements = hawser__cable_elements(st), basis = first_basis(st, options->n), tries = 0;
	double worst = HUGE_VAL, before, target;

	if (basis > BASIS_MAX)
		return hawser__spectral_too_many(options->n, basis, BASIS_MAX, report);
	target = hawser__spectral_target(options, elements);
	do {
		enum hawser_status status;

		before = worst;
		status = try_basis(&worst, modes, st, basis, options->n, report);
		if (status || worst <= target)
			return status;
		tries++;
		basis += basis/4 > 4*elements ? basis/4 : 4*elements;
	} while (basis <= BASIS_MAX && hawser__spectral_improves(worst, before));
	if (worst <= options->tolerance)
		return HAWSER_OK;
	return hawser__spectral_unsettled(options, worst, modes->basis, tries, report);
}

static enum hawser_status fixed(struct hawser_modes *modes, const struct hawser_statics *st,
                                const struct hawser_modes_options *options,
                                struct hawser_report *report)
{
	int elements, p = hawser__cable_split(&elements, st, options->basis);
	double worst;

	if (options->basis > BASIS_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a basis of %d functions a component is more than the %d that "
		                    "this method takes: lower model.basis", options->basis, BASIS_MAX);
	if (options->n > 3*(p*elements - 1))
		return hawser__spectral_too_few(options->n, p*elements - 1, report);
	return try_basis(&worst, modes, st, options->basis, options->n, report);
}

enum hawser_status hawser__gyroscopic_solve(struct hawser_modes *modes,
                                            const struct hawser_statics *statics,
                                            const struct hawser_modes_options *options,
                                            struct hawser_report *report)
{
	enum hawser_status status;

	if (statics->motion.nu == 0.0)
		return hawser__gyroscopic_at_rest(modes, statics, options, "spectral", report);
	status = options->basis > 0 ? fixed(modes, statics, options, report)
	                            : adapt(modes, statics, options, report);

	modes->statics = *statics;
	return status ? status : hawser__modes_label(modes, report);
}
