/* response/balance_solve.c - the bordered linear systems of harmonic balance.
 *
 *   M   scaled bordered matrix of the last derivatives, by rows (to LAPACK its transpose)
 *   LU  factors of M, or of the M of a point nearby
 *
 * A point of a branch needs two or three Jacobians: at the prediction, sometimes at an iterate, and
 * at the accepted point, for its tangent. They differ little. So the factors are kept, and the
 * systems are solved by GMRES with the old factors as preconditioner; tangents are solved to a
 * smaller residual than Newton's steps. Along the branch this takes more and more iterations. The
 * matrix is factorised anew as soon as the solutions with one Jacobian cost more than the mean cost
 * per Jacobian since the last factorisation, the factorisation included: the rule of least mean
 * cost.
 *
 * Reference: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "response/balance.h"

#define KRYLOV HAWSER__KRYLOV
#define NEWTON_RESIDUAL 1e-5 /* relative: far below the contraction required of the corrector */
#define TANGENT_RESIDUAL 1e-9 /* relative: below the least tolerance of a point */
#define INVERSE_ITERATIONS 3 /* for the norm of the inverse: two digits of it are used */
/* A factorisation takes as long as P over this number of iterations (measured at P from 100 to
 * 600: the factorisation is limited by the processor, an iteration by the memory). */
#define FACTOR_COST 24.0

/* Factors in single precision cost half and serve as well as a preconditioner: GMRES needs one
 * or two iterations more. For fewer unknowns than this the time of a call dominates, and doubles
 * are used. */
#define SINGLE_FROM 250

/* The factors as floats, followed by memory for a vector. */
static float *single_factors(const struct hawser__balance *balance)
{
	/* cppcheck-suppress invalidPointerCast ; memory of malloc, all floats then */
	return (float *)balance->lu;
}

static int factorise_single(struct hawser__balance *balance)
{
	int count = balance->unknowns + 1;
	size_t size = (size_t)count*count;
	float *lu = single_factors(balance);

	for (size_t i = 0; i < size; i++)
		lu[i] = (float)balance->matrix[i];
	return LAPACKE_sgetrf_work(LAPACK_COL_MAJOR, count, count, lu, count, balance->pivot) == 0;
}

static int factorise_double(struct hawser__balance *balance)
{
	int count = balance->unknowns + 1;

	memcpy(balance->lu, balance->matrix, (size_t)count*count*sizeof(double));
	return LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, count, count, balance->lu, count,
	                           balance->pivot) == 0;
}

/* `exact`: in double precision whatever the size. */
static int factorise(struct hawser__balance *balance, int exact)
{
	balance->single = !exact && balance->unknowns >= SINGLE_FROM && factorise_single(balance);
	balance->factored = balance->single || factorise_double(balance);
	balance->fresh = balance->factored;
	balance->direct = balance->factored && !balance->single;
	balance->norm_inverse = 0.0;
	balance->jacobians = 1;
	balance->iterations = balance->spent = 0;
	return !balance->factored;
}

int hawser__balance_factor(struct hawser__orbit *orbit, const double *row)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;

	/* cost of the last Jacobian against the mean */
	if (balance->spent*balance->jacobians > balance->unknowns/FACTOR_COST + balance->iterations)
		balance->factored = 0;
	hawser__balance_assemble(balance, row);
	orbit->det_sign = 1.0;
	balance->direct = balance->fresh = 0;
	balance->jacobians++;
	balance->spent = 0;
	return balance->factored ? 0 : factorise(balance, 0);
}

/* x = M^-1 x, or with the transpose of M, by the current factors (LAPACK sees the transpose). */
static void apply(const struct hawser__balance *balance, double *x, char transposed)
{
	int count = balance->unknowns + 1;
	float *narrow = single_factors(balance) + (size_t)count*count;

	if (!balance->single) {
		LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, transposed, count, 1, balance->lu, count,
		                    balance->pivot, x, count);
		return;
	}
	for (int i = 0; i < count; i++)
		narrow[i] = (float)x[i];
	LAPACKE_sgetrs_work(LAPACK_COL_MAJOR, transposed, count, 1, single_factors(balance), count,
	                    balance->pivot, narrow, count);
	for (int i = 0; i < count; i++)
		x[i] = narrow[i];
}

/* Euclidean norm of the inverse, by inverse iteration with the current factors. Defects and
 * errors are root sums of squares; the 1-norm that LAPACK estimates would grow with the number
 * of unknowns. */
double hawser__balance_norm_inverse(struct hawser__balance *balance)
{
	int count = balance->unknowns + 1;
	double *x = balance->krylov, length = 1.0;

	if (balance->norm_inverse != 0.0)
		return balance->norm_inverse;
	for (int i = 0; i < count; i++)
		x[i] = (1.0 + 0.5*cos(2.385*i))/sqrt(count); /* not orthogonal to any structured vector of M */
	for (int i = 0; i < 2*INVERSE_ITERATIONS; i++) {
		apply(balance, x, i%2 ? 'T' : 'N');
		length = cblas_dnrm2(count, x, 1);
		cblas_dscal(count, 1.0/length, x, 1);
	}
	balance->norm_inverse = length;
	return length;
}

