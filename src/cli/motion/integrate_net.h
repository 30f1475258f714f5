/* cli/motion/integrate_net.h - hawser integrate of a scene of kind `net`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_INTEGRATE_NET_H
#define HAWSER_CLI_INTEGRATE_NET_H

#include <hawser/net.h>

#include <hawser/net_motion.h>

#include "cli/frame/kinds.h"
#include "cli/frame/view.h"

/* The settings of the entries `integrate` of kinds: texts of options; NULL if not given. */
struct cli_integrate_net {
	const struct cli_common *common;
	const char *until, *every, *step, *scheme, *probe, *vtk, *state, *initial, *animate;
	double tolerance; /* 0: the library's */
	int frames;       /* of the animation */
	int error;        /* 1: another run, for the error */
	int skip_error;   /* of rods, 1: without the runs for the errors */
};

/* --- probes_mesh.c: motions of probes, of nets and rods --- */

enum { CLI_PROBES = 64, CLI_PROBE_NAME = HAWSER_NET_NAME + 24 };
struct cli_probed {
	int rows, probes;
	char name[CLI_PROBES][CLI_PROBE_NAME];
	const double (*x)[3], (*v)[3], *T, *M; /* [rows*probes] row by row; v, M: of rods, or NULL */
	const double *s; /* [probes] of rods, or NULL */
	const double (*pull)[3]; /* [rows*probes] N, of nets, or NULL */
	int held[CLI_PROBES], holds; /* [holds] the probes that supports hold */
};
/* Add the probes in this text (NULL: none), with commas between them; `add` takes the place of the last
 * one from its name. */
struct cli_probe_adder {
	enum hawser_status (*add)(void *result, const char *name, struct hawser_report *report);
	struct cli_probed *probed;
	void *result;
};
enum hawser_status cli_probes_add(const struct cli_probe_adder *by, const char *text,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* Columns, with this as the context; and `probes` of JSON. */
extern const struct hawser__vector cli_probed_vector, cli_pulled_vector;
extern const struct hawser__field cli_probed_field[];

/* --- integrate_net.c, integrate_rod.c --- */

/* Columns, and keys of JSON. */
extern const struct hawser__field cli_net_motion_field[], cli_rod_motion_field[];
/* Times of a run as hawser_net_integrate and hawser_rod_integrate take them (step -1: by the error);
 * kind: the word for the scene. */
enum hawser_status cli_integrate_times(double *until, double *every, double *step,
                                       const struct cli_integrate_net *settings, const char *kind,
                                       struct hawser_report *report);

/* warnings_net.c: what is warned of after a motion. */
void cli_motion_warnings(const struct hawser_net *net, const struct hawser_net_motion *motion);

#endif
