/* test-rom-bending.c - reduced models of cables with bending stiffness against the energy of the
 * strains,
 * integrated here: frequencies, and forces by finite differences.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/rom.h>
#include <stdlib.h>

#include "tests/tap.h"

/* phi' of mode k at every point, by differences of its interpolated slope: independent of the
 * library's
 * derivative. */
static double turning(const struct hawser_modes *modes, int k, double s)
{
	/* one-sided within an element would be needed at its edges; the Gauss nodes are inside */
	double step = 1e-6, value[4], at[4] = {-2.0, -1.0, 1.0, 2.0};

	for (int i = 0; i < 4; i++) {
		double shape[3], slope[3], x = s + at[i]*step;

		hawser_modes_at(modes, shape, slope, k, x);
		value[i] = (modes->mode[k].plane == HAWSER_IN_PLANE ? slope[1] : slope[2])/
		           (1.0 + hawser_statics_frame(&modes->statics, x).strain);
	}
	return (value[0] - 8.0*value[1] + 8.0*value[2] - value[3])/(12.0*step);
}

/* Energy of coordinates u beyond the static one: exact stretching, less its linear part, and
 * bending. */
static double energy(const struct hawser_modes *modes, const double *bend, const double *u)
{
	const struct hawser_statics *st = &modes->statics;
	int points = modes->grid.points;
	double beta = st->bending.EI/(st->H*st->span.d*st->span.d), sum = 0.0;

	for (int p = 0; p < points; p++) {
		double strain = hawser_statics_frame(st, modes->grid.s[p]).strain, q[3] = {0.0}, turn[2] =
			{0.0};
		double stretch;

		for (int j = 0; j < modes->n; j++) {
			for (int c = 0; c < 3; c++)
				q[c] += u[j]*modes->slope[((size_t)j*(size_t)points + (size_t)p)*3 + (size_t)c];
			turn[modes->mode[j].plane] += u[j]*bend[j*points + p];
		}
		/* |q'| - 1 without cancellation, and less the linear term, strain a/eps */
		stretch = hypot(1.0 + strain + q[0], hypot(q[1], q[2])) - 1.0;
		sum += modes->grid.weight[p]*(((stretch*stretch - strain*strain)*0.5 -
		                               strain*q[0])/st->epsilon +
		                              0.5*beta*(turn[0]*turn[0] + turn[1]*turn[1]));
	}
	for (int end = 0; end < 2; end++)
		for (int f = 1; f < 3 && isfinite(st->bending.rotation[end]); f++) {
			double phi = 0.0, s = end ? st->l : 0.0, shape[3], slope[3];

			for (int j = 0; j < modes->n; j++) {
				hawser_modes_at(modes, shape, slope, j, s);
				phi += u[j]*slope[f];
			}
			phi /= 1.0 + hawser_statics_frame(st, s).strain;
			sum += 0.5*st->bending.rotation[end]/(st->H*st->span.d)*phi*phi;
		}
	return sum;
}

static void check(double h, double weight, double EI, double A, double B)
{
	const struct hawser_span span = {.EA = 3e7, .rho = 61.7, .g = weight/61.7, .d = 137.0, .h = h};
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_NONE}};
	struct hawser_report report;
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom rom;
	enum { N = 6 };
	double u[N], force[N], *bend, worst = 0.0, size = 0.0;

	if (hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, 9e5, HAWSER_BRANCH_TAUT, &report)) {
		ok(0, "%s", report.message);
		return;
	}
	st.bending = (struct hawser_bending){EI, {A, B}};
	if (hawser_modes_solve(&modes, &st, &(struct hawser_modes_options){.n = N}, &report) ||
	    hawser_rom_build(&rom, &modes, &scene, &report)) {
		ok(0, "%s", report.message);
		return;
	}
	bend = malloc((size_t)(N*modes.grid.points)*sizeof *bend);
	for (int k = 0; k < N; k++)
		for (int p = 0; p < modes.grid.points; p++)
			bend[k*modes.grid.points + p] = turning(&modes, k, modes.grid.s[p]);
	/* the quadratic energy of each pair of modes, exactly */
	for (int j = 0; j < N; j++)
		for (int k = 0; k <= j; k++) {
			double a[N] = {0.0}, b[N] = {0.0}, e = 1e-4, mixed, want = j == k ? 1.0 : 0.0, scale;

			a[j] += e;
			a[k] += e;
			b[j] += e;
			b[k] -= e;
			mixed = energy(&modes, bend, a) - energy(&modes, bend, b);
			for (int i = 0; i < N; i++) {
				a[i] = -a[i];
				b[i] = -b[i];
			}
			mixed += energy(&modes, bend, a) - energy(&modes, bend, b);
			/* odd terms cancel; j = k has the energy of twice e */
			scale = modes.mode[j].omega*modes.mode[k].omega;
			mixed /= 4.0*e*e*scale;
			worst = fmax(worst, fabs(mixed - want));
		}
	ok(worst < 1e-4, "h %g, EI %g: energy of pairs is diagonal with omega^2, to %.1e", h, EI, worst);
	for (int k = 0; k < N; k++)
		u[k] = 3e-4*(k%2 ? -1.3 : 1.7)/(1 + k);
	hawser_rom_restoring(&rom, force, u);
	worst = 0.0;
	for (int k = 0; k < N; k++) {
		double v[N], e = 2e-5, up, down, far_up, far_down, slope;

		memcpy(v, u, sizeof v);
		v[k] = u[k] + e;
		up = energy(&modes, bend, v);
		v[k] = u[k] - e;
		down = energy(&modes, bend, v);
		v[k] = u[k] + 2*e;
		far_up = energy(&modes, bend, v);
		v[k] = u[k] - 2*e;
		far_down = energy(&modes, bend, v);
		slope = (8.0*(up - down) - far_up + far_down)/(12.0*e);
		worst = fmax(worst, fabs(slope - force[k]));
		size = fmax(size, fabs(slope - modes.mode[k].omega*modes.mode[k].omega*u[k]));
	}
	ok(worst < 2e-3*size && size > 0.0,
	   "h %g, EI %g: forces are the gradient of the energy to %.1e, of nonlinear ones of %.1e", h, EI,
	   worst, size);
	free(bend);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

CASE(property_rom_bending)
{
	check(61.7, 605.0, 2.385e7, INFINITY, INFINITY);
	check(-23.0, 1605.0, 2.385e8, INFINITY, 0.0);
	check(0.0, 905.0, 6.1e7, 4e6, INFINITY);
	return done_testing();
}
