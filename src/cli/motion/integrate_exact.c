/* cli/motion/integrate_exact.c - a run with the exact energy in place of one of a reduced model
 * that is not good enough (model.energy: auto; exact.c for responses).
 *
 * Two bases that agree in the run tell the error of the larger one. They are compared at the probes, in
 * rows all over the run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/integrate_result.h"
#include "core/report.h"

enum { COMPARED = 512, /* most rows, chosen */
       FUNCTIONS = 24  /* as for responses */ };
static const double accuracy = 0.01, safety = 3.0; /* as for responses */
/* Seconds of processor time that nobody has to ask for, as for responses; they are counted, so
 * that what is chosen does not depend on the machine: the first part of a run tells how many
 * evaluations the whole takes. */
static const double bearable = 60.0, part = 0.02;
/* s; evaluations: 1.7e-6 with 18 coordinates and 2.7e-6 with 36 of the footbridge of
 * tests/cli/exact.sh; Jacobians with their factorisations, over the cube of that number, are few */
static const double evaluation = 1e-6, over_square = 1.5e-9, jacobian = 5e-9;
static const double larger = 2.0;      /* work of the next basis over that of the last; chosen */

/* One basis, its run, and what the run began with. */
struct attempt {
	struct hawser_rom rom;
	struct hawser_trajectory run;
	struct hawser_integrate_options choice;
	double *state;  /* of choice.initial, or NULL */
	double *sample; /* [count] signals of compared rows */
	int count, functions;
	int smaller;    /* coordinates of the attempt before */
	double work;    /* foreseen, s */
	double moved;   /* from the attempt before, relative to the largest signal; NAN: there is none */
};

static void clear(struct attempt *attempt)
{
	hawser_rom_clear(&attempt->rom);
	hawser_trajectory_clear(&attempt->run);
	free(attempt->state);
	free(attempt->sample);
	*attempt = (struct attempt){.functions = 0};
}

static enum hawser_status sample(struct attempt *attempt, const struct cli_integrate_result *result,
                                 struct hawser_report *report)
{
	int rows = attempt->run.rows, compared = rows < COMPARED ? rows : COMPARED;
	int signals = attempt->rom.shapes.points > 0 ? 3*attempt->rom.shapes.points : 0;
	struct cli_model model = *result->model;
	struct cli_integrate_result as = *result;

	model.rom = attempt->rom;
	as.model = &model;
	as.run = attempt->run;
	as.probed = 1;
	attempt->count = compared*signals;
	attempt->sample = calloc((size_t)attempt->count + 1, sizeof *attempt->sample);
	if (!attempt->sample)
		return hawser__no_memory(report, "integrate");
	for (int i = 0; i < compared; i++) {
		size_t row = (size_t)(((double)i + 1.0)/compared*(rows - 1));

		for (int k = 0; k < signals; k++)
			attempt->sample[i*signals + k] = cli_integrate_signal(&as, k, row, 0);
	}
	return HAWSER_OK;
}

static double distance(const struct attempt *a, const struct attempt *b)
{
	double most = 0.0, off = 0.0;

	for (int i = 0; i < a->count && i < b->count; i++) {
		most = fmax(most, fabs(b->sample[i]));
		off = fmax(off, fabs(b->sample[i] - a->sample[i]));
	}
	return most > 0.0 && a->count == b->count ? off/most : INFINITY;
}

static enum hawser_status run_it(struct attempt *attempt, const struct cli_integrate_result *result,
                                 double after, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (after > 0.0)
		status = cli_integrate_settle(&attempt->state, &attempt->choice, after, &attempt->rom, report);
	if (!status)
		status = hawser_integrate(&attempt->run, &attempt->rom, &attempt->choice, report);
	return status || attempt->run.interrupted ? status : sample(attempt, result, report);
}

/* What the run will take, s, as counted; one that can't begin takes nothing. */
static double foresee(const struct attempt *attempt)
{
	const struct hawser_rom *rom = &attempt->rom;
	struct hawser_integrate_options first = attempt->choice;
	struct hawser_trajectory run = {.rows = 0};
	double square = (double)rom->n*rom->n, work = 0.0;

	first.until = first.begin + part*(first.until - first.begin);
	first.every = fmin(first.every, first.until - first.begin);
	if (!hawser_integrate(&run, rom, &first, NULL))
		work = ((evaluation + over_square*square)*(double)run.evaluations +
		        jacobian*square*rom->n*(double)run.jacobians)/part;
	hawser_trajectory_clear(&run);
	return work;
}

