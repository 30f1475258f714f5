/* study/mathieu.c - characteristic values of Mathieu's equation, and their expansions.
 *
 * x'' + (delta + 2 epsilon cos 2t) x = 0 is the standard form with a = delta and q = -epsilon. A
 * shift of t by pi/2 turns the sign of q; it exchanges a_r and b_r for odd r and leaves them for
 * even r. So with q = epsilon the set of boundaries is the same, and "even" and "odd" are those of
 * the standard form: b_1 = 1 - q - q^2/8, a_1 = 1 + q - q^2/8 (Abramowitz and Stegun, 20.2.25).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_mathieu.h>

#include "core/report.h"
#include <hawser/hill.h>

enum { HIGHEST = 60 };

enum hawser_status hawser_mathieu_value(double *delta, int r, int odd, double epsilon,
                                        struct hawser_report *report)
{
	gsl_error_handler_t *handler;
	gsl_sf_result result = {NAN, NAN};
	int failed;

	if (r < (odd ? 1 : 0) || r > HIGHEST || !(fabs(epsilon) < 1e4))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "mathieu",
		                    "characteristic value %c_%d at epsilon %g: orders go from %d to %d",
		                    odd ? 'b' : 'a', r, epsilon, odd ? 1 : 0, HIGHEST);
	handler = gsl_set_error_handler_off();
	failed = odd ? gsl_sf_mathieu_b_e(r, epsilon, &result) : gsl_sf_mathieu_a_e(r, epsilon,
	                                                                            &result);
	gsl_set_error_handler(handler);
	*delta = result.val;
	if (failed || !isfinite(result.val))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "mathieu",
		                    "GSL finds no characteristic value %c_%d at epsilon %g",
		                    odd ? 'b' : 'a', r,
		                    epsilon);
	return HAWSER_OK;
}

double hawser_mathieu_expansion(int r, int odd, double epsilon, int printed)
{
	double square = epsilon*epsilon;

	if (r == 0)
		return -0.5*square;
	if (r == 1)
		return 1.0 + (odd ? -epsilon : epsilon) + (printed ? 0.125 : -0.125)*square;
	if (r == 2)
		return 4.0 + (odd ? -1.0/12.0 : 5.0/12.0)*square;
	return (double)r*r + 0.5*square/((double)r*r - 1.0);
}
