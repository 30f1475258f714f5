/* cli/motion/cmd_transient.c - hawser transient: a ropeway that starts, brakes or runs, and a
 * carrier that passes a battery. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/transient_ropeway.h"
#include "core/report.h"
#include "output/structures/structures.h"

struct settings {
	struct cli_common common;
	const char *event, *pass, *lane, *load_case, *until, *every, *step;
	double damping;
	int elements, tolerate, spans, towers;
};

static const struct cli_option options[] = {
	CLI_TEXT_WITH(event, "NAME", "start, stop (drive.brake) or run (start)",
	              .excludes = "pass", .words = "start|stop|run"),
	CLI_TEXT_OPTION(pass, "TOWER", "instead: a carrier passes the battery of this tower"),
	CLI_TEXT_WITH(until, "TIME", "end (20 s after the ramp or the stop; run: two spacings)",
	              .excludes = "pass"),
	CLI_TEXT_WITH(every, "TIME", "interval of the rows (a 500th of --until)",
	              .excludes = "pass"),
	{"case", 0, "NAME", "load case (full)", CLI_TEXT(load_case)},
	CLI_HEADING("Of a passing carrier"),
	CLI_TEXT_WITH(lane, "NAME", "of --pass: up or down (up)",
	              .needs = "pass", .words = "up|down"),
	CLI_HEADING("Mesh, steps and damping"),
	{"elements", 0, "N", "elements of each span, an odd number (7)", CLI_COUNT(elements),
	 .excludes = "pass"},
	CLI_TEXT_WITH(step, "TIME", "step (half of a wave's time through a mean element)",
	              .excludes = "pass"),
	{"damping", 0, "RATIO", "of waves along the rope around the loop (0)", CLI_POSITIVE(damping),
	 .excludes = "pass"},
	CLI_HEADING("Contents of results"),
	{"spans", 0, "", "table of extremes in each span", CLI_FLAG(spans), .excludes = "pass, towers"},
	{"towers", 0, "", "table of extremes at each tower", CLI_FLAG(towers), .excludes = "pass"},
	{"tolerate", 0, "", "warn of slip, lifted batteries and stops, and go on", CLI_FLAG(tolerate),
	 .excludes = "pass"},
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"The rope of a ropeway along its lanes: elastic, with the masses of carriers, the sag of "
	"each span,",
	"friction on batteries and drive, and a counterweight with mass, on top of exact statics.",
	NULL,
};

static const char *const lane_name[] = {"up", "down"};
static const char *const event_name[] = {"start", "stop", "run"};

/* --- the result --- */

static struct cli_head head(const void *of)
{
	const struct cli_transient *result = of;
	struct cli_head head = cli_si_head(
		result->common, "transient", result->passes
		? "catenaries and arcs, phase by phase"
		: "chain of masses and springs on the statics of each phase, midpoint rule",
		NULL, (unsigned)result->table);

	head.list = result->passes ? &cli_passing_list
		: result->table == CLI_TRANSIENT_SPANS ? &cli_transient_span_list
		: result->table == CLI_TRANSIENT_TOWERS ? &cli_transient_tower_list
		: &cli_transient_row_list;
	return head;
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_transient *result = of;
	const struct hawser_transient *run = &result->run;
	const struct hawser_transient_energy *e = &run->energy;
	const struct hawser_ropeway *rw = &result->ropeway;

