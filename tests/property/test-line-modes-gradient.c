/* Modes of a rope over sheaves against differences of an exact gradient, by another discretisation
 * that shares no code with the library's: positions of the rope by polynomials through equidistant
 * nodes, on a circle its angle, and the full nonlinear energy
 *
 *   integral of EA/2 (|x'| - 1)^2 + rho g y, and m g y of masses, those of hangers on rigid rods,
 *
 * whose exact gradient is differentiated numerically. Constraints are not linearised: a point on a
 * circle is c + R n(angle). The curvature of the circle is in the second derivative of the energy, not
 * in a term of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/line_modes.h>

#include "tests/line-mesh.h"
#include "tests/tap.h"

/* --- eigenvalues in long double, which LAPACK has not: the high modes are 1e12 times those looked for
 * --- */

/* Cholesky factor of K [n][n] in its lower triangle; 0 if K is not positive definite. */
static int factor(long double *K, int n)
{
	for (int j = 0; j < n; j++)
		for (int i = j; i < n; i++) {
			long double sum = K[i*n + j];

			for (int k = 0; k < j; k++)
				sum -= K[i*n + k]*K[j*n + k];
			if (i == j && !(sum > 0.0L))
				return 0;
			K[i*n + j] = i == j ? sqrtl(sum) : sum/K[j*n + j];
		}
	return 1;
}

/* y = K^-1 M x with the factor. */
static void respond(long double *y, const long double *K, const double *M, const long double *x, int n)
{
	for (int i = 0; i < n; i++) {
		y[i] = 0.0L;
		for (int j = 0; j < n; j++)
			y[i] += M[i*n + j]*x[j];
	}
	for (int i = 0; i < n; i++) {
		for (int k = 0; k < i; k++)
			y[i] -= K[i*n + k]*y[k];
		y[i] /= K[i*n + i];
	}
	for (int i = n - 1; i >= 0; i--) {
		for (int k = i + 1; k < n; k++)
			y[i] -= K[k*n + i]*y[k];
		y[i] /= K[i*n + i];
	}
}

static long double product(const double *M, const long double *x, const long double *y, int n)
{
	long double sum = 0.0L;

	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++)
			sum += x[i]*M[i*n + j]*y[j];
	return sum;
}

/* omega of a mode, from LAPACK's vector. */
static double polish(const double *vector, const long double *K, const double *M, int n)
{
	static long double x[UNKNOWNS], y[UNKNOWNS];
	long double omega2 = 0.0L;

	for (int i = 0; i < n; i++)
		x[i] = vector[i];
	for (int step_number = 0; step_number < 2; step_number++) {
		respond(y, K, M, x, n);
		respond(x, K, M, y, n);
		omega2 = product(M, x, y, n)/product(M, x, x, n); /* x K x = x M y */
	}
	return (double)sqrtl(omega2);
}

static void compare(const struct hawser_line *line, double carriage, const char *what)
{
	static struct mesh t;
	static number q[UNKNOWNS], g[UNKNOWNS];
	const struct hawser_line_freedom freedom = {.name = "carriage", .mass = carriage,
	                                            .end = {{{1.0, 0.0, 0.0}, {0.0}}}};
	const struct hawser_line_modes_options o = {.n = 8, .freedom = &freedom,
	                                            .freedoms = carriage > 0.0};
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_line_modes modes;
	struct hawser_report report = {0};
	double *copy, *M, *vector, mu[UNKNOWNS], worst = 0.0, asymmetry = 0.0, largest = 0.0, balance = 0.0;
	long double *K;
	size_t n;

	if (hawser_line_solve(&st, line, &report) ||
	    hawser_line_modes_solve(&modes, lane, 1, &o, &report)) {
		ok(0, "%s: %s", what, report.message);
		return;
	}
	t = (struct mesh){.line = line, .st = &st};
	place(&t, carriage);
	reference(&t);
	n = (size_t)t.unknowns;
	K = calloc(n*n, sizeof *K);
	copy = calloc(n*n, sizeof *copy);
	M = calloc(n*n, sizeof *M);
	vector = calloc(n*n, sizeof *vector);
	if (!ok(K && copy && M && vector && t.unknowns <= UNKNOWNS, "%s: %d unknowns", what, t.unknowns))
		return;
	memset(q, 0, sizeof q);
	gradient_of(g, &t, q, -1);
	for (int i = 0; i < t.unknowns; i++)
		if (i != t.carriage) /* which a counterweight holds */
			balance = fmax(balance, fabs((double)creall(g[i])));
	differences(K, &t, q);
	inertia(M, &t, q);
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < n; j++) {
			largest = fmax(largest, fabs((double)K[i*n + j]));
			asymmetry = fmax(asymmetry, fabs((double)(K[i*n + j] - K[j*n + i])));
			copy[i*n + j] = (double)K[i*n + j];
			vector[i*n + j] = M[i*n + j];
		}
	/* positions have 6e-14 m of round-off, which EA over the distance of nodes makes 1e-3 N and more */
	ok(balance <= 1e-2 && asymmetry <= 1e-11*largest,
	   "%s: an equilibrium to %.1e N, differences symmetric to %.1e", what, balance, asymmetry/largest);
	if (ok(LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', (int)n, vector, (int)n, copy, (int)n,
	                      mu) == 0 &&
	       factor(K, (int)n), "%s: the differences are positive definite", what)) {
		for (int k = 0; k < 8; k++) {
			double omega = polish(vector + (n - 1 - (size_t)k)*n, K, M, (int)n);
			double own = modes.mode[k].omega/modes.time_unit;

			printf("# %d %.12g %.12g %s\n", k + 1, own, omega, hawser_plane_name(modes.mode[k].plane));
			worst = fmax(worst, fabs(own/omega - 1.0));
		}
		ok(worst <= 1e-9, "%s: eight modes to %.1e", what, worst);
	}
	free(copy);
	free(vector);
	free(K);
	free(M);
	hawser_line_modes_clear(&modes);
	hawser_line_statics_clear(&st);
}

CASE(property_line_modes_gradient)
{
	struct hawser_line_sheave sheave[3] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
	                                       {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
	struct hawser_line_mass mass[9];
	struct hawser_line line = {.EA = 40e6, .rho = 4.0, .g = 9.81, .B = {300.0, 58.0},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 2,
	                           .mass = mass};

	compare(&line, 0.0, "two towers");
	for (int i = 0; i < 9; i++)
		mass[i] = (struct hawser_line_mass){.S = 18.3 + 36.6*i, .mass = 400.0};
	line.masses = 9;
	compare(&line, 20e3, "carriers and carriage");
	for (int i = 0; i < 9; i++)
		mass[i] = (struct hawser_line_mass){.S = 8.03 + 36.6*i, .mass = 400.0, .hanger = 4.0};
	compare(&line, 0.0, "carriers on hangers, one of them on a tower");
	/* the lowest part of the line of B Table 6.2: a carrier hangs between two arcs of the first
	 * sheave */
	sheave[0] = (struct hawser_line_sheave){.centre = {40.0, 12.0}, .radius = 12.0, .side = -1};
	sheave[1] = (struct hawser_line_sheave){.centre = {79.71, 4.86}, .radius = 12.0, .side = 1};
	line.A[0] = 25.0;
	line.B[0] = 146.56;
	line.B[1] = 41.03;
	for (int i = 0; i < 9; i++)
		mass[i] = (struct hawser_line_mass){.S = 20.0 + 36.6*i, .mass = 400.0};
	compare(&line, 0.0, "a carrier under a compression battery");
	return done_testing();
}
