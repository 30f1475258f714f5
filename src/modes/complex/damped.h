/* modes/complex/damped.h - eigenvalues of a cable with dampers, between the files of hawser/damped.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_DAMPED_H
#define HAWSER_MODES_DAMPED_H

#include <hawser/damped.h>

/* Two bases, for results and their errors. They do not depend on dampers. `tries`: how often they were
 * too small before; -1: bases for 1e-6 rather than round-off. */
struct hawser__damped_pair {
	int functions; /* of the larger one */
	struct hawser_modes coarse, fine;
};
enum hawser_status hawser__damped_pair(struct hawser__damped_pair *pair,
                                       const struct hawser_statics *st, int n, int tries,
                                       struct hawser_report *report);
/* The same with bending stiffness, whose elements follow the boundary layers; flexure_basis.c. */
enum hawser_status hawser__damped_bending(struct hawser__damped_pair *pair,
                                          const struct hawser_statics *st, int n, int tries,
                                          struct hawser_report *report);
void hawser__damped_pair_clear(struct hawser__damped_pair *pair);

/* The n modes of lowest damped frequency from two bases; *worst: the largest estimated error. The
 * dampers are those of st, which is otherwise the span of the bases. Without `planes`, which take
 * most of the time, all count as in the plane. The caller clears *damped, also on failure. */
enum hawser_status hawser__damped_of(struct hawser_damped *damped, double *worst,
                                     const struct hawser__damped_pair *pair,
                                     const struct hawser_statics *st,
                                     const struct hawser_scene *scene, int n, int planes,
                                     struct hawser_report *report);

/* The first of the ascending values of the key from which on one more mode grows, located between two
 * of them; INFINITY: there is none. The values beyond are not computed. Statuses of
 * hawser_damped_trace. */
enum hawser_status hawser__damped_onset(double *value, const struct hawser_scene *scene,
                                        const struct hawser_damped_sweep_options *options,
                                        struct hawser_report *report);

#endif
