/* modes/analytic.h - closed forms for constant tension and curvature.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_ANALYTIC_H
#define HAWSER_MODES_ANALYTIC_H

#include <hawser/modes.h>

enum hawser_status hawser__analytic_solve(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report);

/* The grid on which closed forms are sampled: elements of degree p, `basis` functions per
 * component, enough to resolve the given number of waves. HAWSER_ERR_ARGUMENT: too many functions,
 * or too few for the modes. */
enum hawser_status hawser__closed_forms_basis(int *elements, int *p, int *basis,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options, int waves,
                                              struct hawser_report *report);

/* HAWSER_ERR_CONVERGENCE if a tolerance is given and the largest error bound exceeds it. */
enum hawser_status hawser__closed_forms_reach(double worst, const struct hawser_modes_options *options,
                                              struct hawser_report *report);

#endif
