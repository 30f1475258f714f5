/* study/hill/hill_track.c - the test function of one boundary.
 *
 *    F        determinant of the Hill matrix at the exponent lambda (response/floquet/hill_matrix.h)
 *    plus     F(0)                 real
 *    minus    F(i Omega/2)         real
 *    growth   real part of the exponent lambda, F(lambda) = 0, by secants in the complex plane from the
 *             exponent of the previous point; along a boundary Re lambda = 0 and F = 0 are solved
 *             together (hawser__hill_newton)
 *    extremum  without damping all exponents are imaginary, F(i nu) is real, and between two of them
 *             it has an extremum in nu, which is 0 as they collide: its value there
 *
 * A determinant takes a tenth of the time of the multipliers, does not require condensation, and is
 * as accurate as its coefficients. The multipliers are used if the field has no models, if a
 * determinant would need too many harmonics.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/report.h"
#include "response/floquet/linear_margin.h"
#include "study/hill/hill.h"

#define BESIDE 1e-4    /* increment for the first slope of F, relative to Omega; chosen */
#define CLOSE 1e-9     /* last correction of an exponent, relative to Omega; by the order of the
                        * secants the next one is below round-off */
#define FARTHEST 0.1   /* longest correction of an exponent, relative to Omega: a longer one may
                        * lead to another exponent; chosen */
#define FAR_SCALE 900  /* largest exponent of 2, with a margin to the range of double (1023) */
#define ROUND_OFF 1e-10 /* corrections below this, relative to the rectangle and to Omega, that do not
                         * become smaller are round-off */
#define APART 1e-4     /* increment for derivatives by nu, relative to Omega: their error is its square;
                        * chosen */
#define AT_EXTREMUM 0.03 /* last correction of nu, relative to this increment: the value changes by its
                          * square, which is subtracted, and by its cube */
#define FARTHER 0.005  /* longest correction of nu, relative to Omega: a longer one may lead to another
                        * extremum; chosen */
#define REAL 1e-5      /* F is even about nu = 0 and Omega/2, where its extremum tells nothing of a
                        * torus; chosen above the last correction */
enum { CORRECTIONS = 12 };

void hawser__hill_to_caller(double out[2], const struct hawser__hill *hill, const double at[2])
{
	const struct hawser_hill_options *options = hill->options;

	for (int k = 0; k < 2; k++)
		out[k] = options->from[k] + (options->to[k] - options->from[k])*at[k];
}

static enum hawser_status model_of(const struct hawser_rom **rom, double *omega,
                                   struct hawser__hill *hill, struct hawser__hill_worker *worker,
                                   const double at[2])
{
	double xy[2];

	hawser__hill_to_caller(xy, hill, at);
	return hill->field->model(hill->field->context, rom, omega, worker->number, xy[0], xy[1],
	                          &worker->report);
}

/* The status of a point, which becomes the worker's unless the point only has no response. */
static enum hawser_status passed(struct hawser__hill *hill, struct hawser__hill_worker *worker,
                                 enum hawser_status status)
{
	int missed = status == HAWSER_ERR_CONVERGENCE && hill->field->responds;

	if (missed && worker->missed++ == 0)
		snprintf(worker->why, sizeof worker->why, "%.300s", worker->report.message);
	worker->status = missed ? HAWSER_OK : status;
	return status;
}

/* Whether the caller has ended the search, which the first thread asks at each point. */
static int interrupted(struct hawser__hill *hill, const struct hawser__hill_worker *worker)
{
	struct hawser_hill_chart *chart = hill->chart;

	if (worker->number != 0 || !chart)
		return 0;
	chart->interrupted |= hawser__hill_told_to_stop(hill->options, chart->boundaries, 0, &hill->span);
	return chart->interrupted;
}

enum hawser_status hawser__hill_multipliers(struct hawser__hill *hill,
                                            struct hawser__hill_worker *worker,
                                            const double at[2], int rough)
{
	const struct hawser_hill_field *field = hill->field;
	const struct hawser_rom *rom;
	double xy[2], omega;
	enum hawser_status status;

	if (worker->status || interrupted(hill, worker))
		return worker->status ? worker->status : HAWSER_ERR_CONVERGENCE;
	worker->evaluations++;
	worker->m = field->m;
	if (rough && worker->linear) {
		status = passed(hill, worker, model_of(&rom, &omega, hill, worker, at));
		if (status || !hawser__linear_rough(worker->linear, worker->log_modulus, worker->argument,
		                                    &worker->m, rom, omega, &worker->report))
			return status;
		worker->m = field->m;
	}
	hawser__hill_to_caller(xy, hill, at);
	status = field->multipliers(field->context, worker->log_modulus, worker->argument, xy[0], xy[1],
	                            &worker->report);
	return passed(hill, worker, status);
}

