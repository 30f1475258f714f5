/* response/locus/own_tests.c - what changes its sign at special points of the loci of autonomous
 * models.
 *
 *    mu       multipliers of the cycle without those that are 1 along the motion (return_map.h); of
 *             an equilibrium exp(x/r), with the eigenvalues x and the largest modulus r of them
 *    passage  the product of mu - 1 over all but the critical ones changes its sign where a real one
 *             passes 1, and not where two real ones become a pair; as mu + 1 for -1, and mu_i mu_j - 1
 *             over all i < j for a pair on the unit circle. Only the sign is that of the product; the
 *             value is the least factor
 *
 * Two real multipliers whose product is 1 change the sign of the last one too: there is no special
 * point, and no pair near the circle.
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., section 10.2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/branch/return_map.h"
#include "response/locus/locus_own.h"

#define OUTSIDE 1e-7 /* of a modulus that counts as unstable, beyond 1 */
#define BESIDE 0.5   /* distance of a critical multiplier from 1 or -1 that is elsewhere; chosen */
#define AMPLITUDE 0.01 /* of the motion, for differences: errors 1e-9 by round-off; chosen */
#define NEAR_END 1e-3 /* of sin(angle) at 1:1 and 1:2, where a pair is nearly double; chosen */

/* --- tests from multipliers --- */

struct multipliers {
	const double complex *mu;
	int count, critical[2]; /* the same twice where there is one */
};

static int is_critical(const struct multipliers *of, int i)
{
	return i == of->critical[0] || i == of->critical[1];
}

/* Of 1 or -1. Beside a double multiplier the critical one has its error, which is taken off. */
static double passage(const struct multipliers *of, double target)
{
	double complex sign = 1.0, own = of->mu[of->critical[0]] - target;
	double least = INFINITY;

	if (cabs(own) > BESIDE || of->critical[0] != of->critical[1])
		own = 0.0;
	for (int i = 0; i < of->count; i++) {
		double complex factor = of->mu[i] - target;

		if (is_critical(of, i))
			continue;
		if (factor != 0.0)
			sign *= factor/cabs(factor);
		least = fmin(least, cabs(factor + own));
	}
	return least < INFINITY ? copysign(least, creal(sign)) : NAN;
}

/* *beside: how far the pair next to the unit circle is from it. */
static double pairs(const struct multipliers *of, double *beside)
{
	double complex sign = 1.0;
	double least = INFINITY;

	*beside = INFINITY;
	for (int i = 0; i < of->count; i++)
		for (int j = i + 1; j < of->count; j++) {
			double complex factor = of->mu[i]*of->mu[j] - 1.0;

			if (is_critical(of, i) || is_critical(of, j))
				continue;
			if (factor != 0.0)
				sign *= factor/cabs(factor);
			least = fmin(least, cabs(factor));
			if (cimag(of->mu[i]) != 0.0 && of->mu[j] == conj(of->mu[i]))
				*beside = fmin(*beside, cabs(factor));
		}
	return least < INFINITY ? copysign(least, creal(sign)) : NAN;
}

static void set_tests(struct hawser__own_spot *spot, const struct multipliers *of, int cycle)
{
	spot->unstable = 0;
	for (int i = 0; i < of->count; i++)
		spot->unstable += !is_critical(of, i) && cabs(of->mu[i]) > 1.0 + OUTSIDE;
	spot->test[HAWSER__OWN_ONE] = passage(of, 1.0);
	spot->test[HAWSER__OWN_MINUS] = cycle ? passage(of, -1.0) : NAN;
	spot->test[HAWSER__OWN_PAIR] = pairs(of, &spot->beside_pair);
}

