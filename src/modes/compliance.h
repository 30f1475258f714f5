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

/* The result: `count` pairs by ascending omega; fields of the refined pairs. */
struct hawser__pairs {
	int count, degree;
	double *omega;        /* [count] */
	double *moved;        /* [count] relative change of omega in the refinement */
	double *x;            /* [count][D*degree*elements] coefficients, descending omega */
	double *strain;       /* [refined][D][points] */
	double *displacement; /* [refined][D][points] */
};

/* The lowest `count` pairs with `degree` Legendre polynomials per strain and element. count is
 * reduced to the size of the basis, (degree*elements - 1)*D, if it is larger. Statuses: _MEMORY,
 * _NAN, _CONVERGENCE. */
enum hawser_status hawser__compliance_solve(struct hawser__pairs *pairs,
                                            const struct hawser__plane *plane,
                                            const struct hawser_grid *grid,
                                            const struct hawser__reference *reference, int degree,
                                            int count, struct hawser_report *report);

/* Refine the first `count` pairs by two steps of inverse iteration with the exact compliance, on
 * the grid and not in the basis. A step computes strains and displacements under the inertial force
 * of the mode, and the frequency as their Rayleigh quotient. moved[k], the relative change by the
 * first step, is to leading order the error of omega before it. The displacements are
 * orthonormal. */
enum hawser_status hawser__compliance_refine(struct hawser__pairs *pairs,
                                             const struct hawser__plane *plane,
                                             const struct hawser_grid *grid,
                                             const struct hawser__reference *reference, int count,
                                             struct hawser_report *report);

/* Replace displacement[D][points] by omega^2 times the exact compliance applied to it: the
 * displacement under its own inertial force. strain[D][points] is the strain of the result. work[D
 * + 1][points]. */
void hawser__compliance_apply(double *displacement, double *strain, double omega,
                              const struct hawser__plane *plane, const struct hawser_grid *grid,
                              const struct hawser__reference *reference, double *work);

/* Strains [D][points] from the coefficients x[D*degree*elements]; the coefficient of strain k,
 * polynomial j and element e has the index (e*D + k)*degree + j. */
void hawser__compliance_strain(double *strain, const double *x, int D,
                               const struct hawser_grid *grid,
                               const struct hawser__reference *reference, int degree);

/* Displacements [D][points] of strain[D][points], integrated from end A, and the displacement
 * end[D] of end B. gradient [points] is work space. */
void hawser__compliance_displace(double *displacement, double *end, double *gradient,
                                 const double *strain, const struct hawser__plane *plane,
                                 const struct hawser_grid *grid,
                                 const struct hawser__reference *reference);

/* Integral of a[D][points] times b[D][points]. */
double hawser__compliance_product(const double *a, const double *b, int D,
                                  const struct hawser_grid *grid);

void hawser__pairs_clear(struct hawser__pairs *pairs);

/* Round-off of the eigenvalues of a Hermitian matrix of this order, relative to the largest one.
 * Smaller eigenvalues are undetermined. */
double hawser__eigen_floor(int order);

/* Fail with _NAN since the eigenvalue of a requested mode, with the given number in its plane, is
 * round-off; `lowest` is the lowest frequency. */
enum hawser_status hawser__eigen_lost(int number, int in_plane, double lowest,
                                      struct hawser_report *report);

#endif
