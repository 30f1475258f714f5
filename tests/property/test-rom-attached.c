/* Reduced models of a cable with attachments: a damper near the end of a stay by its characteristic
 * equation, forces and condensation against models that share no code with them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <lapacke.h>
#include <stdlib.h>

#include <hawser/damped.h>
#include <hawser/rom.h>

#include "tests/rom-eigenvalue.h"
#include "tests/rom-entries.h"
#include "tests/tap.h"

static struct hawser_report report;
static const struct hawser_held *held; /* [2]; NULL: rigid ends */

/* --- a damper on a taut string: with g = lambda l/k and eta the damper relative to the impedance of
 * the string, sinh g + eta sinh(a g) sinh((1 - a) g) = 0 --- */

/* The same on elastic ends, whose stiffness with inertia is K = kappa + m g^2/l over H/d: with
 * u = g cosh(g x) + K_A sinh(g x) from end A, v likewise from end B, u'/u + v'/v + eta g = 0. */
static double complex on_springs(double complex g, double a, double eta, double l)
{
	double complex u[2], slope[2];

	for (int end = 0; end < 2; end++) {
		double x = end ? 1.0 - a : a;
		double complex K = held[end].stiffness[2] + held[end].m*g*g/l;

		u[end] = g*ccosh(g*x) + K*csinh(g*x);
		slope[end] = g*(g*csinh(g*x) + K*ccosh(g*x));
	}
	return slope[0]*u[1] + u[0]*slope[1] + eta*g*u[0]*u[1];
}

static double complex root_of(double complex g, double a, double eta, double l)
{
	for (int i = 0; held && i < 60; i++) {
		double complex h = 1e-6*g, f = on_springs(g, a, eta, l);

		g -= f/((on_springs(g + h, a, eta, l) - on_springs(g - h, a, eta, l))/(2.0*h));
	}
	if (held)
		return g;
	for (int i = 0; i < 60; i++) {
		double complex low = csinh(a*g), high = csinh((1.0 - a)*g);
		double complex f = csinh(g) + eta*low*high;
		double complex slope = ccosh(g) + eta*(a*ccosh(a*g)*high + (1.0 - a)*low*ccosh((1.0 - a)*g));

		g -= f/slope;
	}
	return g;
}

static int solve(struct hawser_modes *modes, const struct hawser_span *span, double H,
                 const struct hawser_attachment *attach, int count, int n)
{
	const struct hawser_modes_options options = {.n = n};
	struct hawser_statics st;

	if (!hawser_statics_loaded(&st, span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, attach, count,
	                           &report) &&
	    (!held || !hawser_statics_hold(&st, held, &report)) &&
	    !hawser_modes_solve(modes, &st, &options, &report))
		return 1;
	return ok(0, "solved: %s", report.message);
}

/* Damping ratio of out-of-plane mode `number` of a stay, and its error relative to the largest one
 * possible; *frequency: the error of the eigenvalue. */
static double stay(double *error, double *frequency, double a, double eta, int number, int n)
{
	const struct hawser_span span = {1e11, 1.0, 9.81, 1.0, 0.0};
	const double H = 1e6, l = 1.0/(1.0 + H/span.EA), k = sqrt(l);
	static struct hawser_held actual[2], scaled[2];
	struct hawser_attachment damper = {.at = a, .damper = {0, 0, eta*sqrt(span.rho*H)*k}};
	const struct hawser_scene scene = {.model = {.modes = n}};
	double complex exact, g = I*M_PI*number, found;
	struct hawser_modes modes;
	struct hawser_rom rom;

	*error = *frequency = INFINITY;
	for (int end = 0; held && end < 2; end++) {
		scaled[end] = actual[end] = held[end];
		for (int c = 0; c < 3; c++)
			actual[end].stiffness[c] *= H/span.d;
		actual[end].mass = held[end].m*span.rho*span.d;
	}
	held = held ? actual : NULL;
	if (!solve(&modes, &span, H, &damper, 1, n))
		return 0.0;
	held = held ? scaled : NULL;
	for (int i = 0, out = 0; held && i < modes.n && out < number; i++)
		if (modes.mode[i].plane == HAWSER_OUT_OF_PLANE && ++out == number)
			g = I*modes.mode[i].omega*k;
	for (int i = 1; i <= 20; i++) /* from the undamped string */
		g = root_of(g, a, eta*i/20.0, l);
	exact = g*k/l;
	if (!hawser_rom_build_linear(&rom, &modes, &scene, &report)) {
		found = eigenvalue(&rom, exact);
		*error = fabs(creal(found)/cabs(found) - creal(exact)/cabs(exact))/(0.5*a);
		*frequency = cabs(found - exact)/cabs(exact);
		hawser_rom_clear(&rom);
	} else {
		ok(0, "a stay: %s", report.message);
	}
	hawser_modes_clear(&modes);
	return -creal(exact)/cabs(exact);
}

