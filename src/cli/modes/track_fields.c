/* cli/modes/track_fields.c - columns and keys of frequencies along a sweep: see track_ropeway.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "cli/modes/track_ropeway.h"
#include "core/report.h"

struct row {
	const struct cli_track *of;
	struct hawser_ropeway_track_point at;
	double value;
	int branch, sample;
	const char *plane, *lane, *span;
};

/* The name of what is before span i of a lane (side 0) or behind it. */
static const char *beside(const struct cli_track *t, int i, int side)
{
	const struct hawser_ropeway *rw = &t->ropeway;
	const struct hawser_line *line = &t->span.line;

	if (t->obstacles)
		return i + side == 0 ? "A" : i + side > line->sheaves ? "B" : line->sheave[i + side - 1].name;
	return i + side == 0 ? "bottom" : i + side > rw->towers ? "top" : rw->tower[i + side - 1].name;
}

enum hawser_status cli_track_name_spans(struct cli_track *t, struct hawser_report *report)
{
	int spans = 1 + (t->obstacles ? t->span.line.sheaves : t->ropeway.towers);
	int count = t->obstacles ? spans : t->ropeway.lanes*spans;

	t->name = calloc((size_t)count, sizeof *t->name);
	if (!t->name)
		return hawser__no_memory(report, t->command);
	for (int k = 0; k < count; k++)
		snprintf(t->name[k], CLI_MODES_SPAN, "%.31s to %.31s", beside(t, k % spans, 0),
		         beside(t, k % spans, 1));
	return HAWSER_OK;
}

static void fill_row(struct row *row, const struct cli_track *t, int i, int b)
{
	*row = (struct row){.of = t, .at = t->track.point[i*t->track.branches + b],
	                    .value = t->track.sample[i].value, .branch = b + 1, .sample = i,
	                    .plane = hawser_plane_name(t->track.plane[b])};
	if (row->at.span < 0)
		return;
	row->lane = t->obstacles ? "" : row->at.span > t->ropeway.towers ? "down" : "up";
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

	snprintf(text, size, "%s%s", t->sweep.key, t->swept == CLI_SWEPT_SPEED ? "_m_s"
	         : t->swept == CLI_SWEPT_TENSION ? suffix[t->ropeway.tension] : "");
}

static const char *value_unit(const void *context)
{
	return ((const struct cli_track *)context)->sweep.si;
}

#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_track_field[] = {
	{NULL, "KEY", "value of what is swept", OF(value), .named = value_name, .si = value_unit},
	{NULL, "branch", "from 1, by frequency at the first value", OF(branch)},
	{NULL, "omega", "circular frequency", OF(at.omega), .unit = HAWSER__RADIAN_S,
	 .flags = HAWSER__NULL},
	{NULL, "frequency", "frequency", OF(at.omega), .unit = HAWSER__HERTZ, .flags = HAWSER__NULL},
	{NULL, "plane", "in-plane or out-of-plane", OF(plane)},
	{NULL, "lane", "of ropeways: of the span with the largest share", OF(lane),
	 .flags = HAWSER__NULL, .when = CLI_TRACK_LANES},
	{NULL, "span", "with the largest share of the kinetic energy", OF(span), .flags = HAWSER__NULL},
	{NULL, "span_share", "its share", OF(at.share), .flags = HAWSER__NULL},
	{NULL, "residual", "error estimate of the frequency, relative", OF(at.residual),
	 .flags = HAWSER__NULL},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_track_rows = {
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
		if (!t->obstacles)
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
		if (t->obstacles)
			hawser__json_integer(json, to, "touched", at->touched);
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

static void resonances_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_track *t = of;
	json_t *list;

	if (t->swept != CLI_SWEPT_SPEED || !(t->distance > 0.0))
		return;
	hawser__json_number(json, into, "spacing", t->distance);
	list = hawser__json_array(json, into, "resonances");
	for (int i = 0; i < t->resonances; i++) {
		const struct hawser_campbell_resonance *at = &t->resonance[i];
		json_t *to = hawser__json_object(json, list, NULL);

		hawser__json_integer(json, to, "harmonic", at->harmonic);
		hawser__json_text(json, to, "plane", hawser_plane_name(t->track.plane[at->branch]));
		hawser__json_integer(json, to, "branch", at->branch + 1);
		hawser__json_number(json, to, "speed", at->speed);
		hawser__json_number(json, to, "omega", at->omega);
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
	{"swept", NULL, "what is swept", OF(sweep.key)},
	{"unit", NULL, "its unit", OF(sweep.si)},
	{"solves", NULL, "number of modal solutions", OF(track.solves)},
	{"least_correlation", NULL, "of a branch's shapes at neighbouring values, squared",
	 OF(track.least_correlation)},
	{"speeds", NULL, "of campbell; stations of others: speed or value, T0 (N), inserted, unsure, "
	 "eigenvalues: branch, plane, re, im (rad/s), frequency (Hz), lane, span, share, residual",
	 HAWSER__CALLS(samples_json)},
	{"crossovers", NULL, "kind (crossing or veering), value, omega (rad/s), relative_gap, branches "
	 "(null: one that is not followed)", HAWSER__CALLS(crossovers_json)},
	{"resonances", NULL, "of campbell, with the spacing (m) of the carriers: where multiples of their "
	 "passing frequency meet branches: harmonic, plane, branch, speed, omega (rad/s)",
	 HAWSER__CALLS(resonances_json)},
	{"ended", NULL, "if the sweep ended before its end: value, why", HAWSER__CALLS(ended_json)},
	HAWSER__END,
};
#undef OF
