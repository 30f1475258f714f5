/* cli/modes/irvine_result.h - a sweep of the tension as table, JSON and picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_IRVINE_RESULT_H
#define HAWSER_CLI_IRVINE_RESULT_H

#include "cli/frame/cli.h"

enum cli_irvine_unit { CLI_NORMALISED = 0, CLI_RAD_S, CLI_HZ, CLI_PERIOD, CLI_IRVINE_UNITS };
enum { CLI_IRVINE_SPEEDS = 12 };
extern const char *const cli_irvine_units[]; /* "rad/s" */

/* A sweep, and the analytic frequencies that the picture shows with it. */
struct cli_irvine_sweep {
	struct hawser_irvine irvine;
	int overlays;     /* curves of the analytic method: the places in each plane that the branches
	                   * have somewhere; 0 without a picture, or without such a method */
	double *analytic; /* [stations][overlays] rad/s, NAN where no branch has the place */
};

struct cli_irvine_result {
	const struct cli_common *common;
	struct hawser_scene scene;
	int sweeps;             /* one sweep for each speed */
	int moving;             /* 1: the cable travels in one of them, or --speeds is given */
	struct cli_irvine_sweep sweep[CLI_IRVINE_SPEEDS]; /* [sweeps] */
	enum cli_irvine_unit unit;
	struct hawser_statics own; /* of the scene itself; H = 0: it has none */
	int over_value;         /* abscissa of the picture: 1: the swept quantity, 0: lambda */
};

/* "N" or "m" */
const char *cli_irvine_si(enum hawser_given sweep);
/* Convert rad/s at the tension H (N) to the unit of the table. */
double cli_irvine_in_unit(const struct cli_irvine_result *result, double omega, double H);
/* The actual H of a station. */
double cli_irvine_tension(const struct hawser_irvine_station *station);
/* 1 if there is an analytic method for this motion. */
int cli_irvine_has_analytic(const struct hawser_irvine *irvine);
/* Frequencies by the analytic method, for the picture. */
enum hawser_status cli_irvine_overlay(struct cli_irvine_result *result,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct cli_showing cli_irvine_showing;
enum hawser_status cli_irvine_draw(const char *path, const void *result,
                                   struct hawser_report *report);
void cli_irvine_free(struct cli_irvine_result *result);

#endif
