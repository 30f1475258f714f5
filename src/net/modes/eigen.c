/* net/modes/eigen.c - the eigenproblem of a mesh: what has modes, the accuracy of modes, and the
 * count of those below a shift; see eigen.h.
 *
 * The factors of K have errors of EA/T*(cable/element)^2 times round-off. Products K*x by elements do
 * not, since a mode hardly stretches elements. Vectors of lanczos.c are therefore improved: inverse
 * iteration with a correction by K*x, and projections of K by elements, whose eigenvalues are wrong
 * by the square of the vectors' errors.
 *
 * Bound: with r = K*x - lambda*M*x there is an eigenvalue within lambda*|r|/|x|, |r|^2 = r'*inv(K)*r
 * and |x|^2 = x'*K*x (expand x in the modes). No unit and no stiff direction enters.
 *
 * Count (Sylvester): K - shift*M = L*D*L' has as many negative pivots as there are modes below the
 * shift. L*D*L' of an indefinite matrix without pivoting may lose digits: the factors are trusted if
 * they solve for a known mode next to the shift.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cblas.h>
#include <lapacke.h>

#include "core/hold.h"
#include "core/report.h"
#include "net/modes/eigen.h"

enum { DENSE = 60, DENSE_AT_MOST = 1000, /* unknowns; a thousand take 2 s */
       DEFAULT = 6, SWEEPS = 6, LIFTS = 6, COLUMN = 102 /* LAPACK_COL_MAJOR */ };
static const double good = 1e-11;  /* bound at which a mode needs no more improvement */
static const double usable = 1e-4; /* bound above which there is no answer: four digits */
static const double edge = 1e-12;  /* strain at which an element is neither slack nor taut */

void hawser__eigen_clear(struct hawser__eigen *eigen)
{
	hawser__border_clear(eigen->border);
	hawser__sparse_clear(eigen->sparse);
	free(eigen->x);
	free(eigen->value);
	free(eigen->error);
	free(eigen->work);
	memset(eigen, 0, sizeof *eigen);
}

/* --- what has modes --- */

static enum hawser_status no_stiffness(const struct hawser__eigen *eigen, const struct hawser_net *net,
                                       struct hawser_report *report)
{
	const struct hawser__mesh *mesh = eigen->mesh;
	int slack = -1;

	for (int e = 0; e < mesh->elements; e++)
		if (eigen->T[e] <= 0.0 && (slack < 0 || (net->cable[mesh->cable[e]].elements > 1 &&
		                                          net->cable[slack].elements == 1)))
			slack = mesh->cable[e];
	if (slack >= 0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: cable %s is slack in the "
		                    "equilibrium, and without its stiffness a part of the net is not held, "
		                    "so that there are no modes about it: shorten the cable, load it, give it "
		                    "one element, or leave it out", net->name, net->cable[slack].name);
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: the stiffness of the net is not "
	                    "positive to double precision: a part of it has next to no tension", net->name);
}

static enum hawser_status look(struct hawser__eigen *eigen, const struct hawser_net *net,
                               struct hawser_report *report)
{
	const struct hawser__mesh *mesh = eigen->mesh;

	for (int e = 0; e < mesh->elements; e++) {
		double d[3], strain = eigen->T[e] > 0.0 ? eigen->T[e]/mesh->EA[e]
			: hawser__mesh_direction(d, mesh, e)/mesh->length0[e] - 1.0;
		char more[80] = "";
		int moves = 0;

		for (int i = 0; i < 6; i++)
			moves |= mesh->unknown[mesh->end[e][i/3]][i%3] >= 0;
		if (moves && fabs(strain) <= edge && eigen->T[e] > 0.0)
			snprintf(more, sizeof more, ", or its EA, which is %.1e times its tension",
			         mesh->EA[e]/eigen->T[e]);
		if (moves && fabs(strain) <= edge)
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: cable %s has an element "
			                    "that is neither slack nor taut in the equilibrium (strain %.1e), so "
			                    "that its stiffness differs between both directions: there are no "
			                    "linear modes; change its length0%s", net->name,
			                    net->cable[mesh->cable[e]].name, strain, more);
		eigen->slack += eigen->T[e] <= 0.0 && !net->cable[mesh->cable[e]].rod;
	}
	return HAWSER_OK;
}

