/* net/span/span-motion.c - the motion of a span by its mesh, with an estimate of its error.
 *
 *   N, h    elements and steps of the mesh; the second run has N/2 and 2h
 *   x       displacement of a probe from the equilibrium
 *   off     (x - x of the second run)/3: error of x at order 2 in both; the whole difference if
 *           the scheme is of order 1
 *
 * By the local error of a step, which is of order 3, twice the step is 8 times the tolerance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "net/span/span.h"

enum { PROBES = HAWSER_SPAN_PROBES, STEPS = 1000 };
static const double place[PROBES] = {0.25, 0.5, 0.75};
static const double tolerance = 1e-7; /* as that of hawser_net_integrate */

const char *hawser_net_span_probe(int probe)
{
	static const char *const name[PROBES] = {"quarter", "mid", "three_quarter"};

	return probe >= 0 && probe < PROBES ? name[probe] : NULL;
}

/* The default of the step, s. */
static double default_step(const struct hawser_scene *scene, const struct hawser_statics *st,
                           double Omega)
{
	double period = 2.0*st->length0*sqrt(st->span.rho/st->H);
	int most = scene->load.present ? 1 : 0;

	for (int i = 0; i < scene->loads; i++)
		most = scene->piece[i].harmonic > most ? scene->piece[i].harmonic : most;
	for (int end = 0; end < 2; end++)
		if (scene->support[end].present)
			most = scene->support[end].harmonic > most ? scene->support[end].harmonic : most;
	if (most > 0 && Omega > 0.0)
		period = fmin(period, 2.0*M_PI/(most*Omega));
	return period/STEPS;
}

void hawser_net_span_motion_clear(struct hawser_net_span_motion *run)
{
	if (!run)
		return;
	hawser_net_motion_clear(&run->motion);
	free(run->x);
	free(run->off);
	memset(run, 0, sizeof *run);
}

/* --- one run --- */

struct level {
	struct hawser_net net;
	struct hawser_net_probe probe[PROBES];
	double rest[PROBES][3]; /* m, in the equilibrium */
	struct hawser_net_motion motion;
	int elements;
	double seconds;
};

static void clear(struct level *level)
{
	hawser_net_motion_clear(&level->motion);
	hawser_net_clear(&level->net);
}

/* Where the probes are in the equilibrium, with ends that do not move. */
static enum hawser_status rest(struct level *level, struct hawser_report *report)
{
	struct hawser_net_statics st;
	enum hawser_status status = hawser_net_solve(&st, &level->net, NULL, report);

	for (int p = 0; p < PROBES && !status; p++) {
		const struct hawser_net_point *at = st.point;
		int n = level->net.cable[level->probe[p].cable].elements, e;
		double along = level->probe[p].part*n;

		for (int c = 0; c < level->probe[p].cable; c++)
			at += level->net.cable[c].elements + 1;
		e = (int)fmin(along, n - 1);
		for (int k = 0; k < 3; k++)
			level->rest[p][k] = at[e].x[k] + (along - e)*(at[e + 1].x[k] - at[e].x[k]);
	}
	if (!status)
		hawser_net_statics_clear(&st);
	return status;
}

static enum hawser_status run_level(struct level *level, const struct hawser_scene *scene,
                                    const struct hawser_statics *st,
                                    const struct hawser_net_span_options *mesh, int halved,
                                    const struct hawser_net_motion_options *options,
                                    struct hawser_report *report)
{
	struct hawser_net_motion_options choice = *options;
	enum hawser_status status = hawser__net_span(&level->net, scene, st, mesh, 1, halved, report);
	double began = hawser__processor_seconds();

