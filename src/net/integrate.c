/* net/integrate.c - hawser_net_integrate: the beginning of a motion, its rows, its results.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "net/motion.h"

enum { ROWS = 10000000, DEFAULT_ROWS = 200 };
static const double default_tolerance = 1e-7;

struct run {
	const struct hawser_net *net;
	const struct hawser_net_motion_options *options;
	struct hawser__mesh mesh;
	struct hawser__motion motion;
	double *state;           /* from a file, or NULL */
	double h, step, every, tolerance; /* step 0: by the error */
	double (*x)[3], *T;      /* [nodes], [elements] of a row */
	struct hawser__support_table *table; /* [tables], until the motion owns them */
	int tables;
};

void hawser_net_motion_clear(struct hawser_net_motion *motion)
{
	if (!motion)
		return;
	free(motion->time);
	free(motion->x);
	free(motion->T);
	free(motion->kinetic);
	free(motion->potential);
	free(motion->work);
	free(motion->dissipated);
	free(motion->slack);
	free(motion->state);
	memset(motion, 0, sizeof *motion);
}

static void clear(struct run *run)
{
	for (int i = 0; i < run->tables; i++)
		hawser__support_clear(&run->table[i]);
	free(run->table);
	free(run->state);
	free(run->x);
	free(run->T);
	hawser__motion_clear(&run->motion);
	hawser__mesh_clear(&run->mesh);
}

/* --- the beginning --- */

static enum hawser_status tables(struct run *run, struct hawser_report *report)
{
	const struct hawser_net *net = run->net;
	enum hawser_status status = HAWSER_OK;

	run->table = calloc((size_t)net->nodes + 1, sizeof *run->table);
	if (!run->table)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < net->nodes && !status; i++) {
		struct hawser__support_table *table = &run->table[run->tables];

		if (!net->node[i].table)
			continue;
		status = hawser__support_read(table, net->node[i].table, report);
		if (status)
			break;
		table->node = i;
		run->tables++;
		if (table->t[0] > 0.0 || table->t[table->rows - 1] < run->options->until)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the motion of node %s is "
			                    "given from %g s to %g s, and the run is from 0 to %g s: make it end "
			                    "earlier, or the table longer", net->node[i].table,
			                    net->node[i].name, table->t[0], table->t[table->rows - 1],
			                    run->options->until);
	}
	return status;
}

/* Supports where they are at t = 0. */
static void displace(struct run *run)
{
	struct hawser__mesh *mesh = &run->mesh;
	double rate[3];

	for (int i = 0; i < mesh->motions; i++)
		for (int k = 0; k < 3; k++)
			mesh->q[mesh->motion[i].node][k] += mesh->motion[i].value[k]*cos(mesh->motion[i].phase);
	for (int i = 0; i < run->tables; i++) {
		struct hawser__support_table *table = &run->table[i];

		hawser__support_at(table->from, rate, table, 0.0);
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[table->node][k] < 0)
				mesh->q[table->node][k] += table->from[k];
	}
}

/* The reference: the equilibrium or, if that was another net's, the one of the state. */
static int place(struct run *run)
{
	struct hawser__mesh *mesh = &run->mesh;
	int same = 1;

	for (int i = 0; i < mesh->nodes && run->state; i++) {
		const double *x = hawser__motion_place(run->state, i);

		same = same && memcmp(mesh->q[i], x, sizeof *mesh->q) == 0;
		memcpy(mesh->q[i], x, sizeof *mesh->q);
	}
	return same;
}

/* The longest step by which an axial wave stays within an element. */
static double transit(const struct hawser__mesh *mesh)
{
	double least = INFINITY;

	for (int e = 0; e < mesh->elements; e++)
		least = fmin(least, mesh->length0[e]*sqrt(mesh->rho[e]/mesh->EA[e]));
	return least;
}

static double longest(const struct hawser__mesh *mesh)
{
	double most = 0.0;

	for (int c = 0; c < mesh->cables; c++) {
		double sum = 0.0;

		for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++)
			sum += mesh->length0[e];
		most = fmax(most, sum);
	}
	return most;
}

