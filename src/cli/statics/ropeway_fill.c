/* cli/statics/ropeway_fill.c - the rows that hawser statics shows of a ropeway.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "core/report.h"

enum { PER_LANE = 400 }; /* points of a profile besides the ends of pieces: a page has as many dots */

static const char *const lane_name[] = {"up", "down"};

static void name_span(char text[CLI_ROPEWAY_SPAN], const struct hawser_ropeway *rw, int i)
{
	snprintf(text, CLI_ROPEWAY_SPAN, "%s to %s", i ? rw->tower[i - 1].name : "bottom",
	         i < rw->towers ? rw->tower[i].name : "top");
}

static void fill_lane(struct cli_ropeway *of, int i)
{
	const struct hawser_ropeway *rw = &of->ropeway;
	const struct hawser_ropeway_lane *from = &of->st.lane[i];
	struct cli_ropeway_lane *lane = &of->lane[i];

	*lane = (struct cli_ropeway_lane){.lane = from, .range = of->swept ? &of->worst.lane[i] : NULL,
		.tower = of->tower + of->towers, .span = of->span + of->spans, .towers = rw->towers,
		.spans = rw->towers + 1};
	for (int k = 0; k < rw->towers; k++) {
		lane->tower[k] = (struct cli_ropeway_tower){
			lane_name[i], rw->tower[k].name,
			from->line->sheave[from->first[k]].side > 0 ? "support" : "compression", from->contact[k],
			lane->range ? &lane->range->tower[k] : NULL};
		if (lane->range)
			of->range[of->towers + k] = (struct cli_ropeway_worst){lane_name[i], rw->tower[k].name,
			                                                      lane->range->tower[k]};
	}
	for (int k = 0; k <= rw->towers; k++) {
		struct cli_ropeway_span *span = &lane->span[k];

		*span = (struct cli_ropeway_span){.lane = lane_name[i], .s = from->span[k],
		                                  .range = lane->range ? &lane->range->span[k] : NULL};
		name_span(span->name, rw, k);
		span->label = span->name;
	}
	of->towers += lane->towers;
	of->spans += lane->spans;
}

enum hawser_status cli_ropeway_fill(struct cli_ropeway *of, struct hawser_report *report)
{
	size_t most = HAWSER_ROPEWAY_LANES*((size_t)of->ropeway.towers + 1);

	of->tower = calloc(most, sizeof *of->tower);
	of->span = calloc(most, sizeof *of->span);
	of->range = calloc(most, sizeof *of->range);
	if (!of->tower || !of->span || !of->range)
		return hawser__no_memory(report, "statics");
	for (int i = 0; i < of->st.lanes; i++)
		fill_lane(of, i);
	return HAWSER_OK;
}

/* Points of a piece, without its end. */
static void piece_points(struct cli_ropeway *of, int lane, const struct hawser_line_piece *piece)
{
	const struct hawser_line_statics *st = &of->st.lane[lane].st;
	int count = 1 + (int)ceil(PER_LANE*(piece->S1 - piece->S0)/st->length0);

	for (int i = 0; i < count; i++) {
		struct cli_ropeway_point *to = &of->point[of->points++];
		double S = piece->S0 + (piece->S1 - piece->S0)*i/count, x[2];

		*to = (struct cli_ropeway_point){.lane = lane_name[lane], .S = S};
		hawser_line_at(st, x, &to->angle, &to->T, NULL, NULL, S);
		to->x = x[0];
		to->y = x[1];
	}
	of->point[of->points++] =
		(struct cli_ropeway_point){lane_name[lane], piece->S1,     piece->x1[0],
	                               piece->x1[1],    piece->angle1, piece->T1};
}

enum hawser_status cli_ropeway_points(struct cli_ropeway *of, struct hawser_report *report)
{
	size_t most = 0;

	for (int i = 0; i < of->st.lanes; i++)
		most += PER_LANE + 3*(size_t)of->st.lane[i].st.pieces;
	of->point = calloc(most + 1, sizeof *of->point);
	if (!of->point)
		return hawser__no_memory(report, "statics");
	for (int i = 0; i < of->st.lanes; i++)
		for (int k = 0; k < of->st.lane[i].st.pieces; k++)
			piece_points(of, i, &of->st.lane[i].st.piece[k]);
	return HAWSER_OK;
}

/* The worst values of a case over both lanes. */
static void fill_case(struct cli_ropeway_case *to, const struct hawser_ropeway_worst *worst,
                      const struct hawser_ropeway *rw)
{
	to->phases = worst->phases;
	to->lifts = worst->lifts;
	to->slips = worst->slips;
	to->stops = worst->stops;
	to->failed = worst->failed;
	to->travel = worst->travel;
	to->force = worst->force;
	to->needed_friction = worst->needed_friction;
	to->T = worst->lane[0].T;
	to->pressing = INFINITY;
	for (int i = 0; i < worst->lanes; i++) {
		const struct hawser_ropeway_lane_range *lane = &worst->lane[i];

		if (i == 0 || lane->T.max > to->T.max) {
			to->T.max = lane->T.max;
			to->T.at_max = lane->T.at_max;
			to->T_lane = lane_name[i];
			name_span(to->T_span, rw, lane->span_max);
		}
		if (lane->T.min < to->T.min) {
			to->T.min = lane->T.min;
			to->T.at_min = lane->T.at_min;
		}
		for (int k = 0; k < rw->towers; k++)
			if (lane->tower[k].pressing.min < to->pressing) {
				to->pressing = lane->tower[k].pressing.min;
				to->pressing_at = lane->tower[k].pressing.at_min;
				to->press_lane = lane_name[i];
				to->press_tower = rw->tower[k].name;
			}
		for (int k = 0; k <= rw->towers; k++)
			if (lane->span[k].sag.max > to->sag) {
				to->sag = lane->span[k].sag.max;
				to->sag_at = lane->span[k].sag.at_max;
				name_span(to->sag_span, rw, k);
			}
	}
	to->T_where = to->T_span;
	to->sag_where = to->sag_span;
	if (rw->towers == 0)
		to->pressing = to->pressing_at = NAN;
}

enum hawser_status cli_ropeway_cases(struct cli_ropeway *of, struct hawser_report *report)
{
	int failed = 0;

	of->load_case = calloc((size_t)of->ropeway.cases, sizeof *of->load_case);
	if (!of->load_case)
		return hawser__no_memory(report, "statics");
	for (; of->cases < of->ropeway.cases; of->cases++) {
		struct cli_ropeway_case *to = &of->load_case[of->cases];
		struct hawser_ropeway_options options = of->options;
		struct hawser_ropeway_worst worst;

		options.load_case = of->cases;
		to->name = of->ropeway.load_case[of->cases].name;
		to->status = (int)hawser_ropeway_sweep(&worst, &of->ropeway, &options, &to->report);
		if (to->status == HAWSER_ERR_MEMORY)
			return hawser__no_memory(report, "statics");
		if (!to->status)
			fill_case(to, &worst, &of->ropeway);
		to->why = to->report.message;
		failed += to->status != 0;
		hawser_ropeway_worst_clear(&worst);
	}
	if (failed < of->cases)
		return HAWSER_OK;
	if (report)
		*report = of->load_case[0].report;
	return (enum hawser_status)of->load_case[0].status;
}

void cli_ropeway_clear(struct cli_ropeway *of)
{
	hawser_ropeway_statics_clear(&of->st);
	hawser_ropeway_worst_clear(&of->worst);
	hawser_ropeway_clear(&of->ropeway);
	free(of->tower);
	free(of->span);
	free(of->point);
	free(of->range);
	free(of->load_case);
}
