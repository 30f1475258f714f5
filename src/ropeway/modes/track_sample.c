/* ropeway/modes/track_sample.c - modes at one value of a sweep, and how much the shapes of two
 * modes have in common.
 *
 * Shapes are compared at the same parts of each span: a span whose ends move, and carriers that pass,
 * change neither the number of these points nor what a mode is. Their weight is the length of rope,
 * with the carriers spread along it. The shapes of one value are then nearly orthogonal, which is
 * enough to find each mode again at the next value.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <cblas.h>

#include "core/report.h"
#include "ropeway/statics/line.h"
#include "ropeway/modes/track.h"

/* Points of a span: several for each half wave of the modes that are asked for. */
enum { PER_SPAN = 16 };
enum { HALVINGS = 60 }; /* to the last digit of a place */
#define APART 1e-9 /* of the energy in common spans: the modes of spans that do not interact have 0 */

void hawser__track_sample_clear(struct hawser__track_sample *sample)
{
	free(sample->omega);
	free(sample->residual);
	free(sample->plane);
	free(sample->share);
	free(sample->shape);
	free(sample->branch);
	*sample = (struct hawser__track_sample){.n = 0};
}

double hawser__track_alike(const struct hawser__track_sample *a, int i,
                           const struct hawser__track_sample *b, int j)
{
	int n = a->values;
	const double *x = a->shape + (size_t)i*2*(size_t)n, *y = b->shape + (size_t)j*2*(size_t)n;
	double c = cblas_ddot(n, x, 1, y, 1) + cblas_ddot(n, x + n, 1, y + n, 1);
	double s = cblas_ddot(n, x, 1, y + n, 1) - cblas_ddot(n, x + n, 1, y, 1);

	return a->plane[i] == b->plane[j] ? c*c + s*s : 0.0;
}

int hawser__track_coupled(const struct hawser__track_sample *a, int i, int j)
{
	double common = 0.0;

	for (int k = 0; k < a->spans; k++)
		common += fmin(a->share[i*a->spans + k], a->share[j*a->spans + k]);
	return a->plane[i] == a->plane[j] && common > APART;
}

/* A part of the line whose shapes are compared: a span of a lane, m of unstretched rope. */
struct part {
	int lane;
	double from, to;
};

/* What is solved at a value. */
struct state {
	struct part *part;   /* [parts] */
	int *own;            /* [modes.spans] the part to which a span of the modes belongs, or -1 */
	int parts;
	struct hawser_line_modes modes;
	struct hawser_ropeway_statics ropeway;
	struct hawser_obstacles_statics obstacles;
};

/* Modes whose spans are apart at a sheave are coupled all the same if the rope slips over it: their
 * shares are then not exactly 0. */
static void keep_shape(double *to, const struct state *of, int values, int k)
{
	int parts = of->modes.gyroscopic ? 2 : 1, at = 0;
	double norm;

	for (int i = 0; i < of->parts; i++) {
		const struct part *part = &of->part[i];
		double length = part->to - part->from, weight = sqrt(length/PER_SPAN), shape[6];

		for (int p = 0; p < PER_SPAN; p++, at += 3) {
			hawser_line_modes_at(shape, NULL, &of->modes, k, part->lane,
			                     (part->from + length*(p + 0.5)/PER_SPAN)/of->modes.length_unit);
			for (int c = 0; c < 3*parts; c++)
				to[c/3*values + at + c % 3] = weight*shape[c];
		}
	}
	norm = cblas_dnrm2(2*values, to, 1);
	if (norm > 0.0)
		cblas_dscal(2*values, 1.0/norm, to, 1);
}

static enum hawser_status keep(struct hawser__track_sample *to, const struct state *of,
                               struct hawser_report *report)
{
	const struct hawser_line_modes *modes = &of->modes;
	size_t n = (size_t)modes->n;

	to->n = modes->n;
	to->spans = of->parts;
	to->values = 3*PER_SPAN*to->spans;
	to->omega = calloc(n, sizeof *to->omega);
	to->residual = calloc(n, sizeof *to->residual);
	to->plane = calloc(n, sizeof *to->plane);
	to->branch = calloc(n, sizeof *to->branch);
	to->share = calloc(n*(size_t)to->spans, sizeof *to->share);
	to->shape = calloc(n*2*(size_t)to->values, sizeof *to->shape);
	if (!to->omega || !to->residual || !to->plane || !to->branch || !to->share || !to->shape)
		return hawser__no_memory(report, "track");
	for (int k = 0; k < modes->n; k++) {
		to->omega[k] = modes->mode[k].omega/modes->time_unit;
		to->residual[k] = modes->mode[k].residual;
		to->plane[k] = modes->mode[k].plane;
		to->branch[k] = -1;
		for (int i = 0; i < modes->spans; i++)
			if (of->own[i] >= 0)
				to->share[k*to->spans + of->own[i]] += modes->share[k*modes->spans + i];
		keep_shape(to->shape + (size_t)k*2*(size_t)to->values, of, to->values, k);
	}
	return HAWSER_OK;
}

static enum hawser_status allot(struct state *of, int parts, struct hawser_report *report)
{
	of->parts = parts;
	of->part = calloc((size_t)parts + 1, sizeof *of->part);
	of->own = calloc((size_t)of->modes.spans + 1, sizeof *of->own);
	return of->part && of->own ? HAWSER_OK : hawser__no_memory(report, "track");
}

