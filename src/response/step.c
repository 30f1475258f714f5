/* response/step.c - one step along the branch: predict, correct, judge, and choose the next length.
 *
 * The predictor is the quintic through the last three stations and their tangents, so its error
 * falls with ds^6 and the corrector starts close. The next step is the largest at which
 * contraction of the corrector, turning of the tangent and distance of the prediction stay at
 * their goals (Allgower and Georg, Numerical Continuation Methods, 6.1).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/trace.h"

#define GOAL_CONTRACTION 0.05
#define GOAL_ANGLE 0.2         /* rad between successive tangents */
#define GOAL_DISTANCE 1e-2     /* of the prediction from the branch, relative to the orbit */
#define LARGEST_STEP 0.4       /* relative change of the orbit in one step */
#define LARGEST_TURN 0.01      /* relative change of Omega in a step: resonances are this narrow */
#define SORTING_STEP 1e-4      /* below this, events in one step are told apart no further */
#define COARSE_STEP 1e-5       /* failing at this, a discretisation is taken to be too coarse */
#define REFINED_STEP 100.0     /* times that step, with a finer one */
#define WORST_ERROR 0.05       /* estimated error of an orbit beyond which it is refused */

static void predict(struct hawser__trace *trace, double ds)
{
	const struct hawser__station *node[3] = {&trace->before, &trace->prev, &trace->here};
	int nodes = trace->known < 3 ? trace->known : 3;

	hawser__station_ahead(trace->next.y, node + 3 - nodes, nodes, ds, trace->orbit);
	/* The plane is normal to the known tangent: an extrapolated one may have swung round. */
	memcpy(trace->direction, trace->here.t, (size_t)trace->orbit->size*sizeof(double));
}

static double angle_between(const struct hawser__trace *trace)
{
	const struct hawser__orbit *orbit = trace->orbit;
	double ab = hawser__orbit_dot(orbit, trace->here.t, trace->next.t);
	double aa = hawser__orbit_dot(orbit, trace->here.t, trace->here.t);
	double bb = hawser__orbit_dot(orbit, trace->next.t, trace->next.t);

	return acos(fmax(-1.0, fmin(1.0, ab/sqrt(aa*bb))));
}

enum hawser_status hawser__trace_correct(struct hawser__trace *trace,
                                         struct hawser__station *station, const double *row,
                                         int *failed)
{
	struct hawser__orbit *orbit = trace->orbit;
	double tolerance = trace->options.tolerance;

	for (;;) {
		int again;
		enum hawser_status status;

		*failed = hawser__orbit_correct(orbit, station->y, &station->correction, row,
		                                tolerance);
		if (*failed)
			return HAWSER_OK;
		status = orbit->ops->refine(orbit, &again, tolerance,
		                            hawser__trace_omega(trace, station), trace->report);
		if (status || !again)
			return status;
	}
}

double hawser__trace_largest_step(const struct hawser__trace *trace)
{
	const struct hawser__orbit *orbit = trace->orbit;
	double omega = hawser__trace_omega(trace, &trace->here);
	double turn = fmin(LARGEST_TURN*omega, trace->options.step_max*(trace->hi - trace->lo));
	/* Omega moves by |t_Omega| ds; where the branch is steep, only the orbit's change counts */
	double share = fabs(trace->here.t[orbit->size - 1]);

	return share*LARGEST_STEP > turn ? turn/share : LARGEST_STEP;
}

/* Factor by which the last step was shorter or longer than it should be. */
static double step_factor(const struct hawser__trace *trace, double angle)
{
	const struct hawser__correction *correction = &trace->next.correction;
	double factor = GOAL_ANGLE/fmax(angle, 1e-12);

	factor = fmin(factor, sqrt(GOAL_CONTRACTION/fmax(correction->contraction, 1e-12)));
	factor = fmin(factor, pow(GOAL_DISTANCE/fmax(correction->first, 1e-12), 1.0/6.0));
	return fmax(0.4, fmin(1.8, factor));
}

/* Without damping a linear resonance has no finite orbit; what stops the numbers from growing is
 * the damping of the integrator, and its peak would be a wrong number. */
