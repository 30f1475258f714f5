/* cli/backbone/backbone.h - backbones beside a frequency response (hawser frf --backbone).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_BACKBONE_H
#define HAWSER_CLI_BACKBONE_H

#include "cli/frame/view.h"

/* cli_model_load, and a model whose K is not diagonal in the coordinates of its modes; a warning says
 * so. */
enum hawser_status cli_model_load_modal(struct cli_model *model, const struct cli_common *common,
                                        int n, struct hawser_report *report) HAWSER_MUST_CHECK;

struct cli_backbone {
	int mode;                             /* index */
	struct hawser_backbone run;
	struct hawser_primary_curve parabola; /* multiple scales; no points where these fail */
	double gamma;
	double *omega;                        /* [run.points], then [parabola points] */
};
/* The free motions of a mode (index) up to 1.2 times its largest amplitude in the response, at the
 * frequencies of its range; result->backbone becomes `backbone`. */
enum hawser_status cli_backbone_trace(struct cli_backbone *backbone, struct cli_frf_result *result,
                                      int mode, struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_backbone_clear(struct cli_backbone *backbone);
/* overlay [2]; how many there are. */
int cli_backbone_overlays(struct cli_overlay *overlay, const struct cli_backbone *backbone);

/* Of a backbone, and of its points. */
extern const struct hawser__field cli_backbone_field[], cli_backbone_free_field[];
extern const struct hawser__list cli_backbone_free_list;
void cli_backbone_comments(struct hawser__table *table, const struct cli_frf_result *result);
const char *cli_backbone_end(enum hawser_backbone_end end); /* for people */
/* Energy over frequency; `result` is a cli_frf_result. */
enum hawser_status cli_backbone_draw(const char *path, const void *result,
                                     struct hawser_report *report);

#endif
