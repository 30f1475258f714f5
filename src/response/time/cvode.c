/* response/time/cvode.c - SUNDIALS CVODE on a reduced model: variable-order multistep methods, with
 * Newton iteration on the exact Jacobian.
 *
 *    y = (u, u'),   y' = (u', a(u, u', Omega t)),   J = [0 I; da/du da/du']
 *
 * Newton's method with a dense matrix is used for Adams too, not functional iteration. On a cable
 * model of five coordinates both take the same time at equal error, since CVODE factorises once in
 * about sixty steps. Functional iteration would limit the step by the highest frequency of the
 * model even if it is not excited. BDF is slower than both if the motion contains all frequencies
 * of the model, and slower than radau.c if heavily damped high modes respond quasi-statically.
 *
 * The local errors of CVODE accumulate: with rtol 1e-13 the energy of an undamped cable drifts by
 * 8e-10 in a thousand periods, with 1e-14 by 4e-11. The Gauss method of gauss.c avoids this.
 *
 * The time of CVODE begins at 0 at the start of the run. CVODE sums its steps in double precision,
 * so that at large times the sum would have an error of 1e-16 of the time since the forcing began.
 *
 * Reference: Hindmarsh et al., SUNDIALS, ACM Trans. Math. Softw. 31 (2005) 363-396.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "core/report.h"
#include "core/sundials.h"
#include "response/time/stepper.h"
#include "rom/terms/history.h"
#include "rom/build/model.h"

struct cvode {
	struct hawser__stepper base;
	struct hawser__sundials sundials;
	N_Vector state;
	SUNMatrix matrix;
	SUNLinearSolver solver;
	void *memory;
	double phase; /* phase of the forcing at the start of the run */
	double *by_u, *by_v, *by_omega, *acceleration; /* [n][n] twice, [n] twice */
};

/* Phase of the forcing at CVODE's time t. */
static double phase_at(const struct cvode *cvode, double t)
{
	const struct hawser__stepper *base = &cvode->base;

	return cvode->phase + hawser__stepper_turned(base->omega, t, 0.0) +
	       base->rate*t*(base->begin - base->since + 0.5*t);
}

static int right_hand_side(sunrealtype t, N_Vector y, N_Vector slope, void *user)
{
	struct cvode *cvode = user;
	int n = cvode->base.rom->n;
	const double *u = NV_DATA_S(y);
	double *out = NV_DATA_S(slope);

	memcpy(out, u + n, (size_t)n*sizeof *out);
	/* 1: CVODE retries with a shorter step */
	return hawser__stepper_acceleration(&cvode->base, out + n, cvode->base.begin + t,
	                                    phase_at(cvode, t), u, u + n) ? 1 : 0;
}

static int jacobian(sunrealtype t, N_Vector y, N_Vector slope, SUNMatrix matrix, void *user,
                    N_Vector scratch1, N_Vector scratch2, N_Vector scratch3)
{
	struct cvode *cvode = user;
	double omega = hawser__stepper_omega(&cvode->base, cvode->base.begin + t);
	int n = cvode->base.rom->n;
	const double *u = NV_DATA_S(y);

	(void)slope, (void)scratch1, (void)scratch2, (void)scratch3;
	hawser_rom_acceleration_jacobian(cvode->base.rom, cvode->acceleration, cvode->by_u,
	                                 cvode->by_v, cvode->by_omega, u, u + n,
	                                 phase_at(cvode, t), omega);
	if (cvode->base.rom->ramp)
		hawser__rom_ramp(cvode->base.rom, cvode->acceleration, cvode->by_u, cvode->by_v, u, u + n,
		                 cvode->base.begin + t, cvode->base.over);
	if (cvode->base.rom->history)
		hawser__rom_history(cvode->base.rom, cvode->acceleration, cvode->by_u, cvode->by_v, u, u + n,
		                    cvode->base.begin + t);
	for (int k = 0; k < n; k++) {
		double *left = SM_COLUMN_D(matrix, k), *right = SM_COLUMN_D(matrix, n + k);

		for (int j = 0; j < n; j++) {
			left[j] = 0.0;
			right[j] = j == k;
			left[n + j] = cvode->by_u[j*n + k];
			right[n + j] = cvode->by_v[j*n + k];
		}
	}
	return 0;
}

static void close_cvode(struct hawser__stepper *stepper)
{
	struct cvode *cvode = (struct cvode *)stepper;

	if (cvode->memory)
		CVodeFree(&cvode->memory);
	if (cvode->solver)
		SUNLinSolFree(cvode->solver);
	if (cvode->matrix)
		SUNMatDestroy(cvode->matrix);
	if (cvode->state)
		N_VDestroy(cvode->state);
	hawser__sundials_clear(&cvode->sundials);
	free(cvode->by_u);
	free(cvode);
}

static double duration(const struct hawser__stepper *stepper)
{
	return stepper->until - stepper->begin;
}

