/* bench/events.c - events of random models, traced both ways: how many are unexplained, suspected or
 * not located, and how many are found from one side only.
 *
 *     bench/events [FIRST [COUNT [CLASS]]]      models FIRST .. FIRST + COUNT - 1 (1, 100)
 *
 * A model of class 1 has 1 to 6 coordinates, quadratic and cubic terms of a potential, some damping,
 * one harmonic of load or two, and sometimes a parametric one. One of class 2 has three coordinates,
 * gyroscopic terms, stronger quadratic terms, and parametric terms in two harmonics. The curve is
 * traced over the lowest resonance, and then back from its last point; a curve may have 4000 points.
 * An event is found again if one of the same kind lies within three times the sum of both stated
 * errors (at least 1e-7, relative); each serves once. A line is written for each event that is not,
 * and for each that is unexplained.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/hawser.h>

#include "rom/build/model.h"

enum { MOST_POINTS = 4000, KINDS = HAWSER_SLACK + 1 };
static const double times_error = 3.0, least_error = 1e-7;

struct count {
	int models, refused, failed, events[KINDS], suspected, unlocated, lost, other_way;
	int ends[HAWSER_END_LOST + 1];
	long points;
};

static uint64_t state;

static double uniform(double low, double high)
{
	state = state*UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
	return low + (high - low)*(double)(state >> 11)/9007199254740992.0;
}

static void cubic(struct hawser_rom *rom, int j, int a, int b, int c, double value)
{
	int low = a < b ? a : b, high = a < b ? b : a;

	rom->C[rom->cubics++] = (struct hawser_cubic){
		j, c < low ? c : low, c < low ? low : c < high ? c : high, c > high ? c : high, value};
}

/* Terms of a random potential: of u_a u_b u_c, of u_a^2 u_b^2 and of u_a^4. */
static void terms(struct hawser_rom *rom, double least_square)
{
	int n = rom->n, count = 2*n;
	double square = least_square + uniform(0.0, 0.6), cube = uniform(0.02, 0.5);

	rom->Q = calloc(3*(size_t)count, sizeof *rom->Q);
	rom->C = calloc(2*(size_t)count + (size_t)n, sizeof *rom->C);
	for (int e = 0; e < count; e++) {
		int i[3] = {(int)uniform(0.0, n), (int)uniform(0.0, n), (int)uniform(0.0, n)};
		double a = square*uniform(-1.0, 1.0)/n, c = cube*uniform(0.0, 1.0)/n;

		for (int k = 0; k < 3; k++) {
			int p = i[(k + 1)%3], q = i[(k + 2)%3];

			rom->Q[rom->quads++] = (struct hawser_quad){i[k], p < q ? p : q, p < q ? q : p, a};
		}
		cubic(rom, i[0], i[0], i[1], i[1], c);
		cubic(rom, i[1], i[1], i[0], i[0], c);
	}
	for (int j = 0; j < n; j++)
		cubic(rom, j, j, j, j, 0.5*cube);
}

/* Gyroscopic terms, and symmetric parametric ones of both harmonics. */
static void couple(struct hawser_rom *rom)
{
	int n = rom->n;

	for (int i = 0; i < n; i++)
		for (int j = 0; j < i; j++) {
			double gyroscopic = uniform(-0.5, 0.5);

			rom->D[i*n + j] += gyroscopic;
			rom->D[j*n + i] -= gyroscopic;
		}
	for (int h = 0; h < rom->harmonics; h++) {
		if (!rom->harmonic[h].K)
			rom->harmonic[h].K = calloc((size_t)n*(size_t)n, sizeof(double));
		for (int i = 0; i < n; i++)
			for (int j = 0; j <= i; j++)
				rom->harmonic[h].K[i*n + j] = rom->harmonic[h].K[j*n + i] =
					uniform(-1.0, 1.0)*(i == j ? 0.3 : 0.15);
	}
}

