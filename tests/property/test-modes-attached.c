/* Modes of a cable with attachments: strings with a mass or a spring by their frequency equations, a
 * chain of masses and links with second order removed, orthogonality, limits, refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>

#include <hawser/modes.h>

#include "tests/link-chain.h"
#include "tests/tap.h"

static struct hawser_report report;

static int solve(struct hawser_modes *modes, struct hawser_statics *st,
                 const struct hawser_span *span, enum hawser_given given, double value,
                 const struct hawser_attachment *attach, int count, int n)
{
	const struct hawser_modes_options options = {.n = n};

	if (!hawser_statics_loaded(st, span, given, value, HAWSER_BRANCH_TAUT, attach, count, &report) &&
	    !hawser_modes_solve(modes, st, &options, &report))
		return 1;
	return ok(0, "solved: %s", report.message);
}

/* --- a taut string: sin x + [(S/x) - m x] sin(a x) sin((1 - a) x) = 0 with x = omega l/k, the mass m
 * relative to that of the string, and the stiffness S relative to k^2/l --- */

static double equation(double x, double a, double m, double S)
{
	return sin(x) + (S/x - m*x)*sin(a*x)*sin((1.0 - a)*x);
}

static double root_of(double *x, double a, double m, double S)
{
	double lo = *x, hi;

	while (equation(lo, a, m, S)*equation(lo + 1e-3, a, m, S) > 0.0)
		lo += 1e-3;
	hi = lo + 1e-3;
	for (int i = 0; i < 60; i++) {
		double middle = 0.5*(lo + hi);

		if (equation(lo, a, m, S)*equation(middle, a, m, S) > 0.0)
			lo = middle;
		else
			hi = middle;
	}
	*x = hi + 1e-6;
	return lo;
}

static void string(double m, double S)
{
	const struct hawser_span span = {1e12, 1e-3, 9.81, 1.0, 0.0};
	const double H = 1e7, eps = H/span.EA, l = 1.0/(1.0 + eps), k2 = 1.0/(1.0 + eps), a = 0.4;
	struct hawser_attachment mass = {.at = a, .mass = m*span.rho*l, .spring = {0, 0, S*k2/l*H}};
	double x = 0.1, worst = 0.0;
	struct hawser_statics st;
	struct hawser_modes modes;

	if (!solve(&modes, &st, &span, HAWSER_GIVEN_H, H, &mass, 1, 12))
		return;
	for (int k = 0; k < modes.n; k++)
		if (modes.mode[k].plane == HAWSER_OUT_OF_PLANE)
			worst = fmax(worst, fabs(modes.mode[k].omega/(root_of(&x, a, m, S)*sqrt(k2)/l) - 1.0));
	ok(worst < 2e-13, "a string with mass %g and spring %g: %.1e", m, S, worst);
	hawser_modes_clear(&modes);
}

/* --- a chain: links between nodes of the static profile, second order in their length --- */

enum { PARTS = 3, LINKS = 48, NODES = PARTS*2*LINKS + 1 };

/* In-plane frequencies (rad/s) of the chain with `links` links in each part. */
static void chain(double *omega, const struct hawser_statics *st, int links)
{
	int n = 2*((st->attachments + 1)*links - 1);
	double *K = calloc((size_t)n*(size_t)n, sizeof *K), *M = calloc((size_t)n*(size_t)n, sizeof *M);
	double from = 0.0;

	for (int part = 0, i = 1; part <= st->attachments; part++) {
		double to = part < st->attachments ? st->attached[part].S : st->length0;

		for (int k = 0; k < links; k++, i++)
			link_between(K, M, n, 2*(i - 2), 2*(i - 1), 2, st, from + (to - from)*k/links,
			             from + (to - from)*(k + 1)/links);
		for (int p = 0; part < st->attachments && p < 2; p++) {
			link_add(M, n, 2*(i - 2) + p, 2*(i - 2) + p, st->attached[part].mass);
			link_add(K, n, 2*(i - 2) + p, 2*(i - 2) + p, st->attached[part].spring[p]);
		}
		from = to;
	}
	link_frequencies(omega, K, M, n);
	free(K);
	free(M);
}

/* A deep inclined span with a mass at 40 % and a mass on springs beyond. */
static void against_chain(void)
{
	const struct hawser_span span = {2e6, 6.0, 9.81, 100.0, 45.0};
	struct hawser_attachment attach[2] = {{.at = 0.4, .mass = 231.7},
	                                      {.at = 0.77, .mass = 55.0, .spring = {900.0, 2385.0, 0.0}}};
	double *coarse = calloc(NODES, 2*sizeof *coarse), *fine = calloc(NODES, 2*sizeof *fine);
	struct hawser_statics st;
	struct hawser_modes modes;
	int i = 0;

	if (!solve(&modes, &st, &span, HAWSER_GIVEN_LENGTH0, 131.3, attach, 2, 12))
		goto done;
	chain(coarse, &st, LINKS/2);
	chain(fine, &st, LINKS);
	for (int k = 0; k < modes.n; k++)
		if (modes.mode[k].plane == HAWSER_IN_PLANE && i < 6) {
			double limit = fine[i] + (fine[i] - coarse[i])/3.0;
			double error = modes.mode[k].omega/modes.time_unit/limit - 1.0;

			/* of fourth order, after the second is removed */
			ok(fabs(error) < 2e-6*(1 + i)*(1 + i), "in-plane %d: %.9g rad/s, chain %.9g: %.1e", i + 1,
			   modes.mode[k].omega/modes.time_unit, limit, error);
			i++;
		}
	hawser_modes_clear(&modes);
done:
	free(coarse);
	free(fine);
}

/* --- orthogonality --- */

