/* continuation/settings.c - the constants that control the steps, kind by kind.
 *
 * Goals are a tenth to a fifth of what makes a step fail, so that few are made twice. `make bench` and
 * bench/frf-auto.py show what they change: points, processor time and branches lost.
 *
 *   smallest          1e-9 of the orbit's size is ten times round-off of a corrected point at the
 *                     default tolerance; a shorter step cannot be told from no step
 *   after_failure     .4: a failed corrector says nothing of the length that it can do
 *   after_refusal     .5
 *   slowest, fastest  .4 to 1.8: a good step alone is no reason to double the next
 *   distance_order    2 nodes - 1 of the predictor, and one: 6 for three points and tangents, 2 for one
 *                     tangent
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "continuation/curve.h"

const struct hawser__step_settings hawser__frf_steps = {
	.smallest = 1e-9, .after_failure = 0.4, .after_refusal = 0.5, .slowest = 0.4, .fastest = 1.8,
	.goal_contraction = 0.05, .goal_angle = 0.2, .goal_distance = 1e-2, .distance_order = 6
};

/* Of large models (hawser__is_large) and of traces for their folds alone. A point with exact energy
 * costs twenty times that of a few coordinates. Between the points the quintic through them is as good
 * as they are. From predictions that are 1e-2 off, one correction in four fails in deep cables, where
 * pairs of high harmonics and modes resonate. */
const struct hawser__step_settings hawser__exact_steps = {
	.smallest = 1e-9, .after_failure = 0.4, .after_refusal = 0.5, .slowest = 0.4, .fastest = 1.8,
	.goal_contraction = 0.05, .goal_angle = 0.3, .goal_distance = 1e-3, .distance_order = 6
};

/* The same through orbits that are known (response/branch/orbits.c), which are .3 rad apart: every
 * second of them tells as much of the multipliers, and of peaks to 1e-4. */
const struct hawser__step_settings hawser__known_steps = {
	.smallest = 1e-9, .after_failure = 0.4, .after_refusal = 0.5, .slowest = 0.4, .fastest = 1.8,
	.goal_contraction = 0.05, .goal_angle = 0.7, .goal_distance = 1e-3, .distance_order = 6
};

/* Of curves of folds and of loci. A point costs several times that of a response: from predictions that
 * are 1e-3 off, two Newton steps are enough. */
const struct hawser__step_settings hawser__folds_steps = {
	.smallest = 1e-9, .after_failure = 0.5, .after_refusal = 0.5, .slowest = 0.4, .fastest = 1.8,
	.goal_contraction = 0.05, .goal_angle = 0.15, .goal_distance = 1e-3, .distance_order = 6
};

/* Backbones are smooth: the longest step, which a picture needs, is what limits them. */
const struct hawser__step_settings hawser__backbone_steps = {
	.smallest = 1e-7, .after_failure = 0.5, .after_refusal = 0.5, .slowest = 0.4, .fastest = 1.5,
	.goal_contraction = 0.05, .goal_angle = 0.2, .distance_order = 2
};

/* Lengths are parts of the parameter's range. */
const struct hawser__step_settings hawser__boundary_steps = {
	.smallest = 1e-4, .after_failure = 0.5, .after_refusal = 0.5, .slowest = 0.4, .fastest = 1.5,
	.goal_angle = 0.1, .distance_order = 2
};

/* Lengths are parts of the parameters' ranges; a chord, which lags behind, is taken for the tangent. */
const struct hawser__step_settings hawser__own_steps = {
	.smallest = 2e-7, .after_failure = 0.5, .after_refusal = 0.5, .slowest = 0.4, .fastest = 1.5,
	.goal_angle = 0.1, .distance_order = 2
};

/* A circle costs hundreds of orbits, and near resonances the corrector fails whatever the step is: a
 * shorter one than 1e-5 would only tell how narrow they are. Circles grow with the square root of Omega
 * from torus points, where the tangent turns fast. */
const struct hawser__step_settings hawser__torus_steps = {
	.smallest = 1e-5, .after_failure = 0.4, .after_refusal = 0.5, .slowest = 0.4, .fastest = 1.8,
	.goal_contraction = 0.05, .goal_angle = 0.2, .distance_order = 2
};
