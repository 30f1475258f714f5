/* hawser/nnm.h - nonlinear normal modes: the free periodic motions of a model without damping and load,
 * over energy and frequency, with the branches that begin at internal resonances.
 *
 * The first curve is the backbone that begins at a linear mode (backbone.h). Where another family of
 * motions meets it, the determinant of the system changes its sign; these are its branch points. They
 * are left both ways along the other curve, and so on to a given depth. In a diagram of frequency over
 * energy such curves have tongues: along them a motion of the mode becomes one in which another mode,
 * of a multiple of the frequency, takes part.
 *
 * Motions in which all coordinates are at rest at two instants of a period come first; where the
 * model may be reflected, those that whirl begin at branch points as well, or at two modes of the
 * same frequency (backbone.h). Free motions that don't equal their reverse with any reflection are
 * not found. With `periods` k, branches of motions that repeat after up to k periods are found as
 * well.
 *
 * Reference: G. Kerschen, M. Peeters, J. C. Golinval and A. F. Vakakis, Nonlinear normal modes, part I,
 * Mech. Syst. Signal Process. 23 (2009) 170; M. Peeters et al., part II, the same, 195.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NNM_H
#define HAWSER_NNM_H

#include <hawser/backbone.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_nnm_options {
	int mode;         /* index of the mode */
	double energy;    /* largest energy (scaled); 0: where the nonlinear terms of the mode equal the
	                   * linear one */
	double lo, hi;    /* scaled range of Omega; hi 0: 0.25 to 4 times the mode's frequency */
	int depth;        /* branches of branches of ...: 0: only the mode's own curve */
	int quadrature;   /* as in backbone.h; from 1, or 0 */
	int periods;      /* see above; 0: 1 */
	double tolerance; /* of the defect and of the integration error, relative to the motion; 0: 1e-9 */
	double step_max;  /* longest step in the metric of the continuation; 0: 0.05 */
	int max_points;   /* of a curve; 0: 1000 */
	struct hawser_progress progress; /* called after each point is added */
};
void hawser_nnm_settle(struct hawser_nnm_options *options);

struct hawser_nnm_curve {
	int parent, born;    /* index of the curve, and of its branch point, at which this one begins; -1: a
	                      * linear mode */
	int depth;
	struct hawser_backbone motion;
	char message[sizeof ((struct hawser_report *)0)->message]; /* why it was lost; else "" */
};

struct hawser_nnm {
	int n, curves, lost; /* lost: branch points from which no curve could be begun */
	int interrupted;     /* 1: progress.function asked for the end */
	double energy;       /* the largest, scaled */
	struct hawser_nnm_curve *curve;
};

/* Trace the curves. Release with hawser_nnm_clear. Errors as hawser_backbone_trace; what fails on a
 * branch is told by its message or counted. */
enum hawser_status hawser_nnm_trace(struct hawser_nnm *nnm, const struct hawser_rom *rom,
                                    const struct hawser_nnm_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_nnm_clear(struct hawser_nnm *nnm);

#ifdef __cplusplus
}
#endif
#endif
