/* net/plan/plan-cost.c - time and memory of statics, modes and motion of a net.
 *
 * Statics are solved, and modes if they should take little; the time of what is not done follows from
 * one factorization and one solution, which are measured, and the number of iterations that such nets
 * took (bench/net-plan). Of the motion the beginning is computed; what is left follows from its growth.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "net/motion/motion.h"
#include "net/plan/plan.h"
#include "net/statics/solve.h"

/* Iterations of statics with lengths (3 to 24 on the meshes of bench/net-plan), of the catenaries
 * before (7 to 112), of form finding with its repetitions, and of modes (8 to 21). */
static const double ITERATIONS = 10.0, CATENARY_ITERATIONS = 40.0, FORM_ITERATIONS = 60.0,
                    MODE_ITERATIONS = 12.0;
/* With obstacles, and in each step of contact.path. */
static const double TOUCH_ITERATIONS = 60.0, STEP_ITERATIONS = 6.0;
/* s, for each element and iteration: assembly; for each cable and iteration: catenaries; for each
 * unknown and vector: products; for an operation. Measured at 2.6 GHz. */
static const double ASSEMBLY = 3e-7, CATENARY = 5e-6, PRODUCT = 1.5e-8, OPERATION = 5e-10;
/* Bytes for each element: mesh, work space, results. */
enum { MESH_BYTES = 560 };

static struct hawser_net_plan_job none(const char *name, const char *method, const char *why)
{
	struct hawser_net_plan_job job = {.name = name, .method = method, .count = NAN, .counted = "",
	                                  .seconds = NAN, .least = NAN, .most = NAN, .bytes = NAN};

	snprintf(job.why, sizeof job.why, "%s", why);
	return job;
}

static void ran(struct hawser_net_plan_job *job, double seconds)
{
	job->basis = HAWSER_NET_BASIS_RUN;
	job->seconds = seconds;
	job->least = 0.7*seconds;
	job->most = 1.5*seconds;
}

static void estimated(struct hawser_net_plan_job *job, double seconds, double factor)
{
	job->basis = HAWSER_NET_BASIS_ESTIMATE;
	job->seconds = seconds;
	job->least = seconds/factor;
	job->most = seconds*factor;
}

/* 1 and the message, if this is a failure of the job and not of the plan. */
static int reported(struct hawser_net_plan_job *job, enum hawser_status status,
                    const struct hawser_report *report)
{
	if (status == HAWSER_OK || status == HAWSER_ERR_MEMORY || status == HAWSER_ERR_PROGRAM)
		return 0;
	job->basis = HAWSER_NET_BASIS_NONE;
	job->seconds = job->least = job->most = job->count = NAN;
	snprintf(job->why, sizeof job->why, "%.*s", (int)sizeof job->why - 1, report->message);
	return 1;
}

/* One factorization with the pattern of the stiffness. */
static enum hawser_status measure(struct hawser__net_planner *planner, struct hawser_report *report)
{
	static const double across[3];
	const struct hawser__mesh *mesh = &planner->mesh;
	struct hawser__sparse *sparse;
	double *x = calloc((size_t)mesh->unknowns + 1, sizeof *x);
	double start = hawser__processor_seconds(), then;
	int definite = 0;
	enum hawser_status status = hawser__sparse_open(&sparse, mesh, report);

	if (!status && !x)
		status = hawser__no_memory(report, "net");
	planner->analysed = (then = hawser__processor_seconds()) - start;
	for (int e = 0; e < mesh->elements && !status; e++)
		hawser__sparse_add(sparse, e, 1.0, 0.0, across);
	if (!status)
		status = hawser__sparse_factor(sparse, &definite, report);
	planner->factored = (start = hawser__processor_seconds()) - then;
	if (!status && definite)
		status = hawser__sparse_solve(x, sparse, report);
	planner->solved = hawser__processor_seconds() - start;
	if (!status)
		planner->bytes = hawser__sparse_bytes(sparse) + MESH_BYTES*(double)mesh->elements;
	hawser__sparse_clear(sparse);
	free(x);
	return status;
}

static int all_lengths(const struct hawser_net *net)
{
	for (int c = 0; c < net->cables; c++)
		if (net->cable[c].given != HAWSER_NET_LENGTH0)
			return 0;
	return 1;
}

