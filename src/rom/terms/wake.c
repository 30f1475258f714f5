/* rom/terms/wake.c - oscillators for the vortices behind a cable (M. L. Facchinetti, E. de Langre,
 * F. Biolley, J. Fluids Struct. 19 (2004) 123).
 *
 *   U, D, W   speed of the flow across the cable, diameter, W = 2 pi St U/D in 1/s
 *   y         displacement across the flow: L times the sum of u_j w_j, L the length unit in m
 *   q         wake variable, 2 in the wake of a cable at rest
 *
 *   q'' + epsilon W (q^2 - 1) q' + W^2 q = (A/D) y''
 *   force on the cable across the flow: density U^2 D C_L q/4 - fluid_damping W density D^2 y'
 *
 * At places: q_i belongs to the middle of a part of the cable and to its length. By modes: q is the sum
 * of q_i s_i, with s_i the motion of mode i across the flow over its largest value, and its equation is
 * projected on each s_i; of the cubic term only that of q_i itself is kept, with the integral of s_i^4
 * over that of s_i^2. Modes that move less than 1 % across the flow have none.
 *
 * A coordinate is q_i/L, so that its value in m is q_i. The coupling by the acceleration is a mass
 * matrix [1 0; -c 1], by whose inverse [1 0; c 1] all equations are multiplied.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/law.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/complex/wind.h"
#include "rom/energy/kernel.h"
#include "rom/file/read.h"
#include "rom/terms/wind.h"

/* Least part of a mode's inertia across the flow. */
static const double moves = 0.01;

struct wakes {
	int n, count;
	double *omega;  /* [count] W, scaled */
	double *cubic;  /* [count] factor of q^2 q' */
	double *force;  /* [count][n] on each mode, scaled, by q = 1 */
	double *inertia; /* [count][n] of y/L: what u_j'' adds to its acceleration */
	char (*name)[32]; /* [count] */
	struct hawser__hold hold;
};

static int wakes_make(struct wakes *wakes, int n, int most)
{
	size_t room = (size_t)most + 1;

	*wakes = (struct wakes){.n = n};
	wakes->omega = hawser__hold(&wakes->hold, room, sizeof(double));
	wakes->cubic = hawser__hold(&wakes->hold, room, sizeof(double));
	wakes->force = hawser__hold(&wakes->hold, room*(size_t)n, sizeof(double));
	wakes->inertia = hawser__hold(&wakes->hold, room*(size_t)n, sizeof(double));
	wakes->name = hawser__hold(&wakes->hold, room, sizeof *wakes->name);
	return !wakes->hold.short_of_memory;
}

/* Motion of mode j across the flow at s. */
static double across(const struct hawser_modes *modes, int j, double s, const double axis[2][2])
{
	double at[3];

	hawser_modes_at(modes, at, NULL, j, s);
	return axis[1][0]*at[1] + axis[1][1]*at[2];
}

/* Of q = 1 per length, in N/m. */
static double push(const struct hawser_wind *wind, double speed)
{
	return wind->density*speed*speed*wind->diameter*wind->wake.lift/4.0;
}

static void at_places(struct wakes *wakes, const struct hawser_modes *modes,
                      const struct hawser_wind *wind)
{
	const struct hawser_statics *st = &modes->statics;

	for (int i = 0; i < wind->wake.places; i++) {
		double part = (i + 0.5)/wind->wake.places, s = part*st->l, axis[2][2];
		double speed = hawser__flow_axes(axis, st, s, wind);

		wakes->omega[i] = 2.0*M_PI*wind->wake.strouhal*speed/wind->diameter*modes->time_unit;
		wakes->cubic[i] = 1.0;
		for (int j = 0; j < wakes->n; j++) {
			double w = across(modes, j, s, axis);

			wakes->inertia[i*wakes->n + j] = w;
			wakes->force[i*wakes->n + j] = st->span.d/st->H*push(wind, speed)*w*
			                               st->l/wind->wake.places;
		}
		snprintf(wakes->name[i], sizeof *wakes->name, "wake at %.4g", part);
		wakes->count++;
	}
}

