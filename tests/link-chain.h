/* tests/link-chain.h - a chain of links between nodes of a static profile, for tests of modes. A link
 * has the stiffness EA over its length along it and the tension over it across; results are of second
 * order in the length of the links.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_LINK_CHAIN_H
#define HAWSER_TESTS_LINK_CHAIN_H

#include <lapacke.h>
#include <math.h>

#include <hawser/statics.h>

/* A [n][n], with nothing outside: an end that is held has no unknowns. */
static inline void link_add(double *A, int n, int i, int j, double value)
{
	if (i >= 0 && j >= 0 && i < n && j < n)
		A[i*n + j] += value;
}

/* The link from one arclength to another, between nodes whose first unknowns are `low` and `high`, of
 * `axes` (2: in the plane, 3) each. */
static inline void link_between(double *K, double *M, int n, int low, int high, int axes,
                                const struct hawser_statics *st, double from, double to)
{
	struct hawser_profile_point a = hawser_statics_at(st, from), b = hawser_statics_at(st, to);
	double middle = hawser_statics_at(st, 0.5*(from + to)).T, L = hypot(b.x - a.x, b.y - a.y);
	double e[3] = {(b.x - a.x)/L, (b.y - a.y)/L, 0.0};
	double axial = st->span.EA/(to - from), across = middle/L;

	for (int p = 0; p < axes; p++) {
		for (int q = 0; q < axes; q++) {
			double k = axial*e[p]*e[q] + across*((p == q) - e[p]*e[q]);

			link_add(K, n, high + p, high + q, k);
			link_add(K, n, low + p, low + q, k);
			link_add(K, n, low + p, high + q, -k);
			link_add(K, n, high + q, low + p, -k);
		}
		link_add(M, n, high + p, high + p, 0.5*st->span.rho*(to - from));
		link_add(M, n, low + p, low + p, 0.5*st->span.rho*(to - from));
	}
}

/* omega [n] (rad/s) of K and M, which are overwritten. */
static inline void link_frequencies(double *omega, double *K, double *M, int n)
{
	if (LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'L', n, K, n, M, n, omega))
		omega[0] = NAN;
	for (int i = 0; i < n; i++)
		omega[i] = sqrt(omega[i]);
}

#endif
