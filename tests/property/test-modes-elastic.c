/* Modes of a cable on elastic supports: a string by its frequency equation, a chain of masses and links
 * with the same springs with second order removed, the rigid limit, orthogonality, all modes of a
 * basis, refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/campbell.h>
#include <hawser/modes.h>

#include "tests/link-chain.h"
#include "tests/tap.h"

static struct hawser_report report;

static int solve(struct hawser_modes *modes, struct hawser_statics *st, const struct hawser_span *span,
                 double T0, const struct hawser_held *held, int n)
{
	const struct hawser_modes_options options = {.n = n};

	if (!hawser_statics_solve(st, span, HAWSER_GIVEN_T0, T0, HAWSER_BRANCH_TAUT, &report) &&
	    !hawser_statics_hold(st, held, &report) && !hawser_modes_solve(modes, st, &options, &report))
		return 1;
	return ok(0, "solved: %s", report.message);
}

static const struct hawser_held rigid = {{INFINITY, INFINITY, INFINITY}, 0.0, 0.0};

/* --- a taut string, out of its plane: w = cos(q s) + b sin(q s) with T q b = (kA - mA omega^2), and
 * -T w'(l) = (kB - mB omega^2) w(l). Stiffness in T/l, mass in that of the string, x = q l --- */

static double equation(double x, const double k[2], const double m[2])
{
	double a = k[0] - m[0]*x*x, b = k[1] - m[1]*x*x; /* T b q l = a */

	return (a*b - x*x)*sin(x) + x*(a + b)*cos(x);
}

static double root_of(double *x, const double k[2], const double m[2])
{
	double lo = *x, hi;

	while (equation(lo, k, m)*equation(lo + 1e-3, k, m) > 0.0)
		lo += 1e-3;
	hi = lo + 1e-3;
	for (int i = 0; i < 60; i++) {
		double middle = 0.5*(lo + hi);

		if (equation(lo, k, m)*equation(middle, k, m) > 0.0)
			lo = middle;
		else
			hi = middle;
	}
	*x = hi + 1e-6;
	return lo;
}

static void string(double kA, double mA, double kB, double mB)
{
	const struct hawser_span span = {1e12, 1e-3, 9.81, 1.0, 0.0};
	const double H = 1e7, eps = H/span.EA, l = 1.0/(1.0 + eps), mass = span.rho*l;
	const double k[2] = {kA, kB}, m[2] = {mA, mB};
	/* T dw/dS / (1 + eps): the wave has the tension H, the arclength is unstretched */
	const struct hawser_held held[2] = {{{INFINITY, INFINITY, kA*H/(1.0 + eps)/l}, mA*mass, 0.0},
	                                    {{INFINITY, INFINITY, kB*H/(1.0 + eps)/l}, mB*mass, 0.0}};
	double x = 0.05, worst = 0.0;
	struct hawser_statics st;
	struct hawser_modes modes;
	int found = 0;

	if (!solve(&modes, &st, &span, H, held, 14))
		return;
	for (int i = 0; i < modes.n; i++)
		if (modes.mode[i].plane == HAWSER_OUT_OF_PLANE) {
			worst = fmax(worst, fabs(modes.mode[i].omega/
			                         (root_of(&x, k, m)/(l*sqrt(1.0 + eps))) - 1.0));
			found++;
		}
	ok(found > 4 && worst < 3e-13, "a string on springs %g, %g with masses %g, %g: %.1e of %d", kA, kB,
	   mA, mB, worst, found);
	hawser_modes_clear(&modes);
}

/* --- a chain: links between nodes of the static profile, second order in their length --- */

enum { LINKS = 96 };

/* The supports of the chain; a rigid direction is stiff by `STIFF` times the stiffest link. */
static void supports(double *K, double *M, int n, const struct hawser_held *held, int links,
                     double stiff)
{
	for (int end = 0; end < 2; end++)
		for (int p = 0; p < 3; p++) {
			int i = (end ? 3*links : 0) + p, rigid_here = isinf(held[end].stiffness[p]);

			link_add(K, n, i, i, rigid_here ? stiff : held[end].stiffness[p]);
			link_add(M, n, i, i, rigid_here ? 0.0 : held[end].mass);
		}
}

/* Frequencies (rad/s) of the chain with `links` links, in both planes. */
static void chain(double *omega, const struct hawser_statics *st, int links)
{
	int n = 3*(links + 1);
	double *K = calloc((size_t)n*(size_t)n, sizeof *K), *M = calloc((size_t)n*(size_t)n, sizeof *M);
	double h = st->length0/links;

	for (int i = 0; i < links; i++)
		link_between(K, M, n, 3*i, 3*i + 3, 3, st, i*h, (i + 1)*h);
	supports(K, M, n, st->held, links, 1e6*st->span.EA/h);
	link_frequencies(omega, K, M, n);
	free(K);
	free(M);
}

