/* beam/critical.c - static speeds, safe speeds, and the size of the discretisation.
 *
 *   A = K at rest, symmetric;  P = s's' + r^2 s''s'', positive definite;  undamped: K = A - v^2 P
 *
 * All static speeds are eigenvalues of one symmetric problem, so none is missed. It is solved as
 * P x = (1/v^2) A x. Its round-off is relative to the largest 1/v^2, which belongs to the lowest
 * speed. With drag, x'Kx is still x'(A - v^2 P)x, so there is no static solution below the first
 * static speed. An undamped gyroscopic system is stable as long as K is positive definite, that
 * is, below the first static speed.
 *
 * Two limits need no discretisation:
 *   - v^2 > theta/r^2 (rotary inertia exceeds bending): the leading term of K is negative, the
 *     shortest waves diverge, and no discretisation converges.
 *   - theta = 0 (a string): K is no longer positive once v^2 exceeds the least tension, and
 *     beyond that speed the boundary conditions at the two supports admit no motion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "beam/sample.h"
#include "core/names.h"
#include "core/order.h"
#include "core/report.h"

enum {
	POINTS = 24, /* samples of the first sweep of search() */
	MOST = 400   /* largest size of a discretisation */
};
#define ROUND_OFF 1e-8 /* an error estimate below this that stops falling is round-off */

/* --- symmetric problems --- */

/* A, and P or, if `mass` is 1, M in the place of P. */
static void symmetric(double *A, double *P, const struct hawser_beam_integrals *is,
                      const struct hawser_beam *beam, int mass)
{
	size_t square = (size_t)is->n*(size_t)is->n;

	for (size_t x = 0; x < square; x++) {
		A[x] = beam->theta*is->s2s2[x] + (beam->tension - beam->weight)*is->s1s1[x] +
		       beam->weight*is->xs1s1[x];
		P[x] = mass ? is->ss[x] + beam->rotary*is->s1s1[x] : is->s1s1[x] + beam->rotary*is->s2s2[x];
	}
}

/* The eigenvalues of A x = value P x, ascending, in value [n]. */
static enum hawser_status symmetric_eigenvalues(double *value,
                                                const struct hawser_beam_integrals *is,
                                                const struct hawser_beam *beam, int mass,
                                                struct hawser_report *report)
{
	size_t n = (size_t)is->n, square = n*n;
	double *A = malloc(2*square*sizeof *A), *P = A ? A + square : NULL;
	int info;

	if (!A)
		return hawser__no_memory(report, "beam");
	symmetric(A, P, is, beam, mass);
	info = LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'U', is->n, P, is->n, A, is->n, value);
	for (size_t i = 0; !info && i < n; i++)
		value[i] = 1.0/value[i];
	if (info > is->n) { /* A is not positive definite */
		symmetric(A, P, is, beam, mass);
		info = LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'U', is->n, A, is->n, P, is->n, value);
	}
	free(A);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "beam");
	if (info)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "beam",
		                    "the static speeds of %d unknowns were not found (LAPACK %d): theta %g, "
		                    "tension %g or weight %g is too large for double precision", is->n, info,
		                    beam->theta, beam->tension, beam->weight);
	qsort(value, n, sizeof *value, hawser__ascending);
	return HAWSER_OK;
}

enum hawser_status hawser_beam_static_speeds(double *speed, int *count, int *buckled,
                                             const struct hawser_beam_integrals *is,
                                             const struct hawser_beam *beam,
                                             struct hawser_report *report)
{
	double *value = malloc((size_t)is->n*sizeof *value);
	enum hawser_status status = hawser__beam_check(beam, report);

	*count = *buckled = 0;
	if (!status && !value)
		status = hawser__no_memory(report, "beam");
	if (!status && beam->theta == 0.0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                      "a string (theta = 0) has no discrete static speeds");
	if (!status)
		status = symmetric_eigenvalues(value, is, beam, 0, report);
	for (int i = 0; !status && i < is->n; i++)
		if (value[i] > 0.0)
			speed[(*count)++] = sqrt(value[i]);
		else
			++*buckled;
	free(value);
	return status;
}

/* --- the safe speed --- */

