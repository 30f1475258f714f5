/* cli/compare/compare_made.h - fidelities of nets and ropeways: models of several numbers of modes. Of
 * nets the reference is the mesh, in which the folds and peaks of the largest model are corrected.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_COMPARE_MADE_H
#define HAWSER_CLI_COMPARE_MADE_H

#include "cli/compare/compare_result.h"

/* What is compared where nothing else is asked for. */
#define CLI_COMPARE_MADE "condensed 4, condensed 6, condensed 9, condensed 12"

/* Refuse fidelities that are none of these scenes, and make the mesh the reference of a net that has
 * none. *most: the largest number of modes. */
enum hawser_status cli_compare_made_choose(struct cli_compare_result *result, int *most, int net,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
/* Whether i is the mesh. */
int cli_compare_is_mesh(const struct cli_compare_result *result, int i);
/* The curve of fidelity i; of the mesh also that of the largest model, from which it comes. */
enum hawser_status cli_compare_made(struct cli_compare_result *result, int i,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* The mesh has one peak of each resonance, the largest: those of other components do not count. */
void cli_compare_made_count(struct cli_compare_result *result, int i);

#endif
