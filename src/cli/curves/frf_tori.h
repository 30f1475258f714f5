/* cli/curves/frf_tori.h - hawser frf --tori: the quasi-periodic motions that begin at the torus
 * points of a frequency response. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_TORI_H
#define HAWSER_CLI_FRF_TORI_H

#include <hawser/torus.h>

#include "cli/frame/cli.h"
#include "cli/frame/progress.h"
#include "output/fields/fields.h"

/* Options of a view, as in frf_fields.c: the model has tensions; over a parameter, or the frequency. */
enum { CLI_TORI_TENSION = 1, CLI_TORI_OVER = 256, CLI_TORI_PLAIN = 4096 };

/* --tori with these options. HAWSER_ERR_ARGUMENT. */
enum hawser_status cli_tori_check(const char *method,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* Sets `tori` and `curves` of the result: a curve from each torus point of all its branches that is not
 * the end of another curve. Those that are not found have no points and say why. *tori owns them, and
 * is released with cli_tori_clear, whatever the status: those of hawser_tori_trace. */
enum hawser_status cli_tori_trace(struct hawser_tori **tori, struct cli_frf_result *result,
                                  int end_at_slack, struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_tori_clear(struct hawser_tori *tori, int curves);
void cli_tori_comments(struct hawser__table *table, const struct cli_frf_result *result);

/* Fields of a struct hawser_tori; lists of its rows in the table, with their greatest and their least
 * amplitudes. */
extern const struct hawser__field cli_tori_field[];
extern const struct hawser__list cli_torus_most_list, cli_torus_least_list;

#endif
