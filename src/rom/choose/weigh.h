/* rom/choose/weigh.h - the dynamic part of each mode in a motion. See weigh.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_WEIGH_H
#define HAWSER_ROM_WEIGH_H

#include <hawser/choose.h>

/* A measure, or a fraction of the largest load, that is zero but for round-off. */
#define HAWSER__NEGLIGIBLE 1e-9

/* Displacements that are weighed: bit 3*p + axis for x, y or z (0, 1, 2) at shape point p; or the
 * displacement in each plane as a whole, if it is not below FAINT (weigh.c). */
#define HAWSER__BY_PLANE (~0u)
enum { HAWSER__COUNTED = 30 }; /* bits in use */

/* most[3*p + axis], of the shape points: largest amplitudes in the motion u[rows][n] of all modes. */
void hawser__largest_displacements(double *most, const struct hawser_rom *all, const double *u,
                                   int rows);

/* The largest relative change of a weighed displacement by delta[rows] of mode s in that motion. */
double hawser__displaced(const struct hawser_rom *all, int s, const double *u, const double *delta,
                         int rows, unsigned counted, const double *most);

/* The orbit of which a motion is: of `model`, whose coordinates are the kept modes in ascending order
 * and then inertia shapes. */
struct hawser__orbit_of {
	const struct hawser_rom *model;
	const double *state; /* [rows][model->n] its coordinates in the rows of the motion */
};

/* coordinate[rows][n] of all modes over a period; those that are not kept are ignored. `spacing`: range
 * in omega on either side that the motion represents. whole = 0: only modes that it can make unstable.
 * For `peaks` and `orbit` see hawser__order. */
enum hawser_status hawser__weigh(struct hawser_choice *choice, const double *coordinate, int rows,
                                 double omega, double spacing, int whole, unsigned counted,
                                 unsigned peaks, const struct hawser__orbit_of *orbit,
                                 struct hawser_report *report);

/* Error in the motion u[rows][n], which `orbit` has (NULL: nearly an orbit of choice->all): relative
 * error of the frequency, and of the amplitudes that have a peak there. [0] the part that no candidate
 * mode would reduce: energy beyond the fourth order, also where the load moves condensed modes, and
 * inertia and damping of modes beyond the candidates; [1] by the order of the energy alone; [2] all of
 * it, with the inertia and damping of every mode that is not kept. 1 if the strain energy has no
 * minimum with the kept modes at u. order.c. */
enum { HAWSER__OMITTED = 3 };
enum hawser_status hawser__order(double omitted[HAWSER__OMITTED], const struct hawser_choice *choice,
                                 const struct hawser__orbit_of *orbit, const double *u, int rows,
                                 double omega, unsigned peaks,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

/* hawser_choose without the choice itself, and, if guesses = 0, without estimated motions, which
 * computed ones are to replace. */
enum hawser_status hawser__choice_begin(struct hawser_choice *choice,
                                        const struct hawser_modes *modes,
                                        const struct hawser_scene *scene, double from, double to,
                                        double accuracy, int guesses,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Set choice->exact and choice->twin. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__choice_resolve(struct hawser_choice *choice,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* hawser_choice_weigh for the weighed displacements, in a motion, which `orbit` has, at which those of
 * `peaks` (bits as above) have a peak. */
enum hawser_status hawser__choice_weigh(struct hawser_choice *choice, const double *coordinate,
                                        int rows, double omega, int whole, unsigned counted,
                                        unsigned peaks, const struct hawser__orbit_of *orbit,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
