/* tests/friction-siconos.c - see friction-siconos.h.
 *
 * M  the problem's matrix, dense, with held directions taken out, [size][size]; size: 3 nodes
 * H  rows of the contacts: normal, tangents, [n][size]; n: 3 contacts
 * W  H M^-1 H^T, Delassus' operator, [n][n]
 * q  w without contact, so that w = W r + q
 *
 * Siconos is loaded when it is asked for: linked, it would make each start of a program some 20 ms
 * longer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/friction-siconos.h"

#ifdef HAVE_SICONOS

#include <lapacke.h>

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <LinearComplementarityProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <NumericsVerbose.h>
#include <SolverOptions.h>
#include <lcp_cst.h>

#include "core/loaded.h"

/* Of its error, which is a mean over the contacts. */
static const double tolerance = 1e-12;
/* Iterations allowed, of Gauss and Seidel's method and of the others. */
enum { SWEEPS = 200000, STEPS = 2000 };

static const struct {
	const char *name;
	int id;
} methods[] = {
	{"lemke", SICONOS_LCP_LEMKE}, {"nsgs", SICONOS_FRICTION_3D_NSGS},
	{"nsn_ac", SICONOS_FRICTION_3D_NSN_AC},
};
enum { METHODS = sizeof methods/sizeof *methods };

/* Its functions, of the types that its headers declare. */
static struct {
	void *library;
	__typeof__(&numerics_set_verbose) verbose;
	__typeof__(&solver_options_create) create;
	__typeof__(&solver_options_delete) drop;
	__typeof__(&NM_create_from_data) matrix;
	__typeof__(&NM_clear) clear;
	__typeof__(&linearComplementarity_driver) lcp;
	__typeof__(&fc3d_driver) fc3d;
} by;

#define FIND(member, name) hawser__loaded(&by.member, sizeof by.member, by.library, #name)

static int loaded(void)
{
	if (!by.library)
		by.library = dlopen("libsiconos_numerics.so", RTLD_LAZY | RTLD_LOCAL);
	return by.library && FIND(verbose, numerics_set_verbose) && FIND(create, solver_options_create) &&
	       FIND(drop, solver_options_delete) && FIND(matrix, NM_create_from_data) &&
	       FIND(clear, NM_clear) && FIND(lcp, linearComplementarity_driver) && FIND(fc3d, fc3d_driver);
}

const char *siconos_method(int index)
{
	return loaded() && index < METHODS ? methods[index].name : NULL;
}

/* The problem in dense matrices, and what is solved with them. */
struct dense {
	int size, n;
	double *M, *Y; /* Y [n + 1][size]: rows H and p, then M^-1 of each */
	double *H, *W, *q, *r, *w, *mu, *work;
};

static void block(struct dense *of, int row, int column, const double B[9], int transposed)
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			of->M[(3*row + i)*of->size + 3*column + j] += B[transposed ? 3*j + i : 3*i + j];
}

static void assemble(struct dense *of, const struct hawser_friction_problem *problem, int nodes,
                     const int (*link)[2], int links)
{
	for (int i = 0; i < nodes; i++)
		block(of, i, i, problem->diagonal[i], 0);
	for (int e = 0; e < links; e++) {
		block(of, link[e][0], link[e][1], problem->off[e], 0);
		block(of, link[e][1], link[e][0], problem->off[e], 1);
	}
	memcpy(of->Y + of->n*of->size, problem->right, (size_t)of->size*sizeof *of->Y);
	for (int c = 0; c < problem->contacts; c++) {
		const struct hawser_contact *contact = &problem->contact[c];

		for (int k = 0; k < 3; k++)
			memcpy(of->H + (3*c + k)*of->size + 3*contact->node, k ? contact->tangent[k - 1]
			       : contact->normal, sizeof contact->normal);
	}
	memcpy(of->Y, of->H, (size_t)(of->n*of->size)*sizeof *of->Y);
}

