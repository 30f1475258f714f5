/* modes/halving.c - modes by a finite-difference scheme on N intervals, with an error estimate from
 * about N/2 intervals (Richardson).
 *
 *   N, M    intervals of the result and of the coarser grid
 *   moved   |omega_N - omega_M|/omega_N
 *   turn    largest rotation of the tangent over one interval of the coarser grid, rad
 *
 *   lift    relative increase of omega_N^2 of an in-plane mode by a spurious stiffness
 *
 * If the error is c/N^2, `moved` is (N/M)^2 - 1 times the error of omega_N. The error estimate is
 * three times the error that follows from this, plus the residual of the eigensolver, plus |Im
 * mu/Re mu| if an unsymmetric scheme has split a double frequency into a complex pair. If `turn`
 * exceeds half a radian, the coarse grid does not resolve the profile, the Richardson estimate is
 * invalid, and the error estimate is set to 1.
 *
 * A scheme that divides differences of displacements by epsilon has a second error in the plane.
 * Where u' = kappa v, the differences u'' (three points) and kappa v', kappa' v (central) do not
 * cancel; the remainder acts as a spurious stiffness of kappa^2 h^2/(4 epsilon) relative to that of
 * the string. It raises omega^2 in proportion to 1/N^2, also where it is not small: for in-plane
 * modes the two grids give the lift of omega_N^2, and not the error of omega_N, as c/N^2. If it
 * exceeds one half, in-plane modes may be missing from the list of the lowest ones, on both grids,
 * and the error estimate of every mode is set to 1. Out-of-plane modes have no such error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/cable.h"
#include "modes/halving.h"
#include "modes/label.h"

enum { INTERVALS_MAX = 1 << 15, MODES_MAX = 200, STENCIL = 6 };
static const double safety = 3.0;
static const double turn_max = 0.5;
static const double lift_max = 0.5;
static const double round_off = 1e-14;
/* An estimate below this value that is not halved by the next grid is dominated by round-off. */
static const double stalled = 1e-2;

struct level {
	int N;
	struct hawser__ritz ritz[HAWSER__PLANES];
};

static void level_clear(struct level *t)
{
	for (int q = 0; q < HAWSER__PLANES; q++)
		hawser__ritz_clear(&t->ritz[q]);
	*t = (struct level){0};
}

static enum hawser_status level_solve(struct level *t, const struct hawser__scheme *scheme,
                                      const struct hawser_statics *statics, int N, int n,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*t = (struct level){.N = N};
	for (int q = 0; q < HAWSER__PLANES && !status; q++)
		status = scheme->solve(&t->ritz[q], statics, (enum hawser_plane)q, N, n, report);
	return status;
}

/* Select the n lowest modes of both planes: place[k] is plane + 2*index, or -1 if the k-th mode has
 * no positive 1/omega^2. */
static int share_out(int *place, const struct level *t, int n)
{
	int next[HAWSER__PLANES] = {0};

	for (int k = 0; k < n; k++) {
		double mu[HAWSER__PLANES];
		int q;

		for (q = 0; q < HAWSER__PLANES; q++)
			mu[q] = next[q] < t->ritz[q].count ? t->ritz[q].re[next[q]] : -1.0;
		q = mu[1] > mu[0];
		if (!(mu[q] > 0.0))
			return -1;
		place[k] = q + 2*next[q]++;
	}
	return 0;
}

/* `turn` for M intervals. The curvature is largest at the lowest point or at the end nearest to
 * it. */
static double turn_of(const struct hawser_statics *st, int M)
{
	double first = st->eta, last = st->eta + st->delta*st->l;
	double u = first > 0.0 ? first : last < 0.0 ? last : 0.0;

	return st->delta/(1.0 + u*u)*st->l/M;
}

int hawser__unresolved(const struct hawser_statics *st, int M, int displacements)
{
	double turn = turn_of(st, M);

	return turn > turn_max || (displacements && turn*turn > st->epsilon);
}

/* The largest that a scheme of displacements makes on N intervals. */
static double lift_of(const struct hawser_statics *st, int N)
{
	double turn = turn_of(st, N);

	return 0.25*turn*turn/st->epsilon;
}

/* Relative error of omega_N, where q = omega_M^2/omega_N^2, both lifted in proportion to 1/N^2:
 * q = (1 + lift ratio^2)/(1 + lift). */
static double lifted(double q, double ratio, double least)
{
	double room = ratio*ratio - q, lift = room > 0.0 ? safety*(q - 1.0)/room : HUGE_VAL;

	return fmin(sqrt(1.0 + fmax(lift, least)) - 1.0, 1.0);
}

static double estimate(const struct level *fine, const struct level *coarse, int place,
                       const struct hawser_statics *st, const struct hawser__scheme *scheme)
{
	const struct hawser__ritz *r = &fine->ritz[place%2], *c = &coarse->ritz[place%2];
	double ratio = (double)fine->N/coarse->N, lift = scheme->displacements ? lift_of(st, fine->N) : 0.0;
	double moved;
	int k = place/2;

	if (k >= c->count || !(c->re[k] > 0.0) || turn_of(st, coarse->N) > turn_max || lift > lift_max)
		return 1.0;
	moved = safety*fabs(1.0 - sqrt(r->re[k]/c->re[k]))/(ratio*ratio - 1.0);
	if (lift > 0.0 && place%2 == HAWSER_IN_PLANE)
		moved = fmax(moved, lifted(r->re[k]/c->re[k], ratio, lift));
	return moved + r->miss[k] + fabs(r->im[k]/r->re[k]) + round_off;
}