	hawser__table_comment(table, "g = %.10g m/s^2", rw->g);
	if (result->passes) {
		hawser__table_comment(table, "a carrier of lane %s passes tower %s at %.6g m/s", result->lane,
		                      rw->tower[result->passing.tower].name, rw->speed);
		return;
	}
	hawser__table_comment(table, "%s, case %s, phase = %.9g m; %.6g kg move with the rope",
	                      result->event, rw->load_case[run->options.load_case].name, rw->phase,
	                      run->mass);
	hawser__table_comment(table, "drive: force = %.7g N at %.6g s to %.7g N at %.6g s, needs a "
	                             "friction "
	                      "of %.5g at %.6g s", run->force.min, run->force.at_min, run->force.max,
	                      run->force.at_max, run->needed_friction.max, run->needed_friction.at_max);
	if (rw->drive)
		hawser__table_comment(table, "slip arc = up to %.5g of %.5g rad; %.4g m slipped; creep = "
		                             "%.2g of "
		                      "the speed", run->slip_arc.max, rw->wrap, run->slipped, run->creep);
	hawser__table_comment(table, "T = %.7g N at %.6g s to %.7g N at %.6g s", run->T.min, run->T.at_min,
	                      run->T.max, run->T.at_max);
	hawser__table_comment(table, "carriage: travel = %.5g m at %.6g s to %.5g m at %.6g s",
	                      run->travel.min, run->travel.at_min, run->travel.max, run->travel.at_max);
	if (isfinite(run->stopped_at))
		hawser__table_comment(table, "the rope at the drive is at rest from %.6g s on",
		                      run->stopped_at);
	hawser__table_comment(table, "energy: kinetic %+.6g, stored %+.6g; work of the drive %.6g, "
	                             "of weights "
	                      "and statics %.6g, dissipated %.6g J; closure %.1e", e->kinetic, e->stored,
	                      e->work, e->slow, e->dissipated, e->closure);
	hawser__table_comment(table, "%d elements a span, step = %.4g s; half as many and twice as long "
	                      "change the force by up to %.3g N, tensions %.3g N, travel %.2g m",
	                      run->options.elements, run->options.step, run->error_force, run->error_T,
	                      run->error_travel);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_transient *result = of;

	if (result->passes)
		return hawser__plot_carrier_passing(path, &result->passing, report);
	return hawser__plot_transient(path, &result->ropeway, &result->run, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .fields = cli_transient_field, .draw = draw};

/* --- the command --- */

static enum hawser_status name_places(struct cli_transient *of, struct hawser_report *report)
{
	const struct hawser_ropeway *rw = &of->ropeway;

	of->span = calloc((size_t)of->run.spans + 1, sizeof *of->span);
	of->tower = calloc((size_t)of->run.towers + 1, sizeof *of->tower);
	if (!of->span || !of->tower)
		return hawser__no_memory(report, "transient");
	of->spans = of->run.spans;
	of->towers = of->run.towers;
	for (int i = 0; i < of->spans; i++) {
		struct cli_transient_place *span = &of->span[i];
		int k = of->run.span[i].index;

		span->of = of->run.span[i];
		span->lane = lane_name[span->of.lane];
		snprintf(span->text, sizeof span->text, "%s to %s", k ? rw->tower[k - 1].name : "bottom",
		         k < rw->towers ? rw->tower[k].name : "top");
		span->name = span->text;
	}
	for (int i = 0; i < of->towers; i++)
		of->tower[i] = (struct cli_transient_place){.lane = lane_name[of->run.tower[i].lane],
			.name = rw->tower[of->run.tower[i].index].name, .of = of->run.tower[i]};
	return HAWSER_OK;
}

static enum hawser_status choose_case(int *index, const struct settings *s,
                                      const struct hawser_ropeway *rw, struct hawser_report *report)
{
	enum { MOST = 64 }; /* names that a message can list */
	const char *list[MOST];
	int count = 0;

	*index = 0;
	for (; count < rw->cases && count < MOST; count++)
		list[count] = rw->load_case[count].name;
	return s->load_case ? cli_choose(index, "transient", "case", s->load_case, list, count, report)
	                    : HAWSER_OK;
}

static enum hawser_status pass(struct cli_transient *of, const struct settings *s,
                               struct hawser_report *report)
{
	const struct hawser_ropeway *rw = &of->ropeway;
	enum { MOST = 256 }; /* names that a message can list */
	const char *list[MOST];
	int tower = 0, lane = 0, load_case, count = 0;
	enum hawser_status status = choose_case(&load_case, s, rw, report);

