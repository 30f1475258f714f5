/* hawser/locus.h - bifurcations of the frequency response, followed in two parameters: the forcing
 * frequency and another parameter of the model. Besides, its resonances: the motions that lag their
 * load by 90 degrees, which with the load as the parameter are the damped backbone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_LOCUS_H
#define HAWSER_LOCUS_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Special points of a locus (bifurcations of codimension two). Kuznetsov, Elements of Applied
 * Bifurcation Theory, 2004, chapter 9. */
enum hawser_locus_special {
	HAWSER_LOCUS_CUSP = 0,     /* two folds merge; of resonances, the parameter turns back */
	HAWSER_LOCUS_DEGENERATE,   /* the branch that is born turns from one side of the locus to the
	                            * other: generalised period doubling, degenerate branch point, and of
	                            * tori Chenciner's point; of resonances, a branch point */
	HAWSER_LOCUS_ONE_ONE,      /* resonance 1:1: two multipliers are +1 */
	HAWSER_LOCUS_ONE_TWO,      /* 1:2: two multipliers are -1 */
	HAWSER_LOCUS_ONE_THREE,    /* 1:3: the torus' multipliers are cube roots of 1 */
	HAWSER_LOCUS_ONE_FOUR,     /* 1:4: they are i and -i */
	HAWSER_LOCUS_WITH_FOLD,    /* another multiplier is +1 */
	HAWSER_LOCUS_WITH_DOUBLING, /* another multiplier is -1 */
	HAWSER_LOCUS_WITH_TORUS,   /* another pair of multipliers is on the unit circle */
	HAWSER_LOCUS_WITH_HOPF,    /* of equilibria: another pair of eigenvalues is on the axis (zero-Hopf,
	                            * double Hopf) */
	HAWSER_LOCUS_TAKENS,       /* of equilibria: two eigenvalues are 0 (Bogdanov-Takens) */
	HAWSER_LOCUS_START,        /* the curve passes the value at which it was started */
	HAWSER_LOCUS_SPECIALS
};
/* "cusp", "generalised-period-doubling", "1:1", ..., "fold-flip", "fold-torus", "flip-torus", ...: the
 * name depends on the kind of the locus. */
const char *hawser_locus_special_name(enum hawser_event_kind kind, enum hawser_locus_special special);

enum hawser_locus_end {
	HAWSER_LOCUS_OMEGA = 0,   /* Omega left its range */
	HAWSER_LOCUS_PARAMETER,   /* the parameter left its range */
	HAWSER_LOCUS_CLOSED,      /* the curve returned to its start */
	HAWSER_LOCUS_RESONANCE,   /* the angle of the torus' multipliers became 0 or pi: the last event */
	HAWSER_LOCUS_NO_FREQUENCY, /* the frequency of the Hopf points became 0: the last event */
	HAWSER_LOCUS_MAX_POINTS,
	HAWSER_LOCUS_INTERRUPTED, /* progress.function asked for it */
	HAWSER_LOCUS_FAILED,      /* the corrector failed; the curve's message says where */
	HAWSER_LOCUS_WORK         /* the search took `most_work` */
};
const char *hawser_locus_end_name(enum hawser_locus_end end);

struct hawser_locus_point {
	double omega;     /* scaled, in the unit of time of the model at the start; of a plane, the first
	                   * parameter */
	double parameter;
	double angle;     /* argument of the critical multipliers, 0 to pi: 0 at folds and branch points, pi
	                   * at period doublings */
	double own;       /* of autonomous models: frequency of the cycle or, of a Hopf point, of its pair,
	                   * scaled; 0: equilibrium */
	double l1;        /* of a Hopf point (struct hawser_hopf), else NAN */
	double arc;       /* arclength along the curve, in the metric of the continuation */
	double residual;  /* certificate: largest defect after the final correction, relative */
	double mesh;      /* certificate: estimated truncation error of the Fourier series, relative to
	                   * the orbit */
	int unstable;     /* multipliers outside the unit circle besides the critical ones */
	int harmonics;    /* of the orbit and of the critical motion */
	int iterations;   /* of the corrector */
	/* Of HAWSER_RESONANCE, else 0; scaled: */
	double amplitude; /* of the harmonic, along the load: |f a|/|f| */
	double phase;     /* by which it lags the load: pi/2, but for `residual` */
	double energy;    /* kinetic and potential energy, mean over the period */
	double work;      /* of the load in a period, all of its harmonics: what the damping takes */
	double damping;   /* work/(4 pi energy): of a linear mode the damping ratio */
};

