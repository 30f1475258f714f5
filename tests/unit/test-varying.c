/* Quadratic terms that vary with the phase, and constant terms, of harmonics: the acceleration and its
 * derivatives by differences; orbits by harmonic balance, shooting and integration; the same orbit
 * after a change of coordinates that creates such terms; factors of the load.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>

#include "response/orbit/load.h"
#include "rom/build/model.h"
#include "tests/tap.h"

enum { N = 2 };

static double *copy(const double *from, size_t count)
{
	double *to = malloc(count*sizeof *to);

	return to ? memcpy(to, from, count*sizeof *to) : NULL;
}

static int model(struct hawser_rom *rom)
{
	static const struct hawser_quad Q[] = {{0, 0, 1, 0.31}, {0, 1, 1, -0.2}, {1, 0, 0, 0.155}};
	static const struct hawser_cubic C[] = {{0, 0, 0, 0, 0.4}, {1, 0, 1, 1, 0.21}};
	static const struct hawser_quad varying[] = {{0, 0, 0, 0.12}, {0, 0, 1, -0.14}, {1, 1, 1, 0.1},
		{1, 0, 0, -0.07}};
	static const double K[] = {1.0, 0.1, 0.1, 2.385}, D[] = {0.05, 0.0, 0.0, 0.07};

	if (hawser__rom_init(rom, N, NULL))
		return 0;
	memcpy(rom->K, K, sizeof K);
	memcpy(rom->D, D, sizeof D);
	rom->Q = malloc(sizeof Q);
	rom->C = malloc(sizeof C);
	memcpy(rom->Q, Q, sizeof Q);
	memcpy(rom->C, C, sizeof C);
	rom->quads = 3;
	rom->cubics = 2;
	rom->harmonics = 4;
	rom->harmonic = calloc(4, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = copy((double[]){0.1, -0.06}, N)};
	rom->harmonic[1] = (struct hawser_harmonic){.k = 1, .phase = HAWSER_SIN,
		.K = copy((double[]){0.1, 0.03, 0.03, -0.12}, N*N), .quads = 4,
		.Q = malloc(sizeof varying)};
	memcpy(rom->harmonic[1].Q, varying, sizeof varying);
	rom->harmonic[2] = (struct hawser_harmonic){.k = 2, .load_power = 2, .quads = 1,
		.Q = malloc(sizeof varying)};
	rom->harmonic[2].Q[0] = (struct hawser_quad){1, 0, 1, -0.1};
	rom->harmonic[3] = (struct hawser_harmonic){.k = 0, .load_power = 2,
		.f = copy((double[]){0.04, 0.1}, N), .K = copy((double[]){0.2, 0.1, 0.1, 0.05}, N*N)};
	return ok(!hawser_rom_compile(rom, NULL), "a model with constant and varying terms");
}

static void check_derivatives(const struct hawser_rom *rom)
{
	double u[N] = {0.31, -0.43}, v[N] = {-0.2, 0.7}, a[N], by_u[N*N], by_v[N*N], by_omega[N];
	double plus[N], minus[N], h = 1e-3, worst = 0.0;
	const double tau = 0.7, s = sin(tau);
	/* equation 1 of the model, written out */
	double want = -0.05*v[0] - u[0] - 0.1*u[1] - 0.31*u[0]*u[1] + 0.2*u[1]*u[1] -
	              0.4*u[0]*u[0]*u[0] + 0.1*cos(tau) +
	              s*(-0.1*u[0] - 0.03*u[1] - 0.12*u[0]*u[0] + 0.14*u[0]*u[1]) +
	              0.04 - 0.2*u[0] - 0.1*u[1];

	hawser_rom_acceleration_jacobian(rom, a, by_u, by_v, by_omega, u, v, tau, 1.1);
	close_to(a[0], want, 1e-15, "the acceleration, written out");
	for (int k = 0; k < N; k++) {
		double keep = u[k];

		u[k] = keep + h;
		hawser_rom_acceleration(rom, plus, u, v, tau, 1.1);
		u[k] = keep - h;
		hawser_rom_acceleration(rom, minus, u, v, tau, 1.1);
		u[k] = keep;
		for (int j = 0; j < N; j++) /* cubic: the difference has an error of C h^2 */
			worst = fmax(worst, fabs((plus[j] - minus[j])/(2.0*h) - by_u[j*N + k]));
	}
	ok(worst < 5e-7, "its derivatives by differences: %.1e", worst);
}

