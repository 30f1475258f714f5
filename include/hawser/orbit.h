/* hawser/orbit.h - one forced periodic orbit of a reduced model: the period map on a fixed mesh,
 * its exact derivative, and Floquet multipliers from the segments' transition matrices.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ORBIT_H
#define HAWSER_ORBIT_H

#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What an orbit computation has cost so far. */
struct hawser_orbit_cost {
	long maps;      /* period maps without variational equations */
	long flows;     /* period maps with them */
	long stages;    /* Runge-Kutta stages in all of them */
	long solves;    /* bordered linear solves */
	double flops;   /* additions and multiplications in the stages, and in the factorisations of
	                 * the bordered matrix; 0 where a method doesn't count them */
};

/* Floquet multipliers of the product M = A[segments-1] ... A[1] A[0] of `segments` matrices [m][m]
 * (row-major, one after another in `segment`, overwritten), by the periodic QR algorithm: it never
 * forms the product, so that a multiplier of 1e-60 beside one of 1 keeps its digits. log_modulus
 * and argument are [m], sorted by falling modulus, complex pairs adjacent with the positive
 * argument first. Beyond 64 factors neighbours are multiplied. Of multipliers below about
 * exp(-660) a complex pair may be given as two real ones. Below -1e5 a logarithm is -1e5. */
enum hawser_status hawser_floquet_product(double *log_modulus, double *argument, double *segment,
                                          int segments, int m, struct hawser_report *report)
	HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
