/* hawser/beam.h - a beam or string that travels along its axis between two supports, vertical,
 * level or inclined: eigenvalues, critical speeds, stability boundaries. (Free motion:
 * hawser/beam_motion.h.)
 *
 * Scaled equation (doc/theory-beam.md) of small deflections y(x, t), with x from the lower end 0
 * to the upper end 1:
 *
 *   theta y'''' - (T y')' + c Dy + (1 - r^2 d^2/dx^2) DDy = 0,    T(x) = tension - rho (1 - x),
 *   D = d/dt + v d/dx,   DDy = d2y/dt2 + 2 v d2y/dxdt + v^2 y''
 *
 * D (8.3.1) has theta = 1 and tension = mu^2, D (8.3.4) theta = 0 (string) and D (9.3.1) tension
 * = 1. References: Dehadrai 2018 (D), chapters 8 and 9; Wickert and Mote 1990.
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

/* The moment condition at a simple end. The travelling beam carries rotary momentum through its
 * ends. */
enum hawser_beam_moment {
	HAWSER_MOMENT_FREE = 0, /* theta y'' = 0, as D: the flux of rotary momentum does work at the
	                         * supports */
	HAWSER_MOMENT_BALANCED  /* theta y'' = r^2 v Dy': the moment balances the flux */
};

struct hawser_beam {
	double theta;   /* bending rigidity, >= 0 */
	double tension; /* at x = 1, > 0 */
	double weight;  /* rho: tension at x = 1 minus tension at x = 0 */
	double drag;    /* c >= 0 */
	double rotary;  /* r^2 = 1/S_R^2 of D (8.3.1), S_R^2 of D (9.3.1) */
	double speed;   /* v, positive from x = 0 to x = 1 */
	enum hawser_beam_ends ends;
	enum hawser_beam_moment moment; /* simple ends only */
	double across;       /* weight normal to the travel: deflects the beam statically, with no effect
	                      * on small motions */
	double length, time; /* units, m and s; 0 if the scene gives the beam without dimensions */
};

/* The scaled beam of a scene. HAWSER_ERR_SCENE (the scene describes a cable),
 * HAWSER_ERR_NO_SOLUTION (a string whose lower end is slack). */