/* Integrals of s_i^2, s_i^4 and s_i w_j over the cable. */
static void by_mode(struct wakes *wakes, const struct hawser__flow_points *flow,
                    const struct hawser_modes *modes, const struct hawser_wind *wind, int mode)
{
	const struct hawser_statics *st = &modes->statics;
	const double *weight = modes->grid.weight;
	int i = wakes->count, n = wakes->n;
	double most = 0.0, square = 0.0, fourth = 0.0, speed = 0.0;

	for (int p = 0; p < flow->points; p++) {
		double w = flow->shape[(size_t)(2*p + 1)*n + mode]/flow->unit;

		most = fmax(most, fabs(w));
		square += weight[p]*w*w;
		fourth += weight[p]*w*w*w*w;
		speed += weight[p]/st->l*flow->speed[p];
	}
	if (modes->mode[mode].number == 0 || square < moves)
		return;
	wakes->omega[i] = 2.0*M_PI*wind->wake.strouhal*speed/wind->diameter*modes->time_unit;
	wakes->cubic[i] = fourth/square/(most*most);
	for (int j = 0; j < n; j++) {
		double product = 0.0;

		for (int p = 0; p < flow->points; p++) {
			const double *w = flow->shape + (size_t)(2*p + 1)*n;

			product += weight[p]*w[mode]*w[j]/(flow->unit*flow->unit);
		}
		if (fabs(product) < 1e-13*square)
			product = 0.0;
		wakes->inertia[i*n + j] = product/square*most;
		wakes->force[i*n + j] = st->span.d/st->H*push(wind, speed)*product/most;
	}
	snprintf(wakes->name[i], sizeof *wakes->name, "wake of mode %d", mode + 1);
	wakes->count++;
}

/* Damping by the fluid across the flow. */
static void add_fluid(double *D, const struct hawser__flow_points *flow,
                      const struct hawser_wind *wind)
{
	int n = flow->n;

	for (int p = 0; p < flow->points; p++) {
		const double *w = flow->shape + (size_t)(2*p + 1)*n;
		double c = wind->wake.fluid_damping*2.0*M_PI*wind->wake.strouhal*flow->speed[p]*wind->density*
		           wind->diameter;

		for (int j = 0; j < n; j++)
			for (int k = 0; k < n; k++)
				D[j*n + k] += flow->weight[p]*c*w[j]*w[k];
	}
}

/* --- room for further coordinates --- */

/* *x [rows][columns] becomes [to_rows][to_columns] with zeros; 0 if memory is short. NULL stays. */
static int widen(double **x, size_t rows, size_t columns, size_t to_rows, size_t to_columns)
{
	double *to = *x ? hawser__numbers(to_rows, to_columns) : NULL;

	if (!*x)
		return 1;
	for (size_t i = 0; to && i < rows; i++)
		memcpy(to + i*to_columns, *x + i*columns, columns*sizeof *to);
	if (!to)
		return 0;
	free(*x);
	*x = to;
	return 1;
}

/* Coordinates without motion of the cable. */
static int widen_model(struct hawser_rom *rom, const struct wakes *wakes)
{
	size_t n = (size_t)rom->n, N = n + (size_t)wakes->count, pairs = n*(n + 1)/2, all = N*(N + 1)/2;
	size_t points = 3*(size_t)rom->shapes.points, line = 3*(size_t)rom->line.points;
	struct hawser_rom_range *range = realloc(rom->range, N*sizeof *range);
	char **label = realloc(rom->label, N*sizeof *label);
	int fits = range && label && widen(&rom->D, n, n, N, N) && widen(&rom->K, n, n, N, N) &&
	           widen(&rom->shapes.shape, n, points, N, points) &&
	           widen(&rom->shapes.slope, n, points, N, points) &&
	           widen(&rom->shapes.second_shape, pairs, points, all, points) &&
	           widen(&rom->shapes.second_slope, pairs, points, all, points) &&
	           widen(&rom->line.slope, n, line, N, line) &&
	           widen(&rom->line.second_slope, pairs, line, all, line);

	rom->range = range ? range : rom->range;
	rom->label = label ? label : rom->label;
	for (int h = 0; fits && h < rom->harmonics; h++)
		fits = widen(&rom->harmonic[h].f, 1, n, 1, N) && widen(&rom->harmonic[h].D, n, n, N, N) &&
		       widen(&rom->harmonic[h].K, n, n, N, N);
	for (int i = 0; fits && i < wakes->count; i++) {
		memset(&range[rom->n], 0, sizeof *range);
		label[rom->n] = strdup(wakes->name[i]);
		fits = label[rom->n++] != NULL;
	}
	return fits;
}

