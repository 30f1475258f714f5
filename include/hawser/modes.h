/* hawser/modes.h - linear modes about the static profile.
 *
 * Scaled as in statics.h; frequencies in sqrt(H/rho)/d, so that omega/time_unit is in rad/s.
 * A mode is Phi = P e + Q n + B z, normalised by the integral of Phi.Phi over [0,l] = 1. Its
 * derivative in the local frame is (a, b, c) = (P' - kappa Q, Q' + kappa P, B').
 *
 * All methods return the same structure: shapes and derivatives at the nodes of a composite
 * Gauss-Legendre grid. Later stages do not depend on the method. Sign convention: going from end A,
 * the dominant component is positive where it first reaches 30 % of its largest magnitude.
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

/* Composite Gauss-Legendre grid on [0, l] with `order` nodes per element. */
struct hawser_grid {
	int elements, order;
	int points;     /* elements*order */
	double *edge;   /* [elements+1] scaled arclength of the element ends, edge[0]=0, last = l */
	double *s;      /* [points] ascending */
	double *weight; /* [points] */
	double *node;   /* [order] Gauss nodes on [-1, 1] */
	double *bary;   /* [order] barycentric weights of these nodes */
};

/* A real mode, or a complex one of a travelling cable (gyroscopic.h). */
struct hawser_mode {
	double omega;    /* scaled circular frequency: the imaginary part of the eigenvalue, whose
	                  * conjugate is left out */
	double re;       /* real part of the eigenvalue, scaled: growth. 0 if the mode is real */
	double residual; /* error estimate, not a residual: estimated relative error of omega, round-off
	                  * included, meant to exceed the true error (doc/theory-modes.md) */
	double condition; /* condition number of the eigenvalue: the largest ratio of its relative error
	                   * to that of the matrices; 1 if the mode is real */
	enum hawser_plane plane;
	int place, number; /* from 1, by frequency: among all modes, and among those of its plane */
	enum hawser_family family;     /* by the larger share of the kinetic energy */
	enum hawser_symmetry symmetry; /* of the dominant component about s = l/2: symmetric if its even
	                                * part has 99 % or more of its energy, antisymmetric if 1 % or
	                                * less; mixed if the mode is complex */
	/* Shares of the integral of |Phi|^2 (of a real mode: of the kinetic energy): those of |P|^2
	 * (along the cable), |Q|^2 and |B|^2. Sum 1. */
	double axial_share, normal_share, out_of_plane_share;
	/* Share, 0 to 1, of the kinetic energy of the particles, travel included, that belongs to the
	 * waves running downstream: 1/2 at rest. It decreases with the speed, since the waves running
	 * upstream are slower and steeper. */
	double downstream;
	/* [2] bending moment EI phi' at ends A and B, phi the rotation of the tangent, in N m per m of the
	 * largest displacement of the mode; 0 at pinned ends and without bending stiffness */
	double moment[2];
	double moment_error; /* estimated error of both, relative to the larger one */
	/* [3] integrals of Phi.x, Phi.y, Phi.z over [0,l], along the global axes, scaled; 0 if the mode
	 * is complex */
	double participation[3];
	/* [3] modal effective mass along x, y, z over the mass of the cable, rho*L: participation^2/l.
	 * Summed over all real modes it is 1 along each axis; 0 if the mode is complex */
	double effective_mass[3];
};

struct hawser_modes {
	struct hawser_statics statics;
	const char *method;         /* static string, the method's name */
	int gyroscopic;             /* 0: real modes, parts is 1; 1: complex modes of a travelling cable
	                             * (gyroscopic.h), parts is 2: real, imaginary */
	int n;                      /* number of modes, by ascending omega, both planes together */
	int spanned;                /* 1: shapes of the space of complex modes (gyroscopic.h) */
	int basis;                  /* functions per component in the final solution */
	double time_unit;           /* d*sqrt(rho/H), s */
	struct hawser_mode *mode;   /* [n] */
	struct hawser_grid grid;
	double *shape;              /* [n][parts][points][3] P, Q, B */
	double *slope;              /* [n][parts][points][3] a, b, c */
	double *stroke;             /* [n][attachments] of the absorbers along their directions, relative to
	                             * the cable, in the order of statics.attached; 0 where there is none.
	                             * NULL if there is no absorber at all. They are part of the norm */
};

/* Settings of all methods. */
struct hawser_modes_options {
	int n;            /* number of modes, >= 1: the lowest of both planes together */
	int basis;        /* functions per component; 0: as many as `tolerance` requires */
	double tolerance; /* required relative error of each frequency, used if basis is 0; 0: the
	                   * default of the method (its row in the table) */
	const char *method; /* NULL: "spectral" */
	int any_error;    /* 0: fail if the error estimate of a mode is 1 or more, since no digit of its
	                   * frequency is known; 1: return it anyway, to compare methods */
};

