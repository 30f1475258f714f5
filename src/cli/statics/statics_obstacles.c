/* cli/statics/statics_obstacles.c - hawser statics of a span that passes over or under circles: the
 * state, the limits within which friction holds it, and the same rope without obstacles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "output/structures/structures.h"

static struct cli_head head(const void *of)
{
	const struct cli_obstacles *result = of;
	struct cli_head head = cli_si_head(
		result->common, "statics", "catenaries and arcs, laid from end A", NULL,
		cli_obstacles_view(result));

	head.list = result->spans_wanted ? &cli_obstacle_span_list : &cli_obstacle_point_list;
	return head;
}

static void obstacle_comments(struct hawser__table *table, const struct cli_obstacle *of,
                              double friction)
{
	if (!of->touches) {
		hawser__table_comment(table, "%s: not touched, the rope passes at %.6g m", of->name,
		                      of->c.clearance);
		return;
	}
	hawser__table_comment(table, "%s: T = %.9g N before, %.9g N behind; wrap = %.9g rad from "
	                      "(%.6f, %.6f) to (%.6f, %.6f) m", of->name, of->c.T_in, of->c.T_out,
	                      of->c.wrap, of->from[0], of->from[1], of->to[0], of->to[1]);
	hawser__table_comment(table, "%s: reaction = [%.9g, %.9g] N, least pressure = %.6g N/m", of->name,
	                      of->c.force[0], of->c.force[1], of->c.pressure_min);
	if (friction > 0.0)
		hawser__table_comment(table, "%s: margin = %.6g; friction holds T behind from %.9g to %.9g N "
		                      "at this T before", of->name, of->c.margin, of->c.T_out_min,
		                      of->c.T_out_max);
}

static void limit_comment(struct hawser__table *table, const char *what,
                          const struct hawser_obstacles_limit *limit)
{
	if (limit->status)
		hawser__table_comment(table, "%s: no equilibrium: %s", what, limit->report.message);
	else
		hawser__table_comment(table, "%s: T0 = %.9g N, T1 = %.9g N, H = %.9g N at A, %.9g N at B", what,
		                      limit->st.T_A, limit->st.T_B, limit->st.T_A*cos(limit->st.angle_A),
		                      limit->st.T_B*cos(limit->st.angle_B));
}

/* Stops of the path of sliding: history, and what the circles did on the way. */
static void path_comments(struct hawser__table *table, const struct cli_obstacles *of)
{
	const struct hawser_obstacles_path *path = &of->st.path;
	const struct hawser_line *line = &of->scene.line;
	const char *unit = line->given == HAWSER_LINE_LENGTH0 ? "m" : "N";
	int steps = of->scene.history ? (path->points - 1)/of->scene.stops : 1;

	for (int i = 0; i < path->points; i += steps)
		hawser__table_comment(table, "path: at %.9g %s T0 = %.9g N, T1 = %.9g N", path->value[i], unit,
		                      path->T[2*i], path->T[2*i + 1]);
	for (int k = 0; k < line->sheaves && of->scene.history; k++) {
		double grip = of->st.held[k].grip, slid = path->slid[(path->points - 1)*line->sheaves + k];

		hawser__table_comment(table, "%s: %s, friction that acts = %.6g of %.6g; %.6g m of rope passed "
		                      "it toward B in all", line->sheave[k].name,
		                      fabs(grip) < line->sheave[k].friction ? "the rope sticks"
		                      : "the rope slipped last", grip, line->sheave[k].friction, slid);
	}
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_obstacles *result = of;
	const struct hawser_line_statics *st = &result->st.st;
	static const char *const sliding[] = {"none", "toward-A", "toward-B", "history"};

	hawser__table_comment(table, "g = %.10g m/s^2; sliding: %s", result->scene.line.g,
	                      sliding[result->scene.line.sliding]);
	hawser__table_comment(table, "T0 = %.9g N at end A, T1 = %.9g N at end B", st->T_A, st->T_B);
	hawser__table_comment(table, "length0 = %.9g m, length = %.9g m", st->length0, st->length);
	for (int i = 0; i < result->spans; i++)
		hawser__table_comment(table, "%s: H = %.9g N, sag = %.6g m", result->span[i].name,
		                      result->span[i].H, result->span[i].sag);
	for (int i = 0; i < result->obstacles; i++)
		obstacle_comments(table, &result->obstacle[i], result->scene.line.sheave[i].friction);
	path_comments(table, result);
	if (result->st.friction) {
		limit_comment(table, "about to slide toward A", &result->st.slide[0]);
		limit_comment(table, "about to slide toward B", &result->st.slide[1]);
	}
	limit_comment(table, "without obstacles", &result->st.clear);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_obstacles *result = of;

	return hawser__plot_obstacles(path, &result->scene, &result->st, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .fields = cli_obstacles_field, .draw = draw};

enum hawser_status cli_statics_obstacles(const void *settings, struct hawser_report *report)
{
	const struct cli_statics_kinds *kinds = settings;
	struct cli_obstacles result = {.common = &kinds->common, .spans_wanted = kinds->spans};
	enum hawser_status status = cli_obstacles_fill(&result, kinds->points, report);

	if (!status) {
		cli_obstacles_warn(&result);
		status = cli_show(&kinds->common, &showing, &result, report);
	}
	cli_obstacles_clear(&result);
	return status;
}