/* The least squares problem of GMRES, kept triangular by rotations. */
struct hessenberg {
	double r[KRYLOV][KRYLOV + 1]; /* column k at r[k] */
	double c[KRYLOV], s[KRYLOV], g[KRYLOV + 1];
};

static void rotate(struct hessenberg *H, int k)
{
	double *column = H->r[k], length;

	for (int i = 0; i < k; i++) {
		double a = column[i], b = column[i + 1];

		column[i] = H->c[i]*a + H->s[i]*b;
		column[i + 1] = H->c[i]*b - H->s[i]*a;
	}
	length = hypot(column[k], column[k + 1]);
	H->c[k] = length > 0.0 ? column[k]/length : 1.0;
	H->s[k] = length > 0.0 ? column[k + 1]/length : 0.0;
	column[k] = length;
	H->g[k + 1] = -H->s[k]*H->g[k];
	H->g[k] = H->c[k]*H->g[k];
}

/* Vector k + 1 of the basis from vector k: M LU^-1 v, made orthogonal (twice is enough). */
static void extend(struct hawser__balance *balance, struct hessenberg *H, int k)
{
	int count = balance->unknowns + 1;
	double *v = balance->krylov + (size_t)(k + 1)*count, *z = balance->rhs + count;

	memcpy(z, balance->krylov + (size_t)k*count, (size_t)count*sizeof *z);
	apply(balance, z, 'T');
	cblas_dgemv(CblasRowMajor, CblasNoTrans, count, count, 1.0, balance->matrix, count, z, 1,
	            0.0, v, 1);
	memset(H->r[k], 0, sizeof H->r[k]);
	for (int pass = 0; pass < 2; pass++)
		for (int i = 0; i <= k; i++) {
			const double *u = balance->krylov + (size_t)i*count;
			double dot = cblas_ddot(count, u, 1, v, 1);

			H->r[k][i] += dot;
			cblas_daxpy(count, -dot, u, 1, v, 1);
		}
	H->r[k][k + 1] = cblas_dnrm2(count, v, 1);
	if (H->r[k][k + 1] > 0.0)
		cblas_dscal(count, 1.0/H->r[k][k + 1], v, 1);
}

/* x = M^-1 x to the relative residual `goal`. Returns 1 after too many iterations; x is then
 * invalid. */
static int gmres(struct hawser__balance *balance, double *x, double goal)
{
	int count = balance->unknowns + 1, k = 0;
	double length = cblas_dnrm2(count, x, 1);
	struct hessenberg H;

	if (length == 0.0)
		return 0;
	memcpy(balance->krylov, x, (size_t)count*sizeof *x);
	cblas_dscal(count, 1.0/length, balance->krylov, 1);
	H.g[0] = length;
	while (k < KRYLOV && fabs(H.g[k]) > goal*length) {
		extend(balance, &H, k);
		rotate(&H, k++);
	}
	balance->spent += k;
	balance->iterations += k;
	/* false for a NaN, too */
	if (!(fabs(H.g[k]) <= goal*length))
		return 1;
	memset(x, 0, (size_t)count*sizeof *x);
	for (int i = k - 1; i >= 0; i--) {
		for (int j = i + 1; j < k; j++)
			H.g[i] -= H.r[j][i]*H.g[j];
		H.g[i] /= H.r[i][i];
		cblas_daxpy(count, H.g[i], balance->krylov + (size_t)i*count, 1, x, 1);
	}
	apply(balance, x, 'T');
	return 0;
}

static void set_right(const struct hawser__balance *balance, double *x, int homogeneous, double last)
{
	int P = balance->unknowns;

	for (int i = 0; i < P; i++)
		x[i] = homogeneous ? 0.0 : -balance->defect[balance->slot[i]]*balance->row_scale[i];
	x[P] = last;
}

void hawser__balance_invert(struct hawser__balance *balance, double *x, double goal)
{
	size_t size = ((size_t)balance->unknowns + 1)*sizeof *x;

	if (!balance->direct) {
		memcpy(balance->kept, x, size);
		if (!gmres(balance, x, goal))
			return;
		memcpy(x, balance->kept, size);
		factorise(balance, 1);
	}
	apply(balance, x, 'T');
}

void hawser__balance_solve(struct hawser__orbit *orbit, double *dy, int homogeneous, double last)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int P = balance->unknowns, end = orbit->size - 1;
	double *x = balance->rhs;

	set_right(balance, x, homogeneous, last);
	hawser__balance_invert(balance, x, homogeneous ? TANGENT_RESIDUAL : NEWTON_RESIDUAL);
	/* a prediction from points with other pairs holds values where nothing is active now */
	for (int i = 0; i < end; i++)
		dy[i] = homogeneous ? 0.0 : balance->at[i] - balance->given[i];
	for (int i = 0; i < P; i++)
		dy[balance->slot[i]] = x[i]*balance->col_scale[i];
	dy[end] = x[P]*orbit->W;
	if (homogeneous)
		balance->turn = x[P]/sqrt(hawser__orbit_dot(orbit, dy, dy));
}
