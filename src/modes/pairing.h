/* modes/pairing.h - derivatives of an energy by shapes: of third order by three of them, of fourth
 * order as the sum over the three ways to pair four. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_PAIRING_H
#define HAWSER_MODES_PAIRING_H

#include <stddef.h>

#include <hawser/status.h>

/* Index of the pair j <= k. */
static inline int hawser__pair(int j, int k)
{
	return j <= k ? k*(k + 1)/2 + j : j*(j + 1)/2 + k;
}

/* Third derivative of the energy of a point, by strains a, b, c, over weight*EA/g^2. */
static inline double hawser__third_at(const double x[3], const double y[3], const double z[3])
{
	return x[0]*(y[1]*z[1] + y[2]*z[2]) + y[0]*(x[1]*z[1] + x[2]*z[2]) +
	       z[0]*(x[1]*y[1] + x[2]*y[2]);
}

/* And the force of x and y against strains, over the same: that derivative is its work on z. */
static inline void hawser__pair_force(double f[3], const double x[3], const double y[3])
{
	f[0] = x[1]*y[1] + x[2]*y[2];
	f[1] = x[0]*y[1] + y[0]*x[1];
	f[2] = x[0]*y[2] + y[0]*x[2];
}

/* third [n][n][n] of the values `by` of all j <= k <= l. HAWSER_ERR_NAN: one is not finite. */
enum hawser_status hawser__third_fill(double *third, int n,
                                      double (*by)(const void *of, int j, int k, int l),
                                      const void *of, const char *place,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* The fourth derivative, of pairing [pairs][pairs]: what one way to pair the indices gives. */
double hawser__pairings(const double *pairing, int pairs, const int index[4]);

#endif
