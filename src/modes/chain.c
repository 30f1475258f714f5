/* modes/chain.c - a chain of N springs and point masses: a symmetric second-order scheme.
 *
 *   h        l/N: mass of a point, and unstretched length of a spring
 *   X_i, F_j displacement of point i (0..N, with fixed ends); force in spring j (0..N-1), from
 *            point j to j+1, in fixed axes: tangent and normal at mid-length
 *   C_j      compliance of a spring, sa^2 e e' + sb^2 n n' at its middle:
 *            sa^2 = epsilon, sb^2 = g/T
 *
 * The equations are F_j - F_(j-1) = -omega^2 h X_j and X_(j+1) - X_j = h C_j F_j. With forces as
 * unknowns nothing is divided by epsilon. A^-1 is applied without a matrix, by two running sums,
 * with F_0 such that the far end is fixed. It is symmetric: frequencies are real and shapes
 * orthogonal for any N.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/methods.h"
#include "modes/halving.h"

struct chain {
	int N, D;
	double h;
	double *C;     /* [N][D][D] h times the compliance */
	double *F;     /* [N][D] forces of the last application */
	double hold[4]; /* [D][D] inverse of the sum of C: force at A that moves the far end by one */
};

/* Direction of spring j from the axes: cosine, sine; and sb^2. */
static void direction(double *cosine, double *sine, double *turning,
                      const struct hawser_statics *st, double s)
{
	double um = st->eta + 0.5*st->delta*st->l, bent = st->delta*(s - 0.5*st->l), u = um + bent;
	double T = hypot(1.0, u), cm = hypot(1.0, um);

	*cosine = (1.0 + u*um)/(T*cm);
	*sine = bent/(T*cm);
	*turning = (1.0 + st->epsilon*T)/T;
}

static void chain_free(struct chain *t)
{
	free(t->C);
	free(t->F);
}

static int chain_init(struct chain *t, const struct hawser_statics *st, enum hawser_plane plane,
                      int N)
{
	int D = plane == HAWSER_IN_PLANE ? 2 : 1;
	double sum[3] = {0.0}, det;

	*t = (struct chain){.N = N, .D = D, .h = st->l/N};
	t->C = malloc((size_t)(N*D*D)*sizeof *t->C);
	t->F = malloc((size_t)(N*D)*sizeof *t->F);
	if (!t->C || !t->F)
		return 0;
	for (int j = 0; j < N; j++) {
		double c, s, turning, *C = t->C + j*D*D;

		direction(&c, &s, &turning, st, (j + 0.5)*t->h);
		C[0] = t->h*turning;
		if (D == 2) {
			C[0] = t->h*(st->epsilon*c*c + turning*s*s);
			C[1] = C[2] = t->h*c*s*(st->epsilon - turning);
			C[3] = t->h*(st->epsilon*s*s + turning*c*c);
			sum[1] += C[1];
			sum[2] += C[3];
		}
		sum[0] += C[0];
	}
	if (D == 1) {
		t->hold[0] = 1.0/sum[0];
		return 1;
	}
	det = sum[0]*sum[2] - sum[1]*sum[1];
	t->hold[0] = sum[2]/det;
	t->hold[1] = t->hold[2] = -sum[1]/det;
	t->hold[3] = sum[0]/det;
	return 1;
}

/* C_j times f[D], added to x[D]. */
static void stretch(double *x, const struct chain *t, int j, const double *f)
{
	const double *C = t->C + j*t->D*t->D;

	for (int a = 0; a < t->D; a++)
		for (int b = 0; b < t->D; b++)
			/* f has D values */
			/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult) */
			x[a] += C[a*t->D + b]*f[b];
}

