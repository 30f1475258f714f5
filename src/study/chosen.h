/* study/chosen.h - how the response of N chosen modes begins: see chosen.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CHOSEN_H
#define HAWSER_STUDY_CHOSEN_H

#include <hawser/choose.h>
#include <hawser/frf.h>

/* The first model, and how its response is traced. choice refers to modes: it stays where it is. */
struct hawser__chosen {
	struct hawser_choice choice;
	struct hawser_modes modes;
	struct hawser_scene scene;         /* the name is the caller's */
	struct hawser_frf_options options;
};

/* Statuses of hawser_modes_solve and hawser_choose. Release with hawser__chosen_clear whatever the
 * status. */
enum hawser_status hawser__chosen_begin(struct hawser__chosen *begin,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options, int n,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__chosen_clear(struct hawser__chosen *begin);

#endif
