/* study/map/map_row.c - a row of a map of responses: the curves of periodic motions along one
 * parameter.
 *
 * A curve is followed from each end of the row, and from the middle of what no curve covers, so that
 * each cell has every response that these curves have there: below and above a fold, stable or not. A
 * response of a cell is the orbit at exactly its value of the parameter (response/branch/stops.h).
 * Two of them are the same if their states at phase 0 are.
 *
 * A curve that is closed, and lies where other curves are (an isola), is found where the linear
 * response leads to it from one of PLACES more values, and is missed otherwise. Of a row over a
 * parameter, curves over the frequency at both of its ends lead to further ones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/branch/stops.h"
#include "study/map/map_rows.h"

#define SAME_STATE 1e-5 /* relative distance of the states of one response, computed twice: orbits have
                         * errors of 1e-9, near a fold their square roots; chosen */
#define SAME_EVENT 1e-6 /* the same for values of the parameter at events, of the range; chosen */
enum { MOST_STARTS = 8, PLACES = 3 };

struct response {
	int place;
	double amplitude, tension; /* m, N */
	int unstable;
};

struct rows_trace {
	struct hawser__map_row *row;
	const struct hawser_rom *rom;
	const struct hawser_rom_family *family;
	double *at;            /* [count] ascending, in the parameter of the trace */
	int count, backwards;  /* 1: place i is answer count - 1 - i */
	double unit;           /* of the parameter: value in the map per value in the trace */
	double omega;          /* scaled, for the size of velocities */
	struct response *found; /* [responses] */
	double *state;         /* [responses][m] */
	int responses, m;
	enum hawser_frf_end end; /* of the last trace */
	int points;            /* of the last trace */
	double *first;         /* [m] state at its first orbit */
	struct hawser_report failed; /* the first failure */
};

/* --- responses --- */

static int same(const struct rows_trace *trace, const double *a, const double *b)
{
	double distance = 0.0, size = 0.0;

	for (int i = 0; i < trace->m; i++) {
		double weight = i < trace->m/2 ? 1.0 : 1.0/(trace->omega*trace->omega);

		distance += weight*(a[i] - b[i])*(a[i] - b[i]);
		size += weight*a[i]*a[i];
	}
	return distance <= SAME_STATE*SAME_STATE*size;
}

static int known(const struct rows_trace *trace, int place, const double *state)
{
	for (int r = 0; r < trace->responses; r++)
		if (trace->found[r].place == place &&
		    same(trace, trace->state + (size_t)r*(size_t)trace->m, state))
			return 1;
	return 0;
}

static enum hawser_status add_response(struct rows_trace *trace, const struct response *response,
                                       const double *state, struct hawser_report *report)
{
	size_t m = (size_t)trace->m;

	if (hawser__more(&trace->found, trace->responses, sizeof *trace->found) ||
	    hawser__more(&trace->state, trace->responses, m*sizeof *trace->state))
		return hawser__no_memory(report, "map");
	memcpy(trace->state + (size_t)trace->responses*m, state, m*sizeof *state);
	trace->found[trace->responses++] = *response;
	return HAWSER_OK;
}

static enum hawser_status take_stops(struct rows_trace *trace, const struct hawser__stops *stops,
                                     struct hawser_report *report)
{
	double length = trace->rom->scaled ? trace->rom->length : 1.0;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < stops->stops && !status; i++) {
		const struct hawser__stop *stop = &stops->stop[i];
		const double *state = stops->state + (size_t)i*(size_t)stops->m;
		const struct response response = {stop->place, stop->peak*length, stop->tension,
		                                  stop->unstable};

		if (isfinite(stop->peak) && !known(trace, stop->place, state))
			status = add_response(trace, &response, state, report);
	}
	return status;
}

/* --- events --- */

static enum hawser_status add_turn(struct hawser__map_row *row, const struct hawser__map_turn *turn,
                                   double range, struct hawser_report *report)
{
	int k = row->turns;

	for (int i = 0; i < row->turns; i++)
		if (row->turn[i].kind == turn->kind && row->turn[i].side == turn->side &&
		    fabs(row->turn[i].at - turn->at) <= SAME_EVENT*range)
			return HAWSER_OK;
	if (hawser__more(&row->turn, row->turns, sizeof *row->turn))
		return hawser__no_memory(report, "map");
	for (; k > 0 && row->turn[k - 1].at > turn->at; k--)
		row->turn[k] = row->turn[k - 1];
	row->turn[k] = *turn;
	row->turns++;
	return HAWSER_OK;
}

