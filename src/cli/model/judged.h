/* cli/model/judged.h - the model by which the response of a travelling cable is judged. See judged.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_JUDGED_H
#define HAWSER_CLI_JUDGED_H

#include <hawser/hill.h>
#include <hawser/map.h>

#include "cli/frame/cli.h"
#include "output/fields/fields.h"

struct cli_judged {
	int stated;       /* 1: the other members are set */
	int functions;    /* a component, of the full-order model that was chosen; 0: the modes asked for */
	int coordinates;
	int waves;        /* of a plane: complex modes whose span is the model; 0: the scene's model */
	struct hawser_map_shift edges; /* of the boundaries of a plane */
	const char *unit; /* of edges.distance */
	double error, to; /* largest relative error of a natural frequency of the travelling cable up to
	                   * `to`, rad/s */
};

/* For a scene with a cable that travels: the error of the model at the frequencies up to `top`, rad/s;
 * with `free` first the smallest full-order model whose error is
 * small takes the place of the modes. model->scene then asks for it, and model->rom is it. */
enum hawser_status cli_judged_choose(struct cli_judged *judged, struct cli_model *model, int free,
                                     double top, struct hawser_report *report);
/* Of a plane of parameters over an axis Omega, or at one: source->waves where the model is left to the
 * program, else the error of the scene's model at the frequencies of the travelling cable. */
enum hawser_status cli_judged_plane(struct cli_judged *judged, struct hawser_map_source *source,
                                    const struct cli_model *model, int free,
                                    struct hawser_report *report);
/* The error of its boundaries, from where they cross a few lines: those of a map, or of a chart. */
enum hawser_status cli_judged_map(struct cli_judged *judged, const struct hawser_map_source *source,
                                  const struct hawser_map *map, struct hawser_report *report);
enum hawser_status cli_judged_chart(struct cli_judged *judged, const struct hawser_map_source *source,
                                    const struct hawser_hill_chart *chart,
                                    struct hawser_report *report);
/* To be called after the result, so that a failure is told alone. */
void cli_judged_warn(const struct cli_judged *judged);
/* Whether the user has left the model to the program: n is the option --modes. */
int cli_judged_free(const struct cli_model *model, int n);
void cli_judged_comment(struct hawser__table *table, const struct cli_judged *judged);
extern const struct hawser__field cli_judged_field[];

#endif
