/* ropeway/statics/arc.c - the rope on a circle.
 *
 * q      angle of contact so far; slope angle a = angle0 - side*q
 * m      friction coefficient, with the sign in which the tension grows
 * w'     w/(1 + T/EA), weight per stretched length
 *
 * Per angle, along and across the rope:
 *   N R = T + side*w' R cos a,      dT/dq = w' R sin a + m N R,      dS/dq = R/(1 + T/EA).
 *
 * T is e^{m q} times an integral of the weight. By collocation at the five points of Gauss,
 * where the exponential is exact and only the weight's part is a polynomial: its error is of
 * order 10, 1e-17 of the weight of the arc in a step of 0.4 rad. The weight depends on T
 * through the strain alone, so that a few substitutions solve the equations of a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "ropeway/statics/rope.h"

enum { POINTS = 5, SUBSTITUTIONS = 60 };
static const double longest = 0.4; /* rad */
static const double node[POINTS] = {0.046910077030668004, 0.23076534494715845, 0.5,
                                    0.76923465505284155, 0.953089922969332};
static const double weight[POINTS] = {0.11846344252809454, 0.23931433524968323, 0.28444444444444444,
                                      0.23931433524968323, 0.11846344252809454};
static const double integral[POINTS][POINTS] = {
	{0.059231721264047272, -0.019570364359076037, 0.011254400818642956, -0.0055937936608121849,
	 0.0015881129678659985},
	{0.12815100567004528, 0.11965716762484162, -0.0245921146196422, 0.010318280670683357,
	 -0.002768994398769603},
	{0.1137762880042246, 0.26000465168064152, 0.14222222222222222, -0.020690316430958285,
	 0.0046871545238699412},
	{0.12123243692686415, 0.22899605457899988, 0.30903655906408664, 0.11965716762484162,
	 -0.0096875631419507397},
	{0.11687532956022855, 0.24490812891049542, 0.2731900436258015, 0.25888469960875927,
	 0.059231721264047272},
};

double hawser__arc_force(const struct hawser__arc *arc, const struct hawser__rope *rope, double T,
                         double a)
{
	return T + arc->side*rope->w*arc->R/(1.0 + T/rope->EA)*cos(a);
}

/* One step h from the slope angle a: tensions at the nodes, and at the end. */
static double step(double T[POINTS], const struct hawser__arc *arc, const struct hawser__rope *rope,
                   double T0, double a, double h)
{
	double pull[POINTS], grow[POINTS], load[POINTS], last = T0, m = arc->friction, sum = 0.0;

	for (int i = 0; i < POINTS; i++) {
		double angle = a - arc->side*node[i]*h;

		grow[i] = m != 0.0 ? exp(m*node[i]*h) : 1.0;
		pull[i] = rope->w*arc->R*(sin(angle) + arc->side*m*cos(angle))/grow[i];
		T[i] = T0*grow[i];
	}
	for (int round = 0; round < SUBSTITUTIONS; round++) {
		double change = 0.0;

		for (int i = 0; i < POINTS; i++)
			load[i] = pull[i]/(1.0 + T[i]/rope->EA);
		for (int i = 0; i < POINTS; i++) {
			double part = 0.0, next;

			for (int j = 0; j < POINTS; j++)
				part += integral[i][j]*load[j];
			next = grow[i]*(T0 + h*part);
			change = fmax(change, fabs(next - T[i]));
			T[i] = next;
			last = fmax(last, fabs(next));
		}
		if (!(change > DBL_EPSILON*last))
			break;
	}
	for (int i = 0; i < POINTS; i++)
		sum += weight[i]*pull[i]/(1.0 + T[i]/rope->EA);
	return (m != 0.0 ? exp(m*h) : 1.0)*(T0 + h*sum);
}

void hawser__arc_at(double *T, double *S, const struct hawser__arc *arc,
                    const struct hawser__rope *rope,
                    double q)
{
	int steps = q > longest ? (int)ceil(q/longest) : 1;
	double h = q/steps, at[POINTS];

	*T = arc->T0;
	*S = 0.0;
	if (!(q > 0.0))
		return;
	if (!(arc->R > 0.0)) {
		*T *= exp(arc->friction*q);
		return;
	}
	for (int k = 0; k < steps; k++) {
		*T = step(at, arc, rope, *T, arc->angle0 - arc->side*k*h, h);
		for (int i = 0; i < POINTS; i++)
			*S += h*weight[i]*arc->R/(1.0 + at[i]/rope->EA);
		if (!(*T > 0.0)) {
			*T = NAN;
			return;
		}
	}
}

void hawser__arc_total(double force[2], const struct hawser__arc *arc, const struct hawser__rope *rope,
                       double q)
{
	int steps = q > longest ? (int)ceil(q/longest) : 1;
	double h = q/steps, T = arc->T0, at[POINTS];

	force[0] = force[1] = 0.0;
	for (int k = 0; k < steps; k++) {
		double a = arc->angle0 - arc->side*k*h;

		T = step(at, arc, rope, T, a, h);
		for (int i = 0; i < POINTS; i++) {
			double angle = a - arc->side*node[i]*h;
			double N = h*weight[i]*hawser__arc_force(arc, rope, at[i], angle);

			force[0] += N*(-arc->side*sin(angle) - arc->friction*cos(angle));
			force[1] += N*(arc->side*cos(angle) - arc->friction*sin(angle));
		}
	}
}
