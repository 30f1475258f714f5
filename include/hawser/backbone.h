/* hawser/backbone.h - backbone curves: the free periodic motions of the undamped model that grow out of
 * one of its modes, followed in amplitude.
 *
 * A resting cable's model looks the same when time runs backwards, so such motions pass through rest
 * twice a period: u(0) = u0 and du/dt = 0 at phase 0 and at phase pi are n equations for u0 and Omega.
 * Half a period is all that has to be followed, and no phase has to be fixed.
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
	HAWSER_BACKBONE_SIZE = 0,   /* the largest amplitude asked for */
	HAWSER_BACKBONE_RANGE,      /* Omega left the range */
	HAWSER_BACKBONE_REST,       /* came back to rest */
	HAWSER_BACKBONE_MAX_POINTS,
	HAWSER_BACKBONE_STOPPED     /* progress.function asked for it, or the status is not HAWSER_OK */
};

struct hawser_backbone_options {
	int mode;         /* index of the mode */
	double size;      /* largest |u_mode| (scaled) */
	double lo, hi;    /* scaled range of Omega; hi 0: 0.5 to 1.5 of the mode's */
	double tolerance; /* of defect and integration error, relative to the motion; 0: 1e-9 */
	double step_max;  /* largest step, of the natural scale of 1; 0: 0.1 */
	int max_points;   /* 0: 2000 */
	struct hawser_progress progress; /* called after each point is added */
};
void hawser_backbone_settle(struct hawser_backbone_options *options);

struct hawser_backbone_point {
	double omega;    /* scaled */
	double energy;   /* scaled; times force*length in J */
	double residual, mesh; /* certificate, relative to the motion */
	double energy_gap;     /* largest difference of the energy along the half period, relative */
	int unstable;    /* Floquet multipliers outside the unit circle (1e-5: two are always 1) */
};

struct hawser_backbone {
	int n, points, capacity, probes;
	struct hawser_backbone_point *point; /* [points] */
	double *coordinate; /* [points][n] max |u_j| */
	double *probe;      /* [points][probes][3] max |x|, |y|, |z|, scaled */
	double *start;      /* [points][n] u0 */
	enum hawser_backbone_end end;
};

/* HAWSER_ERR_ARGUMENT (mode, options, K not diagonal, a gyroscopic model, which has no such motions),
 * HAWSER_ERR_CONVERGENCE (where, and what is traced already remains), HAWSER_ERR_MEMORY. Release with
 * hawser_backbone_clear. */
enum hawser_status hawser_backbone_trace(struct hawser_backbone *backbone, const struct hawser_rom *rom,
                                         const struct hawser_backbone_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_backbone_clear(struct hawser_backbone *backbone);

#ifdef __cplusplus
}
#endif
#endif