/* The events at which responses appear or disappear, or one becomes stable or unstable. */
static enum hawser_status take_events(struct rows_trace *trace, const struct hawser_frf *frf,
                                      struct hawser_report *report)
{
	double range = trace->unit*(trace->at[trace->count - 1] - trace->at[0]);
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < frf->events && !status; i++) {
		const struct hawser_frf_event *event = &frf->event[i];
		double at = trace->family ? event->parameter : event->omega;
		int fold = event->kind == HAWSER_FOLD;
		int stability = (event->unstable[0] == 0) != (event->unstable[1] == 0);
		const struct hawser__map_turn turn = {at*trace->unit, event->error*fabs(at)*trace->unit,
			event->kind, fold ? -frf->point[event->after].direction : 0};

		if (fold ? !(trace->row->only_stable && !stability) : stability)
			status = add_turn(trace->row, &turn, range, report);
	}
	return status;
}

/* --- curves --- */

static int has_range(const struct rows_trace *trace)
{
	return trace->count > 1;
}

static struct hawser_frf_options options_of(const struct rows_trace *trace, double begin, int way)
{
	double lo = trace->at[0], hi = has_range(trace) ? trace->at[trace->count - 1] : 2.0*lo;

	return (struct hawser_frf_options){.family = trace->family, .from = way > 0 ? lo : hi,
		.to = way > 0 ? hi : lo, .begin = begin, .samples = HAWSER_NONE,
		.progress = trace->row->progress ? *trace->row->progress
		                                 : (struct hawser_progress){.function = NULL}};
}

static void note_failure(struct rows_trace *trace, const struct hawser_report *local)
{
	if (!trace->failed.status)
		trace->failed = *local;
}

/* Follow a curve from the value `begin`, upwards or downwards. start [m] or NULL. */
static enum hawser_status follow(struct rows_trace *trace, double begin, int way, const double *start,
                                 struct hawser_report *report)
{
	struct hawser_frf_options options = options_of(trace, begin, way);
	struct hawser__stops stops = {.at = trace->at, .count = trace->count};
	const struct hawser__trace_watch watch = {.context = &stops, .step = hawser__stops_step,
		.back = hawser__stops_back};
	struct hawser_report local = {.status = HAWSER_OK};
	struct hawser_frf frf;
	enum hawser_status status;

	options.start = start;
	options.max_points = has_range(trace) ? 0 : 2;
	status = hawser__frf_trace(&frf, trace->rom, &options, &watch, &local);
	trace->end = frf.end;
	trace->points = frf.points;
	if (status == HAWSER_ERR_CONVERGENCE) {
		note_failure(trace, &local);
		if (frf.points > 0) {
			trace->row->incomplete = 1;
			if (!trace->row->broken)
				hawser__map_note(&trace->row->broken, local.message);
		}
		status = HAWSER_OK;
	} else if (status && report) {
		*report = local;
	}
	if (!status && frf.end == HAWSER_END_INTERRUPTED)
		trace->row->interrupted = 1;
	if (!status && (frf.end == HAWSER_END_MAX_POINTS || stops.missed > 0) && has_range(trace)) {
		trace->row->incomplete = 1;
		if (!trace->row->broken)
			hawser__map_note(&trace->row->broken, stops.missed > 0
			                 ? "an orbit of a curve was not found at a value of the row"
			                 : "a curve has more points than a trace may have");
	}
	if (!status && frf.points > 0)
		memcpy(trace->first, frf.state, (size_t)trace->m*sizeof(double));
	if (!status)
		status = take_stops(trace, &stops, report);
	if (!status)
		status = take_events(trace, &frf, report);
	hawser__stops_clear(&stops);
	hawser_frf_clear(&frf);
	return status;
}

/* A curve through the value, both ways. */
static enum hawser_status follow_both(struct rows_trace *trace, double begin, const double *start,
                                      struct hawser_report *report)
{
	double lo = trace->at[0], hi = trace->at[trace->count - 1];
	enum hawser_status status = HAWSER_OK;

	if (begin < hi)
		status = follow(trace, begin, 1, start, report);
	if (!status && begin > lo && (begin >= hi || trace->end != HAWSER_END_CLOSED) &&
	    !trace->row->interrupted)
		status = follow(trace, begin, -1, start, report);
	return status;
}

/* The orbit to which start [m], or if NULL the linear response, leads at this value. Follow its curve,
 * if it is new. */
static enum hawser_status look(struct rows_trace *trace, double at, const double *start,
                               struct hawser_report *report)
{
	struct hawser_frf_options options = options_of(trace, at, 1);
	int place = 0;
	struct hawser_report local = {.status = HAWSER_OK};
	struct hawser_frf frf;
	enum hawser_status status;

