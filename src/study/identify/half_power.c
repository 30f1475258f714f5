/* study/identify/half_power.c - damping from half-power points (hawser/decay.h).
 *
 *    xi, w0      damping ratio and undamped frequency; a = f/|w0^2 - w^2 + 2 i xi w0 w|
 *    z, y        omega^2 and 1/a^2: y is of second degree in z
 *    zp, m, D    y = m (1 + (z - zp)^2/D^2): m at the peak, 2 m at the half-power points zp -+ D
 *    p, x, h     y = p0 + p1 x + p2 x^2 with x = (z - zc)/h, zc and h of the points that are fitted
 *    R           triangular factor of the fit's equations, with their right side as a last column
 *    q           unknowns of two modes, relative to the parabola's wp and xi: w1, w2 = wp (1 + xi (q0
 *                -+ q1)), ratio xi exp(q2), g1 and g2 = q3 and q4 times 2 xi wp^2 a at the peak
 *
 * zp = w0^2 (1 - 2 xi^2) and D = 2 xi sqrt(1 - xi^2) w0^2, so that D/zp = tan(2 asin xi).
 *
 * A parabola is fitted to the points from the last one below zp - D to the first one above zp + D,
 * at least FEWEST. The peak and the half-power points are those of the parabola, not of the largest
 * sample, which is below the peak. The fit minimises the differences of amplitudes, (P(z) - y)
 * a^3/2, since the noise of measured amplitudes does not depend on their size.
 *
 * The stated error is the larger of two. The first is the confidence interval of the fit, from the
 * scatter of the points or, if that is larger, from round-off. The second is the difference from
 * another fit: to the points down to half of the peak or, if the table has no more points, to all
 * but the outer points. If other modes or a nonlinear response make 1/a^2 deviate smoothly from a
 * parabola, only the second shows it.
 *
 * Two modes within each other's width look like a single one with more damping or, where their parts
 * have different signs, with less. The points down to half of the peak are therefore fitted twice more:
 * by the sum of two modes of one ratio, exactly,
 *
 *      H = g1/(w1^2 - w^2 + 2 i xi w1 w) + g2/(w2^2 - w^2 + 2 i xi w2 w),    a = |H|
 *
 * again with a ratio each, and smoothly: by a parabola with x^3, x^4 and a^2 x. Modes farther away
 * contribute to the powers, and a peak that bends, y = m (1 + (z - zp - b a^2)^2/D^2), to a^2 x.
 * If a sum is the better one, and its ratio differs from the first by more than its own confidence
 * interval, it is taken, with the difference as its error.
 *
 * Points that scatter at random about any smooth curve have noise, which says how large residuals
 * are. All of them down to a fifth of the peak are fitted then, by one mode and by pairs of two
 * ratios, whose parts the flanks tell apart better than the peak does. If a pair fits better, the
 * interval is that of both ratios at once. Otherwise it contains the ratios of all pairs of one ratio
 * whose sum fits as well as one mode. Pairs of two ratios are left out then: a part of any ratio that
 * is small enough is below any noise, and even two equal parts whose ratios differ by a tenth are
 * below one of 0.1 %. What contains them, down to a part of a tenth, is a number of its own, pair_error
 * (hawser__half_hidden): for 240 single modes with noise of 0.1 to 3 % 0.6 of the ratio.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <gsl/gsl_cdf.h>

#include <hawser/decay.h>

#include "core/report.h"
#include "study/identify/half_power.h"

/* P: unknowns of the parabola. FEWEST: points of a fit, so that two degrees of freedom remain for
 * the estimate of the scatter. */
enum { P = HAWSER__HALF_PARABOLA, FEWEST = 5, ITERATIONS = 20 };
/* LEAST_OF_TWO: points of a fit of two modes; MANY: of which their scatter is an estimate. */
enum { EQUAL = HAWSER__HALF_EQUAL, SHAPES = HAWSER__HALF_SHAPES, MOST = HAWSER__HALF_MOST,
       LEAST_OF_TWO = HAWSER__HALF_SHAPES + FEWEST - P, MANY = 20 };

