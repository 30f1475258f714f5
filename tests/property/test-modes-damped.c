/* Complex modes of a cable with dampers: a taut string by its characteristic equation, the optimum of
 * a damper near the end, strings with uniform damping, a chain of masses and links, sweeps, refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <lapacke.h>
#include <stdlib.h>

#include <hawser/damped.h>

#include "tests/link-chain.h"
#include "tests/tap.h"

static struct hawser_report report;

static int solve(struct hawser_damped *damped, struct hawser_statics *st,
                 const struct hawser_span *span, enum hawser_given given, double value,
                 const struct hawser_attachment *attach, int count, const struct hawser_scene *scene,
                 int n)
{
	const struct hawser_damped_options options = {.n = n};

	if (!hawser_statics_loaded(st, span, given, value, HAWSER_BRANCH_TAUT, attach, count, &report) &&
	    !hawser_damped_solve(damped, st, scene, &options, &report))
		return 1;
	return ok(0, "solved: %s", report.message);
}

/* --- a damper on a taut string: with g = lambda l/k and eta the damper relative to the impedance of
 * the string, sinh g + (eta + m g + S/g) sinh(a g) sinh((1 - a) g) = 0; m, S a mass and a spring there.
 * For real m = S = 0 this is Krenk's tan(kL) = ... (J. Appl. Mech. 67 (2000) 772) --- */

static double complex root_of(double complex g, double a, double eta, double m, double S)
{
	for (int i = 0; i < 80; i++) {
		double complex low = csinh(a*g), high = csinh((1.0 - a)*g), Z = eta + m*g + S/g;
		double complex f = csinh(g) + Z*low*high;
		double complex slope = ccosh(g) + (m - S/(g*g))*low*high +
		                       Z*(a*ccosh(a*g)*high + (1.0 - a)*low*ccosh((1.0 - a)*g));

		g -= f/slope;
	}
	return g;
}

static const struct hawser_span light = {1e12, 1e-3, 9.81, 1.0, 0.0};
static const double tension = 1e7;

/* The taut string with eta, m, S at a: every out-of-plane mode found is a root, and they are as many
 * as Im g < the largest one allows. */
static void string(double a, double eta, double m, double S)
{
	const double eps = tension/light.EA, l = 1.0/(1.0 + eps), k2 = 1.0/(1.0 + eps), k = sqrt(k2);
	struct hawser_attachment at = {.at = a, .mass = m*light.rho*l, .spring = {0, 0, S*k2/l*tension},
	                               .damper = {0, 0, eta*k*sqrt(light.rho*tension)}};
	double worst = 0.0, stated = 0.0, gap = 0.0, last = 0.0;
	struct hawser_damped damped;
	struct hawser_statics st;

	if (!solve(&damped, &st, &light, HAWSER_GIVEN_H, tension, &at, 1, NULL, 12))
		return;
	for (int i = 0; i < damped.n; i++) {
		const struct hawser_damped_mode *mode = &damped.mode[i];
		double complex g = (mode->re + I*mode->omega)*l/k, exact;

		if (mode->plane == HAWSER_IN_PLANE) { /* the damper does not act there */
			worst = fmax(worst, fabs(mode->ratio));
			continue;
		}
		exact = root_of(g, a, eta, m, S);
		worst = fmax(worst, cabs(g - exact)/cabs(exact));
		stated = fmax(stated, mode->residual);
		gap = fmax(gap, cimag(exact) - last);
		last = cimag(exact);
	}
	ok(worst < 1e-11 && worst < stated && gap < 2.2*M_PI, "a string with a damper %g at %g, mass %g, "
	   "spring %g: %.1e, stated %.1e; largest gap %.3g pi", eta, a, m, S, worst, stated, gap/M_PI);
	hawser_damped_clear(&damped);
}

/* An absorber of mass m, tuned to S/m, with the damper c: seen from the point it is the impedance
 * m g (S + c g)/(m g^2 + c g + S). Every out-of-plane mode found is a root, and their number is that
 * of the string's modes and one. */