/* --- equations --- */

static int set_equations(struct hawser_rom *rom, const struct wakes *wakes,
                         const struct hawser_wind *wind)
{
	int n = wakes->n, N = rom->n;
	double L = rom->length, epsilon = wind->wake.epsilon;
	struct hawser_term *term = realloc(rom->term, ((size_t)rom->terms + (size_t)wakes->count)*
	                                              sizeof *term);

	if (!term)
		return 0;
	rom->term = term;
	for (int i = 0; i < wakes->count; i++) {
		int q = n + i;

		rom->K[q*N + q] = wakes->omega[i]*wakes->omega[i];
		rom->D[q*N + q] = -epsilon*wakes->omega[i];
		for (int j = 0; j < n; j++)
			rom->K[j*N + q] = -L*wakes->force[i*n + j];
		term[rom->terms++] = (struct hawser_term){
			.j = q, .factors = 3, .rates = 1, .factor = {q, q, q},
			.value = epsilon*wakes->omega[i]*wakes->cubic[i]*L*L};
	}
	return 1;
}

/* The equations times the inverse of the mass matrix. */
static enum hawser_status divide_by_mass(struct hawser_rom *rom, const struct wakes *wakes,
                                         const struct hawser_wind *wind, struct hawser_report *report)
{
	int n = wakes->n, N = rom->n;
	double *inverse = hawser__numbers((size_t)N + 1, (size_t)N);
	enum hawser_status status = inverse ? HAWSER_OK : hawser__no_memory(report, "rom");

	for (int i = 0; !status && i < N; i++) {
		inverse[i*N + i] = 1.0;
		for (int j = 0; j < n && i >= n; j++)
			inverse[i*N + j] = wind->wake.A/wind->diameter*wakes->inertia[(i - n)*n + j];
	}
	if (!status)
		status = hawser__rom_divide(rom, inverse, inverse + (size_t)N*(size_t)N, report);
	free(inverse);
	return status;
}

static enum hawser_status append_wakes(struct hawser_rom *rom, const struct wakes *wakes,
                                       const struct hawser_wind *wind,
                                       struct hawser_report *report)
{
	if (rom->n + wakes->count > HAWSER_ROM_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%d modes and %d oscillators of wind.wake are more than %d coordinates: "
		                    "give fewer of wind.wake.at, or fewer modes", rom->n, wakes->count,
		                    HAWSER_ROM_MAX);
	for (int i = 0; i < wakes->count; i++)
		if (!(wakes->omega[i] > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "%s: the speed across the cable is 0 there, and a wake has none: "
			                    "give a wind.speed and a wind.profile above 0", wakes->name[i]);
	if (!widen_model(rom, wakes) || !set_equations(rom, wakes, wind))
		return hawser__no_memory(report, "rom");
	return divide_by_mass(rom, wakes, wind, report);
}

enum hawser_status hawser__wake_add(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser__flow_points flow = {.n = 0};
	struct wakes wakes;
	enum hawser_status status = HAWSER_OK;
	int places;

	if (!scene || !scene->wind.present || !scene->wind.wake.present)
		return HAWSER_OK;
	places = scene->wind.wake.places;
	if (!wakes_make(&wakes, modes->n, places ? places : modes->n) ||
	    !hawser__flow_points(&flow, modes, scene)) {
		status = hawser__no_memory(report, "rom");
	} else {
		add_fluid(rom->D, &flow, &scene->wind);
		if (places)
			at_places(&wakes, modes, &scene->wind);
		for (int j = 0; !places && j < modes->n; j++)
			by_mode(&wakes, &flow, modes, &scene->wind, j);
		status = append_wakes(rom, &wakes, &scene->wind, report);
	}
	hawser__flow_points_clear(&flow);
	hawser__hold_clear(&wakes.hold);
	return status;
}
