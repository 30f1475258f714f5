/* hawser/frf.h - the frequency response of a reduced model: a branch of forced periodic orbits,
 * followed in Omega by pseudo-arclength continuation, with Floquet stability, located events, and a
 * certificate at every point. A table has the methods that compute the orbits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_FRF_H
#define HAWSER_FRF_H

#include <hawser/family.h>
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
	HAWSER_UNEXPLAINED, /* the number of unstable multipliers changes, and no located event explains
	                     * it */
	HAWSER_SLACK,       /* the least tension becomes zero (end_at_slack) */
	HAWSER_RESONANCE,   /* the motion lags its load by 90 degrees: only in locus.h */
	HAWSER_HOPF         /* a pair of eigenvalues of an equilibrium crosses the imaginary axis: limit
	                     * cycles begin or end there */
};
/* "fold", "period-doubling", "torus", "branch-point", "unexplained", "slack", "resonance", "hopf" */
const char *hawser_event_name(enum hawser_event_kind kind);

enum hawser_frf_end {
	HAWSER_END_RANGE = 0,   /* Omega left [from, to], but not where the branch began */
	HAWSER_END_RETURNED,    /* Omega left [from, to] at `from`, where the branch began */
	HAWSER_END_CLOSED,      /* the curve returned to its start */
	HAWSER_END_MAX_POINTS,
	HAWSER_END_INTERRUPTED, /* progress.function asked for it */
	HAWSER_END_FAILED,      /* the status is not HAWSER_OK; the report says why and where */
	HAWSER_END_AT_REST,     /* the motion vanishes at the branch point that is the last event */
	HAWSER_END_SLACK,       /* the cable goes slack at the last event, or is slack at the first orbit */
	HAWSER_END_UNSTABLE,    /* the last point has more unstable multipliers than `most_unstable` */
	HAWSER_END_LOST,        /* unstable motions, and the next one is not found within the limits of the
	                         * method; `lost` says why */
	HAWSER_END_MEETS,       /* a branch of branches.h meets another one, in the last event: what follows
	                         * is its own image, shifted in time or reflected */
	HAWSER_END_WORK,        /* it took `most_work` */
	HAWSER_END_HOPF,        /* cycles shrink to the Hopf point that is the last event */
	HAWSER_END_HOMOCLINIC   /* cycles whose period grows without a limit */
};
const char *hawser_frf_end_name(enum hawser_frf_end end);

struct hawser_frf_point {
	double omega;     /* scaled */
	double parameter; /* of options->family; omega without a family */
	double arc;       /* arclength along the branch, in the metric of the continuation */
	int unstable;     /* number of multipliers outside the unit circle; 0: stable */
	int undecided;    /* number of multipliers that are nearer to the unit circle than their error,
	                   * as those of an undamped model are. Whether they are unstable is not known,
	                   * and `unstable` excludes them */
	int direction;    /* 1: the parameter increases along the branch at this point, -1: it decreases */
	double residual;  /* certificate: largest defect after the final correction, relative to |x|; of
	                   * shooting, the largest defect of a segment */
	double mesh;      /* certificate: estimated integration or truncation error of the orbit,
	                   * relative to |x| */
	double error;     /* certificate: estimated distance from the exact branch, relative to |x|.
	                   * Shooting: sum of residual and mesh times the norm of the inverse Jacobian;
	                   * harmonic balance: the Newton correction for the truncated terms */
	double liouville; /* certificate: |sum log|mu| + T tr D|  */
	int iterations;   /* number of corrector iterations */
	int steps;        /* Runge-Kutta steps per period; harmonic balance: number of coefficients per
	                   * coordinate */
	int label;        /* hawser_frf_label; 0: none */
	double contact;   /* smallest angle of contact on a sheave over the period, relative to that at rest
	                   * (hawser_rom_contacts): below 0 the rope leaves it; INFINITY: no sheaves */
	int sheave;       /* on which: index in rom->contacts; -1: none */
};

/* The normal form of a Hopf point. */
struct hawser_hopf {
	double omega;   /* frequency, scaled */
	double l1;      /* first Lyapunov coefficient (Kuznetsov), in the norm of the state (u, u'); of
	                 * equations of first order, of u: below 0, the cycles are stable where the
	                 * equilibrium is not (supercritical). NAN: not known; 0: round-off, terms of
	                 * higher order decide */
	double growth;  /* derivative of the growth rate by the parameter */
	double swing;   /* derivative of the square of the cycles' amplitude by the parameter, of the
	                 * coordinate that moves most; NAN where l1 is 0 */
	int coordinate; /* that coordinate */
	int turning;    /* 1: of two pairs together in a model that may be rotated, the cycles that are
	                 * rotations, while those of the other point swing in one direction */
};

