/* response/frf.c - pseudo-arclength continuation of forced periodic orbits.
 *
 *   ds       arclength step in the metric of the last point (shooting.h)
 *   prev, here, next: the last three stations; the predictor is the cubic through prev and here with
 *            their tangents, so its error falls with ds^4 and the corrector starts close
 *
 * Step control: the next step is the largest at which contraction of the corrector, turning of the
 * tangent and distance of the prediction stay at their goals (Allgower and Georg, Numerical
 * Continuation Methods, 6.1). A step whose sign changes of test functions do not account for the
 * change in the number of unstable multipliers, or that holds more than one event, is taken again at
 * half the length: so two folds in one step are not lost.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/locate.h"
#include "response/record.h"
#include "response/start.h"

#define GOAL_CONTRACTION 0.05
#define GOAL_ANGLE 0.2         /* rad between successive tangents */
#define WORST_ANGLE 0.4
#define GOAL_DISTANCE 1e-2     /* of the prediction from the branch, relative to the orbit */
#define WORST_DISTANCE 5e-2    /* beyond these three the step may have reached another branch */
#define WORST_CONTRACTION 0.2
#define WORST_ITERATIONS 5
#define LARGEST_STEP 0.4       /* relative change of the orbit in one step */
#define LARGEST_TURN 0.01      /* relative change of Omega in one step: resonances are this narrow */
#define SMALLEST_STEP 1e-9
#define SORTING_STEP 1e-4      /* below this, events in one step are told apart no further */
#define WORST_ERROR 0.05       /* estimated error of an orbit beyond which it is refused */
#define STEP_ANGLE 1.0         /* first guess of the mesh: rad of the fastest mode a step */
#define DEFAULT_SEGMENTS 4
#define MAX_SEGMENTS 64
#define MAX_MESH 4000          /* steps a segment */

struct trace {
	const struct hawser_rom *rom;
	struct hawser_frf_options options;
	struct hawser_frf *frf;
	struct hawser__shooting shooting;
	struct hawser__amplitude *amplitude;
	struct hawser__station prev, here, next, scratch;
	double *direction;      /* [size] */
	double *start_y;        /* [size] first point, to notice a closed curve */
	double ds, lo, hi;
	int have_prev;
	struct hawser_report *report;
};

struct hawser_frf_options hawser_frf_defaults(void)
{
	return (struct hawser_frf_options){.tolerance = 1e-9, .event_tolerance = 1e-10,
		.max_points = 20000, .step_max = 0.02, .locate = 1};
}

static double omega_of(const struct trace *trace, const struct hawser__station *station)
{
	return station->y[trace->shooting.size - 1];
}

/* --- mesh --- */

static double fastest(const struct hawser_rom *rom)
{
	double top = 0.0;

	for (int j = 0; j < rom->n; j++)
		top = fmax(top, rom->K[j*rom->n + j]);
	for (int h = 0; h < rom->harmonics; h++)
		top = fmax(top, pow(rom->harmonic[h].k, 2));
	return sqrt(top);
}

/* One segment more for every five e-folds of damping in a period: the transition matrices stay well
 * conditioned. */
static int choose_segments(const struct hawser_rom *rom, double omega)
{
	double top = 0.0;

	for (int j = 0; j < rom->n; j++)
		top = fmax(top, fabs(rom->D[j*rom->n + j]));
	return (int)fmin(MAX_SEGMENTS, DEFAULT_SEGMENTS + ceil(top*2.0*M_PI/omega/5.0) - 1.0*(top > 0));
}

/* Mesh that brings the estimated error to half the tolerance; the estimate falls about with h^7. */
static int better_mesh(const struct trace *trace, double mesh)
{
	double ratio = pow(fmax(mesh, 1e-300)/(0.5*trace->options.tolerance), 1.0/7.0);

	return (int)ceil(trace->shooting.steps*fmin(2.0, fmax(0.85, ratio)));
}