/* A method for real modes or for complex ones: its name, a summary of one line, its source, its
 * default tolerance, its function. */
struct hawser_modes_method {
	const char *name, *summary, *source;
	double tolerance; /* default; INFINITY: any error estimate is accepted and reported */
	enum hawser_status (*solve)(struct hawser_modes *modes, const struct hawser_statics *statics,
	                            const struct hawser_modes_options *options,
	                            struct hawser_report *report);
};
/* Row `index` of the table of methods for real modes, from 0, the default first; NULL beyond the
 * last. Static storage. */
const struct hawser_modes_method *hawser_modes_method(int index);

/* Compute real modes: of the cable at rest, or of the apparent cable (struct hawser_motion) of one
 * that travels. *modes is overwritten; release it with hawser_modes_clear. Returns
 * HAWSER_ERR_ARGUMENT (n < 1, unknown method, more modes than the basis has functions, tolerance
 * outside [0, 1), invalid statics), HAWSER_ERR_NO_SOLUTION (inextensible cable: the longitudinal
 * stiffness is infinite), HAWSER_ERR_CONVERGENCE (the report has the largest error estimate, or
 * that of the first mode for which it is 1 or more), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_modes_solve(struct hawser_modes *modes,
                                      const struct hawser_statics *statics,
                                      const struct hawser_modes_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Relative gap of frequencies within a cluster of modes: a model that has one of them has all, or it
 * misses how they drive each other. */
#define HAWSER_CLUSTER 0.01

/* 1: modes j - 1 and j (from 0) are of one cluster. */
int hawser_modes_near(const struct hawser_modes *modes, int j);

/* Where the scene gives no number of modes, scene->model.modes becomes larger by those of the cluster
 * that it cuts; it stays where they cannot be computed. With model.modes: auto and a wind, but no load,
 * it becomes the number of lowest modes with all that grow up to twice the speed of the wind. */
void hawser_modes_settle(struct hawser_scene *scene, const struct hawser_statics *statics);

/* All Galerkin modes of a basis with in_plane functions per component in the plane and out_of_plane
 * functions out of it (0: no modes of that plane). The shapes are orthonormal and the energy is
 * diagonal. The lowest modes are converged, the highest ones are not (see `residual`). Together
 * they span the polynomial basis and serve as the coordinates of a full-order model. There are
 * 2*in_plane + out_of_plane modes, slightly fewer if a deep sag requires several elements. Statuses
 * as above, without _CONVERGENCE. */
enum hawser_status hawser_modes_basis(struct hawser_modes *modes,
                                      const struct hawser_statics *statics, int in_plane,
                                      int out_of_plane, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Shape (P, Q, B) and local-frame derivative (a, b, c) of mode k at scaled arclength s.
 * `shape` and `slope` are [3 parts]: of a complex mode the real parts first; slope may be NULL. */
void hawser_modes_at(const struct hawser_modes *modes, double *shape, double *slope, int k,
                     double s);

/* Matrices of the travel speed in real modes (scaled; doc/theory-travel.md), integrated on the grid:
 * G [n][n] with G_jk the integral of Phi_j . Phi_k', exactly skew; D [n][n] with the integrals of
 * Phi_j' . Phi_k'; g and d [n] with those of Phi_j . x' and Phi_j' . x', where x is the static
 * profile. Each may be NULL. */
void hawser_modes_convection(const struct hawser_modes *modes, double *G, double *D, double *g,
                             double *d);

/* Error of a mode with respect to a reference mode of the same span. */
struct hawser_modes_error {
	int partner;      /* index of the reference mode: the i-th mode of a plane is paired with the
	                   * i-th, unless swapping two neighbours increases both correlations */
	double frequency; /* relative: distance of the eigenvalues over the reference's modulus */
	double shape;     /* square root of the integral of |Phi - Phi_ref|^2 over [0,l]; if frequencies
	                   * of a plane are within 0.1 % of each other, their reference shapes are first
	                   * replaced by the nearest orthonormal combinations. Of complex modes: the
	                   * smallest for any phase */
};
/* error [modes->n]. The reference should have a few more modes. Returns HAWSER_ERR_ARGUMENT (spans
 * of different length; real modes and complex ones; a plane in which the reference has fewer modes),
 * HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_modes_compare(struct hawser_modes_error *error,
                                        const struct hawser_modes *modes,
                                        const struct hawser_modes *reference,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* A result with `count` of the modes, whose indices kept[count] are ascending; `place` and `number`
 * keep their values. *subset is overwritten; release it with hawser_modes_clear. A reduced model of
 * the subset condenses all other modes. Statuses: HAWSER_ERR_ARGUMENT (count is 0, an index is out
 * of range or not ascending), HAWSER_ERR_MEMORY. */
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
