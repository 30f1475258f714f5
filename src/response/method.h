/* response/method.h - what the continuation needs of a method for forced periodic orbits.
 *
 *   y       unknowns [size]: what represents the orbit, then Omega
 *   metric  <a, b> = sum over i of weight_i a_i b_i. |dy| is a relative change of the orbit, by
 *           components, together with that of Omega over its natural width W: an arclength step has
 *           the same meaning for every model, and nothing has to be tuned by hand
 *   plane   a correction stays in <row, y - y_predicted> = 0: the row is the metric's dual of a
 *           direction
 *
 * A method is a row of the table in methods.c and a structure that begins with struct
 * hawser__orbit. The continuation owns the order of the calls: metric; defects with derivatives;
 * factor; solve; then, for an accepted point, multipliers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_METHOD_H
#define HAWSER_RESPONSE_METHOD_H

#include <hawser/frf.h>

#include "continuation/curve.h"
#include "continuation/metric.h"

struct hawser__orbit_ops;

/* The metric of all orbits, so that steps have the same length in every method: its width in Omega,
 * as a fraction of Omega (a resonance of 2.5 % damping), and the least size that a component has in
 * it, as a fraction of the orbit's. */
#define HAWSER_OMEGA_WIDTH 0.05
#define HAWSER_SCALE_FLOOR 0.003

struct hawser__orbit {
	const struct hawser__orbit_ops *ops;
	const struct hawser_rom *rom;
	int n, m;             /* coordinates; states, 2n */
	int size;             /* unknowns, Omega the last */
	double X, W;          /* metric: size of the orbit (its state), natural width in Omega */
	double *weight;       /* [size] metric */
	double mesh;          /* estimated error of the discretisation of the last orbit, absolute */
	double *samples;      /* [rows][n] u at equidistant phases from 0, of the last defects */
	int rows;
	int resolution;       /* steps a period, or real coefficients a coordinate */
	double *log_modulus, *argument; /* [m] of the last multipliers */
	/* Of the last multipliers, beside what the orbit is off by: error of the matrix whose eigenvalues
	 * they are, of which round-off alone, and error of their logarithms beside that. */
	double product_error, product_round_off, multiplier_error;
	double round_off;     /* of the last `error`, what round-off contributes */
	double det_sign, det_log; /* of the bordered Jacobian of the last factorisation */
	double reach;         /* metric: how far the orbit is from the one before; 0: not to be looked at */
	double rate;          /* by what factor a step with a guessed Jacobian lowers the defects */
	double *step, *spare; /* [size] scratch of the corrector and of the metric */
	struct hawser_orbit_cost cost;
};

struct hawser__orbit_ops {
	/* Set X, W and weight from the orbit y [size]. */
	void (*metric)(struct hawser__orbit *orbit, const double *y);

	/* Defects at y, kept for solve; with derive also the Jacobian, the samples and the mesh error.
	 * Returns the largest defect over X; NaN or infinity when there is none. */
	double (*defects)(struct hawser__orbit *orbit, const double *y, int derive);

	/* Factorise the Jacobian with `row` [size] as the border. 1 when singular. */
	int (*factor)(struct hawser__orbit *orbit, const double *row);

	/* dy [size]: J dy = -defects (0 where homogeneous) and <row, dy> = last. */
	void (*solve)(struct hawser__orbit *orbit, double *dy, int homogeneous, double last);

	/* Estimated distance, over X, of the orbit last corrected from the true branch, where `residual`
	 * is its largest defect over X. Infinite where the orbit is not determined. */
	double (*error)(struct hawser__orbit *orbit, double residual);

	/* Floquet multipliers of the orbit at the last derived defects; and the determinant's sign and
	 * logarithm where a coordinate at rest is not in the factorised Jacobian. */
	enum hawser_status (*multipliers)(struct hawser__orbit *orbit, struct hawser_report *report);

	/* After a correction to `tolerance`: a finer discretisation where the mesh error asks for it,
	 * and *again = 1 (correct anew), or 0 where it is fine enough. HAWSER_ERR_CONVERGENCE at the
	 * limit. */
	enum hawser_status (*refine)(struct hawser__orbit *orbit, int *again, double tolerance,
	                             double omega, struct hawser_report *report);
	/* A coarser one for the next point, where this one is finer than needed. */
	enum hawser_status (*relax)(struct hawser__orbit *orbit, double tolerance,
	                            struct hawser_report *report);
	/* A finer one whatever the error, because no orbit was found. */
	enum hawser_status (*enrich)(struct hawser__orbit *orbit, struct hawser_report *report);

	/* With `on`: a discretisation whose error is at least ten times smaller than that of the last
	 * defects, to compare with; HAWSER_ERR_CONVERGENCE where there is none. Else: the former one
	 * again. Either way the next call must be defects. */
	enum hawser_status (*sharpen)(struct hawser__orbit *orbit, int on,
	                              struct hawser_report *report);

	/* y += p cos(k tau) + q sin(k tau), pq [2n]. */
	void (*add_wave)(struct hawser__orbit *orbit, double *y, const double *pq, int k, double omega);
	/* A guess of y from the state x [m] at phase 0. */
	enum hawser_status (*from_state)(struct hawser__orbit *orbit, double *y, const double *x,
	                                 double omega, struct hawser_report *report);
	/* State x [m] at phase 0 of y. */
	void (*state)(const struct hawser__orbit *orbit, double *x, const double *y);

	/* Releases orbit itself. */
	void (*clear)(struct hawser__orbit *orbit);

	/* Both or none. keep: remember the Jacobian of the corrected orbit y. guess: the Jacobian near
	 * y, where the plane's normal is `row`, from remembered ones; 0 when there is none. */
	void (*keep)(struct hawser__orbit *orbit, const double *y);
	int (*guess)(struct hawser__orbit *orbit, const double *y, const double *row);
};

/* The base's arrays (not the samples), for a method's open and clear. */
enum hawser_status hawser__orbit_init(struct hawser__orbit *orbit, const struct hawser_rom *rom,
                                      int size, struct hawser_report *report);
void hawser__orbit_free(struct hawser__orbit *orbit);

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
 * relative to X). On success the derivatives and the factorisation are those at y. Returns 0, or 1
 * when it did not converge. */
int hawser__orbit_correct(struct hawser__orbit *orbit, double *y,
                          struct hawser__correction *correction, const double *row,
                          double tolerance);

/* Unit tangent t [size] at the last corrected y, from the current factorisation, on the side to
 * which that factorisation's row points. */
void hawser__orbit_tangent(struct hawser__orbit *orbit, double *t);

/* A row of the table: hawser_frf_method, and how to begin. */
struct hawser__orbit_method {
	struct hawser_frf_method about;
	/* The method for a trace with these options (begin is set). */
	enum hawser_status (*open)(struct hawser__orbit **orbit, const struct hawser_rom *rom,
	                           const struct hawser_frf_options *options,
	                           struct hawser_report *report);
	/* Whether it is the faster one for this model and range, measured (bench/README.md); NULL:
	 * wherever no other is. */
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
