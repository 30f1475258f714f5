/* response/branch/amplitude.c - see amplitude.h.
 *
 *    signal [rows]       one real signal over a period
 *    c [rows/2 + 1]      its Fourier coefficients, by FFTW
 *
 * The number of rows varies along a branch, and FFTW needs more time to plan a transform than to
 * compute it. Plans are therefore kept, and the number of points of the fine grid is a power of
 * two, so that there are few of the expensive plans.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/branch/amplitude.h"
#include "response/time/planner.h"
#include "rom/condense/answer.h"
#include "rom/energy/kernel.h"

#define REFINE 4   /* least number of fine grid points per sample: with 4, the grid misses the
                    * maximum of the shortest wave by 8 % at most */
#define POLISH 4   /* Newton steps from the largest grid point: enough for round-off */
#define NEARLY 0.9 /* fraction of the largest grid value above which a maximum is refined: more than
                    * the 8 % are allowed for */

#define PLANS 64   /* numbers of rows for which plans are kept; chosen */

struct plans {
	int rows, many;    /* number of samples, number of points of the fine grid */
	fftw_plan analyse;
};

struct hawser__amplitude {
	const struct hawser_rom *rom;
	struct hawser__frozen frozen;
	int capacity;      /* number of rows for which the arrays are large enough */
	double *signal, *fine;
	double *xyz;       /* [capacity][3] displacement of one probe */
	double *tension;   /* [capacity][places], and `extra` of a row; NULL until it is needed */
	double *contact;   /* [capacity][sheaves]; the same */
	fftw_complex *coarse_c, *fine_c;
	struct plans plans[PLANS], *now;
	int kept;
	fftw_plan refine[32]; /* by the binary logarithm of the fine grid's points */
};

struct hawser__amplitude *hawser__amplitude_new(const struct hawser_rom *rom)
{
	struct hawser__amplitude *amplitude = calloc(1, sizeof *amplitude);

	if (amplitude)
		amplitude->rom = rom;
	return amplitude;
}

void hawser__amplitude_take(struct hawser__amplitude *amplitude, const struct hawser_rom *rom)
{
	amplitude->rom = rom;
}

static void drop_plans(struct hawser__amplitude *amplitude)
{
	hawser__planner_lock();
	for (int i = 0; i < amplitude->kept; i++)
		if (amplitude->plans[i].analyse)
			fftw_destroy_plan(amplitude->plans[i].analyse);
	for (int i = 0; i < 32; i++) {
		if (amplitude->refine[i])
			fftw_destroy_plan(amplitude->refine[i]);
		amplitude->refine[i] = NULL;
	}
	hawser__planner_unlock();
	amplitude->kept = 0;
}

static void drop(struct hawser__amplitude *amplitude)
{
	drop_plans(amplitude);
	free(amplitude->signal);
	free(amplitude->fine);
	free(amplitude->xyz);
	free(amplitude->tension);
	free(amplitude->contact);
	free(amplitude->coarse_c);
	free(amplitude->fine_c);
	*amplitude = (struct hawser__amplitude){.rom = amplitude->rom, .frozen = amplitude->frozen};
}

void hawser__amplitude_free(struct hawser__amplitude *amplitude)
{
	if (!amplitude)
		return;
	drop(amplitude);
	hawser__rom_frozen_release(&amplitude->frozen);
	free(amplitude);
}

/* Binary logarithm of the number of points of the fine grid. */
static int fineness(int rows)
{
	int e = 1;

	while ((1 << e) < REFINE*rows)
		e++;
	return e;
}