enum hawser_status hawser__hill_exponents(struct hawser__hill *hill,
                                          struct hawser__hill_worker *worker, int *unstable,
                                          double *to, const double at[2], int rough)
{
	const struct hawser_rom *rom;
	enum hawser_status status;
	double omega;
	int m;

	if (worker->status || interrupted(hill, worker))
		return worker->status ? worker->status : HAWSER_ERR_CONVERGENCE;
	worker->evaluations++;
	worker->m = hill->field->m;
	status = passed(hill, worker, model_of(&rom, &omega, hill, worker, at));
	to[0] = 0.0;
	if (status)
		return status;
	hawser__linear_haste(worker->linear, 1);
	worker->status = rough
		? hawser__linear_rough(worker->linear, worker->log_modulus, worker->argument, &m, rom,
		                       omega, &worker->report)
		: hawser_linear_multipliers(worker->linear, worker->log_modulus, worker->argument, NULL,
		                            rom, omega, &worker->report);
	hawser__linear_haste(worker->linear, 0);
	if (!worker->status)
		worker->status = hawser__linear_exponents(worker->linear, to, rom, omega, &worker->report);
	*unstable = hawser__linear_circle(worker->linear).unstable;
	return worker->status;
}

/* --- the Hill matrix --- */

static int coupled(const struct hawser__variational *system, int j, int k)
{
	size_t n = (size_t)system->n;

	for (int side = 0; side < 2; side++) {
		size_t e = side ? (size_t)k*n + (size_t)j : (size_t)j*n + (size_t)k;

		for (int r = 0; r <= 2*system->order; r++)
			if (system->K[(size_t)r*n*n + e] != 0.0)
				return 1;
		for (int r = 0; r <= 2*system->order_d; r++)
			if (system->D[(size_t)r*n*n + e] != 0.0)
				return 1;
	}
	return 0;
}

/* The coordinates, ascending, that are coupled to `part`: member [n]. Returns their number. */
static int members(int *member, const struct hawser__variational *system, int part)
{
	int count = 1;

	member[0] = part;
	for (int i = 0; i < count; i++)
		for (int j = 0; j < system->n; j++) {
			int known = 0;

			for (int k = 0; k < count; k++)
				known |= member[k] == j;
			if (!known && coupled(system, member[i], j))
				member[count++] = j;
		}
	return count;
}

static void take_part(double *to, const double *series, int order, int n, const int *member, int w)
{
	for (int r = 0; r <= 2*order; r++)
		for (int i = 0; i < w; i++)
			for (int j = 0; j < w; j++)
				*to++ = series[((size_t)r*(size_t)n + (size_t)member[i])*(size_t)n +
				               (size_t)member[j]];
}

/* The equations of the part of the model that contains coordinate `part`. */
static enum hawser_status restrict_to(struct hawser__variational *system,
                                      struct hawser__hill_worker *worker, int part)
{
	int *member = worker->used, w = members(member, system, part);
	size_t wide = 2*(size_t)system->order + 1, wide_d = 2*(size_t)system->order_d + 1;
	size_t need = (wide + wide_d)*(size_t)w*(size_t)w;

	if (w == system->n)
		return HAWSER_OK;
	if (need > worker->part_room) {
		free(worker->part);
		worker->part = malloc(need*sizeof(double));
		worker->part_room = worker->part ? need : 0;
		if (!worker->part)
			return hawser__no_memory(&worker->report, "hill");
	}
	take_part(worker->part, system->K, system->order, system->n, member, w);
	take_part(worker->part + wide*(size_t)w*(size_t)w, system->D, system->order_d, system->n, member,
	          w);
	system->n = w;
	system->K = worker->part;
	system->D = worker->part + wide*(size_t)w*(size_t)w;
	return HAWSER_OK;
}

/* The equations at a point that the track's determinant is of. */
static enum hawser_status equations(struct hawser__variational *system, struct hawser__hill *hill,
                                    int part, const double at[2])
{
	struct hawser__hill_worker *worker = hill->worker;
	const struct hawser_rom *rom;
	enum hawser_status status;
	double omega;

	status = passed(hill, worker, model_of(&rom, &omega, hill, worker, at));
	if (status)
		return status;
	worker->status = hawser__linear_series(worker->linear, system, rom, omega, &worker->report);
	if (!worker->status && part >= 0)
		worker->status = restrict_to(system, worker, part);
	return worker->status;
}

int hawser__hill_is_first(struct hawser__hill *hill, int part, const double at[2])
{
	struct hawser__variational system;
	int *member = hill->worker->used, count, first = part;

	if (equations(&system, hill, -1, at)) {
		hill->status = hill->worker->status;
		*hill->report = hill->worker->report;
		return 0;
	}
	count = members(member, &system, part);
	for (int k = 0; k < count; k++)
		first = member[k] < first ? member[k] : first;
	return first == part;
}