static enum hawser_status count_massive(struct hawser__eigen *eigen, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = eigen->mesh;
	double *heavy = calloc((size_t)mesh->nodes, sizeof *heavy);
	unsigned char *has = calloc((size_t)mesh->unknowns + 1, 1);

	if (!heavy || !has) {
		free(heavy);
		free(has);
		return hawser__no_memory(report, "net");
	}
	for (int i = 0; i < mesh->nodes; i++)
		heavy[i] = mesh->mass[i];
	for (int i = 0; i < mesh->absorbers; i++)
		heavy[mesh->absorber[i].at] = mesh->absorber[i].mass;
	for (int e = 0; e < mesh->elements; e++)
		for (int end = 0; end < 2; end++)
			heavy[mesh->end[e][end]] += mesh->rho[e]*mesh->length0[e];
	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0 && heavy[i/3] > 0.0)
			has[mesh->unknown[i/3][i%3]] = 1;
	for (int i = 0; i < mesh->rotors; i++)
		has[mesh->rotor[i].unknown] |= mesh->rotor[i].mass > 0.0;
	for (int i = 0; i < mesh->unknowns; i++)
		eigen->massive += has[i];
	eigen->massive += mesh->body_unknowns;
	free(heavy);
	free(has);
	return HAWSER_OK;
}

/* K + lift*M in place of K: T/(rho*L^2) with the means of tensions and masses over all cables, of
 * length L together, or 1 for bodies alone; and 10 times more in each further round. */
static enum hawser_status lifted(struct hawser__eigen *eigen, int round, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = eigen->mesh;
	double T = 0.0, mass = 0.0, length = 0.0;

	for (int i = 0; i < mesh->nodes; i++)
		mass += mesh->mass[i];
	for (int e = 0; e < mesh->elements; e++) {
		T += mesh->net->cable[mesh->cable[e]].rod ? 0.0 : fmax(eigen->T[e], 0.0)*mesh->length0[e];
		mass += mesh->rho[e]*mesh->length0[e];
		length += mesh->length0[e];
	}
	eigen->lift = round > 1 ? 10.0*eigen->lift : T > 0.0 ? T/(mass*length*length) : 1.0;
	if (!eigen->work)
		eigen->work = malloc(((size_t)mesh->unknowns + 1)*sizeof *eigen->work);
	return eigen->work ? HAWSER_OK : hawser__no_memory(report, "net");
}

enum hawser_status hawser__eigen_open(struct hawser__eigen *eigen, const struct hawser__mesh *mesh,
                                      const double *T, const struct hawser_net *net, int n,
                                      struct hawser_report *report)
{
	struct hawser__mesh nodes = *mesh; /* without bodies */
	enum hawser_status status;
	int definite = 0, negative = 0;

	nodes.unknowns -= mesh->body_unknowns;
	*eigen = (struct hawser__eigen){.mesh = mesh, .T = T, .name = net->name, .n = n};
	status = count_massive(eigen, report);
	if (!status && eigen->massive == 0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: nothing that can move has a "
		                    "mass, so that there are no modes: give a cable a rho, or a node a mass",
		                    net->name);
	if (n <= 0) {
		eigen->n = n ? -n : DEFAULT;
		eigen->n = eigen->massive < eigen->n ? eigen->massive : eigen->n;
	}
	if (!status && (eigen->n < 1 || eigen->n > eigen->massive))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the mesh has %d unknowns with "
		                    "mass: ask for 1 to %d modes, not %d", net->name, eigen->massive,
		                    eigen->massive, n);
	if (!status)
		status = look(eigen, net, report);
	if (!status)
		status = hawser__sparse_open(&eigen->sparse, &nodes, report);
	for (int round = 0; round <= LIFTS && !status && !definite; round++) {
		if (round > 0)
			status = lifted(eigen, round, report);
		if (status || !isfinite(eigen->lift) || (round > 0 && !mesh->frame && !mesh->body))
			break;
		hawser__sparse_zero(eigen->sparse);
		hawser__eigen_assemble(eigen->sparse, eigen, 0.0);
		status = hawser__sparse_factor(eigen->sparse, &definite, report);
		if (status || !definite || !mesh->body_unknowns)
			continue;
		hawser__border_clear(eigen->border);
		status = hawser__border_open(&eigen->border, &negative, eigen, eigen->sparse, 0.0, report);
		definite = !negative;
	}
	if (!status && !definite)
		status = no_stiffness(eigen, net, report);
	if (status)
		hawser__eigen_clear(eigen);
	return status;
}

/* --- the count --- */

/* Largest component of x - inv(A)*A*x over that of x: what round-off has done to the factors of A =
 * K - shift*M, where it matters most. */