/* Largest d re/dv at rest, if the flux of rotary momentum does work at every speed; otherwise 0.
 * Half of all modes are examined, because a beam that travels down is unstable in high modes
 * (doc/theory-beam.md). */
static enum hawser_status flux_slope(double *slope, const struct hawser_beam_integrals *is,
                                     const struct hawser_beam *beam, double direction, int modes,
                                     struct hawser_report *report)
{
	int half = is->n/2 > modes ? is->n/2 : modes;
	struct hawser__beam_sample rest;
	enum hawser_status status;

	*slope = 0.0;
	if (!hawser__beam_flux(beam) || beam->drag > 0.0 || beam->weight == 0.0)
		return HAWSER_OK;
	status = hawser__beam_sample(&rest, is, beam, 0.0, half, report);
	for (int k = 0; !status && k < rest.pairs && k < half; k++)
		*slope = fmax(*slope, direction*rest.pair[k].slope_re);
	if (!status)
		hawser__beam_sample_clear(&rest);
	return status;
}

/* Add the results of one sweep. */
static void add_sweep(struct hawser_beam_limits *limits, const struct hawser_beam_sweep *sweep)
{
	for (int i = 0; i < sweep->events && isnan(limits->v_crit); i++)
		if (sweep->event[i].growing[1] > 0) {
			limits->v_crit = fabs(sweep->event[i].speed);
			limits->cause = sweep->event[i].kind == HAWSER_BEAM_FLUTTER ? HAWSER_BEAM_FLUTTERS
			                                                            : HAWSER_BEAM_DIVERGES;
		}
	if (isnan(limits->v_first))
		limits->v_first = fabs(sweep->v_first);
	if (isnan(limits->v_bif))
		limits->v_bif = fabs(sweep->v_bif);
}

/* Sweep the speed until v_crit, v_first and v_bif are found, in ranges relative to the first
 * static speed. The first range ends just below it and the next ones just above it, because all
 * static speeds of a very slender beam lie close together. The later ranges grow. */
static enum hawser_status search(struct hawser_beam_limits *limits,
                                 const struct hawser_beam_integrals *is,
                                 const struct hawser_beam *beam, double direction, double first,
                                 double bars, struct hawser_report *report)
{
	static const double to[] = {0.9999, 1.001, 1.01, 1.05, 1.2, 1.5, 2.0, 3.0, 5.0, 8.0, 13.0, 21.0,
	                            34.0, 55.0};
	struct hawser_beam_sweep_options options = {.points = POINTS, .branches = limits->modes,
	                                            .loose = 1};
	double from = 0.0;
	int more = 2; /* ranges to search after v_crit has been found */

	for (size_t i = 0; i < sizeof to/sizeof *to && from < 0.999999*bars && more > 0; i++) {
		struct hawser_beam_sweep sweep;
		enum hawser_status status;

		options.from = direction*from;
		limits->searched = fmin(to[i]*first, 0.999999*bars);
		options.to = direction*limits->searched;
		options.points = i == 0 ? POINTS : POINTS/3;
		status = hawser_beam_sweep(&sweep, is, beam, &options, report);
		if (status)
			return status;
		add_sweep(limits, &sweep);
		hawser_beam_sweep_clear(&sweep);
		if (!isnan(limits->v_crit) && !isnan(limits->v_first) && !isnan(limits->v_bif))
			break;
		more -= !isnan(limits->v_crit) && i > 1;
		from = limits->searched;
	}
	return HAWSER_OK;
}

static enum hawser_status moving_limits(struct hawser_beam_limits *limits,
                                        const struct hawser_beam_integrals *is,
                                        const struct hawser_beam *beam, double first,
                                        struct hawser_report *report)
{
	double direction = beam->speed < 0.0 ? -1.0 : 1.0;
	double bars = beam->rotary > 0.0 ? sqrt(beam->theta/beam->rotary) : INFINITY;
	int level = beam->weight == 0.0 || !hawser__beam_flux(beam);
	enum hawser_status status = HAWSER_OK;