struct hill_equation {
	struct hawser__hill_worker *worker;
	struct hawser__hill_track *track;
	struct hawser__variational system;
	int lost; /* 1: the determinant could not be computed */
};

static double complex determinant(struct hill_equation *equation, double complex lambda)
{
	struct hawser__hill_track *track = equation->track;
	struct hawser__hill_worker *worker = equation->worker;
	double omega = equation->system.omega, at[2] = {creal(lambda)*omega, cimag(lambda)*omega};
	double value[3];
	int exponent;

	if (track->kind == HAWSER_HILL_MINUS)
		at[1] = 0.5*omega;
	if (track->harmonics == 0)
		track->harmonics = hawser__hill_harmonics(&equation->system, at);
	if (track->harmonics == 0) {
		equation->lost = 1;
		return NAN;
	}
	worker->evaluations++;
	worker->status = hawser__hill_determinant(value, &exponent, &worker->matrix,
	                                          &equation->system, at, track->harmonics,
	                                          &worker->report);
	if (worker->status)
		return NAN;
	if (!track->known || abs(exponent - track->exponent) > FAR_SCALE) {
		track->exponent = exponent;
		track->known = 1;
		track->slope[0] = track->slope[1] = track->rise = 0.0;
	}
	exponent -= track->exponent;
	track->noise = track->by != HAWSER__BY_GROWTH ? ldexp(value[2], exponent) : 0.0;
	return ldexp(value[0], exponent) + I*ldexp(value[1], exponent);
}

static double growth(struct hill_equation *equation)
{
	struct hawser__hill_track *track = equation->track;
	double complex lambda = track->lambda[0] + I*track->lambda[1], f = determinant(equation, lambda);
	double complex slope = track->slope[0] + I*track->slope[1];

	if (slope == 0.0)
		slope = (determinant(equation, lambda + BESIDE) - f)/BESIDE;
	for (int i = 0; i < CORRECTIONS; i++) {
		double complex step = -f/slope, next;
		double size = cabs(step);

		if (!(size < FARTHEST))
			return NAN;
		lambda += step;
		if (size < CLOSE) {
			track->lambda[0] = creal(lambda);
			track->lambda[1] = cimag(lambda);
			track->slope[0] = creal(slope);
			track->slope[1] = cimag(slope);
			return creal(lambda);
		}
		next = determinant(equation, lambda);
		if (size > 100.0*CLOSE)
			slope = (next - f)/step;
		f = next;
	}
	return NAN;
}

static double extremum(struct hill_equation *equation)
{
	struct hawser__hill_track *track = equation->track;
	double nu = track->lambda[1] + track->ahead;

	track->ahead = 0.0;
	for (int i = 0; i < CORRECTIONS; i++) {
		double up = creal(determinant(equation, I*(nu + APART)));
		double down = creal(determinant(equation, I*(nu - APART)));
		double f = creal(determinant(equation, I*nu)), slope = (up - down)/(2.0*APART);
		double bend = (up - 2.0*f + down)/(APART*APART), step = -slope/bend;

		if (!(fabs(step) < FARTHER))
			return NAN;
		if (fabs(step) < AT_EXTREMUM*APART) {
			track->lambda[1] = nu;
			return fabs(remainder(nu, 0.5)) > REAL ? f + 0.5*slope*step : NAN;
		}
		nu += step;
	}
	return NAN;
}

static double of_matrix(struct hawser__hill *hill, struct hawser__hill_track *track, const double at[2],
                        int *lost)
{
	struct hawser__hill_worker *worker = hill->worker;
	struct hill_equation equation = {.worker = worker, .track = track};
	double value = NAN;

	if (!equations(&equation.system, hill, track->part, at))
		value = track->by == HAWSER__BY_GROWTH ? growth(&equation)
		        : track->by == HAWSER__BY_EXTREMUM ? extremum(&equation)
		        : creal(determinant(&equation, 0.0));
	*lost = equation.lost;
	return worker->status ? NAN : value;
}

/* --- growth 0: a point of the boundary --- */

/* F at from + s*along and the exponent i nu. */
static double complex beside(struct hawser__hill *hill, struct hawser__hill_track *track,
                             const double from[2], const double along[2], double s, double nu)
{
	const double at[2] = {from[0] + s*along[0], from[1] + s*along[1]};
	struct hawser__hill_worker *worker = hill->worker;
	struct hill_equation equation = {.worker = worker, .track = track};
	double complex f = NAN;

	if (!equations(&equation.system, hill, track->part, at))
		f = determinant(&equation, I*nu);
	if (worker->status) {
		hill->status = worker->status;
		*hill->report = worker->report;
	}
	return f;
}