/* Allocate arrays for at least `rows` rows; the plans belong to the arrays. */
static int make_room(struct hawser__amplitude *amplitude, int rows)
{
	int capacity = 2*rows, many = 1 << fineness(capacity);

	if (rows <= amplitude->capacity)
		return 0;
	drop(amplitude);
	amplitude->signal = hawser__planner_array((size_t)capacity, sizeof *amplitude->signal);
	amplitude->fine = hawser__planner_array((size_t)many, sizeof *amplitude->fine);
	amplitude->xyz = malloc(3*(size_t)capacity*sizeof *amplitude->xyz);
	amplitude->coarse_c = hawser__planner_array((size_t)capacity/2 + 1,
	                                             sizeof *amplitude->coarse_c);
	amplitude->fine_c = hawser__planner_array((size_t)many/2 + 1, sizeof *amplitude->fine_c);
	if (!amplitude->signal || !amplitude->fine || !amplitude->xyz ||
	    !amplitude->coarse_c || !amplitude->fine_c)
		return 1;
	amplitude->capacity = capacity;
	return 0;
}

static int prepare(struct hawser__amplitude *amplitude, int rows)
{
	struct plans *plans;
	int e = fineness(rows);

	if (make_room(amplitude, rows))
		return 1;
	for (int i = 0; i < amplitude->kept; i++)
		if (amplitude->plans[i].rows == rows) {
			amplitude->now = &amplitude->plans[i];
			return 0;
		}
	if (amplitude->kept == PLANS)
		drop_plans(amplitude);
	if (hawser__planner_begin())
		return 1;
	plans = amplitude->now = &amplitude->plans[amplitude->kept++];
	plans->rows = rows;
	plans->many = 1 << e;
	plans->analyse = fftw_plan_dft_r2c_1d(rows, amplitude->signal, amplitude->coarse_c,
	                                      FFTW_ESTIMATE);
	if (!amplitude->refine[e])
		amplitude->refine[e] = fftw_plan_dft_c2r_1d(plans->many, amplitude->fine_c,
		                                            amplitude->fine, FFTW_ESTIMATE);
	hawser__planner_unlock();
	return !plans->analyse || !amplitude->refine[e];
}

/* Value, slope and curvature of the interpolant at phase tau. */
static void evaluate(const fftw_complex *c, int rows, double tau, double value[3])
{
	double complex wave = 1.0, turn = cexp(I*tau);

	value[0] = creal(c[0]);
	value[1] = value[2] = 0.0;
	for (int k = 1; 2*k < rows; k++) {
		double complex term = 2.0*c[k]*(wave *= turn);

		value[0] += creal(term);
		value[1] -= k*cimag(term);
		value[2] -= (double)k*k*creal(term);
	}
}

/* Largest modulus near tau, from the fine grid of spacing h, whose value there is `found`. */
static double polish(const fftw_complex *c, int rows, double tau, double h, double found)
{
	double value[3];

	for (int i = 0; i < POLISH; i++) {
		evaluate(c, rows, tau, value);
		found = fmax(found, fabs(value[0]));
		if (value[2] == 0.0 || fabs(value[1]/value[2]) > h)
			break;
		tau -= value[1]/value[2];
	}
	return found;
}

/* Largest modulus of the signal amplitude->signal. If two maxima are nearly equal, the grid may
 * rank them in the wrong order; therefore all that are near the largest are refined. */
static double largest(struct hawser__amplitude *amplitude)
{
	int rows = amplitude->now->rows, many = amplitude->now->many;
	fftw_complex *c = amplitude->coarse_c;
	double *fine = amplitude->fine, h = 2.0*M_PI/many, top = 0.0, found = 0.0;

	fftw_execute(amplitude->now->analyse);
	for (int k = 0; k <= rows/2; k++)
		c[k] /= rows;
	memset(amplitude->fine_c, 0, ((size_t)many/2 + 1)*sizeof *amplitude->fine_c);
	for (int k = 0; 2*k < rows; k++)
		amplitude->fine_c[k] = c[k];
	fftw_execute(amplitude->refine[fineness(rows)]);
	for (int i = 0; i < many; i++) {
		fine[i] = fabs(fine[i]);
		top = fmax(top, fine[i]);
	}
	for (int i = 0; i < many; i++)
		if (fine[i] > NEARLY*top && fine[i] >= fine[(i + many - 1)%many] &&
		    fine[i] >= fine[(i + 1)%many])
			found = fmax(found, polish(c, rows, i*h, h, fine[i]));
	return found;
}