/* Correct station->y and give it the mesh it needs. Returns 1 when the corrector fails; a mesh that
 * would have to be finer than MAX_MESH is an error. */
static enum hawser_status correct(struct trace *trace, struct hawser__station *station,
                                  const double *row, int *failed)
{
	struct hawser__shooting *shooting = &trace->shooting;

	for (;;) {
		double mesh;
		int steps;
		enum hawser_status status;

		*failed = hawser__shooting_correct(shooting, station->y, &station->correction, row,
		                                   trace->options.tolerance);
		if (*failed)
			return HAWSER_OK;
		mesh = shooting->mesh/shooting->X;
		if (mesh <= trace->options.tolerance)
			return HAWSER_OK;
		steps = better_mesh(trace, mesh);
		if (steps > MAX_MESH)
			return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf", 0, mesh,
			                       "the orbit at scaled Omega %.9g needs more than %d "
			                       "integration steps a period for tolerance %.1g "
			                       "(estimated error %.2g): loosen --tolerance",
			                       omega_of(trace, station), MAX_MESH*shooting->segments,
			                       trace->options.tolerance, mesh);
		if ((status = hawser__shooting_remesh(shooting, steps, trace->report)))
			return status;
	}
}

/* A coarser mesh for the next point, where this one was finer than needed. */
static enum hawser_status relax_mesh(struct trace *trace)
{
	double mesh = trace->shooting.mesh/trace->shooting.X;
	int steps = better_mesh(trace, mesh);

	if (steps >= trace->shooting.steps || steps < 3)
		return HAWSER_OK;
	return hawser__shooting_remesh(&trace->shooting, steps, trace->report);
}

/* --- events --- */

static int crossings(const struct trace *trace, int *width)
{
	int count = 0;

	*width = 0;
	for (int k = 0; k < HAWSER_TESTS; k++)
		if (hawser__station_crossed(&trace->here, &trace->next, k)) {
			count++;
			*width += hawser__event_width(k);
		}
	return count;
}

/* Whether the parabola through g at the last three stations has an extremum beyond zero between here
 * and next, where g itself has one sign: a sign of two crossings in one step. */
static int hides_crossings(double s0, double g0, double s1, double g1, double s2, double g2)
{
	double d01 = (g1 - g0)/(s1 - s0), d12 = (g2 - g1)/(s2 - s1);
	double curvature = (d12 - d01)/(s2 - s0); /* half the second derivative */
	double slope = d12 - curvature*(s2 - s1); /* at s1 */
	double at = curvature != 0.0 ? -slope/(2.0*curvature) : -1.0;

	if ((g1 < 0.0) != (g2 < 0.0) || at <= 0.0 || at >= s2 - s1)
		return 0;
	return (g1 + 0.5*slope*at < 0.0) != (g1 < 0.0);
}

/* Two crossings of the unit circle, or two folds, leave no change of sign and no change in the count. */
static int hidden_pair(const struct trace *trace)
{
	const struct hawser__station *a = &trace->prev, *b = &trace->here, *c = &trace->next;
	int last = trace->shooting.size - 1;

	if (!trace->have_prev)
		return 0;
	for (int i = 0; i < trace->shooting.m; i++)
		if (hides_crossings(a->arc, a->log_modulus[i], b->arc, b->log_modulus[i], c->arc,
		                    c->log_modulus[i]))
			return 1;
	return hides_crossings(a->arc, a->t[last], b->arc, b->t[last], c->arc, c->t[last]);
}

/* Whether the step from here to next holds at most one event and it explains the multipliers. */
static int clear_step(const struct trace *trace)
{
	int width, count = crossings(trace, &width);
	int change = abs(trace->next.unstable - trace->here.unstable);

	return count <= 1 && change == width && !hidden_pair(trace);
}

static enum hawser_status locate_events(struct trace *trace)
{
	struct hawser_frf *frf = trace->frf;
	int first = frf->events, width, suspected, change;
	enum hawser_status status;

