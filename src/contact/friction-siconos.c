/* contact/friction-siconos.c - methods of Siconos (INRIA, Apache-2.0), to compare with and to judge by.
 *
 * W  H M^-1 H^T, Delassus' operator, dense, [3 contacts][3 contacts]
 * q  H u + offset without contact, so that w = W r + q
 *
 * Siconos does not check its input: Lemke's method takes not-a-number for solved, and a wrong size ends
 * the program. So problems are checked before (friction-check.c), and what it calls solved is checked
 * against the law by the caller. It is loaded when a method of it is asked for: linked, it would make
 * each start of a program some 20 ms longer.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/friction.h"
#include "core/loaded.h"
#include "core/report.h"

#ifdef HAVE_SICONOS

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <LinearComplementarityProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <NumericsVerbose.h>
#include <SolverOptions.h>
#include <lcp_cst.h>

/* Its tolerance over ours: its error is a mean over contacts, ours the largest of one. */
static const double stricter = 0.01;
/* Iterations allowed, of Gauss and Seidel's method and of the others. */
enum { SWEEPS = 200000, STEPS = 2000 };

/* Its functions, of the types that its headers declare. */
struct siconos {
	void *library;
	__typeof__(&numerics_set_verbose) verbose;
	__typeof__(&solver_options_create) create;
	__typeof__(&solver_options_delete) drop;
	__typeof__(&NM_create_from_data) matrix;
	__typeof__(&NM_clear) clear;
	__typeof__(&linearComplementarity_driver) lcp;
	__typeof__(&fc3d_driver) fc3d;
};

