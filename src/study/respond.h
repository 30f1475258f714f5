/* study/respond.h - the ways to a response.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_RESPOND_H
#define HAWSER_STUDY_RESPOND_H

#include <hawser/accuracy.h>
#include <hawser/study.h>

/* Continuation of periodic orbits. */
enum hawser_status hawser__study_trace(struct hawser_study_curve *curve,
                                       struct hawser_rom *rom,
                                       const struct hawser_statics *statics,
                                       const struct hawser_scene *scene,
                                       const struct hawser_frf_options *options,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same by harmonic balance, which many coordinates want. */
enum hawser_status hawser__study_balance(struct hawser_study_curve *curve,
                                         struct hawser_rom *rom,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_frf_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* The scene that an accuracy is asked for; its name stays the caller's. And that accuracy. */
struct hawser_scene hawser__auto_scene(const struct hawser_scene *scene);
double hawser__auto_accuracy(const struct hawser_fidelity_choice *choice,
                             const struct hawser_scene *scene);

/* The search for a model of that accuracy, as hawser__study_auto has it; *accuracy is filled even where
 * the search is cut. Its settings are *settings. Statuses of hawser_accuracy_trace. */
enum hawser_status hawser__study_search(struct hawser_accuracy *accuracy,
                                        struct hawser_accuracy_options *settings,
                                        const struct hawser_fidelity_choice *choice,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Modes chosen for an accuracy, and continuation. */
enum hawser_status hawser__study_auto(struct hawser_study_curve *curve, struct hawser_rom *rom,
                                      const struct hawser_statics *statics,
                                      const struct hawser_scene *scene,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* The modes chosen for the scene and the range, and continuation. */
enum hawser_status hawser__study_chosen(struct hawser_study_curve *curve,
                                        struct hawser_rom *rom,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Closed forms of the method of multiple scales, one mode at a time. */
enum hawser_status hawser__study_scales(struct hawser_study_curve *curve,
                                        struct hawser_rom *rom,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
