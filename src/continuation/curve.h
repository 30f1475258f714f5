/* continuation/curve.h - pseudo-arclength continuation of a curve, whatever its equations are.
 *
 * A kind of curve (a branch of periodic orbits, a curve of folds, a backbone, a boundary of stability)
 * owns its points and its equations, and brings a table of operations. This folder owns the loop:
 *
 *   follow.c    from the first point to the end: step, arrive (bounds, closure, events, record), repeat
 *   step.c      one step: predict, correct, judge, and choose the length of the next
 *   metric.c    products, angles and polynomials through points and tangents in a weighted metric
 *   settings.c  the constants of each kind of curve, with the reason of each
 *
 * A step's length is changed nowhere else.
 *
 * Source: E. L. Allgower and K. Georg, Numerical Continuation Methods, Springer 1990, chapter 6.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTINUATION_CURVE_H
#define HAWSER_CONTINUATION_CURVE_H

#include <hawser/status.h>

/* What a correction did. */
struct hawser__correction {
	int iterations;
	double contraction; /* first ratio of successive steps; 0 when one step was enough */
	double residual;    /* largest defect at the end, relative to the point's size */
	double first;       /* length of the first step in the metric: the error of the prediction */
};

/* Constants of the control of steps (settings.c). Lengths are arclengths in the kind's metric. */
struct hawser__step_settings {
	double smallest;         /* a curve whose step would be shorter is lost */
	double after_failure;    /* factor of the step when the corrector has failed */
	double after_refusal;    /* factor of the step when its result is refused */
	double slowest, fastest; /* limits of the factor between successive steps */
	double goal_contraction; /* 0: not looked at */
	double goal_angle;       /* rad between successive tangents */
	double goal_distance;    /* of the prediction from the curve; 0: not looked at */
	int distance_order;      /* the prediction's error falls with this power of the step */
};

enum hawser__verdict {
	HAWSER__KEEP = 0, /* the step is good */
	HAWSER__SHORTEN,  /* make it again, shorter */
	HAWSER__REPEAT    /* make it again as it is: the equations have been refined */
};

enum hawser__arrival {
	HAWSER__GO_ON = 0, /* the new point is kept, and the curve goes on */
	HAWSER__AGAIN,     /* the new point is dropped; the kind has set the step's length */
	HAWSER__AT_END     /* the new point is kept, and is the last */
};

enum hawser__outcome {
	HAWSER__ENDED = 0,   /* an operation has ended the curve and knows why */
	HAWSER__INTERRUPTED, /* the caller asked for the end within a step */
	HAWSER__LOST         /* no step is short enough */
};

struct hawser__curve;

/* Operations of a kind of curve. `owner` is the kind's own structure. All but those marked are
 * required. A status other than HAWSER_OK ends the curve. */
struct hawser__curve_ops {
	/* Before a step: set the metric at the current point. *ended is set to 1 where there is no next
	 * step (as many points as allowed, an interruption). */
	enum hawser_status (*prepare)(void *owner, int *ended);
	/* Whether the caller asks for the end; `tries` steps have been tried from this point. Optional. */
	int (*interrupted)(void *owner, int tries);
	/* Put the next point at arclength ds beyond the current one. 1 where there is no such point. */
	int (*predict)(void *owner, double ds);
	/* Correct the next point in the plane through it and normal to the current tangent. *failed is set
	 * to 1 where that does not converge. */
	enum hawser_status (*correct)(void *owner, double ds, struct hawser__correction *correction,
	                              int *failed);
	/* After a failure: a finer discretisation, if there is one; *factor is what the step's length is
	 * multiplied by then, and 0 where there is none. Optional. */
	enum hawser_status (*refine)(void *owner, double ds, double *factor);
	/* Tangent and test functions of the corrected point; *angle to the current tangent, rad. */
	enum hawser_status (*finish)(void *owner, double ds, double *angle);
	/* Whether the step may be kept. */
	enum hawser_status (*judge)(void *owner, double ds, double angle, enum hawser__verdict *verdict);
	/* The longest step from the next point, given the one just made. */
	double (*longest)(void *owner);
	/* Move the next point to a bound or to the curve's beginning where the step passes one, locate
	 * the events of the step, record, and make the next point the current one. `taken` is the length
	 * of the step; *ds may be set with HAWSER__AGAIN. */
	enum hawser_status (*arrive)(void *owner, enum hawser__arrival *arrival, double taken, double *ds);
};

struct hawser__curve {
	const struct hawser__curve_ops *ops;
	const struct hawser__step_settings *settings;
	void *owner;
	double ds;                            /* length of the next step */
	struct hawser__correction correction; /* of the last try */
};

/* follow.c: from the current point to the end of the curve. */
enum hawser_status hawser__curve_follow(struct hawser__curve *curve, enum hawser__outcome *outcome);

/* step.c: the next point. *taken is the length of the step; 0 where there is none, and *outcome then
 * says why. */
enum hawser_status hawser__curve_step(struct hawser__curve *curve, double *taken,
                                      enum hawser__outcome *outcome);

/* settings.c: of a branch of periodic orbits, of a curve of folds, of a backbone, of a boundary of
 * stability of a beam, of a locus of an autonomous model, of invariant circles. */
extern const struct hawser__step_settings hawser__frf_steps;
extern const struct hawser__step_settings hawser__exact_steps;
extern const struct hawser__step_settings hawser__known_steps;
extern const struct hawser__step_settings hawser__folds_steps;
extern const struct hawser__step_settings hawser__backbone_steps;
extern const struct hawser__step_settings hawser__boundary_steps;
extern const struct hawser__step_settings hawser__own_steps;
extern const struct hawser__step_settings hawser__torus_steps;

#endif
