/* cli/statics/statics_ropeway.c - hawser statics of a scene of kind `ropeway`: the state for one
 * phase of the carriers, the worst values over all phases, and the load cases.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "output/structures/structures.h"

static struct cli_head head(const void *of)
{
	const struct cli_ropeway *result = of;

	return cli_si_head(result->common, "statics", "catenaries and arcs, laid from the tension end",
	                   NULL, (result->swept ? CLI_ROPEWAY_SWEPT : 0u) |
	                   (result->kinds->profile ? CLI_ROPEWAY_PROFILE : 0u) |
	                   (result->kinds->cases ? CLI_ROPEWAY_CASES : 0u));
}

static void state_comments(struct hawser__table *table, const struct cli_ropeway *of)
{
	static const char *const sliding[] = {"running", "rest", "reverse"};
	const struct hawser_ropeway *rw = &of->ropeway;
	const struct hawser_ropeway_statics *st = &of->st;

	hawser__table_comment(table, "g = %.10g m/s^2", rw->g);
	hawser__table_comment(table,
	                      "%d towers, %d and %d carriers; case %s, phase = %.9g m; sliding: %s%s",
	                      rw->towers, st->lane[0].carriers,
	                      st->lanes > 1 ? st->lane[1].carriers : 0,
	                      rw->load_case[st->load_case].name, st->phase, sliding[rw->sliding],
	                      rw->sweep ? " (the phase of the largest tension)" : "");
	hawser__table_comment(table,
	                      "bottom station: T = %.9g N, %.9g N on the carriage, travel = %.6g m",
	                      st->T0, st->weight, st->travel);
	if (st->lanes > 1) {
		hawser__table_comment(table, "top station: T = %.9g N up, %.9g N down", st->lane[0].st.T_B,
		                      st->lane[1].st.T_B);
		hawser__table_comment(table, "drive: force = %.9g N, needs a friction of %.6g%s", st->force,
		                      st->needed_friction, st->slips ? ": it slips" : "");
	} else {
		hawser__table_comment(table, "top station: T = %.9g N up", st->lane[0].st.T_B);
	}
	hawser__table_comment(table, "loop: unstretched length = %.9g m", st->loop0);
}

static void worst_comments(struct hawser__table *table, const struct cli_ropeway *of)
{
	const struct hawser_ropeway_worst *worst = &of->worst;

	hawser__table_comment(table, "worst values of %d phases:", worst->phases);
	for (int i = 0; i < worst->lanes; i++) {
		const struct hawser_ropeway_lane_range *lane = &worst->lane[i];

		hawser__table_comment(
			table, "lane %s: T = %.9g N at phase %.6g m (%s) to %.9g N at phase %.6g m (%s)",
			i ? "down" : "up", lane->T.min, lane->T.at_min, of->lane[i].span[lane->span_min].name,
			lane->T.max, lane->T.at_max, of->lane[i].span[lane->span_max].name);
	}
	hawser__table_comment(table, "carriage: T = %.9g to %.9g N, travel = %.6g to %.6g m", worst->T0.min,
	                      worst->T0.max, worst->travel.min, worst->travel.max);
	if (worst->lanes > 1)
		hawser__table_comment(
			table,
			"drive: force = %.9g N at phase %.6g m to %.9g N at phase %.6g m, needs a "
			"friction of %.6g at phase %.6g m",
			worst->force.min, worst->force.at_min, worst->force.max, worst->force.at_max,
			worst->needed_friction.max, worst->needed_friction.at_max);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_ropeway *result = of;

	state_comments(table, result);
	if (result->swept)
		worst_comments(table, result);
	for (int i = 0; i < result->cases; i++)
		if (result->load_case[i].status)
			hawser__table_comment(table, "case %s: no solution: %s", result->load_case[i].name,
			                      result->load_case[i].why);
}

static const struct hawser__field case_name[] = {
	{NULL, "case", "", HAWSER__AT(struct cli_ropeway_case, name)},
	HAWSER__END,
};

static void case_rows(struct hawser__table *table, const struct cli_ropeway *of)
{
	const struct hawser__view view = cli_si_view(0);

	hawser__fields_columns(table, cli_ropeway_case_field, &view);
	for (int i = 0; i < of->cases; i++)
		hawser__fields_row(table, cli_ropeway_case_field,
		                   of->load_case[i].status ? case_name : cli_ropeway_case_field,
		                   &of->load_case[i], &view);
}

static void rows(struct hawser__table *table, const void *of)
{
	const struct cli_ropeway *result = of;
	const struct hawser__view view = cli_si_view(0);

	if (result->kinds->cases)
		case_rows(table, result);
	else
		hawser__fields_table(table, result->kinds->worst ? &cli_ropeway_worst_list
		                     : result->kinds->spans ? &cli_ropeway_span_list
		                     : result->kinds->profile ? &cli_ropeway_point_list
		                     : &cli_ropeway_tower_list, result, &view);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_ropeway *result = of;

	return hawser__plot_ropeway(path, &result->ropeway, &result->st,
	                            result->swept ? &result->worst : NULL, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .more = rows, .fields = cli_ropeway_field, .draw = draw};

static enum hawser_status choose(struct cli_ropeway *of, struct hawser_report *report)
{
	static const char *const sliding[] = {"running", "rest", "reverse"};
	const struct cli_statics_kinds *kinds = of->kinds;
	const char *list[64];
	int index = (int)of->ropeway.sliding, count = 0;
	enum hawser_status status = HAWSER_OK;

	if (kinds->sliding)
		status = cli_choose(&index, "statics", "sliding", kinds->sliding, sliding, 3, report);
	of->ropeway.sliding = (enum hawser_ropeway_sliding)index;
	for (; count < of->ropeway.cases && count < 64; count++)
		list[count] = of->ropeway.load_case[count].name;
	index = 0;
	if (!status && kinds->load_case)
		status = cli_choose(&index, "statics", "case", kinds->load_case, list, count, report);
	of->options.load_case = index;
	of->options.phases = kinds->phases;
	of->options.tolerate = kinds->tolerate;
	return status;
}

/* The phase that is shown: of a sweep that of the largest tension. */
static double phase_shown(const struct cli_ropeway *of)
{
	const struct hawser_ropeway_worst *worst = &of->worst;
	const struct hawser_ropeway_range *up = &worst->lane[0].T, *down = &worst->lane[1].T;

	if (!of->ropeway.sweep)
		return of->ropeway.phase;
	return worst->lanes > 1 && down->max > up->max ? down->at_max : up->at_max;
}

