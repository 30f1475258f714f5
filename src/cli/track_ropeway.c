/* cli/track_ropeway.c - see track_ropeway.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/track_ropeway.h"
#include "core/report.h"
#include "output/plot_track.h"

/* Values of a sweep: by default, and at most. */
enum { POINTS = 41, MOST = 2000 };
#define FASTEST "10 m/s" /* ropeways run at up to some 12 m/s, chairlifts at 5 */
#define AROUND 2.0       /* irvine: the tension of the scene over and times this */

static const char *const tension_name[] = {"counterweight", "T0", "length0", "T_empty"};
static const char *const unit_name[] = {"rad/s", "Hz"};

/* --- the scene at a value --- */

static enum hawser_status open_at(struct hawser_ropeway *rw, void *context, double value,
                                  struct hawser_report *report)
{
	const struct cli_track *t = context;
	struct cli_common common = *t->common;
	char set[192];
	int load_case;
	enum hawser_status status;

	snprintf(set, sizeof set, "%s=%.17g %s", t->key, value, t->si);
	if (t->swept == CLI_SWEPT_KEY && common.sets < CLI_SETS)
		common.set[common.sets++] = set;
	status = cli_ropeway_open(rw, &load_case, &common, t->command, &t->choice, report);
	if (status)
		return status;
	if (t->swept == CLI_SWEPT_SPEED) {
		rw->speed = value;
		rw->sliding = rw->sliding == HAWSER_ROPEWAY_REST ? HAWSER_ROPEWAY_RUNNING : rw->sliding;
		if (rw->hold == HAWSER_ROPEWAY_HOLD_AUTO) /* at the speed 0 as at all others */
			rw->hold = HAWSER_ROPEWAY_HOLD_SLIP;
	}
	if (t->swept == CLI_SWEPT_TENSION)
		rw->value = value;
	return HAWSER_OK;
}

/* --- what is swept --- */

static enum hawser_status wrong(const struct cli_track *t, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, t->command,
	                    "--over %s: write KEY=FROM:TO:POINTS with 2 to %d points and the same unit in "
	                    "both, such as \"ropeway.towers.p0.at.1=15 m:20 m:41\"", t->over, MOST);
}

/* KEY=FROM:TO:POINTS: numbers in SI, or with a unit that both have. */
static enum hawser_status read_over(double *from, double *to, struct cli_track *t,
                                    struct hawser_report *report)
{
	const char *equals = strchr(t->over, '='), *colon, *second;
	char *end;
	size_t length, unit;

	if (!equals || (length = (size_t)(equals - t->over)) == 0 || length >= sizeof t->key)
		return wrong(t, report);
	snprintf(t->key, sizeof t->key, "%.*s", (int)length, t->over);
	*from = strtod(equals + 1, &end);
	colon = strchr(equals, ':');
	if (!colon || end == equals + 1 || end > colon)
		return wrong(t, report);
	end += strspn(end, " ");
	unit = (size_t)(colon - end);
	if (unit >= sizeof t->si)
		return wrong(t, report);
	snprintf(t->si, sizeof t->si, "%.*s", (int)unit, end);
	*to = strtod(colon + 1, &end);
	second = strchr(colon + 1, ':');
	if (!second || end == colon + 1 || end > second)
		return wrong(t, report);
	end += strspn(end, " ");
	if ((size_t)(second - end) != unit || strncmp(end, t->si, unit) != 0)
		return wrong(t, report);
	t->points = (int)strtol(second + 1, &end, 10);
	return end == second + 1 || *end || t->points < 2 || t->points > MOST || !isfinite(*from) ||
		!isfinite(*to) || *from == *to ? wrong(t, report) : HAWSER_OK;
}

static enum hawser_status range_of(double *from, double *to, struct cli_track *t,
                                   struct hawser_report *report)
{
	const struct hawser_ropeway *rw = &t->ropeway;
	enum cli_sign sign = t->swept == CLI_SWEPT_SPEED ? CLI_NOT_NEGATIVE : CLI_ABOVE_ZERO;
	int length = t->swept == CLI_SWEPT_TENSION && rw->tension == HAWSER_ROPEWAY_LENGTH0;
	enum hawser_status status;