double hawser__six_points(double *derivative, const double *value, int last, int stride, double t)
{
	int points = last + 1 < STENCIL ? last + 1 : STENCIL, first = (int)floor(t) - points/2 + 1;
	double sum = 0.0;

	first = first < 0 ? 0 : first > last + 1 - points ? last + 1 - points : first;
	*derivative = 0.0;
	for (int i = 0; i < points; i++) {
		double v = value[(first + i)*stride], basis = 1.0, slope = 0.0;

		for (int j = 0; j < points; j++)
			if (j != i) {
				slope = (slope*(t - first - j) + basis)/(i - j);
				basis *= (t - first - j)/(i - j);
			}
		sum += v*basis;
		*derivative += v*slope;
	}
	return sum;
}

/* Grid, shapes and labels of the accepted level. */
static enum hawser_status finish(struct hawser_modes *modes, const struct level *fine,
                                 const struct level *coarse, const int *place, int n,
                                 const struct hawser__scheme *scheme,
                                 struct hawser_report *report)
{
	int elements = hawser__cable_elements(&modes->statics);
	struct hawser__cable cable;
	enum hawser_status status = hawser__cable_init(&cable, &modes->statics, elements,
	                                               hawser__cable_degree(elements, n), report);

	if (!status) {
		modes->grid = cable.grid;
		cable.grid = (struct hawser_grid){0};
		status = hawser__modes_allocate(modes, n, modes->grid.points, report);
	}
	for (int k = 0; k < n && !status; k++) {
		const struct hawser__ritz *ritz = &fine->ritz[place[k]%2];
		size_t skip = (size_t)k*3*(size_t)modes->grid.points, j = (size_t)(place[k]/2);

		modes->mode[k].plane = (enum hawser_plane)(place[k]%2);
		modes->mode[k].omega = 1.0/sqrt(ritz->re[j]);
		modes->mode[k].residual = estimate(fine, coarse, place[k], &modes->statics,
		                                   scheme);
		status = scheme->sample(modes->shape + skip, modes->slope + skip, &modes->grid,
		                        ritz->x + j*(size_t)ritz->size, &modes->statics,
		                        modes->mode[k].plane, fine->N, report);
	}
	hawser__cable_clear(&cable);
	modes->basis = fine->N - 1;
	return status ? status : hawser__modes_label(modes, report);
}

/* Choose the first N; fail if the number of modes and the basis are incompatible. */
static enum hawser_status plan(int *N, const struct hawser_modes_options *options,
                               struct hawser_report *report)
{
	int n = options->n;

	*N = options->basis > 0 ? options->basis + 1 : 32 + 8*n;
	if (n > MODES_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d modes asked, where finite differences give %d at most: ask "
		                    "for fewer, or take the method spectral", n, MODES_MAX);
	if (options->basis >= INTERVALS_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a basis of %d points is more than the %d that this method "
		                    "takes: lower model.basis", options->basis, INTERVALS_MAX - 1);
	if (n > 3*(*N/2 - 1))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d modes asked of a basis of %d points, which is compared with "
		                    "one of %d that carries %d: ask for fewer modes, or raise "
		                    "model.basis to %d or more", n, *N - 1, *N/2 - 1, 3*(*N/2 - 1),
		                    n + 4);
	return HAWSER_OK;
}

/* Refine until the largest error estimate of the n modes meets the tolerance. If the basis is
 * given, solve on that grid and on the coarser one only. */
static enum hawser_status converge(struct level *fine, struct level *coarse, int *place,
                                   const struct hawser_statics *statics,
                                   const struct hawser_modes_options *options,
                                   const struct hawser__scheme *scheme, int N,
                                   struct hawser_report *report)
{
	enum hawser_status status = level_solve(coarse, scheme, statics, N/2, options->n, report);
	double worst = HUGE_VAL, before, best = HUGE_VAL;
	int n = options->n, tries = 0, bad = 0;

	for (; !status; N *= 2) {
		status = level_solve(fine, scheme, statics, N, n, report);
		if (status)
			return status;
		bad = share_out(place, fine, n);
		before = worst;
		worst = bad ? HUGE_VAL : 0.0;
		for (int k = 0; k < n && !bad; k++)
			worst = fmax(worst, estimate(fine, coarse, place[k], statics, scheme));
		best = fmin(best, worst);
		tries++;
		if (!bad && (options->basis > 0 || worst <= options->tolerance))
			return HAWSER_OK;
		if (options->basis > 0 || 2*N > INTERVALS_MAX || (before < stalled && worst > 0.5*before))
			break;
		level_clear(coarse);
		*coarse = *fine;
		*fine = (struct level){0};
	}
	if (status)
		return status;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", tries, best,
	                       "the first %d frequencies have an estimated relative error of %.1e "
	                       "at best where %.1e was asked, on grids of up to %d points (%d are "
	                       "the most)%s: ask for fewer modes or a larger tolerance, or take "
	                       "the method spectral", n, best, options->tolerance, fine->N - 1,
	                       INTERVALS_MAX - 1, bad ? "; the last has frequencies that are not real"
	                       : worst > before ? "; round-off lets it get no better" : "");
}

enum hawser_status hawser__halving_solve(struct hawser_modes *modes,
                                         const struct hawser_statics *statics,
                                         const struct hawser_modes_options *options,
                                         const struct hawser__scheme *scheme,
                                         struct hawser_report *report)
{
	struct level fine = {0}, coarse = {0};
	int N, *place = NULL;
	enum hawser_status status = plan(&N, options, report);

	if (status)
		return status;
	place = malloc((size_t)options->n*sizeof *place);
	if (!place)
		return hawser__no_memory(report, "modes");
	status = converge(&fine, &coarse, place, statics, options, scheme, N, report);
	if (!status)
		status = finish(modes, &fine, &coarse, place, options->n, scheme, report);
	level_clear(&fine);
	level_clear(&coarse);
	free(place);
	return status;
}
