/* cli/rom_ropeway.h - hawser rom of a scene of kind `ropeway`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_ROM_ROPEWAY_H
#define HAWSER_CLI_ROM_ROPEWAY_H

#include <hawser/line_rom.h>

#include "cli/modes_ropeway.h"

/* Options of the command line; NULL or 0: not given. */
struct cli_rom_ropeway_choice {
	const char *load, *lane;
	double ripple, damping; /* m, ratio */
	struct cli_ropeway_choice state;
};

/* One lane of a ropeway as a model. */
struct cli_rom_ropeway {
	struct hawser_ropeway ropeway;
	struct hawser_ropeway_statics st;
	int lane;
	struct hawser_line line;               /* at rest, its carriers smeared if they pass */
	struct hawser_line_mass *mass;
	struct hawser_line_statics line_st;
	struct hawser_line_rom_options options;
	struct hawser_line_freedom freedom;    /* the carriage */
	struct hawser_line_modes modes;
};

/* The model; n: number of modes, 0 for the default. *of refers to itself: it must not be moved. */
enum hawser_status cli_rom_ropeway_load(struct cli_rom_ropeway *of, struct cli_model *model,
                                        const struct cli_common *common,
                                        const struct cli_rom_ropeway_choice *choice, int n,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_rom_ropeway_comments(struct hawser__table *table, const struct cli_rom_ropeway *of);
void cli_rom_ropeway_clear(struct cli_rom_ropeway *of);

#endif
