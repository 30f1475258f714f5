/* cli/map/hill_result.h - results of hawser hill as table, JSON and picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_HILL_RESULT_H
#define HAWSER_CLI_HILL_RESULT_H

#include "cli/model/axis.h"
#include "cli/frame/cli.h"
#include "cli/model/judged.h"

enum { CLI_HILL_ORDERS = 12 };

struct cli_hill_result {
	const struct cli_common *common;
	const struct cli_model *model; /* NULL for Mathieu's equation */
	double damping;                /* of that */
	/* boundaries */
	struct cli_map_axis axis[2];
	struct hawser_hill_chart chart;
	const struct hawser_hill_field *field; /* of the chart; the picture evaluates stability with it */
	double omega;                  /* rad/s, if it is not an axis */
	/* multipliers [m], in the model's scale */
	int m, orbit;
	struct cli_judged judged;
	const double *log_modulus, *argument;
	double error;
	int outside, undecided;        /* multipliers outside the unit circle; on it within the error */
};
enum hawser_status cli_hill_draw(const char *path, const void *result, struct hawser_report *report);
/* Boxes, as "xyxy". */
struct cli_hill_boxes {
	double *box; /* [count][4], the caller frees it */
	int count;
};
/* Those that cover the unstable part of the plane, and that without a response. */
enum hawser_status cli_hill_unstable(struct cli_hill_boxes boxes[2],
                                     const struct cli_hill_result *result,
                                     struct hawser_report *report);
extern const struct cli_showing cli_hill_boundaries, cli_hill_multipliers;

#endif
