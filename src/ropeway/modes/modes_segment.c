/* ropeway/modes/modes_segment.c - force, strain and displacement along one piece of rope
 * (modes_equations.c). SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "ropeway/modes/modes.h"

/* out [D][points] = C F. */
void hawser__segment_gradient(double *out, const double *F, const struct hawser__lmode_segment *s)
{
	int points = s->grid.points;

	if (s->D == 1) {
		for (int i = 0; i < points; i++)
			out[i] = (s->sb ? s->sb[i]*s->sb[i] : s->sa*s->sa)*F[i];
		return;
	}
	for (int i = 0; i < points; i++) {
		double c = s->cosine[i], n = s->sine[i];
		double a = s->sa*s->sa*(c*F[i] + n*F[points + i]);
		double b = s->sb[i]*s->sb[i]*(c*F[points + i] - n*F[i]);

		out[i] = c*a - n*b;
		out[points + i] = n*a + c*b;
	}
}

void hawser__segment_strains(double *out, const double *F, const struct hawser__lmode_segment *s)
{
	int points = s->grid.points;

	if (s->D == 1) {
		for (int i = 0; i < points; i++)
			out[i] = (s->sb ? s->sb[i] : s->sa)*F[i];
		return;
	}
	for (int i = 0; i < points; i++) {
		out[i] = s->sa*(s->cosine[i]*F[i] + s->sine[i]*F[points + i]);
		out[points + i] = s->sb[i]*(s->cosine[i]*F[points + i] - s->sine[i]*F[i]);
	}
}

static double integral(const double *f, const struct hawser__lmode_segment *s)
{
	return cblas_ddot(s->grid.points, s->grid.weight, 1, f, 1);
}

/* F [D][points] = minus the integral of f; end[D] at the end. */
static void unload(double *F, double *end, const double *f, const struct hawser__lmode_segment *s)
{
	int points = s->grid.points;

	for (int c = 0; c < s->D; c++) {
		end[c] = -hawser__grid_running(F + c*points, &s->grid, &s->table, f + c*points);
		cblas_dscal(points, -1.0, F + c*points, 1);
	}
}

/* X of an arc on the ground k, for X0 = F0 = 0 and the force F without the ground: X = inverse J C
 * F. */
static void on_ground(double *X, const double *F, const struct hawser__lmode_segment *s, double *work)
{
	int points = s->grid.points;

	hawser__segment_gradient(work + points, F, s);
	(void)hawser__grid_running(work, &s->grid, &s->table, work + points);
	cblas_dgemv(CblasRowMajor, CblasNoTrans, points, points, 1.0, s->inverse, points, work, 1, 0.0, X,
	            1);
}

/* The force F with the ground's part: F += the integral of k X. Returns that over the whole length. */
double hawser__segment_ground(double *F, const double *X, const struct hawser__lmode_segment *s,
                         double *work)
{
	int points = s->grid.points;
	double all;

	for (int i = 0; i < points; i++)
		work[points + i] = s->k[i]*X[i];
	all = hawser__grid_running(work, &s->grid, &s->table, work + points);
	cblas_daxpy(points, 1.0, work, 1, F, 1);
	return all;
}

/* The part of the load in the end's displacement x[D] and force f[D], for X0 = F0 = 0; F [D][points]
 * keeps the force. */
void hawser__segment_load(double *x, double *f, double *F, const double *load,
                       const struct hawser__lmode_segment *s, double *work)
{
	int points = s->grid.points;

	unload(F, f, load, s);
	if (s->k) {
		on_ground(work + 2*points, F, s, work);
		f[0] += hawser__segment_ground(F, work + 2*points, s, work);
	}
	hawser__segment_gradient(work, F, s);
	for (int c = 0; c < s->D; c++)
		x[c] = integral(work + c*points, s);
}

/* P of a segment without ground. */
void hawser__segment_free(struct hawser__lmode_segment *s, double *work)
{
	int points = s->grid.points;

	memset(s->P, 0, sizeof s->P);
	for (int c = 0; c < s->D; c++) {
		for (int k = 0; k < s->D; k++)
			for (int i = 0; i < points; i++)
				work[k*points + i] = k == c;
		hawser__segment_gradient(work + s->D*points, work, s);
		for (int k = 0; k < s->D; k++)
			s->P[0][1][k][c] = integral(work + (s->D + k)*points, s);
		s->P[0][0][c][c] = s->P[1][1][c][c] = 1.0;
	}
}

/* The same with ground: unit[0], unit[1] are X by a unit X0 and a unit F0. */
enum hawser_status hawser__segment_on_ground(struct hawser__lmode_segment *s, double *work,
                                          struct hawser_report *report)
{
	int m = s->grid.points, info;
	double c = s->sa*s->sa, *one = work + 4*m, *A;
	lapack_int *pivot = calloc((size_t)m, sizeof *pivot);

	s->inverse = hawser__numbers((size_t)m*(size_t)m, 1);
	s->unit[0] = hawser__numbers((size_t)m, 1);
	s->unit[1] = hawser__numbers((size_t)m, 1);
	if (!pivot || !s->inverse || !s->unit[0] || !s->unit[1]) {
		free(pivot);
		return hawser__no_memory(report, "line modes");
	}
	A = s->inverse;
	for (int j = 0; j < m; j++) { /* column j of I - c J J k */
		for (int i = 0; i < m; i++)
			work[i] = i == j ? s->k[j] : 0.0;
		(void)hawser__grid_running(work + m, &s->grid, &s->table, work);
		(void)hawser__grid_running(work, &s->grid, &s->table, work + m);
		for (int i = 0; i < m; i++)
			A[i*m + j] = (i == j) - c*work[i];
	}
	info = (int)LAPACKE_dgetrf(LAPACK_ROW_MAJOR, m, m, A, m, pivot);
	if (!info)
		info = (int)LAPACKE_dgetri(LAPACK_ROW_MAJOR, m, A, m, pivot);
	free(pivot);
	if (info)
		return hawser__lapack_starved(info) ? hawser__no_memory(report, "line modes")
			: hawser__fail(report, HAWSER_ERR_NAN, "line modes", "the equations of an arc are "
			               "singular or not a number: check EA, rho and the radius");
	for (int i = 0; i < m; i++)
		one[i] = 1.0;
	cblas_dgemv(CblasRowMajor, CblasNoTrans, m, m, 1.0, A, m, one, 1, 0.0, s->unit[0], 1);
	on_ground(s->unit[1], one, s, work);
	for (int k = 0; k < 2; k++) {
		for (int i = 0; i < m; i++)
			work[2*m + i] = k;
		s->P[1][k][0][0] = k + hawser__segment_ground(work + 2*m, s->unit[k], s, work);
		s->P[0][k][0][0] = (k == 0) + c*integral(work + 2*m, s);
	}
	return HAWSER_OK;
}