static int model(struct hawser_rom *rom, int coupled)
{
	int n = coupled ? 3 : (int)uniform(1.0, 7.0);
	double w = 1.0, damping = exp(uniform(log(0.005), log(0.08)));

	if (hawser__rom_init(rom, n, NULL))
		return 1;
	for (int j = 0; j < n; j++) {
		rom->K[j*(n + 1)] = w*w;
		rom->D[j*(n + 1)] = 2.0*damping*w*uniform(0.5, 2.0);
		w *= uniform(1.02, 2.2);
	}
	terms(rom, coupled ? 0.3 : 0.0);
	rom->harmonics = 1 + (coupled || uniform(0.0, 1.0) < 0.4);
	rom->harmonic = calloc(2, sizeof *rom->harmonic);
	for (int h = 0; h < rom->harmonics; h++) {
		rom->harmonic[h] = (struct hawser_harmonic){.k = h + 1, .phase = h ? HAWSER_SIN : HAWSER_COS};
		rom->harmonic[h].f = calloc((size_t)n, sizeof(double));
		for (int j = 0; j < n; j++)
			rom->harmonic[h].f[j] = uniform(-1.0, 1.0)*(h ? 0.1 : 0.25);
		if (h && uniform(0.0, 1.0) < 0.5) {
			rom->harmonic[h].K = calloc((size_t)n*(size_t)n, sizeof(double));
			for (int j = 0; j < n; j++)
				rom->harmonic[h].K[j*(n + 1)] = uniform(0.0, 0.3);
		}
	}
	if (coupled)
		couple(rom);
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

static int again(const struct hawser_frf_event *event, const struct hawser_frf *other,
                 unsigned char *used)
{
	for (int i = 0; i < other->events; i++) {
		const struct hawser_frf_event *to = &other->event[i];
		double reach = fmax(times_error*(event->error + to->error), least_error);

		if (used[i] || to->kind != event->kind ||
		    !(fabs(to->omega - event->omega) <= reach*event->omega))
			continue;
		used[i] = 1;
		return 1;
	}
	return 0;
}

static void line(int seed, const char *what, const struct hawser_rom *rom,
                 const struct hawser_frf_event *event)
{
	printf("%d\t%s\tn %d\t%s\tOmega %.10g\terror %.1e\tresidual %.1e\t%d to %d unstable%s\n", seed,
	       what, rom->n, hawser_event_name(event->kind), event->omega, event->error, event->residual,
	       event->unstable[0], event->unstable[1], event->suspected ? ", suspected" : "");
}

/* Events of `frf` that `other` has not. */
static int compare(int seed, const char *what, const struct hawser_rom *rom,
                   const struct hawser_frf *frf, const struct hawser_frf *other)
{
	unsigned char *used = calloc((size_t)other->events + 1, 1);
	int lost = 0;

	for (int i = 0; used && i < frf->events; i++)
		if (!again(&frf->event[i], other, used)) {
			line(seed, what, rom, &frf->event[i]);
			lost++;
		}
	free(used);
	return lost;
}

static void one(struct count *count, int seed, int coupled)
{
	struct hawser_frf_options options = {.samples = HAWSER_NONE, .max_points = MOST_POINTS};
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_frf there, back;
	struct hawser_rom rom;
	enum hawser_status status;
	const struct hawser_frf_point *last;

	state = (uint64_t)seed*UINT64_C(0x9e3779b97f4a7c15);
	uniform(0.0, 1.0);
	if (model(&rom, coupled))
		return;
	options.from = uniform(0.45, 0.85);
	options.to = uniform(1.15, 2.6);
	count->models++;
	status = hawser_frf_trace(&there, &rom, &options, &report);
	if (there.points < 3) {
		count->refused++;
		printf("%d\tno curve\tn %d\t%s\n", seed, rom.n, report.message);
		goto done;
	}
	if (status) {
		count->failed++;
		printf("%d\tends at %.6g\tn %d\t%s\n", seed, there.point[there.points - 1].omega, rom.n,
		       report.message);
	}
	count->ends[there.end]++;
	count->points += there.points;
	for (int i = 0; i < there.events; i++) {
		const struct hawser_frf_event *event = &there.event[i];

		count->events[event->kind]++;
		count->suspected += event->suspected;
		count->unlocated += !event->located && event->kind != HAWSER_UNEXPLAINED;
		if (event->kind == HAWSER_UNEXPLAINED || event->suspected || !event->located)
			line(seed, "there", &rom, event);
	}
	if (there.end == HAWSER_END_CLOSED)
		goto done;
	last = &there.point[there.points - 1];
	options.begin = last->omega;
	options.direction = -last->direction;
	options.start = there.state + 2*(size_t)rom.n*(size_t)(there.points - 1);
	options.max_points = 2*MOST_POINTS;
	status = hawser_frf_trace(&back, &rom, &options, &report);
	if (status || back.points < 3)
		printf("%d\tback ends at %.6g\tn %d\t%s\n", seed,
		       back.points ? back.point[back.points - 1].omega : options.begin, rom.n, report.message);
	else {
		count->lost += compare(seed, "not from behind", &rom, &there, &back);
		count->other_way += compare(seed, "from behind only", &rom, &back, &there);
	}
	hawser_frf_clear(&back);
done:
	hawser_frf_clear(&there);
	hawser_rom_clear(&rom);
}

int main(int argc, char **argv)
{
	int first = argc > 1 ? atoi(argv[1]) : 1, models = argc > 2 ? atoi(argv[2]) : 100;
	struct count count = {0};

	for (int seed = first; seed < first + models; seed++) {
		one(&count, seed, argc > 3 && atoi(argv[3]) == 2);
		fflush(stdout);
	}
	printf("models %d, without a curve %d, that ended before the range %d, points %ld\n", count.models,
	       count.refused, count.failed, count.points);
	for (int k = 0; k < KINDS; k++)
		printf("%s %d\n", hawser_event_name((enum hawser_event_kind)k), count.events[k]);
	for (int k = 0; k <= HAWSER_END_LOST; k++)
		if (count.ends[k])
			printf("end: %s %d\n", hawser_frf_end_name((enum hawser_frf_end)k), count.ends[k]);
	printf("suspected %d, not located %d, not found from behind %d, found from behind only %d\n",
	       count.suspected, count.unlocated, count.lost, count.other_way);
	return 0;
}
