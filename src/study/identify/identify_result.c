/* study/identify/identify_result.c - confidence intervals and results of a fit.
 *
 *    J      derivatives of the weighted residuals by the variables x (identify_modes.c), at the end
 *    C      covariance of x: (J' J)^-1 = V diag(1/s^2) V' with the singular values s of J, times the
 *           mean square of the residuals if the deviations of the measurements are not known
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_cdf.h>
#include <lapacke.h>

#include "core/append.h"
#include "core/report.h"
#include "study/identify/identify.h"

/* Least ratio of singular values: below it, differences cannot tell the parameters apart. */
#define DISTINCT 1e-6
#define LEAST_EFFECT 1e-7 /* least derivative of the logarithm of a frequency by x */

static const char where[] = "identify";

/* --- intervals --- */

/* "tension.T0 and cable.rho": the keys of the larger components. */
static void name_keys(char *text, size_t size, const struct hawser__fit *fit, const double *v)
{
	text[0] = '\0';
	for (int k = 0; k < fit->keys; k++)
		if (fabs(v[k]) > 0.2)
			hawser__append(text, size, " and ", "%.60s", fit->key[k]);
}

/* V [keys][keys], rows, and s [keys] of the Jacobian J [keys + 1][count] at x. */
static enum hawser_status decompose(double *V, double *s, double *J, struct hawser__fit *fit,
                                    const double *x, struct hawser_report *report)
{
	int n = fit->keys, m = fit->count, info;
	double super[HAWSER_IDENTIFY_KEYS], one;
	char names[HAWSER_IDENTIFY_KEYS*70];
	enum hawser_status status = hawser__fit_jacobian(J, fit, x, report);

	for (int k = 0; k < n && !status; k++) {
		double most = 0.0;

		for (int i = 0; i < m; i++)
			most = fmax(most, fabs(J[k*m + i])/fit->weight[i]);
		if (most < LEAST_EFFECT)
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                      "%.60s has no effect on these frequencies: it cannot be "
			                      "identified from them", fit->key[k]);
	}
	if (status)
		return status;
	/* the rows of J are the columns of the matrix */
	info = LAPACKE_dgesvd(LAPACK_COL_MAJOR, 'N', 'A', m, n, J, m, s, &one, 1, V, n, super);
	if (info)
		return hawser__lapack_starved(info)
		       ? hawser__no_memory(report, where)
		       : hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
		                      "the singular values of the Jacobian did not converge");
	if (s[n - 1] >= DISTINCT*s[0])
		return HAWSER_OK;
	for (int k = 0; k < n; k++)
		super[k] = V[k*n + n - 1];
	name_keys(names, sizeof names, fit, super);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                    "%s only change these frequencies together: keep one of them fixed, or "
	                    "measure modes that tell them apart", names);
}

static double quantile(double confidence, int known, int freedom)
{
	double p = 0.5 + 0.5*confidence;

	return known ? gsl_cdf_gaussian_Pinv(p, 1.0)
	       : freedom > 0 ? gsl_cdf_tdist_Pinv(p, freedom) : NAN;
}

static void ends(struct hawser_identified_key *key, const struct hawser__fit *fit, int k, double x,
                 double half)
{
	double low, high;

	*key = (struct hawser_identified_key){fit->key[k], fit->start[k], hawser__fit_value(fit, k, x),
	                                      NAN, NAN, NAN, fit->logarithmic[k]};
	if (!isfinite(half))
		return;
	low = hawser__fit_value(fit, k, x - half);
	high = hawser__fit_value(fit, k, x + half);
	key->low = low;
	key->high = high;
	key->relative = key->value != 0.0 ? 0.5*(high - low)/fabs(key->value) : INFINITY;
}