	for (; count < rw->towers && count < MOST; count++)
		list[count] = rw->tower[count].name;
	if (!status && count == 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "transient", "--pass %s: the ropeway has no "
		                      "towers", s->pass);
	if (!status)
		status = cli_choose(&tower, "transient", "pass", s->pass, list, count, report);
	if (!status && s->lane)
		status = cli_choose(&lane, "transient", "lane", s->lane, lane_name, 2, report);
	of->event = "pass";
	of->lane = lane_name[lane];
	return status ? status : hawser_passing_solve(&of->passing, rw, load_case, lane, tower, 0.0, 0,
	                                              report);
}

static enum hawser_status move(struct cli_transient *of, const struct settings *s,
                               struct hawser_report *report)
{
	struct hawser_transient_options o = {.tolerate = s->tolerate, .elements = s->elements,
	                                     .damping = s->damping};
	int event = 0;
	enum hawser_status status = choose_case(&o.load_case, s, &of->ropeway, report);

	if (!status && s->elements && s->elements%2 == 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "transient", "--elements is %d: give an odd "
		                      "number, so that a span has a middle element for its sag", s->elements);
	if (!status && s->event)
		status = cli_choose(&event, "transient", "event", s->event, event_name, 3, report);
	if (!status)
		status = cli_quantity(&o.until, s->until, "s", CLI_ABOVE_ZERO, "transient", "until", report);
	if (!status)
		status = cli_quantity(&o.every, s->every, "s", CLI_ABOVE_ZERO, "transient", "every", report);
	if (!status)
		status = cli_quantity(&o.step, s->step, "s", CLI_ABOVE_ZERO, "transient", "step", report);
	of->event = event_name[event];
	o.event = (enum hawser_transient_event)event;
	if (!status)
		status = hawser_transient_solve(&of->run, &of->ropeway, &o, report);
	return status ? status : name_places(of, report);
}

static void warn(const struct cli_transient *of)
{
	const struct hawser_transient *run = &of->run;
	char text[CLI_WARNING_SIZE];

	if (run->slips) {
		snprintf(text, sizeof text, "the rope slips on the whole drive bullwheel for %.4g s, by %.4g m",
		         (double)run->slips*run->options.step, run->slipped);
		cli_warn(text);
	}
	if (run->lifts) {
		snprintf(text, sizeof text, "the rope is not pressed on a battery for %.4g s, from t = %.4g s "
		         "on: its motion is then not modelled (see --towers)",
		         (double)run->lifts*run->options.step, run->lifts_at);
		cli_warn(text);
	}
	if (run->stops) {
		snprintf(text, sizeof text, "the carriage is beyond its stops for %.4g s: from %.4g m to "
		                            "%.4g m, "
		         "with tension.travel from %.4g m to %.4g m", (double)run->stops*run->options.step,
		         run->travel.min, run->travel.max, of->ropeway.travel[0], of->ropeway.travel[1]);
		cli_warn(text);
	}
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *s = context;
	struct cli_transient result = {.common = &s->common, .passes = s->pass != NULL,
		.table = s->pass ? CLI_TRANSIENT_PASSES : s->spans ? CLI_TRANSIENT_SPANS
		         : s->towers ? CLI_TRANSIENT_TOWERS : CLI_TRANSIENT_RUNS};
	enum hawser_status status = cli_outputs_check(&s->common, report);

	if (!status)
		status = cli_read_ropeway(&result.ropeway, &s->common, report);
	if (!status)
		status = s->pass ? pass(&result, s, report) : move(&result, s, report);
	if (!status) {
		warn(&result);
		status = cli_show(&s->common, &showing, &result, report);
	}
	free(result.span);
	free(result.tower);
	hawser_transient_clear(&result.run);
	hawser_passing_clear(&result.passing);
	hawser_ropeway_clear(&result.ropeway);
	return status;
}

const struct cli_command cli_transient = {
	"transient", "SCENE", "Start, stop and run of a ropeway over time", notes, options,
	NULL, sizeof(struct settings), 1, run, cli_transient_listing,
	.takes = CLI_ROPEWAY,
};
