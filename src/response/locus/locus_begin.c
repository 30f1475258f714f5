/* response/locus/locus_begin.c - the first point of a locus, from an event of a response.
 *
 * The orbits before and after the event are known by their states. Fourier coefficients follow from an
 * integration over a period, an orbit between them by Newton's method in the plane normal to their
 * chord, the null vectors by inverse iteration from arbitrary borders, and the bifurcation by Newton's
 * method at the parameter of the response.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/time/flow.h"
#include "response/locus/locus_walk.h"
#include "response/orbit/shooting.h"

#define ELSEWHERE 1e-3 /* distance in Omega at which the bifurcation found is another one, relative to
                        * the range; chosen, far above the errors of events */
#define SKEW 1e-6      /* relative size of what is absent by symmetry; chosen */
#define MIXED 1e-3     /* the same before the branch point is known exactly; chosen */
enum { FIRST_ORDER = 12, ITERATIONS = 12, INVERSE = 4 };

enum hawser_status hawser__locus_orbit_through(struct hawser__locus_walk *walk, double *z,
                                               const double *x, double first)
{
	struct hawser__locus *locus = walk->locus;
	int n = locus->n, H = locus->order, rows;
	struct hawser__stretch period;
	struct hawser__flow flow;
	double *samples, *end;
	enum hawser_status status = hawser__locus_place(locus, first, walk->options->at);

	if (status)
		return status;
	rows = hawser__shooting_steps(locus->rom, locus->omega, 1);
	rows = rows < 6*H ? 6*H : rows;
	period = (struct hawser__stretch){.h = 2.0*M_PI/rows, .steps = rows, .count = 1};
	samples = malloc((size_t)rows*n*sizeof *samples);
	end = malloc(2*(size_t)n*sizeof *end);
	status = hawser__flow_init(&flow, locus->rom, walk->report);
	if (!status && (!samples || !end))
		status = hawser__no_memory(walk->report, "locus");
	if (!status) {
		memcpy(end, x, 2*(size_t)n*sizeof *end);
		hawser__flow_map(&flow, end, samples, &period, locus->omega);
		memset(z, 0, (size_t)walk->room*sizeof *z);
		for (int r = 0; r < rows; r++)
			for (int k = 0; k < 2*H + 1; k++) {
				double tau = 2.0*M_PI*((double)((long)r*((k + 1)/2)%rows)/rows);
				double s = (k ? 2.0 : 1.0)/rows*(k%2 || !k ? cos(tau) : sin(tau));

				for (int j = 0; j < n; j++)
					z[LOCUS_FIRST + k*n + j] += s*(samples[(size_t)r*n + j] -
					                               (end[j] - x[j])*r/rows);
			}
		z[LOCUS_OMEGA] = first;
	}
	hawser__flow_clear(&flow);
	free(samples);
	free(end);
	return status;
}

/* Newton's method for F = 0 in the plane through z normal to `chord` [size], at fixed parameter. */
static enum hawser_status settle(struct hawser__locus_walk *walk, double *z, const double *chord,
                                 int *failed)
{
	struct hawser__locus *locus = walk->locus;
	int P = locus->coefficients, row = P + 1;

	*failed = 1;
	for (int i = 0; i < ITERATIONS; i++) {
		double residual, length, size;
		enum hawser_status status;

		hawser__locus_borders(locus);
		status = hawser__locus_evaluate(locus, &residual, z);
		if (status || !isfinite(residual))
			return status;
		for (int j = 0; j < P; j++) {
			memcpy(locus->M + (size_t)j*row, locus->J + (size_t)j*P, (size_t)P*sizeof(double));
			locus->M[(size_t)j*row + P] = chord[LOCUS_FIRST + j];
			locus->M[(size_t)P*row + j] = locus->by[0][j];
			locus->rhs[j] = -locus->F[j];
		}
		locus->M[(size_t)P*row + P] = chord[LOCUS_OMEGA];
		locus->rhs[P] = 0.0;
		if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, row, 1, locus->M, row, locus->pivot, locus->rhs, row))
			return HAWSER_OK;
		cblas_daxpy(P, 1.0, locus->rhs, 1, z + LOCUS_FIRST, 1);
		z[LOCUS_OMEGA] += locus->rhs[P];
		length = cblas_dnrm2(P, locus->rhs, 1);
		size = cblas_dnrm2(P, z + LOCUS_FIRST, 1);
		if (!isfinite(length) || length > 10.0*size)
			return HAWSER_OK;
		if (length <= 1e-8*size || size <= 1e-12) {
			*failed = 0;
			return HAWSER_OK;
		}
	}
	return HAWSER_OK;
}

