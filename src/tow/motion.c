/* tow/motion.c - hawser_tow_move: a towed body in time.
 *
 * The rod, its inertia and the steps are those of rods (rod/motion.c); drag, shedding and the body are
 * a function of loads (motion_loads.c), and the towing point moves the first node (motion_start.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "tow/motion.h"

enum { SAMPLES = 500,          /* if `every` is not given: a curve of a picture */
       MOST = 1000000,         /* samples: a row of a table each */
       PER_PERIOD = 20 };      /* steps in a period of shedding: the error of its phase is 1 % */
#define FINE 1e-6   /* of the cable's length: local error of a step; 1000 steps leave 1e-3 of it */
#define BEGIN 1e-3  /* s, first step */
static const char where[] = "tow";

static enum hawser_status settle(struct hawser_tow_options *to, const struct hawser_tow_options *given,
                                 const struct hawser_tow *tow, struct hawser_report *report)
{
	double length = 0.0, last = tow->path.to;

	*to = given ? *given : (struct hawser_tow_options){.until = 0.0};
	for (int i = 0; i < tow->segments; i++)
		length += tow->segment[i].length;
	to->until = to->until > 0.0 ? to->until : last;
	if (!isfinite(to->until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "a path of constant speed has no end: "
		                    "give --until, the time (s) at which the motion ends");
	if (to->until > last)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "--until %.9g s is after the path's "
		                    "end at %.9g s", to->until, last);
	if (!(to->until > tow->path.from))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "--until %.9g s is not after the "
		                    "path's beginning at %.9g s", to->until, tow->path.from);
	to->tolerance = to->tolerance > 0.0 ? to->tolerance : FINE*length;
	to->every = to->every > 0.0 ? to->every : (to->until - tow->path.from)/SAMPLES;
	to->refine = to->refine > 0 ? to->refine : 1;
	if ((to->until - tow->path.from)/to->every > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "--every %.3g s makes more than %d "
		                    "samples: give a longer one", to->every, MOST);
	return HAWSER_OK;
}

static enum hawser_status allocate(struct hawser_tow_motion *out, int samples, int elements,
                                   struct hawser_report *report)
{
	out->sample = calloc((size_t)samples, sizeof *out->sample);
	out->shape = calloc((size_t)samples*((size_t)elements + 1), sizeof *out->shape);
	out->range = calloc((size_t)elements, sizeof *out->range);
	out->elements = elements;
	return out->sample && out->shape && out->range ? HAWSER_OK : hawser__no_memory(report, where);
}

/* --- what is kept --- */

static void take_sample(struct hawser_tow_motion *out, const struct hawser__tow_run *run)
{
	const struct hawser__rod_motion *motion = &run->motion;
	const struct hawser__rod_mesh *mesh = motion->mesh;
	const struct hawser__rod_node *end = &mesh->node[run->rod.end];
	double (*shape)[3] = out->shape + (size_t)out->samples*((size_t)out->elements + 1), R[9], rest[4];
	struct hawser_tow_sample *to = &out->sample[out->samples++];
	double l = run->own.body.kind == HAWSER_TOW_RING ? run->own.body.offset : 0.0;

	to->t = motion->t;
	memcpy(to->top, mesh->node[0].x, sizeof to->top);
	memcpy(to->end, mesh->node[run->rod.last].x, sizeof to->end);
	for (int k = 0; k < 4; k++)
		rest[k] = k ? -mesh->rest[0].q[k] : mesh->rest[0].q[k];
	hawser__quaternion_mul(to->attitude, end->q, rest);
	hawser__quaternion_matrix(R, end->q);
	for (int k = 0; k < 3; k++)
		to->body[k] = end->x[k] + l*R[3*k];
	to->tilt = atan2(hypot(R[0], R[6]), -R[3]);
	hawser__quaternion_matrix(R, mesh->node[0].q);
	for (int k = 0; k < 3; k++)
		to->tension_top -= motion->reaction[0][k]*R[3*k];
	to->tension_end = mesh->strain[run->rod.last - 1].N[0];
	to->kinetic = motion->energy.kinetic;
	to->strain = motion->energy.strain;
	to->height = motion->energy.height;
	to->towed = motion->energy.support;
	to->air = motion->energy.pushed;
	to->winch = motion->energy.winch;
	to->length = mesh->s[run->rod.last];
	for (int i = 0; i <= out->elements; i++)
		memcpy(shape[i], mesh->node[i].x, sizeof shape[i]);
}

