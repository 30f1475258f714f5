/* response/torus/torus_measure.c - how large the motions on a torus are.
 *
 *    theta     of the circle, at MANY N places
 *    window    u over a period of the load from its phase 0, of the motion that begins at theta, and
 *              SIDE steps before and after; those before end periods that began at theta - rho
 *
 * A period of a quasi-periodic motion does not close, so that the Fourier interpolation of amplitude.c
 * is not possible. The largest value in a period is that of the polynomial of degree 4 through
 * derivatives from seven samples about each local maximum, and the largest or least over theta that of
 * the parabola through three neighbours. Where two maxima of a period are equal, or one leaves the
 * period as another enters it, the largest value has a kink over theta; there the least one is where
 * the parabolas of both sides meet.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/torus/torus.h"
#include "rom/energy/kernel.h"

enum { MANY = 4, SIDE = 3 }; /* samples of theta per point; samples on each side of a maximum; chosen */
#define SHARP 2.0 /* change of slope in a kink, relative to that in a step beside it; chosen */
#define FINEST 120 /* least number of samples a period; chosen */

struct hawser__torus_ruler {
	const struct hawser_rom *rom;
	size_t room, signals; /* doubles in memory; signals: coordinates and displacements */
	double *memory;
};

struct hawser__torus_ruler *hawser__torus_ruler_new(const struct hawser_rom *rom)
{
	struct hawser__torus_ruler *ruler = calloc(1, sizeof *ruler);

	if (ruler) {
		ruler->rom = rom;
		ruler->signals = (size_t)rom->n + 3*(size_t)rom->shapes.points;
	}
	return ruler;
}

void hawser__torus_ruler_free(struct hawser__torus_ruler *ruler)
{
	if (ruler)
		free(ruler->memory);
	free(ruler);
}

/* Largest value about sample f[0], which is not less than its neighbours. */
static double top(const double *f)
{
	double b1 = f[1] - f[-1], b2 = f[2] - f[-2], b3 = f[3] - f[-3];
	double s1 = f[1] + f[-1], s2 = f[2] + f[-2], s3 = f[3] + f[-3];
	double d1 = 0.75*b1 - 0.15*b2 + b3/60.0;
	double d2 = -49.0/18.0*f[0] + 1.5*s1 - 0.15*s2 + s3/90.0;
	double d3 = -1.625*b1 + b2 - 0.125*b3;
	double d4 = 28.0/3.0*f[0] - 6.5*s1 + 2.0*s2 - s3/6.0, t = 0.0;

	for (int k = 0; k < 4; k++) {
		double slope = d1 + t*(d2 + t*(d3/2.0 + t*d4/6.0)), bend = d2 + t*(d3 + t*d4/2.0);

		if (!(bend < 0.0))
			return f[0];
		t = fmax(-1.0, fmin(1.0, t - slope/bend));
	}
	return fmax(f[0], f[0] + t*(d1 + t*(d2/2.0 + t*(d3/6.0 + t*d4/24.0))));
}

/* Largest modulus of the samples f [steps + 2 SIDE] but for the first and last SIDE; `work` is as
 * long. */
static double largest(const double *f, double *work, int steps)
{
	double most = 0.0;

	for (int sign = -1; sign < 2; sign += 2) {
		for (int i = 0; i < steps + 2*SIDE; i++)
			work[i] = sign*f[i];
		for (int i = SIDE; i < steps + SIDE; i++)
			if (work[i] >= work[i - 1] && work[i] >= work[i + 1])
				most = fmax(most, top(work + i));
			else
				most = fmax(most, work[i]);
		most = fmax(most, work[steps + SIDE]); /* the end of the period */
	}
	return most;
}

/* Largest value of a periodic function with these samples. */
static double greatest(const double *f, int count, size_t stride)
{
	double best = -HUGE_VAL;

	for (int i = 0; i < count; i++) {
		double b = f[(size_t)i*stride], a = f[(size_t)((i + count - 1)%count)*stride];
		double c = f[(size_t)((i + 1)%count)*stride], bend = 2.0*b - a - c;

		if (b >= a && b >= c)
			best = fmax(best, b + (bend > 0.0 ? 0.125*(c - a)*(c - a)/bend : 0.0));
	}
	return best;
}