	/* K is positive definite below `first`, and the flux does no work */
	if (beam->drag == 0.0 && level && first < bars) {
		limits->v_crit = limits->v_first = limits->v_bif = limits->searched = first;
		limits->cause = HAWSER_BEAM_DIVERGES;
		return HAWSER_OK;
	}
	status = flux_slope(&limits->slope, is, beam, direction, limits->modes, report);
	if (status)
		return status;
	if (limits->slope > 0.0) {
		limits->v_crit = 0.0;
		if (direction*beam->weight > 0.0)
			limits->v_first = 0.0;
		limits->cause = HAWSER_BEAM_BY_FLUX;
	}
	status = search(limits, is, beam, direction, first, bars, report);
	if (!status && isnan(limits->v_crit) && isfinite(bars)) {
		limits->v_crit = bars;
		limits->cause = HAWSER_BEAM_WAVES;
	}
	return status;
}

enum hawser_status hawser_beam_limits(struct hawser_beam_limits *limits,
                                      const struct hawser_beam_integrals *is,
                                      const struct hawser_beam *beam, int modes,
                                      struct hawser_report *report)
{
	double *speed;
	int count = 0, buckled = 0;
	enum hawser_status status = hawser__beam_check(beam, report);

	*limits = (struct hawser_beam_limits){.v_crit = NAN, .v_first = NAN, .v_bif = NAN,
	                                      .modes = modes};
	if (!status && modes < 1)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam", "%d modes: at least 1", modes);
	if (status)
		return status;
	if (beam->theta == 0.0) {
		limits->cause = HAWSER_BEAM_STRING;
		limits->searched = limits->v_crit = limits->v_first =
			sqrt(fmax(hawser_beam_least_tension(beam), 0.0));
		limits->v_bif = beam->drag == 0.0 ? limits->v_crit : NAN;
		return HAWSER_OK;
	}
	speed = malloc((size_t)is->n*sizeof *speed);
	if (!speed)
		return hawser__no_memory(report, "beam");
	status = hawser_beam_static_speeds(speed, &count, &buckled, is, beam, report);
	if (!status && buckled > 0) {
		limits->cause = HAWSER_BEAM_BUCKLES;
		limits->v_crit = limits->v_first = limits->v_bif = 0.0;
	} else if (!status) {
		/* no mode is buckled, so count > 0 */
		/* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage) */
		status = moving_limits(limits, is, beam, speed[0], report);
	}
	free(speed);
	return status;
}

/* --- size of the discretisation --- */

/* Largest relative change of the first `values` values. The first value is nearly 0 near
 * buckling, so a small part of theta + tension is added to the denominator. */
static double largest_change(const double *now, const double *before, int values,
                             const struct hawser_beam *beam)
{
	double least = 1e-3*(beam->theta + beam->tension), most = 0.0;

	for (int i = 0; i < values; i++)
		most = fmax(most, fabs(now[i] - before[i])/(fabs(now[i]) + least));
	return most;
}

/* Eigenvalues whose convergence is tested, in value [2*modes]: those with P (squared static
 * speeds), then those with M (squared frequencies at rest). *enough is 1 if the discretisation
 * has that many. */
static enum hawser_status rest_values(double *value, int *enough,
                                      const struct hawser_beam_method *method,
                                      const struct hawser_beam *beam, int size, int modes,
                                      struct hawser_report *report)
{
	struct hawser_beam_integrals is;
	enum hawser_status status = method->fill(&is, beam->ends, size, report);
	double *all = NULL;

	*enough = 0;
	if (status)
		return status;
	all = malloc((size_t)is.n*sizeof *all);
	if (!all)
		status = hawser__no_memory(report, "beam");
	for (int mass = beam->theta == 0.0; !status && mass < 2 && is.n >= modes; mass++) {
		status = symmetric_eigenvalues(all, &is, beam, mass, report);
		if (!status)
			memcpy(value + mass*modes, all, (size_t)modes*sizeof *all);
		*enough = 1;
	}
	free(all);
	hawser_beam_integrals_clear(&is);
	return status;
}

/* Eigenvalues of a moving or damped beam for the current and the previous size. */
struct history {
	struct hawser_beam_eigenvalue *now, *before; /* [room] */
	int room, found, had; /* found: number in now; had: number in before */
	double last; /* previous change */
};

