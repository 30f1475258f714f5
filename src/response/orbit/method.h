/* response/orbit/method.h - the interface between the continuation and a method for forced periodic
 * orbits.
 *
 *    y       unknowns [size]: the representation of the orbit, then Omega
 *    metric  <a, b> = sum over i of weight_i a_i b_i. |dy| combines the relative change of the
 *            orbit, by components, with that of Omega divided by its natural width W. A step in
 *            arclength thus has the same meaning for every model, and nothing needs tuning
 *    plane   a correction stays in <row, y - y_predicted> = 0: the row is the metric's dual of a
 *            direction
 *
 * A method is a row of the table in methods.c and a structure that begins with struct
 * hawser__orbit. The continuation calls its functions in this order: metric; defects with
 * derivatives; factor; solve; then, for an accepted point, multipliers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_METHOD_H
#define HAWSER_RESPONSE_METHOD_H

#include <math.h>

#include <hawser/frf.h>

#include "continuation/curve.h"
#include "continuation/metric.h"

struct hawser__orbit_ops;

/* What an orbit is. Those of autonomous models, the last two, are in response/cycle; y of a cycle ends
 * with its frequency and the parameter of the family. */
enum hawser__motion {
	HAWSER__FORCED = 0,
	HAWSER__RESTS,
	HAWSER__CYCLES
};

/* Size of the logarithm of a multiplier that is none (hawser__orbit_idle); its square is a double. */
#define HAWSER__MOST_GROWTH 300.0

/* Default tolerance of a model with quadratic drag, which has no second derivative where the velocity
 * changes its sign: the error of an orbit decreases with the cube of the steps, no faster. */
#define HAWSER__DRAG_TOLERANCE 1e-6

/* Distance of the two models whose difference is the derivative by a parameter, relative to its size:
 * at 1e-3 the errors by third derivatives and by the models' own tolerance of about 1e-10 are both
 * near 1e-7, and the derivative only serves to find the next orbit. */
#define HAWSER__NUDGE 5e-4

/* The metric is the same for all methods, so that steps have the same length in each: its width in
 * Omega, as a fraction of Omega (a resonance with 2.5 % damping), and the least size of a
 * component, as a fraction of the size of the orbit. */
#define HAWSER_OMEGA_WIDTH 0.05
#define HAWSER_SCALE_FLOOR 0.003

struct hawser__orbit {
	const struct hawser__orbit_ops *ops;
	const struct hawser_rom *rom;
	const struct hawser_rom_family *family; /* NULL: Omega is the parameter; otherwise y ends with the
	                       * parameter of the family, and rom is the model at the last defects */
	double placed;        /* value of the parameter that `rom` has */
	double middle;        /* between the models of the last derivative by the parameter */
	double floor;         /* least size of the parameter in the metric */
	enum hawser__motion own;
	int freely;           /* 1: the orbit is a cycle's: sizes are those of its deviation from its
	                       * mean, and the multiplier that is 1 is left out */
	int n, m;             /* number of coordinates; of states, 2n */
	int size;             /* unknowns, Omega the last */
	double X, W;          /* metric: size of the orbit (its state), natural width in Omega */
	double *weight;       /* [size] metric */
	double drained;       /* over the period, integral of the trace of D that varies (drag) */
	double mesh;          /* estimated error of the discretisation of the last orbit, absolute */
	double *samples;      /* [rows][n] u at equidistant phases from 0, of the last defects */
	int rows;
	int resolution;       /* steps per period, or real coefficients per coordinate */
	double *log_modulus, *argument; /* [m] of the last multipliers */
	int idle;             /* how many of them, the last, are none: such as that of a cycle which is 1 */
	double trivial;       /* of a cycle: distance of that one from 1, as computed */
	const double *turn;   /* of a cycle, [n][n]: generator of rotations of the coordinates that leave
	                       * the model as it is (cycle/turn.c); NULL: there are none */
	const double *anchor; /* [size] with `turn`: y from which corrections do not turn */
	int held;             /* 1: solve corrects what has been turned, too */
	double *kind;         /* [m] of the last multipliers (floquet.h) */
	/* Of the last multipliers, without the error of the orbit: the error of the matrix whose
	 * eigenvalues they are, its part that is due to round-off, and a further error of their
	 * logarithms. */
	double product_error, product_round_off, multiplier_error;
	double round_off;     /* part of the last `error` that is due to round-off */
	double det_sign, det_log; /* of the bordered Jacobian of the last factorisation */
	const double *tangent; /* [size] of the branch, for relax; or NULL */
	double reach;         /* distance of the orbit from the previous one in the metric; 0: not
	                       * examined */
	int known;            /* 1: the next orbit that is corrected is one already, it may be */
	double patience;      /* contraction that the corrector bears; 0: its own limit (newton.c) */
	double goal;          /* largest relative residual of the next solutions, where the method solves by
	                       * iteration; 0: what a step of the corrector needs */
	const double *estimate; /* [size] of the next tangent, of any length; or NULL */
	int counted;          /* 1: det_sign and det_log are those of the multipliers */
	int unjudged;         /* not 0: no multipliers are wanted: each orbit counts as stable */
	double rate;          /* factor by which a step with a guessed Jacobian reduces the defects */
	double *step, *spare; /* [size] workspace of the corrector and of the metric */
	double *derived;      /* [derivatives] of the last defects, for guess (shooting_guess.c): of a
	                       * method that integrates, the transition matrices and what Omega changes */
	size_t derivatives;
	double *memory;       /* y and `derived` of past orbits, */
	int kept;             /* how many so far */
	void (*tick)(void *owner); /* called before each correction, for progress; or NULL */
	void *owner;
	struct hawser_orbit_cost cost;
};

