/* cli/modes/modes_ropeway.c - hawser modes of a scene of kind `ropeway`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/modes/modes_result.h"
#include "core/report.h"

static const char *const lane_name[] = {"up", "down"};
static const char *const contact_name[] = {"slip", "stick", "roll"};
static const char *const sliding_name[] = {"running", "rest", "reverse"};

enum hawser_status cli_ropeway_open(struct hawser_ropeway *rw, int *load_case,
                                    const struct cli_common *common, const char *command,
                                    const struct cli_ropeway_choice *choice,
                                    struct hawser_report *report)
{
	const char *list[64];
	int index = 0, count = 0;
	enum hawser_status status = cli_read_ropeway(rw, common, report);

	*load_case = 0;
	if (!status && choice->contact) {
		status = cli_choose(&index, command, "contact", choice->contact, contact_name, 3, report);
		rw->hold = (enum hawser_ropeway_hold)(index + 1);
	}
	if (!status && choice->sliding) {
		status = cli_choose(&index, command, "sliding", choice->sliding, sliding_name, 3, report);
		rw->sliding = (enum hawser_ropeway_sliding)index;
	}
	for (; !status && count < rw->cases && count < 64; count++)
		list[count] = rw->load_case[count].name;
	if (!status && choice->load_case)
		status = cli_choose(load_case, command, "case", choice->load_case, list, count, report);
	return status;
}

/* Comments on a state whose modes are shown. */
static void ropeway_state(struct hawser__table *table, const struct hawser_ropeway_statics *st)
{
	const struct hawser_ropeway *rw = st->ropeway;

	hawser__table_comment(table, "g = %.10g m/s^2", rw->g);
	hawser__table_comment(table, "%d towers, %d and %d carriers; case %s, phase = %.9g m%s",
	                      rw->towers, st->lane[0].carriers,
	                      st->lanes > 1 ? st->lane[1].carriers : 0,
	                      rw->load_case[st->load_case].name, st->phase,
	                      rw->sweep ? " (of carriers.phase: sweep, the first one)" : "");
	hawser__table_comment(table, "speed = %.9g m/s, T = %.9g N at the bottom station",
	                      st->lane[0].line->speed, st->T0);
	hawser__table_comment(table, "contact: %s: %s",
	                      hawser_line_contact_name(hawser_ropeway_holds(st)),
	                      rw->hold != HAWSER_ROPEWAY_HOLD_AUTO ? "as given"
	                      : st->lane[0].line->speed > 0.0 ? "the rope runs" : "the rope is at rest");
}

static void bodies(struct hawser__table *table, const struct cli_ropeway_modes *of)
{
	int moves = of->modes.freedoms > 0 && strcmp(of->freedom[0].name, "carriage") == 0;

	for (int i = 0; i < of->modes.freedoms; i++) {
		const char *how = i == 0 && moves
			? "" : ": its moment of inertia over the radius squared, and the rope on it";

		hawser__table_comment(table, "the %s moves, with a mass of %.6g kg%s", of->freedom[i].name,
		                      of->freedom[i].mass, how);
	}
	if (!moves)
		hawser__table_comment(table, "the carriage does not move: %s",
		                      of->ropeway.tension > HAWSER_ROPEWAY_T0 ? "it is fixed"
		                      : "the scene gives no bottom.mass");
}

void cli_ropeway_modes_comments(struct hawser__table *table, const struct cli_ropeway_modes *of)
{
	const struct hawser_line_modes *modes = &of->modes;

	hawser__table_comment(table, "%d points, time unit %.12g s", modes->points, modes->time_unit);
	if (of->points == 0)
		return;
	hawser__table_comment(table, "shapes: P along the rope, Q normal to it, B out of plane; the "
	                      "integral of |P|^2 + |Q|^2 + |B|^2 over S/L, L = %.12g m%s is 1",
	                      modes->length_unit,
	                      modes->freedoms + modes->masses > 0 ? ", and of the bodies" : "");
	for (int k = 0; k < modes->n; k++)
		hawser__table_comment(table, "mode %d: omega = %.15g rad/s, %s", k + 1,
		                      modes->mode[k].omega/modes->time_unit,
		                      hawser_plane_name(modes->mode[k].plane));
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_ropeway_modes *result = of;

	ropeway_state(table, &result->st);
	bodies(table, result);
	cli_ropeway_modes_comments(table, result);
}