/* A sample; body and cable must be above the bed of the water. */
static enum hawser_status sampled(struct hawser_tow_motion *out, const struct hawser__tow_run *run,
                                  struct hawser_report *report)
{
	const struct hawser__rod_mesh *mesh = run->motion.mesh;
	enum hawser_status status;

	take_sample(out, run);
	status = hawser__tow_above_bed(run->tow, out->sample[out->samples - 1].body[1], NAN, run->motion.t,
	                               where, report);
	for (int i = 0; i <= out->elements && !status; i++)
		status = hawser__tow_above_bed(run->tow, mesh->node[i].x[1], mesh->s[i], run->motion.t, where,
		                               report);
	return status;
}

static void take_ranges(struct hawser_tow_motion *out, const struct hawser__tow_run *run, double h)
{
	const double *s = run->motion.mesh->s;

	for (int e = 0; e < out->elements; e++) {
		const struct hawser__rod_strain *at = &run->motion.mesh->strain[e];
		struct hawser_tow_range *to = &out->range[e];

		to->s += run->motion.winch.as ? h*0.5*(s[e] + s[e + 1]) : 0.0;
		to->least = fmin(to->least, at->N[0]);
		to->most = fmax(to->most, at->N[0]);
		to->mean += h*at->N[0];
		to->bent = fmax(to->bent, hypot(at->k[1], at->k[2]));
	}
}

/* --- steps --- */

static enum hawser_status aliased(const struct hawser__tow_run *run, double step,
                                  struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "--step %.6g s is too long for vortex "
	                    "shedding of %.6g Hz at %.6g s, which it would show at a wrong frequency or "
	                    "not at all: give at most %.3g s (%d steps a period), or leave --step out",
	                    step, run->frequency, run->motion.t, 1.0/(PER_PERIOD*run->frequency),
	                    PER_PERIOD);
}

/* To the next sample. */
static enum hawser_status advance(struct hawser_tow_motion *out, struct hawser__tow_run *run,
                                  const struct hawser_tow_options *options, double *h, double to,
                                  struct hawser_report *report)
{
	double from = run->motion.t, count = ceil((to - from)/options->step*(1.0 - 1e-12));
	enum hawser_status status = HAWSER_OK;

	for (int i = 1; !status && run->motion.t < to; i++) {
		double before = run->motion.t, most = 1.0/(PER_PERIOD*run->frequency);

		if (options->step > 0.0) {
			double step = i >= count ? to - before : from + (to - from)*i/count - before;

			if (step > most*(1.0 + 1e-9))
				return aliased(run, step, report);
			status = hawser__rod_motion_step(&run->motion, step, report);
		} else {
			*h = fmin(*h, most);
			status = hawser__rod_motion_adapt(&run->motion, h, to, options->tolerance, report);
		}
		if (status)
			return status;
		if (to - run->motion.t < 1e-12*fabs(to))
			run->motion.t = to;
		else
			out->shortest = fmin(out->shortest, run->motion.h);
		hawser__tow_shed(run);
		out->frequency = fmax(out->frequency, run->frequency);
		take_ranges(out, run, run->motion.t - before);
	}
	return status;
}

