/* water/line.h - the drag of a line, for the loops over elements.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_LINE_H
#define HAWSER_WATER_LINE_H

#include <math.h>

#include <hawser/drag.h>

#include "core/hot.h"
#include "core/vec3.h"

/* hawser_drag_line with the unit tangent t = x' times `inverse`.
 *
 * p normal part of the flow u, a = u.t its part along the line
 * P      1 - t t^T, the derivative of t by x' is P/|x'|
 *
 * |p| p has a continuous derivative, |p| P + p p^T/|p|, which is 0 where p is: only 0/0 has to be
 * avoided, and |p| is not smoothed. */
HAWSER_PART void hawser__drag_line(double f[3], double (*f_u)[3], double (*f_x)[3],
                                   const struct hawser_drag *drag, const double u[3],
                                   const double t[3], double inverse)
{
	const double a = hawser__dot(u, t), p[3] = {u[0] - a*t[0], u[1] - a*t[1], u[2] - a*t[2]};
	const double norm = hawser__norm(p);
	const double across = drag->density*drag->radius*drag->normal*norm;
	const double along = drag->density*drag->radius*drag->tangential*M_PI*fabs(a);
	double one;

	HAWSER_UNROLL
	for (int i = 0; i < 3; i++)
		f[i] = across*p[i] + along*a*t[i];
	if (!f_u && !f_x)
		return;
	one = norm > 0.0 ? 1.0/norm : 0.0;
	HAWSER_UNROLL
	for (int i = 0; i < 3; i++) {
		HAWSER_UNROLL
		for (int j = 0; j < 3; j++) {
			double P = (i == j) - t[i]*t[j], Q = P + one*p[i]*(one*p[j]);

			/* the normal part of u turns with t: dp = -(u.dt) t - a dt, and u.dt = p.dt */
			if (f_u)
				f_u[i][j] = across*Q + 2.0*along*t[i]*t[j];
			if (f_x)
				f_x[i][j] = (along*(2.0*t[i]*p[j] + a*P) - across*(t[i]*p[j] + a*Q))*inverse;
		}
	}
}

#endif
