/* hawser/backbone.h - backbone curves: families of free periodic motions of the undamped model that
 * begin at one of its modes, followed in amplitude.
 *
 * The model of a cable at rest is time-reversible, so the velocity of such motions vanishes twice per
 * period. With u(0) = u0 and du/dt = 0 at phase 0, the n equations du/dt = 0 at phase pi determine a
 * curve of (u0, Omega). Only half a period is integrated, and no phase condition is needed. Other
 * motions are never at rest: those that whirl, and all of a gyroscopic model (a travelling
 * cable's). They equal their own reverse with some coordinates reflected, if the model has this
 * symmetry. The coordinates have signs: 1, even in time, with velocity 0 at phases 0 and pi; -1,
 * odd in time, with value 0 there, and u0 stands for du/dt/Omega. With `periods` k, du/dt vanishes
 * at phase k pi: the curve is the same, and has branch points where motions of k periods begin as
 * well.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BACKBONE_H
#define HAWSER_BACKBONE_H

#include <hawser/orbit.h>
#include <hawser/progress.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_backbone_end {
	HAWSER_BACKBONE_SIZE = 0,   /* the amplitude reached options.size */
	HAWSER_BACKBONE_RANGE,      /* Omega left the range */
	HAWSER_BACKBONE_REST,       /* the motion returned to rest */
	HAWSER_BACKBONE_MAX_POINTS, /* the curve has max_points points */
	HAWSER_BACKBONE_ENERGY,     /* the energy reached options.energy */
	HAWSER_BACKBONE_MEETS,      /* the curve reached one of the points options.known */
	HAWSER_BACKBONE_STOPPED     /* progress.function asked for it, or the status is not HAWSER_OK */
};

struct hawser_backbone_options {
	int mode;         /* index of the mode */
	double size;      /* largest |u_mode| (scaled); the first point is at a thousandth of it */
	double energy;    /* if positive, the largest energy (scaled), in place of size */
	int periods;      /* k; 0: 1 */
	int branches;     /* 1: locate branch points */
	const double *start, *direction; /* [n + 1] u0 and Omega near the first point, which is in the
	                                  * plane through `start` normal to `direction`, in which the
	                                  * curve goes; NULL: the linear mode */
	const double *known; /* [known_count][2] Omega and energy of branch points at which a curve ends */
	int known_count;
	int quadrature;   /* from 1, or 0: begin in this mode as well, a quarter of a period behind; it
	                   * needs the same frequency */
	const int *sign;  /* [n] with `start`; NULL: all 1, or those that the symmetries require */
	double lo, hi;    /* scaled range of Omega; hi 0: 0.5 to 1.5 times the mode's frequency */
	double tolerance; /* of the defect and of the integration error, relative to the motion; 0: 1e-9 */
	double step_max;  /* longest step in the metric of the continuation; 0: 0.1 */
	int max_points;   /* 0: 2000 */
	struct hawser_progress progress; /* called after each point is added */
};
void hawser_backbone_settle(struct hawser_backbone_options *options);

struct hawser_backbone_point {
	double omega;    /* scaled */
	double energy;   /* scaled; times force*length in J */
	double residual, mesh; /* certificate: defect and integration error, relative to the motion */
	double energy_gap;     /* largest relative change of the energy within the half period */
	int unstable;    /* number of multipliers outside the unit circle by more than their error */
};

struct hawser_backbone_branch {
	double omega, energy; /* scaled */
	int after;            /* index of the point before it */
	int turned;           /* 1: the other motions have other signs: they whirl */
};

struct hawser_backbone {
	int n, points, capacity, probes, branches;
	struct hawser_backbone_branch *branch; /* [branches] in order along the curve */
	double *branch_start;     /* [branches][n + 1] u0, Omega */
	double *branch_direction; /* [branches][n + 1] tangent of the other curve */
	int *branch_sign;         /* [branches][n] its signs */
	struct hawser_backbone_point *point; /* [points] */
	double *coordinate; /* [points][n] max |u_j| */
	double *probe;      /* [points][probes][3] max |x|, |y|, |z|, scaled */
	double *start;      /* [points][n] u0 */
	int *sign;          /* [n] of the coordinates */
	enum hawser_backbone_end end;
};

/* Trace the curve. Release with hawser_backbone_clear. HAWSER_ERR_ARGUMENT (mode, options, K not
 * diagonal, a gyroscopic model without a symmetry of reversed motions), HAWSER_ERR_CONVERGENCE (the
 * message says where; the points traced so far remain), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_backbone_trace(struct hawser_backbone *backbone, const struct hawser_rom *rom,
                                         const struct hawser_backbone_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_backbone_clear(struct hawser_backbone *backbone);

#ifdef __cplusplus
}
#endif
#endif