	while (place < trace->count && trace->at[place] != at)
		place++;
	if (start && known(trace, place, start))
		return HAWSER_OK;
	options.start = start;
	options.max_points = 1;
	options.skip_events = 1;
	status = hawser__frf_trace(&frf, trace->rom, &options, NULL, &local);
	if (!status && frf.points > 0 && !known(trace, place, frf.state))
		status = follow_both(trace, at, frf.state, report);
	else if (status == HAWSER_ERR_CONVERGENCE)
		status = HAWSER_OK;
	else if (status && report)
		*report = local;
	hawser_frf_clear(&frf);
	return status;
}

/* A row over a parameter has at this place the responses of the curves over the frequency too, which
 * connect others than the row does. */
static enum hawser_status from_frequencies(struct rows_trace *trace, int place,
                                           struct hawser_report *report)
{
	const struct hawser_rom_family *family = trace->family;
	struct hawser__map_row row = {.at = NULL};
	const struct hawser_rom *rom;
	enum hawser_status status = HAWSER_OK;

	if (!family || trace->row->across || family->model(family->context, &rom, trace->at[place], NULL))
		return HAWSER_OK;
	status = hawser__map_row_at(&row, rom, family->omega, trace->row->progress, report);
	for (int i = 0; i < row.kept && !status && !trace->row->interrupted; i++)
		status = look(trace, trace->at[place], row.state + (size_t)i*(size_t)trace->m, report);
	hawser__map_row_clear(&row);
	return status;
}

static enum hawser_status from_seeds(struct rows_trace *trace, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < trace->row->seeds && !status && !trace->row->interrupted; i++) {
		const struct hawser__map_seed *seed = &trace->row->seed[i];

		status = 2*seed->coordinates == trace->m
		         ? look(trace, seed->at/trace->unit, seed->state, report)
		         : hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                        "the motion at which the map begins has %d coordinates, and the "
		                        "map's model has %d: give both the same modes (--modes) and "
		                        "model.energy", seed->coordinates, trace->m/2);
	}
	return status;
}

/* The middle of the longest run of places without a response that has not been tried; -1: none. */
static int uncovered(const struct rows_trace *trace, const unsigned char *tried)
{
	int best = 0, middle = -1;

	for (int i = 0, run = 0; i < trace->count; i++) {
		int bare = !tried[i];

		for (int r = 0; bare && r < trace->responses; r++)
			bare = trace->found[r].place != i;
		run = bare ? run + 1 : 0;
		if (run > best) {
			best = run;
			middle = i - run/2;
		}
	}
	return middle;
}

static enum hawser_status cover(struct rows_trace *trace, struct hawser_report *report)
{
	unsigned char *tried = calloc((size_t)trace->count, 1);
	enum hawser_status status = HAWSER_OK;

	if (!tried)
		return hawser__no_memory(report, "map");
	for (int i = 0, place; i < MOST_STARTS && !status && !trace->row->interrupted &&
	     (place = uncovered(trace, tried)) >= 0; i++) {
		tried[place] = 1;
		status = follow_both(trace, trace->at[place], NULL, report);
	}
	free(tried);
	return status;
}

static enum hawser_status follow_all(struct rows_trace *trace, struct hawser_report *report)
{
	int last = trace->count - 1, covered;
	enum hawser_status status = follow(trace, trace->at[0], 1, NULL, report);

	if (!has_range(trace) || status || trace->row->interrupted)
		return status;
	covered = trace->points > 1 && trace->end == HAWSER_END_RANGE;
	status = covered ? look(trace, trace->at[last], NULL, report)
	                 : follow(trace, trace->at[last], -1, NULL, report);
	if (!status && !trace->row->interrupted)
		status = cover(trace, report);
	for (int k = 1; k <= PLACES && !status && !trace->row->interrupted; k++)
		status = look(trace, trace->at[k*last/(PLACES + 1)], NULL, report);
	for (int k = 0; k < 2 && !status && !trace->row->interrupted; k++)
		status = from_frequencies(trace, k*last, report);
	return status ? status : from_seeds(trace, report);
}

/* --- answers --- */

static struct hawser__map_answer answer_at(const struct rows_trace *trace, int place)
{
	struct hawser__map_answer all[2]; /* of responses that a cable bears, and of slack ones */
	int any = 0;