	if (t->swept == CLI_SWEPT_KEY)
		return read_over(from, to, t, report);
	*from = t->swept == CLI_SWEPT_SPEED ? 0.0 : length ? rw->value*1.0005 : rw->value/AROUND;
	*to = length ? rw->value*0.9995 : rw->value*AROUND;
	snprintf(t->key, sizeof t->key, "%s",
	         t->swept == CLI_SWEPT_SPEED ? "speed" : tension_name[rw->tension]);
	snprintf(t->si, sizeof t->si, "%s", t->swept == CLI_SWEPT_SPEED ? "m/s" : length ? "m" : "N");
	status = cli_quantity(from, t->from, t->si, sign, t->command, "from", report);
	if (!status)
		status = cli_quantity(to, t->to || t->swept == CLI_SWEPT_TENSION ? t->to : FASTEST, t->si, sign,
		                      t->command, "to", report);
	t->points = t->points ? t->points : POINTS;
	if (!status && (*from == *to || t->points > MOST))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, t->command, "--from and --to are both %.9g "
		                      "%s, or --points is above %d: give a range, and 2 to %d points", *from,
		                      t->si, MOST, MOST);
	return status;
}

static enum hawser_status place(struct cli_track *t, struct hawser_report *report)
{
	double from = 0.0, to = 0.0;
	enum hawser_status status = range_of(&from, &to, t, report);

	if (status)
		return status;
	if (t->logarithmic && !(from > 0.0 && to > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, t->command, "--log: from %.9g to %.9g there "
		                    "are no equal ratios: give values above 0", from, to);
	t->value = calloc((size_t)t->points, sizeof *t->value);
	if (!t->value)
		return hawser__no_memory(report, t->command);
	for (int i = 0; i < t->points; i++) {
		double part = (double)i/(t->points - 1);

		t->value[i] = i + 1 == t->points ? to : t->logarithmic ? from*pow(to/from, part)
		                                                       : from + part*(to - from);
	}
	return HAWSER_OK;
}

/* --- table and JSON --- */

struct row {
	const struct cli_track *of;
	struct hawser_ropeway_track_point at;
	double value;
	int branch, sample;
	const char *plane, *lane, *span;
};

static enum hawser_status name_spans(struct cli_track *t, struct hawser_report *report)
{
	const struct hawser_ropeway *rw = &t->ropeway;
	int count = rw->lanes*(rw->towers + 1);

	t->name = calloc((size_t)count, sizeof *t->name);
	if (!t->name)
		return hawser__no_memory(report, t->command);
	for (int k = 0; k < count; k++) {
		int i = k % (rw->towers + 1);

		snprintf(t->name[k], CLI_MODES_SPAN, "%s to %s", i > 0 ? rw->tower[i - 1].name : "bottom",
		         i < rw->towers ? rw->tower[i].name : "top");
	}
	return HAWSER_OK;
}

static void fill_row(struct row *row, const struct cli_track *t, int i, int b)
{
	*row = (struct row){.of = t, .at = t->track.point[i*t->track.branches + b],
	                    .value = t->track.sample[i].value, .branch = b + 1, .sample = i,
	                    .plane = hawser_plane_name(t->track.plane[b])};
	if (row->at.span < 0)
		return;
	row->lane = row->at.span > t->ropeway.towers ? "down" : "up";
	row->span = t->name[row->at.span];
}

static size_t count_rows(const void *parent)
{
	const struct cli_track *t = parent;

	return (size_t)t->track.samples*(size_t)t->track.branches;
}

static const void *make_row(void *to, const void *parent, size_t k)
{
	const struct cli_track *t = parent;
	int n = t->track.branches;

	fill_row(to, t, (int)k/n, (int)k % n);
	return to;
}

static void value_name(char *text, size_t size, const void *context)
{
	const struct cli_track *t = context;
	static const char *const suffix[] = {"_N", "_N", "_m", "_N"}; /* by enum hawser_ropeway_tension */

	snprintf(text, size, "%s%s", t->key, t->swept == CLI_SWEPT_SPEED ? "_m_s"
	         : t->swept == CLI_SWEPT_TENSION ? suffix[t->ropeway.tension] : "");
}

static const char *value_unit(const void *context)
{
	return ((const struct cli_track *)context)->si;
}

#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_track_field[] = {
	{NULL, "KEY", "value of what is swept", OF(value), .named = value_name, .si = value_unit},
	{NULL, "branch", "from 1, by frequency at the first value", OF(branch)},
	{NULL, "omega", "circular frequency", OF(at.omega), .unit = HAWSER__RADIAN_S,
	 .flags = HAWSER__NULL},
	{NULL, "frequency", "frequency", OF(at.omega), .unit = HAWSER__HERTZ, .flags = HAWSER__NULL},
	{NULL, "plane", "in-plane or out-of-plane", OF(plane)},
	{NULL, "lane", "of the span with the largest share", OF(lane), .flags = HAWSER__NULL},
	{NULL, "span", "with the largest share of the kinetic energy", OF(span), .flags = HAWSER__NULL},
	{NULL, "span_share", "its share", OF(at.share), .flags = HAWSER__NULL},
	{NULL, "residual", "error estimate of the frequency, relative", OF(at.residual),
	 .flags = HAWSER__NULL},
	HAWSER__END,
};
#undef OF
static const struct hawser__list row_list = {
	.field = cli_track_field, .size = HAWSER__MADE_SIZE(struct row), .count = count_rows,
	.row = make_row};

