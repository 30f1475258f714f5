/* net/motion/integrate.c - hawser__net_integrate: the beginning of a motion, its rows, its results.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "net/body.h"
#include "net/motion/motion-contact.h"
#include "net/motion/motion-events.h"
#include "net/motion/motion-ode.h"
#include "net/statics/solve.h"
#include "net/touch/touch.h"

enum { ROWS = 10000000, DEFAULT_ROWS = 200 };
/* s, between two questions whether to go on: not felt by the user, nor by the computation. */
static const double ASKED_EVERY = 0.05;
/* Of the time in which an axial wave passes an element: the first step. */
static const double BEGINS = 0.1;
const double hawser__motion_tolerance = 1e-7;

struct run {
	const struct hawser_net *net, *given; /* with its bodies where they belong; as it was given */
	struct hawser_net seated;
	const struct hawser_net_motion_options *options;
	struct hawser__mesh mesh;
	struct hawser__motion motion;
	double *state;           /* from a file, or NULL */
	double h, step, every, tolerance; /* step 0: by the error */
	double (*x)[3], *T;      /* [nodes], [elements] of a row */
	struct hawser__probes probes;
	struct hawser__net_touched touched; /* of a row, with obstacles */
	struct hawser__support_table *table; /* [tables], until the motion owns them */
	int tables;
	double began, asked;     /* s, clock */
	int still[3];            /* 1: nothing moves along this axis */
	int settled;             /* 0: no equilibrium of the motion on soft beds was found */
	double from;             /* s, of the motion, at the beginning */
	int rows;                /* so far */
};

static void clear(struct run *run)
{
	for (int i = 0; i < run->tables; i++)
		hawser__support_clear(&run->table[i]);
	free(run->table);
	free(run->state);
	free(run->x);
	free(run->T);
	hawser__probes_clear(&run->probes);
	free(run->touched.r_N); /* with r_T */
	free(run->touched.state);
	hawser__motion_clear(&run->motion);
	hawser__mesh_clear(&run->mesh);
	hawser__bodies_unseat(&run->seated, run->given);
}

/* --- the beginning --- */

/* The reference: the equilibrium or, if that was another net's, the one of the state. */
static int place(struct run *run)
{
	struct hawser__mesh *mesh = &run->mesh;
	int same = 1;

	for (int i = 0; i < mesh->nodes && run->state; i++) {
		const double *x = hawser__motion_place(run->state, i);

		/* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison,cert-*): are they the same bytes */
		same = same && memcmp(mesh->q[i], x, sizeof *mesh->q) == 0;
		memcpy(mesh->q[i], x, sizeof *mesh->q);
	}
	return same;
}

/* The longest step by which an axial wave stays within an element, of those that have mass. */
static double transit(const struct run *run)
{
	const struct hawser__mesh *mesh = &run->mesh;
	double least = run->every;

	for (int e = 0; e < mesh->elements; e++)
		if (mesh->rho[e] > 0.0)
			least = fmin(least, mesh->length0[e]*sqrt(mesh->rho[e]/mesh->EA[e]));
	return least;
}

/* The longest cable; of a net without one, its extent. */
static double longest(const struct hawser__mesh *mesh, const struct hawser_net *net)
{
	double most = 0.0;

	for (int c = 0; c < mesh->cables; c++) {
		double sum = 0.0;

		for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++)
			sum += mesh->length0[e];
		most = fmax(most, sum);
	}
	return most > 0.0 ? most : hawser__net_extent(net);
}

/* What nothing moves is not built. */
static void flatten(struct run *run)
{
	double at;

	for (int k = 0; k < 3; k++) {
		run->still[k] = hawser__net_still(&at, run->net, k, run->table, run->tables) &&
		                !(run->state && hawser__motion_moves(run->state, run->mesh.nodes, k));
		if (run->still[k])
			hawser__mesh_flatten(&run->mesh, k, at);
		else
			hawser__absorbers_release(&run->mesh, 1U << k);
	}
}

static enum hawser_status start(struct run *run, struct hawser_report *report)
{
	static const unsigned char none[3];
	const struct hawser_net *net = run->net;
	const struct hawser_net_motion_options *options = run->options;
	const char *scheme = options->scheme ? options->scheme : net->dynamics.scheme;
	double rho = options->rho_inf != 0.0 ? fmax(options->rho_inf, 0.0) : net->dynamics.rho_inf;
	const char *initial = options->initial ? options->initial : net->dynamics.from;
	unsigned char *loose = calloc((size_t)(run->mesh.nodes + net->failures) + 1, 1);
	enum hawser_status status = HAWSER_OK;

