/* response/floquet/monodromy_factors.c - the product of the matrices of the steps, kept as
 * well-conditioned factors, and its eigenvalues.
 *
 * If the product is formed as one matrix, multipliers that are smaller than round-off times its
 * norm are lost. The criterion is the norm: damping that differs between coordinates, overdamped
 * coordinates and growth by an excitation all increase it. A product of small norm stays one
 * matrix, for which LAPACK's QR algorithm is as accurate as possible.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/floquet/floquet.h"
#include "response/floquet/monodromy.h"

#define ROUND_OFF 1.2e-16 /* half a unit in the last place: largest error of an operation */
#define LARGE 1e60 /* norm above which a factor is scaled, so that squares do not overflow */

/* Multiply a factor by the matrix of a step from the left. */
static void multiply(struct hawser__monodromy *monodromy, double *factor, int m, int fresh)
{
	size_t block = (size_t)m*m*sizeof *factor;

	if (fresh) {
		memcpy(factor, monodromy->step, block);
		return;
	}
	memcpy(monodromy->product, factor, block);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, m, m, m, 1.0, monodromy->step, m,
	            monodromy->product, m, 0.0, factor, m);
}

/* Multiply neighbours: half as many factors, with about twice the logarithm of the norm. */
static void pair_up(struct hawser__monodromy *monodromy, struct hawser__factors *factors)
{
	int m = factors->m, kept = 0;
	size_t block = (size_t)m*m;

	for (int i = 0; i < factors->count; i += 2, kept++) {
		const double *first = factors->at + (size_t)i*block;

		if (i + 1 < factors->count)
			cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, m, m, m, 1.0,
			            first + block, m, first, m, 0.0, monodromy->product, m);
		else
			memcpy(monodromy->product, first, block*sizeof(double));
		memcpy(factors->at + (size_t)kept*block, monodromy->product, block*sizeof(double));
	}
	factors->count = kept;
	factors->limit *= 2.0;
}

void hawser__factors_add(struct hawser__monodromy *monodromy, struct hawser__factors *factors)
{
	int m = factors->m;
	double *factor, norm;

	if (factors->largest < 0.0) {
		if (factors->count == factors->most)
			pair_up(monodromy, factors);
		factors->count++;
	}
	factor = factors->at + (size_t)(factors->count - 1)*m*m;
	multiply(monodromy, factor, m, factors->largest < 0.0);
	norm = cblas_dnrm2(m*m, factor, 1)/sqrt(m);
	factors->largest = fmax(log(norm), 0.0);
	if (norm > LARGE) {
		cblas_dscal(m*m, 1.0/norm, factor, 1);
		factors->taken += log(norm);
	}
	monodromy->stretch = fmax(monodromy->stretch, factors->largest);
	if (factors->largest > factors->limit)
		factors->largest = -1.0;
}

double hawser__factors_loss(int m, int steps, double stretch, double error)
{
	return error + ROUND_OFF*(4.0 + sqrt(steps))*m*exp(fmin(2.0*stretch, 40.0));
}

double hawser__factors_error_of(int i, const double *log_modulus, const double *argument, int m,
                                double loss)
{
	double gap = 1.0;

	for (int k = 0; k < m; k++)
		if (k != i)
			gap = fmin(gap, hypot(log_modulus[i] - log_modulus[k],
			                      remainder(argument[i] - argument[k], 2.0*M_PI)));
	return loss > 0.0 ? loss/fmax(gap, sqrt(loss)) : 0.0;
}

double hawser__factors_error(const double *log_modulus, const double *argument, int m, double loss,
                             double error)
{
	double worst = error;

	for (int i = 0; i < m; i++)
		worst = fmax(worst, hawser__factors_error_of(i, log_modulus, argument, m, loss));
	return worst;
}

/* Eigenvalues of a single factor (overwritten): the QR algorithm of LAPACK is more reliable than
 * the periodic one. */
static enum hawser_status eigenvalues(struct hawser__monodromy *monodromy, double *log_modulus,
                                      double *argument, double *kind,
                                      const struct hawser__component *c, double *factor, int m,
                                      struct hawser_report *report)
{
	int info = hawser__floquet_vectors(log_modulus, argument, monodromy->kinds ? kind : NULL, factor, m,
	                                   monodromy->scale, c->member, monodromy->product,
	                                   monodromy->floquet_work);

	return !info ? HAWSER_OK
	       : hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "floquet", info, 0.0,
	                         "the QR algorithm for the Floquet multipliers did not "
	                         "converge (order %d, info %d)", m, info);
}

static int all_finite(const double *x, size_t count)
{
	for (size_t i = 0; i < count; i++)
		if (!isfinite(x[i]))
			return 0;
	return 1;
}

/* The periodic QR iteration sometimes fails to converge; it is then repeated with fewer factors. */
enum hawser_status hawser__factors_multipliers(struct hawser__monodromy *monodromy,
                                               double *log_modulus, double *argument,
                                               double *kind,
                                               const struct hawser__component *c,
                                               struct hawser__factors *factors,
                                               struct hawser_report *report)
{
	int m = factors->m;
	size_t block = (size_t)m*m;
	double *copy = monodromy->factor + (size_t)factors->most*block;

	memset(kind, 0, (size_t)m*sizeof *kind);

	/* LAPACK would print a message to standard error about a NaN */
	if (!all_finite(factors->at, (size_t)factors->count*block))
		return hawser__fail(report, HAWSER_ERR_NAN, "floquet",
		                    "the transition matrix of a period is not finite: stiffness, damping or "
		                    "Omega are beyond double precision");
	while (factors->count > 1) {
		size_t size = (size_t)factors->count*block*sizeof(double);
		enum hawser_status status;

		memcpy(copy, factors->at, size);
		status = hawser__floquet(log_modulus, argument, copy, factors->count, m,
		                         monodromy->floquet_work, report);
		if (status != HAWSER_ERR_CONVERGENCE)
			return status;
		pair_up(monodromy, factors);
		monodromy->stretch *= 2.0;
	}
	return eigenvalues(monodromy, log_modulus, argument, kind, c, factors->at, m, report);
}

void hawser__factors_reverse(struct hawser__factors *factors, const int *sign)
{
	int m = factors->m, w = m/2;
	double *last = factors->at + (size_t)(factors->count - 1)*m*m;

	for (int row = 0; row < m; row++)
		if (sign[row%w] < 0)
			cblas_dscal(m, -1.0, last + (size_t)row*m, 1);
}

void hawser__factors_square(double *log_modulus, double *argument, double *kind, int m)
{
	for (int i = 0; i < m; i++) {
		double twice = remainder(2.0*fabs(argument[i]), 2.0*M_PI);

		log_modulus[i] *= 2.0;
		kind[i] = twice < 0.0 ? -kind[i] : kind[i];
		argument[i] = argument[i] < 0.0 ? -fabs(twice) : fabs(twice);
	}
}
