/* hawser/modes.h - linear modes about the static profile.
 *
 * Scaled as in statics.h; frequencies in 1/(d*sqrt(rho/H)), and omega*time_unit in rad/s.
 * A mode is Phi = P e + Q n + B z, normalised by the integral of Phi.Phi over [0,l] = 1. Its
 * derivative in the local frame is (a, b, c) = (P' - kappa Q, Q' + kappa P, B').
 *
 * Whatever the method, a result is the same thing: shapes and derivatives at the nodes of a
 * composite Gauss-Legendre grid. So nothing downstream knows which method made it. Sign: from end
 * A on, where the dominant component first comes to 30 % of its largest magnitude, it is positive.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_H
#define HAWSER_MODES_H

#include <hawser/statics.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_plane { HAWSER_IN_PLANE = 0, HAWSER_OUT_OF_PLANE };
enum hawser_family { HAWSER_TRANSVERSE = 0, HAWSER_LONGITUDINAL };
enum hawser_symmetry { HAWSER_SYMMETRIC = 0, HAWSER_ANTISYMMETRIC, HAWSER_MIXED };

/* Composite Gauss-Legendre grid on [0, l]: `elements` elements with `order` nodes each. */
struct hawser_grid {
	int elements, order;
	int points;     /* elements*order */
	double *edge;   /* [elements+1] scaled arclength of the element ends, edge[0]=0, last = l */
	double *s;      /* [points] ascending */
	double *weight; /* [points] */
	double *node;   /* [order] Gauss nodes on [-1, 1] */
	double *bary;   /* [order] barycentric weights of these nodes */
};

struct hawser_mode {
	double omega;    /* scaled circular frequency */
	double residual; /* omega's relative error as the method estimates it, on the safe side and with
	                  * round-off; doc/theory-modes.md says how */
	enum hawser_plane plane;
	int place, number; /* from 1, by frequency: among all modes, and among those of its plane */
	enum hawser_family family;     /* by the larger share of the kinetic energy */
	enum hawser_symmetry symmetry; /* of the dominant component about s = l/2; symmetric when 99 % of
	                                * its energy is, antisymmetric when at most 1 % */
	/* Shares of the kinetic energy: the integrals of P^2 (along the cable), Q^2 and B^2. Sum 1. */
	double axial_share, normal_share, out_of_plane_share;
	/* [3] integrals of Phi.x, Phi.y, Phi.z over [0,l], global axes: scaled, as the shapes are */
	double participation[3];
	/* [3] modal effective mass along x, y, z over the mass of the cable, rho*L: participation^2/l.
	 * Summed over all modes it is 1 along each axis */
	double effective_mass[3];
};

struct hawser_modes {
	struct hawser_statics statics;
	const char *method;         /* static string, the method's name */
	int n;                      /* number of modes, ascending omega, both planes together */
	int basis;                  /* functions a component finally used */
	double time_unit;           /* d*sqrt(rho/H), s */
	struct hawser_mode *mode;   /* [n] */
	struct hawser_grid grid;
	double *shape;              /* [n][points][3] P, Q, B */
	double *slope;              /* [n][points][3] a, b, c */
};

/* Settings every method takes. */
struct hawser_modes_options {
	int n;            /* modes wanted, >= 1, lowest of both planes together */
	int basis;        /* functions a component; 0: as many as `tolerance` needs */
	double tolerance; /* relative error asked of each frequency, where the basis is not given; 0: the
	                   * method's own (its row in the table) */
	const char *method; /* NULL: "spectral" */
	int any_error;    /* 0: refused where the residual of one mode is 1 or more, for nothing is
	                   * known of that one; 1: given all the same, to compare methods */
};

