/* ropeway/statics/sweep.c - the worst values over the phases of the carriers.
 *
 * Each phase is a state of its own, so that they are shared among threads. A phase writes its
 * values, each with a least and a largest one within this state, to a row of numbers; the rows are
 * then compared in order, so that the result does not depend on the threads.
 *
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/share.h"
#include "ropeway/statics/line.h"

enum { MOST = 100000, ENVELOPE = HAWSER_ROPEWAY_ENVELOPE, OF_LANE = 2, OF_ALL = 5,
       OF_TOWER = sizeof(struct hawser_ropeway_tower_range)/sizeof(struct hawser_ropeway_range),
       OF_SPAN = sizeof(struct hawser_ropeway_span_range)/sizeof(struct hawser_ropeway_range) };

struct outcome {
	enum hawser_status status;
	int lifted, slips, stopped;
	struct hawser_report report;
};

struct sweep {
	const struct hawser_ropeway *ropeway;
	const struct hawser__frame *frame;
	struct hawser_ropeway_options options;
	int phases, values;
	double (*row)[2];      /* [phases][values] least and largest */
	struct outcome *outcome; /* [phases] */
};

static void put(double (**to)[2], double low, double high)
{
	(**to)[0] = low;
	(**to)[1] = high;
	++*to;
}

static void put_one(double (**to)[2], double value)
{
	put(to, value, value);
}

/* In the order of struct hawser_ropeway_tower_range. */
static void put_tower(double (**to)[2], const struct hawser_ropeway_contact *c)
{
	put(to, fmin(c->T_in, c->T_out), fmax(c->T_in, c->T_out));
	put_one(to, c->reaction[0]);
	put_one(to, c->reaction[1]);
	put_one(to, c->pressing);
	put_one(to, c->pressure);
	put_one(to, c->angle_in);
	put_one(to, c->angle_out);
	put_one(to, c->wrap);
	put_one(to, c->margin);
	put_one(to, c->sheave_force);
	put_one(to, c->sheave_wrap);
}

/* S of a point of the envelope. */
static double place_of(const struct hawser_ropeway_span *span, int i)
{
	return span->S_from + span->length0*i/(ENVELOPE - 1);
}

static void put_lane(double (**to)[2], const struct hawser_ropeway_lane *lane, int towers)
{
	double low = INFINITY, high = 0.0, T;

	for (int i = 0; i < towers; i++)
		put_tower(to, &lane->contact[i]);
	for (int i = 0; i <= towers; i++) {
		const struct hawser_ropeway_span *span = &lane->span[i];

		put(to, span->T_min, span->T_max);
		put_one(to, span->sag);
		put_one(to, span->length0);
		low = fmin(low, span->T_min);
		high = fmax(high, span->T_max);
	}
	for (int i = 0; i <= towers; i++)
		for (int k = 0; k < ENVELOPE; k++) {
			hawser_line_at(&lane->st, NULL, NULL, &T, NULL, NULL, place_of(&lane->span[i], k));
			put_one(to, T);
		}
	put(to, low, high);
	put_one(to, lane->st.T_B);
}

static double phase_of(const struct sweep *sweep, long item)
{
	return sweep->ropeway->spacing*(double)item/sweep->phases;
}

static void one_phase(void *context, long item, int worker)
{
	const struct sweep *sweep = context;
	struct outcome *outcome = &sweep->outcome[item];
	struct hawser_ropeway_statics st;
	double (*to)[2] = sweep->row + item*sweep->values;

	(void)worker;
	outcome->status = hawser__ropeway_state(&st, sweep->frame, &sweep->options, phase_of(sweep, item),
	                                        &outcome->report);
	if (outcome->status)
		return;
	for (int i = 0; i < st.lanes; i++)
		put_lane(&to, &st.lane[i], sweep->ropeway->towers);
	put_one(&to, st.T0);
	put_one(&to, st.travel);
	put_one(&to, st.force);
	put_one(&to, st.power);
	put_one(&to, st.needed_friction);
	outcome->lifted = st.lifted;
	outcome->slips = st.slips;
	outcome->stopped = st.stopped;
	hawser_ropeway_statics_clear(&st);
}

