/* Undamped modes of a cable with absorbers (masses on springs of their own): a taut string by its
 * characteristic equation, an inclined deep span with several of them, a mass, springs and elastic
 * supports by a chain of masses and links with second order removed, strokes, orthogonality, all modes
 * of a basis, a subset, a sweep through a veering, refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/irvine.h>
#include <hawser/modes.h>

#include "tests/link-chain.h"
#include "tests/tap.h"

static struct hawser_report report;

static int solve(struct hawser_modes *modes, struct hawser_statics *st, const struct hawser_span *span,
                 enum hawser_given given, double value, const struct hawser_attachment *attach,
                 int count, const struct hawser_held *held, int n)
{
	const struct hawser_modes_options options = {.n = n};
	enum hawser_status status = hawser_statics_loaded(st, span, given, value, HAWSER_BRANCH_TAUT,
	                                                  attach, count, &report);

	if (!status && held)
		status = hawser_statics_hold(st, held, &report);
	if (!status && !hawser_modes_solve(modes, st, &options, &report))
		return 1;
	return ok(0, "solved: %s", report.message);
}

/* --- a taut string, out of its plane: with the mass m of the absorber over that of the string, its
 * stiffness S in T/l and x = omega l/c the impedance at the point is m S x^2/(S - m x^2), so that
 * (S - m x^2) sin x = m S x sin(a x) sin((1 - a) x) --- */

static double equation(double x, double a, double m, double S)
{
	return (S - m*x*x)*sin(x) - m*S*x*sin(a*x)*sin((1.0 - a)*x);
}

/* The next root from *x on. */
static double root_of(double *x, double a, double m, double S)
{
	double lo = *x, hi, below;

	while (equation(lo, a, m, S)*equation(lo + 1e-3, a, m, S) > 0.0)
		lo += 1e-3;
	hi = lo + 1e-3;
	below = equation(lo, a, m, S);
	for (int i = 0; i < 60; i++) {
		double middle = 0.5*(lo + hi);

		*(below*equation(middle, a, m, S) > 0.0 ? &lo : &hi) = middle;
	}
	*x = hi + 1e-6;
	return lo;
}

static void string(double a, double m, double S)
{
	const struct hawser_span span = {1e12, 1e-3, 9.81, 1.0, 0.0};
	const double H = 1e7, eps = H/span.EA, l = 1.0/(1.0 + eps), k = sqrt(l);
	const struct hawser_attachment at = {.at = a, .absorber_mass = m*span.rho*l,
	                                     .absorber_stiffness = S*k*k/l*H,
	                                     .absorber_direction = {0.0, 0.0, -0.3}};
	double x = 0.05, worst = 0.0, stroke = 0.0, stated = 0.0, own = sqrt(S/m);
	struct hawser_statics st;
	struct hawser_modes modes;
	int found = 0;

	if (!solve(&modes, &st, &span, HAWSER_GIVEN_H, H, &at, 1, NULL, 14))
		return;
	for (int i = 0; i < modes.n; i++) {
		double w = modes.mode[i].omega*l/k, shape[3], expected;

		stated = fmax(stated, modes.mode[i].residual);
		if (modes.mode[i].plane != HAWSER_OUT_OF_PLANE) {
			stroke = fmax(stroke, fabs(modes.stroke[i]));
			continue;
		}
		worst = fmax(worst, fabs(w/root_of(&x, a, m, S) - 1.0));
		hawser_modes_at(&modes, shape, NULL, i, st.attached[0].s);
		expected = -shape[2]/(own*own/(w*w) - 1.0); /* along -z */
		stroke = fmax(stroke, fabs(modes.stroke[i] - expected)/(1.0 + fabs(expected)));
		found++;
	}
	ok(found > 5 && worst < 1e-13 && worst < stated, "an absorber of %g, spring %g at %g of a string: "
	   "%d frequencies to %.1e, stated %.1e", m, S, a, found, worst, stated);
	ok(stroke < 1e-9, "strokes are those of a mass on a spring: %.1e", stroke);
	hawser_modes_clear(&modes);
}

/* --- a chain: links between nodes of the static profile, second order in their length --- */

enum { LINKS = 72 };

/* The absorbers are nodes of their own, of which a direction is joined to the node of the chain by a
 * spring; across it their mass is the node's. */
static void absorb(double *K, double *M, int n, const struct hawser_statics *st, int links, int i)
{
	const struct hawser_attached *at = &st->attached[i];
	int node = 3*(int)lround(at->S/st->length0*links), own = 3*(links + 1) + i;
	double m = at->absorber*st->span.rho*st->span.d;
	const double *a = at->absorber_axis;

	for (int p = 0; p < 3; p++) {
		link_add(M, n, node + p, node + p, at->mass - m);
		link_add(K, n, node + p, node + p, at->spring[p]);
		for (int q = 0; q < 3; q++) {
			link_add(K, n, node + p, node + q, at->absorber_stiffness*a[p]*a[q]);
			link_add(M, n, node + p, node + q, m*((p == q) - a[p]*a[q]));
		}
		link_add(K, n, node + p, own, -at->absorber_stiffness*a[p]);
		link_add(K, n, own, node + p, -at->absorber_stiffness*a[p]);
	}
	link_add(K, n, own, own, m > 0.0 ? at->absorber_stiffness : 1e20);
	link_add(M, n, own, own, m > 0.0 ? m : 1.0);
}

