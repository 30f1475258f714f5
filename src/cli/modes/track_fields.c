/* cli/modes/track_fields.c - columns and keys of frequencies along a sweep: see modes_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/modes/modes_result.h"
#include "core/report.h"

/* of the view */
enum { LANES = 1, SPEEDS = 2, STATIONS = 4, OBSTACLES = 8, SPACED = 16, ENDED = 32 };

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
		/* NOLINTNEXTLINE(clang-analyzer-core.DivideZero): there is a span at least */
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

HAWSER__OF(count_rows, size_t, struct cli_track,
	(size_t)of->track.samples*(size_t)of->track.branches)

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

HAWSER__OF(value_unit, const char *, struct cli_track, of->sweep.si)

HAWSER__OF(re_of, double, struct row, of->at.span < 0 ? NAN : 0.0)

/* What a branch that is lost does not have. */
#define MAYBE(member) HAWSER__AT(struct row, member), .flags = HAWSER__OMIT
#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_track_field[] = {
	{NULL, "KEY", "value of what is swept", OF(value), .named = value_name, .si = value_unit},
	{"branch", "branch", "from 1, by frequency at the first value", OF(branch)},
	{"plane", "plane", "in-plane or out-of-plane", OF(plane), .place = 1},
	{"re", NULL, "real part of the eigenvalue", HAWSER__BY(re_of), .unit = HAWSER__RADIAN_S,
	 .flags = HAWSER__OMIT},
	{"im", "omega", "circular frequency", MAYBE(at.omega), .unit = HAWSER__RADIAN_S},
	{"frequency", "frequency", "frequency", MAYBE(at.omega), .unit = HAWSER__HERTZ},
	{"lane", "lane", "of ropeways: of the span with the largest share", MAYBE(lane),
	 .when = LANES, .place = 1},
	{"span", "span", "with the largest share of the kinetic energy", MAYBE(span), .place = 1},
	{"share", "span_share", "its share", MAYBE(at.share), .place = 1},
	{"residual", "residual", "error estimate of the frequency, relative", MAYBE(at.residual),
	 .place = 1},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_track_rows = {
	.field = cli_track_field, .size = HAWSER__MADE_SIZE(struct row), .count = count_rows,
	.row = make_row};
static const struct hawser__list branch_list = {
	.field = cli_track_field, .size = HAWSER__MADE_SIZE(struct row), .row = make_row, .part = 1,
	.inner_at = offsetof(struct cli_track, track.branches)};

#define OF(member) HAWSER__AT(struct hawser_ropeway_track_sample, member)
#define FLAG(member) HAWSER__FLAG_AT(struct hawser_ropeway_track_sample, member)
static const struct hawser__field sample_field[] = {
	{"speed", NULL, "of campbell: speed of the rope", OF(value), .unit = HAWSER__METRE_S,
	 .when = SPEEDS},
	{"value", NULL, "of others: value of what is swept", OF(value), .when = STATIONS},
	{"T0", NULL, "tension at the bottom, or at end A", OF(T0), .unit = HAWSER__NEWTON},
	{"inserted", NULL, "whether it is between two of the values asked for", FLAG(inserted)},
	{"unsure", NULL, "whether branches were continued with shapes that had changed much", FLAG(unsure)},
	{"touched", NULL, "of a span over obstacles: number of those touched", OF(touched),
	 .when = OBSTACLES},
	{"eigenvalues", NULL, "of the branches", HAWSER__OBJECTS_OF(branch_list)},
	HAWSER__END,
};
#undef FLAG
#undef OF

HAWSER__OF(crosses, const char *, struct hawser_ropeway_track_crossover,
	of->veers ? "veering" : "crossing")

#define OF(member) HAWSER__AT(struct hawser_ropeway_track_crossover, member)
static const struct hawser__field crossover_field[] = {
	{"kind", NULL, "crossing or veering", HAWSER__TEXT_BY(crosses)},
	{"value", NULL, "of what is swept", OF(value)},
	{"omega", NULL, "mean of the two circular frequencies", OF(omega), .unit = HAWSER__RADIAN_S},
	{"relative_gap", NULL, "their distance over it", OF(gap)},
	{"branches", NULL, "those two; null: one that is not followed",
	 HAWSER__INTEGER_PAIR_AT(struct hawser_ropeway_track_crossover, below, above),
	 .flags = HAWSER__NULL | HAWSER__FROM_1},
	HAWSER__END,
};
#undef OF

struct meeting {
	struct hawser_campbell_resonance at;
	const char *plane;
};
#define OF(member) HAWSER__AT(struct meeting, member)
static const struct hawser__field resonance_field[] = {
	{"harmonic", NULL, "multiple of the passing frequency", OF(at.harmonic)},
	{"plane", NULL, "in-plane or out-of-plane", OF(plane)},
	{"branch", NULL, "which it meets", OF(at.branch), .flags = HAWSER__FROM_1},
	{"speed", NULL, "there", OF(at.speed), .unit = HAWSER__METRE_S},
	{"omega", NULL, "circular frequency there", OF(at.omega), .unit = HAWSER__RADIAN_S},
	HAWSER__END,
};
#undef OF

static const void *meeting_row(void *row, const void *parent, size_t i)
{
	const struct cli_track *t = parent;

	*(struct meeting *)row = (struct meeting){
		t->resonance[i], hawser_plane_name(t->track.plane[t->resonance[i].branch])};
	return row;
}
static const struct hawser__list resonance_list = HAWSER__MADE_ROWS(
	struct meeting, resonance_field, struct cli_track, resonances, meeting_row);

#define OF(member) HAWSER__AT(struct cli_track, member)
static const struct hawser__field ended_field[] = {
	{"value", NULL, "where", OF(track.end)},
	{"why", NULL, "the reason", OF(track.why.message)},
	HAWSER__END,
};
#define SAMPLES HAWSER__STORED(struct cli_track, track.sample, track.samples, sample_field)
const struct hawser__field cli_track_member[] = {
	{"swept", NULL, "what is swept", OF(sweep.key)},
	{"unit", NULL, "its unit", OF(sweep.si)},
	{"solves", NULL, "number of modal solutions", OF(track.solves)},
	{"least_correlation", NULL, "of a branch's shapes at neighbouring values, squared",
	 OF(track.least_correlation)},
	{"speeds", NULL, "of campbell", SAMPLES, .when = SPEEDS},
	{"stations", NULL, "of other sweeps, the same", SAMPLES, .when = STATIONS, .flags = HAWSER__BRIEF},
	{"crossovers", NULL, "where branches change their order",
	 HAWSER__STORED(struct cli_track, track.crossover, track.crossovers, crossover_field)},
	{"spacing", NULL, "of campbell: distance of the carriers", OF(distance), .unit = HAWSER__METRE,
	 .when = SPACED},
	{"resonances", NULL, "where multiples of their passing frequency meet branches",
	 HAWSER__OBJECTS_OF(resonance_list), .when = SPACED},
	{"ended", NULL, "if the sweep ended before its end", HAWSER__OBJECT_OF(ended_field), .when = ENDED},
	HAWSER__END,
};
#undef OF

unsigned cli_track_view(const struct cli_track *t)
{
	int speeds = t->swept == CLI_SWEPT_SPEED;

	return (speeds ? SPEEDS : STATIONS) | (t->obstacles ? OBSTACLES : LANES) |
	       (speeds && t->distance > 0.0 ? SPACED : 0u) | (t->track.ended ? ENDED : 0u);
}
