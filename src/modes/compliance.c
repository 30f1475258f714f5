/* modes/compliance.c - modes from the compliance operator, with strains as unknowns.
 *
 *   x      coefficients of the strains: orthonormal Legendre polynomials on each element
 *   d_kc   direction: gradient of displacement c per unit of strain k (includes 1/sqrt(stiffness))
 *   X_c    displacements: X_c(s) = integral from 0 to s of sum_k d_kc * strain_k
 *   C x    = X(l): 0, since the end is fixed. D rows
 *   M      = integral of X.X: the kinetic energy, in terms of strains
 *   mu     = 1/omega^2
 *
 * With strains as unknowns the matrix of the strain energy is the identity for any EA, and no term
 * of order 1/epsilon is formed. The modes are the largest eigenvalues of Z'MZ, where Z is an
 * orthonormal basis of the null space of C; a symmetric eigensolver computes the largest
 * eigenvalues to full relative accuracy. With a displacement basis, assembling K causes a relative
 * error of u/epsilon (u is the unit round-off). The dynamic tension a/epsilon, which is an unknown
 * here, would then be a small difference of displacements with the same loss.
 *
 * The refinement is the iterated Galerkin method (I. H. Sloan, Math. Comp. 30 (1976) 758): one step
 * with the exact operator removes most of the error of a shape. A second step is cheap.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/compliance.h"

/* Matrices are column-major, as in LAPACK; n unknowns, `block` of them per element. */
struct work {
	int n, block;
	double *M;      /* [n][n] */
	double *C;      /* [D] columns of n: end displacement of each function; then its QR */
	double *tau;    /* [D] */
	double *moment; /* [D] columns of n: integral of X over the function's own element */
	double *F, *G;  /* [block] columns of D*order: gradients, displacements times sqrt(weight) */
	double *J;      /* [order][order] running integral times sqrt(weight) */
	double *mu;     /* [n] */
	double *x;      /* [count] columns of n */
	lapack_int *support;
};

static void work_free(struct work *w)
{
	free(w->M);
	free(w->C);
	free(w->tau);
	free(w->moment);
	free(w->F);
	free(w->G);
	free(w->J);
	free(w->mu);
	free(w->x);
	free(w->support);
}

static double *array(size_t a, size_t b)
{
	/* NOLINTNEXTLINE(clang-analyzer-optin.portability.UnixAPI): sizes are limited */
	return calloc(a ? a : 1, (b ? b : 1)*sizeof(double));
}

static int work_init(struct work *w, int D, int degree, int order, int elements, int count)
{
	size_t n = (size_t)degree*(size_t)elements*(size_t)D, block = (size_t)degree*(size_t)D;
	size_t m = (size_t)order;

	*w = (struct work){.n = (int)n, .block = (int)block};
	w->M = array(n, n);
	w->C = array(n, HAWSER__MAX_D);
	w->tau = array(HAWSER__MAX_D, 1);
	w->moment = array(n, HAWSER__MAX_D);
	w->F = array(m*HAWSER__MAX_D, block);
	w->G = array(m*HAWSER__MAX_D, block);
	w->J = array(m, m);
	w->mu = array(n, 1);
	w->x = array(n, (size_t)count);
	w->support = calloc(2*n, sizeof *w->support);
	return w->M && w->C && w->tau && w->moment && w->F && w->G && w->J && w->mu && w->x &&
	       w->support;
}

/* Compute F, the gradients of the functions of element e at its nodes. */
static void gradients(struct work *w, const struct hawser__plane *plane,
                      const struct hawser_grid *grid, const struct hawser__reference *reference,
                      int degree, int e)
{
	int D = plane->D, m = grid->order;
	for (int k = 0; k < D; k++)
		for (int j = 0; j < degree; j++) {
			double norm = sqrt((j + 0.5)/reference->half[e]);
			const double *P = reference->legendre + j*m;

			for (int c = 0; c < D; c++) {
				const double *d = plane->direction + (k*D + c)*grid->points + e*m;
				double *F = w->F + (size_t)(k*degree + j)*(size_t)(D*m) + c*m;

				for (int i = 0; i < m; i++)
					F[i] = norm*P[i]*d[i];
			}
		}
}

