/* response/surge.c - what a change of travel speed puts on the cable, with its axial waves.
 *
 *   a, v    acceleration of the cable along itself, constant from t = 0 to tb; v = a tb
 *   c       sqrt(EA/rho), speed of axial waves
 *   k, x    Omega/c and k L/2
 *   tri     |S| - L/2 for S from -L to L, with period 2 L
 *
 * A straight cable of unstretched length L between its ends: rho w.. = EA w'' - rho a with w = 0 at
 * both ends. At rest for t < 0, d'Alembert's solution has the tension
 *
 *     rho a (S - L/2) - rho a/2 (tri(S - c t) + tri(S + c t))
 *
 * up to tb, and from there on the same at t - tb is subtracted. Its largest value is at the ends,
 * -rho a L/2 - rho a tri(c t) at S = 0: it grows to rho a c t, reaches rho a L at t = L/c,
 * twice that of the
 * static answer, and returns. A stop within less than L/c ends with rho c v. The closed form is taken,
 * and not a sum over axial modes, since it has no truncation error.
 *
 * With damping the overshoot is that of the first axial mode, which bears 8/pi^2 = 81 % of the wave:
 * exp(-pi zeta/sqrt(1 - zeta^2)), none from zeta = 1 on.
 *
 * Where a = A cos(Omega t) for a long time, the tension is rho A/k sin(k (S - L/2))/cos x,
 * without damping. Neglected are the curvature of the cable, and what its speed is to c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include <hawser/integrate.h>

double hawser_surge_overshoot(double ratio)
{
	return ratio < 1.0 ? exp(-M_PI*ratio/sqrt(1.0 - ratio*ratio)) : 0.0;
}

double hawser_surge_ramp(double rho, double EA, double length, double change, double time,
                         double ratio)
{
	double factor = 1.0 + hawser_surge_overshoot(ratio);

	return rho*fabs(change)*fmin(sqrt(EA/rho), 0.5*factor*length/time);
}

double hawser_surge_steady(double rho, double EA, double length, double acceleration, double omega)
{
	double k = omega/sqrt(EA/rho), x = 0.5*k*length, largest = x < M_PI_2 ? sin(x) : 1.0;

	if (x < 1e-8)
		return 0.5*rho*acceleration*length;
	return rho*acceleration*largest/(k*fabs(cos(x)));
}