	if (!trace->options.locate || !crossings(trace, &width))
		return HAWSER_OK;
	for (int k = 0; k < HAWSER_TESTS; k++) {
		struct hawser_frf_event event;
		int found;

		if (!hawser__station_crossed(&trace->here, &trace->next, k))
			continue;
		if ((status = hawser__locate(&event, &found, &trace->shooting, &trace->scratch,
		                             &trace->here, &trace->next, k,
		                             trace->options.tolerance,
		                             trace->options.event_tolerance, trace->report)))
			return status;
		event.after = frf->points - 2; /* next is recorded already */
		if (found && (status = hawser__record_event(frf, &event, trace->report)))
			return status;
	}
	width = 0;
	for (int i = first; i < frf->events; i++)
		width += hawser__event_width(frf->event[i].kind);
	change = abs(trace->next.unstable - trace->here.unstable);
	suspected = width != change;
	for (int i = first; i < frf->events; i++) {
		frf->event[i].suspected = suspected;
		for (int j = i; j > first && frf->event[j].arc < frf->event[j - 1].arc; j--) {
			struct hawser_frf_event keep = frf->event[j];

			frf->event[j] = frf->event[j - 1];
			frf->event[j - 1] = keep;
		}
	}
	return HAWSER_OK;
}

/* --- stepping --- */

static void predict(struct trace *trace, double ds)
{
	struct hawser__shooting *shooting = &trace->shooting;
	const struct hawser__station *here = &trace->here;
	int size = shooting->size;

	if (trace->have_prev) {
		double chord;

		for (int i = 0; i < size; i++)
			trace->direction[i] = here->y[i] - trace->prev.y[i];
		chord = sqrt(hawser__shooting_dot(shooting, trace->direction, trace->direction));
		hawser__station_between(trace->next.y, trace->direction, &trace->prev, here,
		                        1.0 + ds/chord, shooting);
	} else {
		for (int i = 0; i < size; i++)
			trace->next.y[i] = here->y[i] + ds*here->t[i];
	}
	/* The plane is normal to the known tangent: an extrapolated one may have swung round. */
	memcpy(trace->direction, here->t, (size_t)size*sizeof(double));
}

static double angle_between(const struct trace *trace)
{
	const struct hawser__shooting *shooting = &trace->shooting;
	double ab = hawser__shooting_dot(shooting, trace->here.t, trace->next.t);
	double aa = hawser__shooting_dot(shooting, trace->here.t, trace->here.t);
	double bb = hawser__shooting_dot(shooting, trace->next.t, trace->next.t);

	return acos(fmax(-1.0, fmin(1.0, ab/sqrt(aa*bb))));
}

/* Whether the corrector had so little to do that next can only be on the same branch as here. */
static int trusted(const struct trace *trace, double angle)
{
	const struct hawser__correction *correction = &trace->next.correction;

	return angle <= WORST_ANGLE && correction->first <= WORST_DISTANCE &&
	       correction->contraction <= WORST_CONTRACTION &&
	       correction->iterations <= WORST_ITERATIONS;
}

static double largest_step(const struct trace *trace)
{
	const struct hawser__shooting *shooting = &trace->shooting;
	double omega = omega_of(trace, &trace->here);
	double turn = fmin(LARGEST_TURN*omega, trace->options.step_max*(trace->hi - trace->lo));
	/* Omega moves by |t_Omega| ds; where the branch is steep, only the orbit's change counts */
	double share = fabs(trace->here.t[shooting->size - 1]);

	return share*LARGEST_STEP > turn ? turn/share : LARGEST_STEP;
}

/* Factor by which the last step was shorter or longer than it should be. */
static double step_factor(const struct trace *trace, double angle)
{
	const struct hawser__correction *correction = &trace->next.correction;
	double factor = GOAL_ANGLE/fmax(angle, 1e-12);

	factor = fmin(factor, sqrt(GOAL_CONTRACTION/fmax(correction->contraction, 1e-12)));
	factor = fmin(factor, pow(GOAL_DISTANCE/fmax(correction->first, 1e-12), 0.25));
	return fmax(0.4, fmin(1.8, factor));
}