/* kappa of the pair of multipliers that is nearest to the unit circle. */
static enum hawser_status angle_of(struct hawser__locus *locus, double *kappa, int *failed)
{
	enum hawser_status status = hawser__locus_multipliers(locus);
	double best = INFINITY;

	*failed = 1;
	for (int i = 0; !status && i < 2*locus->n; i++) {
		double angle = locus->argument[i];

		if (angle > 0.0 && angle < M_PI && fabs(locus->log_modulus[i]) < best) {
			best = fabs(locus->log_modulus[i]);
			*kappa = angle/(2.0*M_PI);
			*failed = 0;
		}
	}
	return status;
}

/* Null vectors of the orbit start->z. */
static enum hawser_status null_vectors(struct hawser__locus_walk *walk, int *failed)
{
	struct hawser__locus *locus = walk->locus;
	double *z = walk->start.z, residual;
	enum hawser_status status;

	*failed = 1;
	hawser__locus_borders(locus);
	z[LOCUS_KAPPA] = locus->kind == HAWSER_PERIOD_DOUBLING ? 0.5 : 0.0;
	if (locus->kind == HAWSER_TORUS) {
		z[LOCUS_KAPPA] = 0.3;
		status = hawser__locus_evaluate(locus, &residual, z);
		if (status || !isfinite(residual))
			return status;
		if ((status = angle_of(locus, &z[LOCUS_KAPPA], failed)) || *failed)
			return status;
		*failed = 1;
	}
	for (int k = 0; k < INVERSE; k++) {
		status = hawser__locus_evaluate(locus, &residual, z);
		if (status || !isfinite(residual))
			return status;
		hawser__locus_update(locus);
	}
	*failed = 0;
	return HAWSER_OK;
}

/* Bar the kinds of coefficients that v has rather than the orbit, and set those of the orbit to
 * zero: near a branch point an orbit is determined badly in the direction of v. Returns 1 where
 * both have the same kinds: v then does not break a symmetry. */
static int bar(struct hawser__locus *locus, double *z)
{
	int n = locus->n, overlap = 0;
	double *own = locus->rhs, all = cblas_dnrm2(locus->coefficients, z + LOCUS_FIRST, 1);
	double *of_v = own + 2*n;

	memset(own, 0, 4*(size_t)n*sizeof *own);
	for (int k = 0; k < locus->wide; k++) { /* c has length 1 */
		int kind = 2*(k%n) + abs(locus->low + k/n)%2;

		of_v[kind] = fmax(of_v[kind], cabs(locus->c[k]));
	}
	for (int i = 0; i < locus->coefficients && all > 0.0; i++) {
		int kind = 2*(i%n) + (i/n + 1)/2%2;

		own[kind] = fmax(own[kind], fabs(z[LOCUS_FIRST + i])/all);
	}
	for (int kind = 0; kind < 2*n; kind++) {
		locus->barred[kind] = of_v[kind] > own[kind] && of_v[kind] > SKEW;
		overlap |= fmin(of_v[kind], own[kind]) > MIXED;
	}
	for (int i = 0; i < locus->coefficients; i++)
		z[LOCUS_FIRST + i] *= !hawser__locus_is_barred(locus, i);
	return overlap;
}

/* Whether what is barred needs no force: the orbit without it solves all equations. */
static int is_symmetric(const struct hawser__locus *locus)
{
	double barred = 0.0, forces = 0.0;

	for (int i = 0; i < locus->coefficients; i++) {
		const double *row = locus->J + i;
		double size = 0.0;

		for (int j = 0; j < locus->coefficients; j++)
			size = fmax(size, fabs(row[(size_t)j*(size_t)locus->coefficients]));
		forces = fmax(forces, size);
		if (hawser__locus_is_barred(locus, i))
			barred = fmax(barred, fabs(locus->F[i]));
	}
	return barred <= SKEW*forces;
}

