/* study/accuracy/accuracy.h - parts of the search for a model of a requested accuracy: see accuracy.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_ACCURACY_H
#define HAWSER_STUDY_ACCURACY_H

#include <hawser/accuracy.h>

#include "response/branch/trace.h"
#include "study/compare/distance.h"

/* Smallest error that is claimed, relative to the accuracy: tolerances are chosen for it. */
#define HAWSER__LEAST_CLAIM 0.02

/* Error of located peaks, relative to the accuracy; chosen. */
#define HAWSER__LOCATED 0.2

/* Factor on first-order measures for the terms of higher order; calibrated by bench/accuracy.c. */
#define HAWSER__SAFETY 3.0
/* The same on those that add all terms of first order with their signs; by bench/practical.py too. */
#define HAWSER__SAFETY_ORDER 1.75

#define HAWSER__FIRST 10 /* most modes of the first model: later ones depend on its motions; chosen */
#define HAWSER__NEXT 0.2 /* rest of the next model, relative to the accuracy: a small one saves a
                          * further model; chosen */

/* Fewest candidates; chosen. */
enum { HAWSER__FEWEST = 12 };

/* What every search begins with: the accuracy that is asked for. */
enum hawser_status hawser__accuracy_begin(struct hawser_accuracy *a, const struct hawser_scene *scene,
                                          const struct hawser_accuracy_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* Range, tolerances and steps of the responses for an accuracy. */
struct hawser_frf_options
hawser__accuracy_settle(const struct hawser_accuracy_options *options, double accuracy);

/* The largest number of functions per component that is tried: `asked`, 0 for the default, and more
 * with bending. */
int hawser__accuracy_largest(int asked, const struct hawser_statics *st);

/* Where the error of a response is wanted, which is mostly far below the accuracy: the bases that are
 * compared have more functions per component than these, */
int hawser__accuracy_fewest(const struct hawser_statics *st);
#define HAWSER__AMONG 48 /* largest number of candidate modes, limits the cost of their tensors */
#define HAWSER__BASIS_PART 0.1 /* and an error of this part of the accuracy; chosen */

/* Trace the next response and compute its distance from the previous one, which *marks describes;
 * *marks then describes the new one. functions = 0: a model of the modes that are kept now is
 * built; otherwise a->rom is the full-order model with that number of functions. known: orbits of it,
 * or NULL. Statuses of hawser_frf_trace and hawser_rom_build. */
enum hawser_status hawser__accuracy_attempt(struct hawser_accuracy *a, struct hawser__marks *marks,
                                            const struct hawser_scene *scene, int functions,
                                            const struct hawser_frf_options *options,
                                            const struct hawser__orbits *known,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* Frequency up to which modes are candidates, where the range ends at `to`. */
double hawser__accuracy_reach(double to, double accuracy);

/* Compute the candidates, the modes among which hawser_accuracy_choose chooses: at least `fewest`. */
enum hawser_status hawser__accuracy_candidates(struct hawser_modes *modes,
                                               const struct hawser_statics *statics,
                                               const struct hawser_scene *scene, double from,
                                               double to, double accuracy, int fewest,
                                               struct hawser_report *report) HAWSER_MUST_CHECK;

/* The error of a model which keeps the modes of the choice, from what was weighed. To first order, with
 * its signs, it is choice->followed, if there is a full-order model to find it: what the omitted modes
 * do beside following is of that order and included; the square of all that is not. */
double hawser__model_error(const struct hawser_choice *choice);

/* The error that is stated of a model which keeps the modes of the choice, from what was weighed. */
void hawser__accuracy_add_up(struct hawser_accuracy_fixed *fixed, const struct hawser_choice *choice,
                             double located);

/* Set the estimated error: that of the model, `model`, plus the error of the located peaks. */
void hawser__accuracy_claim(struct hawser_accuracy *a, double model,
                            const struct hawser__marks *marks);

/* 1: the last response is incomplete, or its tension is negative at many points. */
int hawser__accuracy_cut(const struct hawser_accuracy *a);

/* 1: the tension of a response is negative at so many points that no model of this kind is valid. */
int hawser__mostly_slack(const struct hawser_frf *frf);

/* Trace full-order models of increasing bases until two agree, and the response of the smaller one.
 * Statuses of hawser_rom_build_full and hawser_frf_trace. */
enum hawser_status hawser__accuracy_full(struct hawser_accuracy *a, struct hawser__marks *marks,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
