/* Resonances (hawser/locus.h): motions in phase quadrature with their load, against closed forms and
 * against Runge-Kutta and Newton's method for the period and the phase, written here.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/locus.h>

#include "tests/balance-model.h"
#include "tests/tap.h"

enum { MOST = 3, UNKNOWNS = 2*MOST + 1 };
static int steps = 1000; /* of a period */

/* --- the second route --- */

/* The period map of x at Omega; sum: integrals of u cos k tau and u sin k tau, [2][n]. */
static void turn(const struct hawser_rom *rom, double *x, double *sum, int k, double omega)
{
	int n = rom->n, m = 2*n;
	double h = 2.0*M_PI/steps, rate[4][2*MOST], at[2*MOST];
	const double part[4] = {0.0, 0.5, 0.5, 1.0};

	memset(sum, 0, (size_t)m*sizeof *sum);
	for (int s = 0; s < steps; s++) {
		double tau = s*h;

		for (int i = 0; i < n; i++) {
			sum[i] += h*x[i]*cos(k*tau);
			sum[n + i] += h*x[i]*sin(k*tau);
		}
		for (int stage = 0; stage < 4; stage++) {
			for (int i = 0; i < m; i++)
				at[i] = x[i] + (stage ? part[stage]*h*rate[stage - 1][i] : 0.0);
			memcpy(rate[stage], at + n, (size_t)n*sizeof(double));
			hawser_rom_acceleration(rom, rate[stage] + n, at, at + n, tau + part[stage]*h, omega);
			for (int i = 0; i < m; i++)
				rate[stage][i] /= omega;
		}
		for (int i = 0; i < m; i++)
			x[i] += h/6.0*(rate[0][i] + 2.0*rate[1][i] + 2.0*rate[2][i] + rate[3][i]);
	}
}

/* The equations at y: state, Omega. */
static void equations(const struct hawser_rom *rom, double *r, const double *y, int k)
{
	int n = rom->n, m = 2*n;
	double x[2*MOST], sum[2*MOST];

	memcpy(x, y, (size_t)m*sizeof *x);
	turn(rom, x, sum, k, y[m]);
	for (int i = 0; i < m; i++)
		r[i] = x[i] - y[i];
	r[m] = 0.0;
	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *of = &rom->harmonic[p];
		const double *u = sum + (of->phase == HAWSER_COS ? 0 : n);

		for (int i = 0; of->k == k && of->f && i < n; i++) {
			double force = rom->mass ? 0.0 : of->f[i];

			for (int j = 0; rom->mass && j < n; j++)
				force += rom->mass[i*n + j]*of->f[j];
			r[m] += pow(y[m], of->omega_power)*force*u[i];
		}
	}
}

/* Gauss elimination. */
static void eliminate(double a[UNKNOWNS][UNKNOWNS], double *b, int size)
{
	for (int k = 0; k < size; k++) {
		int best = k;

		for (int i = k + 1; i < size; i++)
			best = fabs(a[i][k]) > fabs(a[best][k]) ? i : best;
		for (int j = 0; j < size; j++) {
			double swap = a[k][j];

			a[k][j] = a[best][j];
			a[best][j] = swap;
		}
		{
			double swap = b[k];

			b[k] = b[best];
			b[best] = swap;
		}
		for (int i = 0; i < size; i++) {
			double factor = i == k ? 0.0 : a[i][k]/a[k][k];

			for (int j = k; j < size; j++)
				a[i][j] -= factor*a[k][j];
			b[i] -= factor*b[k];
		}
	}
	for (int k = 0; k < size; k++)
		b[k] /= a[k][k];
}

/* The resonance near y, with the derivatives at y; returns its Omega. */
static double settle(const struct hawser_rom *rom, double *y, int k)
{
	int size = 2*rom->n + 1;
	double length = INFINITY, slope[UNKNOWNS][UNKNOWNS], r[UNKNOWNS];

	equations(rom, r, y, k);
	for (int j = 0; j < size; j++) {
		double moved[UNKNOWNS], own = y[j], h = 1e-6*fmax(fabs(own), 1e-2);

		y[j] = own + h;
		equations(rom, moved, y, k);
		y[j] = own;
		for (int l = 0; l < size; l++)
			slope[l][j] = (moved[l] - r[l])/h;
	}
	for (int i = 0; i < 12 && length > 1e-10; i++) {
		double a[UNKNOWNS][UNKNOWNS];

		memcpy(a, slope, sizeof a);
		eliminate(a, r, size);
		length = 0.0;
		for (int j = 0; j < size; j++) {
			y[j] -= r[j];
			length = fmax(length, fabs(r[j]));
		}
		equations(rom, r, y, k);
	}
	return length <= 1e-10 ? y[size - 1] : NAN;
}

