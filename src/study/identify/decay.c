/* study/identify/decay.c - see hawser/decay.h.
 *
 *    s, w   ratio omega and the damped frequency: x = c + exp(-s t) (A cos w t + B sin w t)
 *
 * The extremes of the first cycles that clearly exceed the noise give initial values of s and w;
 * this is the logarithmic decrement. A Levenberg-Marquardt fit of all samples then gives the five
 * parameters. Their covariance gives the confidence intervals, by Student's distribution with count
 * - 5 degrees of freedom. The decrement alone would use only one sample per half cycle, and noise
 * makes maxima too large on average.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_cdf.h>
#include <lapacke.h>

#include <hawser/decay.h>

#include "core/report.h"
#include "study/identify/identify.h"

#define CLEAR 0.2 /* smallest extreme that is used, relative to the largest deflection; chosen:
                   * smaller ones are near the noise */
/* Largest amplitude relative to the largest deflection. If two cycles stand out from the noise, it
 * is 1.4 at most. With two samples per cycle sine and cosine are the same at the samples, and a fit
 * can diverge to any amplitude and damping. */
#define BEYOND 10.0

enum { P = 5, ITERATIONS = 100, FEWEST = 12, A = 0, B, C, S, W };

static const char where[] = "decay";

static enum hawser_status check(const double *t, const double *x, int count, double confidence,
                                struct hawser_report *report)
{
	if (count < FEWEST || !(confidence > 0.0 && confidence < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d samples at the confidence %g: give at least %d, and a confidence "
		                    "between 0 and 1", count, confidence, FEWEST);
	for (int i = 0; i < count; i++) {
		if (!isfinite(t[i]) || !isfinite(x[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, where, "sample %d is not finite", i + 1);
		if (i > 0 && !(t[i] > t[i - 1]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "sample %d is at the time %g, not after %g: times must ascend",
			                    i + 1,
			                    t[i], t[i - 1]);
	}
	return HAWSER_OK;
}

/* Find one extreme for each half cycle: a new half cycle begins when the deflection changes its
 * sign by more than `clear`. Linear regression of the logarithms and of the times of the extremes
 * gives s and w. Returns the number of extremes. */
static int extremes(double p[P], const double *t, const double *x, int count, double mean,
                    double clear)
{
	double last = 0.0, at = 0.0, sum[6] = {0.0}, first = 0.0;
	int side = 0, n = 0;

	for (int i = 0; i <= count; i++) {
		double d = i < count ? x[i] - mean : 0.0;
		int now = i == count ? -2 : d > clear ? 1 : d < -clear ? -1 : side;

		if (now != side && side != 0) {
			double k = n++, y = log(last);

			first = n == 1 ? at : first;
			sum[0] += k;
			sum[1] += k*k;
			sum[2] += y;
			sum[3] += k*y;
			sum[4] += at;
			sum[5] += k*at;
			last = 0.0;
		}
		side = now;
		if (fabs(d) > last) {
			last = fabs(d);
			at = i < count ? t[i] : at;
		}
	}
	if (n >= 4) {
		double d = n*sum[1] - sum[0]*sum[0], half = (n*sum[5] - sum[0]*sum[4])/d;

		p[W] = M_PI/half;
		p[S] = -(n*sum[3] - sum[0]*sum[2])/d/half;
	}
	return n;
}

/* The samples that are fitted. */
struct samples {
	const double *t, *x;
	int count;
};

/* Residuals left [count] and their derivatives J [P][count] at p, each unless it is NULL. */
static enum hawser_status residuals(void *context, double *left, double *J, const double p[P])
{
	const struct samples *of = context;

	for (int i = 0; i < of->count; i++) {
		double tau = of->t[i] - of->t[0], e = exp(-p[S]*tau);
		double c = e*cos(p[W]*tau), s = e*sin(p[W]*tau);

		if (left)
			left[i] = p[C] + p[A]*c + p[B]*s - of->x[i];
		if (!J)
			continue;
		J[A*of->count + i] = c;
		J[B*of->count + i] = s;
		J[C*of->count + i] = 1.0;
		J[S*of->count + i] = -tau*(p[A]*c + p[B]*s);
		J[W*of->count + i] = tau*(p[B]*c - p[A]*s);
	}
	return HAWSER_OK;
}

/* normal [P][P] = J'J, right [P] = -J'left. */
static void normal_equations(double *normal, double *right, const double *J, const double *left,
                             int count)
{
	for (int a = 0; a < P; a++) {
		right[a] = 0.0;
		for (int i = 0; i < count; i++)
			right[a] -= J[a*count + i]*left[i];
		for (int b = 0; b < P; b++) {
			normal[a*P + b] = 0.0;
			for (int i = 0; i < count; i++)
				normal[a*P + b] += J[a*count + i]*J[b*count + i];
		}
	}
}

/* A, B and the offset for given s and w: a linear least-squares problem. */
static void linear_start(double p[P], double *J, double *left, struct samples *of)
{
	enum { LINEAR = C + 1 };
	double normal[P*P], right[P];

	(void)residuals(of, left, J, p);
	normal_equations(normal, right, J, left, of->count);
	/* the leading block; if it is singular, the initial values stay */
	if (!LAPACKE_dposv(LAPACK_COL_MAJOR, 'U', LINEAR, 1, normal, P, right, P))
		for (int a = 0; a < LINEAR; a++)
			p[a] += right[a];
}

static enum hawser_status intervals(struct hawser_decay *decay, const double p[P], const double *J,
                                    const double *left, double sum, int count, double confidence,
                                    double most, struct hawser_report *report)
{
	double normal[P*P], right[P], variance = sum/(count - P), w2 = p[S]*p[S] + p[W]*p[W];
	double quantile = gsl_cdf_tdist_Pinv(0.5 + 0.5*confidence, count - P), by[2][2], ss, sw, ww;

	normal_equations(normal, right, J, left, count);
	if (LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', P, normal, P) ||
	    LAPACKE_dpotri(LAPACK_COL_MAJOR, 'U', P, normal, P) || !(p[W] > 0.0) ||
	    !(hypot(p[A], p[B]) <= BEYOND*most))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
		                    "the samples do not determine frequency and damping: give more of them "
		                    "a cycle, well above two");
	ss = variance*normal[S*P + S];
	sw = variance*normal[W*P + S];
	ww = variance*normal[W*P + W];
	by[0][0] = p[S]/sqrt(w2); /* derivatives of omega by s and w */
	by[0][1] = p[W]/sqrt(w2);
	by[1][0] = p[W]*p[W]/(w2*sqrt(w2)); /* those of the ratio */
	by[1][1] = -p[S]*p[W]/(w2*sqrt(w2));
	decay->omega = sqrt(w2);
	decay->ratio = p[S]/decay->omega;
	decay->omega_error =
	        quantile*sqrt(by[0][0]*by[0][0]*ss + 2.0*by[0][0]*by[0][1]*sw + by[0][1]*by[0][1]*ww);
	decay->ratio_error =
	        quantile*sqrt(by[1][0]*by[1][0]*ss + 2.0*by[1][0]*by[1][1]*sw + by[1][1]*by[1][1]*ww);
	decay->amplitude = hypot(p[A], p[B]);
	decay->offset = p[C];
	decay->noise = sqrt(variance);
	return HAWSER_OK;
}

enum hawser_status hawser_decay_fit(struct hawser_decay *decay, const double *t, const double *x,
                                    int count, double confidence, struct hawser_report *report)
{
	enum hawser_status status = check(t, x, count, confidence, report);
	struct samples samples = {t, x, count};
	struct hawser__least_squares problem = {P, count, residuals, &samples, 0.0, ITERATIONS};
	double p[P] = {0.0}, mean = 0.0, most = 0.0, sum, *J = NULL;
	int steps;

	*decay = (struct hawser_decay){.extremes = 0};
	if (status)
		return status;
	for (int i = 0; i < count; i++)
		mean += x[i]/count;
	for (int i = 0; i < count; i++)
		most = fmax(most, fabs(x[i] - mean));
	decay->extremes = extremes(p, t, x, count, mean, CLEAR*most);
	if (decay->extremes < 4)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d half-cycles stand out: give at least two whole cycles of a free decay",
		                    decay->extremes);
	decay->log_decrement = p[S]/hypot(p[S], p[W]);
	J = malloc((P + 1)*(size_t)count*sizeof *J);
	if (!J)
		return hawser__no_memory(report, where);
	p[C] = mean;
	linear_start(p, J, J + (size_t)P*count, &samples);
	status = hawser__least_squares(p, &sum, &steps, &problem);
	if (status)
		status = hawser__no_memory(report, where);
	(void)residuals(&samples, J + (size_t)P*count, J, p);
	if (!status)
		status = intervals(decay, p, J, J + (size_t)P*count, sum, count, confidence, most,
		                   report);
	free(J);
	return status;
}