/* Whether all objects of CVODE could be made; the only reason for a failure is lack of memory. */
static int set_up(struct cvode *cvode, int family, const double *y0)
{
	int n = cvode->base.rom->n;
	size_t block = (size_t)n*(size_t)n;

	if (!(cvode->by_u = calloc(2*block + 2*(size_t)n, sizeof(double))) ||
	    !hawser__sundials_open(&cvode->sundials) ||
	    !(cvode->state = N_VNew_Serial(2*n, cvode->sundials.context)))
		return 0;
	cvode->by_v = cvode->by_u + block;
	cvode->by_omega = cvode->by_v + block;
	cvode->acceleration = cvode->by_omega + n;
	memcpy(NV_DATA_S(cvode->state), y0, 2*(size_t)n*sizeof(double));
	return (cvode->matrix = SUNDenseMatrix(2*n, 2*n, cvode->sundials.context)) &&
	       (cvode->solver = SUNLinSol_Dense(cvode->state, cvode->matrix, cvode->sundials.context)) &&
	       (cvode->memory = CVodeCreate(family, cvode->sundials.context)) &&
	       hawser__sundials_listen(&cvode->sundials, cvode->memory) &&
	       !CVodeInit(cvode->memory, right_hand_side, 0.0, cvode->state) &&
	       !CVodeSetUserData(cvode->memory, cvode) &&
	       !CVodeSStolerances(cvode->memory, cvode->base.rtol, cvode->base.atol) &&
	       !CVodeSetLinearSolver(cvode->memory, cvode->solver, cvode->matrix) &&
	       !CVodeSetJacFn(cvode->memory, jacobian) &&
	       !CVodeSetMinStep(cvode->memory, DBL_EPSILON*duration(&cvode->base)) &&
	       (!(cvode->base.longest > 0.0) ||
	        !CVodeSetMaxStep(cvode->memory, cvode->base.longest)) &&
	       !CVodeSetStopTime(cvode->memory, duration(&cvode->base));
}

static struct hawser__stepper *open_cvode(const struct hawser__stepper *problem, const double *y0,
                                          int family)
{
	struct cvode *cvode = calloc(1, sizeof *cvode);

	if (!cvode)
		return NULL;
	cvode->base = *problem;
	cvode->phase = hawser__stepper_phase(problem, problem->begin, 0.0);
	if (set_up(cvode, family, y0))
		return &cvode->base;
	close_cvode(&cvode->base);
	return NULL;
}

static struct hawser__stepper *open_adams(const struct hawser__stepper *problem, const double *y0)
{
	return open_cvode(problem, y0, CV_ADAMS);
}

static struct hawser__stepper *open_bdf(const struct hawser__stepper *problem, const double *y0)
{
	return open_cvode(problem, y0, CV_BDF);
}

static enum hawser_status explain(struct cvode *cvode, int flag, struct hawser_report *report)
{
	double t = 0.0, step = 0.0;

	CVodeGetCurrentTime(cvode->memory, &t);
	CVodeGetCurrentStep(cvode->memory, &step);
	t += cvode->base.begin;
	switch (flag) {
	case CV_TOO_MUCH_WORK:
		return hawser__stepper_too_long(&cvode->base, t, report);
	case CV_ERR_FAILURE:
	case CV_CONV_FAILURE:
	case CV_RHSFUNC_FAIL:
	case CV_FIRST_RHSFUNC_ERR:
	case CV_REPTD_RHSFUNC_ERR:
	case CV_UNREC_RHSFUNC_ERR:
	case CV_LSETUP_FAIL:
	case CV_LSOLVE_FAIL:
		return hawser__stepper_escaped(&cvode->base, NV_DATA_S(cvode->state), t, step, report);
	case CV_MEM_FAIL:
		return hawser__no_memory(report, "integrate");
	default:
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "integrate",
		                       (int)cvode->base.steps, step, "CVODE stopped at t = "
		                       "%.6g%s with code %d: %s",
		                       HAWSER_SHOWN_TIME(cvode->base.rom, t), flag, cvode->sundials.message);
	}
}

static enum hawser_status advance(struct hawser__stepper *stepper, double *y, double t,
                                  struct hawser_report *report)
{
	struct cvode *cvode = (struct cvode *)stepper;
	double reached = 0.0, since = t - stepper->begin;
	int flag = CV_SUCCESS;

	/* CVODE chooses its first step by the first output time: request the end, so that the run does
	 * not depend on the output times */
	if (!stepper->steps)
		flag = CVode(cvode->memory, duration(stepper), cvode->state, &reached, CV_ONE_STEP);
	CVodeGetNumSteps(cvode->memory, &stepper->steps);
	CVodeGetCurrentTime(cvode->memory, &reached);
	if (flag >= 0 && reached < since && stepper->steps >= stepper->max_steps)
		return hawser__stepper_too_long(stepper, stepper->begin + reached, report);
	if (flag >= 0) {
		CVodeSetMaxNumSteps(cvode->memory, stepper->max_steps - stepper->steps);
		flag = CVode(cvode->memory, since, cvode->state, &reached, CV_NORMAL);
	}
	CVodeGetNumSteps(cvode->memory, &stepper->steps);
	CVodeGetNumJacEvals(cvode->memory, &stepper->jacobians);
	if (flag < 0)
		return explain(cvode, flag, report);
	memcpy(y, NV_DATA_S(cvode->state), 2*(size_t)stepper->rom->n*sizeof *y);
	return HAWSER_OK;
}

const struct hawser__method hawser__adams = {
	{"adams", "CVODE, Adams-Moulton of order 1 to 12, Newton: any model, moderate tolerances"},
	open_adams, advance, close_cvode, NULL
};

const struct hawser__method hawser__bdf = {
	{"bdf", "CVODE, backward differences of order 1 to 5, Newton: heavily damped high modes"},
	open_bdf, advance, close_cvode, NULL
};