struct hawser_locus_event {
	enum hawser_locus_special kind;
	double omega, parameter, angle, arc;
	double own;       /* as in struct hawser_locus_point */
	double error;     /* estimated error of omega and parameter, relative to their ranges */
	int after;        /* index, among all points, of the last point before it */
};

struct hawser_locus_curve {
	int first, points;             /* index of the first point, and number of points */
	int first_event, events;
	enum hawser_locus_end end[2];  /* [2] at its first and its last point */
	char message[240];             /* why it failed, or "" */
};

struct hawser_locus {
	enum hawser_event_kind kind;
	int n, points, curves, events;
	struct hawser_locus_point *point; /* [points] curve after curve */
	double *coordinate;               /* [points][n] max over the period of |u_j|, scaled */
	double *state;                    /* [points][2n] u then du/dt at tau = 0, scaled */
	struct hawser_locus_curve *curve; /* [curves] */
	struct hawser_locus_event *event; /* [events] */
	int harmonic;                     /* HAWSER_RESONANCE: of the load */
	double at;                        /* the parameter at which the curves begin */
	int lost;                         /* events of the response from which no curve could be begun */
	double *lost_at;                  /* [lost] their Omega */
	struct hawser_frf response;       /* at the parameter `at`, from `from`. Curves begin at those
	                                   * from the other end of the range, and in parts of the range
	                                   * that neither covers, as well */
	int interrupted;
	int costly;                       /* 1: it ended at options->most_work */
	long solves;                      /* number of linear systems factorised */
};

struct hawser_locus_options {
	enum hawser_event_kind kind; /* HAWSER_FOLD, _PERIOD_DOUBLING, _TORUS, _BRANCH_POINT, _HOPF (of
	                              * autonomous models), or
	                              * HAWSER_RESONANCE: motions in phase quadrature with their load, the
	                              * damped backbone */
	int harmonic;                /* HAWSER_RESONANCE: of load and motion; 0: the load's lowest one */
	double from, to;             /* scaled Omega: the range, as in hawser_frf_options */
	double parameter_from, parameter_to;
	double at;                   /* the parameter of the response whose bifurcations begin the curves */
	const struct hawser_frf_options *first; /* NULL, or where that response begins: its start, along and
	                              * begin; it is then followed to both sides */
	int periods;                 /* of the load in one of the motion; 0: those of the model (1,
	                              * or of its loads of several multiples). More need `first`, and no
	                              * plane */
	double near;                 /* scaled Omega: only the bifurcation next to it; 0: all */
	double tolerance;            /* of the defect and of the truncation error, relative; 0: 1e-9 */
	int max_points;              /* of a curve in each direction, and of the response; 0: 2000 */
	double step_max;             /* largest change of Omega or of the parameter in a step, relative to
	                              * its range; 0: 0.02 */
	double most_work;            /* of all responses and curves, s (hawser_orbit_work): they end there,
	                              * and the search is `costly`; 0: no limit. Not
	                              * read for models without a load */
	int skip_events;             /* 1: no special points, no multipliers */
	const struct hawser_rom_plane *plane; /* NULL, or two parameters at one frequency: the first one
	                              * takes the place of Omega in `from`, `to`, `near`, in the points and
	                              * in the events, and may have any sign; the family is not read */
	struct hawser_progress progress; /* called after each point */
};
void hawser_locus_settle(struct hawser_locus_options *options);

/* Trace the loci through the bifurcations of that kind on the response of the model at the parameter
 * `at`, in both directions. The family's omega is not read. Release with hawser_locus_clear. Statuses:
 * HAWSER_ERR_NO_SOLUTION (no such bifurcation), HAWSER_ERR_ARGUMENT (a range, a tolerance, a model that
 * harmonic balance does not take), HAWSER_ERR_CONVERGENCE (no curve could be begun), and those of
 * hawser_frf_trace. */
enum hawser_status hawser_locus_trace(struct hawser_locus *locus,
                                      const struct hawser_rom_family *family,
                                      const struct hawser_locus_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_locus_clear(struct hawser_locus *locus);

#ifdef __cplusplus
}
#endif
#endif