	for (int k = 0; k < 2; k++)
		all[k] = (struct hawser__map_answer){.least = INFINITY, .tension = NAN};
	for (int r = 0; r < trace->responses; r++) {
		const struct response *response = &trace->found[r];
		struct hawser__map_answer *to = &all[response->tension < 0.0];

		if (response->place != place)
			continue;
		any = 1;
		to->stable += response->unstable == 0;
		if (trace->row->only_stable && response->unstable > 0)
			continue;
		if (to->branches == 0 || response->unstable < to->sample.number)
			to->sample.number = response->unstable;
		to->branches++;
		to->least = fmin(to->least, response->amplitude);
		to->most = fmax(to->most, response->amplitude);
		to->tension = fmin(to->tension, response->tension);
	}
	for (int k = 0; k < 2; k++)
		if (all[k].branches > 0) {
			all[k].sample.code = k ? HAWSER_MAP_SLACK : HAWSER_MAP_OK;
			all[k].sample.value = all[k].most;
			return all[k];
		}
	all[0].least = 0.0;
	all[0].sample.code = any ? HAWSER_MAP_NO_STATE : HAWSER_MAP_NOT_CONVERGED;
	return all[0];
}

/* --- a row --- */

/* Values of the followed parameter that are positive, as those of Omega and of the load's factor must
 * be; others are refused. Returns the number of the others, which are the first places. */
static int refuse_low(struct rows_trace *trace, int positive)
{
	struct hawser__map_row *row = trace->row;
	int low = 0;
	char text[120];

	while (positive && low < row->count && !(trace->at[low] > 0.0))
		low++;
	if (low > 0) {
		snprintf(text, sizeof text, "the followed parameter is %.9g: it must be greater than zero",
		         trace->at[0]);
		for (int i = 0; i < low; i++) {
			int k = trace->backwards ? row->count - 1 - i : i;

			hawser__map_row_fill(row, k, k + 1, HAWSER_MAP_REFUSED, text);
		}
	}
	return low;
}

/* The places from `first` on are those of the trace. */
static enum hawser_status keep_states(const struct rows_trace *trace, int first,
                                      struct hawser_report *report)
{
	struct hawser__map_row *row = trace->row;
	size_t m = (size_t)trace->m;

	row->coordinates = trace->m/2;
	row->state = malloc(((size_t)trace->responses + 1)*m*sizeof *row->state);
	row->kept_at = malloc(((size_t)trace->responses + 1)*sizeof *row->kept_at);
	if (!row->state || !row->kept_at)
		return hawser__no_memory(report, "map");
	for (int r = 0; r < trace->responses; r++) {
		int place = first + trace->found[r].place;

		if (row->keep != HAWSER__MAP_KEEPS_ALL && row->keep != place)
			continue;
		memcpy(row->state + (size_t)row->kept*m, trace->state + (size_t)r*m, m*sizeof *row->state);
		row->kept_at[row->kept++] = trace->backwards ? row->count - 1 - place : place;
	}
	return HAWSER_OK;
}

static enum hawser_status follow_row(struct rows_trace *trace, int positive,
                                     struct hawser_report *report)
{
	struct hawser__map_row *row = trace->row;
	int low;
	double *all = trace->at;
	enum hawser_status status;

	for (int i = 0; i < row->count; i++)
		trace->at[i] = row->at[trace->backwards ? row->count - 1 - i : i];
	low = refuse_low(trace, positive);
	for (int i = 0; i < row->count; i++)
		trace->at[i] /= trace->unit;
	trace->at += low;
	trace->count = row->count - low;
	status = trace->count > 0 ? follow_all(trace, report) : HAWSER_OK;
	if (!status && row->keeps)
		status = keep_states(trace, low, report);
	for (int i = 0; i < trace->count && !status; i++) {
		int k = trace->backwards ? row->count - 1 - low - i : low + i;

		row->answer[k] = answer_at(trace, i);
		hawser__map_row_explain(row, &row->answer[k],
		                        trace->failed.status ? trace->failed.message : NULL);
	}
	trace->at = all;
	return status;
}

static enum hawser_status open_arrays(struct rows_trace *trace, struct hawser_report *report)
{
	struct hawser__map_row *row = trace->row;

	trace->m = 2*trace->rom->n;
	trace->at = malloc((size_t)row->count*sizeof *trace->at);
	trace->first = malloc((size_t)trace->m*sizeof *trace->first);
	trace->backwards = row->at[0] > row->at[row->count - 1];
	return trace->at && trace->first ? HAWSER_OK : hawser__no_memory(report, "map");
}

enum hawser_status hawser__map_row_follow(struct hawser__map_row *row, const struct hawser_rom *rom,
                                          const struct hawser_rom_family *family, double omega,
                                          int positive, struct hawser_report *report)
{
	struct rows_trace trace = {.row = row, .rom = rom, .family = family,
		.unit = family ? 1.0 : 1.0/rom->time, .omega = omega*rom->time};
	enum hawser_status status = open_arrays(&trace, report);

	if (!status)
		status = follow_row(&trace, positive, report);
	free(trace.at);
	free(trace.first);
	free(trace.found);
	free(trace.state);
	return status;
}
