/* modes/compliance.h - eigenpairs of a cable's compliance in one plane (doc/theory-modes.md).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_COMPLIANCE_H
#define HAWSER_MODES_COMPLIANCE_H

#include "modes/grid.h"

/* One plane of motion: D strains, D displacements, and the displacement gradient that a unit of
 * each strain gives, direction[strain][displacement][points]. The strain energy is the integral of
 * the squared strains over 2: the directions carry the stiffness. */
enum { HAWSER__MAX_D = 2 };
struct hawser__plane {
	int D;
	const double *direction;
};

/* What comes out: `count` pairs, ascending omega; fields for those that were refined. */
struct hawser__pairs {
	int count, degree;
	double *omega;        /* [count] */
	double *moved;        /* [count] relative change of omega in the refinement */
	double *x;            /* [count][D*degree*elements] coefficients, descending omega */
	double *strain;       /* [refined][D][points] */
	double *displacement; /* [refined][D][points] */
};

/* The lowest `count` pairs with `degree` Legendre polynomials a strain and element. count is cut to
 * what the basis carries: (degree*elements - 1)*D. Statuses: _MEMORY, _NAN, _CONVERGENCE. */
enum hawser_status hawser__compliance_solve(struct hawser__pairs *pairs,
                                            const struct hawser__plane *plane,
                                            const struct hawser_grid *grid,
                                            const struct hawser__reference *reference, int degree,
                                            int count, struct hawser_report *report);

/* Two steps of inverse iteration with the exact compliance, on the grid and not in the basis, for
 * the first `count` pairs: each gets the strains and displacements of the force that its own inertia
 * asks for, and the Rayleigh quotient of these as frequency. moved[k], what the first step changes,
 * is the error that omega had before, to leading order. Displacements come out orthonormal. */
enum hawser_status hawser__compliance_refine(struct hawser__pairs *pairs,
                                             const struct hawser__plane *plane,
                                             const struct hawser_grid *grid,
                                             const struct hawser__reference *reference, int count,
                                             struct hawser_report *report);

/* displacement[D][points] becomes omega^2 times what its own inertia makes of it, with exact
 * compliance; strain[D][points] is the strain of that. work[D + 1][points]. */
void hawser__compliance_apply(double *displacement, double *strain, double omega,
                              const struct hawser__plane *plane, const struct hawser_grid *grid,
                              const struct hawser__reference *reference, double *work);

/* Strains [D][points] of the coefficients x[D*degree*elements], of which strain k, polynomial j on
 * element e stand at (e*D + k)*degree + j. */
void hawser__compliance_strain(double *strain, const double *x, int D,
                               const struct hawser_grid *grid,
                               const struct hawser__reference *reference, int degree);

/* Displacements [D][points] that strain[D][points] makes from end A on, and those of end B, end[D].
 * gradient [points] is work. */
void hawser__compliance_displace(double *displacement, double *end, double *gradient,
                                 const double *strain, const struct hawser__plane *plane,
                                 const struct hawser_grid *grid,
                                 const struct hawser__reference *reference);

/* Integral of a[D][points] times b[D][points]. */
double hawser__compliance_product(const double *a, const double *b, int D,
                                  const struct hawser_grid *grid);

void hawser__pairs_clear(struct hawser__pairs *pairs);

/* An eigenvalue of a Hermitian matrix of this order is round-off where it is not above so much of the
 * largest one. */
double hawser__eigen_floor(int order);

/* Refuses a mode whose eigenvalue is round-off: the number-th of its plane, above `lowest`.
 * Status: _NAN. */
enum hawser_status hawser__eigen_lost(int number, int in_plane, double lowest,
                                      struct hawser_report *report);

#endif
