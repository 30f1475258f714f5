/* cli/model/axis.h - axes over a parameter: options that name a range of one, units and titles.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_AXIS_H
#define HAWSER_CLI_AXIS_H

#include "cli/frame/cli.h"

/* An axis of a plane of parameters: KEY=FROM:TO in SI (Omega: rad/s or the model's own unit), from
 * < to. `key` is in `copy`, which the caller frees. */
struct cli_map_axis {
	char *copy;
	const char *key, *unit;
	double from, to;
	int backwards; /* 1: the larger end was written first */
};
enum hawser_status cli_map_axis(struct cli_map_axis *axis, const char *option, const char *text,
                                struct cli_model *model, struct hawser_report *report);
/* In rad/s, or the model's own unit. */
enum hawser_status cli_map_frequency(double *omega, const char *text, const char *option,
                                     struct cli_model *model, struct hawser_report *report);

/* An axis that shows a key of the scene, Omega or a factor up to `largest`, in units of `unit`. */
struct hawser__axis cli_axis(const char *key, const char *unit, double largest);
/* "ρ = 10", in gnuplot's markup: value and unit of a key of the scene. */
void cli_axis_value(char *text, size_t size, const char *key, double value);
/* Unit of a key of the scene; "1" for a pure number and for other names. "load.per_length[2]" is an
 * element of a key. */
const char *cli_key_unit(const char *key);
/* Words and symbol ("": none) of the key, in gnuplot's markup. Returns 0, with the key itself, if
 * the table has no row for it. */
int cli_axis_quantity(const char **quantity, const char **symbol, const char *key);
/* The key as the title of an axis, in gnuplot's markup. */
void cli_key_title(char *text, size_t size, const char *key);

#endif
