/* Models that are functions (hawser/plugin.h): Duffing's oscillator against the same model of a file;
 * a pendulum whose support moves, with its periods doubled,
	against GSL's integrator; and wrong derivatives,
 * which are refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <stdlib.h>

#include <hawser/branches.h>
#include <hawser/frf.h>
#include <hawser/plugin.h>

#include "tests/tap.h"

static struct hawser_report report;

/* --- two coupled oscillators; `wrong` spoils an entry --- */

static int wrong;

static int pair(double *a, double *by_u, double *by_v, double *by_omega, const double *u,
                const double *v, double tau, double omega, const double *p)
{
	a[0] = p[0]*omega*cos(tau) - 0.05*v[0] - u[0] - 0.1*u[0]*u[0]*u[0] - 0.2*u[0]*u[1];
	a[1] = -0.04*v[1] - 4.0*u[1] - 0.1*u[0]*u[0];
	if (wrong == 4 && !by_u)
		a[1] += 0.1;
	if (!by_u)
		return wrong == 5;
	by_u[0] = -1.0 - 0.3*u[0]*u[0] - 0.2*u[1] + (wrong == 1 ? 1e-4 : 0.0);
	by_u[1] = -0.2*u[0];
	by_u[2] = -0.2*u[0];
	by_u[3] = -4.0;
	by_v[0] = -0.05;
	by_v[3] = wrong == 2 ? 0.04 : -0.04;
	by_omega[0] = wrong == 3 ? 0.0 : p[0]*cos(tau);
	return wrong == 5;
}

/* --- a pendulum: u'' + 0.1 u' + (1 + 3 F cos tau) sin u = 0.2 cos tau --- */

static int pendulum(double *a, double *by_u, double *by_v, double *by_omega, const double *u,
                    const double *v, double tau, double omega, const double *p)
{
	(void)omega;
	(void)by_omega;
	a[0] = 0.2*cos(tau) - 0.1*v[0] - (1.0 + 3.0*p[0]*cos(tau))*sin(u[0]);
	if (by_u) {
		by_u[0] = -(1.0 + 3.0*p[0]*cos(tau))*cos(u[0]);
		by_v[0] = -0.1;
	}
	return 0;
}

static const char *const names[] = {"F", "2F"};
static const double values[] = {0.18};

static struct hawser_plugin plugin_of(int n, int (*function)(double *, double *, double *, double *,
                                      const double *, const double *, double, double, const double *))
{
	return (struct hawser_plugin){HAWSER_PLUGIN_VERSION, n, 1, names, values, function, NULL};
}

static void check_refusals(void)
{
	static const char *const said[] = {NULL, "by_u[0][0] of its function", "by_v[1][1] of its function",
		"by_omega[0] of its function", "the acceleration with derivatives of its function",
		"has no value at rest"};
	struct hawser_plugin plugin = plugin_of(2, pair);
	struct hawser_rom_source source;
	struct hawser_rom rom;
	int known;

	for (wrong = 1; wrong <= 5; wrong++) {
		ok(!hawser_rom_source_plugin(&source, &plugin, "pair", &report), "a function");
		ok(hawser_rom_source_model(&rom, &source, &report) && strstr(report.message, said[wrong]), "%s",
		   report.message);
		hawser_rom_source_clear(&source);
	}
	wrong = 0;
	plugin.version = 3;
	ok(hawser_rom_source_plugin(&source, &plugin, "pair", &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "of version 3"), "%s", report.message);
	plugin = plugin_of(0, pair);
	ok(hawser_rom_source_plugin(&source, &plugin, "pair", &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "0 coordinates"), "%s", report.message);
	plugin = plugin_of(2, pair);
	plugin.parameter = names + 1;
	ok(hawser_rom_source_plugin(&source, &plugin, "pair", &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "has the name \"2F\""), "%s", report.message);
	plugin = plugin_of(2, pair);
	plugin.value = NULL;
	ok(hawser_rom_source_plugin(&source, &plugin, "pair", &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "no list of their names or of their values"), "%s", report.message);
	ok(hawser_rom_source_plugin(&source, NULL, "pair", &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "returned no struct hawser_plugin"), "%s", report.message);
	plugin = plugin_of(2, pair);
	ok(!hawser_rom_source_plugin(&source, &plugin, "pair", &report) &&
	   !hawser_rom_source_model(&rom, &source, &report), "right");
	hawser_rom_source_set(&source, "G", 1.0, &known);
	ok(!known, "it has no G");
	ok(hawser_rom_text(&rom, &(char *){NULL}, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "a reduced-model file takes models with D, K, "
	          "Q and C only; this one is a"),
	   "%s", report.message);
	hawser_rom_clear(&rom);
	hawser_rom_source_clear(&source);
}