/* Value at t of the parabola through a, b, c at t = -2, -1, 0; *slope there, *bend. */
static double parabola(double *slope, double *bend, double a, double b, double c, double t)
{
	double first = 0.5*(a - 4.0*b + 3.0*c);

	*bend = a - 2.0*b + c;
	*slope = first + *bend*t;
	return c + t*(first + 0.5**bend*t);
}

/* Value where the parabolas through f[0..2] and f[3..5] meet between f[2] and f[3], if that is a kink
 * downwards; else the lesser of the two. */
static double kink(const double f[6])
{
	double lo = 0.0, hi = 1.0, value = 0.0, left, right, bend[2];

	if (!(f[2] < f[1] && f[3] < f[4]))
		return fmin(f[2], f[3]);
	for (int k = 0; k < 40; k++) {
		double t = 0.5*(lo + hi), other = parabola(&right, &bend[1], f[5], f[4], f[3], 1.0 - t);

		value = parabola(&left, &bend[0], f[0], f[1], f[2], t);
		if (value > other)
			lo = t;
		else
			hi = t;
	}
	if (lo == 0.0 || hi == 1.0 || -left - right < SHARP*fmax(fabs(bend[0]), fabs(bend[1])))
		return fmin(f[2], f[3]);
	return fmin(value, fmin(f[2], f[3]));
}

/* Least value of a periodic function that is the greater of smooth ones: it may have kinks. */
static double least(const double *f, int count, size_t stride)
{
	double best = HUGE_VAL;

	for (int i = 0; i < count; i++) {
		double near[6], bend;

		for (int k = 0; k < 6; k++)
			near[k] = f[(size_t)((i + k + count - 2)%count)*stride];
		best = fmin(best, kink(near));
		bend = near[1] + near[3] - 2.0*near[2];
		if (near[2] <= near[1] && near[2] <= near[3] && bend > 0.0)
			best = fmin(best, near[2] - 0.125*(near[3] - near[1])*(near[3] - near[1])/bend);
	}
	return best;
}

/* `least` and `most` of tensions at the instants of samples u [rows][n]; extra: see
 * rom/energy/kernel.h. */
static void tensions(const struct hawser__torus_ruler *ruler, double extreme_of[2], const double *u,
                     int rows, double h, double omega, double *all)
{
	int places = hawser__rom_tension_places(ruler->rom);
	double *extra = all + places;

	for (int i = 0; i < rows; i++) {
		struct hawser_rom_moment moment = {.tau = (i - SIDE)*h, .omega = omega};
		int any = hawser__rom_answer_strains(ruler->rom, extra, &moment);

		hawser__rom_tensions_all(ruler->rom, all, u + (size_t)i*(size_t)ruler->rom->n,
		                         any ? extra : NULL);
		for (int p = 0; p < places; p++) {
			extreme_of[0] = fmin(extreme_of[0], all[p]);
			extreme_of[1] = fmax(extreme_of[1], all[p]);
		}
	}
}

/* The signals of one period: value [signals] the largest modulus of each. */
static void period(const struct hawser__torus_ruler *ruler, double *value, const double *u, int steps,
                   double h, double omega, double *work)
{
	const struct hawser_rom *rom = ruler->rom;
	int rows = steps + 2*SIDE, n = rom->n;
	double *xyz = work + 2*rows;

	for (int j = 0; j < n; j++) {
		for (int i = 0; i < rows; i++)
			work[i] = u[(size_t)i*n + j];
		value[j] = largest(work, work + rows, steps);
	}
	for (int p = 0; p < rom->shapes.points; p++) {
		for (int i = 0; i < rows; i++) {
			struct hawser_rom_moment moment = {.tau = (i - SIDE)*h, .omega = omega};

			hawser_rom_displacement_at(rom, xyz + 3*(size_t)i, p, u + (size_t)i*n, &moment);
		}
		for (int axis = 0; axis < 3; axis++) {
			for (int i = 0; i < rows; i++)
				work[i] = xyz[3*(size_t)i + axis];
			value[n + 3*p + axis] = largest(work, work + rows, steps);
		}
	}
}

