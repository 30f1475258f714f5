/* cli/beam/beam_boundary.c - stability boundaries of hawser beam: comments and picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/model/axis.h"
#include "cli/beam/beam_result.h"
#include "output/drawing/figure.h"

static const char *const what[] = {"v_crit", "v_bif"};
/* The same for a picture, in gnuplot's markup. */
static const char *const shown[] = {"stable up to here, {/:Italic v}_{crit}",
                                    "first frequency vanishes, {/:Italic v}_{bif}"};

static void comments(struct hawser__table *table, const struct cli_beam_result *result,
                     const struct cli_beam_variant *v)
{
	for (int turn = 0; turn < 2; turn++) {
		const struct hawser_beam_boundary *boundary = &v->boundary[turn];

		if (boundary->points == 0)
			continue;
		hawser__table_comment(table, "%s over %s: %d points, pieces: %d", what[turn],
		                      result->boundary, boundary->points, boundary->pieces);
		for (int side = 0; side < 2; side++)
			if (*boundary->ended[side])
				hawser__table_comment(table, "%s: %s", side ? "right end" : "left end",
				                      boundary->ended[side]);
	}
}

void cli_beam_boundary_comments(struct hawser__table *table, const struct cli_beam_result *result)
{
	for (int i = 0; i < result->variants; i++)
		comments(table, result, &result->variant[i]);
}

enum hawser_status cli_beam_boundary_draw(const char *path, const struct cli_beam_result *result,
                                          struct hawser_report *report)
{
	struct hawser__axis x, axis[CLI_BEAM_AXES];
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 15.0, 11.0, report);
	double largest = 0.0;
	char label[120];

	if (status)
		return status;
	for (int i = 0; i < 2*result->variants; i++)
		for (int k = 0; k < result->variant[i/2].boundary[i % 2].points; k++)
			largest = fmax(largest, fabs(result->variant[i/2].boundary[i % 2].point[k].parameter));
	x = cli_axis(result->boundary, cli_key_unit(result->boundary), largest);
	cli_beam_sweep_axes(axis, result);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.95, 0.28, 0.97,
		.x = {&x, .tics = 8}, .y = {&axis[CLI_BEAM_SPEED], .zero = 1, .tics = 8, .room = 0.05}});
	for (int i = 0; i < 2*result->variants; i++) {
		const struct hawser_beam_boundary *boundary = &result->variant[i/2].boundary[i % 2];

		for (int k = 0; k < boundary->points; k++) {
			const struct hawser_beam_boundary_point *point = &boundary->point[k];

			if (k > 0 && point->piece != point[-1].piece)
				hawser__figure_gap(&figure);
			hawser__figure_put(&figure, point->parameter, point->speed*point->per_speed);
		}
		cli_beam_label(label, sizeof label, result, &result->variant[i/2], shown[i % 2]);
		hawser__figure_draw(&figure, label, "with lines lt %d lw 1.6 dt %s", i/2 + 1,
		                    i % 2 ? "(10,6)" : "solid");
	}
	return hawser__figure_finish(&figure, report);
}