/* The same as a file, made here. */
static void fill_pair(struct hawser_rom *rom)
{
	static const struct hawser_quad Q[] = {{0, 0, 1, 0.2}, {1, 0, 0, 0.1}};
	static const struct hawser_cubic C[] = {{0, 0, 0, 0, 0.1}};

	*rom = (struct hawser_rom){.n = 2, .quads = 2, .cubics = 1, .harmonics = 1, .length = 1.0,
		.time = 1.0, .force = 1.0, .K = calloc(4, sizeof(double)), .D = calloc(4, sizeof(double)),
		.Q = malloc(sizeof Q), .C = malloc(sizeof C), .harmonic = calloc(1, sizeof *rom->harmonic)};
	memcpy(rom->Q, Q, sizeof Q);
	memcpy(rom->C, C, sizeof C);
	rom->K[0] = 1.0;
	rom->K[3] = 4.0;
	rom->D[0] = 0.05;
	rom->D[3] = 0.04;
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .omega_power = 1, .f = calloc(2,
	                                                                                  sizeof(double))};
	rom->harmonic[0].f[0] = 0.18;
}

static void check_same(void)
{
	struct hawser_frf_options options = {.from = 0.7, .to = 2.2, .method = "shooting"};
	const struct hawser_plugin plugin = plugin_of(2, pair);
	struct hawser_rom_source source;
	struct hawser_rom rom[2];
	struct hawser_frf frf[2];
	double worst = 0.0, apart = 0.0;

	fill_pair(&rom[0]);
	ok(!hawser_rom_compile(&rom[0], &report) &&
	   !hawser_rom_source_plugin(&source, &plugin, "pair", &report) &&
	   !hawser_rom_source_model(&rom[1], &source, &report), "two models");
	for (int i = 0; i < 2; i++)
		ok(!hawser_frf_trace(&frf[i], &rom[i], &options, &report), "a response");
	for (int e = 0; e < frf[0].events && e < frf[1].events; e++)
		worst = fmax(worst, fabs(frf[0].event[e].omega/frf[1].event[e].omega - 1.0) +
		                    (frf[0].event[e].kind != frf[1].event[e].kind));
	ok(frf[0].events == frf[1].events && frf[0].events >= 2 && worst < 1e-9, "%d events, "
	   "the same to %.1e",
	   frf[0].events, worst);
	for (int p = 10; p < frf[0].points; p += 40) {
		struct hawser_frf_options at = {.from = frf[0].point[p].omega, .to = 3.0, .max_points = 1,
			.tolerance = 1e-12, .skip_events = 1, .start = frf[0].state + 4*(size_t)p,
			.method = "shooting"};
		struct hawser_frf one[2];

		for (int i = 0; i < 2; i++)
			ok(!hawser_frf_trace(&one[i], &rom[i], &at, &report), "at %g", at.from);
		for (int i = 0; i < 4; i++)
			apart = fmax(apart, fabs(one[0].state[i] - one[1].state[i]) +
			                    fabs(one[0].multiplier[2*i] - one[1].multiplier[2*i]));
		for (int i = 0; i < 2; i++)
			hawser_frf_clear(&one[i]);
	}
	ok(apart < 1e-10, "states and multipliers at some frequencies, the same to %.1e", apart);
	for (int i = 0; i < 2; i++) {
		hawser_frf_clear(&frf[i]);
		hawser_rom_clear(&rom[i]);
	}
	hawser_rom_source_clear(&source);
}

static int by_gsl(double t, const double *y, double *f, void *omega)
{
	double tau = *(double *)omega*t;

	f[0] = y[1];
	f[1] = 0.2*cos(tau) - 0.1*y[1] - (1.0 + 0.54*cos(tau))*sin(y[0]);
	return GSL_SUCCESS;
}

/* Distance from the state x [2] after `periods` of the load. */
static double away(const double *x, double omega, int periods)
{
	gsl_odeiv2_system system = {by_gsl, NULL, 2, &omega};
	gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3,
	                                                          1e-13, 1e-13);
	double y[2] = {x[0], x[1]}, t = 0.0;

	gsl_odeiv2_driver_apply(driver, &t, 2.0*M_PI/omega*periods, y);
	gsl_odeiv2_driver_free(driver);
	return hypot(y[0] - x[0], y[1] - x[1]);
}

