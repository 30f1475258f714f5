/* tests/unit/test-modes-grid.c - the composite Gauss-Legendre grid.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "modes/grid.h"
#include "tests/tap.h"

static double integral(const struct hawser_grid *grid, double power)
{
	double sum = 0.0;

	for (int i = 0; i < grid->points; i++)
		sum += grid->weight[i]*pow(grid->s[i], power);
	return sum;
}

/* Order n is exact to degree 2n-1, and not for 2n. */
static void exactness(void)
{
	const double edge[] = {0.0, 2.385};
	struct hawser_grid grid;

	for (int n = 1; n <= 41; n += 4) {
		if (hawser__grid_init(&grid, 1, n, edge, NULL, NULL)) {
			ok(0, "grid of order %d", n);
			return;
		}
		close_to(integral(&grid, 2*n - 1), pow(2.385, 2*n)/(2*n), 2e-14, "degree 2n-1");
		if (n < 9)
			ok(fabs(integral(&grid, 2*n)*(2*n + 1)/pow(2.385, 2*n + 1) - 1.0) > 1e-7,
			   "order %d is not exact for degree 2n", n);
		hawser__grid_clear(&grid);
	}
}

/* Running integrals and interpolation of an analytic function on uneven elements. */
static void running(void)
{
	const double edge[] = {0.0, 0.3, 1.1, 2.385};
	struct hawser_grid grid;
	struct hawser__reference reference;
	double f[60], F[60], worst = 0.0, end, far = 0.0;

	if (hawser__grid_init(&grid, 3, 20, edge, NULL, NULL) ||
	    hawser__reference_init(&reference, &grid, 5, NULL)) {
		ok(0, "tables");
		return;
	}
	for (int i = 0; i < 60; i++)
		f[i] = exp(-grid.s[i])*cos(3.0*grid.s[i]);
	end = hawser__grid_running(F, &grid, &reference, f);
	for (int i = 0; i < 60; i++) {
		double s = grid.s[i];

		worst = fmax(worst, fabs(F[i] - (exp(-s)*(3.0*sin(3.0*s) - cos(3.0*s)) + 1.0)/10.0));
	}
	ok(worst < 1e-15, "running integral is exact to %.1e", worst);
	close_to(end, (exp(-2.385)*(3.0*sin(3.0*2.385) - cos(3.0*2.385)) + 1.0)/10.0, 1e-15,
	         "whole integral");
	for (double s = 0.0; s <= 2.385; s += 0.0371) {
		double value;

		hawser__grid_at(&value, &grid, f, 1, 1, s);
		far = fmax(far, fabs(value - exp(-s)*cos(3.0*s)));
	}
	ok(far < 1e-14, "interpolation between nodes and at both ends, to %.1e", far);
	hawser__grid_at(&end, &grid, f, 1, 1, grid.s[33]);
	ok(fabs(end - f[33]) < 1e-15, "a node gives its own value");
	hawser__reference_clear(&reference);
	hawser__grid_clear(&grid);
	hawser__grid_clear(&grid);
	ok(grid.points == 0, "clearing twice is legal");
}

CASE(unit_modes_grid)
{
	exactness();
	running();
	return done_testing();
}
