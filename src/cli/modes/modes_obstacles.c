/* cli/modes/modes_obstacles.c - hawser modes of a span over obstacles: a line of one lane
 * without carriers, with the columns and the picture of the modes of ropeways.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/modes/modes_result.h"
#include "core/report.h"

struct result {
	struct cli_ropeway_modes line; /* the first member: columns are of this */
	struct hawser_obstacles scene;
	struct hawser_obstacles_statics st;
	int loose;
};

static struct cli_head head(const void *of)
{
	const struct cli_ropeway_modes *line = of;
	struct cli_head head = cli_si_head(
		line->common, "modes", "spectral elements, piece by piece", line,
		CLI_MODES_REST | (line->points > 0 ? CLI_MODES_SHAPES : 0u));

	head.list = line->points > 0 ? &cli_modes_ropeway_points : &cli_modes_ropeway_list;
	return head;
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_line *line = &result->scene.line;

	hawser__table_comment(table, "g = %.10g m/s^2", line->g);
	hawser__table_comment(table, "T0 = %.9g N at end A, T1 = %.9g N at end B", result->st.st.T_A,
	                      result->st.st.T_B);
	for (int i = 0; i < line->sheaves; i++)
		if (result->st.st.contact[i].touches)
			hawser__table_comment(table, "%s: wrap = %.9g rad", line->sheave[i].name,
			                      result->st.st.contact[i].wrap);
		else
			hawser__table_comment(table, "%s: not touched, and left out", line->sheave[i].name);
	hawser__table_comment(table, "contact: %s%s", hawser_line_contact_name(result->line.modes.contact),
	                      !result->line.towers ? "; the rope touches no obstacle"
	                      : result->loose ? "; no groove: the rope moves along the axes of the circles"
	                      : "; grooves hold the rope in the plane");
	cli_ropeway_modes_comments(table, &result->line);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;
	const struct hawser_line *line = &result->scene.line;
	struct hawser__ropeway_modes_picture picture = {.what = "obstacles"};
	double (*place)[2] = calloc((size_t)line->sheaves + 1, sizeof *place);
	enum hawser_status status;

	if (!place)
		return hawser__no_memory(report, "modes");
	for (int i = 0; i < line->sheaves; i++) { /* the middle of each arc */
		const struct hawser_line_sheave *sheave = &line->sheave[i];
		const struct hawser_line_contact *contact = &result->st.st.contact[i];
		double angle = 0.5*(contact->angle_in + contact->angle_out);

		if (!contact->touches)
			continue;
		place[picture.towers][0] = sheave->centre[0] - sheave->side*sheave->radius*sin(angle);
		place[picture.towers++][1] = sheave->centre[1] + sheave->side*sheave->radius*cos(angle);
	}
	picture.tower = (const double (*)[2])place;
	memcpy(picture.end[0], line->A, sizeof picture.end[0]);
	memcpy(picture.end[1], line->B, sizeof picture.end[1]);
	status = cli_ropeway_modes_draw(path, &picture, &result->line, report);
	free(place);
	return status;
}

HAWSER__OF(contact_of, const char *, struct result,
	hawser_line_contact_name(of->line.modes.contact))

#define OF(member) HAWSER__AT(struct result, member)
const struct hawser__field cli_modes_obstacles_member[] = {
	{"contact", NULL, "slip, stick or roll", HAWSER__TEXT_BY(contact_of)},
	{"loose", NULL, "whether the rope may move along the axes of the circles, without a groove",
	 HAWSER__FLAG_AT(struct result, loose)},
	{"T0", NULL, "tension at end A", OF(st.st.T_A), .unit = HAWSER__NEWTON},
	{"T1", NULL, "tension at end B", OF(st.st.T_B), .unit = HAWSER__NEWTON},
	{"time_unit", NULL, "of the scaled equations", OF(line.modes.time_unit), .unit = HAWSER__SECOND},
	{"modes", NULL, "by frequency, both planes together", HAWSER__OBJECTS_OF(cli_modes_ropeway_list)},
	{"shapes", NULL, "with --shapes: points of the rope, and for each mode the shape at them",
	 HAWSER__OBJECT_OF(cli_modes_ropeway_shapes), .when = CLI_MODES_SHAPES},
	HAWSER__END,
};
#undef OF
static const struct cli_showing showing = {
	.head = head, .comments = comments, .fields = cli_modes_obstacles_member,
	.stats = cli_modes_ropeway_stats, .draw = draw};

/* Names of the free parts, "A to s0", and the energy in each. */
static enum hawser_status fill_spans(struct result *result, struct hawser_report *report)
{
	const struct hawser_line *line = &result->scene.line;
	struct cli_ropeway_modes *of = &result->line;
	size_t shares = (size_t)of->modes.spans*(size_t)of->modes.n;
	const char *before = "A";
	int sheave = 0;

	of->lanes = 1;
	of->spans = of->modes.spans;
	of->towers = of->spans - 1;
	of->span = calloc((size_t)of->spans, sizeof *of->span);
	of->share = calloc(shares, sizeof *of->share);
	if (!of->span || !of->share)
		return hawser__no_memory(report, "modes");
	memcpy(of->share, of->modes.share, shares*sizeof *of->share);
	for (int i = 0; i < of->spans; i++) {
		const char *behind = "B";

		while (sheave < line->sheaves && !result->st.st.contact[sheave].touches)
			sheave++;
		if (sheave < line->sheaves)
			behind = line->sheave[sheave++].name;
		snprintf(of->span[i].name, CLI_MODES_SPAN, "%s to %s", before, behind);
		of->span[i].label = of->span[i].name;
		of->span[i].lane = "";
		before = behind;
	}
	return HAWSER_OK;
}

static enum hawser_status solve(struct result *result, const char *contact, int n,
                                struct hawser_report *report)
{
	static const char *const name[] = {"slip", "stick"}; /* what turns freely rolls */
	const struct hawser_line_statics *st = &result->st.st;
	struct hawser_line_modes_options options = {.n = n};
	const struct cli_common *common = result->line.common;
	enum hawser_status status = cli_read_obstacles(&result->scene, common, report);

	if (!status && contact)
		status = cli_choose(&result->scene.modes, "modes", "contact", contact, name, 2, report);
	if (!status)
		status = hawser_obstacles_solve(&result->st, &result->scene, report);
	if (!status)
		status = hawser_obstacles_contact(&options.contact, &options.loose, &result->scene, st, report);
	if (!status)
		status = hawser_line_modes_solve(&result->line.modes, &st, 1, &options, report);
	result->loose = options.loose;
	if (!status)
		status = fill_spans(result, report);
	return status || result->line.points == 0 ? status : cli_ropeway_shapes(&result->line, report);
}

enum hawser_status cli_modes_obstacles(const struct cli_common *common, const char *contact, int n,
                                       int points, struct hawser_report *report)
{
	struct result result = {.line = {.common = common, .points = points}};
	enum hawser_status status = solve(&result, contact, n, report);

	if (!status)
		status = cli_show(common, &showing, &result, report);
	hawser_line_modes_clear(&result.line.modes);
	cli_ropeway_modes_free(&result.line);
	hawser_obstacles_statics_clear(&result.st);
	hawser_obstacles_clear(&result.scene);
	return status;
}