/* M has no inverse where a node that moves has no mass. */
static enum hawser_status massive(const struct run *run, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &run->mesh;
	const struct hawser_net *net = run->net;
	unsigned char *heavy = calloc((size_t)mesh->nodes, 1);
	enum hawser_status status = heavy ? HAWSER_OK : hawser__no_memory(report, "net");

	for (int e = 0; e < mesh->elements && !status; e++)
		for (int end = 0; end < 2; end++)
			heavy[mesh->end[e][end]] |= mesh->rho[e] > 0.0;
	for (int c = 0; c < mesh->cables && !status; c++)
		if (net->cable[c].elements > 1 && net->cable[c].rho == 0.0)
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "the scheme cvode needs mass at "
			                      "each node, and cable %s has inner nodes without: give it rho, 1 "
			                      "element, or take the scheme energy", net->cable[c].name);
	for (int i = 0; i < net->nodes && !status; i++)
		for (int k = 0; k < 3 && !status; k++)
			if (mesh->unknown[i][k] >= 0 && !heavy[i] && mesh->mass[i] == 0.0)
				status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "the scheme cvode needs mass "
				                      "at each node, and node %s has none: give it one in `masses`, "
				                      "rho to a cable there, or take the scheme energy",
				                      net->node[i].name);
	free(heavy);
	return status;
}

static enum hawser_status start(struct run *run, struct hawser_report *report)
{
	static const unsigned char none[3];
	const struct hawser_net *net = run->net;
	const struct hawser_net_motion_options *options = run->options;
	const char *scheme = options->scheme ? options->scheme : net->dynamics.scheme;
	double rho = options->rho_inf != 0.0 ? fmax(options->rho_inf, 0.0) : net->dynamics.rho_inf;
	const char *initial = options->initial ? options->initial : net->dynamics.from;
	unsigned char *loose = calloc((size_t)run->mesh.nodes + 1, 1);
	enum hawser_status status = HAWSER_OK;

	if (!loose)
		return hawser__no_memory(report, "net");
	if (initial)
		status = hawser__motion_read(&run->state, initial, &run->mesh, report);
	for (int i = 0; i < net->dynamics.releases; i++) {
		loose[net->dynamics.release[i]] = 1;
		hawser__mesh_hold(&run->mesh, net->dynamics.release[i], none);
	}
	if (!status) {
		int same = place(run);

		status = hawser__motion_open(&run->motion, &run->mesh, scheme, rho, same, loose, report);
	}
	free(loose);
	if (!status && run->motion.scheme->advance)
		status = massive(run, report);
	if (status)
		return status;
	run->motion.table = run->table;
	run->motion.tables = run->tables;
	run->table = NULL;
	run->tables = 0;
	run->h = 0.1*transit(&run->mesh);
	if (run->state)
		hawser__motion_restore(&run->motion, &run->h, run->state);
	else
		status = hawser__motion_begin(&run->motion, report);
	return status;
}

static enum hawser_status prepare(struct run *run, struct hawser_report *report)
{
	const struct hawser_net_motion_options *options = run->options;
	struct hawser__equilibrium found;
	struct hawser__mesh_options settings = {0};
	enum hawser_status status;

