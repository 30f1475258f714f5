/* cli/beam/beam_boundary.c - stability boundaries of hawser beam: comments and picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/beam/beam_result.h"
#include "core/report.h"

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

/* Room for both boundaries of every variant; piece ends are gaps (NAN). */
static int fill(double *x, double *y, const struct hawser_beam_boundary *boundary)
{
	int count = 0;

	for (int i = 0; i < boundary->points; i++) {
		const struct hawser_beam_boundary_point *point = &boundary->point[i];

		if (i > 0 && point->piece != point[-1].piece) {
			x[count] = point->parameter;
			y[count++] = NAN;
		}
		x[count] = point->parameter;
		y[count++] = point->speed*point->per_speed;
	}
	return count;
}

enum hawser_status cli_beam_boundary_draw(const char *path, const struct cli_beam_result *result,
                                          struct hawser_report *report)
{
	struct hawser__beam_line line[2*CLI_BEAM_VARIANTS];
	struct hawser__beam_lines picture = {.line = line};
	struct hawser__beam_picture sweep;
	enum hawser_status status = HAWSER_OK;
	double largest = 0.0;

	for (int i = 0; !status && i < result->variants; i++)
		for (int turn = 0; !status && turn < 2; turn++) {
			const struct hawser_beam_boundary *boundary = &result->variant[i].boundary[turn];
			size_t room = 2*(size_t)boundary->points;
			double *x = malloc((2*room + 1)*sizeof *x);
			struct hawser__beam_line *to = &line[picture.lines];

			if (!x) {
				status = hawser__no_memory(report, "beam");
				break;
			}
			*to = (struct hawser__beam_line){.x = x, .y = x + room, .colour = i + 1, .dashed = turn};
			to->points = fill(x, x + room, boundary);
			for (int k = 0; k < boundary->points; k++)
				largest = fmax(largest, fabs(boundary->point[k].parameter));
			cli_beam_label(to->label, sizeof to->label, result, &result->variant[i], shown[turn]);
			picture.lines += to->points > 0;
			if (to->points == 0)
				free(x);
		}
	picture.x = cli_axis(result->boundary, cli_key_unit(result->boundary), largest);
	cli_beam_sweep_axes(&sweep, result);
	picture.speed = sweep.speed;
	if (!status)
		status = hawser__plot_beam_lines(path, &picture, report);
	for (int i = 0; i < picture.lines; i++)
		free((double *)line[i].x);
	return status;
}