static void branches_json(struct hawser__json *json, json_t *into, const struct cli_track *t, int i)
{
	json_t *list = hawser__json_array(json, into, "eigenvalues");

	for (int b = 0; b < t->track.branches; b++) {
		json_t *to = hawser__json_object(json, list, NULL);
		struct row row;

		fill_row(&row, t, i, b);
		hawser__json_integer(json, to, "branch", row.branch);
		hawser__json_text(json, to, "plane", row.plane);
		if (row.at.span < 0)
			continue;
		hawser__json_number(json, to, "re", 0.0);
		hawser__json_number(json, to, "im", row.at.omega);
		hawser__json_number(json, to, "frequency", row.at.omega/(2.0*M_PI));
		hawser__json_text(json, to, "lane", row.lane);
		hawser__json_text(json, to, "span", row.span);
		hawser__json_number(json, to, "share", row.at.share);
		hawser__json_number(json, to, "residual", row.at.residual);
	}
}

static void samples_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_track *t = of;
	int speeds = t->swept == CLI_SWEPT_SPEED;
	json_t *list = hawser__json_array(json, into, speeds ? "speeds" : "stations");

	for (int i = 0; i < t->track.samples; i++) {
		const struct hawser_ropeway_track_sample *at = &t->track.sample[i];
		json_t *to = hawser__json_object(json, list, NULL);

		hawser__json_number(json, to, speeds ? "speed" : "value", at->value);
		hawser__json_number(json, to, "T0", at->T0);
		hawser__json_flag(json, to, "inserted", at->inserted);
		hawser__json_flag(json, to, "unsure", at->unsure);
		branches_json(json, to, t, i);
	}
}

static void crossovers_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_track *t = of;
	json_t *list = hawser__json_array(json, into, "crossovers");

	for (int i = 0; i < t->track.crossovers; i++) {
		const struct hawser_ropeway_track_crossover *at = &t->track.crossover[i];
		json_t *to = hawser__json_object(json, list, NULL), *pair;

		hawser__json_text(json, to, "kind", at->veers ? "veering" : "crossing");
		hawser__json_number(json, to, "value", at->value);
		hawser__json_number(json, to, "omega", at->omega);
		hawser__json_number(json, to, "relative_gap", at->gap);
		pair = hawser__json_array(json, to, "branches");
		for (int k = 0; k < 2; k++) {
			int branch = k ? at->above : at->below;

			if (branch < 0)
				hawser__json_null(json, pair, NULL);
			else
				hawser__json_integer(json, pair, NULL, branch + 1);
		}
	}
}

static void ended_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_track *t = of;
	json_t *to;

	if (!t->track.ended)
		return;
	to = hawser__json_object(json, into, "ended");
	hawser__json_number(json, to, "value", t->track.end);
	hawser__json_text(json, to, "why", t->track.why.message);
}

#define OF(member) HAWSER__AT(struct cli_track, member)
const struct hawser__field cli_track_member[] = {
	{"swept", NULL, "what is swept", OF(key)},
	{"unit", NULL, "its unit", OF(si)},
	{"solves", NULL, "number of modal solutions", OF(track.solves)},
	{"least_correlation", NULL, "of a branch's shapes at neighbouring values, squared",
	 OF(track.least_correlation)},
	{"speeds", NULL, "of campbell; stations of others: speed or value, T0 (N), inserted, unsure, "
	 "eigenvalues: branch, plane, re, im (rad/s), frequency (Hz), lane, span, share, residual",
	 HAWSER__CALLS(samples_json)},
	{"crossovers", NULL, "kind (crossing or veering), value, omega (rad/s), relative_gap, branches "
	 "(null: one that is not followed)", HAWSER__CALLS(crossovers_json)},
	{"ended", NULL, "if the sweep ended before its end: value, why", HAWSER__CALLS(ended_json)},
	HAWSER__END,
};
#undef OF

/* --- the result --- */

static struct cli_head head(const void *of)
{
	const struct cli_track *t = of;

	return (struct cli_head){.common = t->common, .command = t->command,
	                         .method = "spectral elements, piece by piece",
	                         .view = {.scale = hawser__si, .context = t}};
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_track *t = of;
	const struct hawser_ropeway_track *track = &t->track;
	int unsure = 0;