struct hawser__orbit_ops {
	/* Set X, W and weight from the orbit y [size]. */
	void (*metric)(struct hawser__orbit *orbit, const double *y);

	/* Defects at y, stored for solve; with `derive` also the Jacobian, the samples and the mesh
	 * error. Returns the largest defect divided by X; NaN or infinity if it cannot be computed. */
	double (*defects)(struct hawser__orbit *orbit, const double *y, int derive);

	/* Factorise the Jacobian with `row` [size] as the border. 1 when singular. */
	int (*factor)(struct hawser__orbit *orbit, const double *row);

	/* dy [size]: J dy = -defects (0 where homogeneous) and <row, dy> = last. */
	void (*solve)(struct hawser__orbit *orbit, double *dy, int homogeneous, double last);

	/* Estimated distance, divided by X, of the last corrected orbit from the exact branch;
	 * `residual` is its largest defect divided by X. Infinite if the Jacobian is singular. */
	double (*error)(struct hawser__orbit *orbit, double residual);

	/* Floquet multipliers of the orbit at the last computed derivatives. If the factorised Jacobian
	 * lacks a coordinate at rest, also the sign and logarithm of the determinant with it. */
	enum hawser_status (*multipliers)(struct hawser__orbit *orbit, struct hawser_report *report);

	/* After a correction to `tolerance`: if the mesh error requires it, a finer discretisation, and
	 * *again = 1 (correct again); otherwise *again = 0. HAWSER_ERR_CONVERGENCE at the limit. */
	enum hawser_status (*refine)(struct hawser__orbit *orbit, int *again, double tolerance,
	                             double omega, struct hawser_report *report);
	/* A coarser discretisation for the next point if the present one is finer than necessary. */
	enum hawser_status (*relax)(struct hawser__orbit *orbit, double tolerance,
	                            struct hawser_report *report);
	/* A finer discretisation whatever the error is, since no orbit was found; or, unless `most`, since
	 * the last one is badly determined: then as much finer as `sharpen` makes it, and so are those that
	 * follow, until they are well determined. */
	enum hawser_status (*enrich)(struct hawser__orbit *orbit, int most,
	                             struct hawser_report *report);

	/* With `on`: a discretisation whose error is at least ten times smaller than that of the last
	 * defects, for comparison; HAWSER_ERR_CONVERGENCE if there is none. Otherwise: return to the
	 * former one. In both cases the next call must be `defects`. */
	enum hawser_status (*sharpen)(struct hawser__orbit *orbit, int on,
	                              struct hawser_report *report);

	/* y += p cos(k tau) + q sin(k tau), pq [2n]. */
	void (*add_wave)(struct hawser__orbit *orbit, double *y, const double *pq, int k, double omega);
	/* An estimate of y from the state x [m] at phase 0. */
	enum hawser_status (*from_state)(struct hawser__orbit *orbit, double *y, const double *x,
	                                 double omega, struct hawser_report *report);
	/* The state x [m] of y at phase 0. */
	void (*state)(const struct hawser__orbit *orbit, double *x, const double *y);

	/* Frees the orbit itself too. */
	void (*clear)(struct hawser__orbit *orbit);

	/* A method has both or none: those that integrate have the functions below. keep: store the
	 * Jacobian of the corrected orbit y. guess: extrapolate the Jacobian near y, with the plane's
	 * normal `row`, from stored ones; returns 0 if that is not possible. */
	void (*keep)(struct hawser__orbit *orbit, const double *y);
	int (*guess)(struct hawser__orbit *orbit, const double *y, const double *row);

	/* A method that takes autonomous models has both. parts: where the defects are for solve, and the
	 * derivative by the parameter for factor; returns how many of each. shift: dy [size] becomes the
	 * derivative of y by the phase. */
	int (*parts)(struct hawser__orbit *orbit, double **defect, double **column);
	void (*shift)(struct hawser__orbit *orbit, double *dy, const double *y);
};

/* Allocate and free the arrays of the base (but not the samples), for the open and clear of a
 * method. */
enum hawser_status hawser__orbit_init(struct hawser__orbit *orbit, const struct hawser_rom *rom,
                                      int size, struct hawser_report *report);
