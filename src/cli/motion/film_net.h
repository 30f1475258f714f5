/* cli/motion/film_net.h - a net in motion, for hawser integrate --animate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FILM_NET_H
#define HAWSER_CLI_FILM_NET_H

#include <hawser/net_motion.h>

/* The rows that are shown, at equal distances. */
struct cli_film {
	double (*x)[3]; /* [room][nodes] m */
	int (*end)[2];  /* [elements] */
	int *row;       /* [room] number of the row in the result */
	int rows, nodes, elements;
	int room;       /* frames at most; given */
	double last;    /* number of the last row of the run; given */
};

/* Take the row if it is the next one to be shown. Returns errno. */
int cli_film_add(struct cli_film *film, const struct hawser_net_frame *frame);
/* With a mark and a trail of the first probe. */
enum hawser_status cli_film_write(const char *path, const struct cli_film *film,
                                  const struct hawser_net *net, const struct hawser_net_motion *motion,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_film_clear(struct cli_film *film);

#endif
