/* response/branch/slack.c - where a branch comes to a slack cable.
 *
 *   T(s)   least tension over the period, anywhere on the cable, of the orbit at fraction s of the way
 *          from here to next
 *
 * A cable bears no compression, but the model's tension may become negative: from T = 0 on the model's
 * motion is not that of a cable. T is continuous along the branch, with a corner where the place or the
 * instant of the least tension changes. Each trial is corrected onto the branch.
 *
 * The error of Omega: an orbit that is off by e of its size has a tension that is off by about 2 e of
 * what the motion changes it by, for the tension has terms of first and second order in the
 * coordinates. The slope of T along the step turns this into an error of s, and the tangent into one of
 * Omega.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "continuation/false_position.h"
#include "core/report.h"
#include "response/branch/trace.h"

#define MOST_TRIALS 60 /* false position takes about 6, and 60 halvings resolve any double */

/* Put the point at fraction s into `scratch`; *T its tensions. */
static enum hawser_status attempt(struct hawser__trace *trace, double s, double T[2])
{
	struct hawser__orbit *orbit = trace->orbit;
	struct hawser__station *at = &trace->scratch;
	int failed = hawser__station_inside(at, orbit, &trace->here, &trace->next, s,
	                                    trace->options.tolerance);

	at->arc = trace->here.arc + s*(trace->next.arc - trace->here.arc);
	if (failed)
		return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                       at->correction.iterations, at->correction.residual,
		                       "the corrector failed near %s while locating an event",
		                       hawser__orbit_where(orbit,
		                                           hawser__trace_parameter(trace, at)).text);
	hawser__amplitude_take(trace->amplitude, orbit->rom);
	if (hawser__amplitude_tension(trace->amplitude, T, orbit->samples, orbit->rows,
	                              hawser__orbit_omega(orbit, at->y)))
		return hawser__no_memory(trace->report, "frf");
	return HAWSER_OK;
}

/* Of Omega, relative: see the head of the file. `slope`: of T over s, `length`: of the step. */
static double error_of(const struct hawser__trace *trace, const double T[2], double slope,
                       double length)
{
	const struct hawser__station *at = &trace->next;
	double off = 2.0*at->error*(T[1] - T[0])/slope, omega = hawser__trace_parameter(trace, at);
	double turn = fabs(at->t[trace->orbit->size - 1])*length;

	turn = fmax(turn, fabs(hawser__trace_parameter(trace, &trace->scratch) -
	                       hawser__trace_parameter(trace, &trace->here)));
	return fmin(1.0, trace->options.event_tolerance + off*turn/omega);
}

enum hawser_status hawser__trace_slacken(struct hawser__trace *trace, double from, double to,
                                         struct hawser_frf_event *event)
{
	struct hawser__bracketed in = {0.0, 1.0, from, to, 0};
	double goal = trace->options.event_tolerance, length = trace->next.arc - trace->here.arc;
	double T[2] = {to, to}, s = 1.0;
	enum hawser_status status;

	for (int i = 0; i < MOST_TRIALS; i++) {
		s = hawser__false_position(&in, i);
		if ((status = attempt(trace, s, T)))
			return status;
		if (fabs(T[0]) <= goal*(T[1] - T[0]) || in.b - in.a < goal)
			break;
		hawser__false_position_take(&in, s, T[0]);
	}
	hawser__station_swap(&trace->scratch, &trace->next);
	status = hawser__station_finish(&trace->next, trace->orbit, trace->here.t, trace->report);
	*event = (struct hawser_frf_event){.kind = HAWSER_SLACK, .located = 1, .arc = trace->next.arc,
		.omega = hawser__trace_parameter(trace, &trace->next), .residual = fabs(T[0])/(from - to),
		.bracket = {hawser__trace_parameter(trace, &trace->here),
		            hawser__trace_parameter(trace, &trace->scratch)},
		.unstable = {trace->here.circle.unstable, trace->next.circle.unstable}};
	event->error = error_of(trace, T, (from - T[0])/s, length);
	return status;
}
