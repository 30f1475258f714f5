/* The compiled kernel against the definition in rom.h, term by term; its tangent against central
 * differences; energy against work; merging; every error of hawser_rom_compile.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "rom/energy/kernel.h"
#include "rom/build/model.h"
#include "rom/terms/terms.h"
#include "tests/tap.h"

static double uniform(void)
{
	return 2.0*rand()/RAND_MAX - 1.0;
}

/* Random lists, unsorted and with repeats. potential: gradient of random cubic and quartic forms.
 * */
static int random_model(struct hawser_rom *rom, int n, int potential)
{
	struct hawser_report report;
	int quads = 4*n*n, cubics = 5*n*n;

	if (hawser__rom_init(rom, n, &report))
		return 0;
	rom->Q = calloc((size_t)quads*3, sizeof *rom->Q);
	rom->C = calloc((size_t)cubics*4, sizeof *rom->C);
	for (int j = 0; j < n; j++)
		for (int k = 0; k <= j; k++) {
			rom->K[j*n + k] = rom->K[k*n + j] = uniform() + (j == k ? n : 0);
			rom->D[j*n + k] = uniform();
		}
	for (int i = 0; i < quads; i++) {
		int a = rand()%n, b = rand()%n, c = rand()%n;
		double v = uniform();

		rom->Q[rom->quads++] = (struct hawser_quad){a, b, c, v};
		if (potential) {
			rom->Q[rom->quads++] = (struct hawser_quad){b, a, c, v};
			rom->Q[rom->quads++] = (struct hawser_quad){c, b, a, v};
		}
	}
	for (int i = 0; i < cubics; i++) {
		int a = rand()%n, b = rand()%n, c = rand()%n, d = rand()%n;
		double v = uniform();

		rom->C[rom->cubics++] = (struct hawser_cubic){a, b, c, d, v};
		if (potential) {
			rom->C[rom->cubics++] = (struct hawser_cubic){b, a, c, d, v};
			rom->C[rom->cubics++] = (struct hawser_cubic){c, b, a, d, v};
			rom->C[rom->cubics++] = (struct hawser_cubic){d, b, c, a, v};
		}
	}
	return 1;
}

/* The definition, in the order of the given entries. */
static void by_definition(const struct hawser_rom *rom, double *f, const double *u)
{
	int n = rom->n;

	for (int j = 0; j < n; j++) {
		f[j] = 0.0;
		for (int k = 0; k < n; k++)
			f[j] += rom->K[j*n + k]*u[k];
	}
	for (int i = 0; i < rom->quads; i++)
		f[rom->Q[i].j] += rom->Q[i].value*u[rom->Q[i].k]*u[rom->Q[i].l];
	for (int i = 0; i < rom->cubics; i++)
		f[rom->C[i].j] += rom->C[i].value*u[rom->C[i].k]*u[rom->C[i].l]*u[rom->C[i].m];
}

static double distance(const double *a, const double *b, int count)
{
	double worst = 0.0;

	for (int i = 0; i < count; i++)
		worst = fmax(worst, fabs(a[i] - b[i])/(1.0 + fabs(b[i])));
	return worst;
}

/* Many states in one call, for any number of states, and four side by side, give the same as single
 * calls. */
static void check_block(const struct hawser_rom *rom)
{
	enum { most = 19 };
	int n = rom->n;
	double u[most*12], force[most*12], tangent[most*144], one[12], slope[144], worst = 0.0;
	double lanes[12*HAWSER_LANES], *work = calloc(hawser__rom_tangents_work(rom, most) +
	                                              HAWSER_LANES_WORK((size_t)n), sizeof *work);

	for (int i = 0; i < most*n; i++)
		u[i] = uniform();
	for (int count = 1; work && count <= most; count += 3) {
		hawser__rom_tangents(rom, force, tangent, u, count, work);
		for (int i = 0; i < count; i++) {
			hawser_rom_tangent(rom, one, slope, u + i*n);
			worst = fmax(worst, distance(force + i*n, one, n));
			worst = fmax(worst, distance(tangent + i*n*n, slope, n*n));
		}
		hawser__rom_tangents(rom, force, NULL, u, count, work);
		for (int i = 0; i < count; i++) {
			hawser_rom_restoring(rom, one, u + i*n);
			worst = fmax(worst, distance(force + i*n, one, n));
		}
	}
	ok(worst < 1e-13, "n %d: many states in one call as one by one: %.1e", n, worst);
	worst = 0.0;
	for (int live = 1; work && live <= HAWSER_LANES; live++) {
		for (int i = 0; i < n*HAWSER_LANES; i++)
			lanes[i] = u[i%HAWSER_LANES*n + i/HAWSER_LANES];
		hawser__rom_lanes(rom, force, tangent, lanes, live, work);
		for (int i = 0; i < live*(n + n*n); i++) {
			int lane = i%live, e = i/live;

			hawser_rom_tangent(rom, one, slope, u + lane*n);
			worst = fmax(worst, e < n ? fabs(force[e*HAWSER_LANES + lane] - one[e])
			                          : fabs(tangent[(e - n)*HAWSER_LANES + lane] -
			                                 slope[e - n]));
		}
		hawser__rom_lanes(rom, force, NULL, lanes, live, work);
		for (int i = 0; i < live*n; i++) {
			hawser_rom_restoring(rom, one, u + i%live*n);
			worst = fmax(worst, fabs(force[i/live*HAWSER_LANES + i%live] - one[i/live]));
		}
	}
	ok(work && worst < 1e-12, "n %d: states side by side: %.1e", n, worst);
	free(work);
}