static enum hawser_status history_init(struct history *history, int modes,
                                       struct hawser_report *report)
{
	/* two more than are compared: the order of the last ones may change */
	*history = (struct history){.room = modes + 2, .last = INFINITY};
	history->now = calloc(2*(size_t)history->room, sizeof *history->now);
	history->before = history->now ? history->now + history->room : NULL;
	return history->now ? HAWSER_OK : hawser__no_memory(report, "beam");
}

/* *change is ten times the largest relative change of the first `modes` eigenvalues since the
 * previous size; INFINITY for the first size. Modes of a moving beam have boundary layers at the
 * supports, which static deflections and modes at rest do not have, so they need larger
 * discretisations. The factor of ten is needed because a third more functions changes little
 * while a layer is still unresolved. The change is measured in l^2, because l^2 is a smooth
 * function of the speed near a static speed. */
static enum hawser_status history_update(double *change, struct history *history,
                                      const struct hawser_beam_method *method,
                                      const struct hawser_beam *beam, int size, int modes,
                                      struct hawser_report *report)
{
	double least = 1e-3*hawser__beam_rest_frequency(beam);
	struct hawser_beam_integrals is;
	enum hawser_status status = method->fill(&is, beam->ends, size, report);

	if (status)
		return status;
	memcpy(history->before, history->now, (size_t)history->room*sizeof *history->now);
	history->had = history->found;
	status = hawser_beam_eigenvalues(history->now, NULL, &history->found, &is, beam, history->room,
	                                 report);
	hawser_beam_integrals_clear(&is);
	*change = history->had > 0 ? 0.0 : INFINITY;
	for (int i = 0; i < history->found && i < modes && history->had > 0; i++) {
		const struct hawser_beam_eigenvalue *l = history->now + i, *b = history->before;
		double nearest = INFINITY, size2 = l->re*l->re + l->im*l->im;

		for (int k = 0; k < history->had; k++) /* |l^2 - b^2|, for b and its conjugate */
			nearest = fmin(nearest, hypot(l->re - b[k].re, l->im - b[k].im)
			                        *hypot(l->re + b[k].re, l->im + b[k].im));
		*change = fmax(*change, 5.0*nearest/(size2 + least*least));
	}
	return status;
}

/* The error meets the tolerance, or it is round-off, which more functions do not reduce (this
 * occurs near buckling). */
static int converged(double error, double last, double tolerance)
{
	return error <= tolerance || (error < ROUND_OFF && error > 0.3*last);
}

enum hawser_status hawser_beam_size(int *size, double *error,
                                    const struct hawser_beam_method *method,
                                    const struct hawser_beam *beam, int modes, double tolerance,
                                    struct hawser_report *report)
{
	double *value, last = INFINITY, change_moving = 0.0;
	int enough = 0, before = 0, moves = beam->speed != 0.0 || beam->drag > 0.0;
	struct history history = {0};
	enum hawser_status status = hawser__beam_check(beam, report);

	*error = INFINITY;
	*size = modes + 6;
	if (status || modes < 1)
		return status ? status : hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                                      "%d modes: at least 1", modes);
	value = calloc(4*(size_t)modes, sizeof *value);
	status = value ? history_init(&history, modes, report) : hawser__no_memory(report, "beam");
	for (; !status; *size = *size + *size/3 < MOST ? *size + *size/3 : MOST) {
		int done;

		status = rest_values(value, &enough, method, beam, *size, modes, report);
		if (enough && before)
			*error = largest_change(value, value + 2*modes, 2*modes, beam);
		done = !status && converged(*error, last, tolerance);
		last = *error;
		if (done && moves) {
			status = history_update(&change_moving, &history, method, beam, *size, modes, report);
			*error = fmax(*error, change_moving);
			done = converged(change_moving, history.last, tolerance);
			history.last = change_moving;
		}
		if (status || done)
			break;
		if (*size >= MOST) {
			status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "beam",
			                      "with %d functions of the method %s the error is still %.2g", MOST,
			                      method->name, *error);
			break;
		}
		memcpy(value + 2*modes, value, 2*(size_t)modes*sizeof *value);
		before = enough;
	}
	free(value);
	free(history.now);
	return status;
}

HAWSER__NAMES(hawser_beam_cause_name, enum hawser_beam_cause, "none", "buckling", "flux",
	"divergence", "flutter", "short-waves", "string")
