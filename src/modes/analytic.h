/* modes/analytic.h - closed forms for constant tension and curvature.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_ANALYTIC_H
#define HAWSER_MODES_ANALYTIC_H

#include <hawser/modes.h>

enum hawser_status hawser__analytic_solve(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report);

/* What closed forms are sampled on: elements of degree p, `basis` functions a component, so many that
 * as many waves as said are resolved. HAWSER_ERR_ARGUMENT: too many functions, or too few for the
 * modes. */
enum hawser_status hawser__closed_forms_basis(int *elements, int *p, int *basis,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options, int waves,
                                              struct hawser_report *report);

/* HAWSER_ERR_CONVERGENCE: their largest relative error is above the tolerance, where one was asked. */
enum hawser_status hawser__closed_forms_reach(double worst, const struct hawser_modes_options *options,
                                              struct hawser_report *report);

#endif