static void chain(double *omega, const struct hawser_statics *st, int links)
{
	int n = 3*(links + 1) + st->attachments;
	double *K = calloc((size_t)n*(size_t)n, sizeof *K), *M = calloc((size_t)n*(size_t)n, sizeof *M);
	double h = st->length0/links;

	for (int i = 0; i < links; i++)
		link_between(K, M, n, 3*i, 3*i + 3, 3, st, i*h, (i + 1)*h);
	for (int end = 0; end < 2; end++)
		for (int p = 0; p < 3; p++) {
			int i = end ? 3*links + p : p;
			int fixed = !st->elastic || isinf(st->held[end].stiffness[p]);

			if (!fixed) {
				link_add(K, n, i, i, st->held[end].stiffness[p]);
				link_add(M, n, i, i, st->held[end].mass);
				continue;
			}
			for (int j = 0; j < n; j++)
				K[i*n + j] = K[j*n + i] = M[i*n + j] = M[j*n + i] = 0.0;
			K[i*n + i] = st->span.EA/h; /* alone, above all that are compared */
			M[i*n + i] = st->span.rho*h;
		}
	for (int i = 0; i < st->attachments; i++)
		absorb(K, M, n, st, links, i);
	link_frequencies(omega, K, M, n);
	free(K);
	free(M);
}

static void against_chain(const struct hawser_span *span, double T0,
                          const struct hawser_attachment *attach, int count,
                          const struct hawser_held *held, double tolerance, const char *what)
{
	static double coarse[3*2*LINKS + 20], fine[3*2*LINKS + 20];
	struct hawser_statics st;
	struct hawser_modes modes;
	double worst = 0.0, effective[3] = {0.0};

	if (!solve(&modes, &st, span, HAWSER_GIVEN_T0, T0, attach, count, held, 12))
		return;
	chain(coarse, &st, LINKS);
	chain(fine, &st, 2*LINKS);
	for (int i = 0; i < modes.n; i++) {
		double omega = fine[i] + (fine[i] - coarse[i])/3.0;

		worst = fmax(worst, fabs(modes.mode[i].omega/modes.time_unit/omega - 1.0));
		for (int c = 0; c < 3; c++)
			effective[c] += modes.mode[i].effective_mass[c];
	}
	ok(worst < tolerance, "%s: 12 frequencies of a chain to %.1e", what, worst);
	ok(effective[0] < 1.0 && effective[1] < 1.0 && effective[2] < 1.0,
	   "effective masses of these modes are %.3f, %.3f, %.3f of all", effective[0], effective[1],
	   effective[2]);
	hawser_modes_clear(&modes);
}

/* --- orthogonality, with the masses as they move --- */

static double product(const struct hawser_modes *modes, int j, int k)
{
	const struct hawser_statics *st = &modes->statics;
	const struct hawser_grid *grid = &modes->grid;
	double sum = 0.0;

	for (int p = 0; p < grid->points; p++)
		for (int c = 0; c < 3; c++)
			sum += grid->weight[p]*modes->shape[3*(j*grid->points + p) + c]*
			       modes->shape[3*(k*grid->points + p) + c];
	for (int i = 0; i < st->attachments; i++) {
		const struct hawser_attached *at = &st->attached[i];
		struct hawser_frame_point f = hawser_statics_frame(st, at->s);
		double local[3] = {at->absorber_axis[0]*f.ex + at->absorber_axis[1]*f.ey,
		                   at->absorber_axis[1]*f.ex - at->absorber_axis[0]*f.ey,
		                   at->absorber_axis[2]}, u[3], v[3];
		double s = modes->stroke[j*st->attachments + i], t = modes->stroke[k*st->attachments + i];

		hawser_modes_at(modes, u, NULL, j, at->s);
		hawser_modes_at(modes, v, NULL, k, at->s);
		for (int c = 0; c < 3; c++)
			sum += (at->m - at->absorber)*u[c]*v[c] +
			       at->absorber*(u[c] + s*local[c])*(v[c] + t*local[c]);
	}
	return sum;
}

static double orthogonality(const struct hawser_modes *modes, int n)
{
	double worst = 0.0;

	for (int j = 0; j < n; j++)
		for (int k = 0; k <= j; k++)
			worst = fmax(worst, fabs(product(modes, j, k) - (j == k)));
	return worst;
}

static const struct hawser_span deep = {6e6, 3.0, 9.81, 90.0, 35.0};
static const struct hawser_attachment several[3] = {
	{.at = 0.25, .mass = 20.0, .spring = {0.0, 300.0, 0.0}, .absorber_mass = 35.0,
	 .absorber_stiffness = 700.0, .absorber_direction = {0.4, -1.3, 0.0}},
	{.at = 0.5, .absorber_mass = 12.0, .absorber_stiffness = 90.0,
	 .absorber_direction = {0.0, 0.0, 2.0}},
	{.at = 0.75, .absorber_mass = 25.0, .absorber_stiffness = 2e3,
	 .absorber_direction = {1.0, 0.0, 0.0}},
};

