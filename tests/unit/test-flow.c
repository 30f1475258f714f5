/* The flow on its mesh: order of convergence, exactness of the derivatives, reliability of the
 * error estimate, a closed form.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "response/time/flow.h"
#include "rom/build/model.h"
#include "tests/tap.h"

/* A damped 2:1 pair with a cubic term and a load: all terms of a model except parametric ones. */
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
	struct hawser__stretch stretch = {0.3, 2*M_PI/steps, steps, 1, 0.0};

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
	/* a coarse mesh: the derivatives are exact for the discrete flow */
	struct hawser__stretch stretch = {0.3, 2*M_PI/9, 9, 1, 0.0};
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
	struct hawser__stretch stretch = {0.0, 2*M_PI/60, 60, 1, 0.0};
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

/* --- against the formula of the original paper, in plain loops --- */

enum { N = 3, M = 2*N, COUNT = 6, STEPS = 7 };

/* Terms of a model, as bits. */
enum { DAMPED = 1, BY_MODE = 2, GYROSCOPIC = 4, STIFF = 8, VARYING_K = 16, VARYING_D = 32 };

static int make_model(struct hawser_rom *rom, int what)
{
	if (hawser__rom_init(rom, N, NULL))
		return 0;
	for (int j = 0; j < N; j++) {
		rom->K[j*N + j] = 1.0 + 0.7*j;
		rom->D[j*N + j] = (what & DAMPED ? 0.08 : 0.0) + (what & BY_MODE ? 0.05*j : 0.0) +
		                  (what & STIFF ? 3.1 : 0.0);
	}
	if (what & GYROSCOPIC) {
		rom->D[1] = 0.3;
		rom->D[N] = -0.3;
	}
	rom->quads = rom->cubics = 2;
	rom->Q = calloc(2, sizeof *rom->Q);
	rom->Q[0] = (struct hawser_quad){0, 1, 2, 0.6};
	rom->Q[1] = (struct hawser_quad){2, 0, 0, 0.4};
	rom->C = calloc(2, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, 0.7};
	rom->C[1] = (struct hawser_cubic){1, 0, 1, 2, 0.2};
	rom->harmonics = 2;
	rom->harmonic = calloc(2, sizeof *rom->harmonic);
	for (int h = 0; h < 2; h++) {
		struct hawser_harmonic *harmonic = &rom->harmonic[h];

		*harmonic = (struct hawser_harmonic){.k = h + 1, .omega_power = 2*h,
			.phase = h ? HAWSER_SIN : HAWSER_COS, .f = calloc(N, sizeof(double))};
		harmonic->f[h] = 0.2;
		if (what & VARYING_K)
			harmonic->K = calloc(N*N, sizeof(double));
		if (what & VARYING_D)
			harmonic->D = calloc(N*N, sizeof(double));
		for (int i = 0; i < N*N; i++) {
			if (harmonic->K)
				harmonic->K[i] = 0.03*(i + h);
			if (harmonic->D)
				harmonic->D[i] = 0.02*(i - h);
		}
	}
	return !hawser_rom_compile(rom, NULL);
}

/* One step for x and its derivative X [M][M + 1] by the initial state and Omega; returns the error. */
static double textbook_step(const struct hawser_rom *rom, double *x, double (*X)[M + 1], double tau,
                            double h, double omega)
{
	const struct hawser__tableau *rk = &hawser__dop853;
	double slope[HAWSER_RK_STAGES][M], varied[HAWSER_RK_STAGES][M][M + 1];
	double five = 0.0, three = 0.0;

	for (int s = 0; s <= HAWSER_RK_STAGES; s++) {
		const double *row = s < HAWSER_RK_STAGES ? rk->a[s] : rk->b;
		double y[M], Y[M][M + 1], acc[N], by_u[N*N], by_v[N*N], by_omega[N];

		memcpy(y, x, sizeof y);
		memcpy(Y, X, sizeof Y);
		for (int l = 0; l < s; l++)
			for (int i = 0; i < M; i++) {
				y[i] += h*row[l]*slope[l][i];
				for (int k = 0; k <= M; k++)
					Y[i][k] += h*row[l]*varied[l][i][k];
			}
		if (s == HAWSER_RK_STAGES) {
			memcpy(x, y, sizeof y);
			memcpy(X, Y, sizeof Y);
			break;
		}
		hawser_rom_acceleration_jacobian(rom, acc, by_u, by_v, by_omega, y, y + N,
		                                 tau + rk->c[s]*h, omega);
		for (int j = 0; j < N; j++) {
			slope[s][j] = y[N + j]/omega;
			slope[s][N + j] = acc[j]/omega;
			for (int k = 0; k <= M; k++) {
				double sum = k == M ? by_omega[j] - acc[j]/omega : 0.0;

				for (int i = 0; i < N; i++)
					sum += by_u[j*N + i]*Y[i][k] + by_v[j*N + i]*Y[N + i][k];
				varied[s][j][k] = (Y[N + j][k] - (k == M ? y[N + j]/omega : 0.0))/omega;
				varied[s][N + j][k] = sum/omega;
			}
		}
	}
	for (int i = 0; i < M; i++) {
		double e5 = 0.0, e3 = 0.0;

		for (int s = 0; s < HAWSER_RK_STAGES; s++) {
			e5 += rk->e5[s]*slope[s][i];
			e3 += rk->e3[s]*slope[s][i];
		}
		five += e5*e5;
		three += e3*e3;
	}
	return 0.125*h*five/sqrt(five + 0.01*three);
}