/* Contributions of element e alone: its diagonal block of M, its part of C and of the moments. */
static void element(struct work *w, const struct hawser__plane *plane,
                    const struct hawser_grid *grid, const struct hawser__reference *reference,
                    int degree, int e)
{
	int D = plane->D, m = grid->order, first = e*w->block;
	const double *weight = grid->weight + e*m;

	gradients(w, plane, grid, reference, degree, e);
	for (int i = 0; i < m; i++)
		for (int k = 0; k < m; k++)
			w->J[k*m + i] = sqrt(weight[i])*reference->half[e]*
			                  reference->running[i*m + k];
	for (int c = 0; c < D; c++)
		cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, m, w->block, m, 1.0, w->J, m,
		            w->F + c*m, D*m, 0.0, w->G + c*m, D*m);
	cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, w->block, D*m, 1.0, w->G, D*m, 0.0,
	            w->M + (size_t)first*(size_t)(w->n + 1), w->n);
	for (int j = 0; j < w->block; j++)
		for (int c = 0; c < D; c++) {
			const double *F = w->F + (size_t)j*(size_t)(D*m) + c*m;
			const double *G = w->G + (size_t)j*(size_t)(D*m) + c*m;
			double end = 0.0, moment = 0.0;

			for (int i = 0; i < m; i++) {
				end += weight[i]*F[i];
				moment += sqrt(weight[i])*G[i];
			}
			w->C[c*w->n + first + j] = end;
			w->moment[c*w->n + first + j] = moment;
		}
}

/* A function displaces all points beyond its element by its end displacement. Add this to the lower
 * triangle of M, as inner products of C with C and with the moments. */
static void couple(struct work *w, int D, const struct hawser_grid *grid)
{
	int n = w->n, elements = grid->elements;

	for (int i = 0; i < n; i++) {
		double rest = grid->edge[elements] - grid->edge[i/w->block + 1];
		int own = i/w->block*w->block;

		for (int c = 0; c < D; c++) {
			double beyond = w->C[c*n + i]*rest, lever = beyond + w->moment[c*n + i];

			for (int j = 0; j < own; j++)
				w->M[(size_t)j*(size_t)n + (size_t)i] += w->C[c*n + j]*lever;
			for (int j = own; j <= i; j++)
				w->M[(size_t)j*(size_t)n + (size_t)i] += w->C[c*n + j]*beyond;
		}
	}
}

/* Eigenpairs of M on the null space of C: with C = QR, the trailing block of Q'MQ. LAPACKE's
 * info. */
static int eigen(struct work *w, int D, int count)
{
	int n = w->n, free_n = n - D, info;
	lapack_int found = 0;

	for (int j = 0; j < n; j++)
		for (int i = j + 1; i < n; i++)
			w->M[(size_t)i*(size_t)n + (size_t)j] = w->M[(size_t)j*(size_t)n + (size_t)i];
	info = LAPACKE_dgeqrf(LAPACK_COL_MAJOR, n, D, w->C, n, w->tau);
	if (!info)
		info = LAPACKE_dormqr(LAPACK_COL_MAJOR, 'L', 'T', n, n, D, w->C, n, w->tau, w->M, n);
	if (!info)
		info = LAPACKE_dormqr(LAPACK_COL_MAJOR, 'R', 'N', n, n, D, w->C, n, w->tau, w->M, n);
	if (!info)
		info = LAPACKE_dsyevr(LAPACK_COL_MAJOR, 'V', 'I', 'L', free_n,
		                      w->M + (size_t)D*(size_t)(n + 1), n, 0.0, 0.0,
		                      free_n - count + 1, free_n, 0.0, &found, w->mu, w->x + D, n,
		                      w->support);
	if (info || found != count)
		return info ? info : -1;
	return LAPACKE_dormqr(LAPACK_COL_MAJOR, 'L', 'N', n, count, D, w->C, n, w->tau, w->x, n);
}

double hawser__eigen_floor(int order)
{
	return 4.0*DBL_EPSILON*sqrt(order);
}

enum hawser_status hawser__eigen_lost(int number, int in_plane, double lowest,
                                      struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NAN, "modes",
	                    "the frequency of %s mode %d lies too far above the lowest one (%.3g in "
	                    "1/time unit) for double precision: ask for fewer modes, or raise "
	                    "model.basis",
	                    in_plane ? "in-plane" : "out-of-plane", number, lowest);
}

