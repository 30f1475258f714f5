/* rom/energy/exact.h - a model with the exact strain energy, without expansion: see exact.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_EXACT_H
#define HAWSER_ROM_EXACT_H

#include <stddef.h>

#include <hawser/rom.h>

#include "core/hold.h"
#include "rom/condense/bend.h"

/* The coordinates are separated by plane: `in` of them determine a and b, the other `out` determine
 * c. In space all n of them do both: in = out = n, and `other` is 0. */
struct hawser_rom_exact {
	int n, in, out, points;
	int other;       /* where the coordinates of c begin in the order of `index` */
	int collocated;  /* 1: number of points = number of polynomials of the strains (exact.c) */
	struct hawser_grid grid; /* the quadrature points */
	int *index;      /* [n] index in the model of the in-plane coordinates, then of the others */
	double *weight;  /* [points] weight/eps */
	double *strain;  /* [points] g - 1 */
	double *slope;   /* [points][2][in] a and b of the in-plane coordinates */
	double *slope_z; /* [points][out] c of the others */
	/* products of slopes, in which the tangent is linear with the stiffness of the points as
	 * coefficients (exact_block.c); the pair j <= k of one kind has the index k(k+1)/2 + j */
	double *pairs_in;  /* [points][3][in(in+1)/2] a a, a b + b a, b b */
	double *pairs_out; /* [points][out(out+1)/2] c c */
	double *mixed;     /* [points][2][in][out] a c, b c */
	double *springs;   /* [n][n] in the order of the model: stiffness of attachments and by
	                    * bending (exact_bend.c), or NULL */
	int cubics;        /* absorbers with a cubic spring; only with springs */
	double *cubic;     /* [cubics] k3 */
	double *stroke;    /* [cubics][n] */
	int supports;      /* shapes of moving supports, as in `ends` of the model (ends.h) */
	double *support;   /* [supports][points][3] a, b, c of the quasi-static displacement */
	double *pull;      /* [supports][n] its force at the coordinates by `springs`, or NULL */
	struct hawser__hold hold; /* its arrays */
};

/* Stress and stiffness at a point, without the part that balances the weight. */
struct hawser__stress {
	double a, b, c; /* conjugate to a, b, c: derivatives of the energy density */
	double aa, ab, bb, ac, bc, cc;
};

/* The energy of `modes` (n of them, in the order of the model), by a Gauss rule of `order` points
 * in each element of their grid. Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__exact_new(struct hawser_rom_exact **exact, const struct hawser_modes *modes,
                                     int order, struct hawser_report *report);
void hawser__exact_free(struct hawser_rom_exact *exact);

/* Restoring force [n] and, unless NULL, tangent [n][n] at u [n]. */
void hawser__exact_tangent(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                           const double *u);
/* The same with the supports displaced by the factors s [supports]; NULL for none. */
void hawser__exact_moved(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                         const double *u, const double *s);

/* Give the model the motion of the scene's supports. support_exact.c. */
enum hawser_status hawser__exact_support(struct hawser_rom_exact *exact,
                                         const struct hawser_modes *modes,
                                         const struct hawser_scene *scene,
                                         struct hawser_report *report);
/* Add to restoring [n] and, unless NULL, to tangent [n][n] what the supports change, which are
 * displaced by the factors s [supports]. */
void hawser__exact_vary(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                        const double *u, const double *s);

/* hawser__rom_tangents (kernel.h) for it: exact_block.c. */
size_t hawser__exact_work(const struct hawser_rom_exact *exact, int count);
void hawser__exact_tangents(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                            const double *u, int count, double *work);

/* Add the force [n] and, unless NULL, the tangent [n][n] of springs. */
void hawser__exact_springs(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                           const double *u);

/* Potential at u [n], 0 at rest. */
double hawser__exact_potential(const struct hawser_rom_exact *exact, const double *u);

/* strain[points] = |q'| - 1 at the quadrature points, at u [n], with the supports displaced by s
 * [supports] or, with NULL, not at all. */
void hawser__exact_strain(const struct hawser_rom_exact *exact, double *strain, const double *u,
                          const double *s);

/* At point p, for local strains (a, b, c), without the factor of the quadrature weight. */
struct hawser__stress hawser__exact_stress(const struct hawser_rom_exact *exact, int p, double a,
                                           double b, double c);

/* --- exact_bend.c: bending stiffness in a model with the exact energy --- */

/* Add the stiffness by bending to matrix [n][n], in the order of the model, once the slopes at the
 * quadrature points are set. Nothing without cable.EI. Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__exact_bend(double *matrix, const struct hawser_rom_exact *exact,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report);

/* Add to pull [n] the force on the coordinates by bending of a displacement with the strain
 * [points of the modes' grid][3], which is `at` [points][3] at the quadrature points. */
enum hawser_status hawser__exact_bend_pull(double *pull, const struct hawser_rom_exact *exact,
                                           const struct hawser_modes *modes, const double *strain,
                                           const double *at, struct hawser_report *report);

#endif
