/* cli/plan/plan_ropeway.c - hawser plan of a ropeway: what is modelled, what is left out and
 * why, settings, cost.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/frame/kinds.h"
#include "cli/plan/plan_result.h"
#include "cli/frame/view.h"
#include "core/report.h"

static void print_line(FILE *stream, const struct hawser_ropeway *rw,
                       const struct hawser_ropeway_statics *st)
{
	int support[2] = {0, 0}, sheaves = 0, chosen = 0;

	for (int i = 0; i < rw->towers; i++) {
		support[st->lane[0].line->sheave[st->lane[0].first[i]].side > 0]++;
		sheaves += rw->tower[i].sheaves;
		chosen += rw->tower[i].battery == HAWSER_ROPEWAY_AUTO;
	}
	fprintf(stream, "\nmodelled\n"
	        "  rope: elastic catenaries between contacts, arcs with its weight on sheaves, no mesh\n"
	        "  lanes: %s\n"
	        "  towers: %d, with %d support and %d compression batteries",
	        rw->lanes > 1 ? "up and down" : "up only (down: off)", rw->towers, support[1], support[0]);
	if (chosen > 0)
		fprintf(stream, ", %d of them by battery: auto", chosen);
	fputs("\n", stream);
	if (sheaves > 0)
		fprintf(stream, "  trains of sheaves: %d fixed sheaves\n", sheaves);
	for (int i = 0; i < st->lanes; i++)
		fprintf(stream, "  carriers %s: %d of %.9g kg as point masses on the rope\n", i ? "down" : "up",
		        st->lane[i].carriers, rw->load_case[0].mass[i]);
	fprintf(stream, "  friction: capstan law with the rope's weight, %s\n",
	        rw->sliding == HAWSER_ROPEWAY_REST ? "none acts at rest; its limits are reported"
	        : rw->sliding == HAWSER_ROPEWAY_RUNNING ? "against the running rope"
	        : "against the reversed rope");
	if (rw->speed > 0.0 && rw->sliding != HAWSER_ROPEWAY_REST)
		fprintf(stream, "  speed: %.9g m/s, whose momentum adds rho v^2 = %.6g N to the tension\n",
		        rw->speed, rw->rho*rw->speed*rw->speed);
	fprintf(stream, "  bottom station: %s\n", rw->tension == HAWSER_ROPEWAY_COUNTERWEIGHT
	        ? "counterweight, half on each lane" : rw->tension == HAWSER_ROPEWAY_T0 ? "given tension"
	        : "fixed carriage, loop of given length");
}

static void print_left_out(FILE *stream, const struct hawser_ropeway *rw)
{
	int sheaves = 0;

	for (int i = 0; i < rw->towers; i++)
		sheaves += rw->tower[i].sheaves;
	fputs("\nleft out\n"
	      "  motion out of the vertical planes of the lanes: nothing in the scene acts there\n"
	      "  bending stiffness of the rope: its radius of curvature is that of the battery\n"
	      "  the place of the carriage: the rope leaves the bullwheel at bottom.at, at any travel\n",
	      stream);
	if (rw->hanger > 0.0)
		fputs("  carriers as pendulums: at rest they hang vertically\n", stream);
	if (sheaves > 0)
		fputs("  rockers, which share the load among the sheaves of a battery\n", stream);
	if (rw->ramp > 0.0)
		fputs("  drive.ramp: the start is no steady state\n", stream);
	if (rw->carriage > 0.0)
		fputs("  bottom.mass: the inertia of the carriage does not act in statics\n", stream);
	if (rw->lanes == 1)
		fputs("  drive: its force is the difference of both lanes\n", stream);
}

static void print_settings(FILE *stream, const struct hawser_ropeway *rw)
{
	struct hawser_ropeway_options options = {0};

	hawser_ropeway_settle(&options);
	fprintf(stream, "\nsettings\n"
	        "  g = %.10g m/s^2\n"
	        "  drive.wrap = %.6g rad\n", rw->g, rw->wrap);
	if (rw->drive)
		fprintf(stream, "  drive.friction = %.6g\n", rw->drive_friction);
	else
		fputs("  drive.friction is not given: slipping is not checked\n", stream);
	fprintf(stream, "  bottom.friction = %.6g\n", rw->bottom_friction);
	if (rw->stops)
		fprintf(stream, "  tension.travel = %.6g m to %.6g m\n", rw->travel[0], rw->travel[1]);
	else
		fputs("  tension.travel is not given: stops are not checked\n", stream);
	if (rw->spacing > 0.0)
		fprintf(stream, "  carriers.phase = %s%.9g m, carriers.phase_down = %.9g m\n",
		        rw->sweep ? "sweep, from " : "", rw->phase, rw->phase_down);
	fprintf(stream, "  load cases:");
	for (int i = 0; i < rw->cases; i++)
		fprintf(stream, "%s %s (%.6g kg up, %.6g kg down)", i ? "," : "", rw->load_case[i].name,
		        rw->load_case[i].mass[0], rw->load_case[i].mass[1]);
	fprintf(stream, "\n  --phases %d\n", options.phases);
}

struct result {
	const struct cli_common *common;
	struct hawser_ropeway rw;
	struct hawser_ropeway_statics st;
	double seconds; /* of st */
	char *text;     /* of the plan, in the user's units */
};