static void absorber(double a, double m, double S, double c)
{
	const double eps = tension/light.EA, l = 1.0/(1.0 + eps), k = sqrt(l);
	struct hawser_attachment at = {.at = a, .absorber_mass = m*light.rho*l,
	                               .absorber_stiffness = S*k*k/l*tension,
	                               .absorber_damping = c*k*sqrt(light.rho*tension),
	                               .absorber_direction = {0, 0, -2.0}};
	double worst = 0.0, stated = 0.0, least = INFINITY;
	struct hawser_damped damped;
	struct hawser_statics st;
	int seen = 0, below;

	if (!solve(&damped, &st, &light, HAWSER_GIVEN_H, tension, &at, 1, NULL, 12))
		return;
	for (int i = 0; i < damped.n; i++) {
		const struct hawser_damped_mode *mode = &damped.mode[i];
		double complex g = (mode->re + I*mode->omega)*l/k, low, high, Z, f, slope;

		if (mode->plane == HAWSER_IN_PLANE)
			continue;
		low = csinh(a*g);
		high = csinh((1.0 - a)*g);
		Z = m*g*(S + c*g)/(m*g*g + c*g + S);
		f = csinh(g) + Z*low*high;
		slope = ccosh(g) + Z*(a*ccosh(a*g)*high + (1.0 - a)*low*ccosh((1.0 - a)*g)) +
		        low*high*m*((S + 2.0*c*g)*(m*g*g + c*g + S) - g*(S + c*g)*(2.0*m*g + c))/
		                ((m*g*g + c*g + S)*(m*g*g + c*g + S));
		worst = fmax(worst, cabs(f/slope)/cabs(g));
		stated = fmax(stated, mode->residual);
		least = fmin(least, mode->ratio);
		seen++;
	}
	below = (int)(damped.mode[damped.n - 1].omega*l/k/M_PI);
	ok(worst < 1e-10 && worst < 10.0*stated && seen >= below, "an absorber of mass %g at %g: %.1e, "
	   "stated %.1e; %d modes up to %.3g pi", m, a, worst, stated, seen,
	   damped.mode[damped.n - 1].omega*l/k/M_PI);
	ok((c > 0.0) == (least > 1e-5), "least damping ratio %.3g", least);
	hawser_damped_clear(&damped);
}

/* A small absorber in the middle of a string, tuned to the first mode as in Den Hartog's rule,
 * 1/(1 + mu) of its frequency with mu the mass over the modal one, l/2: with the damping ratio
 * sqrt(mu/(1 + mu)) both modes have the same frequency and half of this damping ratio (S. Krenk,
 * J. Appl. Mech. 72 (2005) 936). A smaller damper splits the frequencies, and both have half of its
 * ratio. */
static void tuned(double mu)
{
	const double eps = tension/light.EA, l = 1.0/(1.0 + eps), k = sqrt(l), m = 0.5*mu;
	const double w = M_PI/(1.0 + mu), zeta = 0.6*sqrt(mu/(1.0 + mu));
	struct hawser_attachment at = {.at = 0.5, .absorber_mass = m*light.rho*l,
	                               .absorber_stiffness = m*w*w*k*k/l*tension,
	                               .absorber_damping = 2.0*zeta*w*m*k*sqrt(light.rho*tension),
	                               .absorber_direction = {0, 0, 1.0}};
	double ratio[2] = {0.0};
	struct hawser_damped damped;
	struct hawser_statics st;
	int seen = 0;

	if (!solve(&damped, &st, &light, HAWSER_GIVEN_H, tension, &at, 1, NULL, 5))
		return;
	for (int i = 0; i < damped.n && seen < 2; i++)
		if (damped.mode[i].plane == HAWSER_OUT_OF_PLANE)
			ratio[seen++] = damped.mode[i].ratio;
	/* Krenk: half of the absorber's ratio, to the order of mu */
	ok(seen == 2 && fabs(ratio[0] - 0.5*zeta) < mu && fabs(ratio[1] - 0.5*zeta) < mu &&
	   fabs(ratio[0] - ratio[1]) < mu, "tuned, mass ratio %g: damping ratios %.5g and %.5g, half of "
	   "the absorber's %.5g", mu, ratio[0], ratio[1], 0.5*zeta);
	hawser_damped_clear(&damped);
}