/* Without damping a linear resonance has no finite orbit; what stops the numbers from growing is the
 * damping of the integrator, and its peak would be a wrong number. */
static enum hawser_status undetermined(const struct trace *trace,
                                       const struct hawser__station *station)
{
	return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
	                       station->correction.iterations, station->error,
	                       "at scaled Omega %.12g the orbit is determined to no better than %.1g "
	                       "of its size: a resonance (nearly) without damping; add damping, or "
	                       "tighten --tolerance (%.1g)", omega_of(trace, station),
	                       station->error, trace->options.tolerance);
}

/* One accepted step: trace->next is the new station. *stop is set when none can be made. */
static enum hawser_status advance(struct trace *trace)
{
	for (;;) {
		int failed;
		double angle;
		enum hawser_status status;

		if (trace->ds < SMALLEST_STEP)
			return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
			                       trace->next.correction.iterations,
			                       trace->next.correction.residual,
			                       "the corrector failed at the smallest step near scaled "
			                       "Omega %.9g (residual %.2g); %d points were traced",
			                       omega_of(trace, &trace->here),
			                       trace->next.correction.residual, trace->frf->points);
		predict(trace, trace->ds);
		if ((status = correct(trace, &trace->next, trace->direction, &failed)))
			return status;
		if (failed) {
			trace->ds *= 0.4;
			continue;
		}
		if ((status = hawser__station_finish(&trace->next, &trace->shooting, trace->here.t,
		                                     trace->report)))
			return status;
		angle = angle_between(trace);
		trace->next.arc = trace->here.arc + trace->ds;
		if ((!trusted(trace, angle) && trace->ds > 1e3*SMALLEST_STEP) ||
		    (trace->ds > SORTING_STEP && !clear_step(trace))) {
			trace->ds *= 0.5;
			continue;
		}
		if (trace->next.error > WORST_ERROR && !crossings(trace, &(int){0}))
			return undetermined(trace, &trace->next);
		trace->ds = fmin(trace->ds*step_factor(trace, angle), largest_step(trace));
		return HAWSER_OK;
	}
}

/* Replace next by the point where the branch between here and next meets Omega = bound. */
static enum hawser_status cut_at(struct trace *trace, double bound)
{
	struct hawser__shooting *shooting = &trace->shooting;
	int last = shooting->size - 1, failed;
	double lo = 0.0, hi = 1.0, *y = trace->scratch.y;
	double side = trace->here.y[last] < bound ? 1.0 : -1.0;
	enum hawser_status status;

	for (int i = 0; i < 60; i++) {
		double s = 0.5*(lo + hi);

		hawser__station_between(y, trace->direction, &trace->here, &trace->next, s, shooting);
		if ((y[last] - bound)*side < 0.0)
			lo = s;
		else
			hi = s;
	}
	y[last] = bound;
	memset(trace->direction, 0, (size_t)shooting->size*sizeof(double));
	trace->direction[last] = side*shooting->W;
	if ((status = correct(trace, &trace->scratch, trace->direction, &failed)))
		return status;
	if (failed)
		return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                       trace->scratch.correction.iterations,
		                       trace->scratch.correction.residual,
		                       "the corrector failed at the end of the range, scaled Omega "
		                       "%.9g", bound);
	trace->scratch.arc = trace->here.arc + lo*(trace->next.arc - trace->here.arc);
	hawser__station_swap(&trace->scratch, &trace->next);
	return hawser__station_finish(&trace->next, shooting, trace->here.t, trace->report);
}