static enum hawser_status defect(double *most, struct hawser__border *border,
                                 struct hawser__sparse *sparse, const struct hawser__eigen *eigen,
                                 double shift, const double *x, struct hawser_report *report)
{
	int n = eigen->mesh->unknowns;
	double *y = malloc(2*((size_t)n + 1)*sizeof *y), *m = hawser__behind(y, (size_t)n + 1);
	double off = 0.0, size = 0.0;
	enum hawser_status status;

	if (!y)
		return hawser__no_memory(report, "net");
	hawser__eigen_stiffness(y, x, eigen);
	hawser__eigen_mass(m, x, eigen->mesh, 7U);
	cblas_daxpy(n, -shift, m, 1, y, 1);
	status = hawser__border_solve(y, border, sparse, report);
	for (int i = 0; i < n; i++) {
		off = fabs(y[i] - x[i]) <= off ? off : fabs(y[i] - x[i]);
		size = fmax(size, fabs(x[i]));
	}
	*most = off/size;
	free(y);
	return status;
}

enum hawser_status hawser__eigen_count(int *below, int *sure, const struct hawser__eigen *eigen,
                                       double shift, const double *near, struct hawser_report *report)
{
	struct hawser__sparse *sparse = NULL;
	struct hawser__border *border = NULL;
	struct hawser__mesh nodes = *eigen->mesh; /* without bodies */
	enum hawser_status status;
	double off = 1.0;
	int more = 0;

	nodes.unknowns -= nodes.body_unknowns;
	status = hawser__sparse_open_indefinite(&sparse, &nodes, report);

	*below = *sure = 0;
	if (!status) {
		hawser__eigen_assemble(sparse, eigen, shift);
		status = hawser__sparse_inertia(below, sure, sparse, report);
	}
	if (!status && *sure && nodes.body_unknowns)
		status = hawser__border_open(&border, &more, eigen, sparse, shift, report);
	*below += more;
	if (!status && *sure)
		status = defect(&off, border, sparse, eigen, shift, near, report);
	*sure = *sure && off < 0.1;
	hawser__border_clear(border);
	hawser__sparse_clear(sparse);
	return status;
}

/* --- accuracy --- */

/* y = inv(K)*b with one correction; r: work space. */
static enum hawser_status solve(double *y, double *r, const double *b, struct hawser__eigen *eigen,
                                struct hawser_report *report)
{
	int n = eigen->mesh->unknowns;
	enum hawser_status status;

	memcpy(y, b, (size_t)n*sizeof *y);
	status = hawser__border_solve(y, eigen->border, eigen->sparse, report);
	if (status)
		return status;
	hawser__eigen_stiffness(r, y, eigen);
	for (int i = 0; i < n; i++)
		r[i] = b[i] - r[i];
	status = hawser__border_solve(r, eigen->border, eigen->sparse, report);
	cblas_daxpy(n, 1.0, r, 1, y, 1);
	eigen->iterations += 2;
	return status;
}

enum hawser_status hawser__eigen_bound(struct hawser__eigen *eigen, struct hawser_report *report)
{
	int n = eigen->mesh->unknowns;
	double *r = malloc(3*((size_t)n + 1)*sizeof *r), *m = hawser__behind(r, (size_t)n + 1);
	double *y = hawser__behind(m, (size_t)n + 1);
	enum hawser_status status = r ? HAWSER_OK : hawser__no_memory(report, "net");

	for (int j = 0; j < eigen->found && !status; j++) {
		const double *x = eigen->x + (size_t)j*(size_t)n;
		double energy;

		hawser__eigen_stiffness(r, x, eigen);
		hawser__eigen_mass(m, x, eigen->mesh, 7U);
		energy = cblas_ddot(n, x, 1, r, 1);
		cblas_daxpy(n, -eigen->value[j], m, 1, r, 1);
		memcpy(y, r, (size_t)n*sizeof *y);
		status = hawser__border_solve(y, eigen->border, eigen->sparse, report);
		eigen->error[j] = sqrt(fmax(cblas_ddot(n, r, 1, y, 1), 0.0)/energy)/2.0;
	}
	free(r);
	return status;
}

struct sweep {
	double *y, *ky, *my; /* [found][unknowns] */
	double *k, *m;       /* [found][found] */
	double *r;           /* [unknowns] */
};

/* Ritz vectors of K and M on y, into eigen->x. */
static enum hawser_status project(struct hawser__eigen *eigen, struct sweep *sweep,
                                  struct hawser_report *report)
{
	int n = eigen->mesh->unknowns, q = eigen->found, info;