/* A method is a row: its name, one line about it, its source, its default tolerance, the function. */
struct hawser_modes_method {
	const char *name, *summary, *source;
	double tolerance; /* default; INFINITY: any error is taken, and stated */
	enum hawser_status (*solve)(struct hawser_modes *modes, const struct hawser_statics *statics,
	                            const struct hawser_modes_options *options,
	                            struct hawser_report *report);
};
/* The rows, *count of them. Static storage. */
const struct hawser_modes_method *hawser_modes_methods(int *count);

/* Solve; *modes is overwritten, release with hawser_modes_clear. Returns HAWSER_ERR_ARGUMENT
 * (n < 1, unknown method, more modes than the basis can carry, tolerance outside [0, 1), statics that
 * make no sense), HAWSER_ERR_NO_SOLUTION (inextensible cable: longitudinal stiffness is infinite),
 * HAWSER_ERR_CONVERGENCE (the report has the worst estimate, or that of the first mode whose residual
 * is 1 or more), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_modes_solve(struct hawser_modes *modes,
                                      const struct hawser_statics *statics,
                                      const struct hawser_modes_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Everything a basis of so many functions a component carries in the plane and out of it (0: nothing of
 * that plane), as modes: the stationary values of Galerkin's problem, with orthonormal shapes and
 * diagonal energy, of which the lowest are converged and the uppermost are not (`residual` tells).
 * Together they span the polynomials: what a full-order model moves in. 2*in_plane + out_of_plane
 * modes, a few less where a deep sag needs elements. Statuses as above, without _CONVERGENCE. */
enum hawser_status hawser_modes_basis(struct hawser_modes *modes,
                                      const struct hawser_statics *statics, int in_plane,
                                      int out_of_plane, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Shape (P, Q, B) and local-frame derivative (a, b, c) of mode k at scaled arclength s.
 * `shape` and `slope` are [3]; slope may be NULL. */
void hawser_modes_at(const struct hawser_modes *modes, double *shape, double *slope, int k,
                     double s);

/* What travelling couples (scaled; doc/theory-travel.md), from the shapes on the grid: G [n][n] with
 * G_jk the integral of Phi_j . Phi_k', skew to the last bit; D [n][n] that of Phi_j' . Phi_k'; g and d
 * [n] those of Phi_j . x' and Phi_j' . x' with the static x. Each may be NULL. */
void hawser_modes_convection(const struct hawser_modes *modes, double *G, double *D, double *g,
                             double *d);

/* What a mode is off a reference mode of the same span. */
struct hawser_modes_error {
	int partner;      /* index of the reference mode: the i-th of the plane belongs to the i-th, but
	                   * for neighbours that both look more like the other's */
	double frequency; /* relative */
	double shape;     /* square root of the integral of |Phi - Phi_ref|^2 over [0,l]; reference modes
	                   * of a plane within 0.1 % of each other are turned as a group beforehand */
};
/* error [modes->n]. The reference should have a few modes more. Returns HAWSER_ERR_ARGUMENT (spans of
 * different length; a plane in which the reference has fewer modes), HAWSER_ERR_NAN,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_modes_compare(struct hawser_modes_error *error,
                                        const struct hawser_modes *modes,
                                        const struct hawser_modes *reference,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* A result with `count` of the modes, kept[count] their indices in ascending order; `place` and
 * `number` stay what they were. *subset is overwritten, release with hawser_modes_clear. A reduced
 * model of it condenses all the others. Statuses: HAWSER_ERR_ARGUMENT (none, an index out of range, not
 * ascending), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_modes_select(struct hawser_modes *subset,
                                       const struct hawser_modes *modes, const int *kept,
                                       int count, struct hawser_report *report) HAWSER_MUST_CHECK;

void hawser_modes_clear(struct hawser_modes *modes);

const char *hawser_plane_name(enum hawser_plane plane);          /* "in-plane" */
const char *hawser_family_name(enum hawser_family family);       /* "transverse" */
const char *hawser_symmetry_name(enum hawser_symmetry symmetry); /* "symmetric" */

#ifdef __cplusplus
}
#endif
#endif