#define FIND(member, name) \
	hawser__loaded(&siconos->member, sizeof siconos->member, siconos->library, #name)

static int load(struct siconos *siconos)
{
	/* the second without the package of headers */
	siconos->library = dlopen("libsiconos_numerics.so", RTLD_LAZY | RTLD_LOCAL);
	if (!siconos->library)
		siconos->library = dlopen("libsiconos_numerics.so.7", RTLD_LAZY | RTLD_LOCAL);
	return siconos->library && FIND(verbose, numerics_set_verbose) &&
	       FIND(create, solver_options_create) && FIND(drop, solver_options_delete) &&
	       FIND(matrix, NM_create_from_data) && FIND(clear, NM_clear) &&
	       FIND(lcp, linearComplementarity_driver) && FIND(fc3d, fc3d_driver);
}

/* x = M^-1 H^T r of the contacts in of->du, with r from `r` [3*contacts]. */
static int respond(struct hawser_friction *of, const double *r)
{
	memset(of->R, 0, (size_t)of->nodes*sizeof *of->R);
	for (int c = 0; c < of->of->contacts; c++) {
		const struct hawser__friction_touch *touch = &of->touch[c];

		for (int k = 0; k < 3; k++)
			for (int i = 0; i < 3; i++)
				of->R[touch->node][i] += touch->H[3*k + i]*r[3*c + k];
	}
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			if (of->of->held && of->of->held[n] & 1U << k)
				of->R[n][k] = 0.0;
	return hawser__friction_step(of, NULL);
}

/* W by columns; the rows and columns of held tangents are those of a multiple of the unit matrix. */
static int delassus(double *W, double *e, struct hawser_friction *of)
{
	const int n = 3*of->of->contacts;

	for (int j = 0; j < n; j++) {
		memset(e, 0, (size_t)n*sizeof *e);
		e[j] = 1.0;
		if (!respond(of, e))
			return 0;
		for (int i = 0; i < n; i++) {
			const struct hawser__friction_touch *row = &of->touch[i/3];
			const double *x = of->du[row->node], *h = row->H + 3*(i%3);

			W[n*j + i] = h[0]*x[0] + h[1]*x[1] + h[2]*x[2];
			if (row->fixed & 1U << i%3 || of->touch[j/3].fixed & 1U << j%3)
				W[n*j + i] = i == j ? 1.0/row->rho : 0.0;
		}
	}
	return 1;
}

/* Without friction: the normal components alone. */
static int lemke(const struct siconos *by, double *r, const double *W, const double *q, int contacts,
                 double *work)
{
	LinearComplementarityProblem lcp = {.size = contacts};
	SolverOptions *options = by->create(SICONOS_LCP_LEMKE);
	int info;

	for (int j = 0; j < contacts; j++) {
		for (int i = 0; i < contacts; i++)
			work[contacts*j + i] = W[3*contacts*3*j + 3*i];
		work[contacts*contacts + j] = q[3*j];
	}
	options->iparam[SICONOS_IPARAM_MAX_ITER] = STEPS;
	lcp.M = by->matrix(NM_DENSE, contacts, contacts, work);
	lcp.q = work + contacts*contacts;
	info = by->lcp(&lcp, work + contacts*(contacts + 1), work + contacts*(contacts + 2), options);
	for (int j = 0; j < contacts; j++)
		r[3*j] = work[contacts*(contacts + 1) + j];
	lcp.M->matrix0 = NULL;
	by->clear(lcp.M);
	free(lcp.M);
	by->drop(options);
	free(options);
	return info;
}

static int coulomb(const struct siconos *by, double *r, double *w, double *W, double *q, double *mu,
                   int contacts, int id, double tolerance, int *iterations)
{
	SolverOptions *options = by->create(id);
	FrictionContactProblem problem = {.dimension = 3, .numberOfContacts = contacts, .q = q, .mu = mu};
	int info;

	problem.M = by->matrix(NM_DENSE, 3*contacts, 3*contacts, W);
	options->dparam[SICONOS_DPARAM_TOL] = tolerance;
	options->iparam[SICONOS_IPARAM_MAX_ITER] = id == SICONOS_FRICTION_3D_NSGS ? SWEEPS : STEPS;
	info = by->fc3d(&problem, r, w, options);
	*iterations = options->iparam[SICONOS_IPARAM_ITER_DONE];
	problem.M->matrix0 = NULL;
	by->clear(problem.M);
	free(problem.M);
	by->drop(options);
	free(options);
	return info;
}

static void frictions(double *mu, double *q, const struct hawser_friction *of)
{
	for (int c = 0; c < of->of->contacts; c++) {
		mu[c] = of->touch[c].mu;
		for (int k = 0; k < 3; k++)
			q[3*c + k] = of->touch[c].fixed & 1U << k ? 0.0 : of->touch[c].w[k];
	}
}

/* Velocities of the impulses, and w of the contacts. */
static int apply(struct hawser_friction *of, double (*u)[3], const double *r)
{
	if (!respond(of, r))
		return 0;
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			u[n][k] += of->du[n][k];
	hawser__friction_defect(of, (const double (*)[3])u);
	hawser__friction_follow(of, (const double (*)[3])u);
	for (int c = 0; c < of->of->contacts; c++)
		for (int k = 0; k < 3; k++)
			of->touch[c].r[k] = of->touch[c].fixed & 1U << k ? 0.0 : r[3*c + k];
	return 1;
}

static enum hawser_status by(struct hawser_friction *of, double (*u)[3],
                             struct hawser_friction_counts *counts,
                             const struct hawser_friction_options *options, int id,
                             struct hawser_report *report)
{
	const size_t n = 3*(size_t)of->of->contacts;
	double *W = calloc(n*n + n*(n + 6) + 1, sizeof *W), *q = W ? W + n*n : NULL;
	double *r = W ? q + n : NULL, *w = W ? r + n : NULL, *mu = W ? w + n : NULL;
	struct siconos siconos = {0};
	int info = 0, good;

	if (!W)
		return hawser__no_memory(report, "friction");
	if (!load(&siconos)) {
		free(W);
		return hawser__fail(report, HAWSER_ERR_PROGRAM, "friction",
		                    "contact: the library libsiconos_numerics cannot be loaded; install the "
		                    "Debian package libsiconos-numerics-dev, or take the method newton");
	}
	hawser__leaks_begin();
	siconos.verbose(0);
	frictions(mu, q, of);
	good = delassus(W, r, of);
	memset(r, 0, n*sizeof *r);
	if (good && n)
		info = id == SICONOS_LCP_LEMKE ? lemke(&siconos, r, W, q, of->of->contacts, mu + n)
			: coulomb(&siconos, r, w, W, q, mu, of->of->contacts, id, stricter*options->tolerance,
			          &counts->iterations);
	hawser__leaks_end();
	good = good && apply(of, u, r);
	free(W);
	if (!good)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "friction",
		                    "contact: a matrix for Siconos was singular");
	return info ? hawser__fail(report, HAWSER_ERR_CONVERGENCE, "friction",
	                           "contact: Siconos's method ended with its code %d", info) : HAWSER_OK;
}

#define METHOD(name, id) \
	enum hawser_status hawser__friction_##name(struct hawser_friction *of, double (*u)[3], \
	                                           struct hawser_friction_counts *counts, \
	                                           const struct hawser_friction_options *options, \
	                                           struct hawser_report *report) \
	{ \
		return by(of, u, counts, options, id, report); \
	}
#else
#define METHOD(name, id) \
	enum hawser_status hawser__friction_##name(struct hawser_friction *of, double (*u)[3], \
	                                           struct hawser_friction_counts *counts, \
	                                           const struct hawser_friction_options *options, \
	                                           struct hawser_report *report) \
	{ \
		(void)of; \
		(void)u; \
		(void)counts; \
		(void)options; \
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction", \
		                    "contact: the method " #name " is one of Siconos, without which this " \
		                    "library was built: install the Debian package libsiconos-numerics-dev " \
		                    "and configure again, or take the method newton"); \
	}
#endif

METHOD(lemke, SICONOS_LCP_LEMKE)
METHOD(nsgs, SICONOS_FRICTION_3D_NSGS)
METHOD(nsn_ac, SICONOS_FRICTION_3D_NSN_AC)
