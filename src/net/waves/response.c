/* net/waves/response.c - response of a net to waves, see hawser/net_waves.h.
 *
 * The iteration for C takes half of each step. C falls as the motion grows and the other way round,
 * so that whole steps alternate; where the drag governs the motion r, C(r) = k/C, half steps are
 * Newton's method for the root of k.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_waves.h>

#include "core/progress.h"
#include "core/hold.h"
#include "core/report.h"
#include "core/settle.h"
#include "core/vec3.h"
#include "net/waves/linear.h"
#include "water/water.h"

struct solver {
	struct hawser_net_waves_options options;
	struct hawser__linear_mesh linear;
	struct hawser_waves sea; /* of a sea: with frequencies in the middle of bins */
	double began;            /* s */
};

void hawser_net_waves_clear(struct hawser_net_waves *waves)
{
	if (!waves)
		return;
	hawser__hold_clear(&(struct hawser__hold){.last = waves->held});
	*waves = (struct hawser_net_waves){0};
}

/* C += the linear drag on a line by its parts across and along, or on a buoy. */
static void drag(double C[3][3], const struct hawser__wetted *wet, const double complex r[3],
                 double amplitude)
{
	const double *t = wet->along;
	int parts = hawser__dot(t, t) > 0.0 ? 2 : 1;

	memset(C, 0, 9*sizeof **C);
	for (int part = 0; part < parts; part++) {
		double P[3][3], D[3][3], mean[3], re[3] = {0.0}, im[3] = {0.0}, cov[3][3] = {{0.0}};

		for (int k = 0; k < 9; k++)
			P[k/3][k%3] = part ? t[k/3]*t[k%3] : (k%4 == 0 ? 1.0 : 0.0) - t[k/3]*t[k%3];
		for (int k = 0; k < 3; k++) {
			mean[k] = hawser__dot(P[k], wet->current);
			for (int j = 0; j < 3 && r; j++) {
				re[k] += P[k][j]*amplitude*creal(r[j]);
				im[k] += P[k][j]*amplitude*cimag(r[j]);
			}
			for (int j = 0; j < 27 && !r; j++)
				cov[k][j/9] += P[k][j/3%3]*wet->cov[j/3%3][j%3]*P[j%3][j/9];
		}
		if (r)
			hawser__drag_orbit(D, re, im, mean);
		else
			hawser__drag_random(D, (const double (*)[3])cov, mean);
		for (int k = 0; k < 81; k++) /* P D P */
			C[k/27][k/9%3] += wet->drag[part]*P[k/27][k/3%3]*D[k/3%3][k%3]*P[k%3][k/9%3];
	}
}

/* Half of the step of C at all places; the largest relative change. Regular waves: omega > 0. */
static double half_step(struct hawser__linear_mesh *linear, double omega, double amplitude)
{
	double change = 0.0, most = 0.0;

	for (int i = 0; i < linear->wets; i++) {
		struct hawser__wetted *wet = &linear->wet[i];
		double complex r[3];
		double C[3][3];

		if (omega > 0.0)
			hawser__linear_mesh_relative(r, linear, wet, omega);
		drag(C, wet, omega > 0.0 ? r : NULL, amplitude);
		for (int k = 0; k < 9; k++) {
			change = fmax(change, fabs(C[k/3][k%3] - wet->C[k/3][k%3]));
			most = fmax(most, fabs(C[k/3][k%3]));
			wet->C[k/3][k%3] = 0.5*(wet->C[k/3][k%3] + C[k/3][k%3]);
		}
	}
	return most > 0.0 ? change/most : 0.0;
}

/* 1 if the caller ends it. */
static int stopped(struct hawser_net_waves *waves, const struct solver *solver, int done)
{
	struct hawser_progress_state state = hawser__progress_state("response", "frequencies", done,
	                                                            solver->began);

	state.expected = waves->points;
	waves->interrupted = waves->interrupted ||
	                     hawser__told_to_stop(&solver->options.progress, &state);
	return waves->interrupted;
}

