/* study/compare/span_motion.c - a mesh of cable elements and reduced models under the same load; see
 * hawser/span_motion.h.
 *
 * Both begin at rest in the equilibrium, with the load at its largest: cos(Omega t). Modes that are not
 * kept, and the mesh, then start with transients that differ: the latter's axial waves are those of
 * a cable, condensed modes have none. They decay as slowly as all motions with a small alpha.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/integrate.h>
#include <hawser/span_motion.h>

#include "core/progress.h"
#include "core/report.h"

enum { PROBES = HAWSER_SPAN_PROBES, MOST_POINTS = 50, MOST_ROWS = 1000000, MOST_STEPS = 100000,
       STEPS = 100 };
static const char where[] = "motion";
/* Of the largest displacement of all, and of the length: less motion than this is none, and has no
 * relative error. */
static const double NOTHING = 1e-9, ROUND_OFF = 1e-13;

void hawser_motions_clear(struct hawser_motions *motions)
{
	if (!motions)
		return;
	for (int i = 0; i < motions->runs && motions->run; i++)
		free(motions->run[i].x);
	free(motions->run);
	free(motions->off);
	hawser_net_motion_clear(&motions->motion);
	memset(motions, 0, sizeof *motions);
}

/* --- the mesh --- */

static enum hawser_status mesh(struct hawser_motions *motions, const struct hawser_scene *scene,
                               const struct hawser_statics *st,
                               const struct hawser_motions_options *options,
                               struct hawser_report *report)
{
	const struct hawser_net_span_motion_options choice = {
		.mesh = {.elements = options->elements, .Omega = options->Omega}, .until = options->until,
		.every = options->every, .step = options->step, .progress = options->progress};
	struct hawser_net_span_motion run;
	struct hawser_motions_run *to = motions->run;
	enum hawser_status status = hawser_net_span_integrate(&run, scene, st, &choice, report);

	if (status)
		return status;
	snprintf(to->name, sizeof to->name, "mesh %d", run.elements);
	to->n = 3*(run.elements - 1);
	to->seconds = run.seconds;
	to->x = run.x;
	to->least = run.motion.least;
	to->least_at = run.motion.least_at;
	to->slack_at = run.motion.slack_at;
	to->slack_S = isnan(to->slack_at) ? NAN : run.slack_S;
	motions->motion = run.motion;
	motions->off = run.off;
	motions->rows = run.rows;
	motions->interrupted = run.interrupted;
	motions->elements = run.elements;
	motions->other = run.other;
	motions->step = run.step;
	motions->other_seconds = run.other_seconds;
	return HAWSER_OK;
}

/* --- a model --- */

static void tension(struct hawser_motions_run *to, const struct hawser_rom *rom, const double *state,
                    const struct hawser_rom_moment *moment, double t)
{
	double least, most;

	if (!hawser_rom_tensions_at(rom, &least, &most, state, moment))
		return;
	if (!(least >= to->least)) {
		to->least = least;
		to->least_at = t;
	}
	if (least < 0.0 && isnan(to->slack_at))
		to->slack_at = t;
}

/* Points of the model's run in a row of the result: four in the time in which an axial wave runs along
 * the cable, so that its tension is seen, but not too many. */
static int points_of(const struct hawser_motions *motions, const struct hawser_statics *st,
                     const struct hawser_motions_options *options)
{
	double transit = st->length0*sqrt(st->span.rho/st->span.EA);
	double most = fmin(MOST_POINTS, MOST_ROWS/fmax(motions->rows, 1));

	return (int)fmax(fmin(ceil(4.0*options->every/transit), most), 1.0);
}

/* Steps that a motion in the range of a model does not need: so many in a period of its fastest
 * coordinate. One that escapes takes ever shorter steps. */
static long steps_of(const struct hawser_rom *rom, double until)
{
	double fastest = 0.0;

	for (int j = 0; j < rom->n; j++)
		fastest = fmax(fastest, sqrt(fabs(rom->K[j*rom->n + j])));
	return (long)fmin(MOST_STEPS + STEPS*fastest*until/(2.0*M_PI), 1e8);
}

/* Tensions of all points that there are; displacements if the run is complete. */
static enum hawser_status sample(struct hawser_motions_run *to, const struct hawser_motions *motions,
                                 const struct hawser_rom *rom, const struct hawser_trajectory *run,
                                 const struct hawser_integrate_options *options, int points,
                                 struct hawser_report *report)
{
	int count = (motions->rows - 1)*points + 1, whole = run->rows >= count;

	to->n = rom->n;
	to->x = calloc((size_t)motions->rows*PROBES + 1, sizeof *to->x);
	if (!to->x)
		return hawser__no_memory(report, where);
	for (int i = 0; i < count && i < run->rows; i++) {
		const double *state = run->state + (size_t)i*2*(size_t)rom->n;
		struct hawser_rom_moment moment = hawser_integrate_moment(options, run->time[i]);

		for (int p = 0; p < PROBES && whole && i % points == 0; p++) {
			double *x = to->x[i/points*PROBES + p];

			hawser_rom_displacement_at(rom, x, p, state, &moment);
			for (int k = 0; k < 3; k++)
				x[k] *= rom->length;
		}
		tension(to, rom, state, &moment, run->time[i]*rom->time);
	}
	return whole ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_CONVERGENCE, where, "the run was interrupted");
}

