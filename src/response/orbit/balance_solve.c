/* response/orbit/balance_solve.c - the bordered linear systems of harmonic balance.
 *
 *   M   scaled bordered matrix of the last derivatives, by rows (the transpose for LAPACK)
 *   LU  factors of M, or of the M of an earlier point
 *
 * A point of a branch needs two or three Jacobians: at the prediction, sometimes at an iterate, and
 * at the accepted point, for its tangent. They differ little. The factors are therefore kept, and
 * the systems are solved by GMRES with the old factors as preconditioner, which the vectors of the last
 * solutions correct. Along the branch the number of iterations increases. The
 * matrix is factorised again as soon as the solutions with one Jacobian cost more than the mean
 * cost per Jacobian since the last factorisation, including the factorisation: the rule of least
 * mean cost.
 *
 * From some hundred unknowns on M is assembled for its factors only. Its products with vectors
 * are computed from the sampled tangents, and where that is cheaper the preconditioner solves the
 * linear equations by collocation over the period (balance_blocks.h). GMRES is flexible: it keeps
 * the preconditioned vectors, which saves one application per solution.
 *
 * Reference: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986); Saad, ibid. 14 (1993).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "response/orbit/balance.h"

#define APPLIED 8.0 /* operations for an element of the matrix in an iteration, at the speed of a
                     * factorisation; chosen */
#define KRYLOV HAWSER__KRYLOV
#define OLD_KRYLOV 24 /* the same with old factors, or with those of M itself; chosen */
#define NEWTON_RESIDUAL 1e-5 /* relative: far below the contraction required of the corrector */
#define TANGENT_RESIDUAL 1e-11 /* relative; at a fold the Omega component of the tangent is 0 */
#define TRIED 6 /* iterations after which a solution with old factors may be given up; chosen */
#define MANY 9 /* iterations with new factors, after which these are made better; chosen */
#define INVERSE_ITERATIONS 3 /* for the norm of the inverse, of which two digits are used */
/* A factorisation takes the time of P/FACTOR_COST iterations (measured for P from 100 to 600: the
 * factorisation is limited by the processor, an iteration by the memory). */
#define FACTOR_COST 24.0
/* By blocks: time of an operation of a factorisation (matrix products) over that of an iteration
 * (matrix times vector). Chosen: of 0.2, 0.3 and 0.4 the one with the shortest responses with exact
 * energy. */
#define BLOCK_SPEED 0.3
#define BLOCK_INVERSE_ITERATIONS 2 /* they start from the vector of the last point */

/* Factors in single precision take half the time and are as good a preconditioner: GMRES needs one
 * or two more iterations. For fewer unknowns than this the time of a call dominates, and doubles
 * are used. */
#define SINGLE_FROM 250

/* Otherwise M is made to be factorised only, and its products come from the sampled tangents. */
static int multiplies_matrix(const struct hawser__balance *balance)
{
	return !balance->blockwise && balance->unknowns < SINGLE_FROM;
}

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

/* `exact`: in double precision for any size. */
static int factorise(struct hawser__balance *balance, int exact)
{
	double P = balance->unknowns;

	if (!multiplies_matrix(balance))
		hawser__balance_assemble(balance);
	balance->base.cost.dense += 2.0/3.0*P*P*P;
	balance->single = !exact && balance->unknowns >= SINGLE_FROM && factorise_single(balance);
	balance->factored = balance->single || factorise_double(balance);
	balance->fresh = balance->factored;
	balance->direct = balance->factored && !balance->single;
	balance->norm_inverse = 0.0;
	balance->jacobians = 1;
	balance->iterations = balance->spent = balance->learned = 0;
	return !balance->factored;
}

/* Operations of an iteration. */
static double applied(const struct hawser__balance *balance)
{
	double P = balance->unknowns;

	return balance->blockwise ? hawser__blocks_applied(&balance->blocks, balance) : APPLIED*P*P;
}

/* Cost of a factorisation, in iterations. */
static double factor_cost(const struct hawser__balance *balance)
{
	return balance->blockwise ? BLOCK_SPEED*hawser__blocks_factored(&balance->blocks, balance)/
	                            hawser__blocks_applied(&balance->blocks, balance)
	                          : balance->unknowns/FACTOR_COST;
}

