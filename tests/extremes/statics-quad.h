/* tests/extremes/statics-quad.h - the elastic catenary, at rest or travelling, in quadruple precision.
 *
 * The equations are those of the physical tension, without an apparent cable. The vector R of modulus
 * EA (|x'| - 1) - p |x'|, p = rho v^2, is parallel to x'. Rx is constant and Ry grows by w S. With
 * u = Ry/Rx and i = 1/EA
 *
 *   (1 - p i) x(S) = i Rx S + (Rx/w) (asinh u - asinh u0)
 *   (1 - p i) y(S) = i (Ry0 S + w S^2/2) + (Rx/w) (sqrt(1+u^2) - sqrt(1+u0^2)),
 *   (1 - p i) T = |R| + p
 *
 * where the differences are evaluated as products. Newton's method on (Rx, Ry0, L), with exact
 * derivatives, starts from the state to be tested. The distance to the converged state is the error of
 * that state.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_STATICS_QUAD_H
#define HAWSER_TESTS_STATICS_QUAD_H

#include <hawser/statics.h>

#include "tests/modes-shooting.h"

/* The inputs of a problem. The first six are varied to find the effect of input errors. */
struct quad_span {
	quad value, i, w, d, h, p;
	enum hawser_given given;
};
enum { QUAD_INPUTS = 6, QUAD_OUTPUTS = 10 };

static inline quad quad_abs(quad x)
{
	return x < 0 ? -x : x;
}

/* exp(x) by halving 12 times, |x| < 700 */
static inline quad quad_exp(quad x)
{
	quad small = x/4096, sum = 1;

	for (int k = 16; k > 0; k--)
		sum = 1 + small/k*sum;
	for (int k = 0; k < 12; k++)
		sum *= sum;
	return sum;
}

/* Newton's step of third order from the double's */
static inline quad quad_log(quad x)
{
	quad y = log((double)x), r = x*quad_exp(-y) - 1;

	return y + r - r*r/2 + r*r*r/3;
}

static inline quad quad_asinh(quad u)
{
	quad a = quad_abs(u), y = quad_log(a + quad_sqrt(1 + a*a));

	return u < 0 ? -y : y;
}

/* Twice atanh(t) = log((1 + t)/(1 - t)), 0 <= t < 1 */
static inline quad quad_twice_atanh(quad t)
{
	quad sum = 0, t2 = t*t;

	if (t > (quad)0.1)
		return quad_log((1 + t)/(1 - t));
	for (int k = 18; k >= 0; k--)
		sum = sum*t2 + (quad)2/(2*k + 1);
	return sum*t;
}

/* Differences between S = 0, with slope u0, and the place with slope u0 + rise. */
struct quad_arc {
	quad r0, r1, u1;
	quad angle, sines, cosines; /* differences of asinh u, u/r, 1/r */
	quad roots;                 /* of r */
};

static inline struct quad_arc quad_arc_of(quad u0, quad rise)
{
	struct quad_arc arc = {.u1 = u0 + rise};
	quad t;

	arc.r0 = quad_sqrt(1 + u0*u0);
	arc.r1 = quad_sqrt(1 + arc.u1*arc.u1);
	t = rise/(arc.r0 + arc.r1); /* tanh of half the angle */
	if (quad_abs(t) < (quad)0.9)
		arc.angle = t < 0 ? -quad_twice_atanh(-t) : quad_twice_atanh(t);
	else
		arc.angle = quad_asinh(arc.u1) - quad_asinh(u0);
	arc.sines = 2*t/(1 - t*t)/(arc.r0*arc.r1);
	if (quad_abs(t) >= (quad)0.9)
		arc.sines = arc.u1/arc.r1 - u0/arc.r0;
	arc.roots = rise*(arc.u1 + u0)/(arc.r0 + arc.r1);
	arc.cosines = -arc.roots/(arc.r0*arc.r1);
	return arc;
}

/* x and y at S, and their derivatives by Rx, Ry0, S: at [2][4]. */
static inline void quad_place(quad at[2][4], const struct quad_span *span, const quad *z, quad S)
{
	quad w = span->w, i = span->i, part = 1 - span->p*i;
	struct quad_arc arc = quad_arc_of(z[1]/z[0], w*S/z[0]);
	const quad all[2][4] = {
		{i*z[0]*S + z[0]/w*arc.angle, i*S + (arc.angle - arc.sines)/w, arc.cosines/w,
		 i*z[0] + 1/arc.r1},
		{i*(z[1]*S + w*S*S/2) + z[0]/w*arc.roots, arc.cosines/w, i*S + arc.sines/w,
		 i*(z[1] + w*S) + arc.u1/arc.r1}};

	for (int k = 0; k < 8; k++)
		at[k/4][k%4] = all[k/4][k%4]/part;
}