void hawser__orbit_free(struct hawser__orbit *orbit);

/* shooting_guess.c: `keep` and `guess` of a method whose Jacobian follows from orbit->derived
 * [derivatives] alone. _remember gives them room, for the lifetime of the base; 1: no memory. */
int hawser__orbit_remember(struct hawser__orbit *orbit, double *derived, size_t derivatives);
void hawser__orbit_keep(struct hawser__orbit *orbit, const double *y);
int hawser__orbit_guess(struct hawser__orbit *orbit, const double *y, const double *row);

/* The scaled forcing frequency at the parameter p of the family; NaN if there is no model. */
double hawser__orbit_frequency(const struct hawser__orbit *orbit, double p);

/* The forcing frequency of an orbit y; of a cycle its own, of an equilibrium 1. */
static inline double hawser__orbit_omega(const struct hawser__orbit *orbit, const double *y)
{
	double p = y[orbit->size - 1];

	if (orbit->own)
		return orbit->own == HAWSER__CYCLES ? y[orbit->size - 2] : 1.0;
	return orbit->family ? hawser__orbit_frequency(orbit, p) : p;
}

/* det_sign and det_log of a method whose matrix has the active pairs only. Branches in other pairs
 * (out of plane, or with even harmonics) are detected by the multipliers. For the Jacobian J of all
 * pairs and the unit tangent t, of which `turn` is the component of the parameter, det [J; t'] =
 * det(J without the parameter)/turn, and the former has the zeros and signs of prod(1 - mu). */
void hawser__orbit_determinant(struct hawser__orbit *orbit, double turn);

/* The multipliers from index `from` on are none: they are far inside the unit circle. */
void hawser__orbit_idle(struct hawser__orbit *orbit, int from);

/* Make orbit->rom the model at the parameter p of the family, if there is one. Returns 1 if there is
 * no such model. */
int hawser__orbit_place(struct hawser__orbit *orbit, double p);

/* The size of the parameter that y [size] ends with, for relative changes. */
static inline double hawser__orbit_extent(const struct hawser__orbit *orbit, const double *y)
{
	return fmax(fabs(y[orbit->size - 1]), orbit->floor);
}

/* The derivative by the parameter that y [size] ends with is taken from the models at the value that
 * is returned, less and plus *wide: the parameter, or one near enough whose models were just made. */
double hawser__orbit_middle(struct hawser__orbit *orbit, double *wide, const double *y);

/* "Omega 1.2 rad/s" or "the parameter 0.3", for messages. */
struct hawser__where {
	char text[64];
};
struct hawser__where hawser__orbit_where(const struct hawser__orbit *orbit, double at);

/* |sum log|mu| + integral of tr D| of the last multipliers, those of an orbit at omega: zero for
 * an exact monodromy matrix. */
double hawser__orbit_liouville(const struct hawser__orbit *orbit, double omega);

static inline struct hawser__metric hawser__orbit_metric(const struct hawser__orbit *orbit)
{
	return (struct hawser__metric){orbit->size, orbit->weight};
}

static inline double hawser__orbit_dot(const struct hawser__orbit *orbit, const double *a,
                                       const double *b)
{
	const struct hawser__metric metric = hawser__orbit_metric(orbit);

	return hawser__metric_dot(&metric, a, b);
}

/* Correct y onto the branch in the plane <row, y - y_pred> = 0, to `tolerance` (defect and step,
 * relative to X). On success, derivatives and factorisation are those at y. Returns 0, or 1 if the
 * iteration did not converge. */
int hawser__orbit_correct(struct hawser__orbit *orbit, double *y,
                          struct hawser__correction *correction, const double *row,
                          double tolerance);

/* Unit tangent t [size] at the last corrected y, from the current factorisation, with a positive
 * component along the row of that factorisation. */
void hawser__orbit_tangent(struct hawser__orbit *orbit, double *t);

/* A row of the table: hawser_frf_method, and the function that opens it. */
struct hawser__orbit_method {
	struct hawser_frf_method about;
	/* The method for a trace with these options (begin is set). */
	enum hawser_status (*open)(struct hawser__orbit **orbit, const struct hawser_rom *rom,
	                           const struct hawser_frf_options *options,
	                           struct hawser_report *report);
	/* Whether this method is the fastest for this model and range, from measurements
	 * (bench/README.md); NULL: if no other one is. */
	int (*suits)(const struct hawser_rom *rom, const struct hawser_frf_options *options);
};

/* methods.c: the row that options->method names; NULL: the one that suits the model.
 * HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser__orbit_method(const struct hawser__orbit_method **method,
                                        const struct hawser_rom *rom,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report);

/* The rows. */
extern const struct hawser__orbit_method hawser__shooting_method;
extern const struct hawser__orbit_method hawser__balance_method;
extern const struct hawser__orbit_method hawser__scales_method;

#endif
