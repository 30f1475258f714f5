/* beam/boundary.c - a stability boundary over a parameter, piece by piece.
 *
 * hawser_beam_limits gives the first point of a piece. From there pseudo-arclength continuation
 * (continuation/curve.h) follows the equations of boundary.h in both directions, through turning
 * points. At every point the growing modes just below and just above the speed are counted. If a
 * mode grows below, another mode has become critical: the piece ends, and a new piece begins at
 * that parameter.
 *
 * A boundary may reach speed 0, where the beam buckles under its weight. The piece ends there,
 * and the parameter of the end is computed with v = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "beam/boundary.h"
#include "core/report.h"

#define CLOSE 2e-3 /* relative distance from an end of the range that counts as the end */
enum {
	STARTS = 33, /* parameters at which a first piece is searched for */
	MOST = 2000, /* default of the largest number of points */
	PIECES = 12  /* largest number of pieces */
};

/* --- one piece --- */

/* Starting point u and borders at parameter p, from the safe speed there. *found is 1 if that speed
 * exists and is above 0. */
static enum hawser_status begin(double *u, int *found, struct hawser__boundary_work *work, double p,
                                struct hawser_report *report)
{
	struct hawser_beam_limits limits;
	struct hawser__beam_sample sample;
	struct hawser_beam beam;
	double v, w = 0.0;
	enum hawser__onset onset;
	enum hawser_status status = work->family->at(&beam, work->family->context, p, NULL);

	*found = 0;
	if (status) /* the parameter gives no valid beam */
		return HAWSER_OK;
	beam.speed = 0.0;
	status = hawser_beam_limits(&limits, work->is, &beam, work->options->modes, report);
	v = work->options->bifurcation ? limits.v_bif : limits.v_crit;
	if (status || !(v > 0.0) || limits.cause == HAWSER_BEAM_WAVES)
		return status;
	status = hawser__beam_sample(&sample, work->is, &beam, v, work->options->modes, report);
	if (status)
		return status;
	onset = limits.cause == HAWSER_BEAM_FLUTTERS ? HAWSER__AXIS : HAWSER__STATIC;
	if (work->options->bifurcation)
		onset = beam.drag == 0.0 && limits.cause == HAWSER_BEAM_DIVERGES ? HAWSER__STATIC
		                                                                 : HAWSER__DOUBLE;
	if (onset != HAWSER__STATIC) {
		double least = INFINITY;

		for (int k = 0; k < sample.pairs; k++) {
			const struct hawser__beam_pair *pair = &sample.pair[k];
			double off = onset == HAWSER__AXIS ? pair->im > 0.0 ? fabs(pair->re[0]) : INFINITY
			             : fmin(pair->im, fabs(pair->re[0] - pair->re[1]) + pair->im);

			if (off < least) {
				least = off;
				w = onset == HAWSER__AXIS ? pair->im : 0.5*(pair->re[0] + pair->re[1]);
			}
		}
	}
	hawser__onset_clear(&work->equation);
	status = hawser__onset_open(&work->equation, onset, work->is, work->family, report);
	if (!status) {
		work->equation.scale[0] = work->range;
		work->equation.scale[1] = v;
		work->equation.scale[2] = onset == HAWSER__DOUBLE ? fmax(fabs(w), 4.0*v) : fabs(w);
		if (onset == HAWSER__STATIC)
			work->equation.scale[2] = 1.0;
		hawser__onset_border(&work->equation, &sample, onset == HAWSER__AXIS ? I*w : w);
		u[0] = p/work->range;
		u[1] = 1.0;
		u[2] = w/work->equation.scale[2];
		*found = 1;
	}
	hawser__beam_sample_clear(&sample);
	return status;
}

static void reverse(struct hawser_beam_boundary_point *point, int count)
{
	for (int i = 0, k = count - 1; i < k; i++, k--) {
		struct hawser_beam_boundary_point swapped = point[i];

		point[i] = point[k];
		point[k] = swapped;
	}
}

/* Trace the piece through p in both directions, from parameter *low to *high. *found is 0 if
 * there is no boundary at p. */