static enum hawser_status solve_ropeway(struct state *of, struct hawser__track_sample *sample,
                                        const struct hawser__track *t, const struct hawser_ropeway *rw,
                                        struct hawser_report *report)
{
	const struct hawser_ropeway_options options = {.load_case = t->options->load_case};
	const struct hawser_ropeway_modes_options choice = {.n = t->ask,
	                                                    .tolerance = t->options->tolerance};
	const struct hawser_ropeway_statics *st = &of->ropeway;
	enum hawser_status status = hawser_ropeway_solve(&of->ropeway, rw, &options, rw->phase, report);

	if (!status)
		status = hawser_ropeway_modes_solve(&of->modes, st, &choice, report);
	if (!status)
		status = allot(of, st->lanes*(rw->towers + 1), report);
	if (status)
		return status;
	for (int i = 0; i < of->parts; i++) {
		int lane = i/(rw->towers + 1);
		const struct hawser_ropeway_span *span = &st->lane[lane].span[i % (rw->towers + 1)];

		of->part[i] = (struct part){lane, span->S_from, span->S_to};
	}
	hawser_ropeway_modes_spans(of->own, &of->modes, st);
	sample->at.T0 = st->T0;
	return HAWSER_OK;
}

/* S at which the rope is above or below the middle of a sheave that it does not touch. */
static double passes(const struct hawser_line_statics *st, int sheave)
{
	double low = 0.0, high = st->length0;

	for (int i = 0; i < HALVINGS; i++) {
		double S = 0.5*(low + high), x[2];

		hawser_line_at(st, x, NULL, NULL, NULL, NULL, S);
		*(x[0] < st->line->sheave[sheave].centre[0] ? &low : &high) = S;
	}
	return 0.5*(low + high);
}

/* The parts from obstacle to obstacle: each ends where the rope touches the next one. */
static void divide(struct state *of, int *touched)
{
	const struct hawser_line_statics *st = &of->obstacles.st;
	int span = 0;

	*touched = 0;
	of->own[0] = 0;
	of->part[0].from = 0.0;
	for (int k = 0; k < st->line->sheaves; k++) {
		double *to = &of->part[k].to, *from = &of->part[k + 1].from;

		if (!st->contact[k].touches) {
			*to = *from = passes(st, k);
			continue;
		}
		hawser__line_touch(to, from, st, k);
		++*touched;
		if (++span < of->modes.spans)
			of->own[span] = k + 1;
	}
	of->part[st->line->sheaves].to = st->length0;
}

static enum hawser_status solve_obstacles(struct state *of, struct hawser__track_sample *sample,
                                          const struct hawser__track *t,
                                          const struct hawser_obstacles *scene,
                                          struct hawser_report *report)
{
	struct hawser_line_modes_options options = {.n = t->ask, .tolerance = t->options->tolerance};
	const struct hawser_line_statics *st = &of->obstacles.st;
	enum hawser_status status = hawser_obstacles_solve(&of->obstacles, scene, report);

	if (!status)
		status = hawser_obstacles_contact(&options.contact, &options.loose, scene, st, report);
	if (!status)
		status = hawser_line_modes_solve(&of->modes, &st, 1, &options, report);
	if (!status)
		status = allot(of, scene->line.sheaves + 1, report);
	if (status)
		return status;
	divide(of, &sample->at.touched);
	sample->at.T0 = st->T_A;
	return HAWSER_OK;
}

enum hawser_status hawser__track_open(struct hawser__track_scene *scene, const struct hawser__track *t,
                                      double value, struct hawser_report *report)
{
	const struct hawser_ropeway_track_options *o = t->options;

	*scene = (struct hawser__track_scene){.value = value};
	return o->open ? o->open(&scene->ropeway, o->context, value, report)
	               : o->open_obstacles(&scene->obstacles, o->context, value, report);
}

void hawser__track_scene_clear(struct hawser__track_scene *scene)
{
	hawser_ropeway_clear(&scene->ropeway);
	hawser_obstacles_clear(&scene->obstacles);
}

enum hawser_status hawser__track_solve(struct hawser__track_sample *sample,
                                       const struct hawser__track *t,
                                       const struct hawser__track_scene *scene,
                                       struct hawser_report *report)
{
	struct state of = {.parts = 0};
	enum hawser_status status;

	*sample = (struct hawser__track_sample){.at = {.value = scene->value}};
	status = t->options->open ? solve_ropeway(&of, sample, t, &scene->ropeway, report)
	                          : solve_obstacles(&of, sample, t, &scene->obstacles, report);
	sample->at.gyroscopic = of.modes.gyroscopic;
	if (!status)
		status = keep(sample, &of, report);
	hawser_line_modes_clear(&of.modes);
	hawser_ropeway_statics_clear(&of.ropeway);
	hawser_obstacles_statics_clear(&of.obstacles);
	free(of.part);
	free(of.own);
	if (status)
		hawser__track_sample_clear(sample);
	return status;
}

enum hawser_status hawser__track_sample(struct hawser__track_sample *sample, struct hawser__track *t,
                                        double value, struct hawser_report *report)
{
	struct hawser__track_scene scene;
	enum hawser_status status = hawser__track_open(&scene, t, value, report);

	if (!status) {
		status = hawser__track_solve(sample, t, &scene, report);
		t->solves++;
	}
	hawser__track_scene_clear(&scene);
	return status;
}
