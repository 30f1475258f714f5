/* bench/estimates-frf.c - points, events, folds and peaks of hawser frf (estimates.h).
 *
 * The error of a point is its distance from the true branch. The true orbit is therefore the
 * nearest one: by shooting with a tolerance of 1e-13, in the plane normal to the tangent of the
 * branch.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "bench/estimates.h"
#include "response/branch/amplitude.h"
#include "response/orbit/method.h"

enum { POINTS = 160, TRIED = 4 };
/* Of the corrector. The mesh is finer, since its estimate may be below its error. */
static const double exact = 1e-13;
/* Ratio of the fastest frequency to Omega above which scenes are computed by harmonic balance only,
 * to save time. */
static const double stiff = 20.0;

static double fastest(const struct hawser_rom *rom)
{
	double most = 0.0;

	for (int j = 0; j < rom->n; j++)
		most = fmax(most, rom->K[j*rom->n + j]);
	return sqrt(most);
}

static struct hawser_frf_options options_of(struct chance *chance, const struct hawser_rom *rom)
{
	static const char *const method[] = {NULL, "shooting", "balance"};
	struct hawser_frf_options options = {.method = NULL};
	double first = sqrt(rom->K[0]);

	options.from = first*chance_between(chance, 0.5, 0.95);
	options.to = first*chance_between(chance, 1.05, 1.8);
	options.max_points = POINTS;
	options.samples = HAWSER_NONE;
	options.method = method[fastest(rom) > stiff*options.from ? 2 : chance_int(chance, 0, 2)];
	if (chance_unit(chance) < 0.4)
		options.tolerance = chance_log(chance, 1e-11, 1e-4);
	return options;
}

/* --- points --- */

struct nearest {
	struct hawser__orbit *orbit;
	double *y, *row, *x, *coordinate;
	double omega;
};

static void nearest_clear(struct nearest *at)
{
	if (at->orbit)
		at->orbit->ops->clear(at->orbit);
	free(at->y);
	*at = (struct nearest){0};
}

/* The orbit of the branch next to x [2n], omega; returns 0 if it is not found. */
static int nearest_to(struct nearest *at, const struct hawser_rom *rom, const double *x,
                      double omega, const struct hawser_frf_options *from, double finest)
{
	struct hawser_frf_options options = *from;
	struct hawser__amplitude *amplitude = hawser__amplitude_new(rom);
	struct hawser__correction correction;
	int size, nodes, m = 2*rom->n, again = 1, failed = 0;
	double *probe = NULL;

	*at = (struct nearest){0};
	options.begin = omega;
	if (!amplitude || hawser__shooting_method.open(&at->orbit, rom, &options, NULL))
		goto done;
	size = at->orbit->size;
	at->y = calloc(2*(size_t)size + 3*(size_t)m, sizeof *at->y);
	probe = calloc(3*(size_t)rom->shapes.points + 1, sizeof *probe);
	if (!at->y || !probe)
		goto done;
	at->row = at->y + size;
	at->x = at->row + size;
	at->coordinate = at->x + m;
	/* a mesh fine enough for the periodic orbit at this state, and the tangent */
	for (int tries = 0; again && tries < 60; tries++) {
		if (at->orbit->ops->from_state(at->orbit, at->y, x, omega, NULL))
			goto done;
		at->y[size - 1] = omega;
		at->orbit->ops->metric(at->orbit, at->y);
		if (!(at->orbit->ops->defects(at->orbit, at->y, 1) < 1.0) ||
		    at->orbit->ops->refine(at->orbit, &again, finest, omega, NULL))
			goto done;
	}
	memset(at->row, 0, (size_t)size*sizeof *at->row);
	at->row[size - 1] = at->orbit->W;
	if (at->orbit->ops->factor(at->orbit, at->row))
		goto done;
	hawser__orbit_tangent(at->orbit, at->row);
	nodes = (size - 1)/m;
	/* normal to the tangent in the norm of the state over X and Omega over W */
	for (int i = 0; i < size - 1; i++)
		at->row[i] /= nodes*at->orbit->X*at->orbit->X*at->orbit->weight[i];
	for (again = 1; again && !failed;) {
		failed = hawser__orbit_correct(at->orbit, at->y, &correction, at->row, exact);
		if (!failed && at->orbit->ops->refine(at->orbit, &again, finest, omega, NULL))
			goto done;
	}
	if (failed)
		goto done;
	at->orbit->ops->state(at->orbit, at->x, at->y);
	at->omega = at->y[size - 1];
	if (hawser__amplitude_find(amplitude, at->coordinate, probe, at->orbit->samples,
	                           at->orbit->rows, at->omega))
		goto done;
	hawser__amplitude_free(amplitude);
	free(probe);
	return 1;
done:
	hawser__amplitude_free(amplitude);
	free(probe);
	nearest_clear(at);
	return 0;
}

