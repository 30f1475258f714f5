/* All modes of a basis: orthonormal shapes and diagonal energy up to the highest mode, the lowest
 * frequencies close to and above those of the converged method, and error estimates that hold.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/modes.h>

#include "tests/modes-span.h"
#include "tests/tap.h"

/* Mass of modes j and k, and stiffness over omega_j omega_k. */
static void products(double *mass, double *stiffness, const struct hawser_modes *modes, int j, int k)
{
	size_t points = (size_t)modes->grid.points;
	const double *x = modes->shape + 3*points*(size_t)j, *y = modes->shape + 3*points*(size_t)k;
	const double *f = modes->slope + 3*points*(size_t)j, *g = modes->slope + 3*points*(size_t)k;
	double m = 0.0, s = 0.0;

	for (size_t p = 0; p < points; p++, x += 3, y += 3, f += 3, g += 3) {
		double strain = hawser_statics_frame(&modes->statics, modes->grid.s[p]).strain;
		double turn = strain/(1.0 + strain), w = modes->grid.weight[p];

		m += w*(x[0]*y[0] + x[1]*y[1] + x[2]*y[2]);
		s += w*(f[0]*g[0] + turn*(f[1]*g[1] + f[2]*g[2]));
	}
	*mass = m;
	*stiffness = s/modes->statics.epsilon/modes->mode[j].omega/modes->mode[k].omega;
}

/* Displacement of end B: the integral of the gradients, relative to the integral of their moduli. */
static double end_of(const struct hawser_modes *modes, int k)
{
	size_t points = (size_t)modes->grid.points;
	const double *f = modes->slope + 3*points*(size_t)k;
	double sum[3] = {0.0}, size = 0.0;

	for (size_t p = 0; p < points; p++, f += 3) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, modes->grid.s[p]);
		double w = modes->grid.weight[p];

		sum[0] += w*(f[0]*at.ex - f[1]*at.ey);
		sum[1] += w*(f[0]*at.ey + f[1]*at.ex);
		sum[2] += w*f[2];
		size += w*sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2]);
	}
	return (fabs(sum[0]) + fabs(sum[1]) + fabs(sum[2]))/size;
}

static void check_span(double epsilon, double delta, double hs, int functions, const char *name)
{
	struct hawser_statics st = span_of(epsilon, delta, hs);
	struct hawser_modes_options options = {.n = 16, .tolerance = 1e-11};
	struct hawser_modes modes, fine;
	struct hawser_report report = {0};
	double mass = 0.0, stiffness = 0.0, end = 0.0, below = 0.0, honest = 0.0;
	int ascending = 1;

	if (!ok(!hawser_modes_basis(&modes, &st, functions, functions, &report) &&
	        !hawser_modes_solve(&fine, &st, &options, &report), "%s: %s", name, report.message))
		return;
	for (int k = 0; k < modes.n; k++) {
		end = fmax(end, end_of(&modes, k));
		ascending = ascending && (k == 0 || modes.mode[k].omega >= modes.mode[k - 1].omega);
		for (int j = 0; j <= k; j++) {
			double m, s;

			products(&m, &s, &modes, j, k);
			mass = fmax(mass, fabs(m - (j == k)));
			stiffness = fmax(stiffness, fabs(s - (j == k)));
		}
	}
	ok(modes.n == 3*modes.basis && modes.basis <= functions &&
	   modes.basis > functions - modes.grid.elements,
	   "%s: %d modes of %d functions", name, modes.n, functions);
	/* stretch moves the end sqrt(epsilon) times as far as rotation: a round-off error of a
	 * rotational strain in the stretching modes is 2e-10 of `size`, and must be removed */
	ok(ascending && end < 1e-14,
	   "%s: ascending, fixed at the ends (%.1e)", name, end);
	ok(mass < 1e-13, "%s: orthonormal, %.1e", name, mass);
	ok(stiffness < 1e-13, "%s: diagonal energy, %.1e", name, stiffness);
	for (int k = 0; k < fine.n; k++) {
		double error = modes.mode[k].omega/fine.mode[k].omega - 1.0;

		below = fmin(below, error);
		honest = fmax(honest, fabs(error)/modes.mode[k].residual);
	}
	ok(below > -1e-12, "%s: no frequency below the converged one (%.1e)", name, below);
	ok(honest <= 1.0, "%s: errors are within the estimates (%.2f of them)", name, honest);
	hawser_modes_clear(&modes);
	hawser_modes_clear(&fine);
}

static void check_planes(void)
{
	struct hawser_statics st = span_of(2.385e-4, 0.31, 0.07);
	struct hawser_modes both, plane, across;
	int in = 0, next = 0, same = 1;

	if (!ok(!hawser_modes_basis(&both, &st, 9, 9, NULL) &&
	        !hawser_modes_basis(&plane, &st, 9, 0, NULL) &&
	        !hawser_modes_basis(&across, &st, 0, 9, NULL), "one plane alone"))
		return;
	for (int k = 0; k < both.n; k++)
		if (both.mode[k].plane == HAWSER_IN_PLANE)
			same = same && both.mode[k].omega == plane.mode[in++].omega;
		else
			same = same && both.mode[k].omega == across.mode[next++].omega;
	ok(same && in == plane.n && next == across.n && in == 18 && next == 9,
	   "the planes are independent: %d and %d", in, next);
	hawser_modes_clear(&both);
	hawser_modes_clear(&plane);
	same = !hawser_modes_basis(&both, &st, 12, 4, NULL);
	ok(same && both.n == 28, "planes of unlike size: %d", both.n);
	hawser_modes_clear(&both);
	hawser_modes_clear(&across);
}

static void check_status(enum hawser_status want, const struct hawser_statics *st, int in, int out,
                         const char *word)
{
	struct hawser_report report = {0};
	struct hawser_modes modes;
	enum hawser_status status = hawser_modes_basis(&modes, st, in, out, &report);

	ok(status == want && strstr(report.message, word) && !modes.mode, "status %d: %s", status,
	   report.message);
	hawser_modes_clear(&modes);
}

static void check_statuses(void)
{
	struct hawser_statics st = span_of(1e-3, 0.4, 0.1), bad = st;

	check_status(HAWSER_ERR_ARGUMENT, &st, 0, 0, "functions");
	check_status(HAWSER_ERR_ARGUMENT, &st, -1, 3, "functions");
	check_status(HAWSER_ERR_ARGUMENT, &st, 2, 401, "functions");
	bad.epsilon = 0.0;
	check_status(HAWSER_ERR_NO_SOLUTION, &bad, 4, 4, "inextensible");
	bad = st;
	bad.delta = NAN;
	check_status(HAWSER_ERR_NAN, &bad, 4, 4, "delta");
	bad = st;
	bad.l = -1.0;
	check_status(HAWSER_ERR_ARGUMENT, &bad, 4, 4, "l = L/d");
}

CASE(property_modes_basis)
{
	check_span(3.1e-2, 0.93, 0.27, 12, "soft inclined");
	check_span(2.0e-4, 0.18, 0.04, 20, "chairlift");
	check_span(3.1e-3, 4.7, -0.6, 33, "deep sag");
	check_span(1e-3, 11.0, 0.3, 40, "very slack");
	check_span(1e-7, 0.5, 0.0, 30, "stiff");
	check_span(1e-12, 0.53, 0.11, 50, "nearly inextensible");
	check_planes();
	check_statuses();
	return done_testing();
}
