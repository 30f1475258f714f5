/* Boundaries of stability by determinants of Hill matrices, compared with multipliers: at each
 * point one multiplier is +1 or -1, or a complex pair is on the unit circle; and boundaries traced
 * by multipliers alone are the same curves. Damped models, gyroscopic ones with varying damping,
 * undamped ones, and a stiff beam of ten modes, whose fast coordinates no step must resolve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdint.h>
#include <stdlib.h>

#include <hawser/hill.h>

#include "rom/build/model.h"
#include "tests/tap.h"

enum { MOST = 10 };
enum kind { DAMPED, GYROSCOPIC, UNDAMPED };
static const char *const names[] = {"damped", "gyroscopic", "undamped"};

static uint64_t chance = 2385;

static double between(double low, double high)
{
	chance = chance*6364136223846793005u + 1442695040888963407u;
	return low + (high - low)*(double)(chance >> 11)/9007199254740992.0;
}

/* A beam: frequencies j^2, and an axial load that varies in time and increases along the beam. With
 * a speed, also the gyroscopic matrices of its mean and of its fluctuation. */
static int beam(struct hawser_rom *rom, int n, enum kind kind)
{
	double growth = between(0.3, 1.2), ratio = kind == UNDAMPED ? 0.0 : between(0.003, 0.01);
	double *K, *D = NULL;

	if (hawser__rom_init(rom, n, NULL))
		return 1;
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0].k = 1;
	rom->harmonic[0].K = K = calloc((size_t)n*(size_t)n, sizeof *K);
	if (kind == GYROSCOPIC)
		rom->harmonic[0].D = D = calloc((size_t)n*(size_t)n, sizeof *D);
	for (int i = 0; i < n; i++) {
		double a = i + 1, w = a*a;

		rom->K[i*n + i] = w*w;
		rom->D[i*n + i] = 2.0*ratio*w;
		for (int j = 0; j < n; j++) {
			double b = j + 1, far = (a - b)*(a - b), sum = (a + b)*(a + b);

			if (i == j)
				K[i*n + j] = 0.4*a*a;
			else if ((i - j)%2)
				K[i*n + j] = -0.4*growth*2.0*a*b/(M_PI*M_PI)*(1.0/far + 1.0/sum);
			if (D && (i - j)%2) {
				D[i*n + j] = 0.2*4.0*a*b/(a*a - b*b)/M_PI;
				rom->D[i*n + j] += D[i*n + j];
			}
		}
	}
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* Smallest distance between multiplier i and another one, off the real axis. */
static double nearest_other(const double *log_modulus, const double *argument, int i)
{
	double best = INFINITY;

	for (int j = 0; j < i; j++)
		best = fmin(best, cabs(cexp(log_modulus[i] + I*argument[i]) -
		                       cexp(log_modulus[j] + I*argument[j])));
	return best;
}

/* Distance of the multipliers at a point from a boundary of this kind: from +1 or -1; for a torus
 * point from the unit circle or, without damping, where all are on it, from each other. */
static double distance(const struct hawser_hill_field *field, int kind, const double at[2],
                       int undamped)
{
	double log_modulus[2*MOST], argument[2*MOST], best = INFINITY;

	if (field->multipliers(field->context, log_modulus, argument, at[0], at[1], NULL))
		return NAN;
	for (int i = 0; i < field->m; i++) {
		double turn = kind == HAWSER_HILL_PLUS ? argument[i] : remainder(argument[i] - M_PI, 2.0*M_PI);

		if (kind != HAWSER_HILL_TORUS)
			best = fmin(best, hypot(log_modulus[i], turn));
		else if (fabs(sin(argument[i])) > 1e-4)
			best = fmin(best, undamped ? nearest_other(log_modulus, argument, i)
			                           : fabs(log_modulus[i]));
	}
	return best;
}

/* Distance, relative to the rectangle, of a point from the nearest piece of a boundary of its
 * kind. */
static double apart(const struct hawser_hill_chart *chart, int kind, const double at[2],
                    const struct hawser_hill_options *options)
{
	double best = INFINITY;

	for (int b = 0; b < chart->boundaries; b++) {
		const struct hawser_hill_boundary *boundary = &chart->boundary[b];

		for (int i = 0; (int)boundary->kind == kind && i + 1 < boundary->points; i++) {
			double d[2], r[2], s;

			for (int k = 0; k < 2; k++) {
				double wide = options->to[k] - options->from[k];

				d[k] = (boundary->at[2*i + 2 + k] - boundary->at[2*i + k])/wide;
				r[k] = (at[k] - boundary->at[2*i + k])/wide;
			}
			s = fmin(1.0, fmax(0.0, (r[0]*d[0] + r[1]*d[1])/(d[0]*d[0] + d[1]*d[1])));
			best = fmin(best, hypot(r[0] - s*d[0], r[1] - s*d[1]));
		}
	}
	return best;
}

struct seen {
	double worst; /* distance of a multiplier at a point */
	int points, lost;
};

static void look(struct seen *seen, const struct hawser_hill_chart *chart,
                 const struct hawser_hill_field *field, int undamped, int every)
{
	for (int b = 0; b < chart->boundaries; b++)
		for (int i = 0; i < chart->boundary[b].points; i += every, seen->points++) {
			double off = distance(field, (int)chart->boundary[b].kind, chart->boundary[b].at + 2*i,
			                      undamped);

			seen->worst = isfinite(off) ? fmax(seen->worst, off) : INFINITY;
		}
}