/* Largest damping ratio of out-of-plane mode `number` over the size of the damper, by a sweep of the
 * scene's key: a/2 at eta = 1/(pi a number) (Pacheco, Fujino, Sulekh, J. Struct. Eng. 119 (1993) 1961;
 * Krenk). The next order is a^2. */
static void optimum(double a)
{
	const double z = sqrt(light.rho*tension);
	struct hawser_scene scene = {.cable = {.EA = light.EA, .rho = light.rho},
	                             .span = {light.d, 0.0}, .g = light.g,
	                             .tension = {HAWSER_GIVEN_H, tension, HAWSER_BRANCH_TAUT,
	                                         (enum hawser_state)0}, .attachments = 1,
	                             .attach = {{.at = a, .damper = {0, 0, z}}}};
	double size[33];
	const struct hawser_damped_sweep_options options = {
		.key = "attach.0.damper[2]", .value = size, .points = 33, .modes = {.n = 6}};
	struct hawser_damped_sweep sweep;

	for (int i = 0; i < 33; i++)
		size[i] = 0.2*z/(M_PI*a)*pow(15.0, i/32.0);
	if (!ok(!hawser_damped_trace(&sweep, &scene, &options, &report), "a sweep: %s", report.message))
		return;
	for (int number = 1; number <= 2; number++) {
		double most = 0.0, best = 0.0;

		for (int i = 0; i < sweep.points; i++)
			for (int k = 0; k < sweep.state[i].n; k++) {
				const struct hawser_damped_mode *mode = &sweep.state[i].mode[k];

				if (mode->plane == HAWSER_OUT_OF_PLANE && mode->number == number &&
				    mode->ratio > most) {
					most = mode->ratio;
					best = sweep.value[i]/z*M_PI*a*number;
				}
			}
		ok(fabs(most/(0.5*a) - 1.0) < 2.5*a*number + 0.002, "damper at %g, mode %d: largest ratio "
		   "%.5g, a/2 = %.5g", a, number, most, 0.5*a);
		ok(fabs(best - 1.0) < 0.08 + 2.0*a*number, "at %.3g times Krenk's optimal size", best);
	}
	hawser_damped_sweep_clear(&sweep);
}

/* Damping of the scene beside the damper: alpha and Rayleigh's factor of mass shift the square of the
 * eigenvalue, lambda^2 + alpha lambda = g^2 without damper. */
static void uniform(void)
{
	const double eps = tension/light.EA, l = 1.0/(1.0 + eps), k = sqrt(l);
	struct hawser_attachment at = {.at = 0.3, .damper = {0, 0, 1e-9}};
	struct hawser_scene scene = {.damping = {.kind = HAWSER_DAMPING_RATIO, .ratio = 0.0123}};
	struct hawser_damped damped;
	struct hawser_statics st;

	if (!solve(&damped, &st, &light, HAWSER_GIVEN_H, tension, &at, 1, &scene, 4))
		return;
	for (int i = 0; i < damped.n; i++)
		close_to(damped.mode[i].ratio, 0.0123, 1e-9, "the scene's damping ratio");
	scene.damping.kind = HAWSER_DAMPING_ALPHA;
	scene.damping.alpha = 0.4*light.rho/damped.time_unit;
	hawser_damped_clear(&damped);
	if (!solve(&damped, &st, &light, HAWSER_GIVEN_H, tension, &at, 1, &scene, 4))
		return;
	close_to(damped.mode[0].re, -0.2, 1e-9, "alpha");
	close_to(hypot(damped.mode[0].re, damped.mode[0].omega), M_PI*k/l, 1e-9, "and the modulus");
	hawser_damped_clear(&damped);
}

/* --- a chain: links between nodes of the static profile, second order in their length --- */

enum { LINKS = 30 };