/* The optimal damper of a stay has the modal damping a/2 (a: distance from the end over the length),
 * at eta = 1/(pi a number): Pacheco, Fujino, Sulekh, J. Struct. Eng. 119 (1993) 1961; Krenk, J. Appl.
 * Mech. 67 (2000) 772. */
static void dampers(void)
{
	for (int number = 1; number <= 2; number++)
		for (int i = 0; i < 3; i++) {
			double a = 0.01*(1 + 2*i), worst = 0.0, off = 0.0, most = 0.0, error, frequency;

			for (double size = 0.25; size < 5.0; size *= 1.3) {
				most = fmax(most, stay(&error, &frequency, a, size/(M_PI*a*number), number, 12));
				worst = fmax(worst, error);
				off = fmax(off, frequency);
			}
			ok(fabs(most/(0.5*a) - 1.0) < 3.0*a*number, "damper at %g, mode %d: largest damping ratio "
			   "%.5g, a/2 = %.5g", a, number, most, 0.5*a);
			ok(worst < 1e-3 && off < 3e-5, "12 modes and a shape: damping within %.1e of the largest, "
			   "eigenvalue within %.1e", worst, off);
		}
}

/* The error falls with the number of modes. */
static void converges(void)
{
	double before = 1.0, error, frequency;

	for (int n = 4; n <= 32; n *= 2) {
		stay(&error, &frequency, 0.05, 6.0, 1, n);
		ok(frequency < before/3.0, "%d modes of both planes: %.1e", n, frequency);
		before = frequency;
	}
}

/* A damper of a stay on springs, whose ends have masses. */
static void dampers_on_springs(void)
{
	static const struct hawser_held ends[2] = {{{40.0, 30.0, 9.7}, 0.0, 0.031},
	                                           {{25.0, 70.0, 31.4}, 0.0, 0.0}};
	double worst = 0.0, off = 0.0, error, frequency;

	for (int number = 1; number <= 2; number++)
		for (int i = 0; i < 4; i++) {
			held = ends;
			(void)stay(&error, &frequency, 0.02 + 0.03*i, (0.31 + 0.4*i)/(0.02 + 0.03*i)/number,
			           number, 24);
			worst = fmax(worst, error);
			off = fmax(off, frequency);
		}
	held = NULL;
	ok(worst < 2e-4 && off < 5e-6, "on springs, 24 modes: damping within %.1e of a/2, eigenvalue "
	   "within %.1e", worst, off);
}

/* --- forces --- */

static const struct hawser_span inclined = {4e7, 6.0, 9.81, 250.0, -61.7};
static const struct hawser_attachment carriers[] = {
	{.at = 0.13, .mass = 300.0, .spring = {1e3, 2e4, 500.0}},
	{.at = 0.62, .mass = 1000.0}};
static const struct hawser_held ends[2] = {{{7e3, 2e4, 900.0}, 150.0, 0.0},
                                           {{INFINITY, 3.1e4, 5e3}, 0.0, 0.0}};

/* Restoring forces of the expansion and of the exact energy differ by the fourth order. */
static void expansion(void)
{
	const struct hawser_scene scene = {.model = {.modes = 6, .condense = HAWSER_CONDENSE_NONE}};
	struct hawser_modes modes;
	struct hawser_rom quartic, exact;
	double difference[2] = {0.0}, u[6], v[6] = {0.0}, f[6], g[6];

	if (!solve(&modes, &inclined, 4e4, carriers, 2, 6))
		return;
	if (!ok(!hawser_rom_build(&quartic, &modes, &scene, &report) &&
	        !hawser_rom_build_exact(&exact, &modes, &scene, &report), "built: %s", report.message))
		return;
	for (int i = 0; i < 2; i++) {
		for (int j = 0; j < 6; j++)
			u[j] = 2e-5*(i + 1)*(1.0 - 0.3*j);
		hawser_rom_restoring(&quartic, f, u);
		hawser_rom_restoring(&exact, g, u);
		for (int j = 0; j < 6; j++)
			difference[i] = fmax(difference[i], fabs(f[j] - g[j]));
	}
	ok(fabs(log2(difference[1]/difference[0]) - 4.0) < 0.1, "with springs, expanded and exact forces "
	   "differ in order %.3f", log2(difference[1]/difference[0]));
	close_to(hawser_rom_energy(&exact, u, v), hawser_rom_energy(&quartic, u, v), 1e-3, "energies");
	hawser_rom_clear(&quartic);
	hawser_rom_clear(&exact);
	hawser_modes_clear(&modes);
}

/* The cubic term of one mode with the others condensed: by the closed form, and by elimination of the
 * other modes of a basis, C - sum of Q_0^0s Q_s^00 over their stiffness. */
