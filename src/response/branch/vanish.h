/* response/branch/vanish.h - the end of a branch whose motion vanishes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_VANISH_H
#define HAWSER_RESPONSE_VANISH_H

#include <hawser/frf.h>

/* The sizes of the last orbits of a branch. */
struct hawser__shrinking {
	double size[2], omega[2]; /* of the last two orbits, the last one second */
	double largest;           /* largest size so far */
	int known;
};

/* Store the next orbit of a branch of rom. *found is 1 if the branch ends at a branch point at
 * rest: all members of *event but arc, after and unstable are then set. */
enum hawser_status hawser__vanish(struct hawser__shrinking *shrinking, int *found,
                                  struct hawser_frf_event *event, const struct hawser_rom *rom,
                                  double size, double omega,
                                  struct hawser_report *report);

#endif
