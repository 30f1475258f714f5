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

/* --- events_net.c: cables of a net that part, and winches, in the output of integrate --- */

struct cli_events {
	const struct hawser_net *net;
	const struct hawser_net_parted *failure; /* [failures] */
	const struct hawser_net_wound *winch;    /* [winches] */
	int failures, winches;
};
/* Options of the view. */
enum { CLI_FAILURES = 2, CLI_WINCHES = 4 };
extern const struct hawser__field cli_events_field[];
void cli_events_comments(struct hawser__table *table, const struct cli_events *events);

/* --- film_net.c: a net in motion, for --animate of hawser integrate and orbit --- */

/* The rows that are shown, at equal distances. */
struct cli_film {
	double (*x)[3]; /* [room][nodes] m */
	int (*end)[2];  /* [elements] */
	int *row;       /* [room] number of the row in the result */
	double *time;   /* [room] s */
	double (*mark)[3]; /* [room] m: what has a mark and a trail; by the caller or cli_film_magnify */
	char note[48];  /* after the time */
	int *held;      /* [helds] nodes that are shown as held; the caller's */
	int rows, nodes, elements, helds;
	int room;       /* frames at most; given */
	double last;    /* number of the last row of the run; given */
};

/* Take the row if it is the next one to be shown. Returns errno. */
int cli_film_add(struct cli_film *film, const struct hawser_net_frame *frame);
/* Where motions are too small to be seen, enlarge them about the mean of all rows by a round number,
 * which the note tells. The node that moves most has the mark. */
void cli_film_magnify(struct cli_film *film);
/* net: has its supports, in place of `held`, and its surfaces; or NULL. */
enum hawser_status cli_film_write(const char *path, const struct cli_film *film,
                                  const struct hawser_net *net,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_film_clear(struct cli_film *film);

#endif