/* The one next to `target`, and its conjugate or the same. */
static void choose_critical(struct multipliers *of, double complex target)
{
	int best = 0;

	for (int i = 1; i < of->count; i++)
		if (cabs(of->mu[i] - target) < cabs(of->mu[best] - target))
			best = i;
	of->critical[0] = of->critical[1] = best;
	for (int i = 0; i < of->count && cimag(target) != 0.0; i++)
		if (i != best && of->mu[i] == conj(of->mu[best]))
			of->critical[1] = i;
}

/* The pair next to the unit circle, and to the angle if it is known. */
static void choose_pair(struct multipliers *of, double angle)
{
	double least = INFINITY;

	for (int i = 0; i < of->count; i++) {
		double away = hypot(log(cabs(of->mu[i])), angle > 0.0 ? carg(of->mu[i]) - angle : 0.0);

		if (cimag(of->mu[i]) > 0.0 && away < least) {
			least = away;
			choose_critical(of, of->mu[i]);
		}
	}
}

/* --- equilibria --- */

enum hawser_status hawser__own_judge_rest(struct hawser__own_spot *spot, const struct hawser_rom *rom,
                                          struct hawser_report *report)
{
	size_t m = 2*(size_t)rom->n, n = (size_t)rom->n;
	double *memory = calloc(2*m*m + 5*m, sizeof *memory), *A = memory, *by_u = hawser__behind(A, m*m);
	double *work = hawser__behind(by_u, m*m), *re = hawser__behind(work, 3*m);
	double *im = hawser__behind(re, m), rate = 0.0, unused;
	double complex *mu = calloc(m, sizeof *mu);
	struct multipliers of = {.mu = mu};
	int info = LAPACK_WORK_MEMORY_ERROR;

	if (memory && mu) {
		of.count = hawser__autonomous_matrix(A, by_u, by_u + n*n, work, rom, spot->state,
		                                     spot->state + n);
		info = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', of.count, A, of.count, re, im, &unused, 1,
		                     &unused, 1);
	}
	for (int i = 0; !info && i < of.count; i++)
		rate = fmax(rate, hypot(re[i], im[i]));
	for (int i = 0; !info && i < of.count; i++)
		mu[i] = exp(re[i]/rate)*(cos(im[i]/rate) + I*sin(im[i]/rate));
	if (!info) {
		choose_critical(&of, cexp(I*(spot->omega/rate)));
		set_tests(spot, &of, 0);
	}
	free(memory);
	free(mu);
	return hawser__lapack_starved(info) ? hawser__no_memory(report, "locus") : HAWSER_OK;
}

/* --- limit cycles --- */

enum hawser_status hawser__own_judge_cycle(struct hawser__own_spot *spot, const struct hawser_rom *rom,
                                           const struct hawser__own_line *line,
                                           struct hawser_report *report)
{
	enum hawser_event_kind kind = line->kind;
	struct hawser__return section;
	struct multipliers of;
	enum hawser_status status = hawser__return_open(&section, rom, spot->state, spot->omega, 1,
	                                                line->steps, report);

	if (!status) {
		of = (struct multipliers){.mu = section.mu, .count = section.size};
		choose_critical(&of, kind == HAWSER_PERIOD_DOUBLING ? -1.0 : 1.0);
		if (kind == HAWSER_TORUS) {
			choose_pair(&of, fabs(remainder(spot->angle, 2.0*M_PI)));
			if (spot->angle == 0.0)
				spot->angle = fabs(carg(of.mu[of.critical[0]]));
			spot->test[HAWSER__OWN_THIRD] = cos(spot->angle) + 0.5;
			spot->test[HAWSER__OWN_QUARTER] = cos(spot->angle);
		}
		set_tests(spot, &of, 1);
		if (kind == HAWSER_PERIOD_DOUBLING ||
		    (kind == HAWSER_TORUS && fabs(sin(spot->angle)) > NEAR_END))
			status = hawser__return_form(&section, &spot->test[HAWSER__OWN_DEGENERATE],
			                             of.critical[0], kind, AMPLITUDE*section.extent, report);
	}
	hawser__return_close(&section);
	return status;
}