static void check_model(int n, int potential)
{
	struct hawser_rom rom;
	double u[12], up[12], want[12], force[12], tangent[144], fp[12], fm[12], fd[144], zero[12] = {0};
	const double h = 1e-5;

	random_model(&rom, n, potential);
	for (int j = 0; j < n; j++)
		u[j] = uniform();
	by_definition(&rom, want, u);
	ok(!hawser_rom_compile(&rom, NULL), "n %d: compiles", n);
	hawser_rom_restoring(&rom, force, u);
	ok(distance(force, want, n) < 1e-13, "n %d: restoring force as defined: %.1e", n,
	   distance(force, want, n));
	hawser_rom_tangent(&rom, force, tangent, u);
	ok(distance(force, want, n) < 1e-13, "n %d: the tangent's force too", n);
	for (int k = 0; k < n; k++) {
		memcpy(up, u, sizeof up);
		up[k] = u[k] + h;
		hawser_rom_restoring(&rom, fp, up);
		up[k] = u[k] - h;
		hawser_rom_restoring(&rom, fm, up);
		for (int j = 0; j < n; j++)
			fd[j*n + k] = (fp[j] - fm[j])/(2*h);
	}
	ok(distance(fd, tangent, n*n) < 1e-8, "n %d: tangent against differences: %.1e", n,
	   distance(fd, tangent, n*n));
	ok((hawser_rom_asymmetry(&rom) < 1e-13) == (potential || n == 1),
	   "n %d: asymmetry %.1e tells whether there is a potential", n, hawser_rom_asymmetry(&rom));
	for (int k = 0; potential && k < n; k++) {
		memcpy(up, u, sizeof up);
		up[k] = u[k] + h;
		fp[k] = hawser_rom_energy(&rom, up, zero);
		up[k] = u[k] - h;
		fp[k] = (fp[k] - hawser_rom_energy(&rom, up, zero))/(2*h);
	}
	if (potential)
		ok(distance(fp, force, n) < 1e-8, "n %d: the force is the gradient of the energy", n);
	check_block(&rom);
	for (int i = 0; i < rom.cubics; i++)
		rom.C[i].value *= potential ? 0.385 : uniform();
	rom.K[0] *= 1.7;
	rom.D[0] = 0.0;
	by_definition(&rom, want, u);
	ok(!hawser__rom_refill(&rom, NULL), "n %d: other values of the same entries", n);
	hawser_rom_restoring(&rom, force, u);
	ok(distance(force, want, n) < 1e-13, "n %d: and their force: %.1e", n, distance(force, want, n));
	check_block(&rom);
	hawser_rom_clear(&rom);
}

/* Terms of velocities, of which there are enough for matrices, against their definition: one state, as
 * many as lanes, and states of a period. */
static void check_rates(void)
{
	enum { n = 3, count = 50, states = 5 };
	struct hawser_rom rom;
	double v[states*n], u[states*n] = {0.0}, want[states*n] = {0.0}, slope[states*n*n] = {0.0};
	double force[states*n] = {0.0}, by_v[states*n*n] = {0.0}, lanes[3][n*n*HAWSER_LANES] = {{0.0}};
	double tau[HAWSER_LANES] = {0.0}, worst = 0.0;
	const struct hawser__more left = {.force = force, .by_v = by_v, .sign = -1.0, .stride = 1};
	const struct hawser__more side = {.force = lanes[1], .by_v = lanes[2], .sign = -1.0,
	                                  .stride = HAWSER_LANES};

	random_model(&rom, n, 0);
	rom.term = calloc(count, sizeof *rom.term);
	for (int i = 0; i < states*n; i++)
		v[i] = uniform();
	for (; rom.terms < count; rom.terms++) {
		struct hawser_term *term = &rom.term[rom.terms];

		*term = (struct hawser_term){.j = rand()%n, .factors = 2 + rand()%2, .value = uniform(),
		                             .factor = {rand()%n, rand()%n, rand()%n}};
		term->rates = term->factors;
		for (int r = 0; r < states; r++)
			for (int gone = -1; gone < term->factors; gone++) {
				double product = term->value;

				for (int f = 0; f < term->factors; f++)
					product *= f == gone ? 1.0 : v[r*n + term->factor[f]];
				if (gone < 0)
					want[r*n + term->j] += product;
				else
					slope[(r*n + term->j)*n + term->factor[gone]] += product;
			}
	}
	ok(!hawser_rom_compile(&rom, NULL) && rom.kernel->rates && rom.kernel->others == 0,
	   "terms of velocities have matrices");
	hawser__rom_more_left(&rom, &left, u, v, states, 1.0);
	for (int i = 0; i < n*HAWSER_LANES; i++)
		lanes[0][i] = v[i%HAWSER_LANES*n + i/HAWSER_LANES];
	hawser__rom_more_add(&rom, &side, u, lanes[0], tau, 1.0);
	for (int i = 0; i < n*n*HAWSER_LANES; i++) {
		int lane = i%HAWSER_LANES, j = i/HAWSER_LANES;

		worst = fmax(worst, fabs(lanes[2][i] - slope[lane*n*n + j]));
		worst = fmax(worst, j < n ? fabs(lanes[1][i] + want[lane*n + j]) : 0.0);
	}
	ok(distance(force, want, states*n) < 1e-14 && distance(by_v, slope, states*n*n) < 1e-14 &&
	   worst < 1e-14, "and the forces and derivatives of their products: %.1e", worst);
	hawser_rom_clear(&rom);
}