	if (!(options->until > 0.0) || !isfinite(options->until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "the end of the motion must be a "
		                    "positive time, not %g s", options->until);
	run->every = options->every > 0.0 ? options->every : options->until/DEFAULT_ROWS;
	if (options->until/run->every > ROWS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%.3g rows are more than %d: choose "
		                    "a longer time between them", options->until/run->every, ROWS);
	run->step = options->step != 0.0 ? fmax(options->step, 0.0) : run->net->dynamics.step;
	status = hawser__mesh_build(&run->mesh, run->net, report);
	if (!status)
		status = tables(run, report);
	if (status)
		return status;
	displace(run);
	status = hawser__mesh_form(&run->mesh, NULL, &found, run->net, &settings, report);
	if (!status)
		status = start(run, report);
	if (status)
		return status;
	run->tolerance = (options->tolerance > 0.0 ? options->tolerance : default_tolerance)*
	                 longest(&run->mesh);
	run->x = calloc((size_t)run->mesh.nodes, sizeof *run->x);
	run->T = calloc((size_t)run->mesh.elements, sizeof *run->T);
	return run->x && run->T ? HAWSER_OK : hawser__no_memory(report, "net");
}

/* --- rows --- */

static enum hawser_status allocate(struct hawser_net_motion *to, size_t rows, size_t probes,
                                   struct hawser_report *report)
{
	to->time = calloc(rows, sizeof *to->time);
	to->x = calloc(rows*probes + 1, sizeof *to->x);
	to->T = calloc(rows*probes + 1, sizeof *to->T);
	to->kinetic = calloc(rows, sizeof *to->kinetic);
	to->potential = calloc(rows, sizeof *to->potential);
	to->work = calloc(rows, sizeof *to->work);
	to->dissipated = calloc(rows, sizeof *to->dissipated);
	to->slack = calloc(rows, sizeof *to->slack);
	return to->time && to->x && to->T && to->kinetic && to->potential && to->work &&
	       to->dissipated && to->slack ? HAWSER_OK : hawser__no_memory(report, "net");
}

static void probe(double x[3], double *T, const struct run *run, const struct hawser_net_probe *at)
{
	const struct hawser__mesh *mesh = &run->mesh;
	int first = at->cable < 0 ? 0 : mesh->first[at->cable];
	int n = at->cable < 0 ? 0 : mesh->first[at->cable + 1] - first;
	double along = fmin(fmax(at->part, 0.0), 1.0)*n, part;
	int e = first + (int)fmin(along, fmax(n - 1, 0));

	*T = 0.0;
	if (n == 0) {
		memcpy(x, run->x[at->node], 3*sizeof *x);
		for (int i = 0; i < mesh->elements; i++)
			if (mesh->end[i][0] == at->node || mesh->end[i][1] == at->node)
				*T = fmax(*T, run->T[i]);
		return;
	}
	part = along - (e - first);
	*T = run->T[e];
	for (int k = 0; k < 3; k++)
		x[k] = (1.0 - part)*run->x[mesh->end[e][0]][k] + part*run->x[mesh->end[e][1]][k];
}

/* Positions and tensions as they are, into the next row; returns what the caller's function does. */
static int row(struct hawser_net_motion *to, struct run *run)
{
	const struct hawser__motion *motion = &run->motion;
	const struct hawser_net_motion_options *options = run->options;
	struct hawser_net_frame frame = {.t = motion->t, .row = to->rows, .nodes = motion->nodes,
	                                 .elements = motion->elements, .x = (const double (*)[3])run->x,
	                                 .end = (const int (*)[2])run->mesh.end, .T = run->T};
	int i = to->rows++;

	for (int n = 0; n < motion->nodes; n++)
		for (int k = 0; k < 3; k++)
			run->x[n][k] = motion->reference[n][k] + motion->u[n][k];
	to->time[i] = motion->t;
	to->kinetic[i] = motion->energy.kinetic;
	to->potential[i] = motion->energy.potential;
	to->work[i] = motion->energy.work;
	to->dissipated[i] = motion->energy.dissipated;
	to->slack[i] = hawser__motion_tensions(run->T, motion);
	for (int p = 0; p < options->probes; p++)
		probe(to->x[i*options->probes + p], &to->T[i*options->probes + p], run, &options->probe[p]);
	return options->frame ? options->frame(options->data, &frame) : 0;
}

static enum hawser_status advance(struct run *run, double end, struct hawser_report *report)
{
	double n;
	enum hawser_status status = HAWSER_OK;

