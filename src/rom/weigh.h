/* rom/weigh.h - what each mode does in a motion that it does not do statically. See weigh.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_WEIGH_H
#define HAWSER_ROM_WEIGH_H

#include <hawser/choose.h>

/* A measure, or a part of the largest load, that is round-off: no reason for anything. */
#define HAWSER__NEGLIGIBLE 1e-9

/* Which displacements count, in what is moved: bit 3*p + axis for x, y or z (0, 1, 2) at shape point
 * p; or those in each plane as a whole, where they are not faint. */
#define HAWSER__BY_PLANE (~0u)
enum { HAWSER__COUNTED = 30 }; /* bits that mean something */

/* most[3*p + axis], of the shape points: largest amplitudes in the motion u[rows][n] of all modes. */
void hawser__largest_displacements(double *most, const struct hawser_rom *all, const double *u,
                                   int rows);

/* The largest part by which delta[rows] of mode s moves, in that motion, a displacement that counts. */
double hawser__displaced(const struct hawser_rom *all, int s, const double *u, const double *delta,
                         int rows, unsigned counted, const double *most);

/* coordinate[rows][n] of all modes over a period; those that are not kept are not looked at. `spacing`:
 * how far on either side in omega the motion stands for. whole = 0: only what it can make unstable.
 * For `peaks` and `model` see hawser__order. */
enum hawser_status hawser__weigh(struct hawser_choice *choice, const double *coordinate, int rows,
                                 double omega, double spacing, int whole, unsigned counted,
                                 unsigned peaks, const struct hawser_rom *model,
                                 struct hawser_report *report);

/* What no mode looked at makes up for, in the motion u[rows][n] of `model` (NULL: one without shapes),
 * of which the kept modes alone are looked at: the energy's terms beyond the fourth order, and inertia
 * and damping of modes beyond. The part by which the frequency is off, and the amplitudes of those
 * displacements that have a peak there: [0] all of it, [1] the energy's order alone; 1 where the strain
 * energy has no least value with the kept modes where they are. order.c. */
enum hawser_status hawser__order(double lacks[2], const struct hawser_choice *choice,
                                 const struct hawser_rom *model, const double *u, int rows,
                                 double omega, unsigned peaks,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

/* Set choice->exact and choice->twin. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__choice_resolve(struct hawser_choice *choice,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* hawser_choice_weigh, of the displacements that count, in a motion of `model` at which those of
 * `peaks` (bits as above) have one. */
enum hawser_status hawser__choice_weigh(struct hawser_choice *choice, const double *coordinate,
                                        int rows, double omega, int whole, unsigned counted,
                                        unsigned peaks, const struct hawser_rom *model,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
