/* The tensors of the reduced model at the limits of the parameters of a span: nearly inextensible to
 * nearly slack, taut to deep, level to steep, 1 to 60 modes.
 *
 * Along u = t r the strain energy of the modes is a power series in t whose coefficients are integrals
 * of sums and products. Here they are computed in __float128 on a grid three times finer, from the
 * slopes of the modes. The derivative along another direction must equal that of K, Q and C. The
 * tolerance is the round-off of the slopes, 1e-16, as it enters an elongation (a difference of slopes),
 * relative to the elongations of order sqrt(epsilon) in the energy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/rom.h>

#include "tests/extremes/sweep.h"
#include "tests/modes-span.h"

typedef __float128 quad;

enum { EPSILON, DELTA, SLOPE, MODES, AXES, ORDERS = 4, MOST = 60, CUTS = 3, DIRECTIONS = 3 };

static const double epsilons[] = {1e-14, 1e-10, 1e-6, 1e-3, 0.03, 0.5};
static const double deltas[] = {1e-9, 1e-4, 0.1, 1.0, 5.0, 20.0};
static const double slopes[] = {-5.0, 0.0, 1e-9, 0.5, 30.0};
static const double modes_few[] = {1, 4, 9};
static const double modes_many[] = {1, 2, 4, 9, 16, 30, 60};

#define VALUES(a) (a), (int)(sizeof(a)/sizeof *(a))
static struct sweep_axis axis[AXES] = {
	{"epsilon", 1e-3, VALUES(epsilons), 2},
	{"delta", 0.1, VALUES(deltas), 2},
	{"slope", 0.27, VALUES(slopes), 1},
	{"modes", 4, VALUES(modes_few), 0},
};

static double uniform(unsigned *seed)
{
	*seed = *seed*1664525u + 1013904223u;
	return *seed/2147483648.0 - 1.0;
}

/* Slopes of the directions a = sum r_j Phi_j', b = sum q_j Phi_j' at s. */
static void directions(const struct hawser_modes *modes, quad a[3], quad b[3], const double *r,
                       const double *q, double s)
{
	for (int i = 0; i < 3; i++)
		a[i] = b[i] = 0;
	for (int j = 0; j < modes->n; j++) {
		double shape[3], slope[3];

		hawser_modes_at(modes, shape, slope, j, s);
		for (int i = 0; i < 3; i++) {
			a[i] += (quad)r[j]*slope[i];
			b[i] += (quad)q[j]*slope[i];
		}
	}
}

/* sum[k] += weight/epsilon times the coefficient of t^k in (1 - 1/|d|) d.b, d = (g, 0, 0) + t a, g
 * = 1 + strain. */
static void add_point(quad sum[ORDERS], const quad a[3], const quad b[3], double strain, quad weight)
{
	quad g = 1 + (quad)strain, linear = 2*a[0]/g, square = (a[0]*a[0] + a[1]*a[1] + a[2]*a[2])/(g*g);
	quad inverse[ORDERS] = {1}, along[2] = {g*b[0], a[0]*b[0] + a[1]*b[1] + a[2]*b[2]};

	/* y = S^(-1/2) with S = 1 + linear t + square t^2: S y' = -S' y/2 */
	for (int k = 0; k + 1 < ORDERS; k++) {
		quad rest = -(linear*inverse[k])/2 - linear*k*inverse[k];

		if (k)
			rest -= square*inverse[k - 1] + square*(k - 1)*inverse[k - 1];
		inverse[k + 1] = rest/(k + 1);
	}
	for (int k = 0; k < ORDERS; k++) {
		quad part = k ? -inverse[k]/g : strain/g;
		quad before = k > 1 ? -inverse[k - 1]/g : strain/g;

		sum[k] += weight*(part*along[0] + (k ? before*along[1] : 0));
	}
}

static void series(const struct hawser_modes *modes, quad sum[ORDERS], const double *r,
                   const double *q)
{
	const struct hawser_grid *grid = &modes->grid;

	for (int piece = 0; piece < grid->elements*CUTS; piece++)
		for (int i = 0; i < grid->order; i++) {
			int e = piece/CUTS;
			double width = (grid->edge[e + 1] - grid->edge[e])/CUTS;
			double s = grid->edge[e] + width*(piece%CUTS + 0.5*(1.0 + grid->node[i]));
			double strain = hawser_statics_frame(&modes->statics, s).strain;
			quad a[3], b[3];

			directions(modes, a, b, r, q, s);
			add_point(sum, a, b, strain, (quad)grid->weight[e*grid->order + i]/CUTS/
			                             modes->statics.epsilon);
		}
}

/* The largest difference between the three orders and those of the model, relative to the sum of the
 * absolute values of the terms. */
static double compare(const struct hawser_rom *rom, const struct hawser_modes *modes, unsigned seed)
{
	double r[MOST], q[MOST], worst = 0.0, want[ORDERS] = {0.0}, size[ORDERS] = {0.0};
	quad sum[ORDERS] = {0};

	for (int j = 0; j < rom->n; j++) {
		r[j] = uniform(&seed)/rom->K[j*(rom->n + 1)];
		q[j] = uniform(&seed)/rom->K[j*(rom->n + 1)];
		want[1] += q[j]*rom->K[j*(rom->n + 1)]*r[j];
		size[1] += fabs(q[j]*rom->K[j*(rom->n + 1)]*r[j]);
	}
	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *e = &rom->Q[i];
		double part = q[e->j]*e->value*r[e->k]*r[e->l];

		want[2] += part;
		size[2] += fabs(part);
	}
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *e = &rom->C[i];
		double part = q[e->j]*e->value*r[e->k]*r[e->l]*r[e->m];

		want[3] += part;
		size[3] += fabs(part);
	}
	series(modes, sum, r, q);
	for (int k = 1; k < ORDERS; k++)
		if (size[k] > 0.0)
			worst = fmax(worst, fabs((double)(sum[k] - (quad)want[k]))/size[k]);
	return worst;
}

static void solve(struct sweep_point *point, const double *x, void *context)
{
	struct hawser_statics statics = span_of(x[EPSILON], x[DELTA], x[SLOPE]);
	struct hawser_modes_options options = {.n = (int)x[MODES]};
	struct hawser_modes modes;
	struct hawser_rom rom;

	(void)context;
	point->status = hawser_modes_solve(&modes, &statics, &options, &point->report);
	if (point->status)
		return;
	point->status = hawser_rom_build(&rom, &modes, NULL, &point->report);
	for (unsigned trial = 0; !point->status && trial < DIRECTIONS; trial++)
		point->error = fmax(point->error, compare(&rom, &modes, 2385 + trial));
	if (!point->status)
		point->error = fmax(point->error, hawser_rom_asymmetry(&rom));
	point->stated = (1.0 + x[DELTA])*(1e-14 + 1e-15/sqrt(x[EPSILON]));
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

CASE(extremes_sweep_rom)
{
	struct sweep_tally tally;

	if (sweep_long()) {
		axis[MODES].value = modes_many;
		axis[MODES].count = sizeof modes_many/sizeof *modes_many;
	}
	tally = sweep_pairs("rom", axis, AXES, solve, NULL);
	ok(tally.right > tally.points/2, "more than half of the points are right: %d of %d", tally.right,
	   tally.points);
	return done_testing();
}