/* Broyden's method for F(s, nu) = 0, from the derivatives at the previous point. With F_s and F_nu
 * seen as vectors of two components the unknowns are s and nu, both of the size of the rectangle or
 * of Omega. A step and the one before tell what is left: the method converges superlinearly, so that
 * the next step is smaller by more than their ratio. */
static int newton(struct hawser__hill *hill, struct hawser__hill_track *track, double *s,
                  const double from[2], const double along[2], double reach)
{
	double complex slope = track->slope[0] + I*track->slope[1];
	double complex f_s = -slope*(track->rise + I*track->drift), f_nu = I*slope, f, lift;
	double nu = track->lambda[1] + track->ahead, last = INFINITY, at = 0.0, ds = 0.0, dnu = 0.0;
	int exponent = track->exponent;

	for (int i = 0; i < CORRECTIONS; i++) {
		double det, size;

		f = beside(hill, track, from, along, at, nu);
		if (hill->status || track->exponent != exponent)
			return 0;
		if (i > 0) { /* J += F d'/(d'd) of the last step d */
			f_s += f*ds/(last*last);
			f_nu += f*dnu/(last*last);
		}
		det = cimag(conj(f_s)*f_nu);
		ds = -cimag(conj(f)*f_nu)/det;
		dnu = -cimag(conj(f_s)*f)/det;
		size = hypot(ds, dnu);
		at += ds;
		nu += dnu;
		if (!(fabs(at) <= reach && fabs(dnu) < FARTHEST))
			return 0;
		if (size*(i > 0 ? fmin(1.0, size/last) : 1.0) <= hill->options->tolerance ||
		    (size < ROUND_OFF && size >= 0.5*last)) {
			slope = f_nu/I;
			lift = -f_s/slope;
			track->slope[0] = creal(slope);
			track->slope[1] = cimag(slope);
			track->rise = creal(lift);
			track->drift = cimag(lift);
			track->lambda[0] = 0.0;
			track->lambda[1] = nu;
			*s = at;
			return track->rise > 0.0;
		}
		last = size;
	}
	return 0;
}

int hawser__hill_newton(struct hawser__hill *hill, struct hawser__hill_track *track, double *s,
                        const double from[2], const double along[2], double reach)
{
	struct hawser__hill_track keep = *track;

	if (track->by != HAWSER__BY_GROWTH || !(track->rise > 0.0) || !track->known ||
	    (track->slope[0] == 0.0 && track->slope[1] == 0.0))
		return 0;
	if (newton(hill, track, s, from, along, reach))
		return 1;
	*track = keep;
	return 0;
}

double hawser__hill_value(struct hawser__hill *hill, struct hawser__hill_track *track,
                          const double at[2])
{
	struct hawser__hill_worker *worker = hill->worker;
	double value = NAN;
	int lost;

	if (hill->status)
		return NAN;
	if (track->by != HAWSER__BY_MULTIPLIERS)
		value = of_matrix(hill, track, at, &lost);
	else if (!hawser__hill_multipliers(hill, worker, at, 0))
		value = hawser__hill_test(worker, track->kind);
	if (worker->status) {
		hill->status = worker->status;
		*hill->report = worker->report;
	}
	return value;
}

int hawser__hill_choose(struct hawser__hill *hill, struct hawser__hill_track *track, int kind, int part,
                        const double at[2])
{
	struct hawser__hill_worker *worker = hill->worker;
	double argument = 0.0, keep = 0.0;
	int lost = 1;

	*track = (struct hawser__hill_track){.kind = kind, .by = HAWSER__BY_MULTIPLIERS, .part = part};
	if (!worker->linear || hill->status)
		return !hill->status;
	if (kind != HAWSER_HILL_TORUS) {
		track->by = HAWSER__BY_DETERMINANT;
	} else {
		if (hawser__hill_multipliers(hill, worker, at, 1)) {
			hill->status = worker->status;
			*hill->report = worker->report;
			return 0;
		}
		if (!hawser__hill_pair(worker, &argument))
			return 0;
		track->by = hawser__hill_undamped(worker) ? HAWSER__BY_EXTREMUM : HAWSER__BY_GROWTH;
		track->lambda[1] = argument/(2.0*M_PI);
	}
	keep = of_matrix(hill, track, at, &lost);
	if (lost || !isfinite(keep))
		*track = (struct hawser__hill_track){.kind = kind, .by = HAWSER__BY_MULTIPLIERS};
	if (worker->status) {
		hill->status = worker->status;
		*hill->report = worker->report;
	}
	return !hill->status;
}