/* The signal of row i. */
static struct hawser_rom_moment moment_at(int i, int rows, double omega)
{
	return (struct hawser_rom_moment){.tau = 2.0*M_PI*i/rows, .omega = omega};
}

int hawser__amplitude_find(struct hawser__amplitude *amplitude, double *coordinate, double *probe,
                           const double *samples, int rows, double omega)
{
	const struct hawser_rom *rom = hawser__rom_freeze(&amplitude->frozen, amplitude->rom, omega);
	int n = amplitude->rom->n;

	if (!rom || prepare(amplitude, rows))
		return 1;
	for (int j = 0; j < n; j++) {
		for (int i = 0; i < rows; i++)
			amplitude->signal[i] = samples[(size_t)i*n + j];
		coordinate[j] = largest(amplitude);
	}
	for (int p = 0; p < rom->shapes.points; p++) {
		for (int i = 0; i < rows; i++) {
			struct hawser_rom_moment moment = moment_at(i, rows, omega);

			hawser_rom_displacement_at(rom, amplitude->xyz + 3*(size_t)i, p,
			                           samples + (size_t)i*n,
			                           omega > 0.0 ? &moment : NULL);
		}
		for (int axis = 0; axis < 3; axis++) {
			for (int i = 0; i < rows; i++)
				amplitude->signal[i] = amplitude->xyz[3*(size_t)i + axis];
			probe[3*p + axis] = largest(amplitude);
		}
	}
	return 0;
}

/* The largest moduli of what is shifted so far that all of it is on one side. */
int hawser__amplitude_swing(struct hawser__amplitude *amplitude, double *swing, const double *samples,
                            int rows)
{
	int n = amplitude->rom->n;

	if (prepare(amplitude, rows))
		return 1;
	for (int j = 0; j < n; j++) {
		double shift = 0.0, sum = 0.0;

		for (int i = 0; i < rows; i++)
			shift = fmax(shift, 2.0*fabs(samples[(size_t)i*n + j]));
		for (int side = -1; side <= 1; side += 2) {
			for (int i = 0; i < rows; i++)
				amplitude->signal[i] = samples[(size_t)i*n + j] + side*shift;
			sum += largest(amplitude);
		}
		swing[j] = 0.5*sum - shift;
	}
	return 0;
}

/* --- tension --- */

/* A candidate for an extreme: the row, the point of the cable, and the extreme of its parabola. */
struct extreme {
	int row, place;
	double shift, height; /* position of the parabola's extreme relative to `row`, in rows, and its
	                       * value times the sign */
};

/* The point of the cable whose parabola through three samples about its largest (times `sign`) is
 * highest. */
static struct extreme highest(const double *tension, int rows, int places, double sign)
{
	struct extreme best = {0, 0, 0.0, -HUGE_VAL};

	for (int p = 0; p < places; p++) {
		double a, b, c, bend, shift;
		int top = 0;

		for (int i = 1; i < rows; i++)
			if (sign*tension[(size_t)i*places + p] > sign*tension[(size_t)top*places + p])
				top = i;
		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): all rows are filled */
		a = sign*tension[(size_t)((top + rows - 1)%rows)*places + p];
		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): the same */
		b = sign*tension[(size_t)top*places + p];
		c = sign*tension[(size_t)((top + 1)%rows)*places + p];
		bend = 2.0*b - a - c;
		shift = bend > 0.0 ? 0.5*(c - a)/bend : 0.0;
		if (b + 0.25*(c - a)*shift > best.height)
			best = (struct extreme){top, p, shift, b + 0.25*(c - a)*shift};
	}
	return best;
}