	if (run->motion.scheme->advance) {
		status = run->motion.scheme->advance(&run->motion, end, run->tolerance, run->step, report);
	} else if (run->step <= 0.0) {
		status = hawser__motion_adapt(&run->motion, &run->h, end, run->tolerance, report);
	} else {
		n = ceil(run->every/run->step*(1.0 - 1e-12));
		for (double i = 0.0; i < n && !status; i++)
			status = hawser__motion_step(&run->motion, run->every/n, report);
	}
	run->motion.t = status ? run->motion.t : end;
	return status;
}

static enum hawser_status rows(struct hawser_net_motion *to, struct run *run,
                               struct hawser_report *report)
{
	double first = round(run->motion.t/run->every), last = run->options->until/run->every;
	double began = hawser__wall_seconds();
	enum hawser_status status = allocate(to, (size_t)fmax(last - first, 0.0) + 3,
	                                     (size_t)run->options->probes, report);

	to->probes = run->options->probes;
	to->start_kinetic = run->motion.energy.kinetic;
	if (status)
		return status;
	to->interrupted = row(to, run) != 0;
	for (double i = first + 1.0; i <= last*(1.0 + 1e-12) && !status && !to->interrupted; i++) {
		struct hawser_progress_state state;

		status = advance(run, i*run->every, report);
		if (status)
			break;
		to->interrupted = row(to, run) != 0;
		state = hawser__progress_state("motion", "rows", to->rows, began);
		state.expected = (long)(last - first) + 1;
		state.fraction = (i - first)/fmax(last - first, 1.0);
		if (hawser__told_to_stop(&run->options->progress, &state))
			to->interrupted = 1;
	}
	return status;
}

static enum hawser_status integrate(struct hawser_net_motion *to, const struct hawser_net *net,
                                    const struct hawser_net_motion_options *options,
                                    struct hawser_report *report)
{
	struct run run = {.net = net, .options = options};
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
		to->closure = motion->closure/fmax(fmax(motion->most_energy, motion->least_energy), DBL_MIN);
		to->scheme = motion->scheme->shown.name;
		to->error = motion->drift;
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

/* Largest distance of the probes of two motions, over the rows of both. */
static double distance(const struct hawser_net_motion *a, const struct hawser_net_motion *b)
{
	int rows = a->rows < b->rows ? a->rows : b->rows;
	double most = 0.0;

	for (int i = 0; i < rows*a->probes; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(a->x[i][k] - b->x[i][k]));
	return most;
}

/* The motion again with steps twice as long: the error of order p is the difference over 2^p - 1. CVODE
 * has no steps that could be doubled: with a hundred times its tolerance, the difference is a bound. */
static enum hawser_status check(struct hawser_net_motion *motion, const struct hawser_net *net,
                                const struct hawser_net_motion_options *options,
                                struct hawser_report *report)
{
	struct hawser_net_motion_options again = *options;
	struct hawser_net_motion other;
	const struct hawser__motion_scheme *scheme = NULL;
	double factor, step = options->step != 0.0 ? options->step : net->dynamics.step;
	int order;
	enum hawser_status status;

	for (int i = 0; !scheme || strcmp(scheme->shown.name, motion->scheme) != 0; i++)
		scheme = hawser__motion_scheme(i);
	order = scheme->shown.order;
	factor = scheme->advance ? 100.0 : pow(2.0, order + 1);
	again.tolerance = factor*(options->tolerance > 0.0 ? options->tolerance : default_tolerance);
	again.step = step > 0.0 ? 2.0*step : -1.0;
	again.frame = NULL;
	status = integrate(&other, net, &again, report);
	if (status)
		return status;
	motion->error = distance(motion, &other)/(scheme->advance ? 1.0 : pow(2.0, order) - 1.0);
	motion->checked = 1;
	motion->interrupted |= other.interrupted;
	hawser_net_motion_clear(&other);
	return HAWSER_OK;
}

enum hawser_status hawser_net_integrate(struct hawser_net_motion *to, const struct hawser_net *net,
                                        const struct hawser_net_motion_options *options,
                                        struct hawser_report *report)
{
	enum hawser_status status = integrate(to, net, options, report);

	if (!status && options->check && !to->interrupted)
		status = check(to, net, options, report);
	if (status)
		hawser_net_motion_clear(to);
	return status;
}