struct hawser_frf_event {
	enum hawser_event_kind kind;
	double omega;    /* scaled, located by bracketing; of an unexplained event the middle of the
	                  * bracket */
	double parameter; /* the same of options->family, to which `error` and `bracket` then refer; omega
	                  * without a family */
	double arc;
	double residual; /* |test function| at the located point, relative to its values at the ends of
	                  * the bracket */
	double error;    /* estimated relative error of omega; of an unexplained event half the width of
	                  * the bracket */
	int suspected;   /* 1: the number of unstable multipliers does not confirm the event */
	int located;     /* 1; 0 if the event is unexplained or `error` exceeds 0.01 */
	int after;       /* index of the last point before the event */
	double bracket[2]; /* scaled Omega of the two orbits that bracket the event, in the order of the
	                    * curve */
	int unstable[2]; /* multipliers outside the unit circle at these two orbits */
	int label;       /* hawser_frf_label; 0: none */
	struct hawser_hopf hopf; /* of such a point */
	int turns;       /* 1: a branch point at which the parameter turns, as on a branch that meets
	                  * another one */
};

struct hawser__orbits;

struct hawser_frf {
	int n;                          /* coordinates */
	int points, capacity;
	double length, time;            /* units of the model that was given, in which all scaled members
	                                 * are, those of a family too */
	int undecided;                  /* number of points with undecided multipliers */
	struct hawser_frf_point *point; /* [points] */
	double *coordinate;             /* [points][n] max over the period of |u_j|, scaled */
	double *probe;                  /* [points][shape points][3] max |x|, |y|, |z|, scaled */
	double *swing;                  /* [points][n] half of the largest less the smallest u_j over the
	                                 * period, of equilibria and cycles, scaled; else NULL */
	double *trivial;                /* [points] of a cycle, distance from 1 of its multiplier that is 1,
	                                 * as computed; NULL with `swing` */
	double *tension;                /* [points][2] smallest and largest tension over the period, N
	                                 * (SI), anywhere on the cable (at the points of
	                                 * hawser_rom_tensions); NULL if the model has no tensions */
	double *multiplier;             /* [points][2n][2] log modulus, argument; of equilibria growth
	                                 * rate, frequency (of the first model's time); NAN: none */
	double *state;                  /* [points][2n] u then du/dt at tau = 0, scaled */
	int probes;
	int period;                     /* number of periods of the load in one of the motion: 1, or more
	                                 * on a branch of branches.h */
	int parent;                     /* the branch from an event of which this one begins; 0: none */
	double born, born_at;           /* scaled Omega of that event, and its parameter */
	int branch;                     /* 1; hawser_cover_trace numbers further branches from 2 */
	int events, event_capacity;
	struct hawser_frf_event *event; /* [events] in order along the branch */
	double *event_state;            /* [events][2n] u then du/dt at tau = 0 of their orbits, scaled; NAN
	                                 * for an unexplained event, which has none. At a branch point it
	                                 * may be interpolated */
	enum hawser_frf_end end;
	char lost[sizeof ((struct hawser_report *)0)->message]; /* HAWSER_END_LOST: why; else "" */
	const char *method;             /* the method used, a static string */
	/* If the method is not shooting: number of points computed again by shooting (of stiff models,
	 * by integration over a period); their largest difference relative to the state at phase 0; and
	 * the number of them with a different number of unstable multipliers */
	int sampled;
	double sample_gap;
	int sample_disagreements;
	struct hawser_orbit_cost cost;
	struct hawser__orbits *back;    /* internal: orbits of the curve from the other end of the range, if
	                                 * it was followed there before; or NULL */
};

/* A method for periodic orbits: its name, a summary of one line, its source. */
struct hawser_frf_method {
	const char *name, *summary, *source;
	int approximate; /* 1: its orbits satisfy the equations of the model only to a certain order in
	                  * their amplitude, and its certificate refers to its own equations */
};
/* Row `index` of the table, from 0; NULL beyond the last. Static storage. */
const struct hawser_frf_method *hawser_frf_method(int index);

struct hawser_resonance; /* scales.h */