	if (!loose)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < net->dynamics.releases; i++) {
		loose[net->dynamics.release[i]] = 1;
		if (!run->mesh.rigid[net->dynamics.release[i]])
			hawser__mesh_hold(&run->mesh, net->dynamics.release[i], none);
	}
	hawser__events_spare(&run->mesh, net);
	if (net->surfaces && net->dynamics.releases)
		status = hawser__touch_again(&run->mesh, net, report);
	if (!status && net->dynamics.releases)
		status = hawser__bodies_stand(&run->mesh, net, loose, report);
	hawser__touch_measure(&run->mesh);
	if (initial && !status)
		status = hawser__motion_read(&run->state, initial, &run->mesh, report);
	if (!status) {
		int same = place(run);

		flatten(run);
		status = hawser__motion_open(&run->motion, &run->mesh, scheme, rho, same, loose, report);
	}
	if (!status)
		status = hawser__bodies_start(&run->motion, net, loose, run->still, report);
	free(loose);
	if (!status && run->motion.scheme->rule != hawser__motion_scheme(0)->rule)
		status = hawser__mesh_lawless(net, "another scheme than energy", report);
	if (!status && ((run->mesh.touches || run->mesh.water || net->bodies) ?
	                run->motion.scheme->rule != hawser__motion_scheme(0)->rule :
	                run->motion.attached && run->motion.scheme->advance))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the scheme %s does not know "
		                      "%s: take energy, or leave dynamics.scheme and --method out",
		                      net->name ? net->name : "the net", run->motion.scheme->shown.name,
		                      run->mesh.touches ? "obstacles" : net->winds ? "wind"
		                      : run->mesh.water ? "water" : net->bodies ? "rigid bodies"
		                      : "springs, dampers and absorbers of nodes");
	if (!status && run->mesh.touches)
		status = hawser__contact_open(&run->motion, net->contact.restitution, report);
	if (!status)
		status = hawser__events_open(&run->motion, net, run->still, initial, report);
	if (!status)
		status = hawser__ode_massive(&run->mesh, net, report);
	if (status)
		return status;
	run->motion.table = run->table;
	run->motion.tables = run->tables;
	run->table = NULL;
	run->tables = 0;
	run->h = BEGINS*transit(run);
	if (run->state)
		hawser__motion_restore(&run->motion, &run->h, run->state);
	if (run->state && run->motion.t >= run->options->until)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s is the state at %g s, and the "
		                    "run is to end at %g s: the end counts from the beginning of the first "
		                    "run", initial, run->motion.t, run->options->until);
	if (!run->state)
		status = hawser__motion_begin(&run->motion, report);
	return status;
}

/* The equilibrium; with friction as the way of the supports has left it. */
static enum hawser_status still(struct run *run, struct hawser_report *report)
{
	struct hawser__equilibrium found;
	struct hawser__mesh_options settings = {0};
	enum hawser_status status;
	double *T;

	run->mesh.surfaces_rest = run->net->dynamics.surfaces_start;
	if (!run->net->contact.history)
		status = hawser__mesh_form(&run->mesh, NULL, &found, run->net, &settings, report);
	else if (!(T = calloc((size_t)run->mesh.elements, sizeof *T)))
		status = hawser__no_memory(report, "net");
	else {
		status = hawser__net_history(&run->mesh, T, &found, run->net, &settings, report);
		free(T);
	}
	if (!status)
		status = hawser__bodies_land(&run->mesh, run->net, report);
	run->mesh.surfaces_rest = 0;
	if (!status)
		status = hawser__motion_settle(&run->mesh, &run->settled, report);
	return status ? status : hawser__touch_sides(&run->mesh, run->net, report);
}

/* What only models have. */
static enum hawser_status check(const struct hawser_net *net, struct hawser_report *report)
{
	const char *key = net->ratio > 0.0 ? "damping.ratio"
	                  : net->mass_rate > 0.0 ? "damping.rayleigh" : NULL;

	for (int i = 0; i < net->loads + net->motions && !key; i++)
		key = (i < net->loads ? net->load[i] : net->motion[i - net->loads]).multiple > 0
		      ? "multiple in place of Omega" : NULL;
	return !key ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: %s is for models, as of frf: the "
	                      "motion of the mesh has damping.alpha (2 w z times the mass per length, for "
	                      "a ratio z at the frequency w), damping.axial and dampers, and loads with a "
	                      "frequency", net->name, key);
}

static enum hawser_status prepare(struct run *run, struct hawser_report *report)
{
	const struct hawser_net_motion_options *options = run->options;
	enum hawser_status status = check(run->net, report);

