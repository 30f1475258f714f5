/* hawser/orbit.h - the cost of periodic orbits, and Floquet multipliers from the transition matrices
 * of the segments of a period.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ORBIT_H
#define HAWSER_ORBIT_H

#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The cost of a computation of orbits so far. */
struct hawser_orbit_cost {
	long maps;      /* period maps without variational equations */
	long flows;     /* period maps with them */
	long stages;    /* Runge-Kutta stages of all period maps */
	long solves;    /* solutions of bordered linear systems */
	long judged;    /* sets of Floquet multipliers */
	double dense;   /* additions and multiplications in the linear systems of harmonic balance and in
	                 * the steps of multipliers */
	double flops;   /* additions and multiplications in the stages and in the factorisations of the
	                 * bordered matrix; 0 if the method does not count them */
};

/* What that costs with this model: seconds of processor time on a core of 2 GHz, counted, not
 * measured, so that what depends on it depends on neither the machine nor what else that does; within
 * a factor of about 2 (response/orbit/work.c). */
double hawser_orbit_work(const struct hawser_orbit_cost *cost, const struct hawser_rom *rom);

/* Floquet multipliers, that is eigenvalues of the product M = A[segments-1] ... A[1] A[0] of `segments`
 * matrices [m][m] (row-major, one after another in `segment`, overwritten), by the periodic QR
 * algorithm. The algorithm does not form the product, so that a multiplier of 1e-60 beside one of 1
 * keeps its digits. If there are more than 64 factors, neighbours are multiplied first. log_modulus
 * and argument are [m], by falling modulus; complex pairs are adjacent, the positive argument first. A
 * complex pair with moduli below about exp(-660) may be returned as two real multipliers. Logarithms
 * below -1e5 become -1e5. */
enum hawser_status hawser_floquet_product(double *log_modulus, double *argument, double *segment,
                                          int segments, int m, struct hawser_report *report)
	HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
