/* hawser/torus.h - quasi-periodic responses: invariant circles of the map over a period of the load,
 * which begin at the torus (Neimark-Sacker) points of a frequency response.
 *
 * With such a motion the amplitude changes from period to period: the displacement has the frequency
 * of the load and a second one. The members *_least and *_most are the least and the greatest, over
 * the torus, of the largest value in a period of the load that begins at its phase 0; at a torus point
 * both are the amplitude of the periodic motion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TORUS_H
#define HAWSER_TORUS_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_tori_end {
	HAWSER_TORI_RANGE = 0,   /* Omega left its range */
	HAWSER_TORI_TORUS_POINT, /* the circle shrinks to a periodic motion: `to` */
	HAWSER_TORI_MAX_POINTS,
	HAWSER_TORI_INTERRUPTED, /* progress.function asked for it */
	HAWSER_TORI_SLACK,       /* the next motion would make the cable slack (end_at_slack) */
	HAWSER_TORI_ROUGH,       /* the circle needs more than the largest number of points: it loses its
	                          * smoothness; `lost` says more */
	HAWSER_TORI_LOST         /* no circle is found beyond; `lost` says more */
};
/* "range", "torus-point", "max-points", "interrupted", "slack", "rough", "lost" */
const char *hawser_tori_end_name(enum hawser_tori_end end);

struct hawser_tori_point {
	double omega;        /* scaled */
	double parameter;    /* of options->family; omega without a family */
	double rotation;     /* rotation number: rad per period of the load, up to its sign and multiples
	                      * of 2 pi */
	double second;       /* scaled second frequency: rotation*omega/(2 pi) */
	double growth;       /* largest logarithm of growth per period of what is not along the circle;
	                      * negative: the circle attracts */
	double growth_error; /* estimated error of it */
	int unstable;        /* number of such logarithms above their error */
	int undecided;       /* number of those that are nearer to zero than their error: whether they are
	                      * unstable is not known; where both numbers are 0 the circle is stable */
	double arc;          /* arclength along the curve, in the metric of the continuation */
	double size;         /* of the circle: root mean square distance from its mean, scaled */
	double residual;     /* certificate: largest defect at the points of the circle, relative to the
	                      * largest state */
	double error;        /* certificate: the same between the points, with half the length of steps */
	double tail;         /* certificate: last coefficients of the circle over the largest */
	int circle;          /* points of the circle */
	int steps;           /* of integration per period */
	int iterations;      /* of the corrector */
};

struct hawser_tori {
	int n, probes;              /* coordinates, points of the cable */
	int points, capacity;
	double length, time;        /* units of the model */
	struct hawser_tori_point *point; /* [points] */
	double *coordinate_least;   /* [points][n] scaled */
	double *coordinate_most;    /* [points][n] */
	double *probe_least;        /* [points][probes][3] scaled */
	double *probe_most;         /* [points][probes][3] */
	double *tension;            /* [points][2] smallest and largest tension on the torus, N (SI),
	                             * anywhere on the cable; NULL if the model has no tensions */
	double *state;              /* [points][2n] a point of the circle: u then du/dt at the start of a
	                             * period, scaled */
	int curve;                  /* 1; a caller that follows several may number them */
	int branch;                 /* number of the branch of the response */
	int from;                   /* index of the event at which the curve begins, in that branch */
	int to;                     /* the same of the event at which it ends, or -1 */
	double from_at;             /* its Omega, scaled, or its parameter */
	double to_at;               /* the same, extrapolated if `to` is -1; NAN: it ends otherwise */
	enum hawser_tori_end end;
	char lost[sizeof ((struct hawser_report *)0)->message]; /* why, or "" */
};

struct hawser_tori_options {
	const struct hawser_rom_family *family; /* NULL, or that of the response: the tori are followed in
	                        * its parameter */
	double from, to;       /* scaled Omega, or the parameter: the range */
	double tolerance;      /* of `error`; 0: 1e-6 */
	double step_max;       /* largest change of Omega in a step, relative to the range; 0: 0.02 */
	int max_points;        /* of the curve; 0: 2000 */
	int most_circle;       /* largest number of points of a circle; 0: 127; at most 2400 numbers */
	int end_at_slack;      /* 1: end the curve where the least tension becomes negative */
	struct hawser_progress progress; /* called after each circle */
};
void hawser_tori_settle(struct hawser_tori_options *options);

/* Follow the invariant circles that begin at event `event` of `frf`, a torus point that was located.
 * Release with hawser_tori_clear, whatever the status. HAWSER_ERR_ARGUMENT (another event, options; a
 * model without damping, of first order, with a history; a branch of several periods of the load),
 * HAWSER_ERR_CONVERGENCE (no first circle), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_tori_trace(struct hawser_tori *tori, const struct hawser_rom *rom,
                                     const struct hawser_frf *frf, int event,
                                     const struct hawser_tori_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_tori_clear(struct hawser_tori *tori);

#ifdef __cplusplus
}
#endif
#endif
