/* net/motion/motion-cvode.c - SUNDIALS CVODE on a mesh, as a check of the other schemes: orders up
 * to 12, and a local error that is controlled in positions and velocities.
 *
 * y = (u, v) of the unknowns. An error weight is 1/tolerance for positions and 1/(tolerance*omega)
 * for velocities, with the slow frequency omega = sqrt(g/L + T/(rho*L^2)) of the longest cable: the
 * errors of the slow motion decide, and they add up in the positions. The norm is Euclid's, so that no
 * component exceeds the tolerance; that of SUNDIALS is a root mean square, which a few components of a
 * thousand do not move.
 *
 * Adams' formulas, with Newton's method: axial waves without damping stay in the motion, and backward
 * differences are slow and inexact on them (a span of 300 m with 100 elements over 10 s at 1e-8:
 * 25170 steps by Adams, 183388 by BDF). Where Kelvin-Voigt damping makes the fastest axial wave
 * aperiodic (damping.axial*omega_max > 2), it would still limit the steps of Adams' formulas, and BDF
 * is taken (the same span with 0.01 s: 9483 and 2198 steps).
 *
 * The ledger integrates the rates of work and damping over each step by three Gauss points of CVODE's
 * own interpolation.
 *
 * Reference: Hindmarsh et al., SUNDIALS, ACM Trans. Math. Softw. 31 (2005) 363-396.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>

#include "core/report.h"
#include "core/sundials.h"
#include "net/motion/motion-ode.h"

/* Newton's equations are solved exactly: CVODE must not take small right sides for solved. */
static const double EXACT = 1e-12;

struct hawser__cvode {
	struct hawser__sundials sundials;
	struct hawser__ode ode;
	void *memory;
	SUNLinearSolver solver;
	N_Vector y, dense, weight;
	int unknowns;
	double omega;             /* 1/s, see above */
	double since;             /* time that the ledger has reached */
	long base[3];             /* of the motion: steps, iterations, rejected, before CVODE began */
	unsigned char *taut;      /* [elements] at `since` */
	enum hawser_status status; /* of the last failure within a function that CVODE calls */
	struct hawser_report report;
};

void hawser__cvode_clear(struct hawser__cvode *cvode)
{
	if (!cvode)
		return;
	if (cvode->memory)
		CVodeFree(&cvode->memory);
	if (cvode->solver)
		SUNLinSolFreeEmpty(cvode->solver);
	if (cvode->y)
		N_VDestroy(cvode->y);
	if (cvode->dense)
		N_VDestroy(cvode->dense);
	if (cvode->weight)
		N_VDestroy(cvode->weight);
	hawser__sundials_clear(&cvode->sundials);
	hawser__ode_clear(&cvode->ode);
	free(cvode->taut);
	free(cvode);
}

static int right_hand_side(sunrealtype t, N_Vector y, N_Vector slope, void *user)
{
	struct hawser__cvode *cvode = user;
	int n = cvode->unknowns;
	const double *u = NV_DATA_S(y);
	double *out = NV_DATA_S(slope);

	memcpy(out, u + n, (size_t)n*sizeof *out);
	cvode->status = hawser__ode_accelerate(out + n, &cvode->ode, t, u, u + n, &cvode->report);
	for (int i = 0; i < n && !cvode->status; i++)
		if (!isfinite(out[n + i]))
			return 1; /* CVODE tries a shorter step */
	return cvode->status ? -1 : 0;
}

static SUNLinearSolver_Type embedded(SUNLinearSolver solver)
{
	(void)solver;
	return SUNLINEARSOLVER_MATRIX_EMBEDDED;
}

static int solve(SUNLinearSolver solver, SUNMatrix none, N_Vector x, N_Vector b, sunrealtype tolerance)
{
	struct hawser__cvode *cvode = solver->content;
	N_Vector predicted, y, slope, history;
	double t, gamma, order, *to = NV_DATA_S(x);
	void *user;
	int good = 0, n = cvode->unknowns;

	(void)none, (void)tolerance;
	if (CVodeGetNonlinearSystemData(cvode->memory, &t, &predicted, &y, &slope, &gamma, &order, &history,
	                                &user))
		return -1;
	memcpy(to, NV_DATA_S(b), (size_t)(2*n)*sizeof *to);
	cvode->status = hawser__ode_newton(to, to + n, &good, &cvode->ode, gamma, t, NV_DATA_S(y),
	                                   NV_DATA_S(y) + n, &cvode->report);
	return cvode->status ? -1 : !good;
}

