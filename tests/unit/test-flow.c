/* The flow on its mesh: order of convergence, exactness of the derivatives, honesty of the error
 * estimate, a closed form.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include "response/flow.h"
#include "rom/model.h"
#include "tests/tap.h"

/* A damped 2:1 pair with a cubic term and a load: everything the flow can meet but parameters. */
static int make_pair(struct hawser_rom *rom)
{
	if (hawser__rom_init(rom, 2, NULL))
		return 0;
	rom->K[0] = 1.0;
	rom->K[3] = 4.1;
	rom->D[0] = 0.05;
	rom->D[1] = 0.02; /* not symmetric */
	rom->D[3] = 0.11;
	rom->quads = 2;
	rom->Q = calloc(2, sizeof *rom->Q);
	rom->Q[0] = (struct hawser_quad){0, 0, 1, 1.0};
	rom->Q[1] = (struct hawser_quad){1, 0, 0, 0.5};
	rom->cubics = 1;
	rom->C = calloc(1, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, 0.7};
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 2, .phase = HAWSER_SIN, .omega_power = 1,
		.f = calloc(2, sizeof(double))};
	rom->harmonic[0].f[0] = 0.3;
	rom->harmonic[0].f[1] = -0.2;
	return !hawser_rom_compile(rom, NULL);
}

static const double start[4] = {0.41, -0.33, 0.12, 0.57};

static double run(struct hawser__flow *flow, double *x, int steps, double omega)
{
	struct hawser__stretch stretch = {0.3, 2*M_PI/steps, steps};

	memcpy(x, start, sizeof start);
	return hawser__flow_map(flow, x, NULL, &stretch, omega);
}

static double distance(const double *a, const double *b)
{
	double sum = 0.0;

	for (int i = 0; i < 4; i++)
		sum += pow(a[i] - b[i], 2);
	return sqrt(sum);
}

static void check_order(struct hawser__flow *flow)
{
	double exact[4], x[4], previous = 0.0;

	run(flow, exact, 400, 0.9);
	for (int steps = 14; steps <= 56; steps *= 2) {
		double estimate = run(flow, x, steps, 0.9), error = distance(x, exact);

		if (previous > 0.0)
			ok(fabs(log2(previous/error) - 8.0) < 0.7, "%d steps: order %.2f", steps,
			   log2(previous/error));
		ok(estimate > error && estimate < 1e3*error,
		   "%d steps: estimate %.1e bounds the error %.1e within a factor of 1000", steps,
		   estimate, error);
		previous = error;
	}
}

static void check_derivatives(struct hawser__flow *flow)
{
	struct hawser__stretch stretch = {0.3, 2*M_PI/9, 9}; /* coarse: exact for what is computed */
	double A[16], b[4], x[4], plus[4], minus[4], worst = 0.0, omega = 1.17;
	const double h = 1e-4;

	memcpy(x, start, sizeof start);
	hawser__flow_derive(flow, x, A, b, NULL, &stretch, omega);
	run(flow, plus, 9, omega);
	ok(distance(x, plus) < 1e-15, "the derived flow is the flow");
	for (int k = 0; k < 5; k++) {
		double d[4];

		for (int i = 0; i < 4; i++)
			d[i] = 0.0;
		/* fourth-order difference: h^4 times a fifth derivative */
		for (int s = 1; s <= 2; s++) {
			double weight = s == 1 ? 2.0/3.0 : -1.0/12.0;

			memcpy(plus, start, sizeof start);
			memcpy(minus, start, sizeof start);
			if (k < 4) {
				plus[k] += s*h;
				minus[k] -= s*h;
			}
			hawser__flow_map(flow, plus, NULL, &stretch, omega + (k == 4 ? s*h : 0));
			hawser__flow_map(flow, minus, NULL, &stretch, omega - (k == 4 ? s*h : 0));
			for (int i = 0; i < 4; i++)
				d[i] += weight*(plus[i] - minus[i])/h;
		}
		for (int i = 0; i < 4; i++)
			worst = fmax(worst, fabs(d[i] - (k < 4 ? A[4*i + k] : b[i])));
	}
	ok(worst < 1e-10, "A and b against fourth-order differences: %.1e", worst);
}

/* Free decay u'' + 2 z u' + u = 0 from (1, 0). */
static void check_closed_form(void)
{
	struct hawser_rom rom;
	struct hawser__flow flow;
	struct hawser__stretch stretch = {0.0, 2*M_PI/60, 60};
	double x[2] = {1.0, 0.0}, z = 0.07, omega = 0.8, t = 2*M_PI/omega, wd = sqrt(1 - z*z);

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	rom.D[0] = 2*z;
	ok(!hawser_rom_compile(&rom, NULL) && !hawser__flow_init(&flow, &rom, NULL), "oscillator");
	hawser__flow_map(&flow, x, NULL, &stretch, omega);
	close_to(x[0], exp(-z*t)*(cos(wd*t) + z/wd*sin(wd*t)), 1e-12, "free decay, displacement");
	close_to(x[1], -exp(-z*t)/wd*sin(wd*t), 1e-12, "free decay, velocity");
	hawser__flow_clear(&flow);
	hawser_rom_clear(&rom);
}

int main(void)
{
	struct hawser_rom rom;
	struct hawser__flow flow;

	ok(make_pair(&rom) && !hawser__flow_init(&flow, &rom, NULL), "model and flow");
	check_order(&flow);
	check_derivatives(&flow);
	hawser__flow_clear(&flow);
	hawser_rom_clear(&rom);
	check_closed_form();
	return done_testing();
}
