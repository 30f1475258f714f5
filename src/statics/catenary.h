/* statics/catenary.h - internal to the statics stage: the span in scaled form, and an equilibrium
 * in variables without cancellation. Derivations: doc/theory-statics.md.
 *
 *   c      asinh of the chord's slope |h|/d: the chord's hyperbolic angle
 *   p, q   hyperbolic angles of the cable at its lower and at its upper end, sinh p = slope
 *   m, a   (p + q)/2 and (q - p)/2: mean angle and half width; 0 <= m <= c, a > 0
 *   w      rho*g, N/m          force  w*d/2, N          b  force/H = delta/2
 *   X      b - a = eps*cosh(m)*sinh(a) = b*epsilon*l: the share of the stretch in the span
 *
 * A span with end B below end A is the mirror image of one with B above A. The functions here
 * assume h >= 0 and refer to the lower and the upper end; solve.c mirrors the result.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_CATENARY_H
#define HAWSER_STATICS_CATENARY_H

#include <hawser/statics.h>

/* Quantities of the span that do not depend on the tension. */
struct hawser__chord {
	double EA;    /* N, may be INFINITY */
	double w;     /* N/m */
	double d, h;  /* m, h >= 0 */
	double force; /* w*d/2, N */
	double slope; /* h/d */
	double cosc;  /* cosh(c) = chord/d */
};

void hawser__chord_of(struct hawser__chord *chord, const struct hawser_span *span);

/* One equilibrium. */
struct hawser__catenary {
	double H;                /* N */
	double eps, b;           /* H/EA, force/H */
	double a, X;             /* b = a + X */
	double sinha, cosha, tanha;
	double excess;           /* sinh(a) - a */
	double K;                /* a*coth(a) - 1 */
	double D;                /* sinh(a) + X*cosh(a) */
	double sinhm, coshm, m;
	double da, dm;           /* derivatives of a and m by ln H */
	int iterations;          /* total number of iterations so far */
};

enum hawser__end { HAWSER__LOWER = 0, HAWSER__UPPER };

/* The lower or upper end to which T0 (or, for HAWSER_GIVEN_T1, T1) belongs. */
enum hawser__end hawser__end_of(const struct hawser_span *span, enum hawser_given given);

/* Set the members that depend on a alone: sinha to K. */
void hawser__catenary_width(struct hawser__catenary *cat, double a);

/* Set D, sinhm, coshm, m, da, dm from a and X. */
void hawser__catenary_lift(struct hawser__catenary *cat, const struct hawser__chord *chord);

/* The unique equilibrium at the horizontal tension H. `stretch` is an initial value of X/a, or 0.
 * Sets a = NAN if the result exceeds the range of double. */
void hawser__catenary_at(struct hawser__catenary *cat, const struct hawser__chord *chord, double H,
                         double stretch);

/* c - m: the angle of the chord minus the mean angle. The lower end lies a + (c - m) below the
 * angle of the chord, the upper end a - (c - m) above it. */
double hawser__catenary_gap(const struct hawser__catenary *cat, const struct hawser__chord *chord);

/* Tension at an end, N, and its derivative d ln T/d ln H. */
double hawser__catenary_tension(const struct hawser__catenary *cat, enum hawser__end end,
                                double *derivative);

/* Largest vertical distance from the chord, m, and its derivative d ln sag/d ln H. */
double hawser__catenary_sag(const struct hawser__catenary *cat, const struct hawser__chord *chord,
                            double *derivative);

/* Result of a search. */
enum hawser__found {
	HAWSER__FOUND = 0,
	HAWSER__NOT_FOUND,  /* there is no such equilibrium */
	HAWSER__RANGE  /* the result or an intermediate value exceeds the range of double */
};

/* Search for a given tension at an end. On HAWSER__NOT_FOUND *cat is the equilibrium with the least
 * tension. */
enum hawser__found hawser__from_tension(struct hawser__catenary *cat,
                                        const struct hawser__chord *chord,
                                        enum hawser__end end, double T,
                                        enum hawser_branch branch);
/* Least tension at an end, N, with its equilibrium in *cat; 0 if it exceeds the range of double. */
double hawser__least_tension(struct hawser__catenary *cat, const struct hawser__chord *chord,
                             enum hawser__end end);
enum hawser__found hawser__from_sag(struct hawser__catenary *cat,
                                    const struct hawser__chord *chord, double sag);
/* Search for a given unstretched length. HAWSER__NOT_FOUND: the cable is inextensible and no longer
 * than the chord. */
enum hawser__found hawser__from_length(struct hawser__catenary *cat,
                                       const struct hawser__chord *chord, double length0);

/* Irvine's lambda, classical and by B (4.60). */
double hawser__irvine(const struct hawser__catenary *cat, const struct hawser__chord *chord);
double hawser__irvine_source(const struct hawser__catenary *cat);

/* asinh(v) - asinh(u) for v >= u, given step = v - u, without cancellation. */
double hawser__angle_between(double u, double v, double step);

#endif