enum hawser_status hawser_beam_scene(struct hawser_beam *beam, const struct hawser_scene *scene,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* The least tension over x. If it is negative, a part of the beam is in compression. */
double hawser_beam_least_tension(const struct hawser_beam *beam);

/* Integrals over [0, 1] of the functions of a discretisation y = sum of b_k s_k(x). They do not
 * depend on the parameters of the beam. Each is [n][n] row-major, and zero where |j - k| > band. */
struct hawser_beam_integrals {
	int n, band;
	double *ss, *s1s1, *s2s2; /* [n][n] s_j s_k, s_j' s_k', s_j'' s_k'' */
	double *xs1s1;            /* [n][n] x s_j' s_k' */
	double *ss1, *s1s2;       /* [n][n] s_j s_k', s_j' s_k'' */
};

/* A method of discretisation. `size` is the number of functions or of elements. fill() computes
 * *integrals; release it with hawser_beam_integrals_clear. Statuses of fill():
 * HAWSER_ERR_ARGUMENT (size < 1, or too small for a clamped beam), HAWSER_ERR_MEMORY. */
struct hawser_beam_method {
	const char *name, *summary, *source;
	enum hawser_status (*fill)(struct hawser_beam_integrals *integrals, enum hawser_beam_ends ends,
	                           int size, struct hawser_report *report);
	/* s [n]: the functions at x (derivative 0), or their derivatives of order 1 to 3 */
	void (*at)(double *s, enum hawser_beam_ends ends, int size, int derivative, double x);
};
/* Row `index` of the table of methods, from 0, the default first; NULL beyond the last. Static
 * storage. */
const struct hawser_beam_method *hawser_beam_method(int index);
void hawser_beam_integrals_clear(struct hawser_beam_integrals *integrals);

/* The matrices of M b'' + C b' + K b = 0. M, C, K [n][n] row-major are allocated by the caller. */
void hawser_beam_matrices(double *M, double *C, double *K,
                          const struct hawser_beam_integrals *integrals,
                          const struct hawser_beam *beam);

/* An eigenvalue of the beam: y = Re[shape exp(l t)]. */
struct hawser_beam_eigenvalue {
	double re, im;    /* scaled; im >= 0: of a conjugate pair, the one above the real axis */
	double residual;  /* backward error: |(l^2 M + l C + K) b| over the sum of the terms' norms */
	double condition; /* condition number of l with respect to relative errors of M, C and K */
};

/* The `count` eigenvalues of least modulus, ascending, in value [count]. Their eigenvectors
 * (coefficients b) go to vector [count][2][n], real and imaginary parts; vector may be NULL. For
 * a gyroscopic beam (no drag, no flux of rotary momentum) an eigenvalue on the imaginary axis has
 * re = 0 exactly. *found may be less than count. HAWSER_ERR_ARGUMENT (count, or theta, tension,
 * drag or rotary out of range), HAWSER_ERR_CONVERGENCE, HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_beam_eigenvalues(struct hawser_beam_eigenvalue *value, double *vector,
                                           int *found, const struct hawser_beam_integrals *integrals,
                                           const struct hawser_beam *beam, int count,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- sweep of the speed --- */

enum hawser_beam_event_kind {
	HAWSER_BEAM_DIVERGENCE = 0, /* a real eigenvalue becomes positive */
	HAWSER_BEAM_FLUTTER,        /* a complex pair gets a positive real part */
	HAWSER_BEAM_CALM            /* the number of growing modes decreases */
};
const char *hawser_beam_event_name(enum hawser_beam_event_kind kind); /* "divergence" */

/* A change of the number of growing modes. The speed is the middle of a bracket of relative width
 * 1e-13. */
struct hawser_beam_event {
	enum hawser_beam_event_kind kind;
	double speed, im; /* scaled; im is the imaginary part of the critical eigenvalue */
	int growing[2];   /* number of growing modes before and after the event */
};

/* One sample of a sweep. */
struct hawser_beam_station {
	double speed;
	int growing;  /* number of growing modes among those followed */
	int inserted; /* 1: added by the refinement */
};

struct hawser_beam_sweep {
	int stations, branches, events, solves;
	int unsure;  /* number of stations with branches not separated at the smallest step */
	double least_correlation; /* smallest correlation of a branch between successive stations */
	struct hawser_beam_station *station; /* [stations] from `from` to `to` */
	double *re;   /* [stations][branches][2] real parts of a pair; different only if it is real */
	double *im;   /* [stations][branches] >= 0; 0: the pair is real */
	double *condition; /* [stations][branches] as in struct hawser_beam_eigenvalue */
	struct hawser_beam_event *event; /* [events] in the order of the sweep */
	double v_first; /* first speed at which branch 0 grows; NAN: none in the range */
	double v_bif;   /* first speed at which branch 0 has frequency 0; NAN: none in the range */
};

struct hawser_beam_sweep_options {
	double from, to; /* range of the speed; to < from is allowed */
	int points;      /* number of stations before refinement, >= 2 */
	int branches;    /* number of pairs followed: those of least modulus at `from` */
	int loose;       /* 1: refine only where growth may be missed, not to resolve the branches */
};
/* Eigenvalues over a range of speeds; beam->speed is ignored. Release with hawser_beam_sweep_clear.
 * HAWSER_ERR_ARGUMENT, and the statuses of hawser_beam_eigenvalues. */
enum hawser_status hawser_beam_sweep(struct hawser_beam_sweep *sweep,
                                     const struct hawser_beam_integrals *integrals,
                                     const struct hawser_beam *beam,
                                     const struct hawser_beam_sweep_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_beam_sweep_clear(struct hawser_beam_sweep *sweep);

/* Static speeds, at which a static deflection needs no load, ascending, in speed [n], the first
 * *count of it used. They are all eigenvalues of the symmetric problem K0 x = v^2 P x of the
 * undamped beam; drag is ignored. *buckled is the number of modes that are statically unstable at
 * rest under the weight. HAWSER_ERR_ARGUMENT (a quantity out of range, or a string),
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_beam_static_speeds(double *speed, int *count, int *buckled,
                                             const struct hawser_beam_integrals *integrals,
                                             const struct hawser_beam *beam,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

/* The cause of the instability at v_crit. */
enum hawser_beam_cause {
	HAWSER_BEAM_NO_GROWTH = 0,
	HAWSER_BEAM_BUCKLES,     /* buckling at rest under the weight */
	HAWSER_BEAM_BY_FLUX,     /* at every speed, by the work of the flux of rotary momentum */
	HAWSER_BEAM_DIVERGES,
	HAWSER_BEAM_FLUTTERS,
	HAWSER_BEAM_WAVES,       /* v^2 = theta/rotary: above it the shortest waves diverge */
	HAWSER_BEAM_STRING       /* a string: v^2 = the least tension, the lowest wave speed squared */
};
const char *hawser_beam_cause_name(enum hawser_beam_cause cause); /* "divergence" */

/* Safe speeds: moduli, for a travel in the direction of beam->speed (upwards if beam->speed is
 * 0). */
struct hawser_beam_limits {
	double v_crit;  /* lowest speed at which any mode grows; NAN: none up to `searched` */
	double v_first; /* the same for the first mode alone, as D defines it */
	double v_bif;   /* lowest speed at which the first mode's frequency is 0; NAN: none */
	double slope;   /* cause HAWSER_BEAM_BY_FLUX: largest d re/dv of a mode at rest; otherwise 0 */
	double searched; /* largest speed examined */
	enum hawser_beam_cause cause;
	int modes;      /* number of modes examined */
};
/* HAWSER_ERR_ARGUMENT (modes < 1), and the statuses of hawser_beam_static_speeds and
 * hawser_beam_sweep. */
enum hawser_status hawser_beam_limits(struct hawser_beam_limits *limits,
                                      const struct hawser_beam_integrals *integrals,
                                      const struct hawser_beam *beam, int modes,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* The size of a discretisation at which the first `modes` frequencies at rest and static speeds
 * have converged to the relative tolerance. For a beam that moves or has drag, its first `modes`
 * eigenvalues l at beam->speed must have converged too, measured in l^2 relative to |l|^2 + (1e-3
 * w1)^2, where w1 is the first frequency at rest. *error is the estimated remaining error; values
 * below a hundredth of the tolerance are not meaningful. HAWSER_ERR_CONVERGENCE if 400 functions
 * are not enough; *size is then 400 and *error the error that they leave. */
enum hawser_status hawser_beam_size(int *size, double *error,
                                    const struct hawser_beam_method *method,
                                    const struct hawser_beam *beam, int modes, double tolerance,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- stability boundaries --- */

/* A beam that depends on a parameter. If at() fails, the boundary ends at that parameter. */
struct hawser_beam_family {
	enum hawser_status (*at)(struct hawser_beam *beam, void *context, double parameter,
	                         struct hawser_report *report);
	void *context;
};
/* Context of hawser_beam_scene_family: a scene, and the key (hawser_scene_key) that is the
 * parameter. */
struct hawser_beam_scene_key {
	const struct hawser_scene *scene;
	const char *key;
};
enum hawser_status hawser_beam_scene_family(struct hawser_beam *beam, void *scene_key,
                                            double parameter, struct hawser_report *report);

struct hawser_beam_boundary_point {
	double parameter, speed; /* the speed is scaled with the units of the beam at this parameter */
	double im;               /* imaginary part of the critical eigenvalue; 0 for v_bif */
	double re;               /* for v_bif the double real eigenvalue; otherwise 0 */
	double per_speed;        /* unit of the speed in m/s; 1 if the beam has no dimensions */
	enum hawser_beam_cause cause;
	int growing[2];          /* number of growing modes just below and just above the speed */
	int piece;               /* index from 0; successive pieces of the boundary meet at corners */
};

struct hawser_beam_boundary {
	int points, pieces;
	struct hawser_beam_boundary_point *point; /* [points] sorted by piece, and along each piece */
	char ended[2][160]; /* reason of the lower and the upper end; "": the end of the range */
};

struct hawser_beam_boundary_options {
	double from, to;   /* range of the parameter, from < to */
	int modes;         /* number of modes examined */
	int bifurcation;   /* 1: v_bif instead of v_crit */
	double step;       /* longest step relative to the range; 0: 0.02 */
	int max_points;    /* 0: 2000 */
};
/* The boundary v_crit or v_bif over the parameter, by pseudo-arclength continuation of det Q(i w;
 * v, p) = 0 (for v_bif, of a double real eigenvalue). Each point is verified by counting the
 * growing modes on both sides of it. Where another mode becomes critical, a new piece begins. The
 * boundary of a string is evaluated in closed form at 201 equidistant parameters.
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_NO_SOLUTION (no boundary in the range), and the statuses of
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
