/* cli/statics/rod_result.h - what hawser statics shows of a scene of kind `rod`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_ROD_RESULT_H
#define HAWSER_CLI_ROD_RESULT_H

#include <hawser/rod.h>

#include "cli/statics/statics_kinds.h"

struct cli_rod {
	const struct cli_common *common;
	struct hawser_rod scene;
	struct hawser_rod_statics st;
	int stable;     /* 1, 0; HAWSER__NO_INTEGER: not judged */
	double error_x, error_N, error_M; /* NAN: not known */
	char warning[CLI_WARNING_SIZE]; /* "": none */
};

/* rod_fields.c; CLI_ROD_WATER: what a rod in water has besides */
enum { CLI_ROD_WATER = 1 };
extern const struct hawser__field cli_rod_number_field[], cli_rod_field[];
extern const struct hawser__list cli_rod_point_list;

#endif
