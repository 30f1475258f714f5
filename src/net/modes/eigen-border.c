/* net/modes/eigen-border.c - the motions of rigid bodies beside the sparse matrix of the nodes; see
 * eigen.h.
 *
 * A = [S, F; F', R]  S of the nodes, by its factors; F, R of the motions of bodies, few and dense
 * Z = inv(S)*F       and C = R - F'*Z = Q*diag(c)*Q'
 *
 * A solution is one with S and one with C. A has as many negative pivots as S and C together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <cblas.h>
#include <lapacke.h>

#include "core/hold.h"
#include "core/report.h"
#include "net/modes/eigen.h"

enum { COLUMN = 102 /* LAPACK_COL_MAJOR */ };
/* Of the largest of C beside which an eigenvalue is round-off. */
static const double ROUND = 1e-13;

struct hawser__border {
	int n, nodes;        /* motions of bodies; unknowns of nodes */
	double *Z, *C, *c;   /* [n][nodes], [n][n] Q, [n] */
	double *t, *z;       /* [n] */
	struct hawser__hold hold;
};

void hawser__border_clear(struct hawser__border *border)
{
	if (!border)
		return;
	hawser__hold_clear(&border->hold);
	free(border);
}

/* Column j of F and R, of K - shift*M. */
static void column(double *to, double *unit, double *mass, const struct hawser__eigen *eigen, int j,
                   double shift)
{
	const struct hawser__mesh *mesh = eigen->mesh;

	unit[j] = 1.0;
	hawser__eigen_stiffness(to, unit, eigen);
	hawser__eigen_mass(mass, unit, mesh, 7U);
	cblas_daxpy(mesh->unknowns, -shift, mass, 1, to, 1);
	unit[j] = 0.0;
}

static enum hawser_status fill(struct hawser__border *border, double *F, double *unit,
                               const struct hawser__eigen *eigen, struct hawser__sparse *sparse,
                               double shift, struct hawser_report *report)
{
	size_t n = (size_t)border->n, nodes = (size_t)border->nodes, all = n + nodes;
	enum hawser_status status = HAWSER_OK;

	for (size_t j = 0; j < n && !status; j++) {
		column(F + j*all, unit, unit + all, eigen, (int)(nodes + j), shift);
		memcpy(border->Z + j*nodes, F + j*all, nodes*sizeof *border->Z);
		if (nodes > 0)
			status = hawser__sparse_solve(border->Z + j*nodes, sparse, report);
	}
	for (size_t i = 0; i < n*n && !status; i++)
		border->C[i] = F[i/n*all + nodes + i % n] - cblas_ddot((int)nodes, F + i % n*all, 1,
		                                                       border->Z + i/n*nodes, 1);
	return status;
}

enum hawser_status hawser__border_open(struct hawser__border **made, int *negative,
                                       const struct hawser__eigen *eigen,
                                       struct hawser__sparse *sparse, double shift,
                                       struct hawser_report *report)
{
	int own = eigen->mesh->body_unknowns, info;
	size_t n = (size_t)own, nodes = (size_t)eigen->mesh->unknowns - n;
	struct hawser__border *border = calloc(1, sizeof *border);
	double *F = hawser__numbers(n + 2, n + nodes);
	enum hawser_status status = border && F ? HAWSER_OK : hawser__no_memory(report, "net");

	*made = border;
	*negative = 0;
	if (!status) {
		border->n = own;
		border->nodes = (int)nodes;
		border->Z = hawser__hold(&border->hold, n*nodes + 1, sizeof *border->Z);
		border->C = hawser__hold(&border->hold, n*n + 1, sizeof *border->C);
		border->c = hawser__hold(&border->hold, n + 1, sizeof *border->c);
		border->t = hawser__hold(&border->hold, n + 1, sizeof *border->t);
		border->z = hawser__hold(&border->hold, n + 1, sizeof *border->z);
		status = border->hold.short_of_memory ? hawser__no_memory(report, "net")
			: fill(border, F, F + n*(n + nodes), eigen, sparse, shift, report);
	}
	free(F);
	if (status)
		return status;
	info = LAPACKE_dsyev(COLUMN, 'V', 'L', own, border->C, own, border->c);
	if (info != 0)
		return hawser__lapack_starved(info) ? hawser__no_memory(report, "net")
			: hawser__fail(report, HAWSER_ERR_NAN, "net", "%s: the stiffness of the bodies is not "
			               "finite", eigen->name);
	for (int i = 0; i < own; i++)
		*negative += border->c[i] <= ROUND*border->c[own - 1];
	return HAWSER_OK;
}

enum hawser_status hawser__border_solve(double *x, struct hawser__border *border,
                                        struct hawser__sparse *sparse, struct hawser_report *report)
{
	int n = border ? border->n : 0, nodes = border ? border->nodes : 0;
	enum hawser_status status;

	if (!border)
		return hawser__sparse_solve(x, sparse, report);
	for (int j = 0; j < n; j++)
		border->t[j] = x[nodes + j] - cblas_ddot(nodes, border->Z + (size_t)j*(size_t)nodes, 1, x, 1);
	cblas_dgemv(CblasColMajor, CblasTrans, n, n, 1.0, border->C, n, border->t, 1, 0.0, border->z, 1);
	for (int j = 0; j < n; j++)
		border->z[j] /= border->c[j];
	cblas_dgemv(CblasColMajor, CblasNoTrans, n, n, 1.0, border->C, n, border->z, 1, 0.0, x + nodes, 1);
	status = nodes > 0 ? hawser__sparse_solve(x, sparse, report) : HAWSER_OK;
	for (int j = 0; j < n; j++)
		cblas_daxpy(nodes, -x[nodes + j], border->Z + (size_t)j*(size_t)nodes, 1, x, 1);
	return status;
}