static struct cli_head head(const void *of)
{
	const struct cli_ropeway_modes *result = of;
	int runs = result->modes.gyroscopic;
	struct cli_head head = cli_si_head(
		result->common, "modes", "spectral elements, piece by piece", result,
		CLI_MODES_ROPEWAY | (runs ? CLI_MODES_RUNS : CLI_MODES_REST) |
		(result->lanes > 1 ? CLI_MODES_LOOP : 0u) | (result->points > 0 ? CLI_MODES_SHAPES : 0u));

	head.list = result->points > 0 ? &cli_modes_ropeway_points : &cli_modes_ropeway_list;
	return head;
}

enum hawser_status cli_ropeway_modes_draw(const char *path,
                                          struct hawser__ropeway_modes_picture *picture,
                                          const struct cli_ropeway_modes *of,
                                          struct hawser_report *report)
{
	const char **name = calloc((size_t)of->spans, sizeof *name);
	enum hawser_status status;

	if (!name)
		return hawser__no_memory(report, "modes");
	for (int i = 0; i < of->spans; i++)
		name[i] = of->span[i].name;
	picture->modes = &of->modes;
	picture->spans = of->spans;
	picture->name = name;
	picture->share = of->share;
	status = hawser__plot_ropeway_modes(path, picture, report);
	free(name);
	return status;
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_ropeway_modes *result = of;
	const struct hawser_ropeway *rw = &result->ropeway;
	struct hawser__ropeway_modes_picture picture = {.what = "towers", .posts = 1,
	                                                .towers = rw->towers};
	double (*tower)[2] = calloc((size_t)rw->towers + 1, sizeof *tower);
	enum hawser_status status;

	if (!tower)
		return hawser__no_memory(report, "modes");
	for (int i = 0; i < rw->towers; i++)
		memcpy(tower[i], rw->tower[i].at, sizeof tower[i]);
	picture.tower = (const double (*)[2])tower;
	memcpy(picture.end[0], rw->bottom, sizeof picture.end[0]);
	memcpy(picture.end[1], rw->top, sizeof picture.end[1]);
	for (int i = 0; i < result->lanes; i++)
		picture.carriers[i] = result->st.lane[i].carriers;
	status = cli_ropeway_modes_draw(path, &picture, result, report);
	free(tower);
	return status;
}

const struct hawser__field cli_modes_ropeway_stats[] = {
	{"unknowns", NULL, "values of a mode", HAWSER__AT(struct cli_ropeway_modes, modes.unknowns)},
	{"iterations", NULL, "of the eigenvalue solver",
	 HAWSER__AT(struct cli_ropeway_modes, modes.iterations)},
	HAWSER__END,
};
static const struct cli_showing showing = {
	.head = head, .comments = comments, .fields = cli_modes_ropeway_member,
	.stats = cli_modes_ropeway_stats, .draw = draw};

/* --- what is shown --- */

/* Names of the spans, and the energy in each: those within the train of a tower belong to none. */
static enum hawser_status fill_spans(struct cli_ropeway_modes *of, struct hawser_report *report)
{
	const struct hawser_ropeway *rw = &of->ropeway;
	const struct hawser_line_modes *modes = &of->modes;
	int *own = calloc((size_t)modes->spans + 1, sizeof *own);