static int make_room(struct hawser__torus_ruler *ruler, size_t room)
{
	if (room <= ruler->room)
		return 0;
	free(ruler->memory);
	ruler->memory = malloc(room*sizeof *ruler->memory);
	ruler->room = ruler->memory ? room : 0;
	return !ruler->memory;
}

/* window [steps + 2 SIDE][n] of the period that begins at point i, from u [N][steps + SIDE][n]. */
static void open_window(double *window, const double *u, const struct hawser__torus *torus, int i,
                        int steps)
{
	int N = torus->points, n = torus->m/2, rows = steps + SIDE;

	memset(window, 0, (size_t)(SIDE*n)*sizeof *window);
	for (int j = 0; j < N; j++)
		cblas_daxpy(SIDE*n, hawser__torus_cardinal(N, 2.0*M_PI*(i - j)/N - torus->rho, 0),
		            u + ((size_t)j*(size_t)rows + (size_t)(steps - SIDE))*(size_t)n, 1, window, 1);
	memcpy(window + SIDE*n, u + (size_t)i*(size_t)rows*(size_t)n,
	       (size_t)rows*(size_t)n*sizeof *window);
}

int hawser__torus_measure(struct hawser__torus_ruler *ruler, struct hawser_tori *list, int index,
                          struct hawser__torus *torus)
{
	int N = torus->points, steps = torus->steps*((FINEST + torus->steps - 1)/torus->steps);
	int rows = steps + SIDE, n = ruler->rom->n, places = hawser__rom_tension_places(ruler->rom);
	double h = 2.0*M_PI/steps, *u, *value, *all, *work, *window;
	struct hawser__stretch stretch = {.h = h, .steps = rows, .count = N};
	size_t samples = (size_t)N*(size_t)rows*(size_t)n, at = (size_t)index, k = ruler->signals;
	double *tension = list->tension ? list->tension + 2*at : NULL;

	ruler->rom = torus->flow.rom; /* at the place */
	if (make_room(ruler, samples + MANY*(size_t)N*k + HAWSER__EXTRA((size_t)places) +
	                     (size_t)places + (5 + (size_t)n)*(size_t)(rows + SIDE)))
		return 1;
	u = ruler->memory;
	value = u + samples;
	all = value + MANY*(size_t)N*k;
	window = all + places + HAWSER__EXTRA((size_t)places);
	work = window + (size_t)n*(size_t)(rows + SIDE);
	if (tension) {
		tension[0] = HUGE_VAL;
		tension[1] = -HUGE_VAL;
	}
	for (int s = 0; s < MANY; s++) {
		hawser__torus_shifted(torus->image, torus, 2.0*M_PI*s/(MANY*N), 0);
		(void)hawser__flow_map(&torus->flow, torus->image, u, &stretch, torus->omega);
		for (int i = 0; i < N; i++) {
			open_window(window, u, torus, i, steps);
			period(ruler, value + (size_t)(MANY*i + s)*k, window, steps, h, torus->omega, work);
			if (tension)
				tensions(ruler, tension, window, rows + SIDE, h, torus->omega, all);
		}
	}
	for (int j = 0; j < n; j++) {
		list->coordinate_least[at*(size_t)n + j] = least(value + j, MANY*N, k);
		list->coordinate_most[at*(size_t)n + j] = greatest(value + j, MANY*N, k);
	}
	for (size_t j = (size_t)n; j < k; j++) {
		list->probe_least[at*(k - (size_t)n) + j - (size_t)n] = least(value + j, MANY*N, k);
		list->probe_most[at*(k - (size_t)n) + j - (size_t)n] = greatest(value + j, MANY*N, k);
	}
	return 0;
}