enum hawser_status hawser__trace_determined(const struct hawser__trace *trace,
                                            const struct hawser__station *station)
{
	return station->error <= WORST_ERROR ? HAWSER_OK :
	       hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
	                       station->correction.iterations, station->error,
	                       "at Omega %.12g%s the orbit is determined to no better than %.1g of its "
	                       "size: tighten --tolerance (%.1g); if that does not help, it is a "
	                       "resonance without damping",
	                       HAWSER_SHOWN(trace->rom, hawser__trace_omega(trace, station)),
	                       station->error, trace->options.tolerance);
}

enum hawser_status hawser__trace_advance(struct hawser__trace *trace)
{
	int enriched = 0;

	for (int tries = 0;; tries++) {
		int failed;
		double angle;
		enum hawser_status status;

		if (trace->ds < HAWSER_SMALLEST_STEP)
			return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
			                       trace->next.correction.iterations,
			                       trace->next.correction.residual,
			                       "the corrector failed at the smallest step near Omega "
			                       "%.9g%s (residual %.2g); %d points were traced",
			                       HAWSER_SHOWN(trace->rom,
			                                    hawser__trace_omega(trace, &trace->here)),
			                       trace->next.correction.residual, trace->frf->points);
		/* a difficult step takes many tries: the user may have had enough of them */
		if (tries > 0 && trace->options.progress &&
		    trace->options.progress(trace->options.progress_context, trace->frf)) {
			trace->stopped = 1;
			return HAWSER_OK;
		}
		predict(trace, trace->ds);
		trace->orbit->reach = trace->ds;
		status = hawser__trace_correct(trace, &trace->next, trace->direction, &failed);
		trace->orbit->reach = 0.0;
		if (status)
			return status;
		/* pairs or nodes that were dropped, or never taken in, may be what it fails by */
		if (failed && trace->ds < COARSE_STEP && !enriched++) {
			if ((status = trace->orbit->ops->enrich(trace->orbit, trace->report)))
				return status;
			trace->ds *= REFINED_STEP;
			continue;
		}
		if (failed) {
			trace->ds *= 0.4;
			continue;
		}
		if ((status = hawser__station_finish(&trace->next, trace->orbit, trace->here.t,
		                                     trace->report)))
			return status;
		angle = angle_between(trace);
		trace->next.arc = trace->here.arc + trace->ds;
		if ((!hawser__trace_trusted(trace, angle) && trace->ds > 1e3*HAWSER_SMALLEST_STEP) ||
		    (trace->ds > SORTING_STEP && hawser__trace_hides(trace))) {
			trace->ds *= 0.5;
			continue;
		}
		if (!hawser__account_crossings(&trace->here, &trace->next, &(int){0}) &&
		    (status = hawser__trace_determined(trace, &trace->next))) {
			/* or what is missing leaves it undetermined, each part small as it is */
			if (enriched++ || trace->orbit->ops->enrich(trace->orbit, NULL))
				return status;
			continue;
		}
		trace->ds = fmin(trace->ds*step_factor(trace, angle), hawser__trace_largest_step(trace));
		return HAWSER_OK;
	}
}

enum hawser_status hawser__trace_cut(struct hawser__trace *trace, double bound)
{
	struct hawser__orbit *orbit = trace->orbit;
	int last = orbit->size - 1, failed;
	double lo = 0.0, hi = 1.0, *y = trace->scratch.y;
	double side = trace->here.y[last] < bound ? 1.0 : -1.0;
	enum hawser_status status;

	for (int i = 0; i < 60; i++) {
		double s = 0.5*(lo + hi);

		hawser__station_between(y, trace->direction, &trace->here, &trace->next, s, orbit);
		if ((y[last] - bound)*side < 0.0)
			lo = s;
		else
			hi = s;
	}
	y[last] = bound;
	memset(trace->direction, 0, (size_t)orbit->size*sizeof(double));
	trace->direction[last] = side*orbit->W;
	if ((status = hawser__trace_correct(trace, &trace->scratch, trace->direction, &failed)))
		return status;
	if (failed)
		return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                       trace->scratch.correction.iterations,
		                       trace->scratch.correction.residual,
		                       "the corrector failed at the end of the range, Omega %.9g%s",
		                       HAWSER_SHOWN(trace->rom, bound));
	trace->scratch.arc = trace->here.arc + lo*(trace->next.arc - trace->here.arc);
	hawser__station_swap(&trace->scratch, &trace->next);
	status = hawser__station_finish(&trace->next, orbit, trace->here.t, trace->report);
	return status ? status : hawser__trace_determined(trace, &trace->next);
}