void hawser__compliance_strain(double *strain, const double *x, int D,
                               const struct hawser_grid *grid,
                               const struct hawser__reference *reference, int degree)
{
	int m = grid->order;

	memset(strain, 0, (size_t)(D*grid->points)*sizeof *strain);
	for (int e = 0; e < grid->elements; e++)
		for (int k = 0; k < D; k++)
			for (int j = 0; j < degree; j++)
				cblas_daxpy(m, x[(e*D + k)*degree + j]*
				            sqrt((j + 0.5)/reference->half[e]),
				            reference->legendre + j*m, 1,
				            strain + k*grid->points + e*m, 1);
}

void hawser__compliance_displace(double *displacement, double *end, double *gradient,
                                 const double *strain, const struct hawser__plane *plane,
                                 const struct hawser_grid *grid,
                                 const struct hawser__reference *reference)
{
	int D = plane->D, points = grid->points;

	for (int c = 0; c < D; c++) {
		memset(gradient, 0, (size_t)points*sizeof *gradient);
		for (int k = 0; k < D; k++) {
			const double *d = plane->direction + (k*D + c)*points;

			for (int i = 0; i < points; i++)
				gradient[i] += d[i]*strain[k*points + i];
		}
		end[c] = hawser__grid_running(displacement + c*points, grid, reference, gradient);
	}
}

void hawser__pairs_clear(struct hawser__pairs *pairs)
{
	free(pairs->omega);
	free(pairs->moved);
	free(pairs->x);
	free(pairs->strain);
	free(pairs->displacement);
	*pairs = (struct hawser__pairs){0};
}

/* Reorder the columns of x, which have ascending mu, by ascending omega. If mu is of the order of
 * the solver's round-off, relative to the largest mu, the frequency is undetermined, except that it
 * lies above all others. It is set to infinity, and the solution fails if that mode is
 * requested. */
static enum hawser_status hand_over(struct hawser__pairs *pairs, struct work *w,
                                    struct hawser_report *report)
{
	double largest = pairs->count ? w->mu[pairs->count - 1] : 0.0;

	if (!isfinite(1.0/sqrt(largest)) && pairs->count)
		return hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                    "the lowest frequency came out as not a number (1/omega^2 = %g): check "
		                    "EA, rho, d and the tension of the span", largest);
	for (int k = 0; k < pairs->count; k++) {
		double mu = w->mu[pairs->count - 1 - k];

		pairs->omega[k] = mu > hawser__eigen_floor(w->n)*largest ? 1.0/sqrt(mu) : HUGE_VAL;
	}
	pairs->x = w->x;
	w->x = NULL;
	return HAWSER_OK;
}

enum hawser_status hawser__compliance_solve(struct hawser__pairs *pairs,
                                            const struct hawser__plane *plane,
                                            const struct hawser_grid *grid,
                                            const struct hawser__reference *reference, int degree,
                                            int count, struct hawser_report *report)
{
	int carried = (degree*grid->elements - 1)*plane->D, info;
	enum hawser_status status = HAWSER_OK;
	struct work w;

	count = count < carried ? count : carried;
	*pairs = (struct hawser__pairs){.count = count, .degree = degree};
	pairs->omega = array((size_t)count, 1);
	pairs->moved = array((size_t)count, 1);
	if (!work_init(&w, plane->D, degree, grid->order, grid->elements, count) ||
	    !pairs->omega || !pairs->moved) {
		status = hawser__no_memory(report, "modes");
		goto done;
	}
	for (int e = 0; e < grid->elements; e++)
		element(&w, plane, grid, reference, degree, e);
	couple(&w, plane->D, grid);
	info = eigen(&w, plane->D, count);
	if (info) {
		status = hawser__lapack_starved(info) ? hawser__no_memory(report, "modes")
			: hawser__fail(report, HAWSER_ERR_NAN, "modes",
			               "the eigenvalue solver met a not-a-number with %d functions a "
			               "component: check EA, rho, d and the tension of the span",
			               degree*grid->elements - 1);
		goto done;
	}
	status = hand_over(pairs, &w, report);
done:
	work_free(&w);
	if (status)
		hawser__pairs_clear(pairs);
	return status;
}

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
	} else {
		double det = A[0][0]*A[1][1] - A[0][1]*A[1][0];

		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): b has D values */
		F0[0] = (b[0]*A[1][1] - b[1]*A[0][1])/det;
		F0[1] = (b[1]*A[0][0] - b[0]*A[1][0])/det;
	}
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
	for (int k = 0; k < D; k++)
		for (int i = 0; i < points; i++) {
			const double *d = plane->direction + k*D*points + i;
			double sum = 0.0;

			for (int c = 0; c < D; c++)
				sum += d[c*points]*force[c*points + i];
			strain[k*points + i] = sum;
		}
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