/* State of the orbit at `omega` by a method. */
static int orbit(double state[2*N], struct hawser_frf_point *point, double multiplier[4*N],
                 const struct hawser_rom *rom, const char *method, double omega)
{
	struct hawser_frf_options options = {.method = method, .from = omega - 0.05, .to = omega,
		.tolerance = 1e-11, .samples = HAWSER_NONE};
	struct hawser_report report = {.message = ""};
	struct hawser_frf frf;
	enum hawser_status status = hawser_frf_trace(&frf, rom, &options, &report);

	if (!ok(!status && frf.points > 0, "%s at %g %s", method, omega, report.message))
		return 0;
	memcpy(state, frf.state + (size_t)(frf.points - 1)*2*N, 2*N*sizeof *state);
	memcpy(multiplier, frf.multiplier + (size_t)(frf.points - 1)*4*N, 4*N*sizeof *state);
	*point = frf.point[frf.points - 1];
	hawser_frf_clear(&frf);
	return 1;
}

static void check_orbits(const struct hawser_rom *rom)
{
	const double at[] = {0.55, 0.8, 1.35};
	double a[2*N], b[2*N], ma[4*N], mb[4*N], worst = 0.0, multipliers = 0.0;
	struct hawser_frf_point p, q;

	for (int i = 0; i < 3; i++) {
		struct hawser_integrate_options run = {.omega = at[i], .until = 2.0*M_PI/at[i],
			.every = 2.0*M_PI/at[i], .rtol = 1e-12, .atol = 1e-14, .initial = a};
		struct hawser_trajectory trajectory;

		if (!orbit(a, &p, ma, rom, "balance", at[i]) || !orbit(b, &q, mb, rom, "shooting", at[i]))
			return;
		for (int j = 0; j < 2*N; j++)
			worst = fmax(worst, fabs(a[j] - b[j]));
		for (int j = 0; j < 2*N; j++)
			multipliers = fmax(multipliers, fabs(ma[2*j] - mb[2*j]));
		ok(!hawser_integrate(&trajectory, rom, &run, NULL), "integrated over a period");
		for (int j = 0; j < 2*N; j++)
			worst = fmax(worst, fabs(trajectory.state[(size_t)(trajectory.rows - 1)*2*N +
			                                          (size_t)j] - a[j]));
		hawser_trajectory_clear(&trajectory);
		ok(p.liouville < 1e-8 && q.liouville < 1e-8, "Liouville: %.1e, %.1e", p.liouville,
		   q.liouville);
	}
	ok(worst < 2e-9, "balance, shooting and integration: %.1e", worst);
	ok(multipliers < 1e-7, "their multipliers: %.1e", multipliers);
}

/* x'' + d x' + x + q x^2 + c x^3 = 0 in the coordinate u = x - A cos(2 tau), the motion of a frame:
 * every kind of harmonic, constant ones too. The orbit of x with a force F cos(tau) is that of u. */
