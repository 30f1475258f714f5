/* cli/curves/frf_over.h - hawser frf --over: the motion at one frequency, followed in a parameter.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_OVER_H
#define HAWSER_CLI_FRF_OVER_H

#include <hawser/scene_family.h>

#include "cli/model/axis.h"

struct cli_over {
	struct cli_map_axis axis; /* in SI */
	double from, to;          /* in the order of the curve */
	double omega;             /* rad/s, or the model's own unit; set before it is opened: the default */
	double guess;             /* of a cycle's frequency, in the same unit; 0: none */
	double at;                /* the value at which the modes are those of the scene; NAN: from */
	int file, open;           /* 1: the family is that of a file; 1: it is open */
	void (*close)(struct hawser_rom_family *);
	struct hawser_rom_family family;
};

/* text: KEY=FROM:TO; frequency: that of the load. All zero before use; release with cli_over_clear.
 * HAWSER_ERR_ARGUMENT. */
enum hawser_status cli_over_open(struct cli_over *over, const char *text, const char *frequency,
                                 struct cli_model *model, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* goes_on: the first motion is given. HAWSER_ERR_ARGUMENT: a frequency of rest. */
enum hawser_status cli_over_check(const struct cli_over *over, int goes_on,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_over_clear(struct cli_over *over);

/* Whether the key of --over KEY=FROM:TO is one of a scene, not a factor of the model. */
int cli_over_needs_scene(const char *text);
/* cli_model_load for --over, or NULL: models of a scene over one of its keys have no coordinates for
 * the inertia of condensed modes. */
enum hawser_status cli_over_load(struct cli_model *model, const struct cli_common *common, int n,
                                 const char *over, struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