/* Number of points of `of` that are not near a boundary of `chart`. */
static int missed(const struct hawser_hill_chart *chart, const struct hawser_hill_chart *of,
                  const struct hawser_hill_field *field, int undamped,
                  const struct hawser_hill_options *options)
{
	int lost = 0;

	for (int b = 0; b < of->boundaries; b++)
		for (int i = 0; i < of->boundary[b].points; i++) {
			const double *at = of->boundary[b].at + 2*i;
			int kind = (int)of->boundary[b].kind;

			/* by multipliers alone, a product of 1 of two real multipliers also counts */
			if (kind == HAWSER_HILL_TORUS && !(distance(field, kind, at, undamped) < 1e-3))
				continue;
			/* a curve ends just before the tip of a tongue */
			lost += apart(chart, kind, at, options) > 1e-2;
		}
	return lost;
}

/* A beam, the field of its stability, and its boundaries. */
struct chart {
	struct hawser_rom rom;
	struct hawser_map_source source;
	struct hawser_hill_field field;
	struct hawser_hill_options options;
	struct hawser_hill_chart own, plain; /* by determinants; by multipliers alone */
};

/* Returns 1 if it fails. */
static int open_chart(struct chart *chart, enum kind kind, int n, double from, double to, int lines,
                      int samples, double step)
{
	*chart = (struct chart){.source = {.rom = &chart->rom, .key = {"Omega", "factor.load"}}};
	chart->options.from[0] = from;
	chart->options.to[0] = to;
	chart->options.to[1] = 1.0;
	chart->options.lines = lines;
	chart->options.samples = samples;
	chart->options.step = step;
	return beam(&chart->rom, n, kind) ||
	       hawser_hill_cable_open(&chart->field, &chart->source, NULL) ||
	       hawser_hill_trace(&chart->own, &chart->field, &chart->options, NULL);
}

static void close_chart(struct chart *chart)
{
	hawser_hill_clear(&chart->own);
	hawser_hill_clear(&chart->plain);
	hawser_hill_cable_close(&chart->field);
	hawser_rom_clear(&chart->rom);
}

/* Of a search: calls until it ends. */
static int end_later(void *left, const struct hawser_progress_state *state)
{
	(void)state;
	return --*(int *)left <= 0;
}

/* Ended early: no failure, what was found so far, and not much more work. */
static void check_end(const struct chart *chart)
{
	struct hawser_hill_options options = chart->options;
	for (int calls = 1; calls < 200; calls *= 12) {
		struct hawser_hill_chart ended;
		int left = calls, failed;

		options.progress = (struct hawser_progress){end_later, &left};
		failed = hawser_hill_trace(&ended, &chart->field, &options, NULL) != HAWSER_OK;
		ok(!failed && ended.interrupted && ended.boundaries <= chart->own.boundaries &&
		   ended.evaluations < chart->own.evaluations, "ended by call %d: %d boundaries, %ld "
		   "evaluations", calls, ended.boundaries, ended.evaluations);
		hawser_hill_clear(&ended);
	}
}

static void compare(enum kind kind, int n)
{
	/* multipliers that coincide at +-1 or on the circle move with the square root of a distance */
	double limit = kind == UNDAMPED ? 1e-4 : 1e-6;
	struct hawser_hill_field plain;
	struct seen seen = {.worst = 0.0};
	struct chart chart;
	int failed = open_chart(&chart, kind, n, 1.0, 5.3, 2, 60, 0.02);

	if (!failed)
		check_end(&chart);
	plain = chart.field;
	plain.model = NULL;
	plain.prepare = NULL;
	failed = failed || hawser_hill_trace(&chart.plain, &plain, &chart.options, NULL);
	if (ok(!failed && chart.own.boundaries > 1, "%s, %d modes: %d boundaries, %ld evaluations; by "
	       "multipliers alone %d, %ld", names[kind], n, chart.own.boundaries, chart.own.evaluations,
	       chart.plain.boundaries, chart.plain.evaluations)) {
		look(&seen, &chart.own, &chart.field, kind == UNDAMPED, 3);
		ok(seen.points > 20 && seen.worst < limit, "at %d points the multipliers say the same "
		   "within %.1e", seen.points, seen.worst);
		seen.lost = missed(&chart.own, &chart.plain, &chart.field, kind == UNDAMPED, &chart.options);
		ok(seen.lost == 0, "%d points of the others are missed", seen.lost);
	}
	close_chart(&chart);
}

/* Ten modes, frequencies from 1 to 100: boundaries by multipliers of condensed coordinates took a
 * minute and more. All coordinates enter a determinant. */
static void stiff(enum kind kind, int n, double from, double to)
{
	struct seen seen = {.worst = 0.0};
	struct chart chart;
	int failed = open_chart(&chart, kind, n, from, to, 1, 12, 0.05);

	ok(!failed && chart.own.boundaries > 0 && chart.own.evaluations < 3000, "%s, %d modes: %d "
	   "boundaries, %ld evaluations", names[kind], n, chart.own.boundaries, chart.own.evaluations);
	look(&seen, &chart.own, &chart.field, 0, kind == GYROSCOPIC ? 20 : 4);
	/* the beam's multipliers are those of a condensed model with a stated error of 1e-5 */
	ok(seen.points > 1 && seen.worst < 1e-4, "at %d points the multipliers say the same within %.1e",
	   seen.points, seen.worst);
	close_chart(&chart);
}

CASE(property_hill_boundaries)
{
	compare(DAMPED, 3);
	compare(GYROSCOPIC, 3);
	if (getenv("HAWSER_LONG")) /* narrow tongues of high orders, which need many steps */
		compare(UNDAMPED, 2);
	stiff(DAMPED, MOST, 1.85, 2.25);
	stiff(GYROSCOPIC, getenv("HAWSER_LONG") ? MOST : 5, 1.85, 2.25);
	return done_testing();
}