static enum hawser_status between(struct hawser__locus_walk *walk, const struct hawser_frf *frf,
                                  const struct hawser_frf_event *event, int *failed)
{
	const struct hawser_frf_point *a = &frf->point[event->after], *b = a + 1;
	const double *xa = frf->state + 2*(size_t)frf->n*event->after, *xb = xa + 2*(size_t)frf->n;
	const double *x = frf->event_state + 2*(size_t)frf->n*(event - frf->event);
	double *from = walk->here.z, *to = walk->next.z, *z = walk->start.z, *chord = walk->spare;
	double part = (event->arc - a->arc)/(b->arc - a->arc), range = walk->locus->extent[0], size;
	enum hawser_status status = hawser__locus_orbit_through(walk, from, xa, a->parameter);

	*failed = 1;
	if (status || (status = hawser__locus_orbit_through(walk, to, xb, b->parameter)))
		return status;
	part = part >= 0.0 && part <= 1.0 ? part : 0.5;
	for (int k = 0; k < walk->room; k++) {
		z[k] = from[k] + part*(to[k] - from[k]);
		chord[k] = to[k] - from[k];
	}
	if (cblas_dnrm2(walk->locus->coefficients, z + LOCUS_FIRST, 1) <= 1e-12) {
		memset(z, 0, (size_t)walk->room*sizeof *z);
		z[LOCUS_OMEGA] = event->parameter;
	}
	chord[LOCUS_OMEGA] /= range*range;
	size = cblas_dnrm2(walk->locus->coefficients, z + LOCUS_FIRST, 1);
	if (size > 0.0)
		cblas_dscal(walk->locus->coefficients, 1.0/(size*size), chord + LOCUS_FIRST, 1);
	if (isfinite(x[0]) && (status = hawser__locus_orbit_through(walk, z, x, event->parameter)))
		return status;
	z[LOCUS_PARAMETER] = walk->options->at;
	memcpy(walk->here.z, z, (size_t)walk->room*sizeof *z);
	status = settle(walk, z, chord, failed);
	/* the matrix is singular there */
	if (!status && *failed && walk->locus->kind == HAWSER_BRANCH_POINT) {
		memcpy(z, walk->here.z, (size_t)walk->room*sizeof *z);
		*failed = 0;
	}
	if (cblas_dnrm2(walk->locus->coefficients, z + LOCUS_FIRST, 1) <= 1e-12)
		memset(z + LOCUS_FIRST, 0, (size_t)walk->locus->coefficients*sizeof *z);
	return status;
}

static int first_order(const struct hawser__locus *locus)
{
	int order = FIRST_ORDER < locus->most ? FIRST_ORDER : locus->most;

	for (int p = 0; p < locus->rom->harmonics; p++)
		order = locus->rom->harmonic[p].k + 4 > order ? locus->rom->harmonic[p].k + 4 : order;
	return order;
}

enum hawser_status hawser__locus_first_order(struct hawser__locus *locus)
{
	return hawser__locus_arrange(locus, first_order(locus));
}

enum hawser_status hawser__locus_begin(struct hawser__locus_walk *walk, const struct hawser_frf *frf,
                                       int event, int *failed)
{
	struct hawser__locus *locus = walk->locus;
	const struct hawser_frf_event *from = &frf->event[event];
	struct hawser__locus_station *start = &walk->start;
	double elsewhere = ELSEWHERE*locus->extent[0];
	enum hawser_status status;

	*failed = 1;
	if (first_order(locus) > locus->most || from->after < 0 || from->after + 1 >= frf->points)
		return HAWSER_OK;
	walk->reference[0] = walk->reference[1] = 0.0;
	memset(locus->barred, 0, 2*(size_t)locus->n);
	if ((status = hawser__locus_first_order(locus)) ||
	    (status = hawser__locus_place(locus, from->parameter, walk->options->at)))
		return status;
	if ((status = between(walk, frf, from, failed)) || *failed)
		return status;
	if (locus->kind == HAWSER_RESONANCE) /* `from` is interpolated */
		elsewhere = fmax(elsewhere, fabs(from[0].bracket[1] - from[0].bracket[0]));
	else if ((status = null_vectors(walk, failed)) || *failed)
		return status;
	*failed = 1;
	if (locus->kind == HAWSER_BRANCH_POINT && bar(locus, start->z))
		return HAWSER_OK;
	memset(walk->spare, 0, (size_t)walk->room*sizeof(double));
	walk->spare[LOCUS_PARAMETER] = 1.0;
	if ((status = hawser__locus_correct(walk, start, walk->spare, failed)) || *failed)
		return status;
	*failed = fabs(start->z[LOCUS_OMEGA] - from->parameter) > elsewhere || !is_symmetric(locus);
	if (*failed)
		return HAWSER_OK;
	start->arc = 0.0;
	hawser__locus_update(locus);
	status = hawser__locus_evaluate(locus, &start->correction.residual, start->z);
	memset(walk->spare, 0, (size_t)walk->room*sizeof(double));
	walk->spare[LOCUS_PARAMETER] = locus->extent[1];
	return status ? status : hawser__locus_finish(walk, start, walk->spare);
}
