/* cli/judged.h - the model by which the response of a travelling cable is judged. See judged.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_JUDGED_H
#define HAWSER_CLI_JUDGED_H

#include "cli/cli.h"

struct cli_judged {
	int stated;       /* 1: the other members are set */
	int functions;    /* a component, of the full-order model that was chosen; 0: the modes asked for */
	int coordinates;
	double error, to; /* largest relative error of a natural frequency of the travelling cable up to
	                   * `to`, rad/s */
};

/* For a scene with a cable that travels: the error of the model at the frequencies up to `top`, rad/s,
 * with a warning where it is not small; with `free` first the smallest full-order model whose error is
 * small takes the place of the modes. model->scene then asks for it, and model->rom is it. */
enum hawser_status cli_judged_choose(struct cli_judged *judged, struct cli_model *model, int free,
                                     double top, struct hawser_report *report);
/* The error of a plane of parameters, whose model is made from the scene. */
enum hawser_status cli_judged_plane(struct cli_judged *judged, const struct cli_model *model,
                                    double top, struct hawser_report *report);
/* Whether the user has left the model to the program: n is the option --modes. */
int cli_judged_free(const struct cli_model *model, int n);
void cli_judged_comment(struct hawser__table *table, const struct cli_judged *judged);

#endif
