/* modes/compliance.c - modes from the compliance operator, with strains as unknowns.
 *
 *   x      coefficients of the strains: orthonormal Legendre polynomials on each element
 *   d_kc   direction: gradient of displacement c per unit of strain k (includes 1/sqrt(stiffness))
 *   X_c    displacements: X_c(s) = integral from 0 to s of sum_k d_kc * strain_k
 *   C x    = X(l): 0, since the end is fixed. D rows. A spring to ground adds an unknown, its strain,
 *            and a row that makes it that of its lump. The spring of an elastic support is a strain
 *            at an end: it displaces the whole cable (at A), or only what C measures (at B). That of
 *            an absorber is the strain of its own spring and displaces its mass only
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
 * The refinement is in compliance_refine.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/compliance.h"

/* Matrices are column-major, as in LAPACK; n unknowns, `block` of them per element, and the springs. */
struct work {
	int n, block, joint; /* joint: index of the first joint */
	double *M;      /* [n][n] */
	double *C;      /* [D + springs] columns of n: constraints, first the end displacement of each
	                 * function; then their QR */
	double *tau;    /* [D + springs] */
	double *moment; /* [D] columns of n: integral of X over the function's own element */
	double *F, *G;  /* [block] columns of D*order: gradients, displacements times sqrt(weight) */
	double *J;      /* [order][order] running integral times sqrt(weight) */
	double *mu;     /* [n] */
	double *x;      /* [count] columns of n */
	lapack_int *support;
	struct hawser__hold hold;
};

static void work_free(struct work *w)
{
	hawser__hold_clear(&w->hold);
	free(w->x);
}