/* The curve is closed when it passes its first point in the first direction. */
static int closed(const struct trace *trace)
{
	const struct hawser__shooting *shooting = &trace->shooting;
	double *d = trace->direction, along, distance;

	if (trace->frf->points < 10)
		return 0;
	for (int i = 0; i < shooting->size; i++)
		d[i] = trace->start_y[i] - trace->here.y[i];
	along = hawser__shooting_dot(shooting, d, trace->here.t);
	distance = sqrt(hawser__shooting_dot(shooting, d, d));
	return along > 0.0 && along < 1.5*(trace->next.arc - trace->here.arc) &&
	       distance < 1.2*along &&
	       omega_of(trace, &trace->here) != trace->options.from;
}

static enum hawser_status begin(struct trace *trace)
{
	struct hawser__shooting *shooting = &trace->shooting;
	int last = shooting->size - 1, failed;
	enum hawser_status status;

	if ((status = hawser__start(trace->here.y, shooting, &trace->here.correction,
	                            trace->options.start, trace->options.from,
	                            trace->options.tolerance, trace->report)))
		return status;
	memset(trace->direction, 0, (size_t)shooting->size*sizeof(double));
	trace->direction[last] = shooting->W*(trace->options.to > trace->options.from ? 1.0 : -1.0);
	if ((status = correct(trace, &trace->here, trace->direction, &failed)))
		return status;
	if (failed)
		return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                       trace->here.correction.iterations,
		                       trace->here.correction.residual,
		                       "the first orbit, at scaled Omega %.9g, was lost when its mesh "
		                       "was refined", trace->options.from);
	if ((status = hawser__station_finish(&trace->here, shooting, trace->direction,
	                                     trace->report)))
		return status;
	memcpy(trace->start_y, trace->here.y, (size_t)shooting->size*sizeof(double));
	trace->ds = fmin(0.05, largest_step(trace));
	return hawser__record_point(trace->frf, trace->amplitude, &trace->here, shooting,
	                            trace->report);
}

static int interrupted(const struct trace *trace)
{
	return trace->options.progress &&
	       trace->options.progress(trace->options.progress_context, trace->frf);
}

/* Record the new station and its events, and make it the current one. An event that cannot be located
 * means that next lies across a gap (a bifurcation that a small load has pulled apart): the station is
 * dropped, *again set, and the step halved until the gap is resolved. */
static enum hawser_status accept(struct trace *trace, int *again)
{
	struct hawser_frf *frf = trace->frf;
	double taken = trace->next.arc - trace->here.arc;
	int events = frf->events;
	enum hawser_status status = hawser__record_point(frf, trace->amplitude, &trace->next,
	                                                 &trace->shooting, trace->report);

	*again = 0;
	if (status)
		return status;
	status = locate_events(trace);
	if (status == HAWSER_ERR_CONVERGENCE && taken > 1e3*SMALLEST_STEP) {
		frf->points--;
		frf->events = events;
		trace->ds = 0.5*taken;
		*again = 1;
		return HAWSER_OK;
	}
	if (status)
		return status;
	hawser__station_swap(&trace->prev, &trace->here);
	hawser__station_swap(&trace->here, &trace->next);
	trace->have_prev = 1;
	return HAWSER_OK;
}

static enum hawser_status follow(struct trace *trace)
{
	struct hawser_frf *frf = trace->frf;
	enum hawser_status status;

	for (;;) {
		double omega;
		int outside, again;

		if (interrupted(trace)) {
			frf->end = HAWSER_END_INTERRUPTED;
			return HAWSER_OK;
		}
		if (frf->points >= trace->options.max_points) {
			frf->end = HAWSER_END_MAX_POINTS;
			return HAWSER_OK;
		}
		hawser__shooting_metric(&trace->shooting, trace->here.y);
		if ((status = advance(trace)))
			return status;
		omega = omega_of(trace, &trace->next);
		outside = omega >= trace->hi || omega <= trace->lo;
		if (outside && (status = cut_at(trace, omega >= trace->hi ? trace->hi : trace->lo)))
			return status;
		frf->end = outside ? HAWSER_END_RANGE : HAWSER_END_CLOSED;
		if (!outside && closed(trace))
			return HAWSER_OK;
		if ((status = accept(trace, &again)))
			return status;
		if (again)
			continue;
		if (outside)
			return HAWSER_OK;
		if ((status = relax_mesh(trace)))
			return status;
	}
}

