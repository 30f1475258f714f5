/* cli/motion/film_net.h - a net in motion, for --animate of hawser integrate and orbit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FILM_NET_H
#define HAWSER_CLI_FILM_NET_H

#include <hawser/net_motion.h>

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
