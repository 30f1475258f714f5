/* bench/waves - the water of a sea at 40 places that move, at steps of 0.05 s with three iterations
 * each: the direct sum over 400 components against water/near.h. Errors over the root of the mean
 * square of the velocity of all places, processor time of one evaluation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include <hawser/waves.h>

#include "bench/clock.h"
#include "water/near.h"

enum { PLACES = 40, STEPS = 400, ITERATIONS = 3 };

struct result {
	double u, du, elevation; /* largest errors; the sum of squares of u */
	double square;
	double seconds[2];       /* near, direct */
};

static void where(double x[3], int place, double t, double depth)
{
	x[0] = 10.0*place + 3.0*sin(0.57*t + 1.0);
	x[1] = -fmin(depth - 1.0, 200.0)*place/PLACES + 2.0*sin(0.6*t);
	x[2] = 0.1*place;
}

static void compare(struct result *result, struct hawser__near *near, const struct hawser_waves *waves,
                    double t)
{
	static struct hawser_wave_flow got[PLACES], want[PLACES];
	double x[PLACES][3], start;

	for (int i = 0; i < PLACES; i++)
		where(x[i], i, t, waves->depth);
	start = cpu_secs();
	for (int n = 0; n < ITERATIONS; n++)
		for (int i = 0; i < PLACES; i++)
			hawser__near_at(&got[i], near, i, x[i], t + 1e-9*n);
	result->seconds[0] += cpu_secs() - start;
	start = cpu_secs();
	for (int n = 0; n < ITERATIONS; n++)
		for (int i = 0; i < PLACES; i++)
			hawser_waves_at(&want[i], waves, x[i], t + 1e-9*n);
	result->seconds[1] += cpu_secs() - start;
	for (int i = 0; i < PLACES; i++) {
		for (int k = 0; k < 3; k++) {
			result->u = fmax(result->u, fabs(got[i].u[k] - want[i].u[k]));
			result->du = fmax(result->du, fabs(got[i].du[k] - want[i].du[k]));
			result->square += want[i].u[k]*want[i].u[k];
		}
		result->elevation = fmax(result->elevation, fabs(got[i].elevation - want[i].elevation));
	}
}

int main(void)
{
	static const char *const name[] = {"wheeler", "none", "vertical", "extrapolate"};
	const double calls = (double)PLACES*STEPS*ITERATIONS;

	printf("stretching\tdepth_m\terror_u\terror_du\terror_elevation\tnear_us\tdirect_us\tratio\n");
	for (int n = 0; n < 8; n++) {
		struct hawser_waves_given given = {.Hs = 5.0, .Tp = 11.0, .depth = n < 4 ? 200.0 : 60.0,
			.seed = n, .stretching = (enum hawser_wave_stretching)(n%4)};
		struct hawser_report report = {0};
		struct hawser_waves waves;
		struct hawser__near *near = NULL;
		struct result r = {0};

		if (hawser_waves_make(&waves, &given, &report) ||
		    hawser__near_open(&near, &waves, PLACES, &report)) {
			fprintf(stderr, "waves: %s\n", report.message);
			return 1;
		}
		for (int step = 0; step < STEPS; step++)
			compare(&r, near, &waves, 0.05*step);
		r.square = sqrt(r.square/(PLACES*STEPS));
		printf("%s\t%g\t%.1e\t%.1e\t%.1e\t%.2f\t%.2f\t%.1f\n", name[n%4], given.depth, r.u/r.square,
		       r.du/r.square, r.elevation/r.square, 1e6*r.seconds[0]/calls, 1e6*r.seconds[1]/calls,
		       r.seconds[1]/r.seconds[0]);
		hawser__near_free(near);
		hawser_waves_clear(&waves);
	}
	return 0;
}