static int held(const struct hawser_friction_problem *problem, int d)
{
	return problem->held && problem->held[d/3] & 1U << d%3;
}

/* A held direction has its velocity, and no impulse moves it. */
static void hold(struct dense *of, const struct hawser_friction_problem *problem)
{
	double *p = of->Y + of->n*of->size;

	for (int d = 0; d < of->size; d++) {
		if (!held(problem, d))
			continue;
		for (int i = 0; i < of->size; i++) {
			if (!held(problem, i))
				p[i] -= of->M[i*of->size + d]*p[d];
			of->M[i*of->size + d] = of->M[d*of->size + i] = 0.0;
		}
		of->M[d*of->size + d] = 1.0;
		for (int i = 0; i < of->n; i++)
			of->Y[i*of->size + d] = 0.0;
	}
}

static double shift(const struct hawser_contact *c)
{
	return c->restitution > 0.0 && c->before < 0.0 && c->before + c->gap_rate <= 0.0
	       ? c->restitution*c->before : c->gap_rate;
}

/* W and q. A tangent along a held direction, whose row of W is 0, gets one that leaves it without
 * impulse. */
static void reduce(struct dense *of, const struct hawser_friction_problem *problem)
{
	for (int i = 0; i < of->n; i++) {
		const struct hawser_contact *contact = &problem->contact[i/3];
		const double *H = of->H + i*of->size, *u = of->Y + of->n*of->size;

		for (int j = 0; j < of->n; j++)
			for (int d = 0; d < of->size; d++)
				of->W[of->n*j + i] += H[d]*of->Y[j*of->size + d];
		of->q[i] = i%3 ? 0.0 : shift(contact);
		for (int d = 0; d < of->size; d++)
			of->q[i] += H[d]*u[d];
		for (int k = 0; k < 3; k++)
			of->q[i] -= H[3*contact->node + k]*contact->surface[k];
	}
	for (int i = 0; i < of->n; i++) {
		double normal = of->W[(of->n + 1)*(i - i%3)];

		of->mu[i/3] = problem->contact[i/3].friction;
		if (of->W[(of->n + 1)*i] > 1e-10*normal)
			continue;
		for (int j = 0; j < of->n; j++)
			of->W[of->n*j + i] = of->W[of->n*i + j] = 0.0;
		of->W[(of->n + 1)*i] = normal;
		of->q[i] = 0.0;
	}
}

static void drop(NumericsMatrix *matrix, SolverOptions *options)
{
	matrix->matrix0 = NULL; /* ours */
	by.clear(matrix);
	free(matrix);
	by.drop(options);
	free(options);
}

/* Without friction: the normal components alone. */
static int lemke(struct dense *of)
{
	const int contacts = of->n/3;
	double *q = of->work + contacts*contacts, *r = q + contacts;
	SolverOptions *options = by.create(SICONOS_LCP_LEMKE);
	LinearComplementarityProblem lcp = {.size = contacts, .q = q};
	int info;

	for (int j = 0; j < contacts; j++) {
		for (int i = 0; i < contacts; i++)
			of->work[contacts*j + i] = of->W[of->n*3*j + 3*i];
		q[j] = of->q[3*j];
	}
	options->iparam[SICONOS_IPARAM_MAX_ITER] = STEPS;
	lcp.M = by.matrix(NM_DENSE, contacts, contacts, of->work);
	info = by.lcp(&lcp, r, r + contacts, options);
	for (int j = 0; j < contacts; j++)
		of->r[3*j] = r[j];
	drop(lcp.M, options);
	return info;
}

static int coulomb(struct dense *of, int id)
{
	SolverOptions *options = by.create(id);
	FrictionContactProblem problem = {.dimension = 3, .numberOfContacts = of->n/3, .q = of->q,
	                                  .mu = of->mu};
	int info;

	problem.M = by.matrix(NM_DENSE, of->n, of->n, of->W);
	options->dparam[SICONOS_DPARAM_TOL] = tolerance;
	options->iparam[SICONOS_IPARAM_MAX_ITER] = id == SICONOS_FRICTION_3D_NSGS ? SWEEPS : STEPS;
	info = by.fc3d(&problem, of->r, of->w, options);
	drop(problem.M, options);
	return info;
}