/* The sag and its derivatives. The derivative with respect to S vanishes, because the slope at S is
 * that of the chord. */
static inline void quad_sag(quad *sag, const struct quad_span *span, const quad *z)
{
	quad slope = span->h/span->d, rise = slope - z[1]/z[0], S = rise*z[0]/span->w, at[2][4];
	struct quad_arc arc = quad_arc_of(z[1]/z[0], rise);

	quad_place(at, span, z, S);
	sag[0] = (span->i*span->w*S*S/2 + z[0]/span->w*(slope*arc.angle - arc.roots))
	         /(1 - span->p*span->i);
	sag[1] = slope*at[0][1] - at[1][1];
	sag[2] = slope*at[0][2] - at[1][2];
	sag[3] = 0;
}

/* The given quantity and its derivatives: given [4]. */
static inline void quad_given(quad *given, const struct quad_span *span, const quad *z)
{
	quad part = 1 - span->p*span->i, Ry = z[1], R, r;

	if (span->given == HAWSER_GIVEN_T1)
		Ry += span->w*z[2];
	R = quad_sqrt(z[0]*z[0] + Ry*Ry);
	r = R/z[0];
	switch (span->given) {
	case HAWSER_GIVEN_H:
		given[0] = (z[0] + span->p/r)/part;
		given[1] = (1 + span->p*(Ry/z[0])*(Ry/z[0])/(r*r*r*z[0]))/part;
		given[2] = -span->p*(Ry/z[0])/(r*r*r*z[0])/part;
		given[3] = 0;
		break;
	case HAWSER_GIVEN_T0:
	case HAWSER_GIVEN_T1:
		given[0] = (R + span->p)/part;
		given[1] = z[0]/R/part;
		given[2] = Ry/R/part;
		given[3] = span->given == HAWSER_GIVEN_T1 ? Ry/R*span->w/part : 0;
		break;
	case HAWSER_GIVEN_SAG:
		quad_sag(given, span, z);
		break;
	default:
		given[0] = z[2];
		given[1] = given[2] = 0;
		given[3] = 1;
	}
}

/* x of a [3][4] = (A | b), by elimination with pivots. */
static inline void quad_solve(quad *x, quad a[3][4])
{
	for (int k = 0; k < 3; k++) {
		int top = k;

		for (int j = k + 1; j < 3; j++)
			top = quad_abs(a[j][k]) > quad_abs(a[top][k]) ? j : top;
		for (int c = 0; c < 4; c++) {
			quad swap = a[k][c];

			a[k][c] = a[top][c];
			a[top][c] = swap;
		}
		for (int j = k + 1; j < 3; j++) {
			quad f = a[j][k]/a[k][k];

			for (int c = k; c < 4; c++)
				a[j][c] -= f*a[k][c];
		}
	}
	for (int k = 2; k >= 0; k--) {
		x[k] = a[k][3];
		for (int c = k + 1; c < 3; c++)
			x[k] -= a[k][c]*x[c];
		x[k] /= a[k][k];
	}
}

/* a [3][4]: derivatives of the conditions with respect to ln Rx, Ry0/|R0|, ln L, and minus their
 * residuals. */
static inline void quad_equations(quad a[3][4], quad *scale, const struct quad_span *span,
                                  const quad *z)
{
	quad row[3][4], want[3] = {span->d, span->h, span->value};

	quad_place(row, span, z, z[2]);
	quad_given(row[2], span, z);
	scale[0] = z[0];
	scale[1] = quad_sqrt(z[0]*z[0] + z[1]*z[1]);
	scale[2] = z[2];
	for (int j = 0; j < 3; j++) {
		for (int k = 0; k < 3; k++)
			a[j][k] = row[j][k + 1]*scale[k]/(j == 1 ? span->d + quad_abs(span->h) : want[j]);
		a[j][3] = (want[j] - row[j][0])/(j == 1 ? span->d + quad_abs(span->h) : want[j]);
	}
}