static void widen(struct hawser_ropeway_range *range, const double value[2], double phase, int fresh)
{
	if (fresh || value[0] < range->min) {
		range->min = value[0];
		range->at_min = phase;
	}
	if (fresh || value[1] > range->max) {
		range->max = value[1];
		range->at_max = phase;
	}
}

static void count(int *counter, double *at, int flag, double phase)
{
	if (flag && !(*counter)++)
		*at = phase;
}

/* Compare the rows. */
static enum hawser_status compare(struct hawser_ropeway_worst *worst, const struct sweep *sweep,
                                  struct hawser_report *report)
{
	for (int i = 0; i < sweep->phases; i++) {
		const struct outcome *outcome = &sweep->outcome[i];
		double phase = phase_of(sweep, i);

		if (outcome->status && !worst->failed++)
			worst->why = outcome->report;
		if (outcome->status && (!sweep->options.tolerate || outcome->status == HAWSER_ERR_MEMORY)) {
			if (report)
				*report = outcome->report;
			return outcome->status;
		}
		if (outcome->status)
			continue;
		for (int k = 0; k < sweep->values; k++)
			widen(&worst->range[k], sweep->row[(size_t)i*(size_t)sweep->values + (size_t)k], phase,
			      worst->solved == 0);
		worst->solved++;
		count(&worst->lifts, &worst->lifts_at, outcome->lifted, phase);
		count(&worst->slips, &worst->slips_at, outcome->slips, phase);
		count(&worst->stops, &worst->stops_at, outcome->stopped, phase);
	}
	if (worst->solved == 0) {
		if (report)
			*report = worst->why;
		return worst->why.status;
	}
	return HAWSER_OK;
}

/* Places of the envelope, in the first phase that is solved. */
static enum hawser_status places(struct hawser_ropeway_worst *worst, const struct sweep *sweep,
                                 struct hawser_report *report)
{
	struct hawser_ropeway_statics st;
	enum hawser_status status;
	int first = 0;

	while (sweep->outcome[first].status)
		first++;
	status = hawser__ropeway_state(&st, sweep->frame, &sweep->options, phase_of(sweep, first), report);
	if (status)
		return status;
	for (int i = 0; i < st.lanes; i++)
		for (int k = 0; k <= worst->towers; k++)
			for (int j = 0; j < ENVELOPE; j++)
				hawser_line_at(&st.lane[i].st, worst->lane[i].place[k*ENVELOPE + j], NULL, NULL,
				               NULL, NULL, place_of(&st.lane[i].span[k], j));
	hawser_ropeway_statics_clear(&st);
	return HAWSER_OK;
}

static int values_of(const struct hawser_ropeway *rw)
{
	return rw->lanes*(rw->towers*OF_TOWER + (rw->towers + 1)*(OF_SPAN + ENVELOPE) + OF_LANE) + OF_ALL;
}

/* Memory of the result; the ranges of the lanes point into `range`, in the order of put_lane(). */
static enum hawser_status allot(struct hawser_ropeway_worst *worst, const struct hawser_ropeway *rw,
                                struct hawser_report *report)
{
	size_t points = ((size_t)rw->towers + 1)*ENVELOPE;
	struct hawser_ropeway_range *next;

	worst->towers = rw->towers;
	worst->lanes = rw->lanes;
	worst->ranges = values_of(rw);
	worst->lifts_at = worst->slips_at = worst->stops_at = NAN;
	worst->range = next = calloc((size_t)worst->ranges, sizeof *worst->range);
	if (!next)
		return hawser__no_memory(report, "ropeway");
	for (int i = 0; i < rw->lanes; i++) {
		struct hawser_ropeway_lane_range *lane = &worst->lane[i];

		lane->tower = (struct hawser_ropeway_tower_range *)next;
		lane->span = (struct hawser_ropeway_span_range *)(next + rw->towers*OF_TOWER);
		lane->envelope = next + rw->towers*OF_TOWER + (rw->towers + 1)*OF_SPAN;
		next = lane->envelope + points + OF_LANE;
		lane->place = calloc(points, sizeof *lane->place);
		if (!lane->place)
			return hawser__no_memory(report, "ropeway");
	}
	return HAWSER_OK;
}