/* The in-plane eigenvalue (1/s) of the chain next to `near`. */
static double complex chain(const struct hawser_statics *st, double alpha, int links,
                            double complex near)
{
	int n = 2*((st->attachments + 1)*links - 1), N = 2*n;
	double *K = calloc((size_t)n*(size_t)n, sizeof *K), *M = calloc((size_t)n*(size_t)n, sizeof *M);
	double *D = calloc((size_t)n*(size_t)n, sizeof *D), *A = calloc((size_t)N*(size_t)N, sizeof *A);
	double *w = calloc(2*(size_t)N, sizeof *w), from = 0.0;
	double complex best = INFINITY;

	for (int part = 0, i = 1; part <= st->attachments; part++) {
		double to = part < st->attachments ? st->attached[part].S : st->length0;

		for (int k = 0; k < links; k++, i++) {
			link_between(K, M, n, 2*(i - 2), 2*(i - 1), 2, st, from + (to - from)*k/links,
			             from + (to - from)*(k + 1)/links);
			for (int j = 2*(i - 2); j < 2*i; j++)
				link_add(D, n, j, j, 0.5*alpha*(to - from)/links);
		}
		for (int p = 0; part < st->attachments && p < 2; p++) {
			link_add(M, n, 2*(i - 2) + p, 2*(i - 2) + p, st->attached[part].mass);
			link_add(K, n, 2*(i - 2) + p, 2*(i - 2) + p, st->attached[part].spring[p]);
			link_add(D, n, 2*(i - 2) + p, 2*(i - 2) + p, st->attached[part].damper[p]);
		}
		from = to;
	}
	for (int j = 0; j < n; j++) {
		A[j*N + n + j] = 1.0;
		for (int k = 0; k < n; k++) {
			A[(n + j)*N + k] = -K[j*n + k]/M[j*n + j];
			A[(n + j)*N + n + k] = -D[j*n + k]/M[j*n + j];
		}
	}
	if (!LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', N, A, N, w, w + N, NULL, 1, NULL, 1))
		for (int i = 0; i < N; i++)
			if (cabs(w[i] + I*w[N + i] - near) < cabs(best - near))
				best = w[i] + I*w[N + i];
	free(K);
	free(M);
	free(D);
	free(A);
	free(w);
	return best;
}

/* A sagging inclined span with a heavy damper, and a mass on a spring and a damper. */
static void against_chain(void)
{
	const struct hawser_span span = {2e6, 6.0, 9.81, 100.0, 45.0};
	struct hawser_attachment attach[2] = {{.at = 0.07, .damper = {300.0, 2000.0, 50.0}},
	                                      {.at = 0.77, .mass = 55.0, .spring = {900.0, 2385.0, 0.0},
	                                       .damper = {40.0, 25.0, 0.0}}};
	struct hawser_scene scene = {.damping = {.kind = HAWSER_DAMPING_ALPHA, .alpha = 0.11}};
	struct hawser_damped damped;
	struct hawser_statics st;
	int seen = 0;

	if (!solve(&damped, &st, &span, HAWSER_GIVEN_LENGTH0, 126.3, attach, 2, &scene, 8))
		return;
	for (int i = 0; i < damped.n && seen < 4; i++) {
		const struct hawser_damped_mode *mode = &damped.mode[i];
		double complex found = (mode->re + I*mode->omega)/damped.time_unit, coarse, fine, limit;

		if (mode->plane != HAWSER_IN_PLANE)
			continue;
		coarse = chain(&st, 0.11, LINKS/2, found);
		fine = chain(&st, 0.11, LINKS, found);
		limit = fine + (fine - coarse)/3.0;
		seen++;
		ok(cabs(found - limit) < 4e-5*seen*cabs(limit) && cabs(found - fine) > 2.0*cabs(found - limit),
		   "in-plane %d: %.7g + %.8gi, chain %.7g + %.8gi: %.1e (before extrapolation %.1e)",
		   mode->number, creal(found), cimag(found), creal(limit), cimag(limit),
		   cabs(found - limit)/cabs(limit), cabs(found - fine)/cabs(fine));
	}
	hawser_damped_clear(&damped);
}

/* A damper in mid-span above the critical size: the first mode creeps. The real roots of the
 * characteristic equation sinh g + eta sinh(g/2)^2 = 0: tanh(g/2) = -2/eta. */
static void overdamped(void)
{
	const double eps = tension/light.EA, l = 1.0/(1.0 + eps), k = sqrt(l), eta = 6.0;
	struct hawser_attachment at = {.at = 0.5, .damper = {0, 0, eta*k*sqrt(light.rho*tension)}};
	struct hawser_damped damped;
	struct hawser_statics st;

	if (!solve(&damped, &st, &light, HAWSER_GIVEN_H, tension, &at, 1, NULL, 6))
		return;
	ok(damped.overdamped == 1, "one motion creeps: %d", damped.overdamped);
	close_to(damped.slowest*l/k, -2.0*atanh(2.0/eta), 1e-10, "its rate");
	hawser_damped_clear(&damped);
}

static void refusals(void)
{
	struct hawser_scene scene = {.cable = {.EA = light.EA, .rho = light.rho},
	                             .span = {light.d, 0.0}, .g = light.g,
	                             .tension = {HAWSER_GIVEN_H, tension, HAWSER_BRANCH_TAUT,
	                                         (enum hawser_state)0}, .attachments = 2,
	                             .attach = {{.at = 0.1, .damper = {0, 0, 1.0}},
	                                        {.at = 0.2, .mass = 1.0}}};
	double place[] = {0.2, 0.3};
	struct hawser_damped_sweep_options options = {.key = "attach.0.at", .value = place,
	                                              .points = 2, .modes = {.n = 2}};
	struct hawser_damped_sweep sweep;
	struct hawser_damped_options one = {.n = 0};
	struct hawser_damped damped;
	struct hawser_statics st;

	ok(hawser_damped_trace(&sweep, &scene, &options, &report) != HAWSER_OK &&
	   strstr(report.message, "at attach.0.at = 0.2: "), "a failing point is named: %s",
	   report.message);
	options.points = 0;
	ok(hawser_damped_trace(&sweep, &scene, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "sweep of 0 points"), "%s", report.message);
	options.points = 2;
	place[1] = INFINITY;
	ok(hawser_damped_trace(&sweep, &scene, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "finite numbers"), "%s", report.message);
	if (!ok(!hawser_statics_scene(&st, &scene, &report), "statics"))
		return;
	ok(hawser_damped_solve(&damped, &st, NULL, &one, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "at least one"), "%s", report.message);
	one.n = 3;
	scene.attach[0].absorber_mass = scene.attach[0].absorber_stiffness = 1.0;
	ok(hawser_statics_scene(&st, &scene, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "without direction"), "%s", report.message);
	scene.attach[0].absorber_direction[1] = 1.0;
	ok(!hawser_statics_scene(&st, &scene, &report), "statics with an absorber");
	one.n = 2000;
	ok(hawser_damped_solve(&damped, &st, NULL, &one, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "are the most"), "%s", report.message);
	one = (struct hawser_damped_options){.n = 3, .tolerance = 2.0};
	ok(hawser_damped_solve(&damped, &st, NULL, &one, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "tolerance"), "%s", report.message);
}

CASE(property_modes_damped)
{
	string(0.02, 15.0, 0.0, 0.0);
	string(0.37, 2.385, 0.0, 0.0);
	string(0.05, 1e4, 0.0, 0.0);
	string(0.12, 3.1, 0.4, 7.3);
	absorber(0.47, 0.02, 0.02*9.0, 0.004);
	absorber(0.31, 0.4, 5.0, 0.0);
	absorber(0.08, 0.05, 0.05*40.0, 0.31);
	tuned(0.01);
	tuned(0.002);
	if (getenv("HAWSER_LONG"))
		optimum(0.01);
	optimum(0.05);
	uniform();
	against_chain();
	overdamped();
	refusals();
	return done_testing();
}