enum hawser_status hawser__plan_statics(struct hawser__net_planner *planner,
                                        struct hawser_report *report)
{
	const struct hawser_net *net = planner->net;
	struct hawser_net_plan_job *job = &planner->plan->job[0];
	int lengths = all_lengths(net), path = net->contact.history ? net->contact.path[0].points : 0;
	double seconds, start;
	enum hawser_status status = hawser__net_supported(&planner->mesh, net, &planner->report);

	*job = none("statics", "automatic", net->surfaces
	            ? "interior point, then Newton's method for positions, tensions and contacts" : lengths
	            ? "Newton's method with slack members, from exact catenaries or force densities"
	            : "form finding by force densities, then the mesh with the lengths found");
	job->unknowns = planner->mesh.unknowns;
	if (reported(job, status, &planner->report))
		return HAWSER_OK;
	status = status ? status : measure(planner, report);
	if (status)
		return status;
	job->counted = "iterations";
	job->count = net->surfaces ? TOUCH_ITERATIONS + STEP_ITERATIONS*path*net->contact.steps
		: lengths ? ITERATIONS : FORM_ITERATIONS;
	job->bytes = planner->bytes;
	seconds = 2.0*planner->analysed + job->count*(planner->factored + planner->solved +
	                                              ASSEMBLY*planner->mesh.elements) +
	          CATENARY_ITERATIONS*CATENARY*planner->mesh.cables;
	estimated(job, seconds, 6.0);
	if (seconds > 10.0*planner->options.seconds)
		return HAWSER_OK;
	start = hawser__processor_seconds();
	status = hawser_net_solve(&planner->st, net, NULL, &planner->report);
	seconds = hawser__processor_seconds() - start;
	if (reported(job, status, &planner->report))
		return HAWSER_OK;
	if (status)
		return hawser__no_memory(report, "net");
	job->count = planner->st.iterations;
	ran(job, seconds);
	return HAWSER_OK;
}

enum hawser_status hawser__plan_modes(struct hawser__net_planner *planner, struct hawser_report *report)
{
	struct hawser_net_plan *plan = planner->plan;
	struct hawser_net_plan_job *job = &plan->job[1];
	double n = planner->mesh.unknowns, modes = fmin(planner->options.modes, n);
	double vectors = fmin(fmax(2.0*modes, modes + 8.0), n), seconds, start;
	enum hawser_status status;

	*job = none("modes", "subspace iteration", "thousands of unknowns, few modes, one factorization");
	job->unknowns = (int)n;
	if (plan->job[0].basis == HAWSER_NET_BASIS_NONE) {
		*job = none("modes", "subspace iteration", "there is no equilibrium");
		return HAWSER_OK;
	}
	seconds = plan->job[0].seconds + planner->analysed + planner->factored +
	          MODE_ITERATIONS*vectors*(planner->solved + n*(PRODUCT + 3.0*OPERATION*vectors));
	job->count = MODE_ITERATIONS;
	job->counted = "iterations";
	job->bytes = plan->job[0].bytes + 32.0*n*vectors + 24.0*modes*planner->mesh.nodes;
	estimated(job, seconds, 3.0);
	if (!planner->st.x || seconds > planner->options.seconds)
		return HAWSER_OK;
	start = hawser__processor_seconds();
	status = hawser_net_modes_solve(&planner->modes, planner->net, (int)modes, &planner->report);
	seconds = hawser__processor_seconds() - start;
	if (reported(job, status, &planner->report))
		return HAWSER_OK;
	if (status)
		return hawser__no_memory(report, "net");
	job->count = planner->modes.iterations;
	for (int j = 0; j < planner->modes.n && !(plan->first > 0.0); j++)
		if (planner->modes.omega[j] > planner->modes.corners[j]) /* a belt that circulates is none */
			plan->first = planner->modes.omega[j];
	ran(job, seconds);
	return HAWSER_OK;
}

/* Clock of the beginning of a motion, s: of statics, of the first half of the steps, and of all; the
 * parts of the motion that were reached. */
struct trial {
	double start, limit, setup, half, now, at_half, part;
};

static int watch(void *data, const struct hawser_progress_state *state)
{
	struct trial *trial = data;

	trial->now = hawser__processor_seconds() - trial->start;
	trial->part = state->fraction;
	if (trial->setup == 0.0)
		trial->setup = trial->now;
	if (trial->now - trial->setup < 0.5*trial->limit) {
		trial->half = trial->now;
		trial->at_half = trial->part;
	}
	return trial->now - trial->setup > trial->limit;
}

