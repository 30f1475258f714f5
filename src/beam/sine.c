/* beam/sine.c - Galerkin's method with sines: sin(k pi x) for simple ends, as D (9.0.1), and
 * sin(pi x) sin(k pi x) for clamped ends.
 *
 * sin(pi x) sin(k pi x) = [cos((k - 1) pi x) - cos((k + 1) pi x)]/2. The integrals of products of
 * two sines or two cosines, and of x times such products, have closed forms. For even a + b most
 * of them vanish.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>

#include "beam/sample.h"
#include "core/report.h"

static const double pi = 3.14159265358979323846;

static int odd(int a, int b)
{
	return (a + b) & 1;
}

/* Integrals of one pair of terms: number a of s_j and number b of s_k. */
struct pair {
	double ss, s1s1, s2s2, xs1s1, ss1, s1s2;
};

/* sin(a pi x), sin(b pi x), a, b >= 1; or the cosines, a, b >= 0. */
static struct pair product(int a, int b, int cosines)
{
	double p = pi*a, q = pi*b;
	struct pair it = {0};

	if (a == b) {
		it.ss = cosines && !a ? 1.0 : 0.5;
		it.s1s1 = 0.5*p*p;
		it.s2s2 = 0.5*p*p*p*p;
		it.xs1s1 = 0.25*p*p;
	} else if (odd(a, b)) {
		double sum = a + b, difference = a - b, sign = cosines ? -1.0 : 1.0;

		it.xs1s1 = -a*(double)b*(1.0/(difference*difference) + sign/(sum*sum));
		it.ss1 = 2.0*(cosines ? b : a)*b/(sum*difference);
		it.s1s2 = 2.0*p*q*(cosines ? a : b)*b/(sum*difference);
	}
	return it;
}

static void add(struct hawser_beam_integrals *is, size_t x, double weight, const struct pair *it)
{
	is->ss[x] += weight*it->ss;
	is->s1s1[x] += weight*it->s1s1;
	is->s2s2[x] += weight*it->s2s2;
	is->xs1s1[x] += weight*it->xs1s1;
	is->ss1[x] += weight*it->ss1;
	is->s1s2[x] += weight*it->s1s2;
}

static void fill_clamped(struct hawser_beam_integrals *is, int j, int k)
{
	size_t x = (size_t)(j - 1)*(size_t)is->n + (size_t)(k - 1);

	for (int a = -1; a <= 1; a += 2)
		for (int b = -1; b <= 1; b += 2) {
			struct pair it = product(j + a, k + b, 1);

			add(is, x, 0.25*a*b, &it);
		}
}

static enum hawser_status fill(struct hawser_beam_integrals *is, enum hawser_beam_ends ends, int n,
                               struct hawser_report *report)
{
	enum hawser_status status;

	if (n < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                    "%d functions: give at least 1", n);
	status = hawser__beam_integrals_init(is, n, n, report);
	for (int j = 1; !status && j <= n; j++)
		for (int k = 1; k <= n; k++) {
			struct pair it;

			if (ends == HAWSER_ENDS_CLAMPED) {
				fill_clamped(is, j, k);
				continue;
			}
			it = product(j, k, 0);
			add(is, (size_t)(j - 1)*(size_t)n + (size_t)(k - 1), 1.0, &it);
		}
	return status;
}

static double cosine(int a, int derivative, double x)
{
	double p = pi*a;

	return derivative == 0 ? cos(p*x) : derivative == 1 ? -p*sin(p*x)
	       : derivative == 2 ? -p*p*cos(p*x) : p*p*p*sin(p*x);
}

static void at(double *s, enum hawser_beam_ends ends, int n, int derivative, double x)
{
	for (int k = 1; k <= n; k++) {
		double p = pi*k;

		if (ends == HAWSER_ENDS_CLAMPED)
			s[k - 1] = 0.5*(cosine(k - 1, derivative, x) - cosine(k + 1, derivative, x));
		else
			s[k - 1] = derivative == 0 ? sin(p*x) : derivative == 1 ? p*cos(p*x)
			         : derivative == 2 ? -p*p*sin(p*x) : -p*p*p*cos(p*x);
	}
}

const struct hawser_beam_method hawser__beam_sine = {
	"sine", "Galerkin's method with sines", "D (9.0.1)", fill, at,
};
