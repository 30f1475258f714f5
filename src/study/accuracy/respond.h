/* study/accuracy/respond.h - the functions that compute the responses of the fidelities.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_RESPOND_H
#define HAWSER_STUDY_RESPOND_H

#include <hawser/accuracy.h>
#include <hawser/study.h>

/* By continuation of periodic orbits. */
enum hawser_status hawser__study_trace(struct hawser_study_curve *curve,
                                       struct hawser_rom *rom,
                                       const struct hawser_statics *statics,
                                       const struct hawser_scene *scene,
                                       const struct hawser_frf_options *options,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same by harmonic balance, which suits models with many coordinates. */
enum hawser_status hawser__study_balance(struct hawser_study_curve *curve,
                                         struct hawser_rom *rom,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_frf_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* With modes chosen for an accuracy, by continuation. */
enum hawser_status hawser__study_auto(struct hawser_study_curve *curve, struct hawser_rom *rom,
                                      const struct hawser_statics *statics,
                                      const struct hawser_scene *scene,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* With a given number of modes, chosen for the scene and the range, by continuation. */
enum hawser_status hawser__study_chosen(struct hawser_study_curve *curve,
                                        struct hawser_rom *rom,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Closed forms by the method of multiple scales, one mode at a time. */
enum hawser_status hawser__study_scales(struct hawser_study_curve *curve,
                                        struct hawser_rom *rom,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