static const char where[] = "half-power";

/* Largest error relative to the ratio: with a larger one no digit of the ratio is known; chosen. */
static const double too_far = 0.1;

/* Confidence with which a pair has to fit better than one mode, and where there is noise, so that
 * fewer pairs are taken for one; chosen. */
static const double SURE = 0.99, LIKELY = 0.9;

/* Scatter of one mode relative to its peak, that of amplitudes with 11 digits; chosen. */
static const double EXACT = 1e-11;

/* Scatter of two modes relative to that of a smooth deviation: above it, that explains the points as
 * well; above its inverse it explains them alone; chosen. */
static const double CLEARLY = 0.1;

/* Scatter of one mode that is slight: every response bends a little, and other modes follow the load;
 * chosen. */
static const double SLIGHT = 1e-3;

/* Half the distance of two modes with two ratios over half the width of the peak: a mode farther away
 * has no part in its ratio; chosen. */
static const double WIDE = 2.0;

/* Factor on the difference of the two ratios: it exceeds the error of both for a peak that bends by
 * up to 2 %, since the ratio refers to a frequency that the bend changes. */
static const double MARGIN = 1.1;

/* Correlation of neighbours below which residuals are noise, and how far points with noise are fitted,
 * in half the width of the peak: down to a fifth of it; chosen. */
static const double WHITE = 0.3, FAR = 4.9;

static double square(double x)
{
	return x*x;
}

/* --- one fit, and its points --- */

static int fit_span(struct hawser__half_fit *fit, const struct hawser__half_table *table,
                    struct hawser__half_span span)
{
	double z0 = square(table->omega[span.first]), z1 = square(table->omega[span.last]);

	return hawser__half_shapes(fit, table, span, HAWSER__HALF_NONE, 0.5*(z0 + z1), 0.5*(z1 - z0));
}

/* The points from the last one below zp - reach to the first one above zp + reach, if the table has
 * them. */
static struct hawser__half_span around(const struct hawser__half_table *table, double zp, double reach)
{
	struct hawser__half_span span = {0, table->count - 1};

	while (span.first < span.last && square(table->omega[span.first + 1]) <= zp - reach)
		span.first++;
	while (span.last > span.first && square(table->omega[span.last - 1]) >= zp + reach)
		span.last--;
	while (span.last - span.first + 1 < FEWEST) {
		int up = span.last + 1, down = span.first - 1;

		if (down < 0 || (up < table->count && table->a[up] > table->a[down]))
			span.last = up;
		else
			span.first = down;
	}
	return span;
}

/* The second fit: to the points down to half of the peak or, if there are no more, to all but the
 * outer ones. */
static struct hawser__half_span second(const struct hawser__half_table *table,
                                       struct hawser__half_span span,
                                       const struct hawser__half_fit *fit)
{
	struct hawser__half_span wider = around(table, fit->zp, sqrt(3.0)*fit->D);

	if (wider.first < span.first || wider.last > span.last)
		return wider;
	return (struct hawser__half_span){span.first + 1, span.last - 1};
}

/* --- two modes --- */

/* Whether the first fit's scatter is less by more than chance. */
static int is_less(const struct hawser__half_fit *fit, int free_points,
                   const struct hawser__half_fit *than, int free_of_that, double sure)
{
	return fit->scatter*sqrt(gsl_cdf_fdist_Pinv(sure, free_of_that, free_points)) < than->scatter;
}

/* Whether a fit with more unknowns is better than one with fewer. */
static int is_better(const struct hawser__half_fit *more, int unknowns,
                     const struct hawser__half_fit *fewer, int less, int count)
{
	return is_less(more, count - unknowns, fewer, count - less, SURE);
}

/* What the points may be other than one mode. */
enum seen { ONE, HIDDEN, SUSPECTED, CLEAR };

/* Fits of the points of a span: one mode, the best pair of one ratio, with its unknowns, and of two. */
struct fits {
	struct hawser__half_pair_of pair;
	struct hawser__half_fit one, same, apart;
	double equal[SHAPES];
	int count;
};

