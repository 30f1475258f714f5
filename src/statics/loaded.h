/* statics/loaded.h - internal to the statics stage: a cable with point masses.
 *
 *   H, V0, L   horizontal force, vertical force at end A, unstretched length: the unknowns
 *   V          vertical force: V0 + w*S + the weights W_i with S_i <= S
 *   x, y       position of end B that they give; the equilibrium has x = d, y = h
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_LOADED_H
#define HAWSER_STATICS_LOADED_H

#include <hawser/statics.h>

struct hawser__load_point {
	double at; /* fraction of the length, or length in m if `fixed` */
	int fixed;
	double W;  /* N */
};

struct hawser__loaded {
	double EA, w, d, h; /* N, N/m, m, m */
	int count;
	struct hawser__load_point load[HAWSER_ATTACH_MAX]; /* [count], ascending S for the length that
	                                                    * `sort` has seen */
	double weight;   /* N, of all loads */
	double H, V0, L; /* the state */
	int iterations;
};

/* The end of the profile and its derivatives at a state; also those of a point before the end. */
struct hawser__reach {
	double x, y;
	double xH, xV, xL, yH, yV, yL; /* xV = yH */
	double length;                 /* stretched */
};

/* S of load i, at most L, and its derivative by L. */
double hawser__load_place(const struct hawser__loaded *cable, int i, double *by_L);

/* Position of the point S, of which S_L is the derivative by L, at the state of *cable. */
void hawser__loaded_reach(struct hawser__reach *reach, const struct hawser__loaded *cable, double S,
                          double S_L);

/* Vertical force at S, without the load at S itself. */
double hawser__loaded_force(const struct hawser__loaded *cable, double S);

/* Largest vertical distance from the chord, and its derivative by H along the equilibria with
 * derivatives V' and L' by H. */
double hawser__loaded_sag(const struct hawser__loaded *cable, double V_H, double L_H,
                          double *derivative);

#endif