/* The extreme of the trigonometric interpolant near that of the parabola. */
static double extreme_near(struct hawser__amplitude *amplitude, const double *tension,
                           const struct extreme *at, int rows, int places, double sign)
{
	double h = 2.0*M_PI/rows, tau = h*(at->row + at->shift), value[3];
	double best = sign*tension[(size_t)at->row*places + at->place];

	for (int i = 0; i < rows; i++)
		amplitude->signal[i] = tension[(size_t)i*places + at->place];
	fftw_execute(amplitude->now->analyse);
	for (int k = 0; k <= rows/2; k++)
		amplitude->coarse_c[k] /= rows;
	for (int i = 0; i < POLISH; i++) {
		evaluate(amplitude->coarse_c, rows, tau, value);
		best = fmax(best, sign*value[0]);
		if (!(sign*value[2] < 0.0) || fabs(value[1]/value[2]) > h)
			break;
		tau -= value[1]/value[2];
	}
	return sign*best;
}

int hawser__amplitude_tension(struct hawser__amplitude *amplitude, double extreme[2],
                              const double *samples, int rows, double omega)
{
	const struct hawser_rom *rom = hawser__rom_freeze(&amplitude->frozen, amplitude->rom, omega);
	int places = hawser__rom_tension_places(amplitude->rom);
	double *extra; /* [HAWSER__EXTRA(places)] */

	if (places == 0)
		return -1;
	if (!rom || prepare(amplitude, rows))
		return 1;
	if (!amplitude->tension)
		amplitude->tension = malloc(((size_t)amplitude->capacity*(size_t)places +
		                             HAWSER__EXTRA(places))*sizeof *amplitude->tension);
	if (!amplitude->tension)
		return 1;
	extra = amplitude->tension + (size_t)amplitude->capacity*(size_t)places;
	for (int i = 0; i < rows; i++) {
		struct hawser_rom_moment moment = moment_at(i, rows, omega);
		int any = omega > 0.0 && hawser__rom_answer_strains(rom, extra, &moment);

		hawser__rom_tensions_all(rom, amplitude->tension + (size_t)i*places,
		                         samples + (size_t)i*rom->n, any ? extra : NULL);
	}
	for (int side = 0; side < 2; side++) {
		double sign = side ? 1.0 : -1.0;
		/* NOLINTNEXTLINE(clang-analyzer-unix.Malloc): drop() leaves no pointer to what it frees */
		struct extreme at = highest(amplitude->tension, rows, places, sign);

		extreme[side] = extreme_near(amplitude, amplitude->tension, &at, rows, places, sign);
	}
	return 0;
}

int hawser__amplitude_contact(struct hawser__amplitude *amplitude, double *least, int *sheave,
                              const double *samples, int rows)
{
	const struct hawser_rom_contacts *contacts = &amplitude->rom->contacts;
	int sheaves = contacts->count, n = amplitude->rom->n;
	struct extreme at;

	*least = INFINITY;
	*sheave = -1;
	if (sheaves == 0)
		return 0;
	if (prepare(amplitude, rows))
		return 1;
	if (!amplitude->contact)
		amplitude->contact = malloc((size_t)amplitude->capacity*(size_t)sheaves*
		                            sizeof *amplitude->contact);
	if (!amplitude->contact)
		return 1;
	for (int i = 0; i < rows; i++)
		for (int k = 0; k < sheaves; k++) {
			double angle = 1.0;

			for (int j = 0; j < n; j++)
				angle += contacts->turn[j*sheaves + k]*samples[(size_t)i*n + j];
			amplitude->contact[(size_t)i*sheaves + k] = angle;
		}
	at = highest(amplitude->contact, rows, sheaves, -1.0);
	*least = extreme_near(amplitude, amplitude->contact, &at, rows, sheaves, -1.0);
	*sheave = at.place;
	return 0;
}