	if (status)
		return status;
	if (!(options->until > 0.0) || !isfinite(options->until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "the end of the motion must be a "
		                    "positive time, not %g s", options->until);
	run->every = options->every > 0.0 ? options->every : options->until/DEFAULT_ROWS;
	if (options->until/run->every > ROWS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%.3g rows are more than %d: choose "
		                    "a longer time between them", options->until/run->every, ROWS);
	run->step = options->step != 0.0 ? fmax(options->step, 0.0) : run->net->dynamics.step;
	status = hawser__supports_read(&run->table, &run->tables, run->given, run->options->until, report);
	if (!status)
		status = hawser__motion_seat(&run->seated, run->given, run->table, run->tables, report);
	run->net = &run->seated;
	if (!status)
		status = hawser__mesh_build(&run->mesh, run->net, report);
	if (!status)
		status = hawser__net_supported(&run->mesh, run->net, report);
	if (status)
		return status;
	hawser__supports_begin(run->mesh.q, run->net, run->table, run->tables);
	status = still(run, report);
	if (!status)
		status = start(run, report);
	if (status)
		return status;
	run->tolerance = (options->tolerance > 0.0 ? options->tolerance : hawser__motion_tolerance)*
	                 longest(&run->mesh, run->net);
	run->x = calloc((size_t)run->mesh.nodes, sizeof *run->x);
	run->T = calloc((size_t)run->mesh.elements, sizeof *run->T);
	if (!run->x || !run->T)
		return hawser__no_memory(report, "net");
	if (run->motion.contact)
		status = hawser__contact_room(&run->touched, run->mesh.nodes, report);
	return status ? status : hawser__probes_open(&run->probes, &run->motion, run->net,
	                                             (const double (*)[3])run->x, run->T, report);
}

/* --- rows --- */

/* Positions and tensions as they are, into the next row; *stop: what the caller's function returns. */
static enum hawser_status row(int *stop, struct hawser_net_motion *to, struct run *run,
                              struct hawser_report *report)
{
	const struct hawser__motion *motion = &run->motion;
	const struct hawser_net_motion_options *options = run->options;
	struct hawser_net_frame frame = {.t = motion->t, .row = to->rows, .nodes = motion->nodes,
	                                 .elements = motion->elements, .x = (const double (*)[3])run->x,
	                                 .end = (const int (*)[2])run->mesh.end, .T = run->T};
	enum hawser_status status;
	int i = to->rows++;

	for (int n = 0; n < motion->nodes; n++)
		for (int k = 0; k < 3; k++)
			run->x[n][k] = motion->reference[n][k] + motion->u[n][k];
	hawser__events_places(run->x, motion);
	to->time[i] = motion->t;
	to->kinetic[i] = motion->energy.kinetic;
	to->potential[i] = motion->energy.potential;
	to->work[i] = motion->energy.work;
	to->dissipated[i] = motion->energy.dissipated;
	to->slack[i] = hawser__motion_tensions(run->T, motion);
	if (motion->contact) {
		hawser__contact_row(to, i, &run->touched, &run->motion);
		frame.state = run->touched.state;
		frame.r_N = run->touched.r_N;
		frame.r_T = run->touched.r_T;
	}
	status = run->net->bodies ? hawser__bodies_outside(run->net, (const double (*)[3])run->x, motion->t,
	                                                   report) : HAWSER_OK;
	if (!status)
		status = hawser__contact_beyond(motion, report);
	if (!status)
		status = hawser__touch_passes(&run->mesh, (const double (*)[3])run->x, motion->t, report);
	if (!status && options->probes)
		status = hawser__probes_state(&run->probes, report);
	for (int p = 0; p < options->probes && !status; p++) {
		int at = i*options->probes + p;

		hawser__probe(to->x[at], to->v[at], &to->T[at], to->pull[at], &run->probes,
		              &options->probe[p]);
	}
	*stop = !status && options->frame && options->frame(options->data, &frame) != 0;
	return status;
}

/* Whether the caller ends the run: asked after each row, and within rows after some time. */
static int ask(const struct run *run)
{
	const struct hawser_net_motion_options *options = run->options;
	struct hawser_progress_state state = hawser__progress_state("motion", "rows", run->rows,
	                                                            run->began);

	state.expected = (long)((options->until - run->from)/run->every) + 1;
	state.fraction = (run->motion.t - run->from)/fmax(options->until - run->from, DBL_MIN);
	return hawser__told_to_stop(&options->progress, &state);
}

static int stop(void *data)
{
	struct run *run = data;
	double now = hawser__wall_seconds();

	if (now - run->asked < ASKED_EVERY)
		return 0;
	run->asked = now;
	return ask(run);
}

/* Steps of one length; what is left of an interval in which a run was interrupted has the same ones. */
static enum hawser_status march(struct run *run, double end, struct hawser_report *report)
{
	double h = run->every/ceil(run->every/run->step*(1.0 - 1e-12)), left = end - run->motion.t;
	double n = round(left/h);
	enum hawser_status status = HAWSER_OK;