static void check_frame(void)
{
	const double d = 0.1, q = 0.4, c = 0.3, A = 0.21, F = 0.15, w = 0.7;
	struct hawser_rom fixed, moved;
	double x[2], u[2];
	struct hawser_frf_options options = {.from = w - 0.05, .to = w, .tolerance = 1e-11};
	struct hawser_frf a, b;
	int good;

	for (int i = 0; i < 2; i++) {
		struct hawser_rom *rom = i ? &moved : &fixed;

		if (hawser__rom_init(rom, 1, NULL))
			return;
		rom->K[0] = 1.0;
		rom->D[0] = d;
		rom->Q = malloc(sizeof *rom->Q);
		rom->C = malloc(sizeof *rom->C);
		rom->Q[0] = (struct hawser_quad){0, 0, 0, q};
		rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, c};
		rom->quads = rom->cubics = 1;
		rom->harmonic = calloc(7, sizeof *rom->harmonic);
		rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = copy(&F, 1)};
		rom->harmonics = 1;
	}
	moved.harmonics = 7;
	moved.harmonic[1] = (struct hawser_harmonic){.k = 2, .quads = 1,
		.f = copy((double[]){-A - 0.75*c*A*A*A}, 1), .K = copy((double[]){2.0*q*A}, 1),
		.Q = malloc(sizeof(struct hawser_quad))};
	moved.harmonic[1].Q[0] = (struct hawser_quad){0, 0, 0, 3.0*c*A};
	moved.harmonic[2] = (struct hawser_harmonic){.k = 2, .omega_power = 2,
		.f = copy((double[]){4.0*A}, 1)};
	moved.harmonic[3] = (struct hawser_harmonic){.k = 2, .omega_power = 1, .phase = HAWSER_SIN,
		.f = copy((double[]){2.0*A*d}, 1)};
	moved.harmonic[4] = (struct hawser_harmonic){.k = 0, .f = copy((double[]){-0.5*q*A*A}, 1),
		.K = copy((double[]){1.5*c*A*A}, 1)};
	moved.harmonic[5] = (struct hawser_harmonic){.k = 4, .f = copy((double[]){-0.5*q*A*A}, 1),
		.K = copy((double[]){1.5*c*A*A}, 1)};
	moved.harmonic[6] = (struct hawser_harmonic){.k = 6,
		.f = copy((double[]){-0.25*c*A*A*A}, 1)};
	for (int method = 0; method < 2; method++) {
		options.method = method ? "shooting" : "balance";
		good = !hawser_rom_compile(&fixed, NULL) && !hawser_rom_compile(&moved, NULL) &&
		       !hawser_frf_trace(&a, &fixed, &options, NULL);
		if (!ok(good && !hawser_frf_trace(&b, &moved, &options, NULL), "both frames"))
			return;
		memcpy(x, a.state + 2*(a.points - 1), sizeof x);
		memcpy(u, b.state + 2*(b.points - 1), sizeof u);
		ok(fabs(u[0] + A - x[0]) < 1e-9 && fabs(u[1] - x[1]) < 1e-9,
		   "%s: the same motion in the moving frame: %.1e, %.1e", options.method,
		   u[0] + A - x[0], u[1] - x[1]);
		close_to(b.multiplier[4*(b.points - 1)], a.multiplier[4*(a.points - 1)], 1e-7,
		         "multiplier");
		hawser_frf_clear(&a);
		hawser_frf_clear(&b);
	}
	hawser_rom_clear(&fixed);
	hawser_rom_clear(&moved);
}

static void check_load(const struct hawser_rom *rom)
{
	struct hawser__load load;
	double a[N], b[N], u[N] = {0.3, 0.2}, v[N] = {0.1, -0.4};
	double rate = 0.0, h = 1e-4;

	if (!ok(!hawser__load_open(&load, rom, NULL), "a model with a factor"))
		return;
	hawser__load_set(&load, 0.6);
	ok(load.rom.harmonic[1].Q[2].value == 0.6*rom->harmonic[1].Q[2].value &&
	   load.rom.harmonic[3].f[0] == 0.6*0.6*rom->harmonic[3].f[0],
	   "the factor, and its square");
	hawser__load_set(&load, 0.6 + h);
	hawser_rom_acceleration(&load.rom, a, u, v, 0.4, 1.2);
	hawser__load_set(&load, 0.6 - h);
	hawser_rom_acceleration(&load.rom, b, u, v, 0.4, 1.2);
	for (int i = 0; i < 4; i++) {
		const struct hawser_harmonic *x = &rom->harmonic[i];
		double wave = x->phase == HAWSER_SIN ? sin(x->k*0.4) : cos(x->k*0.4), sum = 0.0;

		for (int k = 0; k < N; k++)
			sum -= x->K ? x->K[k]*u[k] : 0.0;
		for (int e = 0; e < x->quads; e++)
			sum -= x->Q[e].j == 0 ? x->Q[e].value*u[x->Q[e].k]*u[x->Q[e].l] : 0.0;
		rate += hawser__load_rate(x, 0.6)*wave*(sum + (x->f ? x->f[0] : 0.0));
	}
	close_to((a[0] - b[0])/(2.0*h), rate, 1e-10, "the rate by differences");
	hawser__load_clear(&load);
}

CASE(unit_varying)
{
	struct hawser_rom rom;

	if (model(&rom)) {
		check_derivatives(&rom);
		check_orbits(&rom);
		check_load(&rom);
	}
	hawser_rom_clear(&rom);
	check_frame();
	return done_testing();
}
