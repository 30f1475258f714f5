/* bench/map.c - cost of a map of Floquet multipliers: 200 x 200 points of a model of six coupled
 * coordinates, adaptively and point by point.
 *
 * Verified: at points spread over the map the largest multiplier agrees with that of a transition
 * matrix by hawser_integrate; the adaptive map has the same number of instabilities as the full one
 * at 99 % of the points; one thread and all threads give the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <hawser/hawser.h>

#include "bench/clock.h"

enum { N = 6, POINTS = 200 };

static double K[N*N], D[N*N], K1[N*N], K2[N*N];
static struct hawser_harmonic harmonic[2] = {
	{.k = 1, .phase = HAWSER_COS, .K = K1}, {.k = 2, .phase = HAWSER_SIN, .K = K2}};

/* Frequencies of a span with sag, 1 % of damping, a gyroscopic part, and two full harmonics. */
static void fill(struct hawser_rom *rom)
{
	static const double w[N] = {1.0, 1.37, 2.21, 2.9, 3.83, 4.6};

	for (int j = 0; j < N; j++)
		for (int k = 0; k < N; k++) {
			double a = sin(1.0 + 7.0*j*k + j + k), b = cos(2.0 + 3.0*j*k + j + k);

			K[j*N + k] = j == k ? w[j]*w[j] : 0.0;
			D[j*N + k] = j == k ? 0.02*w[j] : 0.05*(k - j)/(1.0 + j + k);
			K1[j*N + k] = 0.4*a*w[j]*w[k];
			K2[j*N + k] = 0.1*b*w[j]*w[k];
		}
	*rom = (struct hawser_rom){.n = N, .K = K, .D = D, .harmonics = 2, .harmonic = harmonic,
		.length = 1.0, .time = 1.0, .force = 1.0};
}

static int trace(struct hawser_map *map, const struct hawser_rom *rom, int coarse, int threads,
                 double tolerance, double *wall, double *cpu)
{
	const struct hawser_map_source source = {.rom = rom, .key = {"Omega", "factor.load"},
		.quantity = "multiplier"};
	struct hawser_map_options options = {.coarse = 0};
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_map_field field;
	enum hawser_status status = hawser_map_cable_open(&field, &source, &report);
	double began = clock_secs();
	double before = cpu_secs();

	options.from[0] = 0.8;
	options.to[0] = 9.0;
	options.to[1] = 0.5;
	options.points[0] = options.points[1] = POINTS;
	options.coarse = coarse;
	options.threads = threads;
	options.tolerance = tolerance;
	if (!status)
		status = hawser_map_trace(map, &field, &options, &report);
	hawser_map_cable_close(&field);
	*wall = clock_secs() - began;
	*cpu = cpu_secs() - before;
	if (status)
		fprintf(stderr, "map: %s\n", report.message);
	return status;
}

/* Largest modulus at (omega, load), from 2N integrations over a period. */
static double integrated(struct hawser_rom *rom, double omega, double load)
{
	double period = 2.0*M_PI/omega, monodromy[4*N*N], log_modulus[2*N], argument[2*N];
	double first[N*N], second[N*N], result = NAN;

	memcpy(first, K1, sizeof first);
	memcpy(second, K2, sizeof second);
	for (int e = 0; e < N*N; e++) {
		K1[e] *= load;
		K2[e] *= load;
	}
	for (int q = 0; q < 2*N; q++) {
		double start[2*N] = {0.0};
		struct hawser_integrate_options options = {.omega = omega, .until = period,
			.every = period, .rtol = 1e-13, .atol = 1e-15, .method = "adams", .initial = start};
		struct hawser_trajectory run = {0};

		start[q] = 1.0;
		if (!hawser_integrate(&run, rom, &options, NULL))
			for (int p = 0; p < 2*N; p++)
				monodromy[p*2*N + q] = run.state[(run.rows - 1)*2*N + p];
		hawser_trajectory_clear(&run);
	}
	memcpy(K1, first, sizeof first);
	memcpy(K2, second, sizeof second);
	if (!hawser_floquet_product(log_modulus, argument, monodromy, 1, 2*N, NULL))
		result = exp(log_modulus[0]);
	return result;
}

static double check_values(const struct hawser_map *map, struct hawser_rom *rom)
{
	double worst = 0.0;

	if (hawser_rom_compile(rom, NULL))
		return NAN;
	for (int k = 0; k < 24; k++) {
		int i = (37*k + 11)%POINTS, j = (53*k + 19)%POINTS;
		double got = map->point[j*POINTS + i].sample.value;
		double want = integrated(rom, map->x[i], map->y[j]);

		worst = fmax(worst, fabs(got/want - 1.0));
	}
	return worst;
}

static int differences(const struct hawser_map *a, const struct hawser_map *b, int values)
{
	int count = 0;

	for (int p = 0; p < POINTS*POINTS; p++) {
		const struct hawser_map_sample *x = &a->point[p].sample, *y = &b->point[p].sample;

		count += x->number != y->number || x->code != y->code ||
		         (values && memcmp(&x->value, &y->value, sizeof x->value) != 0);
	}
	return count;
}

int main(void)
{
	static const struct {
		const char *name;
		int coarse, threads;
		double tolerance;
	} run[] = {{"every point, 1 thread", 1, 1, 0.9}, {"every point, all threads", 1, 0, 0.9},
		{"adaptive, 1 thread", 8, 1, 0.9}, {"adaptive, all threads", 8, 0, 0.9},
		{"adaptive, boundaries to 1e-4", 8, 0, 1e-4}};
	enum { RUNS = sizeof run/sizeof *run };
	struct hawser_map map[RUNS];
	struct hawser_rom rom;
	int bad = 0, other;
	double worst;

	openblas_set_num_threads(1);
	fill(&rom);
	puts("map: 200 x 200 points of a model of six coordinates, multipliers");
	puts("run                           computed  boundary  wall s  cpu s  us a point");
	for (int k = 0; k < RUNS; k++) {
		double wall, cpu;

		if (trace(&map[k], &rom, run[k].coarse, run[k].threads, run[k].tolerance, &wall, &cpu))
			return 1;
		printf("%-29s %8ld  %8d  %6.2f  %5.2f  %10.1f\n", run[k].name, map[k].visited,
		       map[k].boundaries, wall, cpu, 1e6*cpu/(double)map[k].visited);
	}
	worst = check_values(&map[0], &rom);
	other = differences(&map[0], &map[2], 0);
	bad = !(worst < 1e-8) || differences(&map[0], &map[1], 1) || differences(&map[2], &map[3], 1);
	printf("largest multipliers: within %.1e of integrations; threads: %s; adaptive: another number at "
	       "%d of %d nodes\n", worst, bad ? "SEE ABOVE" : "the same bits", other, POINTS*POINTS);
	for (int k = 0; k < RUNS; k++)
		hawser_map_clear(&map[k]);
	return bad || other > POINTS*POINTS/100;
}
