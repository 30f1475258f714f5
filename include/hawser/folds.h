/* hawser/folds.h - folds of the frequency response, followed in two parameters: the forcing frequency
 * and the load. The curves of folds show the load at which jumps begin and the load at which isolas
 * (closed response curves) detach from the main curve.
 *
 * The load factor multiplies all harmonics of the model, both loads and parametric terms. The factor 1
 * is the nominal load, that is the load of the model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_FOLDS_H
#define HAWSER_FOLDS_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Kinds of events on a fold curve. Golubitsky and Schaeffer, Singularities and Groups in Bifurcation
 * Theory I (1985), chapter IV, with Omega as the parameter, call the last three hysteresis, isola
 * centre and simple bifurcation. */
enum hawser_folds_kind {
	HAWSER_FOLDS_NOMINAL = 0,  /* the curve crosses the nominal load: a fold of the nominal response */
	HAWSER_FOLDS_CUSP,         /* two folds merge and vanish: jumps begin */
	HAWSER_FOLDS_ISOLA,        /* a closed response curve shrinks to a point and vanishes */
	HAWSER_FOLDS_BIFURCATION   /* two response curves meet and exchange their branches */
};
const char *hawser_folds_kind_name(enum hawser_folds_kind kind); /* "nominal", "cusp", ... */

enum hawser_folds_end {
	HAWSER_FOLDS_OMEGA = 0,   /* Omega left its range */
	HAWSER_FOLDS_LOAD,        /* the load left its range */
	HAWSER_FOLDS_CLOSED,      /* the curve returned to its start */
	HAWSER_FOLDS_MAX_POINTS,  /* the curve has max_points points */
	HAWSER_FOLDS_INTERRUPTED, /* progress.function asked for it */
	HAWSER_FOLDS_FAILED,      /* the corrector failed; the curve's message says where */
	HAWSER_FOLDS_WORK         /* the search took `most_work` */
};
const char *hawser_folds_end_name(enum hawser_folds_end end);

/* The kind of the least load, that is of the smallest load at which the response has a fold in the
 * range of Omega. */
enum hawser_folds_least_kind {
	HAWSER_FOLDS_LEAST_CUSP = 0,
	HAWSER_FOLDS_LEAST_ISOLA,
	HAWSER_FOLDS_LEAST_BIFURCATION,
	HAWSER_FOLDS_LEAST_OMEGA, /* a fold enters the range of Omega through one of its ends */
	HAWSER_FOLDS_LEAST_LOAD,  /* load_from: the response has folds at this load already */
	HAWSER_FOLDS_LEAST_BOUND  /* an upper bound: the search below it could not be completed */
};
const char *hawser_folds_least_name(enum hawser_folds_least_kind kind); /* "cusp", ..., "bound" */

struct hawser_folds_point {
	double omega, load; /* scaled frequency; load factor */
	double arc;         /* arclength from the start of the curve, in the metric of the continuation */
	double residual;    /* largest defect after the final correction, relative to the orbit */
	double mesh;        /* estimated truncation error of the Fourier series, relative to the orbit */
	int iterations;     /* number of corrector iterations */
	int harmonics;      /* number of harmonics of the Fourier series */
};

struct hawser_folds_event {
	enum hawser_folds_kind kind;
	double omega, load, arc;
	double residual; /* |test function| at the located point, relative to its values at the ends of
	                  * the bracket */
	int minimum;     /* 1: the load has a minimum along the curve here, -1: a maximum, 0: neither */
	int after;       /* index, among all points, of the last point before the event */
};

struct hawser_folds_curve {
	int first, points;       /* index of the first point of the curve, and number of its points */
	int first_event, events; /* index of the first event of the curve, and number of its events */
	enum hawser_folds_end end[2]; /* [2] at its first and its last point */
	double least_omega, least_load; /* the point with the smallest load on the curve */
	int least_event;         /* index of the event at that point; -1: the point is an end */
	char message[240];       /* why the curve failed, or which event was not located, or "" */
};

/* The responses at one load that were searched for folds, traced from both ends of the range. */
struct hawser_folds_level {
	double load;     /* load factor */
	double from, to; /* scaled Omega: the range; at loads below the least load known so far, a wider
	                  * window */
	int folds;       /* number of folds of the responses */
};

/* A fold of a response through which no curve could be traced. */
struct hawser_folds_lost {
	double omega, load;
};

/* The search for detached curves from pseudo-random motions. */
struct hawser_folds_starts {
	int starts, frequencies; /* number of motions, at so many frequencies equally spaced in the range */
	int known;    /* of them: that settled on a known curve, */
	int lost;     /* that led to no orbit */
	int fresh;    /* number of curves found by them, which are among the isolas */
	int attached; /* number of curves found that begin at a branch point of a known one; not among the
	               * isolas */
};