	of->spans = of->lanes*(of->towers + 1);
	of->span = calloc((size_t)of->spans, sizeof *of->span);
	of->share = calloc((size_t)of->spans*(size_t)modes->n + 1, sizeof *of->share);
	if (!own || !of->span || !of->share) {
		free(own);
		return hawser__no_memory(report, "modes");
	}
	for (int i = 0; i < of->spans; i++) {
		int k = i % (of->towers + 1);

		of->span[i].lane = lane_name[i/(of->towers + 1)];
		snprintf(of->span[i].name, CLI_MODES_SPAN, "%s to %s", k ? rw->tower[k - 1].name : "bottom",
		         k < of->towers ? rw->tower[k].name : "top");
		of->span[i].label = of->span[i].name;
	}
	hawser_ropeway_modes_spans(own, modes, &of->st);
	for (int k = 0; k < modes->n; k++)
		for (int i = 0; i < modes->spans; i++)
			if (own[i] >= 0)
				of->share[k*of->spans + own[i]] += modes->share[k*modes->spans + i];
	free(own);
	return HAWSER_OK;
}

enum hawser_status cli_ropeway_shapes(struct cli_ropeway_modes *of, struct hawser_report *report)
{
	const struct hawser_line_modes *modes = &of->modes;
	size_t numbers = modes->gyroscopic ? 6 : 3, rows;

	of->rows = of->lanes*of->points;
	rows = (size_t)of->rows;
	of->S = calloc(rows, sizeof *of->S);
	of->x = calloc(rows, sizeof *of->x);
	of->y = calloc(rows, sizeof *of->y);
	of->lane = calloc(rows, sizeof *of->lane);
	of->shape = calloc(rows*numbers*(size_t)modes->n, sizeof *of->shape);
	if (!of->S || !of->x || !of->y || !of->lane || !of->shape)
		return hawser__no_memory(report, "modes");
	for (int i = 0; i < of->rows; i++) {
		int lane = i/of->points, k = i % of->points;
		const struct hawser_line_statics *line = modes->lane[lane];
		double x[2];

		of->lane[i] = lane_name[lane];
		of->S[i] = line->length0*k/(of->points - 1);
		hawser_line_at(line, x, NULL, NULL, NULL, NULL, of->S[i]);
		of->x[i] = x[0];
		of->y[i] = x[1];
		for (int j = 0; j < modes->n; j++)
			hawser_line_modes_at(of->shape + ((size_t)i*(size_t)modes->n + (size_t)j)*numbers, NULL,
			                     modes, j, lane, of->S[i]/modes->length_unit);
	}
	return HAWSER_OK;
}

static enum hawser_status solve(struct cli_ropeway_modes *of, const struct cli_ropeway_choice *choice,
                                int n, struct hawser_report *report)
{
	struct hawser_ropeway_options options = {.load_case = 0};
	const struct hawser_ropeway_modes_options modes = {.n = n};
	enum hawser_status status = cli_ropeway_open(&of->ropeway, &options.load_case, of->common, "modes",
	                                             choice, report);

	if (!status)
		status = hawser_ropeway_solve(&of->st, &of->ropeway, &options, of->ropeway.phase, report);
	if (!status)
		status = hawser_ropeway_modes_solve(&of->modes, &of->st, &modes, report);
	if (status)
		return status;
	of->lanes = of->st.lanes;
	of->towers = of->ropeway.towers;
	(void)hawser_ropeway_freedoms(of->freedom, &of->st);
	status = fill_spans(of, report);
	return status || of->points == 0 ? status : cli_ropeway_shapes(of, report);
}

void cli_ropeway_modes_free(struct cli_ropeway_modes *of)
{
	free(of->span);
	free(of->share);
	free(of->S);
	free(of->x);
	free(of->y);
	free(of->lane);
	free(of->shape);
}

enum hawser_status cli_modes_ropeway(const struct cli_common *common,
                                     const struct cli_ropeway_choice *choice, int n, int points,
                                     struct hawser_report *report)
{
	struct cli_ropeway_modes result = {.common = common, .points = points};
	enum hawser_status status = solve(&result, choice, n, report);

	if (!status)
		status = cli_show(common, &showing, &result, report);
	hawser_line_modes_clear(&result.modes);
	hawser_ropeway_statics_clear(&result.st);
	hawser_ropeway_clear(&result.ropeway);
	cli_ropeway_modes_free(&result);
	return status;
}
