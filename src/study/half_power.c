/* study/half_power.c - damping from half-power points (hawser/decay.h).
 *
 * a = f/|omega^2 - Omega^2 + 2 i xi omega Omega|: with z = Omega^2, 1/a^2 is of second degree in
 * z. At half the largest a^2 z = omega^2 [1 - 2 xi^2 +- 2 xi sqrt(1 - xi^2)], so that (z2 -
 * z1)/(z2 + z1) = tan(2 asin xi).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include <hawser/decay.h>

#include "core/report.h"

/* The parabola 1/a^2 = y0 + (z - z1)(s + q (z - z1)) through points i - 1 to i + 1. */
struct parabola {
	double z, y, s, q;
};

static struct parabola through(const double *omega, const double *a, int i)
{
	double z = omega[i]*omega[i], y = 1.0/(a[i]*a[i]);
	double dl = omega[i - 1]*omega[i - 1] - z, dr = omega[i + 1]*omega[i + 1] - z;
	double sl = (1.0/(a[i - 1]*a[i - 1]) - y)/dl, sr = (1.0/(a[i + 1]*a[i + 1]) - y)/dr;
	double q = (sr - sl)/(dr - dl);

	return (struct parabola){z, y, sl - q*dl, q};
}

/* z at which it is `level`, between two values; their linear mean where rounding leaves none. */
static double solve(const struct parabola *p, double level, double lo, double hi)
{
	for (int i = 0; i < 200; i++) {
		double z = 0.5*(lo + hi), d = z - p->z, f = p->y + d*(p->s + p->q*d) - level;
		double dl = lo - p->z, fl = p->y + dl*(p->s + p->q*dl) - level;

		if ((f < 0.0) == (fl < 0.0))
			lo = z;
		else
			hi = z;
	}
	return 0.5*(lo + hi);
}

enum hawser_status hawser_half_power_find(struct hawser_half_power *half, const double *omega,
                                          const double *a, int count, struct hawser_report *report)
{
	int best = 0, low, high;
	struct parabola p;
	double level, z[2];

	if (count < 5)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "half-power",
		                    "%d points: give at least 5", count);
	for (int i = 0; i < count; i++) {
		if (i > 1 && omega[1] > omega[0] && omega[i] < omega[i - 1])
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "half-power",
			                    "the frequencies turn back at point %d (%g after %g): half-power "
			                    "points are those of a linear resonance, whose response does not "
			                    "fold; give a response at a lower load", i + 1, omega[i],
			                    omega[i - 1]);
		if (!(a[i] > 0.0) || !(omega[i] > (i ? omega[i - 1] : 0.0)) || !isfinite(a[i] + omega[i]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "half-power",
			                    "point %d (%g, %g): frequencies must ascend from above zero, and "
			                    "amplitudes be positive", i + 1, omega[i], a[i]);
		best = a[i] > a[best] ? i : best;
	}
	for (low = best; low >= 0 && a[low] > a[best]*M_SQRT1_2; low--)
		;
	for (high = best; high < count && a[high] > a[best]*M_SQRT1_2; high++)
		;
	if (low < 0 || high == count || best == 0 || best == count - 1)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "half-power",
		                    "the amplitude does not fall to 0.707 of the largest on both sides of it: "
		                    "widen the range");
	p = through(omega, a, best);
	half->peak = p.q > 0.0 ? sqrt(p.z - 0.5*p.s/p.q) : omega[best];
	level = 2.0*(p.q > 0.0 ? p.y - 0.25*p.s*p.s/p.q : p.y);
	p = through(omega, a, low > 0 ? low : 1);
	z[0] = solve(&p, level, omega[low]*omega[low], omega[low + 1]*omega[low + 1]);
	p = through(omega, a, high < count - 1 ? high : count - 2);
	z[1] = solve(&p, level, omega[high - 1]*omega[high - 1], omega[high]*omega[high]);
	half->low = sqrt(z[0]);
	half->high = sqrt(z[1]);
	half->ratio = sin(0.5*atan2(z[1] - z[0], z[1] + z[0]));
	return HAWSER_OK;
}
