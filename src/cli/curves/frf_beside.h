/* cli/curves/frf_beside.h - a second response in the picture of a frequency response (hawser frf
 * --beside). SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_BESIDE_H
#define HAWSER_CLI_FRF_BESIDE_H

#include <jansson.h>

#include "cli/frame/cli.h"

/* All zero before use. */
struct cli_beside {
	char label[48];        /* from the name of the file */
	json_t *root;
	int points;            /* with one that is no number after each branch */
	double *omega;         /* [points] scaled */
	double *probe[2];      /* stable, unstable: [points][3*probes] scaled; NAN: not known, or not
	                        * here */
	double *coordinate[2]; /* the same: [points][n] */
};
/* Read the result `path`, before anything is computed. HAWSER_ERR_ARGUMENT: it is no response, or has
 * other units; HAWSER_ERR_IO, HAWSER_ERR_MEMORY. */
enum hawser_status cli_beside_open(struct cli_beside *beside, const char *path,
                                   const struct cli_model *model,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* Set overlay [2] to its stable and its unstable parts, with the probes and coordinates of `result`;
 * *count of them: 0 if it has none of these, about which a warning is written. HAWSER_ERR_MEMORY. */
enum hawser_status cli_beside_overlays(struct cli_overlay *overlay, int *count,
                                       struct cli_beside *beside,
                                       const struct cli_frf_result *result,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_beside_clear(struct cli_beside *beside);

#endif