static enum hawser_status check(const struct hawser_rom *rom,
                                const struct hawser_frf_options *options,
                                struct hawser_report *report)
{
	int driven = 0;

	for (int h = 0; h < rom->harmonics; h++)
		driven |= rom->harmonic[h].f || rom->harmonic[h].D || rom->harmonic[h].K;
	if (!driven)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "the model has no forcing: give the scene a load, or the model "
		                    "file a harmonic");
	if (!(options->from > 0.0) || !(options->to > 0.0) || options->from == options->to ||
	    !isfinite(options->from) || !isfinite(options->to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "frequency range from %g to %g (scaled): both ends must be "
		                    "positive, finite and different", options->from, options->to);
	if (!(options->tolerance >= 1e-13 && options->tolerance <= 1e-2))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "tolerance %g: must be between 1e-13 and 1e-2",
		                    options->tolerance);
	if (options->segments < 0 || options->segments > MAX_SEGMENTS || options->max_points < 1 ||
	    !(options->step_max > 0.0) || !(options->event_tolerance > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "segments %d (0 to %d), max points %d (1 or more), largest step %g "
		                    "and event tolerance %g (positive): one is out of range",
		                    options->segments, MAX_SEGMENTS, options->max_points,
		                    options->step_max, options->event_tolerance);
	return HAWSER_OK;
}

static enum hawser_status open_trace(struct trace *trace, struct hawser_report *report)
{
	const struct hawser_rom *rom = trace->rom;
	struct hawser__shooting *shooting = &trace->shooting;
	double slowest = fmin(trace->options.from, trace->options.to);
	int segments = trace->options.segments ? trace->options.segments
	                                       : choose_segments(rom, slowest);
	double cycles = 2.0*M_PI*fastest(rom)/trace->options.from;
	int steps = (int)fmin(MAX_MESH, fmax(3.0, ceil(cycles/STEP_ANGLE/segments)));
	enum hawser_status status = hawser__shooting_init(shooting, rom, segments, steps, report);

	if (status)
		return status;
	if ((status = hawser__station_init(&trace->prev, shooting, report)) ||
	    (status = hawser__station_init(&trace->here, shooting, report)) ||
	    (status = hawser__station_init(&trace->next, shooting, report)) ||
	    (status = hawser__station_init(&trace->scratch, shooting, report)))
		return status;
	trace->direction = calloc((size_t)shooting->size, sizeof(double));
	trace->start_y = calloc((size_t)shooting->size, sizeof(double));
	trace->amplitude = hawser__amplitude_new(rom);
	if (!trace->direction || !trace->start_y || !trace->amplitude)
		return hawser__no_memory(report, "frf");
	return HAWSER_OK;
}

static void close_trace(struct trace *trace)
{
	hawser__shooting_clear(&trace->shooting);
	hawser__station_clear(&trace->prev);
	hawser__station_clear(&trace->here);
	hawser__station_clear(&trace->next);
	hawser__station_clear(&trace->scratch);
	hawser__amplitude_free(trace->amplitude);
	free(trace->direction);
	free(trace->start_y);
}

enum hawser_status hawser_frf_trace(struct hawser_frf *frf, const struct hawser_rom *rom,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report)
{
	struct trace trace = {.rom = rom, .options = *options, .frf = frf, .report = report,
		.lo = fmin(options->from, options->to), .hi = fmax(options->from, options->to)};
	enum hawser_status status;

	*frf = (struct hawser_frf){.n = rom->n, .probes = rom->shapes.points};
	if ((status = check(rom, options, report)))
		return status;
	if (!(status = open_trace(&trace, report)) && !(status = begin(&trace)))
		status = follow(&trace);
	if (status)
		frf->end = HAWSER_END_FAILED;
	close_trace(&trace);
	return status;
}
