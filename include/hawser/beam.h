/* hawser/beam.h - a beam or string that travels along itself between two supports, upright, level or
 * inclined: its eigenvalues, the speeds at which it becomes unstable, its free motion.
 *
 * Scaled (doc/theory-beam.md), x from the lower end 0 to the upper end 1, small deflections y(x, t):
 *
 *   theta y'''' - (T y')' + c Dy + (1 - r^2 d^2/dx^2) DDy = 0,    T(x) = tension - rho (1 - x),
 *   D = d/dt + v d/dx,   DDy = d2y/dt2 + 2 v d2y/dxdt + v^2 y''
 *
 * D (8.3.1) has theta = 1 and tension = mu^2, D (8.3.4) theta = 0 (string) and D (9.3.1) tension = 1.
 * References: Dehadrai 2018 (D), chapters 8 and 9; Wickert and Mote 1990.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_H
#define HAWSER_BEAM_H

#include <hawser/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_beam_ends {
	HAWSER_ENDS_SIMPLE = 0, /* y = 0 and no moment */
	HAWSER_ENDS_CLAMPED     /* y = 0 and y' = 0 */
};

/* What the moment at a simple end does with the rotary momentum that the cable carries through it. */
enum hawser_beam_moment {
	HAWSER_MOMENT_FREE = 0, /* theta y'' = 0, as D: the momentum is fed in and taken out by the
	                         * supports */
	HAWSER_MOMENT_BALANCED  /* theta y'' = r^2 v Dy': nothing but the flux of momentum */
};

struct hawser_beam {
	double theta;   /* bending rigidity, >= 0 */
	double tension; /* at x = 1, > 0 */
	double weight;  /* rho: by how much the tension falls from x = 1 to x = 0 */
	double drag;    /* c >= 0 */
	double rotary;  /* r^2 = 1/S_R^2 of D (8.3.1), S_R^2 of D (9.3.1) */
	double speed;   /* v, from x = 0 to x = 1 */
	enum hawser_beam_ends ends;
	enum hawser_beam_moment moment; /* simple ends only */
	double across;       /* weight across the travel: deflects the beam statically and does nothing else
	                      * to these small motions */
	double length, time; /* units, m and s; 0 where the beam was given without dimensions */
};

/* The scaled beam of a scene. HAWSER_ERR_SCENE (a scene of a cable), HAWSER_ERR_NO_SOLUTION (a string
 * whose lower end is slack). */