static void basis(void)
{
	struct hawser_modes modes, all, part;
	struct hawser_statics st;
	const int kept[] = {1, 4, 6};
	double worst = 0.0, stroke = 0.0;

	if (!solve(&modes, &st, &deep, HAWSER_GIVEN_T0, 6e3, several, 3, NULL, 10))
		return;
	worst = orthogonality(&modes, modes.n);
	ok(worst < 1e-9, "modes are orthonormal with strokes: %.1e", worst);
	if (!ok(!hawser_modes_select(&part, &modes, kept, 3, &report), "a subset"))
		return;
	for (int i = 0; i < 9; i++)
		stroke = fmax(stroke, fabs(part.stroke[i] - modes.stroke[3*kept[i/3] + i%3]));
	ok(stroke == 0.0, "it has the strokes");
	hawser_modes_clear(&part);
	if (!ok(!hawser_modes_basis(&all, &st, 40, 40, &report), "a basis: %s", report.message))
		return;
	worst = 0.0;
	for (int i = 0; i < modes.n; i++) {
		worst = fmax(worst, fabs(all.mode[i].omega/modes.mode[i].omega - 1.0));
		for (int a = 0; a < 3; a++)
			stroke = fmax(stroke, fabs(all.stroke[3*i + a] - modes.stroke[3*i + a]));
	}
	ok(worst < 1e-9 && stroke < 1e-5, "the modes of a basis: %.1e, strokes %.1e", worst, stroke);
	worst = orthogonality(&all, all.n);
	ok(worst < 1e-9, "all %d modes are orthonormal: %.1e", all.n, worst);
	hawser_modes_clear(&all);
	hawser_modes_clear(&modes);
}

/* Where two branches veer the cable moves alike in both, and only the absorber tells them apart. */
static void sweep(void)
{
	const struct hawser_attachment at = {.at = 0.5, .absorber_mass = 4.0, .absorber_stiffness = 144.0,
	                                     .absorber_direction = {0.0, 1.0, 0.0}};
	const struct hawser_span span = {5e6, 3.0, 9.81, 90.0, 0.0};
	const struct hawser_irvine_options options = {.n = 4, .points = 12, .from = 3e4, .to = 3e5,
	                                              .attach = &at, .attachments = 1,
	                                              .sweep = HAWSER_GIVEN_H};
	struct hawser_irvine irvine;
	double gap = 0.0;
	int veering = 0;

	if (!ok(!hawser_irvine_trace(&irvine, &span, &options, &report), "a sweep: %s", report.message))
		return;
	for (int i = 0; i < irvine.crossovers; i++)
		if (irvine.crossover[i].kind == HAWSER_VEERING) {
			gap = irvine.crossover[i].relative_gap;
			veering++;
		}
	/* of two oscillators: the square root of the mass over the modal one, half of the cable's */
	ok(veering == 1 && fabs(gap/sqrt(2.0*at.absorber_mass/(span.rho*span.d)) - 1.0) < 0.01,
	   "%d veering in a sweep of the tension, with a relative gap of %.4f", veering, gap);
	hawser_irvine_clear(&irvine);
}

static void refusals(void)
{
	struct hawser_attachment at = {.at = 0.5, .absorber_mass = 4.0, .absorber_stiffness = 60.0,
	                               .absorber_direction = {0.0, 1.0, 1.0}};
	const struct hawser_modes_options options = {.n = 4};
	struct hawser_statics st;
	struct hawser_modes modes;

	if (!ok(!hawser_statics_loaded(&st, &deep, HAWSER_GIVEN_T0, 6e3, HAWSER_BRANCH_TAUT, &at, 1,
	                               &report), "statics"))
		return;
	ok(hawser_modes_solve(&modes, &st, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "absorber_direction is oblique"), "oblique: %s", report.message);
	ok(hawser_modes_basis(&modes, &st, 8, 8, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "absorber_direction is oblique"), "the same of a basis");
	st.space = 1;
	ok(hawser_modes_solve(&modes, &st, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "hangs in space"), "%s", report.message);
	st.space = 0;
	st.attached[0].absorber_axis[2] = 0.0;
	st.bending.EI = 1e3;
	ok(hawser_modes_solve(&modes, &st, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "without bending stiffness"), "%s", report.message);
}

CASE(property_modes_absorber)
{
	const struct hawser_held held[2] = {{{2e5, 3e5, INFINITY}, 40.0, 0.0},
	                                    {{4e5, INFINITY, 9e4}, 15.0, 0.0}};

	string(0.5, 0.02, 0.02*9.0);
	string(0.31, 0.4, 5.0);
	string(0.08, 0.05, 0.05*40.0);
	string(0.47, 3.0, 400.0);
	against_chain(&deep, 6e3, several, 3, NULL, 3e-6, "an inclined deep span with three absorbers");
	against_chain(&deep, 6e3, several, 3, held, 3e-6, "the same on elastic supports");
	basis();
	sweep();
	refusals();
	return done_testing();
}