/* w = W r + q, and the states that r - rho w shows. */
static void reply_all(struct hawser_contact_reply *reply, struct dense *of,
                      const struct hawser_friction_problem *problem)
{
	for (int c = 0; c < problem->contacts; c++) {
		const double *r = of->r + 3*c, rho = 1.0/of->W[(of->n + 1)*3*c], mu = of->mu[c];
		double *w = reply[c].velocity, tangent;

		for (int k = 0; k < 3; k++) {
			reply[c].impulse[k] = r[k];
			w[k] = of->q[3*c + k];
			for (int j = 0; j < of->n; j++)
				w[k] += of->W[of->n*j + 3*c + k]*of->r[j];
		}
		tangent = hypot(r[1] - rho*w[1], r[2] - rho*w[2]);
		reply[c].state = r[0] - rho*w[0] <= 0.0 ? HAWSER_CONTACT_OPEN
		               : mu > 0.0 && tangent <= mu*(r[0] - rho*w[0]) ? HAWSER_CONTACT_STICK
		                                                             : HAWSER_CONTACT_SLIP;
		w[0] -= shift(&problem->contact[c]);
	}
}

static const char *solve(struct hawser_contact_reply *reply, struct dense *of,
                         const struct hawser_friction_problem *problem, int id)
{
	int info;

	hold(of, problem);
	if (LAPACKE_dposv(LAPACK_COL_MAJOR, 'U', of->size, of->n + 1, of->M, of->size, of->Y, of->size))
		return "the matrix is not positive definite";
	reduce(of, problem);
	by.verbose(0);
	hawser__leaks_begin();
	info = of->n == 0 ? 0 : id == SICONOS_LCP_LEMKE ? lemke(of) : coulomb(of, id);
	hawser__leaks_end();
	if (info)
		return "Siconos found no solution";
	reply_all(reply, of, problem);
	return NULL;
}

const char *siconos_solve(struct hawser_contact_reply *reply,
                          const struct hawser_friction_problem *problem, int nodes,
                          const int (*link)[2], int links, const char *method)
{
	const size_t size = 3*(size_t)nodes, n = 3*(size_t)problem->contacts;
	const size_t words[] = {size*size, (n + 1)*size, n*size, n*n, n, n, n, n, n*n + n};
	struct dense of = {.size = (int)size, .n = (int)n};
	double **part[] = {&of.M, &of.Y, &of.H, &of.W, &of.q, &of.r, &of.w, &of.mu, &of.work}, *all;
	const char *wrong;
	size_t sum = 0;
	int k = 0;

	for (size_t i = 0; i < sizeof words/sizeof *words; i++)
		sum += words[i];
	all = loaded() ? calloc(sum, sizeof *all) : NULL;
	if (!all)
		return "no library of Siconos, or no memory";
	*part[0] = all;
	for (size_t i = 1; i < sizeof words/sizeof *words; i++)
		*part[i] = *part[i - 1] + words[i - 1];
	while (k < METHODS - 1 && strcmp(methods[k].name, method) != 0)
		k++;
	assemble(&of, problem, nodes, link, links);
	wrong = solve(reply, &of, problem, methods[k].id);
	free(all);
	return wrong;
}

#else
const char *siconos_method(int index)
{
	(void)index;
	return NULL;
}

const char *siconos_solve(struct hawser_contact_reply *reply,
                          const struct hawser_friction_problem *problem, int nodes,
                          const int (*link)[2], int links, const char *method)
{
	(void)reply;
	(void)problem;
	(void)nodes;
	(void)link;
	(void)links;
	(void)method;
	return "built without Siconos";
}
#endif
