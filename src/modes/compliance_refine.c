/* modes/compliance_refine.c - refinement of modes by inverse iteration with the exact compliance.
 *
 *   F          force along the cable: F0 - omega^2 times the integral of X up to s and the point
 *              masses times X before s, plus the forces of springs before s
 *   end[2]     the same at the springs of elastic supports: before end A, and beyond end B
 *
 * This is the iterated Galerkin method (I. H. Sloan, Math. Comp. 30 (1976) 758): one step with the
 * exact operator removes most of the error of a shape. A second step is cheap.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "core/vec3.h"
#include "modes/compliance.h"

/* Solve [integral of d d'] F0 = b: F0 is the constant force whose strains displace end B by b. */
static void constant_force(double *F0, const double *b, const struct hawser__plane *plane,
                           const struct hawser_grid *grid)
{
	int D = plane->D, points = grid->points;
	double A[HAWSER__MAX_D][HAWSER__MAX_D] = {{0.0}};

	for (int k = 0; k < D; k++)
		for (int i = 0; i < points; i++) {
			const double *d = plane->direction + k*D*points + i;

			for (int c = 0; c < D; c++)
				for (int q = 0; q < D; q++)
					A[c][q] += grid->weight[i]*d[c*points]*d[q*points];
		}
	if (D == 1) {
		F0[0] = b[0]/A[0][0];
	} else if (D == 3) {
		hawser__solve3(F0, A, b, 0.0);
	} else {
		double det = A[0][0]*A[1][1] - A[0][1]*A[1][0];

		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): b has D values */
		F0[0] = (b[0]*A[1][1] - b[1]*A[0][1])/det;
		F0[1] = (b[1]*A[0][0] - b[0]*A[1][0])/det;
	}
}

/* strain [D][points] = d' force, or is increased by it. */
static void strains_of(double *strain, const double *force, int increase,
                       const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	int D = plane->D, points = grid->points;

	for (int k = 0; k < D; k++)
		for (int i = 0; i < points; i++) {
			const double *d = plane->direction + k*D*points + i;
			double sum = increase ? strain[k*points + i] : 0.0;

			for (int c = 0; c < D; c++)
				sum += d[c*points]*force[c*points + i];
			strain[k*points + i] = sum;
		}
}

/* The strains of the joints, or what is added to them. */
static void joints_of(double *strain, double end[2][HAWSER__MAX_D], int increase,
                      const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	double *joint = strain + plane->D*grid->points + plane->springs;

	for (int j = 0; j < plane->joints; j++) {
		double sum = increase ? joint[j] : 0.0;

		for (int c = 0; c < plane->D; c++)
			sum += plane->joint[j].d[c]*end[plane->joint[j].end][c];
		joint[j] = sum;
	}
}

/* The force of the foundations and of springs, which is added to `force` and `end`. */
static void balance_springs(double *force, double end[2][HAWSER__MAX_D], double *strain,
                            const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	double b[HAWSER__MAX_FORCES], z[HAWSER__MAX_FORCES];

	hawser__spring_work(b, force, end, plane, grid);
	hawser__spring_solve(z, b, plane, grid);
	hawser__spring_force(force, end, z, -1.0, plane, grid);
	strains_of(strain, force, 0, plane, grid);
	joints_of(strain, end, 0, plane, grid);
	for (int j = 0; j < plane->springs; j++)
		strain[plane->D*grid->points + j] = -z[plane->D + j];
}

/* Force F(s) = F0 - omega^2 * integral of X, with F0 such that the far end does not move: F0
 * compensates the integral of d (d' F) for F0 = 0. force is [D][points]. */
static void balance(double *force, double *strain, const struct hawser__plane *plane,
                    const struct hawser_grid *grid)
{
	int D = plane->D, points = grid->points;
	double b[HAWSER__MAX_D] = {0.0}, F0[HAWSER__MAX_D];

	for (int k = 0; k < D; k++)
		for (int i = 0; i < points; i++) {
			const double *d = plane->direction + k*D*points + i;
			double pull = 0.0;

			for (int c = 0; c < D; c++)
				pull += d[c*points]*force[c*points + i];
			for (int c = 0; c < D; c++)
				b[c] -= grid->weight[i]*d[c*points]*pull;
		}
	constant_force(F0, b, plane, grid);
	for (int c = 0; c < D; c++)
		for (int i = 0; i < points; i++)
			force[c*points + i] += F0[c];
	strains_of(strain, force, 0, plane, grid);
}

/* Correct the strains so that end B, which they displace by `end`, does not move. The round-off of
 * the rotational strains is relative to the force. The force is larger than these strains by the
 * factor lambda (the angle of the sag over sqrt(epsilon)), so that its round-off displaces the end.
 * To first order a frequency changes by the force times the displacement of the end; without the
 * correction its relative error would be of order lambda^2 u, where u is the unit round-off. With
 * the correction only the round-off r of the strains x remains, |r| <= u |x|. It displaces the end
 * by the integral of d r, and F0 times that is at most u |x| |d'F0|, where |d'F0| is the norm of
 * the strains of the constant force. The strains for F0 = 0 are x - d'F0, of which x is the part
 * orthogonal to constant forces. Relative to omega^2 = |x|^2 the error of a frequency is therefore
 * a few u for any lambda. */