/* 1/s: slow frequency of the longest cable. */
static double slow(const struct hawser__motion *motion)
{
	const struct hawser__mesh *mesh = motion->mesh;
	double longest = 0.0, mass = 0.0, length = 0.0, T = 0.0, EA = 0.0, rho, square;

	for (int c = 0; c < mesh->cables; c++) {
		double sum = 0.0;

		for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++)
			sum += mesh->length0[e];
		longest = fmax(longest, sum);
	}
	for (int i = 0; i < motion->nodes; i++)
		mass += mesh->mass[i];
	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];

		mass += el->m;
		length += mesh->length0[e];
		T = fmax(T, el->k*fmax(el->p_ref, 0.0));
		EA = fmax(EA, mesh->EA[e]);
	}
	rho = mass/length;
	square = mesh->g/longest + T/(rho*longest*longest);
	return sqrt(square > 0.0 ? square : EA/(rho*longest*longest));
}

/* Whether Kelvin-Voigt damping makes the fastest axial wave of an element aperiodic. */
static int overdamped(const struct hawser__motion *motion)
{
	double most = 0.0;

	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];

		if (el->m > 0.0)
			most = fmax(most, el->c/el->k*2.0*sqrt(el->k/el->m));
	}
	return most > 2.0;
}

static void look(struct hawser__cvode *cvode)
{
	struct hawser__motion *motion = cvode->ode.motion;

	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		double d[3], l = 0.0;
		int taut;

		for (int k = 0; k < 3; k++) {
			d[k] = el->D[k] + motion->u[el->b][k] - motion->u[el->a][k];
			l += d[k]*d[k];
		}
		taut = sqrt(l) > motion->mesh->length0[e];
		motion->switches += taut != cvode->taut[e];
		cvode->taut[e] = (unsigned char)taut;
		hawser__motion_watch(motion, e, d, sqrt(l) - motion->mesh->length0[e], motion->t);
	}
}

/* Whether all of CVODE could be made; the only reason for a failure is lack of memory. */
static int set_up(struct hawser__cvode *cvode, double tolerance, double longest)
{
	struct hawser__motion *motion = cvode->ode.motion;
	const struct hawser__mesh *mesh = motion->mesh;
	int n = cvode->unknowns;
	double spread = tolerance/sqrt(2.0*n);

	cvode->omega = slow(motion);
	if (!hawser__sundials_open(&cvode->sundials) ||
	    !(cvode->y = N_VNew_Serial(2*n, cvode->sundials.context)) ||
	    !(cvode->dense = N_VNew_Serial(2*n, cvode->sundials.context)) ||
	    !(cvode->weight = N_VNew_Serial(2*n, cvode->sundials.context)) ||
	    !(cvode->solver = SUNLinSolNewEmpty(cvode->sundials.context)))
		return 0;
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			int j = mesh->unknown[i][k];

			if (j < 0)
				continue;
			NV_DATA_S(cvode->y)[j] = motion->u[i][k];
			NV_DATA_S(cvode->y)[n + j] = motion->v[i][k];
			NV_DATA_S(cvode->weight)[j] = spread;
			NV_DATA_S(cvode->weight)[n + j] = spread*cvode->omega;
		}
	cvode->solver->content = cvode;
	cvode->solver->ops->gettype = embedded;
	cvode->solver->ops->solve = solve;
	return (cvode->memory = CVodeCreate(overdamped(motion) ? CV_BDF : CV_ADAMS,
	                                    cvode->sundials.context)) &&
	       hawser__sundials_listen(&cvode->sundials, cvode->memory) &&
	       !CVodeInit(cvode->memory, right_hand_side, motion->t, cvode->y) &&
	       !CVodeSetUserData(cvode->memory, cvode) &&
	       !CVodeSVtolerances(cvode->memory, 0.0, cvode->weight) &&
	       !CVodeSetLinearSolver(cvode->memory, cvode->solver, NULL) &&
	       !CVodeSetEpsLin(cvode->memory, EXACT) &&
	       (!(longest > 0.0) || !CVodeSetMaxStep(cvode->memory, longest));
}

static enum hawser_status open(struct hawser__motion *motion, double tolerance, double longest,
                               struct hawser_report *report)
{
	struct hawser__cvode *cvode = calloc(1, sizeof *cvode);
	enum hawser_status status;

