/* study/accuracy/chosen.h - the first model for the response of N chosen modes: see chosen.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CHOSEN_H
#define HAWSER_STUDY_CHOSEN_H

#include <hawser/choose.h>
#include <hawser/frf.h>

/* The first model, and the options with which its response is traced. Must not be moved: choice
 * refers to modes. */
struct hawser__chosen {
	struct hawser_choice choice;
	struct hawser_modes modes;
	struct hawser_scene scene;         /* its `name` is owned by the caller */
	struct hawser_frf_options options;
};

/* Find the first model. Statuses of hawser_modes_solve and hawser_choose. Release with
 * hawser__chosen_clear, whatever the status. */
enum hawser_status hawser__chosen_begin(struct hawser__chosen *begin,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options, int n,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__chosen_clear(struct hawser__chosen *begin);

#endif