/* Returns 0 where one mode fits to round-off, or does not fit at all. */
static int fit_all(struct fits *all, const struct hawser__half_table *table,
                   struct hawser__half_span span, const struct hawser__half_fit *fit)
{
	struct hawser__half_fit other = *fit;
	double q[SHAPES];

	*all = (struct fits){{table, span, sqrt(fit->zp), fit->ratio, EQUAL, NULL}, *fit, *fit, *fit,
		{0.0, 0.0, 0.0, 0.5, 0.5}, span.last - span.first + 1};
	if (!fit_span(&all->one, table, span) || all->one.scatter < EXACT)
		return 0;
	if (!hawser__half_quotient(q, &all->pair) ||
	    !hawser__half_pair(q, &all->apart, &all->pair, SHAPES) || fabs(q[1]) > WIDE)
		all->apart.scatter = INFINITY;
	if (!hawser__half_pair(all->equal, &all->same, &all->pair, EQUAL))
		all->same.scatter = INFINITY;
	memcpy(q, all->equal, sizeof q);
	if (isfinite(all->same.scatter) && hawser__half_pair(q, &other, &all->pair, SHAPES) &&
	    !(fabs(q[1]) > WIDE) && other.scatter < all->apart.scatter)
		all->apart = other;
	return 1;
}

static int reach_of(double reach[2], const struct fits *all)
{
	if (!isfinite(all->same.scatter))
		return 0;
	hawser__half_reach(reach, all->equal, all->same.sum, &all->pair);
	return 1;
}

/* Two modes, with two ratios if that is better. */
static enum seen find_pair(struct hawser__half_fit *two, double reach[2],
                           const struct hawser__half_table *table, struct hawser__half_span span,
                           const struct hawser__half_fit *fit)
{
	struct hawser__half_fit smooth = *fit;
	struct fits all;
	int unknowns = EQUAL, is_smooth, white;

	if (!fit_all(&all, table, span, fit))
		return ONE;
	is_smooth = all.count > SHAPES &&
	            hawser__half_shapes(&smooth, table, span, HAWSER__HALF_SMOOTH, fit->zp, fit->D);
	white = is_smooth && all.count >= MANY && !is_better(&smooth, SHAPES, &all.one, P, all.count);
	*two = all.same;
	if (!white && is_better(&all.apart, SHAPES, two, EQUAL, all.count)) {
		*two = all.apart;
		unknowns = SHAPES;
	} else if (isfinite(all.apart.scatter)) {
		/* two ratios that noise hides are an error of the one */
		two->hidden = fabs(all.apart.ratio - two->ratio) + all.apart.apart + all.apart.ratio_error;
	}
	if (is_smooth && two->scatter > smooth.scatter/CLEARLY)
		return ONE;
	if (is_smooth && all.one.scatter < SLIGHT && !(two->scatter < CLEARLY*smooth.scatter))
		white = 1;
	if (white || !is_better(two, unknowns, &all.one, P, all.count))
		return reach_of(reach, &all) ? HIDDEN : ONE;
	return is_smooth && !(two->scatter < CLEARLY*smooth.scatter) ? SUSPECTED : CLEAR;
}

/* Whether the points of the span scatter at random about any smooth curve. */
static int is_noise(struct hawser__half_fit *smooth, const struct hawser__half_table *table,
                    struct hawser__half_span span, const struct hawser__half_fit *fit)
{
	return span.last - span.first + 1 >= MANY &&
	       hawser__half_shapes(smooth, table, span, HAWSER__HALF_SMOOTH, fit->zp, fit->D) &&
	       smooth->scatter > EXACT && smooth->lag < WHITE;
}

/* Points with noise: one mode or two, from all points down to a fifth of the peak. Returns the number
 * of modes, or 0 if neither leaves only the noise. */
