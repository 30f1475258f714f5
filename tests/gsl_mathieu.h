/* tests/gsl_mathieu.h - characteristic values of Mathieu's equation by GSL, which shares no code
 * with this program.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_GSL_MATHIEU_H
#define TESTS_GSL_MATHIEU_H

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_mathieu.h>
#include <math.h>

/* x'' + (delta + 2 epsilon cos 2t) x = 0 is the standard form with a = delta and q = -epsilon. A shift
 * of t by pi/2 turns the sign of q; it exchanges a_r and b_r for odd r and leaves them for even r. So
 * with q = epsilon the set of boundaries is the same. 0: *delta is a_r or b_r. */
static inline int gsl_mathieu(double *delta, int r, int odd, double epsilon)
{
	gsl_error_handler_t *handler = gsl_set_error_handler_off();
	gsl_sf_result result = {NAN, NAN};
	int failed = odd ? gsl_sf_mathieu_b_e(r, epsilon, &result)
	                 : gsl_sf_mathieu_a_e(r, epsilon, &result);

	gsl_set_error_handler(handler);
	*delta = result.val;
	return failed || !isfinite(result.val);
}

#endif