static enum hawser_status diverged(const struct solver *solver, double change,
                                   struct hawser_report *report)
{
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "net", solver->options.iterations, change,
	                       "%s: the linear drag changes by %.1e in iteration %d",
	                       solver->linear.net->name, change, solver->options.iterations);
}

/* The response to the regular waves of the scene's height at this frequency. */
static enum hawser_status regular(struct hawser_net_waves *waves, struct solver *solver, double omega,
                                  struct hawser_report *report)
{
	struct hawser__linear_mesh *linear = &solver->linear;
	enum hawser_status status = HAWSER_OK;
	double change = 1.0;
	int n = 0;

	hawser__linear_mesh_wave(linear, omega);
	for (; !status && change > solver->options.tolerance; n++) {
		if (n == solver->options.iterations)
			return diverged(solver, change, report);
		change = half_step(linear, omega, 0.5*waves->height);
		status = hawser__linear_mesh_solve(linear, omega, report);
	}
	waves->iterations = n > waves->iterations ? n : waves->iterations;
	waves->change = fmax(waves->change, change);
	return status;
}

static double complex tension(const struct hawser__linear_mesh *linear, int cable, int end,
                              double omega)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	int e = end ? mesh->first[cable + 1] - 1 : mesh->first[cable];
	double complex stretch = 0.0;
	double d[3];

	hawser__mesh_direction(d, mesh, e);
	for (int k = 0; k < 3; k++)
		stretch += d[k]*(linear->x[mesh->end[e][1]][k] - linear->x[mesh->end[e][0]][k]);
	return linear->T[e] > 0.0
		? mesh->EA[e]/mesh->length0[e]*(1.0 - I*omega*mesh->axial[e])*stretch : 0.0;
}

/* Displacement of a probe. */
static void displacement(double complex x[3], const struct hawser__linear_mesh *linear,
                         const struct hawser_net_probe *probe)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	int first, count, e;
	double place;

	if (probe->node >= 0) {
		memcpy(x, linear->x[probe->node], 3*sizeof *x);
		return;
	}
	first = mesh->first[probe->cable];
	count = mesh->first[probe->cable + 1] - first;
	place = probe->part*count;
	e = first + (place < count ? (int)place : count - 1);
	place -= e - first;
	for (int k = 0; k < 3; k++)
		x[k] = (1.0 - place)*linear->x[mesh->end[e][0]][k] + place*linear->x[mesh->end[e][1]][k];
}

/* Sums over the sea: covariances at all places, and the squares of what is shown. */
static enum hawser_status sum(struct hawser_net_waves *waves, struct solver *solver, int shown,
                              struct hawser_report *report)
{
	struct hawser__linear_mesh *linear = &solver->linear;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < linear->wets; i++)
		memset(linear->wet[i].cov, 0, sizeof linear->wet[i].cov);
	for (int n = 0; n < solver->sea.count && !status; n++) {
		const struct hawser_wave *wave = &solver->sea.wave[n];
		double square = 0.5*wave->amplitude*wave->amplitude;
		double complex r[3];

		hawser__linear_mesh_wave(linear, wave->omega);
		status = hawser__linear_mesh_solve(linear, wave->omega, report);
		for (int i = 0; i < linear->wets && !status; i++) {
			hawser__linear_mesh_relative(r, linear, &linear->wet[i], wave->omega);
			for (int k = 0; k < 9; k++)
				linear->wet[i].cov[k/3][k%3] += square*creal(r[k/3]*conj(r[k%3]));
		}
		for (int p = 0; p < waves->probes && shown; p++) {
			displacement(r, linear, &solver->options.probe[p]);
			for (int k = 0; k < 3; k++)
				waves->size[p][k] += square*creal(r[k]*conj(r[k]));
		}
		for (int k = 0; k < 2*waves->cables && shown; k++) {
			double complex T = tension(linear, k/2, k%2, wave->omega);

			waves->T_size[k/2][k%2] += square*creal(T*conj(T));
		}
	}
	return status;
}