/* Six stretches at once (a full set of lanes, and a partly filled one): state, derivatives,
 * samples, error. */
static void check_textbook(int what, const char *name)
{
	struct hawser_rom rom;
	struct hawser__flow flow;
	struct hawser__stretch stretch = {0.3, 0.15, STEPS, COUNT, 0.9};
	double x[COUNT][M], mapped[COUNT][M], A[COUNT][M][M], b[COUNT][M], samples[COUNT][STEPS][N];
	double omega = 0.83, worst = 0.0, error = 0.0, estimate;

	ok(make_model(&rom, what) && !hawser__flow_init(&flow, &rom, NULL), "%s: model", name);
	for (int i = 0; i < COUNT*M; i++)
		x[i/M][i%M] = mapped[i/M][i%M] = 0.4*cos(1.7*i);
	estimate = hawser__flow_derive(&flow, x[0], A[0][0], b[0], samples[0][0], &stretch, omega);
	for (int c = 0; c < COUNT; c++) {
		double y[M], Y[M][M + 1] = {{0.0}};

		for (int i = 0; i < M; i++) {
			y[i] = mapped[c][i];
			Y[i][i] = 1.0;
		}
		for (int s = 0; s < STEPS; s++) {
			for (int j = 0; j < N; j++)
				worst = fmax(worst, fabs(samples[c][s][j] - y[j]));
			error += textbook_step(&rom, y, Y, 0.3 + 0.9*c + 0.15*s, 0.15, omega);
		}
		for (int i = 0; i < M; i++) {
			worst = fmax(worst, fmax(fabs(x[c][i] - y[i]), fabs(b[c][i] - Y[i][M])));
			for (int k = 0; k < M; k++)
				worst = fmax(worst, fabs(A[c][i][k] - Y[i][k]));
		}
	}
	ok(worst < 2e-14, "%s: the flow by the formula as printed: %.1e", name, worst);
	close_to(estimate, error, 1e-6, "the error it states");
	close_to(hawser__flow_map(&flow, mapped[0], NULL, &stretch, omega), estimate, 1e-12,
	         "that of the flow alone");
	ok(!memcmp(mapped, x, sizeof x), "%s: the flow alone is the same", name);
	hawser__flow_clear(&flow);
	hawser_rom_clear(&rom);
}

CASE(unit_flow)
{
	struct hawser_rom rom;
	struct hawser__flow flow;

	ok(make_pair(&rom) && !hawser__flow_init(&flow, &rom, NULL), "model and flow");
	check_order(&flow);
	check_derivatives(&flow);
	hawser__flow_clear(&flow);
	hawser_rom_clear(&rom);
	check_closed_form();
	check_textbook(0, "undamped");
	check_textbook(DAMPED, "one damping for all");
	check_textbook(DAMPED | BY_MODE | VARYING_K, "a damping for each, varying stiffness");
	check_textbook(DAMPED | BY_MODE | GYROSCOPIC, "gyroscopic");
	check_textbook(DAMPED | VARYING_D, "varying damping");
	check_textbook(STIFF | BY_MODE, "damping too strong for the formula");
	return done_testing();
}
