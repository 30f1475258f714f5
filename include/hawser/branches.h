/* hawser/branches.h - the branch that begins at a bifurcation of another one: motions of twice the
 * period at a period doubling, a second motion of the same period at a branch point, such as the
 * out-of-plane motion that is born from one in the plane (whirling).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BRANCHES_H
#define HAWSER_BRANCHES_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Trace the branch that begins at an event of `from`, a response of `rom` over Omega or over the
 * parameter of a family, away from the event. Its first orbit is searched for beside the event, in the
 * direction of the eigenvector of the multiplier that is -1 or 1 there. branch->period is that of
 * `from`, or twice as much. options: those of `from`; `begin`, `direction` and `start` are not used.
 * Release with hawser_frf_clear. Of a family of autonomous models `from` may be equilibria or limit
 * cycles, and the event a Hopf point; event -1 is the limit cycle to which the motion goes from beside
 * an equilibrium that is unstable, -2 the same to the other end of the range if it begins in the
 * middle.
 * HAWSER_ERR_ARGUMENT (another event than a period doubling or a branch point, or one that was not
 * located), HAWSER_ERR_CONVERGENCE (no orbit of another branch was found), and those of
 * hawser_frf_trace. */
enum hawser_status hawser_branch_switch(struct hawser_frf *branch, const struct hawser_rom *rom,
                                        const struct hawser_frf *from, int event,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Trace a branch of motions of `periods` periods of the load, with options->start the state of one of
 * them. Statuses of hawser_frf_trace; HAWSER_ERR_ARGUMENT (periods < 1, or no multiple of the model's
 * own). */
enum hawser_status hawser_branch_trace(struct hawser_frf *branch, const struct hawser_rom *rom,
                                       int periods, const struct hawser_frf_options *options,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif

#endif
