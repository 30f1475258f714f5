/* Along a line through random models, damped and undamped, with and without a gyroscopic part, the
 * number of unstable multipliers at each of many points is that of the map's boundaries, and where it
 * changes hill has a boundary. The multipliers are computed directly, without any search.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>
#include <stdlib.h>

#include <hawser/hill.h>
#include <hawser/linear.h>
#include <hawser/map.h>

#include "tests/tap.h"

enum { N = 3, SAMPLES = 600 };
static const double low = 0.9, high = 3.7, row = 0.5;

static uint64_t chance = 2385;

static double between(double from, double to)
{
	chance = chance*6364136223846793005u + 1442695040888963407u;
	return from + (to - from)*(double)(chance >> 11)/9007199254740992.0;
}

struct model {
	double K[N*N], D[N*N], K1[N*N], K2[N*N];
	struct hawser_harmonic harmonic[2];
	struct hawser_rom rom;
};

static void draw(struct model *to, int damped)
{
	double w = 1.0, strength = between(0.05, 0.35), turn = between(0.0, 0.2);

	*to = (struct model){.harmonic = {{.k = 1, .phase = HAWSER_COS, .K = to->K1},
	                                  {.k = 2, .phase = HAWSER_COS, .K = to->K2}}};
	for (int j = 0; j < N; j++, w += between(0.3, 0.8)) {
		to->K[j*(N + 1)] = w*w;
		to->D[j*(N + 1)] = damped ? between(0.004, 0.03)*w : 0.0;
	}
	for (int j = 0; j < N; j++)
		for (int k = 0; k <= j; k++) {
			double size = sqrt(to->K[j*(N + 1)]*to->K[k*(N + 1)]);

			to->K1[j*N + k] = to->K1[k*N + j] = strength*between(-1.0, 1.0)*size;
			to->K2[j*N + k] = to->K2[k*N + j] = 0.3*strength*between(-1.0, 1.0)*size;
			if (k < j) {
				to->D[j*N + k] = turn;
				to->D[k*N + j] = -turn;
			}
		}
	to->rom = (struct hawser_rom){.n = N, .K = to->K, .D = to->D, .harmonics = 2,
		.harmonic = to->harmonic, .length = 1.0, .time = 1.0, .force = 1.0};
}

/* The number of unstable multipliers at x by the map's boundaries on the row; -1: within a bracket. */
static int by_map(const struct hawser_map *map, double x)
{
	double nearest = -INFINITY;
	int number = map->point[map->nx*(map->ny/2)].sample.number;

	for (int k = 0; k < map->boundaries; k++) {
		const struct hawser_map_boundary *b = &map->boundary[k];

		if (b->along != 0 || fabs(b->y - row) > 1e-9)
			continue;
		if (fabs(b->x - x) < fmax(b->width, 1e-4))
			return -1;
		if (b->x < x && b->x > nearest) {
			nearest = b->x;
			number = b->number[1];
		}
	}
	return number;
}

/* Whether hill has a boundary on the row between a and b. */
static int by_hill(const struct hawser_hill_chart *chart, double a, double b)
{
	for (int c = 0; c < chart->boundaries; c++)
		for (int i = 0; i + 1 < chart->boundary[c].points; i++) {
			const double *p = chart->boundary[c].at + 2*i, *q = p + 2;
			double x;

			if ((p[1] > row) == (q[1] > row))
				continue;
			x = p[0] + (q[0] - p[0])*(row - p[1])/(q[1] - p[1]);
			if (x > a && x < b)
				return 1;
		}
	return 0;
}

/* The number of unstable multipliers; -1: some are within their errors of the circle, with damping. */
static int directly(struct hawser_linear *linear, const struct model *model, double x, int damped)
{
	double log_modulus[2*N], argument[2*N], K[2][N*N];
	struct hawser_harmonic harmonic[2] = {model->harmonic[0], model->harmonic[1]};
	struct hawser_rom rom = model->rom;
	int count = 0;

	for (int h = 0; h < 2; h++) {
		for (int e = 0; e < N*N; e++)
			K[h][e] = row*model->harmonic[h].K[e];
		harmonic[h].K = K[h];
	}
	rom.harmonic = harmonic;
	if (hawser_linear_multipliers(linear, log_modulus, argument, NULL, &rom, x, NULL))
		return -1;
	for (int i = 0; i < 2*N; i++) {
		if (damped ? fabs(log_modulus[i]) < 1e-6 : log_modulus[i] > 1e-8 && log_modulus[i] < 1e-5)
			return -1;
		count += log_modulus[i] > 1e-8;
	}
	return count;
}

static void compare(int damped)
{
	struct model model;
	struct hawser_map_source source = {.rom = &model.rom, .key = {"Omega", "factor.load"},
		.quantity = "multiplier"};
	struct hawser_map_options options = {.from = {low, 0.0}, .to = {high, 2.0*row},
		.points = {57, 17}, .threads = 1};
	struct hawser_hill_options choice = {.from = {low, 0.0}, .to = {high, 2.0*row}, .lines = 4,
		.samples = 80};
	struct hawser_map_field field = {.name = NULL};
	struct hawser_hill_field plane = {.m = 0};
	struct hawser_map map = {.nx = 0};
	struct hawser_hill_chart chart = {.boundaries = 0};
	struct hawser_linear *linear = NULL;
	int failed, wrong = 0, lost = 0, before = -1, changes = 0, limited = 0;
	double step = (high - low)/SAMPLES, at = 0.0;

	draw(&model, damped);
	failed = hawser_map_cable_open(&field, &source, NULL) ||
	         hawser_map_trace(&map, &field, &options, NULL) ||
	         hawser_hill_cable_open(&plane, &source, NULL) ||
	         hawser_hill_trace(&chart, &plane, &choice, NULL) || hawser_linear_open(&linear, N, NULL);
	for (int i = 0; !failed && i <= SAMPLES; i++) {
		double x = low + i*step;
		int number = directly(linear, &model, x, damped), mapped = by_map(&map, x);

		if (number >= 0 && mapped >= 0 && number != mapped) {
			wrong++;
			at = x;
		}
		if (number >= 0 && before >= 0 && number != before) {
			changes++;
			if (!by_hill(&chart, x - 2.0*step, x + step)) {
				lost++;
				at = x;
			}
		}
		before = number;
	}
	for (int b = 0; b < chart.boundaries; b++)
		limited += chart.boundary[b].limited;
	/* a map does not resolve a stable gap between two tongues of one kind that is narrower than a cell,
	 * as without damping near their tips */
	ok(!failed && wrong <= (damped ? 0 : SAMPLES/200), "%s: map has the number of %d points, but for "
	   "%d (the last at %.6f)", damped ? "damped" : "undamped", SAMPLES + 1, wrong, at);
	ok(!failed && lost == 0 && limited == 0, "hill has the %d changes, but for %d (the last at %.6f)",
	   changes, lost, at);
	hawser_linear_free(linear);
	hawser_map_clear(&map);
	hawser_hill_clear(&chart);
	hawser_map_cable_close(&field);
	hawser_hill_cable_close(&plane);
}

CASE(property_tongues)
{
	int models = getenv("HAWSER_LONG") ? 60 : 1;

	for (int i = 0; i < models; i++) {
		compare(1);
		compare(0);
	}
	return done_testing();
}