/* Newton's method from z [3]. Returns the size of the last step relative to the state. */
static inline double quad_newton(quad *z, const struct quad_span *span, int steps)
{
	double last = INFINITY;

	for (int n = 0; n < steps && last > 1e-26; n++) {
		quad a[3][4], step[3], scale[3], f;

		quad_equations(a, scale, span, z);
		quad_solve(step, a);
		last = (double)(quad_abs(step[0]) + quad_abs(step[1]) + quad_abs(step[2]));
		f = last > 0.5 ? 0.5/(quad)last : 1; /* damped far from the solution */
		for (int k = 0; k < 3; k++)
			z[k] += f*step[k]*scale[k];
		if (!(last < 1e300) || !(z[0] > 0) || !(z[2] > 0))
			return INFINITY;
	}
	return last;
}

/* Values of all outputs, and the sizes that their errors are relative to. */
static inline void quad_outputs(quad *out, const struct quad_span *span, const quad *z)
{
	quad rise = span->w*z[2]/z[0], part = 1 - span->p*span->i, R0, R1, sag[4];
	struct quad_arc arc = quad_arc_of(z[1]/z[0], rise);

	R0 = z[0]*arc.r0;
	R1 = z[0]*arc.r1;
	quad_sag(sag, span, z);
	out[0] = z[0];
	out[1] = R0;
	out[2] = R1;
	out[3] = z[2]/part;
	out[4] = sag[0];
	out[5] = (z[2] + span->i*z[0]*z[0]/(2*span->w)*(arc.u1*arc.r1 - z[1]/z[0]*arc.r0 + arc.angle))
	         /part;
	out[6] = z[1] + R0; /* V0 over the tension */
	out[7] = (R0 + span->p)/part;
	out[8] = (R1 + span->p)/part;
	out[9] = z[2];
}

/* *error and *stated of the output of st with the largest ratio of the two. *stated is `units` units in
 * the last place times the sum of 1, of the larger hyperbolic angle |asinh u| of the two ends, and of
 * the condition numbers of the output with respect to the inputs. For a strain above 1 it is ten times
 * larger. *error is NAN if there is no solution near st. */
static inline void quad_judge(double *error, double *stated, const struct hawser_statics *st,
                              struct quad_span *span, double units)
{
	const struct hawser_statics actual = hawser_statics_actual(st);
	quad z[3] = {st->H, st->V0, (quad)st->length0*(1 - span->p*span->i)}, out[QUAD_OUTPUTS];
	const quad got[QUAD_OUTPUTS] = {st->H, st->T0, st->T1, st->length0, st->sag, st->length,
	                                (quad)st->V0 + st->T0, actual.T0, actual.T1, actual.length0};
	const quad little = (quad)0x1p-53*(quad)1e-4;
	double room[QUAD_OUTPUTS], last = quad_newton(z, span, 30);

	*error = NAN;
	*stated = 0.0;
	if (!(last < 1e-18))
		return;
	if (fmax(st->T0, st->T1) > st->span.EA)
		units *= 10.0;
	quad_outputs(out, span, z);
	for (int k = 0; k < QUAD_OUTPUTS; k++)
		room[k] = 1.0 + fmax(fabs(asinh(st->V0/st->H)), fabs(asinh(st->V1/st->H)));
	for (int n = 0; n < QUAD_INPUTS; n++) {
		struct quad_span other = *span;
		quad *input[QUAD_INPUTS] = {&other.value, &other.i, &other.w, &other.d, &other.h, &other.p};
		quad moved[3] = {z[0], z[1], z[2]}, there[QUAD_OUTPUTS];

		*input[n] *= 1 + little;
		if (*input[n] == 0)
			continue;
		quad_newton(moved, &other, 1);
		quad_outputs(there, &other, moved);
		for (int k = 0; k < QUAD_OUTPUTS; k++)
			room[k] += fabs((double)((there[k] - out[k])/(little*(k == 6 ? out[1] : out[k]))));
	}
	*error = 0.0;
	for (int k = 0; k < QUAD_OUTPUTS; k++) {
		double e = fabs((double)((got[k] - out[k])/(k == 6 ? out[1] : out[k])));
		double s = units*0x1p-53*room[k];

		if (isnan(e) || isnan(s) || e*(*stated) > *error*s || *stated == 0.0) {
			*error = e;
			*stated = s;
		}
		if (isnan(e))
			return;
	}
}

#endif
