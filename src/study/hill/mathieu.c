/* study/hill/mathieu.c - characteristic values of Mathieu's equation, and their expansions.
 *
 * x'' + (delta + 2 epsilon cos 2t) x = 0 is the standard form with a = delta and q = -epsilon. A
 * shift of t by pi/2 changes the sign of q; it exchanges a_r and b_r for odd r and leaves them for
 * even r. With q = epsilon the set of boundaries is therefore the same, and "even" and "odd" are
 * those of the standard form: b_1 = 1 - q - q^2/8, a_1 = 1 + q - q^2/8 (Abramowitz and Stegun,
 * 20.2.25).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "study/hill/hill.h"

#define BEYOND 30 /* harmonics beyond the turning point: with them the truncation error is below
                   * round-off for small epsilon */
#define LARGEST 1e4 /* largest |epsilon|, chosen to limit the number of harmonics: 250 */

enum { HIGHEST = 1000 }; /* largest order, chosen for the same reason: 500 harmonics */

/* Beyond the turning point, k^2 = delta + 2 epsilon, the harmonics decrease faster than any power.
 * The width of the transition grows with the cube root of epsilon. */
int hawser__mathieu_highest(int r, double epsilon)
{
	double most = fabs(epsilon);

	return (int)ceil(sqrt((double)r*r + 4.0*most) + 2.0*cbrt(most)) + BEYOND;
}

/* Indices of the harmonics of boundary r: first, first + 2, ..., top. */
static int first_harmonic(int r, int odd)
{
	return r%2 ? 1 : odd ? 2 : 0;
}

static int harmonics(int r, int odd, int top)
{
	return (top - first_harmonic(r, odd))/2 + 1;
}

/* The Hill matrix: symmetric and tridiagonal, d [harmonics] and e [harmonics - 1]. */
static void hill_matrix(double *d, double *e, int r, int odd, double epsilon, int n)
{
	int first = first_harmonic(r, odd);

	for (int i = 0; i < n; i++) {
		double k = first + 2*i;

		d[i] = k*k;
		e[i] = epsilon;
	}
	if (first == 0)
		e[0] *= M_SQRT2;
	if (first == 1)
		d[0] += odd ? -epsilon : epsilon;
}

enum hawser_status hawser__mathieu_eigenvalue(double *delta, int r, int odd, double epsilon, int top,
                                              struct hawser_report *report)
{
	int n = harmonics(r, odd, top), info;
	double *d = malloc(2*(size_t)n*sizeof *d), *e;

	if (!d)
		return hawser__no_memory(report, "mathieu");
	e = d + n;
	hill_matrix(d, e, r, odd, epsilon, n);
	info = LAPACKE_dsterf_work(n, d, e);
	*delta = d[(r - first_harmonic(r, odd))/2];
	free(d);
	return info ? hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "mathieu", info, 0.0,
	                              "the eigenvalues of the Hill matrix at epsilon %g were not found",
	                              epsilon) : HAWSER_OK;
}

static enum hawser_status check(int r, int odd, double epsilon, struct hawser_report *report)
{
	if (r < (odd ? 1 : 0) || r > HIGHEST || !(fabs(epsilon) < LARGEST))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "mathieu",
		                    "characteristic value %c_%d at epsilon %g: orders go from %d to %d, "
		                    "|epsilon| to %g",
		                    odd ? 'b' : 'a', r, epsilon, odd ? 1 : 0, HIGHEST, LARGEST);
	return HAWSER_OK;
}

enum hawser_status hawser_mathieu_value(double *delta, int r, int odd, double epsilon,
                                        struct hawser_report *report)
{
	enum hawser_status status = check(r, odd, epsilon, report);

	if (status)
		return status;
	return hawser__mathieu_eigenvalue(delta, r, odd, epsilon, hawser__mathieu_highest(r, epsilon),
	                                  report);
}

/* Replace a pivot of 0. */
static double pivot(double value, double scale)
{
	return value != 0.0 ? value : DBL_EPSILON*scale;
}

/* One step of inverse iteration by the twisted factorisation of T - delta. up[i] and down[i] are
 * the pivots of elimination from the first and from the last harmonic;
 *
 *      gamma_k = up_k + down_k - (d_k - delta)
 *
 * is the pivot if both eliminations end at k. z solves (T - delta) z = gamma_k e_k with z_k = 1, so
 * that delta + gamma_k/|z|^2 is the Rayleigh quotient of z. k is chosen such that |gamma_k| is
 * smallest (Parlett and Dhillon, Linear Algebra Appl. 267 (1997) 247-279). */
static double correction(double *up, double *down, const double *d, const double *e, int n,
                         double delta)
{
	double scale = fabs(delta) + fabs(e[0]) + 1.0, gamma = INFINITY, z = 1.0, sum = 1.0;
	int k = 0;

	for (int i = 0; i < n; i++)
		up[i] = pivot(d[i] - delta - (i ? e[i - 1]*e[i - 1]/up[i - 1] : 0.0), scale);
	for (int i = n - 1; i >= 0; i--)
		down[i] = pivot(d[i] - delta - (i < n - 1 ? e[i]*e[i]/down[i + 1] : 0.0), scale);
	for (int i = 0; i < n; i++)
		if (fabs(up[i] + down[i] - (d[i] - delta)) < fabs(gamma)) {
			gamma = up[i] + down[i] - (d[i] - delta);
			k = i;
		}
	for (int i = k - 1; i >= 0; i--) {
		z *= -e[i]/up[i];
		sum += z*z;
	}
	z = 1.0;
	for (int i = k + 1; i < n; i++) {
		z *= -e[i - 1]/down[i];
		sum += z*z;
	}
	return gamma/sum;
}

enum hawser_status hawser_mathieu_distance(double *distance, double delta, int r, int odd,
                                           double epsilon, struct hawser_report *report)
{
	enum hawser_status status = check(r, odd, epsilon, report);
	int n = status ? 0 : harmonics(r, odd, hawser__mathieu_highest(r, epsilon));
	double *work = status ? NULL : malloc(4*(size_t)n*sizeof *work);

	if (!work)
		return status ? status : hawser__no_memory(report, "mathieu");
	hill_matrix(work, work + n, r, odd, epsilon, n);
	*distance = -correction(work + 2*n, work + 3*n, work, work + n, n, delta);
	free(work);
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