static void condensation(double springs)
{
	const struct hawser_scene raw = {.model = {.modes = 1, .condense = HAWSER_CONDENSE_NONE}};
	const struct hawser_scene condensed = {.model = {.modes = 1}};
	struct hawser_attachment masses[2] = {carriers[0], carriers[1]};
	struct hawser_modes modes, all;
	struct hawser_rom one, many;

	for (int c = 0; c < 3; c++)
		masses[0].spring[c] *= springs;
	masses[1].spring[0] = 700.0*springs;
	if (!solve(&modes, &inclined, 4e4, masses, 2, 1))
		return;
	if (!ok(!hawser_modes_basis(&all, &modes.statics, 20, 20, &report) &&
	        !hawser_rom_build(&one, &modes, &condensed, &report) &&
	        !hawser_rom_build(&many, &all, &raw, &report), "built: %s", report.message))
		return;
	close_to(cubic_of(&one, 0, 0, 0, 0), condensed_cubic(&many, 0), 1e-7,
	         springs > 0.0 ? "and with springs" : "the condensed cubic term of mode 1");
	hawser_rom_clear(&one);
	hawser_rom_clear(&many);
	hawser_modes_clear(&all);
	hawser_modes_clear(&modes);
}

/* A model with springs and dampers has the eigenvalues of the exact linear problem (damped.h). */
static void springs_and_dampers(void)
{
	const struct hawser_scene scene = {.damping = {.kind = HAWSER_DAMPING_ALPHA, .alpha = 0.2},
	                                   .model = {.modes = 14}};
	struct hawser_attachment attach[2] = {carriers[0], carriers[1]};
	const struct hawser_damped_options options = {.n = 3};
	struct hawser_damped exact;
	struct hawser_modes modes;
	struct hawser_rom rom;

	attach[0].damper[1] = 4e3;
	attach[1].damper[2] = 2385.0;
	if (!solve(&modes, &inclined, 4e4, attach, 2, 14))
		return;
	if (!ok(!hawser_damped_solve(&exact, &modes.statics, &scene, &options, &report) &&
	        !hawser_rom_build(&rom, &modes, &scene, &report), "built: %s", report.message))
		return;
	for (int i = 0; i < exact.n; i++) {
		double complex root = exact.mode[i].re + I*exact.mode[i].omega;
		double complex found = eigenvalue(&rom, root);

		ok(cabs(found - root) < 1e-5*cabs(root) && exact.mode[i].ratio > 1e-3,
		   "springs and dampers: %.6g + %.6gi, exact %.6g + %.6gi", creal(found), cimag(found),
		   creal(root), cimag(root));
	}
	hawser_rom_clear(&rom);
	hawser_damped_clear(&exact);
	hawser_modes_clear(&modes);
}

/* alpha acts on the cable and not on the point masses: v D v is alpha times the integral of the square
 * of the velocity. */
static void viscous(void)
{
	const double alpha = 0.3;
	const struct hawser_scene scene = {.damping = {.kind = HAWSER_DAMPING_ALPHA, .alpha = alpha},
	                                   .model = {.modes = 3}};
	struct hawser_attachment mass = carriers[1];
	struct hawser_modes modes;
	struct hawser_rom rom;
	double worst = 0.0;

	if (!solve(&modes, &inclined, 4e4, &mass, 1, 3))
		return;
	if (!ok(!hawser_rom_build_linear(&rom, &modes, &scene, &report), "built: %s", report.message))
		return;
	for (int j = 0; j < 3; j++)
		for (int k = 0; k < 3; k++) {
			double sum = 0.0;

			for (int p = 0; p < modes.grid.points; p++)
				for (int c = 0; c < 3; c++)
					sum += modes.grid.weight[p]*modes.shape[3*(j*modes.grid.points + p) + c]*
					       modes.shape[3*(k*modes.grid.points + p) + c];
			worst = fmax(worst, fabs(rom.D[3*j + k] - sum*alpha*modes.time_unit/inclined.rho));
		}
	ok(worst < 1e-13, "alpha acts on the cable only: %.1e", worst);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

static void refusals(void)
{
	struct hawser_scene scene = {.model = {.modes = 3}};
	struct hawser_attachment attach[2] = {carriers[0], carriers[1]};
	struct hawser_modes modes;
	struct hawser_rom rom;

	attach[1].damper[1] = 100.0;
	if (!solve(&modes, &inclined, 4e4, attach + 1, 1, 3))
		return;
	scene.model.modes = HAWSER_MODES_AUTO;
	ok(hawser_rom_build(&rom, &modes, &scene, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "number of modes"), "%s", report.message);
	hawser_modes_clear(&modes);
}

CASE(property_rom_attached)
{
	dampers();
	converges();
	expansion();
	condensation(0.0);
	condensation(1.0);
	condensation(1e7);
	springs_and_dampers();
	viscous();
	refusals();
	dampers_on_springs();
	held = ends;
	expansion();
	condensation(0.0);
	condensation(1.0);
	condensation(1e7);
	springs_and_dampers();
	return done_testing();
}
