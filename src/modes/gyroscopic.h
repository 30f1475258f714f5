/* modes/gyroscopic.h - the code common to the methods for modes of a travelling cable.
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

/* Modes by a method for cables at rest, converted to complex modes, for a cable that does not
 * travel. */
enum hawser_status hawser__gyroscopic_at_rest(struct hawser_complex_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              const char *method, struct hawser_report *report);

/* Allocate n modes on a grid of `points` nodes. Status: _MEMORY. */
enum hawser_status hawser__complex_allocate(struct hawser_complex_modes *modes, int n, int points,
                                            struct hawser_report *report);

/* Normalise all modes, set their phases and fill their remaining members. Plane, eigenvalue, shape
 * and slope of each mode, the statics and the grid must be set. Status: _NAN. */
enum hawser_status hawser__complex_label(struct hawser_complex_modes *modes,
                                         struct hawser_report *report);

#endif