/* Derivatives of the acceleration with every kind of harmonic. */
static void check_forced(void)
{
	enum { n = 3 };
	struct hawser_rom rom;
	double u[n] = {0.31, -0.72, 0.55}, v[n] = {-0.41, 0.13, 0.87}, tau = 0.77, omega = 1.385;
	double acc[n], by_u[n*n], by_v[n*n], by_omega[n], p[n], m[n], worst = 0.0;
	const double h = 1e-5;

	random_model(&rom, n, 1);
	rom.harmonics = 3;
	rom.harmonic = calloc(3, sizeof *rom.harmonic);
	for (int i = 0; i < 3; i++) {
		struct hawser_harmonic *harmonic = &rom.harmonic[i];

		*harmonic = (struct hawser_harmonic){.k = i + 1, .omega_power = i,
			.phase = i == 1 ? HAWSER_SIN : HAWSER_COS};
		harmonic->f = malloc(n*sizeof(double));
		harmonic->D = malloc(n*n*sizeof(double));
		harmonic->K = malloc(n*n*sizeof(double));
		for (int j = 0; j < n*n; j++) {
			harmonic->f[j%n] = uniform();
			harmonic->D[j] = uniform();
			harmonic->K[j] = uniform();
		}
	}
	ok(!hawser_rom_compile(&rom, NULL), "forced model compiles");
	hawser_rom_acceleration_jacobian(&rom, acc, by_u, by_v, by_omega, u, v, tau, omega);
	hawser_rom_acceleration(&rom, p, u, v, tau, omega);
	ok(distance(p, acc, n) < 1e-14, "both calls give the same acceleration");
	for (int k = 0; k < n; k++)
		for (int part = 0; part < 2; part++) {
			double *x = part ? v : u, keep = x[k];

			x[k] = keep + h;
			hawser_rom_acceleration(&rom, p, u, v, tau, omega);
			x[k] = keep - h;
			hawser_rom_acceleration(&rom, m, u, v, tau, omega);
			x[k] = keep;
			for (int j = 0; j < n; j++)
				worst = fmax(worst, fabs((p[j] - m[j])/(2*h) -
				                         (part ? by_v : by_u)[j*n + k]));
		}
	hawser_rom_acceleration(&rom, p, u, v, tau, omega + h);
	hawser_rom_acceleration(&rom, m, u, v, tau, omega - h);
	for (int j = 0; j < n; j++)
		worst = fmax(worst, fabs((p[j] - m[j])/(2*h) - by_omega[j]));
	ok(worst < 1e-8, "derivatives by u, v, Omega against differences: %.1e", worst);
	hawser_rom_clear(&rom);
}

static void check_errors(void)
{
	struct hawser_rom rom;
	struct hawser_report report = {.message = ""};

	ok(hawser__rom_init(&rom, 0, &report) == HAWSER_ERR_ARGUMENT, "n 0: %s", report.message);
	ok(hawser__rom_init(&rom, 101, &report) == HAWSER_ERR_ARGUMENT, "n 101: %s", report.message);
	random_model(&rom, 2, 0);
	rom.Q[3].l = 2;
	ok(hawser_rom_compile(&rom, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	rom.Q[3].l = 1;
	rom.C[5].value = NAN;
	ok(hawser_rom_compile(&rom, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	rom.C[5].value = 0.0;
	rom.K[1] = INFINITY;
	ok(hawser_rom_compile(&rom, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	rom.K[1] = 0.0;
	rom.harmonic = calloc(1, sizeof *rom.harmonic);
	rom.harmonics = 1;
	rom.harmonic[0].k = -1;
	ok(hawser_rom_compile(&rom, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	hawser_rom_clear(&rom);
	hawser_rom_clear(NULL);
}

CASE(unit_rom_kernel)
{
	srand(2385);
	for (int n = 1; n <= 12; n += n < 3 ? 1 : 3) {
		check_model(n, 1);
		check_model(n, 0);
	}
	check_forced();
	check_rates();
	check_errors();
	return done_testing();
}