static enum hawser_status integrate(struct hawser_motions_run *to, const struct hawser_motions *motions,
                                    const struct hawser_rom *rom, const struct hawser_statics *st,
                                    const struct hawser_motions_options *options,
                                    struct hawser_report *report)
{
	int points = points_of(motions, st, options);
	const struct hawser_integrate_options choice = {
		.omega = options->Omega*rom->time, .until = options->until/rom->time,
		.every = options->every/rom->time/points, .progress = options->progress,
		.max_steps = steps_of(rom, options->until/rom->time)};
	struct hawser_trajectory run = {.rows = 0};
	enum hawser_status status = hawser_integrate(&run, rom, &choice, report), sampled;

	sampled = sample(to, motions, rom, &run, &choice, points, status ? NULL : report);
	hawser_trajectory_clear(&run);
	return status ? status : sampled;
}

/* A failure is part of the result. */
static void model(struct hawser_motions_run *to, const struct hawser_motions *motions,
                  const struct hawser_scene *scene, const struct hawser_statics *st,
                  const struct hawser_motions_options *options,
                  const struct hawser_fidelity_choice *choice)
{
	struct hawser_rom rom = {0};
	double began = hawser__processor_seconds();

	memcpy(to->name, choice->name, sizeof to->name);
	to->least = to->least_at = to->slack_at = to->slack_S = NAN;
	to->status = choice->fidelity->build(&rom, st, scene, choice->number, &to->report);
	if (!to->status)
		to->status = integrate(to, motions, &rom, st, options, &to->report);
	to->seconds = hawser__processor_seconds() - began;
	hawser_rom_clear(&rom);
}

/* --- differences --- */

static int first_row(const struct hawser_motions *motions, double after)
{
	int i = 0;

	while (i < motions->rows - 1 && motions->motion.time[i] < after*(1.0 - 1e-12))
		i++;
	return i;
}

/* Root mean square of component k of a probe, of x or of x - y. */
static double rms(const double (*x)[3], const double (*y)[3], const struct hawser_motions *motions,
                  int p, int k, int first)
{
	double sum = 0.0;

	for (int i = first; i < motions->rows; i++) {
		double value = x[i*PROBES + p][k] - (y ? y[i*PROBES + p][k] : 0.0);

		sum += value*value;
	}
	return sqrt(sum/(motions->rows - first));
}

static void compare(struct hawser_motions *motions, int first, double length)
{
	const double (*of)[3] = (const double (*)[3])motions->run[0].x;
	const double (*off)[3] = (const double (*)[3])motions->off;
	double size[PROBES][3], most = 0.0;

	for (int p = 0; p < PROBES; p++)
		for (int k = 0; k < 3; k++) {
			size[p][k] = rms(of, NULL, motions, p, k, first);
			most = fmax(most, size[p][k]);
		}
	for (int r = 0; r < motions->runs; r++) {
		struct hawser_motions_run *run = &motions->run[r];
		const double (*x)[3] = (const double (*)[3])run->x;

		for (int p = 0; p < PROBES && !run->status; p++)
			for (int k = 0; k < 3; k++) {
				double error = r ? rms(x, of, motions, p, k, first)
					: off ? rms(off, NULL, motions, p, k, first) : NAN;

				run->difference[p][k] = size[p][k] > fmax(NOTHING*most, ROUND_OFF*length)
					? error/size[p][k] : NAN;
				for (int i = first; i < motions->rows; i++)
					run->largest[p][k] = fmax(run->largest[p][k], fabs(x[i*PROBES + p][k]));
			}
	}
}

static enum hawser_status check(const struct hawser_motions_options *options,
                                struct hawser_report *report)
{
	if (!(options->until > 0.0 && options->every > 0.0 && options->after >= 0.0) ||
	    options->after >= options->until)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "rows every %g s from %g s to %g s: "
		                    "give positive times, with an end after their beginning",
		                    options->every, options->after, options->until);
	for (int i = 0; i < options->choices; i++) {
		const char *name = options->choice[i].fidelity->name;

		if (strcmp(name, "raw") != 0 && strcmp(name, "condensed") != 0 && strcmp(name, "full") != 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "the fidelity %s has no motion from rest: name raw N, condensed N or "
			                    "full N", name);
	}
	return HAWSER_OK;
}

enum hawser_status hawser_motions_compare(struct hawser_motions *motions,
                                          const struct hawser_scene *scene,
                                          const struct hawser_statics *st,
                                          const struct hawser_motions_options *options,
                                          struct hawser_report *report)
{
	enum hawser_status status = check(options, report);

	memset(motions, 0, sizeof *motions);
	if (status)
		return status;
	motions->runs = options->choices + 1;
	motions->run = calloc((size_t)motions->runs, sizeof *motions->run);
	if (!motions->run)
		status = hawser__no_memory(report, where);
	if (!status)
		status = mesh(motions, scene, st, options, report);
	for (int i = 0; i < options->choices && !status && !motions->interrupted; i++)
		model(&motions->run[i + 1], motions, scene, st, options, &options->choice[i]);
	if (!status && motions->interrupted)
		motions->runs = 1;
	if (!status)
		compare(motions, first_row(motions, options->after), st->length0);
	if (status)
		hawser_motions_clear(motions);
	return status;
}
