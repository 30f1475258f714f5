/* response/time/nystrom.c - see nystrom.h.
 *
 *   P, P2    (a; b; e5; e3) times R, and times R^2
 *   Pa, Qa   P a, and (P + P2) a
 *
 * Derivatives by H: (H P)' = P2 and (H^2 P a)' = H (P + P2) a, from R' = -d a R^2 and H d a R = I - R.
 * By Omega they are -H/Omega times that.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "core/hot.h"
#include "response/time/nystrom.h"

typedef double matrix[HAWSER_RK_ROWS][HAWSER_RK_STAGES];

/* out = left right, for a square lower-triangular right of which `rows` rows count. */
HAWSER_PART void multiply(matrix out, matrix left, double (*right)[HAWSER_RK_STAGES])
{
	for (int i = 0; i < HAWSER_RK_ROWS; i++) {
		hawser__vec sum[3] = {{0.0}, {0.0}, {0.0}};
		int count = i < HAWSER_RK_STAGES ? i : HAWSER_RK_STAGES;

		for (int k = 0; k < count; k++) {
			const hawser__vec *row = (const hawser__vec *)right[k];

			sum[0] += left[i][k]*row[0];
			sum[1] += left[i][k]*row[1];
			sum[2] += left[i][k]*row[2];
		}
		memcpy(out[i], sum, sizeof sum);
	}
}

/* R = (I + x a)^-1 by rows. */
HAWSER_PART void invert(double (*R)[HAWSER_RK_STAGES], matrix a, double x)
{
	for (int i = 0; i < HAWSER_RK_STAGES; i++) {
		hawser__vec sum[3] = {{0.0}, {0.0}, {0.0}};

		for (int k = 0; k < i; k++) {
			const hawser__vec *row = (const hawser__vec *)R[k];

			sum[0] -= x*a[i][k]*row[0];
			sum[1] -= x*a[i][k]*row[1];
			sum[2] -= x*a[i][k]*row[2];
		}
		memcpy(R[i], sum, sizeof sum);
		R[i][i] = 1.0;
	}
}

static double row_sum(const double *row)
{
	double sum = 0.0;

	for (int l = 0; l < HAWSER_RK_STAGES; l++)
		sum += row[l];
	return sum;
}

HAWSER_HOT
static void eliminate(matrix P, matrix P2, matrix Pa, matrix Qa, double x)
{
	const struct hawser__tableau *rk = &hawser__dop853;
	double R[HAWSER_RK_STAGES][HAWSER_RK_STAGES];
	matrix all;

	memcpy(all, rk->a, sizeof rk->a);
	memcpy(all[HAWSER_RK_END], rk->b, sizeof rk->b);
	memcpy(all[HAWSER_RK_FIVE], rk->e5, sizeof rk->e5);
	memcpy(all[HAWSER_RK_THREE], rk->e3, sizeof rk->e3);
	invert(R, all, x);
	multiply(P, all, R);
	multiply(P2, P, R);
	multiply(Pa, P, all);
	multiply(Qa, P2, all);
	for (int i = 0; i < HAWSER_RK_ROWS; i++)
		for (int l = 0; l < HAWSER_RK_STAGES; l++)
			Qa[i][l] += Pa[i][l];
}

void hawser__nystrom(struct hawser__nystrom *nystrom, double damping, double h, double omega)
{
	double H = h/omega, by_omega = -H/omega;
	matrix P, P2, Pa, Qa;

	eliminate(P, P2, Pa, Qa, H*damping);
	for (int i = 0; i < HAWSER_RK_ROWS; i++) {
		nystrom->uv[i] = H*row_sum(P[i]);
		nystrom->vv[i] = -damping*nystrom->uv[i];
		nystrom->uv_omega[i] = by_omega*row_sum(P2[i]);
		nystrom->vv_omega[i] = -damping*nystrom->uv_omega[i];
		for (int l = 0; l < HAWSER_RK_STAGES; l++) {
			nystrom->uf[i][l] = H*H*Pa[i][l];
			nystrom->vf[i][l] = H*P[i][l];
			nystrom->uf_omega[i][l] = by_omega*H*Qa[i][l];
			nystrom->vf_omega[i][l] = by_omega*P2[i][l];
		}
	}
}