double hawser__compliance_product(const double *a, const double *b, int D,
                                  const struct hawser_grid *grid)
{
	double sum = 0.0;

	for (int c = 0; c < D; c++)
		for (int i = 0; i < grid->points; i++)
			sum += grid->weight[i]*a[c*grid->points + i]*b[c*grid->points + i];
	return sum;
}

/* Orthogonalise mode k against the lower modes j: inverse iteration amplifies their round-off by
 * the factor (omega_k/omega_j)^2. */
static void purge(struct hawser__pairs *pairs, int D, const struct hawser_grid *grid, int k)
{
	int values = D*grid->points;
	double *displacement = pairs->displacement + (size_t)k*(size_t)values;
	double *strain = pairs->strain + (size_t)k*(size_t)values;

	for (int j = 0; j < k; j++) {
		const double *lower = pairs->displacement + (size_t)j*(size_t)values;
		double part = hawser__compliance_product(lower, displacement, D, grid);

		cblas_daxpy(values, -part, lower, 1, displacement, 1);
		cblas_daxpy(values, -part, pairs->strain + (size_t)j*(size_t)values, 1, strain, 1);
	}
}

void hawser__compliance_apply(double *displacement, double *strain, double omega,
                              const struct hawser__plane *plane, const struct hawser_grid *grid,
                              const struct hawser__reference *reference, double *work)
{
	int D = plane->D, points = grid->points;
	double end[HAWSER__MAX_D]; /* 0 up to round-off */
	double *gradient = work + D*points;

	for (int c = 0; c < D; c++) {
		double *force = work + c*points;

		hawser__grid_running(force, grid, reference, displacement + c*points);
		cblas_dscal(points, -omega*omega, force, 1);
	}
	balance(work, strain, plane, grid);
	hawser__compliance_displace(displacement, end, gradient, strain, plane, grid, reference);
	hold_end(strain, end, plane, grid);
	hawser__compliance_displace(displacement, end, gradient, strain, plane, grid, reference);
}

static void step(struct hawser__pairs *pairs, const struct hawser__plane *plane,
                 const struct hawser_grid *grid, const struct hawser__reference *reference, int k,
                 double *work)
{
	int D = plane->D, values = D*grid->points;
	double *displacement = pairs->displacement + (size_t)k*(size_t)values;
	double *strain = pairs->strain + (size_t)k*(size_t)values, norm;

	hawser__compliance_apply(displacement, strain, pairs->omega[k], plane, grid, reference,
	                         work);
	purge(pairs, D, grid, k);
	norm = sqrt(hawser__compliance_product(displacement, displacement, D, grid));
	cblas_dscal(values, 1.0/norm, displacement, 1);
	cblas_dscal(values, 1.0/norm, strain, 1);
	pairs->omega[k] = sqrt(hawser__compliance_product(strain, strain, D, grid));
}

/* Strains and displacements of the coefficients of pair k. */
static void unfold(struct hawser__pairs *pairs, const struct hawser__plane *plane,
                   const struct hawser_grid *grid, const struct hawser__reference *reference,
                   int k, double *work)
{
	int D = plane->D, n = D*pairs->degree*grid->elements;
	size_t values = (size_t)D*(size_t)grid->points, column = (size_t)(pairs->count - 1 - k);
	double *strain = pairs->strain + (size_t)k*values, end[HAWSER__MAX_D];

	hawser__compliance_strain(strain, pairs->x + column*(size_t)n, D, grid, reference,
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
	size_t points = (size_t)grid->points, values = (size_t)plane->D*points;
	double *work = array(HAWSER__MAX_D + 1, points);

	pairs->strain = array((size_t)count, values);
	pairs->displacement = array((size_t)count, values);
	if (!work || !pairs->strain || !pairs->displacement) {
		free(work);
		return hawser__no_memory(report, "modes");
	}
	for (int k = 0; k < count; k++) {
		double before = pairs->omega[k];

		if (!isfinite(before)) {
			free(work);
			return hawser__eigen_lost(k + 1, plane->D == 2, pairs->omega[0], report);
		}
		unfold(pairs, plane, grid, reference, k, work);
		step(pairs, plane, grid, reference, k, work);
		pairs->moved[k] = fabs(pairs->omega[k] - before)/pairs->omega[k];
		step(pairs, plane, grid, reference, k, work);
	}
	free(work);
	return HAWSER_OK;
}