static enum hawser_status piece(int *found, double *low, double *high,
                                enum hawser__boundary_end end[2],
                                struct hawser__boundary_work *work, double p,
                                struct hawser_report *report)
{
	struct hawser_beam_boundary *boundary = work->boundary;
	struct hawser_beam_boundary_point point;
	double u[3], border[2] = {p, p};
	int first = boundary->points, good, iterations;
	enum hawser_status status = begin(u, found, work, p, report);

	if (status || !*found)
		return status;
	status = hawser__onset_correct(&work->equation, u, hawser__along_parameter, &iterations, report);
	if (!status)
		status = hawser__boundary_point(&point, &good, work, u, report);
	if (status == HAWSER_ERR_CONVERGENCE || (!status && !good)) {
		*found = 0;
		return HAWSER_OK;
	}
	for (int side = 0; !status && side < 2; side++) {
		if (side == 1) {
			if (boundary->points > first)
				reverse(boundary->point + first, boundary->points - first);
			status = hawser__boundary_keep(work, &point, report);
			if (!status)
				status = begin(u, found, work, p, report);
			if (!status && *found)
				status = hawser__onset_correct(&work->equation, u,
				                               hawser__along_parameter, &iterations,
				                               report);
		}
		end[side] = HAWSER__RANGE_ENDS;
		if (!status && (side == 0 ? p > work->low : p < work->high))
			status = hawser__boundary_follow(&end[side], &border[side], work, u,
			                                 side ? 1.0 : -1.0, report);
	}
	*low = fmin(border[0], p);
	*high = fmax(border[1], p);
	boundary->pieces++;
	return status;
}

static void explain(char *text, size_t size, enum hawser__boundary_end end, double at, int possible)
{
	*text = '\0';
	if (end == HAWSER__SPEED_ENDS)
		snprintf(text, size, "at %.10g the boundary reaches speed 0", at);
	else if (end == HAWSER__PIECE_LOST && !possible)
		snprintf(text, size, "followed to %.10g: beyond it the parameter gives no valid beam", at);
	else if (end == HAWSER__PIECE_LOST)
		snprintf(text, size, "the boundary was lost at %.10g", at);
	else if (end == HAWSER__OVERTAKEN)
		snprintf(text, size, "at %.10g another mode becomes critical", at);
}

static int possible(const struct hawser__boundary_work *work, double p)
{
	struct hawser_beam beam;

	return work->family->at(&beam, work->family->context, p, NULL) == HAWSER_OK;
}

/* The boundary of a string, in closed form: the speed of its slowest waves. */
static enum hawser_status string_boundary(struct hawser__boundary_work *work,
                                          struct hawser_report *report)
{
	enum { PLACES = 201 }; /* equidistant parameters */
	const struct hawser_beam_boundary_options *options = work->options;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; !status && i < PLACES; i++) {
		double p = options->from + (options->to - options->from)*i/(PLACES - 1.0);
		struct hawser_beam beam;

		if (work->family->at(&beam, work->family->context, p, NULL))
			continue;
		status = hawser__boundary_keep(work, &(struct hawser_beam_boundary_point){.parameter = p,
			.speed = sqrt(fmax(hawser_beam_least_tension(&beam), 0.0)), .growing = {0, 1},
			.per_speed = beam.time > 0.0 ? beam.length/beam.time : 1.0,
			.cause = HAWSER_BEAM_STRING}, report);
	}
	work->boundary->pieces = work->boundary->points > 0;
	return status;
}

/* A piece that is lost closer than CLOSE to an end of the range counts as complete. */
static enum hawser__boundary_end near_range_end(enum hawser__boundary_end end, double gap,
                                                const struct hawser__boundary_work *work)
{
	return end == HAWSER__PIECE_LOST && gap < CLOSE*work->range ? HAWSER__RANGE_ENDS : end;
}

/* Search for a first piece at equidistant parameters from the lower end. *p is the parameter
 * found. */
static enum hawser_status first_piece(int *found, double *p, double *low, double *high,
                                      enum hawser__boundary_end end[2],
                                      struct hawser__boundary_work *work,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*found = 0;
	for (int i = 0; !status && !*found && i < STARTS; i++) {
		*p = work->options->from + work->range*i/(STARTS - 1.0);
		status = piece(found, low, high, end, work, *p, report);
	}
	return status;
}