	for (int i = 0; i < track->samples; i++)
		unsure += track->sample[i].unsure;
	hawser__table_comment(table, "%s from %.9g to %.9g%s%s; case %s", t->key,
	                      track->sample[0].value, track->sample[track->samples - 1].value,
	                      *t->si ? " " : "", t->si,
	                      t->ropeway.load_case[t->load_case].name);
	hawser__table_comment(table, "%d modal solutions; least squared correlation of a branch %.3g",
	                      track->solves, track->least_correlation);
	if (unsure > 0)
		hawser__table_comment(table, "at %d values a branch was continued by shapes that had changed "
		                      "by more than a half", unsure);
	for (int i = 0; i < track->crossovers; i++) {
		const struct hawser_ropeway_track_crossover *at = &track->crossover[i];

		char pair[48];

		if (at->below < 0 || at->above < 0)
			snprintf(pair, sizeof pair, "branch %d and one that is not followed",
			         1 + (at->below < 0 ? at->above : at->below));
		else
			snprintf(pair, sizeof pair, "branches %d and %d", at->below + 1, at->above + 1);
		hawser__table_comment(table, "%s at %s = %.9g%s%s: %s, omega = %.9g rad/s, relative gap %.2e",
		                      at->veers ? "veering" : "crossing", t->key, at->value, *t->si ? " " : "",
		                      t->si, pair, at->omega, at->gap);
	}
	if (track->ended)
		hawser__table_comment(table, "the sweep ends before %s = %.9g%s%s: %s", t->key, track->end,
		                      *t->si ? " " : "", t->si, track->why.message);
}

static void rows(struct hawser__table *table, const void *of)
{
	const struct hawser__view view = head(of).view;

	hawser__fields_table(table, &row_list, of, &view);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_track *t = of;
	static const char *const title[] = {"Counterweight", "Tension {/:Italic T}_0",
	                                    "Length of the loop", "Tension of the empty rope"};
	char label[160];
	const char *what = t->swept == CLI_SWEPT_SPEED ? "Speed {/:Italic v}" : title[t->ropeway.tension];
	struct hawser__axis x, y = hawser__axis_of("Frequency", t->hertz ? "Hz" : "rad/s", 0.0);
	double largest = fmax(fabs(t->value[0]), fabs(t->value[t->points - 1]));

	if (t->swept == CLI_SWEPT_KEY) {
		size_t k = 0;

		for (const char *c = t->key; *c && k + 2 < sizeof label; c++) {
			if (*c == '_')
				label[k++] = '\\';
			label[k++] = *c;
		}
		label[k] = '\0';
		what = label;
	}
	x = hawser__axis_of(what, t->si, largest);
	return hawser__plot_track(path, &(struct hawser__track_picture){
		.track = &t->track, .x_title = x.title, .y_title = y.title, .x_per = x.per,
		.y_per = y.per*(t->hertz ? 2.0*M_PI : 1.0), .logarithmic = t->logarithmic,
		.harmonics = t->distance > 0.0 ? t->harmonics : 0,
		.slope = t->distance > 0.0 ? 2.0*M_PI/t->distance : 0.0}, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .more = rows, .fields = cli_track_member, .draw = draw};

static enum hawser_status solve(struct cli_track *t, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	t->hertz = 1;
	if (t->unit)
		status = cli_choose(&t->hertz, t->command, "unit", t->unit, unit_name, 2, report);
	if (!status)
		status = cli_ropeway_open(&t->ropeway, &t->load_case, t->common, t->command, &t->choice,
		                          report);
	if (!status && t->swept == CLI_SWEPT_SPEED) {
		t->distance = t->ropeway.spacing;
		status = cli_quantity(&t->distance, t->spacing, "m", CLI_ABOVE_ZERO, t->command, "spacing",
		                      report);
	}
	if (!status)
		status = place(t, report);
	if (!status)
		status = name_spans(t, report);
	if (!status)
		status = hawser_ropeway_track_solve(&t->track, &(struct hawser_ropeway_track_options){
			.value = t->value, .points = t->points, .open = open_at, .context = t,
			.load_case = t->load_case, .n = t->n}, report);
	return status;
}

enum hawser_status cli_track_run(struct cli_track *t, struct hawser_report *report)
{
	enum hawser_status status = cli_outputs_check(t->common, report);

	if (!status)
		status = solve(t, report);
	if (!status)
		status = cli_show(t->common, &showing, t, report);
	hawser_ropeway_track_clear(&t->track);
	hawser_ropeway_clear(&t->ropeway);
	free(t->value);
	free(t->name);
	return status;
}