static void apply(double *y, const double *x, void *context)
{
	struct chain *t = context;
	int D = t->D;
	double f[2] = {0.0}, end[2] = {0.0}, now[2] = {0.0};

	for (int j = 0; j < t->N; j++) {
		for (int c = 0; c < D; c++) {
			if (j > 0)
				f[c] -= t->h*x[(j - 1)*D + c];
			t->F[j*D + c] = f[c];
		}
		stretch(end, t, j, f);
	}
	for (int a = 0; a < D; a++) {
		double hold = 0.0;

		for (int b = 0; b < D; b++)
			hold -= t->hold[a*D + b]*end[b];
		for (int j = 0; j < t->N; j++)
			t->F[j*D + a] += hold;
	}
	for (int j = 0; j < t->N - 1; j++) {
		stretch(now, t, j, t->F + j*D);
		for (int c = 0; c < D; c++)
			y[j*D + c] = now[c];
	}
}

static enum hawser_status solve(struct hawser__ritz *ritz, const struct hawser_statics *statics,
                                enum hawser_plane plane, int N, int count,
                                struct hawser_report *report)
{
	struct chain t;
	struct hawser__operator A = {.apply = apply, .context = &t, .symmetric = 1};
	enum hawser_status status;

	if (chain_init(&t, statics, plane, N)) {
		A.size = t.D*(N - 1);
		status = hawser__krylov(ritz, &A, count, report);
	} else {
		status = hawser__no_memory(report, "modes");
	}
	chain_free(&t);
	return status;
}

/* Replace the forces of the springs by the strains a, b (c). */
static void strains(struct chain *t, const struct hawser_statics *st, double mu)
{
	for (int j = 0; j < t->N; j++) {
		double c, s, turning, *F = t->F + j*t->D, along = F[0]/mu, across = F[t->D - 1]/mu;

		direction(&c, &s, &turning, st, (j + 0.5)*t->h);
		F[0] = turning*along;
		if (t->D == 2) {
			F[0] = st->epsilon*(c*along + s*across);
			F[1] = turning*(c*across - s*along);
		}
	}
}

/* Displacements are known at the points, strains at the midpoints of the springs. */
static enum hawser_status sample(double *shape, double *slope, const struct hawser_grid *grid,
                                 const double *x, const struct hawser_statics *statics,
                                 enum hawser_plane plane, int N, struct hawser_report *report)
{
	int in_plane = plane == HAWSER_IN_PLANE, D = in_plane ? 2 : 1, first = in_plane ? 0 : 2;
	double *value = calloc(2*(size_t)D*((size_t)N + 1), sizeof *value), mu = 0.0, ignored;
	double *y, X[2];
	struct chain t = {0};

	if (!value || !chain_init(&t, statics, plane, N)) {
		free(value);
		chain_free(&t);
		return hawser__no_memory(report, "modes");
	}
	y = value + D*(N + 1);
	apply(y, x, &t);
	for (int i = 0; i < D*(N - 1); i++) {
		mu += x[i]*y[i];
		value[D + i] = x[i];
	}
	strains(&t, statics, mu);
	for (int i = 0; i < grid->points; i++, shape += 3, slope += 3) {
		double at = grid->s[i]*N/statics->l, c, s, turning;

		direction(&c, &s, &turning, statics, grid->s[i]);
		for (int k = 0; k < D; k++) {
			X[k] = hawser__six_points(&ignored, value + k, N, D, at);
			slope[first + k] = hawser__six_points(&ignored, t.F + k, N - 1, D, at - 0.5);
		}
		shape[first] = in_plane ? c*X[0] + s*X[1] : X[0];
		if (in_plane)
			shape[1] = c*X[1] - s*X[0];
	}
	free(value);
	chain_free(&t);
	return HAWSER_OK;
}

enum hawser_status hawser__chain_solve(struct hawser_modes *modes,
                                       const struct hawser_statics *statics,
                                       const struct hawser_modes_options *options,
                                       struct hawser_report *report)
{
	static const struct hawser__scheme scheme = {0, solve, sample};

	return hawser__halving_solve(modes, statics, options, &scheme, report);
}
