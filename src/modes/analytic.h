/* modes/analytic.h - closed forms for constant tension and curvature.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_ANALYTIC_H
#define HAWSER_MODES_ANALYTIC_H

#include <hawser/modes.h>

#include "modes/cable.h"

enum hawser_status hawser__analytic_solve(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report);

/* Kinds of waves on a cable of constant tension and curvature. */
enum hawser__wave_kind { HAWSER__OUT_OF_PLANE, HAWSER__TRANSVERSE, HAWSER__LONGITUDINAL,
                         HAWSER__WAVE_KINDS };

/* A mode in closed form. The symbols are those of analytic.c and gyroscopic_analytic.c. */
struct hawser__wave {
	double omega; /* scaled */
	double phase; /* X at rest; Y if the cable travels */
	double y;     /* of Y; 0 at rest */
	enum hawser__wave_kind kind;
	int even;     /* at rest: f is even about mid-length, X a root of the transcendental equation */
};

/* The closed forms of a cable at rest, or those of one that travels. */
struct hawser__closed_forms {
	int wavelengths; /* that the grid resolves, for each mode asked for */
	int work;        /* rows of the work space of `fill` */
	/* The first n waves of each kind, in any order: wave [HAWSER__WAVE_KINDS*n]. */
	void (*find)(struct hawser__wave *wave, const struct hawser_statics *statics, int n);
	/* Shape, slope, residual and condition of mode k, whose omega and plane are set. work
	 * [work][points]. */
	void (*fill)(struct hawser_modes *modes, int k, const struct hawser__wave *wave,
	             const struct hawser__cable *cable, double *work);
};

/* Modes by closed forms. Statuses: _ARGUMENT (more functions than the grid may have, or fewer than
 * the modes need), _CONVERGENCE (a tolerance is given and the largest error bound exceeds it), _NAN,
 * _MEMORY. */
enum hawser_status hawser__closed_forms_solve(struct hawser_modes *modes,
                                              const struct hawser__closed_forms *forms,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              struct hawser_report *report);

#endif