static void hold_end(double *strain, const double *end, const struct hawser__plane *plane,
                     const struct hawser_grid *grid)
{
	int D = plane->D, points = grid->points;
	double F0[HAWSER__MAX_D];

	constant_force(F0, end, plane, grid);
	for (int k = 0; k < D; k++)
		for (int i = 0; i < points; i++)
			for (int c = 0; c < D; c++)
				strain[k*points + i] -= plane->direction[(k*D + c)*points + i]*F0[c];
}

/* The same with springs, whose strains must be those of their lumps. work [D][points]. */
static void hold_springs(double *strain, const double *displacement, const double *end,
                         const struct hawser__plane *plane, const struct hawser_grid *grid,
                         double *work)
{
	int D = plane->D, points = grid->points;
	double r[HAWSER__MAX_FORCES], z[HAWSER__MAX_FORCES], joint[2][HAWSER__MAX_D] = {{0.0}};

	for (int c = 0; c < D; c++)
		r[c] = end[c];
	for (int j = 0; j < plane->springs; j++) {
		const struct hawser__spring *spring = &plane->spring[j];

		r[D + j] = strain[D*points + j];
		for (int c = 0; c < D; c++)
			r[D + j] += spring->g[c]*
			            (end[c] - displacement[D*points + c*plane->lumps + spring->lump]);
	}
	hawser__spring_solve(z, r, plane, grid);
	for (int i = 0; i < D*points; i++)
		work[i] = 0.0;
	hawser__spring_force(work, joint, z, -1.0, plane, grid);
	strains_of(strain, work, 1, plane, grid);
	joints_of(strain, joint, 1, plane, grid);
	for (int j = 0; j < plane->springs; j++)
		strain[D*points + j] -= z[D + j];
}

double hawser__compliance_product(const double *a, const double *b, int D,
                                  const struct hawser_grid *grid)
{
	double sum = 0.0;

	for (int c = 0; c < D; c++)
		for (int i = 0; i < grid->points; i++)
			sum += grid->weight[i]*a[c*grid->points + i]*b[c*grid->points + i];
	return sum;
}

double hawser__mass_product(const double *a, const double *b, const struct hawser__plane *plane,
                            const struct hawser_grid *grid)
{
	double sum = hawser__compliance_product(a, b, plane->D, grid);

	for (int i = 0; i < plane->D*(plane->lumps + plane->absorbers); i++) {
		int at = plane->D*grid->points + i, lump;

		sum += hawser__row_mass(&lump, plane, i)*a[at]*b[at];
	}
	return sum;
}

double hawser__energy_product(const double *a, const double *b, const struct hawser__plane *plane,
                              const struct hawser_grid *grid)
{
	double sum = hawser__compliance_product(a, b, plane->D, grid);

	for (int j = 0; j < plane->springs + plane->joints + plane->absorbers; j++)
		sum += a[plane->D*grid->points + j]*b[plane->D*grid->points + j];
	return sum;
}

/* Orthogonalise mode k against the lower modes j: inverse iteration amplifies their round-off by
 * the factor (omega_k/omega_j)^2. */
static void purge(struct hawser__pairs *pairs, const struct hawser__plane *plane,
                  const struct hawser_grid *grid, int k)
{
	size_t values = hawser__displacements(plane, grid), strains = hawser__strains(plane, grid);
	double *displacement = pairs->displacement + (size_t)k*values;
	double *strain = pairs->strain + (size_t)k*strains;

	for (int j = 0; j < k; j++) {
		const double *lower = pairs->displacement + (size_t)j*values;
		double part = hawser__mass_product(lower, displacement, plane, grid);

		cblas_daxpy((int)values, -part, lower, 1, displacement, 1);
		cblas_daxpy((int)strains, -part, pairs->strain + (size_t)j*strains, 1, strain, 1);
	}
}

/* Add the inertial forces of the point masses to force [D][points] and to that beyond end B. */
static void add_lumps(double *force, double *beyond, const double *displacement, double omega,
                      const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	const double *X = displacement + plane->D*grid->points;

	for (int i = 0; i < plane->D*(plane->lumps + plane->absorbers); i++) {
		int lump, own = plane->D*plane->lumps;
		double inertia = omega*omega*hawser__row_mass(&lump, plane, i)*X[i];
		int c = i < own ? i/plane->lumps : (i - own)/plane->absorbers;

		for (int p = plane->lump[lump].edge*grid->order; p < grid->points; p++)
			force[c*grid->points + p] -= inertia;
		beyond[c] -= inertia;
	}
}