/* The linear drag in the sea, and the standard deviations. It begins with that of the water alone. */
static enum hawser_status sea(struct hawser_net_waves *waves, struct solver *solver,
                              struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (waves->change = 1.0; !status && waves->change > solver->options.tolerance &&
	     !stopped(waves, solver, 0); waves->iterations++) {
		if (waves->iterations == solver->options.iterations)
			return diverged(solver, waves->change, report);
		status = sum(waves, solver, 0, report);
		if (!status)
			waves->change = half_step(&solver->linear, 0.0, 0.0);
	}
	if (!status && !waves->interrupted)
		status = sum(waves, solver, 1, report);
	for (int k = 0; k < 3*waves->probes; k++)
		waves->size[k/3][k%3] = sqrt(waves->size[k/3][k%3]);
	for (int k = 0; k < 2*waves->cables; k++)
		waves->T_size[k/2][k%2] = sqrt(waves->T_size[k/2][k%2]);
	return status;
}

static void keep(struct hawser_net_waves *waves, const struct solver *solver, int row)
{
	const struct hawser__linear_mesh *linear = &solver->linear;
	double size = solver->sea.count ? 0.0 : 0.5*waves->height;

	for (int p = 0; p < waves->probes; p++) {
		double complex x[3];

		displacement(x, linear, &solver->options.probe[p]);
		for (int k = 0; k < 3; k++) {
			waves->x[3*(row*waves->probes + p) + k] = cabs(x[k]);
			waves->phase[3*(row*waves->probes + p) + k] = carg(x[k]);
			waves->size[p][k] = fmax(waves->size[p][k], size*cabs(x[k]));
		}
	}
	for (int k = 0; k < 2*waves->cables; k++) {
		double complex T = tension(linear, k/2, k%2, waves->omega[row]);

		waves->T[2*row*waves->cables + k] = cabs(T);
		waves->T_phase[2*row*waves->cables + k] = carg(T);
		waves->T_size[k/2][k%2] = fmax(waves->T_size[k/2][k%2], size*cabs(T));
	}
}

static enum hawser_status allocate(struct hawser_net_waves *waves, int is_sea,
                                   struct hawser_report *report)
{
	size_t points = (size_t)waves->points, probes = (size_t)waves->probes;
	size_t cables = (size_t)waves->cables;
	struct hawser__hold hold = {0};

	waves->omega = hawser__hold(&hold, points, sizeof *waves->omega);
	waves->spectrum = is_sea ? hawser__hold(&hold, points, sizeof *waves->spectrum) : NULL;
	waves->x = hawser__hold(&hold, 3*points*probes + 1, sizeof *waves->x);
	waves->phase = hawser__hold(&hold, 3*points*probes + 1, sizeof *waves->phase);
	waves->T = hawser__hold(&hold, 2*points*cables + 1, sizeof *waves->T);
	waves->T_phase = hawser__hold(&hold, 2*points*cables + 1, sizeof *waves->T_phase);
	waves->size = hawser__hold(&hold, probes + 1, sizeof *waves->size);
	waves->T_size = hawser__hold(&hold, cables + 1, sizeof *waves->T_size);
	waves->T_mean = hawser__hold(&hold, 2*cables + 1, sizeof *waves->T_mean);
	waves->held = hold.last;
	return hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

static enum hawser_status check(const struct hawser_net *net,
                                const struct hawser_net_waves_options *options,
                                struct hawser_report *report)
{
	int driven = net->motions > 0;

	if (!net->water.waves.count)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s has no waves: add water.waves, for "
		                    "example {height: 4 m, period: 9 s}, and water.depth", net->name);
	if (net->ratio > 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: damping.ratio is that of modes, "
		                    "and the response to waves has none: give damping.rayleigh, alpha or "
		                    "axial", net->name);
	for (int i = 0; i < net->loads; i++)
		driven = driven || net->load[i].harmonic;
	if (driven)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s has waves, and harmonic loads or "
		                    "motions of supports besides: the response to waves is that to waves "
		                    "alone; leave one of them out", net->name);
	if (!(options->from > 0.0 && options->from <= options->to && options->points >= 1))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%d frequencies of waves from %g to %g "
		                    "rad/s", options->points, options->from, options->to);
	return HAWSER_OK;
}

