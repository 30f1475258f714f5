/* cli/condensed.h - what the condensation of fast coordinates leaves out of multipliers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_CONDENSED_H
#define HAWSER_CLI_CONDENSED_H

#include <hawser/map.h>

#include "output/output.h"

/* A comment with the error of the condensation, and the object `condensed`; neither where no coordinate
 * was left out. */
void cli_condensed_comment(struct hawser__table *table, const struct hawser_map_condensed *condensed);
void cli_condensed_json(struct hawser__json *json, const struct hawser_map_condensed *condensed);

#endif