static void clear_ranges(struct hawser_tow_motion *out, const struct hawser__tow_run *run)
{
	for (int e = 0; e < out->elements; e++)
		out->range[e] = (struct hawser_tow_range){
			.s = run->motion.winch.as ? 0.0 : 0.5*(run->rod.mesh.s[e] + run->rod.mesh.s[e + 1]),
			.least = INFINITY, .most = -INFINITY};
}

/* The first state; *h is the first step. */
static enum hawser_status begin(struct hawser__tow_run *run, double *h,
                                const struct hawser_tow_options *options, struct hawser_report *report)
{
	enum hawser_status status;

	if (!options->initial)
		return hawser__rod_motion_begin(&run->motion, 1, report);
	status = hawser__tow_state_read(run, h, options->initial, report);
	if (!status && !(run->motion.t < options->until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "%s is the state at %.9g s, and the "
		                    "motion is to end at %.9g s: --until counts as the path does",
		                    options->initial, run->motion.t, options->until);
	return status;
}

static enum hawser_status go(struct hawser_tow_motion *out, struct hawser__tow_run *run, double *h,
                             const struct hawser_tow_options *options, struct hawser_report *report)
{
	double first = run->tow->path.from, from;
	int count = (int)ceil((options->until - first)/options->every - 1e-9), i;
	enum hawser_status status = allocate(out, count + 1, run->rod.last, report);

	if (!status)
		status = begin(run, h, options, report);
	if (status)
		return status;
	clear_ranges(out, run);
	out->shortest = INFINITY;
	from = run->motion.t;
	(void)hawser__rod_motion_form(&run->motion, from, 0);
	hawser__rod_winch_power(&run->motion);
	status = sampled(out, run, report);
	for (i = 1 + (int)floor((from - first)/options->every*(1.0 + 1e-12)); i <= count && !status &&
	     !out->interrupted; i++) {
		run->motion.factor_h = 0.0; /* as in a run that begins here, to the last bit */
		status = advance(out, run, options, h, i == count ? options->until : first + i*options->every,
		                 report);
		if (!status)
			status = sampled(out, run, report);
		if (status)
			return status;
		out->interrupted = options->progress &&
		                   options->progress(options->data, run->motion.t, options->until);
	}
	for (int e = 0; e < out->elements && !status; e++) {
		out->range[e].mean /= run->motion.t - from;
		out->range[e].s /= run->motion.winch.as ? run->motion.t - from : 1.0;
	}
	return status;
}

enum hawser_status hawser_tow_move(struct hawser_tow_motion *out, const struct hawser_tow *tow,
                                   const struct hawser_tow_options *given, struct hawser_report *report)
{
	struct hawser_tow_options options;
	struct hawser__tow_run run;
	enum hawser_status status = settle(&options, given, tow, report);
	double h;

	memset(out, 0, sizeof *out);
	if (status)
		return status;
	status = hawser__tow_run_open(&run, tow, options.refine, options.until, report);
	if (!status) {
		run.motion.rho_inf = options.rho_inf > 0.0 ? options.rho_inf : run.motion.rho_inf;
		h = fmin(BEGIN, options.every);
		status = go(out, &run, &h, &options, report);
	}
	if (!status)
		status = hawser__tow_state_save(&out->state, &out->states, &run, h, report);
	if (!status) {
		out->raised = run.rod.raised;
		out->steps = run.motion.steps;
		out->rejected = run.motion.rejected;
		out->iterations = run.motion.iterations;
		out->step_error = run.motion.drift;
		out->closure = run.motion.energy_lost/fmax(run.motion.most_energy, DBL_MIN);
		out->momentum = run.motion.momentum_gap/fmax(run.motion.most_momentum, DBL_MIN);
	}
	hawser__tow_run_close(&run);
	if (status)
		hawser_tow_motion_clear(out);
	return status;
}

void hawser_tow_motion_clear(struct hawser_tow_motion *motion)
{
	if (!motion)
		return;
	free(motion->sample);
	free(motion->shape);
	free(motion->range);
	free(motion->state);
	memset(motion, 0, sizeof *motion);
}