static int moves(const struct hawser__net_planner *planner)
{
	const struct hawser_net *net = planner->net;
	int tables = 0;

	for (int i = 0; i < net->nodes; i++)
		tables |= net->node[i].table != NULL;
	return tables || planner->plan->fastest > 0.0 || net->dynamics.releases > 0 || net->dynamics.from ||
	       net->water.waves.count || net->failures || net->winches || planner->options.motion.initial;
}

/* From the beginning, which ended at trial->part of the motion, to the whole: time grows as a power of
 * the part, below 1 if vibrations of the start decay, and linearly from some times that part on. */
static void extend(struct hawser__net_planner *planner, const struct trial *trial, double seconds)
{
	static const double LINEAR = 30.0, LEAST = 0.7, MOST = 1.2;
	struct hawser_net_plan_job *job = &planner->plan->job[2];
	const struct hawser_net_motion *motion = &planner->motion;
	double times = 1.0/fmax(trial->part, 1e-9), first = fmin(times, LINEAR), power = 1.0, all;

	if (trial->at_half > 0.0 && trial->part > trial->at_half && trial->half > trial->setup)
		power = log((trial->now - trial->setup)/(trial->half - trial->setup))/
		        log(trial->part/trial->at_half);
	power = fmin(fmax(power, LEAST), MOST);
	all = pow(first, power)*(1.0 + power*(times/first - 1.0));
	job->count = (double)motion->steps*(motion->interrupted ? all : 1.0);
	if (motion->interrupted)
		estimated(job, trial->setup + all*(trial->now - trial->setup), trial->part > 0.02 ? 2.5 : 4.0);
	else
		ran(job, seconds);
	planner->plan->step = job->count > 0.0 ? planner->plan->until/job->count : NAN;
}

static void solver(struct hawser__net_planner *planner)
{
	struct hawser_net_plan_job *job = &planner->plan->job[2];
	const struct hawser__motion_scheme *scheme;
	const char *name = planner->options.motion.scheme ? planner->options.motion.scheme
	                                                  : planner->net->dynamics.scheme;

	for (int i = 0; (scheme = hawser__motion_scheme(i)); i++)
		if (!*name || strcmp(scheme->shown.name, name) == 0)
			break;
	if (scheme)
		job->method = scheme->shown.name;
}

enum hawser_status hawser__plan_motion(struct hawser__net_planner *planner,
                                       struct hawser_report *report)
{
	struct hawser_net_plan *plan = planner->plan;
	struct hawser_net_plan_job *job = &plan->job[2];
	struct trial trial = {.start = hawser__processor_seconds(), .limit = planner->options.seconds};
	struct hawser_net_motion_options options = planner->options.motion;
	int chain = 0;
	enum hawser_status status;

	*job = none("integrate", "", "nothing sets the net in motion: no harmonic load, moving support, "
	            "wave, failure, winch, release or first state; it stays in equilibrium");
	solver(planner);
	job->unknowns = plan->unknowns;
	if (plan->job[0].basis == HAWSER_NET_BASIS_NONE) {
		snprintf(job->why, sizeof job->why, "there is no equilibrium to begin from");
		return HAWSER_OK;
	}
	if (!moves(planner))
		return HAWSER_OK;
	if (!planner->st.x) {
		snprintf(job->why, sizeof job->why, "not looked at: the statics take too long for a plan "
		         "(--limit)");
		return HAWSER_OK;
	}
	status = hawser__blocks_bytes(&job->bytes, &chain, &planner->mesh, report);
	if (status)
		return status;
	options.progress.function = watch;
	options.progress.data = &trial;
	options.frame = NULL;
	options.check = 0;
	status = hawser_net_integrate(&planner->motion, planner->net, &options, &planner->report);
	if (reported(job, status, &planner->report))
		return HAWSER_OK;
	if (status)
		return hawser__no_memory(report, "net");
	job->unknowns = planner->motion.unknowns;
	job->counted = "steps";
	job->bytes = fmax(plan->job[0].bytes,
	                  job->bytes) + 8.0*(10.0 + 4.0*options.probes)*plan->until/plan->every;
	snprintf(job->why, sizeof job->why, "%s; %s", chain
	         ? "elimination along the chains of elements" : "sparse LU factors (KLU)",
	         plan->until > planner->motion.reached ? "the beginning was computed" : "all was computed");
	extend(planner, &trial, hawser__processor_seconds() - trial.start);
	return HAWSER_OK;
}