/* Displacement along x, y, z at attachment i. */
static void at_attachment(double u[3], const struct hawser_modes *modes, int k, int i)
{
	struct hawser_frame_point at = hawser_statics_frame(&modes->statics,
	                                                    modes->statics.attached[i].s);
	double local[3];

	hawser_modes_at(modes, local, NULL, k, modes->statics.attached[i].s);
	u[0] = local[0]*at.ex - local[1]*at.ey;
	u[1] = local[0]*at.ey + local[1]*at.ex;
	u[2] = local[2];
}

/* Largest entries of mass - 1 and, relative to the frequencies, of energy - omega^2. */
static void defects(double *mass, double *energy, const struct hawser_modes *modes, int n)
{
	const struct hawser_statics *st = &modes->statics;
	size_t points = (size_t)modes->grid.points;

	*mass = *energy = 0.0;
	for (int j = 0; j < n; j++)
		for (int k = 0; k <= j; k++) {
			double M = 0.0, E = 0.0, omega = modes->mode[j].omega*modes->mode[k].omega;

			for (size_t p = 0; p < points; p++) {
				const double *x = modes->shape + 3*(j*points + p), *y = modes->shape + 3*(k*points + p);
				const double *a = modes->slope + 3*(j*points + p), *b = modes->slope + 3*(k*points + p);
				struct hawser_frame_point at = hawser_statics_frame(st, modes->grid.s[p]);
				double w = modes->grid.weight[p], T = hypot(1.0, at.u)/(1.0 + at.strain);

				M += w*(x[0]*y[0] + x[1]*y[1] + x[2]*y[2]);
				E += w*(a[0]*b[0]/st->epsilon + T*(a[1]*b[1] + a[2]*b[2]));
			}
			for (int i = 0; i < st->attachments; i++) {
				double u[3], v[3];

				at_attachment(u, modes, j, i);
				at_attachment(v, modes, k, i);
				for (int c = 0; c < 3; c++) {
					M += st->attached[i].m*u[c]*v[c];
					E += st->attached[i].spring[c]*st->span.d/st->H*u[c]*v[c];
				}
			}
			*mass = fmax(*mass, fabs(M - (j == k)));
			*energy = fmax(*energy, fabs(E/omega - (j == k)));
		}
}

static void orthogonal(void)
{
	const struct hawser_span span = {4e7, 6.0, 9.81, 250.0, -61.7};
	struct hawser_attachment attach[3] = {{.at = 0.13, .mass = 300.0, .spring = {1e3, 2e4, 500.0}},
	                                      {.at = 0.5, .damper = {0.0, 1.0, 0.0}},
	                                      {.at = 0.81, .mass = 2000.0, .spring = {0.0, 0.0, 1e7}}};
	double mass, energy, worst = 0.0, sum[3] = {0.0};
	struct hawser_modes modes, all;
	struct hawser_statics st;
	int pair = 0;

	if (!solve(&modes, &st, &span, HAWSER_GIVEN_T1, 4e4, attach, 3, 14))
		return;
	defects(&mass, &energy, &modes, modes.n);
	ok(mass < 1e-11, "the masses are part of the norm: %.1e", mass);
	ok(energy < 1e-9, "the springs are part of the energy: %.1e", energy);
	if (ok(!hawser_modes_basis(&all, &st, 80, 80, &report), "basis: %s", report.message)) {
		for (int k = 0; k < modes.n; k++)
			worst = fmax(worst, fabs(all.mode[k].omega/modes.mode[k].omega - 1.0));
		ok(worst < 1e-9, "the modes of a basis begin with these: %.1e", worst);
		defects(&mass, &energy, &all, 60);
		ok(mass < 1e-11 && energy < 1e-9, "and are orthonormal: %.1e, %.1e", mass, energy);
		for (int k = 0; k < all.n; k++)
			for (int c = 0; c < 3; c++)
				sum[c] += all.mode[k].effective_mass[c];
		for (int c = 0; c < 3; c++)
			close_to(sum[c], 1.0, 1e-2, "their effective masses add up");
		hawser_modes_clear(&all);
	}
	for (int k = 0; k < modes.n; k++)
		pair += modes.mode[k].residual < 1e-12;
	ok(pair == modes.n, "%d of %d error estimates are round-off", pair, modes.n);
	hawser_modes_clear(&modes);
}

static void limits(void)
{
	const struct hawser_span span = {4e8, 6.0, 9.81, 250.0, 61.7};
	struct hawser_attachment attach[2] = {{.at = 0.3, .damper = {0.0, 5.0, 0.0}}, {.at = 0.5}};
	struct hawser_modes_options options = {.n = 8, .method = "fdm"};
	struct hawser_modes plain, modes;
	struct hawser_statics st;
	double worst = 0.0;

	attach[1].mass = 1e-12;
	if (!solve(&plain, &st, &span, HAWSER_GIVEN_T0, 8e4, attach, 0, 8) ||
	    !solve(&modes, &st, &span, HAWSER_GIVEN_T0, 8e4, attach, 2, 8))
		return;
	for (int k = 0; k < 8; k++)
		worst = fmax(worst, fabs(modes.mode[k].omega/plain.mode[k].omega - 1.0));
	ok(worst < 1e-13, "without mass and stiffness nothing changes: %.1e", worst);
	hawser_modes_clear(&plain);
	hawser_modes_clear(&modes);
	ok(hawser_modes_solve(&modes, &st, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "spectral"), "other methods refuse: %s", report.message);
}

CASE(property_modes_attached)
{
	string(0.3, 0.0);
	string(23.85, 0.0);
	string(0.0, 2.385);
	string(0.7, 400.0);
	against_chain();
	orthogonal();
	limits();
	return done_testing();
}
