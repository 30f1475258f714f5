/* response/branch/stops.h - the orbits of a curve at given values of its parameter.
 *
 * A curve that turns back passes a value several times. Each passage becomes a stop: the orbit is
 * corrected at exactly this value, so that nothing is interpolated.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_STOPS_H
#define HAWSER_RESPONSE_STOPS_H

#include "response/branch/trace.h"

struct hawser__stop {
	int place;      /* index of its value in `at` */
	int unstable;   /* number of multipliers outside the unit circle, counted from event to event */
	double peak;    /* largest displacement of a probe along an axis, of a coordinate in a model without
	                 * probes; scaled by the units of the trace's model */
	double tension; /* least tension over the period, N; NaN if the model has none */
};

struct hawser__stops {
	const double *at; /* [count] ascending, in the parameter of the trace */
	int count;
	struct hawser__stop *stop; /* [stops] in order along the curve */
	double *state;             /* [stops][m] at phase 0, in the units of the trace's model */
	int stops, m;
	int last[2];               /* stops and missed before the last step */
	int missed;                /* passages at which no orbit was found */
	double *spare;             /* [n + 3 probes], workspace */
};

/* The member `step` of struct hawser__trace_watch: adds the stops of a step; `context` is the
 * structure, in which `at` and `count` are set. The stops of a trace that begins again, since it had
 * jumped, replace those before. */
enum hawser_status hawser__stops_step(void *context, struct hawser__trace *trace);
/* The member `back`: without those of the last step. */
void hawser__stops_back(void *context);
/* Frees the arrays, but for `at`. */
void hawser__stops_clear(struct hawser__stops *stops);

#endif