/* The strains of the absorbers' springs under the inertia of their masses. */
static void absorbers_of(double *strain, const double *displacement, double omega,
                         const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	const double *X = displacement + plane->D*(grid->points + plane->lumps);

	strain += plane->D*grid->points + plane->springs + plane->joints;
	for (int i = 0; i < plane->absorbers; i++) {
		const struct hawser__absorber *absorber = &plane->absorber[i];

		strain[i] = 0.0;
		for (int c = 0; c < plane->D; c++)
			strain[i] += omega*omega*absorber->mass*absorber->root*absorber->a[c]*
			             X[c*plane->absorbers + i];
	}
}

void hawser__compliance_apply(double *displacement, double *strain, double omega,
                              const struct hawser__plane *plane, const struct hawser_grid *grid,
                              const struct hawser__reference *reference, double *work)
{
	int D = plane->D, points = grid->points;
	double end[HAWSER__MAX_D]; /* 0 up to round-off */
	double joint[2][HAWSER__MAX_D] = {{0.0}};
	int sprung = plane->springs + plane->joints > 0;
	double *gradient = work + D*points;

	for (int c = 0; c < D; c++) {
		double *force = work + c*points;

		joint[1][c] = -omega*omega*hawser__grid_running(force, grid, reference,
		                                                displacement + c*points);
		cblas_dscal(points, -omega*omega, force, 1);
	}
	add_lumps(work, joint[1], displacement, omega, plane, grid);
	if (sprung)
		balance_springs(work, joint, strain, plane, grid);
	else
		balance(work, strain, plane, grid);
	absorbers_of(strain, displacement, omega, plane, grid);
	hawser__compliance_displace(displacement, end, gradient, strain, plane, grid, reference);
	if (sprung)
		hold_springs(strain, displacement, end, plane, grid, work);
	else
		hold_end(strain, end, plane, grid);
	hawser__compliance_displace(displacement, end, gradient, strain, plane, grid, reference);
}

static void step(struct hawser__pairs *pairs, const struct hawser__plane *plane,
                 const struct hawser_grid *grid, const struct hawser__reference *reference, int k,
                 double *work)
{
	size_t values = hawser__displacements(plane, grid), strains = hawser__strains(plane, grid);
	double *displacement = pairs->displacement + (size_t)k*values;
	double *strain = pairs->strain + (size_t)k*strains, norm;

	hawser__compliance_apply(displacement, strain, pairs->omega[k], plane, grid, reference,
	                         work);
	purge(pairs, plane, grid, k);
	norm = sqrt(hawser__mass_product(displacement, displacement, plane, grid));
	cblas_dscal((int)values, 1.0/norm, displacement, 1);
	cblas_dscal((int)strains, 1.0/norm, strain, 1);
	pairs->omega[k] = sqrt(hawser__energy_product(strain, strain, plane, grid));
}

/* Strains and displacements of the coefficients of pair k. */
static void unfold(struct hawser__pairs *pairs, const struct hawser__plane *plane,
                   const struct hawser_grid *grid, const struct hawser__reference *reference,
                   int k, double *work)
{
	int n = plane->D*pairs->degree*grid->elements + plane->springs + plane->joints + plane->absorbers;
	size_t values = hawser__displacements(plane, grid), column = (size_t)(pairs->count - 1 - k);
	double *strain = pairs->strain + (size_t)k*hawser__strains(plane, grid), end[HAWSER__MAX_D];

	hawser__compliance_strain(strain, pairs->x + column*(size_t)n, plane, grid, reference,
	                          pairs->degree);
	hawser__compliance_displace(pairs->displacement + (size_t)k*values, end, work, strain, plane,
	                            grid, reference);
}

enum hawser_status hawser__compliance_refine(struct hawser__pairs *pairs,
                                             const struct hawser__plane *plane,
                                             const struct hawser_grid *grid,
                                             const struct hawser__reference *reference, int count,
                                             struct hawser_report *report)
{
	double *work = hawser__numbers(HAWSER__MAX_D + 1, (size_t)grid->points);

	pairs->strain = hawser__numbers((size_t)count, hawser__strains(plane, grid));
	pairs->displacement = hawser__numbers((size_t)count, hawser__displacements(plane, grid));
	if (!work || !pairs->strain || !pairs->displacement) {
		free(work);
		return hawser__no_memory(report, "modes");
	}
	for (int k = 0; k < count; k++) {
		double before = pairs->omega[k];

		if (!isfinite(before)) {
			free(work);
			return hawser__eigen_lost(k + 1, plane->D > 1, pairs->omega[0], report);
		}
		unfold(pairs, plane, grid, reference, k, work);
		step(pairs, plane, grid, reference, k, work);
		pairs->moved[k] = fabs(pairs->omega[k] - before)/pairs->omega[k];
		step(pairs, plane, grid, reference, k, work);
	}
	free(work);
	return HAWSER_OK;
}