	if (fabs(left/h - n) > 1e-6) { /* a state of a run with other rows */
		n = ceil(left/h);
		h = left/n;
	}
	for (long i = (long)n; i > 0 && !status && !hawser__events_due(&run->motion); i--) {
		if (hawser__motion_asked(&run->motion))
			return HAWSER_OK;
		status = hawser__motion_step(&run->motion, h, report);
	}
	return status;
}

static enum hawser_status advance_to(struct run *run, double end, struct hawser_report *report)
{
	enum hawser_status status;

	if (run->motion.scheme->advance) {
		status = run->motion.scheme->advance(&run->motion, end, run->tolerance, run->step, report);
	} else if (run->step <= 0.0) {
		status = hawser__motion_adapt(&run->motion, &run->h, end, run->tolerance, report);
	} else {
		status = march(run, end, report);
	}
	if (!status && !run->motion.stopped && !hawser__events_due(&run->motion))
		run->motion.t = end;
	return status;
}

/* By the times and tensions at which cables part. */
static enum hawser_status advance(struct run *run, double end, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	while (!status && run->motion.t < end && !run->motion.stopped) {
		status = advance_to(run, hawser__events_next(&run->motion, end), report);
		if (!status && !run->motion.stopped && run->motion.events)
			status = hawser__events_part(&run->motion, report);
		if (run->motion.past_h <= 0.0) /* a cable has parted: as at the beginning */
			run->h = fmin(run->h, BEGINS*transit(run));
	}
	return status;
}

static enum hawser_status rows(struct hawser_net_motion *to, struct run *run,
                               struct hawser_report *report)
{
	double first = floor(run->motion.t/run->every*(1.0 + 1e-12)), last = run->options->until/run->every;
	enum hawser_status status = hawser__motion_rows(to, (size_t)fmax(last - first, 0.0) + 3,
	                                     (size_t)run->options->probes, report);

	to->probes = run->options->probes;
	to->unbalanced = !run->settled && !run->state;
	if (status)
		return status;
	run->began = hawser__wall_seconds(); /* asked at once: the caller learns that steps begin */
	run->from = run->motion.t;
	run->motion.stop = hawser__is_watched(&run->options->progress) ? stop : NULL;
	run->motion.data = run;
	status = row(&to->interrupted, to, run, report);
	for (double i = first + 1.0; i <= last*(1.0 + 1e-12) && !status && !to->interrupted; i++) {
		status = advance(run, i*run->every, report);
		to->interrupted = run->motion.stopped;
		if (status || to->interrupted)
			break;
		status = row(&to->interrupted, to, run, report);
		run->rows = to->rows;
		if (!status && ask(run))
			to->interrupted = 1;
	}
	to->reached = run->motion.t;
	return status;
}

static void slackens(struct hawser_net_motion *to, const struct run *run)
{
	const struct hawser__motion *motion = &run->motion;
	const struct hawser__mesh *mesh = &run->mesh;
	int c, first;

	to->least = motion->least;
	to->least_at = motion->least_at;
	to->slack_at = motion->slack_at;
	if (isnan(motion->slack_at)) /* of a body alone there are no cables */
		return;
	c = mesh->cable[motion->slack_element];
	first = mesh->first[c];
	to->slack_cable = c;
	to->slack_part = (motion->slack_element - first + 0.5)/(mesh->first[c + 1] - first);
}

enum hawser_status hawser__net_integrate(struct hawser_net_motion *to, const struct hawser_net *net,
                                         const struct hawser_net_motion_options *options,
                                         struct hawser_report *report)
{
	struct run run = {.net = net, .given = net, .options = options};
	const struct hawser__motion *motion = &run.motion;
	enum hawser_status status;

	memset(to, 0, sizeof *to);
	status = prepare(&run, report);
	if (!status)
		status = rows(to, &run, report);
	if (!status) {
		to->states = hawser__motion_states(motion);
		to->state = calloc((size_t)to->states, sizeof *to->state);
		if (to->state)
			hawser__motion_save(to->state, motion, run.h);
		else
			status = hawser__no_memory(report, "net");
		slackens(to, &run);
		if (!status && motion->contact)
			status = hawser__contact_result(to, net, &run.motion, report);
		if (!status && motion->events)
			status = hawser__events_result(to, motion, report);
		to->closure = motion->closure/fmax(fmax(motion->most_energy, motion->least_energy), DBL_MIN);
		to->scheme = motion->scheme->shown.name;
		to->error = motion->drift;
		to->unknowns = run.mesh.unknowns;
		memcpy(to->still, run.still, sizeof to->still);
		to->steps = motion->steps;
		to->iterations = motion->iterations;
		to->splits = motion->splits;
		to->rejected = motion->rejected;
		to->switches = motion->switches;
	}
	clear(&run);
	if (status)
		hawser_net_motion_clear(to);
	return status;
}