static void settle(struct hawser_net_waves_options *options, const struct hawser_net *net)
{
	const struct hawser_waves *waves = &net->water.waves;

	hawser__settle(&options->tolerance, 1e-8);
	hawser__settle_count(&options->iterations, 100);
	hawser__settle_count(&options->points, 100);
	if (waves->count) {
		hawser__settle(&options->from, waves->wave[0].omega*(waves->count > 1 ? 1.0 : 0.5));
		hawser__settle(&options->to,
		               waves->wave[waves->count - 1].omega*(waves->count > 1 ? 1.0 : 2.0));
	}
}

static enum hawser_status run(struct hawser_net_waves *waves, struct solver *solver,
                              const struct hawser_jonswap *spectrum, struct hawser_report *report)
{
	const struct hawser_net_waves_options *options = &solver->options;
	struct hawser__linear_mesh *linear = &solver->linear;
	enum hawser_status status = solver->sea.count ? sea(waves, solver, report) : HAWSER_OK;

	for (int i = 0; i < waves->points && !status; i++) {
		double omega = options->from + (waves->points > 1 ? (options->to - options->from)*i/
		                                                    (waves->points - 1) : 0.0);

		if (stopped(waves, solver, i)) {
			waves->points = i;
			break;
		}
		waves->omega[i] = omega;
		if (waves->spectrum) {
			waves->spectrum[i] = hawser_jonswap_at(spectrum, omega);
			hawser__linear_mesh_wave(linear, omega);
			status = hawser__linear_mesh_solve(linear, omega, report);
		} else {
			status = regular(waves, solver, omega, report);
		}
		if (!status)
			keep(waves, solver, i);
	}
	for (int k = 0; k < 2*waves->cables; k++)
		waves->T_mean[k] = linear->T[k%2 ? linear->mesh.first[k/2 + 1] - 1 : linear->mesh.first[k/2]];
	for (int i = 0; i < linear->mesh.touches; i++)
		waves->touching += linear->mesh.touch[i].r > 0.0;
	waves->unknowns = linear->mesh.unknowns;
	return status;
}

enum hawser_status hawser_net_waves_solve(struct hawser_net_waves *waves, const struct hawser_net *net,
                                          const struct hawser_net_waves_options *asked,
                                          struct hawser_report *report)
{
	struct solver solver = {.options = *asked, .began = hawser__wall_seconds()};
	struct hawser_waves_given middle = net->water.given;
	struct hawser_jonswap spectrum = {0.0, 0.0, 0.0};
	int is_sea = middle.Hs > 0.0;
	enum hawser_status status;

	*waves = (struct hawser_net_waves){0};
	settle(&solver.options, net);
	if ((status = check(net, &solver.options, report)) != HAWSER_OK)
		return status;
	*waves = (struct hawser_net_waves){
		.points = solver.options.points, .probes = solver.options.probes,
		.height = is_sea ? middle.Hs : middle.height};
	while (waves->cables < net->cables && !net->cable[waves->cables].rod)
		waves->cables++; /* rods of bodies are behind them, and have no tensions */
	middle.seed = HAWSER_NONE;
	if (is_sea) {
		hawser_jonswap_of(&spectrum, middle.Hs, middle.Tp, middle.gamma > 0.0 ? middle.gamma : 3.3);
		status = hawser_waves_make(&solver.sea, &middle, report);
	}
	if (!status)
		status = allocate(waves, is_sea, report);
	if (!status)
		status = hawser__linear_mesh_open(&solver.linear, net, report);
	if (!status)
		status = run(waves, &solver, &spectrum, report);
	hawser__linear_mesh_clear(&solver.linear);
	hawser_waves_clear(&solver.sea);
	if (status)
		hawser_net_waves_clear(waves);
	return status;
}