/* The attempts in turn, until two agree; *last is the last that came to its end. *costly becomes
 * the work of all if it is too much, and *functions is the basis then. */
static enum hawser_status attempts(struct attempt *last, double *costly, int *functions,
                                   const struct cli_integrate_result *result,
                                   const struct hawser_integrate_options *choice, double after,
                                   struct hawser_report *report)
{
	double spent = 0.0;
	struct hawser_modes modes;
	struct hawser_accuracy_bases of = {&modes, &result->model->scene, choice->omega, accuracy,
	                                   FUNCTIONS};
	enum hawser_status status = cli_modes_up_to(&modes, &result->model->statics, 2.0*choice->omega,
	                                            report);
	int ended = 0;

	while (!status && !ended && !(safety*last->moved <= accuracy)) {
		struct attempt next = {.choice = *choice, .moved = NAN};

		status = hawser_accuracy_basis(&next.rom, functions, &of, last->rom.n, report);
		if (status || next.rom.n == 0)
			break;
		next.functions = *functions;
		next.work = foresee(&next);
		/* the second may confirm the first */
		*costly = spent + next.work*(last->functions ? 1.0 : 1.0 + larger);
		ended = *costly > bearable;
		if (!ended) {
			spent += next.work;
			*costly = 0.0;
			status = run_it(&next, result, after, report);
			ended = status || next.run.interrupted;
		}
		if (ended) {
			clear(&next);
			continue;
		}
		next.moved = last->functions ? distance(last, &next) : NAN;
		next.smaller = last->rom.n;
		clear(last);
		*last = next;
	}
	hawser_modes_clear(&modes);
	return status;
}

/* The result is that of the attempt, and the model what the scene would be with these keys. */
static void take(struct cli_integrate_result *result, struct cli_model *model, struct attempt *last)
{
	struct cli_model_error *error = &result->model_error;

	model->exact = (struct cli_exact){.modes = model->modes.n, .functions = last->functions,
	                                  .coordinates = last->rom.n,
	                                  .before = error->stated ? error->fixed.estimated : NAN,
	                                  .beyond = error->stated ? error->fixed.truncation : NAN};
	model->scene.model.energy = HAWSER_ENERGY_EXACT;
	model->scene.model.basis = last->functions;
	hawser_rom_clear(&model->rom);
	model->rom = last->rom;
	hawser_trajectory_clear(&result->run);
	result->run = last->run;
	result->forcing = last->choice;
	*error = (struct cli_model_error){.stated = 1, .compared = 1, .timed = error->timed,
	                                  .about = "displacements in this run", .advice = cli_basis_advice};
	error->fixed.estimated = fmin(safety*last->moved, 1.0);
	error->fixed.looked_at = last->smaller;
	last->rom = (struct hawser_rom){.n = 0};
	last->run = (struct hawser_trajectory){.rows = 0};
}

enum hawser_status cli_integrate_exact(struct cli_integrate_result *result, struct cli_model *model,
                                       struct hawser_integrate_options *choice, double **state,
                                       double after, struct hawser_report *report)
{
	struct attempt last = {.moved = NAN};
	struct hawser_report why = {.message = ""};
	double costly = 0.0;
	int functions = 0;
	enum hawser_status status = attempts(&last, &costly, &functions, result, choice, after, &why);

	if (status == HAWSER_ERR_MEMORY) {
		if (report)
			*report = why;
		clear(&last);
		return status;
	}
	if (isfinite(last.moved)) {
		take(result, model, &last);
		*choice = result->forcing;
		if (last.state) {
			free(*state);
			*state = last.state;
			last.state = NULL;
		}
	} else if (!status && costly > 0.0) {
		snprintf(model->exact.failed, sizeof model->exact.failed, "it would take some %.0f s: shorten "
		         "the run, or ask for it (--set model.energy=exact --set model.basis=%d)", costly,
		         functions);
	} else {
		snprintf(model->exact.failed, sizeof model->exact.failed, "%s",
		         status ? why.message : "no two bases hold the modes of the range");
	}
	clear(&last);
	return model->exact.functions ? cli_basis_check(model, choice->omega, report) : HAWSER_OK;
}