struct hawser_folds {
	int n, probes;
	int points;
	struct hawser_folds_point *point; /* [points] curve after curve */
	double *coordinate;               /* [points][n] max over the period of |u_j|, scaled */
	double *probe;                    /* [points][probes][3] max |x|, |y|, |z|, scaled */
	double *state;                    /* [points][2n] u then du/dt at tau = 0, scaled */
	int curves;
	struct hawser_folds_curve *curve; /* [curves] */
	int events;
	struct hawser_folds_event *event; /* [events] curve after curve, in order along it */
	double *event_state;              /* [events][2n] */
	double least_load, least_omega;   /* the least load with a fold in the range, and Omega of this
	                                   * fold; INFINITY if no fold was found */
	enum hawser_folds_least_kind least_kind;
	int levels;
	struct hawser_folds_level *level; /* [levels] loads at which responses were searched for folds, in
	                                   * the order of the search: nominal, load_to, falling loads */
	int searched;                     /* 1: at all loads examined below least_load, the responses
	                                   * were traced to their ends */
	int nearly_linear;                /* 1: the search ended at a nearly linear response. Its
	                                   * multipliers differ from those of the linear model by at most
	                                   * half of the distance of the latter from the unit circle, and
	                                   * its states from the linear response by at most half of the
	                                   * largest state of the linear response. 0: the search ended at
	                                   * load_from */
	struct hawser_frf response;       /* at the nominal load, traced from `from` */
	int isolas;
	struct hawser_frf *isola;         /* [isolas] curves at the nominal load that are not parts of
	                                   * `response`, such as one that begins at `to`; an isola has
	                                   * the end HAWSER_END_CLOSED */
	int lost;                         /* number of folds of the responses through which no curve of
	                                   * folds could be traced, and of folds on detached response
	                                   * curves that could not be traced */
	struct hawser_folds_lost *lost_at; /* [lost] */
	struct hawser_folds_starts starts;
	int interrupted;
	int costly;                       /* 1: it ended at options->most_work */
	char note[240];                   /* which parts of the search are incomplete, or "" */
	long solves;                      /* number of linear systems factorised */
};

struct hawser_folds_options {
	double from, to;           /* scaled Omega: range of responses and curves */
	double load_from, load_to; /* load factors: range of the curves; 0: 0.01 and 2 */
	double tolerance;          /* of the defect and of the truncation error, each relative to the
	                            * orbit; 0: 1e-9 */
	double event_tolerance;    /* relative, in arclength; 0: 1e-10 */
	int max_points;            /* of a curve in each direction, and of a response; 0: 5000. If a
	                            * response reaches this number, `note` says so */
	double step_max;           /* largest change of Omega in a step, relative to the range; 0: 0.02 */
	int most_unstable;         /* end a response at another load than the nominal one at the first point
	                            * with more unstable multipliers: `note` says so; 0: no limit */
	double most_work;          /* of all responses and curves, s (hawser_orbit_work): they end there,
	                            * and the search is `costly`; 0: no limit */
	int skip_isolas;           /* 1: do not trace detached curves at the nominal load */
	int starts;                /* number of pseudo-random motions from which detached curves are looked
	                            * for as well; 0: 96, or fewer where they take long; or HAWSER_NONE */
	const struct hawser_frf_options *first; /* NULL, or where the response at the nominal load begins:
	                            * its start, along and begin. It is followed to both sides, and no
	                            * others are searched for folds */
	const char *method;        /* of the responses (hawser_frf_options); NULL: "balance", whose
	                            * orbits at folds start the curves without conversion; "auto": the
	                            * method that suits the model */
	struct hawser_progress progress; /* called after each point of a response or of a curve */
};
void hawser_folds_settle(struct hawser_folds_options *options);

/* Trace the fold curves through every fold of the responses at the nominal load; if this load is below
 * load_to, also at load_to; then at falling loads below the least load found, until the response is
 * nearly linear or the load is load_from. Each response is traced from both ends of the range. Then
 * trace the detached curves at the nominal load. If a fold curve leaves the range and returns, each
 * part within the range is a curve of its own. If a curve fails, it ends at its last point with a
 * message, and the others are traced. Release with hawser_folds_clear. Statuses:
 * HAWSER_ERR_NO_SOLUTION (no fold at these loads), HAWSER_ERR_ARGUMENT (a range, a tolerance, a model
 * without forcing), HAWSER_ERR_CONVERGENCE (the response at the nominal load could not be traced, or
 * reached max_points before any fold, or no curve could be started), HAWSER_ERR_NAN,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_folds_trace(struct hawser_folds *folds, const struct hawser_rom *rom,
                                      const struct hawser_folds_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_folds_clear(struct hawser_folds *folds);

#ifdef __cplusplus
}
#endif
#endif