static int factor_top(struct hawser__balance *balance)
{
	int top = hawser__balance_top(balance, balance->top_block, balance->top_from);

	for (size_t i = 0; i < (size_t)top*top; i++)
		balance->top_factors[i] = (float)balance->top_block[i];
	return LAPACKE_sgetrf_work(LAPACK_COL_MAJOR, top, top, balance->top_factors, top,
	                           balance->top_pivot) != 0;
}

/* Factorise M itself and use these factors from now on, in double precision if `exact`. Returns 1
 * on failure. */
static int take_matrix(struct hawser__balance *balance, int exact)
{
	if (hawser__balance_matrix_room(balance))
		return 1;
	balance->blockwise = 0;
	if (multiplies_matrix(balance))
		hawser__balance_assemble(balance);
	return factorise(balance, exact);
}

/* Factorise for the preconditioner. Returns 1 on failure. */
static int prepare(struct hawser__balance *balance)
{
	if (!balance->blockwise)
		return factorise(balance, 0);
	if (hawser__blocks_factor(&balance->blocks, balance, balance->row) || factor_top(balance))
		return take_matrix(balance, 0);
	balance->base.cost.dense += BLOCK_SPEED*hawser__blocks_factored(&balance->blocks, balance);
	balance->factored = balance->fresh = 1;
	balance->norm_inverse = 0.0;
	balance->jacobians = 1;
	balance->iterations = balance->spent = balance->learned = 0;
	memset(balance->free, 0, (size_t)balance->unknowns*sizeof(double));
	balance->free[balance->unknowns] = 1.0;
	hawser__blocks_apply(&balance->blocks, balance, balance->free);
	return 0;
}

int hawser__balance_factor(struct hawser__orbit *orbit, const double *row)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;

	/* compare the cost of the last Jacobian with the mean */
	if (balance->spent*balance->jacobians > factor_cost(balance) + balance->iterations)
		balance->factored = 0;
	/* old factors remain a preconditioner only if the scales are the same */
	if (!balance->factored)
		hawser__balance_scale(balance);
	hawser__balance_set_border(balance, row);
	memcpy(balance->row, row, (size_t)orbit->size*sizeof *row);
	if (multiplies_matrix(balance))
		hawser__balance_assemble(balance);
	orbit->det_sign = 1.0;
	balance->direct = balance->fresh = 0;
	balance->jacobians++;
	balance->spent = 0;
	return balance->factored ? 0 : prepare(balance);
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

static void multiply(struct hawser__balance *balance, double *out, const double *x)
{
	int count = balance->unknowns + 1;

	if (!multiplies_matrix(balance))
		hawser__balance_product(balance, out, x, 0);
	else
		cblas_dgemv(CblasRowMajor, CblasNoTrans, count, count, 1.0, balance->matrix, count, x, 1,
		            0.0, out, 1);
}

/* x = approximation of M^-1 x by blocks. The balanced equations have no harmonics above H, but
 * collocation does; this affects only the highest harmonics, which are therefore solved separately
 * first (multiplicative Schwarz). Collocation has the border as a sum over the steps; a multiple of
 * its solution for a zero right side satisfies the border exactly. */
static void precondition_by_blocks(struct hawser__balance *balance, double *x)
{
	int count = balance->unknowns + 1, top = balance->top_count, at = count - 1 - top;
	double *first = balance->rest, *image = first + count, part;
	float *narrow = balance->top_factors + (size_t)top*top;

	memset(first, 0, (size_t)count*sizeof *first);
	for (int i = 0; i < top; i++)
		narrow[i] = (float)x[at + i];
	LAPACKE_sgetrs_work(LAPACK_COL_MAJOR, 'T', top, 1, balance->top_factors, top,
	                    balance->top_pivot, narrow, top);
	for (int i = 0; i < top; i++)
		first[at + i] = narrow[i];
	hawser__balance_product(balance, image, first, balance->top_from);
	cblas_daxpy(count, -1.0, image, 1, x, 1);
	part = x[count - 1];
	hawser__blocks_apply(&balance->blocks, balance, x);
	part -= cblas_ddot(count, balance->border, 1, x, 1);
	cblas_daxpy(count, 1.0, first, 1, x, 1);
	cblas_daxpy(count, part/cblas_ddot(count, balance->border, 1, balance->free, 1), balance->free, 1,
	            x, 1);
}

/* x = approximation of M^-1 x: its parts along the images that are known, the last first, and by the
 * factors what remains. */