/* --- the checks --- */

static int without; /* models whose response has no resonance in the range */

static int trace(struct hawser_locus *locus, struct hawser_rom_family *family,
                 const struct hawser_rom *rom, const struct hawser_locus_options *options)
{
	struct hawser_report report = {.message = ""};
	enum hawser_status status = hawser_factor_open(family, rom, HAWSER_FACTOR_LOAD, 1.0, NULL);

	if (!status)
		status = hawser_locus_trace(locus, family, options, &report);
	without += status == HAWSER_ERR_NO_SOLUTION;
	return ok(status == HAWSER_ERR_NO_SOLUTION || (!status && locus->lost == 0), "traced %s",
	          report.message) && !status;
}

/* `count` points of the curves by the second route. */
static void confirm(const struct hawser_rom *rom, const struct hawser_locus_options *options,
                    int count, const char *what)
{
	struct hawser_rom_family family;
	struct hawser_locus locus;
	double worst = 0.0, drift = 0.0, quadrature = 0.0;
	int m = 2*rom->n;

	if (!trace(&locus, &family, rom, options)) {
		hawser_factor_close(&family);
		return;
	}
	for (int c = 0; c < count; c++) {
		int i = (int)((c + 0.5)/count*locus.points);
		double y[UNKNOWNS], x[UNKNOWNS];
		const struct hawser_rom *here;

		if (family.model(family.context, &here, locus.point[i].parameter, NULL))
			continue;
		memcpy(y, locus.state + (size_t)i*m, (size_t)m*sizeof *y);
		y[m] = locus.point[i].omega;
		memcpy(x, y, sizeof x);
		y[0] *= 1.001; /* no start at the answer */
		y[m] *= 1.0001;
		worst = fmax(worst, fabs(settle(here, y, locus.harmonic)/locus.point[i].omega - 1.0));
		for (int k = 0; k < m; k++)
			drift = fmax(drift, fabs(y[k] - x[k]));
		quadrature = fmax(quadrature, fabs(locus.point[i].phase - M_PI_2));
	}
	ok(worst < 1e-9 && drift < 1e-8 && quadrature < 1e-10 && locus.points > 2*count,
	   "%s: %d of %d points by Runge-Kutta: Omega to %.1e, states to %.1e, phase to %.1e", what, count,
	   locus.points, worst, drift, quadrature);
	hawser_locus_clear(&locus);
	hawser_factor_close(&family);
}

