/* cli/model/rom_ropeway.h - the model of a scene of kind `ropeway`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_ROM_ROPEWAY_H
#define HAWSER_CLI_ROM_ROPEWAY_H

#include <hawser/line_rom.h>

#include "cli/modes/modes_ropeway.h"

/* One lane of a ropeway as a model. */
struct cli_rom_ropeway {
	struct hawser_ropeway ropeway;
	struct hawser_ropeway_statics st;
	int lane, smeared;
	struct hawser_line line;               /* at rest */
	struct hawser_line_mass *mass;
	struct hawser_line_statics line_st;
	struct hawser_line_rom_options options;
	struct hawser_line_freedom freedom;    /* the carriage */
	struct hawser_line_modes modes;
	int kept[HAWSER_LINE_ROM_MODES];       /* --keep: what options.kept points to */
	int chosen;                            /* candidates of a choice of modes; 0: none was made */
};

/* model->ropeway and model->rom by common->lane; n: number of modes, 0 for the default. */
enum hawser_status cli_rom_ropeway_load(struct cli_model *model, const struct cli_common *common, int n,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same with n modes, or those of them that kept[count] are the indices of. Release them with
 * hawser_rom_clear and hawser_line_modes_clear. */
enum hawser_status cli_rom_ropeway_again(struct hawser_rom *rom, struct hawser_line_modes *modes,
                                         const struct cli_rom_ropeway *of, int n, const int *kept,
                                         int count, struct hawser_report *report) HAWSER_MUST_CHECK;
/* ropeway_choice.c: the error by the modes that the model of the response leaves out, and a response of
 * a model of those modes that matter, in place of both where there is one. */
enum hawser_status cli_ropeway_error(struct hawser_accuracy_fixed *fixed, const struct cli_model *model,
                                     const struct hawser_frf *frf, double from, double to,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_ropeway_response(struct hawser_frf *frf, struct cli_model *model,
                                        struct cli_frf_result *result,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* What the model is, as comments; nothing of models of other scenes. */
void cli_rom_ropeway_comments(struct hawser__table *table, const struct cli_model *model);
void cli_rom_ropeway_free(struct cli_rom_ropeway *of);

#endif