enum hawser_status hawser_beam_scene(struct hawser_beam *beam, const struct hawser_scene *scene,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* Below 0, bending alone carries a part of the beam. */
double hawser_beam_least_tension(const struct hawser_beam *beam);

/* What a discretisation makes of y = sum of b_k s_k(x): integrals over [0, 1] that no parameter of the
 * beam enters, each [n][n] row-major, zero where |j - k| > band. */
struct hawser_beam_integrals {
	int n, band;
	double *ss, *s1s1, *s2s2; /* [n][n] s_j s_k, s_j' s_k', s_j'' s_k'' */
	double *xs1s1;            /* [n][n] x s_j' s_k' */
	double *ss1, *s1s2;       /* [n][n] s_j s_k', s_j' s_k'' */
};

/* A discretisation is a row. `size` functions, or elements; fill() makes *integrals, which
 * hawser_beam_integrals_clear releases. Statuses: _ARGUMENT (size < 1, or fewer than a clamped beam
 * needs), _MEMORY. */
struct hawser_beam_method {
	const char *name, *summary, *source;
	enum hawser_status (*fill)(struct hawser_beam_integrals *integrals, enum hawser_beam_ends ends,
	                           int size, struct hawser_report *report);
	/* s [n] the functions' values at x, or their derivatives by the order 0 to 3 */
	void (*at)(double *s, enum hawser_beam_ends ends, int size, int derivative, double x);
};
/* The rows, *count of them, the default first. Static storage. */
const struct hawser_beam_method *hawser_beam_methods(int *count);
void hawser_beam_integrals_clear(struct hawser_beam_integrals *integrals);

/* M b'' + C b' + K b = 0; M, C, K [n][n] row-major, given by the caller. */
void hawser_beam_matrices(double *M, double *C, double *K,
                          const struct hawser_beam_integrals *integrals,
                          const struct hawser_beam *beam);

/* An eigenvalue of the beam: y = Re[shape exp(l t)]. */
struct hawser_beam_eigenvalue {
	double re, im;    /* scaled, im >= 0: of a pair, the one above the real axis */
	double residual;  /* backward error: |(l^2 M + l C + K) b| over the norms' sum */
	double condition; /* by how much relative errors of M, C and K can grow in l */
};

/* The `count` eigenvalues of least modulus, ascending, in value [count], and the coefficients'
 * vectors in vector [count][2][n] (real and imaginary parts), or NULL. An undamped beam's
 * eigenvalue on the imaginary axis has re = 0 exactly. *found may be less than count.
 * HAWSER_ERR_ARGUMENT (count, beam: theta, tension, drag or rotary out of range),
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_beam_eigenvalues(struct hawser_beam_eigenvalue *value, double *vector,
                                           int *found, const struct hawser_beam_integrals *integrals,
                                           const struct hawser_beam *beam, int count,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- along the speed --- */

enum hawser_beam_event_kind {
	HAWSER_BEAM_DIVERGENCE = 0, /* a growth without a frequency begins */
	HAWSER_BEAM_FLUTTER,        /* a growing oscillation begins */
	HAWSER_BEAM_CALM            /* a growth ends */
};
const char *hawser_beam_event_name(enum hawser_beam_event_kind kind); /* "divergence" */

/* Where the number of growing modes changes: the speed is the middle of a bracket of 1e-12 of its
 * size. */
struct hawser_beam_event {
	enum hawser_beam_event_kind kind;
	double speed, im; /* scaled; the eigenvalue's frequency there */
	int growing[2];   /* modes before it and beyond */
};

struct hawser_beam_station {
	double speed;
	int growing;  /* of the modes followed */
	int inserted; /* 1: by the refinement */
};

struct hawser_beam_sweep {
	int stations, branches, events, solves;
	int unsure;  /* stations at which a branch could not be told from another within the smallest
	              * step */
	double least_correlation;
	struct hawser_beam_station *station; /* [stations] from `from` to `to` */
	double *re;   /* [stations][branches][2] equal, but where the pair is real */
	double *im;   /* [stations][branches] >= 0; 0: two real eigenvalues */
	double *condition; /* [stations][branches] as in struct hawser_beam_eigenvalue */
	struct hawser_beam_event *event; /* [events] in the order of the sweep */
	double v_first; /* the growth of branch 0 begins; NAN: nowhere between */
	double v_bif;   /* the frequency of branch 0 vanishes; NAN: nowhere between */
};

struct hawser_beam_sweep_options {
	double from, to; /* of the speed; may descend */
	int points;      /* before refinement, >= 2 */
	int branches;    /* pairs of eigenvalues followed, those of least modulus at `from` */
	int loose;       /* 1: no stations added for the branches' sake alone, only where growth may hide */
};
/* Sweep; beam->speed does not matter. Release with hawser_beam_sweep_clear. HAWSER_ERR_ARGUMENT and
 * statuses of hawser_beam_eigenvalues. */
enum hawser_status hawser_beam_sweep(struct hawser_beam_sweep *sweep,
                                     const struct hawser_beam_integrals *integrals,
                                     const struct hawser_beam *beam,
                                     const struct hawser_beam_sweep_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_beam_sweep_clear(struct hawser_beam_sweep *sweep);

/* Speeds at which the beam has a static deflection without a load, ascending, in speed [*count],
 * room for n: all of an undamped beam, K = K0 - v^2 P being symmetric. *buckled: how many static
 * modes its weight makes grow at rest. HAWSER_ERR_ARGUMENT (drag, or a string),
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_beam_static_speeds(double *speed, int *count, int *buckled,
                                             const struct hawser_beam_integrals *integrals,
                                             const struct hawser_beam *beam,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

/* Why there is growth at v_crit. */
enum hawser_beam_cause {
	HAWSER_BEAM_NO_GROWTH = 0,
	HAWSER_BEAM_BUCKLES,     /* at rest, by its own weight */
	HAWSER_BEAM_BY_FLUX,     /* at every speed, by the rotary momentum fed in at the supports */
	HAWSER_BEAM_DIVERGES,
	HAWSER_BEAM_FLUTTERS,
	HAWSER_BEAM_WAVES,       /* v^2 = theta/rotary, the speed of bars: waves of any shortness */
	HAWSER_BEAM_STRING       /* v^2 = the least tension, the speed of waves where it is least */
};
const char *hawser_beam_cause_name(enum hawser_beam_cause cause); /* "divergence" */

/* Safe speeds, from rest in the direction of beam->speed (upwards where that is 0): magnitudes. */
struct hawser_beam_limits {
	double v_crit;  /* growth of any of the modes begins; NAN: not up to `searched` */
	double v_first; /* of the first mode, as D defines it; NAN the same */
	double v_bif;   /* the first mode's frequency vanishes; NAN the same */
	double slope;   /* d re/dv at rest of the mode that grows most, where that is by flux */
	double searched;
	enum hawser_beam_cause cause;
	int modes;      /* watched */
};
enum hawser_status hawser_beam_limits(struct hawser_beam_limits *limits,
                                      const struct hawser_beam_integrals *integrals,
                                      const struct hawser_beam *beam, int modes,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Size of a discretisation for which the first `modes` eigenvalues and static speeds at rest have
 * settled to `tolerance`, relative, and where the beam moves or has drag its eigenvalues then (the
 * squares, over these and that of a thousandth of the first frequency at rest). *error is what is left,
 * an estimate that tells nothing below a hundredth of the tolerance. HAWSER_ERR_CONVERGENCE where that
 * takes more than 400 functions; *size is then 400, and *error says how far it is. */
enum hawser_status hawser_beam_size(int *size, double *error,
                                    const struct hawser_beam_method *method,
                                    const struct hawser_beam *beam, int modes, double tolerance,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- stability boundaries --- */

/* The beam for a value of a parameter. A failure ends the boundary there. */
struct hawser_beam_family {
	enum hawser_status (*at)(struct hawser_beam *beam, void *context, double parameter,
	                         struct hawser_report *report);
	void *context;
};
/* The family of a scene whose key (hawser_scene_keys) varies. */
struct hawser_beam_scene_key {
	const struct hawser_scene *scene;
	const char *key;
};
enum hawser_status hawser_beam_scene_family(struct hawser_beam *beam, void *scene_key,
                                            double parameter, struct hawser_report *report);

struct hawser_beam_boundary_point {
	double parameter, speed; /* scaled, and in units of the beam at this parameter: */
	double im;               /* of the eigenvalue on the imaginary axis; of v_bif 0 */
	double re;               /* 0; of v_bif, the double eigenvalue */
	double per_speed;        /* m/s, or 1 */
	enum hawser_beam_cause cause;
	int growing[2];          /* modes just below and just above the speed */
	int piece;               /* from 0: pieces of the boundary meet in corners */
};

struct hawser_beam_boundary {
	int points, pieces;
	struct hawser_beam_boundary_point *point; /* [points] by piece, and along it */
	char ended[2][160]; /* why it ends at either end, or "" where the range does */
};

struct hawser_beam_boundary_options {
	double from, to;   /* of the parameter, from < to */
	int modes;         /* watched */
	int bifurcation;   /* v_bif instead of v_crit */
	double step;       /* longest, as a part of the range; 0: 0.02 */
	int max_points;    /* 0: 2000 */
};
/* The boundary as a curve of its own, by pseudo-arclength continuation of det Q(i w; v, p) = 0 (of a
 * double real eigenvalue for v_bif), each point checked by counting what grows on both its sides, and a
 * new piece begun where another mode takes over. A string's is its closed form at the steps' places.
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_NO_SOLUTION (no boundary in the range), and statuses of
 * hawser_beam_limits. Release with hawser_beam_boundary_clear. */
enum hawser_status hawser_beam_boundary(struct hawser_beam_boundary *boundary,
                                        const struct hawser_beam_integrals *integrals,
                                        const struct hawser_beam_family *family,
                                        const struct hawser_beam_boundary_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_beam_boundary_clear(struct hawser_beam_boundary *boundary);

#ifdef __cplusplus
}
#endif
#endif