/* Coordinates turned by 0.7; a load in two phases, on one mode. */
static void linear(void)
{
	const double c = cos(0.7), s = sin(0.7), w2[2] = {1.7, 9.1}, d[2] = {0.04, 0.07};
	const struct hawser_locus_options options = {.kind = HAWSER_RESONANCE, .from = 0.5, .to = 4.0,
		.parameter_from = 0.3, .parameter_to = 2.385, .at = 1.0};
	const double a[2][2] = {{c, s}, {-s, c}};
	double gap = 0.0, size = 0.0, damping = 0.0, work = 0.0;
	struct hawser_rom rom;
	struct hawser_rom_family family;
	struct hawser_locus locus;

	if (!ok(!hawser__rom_init(&rom, 2, NULL), "a model"))
		return;
	for (int i = 0; i < 4; i++) {
		rom.K[i] = rom.D[i] = 0.0;
		for (int k = 0; k < 2; k++) {
			rom.K[i] += w2[k]*a[k][i/2]*a[k][i%2];
			rom.D[i] += d[k]*a[k][i/2]*a[k][i%2];
		}
	}
	add_harmonic(&rom, (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS},
	             (double[]){0.03*c, 0.03*s}, NULL, NULL);
	add_harmonic(&rom, (struct hawser_harmonic){.k = 1, .phase = HAWSER_SIN},
	             (double[]){0.04*c, 0.04*s}, NULL, NULL);
	if (!ok(!hawser_rom_compile(&rom, NULL), "compiled") || !trace(&locus, &family, &rom, &options))
		return;
	for (int i = 0; i < locus.points; i++) {
		const struct hawser_locus_point *point = &locus.point[i];
		double f = 0.05*point->parameter, w = sqrt(w2[0]), amplitude = f/(d[0]*w);

		gap = fmax(gap, fabs(point->omega/w - 1.0));
		size = fmax(size, fabs(point->amplitude/amplitude - 1.0));
		damping = fmax(damping, fabs(point->damping/(0.5*d[0]/w) - 1.0));
		work = fmax(work, fabs(point->work/(M_PI*f*amplitude) - 1.0));
	}
	ok(locus.curves == 1 && locus.points > 20 && fmax(gap, size) < 1e-12 && damping < 1e-11 &&
	   work < 1e-11, "linear, closed form: Omega to %.1e, amplitude to %.1e, damping to %.1e, work to "
	   "%.1e", gap, size, damping, work);
	hawser_locus_clear(&locus);
	hawser_factor_close(&family);
	hawser_rom_clear(&rom);
}

/* u'' + d u' + u + u^3 = p cos: the frequency of the free motion of this energy, by the mean of
 * arithmetic and geometric means. */
static double free_frequency(double energy)
{
	double a2 = sqrt(1.0 + 4.0*energy) - 1.0, x = 1.0, y = sqrt(1.0 - 0.5*a2/(1.0 + a2));

	for (int i = 0; i < 8; i++) {
		double mean = 0.5*(x + y);

		y = sqrt(x*y);
		x = mean;
	}
	return sqrt(1.0 + a2)*x;
}