/* Integral of Phi_j . Phi_k with the masses at the ends. */
static double product(const struct hawser_modes *modes, int j, int k)
{
	const struct hawser_grid *grid = &modes->grid;
	double sum = 0.0, x[3], y[3];

	for (int i = 0; i < grid->points; i++)
		for (int c = 0; c < 3; c++)
			sum += grid->weight[i]*modes->shape[(j*grid->points + i)*3 + c]*
			       modes->shape[(k*grid->points + i)*3 + c];
	for (int end = 0; end < 2; end++) {
		hawser_modes_at(modes, x, NULL, j, end ? modes->statics.l : 0.0);
		hawser_modes_at(modes, y, NULL, k, end ? modes->statics.l : 0.0);
		sum += modes->statics.held[end].mass/(modes->statics.span.rho*modes->statics.span.d)*
		       (x[0]*y[0] + x[1]*y[1] + x[2]*y[2]);
	}
	return sum;
}

/* A deep inclined span on springs of both ends, with other stiffness in each direction. */
static void against_chain(void)
{
	const struct hawser_span span = {2e6, 6.0, 9.81, 100.0, 45.0};
	const struct hawser_held held[2] = {{{2385.0, 5100.0, 900.0}, 231.7, 0.0},
	                                    {{7000.0, INFINITY, 400.0}, 55.0, 0.0}};
	double *coarse = calloc(3*(LINKS + 1), sizeof *coarse), *fine = calloc(3*(LINKS + 1), sizeof *fine);
	double worst = 0.0, apart = 0.0;
	struct hawser_statics st;
	struct hawser_modes modes;

	if (!solve(&modes, &st, &span, 6500.0, held, 12))
		goto done;
	chain(coarse, &st, LINKS/2);
	chain(fine, &st, LINKS);
	for (int k = 0; k < modes.n; k++) {
		double limit = fine[k] + (fine[k] - coarse[k])/3.0;

		worst = fmax(worst, fabs(modes.mode[k].omega/modes.time_unit/limit - 1.0));
		for (int j = 0; j <= k; j++)
			apart = fmax(apart, fabs(product(&modes, j, k) - (j == k)));
	}
	ok(worst < 2e-4, "%d modes on springs agree with a chain: %.1e", modes.n, worst);
	ok(apart < 1e-10, "orthonormal with the masses of the supports: %.1e", apart);
	hawser_modes_clear(&modes);
done:
	free(coarse);
	free(fine);
}

/* Stiff springs: the frequencies of rigid ends, up to a difference of first order in 1/stiffness; and a
 * very heavy support is another way to hold an end. */
static void limits(void)
{
	const struct hawser_span span = {2e6, 6.0, 9.81, 100.0, -23.85};
	const double stiffness[3] = {1e9, 1e10, 1e11};
	double worst[3] = {0.0}, heavy[2] = {0.0}, sway;
	struct hawser_held held[2] = {rigid, rigid};
	struct hawser_statics st;
	struct hawser_modes fixed, modes;

	if (!solve(&fixed, &st, &span, 9000.0, held, 9))
		return;
	for (int i = 0; i < 3; i++) {
		for (int end = 0; end < 2; end++)
			for (int axis = 0; axis < 3; axis++)
				held[end].stiffness[axis] = stiffness[i];
		if (!solve(&modes, &st, &span, 9000.0, held, 9))
			continue;
		for (int k = 0; k < 9; k++)
			worst[i] = fmax(worst[i], fabs(modes.mode[k].omega/fixed.mode[k].omega - 1.0));
		hawser_modes_clear(&modes);
	}
	ok(worst[0] > 1e-8 && fabs(worst[0]/worst[1] - 10.0) < 0.1 && fabs(worst[1]/worst[2] - 10.0) < 0.1,
	   "stiff springs come near rigid ends as 1/stiffness: %.2e, %.2e, %.2e", worst[0], worst[1],
	   worst[2]);
	held[0] = rigid;
	for (int i = 0; i < 2; i++) {
		held[1] = (struct hawser_held){{INFINITY, INFINITY, 50.0}, i ? 1e6 : 1e5, 0.0};
		if (!solve(&modes, &st, &span, 9000.0, held, 8))
			continue;
		sway = modes.mode[0].omega/modes.time_unit/sqrt((50.0 + st.H/100.0)/held[1].mass) - 1.0;
		ok(fabs(sway) < 300.0/held[1].mass, "a heavy support sways on its springs and the tension of "
		   "the cable: %.1e", sway);
		for (int k = 0; k < 7; k++)
			heavy[i] = fmax(heavy[i], fabs(modes.mode[k + 1].omega/fixed.mode[k].omega - 1.0));
		hawser_modes_clear(&modes);
	}
	ok(heavy[1] > 0.0 && fabs(heavy[0]/heavy[1] - 10.0) < 0.1, "for all other modes it is the more at "
	   "rest the heavier it is: %.2e, %.2e", heavy[0], heavy[1]);
	hawser_modes_clear(&fixed);
}