struct hawser_frf_options {
	const char *method;    /* name of a method; NULL or "auto": the method that suits the model */
	const struct hawser_rom_family *family; /* NULL: the parameter is Omega. Otherwise the branch is
	                        * followed in the parameter of the family, which takes the place of
	                        * Omega in the members below; by harmonic balance. If its frequency is 0
	                        * (of autonomous models): equilibria, or with `omega` limit cycles */
	double omega;          /* scaled frequency of the first cycle, about; 0: equilibria; HAWSER_NONE:
	                        * of the cycle to which `start` leads, or equilibria if that is one */
	const double *turn;    /* [2n] or NULL: the coordinates of the first cycle are about those of
	                        * `start` + `along` cos + `turn` sin; else `start` is a state of it */
	double from, to;       /* scaled Omega, from != to: the range, and the initial direction */
	double begin;          /* scaled Omega of the first orbit, in the range; 0: from */
	int direction;         /* initial direction: 1: Omega increases, -1: it decreases; 0: towards
	                        * `to`. `begin`, `direction` and `start` from a point of another trace
	                        * continue that trace */
	double tolerance;      /* of the defect and of the integration error of an orbit, each relative
	                        * to the size of the orbit; `error` of a point may be larger; 0: 1e-9 */
	double event_tolerance; /* relative, in Omega; 0: by the model, 1e-10, or with exact energy, or 12
	                         * coordinates and more, 1e-7 */
	int segments;          /* shooting: number of segments; 0: chosen from the growth of the flow */
	int max_points;        /* 0: 20000 */
	double step_max;       /* largest change of Omega in a step, relative to the range; 0: 0.02 */
	int skip_events;       /* 1: do not locate events */
	int unjudged;          /* 1: no multipliers and longer steps, where only the shape of the curve
	                        * matters: every point counts as stable, and the only events are folds and
	                        * slackness; 2: of models with exact energy no errors of orbits either,
	                        * but for those of their harmonics */
	int end_at_slack;      /* 1: end the branch where the least tension becomes zero: a cable bears no
	                        * compression, so the model's motion beyond is not the cable's */
	int most_unstable;     /* end the branch at the first point with more unstable multipliers: such
	                        * motions are not observed, and many cost much; 0: no limit */
	double most_work;      /* end the branch after this work (hawser_orbit_work), s; 0: no limit */
	int samples;           /* number of points to compute again by another method; 0: 5; or
	                        * HAWSER_NONE */
	const struct hawser_resonance *resonance; /* multiple scales: which modes are resonant; NULL:
	                        * hawser_resonance_find */
	const double *start;   /* [2n] guess of the state at the first orbit, phase 0, u then du/dt;
	                        * NULL: the linear response */
	const double *along;   /* [2n] or NULL: the first orbit is then not one at `begin`, but one that is
	                        * this far from `start` in this direction, at its own Omega; the curve is
	                        * followed onwards from there */
	struct hawser_progress progress; /* called after each point, with `frf`, which has none while the
	                        * first orbit is looked for */
};

void hawser_frf_settle(struct hawser_frf_options *options);

/* Trace the branch. On HAWSER_ERR_CONVERGENCE, *frf has the points traced so far, and frf->end is
 * HAWSER_END_FAILED; or HAWSER_END_INTERRUPTED, without points, where `progress` ended it before the
 * first one. With most_unstable, where the last of them are unstable, the status is HAWSER_OK and the
 * end HAWSER_END_LOST; the branch might become stable again beyond, and hawser_cover_trace looks for
 * motions there. Release with hawser_frf_clear. Others: HAWSER_ERR_ARGUMENT (range, model without
 * forcing), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_frf_trace(struct hawser_frf *frf, const struct hawser_rom *rom,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_frf_clear(struct hawser_frf *frf);

/* Number the events, the first and last point, and every `every`th one (0: 10; HAWSER_NONE: events
 * alone) along the branch, from `first` on: their members `label`. Returns the number after the last
 * one. */
int hawser_frf_label(struct hawser_frf *frf, int first, int every);

/* A sweep by time integration at `count` frequencies from `from` to `to`. Each integration starts
 * from the final state of the previous one and lasts until the motion is periodic, so that the
 * sweep shows jumps. Arrays are as in hawser_frf; the residual of a point is the difference of the
 * last two periods. */
struct hawser_sweep_options {
	double from, to;  /* scaled Omega; to < from sweeps down */
	int count;
	double settle;    /* largest relative change over a period of a motion that counts as periodic;
	                   * 0: 1e-6 */
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