static void warn(const struct cli_ropeway *of)
{
	const struct hawser_ropeway_statics *st = &of->st;
	char text[CLI_WARNING_SIZE];

	for (int i = 0; i < of->towers; i++)
		if (!of->tower[i].c.touches) {
			snprintf(text, sizeof text,
			         "lane %s: the rope does not press the battery of tower %s: it passes "
			         "at a distance of %.4g m",
			         of->tower[i].lane, of->tower[i].name, of->tower[i].c.clearance);
			cli_warn(text);
		}
	if (st->slips) {
		snprintf(text, sizeof text,
		         "the drive slips: it needs a friction of %.4g, and drive.friction is %.4g",
		         st->needed_friction, of->ropeway.drive_friction);
		cli_warn(text);
	}
	if (st->stopped) {
		snprintf(text, sizeof text,
		         "the carriage is beyond its stops: at %.4g m, with tension.travel from "
		         "%.4g m to %.4g m",
		         st->travel, of->ropeway.travel[0], of->ropeway.travel[1]);
		cli_warn(text);
	}
	if (of->swept && of->worst.failed > 0) {
		snprintf(text, sizeof text, "%d of %d phases have no equilibrium, and are left out: %s",
		         of->worst.failed, of->worst.phases, of->worst.why.message);
		cli_warn(text);
	}
}

static enum hawser_status solve(struct cli_ropeway *of, struct hawser_report *report)
{
	enum hawser_status status = choose(of, report);
	int sweep = of->ropeway.sweep || of->kinds->worst;

	if (!status && sweep)
		status = hawser_ropeway_sweep(&of->worst, &of->ropeway, &of->options, report);
	of->swept = sweep && !status;
	if (!status)
		status = hawser_ropeway_solve(&of->st, &of->ropeway, &of->options, phase_shown(of), report);
	if (!status)
		status = cli_ropeway_fill(of, report);
	if (!status && of->kinds->profile)
		status = cli_ropeway_points(of, report);
	if (!status && of->kinds->cases)
		status = cli_ropeway_cases(of, report);
	return status;
}

enum hawser_status cli_statics_ropeway(const void *settings, struct hawser_report *report)
{
	const struct cli_statics_kinds *kinds = settings;
	struct cli_ropeway result = {.common = &kinds->common, .kinds = kinds};
	enum hawser_status status = cli_read_ropeway(&result.ropeway, &kinds->common, report);

	if (!status)
		status = solve(&result, report);
	if (!status) {
		warn(&result);
		status = cli_show(&kinds->common, &showing, &result, report);
	}
	cli_ropeway_clear(&result);
	return status;
}
