/* hawser/folds.h - folds of the frequency response followed in two parameters, the forcing frequency
 * and the load: where jumps begin, and where curves detach from the main one.
 *
 * All harmonics of the model (loads and parametric terms) are multiplied by the load factor; 1 is
 * the load of the model, the nominal one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_FOLDS_H
#define HAWSER_FOLDS_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What is special about a point of a fold curve. In the terms of Golubitsky and Schaeffer,
 * Singularities and Groups in Bifurcation Theory I (1985), chapter IV, with Omega as the parameter:
 * hysteresis, isola centre, simple bifurcation. */
enum hawser_folds_kind {
	HAWSER_FOLDS_NOMINAL = 0,  /* the curve passes the nominal load: a fold of its response */
	HAWSER_FOLDS_CUSP,         /* two folds merge and vanish: jumps begin */
	HAWSER_FOLDS_ISOLA,        /* a closed response curve shrinks to a point and vanishes */
	HAWSER_FOLDS_BIFURCATION   /* two response curves meet and exchange their branches */
};
const char *hawser_folds_kind_name(enum hawser_folds_kind kind); /* "nominal", "cusp", ... */

enum hawser_folds_end {
	HAWSER_FOLDS_OMEGA = 0,   /* Omega left its range */
	HAWSER_FOLDS_LOAD,        /* the load left its range */
	HAWSER_FOLDS_CLOSED,      /* the curve came back to its start */
	HAWSER_FOLDS_MAX_POINTS,
	HAWSER_FOLDS_INTERRUPTED, /* progress.function asked for it */
	HAWSER_FOLDS_FAILED       /* the corrector failed; the curve's message says where */
};
const char *hawser_folds_end_name(enum hawser_folds_end end);

/* What the least load is at which the response has a fold in the range of Omega. */
enum hawser_folds_least_kind {
	HAWSER_FOLDS_LEAST_CUSP = 0,
	HAWSER_FOLDS_LEAST_ISOLA,
	HAWSER_FOLDS_LEAST_BIFURCATION,
	HAWSER_FOLDS_LEAST_OMEGA, /* there a fold enters the range of Omega through one of its ends */
	HAWSER_FOLDS_LEAST_LOAD,  /* load_from: there are folds at that load already */
	HAWSER_FOLDS_LEAST_BOUND  /* an upper bound: the search below it could not be completed */
};
const char *hawser_folds_least_name(enum hawser_folds_least_kind kind); /* "cusp", ..., "bound" */

struct hawser_folds_point {
	double omega, load; /* scaled frequency; load factor */
	double arc;         /* along the curve, from its start, in the continuation's own metric */
	double residual;    /* largest defect after the final correction, relative to the orbit */
	double mesh;        /* estimated error of the truncated Fourier series, relative to it */
	int iterations, harmonics;
};

struct hawser_folds_event {
	enum hawser_folds_kind kind;
	double omega, load, arc;
	double residual; /* |test function| at the located point, relative to its bracket ends */
	int minimum;     /* load smallest here along the curve: 1, largest: -1; 0 at a passage */
	int after;       /* index of the point before it, of all points */
};

struct hawser_folds_curve {
	int first, points;       /* its part of the points */
	int first_event, events; /* and of the events */
	enum hawser_folds_end end[2]; /* [2] at its first and its last point */
	double least_omega, least_load; /* smallest load on the curve */
	int least_event;         /* the event that it is, or -1: an end of the curve */
	char message[240];       /* why it failed, or what was not located, or "" */
};

/* Responses that were searched for folds, from both ends of the range. */
struct hawser_folds_level {
	double load;     /* load factor */
	double from, to; /* scaled Omega: the range, or somewhat more at loads below the least */
	int folds;       /* that they have */
};

/* A fold that no curve was found from. */
struct hawser_folds_lost {
	double omega, load;
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
	double least_load, least_omega;   /* the least load with a fold in the range, and where; INFINITY
	                                   * where none was found */
	enum hawser_folds_least_kind least_kind;
	int levels;
	struct hawser_folds_level *level; /* [levels] responses searched for folds, in the order of the
	                                   * search: the nominal load, load_to, then falling ones */
	int searched;                     /* 1: the responses at all loads looked at below least_load
	                                   * were traced to their ends */
	int nearly_linear;                /* 1: the search ended at a response with multipliers that are
	                                   * off the linear model's by less than half of their distance
	                                   * from a fold, and states off the linear response's by at
	                                   * most half of the largest; 0: at load_from */
	struct hawser_frf response;       /* at the nominal load, from `from` */
	int isolas;
	struct hawser_frf *isola;         /* [isolas] curves at the nominal load that the response did
	                                   * not visit, the one from `to` among them; end
	                                   * HAWSER_END_CLOSED where it is an isola */
	int lost;                         /* folds of the response from which no curve was found, and
	                                   * folds on detached curves that could not be traced */
	struct hawser_folds_lost *lost_at; /* [lost] */
	int interrupted;
	char note[240];                   /* what could not be looked at, or "" */
	long solves;                      /* linear systems factorised */
};

struct hawser_folds_options {
	double from, to;           /* scaled Omega: range of responses and curves */
	double load_from, load_to; /* load factors: range of the curves; 0: 0.01 and 2 */
	double tolerance;          /* of the defect and of the truncation, relative to the orbit;
	                            * 0: 1e-9 */
	double event_tolerance;    /* relative, in arclength; 0: 1e-10 */
	int max_points;            /* of a curve each way, and of a response; 0: 5000. What a response
	                            * lacks for it, the note says */
	double step_max;           /* largest change of Omega in a step, of the range; 0: 0.02 */
	int skip_isolas;           /* 1: do not trace detached curves at the nominal load */
	const char *method;        /* of the responses (hawser_frf_options); NULL: "balance", whose
	                            * orbits at the folds are starts as they are; "auto": the one that
	                            * suits the model */
	struct hawser_progress progress; /* called after each point of a response or of a curve */
};
void hawser_folds_settle(struct hawser_folds_options *options);

/* Trace the fold curves through every fold of the responses at the nominal load and, if that lies below
 * load_to, at load_to; then at falling loads below the least load found, until the response is nearly
 * linear or the load is load_from; each from both ends of the range. Then trace the detached curves. A
 * curve that leaves the range and returns is one curve a part within it.
 * HAWSER_ERR_NO_SOLUTION: no fold at these loads.
 * HAWSER_ERR_ARGUMENT: a range, a tolerance, a model without forcing. HAWSER_ERR_CONVERGENCE: the
 * response at the nominal load could not be traced, or ended at max_points before any fold, or no
 * curve could be begun. HAWSER_ERR_NAN,
 * HAWSER_ERR_MEMORY. A curve that fails ends there and says so; the others are traced. Release with
 * hawser_folds_clear. */
enum hawser_status hawser_folds_trace(struct hawser_folds *folds, const struct hawser_rom *rom,
                                      const struct hawser_folds_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_folds_clear(struct hawser_folds *folds);

#ifdef __cplusplus
}
#endif
#endif