	motion->cvode = cvode;
	if (!cvode)
		return hawser__no_memory(report, "net");
	status = hawser__ode_open(&cvode->ode, motion, report);
	if (status)
		return status;
	cvode->unknowns = motion->mesh->unknowns;
	cvode->since = motion->t;
	cvode->base[0] = motion->steps;
	cvode->base[1] = motion->iterations;
	cvode->base[2] = motion->rejected;
	cvode->taut = calloc((size_t)motion->elements + 1, 1);
	if (!cvode->taut || !set_up(cvode, tolerance, longest))
		return hawser__no_memory(report, "net");
	look(cvode);
	motion->switches = 0;
	return HAWSER_OK;
}

static enum hawser_status explain(struct hawser__cvode *cvode, int flag, struct hawser_report *report)
{
	double t = 0.0, step = 0.0;

	if (cvode->status) {
		if (report)
			*report = cvode->report;
		return cvode->status;
	}
	if (flag == CV_MEM_FAIL)
		return hawser__no_memory(report, "net");
	CVodeGetCurrentTime(cvode->memory, &t);
	CVodeGetCurrentStep(cvode->memory, &step);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "net", 0, step, "the scheme cvode stopped "
	                       "at %.9g s with a step of %.3g s (code %d: %s): give a larger --rtol, or "
	                       "take the scheme energy", t, step, flag, cvode->sundials.message);
}

/* The local error of the last step: what it adds to positions, sooner or later. */
static double local_error(struct hawser__cvode *cvode)
{
	double position = 0.0, velocity = 0.0;
	int n = cvode->unknowns;

	if (CVodeGetEstLocalErrors(cvode->memory, cvode->dense) < 0)
		return 0.0;
	for (int i = 0; i < n; i++) {
		position = fmax(position, fabs(NV_DATA_S(cvode->dense)[i]));
		velocity = fmax(velocity, fabs(NV_DATA_S(cvode->dense)[n + i]));
	}
	return position + velocity/cvode->omega;
}

/* The ledger from `since` to `end`, by CVODE's interpolation. */
static enum hawser_status account(struct hawser__cvode *cvode, double end, struct hawser_report *report)
{
	static const double place[3] = {-0.7745966692414834, 0.0, 0.7745966692414834},
	                    weight[3] = {5.0/18.0, 8.0/18.0, 5.0/18.0};
	struct hawser__motion *motion = cvode->ode.motion;
	double h = end - cvode->since, work, lost;
	const double *y = NV_DATA_S(cvode->dense);
	int n = cvode->unknowns, flag;
	enum hawser_status status;

	for (int i = 0; i < 3; i++) {
		double t = cvode->since + h*(0.5 + 0.5*place[i]);

		flag = CVodeGetDky(cvode->memory, t, 0, cvode->dense);
		if (flag < 0)
			return explain(cvode, flag, report);
		status = hawser__ode_power(&work, &lost, &cvode->ode, t, y, y + n, report);
		if (status)
			return status;
		motion->energy.work += h*weight[i]*work;
		motion->energy.dissipated += h*weight[i]*lost;
	}
	flag = CVodeGetDky(cvode->memory, end, 0, cvode->dense);
	if (flag < 0)
		return explain(cvode, flag, report);
	hawser__ode_spread(motion->u, motion->v, &cvode->ode, end, y, y + n);
	cvode->since = end;
	motion->t = end;
	look(cvode);
	hawser__motion_balance(motion);
	return HAWSER_OK;
}

enum hawser_status hawser__cvode_advance(struct hawser__motion *motion, double end, double tolerance,
                                         double longest, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	struct hawser__cvode *cvode;
	long count[3] = {0};

	if (!motion->cvode)
		status = open(motion, tolerance, longest, report);
	cvode = motion->cvode;
	while (!status && cvode->since < end && !hawser__motion_asked(motion)) {
		double reached = cvode->since;
		int flag;

		CVodeGetCurrentTime(cvode->memory, &reached);
		if (reached <= cvode->since) {
			flag = CVode(cvode->memory, end, cvode->y, &reached, CV_ONE_STEP);
			if (flag < 0)
				return explain(cvode, flag, report);
			motion->drift += local_error(cvode);
		}
		status = account(cvode, fmin(reached, end), report);
	}
	if (status)
		return status;
	CVodeGetNumSteps(cvode->memory, &count[0]);
	CVodeGetNumNonlinSolvIters(cvode->memory, &count[1]);
	CVodeGetNumErrTestFails(cvode->memory, &count[2]);
	motion->steps = cvode->base[0] + count[0];
	motion->iterations = cvode->base[1] + count[1];
	motion->rejected = cvode->base[2] + count[2];
	motion->past_h = motion->past2_h = 0.0; /* what another scheme would go on from */
	return HAWSER_OK;
}
