/* hawser/frf.h - the frequency response of a reduced model: a branch of forced periodic orbits,
 * followed in Omega by pseudo-arclength continuation, with Floquet stability, located events, and a
 * certificate at every point. The orbits come from one of the methods of a table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_FRF_H
#define HAWSER_FRF_H

#include <hawser/orbit.h>
#include <hawser/progress.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_event_kind {
	HAWSER_FOLD = 0,
	HAWSER_PERIOD_DOUBLING,
	HAWSER_TORUS,
	HAWSER_BRANCH_POINT,
	HAWSER_UNEXPLAINED /* the count of unstable multipliers changes, and no event was located that
	                    * explains it */
};
/* "fold", "period-doubling", "torus", "branch-point", "unexplained" */
const char *hawser_event_name(enum hawser_event_kind kind);

enum hawser_frf_end {
	HAWSER_END_RANGE = 0,   /* Omega left [from, to], at the end opposite to where it began */
	HAWSER_END_RETURNED,    /* Omega left [from, to] where the branch had entered it */
	HAWSER_END_CLOSED,      /* the curve came back to its start */
	HAWSER_END_MAX_POINTS,
	HAWSER_END_INTERRUPTED, /* progress.function asked for it */
	HAWSER_END_FAILED,      /* the status is not HAWSER_OK; the report says why and where */
	HAWSER_END_AT_REST      /* the motion shrinks to rest, at the branch point that is the last event */
};
const char *hawser_frf_end_name(enum hawser_frf_end end);

struct hawser_frf_point {
	double omega;     /* scaled */
	double arc;       /* arclength along the branch, in the continuation's own metric */
	int unstable;     /* multipliers outside the unit circle; stable when 0 */
	int undecided;    /* multipliers nearer to the unit circle than their error: those of an undamped
	                   * model. They may be on either side and are not in `unstable` */
	int direction;    /* in which Omega changes along the branch there: 1 or -1 */
	double residual;  /* certificate: largest defect of a shooting segment after the final
	                   * correction, relative to |x| */
	double mesh;      /* certificate: estimated integration error of the orbit, relative to |x| */
	double error;     /* certificate: estimated distance from the true branch, relative to |x|:
	                   * shooting: residual and mesh error times the norm of the inverse Jacobian;
	                   * harmonic balance: one more correction by what is missing */
	double liouville; /* certificate: |sum log|mu| + T tr D|  */
	int iterations;   /* corrector iterations this point took */
	int steps;        /* Runge-Kutta steps a period; harmonic balance: coefficients a coordinate */
};

struct hawser_frf_event {
	enum hawser_event_kind kind;
	double omega;    /* scaled, located by bracketing; unexplained: the middle of the bracket */
	double arc;
	double residual; /* |test function| at the located point, relative to its bracket ends */
	double error;    /* estimated relative error of omega; unexplained: half the bracket's width */
	int suspected;   /* the count of unstable multipliers does not confirm it */
	int located;     /* 1; 0 where it is unexplained or `error` exceeds 0.01 */
	int after;       /* index of the last point before the event */
	double bracket[2]; /* scaled Omega of the orbits between which it lies, along the curve */
	int unstable[2]; /* multipliers outside the unit circle at these two orbits */
};

struct hawser_frf {
	int n;                          /* coordinates */
	int points, capacity;
	int undecided;                  /* points with undecided multipliers */
	struct hawser_frf_point *point; /* [points] */
	double *coordinate;             /* [points][n] max over the period of |u_j|, scaled */
	double *probe;                  /* [points][shape points][3] max |x|, |y|, |z|, scaled */
	double *tension;                /* [points][2] least and greatest tension over the period, N (SI),
	                                 * anywhere on the cable (the places of hawser_rom_tensions);
	                                 * NULL where the model tells none */
	double *multiplier;             /* [points][2n][2] log modulus, argument */
	double *state;                  /* [points][2n] u then du/dt at tau = 0, scaled */
	int probes;
	int events, event_capacity;
	struct hawser_frf_event *event; /* [events] in order along the branch */
	enum hawser_frf_end end;
	const char *method;             /* the method used, a static string */
	/* where the method is not shooting: points computed again by shooting (stiff models: integrated
	 * over a period), how far they then were off relative to the state at phase 0, and at how
	 * many of them the number of unstable multipliers is another */
	int sampled;
	double sample_gap;
	int sample_disagreements;
	struct hawser_orbit_cost cost;
};