/* Search for further pieces below *low (right 0) or above *high (right 1), as long as the last
 * piece was overtaken or lost. */
static enum hawser_status more_pieces(double *low, double *high, enum hawser__boundary_end end[2],
                                      struct hawser__boundary_work *work, int right,
                                      struct hawser_report *report)
{
	const struct hawser_beam_boundary_options *options = work->options;
	enum hawser_status status = HAWSER_OK;
	enum hawser__boundary_end next[2];
	double l, h;
	int found = 1;

	while (!status && found && work->boundary->pieces < PIECES) {
		double left = right ? options->to - *high : *low - options->from, p = 0.0;

		if ((end[right] != HAWSER__OVERTAKEN && end[right] != HAWSER__PIECE_LOST) ||
		    left < CLOSE*work->range*1e-3)
			break;
		work->low = right ? *high : options->from;
		work->high = right ? options->to : *low;
		found = 0;
		for (double part = 0.01; !status && !found && part < 0.7; part *= 3.0) {
			p = right ? *high + part*left : *low - part*left;
			status = piece(&found, &l, &h, next, work, p, report);
		}
		if (status || !found)
			break;
		*low = fmin(*low, l);
		*high = fmax(*high, h);
		end[right] = next[right];
	}
	return status;
}

static enum hawser_status trace(struct hawser__boundary_work *work, struct hawser_report *report)
{
	const struct hawser_beam_boundary_options *options = work->options;
	struct hawser_beam_boundary *boundary = work->boundary;
	double low, high, p;
	enum hawser__boundary_end end[2];
	int found;
	enum hawser_status status = first_piece(&found, &p, &low, &high, end, work, report);

	if (status || !found)
		return status;
	for (int right = 0; !status && right < 2; right++)
		status = more_pieces(&low, &high, end, work, right, report);
	explain(boundary->ended[0], sizeof boundary->ended[0],
	        near_range_end(end[0], low - options->from, work), low, possible(work, options->from));
	explain(boundary->ended[1], sizeof boundary->ended[1],
	        near_range_end(end[1], options->to - high, work), high, possible(work, options->to));
	return status;
}

enum hawser_status hawser_beam_boundary(struct hawser_beam_boundary *boundary,
                                        const struct hawser_beam_integrals *is,
                                        const struct hawser_beam_family *family,
                                        const struct hawser_beam_boundary_options *options,
                                        struct hawser_report *report)
{
	struct hawser__boundary_work work = {.boundary = boundary, .is = is, .family = family,
		.options = options, .range = options->to - options->from, .low = options->from,
		.high = options->to, .longest = options->step > 0.0 ? options->step : 0.02,
		.most = options->max_points > 0 ? options->max_points : MOST};
	struct hawser_beam middle;
	enum hawser_status status;

	memset(boundary, 0, sizeof *boundary);
	if (!(options->from < options->to) || !isfinite(work.range) || options->modes < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                    "a boundary from %g to %g with %d modes: give the smaller end first, and "
		                    "at least one mode", options->from, options->to, options->modes);
	status = family->at(&middle, family->context, options->to, report);
	if (!status)
		status = middle.theta == 0.0 ? string_boundary(&work, report) : trace(&work, report);
	hawser__onset_clear(&work.equation);
	if (!status && boundary->points == 0)
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "beam",
		                      "no boundary of stability for parameters from %g to %g", options->from,
		                      options->to);
	if (status)
		hawser_beam_boundary_clear(boundary);
	return status;
}

void hawser_beam_boundary_clear(struct hawser_beam_boundary *boundary)
{
	if (!boundary)
		return;
	free(boundary->point);
	memset(boundary, 0, sizeof *boundary);
}

enum hawser_status hawser_beam_scene_family(struct hawser_beam *beam, void *context, double parameter,
                                            struct hawser_report *report)
{
	const struct hawser_beam_scene_key *family = context;
	struct hawser_scene scene = *family->scene; /* shallow copy: not to be cleared */
	enum hawser_status status = hawser_scene_set(&scene, family->key, parameter, report);

	return status ? status : hawser_beam_scene(beam, &scene, report);
}