static int among_noise(struct hawser__half_fit *fit, const struct hawser__half_table *table,
                       const struct hawser__half_fit *smooth, int count)
{
	struct hawser__half_fit *two;
	struct fits all;
	double reach[2] = {0.0, 0.0};
	int free_points;

	if (!fit_all(&all, table, around(table, fit->zp, FAR*fit->D), fit))
		return 0;
	two = &all.apart;
	free_points = all.count - SHAPES;
	if (!isfinite(two->scatter) || is_less(smooth, count - SHAPES, two, free_points, SURE))
		return 0;
	if (is_less(two, free_points, &all.one, all.count - P, LIKELY) ||
	    is_less(&all.same, all.count - EQUAL, &all.one, all.count - P, LIKELY)) {
		fit->ratio = two->ratio;
		fit->ratio_error = two->both;
		fit->noise = two->scatter;
		return 2;
	}
	if (!reach_of(reach, &all))
		return 0;
	*fit = all.one;
	fit->noise = fit->scatter;
	for (int k = 0; k < 2; k++)
		fit->ratio_error = fmax(fit->ratio_error, fabs(reach[k] - fit->ratio));
	return 1;
}

/* The ratio becomes that of two modes where it certainly differs, with the difference as its error. If
 * that needs points beyond half of the peak, or is not clearly the best, only the error is taken.
 * Returns the number of modes. */
static int close_modes(struct hawser__half_fit *fit, const struct hawser__half_table *table)
{
	double beyond = sqrt(3.0)*fit->D, shift, off, reach[2];
	struct hawser__half_span span = around(table, fit->zp, beyond);
	struct hawser__half_fit two = *fit, smooth = *fit;
	int enough = span.last - span.first + 1 >= LEAST_OF_TWO, modes;
	enum seen seen = ONE;

	while (span.last - span.first + 1 < LEAST_OF_TWO && (beyond *= 1.25) < 4.0*fit->zp)
		span = around(table, fit->zp, beyond);
	modes = is_noise(&smooth, table, span, fit) ?
	        among_noise(fit, table, &smooth, span.last - span.first + 1) : 0;
	if (modes > 0)
		return modes;
	if (span.last - span.first + 1 >= LEAST_OF_TWO)
		seen = find_pair(&two, reach, table, span, fit);
	if (seen == HIDDEN)
		for (int k = 0; k < 2; k++)
			fit->ratio_error = fmax(fit->ratio_error, fabs(reach[k] - fit->ratio));
	if (seen == ONE || seen == HIDDEN)
		return 1;
	shift = fabs(two.ratio - fit->ratio);
	off = fmax(shift, two.apart) + (seen == SUSPECTED ? two.hidden : 0.0);
	if (!(off > two.ratio_error))
		return 1;
	if (seen == SUSPECTED || !enough || !(off < too_far*fit->ratio)) {
		fit->ratio_error = fmax(fit->ratio_error, MARGIN*(shift + fmax(two.apart, two.hidden)) +
		                        two.ratio_error);
		return 1;
	}
	fit->ratio = two.ratio;
	fit->ratio_error = fmax(fmax(two.apart + two.ratio_error, two.hidden), MARGIN*off);
	return 2;
}

/* Iterates until the fitted points are those that the half-power points of the parabola require. */
static int settle(struct hawser__half_fit *fit, struct hawser__half_span *span,
                  const struct hawser__half_table *table)
{
	double level = table->a[table->best]*M_SQRT1_2;

	*span = (struct hawser__half_span){table->best, table->best};
	while (span->first > 0 && table->a[span->first] > level)
		span->first--;
	while (span->last < table->count - 1 && table->a[span->last] > level)
		span->last++;
	*span = around(table, 0.5*(square(table->omega[span->first]) + square(table->omega[span->last])),
	               0.5*(square(table->omega[span->last]) - square(table->omega[span->first])));
	for (int i = 0; i < ITERATIONS; i++) {
		struct hawser__half_span now;

		if (!fit_span(fit, table, *span))
			return 0;
		now = around(table, fit->zp, fit->D);
		if (memcmp(&now, span, sizeof now) == 0)
			return 1;
		*span = now;
	}
	return 1;
}

/* --- the table --- */

static enum hawser_status check(struct hawser__half_table *table, struct hawser_report *report)
{
	const double *omega = table->omega, *a = table->a;

