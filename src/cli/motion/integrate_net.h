/* cli/motion/integrate_net.h - hawser integrate of a scene of kind `net`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_INTEGRATE_NET_H
#define HAWSER_CLI_INTEGRATE_NET_H

#include "cli/frame/cli.h"

/* Texts of options; NULL if not given. */
struct cli_integrate_net {
	const char *until, *every, *step, *scheme, *probe, *vtk, *state, *initial, *animate;
	double tolerance; /* 0: the library's */
	int frames;       /* of the animation */
	int error;        /* 1: another run, for the error */
	int skip_error;   /* of rods, 1: without the runs for the errors */
};
/* integrate_rod.c: of a scene of kind `rod`. */
/* Times of a run as hawser_net_integrate and hawser_rod_integrate take them (step -1: by the error);
 * kind: the word for the scene. */
enum hawser_status cli_integrate_times(double *until, double *every, double *step,
                                       const struct cli_integrate_net *settings, const char *kind,
                                       struct hawser_report *report);
enum hawser_status cli_integrate_rod(const struct cli_common *common,
                                     const struct cli_integrate_net *settings,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_integrate_net(const struct cli_common *common,
                                     const struct cli_integrate_net *settings,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