/* A method for periodic orbits: its name, one line about it, its source. */
struct hawser_frf_method {
	const char *name, *summary, *source;
	int approximate; /* its orbits are the model's to an order of their size only, and its certificate
	                  * is about its own equations */
};
/* Row `index` of the table, from 0; NULL beyond the last. Static storage. */
const struct hawser_frf_method *hawser_frf_method(int index);

struct hawser_resonance; /* scales.h */

struct hawser_frf_options {
	const char *method;    /* name of a method; NULL or "auto": the one that suits the model */
	double from, to;       /* scaled Omega, from != to: the range, and the first direction */
	double begin;          /* scaled Omega of the first orbit, in the range; 0: from */
	int direction;         /* in which Omega changes at first, 1 or -1; 0: towards `to`. With begin and
	                        * start from a point of another trace, that one is continued */
	double tolerance;      /* of an orbit's defect and of its integration error, each relative to
	                        * the orbit's size; a point's `error` may be larger; 0: 1e-9 */
	double event_tolerance; /* relative, in Omega; 0: 1e-10 */
	int segments;          /* shooting: segments; 0: chosen from the growth of the flow */
	int max_points;        /* 0: 20000 */
	double step_max;       /* largest change of Omega in a step, of the range; 0: 0.02 */
	int skip_events;       /* 1: do not locate events */
	int samples;           /* points to compute again by another method; 0: 5; or HAWSER_NONE */
	const struct hawser_resonance *resonance; /* multiple scales: which modes are resonant; NULL:
	                        * hawser_resonance_find */
	const double *start;   /* [2n] guess of the state at the first orbit, phase 0, u then du/dt;
	                        * NULL: the linear response */
	struct hawser_progress progress; /* called after each point, with `frf` */
};

void hawser_frf_settle(struct hawser_frf_options *options);

/* Trace the branch. On HAWSER_ERR_CONVERGENCE with at least one point, *frf still holds what was
 * traced and frf->end is HAWSER_END_FAILED. Release with hawser_frf_clear. Other statuses:
 * HAWSER_ERR_ARGUMENT (range, model without forcing), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_frf_trace(struct hawser_frf *frf, const struct hawser_rom *rom,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_frf_clear(struct hawser_frf *frf);

/* A cheap sweep by settled time integration at `count` frequencies from `from` to `to`, each
 * started from where the last one ended: shows the jumps. Arrays as in hawser_frf; every point's
 * residual is the distance between two successive periods at the end of settling. */
struct hawser_sweep_options {
	double from, to;  /* scaled Omega; to < from sweeps down */
	int count;
	double settle;    /* relative change over a period that counts as settled; 0: 1e-6 */
	int max_periods;  /* 0: 2000 */
	struct hawser_progress progress; /* called before each frequency */
};
void hawser_sweep_settle(struct hawser_sweep_options *options);

struct hawser_sweep {
	int n, points, probes;
	double *omega;      /* [points] scaled */
	double *coordinate; /* [points][n] */
	double *probe;      /* [points][probes][3] */
	double *residual;   /* [points] */
	int interrupted;
};
enum hawser_status hawser_sweep_run(struct hawser_sweep *sweep, const struct hawser_rom *rom,
                                    const struct hawser_sweep_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_sweep_clear(struct hawser_sweep *sweep);

#ifdef __cplusplus
}
#endif
#endif
