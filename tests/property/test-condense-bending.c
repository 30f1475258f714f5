/* Condensation with bending stiffness against sums over all modes of a basis: the cubic terms, the
 * second-order displacement, the stiffness that a load varies and the response to it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include <hawser/rom.h>

#include "tests/modes-span.h"
#include "tests/modes-third.h"
#include "tests/tap.h"

#define KEPT 4

static int modes_of(struct hawser_modes *modes, const struct hawser_statics *st, int n)
{
	struct hawser_modes_options options = {.n = n, .tolerance = 1e-10};

	return !hawser_modes_solve(modes, st, &options, NULL);
}

static double cubic_of(const struct hawser_rom *rom, const struct hawser_cubic *like)
{
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		if (c->j == like->j && c->k == like->k && c->l == like->l && c->m == like->m)
			return c->value;
	}
	return 0.0;
}

/* Effect of the modes KEPT..upto on the entry: the sum over the three pairings of its four
 * indices. */
static double given_back(const double *T, const struct hawser_modes *modes, int upto,
                         const struct hawser_cubic *c)
{
	const int x[3][4] = {{c->j, c->k, c->l, c->m}, {c->j, c->l, c->k, c->m},
		{c->j, c->m, c->k, c->l}};
	double sum = 0.0;

	for (int w = 0; w < 3; w++)
		for (int s = KEPT; s < upto; s++)
			sum += T[(x[w][0]*KEPT + x[w][1])*modes->n + s]*
			       T[(x[w][2]*KEPT + x[w][3])*modes->n + s]/
			       pow(modes->mode[s].omega, 2);
	return sum/(c->k == c->m ? 6 : c->k == c->l || c->l == c->m ? 2 : 1);
}

static double *all_thirds(const struct hawser_modes *modes)
{
	double *T = malloc((size_t)KEPT*KEPT*modes->n*sizeof *T);

	for (int j = 0; T && j < KEPT; j++)
		for (int k = 0; k < KEPT; k++)
			for (int s = 0; s < modes->n; s++)
				T[(j*KEPT + k)*modes->n + s] = third(modes, j, k, s);
	return T;
}

/* Largest difference between condensed C and raw C minus the sum over modes, relative to the
 * largest entry. */
static double rest(const struct hawser_rom *condensed, const struct hawser_rom *raw, const double *T,
                   const struct hawser_modes *many, int upto)
{
	double worst = 0.0, largest = 0.0;

	for (int i = 0; i < raw->cubics; i++) {
		const struct hawser_cubic *c = &raw->C[i];
		double value = cubic_of(condensed, c);

		largest = fmax(largest, fabs(value));
		worst = fmax(worst, fabs(value - c->value + given_back(T, many, upto, c)));
	}
	return worst/largest;
}

/* The second-order displacement at mid-span as a sum over the same modes. */
static double rest_of_shape(const struct hawser_rom *condensed, const double *T,
                            const struct hawser_modes *many)
{
	double worst = 0.0, largest = 0.0;

	for (int k = 0; k < KEPT; k++)
		for (int j = 0; j <= k; j++) {
			const double *w = condensed->shapes.second_shape +
			                  3*((size_t)(k*(k + 1)/2 + j)*condensed->shapes.points + 1);
			double sum[3] = {0.0}, shape[3];

			for (int s = KEPT; s < many->n; s++) {
				hawser_modes_at(many, shape, NULL, s, 0.5*many->statics.l);
				for (int c = 0; c < 3; c++)
					sum[c] -= T[(j*KEPT + k)*many->n + s]*shape[c]/
					          pow(many->mode[s].omega, 2);
			}
			for (int c = 0; c < 3; c++) {
				worst = fmax(worst, fabs(w[c] - sum[c]));
				largest = fmax(largest, fabs(w[c]));
			}
		}
	return worst/largest;
}

/* xi = L sqrt(T/EI) at mid-span. */
static struct hawser_statics stiff_span(double epsilon, double delta, double hs, double xi, double A,
                                        double B)
{
	struct hawser_statics st = span_of(epsilon, delta, hs);
	double L = st.l*st.span.d;

	st.bending.EI = st.H*L*L/(xi*xi);
	st.bending.rotation[0] = A*st.bending.EI/L;
	st.bending.rotation[1] = B*st.bending.EI/L;
	return st;
}

static void check_span(double epsilon, double delta, double hs, double xi, double A, double B,
                       double tolerance)
{
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC,
	                                       .inertia = HAWSER_INERTIA_NONE}};
	struct hawser_statics st = stiff_span(epsilon, delta, hs, xi, A, B);
	struct hawser_report report = {.message = ""};
	struct hawser_modes few, many;
	struct hawser_rom condensed, raw;
	double *T, left, half;

	if (!ok(modes_of(&few, &st, KEPT) && !hawser_modes_basis(&many, &st, 70, 70, &report) &&
	        !hawser_rom_build(&condensed, &few, &scene, &report) &&
	        !hawser_rom_build(&raw, &few, NULL, &report),
	        "epsilon %g, delta %g, hs %g, xi %g: models %s", epsilon, delta, hs, xi, report.message))
		return;
	T = all_thirds(&many);
	left = rest(&condensed, &raw, T, &many, many.n);
	half = rest(&condensed, &raw, T, &many, many.n/3);
	ok(left < tolerance && left < half, "condensed C against %d modes: %.1e, a third of them %.1e",
	   many.n, left, half);
	left = rest_of_shape(&condensed, T, &many);
	ok(left < 10.0*tolerance, "second-order displacement: %.1e", left);
	left = hawser_rom_asymmetry(&condensed);
	ok(left < 1e-13, "still a potential: %.1e", left);
	free(T);
	hawser_rom_clear(&condensed);
	hawser_rom_clear(&raw);
	hawser_modes_clear(&few);
	hawser_modes_clear(&many);
}

int main(void)
{
	check_span(0.05, 0.2, 0.0, 31.0, INFINITY, INFINITY, 1e-10);
	check_span(0.05, 0.2, 0.3, 5.3, INFINITY, 0.0, 1e-10);
	check_span(0.2, 1.5, 0.4, 17.0, 2.3, INFINITY, 1e-9);
	check_span(1e-3, 0.3, -0.7, 171.0, INFINITY, INFINITY, 1e-9);
	check_span(1e-3, 0.05, 0.4, 913.0, INFINITY, 7.1, 1e-9);
	return done_testing();
}
