/* bench/modes.c - accuracy of the first ten natural frequencies against cost, and the effect of the
 * choice of unknowns. True errors are against shooting in quadruple precision. Verifies before it
 * times: status 1 if the default misses its tolerance or states less than its error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/clock.h"
#include "tests/modes-shooting.h"
#include "tests/modes-span.h"

enum { MODES = 10, DEGREE = 40, NODES = 80, UNKNOWNS = 2*(DEGREE - 1) };

/* Best time of a solution, over a tenth of a second. */
static double time_secs(const struct hawser_statics *st, const struct hawser_modes_options *options)
{
	double best = HUGE_VAL, start = clock_secs();

	while (clock_secs() - start < 0.1) {
		struct hawser_modes m;
		double before = clock_secs();

		if (hawser_modes_solve(&m, st, options, NULL))
			return NAN;
		best = fmin(best, clock_secs() - before);
		hawser_modes_clear(&m);
	}
	return best;
}

/* One line of the table; returns nonzero if the default missed its tolerance or its estimate. */
static int line(const struct hawser_statics *st, int basis)
{
	struct hawser_modes_options options = {.n = MODES, .basis = basis};
	struct hawser_modes m;
	struct hawser_report report;
	double worst = 0.0, stated = 0.0;
	int low = 0;

	if (hawser_modes_solve(&m, st, &options, &report)) {
		printf("%7d  %s\n", basis, report.message);
		return basis == 0;
	}
	for (int k = 0; k < MODES; k++) {
		double error;

		shoot_frequency(st, m.mode[k].plane, m.mode[k].omega, 40, &error);
		worst = fmax(worst, error);
		stated = fmax(stated, m.mode[k].residual);
		low |= error > m.mode[k].residual;
	}
	printf("%7d %9d %8d %12.1e %12.1e %9.3f\n", m.basis, m.grid.elements, m.grid.points, worst,
	       stated, 1e3*time_secs(st, &options));
	hawser_modes_clear(&m);
	return basis == 0 && (low || worst > 1e-9 || stated > 1e-10);
}

static int table(const char *name, double epsilon, double delta, double hs)
{
	struct hawser_statics st = scaled_span(epsilon, delta, hs);
	int bad = 0;

	printf("\n%s: epsilon %g, delta %g, hs %g\n", name, epsilon, delta, hs);
	printf("  basis  elements   points   true error       stated        ms\n");
	for (int basis = 8; basis <= (delta > 5.0 ? 128 : 32); basis = basis*(delta > 5.0 ? 2 : 1) +
	     (delta > 5.0 ? 0 : 4))
		bad |= line(&st, basis);
	printf("default:\n");
	return bad | line(&st, 0);
}

/* --- the usual formulation: displacements P, Q as unknowns, K and M assembled --- */

/* Integrals N_j of Legendre polynomials, zero at both ends, and their derivatives: [DEGREE-1]. */
static void bubbles(double *N, double *slope, double x)
{
	double P[DEGREE + 1] = {1.0, x};

	for (int j = 1; j < DEGREE; j++)
		P[j + 1] = ((2*j + 1)*x*P[j] - j*P[j - 1])/(j + 1);
	for (int j = 1; j < DEGREE; j++) {
		N[j - 1] = (P[j + 1] - P[j - 1])/(2*j + 1);
		slope[j - 1] = P[j];
	}
}

static void displacement_matrices(double *K, double *M, const struct hawser_statics *st,
                                  const struct hawser_grid *grid)
{
	for (int i = 0; i < grid->points; i++) {
		double N[DEGREE], D[DEGREE], row[4][UNKNOWNS] = {{0.0}}, w = grid->weight[i];
		double u = st->eta + st->delta*grid->s[i], T = hypot(1.0, u), kappa = st->delta/(T*T);

		bubbles(N, D, grid->node[i]);
		for (int j = 0, q = DEGREE - 1; j < DEGREE - 1; j++, q++) {
			row[0][j] = D[j]*2.0/st->l/sqrt(st->epsilon);
			row[0][q] = -kappa*N[j]/sqrt(st->epsilon);
			row[1][q] = D[j]*2.0/st->l*sqrt(T/(1.0 + st->epsilon*T));
			row[1][j] = kappa*N[j]*sqrt(T/(1.0 + st->epsilon*T));
			row[2][j] = row[3][q] = N[j];
		}
		for (int a = 0; a < UNKNOWNS; a++)
			for (int b = 0; b < UNKNOWNS; b++) {
				K[a*UNKNOWNS + b] += w*(row[0][a]*row[0][b] + row[1][a]*row[1][b]);
				M[a*UNKNOWNS + b] += w*(row[2][a]*row[2][b] + row[3][a]*row[3][b]);
			}
	}
}

/* Largest error of the in-plane frequencies of `right`; inverse: M x = mu K x instead. */
static double displacement_error(const struct hawser_modes *right, const struct hawser_grid *grid,
                                 int inverse)
{
	double *K = calloc(UNKNOWNS*UNKNOWNS, sizeof *K), *M = calloc(UNKNOWNS*UNKNOWNS, sizeof *M);
	double value[UNKNOWNS], worst = 0.0;
	int next = 0;

	if (!K || !M)
		exit(4);
	displacement_matrices(K, M, &right->statics, grid);
	if (LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'U', UNKNOWNS, inverse ? M : K, UNKNOWNS,
	                  inverse ? K : M, UNKNOWNS, value))
		worst = NAN;
	for (int k = 0; k < MODES && !isnan(worst); k++) {
		double omega;

		if (right->mode[k].plane != HAWSER_IN_PLANE)
			continue;
		omega = inverse ? 1.0/sqrt(value[UNKNOWNS - 1 - next]) : sqrt(value[next]);
		next++;
		worst = isnan(omega) ? NAN : fmax(worst, fabs(omega/right->mode[k].omega - 1.0));
	}
	free(K);
	free(M);
	return worst;
}

static void unknowns(void)
{
	printf("\nDisplacements as unknowns (%d functions a component), error of the in-plane ones "
	       "among the first ten; delta 0.8, hs 0.3\n", DEGREE - 1);
	printf("epsilon     K x = w2 M x    M x = mu K x             strains\n");
	for (double epsilon = 1e-2; epsilon > 1e-15; epsilon *= 1e-2) {
		struct hawser_statics st = scaled_span(epsilon, 0.8, 0.3);
		struct hawser_modes_options fine = {.n = MODES, .basis = NODES/2 - 1};
		struct hawser_modes m;
		double worst = 0.0;

		if (hawser_modes_solve(&m, &st, &fine, NULL))
			exit(1);
		for (int k = 0; k < MODES; k++) {
			double error;

			shoot_frequency(&st, m.mode[k].plane, m.mode[k].omega, 40, &error);
			worst = fmax(worst, error);
		}
		printf("%7.0e %16.1e %15.1e %19.1e\n", epsilon,
		       displacement_error(&m, &m.grid, 0), displacement_error(&m, &m.grid, 1), worst);
		hawser_modes_clear(&m);
	}
}

int main(void)
{
	int bad = 0;

	bad |= table("chairlift (B Table 4.2)", 80e3/400e6, 6*9.81*250/80e3, 0.04);
	bad |= table("nearly inextensible, steep", 1e-13, 0.5, 2.0);
	bad |= table("deep sag", 1e-11, 3.0, 0.3);
	bad |= table("very slack", 1e-11, 20.0, 0.0);
	unknowns();
	return bad;
}