static int work_init(struct work *w, const struct hawser__plane *plane, int degree, int order,
                     int elements, int count)
{
	size_t block = (size_t)degree*(size_t)plane->D, springs = (size_t)plane->springs;
	size_t m = (size_t)order, first = block*(size_t)elements + springs;
	size_t n = first + (size_t)plane->joints + (size_t)plane->absorbers;

	*w = (struct work){.n = (int)n, .block = (int)block, .joint = (int)first};
	w->M = hawser__hold(&w->hold, n*n + 1, sizeof *w->M);
	w->C = hawser__hold(&w->hold, n*(HAWSER__MAX_D + springs) + 1, sizeof *w->C);
	w->tau = hawser__hold(&w->hold, HAWSER__MAX_D + springs + 1, sizeof *w->tau);
	w->moment = hawser__hold(&w->hold, n*HAWSER__MAX_D + 1, sizeof *w->moment);
	w->F = hawser__hold(&w->hold, m*HAWSER__MAX_D*block + 1, sizeof *w->F);
	w->G = hawser__hold(&w->hold, m*HAWSER__MAX_D*block + 1, sizeof *w->G);
	w->J = hawser__hold(&w->hold, m*m + 1, sizeof *w->J);
	w->mu = hawser__hold(&w->hold, n + 1, sizeof *w->mu);
	w->x = hawser__numbers(n, (size_t)count); /* which the result takes over */
	w->support = hawser__hold(&w->hold, 2*n, sizeof *w->support);
	return !w->hold.short_of_memory && w->x;
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

/* Length and point masses beyond element e. */
static double mass_beyond(const struct hawser__plane *plane, const struct hawser_grid *grid, int e)
{
	double mass = grid->edge[grid->elements] - grid->edge[e + 1];

	for (int i = 0; i < plane->lumps; i++)
		if (plane->lump[i].edge > e)
			mass += plane->lump[i].mass;
	for (int i = 0; i < plane->absorbers; i++)
		if (plane->lump[plane->absorber[i].lump].edge > e)
			mass += plane->absorber[i].mass;
	return mass;
}

/* A function displaces all points beyond its element by its end displacement. Add this to the lower
 * triangle of M, as inner products of C with C and with the moments. */
static void couple(struct work *w, const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	int n = w->n, D = plane->D;

	for (int i = 0; i < w->block*grid->elements; i++) {
		double rest = mass_beyond(plane, grid, i/w->block);
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

/* The joints' part of C and of the lower triangle of M: those of end A displace the whole cable. */
static void join(struct work *w, const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	int n = w->n, D = plane->D;
	double all = mass_beyond(plane, grid, -1);

	for (int j = 0, row = w->joint; j < plane->joints; j++, row++) {
		const struct hawser__joint *joint = &plane->joint[j];

		for (int c = 0; c < D; c++)
			w->C[c*n + row] = joint->d[c];
		if (joint->end)
			continue;
		for (int f = 0; f < w->block*grid->elements; f++) {
			double rest = mass_beyond(plane, grid, f/w->block);

			for (int c = 0; c < D; c++)
				w->M[(size_t)f*(size_t)n + (size_t)row] +=
					joint->d[c]*(w->C[c*n + f]*rest + w->moment[c*n + f]);
		}
		for (int i = 0; i <= j; i++)
			for (int c = 0; c < D && !plane->joint[i].end; c++)
				w->M[(size_t)(w->joint + i)*(size_t)n + (size_t)row] +=
					joint->d[c]*plane->joint[i].d[c]*all;
	}
}

/* The absorbers' part of the lower triangle of M. */
static void hang(struct work *w, const struct hawser__plane *plane)
{
	int n = w->n, D = plane->D;

	for (int i = 0, row = w->joint + plane->joints; i < plane->absorbers; i++, row++) {
		const struct hawser__absorber *absorber = &plane->absorber[i];
		double scale = absorber->mass*absorber->root;

		for (int c = 0; c < D; c++) {
			double part = scale*absorber->a[c];

			for (int f = 0; f < w->block*plane->lump[absorber->lump].edge; f++)
				w->M[(size_t)f*(size_t)n + (size_t)row] += part*w->C[c*n + f];
			for (int j = 0; j < plane->joints; j++)
				if (!plane->joint[j].end)
					w->M[(size_t)(w->joint + j)*(size_t)n + (size_t)row] +=
						part*plane->joint[j].d[c];
		}
		w->M[(size_t)row*(size_t)(n + 1)] += scale*absorber->root;
	}
}

/* Eigenpairs of M on the null space of the D constraints C: with C = QR, the trailing block of Q'MQ.
 * LAPACKE's info. */
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

void hawser__compliance_strain(double *strain, const double *x, const struct hawser__plane *plane,
                               const struct hawser_grid *grid,
                               const struct hawser__reference *reference, int degree)
{
	int m = grid->order, D = plane->D;

	memset(strain, 0, (size_t)(D*grid->points)*sizeof *strain);
	for (int e = 0; e < grid->elements; e++)
		for (int k = 0; k < D; k++)
			for (int j = 0; j < degree; j++)
				cblas_daxpy(m, x[(e*D + k)*degree + j]*
				            sqrt((j + 0.5)/reference->half[e]),
				            reference->legendre + j*m, 1,
				            strain + k*grid->points + e*m, 1);
	for (int j = 0; j < plane->springs + plane->joints + plane->absorbers; j++)
		strain[D*grid->points + j] = x[D*degree*grid->elements + j];
}

/* Displacement of the lumps: that of end A, `base`, and the integral of the gradient up to their
 * edges. */
static void at_lumps(double *lump, const struct hawser__plane *plane, const struct hawser_grid *grid,
                     const double *gradient, double base)
{
	for (int e = 0, i = 0; i < plane->lumps; i++) {
		for (; e < plane->lump[i].edge; e++)
			base += cblas_ddot(grid->order, grid->weight + e*grid->order, 1,
			                   gradient + e*grid->order, 1);
		lump[i] = base;
	}
}

/* Component c of the displacement of the absorbers' masses. rows: behind those of the cable. */
static void at_absorbers(double *rows, const struct hawser__plane *plane, const double *strain, int c)
{
	double *mass = rows + plane->D*plane->lumps + c*plane->absorbers;

	for (int i = 0; i < plane->absorbers; i++) {
		const struct hawser__absorber *absorber = &plane->absorber[i];

		mass[i] = rows[c*plane->lumps + absorber->lump] + absorber->root*absorber->a[c]*strain[i];
	}
}

/* Displacement c of end A by its joints, or what those of end B add. */
static double by_joints(const double *strain, const struct hawser__plane *plane, int end, int c)
{
	double sum = 0.0;

	for (int j = 0; j < plane->joints; j++)
		if (plane->joint[j].end == end)
			sum += plane->joint[j].d[c]*strain[j];
	return sum;
}

void hawser__compliance_displace(double *displacement, double *end, double *gradient,
                                 const double *strain, const struct hawser__plane *plane,
                                 const struct hawser_grid *grid,
                                 const struct hawser__reference *reference)
{
	int D = plane->D, points = grid->points;
	const double *joint = strain + D*points + plane->springs;

	for (int c = 0; c < D; c++) {
		double start = by_joints(joint, plane, 0, c);

		memset(gradient, 0, (size_t)points*sizeof *gradient);
		for (int k = 0; k < D; k++) {
			const double *d = plane->direction + (k*D + c)*points;

			for (int i = 0; i < points; i++)
				gradient[i] += d[i]*strain[k*points + i];
		}
		end[c] = hawser__grid_running(displacement + c*points, grid, reference, gradient);
		for (int i = 0; plane->joints > 0 && i < points; i++)
			displacement[c*points + i] += start;
		end[c] += start + by_joints(joint, plane, 1, c);
		at_lumps(displacement + D*points + c*plane->lumps, plane, grid, gradient, start);
		at_absorbers(displacement + D*points, plane, joint + plane->joints, c);
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
	int carried = (degree*grid->elements - 1)*plane->D + plane->joints + plane->absorbers, info;
	enum hawser_status status = HAWSER_OK;
	struct work w;

	count = count < carried ? count : carried;
	*pairs = (struct hawser__pairs){.count = count, .degree = degree};
	pairs->omega = hawser__numbers((size_t)count, 1);
	pairs->moved = hawser__numbers((size_t)count, 1);
	if (!work_init(&w, plane, degree, grid->order, grid->elements, count) ||
	    !pairs->omega || !pairs->moved) {
		status = hawser__no_memory(report, "modes");
		goto done;
	}
	for (int e = 0; e < grid->elements; e++)
		element(&w, plane, grid, reference, degree, e);
	couple(&w, plane, grid);
	join(&w, plane, grid);
	hang(&w, plane);
	hawser__spring_constraints(w.C + plane->D*w.n, w.C, w.n, w.block, plane, grid);
	info = eigen(&w, plane->D + plane->springs, count);
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