	for (int j = 0; j < q; j++) {
		double *y = sweep->y + (size_t)j*(size_t)n, *my = sweep->my + (size_t)j*(size_t)n, scale;

		hawser__eigen_mass(my, y, eigen->mesh, 7U);
		scale = 1.0/sqrt(cblas_ddot(n, y, 1, my, 1));
		cblas_dscal(n, scale, y, 1);
		cblas_dscal(n, scale, my, 1);
		hawser__eigen_stiffness(sweep->ky + (size_t)j*(size_t)n, y, eigen);
	}
	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, q, q, n, 1.0, sweep->y, n, sweep->ky, n, 0.0,
	            sweep->k, q);
	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, q, q, n, 1.0, sweep->y, n, sweep->my, n, 0.0,
	            sweep->m, q);
	info = LAPACKE_dsygvd(COLUMN, 1, 'V', 'L', q, sweep->k, q, sweep->m, q, eigen->value);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "net");
	if (info != 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: the modes cannot be told "
		                    "apart to double precision: ask for fewer than %d", eigen->name, eigen->n);
	cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, q, q, 1.0, sweep->y, n, sweep->k, q, 0.0,
	            eigen->x, n);
	return HAWSER_OK;
}

static double worst(const struct hawser__eigen *eigen)
{
	double most = 0.0;

	for (int j = 0; j < eigen->found; j++)
		if (!(eigen->error[j] <= most))
			most = eigen->error[j];
	return most;
}

/* Inverse iteration until the bounds are good, or no sweep betters them. */
static enum hawser_status improve(struct hawser__eigen *eigen, struct sweep *sweep,
                                  struct hawser_report *report)
{
	size_t n = (size_t)eigen->mesh->unknowns;
	double last = HUGE_VAL;

	for (int k = 0; k < SWEEPS; k++) {
		enum hawser_status status = HAWSER_OK;

		for (int j = 0; j < eigen->found && !status; j++) {
			hawser__eigen_mass(sweep->my, eigen->x + (size_t)j*n, eigen->mesh, 7U);
			status = solve(sweep->y + (size_t)j*n, sweep->r, sweep->my, eigen, report);
		}
		if (!status)
			status = project(eigen, sweep, report);
		if (!status)
			status = hawser__eigen_bound(eigen, report);
		if (status)
			return status;
		if (worst(eigen) <= good || worst(eigen) > 0.5*last)
			break;
		last = worst(eigen);
	}
	return worst(eigen) <= usable ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: the frequencies are known to %.1e "
		               "only, by round-off: a part of the net is too stiff, or its elements too short, "
		               "for its tension", eigen->name, worst(eigen));
}

/* The first vectors: by dense matrices if there are few unknowns, and where a Lanczos basis of not too
 * many is exhausted by round-off. */
static enum hawser_status vectors(struct hawser__eigen *eigen, struct hawser_report *report)
{
	int unknowns = eigen->mesh->unknowns;
	struct hawser_report unused = {0};
	enum hawser_status status;

	if (unknowns <= DENSE)
		return hawser__eigen_dense(eigen, report);
	status = hawser__eigen_lanczos(eigen, unknowns > DENSE_AT_MOST ? report : &unused);
	if (unknowns > DENSE_AT_MOST || !status)
		return status;
	return status == HAWSER_ERR_CONVERGENCE ? hawser__eigen_dense(eigen, report)
	                                        : hawser__no_memory(report, "net");
}

enum hawser_status hawser__eigen_solve(struct hawser__eigen *eigen, struct hawser_report *report)
{
	struct sweep sweep = {0};
	enum hawser_status status = vectors(eigen, report);
	size_t q = (size_t)eigen->found, n = (size_t)eigen->mesh->unknowns;

	if (status)
		return status;
	sweep.y = malloc(q*n*sizeof *sweep.y);
	sweep.ky = malloc(q*n*sizeof *sweep.ky);
	sweep.my = malloc(q*n*sizeof *sweep.my);
	sweep.k = malloc(q*q*sizeof *sweep.k);
	sweep.m = malloc(q*q*sizeof *sweep.m);
	sweep.r = malloc(n*sizeof *sweep.r);
	if (!sweep.y || !sweep.ky || !sweep.my || !sweep.k || !sweep.m || !sweep.r)
		status = hawser__no_memory(report, "net");
	else
		status = improve(eigen, &sweep, report);
	free(sweep.y);
	free(sweep.ky);
	free(sweep.my);
	free(sweep.k);
	free(sweep.m);
	free(sweep.r);
	return status;
}