static void check_pendulum(void)
{
	struct hawser_frf_options options = {.from = 2.4, .to = 1.5};
	const struct hawser_plugin plugin = plugin_of(1, pendulum);
	struct hawser_rom_source source;
	struct hawser_frf frf, branch;
	struct hawser_rom rom;
	double worst = 0.0, least = INFINITY;
	int doubling = -1;

	ok(!hawser_rom_source_plugin(&source, &plugin, "pendulum", &report) &&
	   !hawser_rom_source_model(&rom, &source, &report), "a pendulum");
	ok(!hawser_frf_trace(&frf, &rom, &options, &report), "its response");
	for (int p = 0; p < frf.points; p += 1 + frf.points/8)
		worst = fmax(worst, away(frf.state + 2*(size_t)p, frf.point[p].omega, 1));
	ok(worst < 1e-8, "GSL returns to its orbits: %.1e", worst);
	for (int e = frf.events - 1; e >= 0; e--)
		if (frf.event[e].kind == HAWSER_PERIOD_DOUBLING)
			doubling = e;
	if (ok(doubling >= 0, "a period doubling") &&
	    ok(!hawser_branch_switch(&branch, &rom, &frf, doubling, &options, &report), "its branch")) {
		worst = 0.0;
		for (int p = 5; p < branch.points; p += 1 + branch.points/8) {
			worst = fmax(worst, away(branch.state + 2*(size_t)p, branch.point[p].omega, 2));
			least = fmin(least, away(branch.state + 2*(size_t)p, branch.point[p].omega, 1));
		}
		ok(branch.period == 2 && worst < 1e-7 && least > 1e-3,
		   "after two periods GSL returns to %.1e, after one not: %.1e", worst, least);
		hawser_frf_clear(&branch);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_rom_source_clear(&source);
}

/* --- equations of first order: the Brusselator, x' = 1 - (B+1) x + x^2 y, y' = B x - x^2 y --- */

static int brusselator(double *rate, double *by_u, double *bend, const double *u, const double *v,
                       const double *p)
{
	double x = u[0], y = u[1];

	rate[0] = 1.0 - (p[0] + 1.0)*x + x*x*y;
	rate[1] = p[0]*x - x*x*y;
	by_u[0] = 2.0*x*y - p[0] - 1.0;
	by_u[1] = x*x;
	by_u[2] = p[0] - 2.0*x*y;
	by_u[3] = -x*x;
	bend[0] = 2.0*(y*v[0] + x*v[1]);
	bend[1] = 2.0*x*v[0];
	bend[2] = wrong ? 0.0 : -bend[0];
	bend[3] = -bend[1];
	return 0;
}

/* Its Hopf point B = 2, and the period at B = 3, by collocation. */
static void check_first_order(void)
{
	static const double first[] = {1.0};
	static const char *const name[] = {"B"};
	const struct hawser_plugin plugin = {HAWSER_PLUGIN_VERSION, 2, 1, name, first, NULL, brusselator};
	struct hawser_rom_source source;
	struct hawser_rom_family family = {.context = NULL};
	struct hawser_frf_options options = {.from = 1.0, .to = 3.0, .family = &family,
		.tolerance = 1e-11};
	struct hawser_frf frf = {.n = 0}, cycles = {.n = 0};
	const struct hawser_rom *rom;
	struct hawser_rom spoilt;
	enum hawser_status status = hawser_rom_source_plugin(&source, &plugin, "brusselator", &report);

	wrong = 1;
	ok(!status && hawser_rom_source_model(&spoilt, &source, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "by_u["), "%s", report.message);
	wrong = 0;
	status = hawser_parameter_open(&family, &source, "B", 0.0, &report);
	if (!status)
		status = family.model(family.context, &rom, 1.0, &report);
	ok(!status && hawser_rom_autonomous(rom), "nothing excites it %s", report.message);
	if (!status)
		status = hawser_frf_trace(&frf, rom, &options, &report);
	if (ok(!status && frf.events == 1 && frf.event[0].kind == HAWSER_HOPF, "a Hopf point %s",
	       report.message)) {
		ok(fabs(frf.event[0].parameter - 2.0) < 1e-9 && fabs(frf.event[0].omega - 1.0) < 1e-9,
		   "at B = 2, of frequency 1");
		status = hawser_branch_switch(&cycles, rom, &frf, 0, &options, &report);
		ok(!status && fabs(2.0*M_PI/cycles.point[cycles.points - 1].omega/7.156919921180 - 1.0) < 1e-9,
		   "the period of its cycle at B = 3 %s", report.message);
	}
	hawser_frf_clear(&cycles);
	hawser_frf_clear(&frf);
	hawser_parameter_close(&family);
	hawser_rom_source_clear(&source);
}

CASE(property_plugin)
{
	gsl_set_error_handler_off();
	check_refusals();
	check_same();
	check_pendulum();
	check_first_order();
	return done_testing();
}