/* Copies of ranges that stand alone, and the spans of the extremes. */
static void finish(struct hawser_ropeway_worst *worst)
{
	const struct hawser_ropeway_range *last = worst->range + worst->ranges - OF_ALL;

	worst->T0 = last[0];
	worst->travel = last[1];
	worst->force = last[2];
	worst->power = last[3];
	worst->needed_friction = last[4];
	for (int i = 0; i < worst->lanes; i++) {
		struct hawser_ropeway_lane_range *lane = &worst->lane[i];
		const struct hawser_ropeway_range *all = lane->envelope + (worst->towers + 1)*ENVELOPE;

		lane->T = all[0];
		lane->T_top = all[1];
		for (int k = 0; k <= worst->towers; k++) {
			lane->span_min =
				lane->span[k].T.min < lane->span[lane->span_min].T.min ? k : lane->span_min;
			lane->span_max =
				lane->span[k].T.max > lane->span[lane->span_max].T.max ? k : lane->span_max;
		}
	}
}

/* 1 if the state depends on the phase. */
static int has_carriers(const struct hawser_ropeway *rw, int load_case)
{
	const double *mass = rw->load_case[load_case].mass;

	return rw->spacing > 0.0 && (mass[0] > 0.0 || (rw->lanes > 1 && mass[1] > 0.0));
}

static enum hawser_status run(struct hawser_ropeway_worst *worst, struct sweep *sweep,
                              struct hawser_report *report)
{
	enum hawser_status status = allot(worst, sweep->ropeway, report);
	int threads = sweep->options.threads > 0 ? sweep->options.threads : hawser__processors();

	worst->phases = sweep->phases;
	worst->load_case = sweep->options.load_case;
	sweep->values = worst->ranges;
	sweep->row = malloc((size_t)sweep->phases*(size_t)sweep->values*sizeof *sweep->row);
	sweep->outcome = calloc((size_t)sweep->phases, sizeof *sweep->outcome);
	if (!status && (!sweep->row || !sweep->outcome))
		status = hawser__no_memory(report, "ropeway");
	if (!status) {
		hawser__share(sweep->phases, threads, one_phase, sweep);
		status = compare(worst, sweep, report);
	}
	if (!status)
		status = places(worst, sweep, report);
	if (!status)
		finish(worst);
	free(sweep->row);
	free(sweep->outcome);
	return status;
}

enum hawser_status hawser_ropeway_sweep(struct hawser_ropeway_worst *worst,
                                        const struct hawser_ropeway *rw,
                                        const struct hawser_ropeway_options *options,
                                        struct hawser_report *report)
{
	struct sweep sweep = {.ropeway = rw,
	                      .options = options ? *options : (struct hawser_ropeway_options){0}};
	struct hawser__frame frame;
	enum hawser_status status;

	memset(worst, 0, sizeof *worst);
	hawser_ropeway_settle(&sweep.options);
	if (sweep.options.load_case < 0 || sweep.options.load_case >= rw->cases ||
	    sweep.options.phases < 1 || sweep.options.phases > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "ropeway",
		                    "load case %d of %d with %d phases: the "
		                    "case must exist, and phases be from 1 to %d",
		                    sweep.options.load_case, rw->cases, sweep.options.phases, MOST);
	sweep.phases = has_carriers(rw, sweep.options.load_case) ? sweep.options.phases : 1;
	status = hawser__frame_open(&frame, rw, report);
	if (!status)
		status = hawser__frame_refer(&frame, report);
	sweep.frame = &frame;
	if (!status)
		status = run(worst, &sweep, report);
	hawser__frame_clear(&frame);
	if (status)
		hawser_ropeway_worst_clear(worst);
	return hawser__in_file(report, status, rw->name);
}

void hawser_ropeway_worst_clear(struct hawser_ropeway_worst *worst)
{
	if (!worst)
		return;
	free(worst->range);
	for (int i = 0; i < HAWSER_ROPEWAY_LANES; i++)
		free(worst->lane[i].place);
	memset(worst, 0, sizeof *worst);
}
