/* rom/terms/history.h - the forces of a model's history (struct hawser_rom_history). See history.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_HISTORY_H
#define HAWSER_ROM_HISTORY_H

#include <hawser/rom.h>

/* The value of a signal at time t, or its derivative number `rate` (up to 3); before the first and
 * after the last time that of the first and last cubic. 0 of a signal without rows. */
double hawser__history_value(const struct hawser_rom_history *history, int signal, double t, int rate);

/* The factor of a term, or its time derivative (rate = 1). */
double hawser__history_factor(const struct hawser_rom_history *history, int term, double t, int rate);

/* Least distance of two times. */
double hawser__history_spacing(const struct hawser_rom_history *history);

/* First and last time that all signals have; the status of a run from begin to until. */
enum hawser_status hawser__history_covers(const struct hawser_rom *rom, double begin, double until,
                                          struct hawser_report *report);

/* Add the forces at time t to acceleration [n] and, unless NULL, to its derivatives by_u and by_v
 * [n][n]. */
void hawser__rom_history(const struct hawser_rom *rom, double *acceleration, double *by_u,
                         double *by_v, const double *u, const double *v, double t);

/* s times one term, in the same way. In forced.c. */
void hawser__rom_term(const struct hawser_ramp_term *term, double s, double *acceleration,
                      double *by_u, double *by_v, const double *u, const double *v, int n);

/* --- made of moving ends (support.c, support_energy.c) --- */

/* A history of the model without terms, with the signals of `given` of the scene (history_motion.c). */
enum hawser_status hawser__history_begin(struct hawser_rom *rom, const struct hawser_scene *scene,
                                         const struct hawser_statics *statics,
                                         struct hawser_report *report);

/* Another term of zeros with this factor; NULL if memory is short. */
struct hawser_ramp_term *hawser__history_term(struct hawser_rom *rom,
                                              const struct hawser_history_factor *factor);

/* The last harmonic of the model becomes a term, without corrections of a frequency. */
enum hawser_status hawser__history_take(struct hawser_rom *rom,
                                        const struct hawser_history_factor *factor,
                                        struct hawser_report *report);

/* Signal `number` has value [rows] at time [rows], which are copied. */
enum hawser_status hawser__history_signal(struct hawser_rom *rom, int number, const double *time,
                                          const double *value, int rows,
                                          struct hawser_report *report);

/* Remove the terms from `terms` and the signals from `signals` on. */
void hawser__history_cut(struct hawser_rom_history *history, int terms, int signals);

/* Free what a term owns, and the whole history. */
void hawser__rom_term_clear(struct hawser_ramp_term *term);
void hawser__rom_history_clear(struct hawser_rom *rom);

#endif