/* All modes of a basis are those of the solver, as far as they are converged. */
static void basis(void)
{
	const struct hawser_span span = {2e6, 6.0, 9.81, 100.0, 45.0};
	const struct hawser_held held[2] = {{{2385.0, 5100.0, 900.0}, 231.7, 0.0},
	                                    {{7000.0, INFINITY, INFINITY}, 0.0, 0.0}};
	struct hawser_modes modes, all;
	struct hawser_statics st;
	double worst = 0.0, apart = 0.0;

	if (!solve(&modes, &st, &span, 6500.0, held, 8))
		return;
	if (!hawser_modes_basis(&all, &st, 24, 24, &report)) {
		for (int k = 0; k < modes.n; k++)
			worst = fmax(worst, fabs(all.mode[k].omega/modes.mode[k].omega - 1.0));
		for (int k = 0; k < all.n; k++)
			for (int j = 0; j <= k; j++)
				apart = fmax(apart, fabs(product(&all, j, k) - (j == k)));
		ok(worst < 1e-9 && apart < 1e-10, "%d modes of a basis: %.1e, orthonormal up to %.1e", all.n,
		   worst, apart);
		hawser_modes_clear(&all);
	} else {
		ok(0, "basis: %s", report.message);
	}
	hawser_modes_clear(&modes);
}

/* The effective masses along each axis sum up to 1, with a mass that is free to move. */
static void effective(void)
{
	const struct hawser_span span = {2e6, 6.0, 9.81, 100.0, 45.0};
	const struct hawser_held held[2] = {{{2385.0, 5100.0, 900.0}, 231.7, 0.0},
	                                    {{7000.0, INFINITY, 400.0}, 55.0, 0.0}};
	struct hawser_modes modes;
	struct hawser_statics st;
	double sum[3] = {0.0};

	if (!solve(&modes, &st, &span, 6500.0, held, 60))
		return;
	for (int k = 0; k < modes.n; k++)
		for (int c = 0; c < 3; c++)
			sum[c] += modes.mode[k].effective_mass[c];
	for (int c = 0; c < 3; c++)
		ok(sum[c] > 0.96 && sum[c] < 1.0 + 1e-10, "effective mass along axis %d: %.6f", c, sum[c]);
	hawser_modes_clear(&modes);
}

static void refused(void)
{
	const struct hawser_span span = {2e6, 6.0, 9.81, 100.0, 45.0};
	struct hawser_held held[2] = {rigid, rigid};
	struct hawser_modes_options options = {.n = 2, .method = "chain"};
	struct hawser_statics st;
	struct hawser_modes modes;

	ok(!hawser_statics_solve(&st, &span, HAWSER_GIVEN_T0, 6500.0, HAWSER_BRANCH_TAUT, &report),
	   "solved");
	held[1].mass = 3.0;
	ok(hawser_statics_hold(&st, held, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "an end that is rigid"), "%s", report.message);
	held[1].stiffness[1] = 0.0;
	ok(hawser_statics_hold(&st, held, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "support.B.stiffness[1] = 0"), "%s", report.message);
	held[1].stiffness[1] = 10.0;
	held[1].mass = -1.0;
	ok(hawser_statics_hold(&st, held, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "support.B.mass = -1"), "%s", report.message);
	held[1].mass = 0.0;
	ok(!hawser_statics_hold(&st, held, &report), "held");
	ok(hawser_modes_solve(&modes, &st, &options, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "rigid supports"), "%s", report.message);
	st.turned = 1;
	st.turned = 0;
	st.motion.nu = 0.3;
	ok(hawser_statics_hold(&st, held, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "travels are not modelled"), "%s", report.message);
}

/* A program that sweeps the speed of a cable on springs. */
static void not_travelling(void)
{
	static struct hawser_scene scene = {.cable = {.EA = 2e6, .rho = 6.0}, .span = {100.0, 45.0},
	                                    .g = 9.81,
		.tension = {HAWSER_GIVEN_T0, 6500.0, HAWSER_BRANCH_TAUT, HAWSER_STATE_REFERENCE},
		.travel = {.present = 1, .speed = 1.0, .hold = HAWSER_HOLD_TENSION}};
	struct hawser_campbell_options options = {.from = 0.0, .to = 5.0};
	struct hawser_campbell campbell;

	for (int end = 0; end < 2; end++) {
		scene.support[end].present = 1;
		for (int axis = 0; axis < 3; axis++)
			scene.support[end].stiffness[axis] = axis == 1 ? INFINITY : 4e3;
	}
	ok(hawser_campbell_trace(&campbell, &scene, &options, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "the supports are elastic"), "%s", report.message);
}

CASE(property_modes_elastic)
{
	string(3.7, 0.0, 2.385, 0.0);
	string(0.31, 1.9, 12.0, 0.2);
	string(1e3, 0.0, 1e-2, 0.77);
	against_chain();
	limits();
	basis();
	effective();
	refused();
	not_travelling();
	return done_testing();
}