static void precondition(struct hawser__balance *balance, double *x)
{
	int count = balance->unknowns + 1, last = balance->learned;
	double *part = balance->rest + 2*(size_t)count;

	memset(part, 0, (size_t)count*sizeof *part);
	for (int i = last - 1; i >= 0 && i >= last - HAWSER__LEARNED; i--) {
		size_t at = (size_t)(i%HAWSER__LEARNED)*count;
		double share = cblas_ddot(count, balance->effect + at, 1, x, 1);

		cblas_daxpy(count, share, balance->cause + at, 1, part, 1);
		cblas_daxpy(count, -share, balance->effect + at, 1, x, 1);
	}
	if (balance->blockwise)
		precondition_by_blocks(balance, x);
	else
		apply(balance, x, 'T');
	cblas_daxpy(count, 1.0, part, 1, x, 1);
}

/* The same by blocks, which have no transpose: the largest growth of a vector near the singular
 * vector of the smallest singular value of M. The vector is kept from point to point. */
static double norm_by_blocks(struct hawser__balance *balance)
{
	int count = balance->unknowns + 1;
	double *x = balance->near, most = 0.0;

	for (int i = 0; i < BLOCK_INVERSE_ITERATIONS; i++) {
		double length;

		precondition(balance, x);
		length = cblas_dnrm2(count, x, 1);
		if (!(length > 0.0 && isfinite(length)))
			return INFINITY;
		cblas_dscal(count, 1.0/length, x, 1);
		most = fmax(most, length);
	}
	return most;
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
	if (balance->blockwise)
		return balance->norm_inverse = norm_by_blocks(balance);
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

/* The least squares problem of GMRES, kept upper triangular by rotations. */
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

/* Compute vector k + 1 of the basis: M LU^-1 v for vector k, orthogonalised twice. */
static void extend(struct hawser__balance *balance, struct hessenberg *H, int k)
{
	int count = balance->unknowns + 1;
	double *v = balance->krylov + (size_t)(k + 1)*count;
	double *z = balance->flexible + (size_t)k*count;

	memcpy(z, balance->krylov + (size_t)k*count, (size_t)count*sizeof *z);
	precondition(balance, z);
	multiply(balance, v, z);
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

/* With fresh blocks the alternative is to factorise M itself, which takes as long as hundreds of
 * iterations. */
static int most_iterations(const struct hawser__balance *balance)
{
	return balance->base.rom->exact && balance->blockwise && balance->fresh ? KRYLOV : OLD_KRYLOV;
}

/* Whether old factors would need more than OLD_KRYLOV iterations, at the mean rate of the first k,
 * which have reduced the residual to `part`. */
static int hopeless(const struct hawser__balance *balance, int k, double part, double goal)
{
	return !balance->fresh && k >= TRIED && k*log(goal) < OLD_KRYLOV*log(part);
}

/* Store the vectors of a solution with k iterations, combined such that their images are orthonormal.
 * They are the directions in which the old factors are wrong, and the next Jacobian differs little from
 * this one (Broyden's update of the inverse). */
static void learn(struct hawser__balance *balance, const struct hessenberg *H, int k)
{
	int count = balance->unknowns + 1;

	for (int i = 0; i < k; i++) {
		double *v = balance->krylov + (size_t)i*count, *z = balance->flexible + (size_t)i*count;
		size_t at = (size_t)(balance->learned++%HAWSER__LEARNED)*count;

		cblas_drot(count, v, 1, v + count, 1, H->c[i], H->s[i]);
		for (int j = 0; j < i; j++)
			cblas_daxpy(count, -H->r[i][j], balance->flexible + (size_t)j*count, 1, z, 1);
		cblas_dscal(count, 1.0/H->r[i][i], z, 1);
		memcpy(balance->cause + at, z, (size_t)count*sizeof *z);
		memcpy(balance->effect + at, v, (size_t)count*sizeof *v);
	}
}

/* x = M^-1 x to the relative residual `goal`. Returns 1 after too many iterations; x is then
 * invalid. */
static int gmres(struct hawser__balance *balance, double *x, double goal)
{
	int count = balance->unknowns + 1, k = 0, most = most_iterations(balance);
	double length = cblas_dnrm2(count, x, 1);
	struct hessenberg H;

	if (length == 0.0)
		return 0;
	memcpy(balance->krylov, x, (size_t)count*sizeof *x);
	cblas_dscal(count, 1.0/length, balance->krylov, 1);
	H.g[0] = length;
	while (k < most && fabs(H.g[k]) > goal*length &&
	       !hopeless(balance, k, fabs(H.g[k])/length, goal)) {
		extend(balance, &H, k);
		rotate(&H, k++);
	}
	balance->spent += k;
	balance->iterations += k;
	balance->base.cost.dense += k*applied(balance);
	balance->top_more |= balance->blockwise && balance->fresh && k > MANY;
	/* false for a NaN, too */
	if (!(fabs(H.g[k]) <= goal*length))
		return 1;
	memset(x, 0, (size_t)count*sizeof *x);
	for (int i = k - 1; i >= 0; i--) {
		for (int j = i + 1; j < k; j++)
			H.g[i] -= H.r[j][i]*H.g[j];
		H.g[i] /= H.r[i][i];
		cblas_daxpy(count, H.g[i], balance->flexible + (size_t)i*count, 1, x, 1);
	}
	learn(balance, &H, k);
	return 0;
}

static void set_right(const struct hawser__balance *balance, double *x, int homogeneous, double last)
{
	int P = balance->unknowns;

	for (int i = 0; i < P; i++)
		x[i] = homogeneous ? 0.0 : -balance->defect[balance->slot[i]]*balance->row_scale[i];
	x[P] = last;
}

/* Replace the factors by better ones: those of an earlier M by the same of the present one; blocks by
 * M itself, and floats by doubles. Returns 1 if there are none. */
static int renew(struct hawser__balance *balance)
{
	if (!balance->fresh)
		return prepare(balance);
	return balance->blockwise ? take_matrix(balance, 0) : factorise(balance, 1);
}

void hawser__balance_invert(struct hawser__balance *balance, double *x, double goal)
{
	size_t size = ((size_t)balance->unknowns + 1)*sizeof *x;

	while (!balance->direct) {
		memcpy(balance->kept, x, size);
		if (!gmres(balance, x, goal))
			return;
		memcpy(x, balance->kept, size);
		if (renew(balance)) {
			for (int i = 0; i <= balance->unknowns; i++)
				x[i] = NAN; /* the corrector fails */
			return;
		}
	}
	apply(balance, x, 'T');
}

/* x [P + 1] = M^-1 (0, ..., 0, last) from an estimate of its direction [size]; base [P + 1] is work
 * space. */
static void improve(struct hawser__balance *balance, double *x, double *base, const double *estimate,
                    double last, double goal)
{
	int P = balance->unknowns;
	double length;

	for (int i = 0; i < P; i++)
		base[i] = estimate[balance->slot[i]]/balance->col_scale[i];
	base[P] = estimate[balance->base.size - 1]/balance->base.W;
	cblas_dscal(P + 1, last/cblas_ddot(P + 1, balance->border, 1, base, 1), base, 1);
	multiply(balance, x, base);
	cblas_dscal(P + 1, -1.0, x, 1);
	x[P] = 0.0;
	length = cblas_dnrm2(P + 1, x, 1);
	if (length > goal*fabs(last))
		hawser__balance_invert(balance, x, goal*fabs(last)/length);
	else
		memset(x, 0, ((size_t)P + 1)*sizeof *x);
	cblas_daxpy(P + 1, 1.0, base, 1, x, 1);
}

void hawser__balance_solve(struct hawser__orbit *orbit, double *dy, int homogeneous, double last)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int P = balance->unknowns, end = orbit->size - 1;
	double *x = balance->rhs, goal = orbit->goal;

	if (!(goal > 0.0))
		goal = homogeneous ? TANGENT_RESIDUAL : NEWTON_RESIDUAL;
	set_right(balance, x, homogeneous, last);
	if (homogeneous && orbit->estimate)
		improve(balance, x, x + P + 1, orbit->estimate, last, goal);
	else
		hawser__balance_invert(balance, x, goal);
	/* a prediction from points with other active pairs may have values in inactive ones */
	for (int i = 0; i < end; i++)
		dy[i] = homogeneous ? 0.0 : balance->at[i] - balance->given[i];
	for (int i = 0; i < P; i++)
		dy[balance->slot[i]] = x[i]*balance->col_scale[i];
	dy[end] = x[P]*orbit->W;
	if (homogeneous)
		balance->turn = x[P]/sqrt(hawser__orbit_dot(orbit, dy, dy));
}
