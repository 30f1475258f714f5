/* cli/curves/locus_result.h - loci of bifurcations as a table, JSON and a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_LOCUS_RESULT_H
#define HAWSER_CLI_LOCUS_RESULT_H

#include "cli/frame/cli.h"

struct cli_locus_result {
	const struct cli_common *common;
	const struct cli_model *model;
	const struct hawser_locus *locus;
	const char *key, *unit; /* of the parameter */
	const char *first, *first_unit; /* NULL, or of the parameter that replaces Omega */
	double omega;           /* then the frequency, in rad/s or the model's unit */
	double from, to;        /* scaled Omega, or the first parameter */
	double parameter_from, parameter_to;
};
extern const struct cli_showing cli_locus_showing;
enum hawser_status cli_locus_draw(const char *path, const void *result, struct hawser_report *report);

#endif
