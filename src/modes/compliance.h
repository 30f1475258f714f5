/* modes/compliance.h - eigenpairs of a cable's compliance in one plane (doc/theory-modes.md).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_COMPLIANCE_H
#define HAWSER_MODES_COMPLIANCE_H

#include "modes/grid.h"

/* One plane of motion: D strains, D displacements, and the displacement gradient that a unit of
 * each strain gives, direction[strain][displacement][points]. The strain energy is the integral of
 * the squared strains over 2: the directions carry the stiffness. */
enum { HAWSER__MAX_D = 3, HAWSER__MAX_SPRINGS = HAWSER__MAX_D*HAWSER_ATTACH_MAX,
       HAWSER__MAX_JOINTS = 2*HAWSER__MAX_D, HAWSER__MAX_LUMPS = HAWSER_ATTACH_MAX + 2,
       HAWSER__MAX_ABSORBERS = HAWSER_ATTACH_MAX };

/* A point mass, scaled, at an edge of elements, the first and the last included; it may be 0. */
struct hawser__lump {
	int edge;
	double mass;
};

/* A spring to ground from a lump. Its strain is g.X with the displacement X of the lump, so that its
 * energy, too, is half of the square of its strain: g is the direction times sqrt(stiffness). */
struct hawser__spring {
	int lump;
	double g[HAWSER__MAX_D];
};

/* The spring of an elastic support, between the fixed foundation and end A, or end B and its
 * foundation: a strain at that point, whose unit displaces all that is beyond it by d, the direction
 * over sqrt(stiffness). A rigid direction is d = 0, or none. */
struct hawser__joint {
	int end; /* 0: A, 1: B */
	double d[HAWSER__MAX_D];
};

/* A mass that moves along the unit vector a relative to its lump, on a spring of stiffness 1/root^2,
 * whose strain is a further unknown: a unit of it is the stroke `root`. Across a it moves with the
 * lump. */
struct hawser__absorber {
	int lump;
	double mass, root, a[HAWSER__MAX_D];
};

struct hawser__plane {
	int D;
	const double *direction;
	int lumps, springs, joints, absorbers;
	const struct hawser__lump *lump;     /* [lumps] ascending edge */
	const struct hawser__spring *spring; /* [springs] ascending lump */
	const struct hawser__joint *joint;   /* [joints]; with them the first and the last lump are ends */
	const struct hawser__absorber *absorber; /* [absorbers] ascending lump */
};

/* Strains are [D][points], followed by those of the springs, of the joints and of the absorbers;
 * displacements are [D][points], followed by those of the lumps, [D][lumps], and of the masses of the
 * absorbers, [D][absorbers]. The sizes of both: */
static inline size_t hawser__strains(const struct hawser__plane *plane,
                                     const struct hawser_grid *grid)
{
	return (size_t)plane->D*(size_t)grid->points + (size_t)plane->springs + (size_t)plane->joints +
	       (size_t)plane->absorbers;
}

static inline size_t hawser__displacements(const struct hawser__plane *plane,
                                           const struct hawser_grid *grid)
{
	return (size_t)plane->D*((size_t)grid->points + (size_t)plane->lumps + (size_t)plane->absorbers);
}

/* Row i of the displacements behind those of the cable: its mass, and the lump where it acts. */
static inline double hawser__row_mass(int *lump, const struct hawser__plane *plane, int i)
{
	const struct hawser__absorber *absorber;

	if (i < plane->D*plane->lumps) {
		*lump = i%plane->lumps;
		return plane->lump[*lump].mass;
	}
	absorber = &plane->absorber[(i - plane->D*plane->lumps)%plane->absorbers];
	*lump = absorber->lump;
	return absorber->mass;
}

/* The result: `count` pairs by ascending omega; fields of the refined pairs. */
struct hawser__pairs {
	int count, degree;
	double *omega;        /* [count] */
	double *moved;        /* [count] relative change of omega in the refinement */
	double *x;            /* [count][D*degree*elements + springs + joints + absorbers] by descending
	                       * omega */
	double *strain;       /* [refined][strains] */
	double *displacement; /* [refined][displacements] */
};

/* The lowest `count` pairs with `degree` Legendre polynomials per strain and element. count is
 * reduced to the size of the basis, (degree*elements - 1)*D + joints + absorbers, if it is larger.
 * Statuses: _MEMORY, _NAN, _CONVERGENCE. */
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

/* Replace displacement[displacements] by omega^2 times the exact compliance applied to it: the
 * displacement under its own inertial force. strain[strains] is the strain of the result. work[D
 * + 1][points]. */
void hawser__compliance_apply(double *displacement, double *strain, double omega,
                              const struct hawser__plane *plane, const struct hawser_grid *grid,
                              const struct hawser__reference *reference, double *work);

/* Strains from the coefficients x[D*degree*elements + springs + joints + absorbers]; the coefficient of
 * strain k, polynomial j and element e has the index (e*D + k)*degree + j, those of springs, joints and
 * absorbers follow. */
void hawser__compliance_strain(double *strain, const double *x, const struct hawser__plane *plane,
                               const struct hawser_grid *grid,
                               const struct hawser__reference *reference, int degree);

/* Displacements of strains, integrated from end A, and the displacement end[D] of end B, or of its
 * foundation. gradient [points] is work space. */
void hawser__compliance_displace(double *displacement, double *end, double *gradient,
                                 const double *strain, const struct hawser__plane *plane,
                                 const struct hawser_grid *grid,
                                 const struct hawser__reference *reference);

/* Inner products of displacements, with the masses, and of strains, with the springs. */
double hawser__mass_product(const double *a, const double *b, const struct hawser__plane *plane,
                            const struct hawser_grid *grid);
double hawser__energy_product(const double *a, const double *b, const struct hawser__plane *plane,
                              const struct hawser_grid *grid);

/* constraint[springs] columns of `rows`: for the coefficients x of the strains, the strain of each
 * spring by the displacement of its lump minus its own one, which is 0. C: D columns of `rows`, the
 * displacement of end B by each function, of which there are `block` in each element, and by joints. */
void hawser__spring_constraints(double *constraint, const double *C, int rows, int block,
                                const struct hawser__plane *plane, const struct hawser_grid *grid);

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

/* --- compliance_springs.c: internal to compliance: forces of springs and fixed ends --- */

enum { HAWSER__MAX_FORCES = HAWSER__MAX_D + HAWSER__MAX_SPRINGS }; /* most constants z */

/* Solve A z = b, z and b [D + springs]. */
void hawser__spring_solve(double *z, const double *b, const struct hawser__plane *plane,
                          const struct hawser_grid *grid);

/* b[D + springs] = <phi, force>, force [D][points], at the joints of ends A and B: end. */
void hawser__spring_work(double *b, const double *force, double end[2][HAWSER__MAX_D],
                         const struct hawser__plane *plane, const struct hawser_grid *grid);

/* force [D][points] and end [2] += factor times the sum of z_a phi_a. */
void hawser__spring_force(double *force, double end[2][HAWSER__MAX_D], const double *z, double factor,
                          const struct hawser__plane *plane, const struct hawser_grid *grid);

#endif