static int nearest(struct nearest *at, const struct hawser_rom *rom, const double *x, double omega,
                   const struct hawser_frf_options *from)
{
	for (double finest = 3e-15; finest < 1e-12; finest *= 10.0)
		if (nearest_to(at, rom, x, omega, from, finest))
			return 1;
	return 0;
}

static double distance(const double *a, const double *b, int m)
{
	double sum = 0.0;

	for (int i = 0; i < m; i++)
		sum += (a[i] - b[i])*(a[i] - b[i]);
	return sqrt(sum);
}

static double norm(const double *a, int m)
{
	double sum = 0.0;

	for (int i = 0; i < m; i++)
		sum += a[i]*a[i];
	return sqrt(sum);
}

int estimate_frf(struct tally *tally, struct chance *chance)
{
	struct hawser_rom rom;
	struct hawser_frf_options options;
	struct hawser_frf frf;
	int n;

	if (estimate_model(&rom, chance, 0))
		return 1;
	options = options_of(chance, &rom);
	n = rom.n;
	(void)!hawser_frf_trace(&frf, &rom, &options, NULL);
	for (int i = 0; i < TRIED && frf.points > 0; i++) {
		int p = chance_int(chance, 0, frf.points - 1);
		const struct hawser_frf_point *point = &frf.point[p];
		const double *x = frf.state + (size_t)p*2*n, *a = frf.coordinate + (size_t)p*n;
		struct nearest at;

		if (!nearest(&at, &rom, x, point->omega, &options)) {
			tally_note(tally, NAN, point->error, "%s, point %d, Omega %.9g: no orbit is near",
			           frf.method, p, point->omega);
			continue;
		}
		tally_note(tally, distance(at.x, x, 2*n)/at.orbit->X, point->error,
		           "%s to %.1g, point %d of %d, Omega %.9g: state (n %d, %s, unstable %d, "
		           "residual %.2g, mesh %.2g, steps %d; Omega by %.1g)",
		           frf.method, options.tolerance, p, frf.points, point->omega, n,
		           rom.scaled ? "cable" : "oscillators", point->unstable, point->residual,
		           point->mesh, point->steps, at.omega/point->omega - 1.0);
		tally_note(tally, distance(at.coordinate, a, n)/norm(at.coordinate, n), point->error,
		           "%s to %.1g, point %d of %d, Omega %.9g: amplitudes (n %d, %s)", frf.method,
		           options.tolerance, p, frf.points, point->omega, n,
		           rom.scaled ? "cable" : "oscillators");
		nearest_clear(&at);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return 0;
}

/* --- events --- */

/* The event of the same kind nearest to *event if the branch is followed again from the point
 * before it, by shooting with a tolerance of 1e-12; NAN if there is none. */
static double located(const struct hawser_rom *rom, const struct hawser_frf *frf,
                      const struct hawser_frf_event *event, struct hawser_frf_options options)
{
	double start = frf->point[event->after].omega, reach = event->omega - start, best = NAN;
	struct hawser_frf again;

	options.method = "shooting";
	options.tolerance = 1e-12;
	options.event_tolerance = 1e-13;
	options.begin = start;
	options.start = frf->state + (size_t)event->after*2*frf->n;
	options.from = start - 0.5*reach;
	options.to = event->omega + 3.0*reach;
	options.max_points = 60;
	(void)!hawser_frf_trace(&again, rom, &options, NULL);
	for (int e = 0; e < again.events; e++)
		if (again.event[e].kind == event->kind &&
		    !(fabs(again.event[e].omega - event->omega) >= fabs(best - event->omega)))
			best = again.event[e].omega;
	hawser_frf_clear(&again);
	return best;
}

int estimate_events(struct tally *tally, struct chance *chance)
{
	struct hawser_rom rom;
	struct hawser_frf_options options;
	struct hawser_frf frf;

	if (estimate_model(&rom, chance, 1))
		return 1;
	options = options_of(chance, &rom);
	options.max_points = 2*POINTS;
	(void)!hawser_frf_trace(&frf, &rom, &options, NULL);
	for (int e = 0; e < frf.events && e < 2*TRIED; e++) {
		const struct hawser_frf_event *event = &frf.event[e];
		double right = event->suspected ? NAN : located(&rom, &frf, event, options);

		if (!isnan(right)) /* not found again: too near the next one to identify it */
			tally_note(tally, fabs(event->omega/right - 1.0), event->error,
			           "%s by %s to %.1g at Omega %.9g, n %d, %s, residual %.1g",
			           hawser_event_name(event->kind), frf.method, options.tolerance,
			           event->omega, rom.n, rom.scaled ? "cable" : "oscillators",
			           event->residual);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return 0;
}