/* The text in the user's units; times of computation stay in s. */
static enum hawser_status write_text(struct result *result, struct hawser_report *report)
{
	struct hawser_ropeway_options options = {0};
	char *text = NULL, *shown = NULL;
	size_t size = 0, most;
	FILE *stream = open_memstream(&text, &size);

	if (stream) {
		print_line(stream, &result->rw, &result->st);
		print_left_out(stream, &result->rw);
		print_settings(stream, &result->rw);
	}
	if (stream && fclose(stream) == 0 && text)
		shown = hawser__units_text(text);
	hawser_ropeway_settle(&options);
	most = (shown ? strlen(shown) : 0) + 200;
	result->text = shown ? malloc(most) : NULL;
	if (result->text && result->common->reproducible)
		snprintf(result->text, most, "%s", shown);
	else if (result->text)
		snprintf(result->text, most, "%s\ncost\n"
		         "  a state: %.2g s, measured; --worst about %.2g s of processor time; --cases as much "
		         "for each case\n", shown, result->seconds, result->seconds*options.phases);
	free(shown);
	free(text);
	return result->text ? HAWSER_OK : hawser__no_memory(report, "plan");
}

/* A line "  rope: ..." below "modelled" is the comment "modelled: rope: ...". */
static void comments(struct hawser__table *table, const void *of)
{
	const char *heading = "";

	for (const char *line = ((const struct result *)of)->text; *line; line += strcspn(line, "\n") + 1)
		if (*line == ' ')
			hawser__table_remark(table, "%.*s: %.*s", (int)strcspn(heading, "\n"), heading,
			                     (int)strcspn(line, "\n") - 2, line + 2);
		else
			heading = line;
}

struct row {
	const char *lane;
	int towers, carriers;
};
const struct hawser__field cli_plan_ropeway_row[] = {
	{NULL, "lane", "up or down", HAWSER__AT(struct row, lane)},
	{NULL, "towers", "of the line", HAWSER__AT(struct row, towers)},
	{NULL, "carriers", "on this lane", HAWSER__AT(struct row, carriers)},
	HAWSER__END,
};

static const void *lane_row(void *row, const void *of, size_t i)
{
	const struct result *result = of;

	*(struct row *)row = (struct row){i ? "down" : "up", result->rw.towers,
	                                  result->st.lane[i].carriers};
	return row;
}
static const struct hawser__list lane_list = HAWSER__MADE_ROWS(
	struct row, cli_plan_ropeway_row, struct result, st.lanes, lane_row);

static struct cli_head head(const void *of)
{
	return cli_si_head(((const struct result *)of)->common, "plan", "statics of a ropeway", NULL, 0);
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &lane_list};

static enum hawser_status show(struct result *result, struct hawser_report *report)
{
	const struct cli_common *common = result->common;
	enum hawser_status status = write_text(result, report);

	if (!status && common->tsv)
		status = cli_show(common, &showing, result, report);
	else if (!status)
		printf("hawser %s plan: %s\nstatics of a ropeway\n%s", hawser_version(),
		       cli_input_name(common), result->text);
	free(result->text);
	return status;
}

enum hawser_status cli_plan_ropeway(const void *settings, struct hawser_report *report)
{
	const struct cli_common *common = settings;
	const struct hawser_ropeway_options options = {.tolerate = 1};
	struct result result = {.common = common};
	enum hawser_status status;

	if (common->json)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "plan", "the plan of a ropeway is a text: "
		                    "leave --json out (--tsv has it as comments)");
	status = cli_outputs_check(common, report);
	if (!status)
		status = cli_read_ropeway(&result.rw, common, report);
	if (status)
		return status;
	result.seconds = -cli_processor_seconds();
	status = hawser_ropeway_solve(&result.st, &result.rw, &options, result.rw.phase, report);
	result.seconds += cli_processor_seconds();
	if (!status) {
		status = show(&result, report);
		hawser_ropeway_statics_clear(&result.st);
	}
	hawser_ropeway_clear(&result.rw);
	return status;
}
