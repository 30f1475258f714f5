/* response/cycle/cycle.h - equilibria and limit cycles of autonomous models, as methods for orbits
 * (response/orbit/method.h) of a family whose frequency is 0.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_CYCLE_H
#define HAWSER_RESPONSE_CYCLE_H

#include "response/orbit/method.h"

/* Equilibria: equilibrium.c. The "multipliers" of an equilibrium are (s + x)/(s - x) of the
 * eigenvalues x, with a rate s that is the same along the branch: the left half plane becomes the
 * unit disc, and what finds the events of orbits finds folds, branch points and Hopf points. */
enum hawser_status hawser__equilibrium_open(struct hawser__orbit **orbit,
                                            const struct hawser_rom *rom,
                                            struct hawser_report *report);
/* The eigenvalue of such a multiplier. */
void hawser__equilibrium_value(double *growth, double *turn, const struct hawser__orbit *orbit,
                               double log_modulus, double argument);

/* The matrix A (column-major) of x' = A x about the state u [n], v [n]; returns its order. */
int hawser__autonomous_matrix(double *A, double *by_u, double *by_v, double *acceleration,
                              const struct hawser_rom *rom, const double *u, const double *v);

/* Limit cycles: cycle.c. `inner` (owned) has Omega as its parameter; the family's follows it in
 * y. */
enum hawser_status hawser__cycle_open(struct hawser__orbit **orbit, struct hawser__orbit *inner,
                                      struct hawser_report *report);

/* The y of the last metric is only a guess of a cycle: the next corrections may shift it. */
void hawser__cycle_loose(struct hawser__orbit *orbit);

/* turn [n][n]: the generator of rotations of the coordinates that leave the model as it is; *found:
 * there are such. turn.c. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__cycle_turn(double *turn, int *found, const struct hawser_rom *rom,
                                      struct hawser_report *report);

/* From a state x [2n], which may be replaced by a later one of the motion from it: *omega of the
 * limit cycle that is near, or 0 where the state is an equilibrium. HAWSER_ERR_CONVERGENCE (the
 * motion does not come to a cycle), HAWSER_ERR_MEMORY. */
enum hawser_status hawser__cycle_settle(double *x, double *omega, const struct hawser_rom *rom,
                                        struct hawser_report *report);

/* The branch at an event of equilibria or cycles, and beside equilibria that are unstable:
 * hawser_branch_switch. */
enum hawser_status hawser__own_leave(struct hawser_frf *branch, const struct hawser_rom *rom,
                                     const struct hawser_frf *from, int back,
                                     const struct hawser_frf_options *options,
                                     struct hawser_report *report);
enum hawser_status hawser__own_switch(struct hawser_frf *branch, const struct hawser_rom *rom,
                                      const struct hawser_frf *from, int event,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report);
/* switch/branches.c: x [2n] becomes the state after a period; A [2n][2n], unless NULL, its
 * derivative. */
enum hawser_status hawser__branch_period(double *x, double *A, const struct hawser_rom *rom,
                                         double omega, struct hawser_report *report);
/* v [2n], of length 1: the eigenvector of the period map at the state x [2n], of
 * the multiplier nearest to `target`. */
enum hawser_status hawser__branch_direction(double *v, const struct hawser_rom *rom, const double *x,
                                            double omega, double target,
                                            struct hawser_report *report);

#endif