static int duffing(struct hawser_rom *rom, double damping)
{
	if (hawser__rom_init(rom, 1, NULL))
		return 1;
	rom->K[0] = 1.0;
	rom->D[0] = damping;
	rom->cubics = 1;
	rom->C = calloc(1, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, 1.0};
	add_harmonic(rom, (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS}, (double[]){damping}, NULL,
	             NULL);
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

static void vanishing_damping(void)
{
	double gap[3];

	for (int k = 0; k < 3; k++) {
		const struct hawser_locus_options options = {.kind = HAWSER_RESONANCE, .from = 0.5, .to = 4.0,
			.parameter_from = 0.01, .parameter_to = 2.0, .at = 1.0};
		struct hawser_rom rom;
		struct hawser_rom_family family;
		struct hawser_locus locus;
		const struct hawser_locus_point *last, *first;

		if (!ok(!duffing(&rom, 0.2*pow(2.0, -k)), "a model") || !trace(&locus, &family, &rom, &options))
			return;
		first = &locus.point[0];
		last = &locus.point[locus.points - 1];
		gap[k] = fabs(last->omega - free_frequency(last->energy));
		/* one harmonic: Omega^2 = 1 + 3/4 a^2; the load f is damping Omega a, at any damping */
		ok(first->parameter == 0.01 && fabs(first->omega - sqrt(1.0 + 0.75*pow(first->amplitude, 2))) <
		   pow(first->amplitude, 4) && fabs(first->amplitude*first->omega/0.01 - 1.0) < 1e-8,
		   "small motion: Omega %.12g, amplitude %.12g", first->omega, first->amplitude);
		hawser_locus_clear(&locus);
		hawser_factor_close(&family);
		hawser_rom_clear(&rom);
	}
	ok(fabs(log2(gap[1]/gap[2]) - 2.0) < 0.02, "from the free motion: %.3e %.3e %.3e, order %.3f in "
	   "the damping", gap[0], gap[1], gap[2], log2(gap[1]/gap[2]));
}

/* Three coordinates, coupled by all terms, with a mass matrix and a load of two harmonics. */
static int coupled(struct hawser_rom *rom, unsigned seed)
{
	unsigned state = seed;
	double v[64];

	for (int i = 0; i < 64; i++) {
		state = state*1664525u + 1013904223u;
		v[i] = (double)(state >> 8)/16777216.0 - 0.5;
	}
	if (hawser__rom_init(rom, 3, NULL))
		return 1;
	for (int i = 0; i < 9; i++) {
		rom->K[i] = (i%4 == 0 ? 1.0 + 1.3*i : 0.0) + 0.2*v[i];
		rom->D[i] = (i%4 == 0 ? 0.06 : 0.0) + 0.02*v[9 + i];
	}
	rom->mass = calloc(9, sizeof *rom->mass);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			rom->mass[3*i + j] = (i == j) + 0.2*v[18 + i + j];
	rom->cubics = 6;
	rom->C = calloc(6, sizeof *rom->C);
	rom->quads = 6;
	rom->Q = calloc(6, sizeof *rom->Q);
	for (int i = 0; i < 6; i++) {
		rom->C[i] = (struct hawser_cubic){i/2, 0, 0, i%2*(1 + i/2)%3, 0.3 + v[24 + i]};
		rom->Q[i] = (struct hawser_quad){i/2, 0, i%2, 0.4*v[30 + i]};
	}
	add_harmonic(rom, (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS},
	             (double[]){0.05, 0.02*v[36], 0.02*v[37]}, NULL, NULL);
	add_harmonic(rom, (struct hawser_harmonic){.k = 1, .phase = HAWSER_SIN, .omega_power = 2},
	             (double[]){0.05*v[38], 0.02*v[39], 0.02*v[40]}, NULL, NULL);
	add_harmonic(rom, (struct hawser_harmonic){.k = 2, .phase = HAWSER_SIN},
	             (double[]){0.05*v[41], 0.05*v[42], 0.05*v[43]}, NULL, NULL);
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

static void refused(const struct hawser_rom *rom, int harmonic, const char *what)
{
	const struct hawser_locus_options options = {.kind = HAWSER_RESONANCE, .from = 0.5, .to = 4.0,
		.parameter_from = 0.5, .parameter_to = 2.0, .at = 1.0, .harmonic = harmonic};
	struct hawser_locus locus = {.n = 0};
	struct hawser_rom_family family;
	struct hawser_report report = {.message = ""};
	int opened = hawser_factor_open(&family, rom, HAWSER_FACTOR_LOAD, 1.0, NULL) == HAWSER_OK;

	ok(opened && hawser_locus_trace(&locus, &family, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, what), "%s", report.message);
	hawser_locus_clear(&locus);
	if (opened)
		hawser_factor_close(&family);
}

static void refusals(void)
{
	struct hawser_rom rom;

	if (!ok(!duffing(&rom, 0.1), "a model"))
		return;
	refused(&rom, 3, "the load has no force of that harmonic");
	rom.harmonic[0].f[0] = 0.0;
	refused(&rom, 0, "only varies the stiffness");
	rom.harmonics = 0;
	refused(&rom, 0, "the model has no load");
	rom.harmonics = 1;
	hawser_rom_clear(&rom);
}

CASE(property_resonance)
{
	struct hawser_locus_options options = {.kind = HAWSER_RESONANCE, .from = 0.6, .to = 1.7,
		.parameter_from = 0.2, .parameter_to = 2.0, .at = 0.5};
	unsigned most = getenv("HAWSER_LONG") ? 60 : 2;
	struct hawser_rom rom;

	if (most > 2) {
		steps = 6000;
		options.tolerance = 1e-11;
	}
	linear();
	vanishing_damping();
	if (ok(!make_general(&rom), "a model with all terms")) {
		struct hawser_locus_options small = options;

		small.parameter_from = 0.02;
		small.parameter_to = 0.15;
		small.at = 0.05;
		confirm(&rom, &small, 2, "gyroscopic, parametric, two harmonics");
		hawser_rom_clear(&rom);
	}
	for (unsigned seed = 2; seed <= most; seed++)
		if (ok(!coupled(&rom, seed), "a model")) {
			options.harmonic = 1 + (int)(seed%2);
			options.from = 0.6/options.harmonic;
			options.to = 1.7/options.harmonic;
			confirm(&rom, &options, 2, "coupled coordinates");
			hawser_rom_clear(&rom);
		}
	ok(without <= (int)most/15, "%d of %d models without a resonance", without, (int)most);
	refusals();
	return done_testing();
}
