/* net/modes/eigen-dense.c - all modes of a small mesh by dense matrices; see eigen.h.
 *
 * mu    eigenvalues of M*x = mu*K*x, mu = 1/omega^2
 *
 * A Lanczos basis of a few unknowns is exhausted before it holds the modes that are wanted: what is
 * left outside it is round-off, with EA/T = 1e8 from the 7th vector on. LAPACK's dsygvd has no such
 * end, and takes some ms for a hundred unknowns. K, not M, is the definite matrix: M is singular
 * where nodes have no mass, and the low modes, whose mu are the largest, have the smallest errors.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <lapacke.h>

#include "core/report.h"
#include "net/modes/eigen.h"

enum { COLUMN = 102 /* LAPACK_COL_MAJOR */ };

/* Columns of K and M: images of unit vectors. */
static void matrices(double *K, double *M, const struct hawser__eigen *eigen)
{
	size_t n = (size_t)eigen->mesh->unknowns;
	double *unit = M + n*n; /* [n], zero */

	for (size_t j = 0; j < n; j++) {
		unit[j] = 1.0;
		hawser__eigen_stiffness(K + j*n, unit, eigen);
		hawser__eigen_mass(M + j*n, unit, eigen->mesh, 7U);
		unit[j] = 0.0;
	}
}

/* Modes up to the first gap at or after mode n, and a shift in that gap. */
static void up_to_gap(struct hawser__eigen *eigen, const double *mu)
{
	int last = eigen->mesh->unknowns - 1, found = eigen->n;
	double gap = 0.0;

	while (found < eigen->massive &&
	       mu[last - found] >= mu[last - found + 1]/(1.0 + HAWSER__EIGEN_EQUAL))
		found++;
	eigen->found = found;
	eigen->shift = 0.0;
	if (found < eigen->massive)
		gap = mu[last - found + 1]/mu[last - found] - 1.0;
	if (gap > 0.0)
		eigen->shift = (1.0 + fmin(0.5*gap, HAWSER__EIGEN_ABOVE))/mu[last - found + 1];
}

enum hawser_status hawser__eigen_dense(struct hawser__eigen *eigen, struct hawser_report *report)
{
	size_t n = (size_t)eigen->mesh->unknowns;
	double *M = calloc(2*n*n + 2*n, sizeof *M), *K = M ? M + n*n + n : NULL, *mu = M ? K + n*n : NULL;
	enum hawser_status status = M ? HAWSER_OK : hawser__no_memory(report, "net");
	int info = 0;

	if (!status) {
		matrices(K, M, eigen);
		info = LAPACKE_dsygvd(COLUMN, 1, 'V', 'L', (int)n, M, (int)n, K, (int)n, mu);
		eigen->dense = 1;
	}
	if (info != 0)
		status = hawser__lapack_starved(info) ? hawser__no_memory(report, "net")
			: hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: the stiffness of the net is not "
			               "positive to double precision: a part of it is too stiff for its tension",
			               eigen->name);
	if (!status) {
		up_to_gap(eigen, mu);
		eigen->x = malloc((size_t)eigen->found*n*sizeof *eigen->x);
		eigen->value = malloc((size_t)eigen->found*sizeof *eigen->value);
		eigen->error = calloc((size_t)eigen->found, sizeof *eigen->error);
		if (!eigen->x || !eigen->value || !eigen->error)
			status = hawser__no_memory(report, "net");
	}
	for (int j = 0; j < eigen->found && !status; j++) {
		size_t at = n - 1 - (size_t)j;

		eigen->value[j] = 1.0/mu[at];
		for (size_t i = 0; i < n; i++) /* x'*K*x = 1 */
			eigen->x[(size_t)j*n + i] = M[at*n + i]/sqrt(mu[at]);
	}
	free(M);
	return status;
}
