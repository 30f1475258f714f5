/* modes/gyroscopic.h - what the ways to the modes of a travelling cable share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_GYROSCOPIC_H
#define HAWSER_MODES_GYROSCOPIC_H

#include <hawser/gyroscopic.h>

enum hawser_status hawser__gyroscopic_solve(struct hawser_complex_modes *modes,
                                            const struct hawser_statics *statics,
                                            const struct hawser_modes_options *options,
                                            struct hawser_report *report);
enum hawser_status hawser__gyroscopic_analytic(struct hawser_complex_modes *modes,
                                               const struct hawser_statics *statics,
                                               const struct hawser_modes_options *options,
                                               struct hawser_report *report);
enum hawser_status hawser__gyroscopic_fdm(struct hawser_complex_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report);

/* The modes of that resting row, for a cable that does not travel. */
enum hawser_status hawser__gyroscopic_at_rest(struct hawser_complex_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              const char *method, struct hawser_report *report);

/* Room for n modes on a grid of `points` nodes. Status: _MEMORY. */
enum hawser_status hawser__complex_allocate(struct hawser_complex_modes *modes, int n, int points,
                                            struct hawser_report *report);

/* Every mode, whose plane, eigenvalue, shape and slope are there, gets norm, phase, and the rest.
 * The statics and the grid must be in *modes. Status: _NAN. */
enum hawser_status hawser__complex_label(struct hawser_complex_modes *modes,
                                         struct hawser_report *report);

#endif