	if (status)
		return status;
	for (int p = 0; p < PROBES; p++) {
		level->probe[p].node = -1;
		hawser__net_span_place(&level->probe[p].cable, &level->probe[p].part, &level->net,
		                      place[p]*st->length0);
	}
	for (int c = 0; c < level->net.cables; c++)
		level->elements += level->net.cable[c].elements;
	choice.probe = level->probe;
	choice.probes = PROBES;
	if (level->net.motions)
		status = rest(level, report);
	if (!status)
		status = hawser_net_integrate(&level->motion, &level->net, &choice, report);
	for (int p = 0; p < PROBES && !status && !level->net.motions; p++)
		memcpy(level->rest[p], level->motion.x[p], sizeof level->rest[p]);
	level->seconds = hawser__processor_seconds() - began;
	return status;
}

static double moved(const struct level *level, int row, int probe, int k)
{
	return level->motion.x[row*PROBES + probe][k] - level->rest[probe][k];
}

/* --- both --- */

static enum hawser_status fill(struct hawser_net_span_motion *run, struct level *fine,
                               const struct level *coarse, struct hawser_report *report)
{
	int rows = fine->motion.rows, known = coarse->motion.rows >= rows;
	double part = 1.0/3.0;

	run->x = calloc((size_t)rows*PROBES + 1, sizeof *run->x);
	run->off = known ? calloc((size_t)rows*PROBES + 1, sizeof *run->off) : NULL;
	if (!run->x || (known && !run->off))
		return hawser__no_memory(report, "net");
	for (int i = 0; known && hawser_net_scheme(i); i++)
		if (strcmp(hawser_net_scheme(i)->name, fine->motion.scheme) == 0)
			part = hawser_net_scheme(i)->order == 1 ? 1.0 : part;
	for (int i = 0; i < rows; i++)
		for (int p = 0; p < PROBES; p++)
			for (int k = 0; k < 3; k++) {
				double x = moved(fine, i, p, k);

				run->x[i*PROBES + p][k] = x;
				if (known)
					run->off[i*PROBES + p][k] = part*(x - moved(coarse, i, p, k));
			}
	run->slack_S = isnan(fine->motion.slack_at) ? NAN
		: fine->motion.slack_part*fine->net.cable[fine->motion.slack_cable].value;
	for (int c = 0; c < fine->motion.slack_cable; c++)
		run->slack_S += fine->net.cable[c].value;
	run->rows = rows;
	run->interrupted = fine->motion.interrupted;
	run->elements = fine->elements;
	run->other = known ? coarse->elements : 0;
	run->seconds = fine->seconds;
	run->other_seconds = coarse->seconds;
	run->motion = fine->motion;
	fine->motion = (struct hawser_net_motion){.rows = 0};
	return HAWSER_OK;
}

enum hawser_status hawser_net_span_integrate(struct hawser_net_span_motion *run,
                                             const struct hawser_scene *scene,
                                             const struct hawser_statics *st,
                                             const struct hawser_net_span_motion_options *options,
                                             struct hawser_report *report)
{
	struct hawser_net_span_options mesh = options->mesh;
	struct hawser_net_motion_options motion = {
		.until = options->until, .every = options->every, .step = options->step,
		.tolerance = options->tolerance > 0.0 ? options->tolerance : tolerance,
		.scheme = options->scheme, .progress = options->progress};
	struct level fine = {.elements = 0}, coarse = {.elements = 0};
	enum hawser_status status;

	memset(run, 0, sizeof *run);
	hawser_net_span_settle(&mesh);
	if (!options->single && mesh.elements < 4)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "a motion needs 4 elements at least, "
		                    "not %d: its error is estimated by a mesh with half of them",
		                    mesh.elements);
	if (motion.step == 0.0)
		motion.step = default_step(scene, st, mesh.Omega);
	run->step = fmax(motion.step, 0.0);
	status = run_level(&fine, scene, st, &mesh, 0, &motion, report);
	motion.step *= motion.step > 0.0 ? 2.0 : 1.0;
	motion.tolerance *= 8.0;
	if (!status && !options->single && !fine.motion.interrupted)
		status = run_level(&coarse, scene, st, &mesh, 1, &motion, report);
	if (!status)
		status = fill(run, &fine, &coarse, report);
	clear(&fine);
	clear(&coarse);
	if (status)
		hawser_net_span_motion_clear(run);
	return status;
}