	if (table->count < FEWEST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "%d points: give at least %d",
		                    table->count, FEWEST);
	if (!(table->confidence > 0.0 && table->confidence < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a confidence of %g: give one between 0 and 1", table->confidence);
	for (int i = 0; i < table->count; i++) {
		if (i > 1 && omega[1] > omega[0] && omega[i] < omega[i - 1])
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "the frequencies turn back at point %d (%g after %g): half-power "
			                    "points are those of a linear resonance, whose response does not "
			                    "fold; give a response at a lower load", i + 1, omega[i],
			                    omega[i - 1]);
		if (!(a[i] > 0.0) || !(omega[i] > (i ? omega[i - 1] : 0.0)) || !isfinite(a[i] + omega[i]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "point %d (%g, %g): frequencies must ascend from above zero, and "
			                    "amplitudes be positive", i + 1, omega[i], a[i]);
		table->best = a[i] > a[table->best] ? i : table->best;
	}
	return HAWSER_OK;
}

/* The error that contains both ratios of two modes that are not seen: they may hide in all that one
 * mode leaves, of the points down to a fifth of the peak where these have noise, else down to half. */
static double pair_error(const struct hawser__half_fit *fit, const struct hawser__half_table *table)
{
	double beyond = fit->noise > 0.0 ? FAR : sqrt(3.0);
	struct hawser__half_span span = around(table, fit->zp, beyond*fit->D);
	struct hawser__half_fit one;

	if (!fit_span(&one, table, span))
		return NAN;
	if (one.scatter < EXACT)
		return fit->ratio_error;
	return fit->ratio_error + fabs(one.ratio - fit->ratio) + hawser__half_hidden(&one, table, span);
}

static enum hawser_status narrow(struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "the amplitude does not fall to 0.707 of the largest on both sides of it: "
	                    "widen the range");
}

enum hawser_status hawser_half_power_find(struct hawser_half_power *half, const double *omega,
                                          const double *a, int count, double confidence,
                                          struct hawser_report *report)
{
	struct hawser__half_table table = {omega, a, count, 0, confidence};
	enum hawser_status status = check(&table, report);
	struct hawser__half_fit fit = {.zp = 0.0}, other = {.zp = 0.0};
	struct hawser__half_span span = {0, 0};
	int modes;

	*half = (struct hawser_half_power){.ratio = 0.0};
	if (status)
		return status;
	if (table.best == 0 || table.best == count - 1)
		return narrow(report);
	if (!settle(&fit, &span, &table))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "near %g rad/s, where the amplitude is the largest, it is not that of "
		                    "a linear oscillator (1/a^2 is no parabola in omega^2 with a minimum): "
		                    "give a response at a lower load, in finer steps, of one mode",
		                    omega[table.best]);
	if (!(fit.zp - fit.D >= square(omega[0])) || !(fit.zp + fit.D <= square(omega[count - 1])))
		return narrow(report);
	if (!fit_span(&other, &table, second(&table, span, &fit)))
		other.ratio = other.zp = INFINITY;
	fit.ratio_error = fmax(fit.ratio_error, fabs(other.ratio - fit.ratio));
	modes = close_modes(&fit, &table);
	fit.zp_error = fmax(fit.zp_error, fabs(other.zp - fit.zp));
	if (!(fit.ratio_error <= too_far*fit.ratio))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "the points near %g rad/s give the ratio %.3g, to no better than %.1g: "
		                    "they are not those of one linear oscillator (two close modes?), or too "
		                    "far apart for their noise; give a response at a lower load, in finer "
		                    "steps, of one mode",
		                    omega[table.best], fit.ratio, fit.ratio_error);
	*half = (struct hawser_half_power){sqrt(fit.zp), sqrt(fit.zp - fit.D), sqrt(fit.zp + fit.D),
		fit.ratio, fit.ratio_error, 0.5*fit.zp_error/sqrt(fit.zp), modes, fit.noise,
		modes == 1 ? pair_error(&fit, &table) : fit.ratio_error};
	return HAWSER_OK;
}