static enum hawser_status intervals(struct hawser_identified *identified, struct hawser__fit *fit,
                                    const struct hawser__identify_end *best,
                                    double confidence,
                                    struct hawser_report *report)
{
	int n = fit->keys, known = fit->measured[0].deviation > 0.0;
	int freedom = identified->freedom;
	double V[HAWSER_IDENTIFY_KEYS*HAWSER_IDENTIFY_KEYS], s[HAWSER_IDENTIFY_KEYS];
	double C[HAWSER_IDENTIFY_KEYS][HAWSER_IDENTIFY_KEYS] = {{0.0}};
	double unit = known ? 1.0 : freedom > 0 ? sqrt(best->chi2/freedom) : NAN;
	double wide = quantile(confidence, known, freedom)*unit;
	double *J = malloc((size_t)(n + 1)*(size_t)fit->count*sizeof *J);
	enum hawser_status status = J ? decompose(V, s, J, fit, best->x, report)
	                              : hawser__no_memory(report, where);

	free(J);
	if (status)
		return status;
	for (int a = 0; a < n; a++)
		for (int b = 0; b < n; b++)
			for (int k = 0; k < n; k++)
				C[a][b] += V[a*n + k]*V[b*n + k]/(s[k]*s[k]);
	for (int a = 0; a < n; a++) {
		ends(&identified->key[a], fit, a, best->x[a], wide*sqrt(C[a][a]));
		for (int b = 0; b < n; b++)
			identified->correlation[a][b] = C[a][b]/sqrt(C[a][a]*C[b][b]);
	}
	identified->weakness = unit/s[n - 1];
	return HAWSER_OK;
}

/* --- results --- */

static void list(struct hawser_identified *identified, const struct hawser__fit *fit,
                 const struct hawser_modes *modes, const struct hawser_modes *before)
{
	double sum = 0.0;

	for (int i = 0; i < fit->count; i++) {
		const struct hawser_measured *measured = &fit->measured[i];
		const struct hawser_mode *mode = hawser__fit_find(modes, fit->mate[i]);
		const struct hawser_mode *old = hawser__fit_find(before, fit->mate[i]);
		struct hawser_identified_mode *to = &identified->mode[i];
		double computed = mode->omega/modes->time_unit, left = log(computed/measured->omega);

		*to = (struct hawser_identified_mode){
			.measured = measured->omega, .computed = computed,
			.before = old ? old->omega/before->time_unit : NAN,
			.difference = computed/measured->omega - 1.0,
			.deviation = measured->deviation > 0.0 ? measured->deviation/measured->omega : NAN,
			.plane = mode->plane, .place = mode->place, .number = mode->number,
			.matched = !hawser__fit_given(measured)};
		sum += left*left;
	}
	identified->spread = identified->freedom > 0 ? sqrt(sum/identified->freedom) : NAN;
	for (int i = 0; i < fit->count; i++)
		if (!(fit->measured[i].deviation > 0.0))
			identified->mode[i].deviation = identified->spread;
}

enum hawser_status hawser__fit_finish(struct hawser_identified *identified, struct hawser__fit *fit,
                                      const struct hawser__identify_end *best, double confidence,
                                      struct hawser_report *report)
{
	static const double none[HAWSER_IDENTIFY_KEYS];
	struct hawser_modes modes = {0}, before = {0};
	int known = fit->measured[0].deviation > 0.0;
	enum hawser_status status;

	identified->keys = fit->keys;
	identified->count = fit->count;
	identified->freedom = fit->count - fit->keys;
	identified->chi2 = known ? best->chi2 : NAN;
	identified->probability = known && identified->freedom > 0
	                          ? gsl_cdf_chisq_Q(best->chi2, identified->freedom) : NAN;
	identified->skipped = best->skipped;
	identified->mode = calloc((size_t)fit->count, sizeof *identified->mode);
	if (!identified->mode)
		return hawser__no_memory(report, where);
	status = intervals(identified, fit, best, confidence, report);
	if (!status)
		status = hawser__fit_modes(&modes, fit, best->x, report);
	if (!status)
		status = hawser__fit_modes(&before, fit, none, report);
	if (!status)
		status = hawser__fit_scene(&identified->scene, fit, best->x, report);
	if (!status)
		list(identified, fit, &modes, &before);
	if (!status)
		hawser__fit_doubt(identified, fit, &modes);
	identified->evaluations = fit->evaluations;
	hawser_modes_clear(&modes);
	hawser_modes_clear(&before);
	return status;
}
