/* study/map/map_point.c - a point of the field of a scene or a model: the model at this point, with the
 * factors of load and damping, and its quantity.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/orbit/about.h"
#include "response/floquet/linear_margin.h"
#include "response/orbit/load.h"
#include "rom/build/build.h"
#include "scene/keys.h"
#include "study/map/map.h"
#include "study/map/map_cable.h"

#define ORBIT 1e-6 /* see struct hawser_map_source: a hundredth of the width of a map's brackets */

#define LEVEL 1e-8 /* logarithm of a real multiplier that counts as above 1; chosen */

struct worker {
	struct hawser__map_cable *cable;
	struct hawser__map_room room;
	struct hawser_rom scaled; /* copy of a model with factors; its arrays follow */
	double *numbers;
	struct hawser_quad *quad;
	struct hawser_harmonic *harmonic;
	struct hawser_rom damped; /* copy of a model with another D */
	double *D;
	struct hawser__structure own; /* structure of the last point, if it is not stored */
	struct hawser_rom built;      /* model of the last point, likewise */
	struct hawser__about about;   /* of the last point */
	struct hawser__way foretold;  /* likewise */
	struct hawser_map_condensed condensed;
};

enum hawser_status hawser__map_worker_open(void **to, void *context,
                                           struct hawser_report *report)
{
	struct worker *worker = calloc(1, sizeof *worker);

	*to = worker;
	if (!worker)
		return hawser__no_memory(report, "map");
	worker->cable = context;
	return HAWSER_OK;
}

void hawser__map_condensed_note(struct hawser_map_condensed *condensed,
                                const struct hawser__map_room *room)
{
	struct hawser_map_condensed one = {.points = 1, .kept = room->n};

	if (room->linear)
		one.kept = hawser__linear_kept(room->linear, &one.neglected);
	if (one.neglected > 0.0)
		hawser__map_condensed_merge(condensed, &one);
}

static void release_point(struct worker *worker)
{
	hawser__structure_clear(&worker->own);
	hawser_rom_clear(&worker->built);
	worker->own = (struct hawser__structure){.value = 0.0};
	worker->built = (struct hawser_rom){.n = 0};
}

void hawser__map_worker_close(void *context)
{
	struct worker *worker = context;

	if (!worker)
		return;
	hawser__map_condensed_merge(&worker->cable->condensed, &worker->condensed);
	release_point(worker);
	hawser__map_room_clear(&worker->room);
	free(worker->numbers);
	free(worker->quad);
	free(worker->harmonic);
	free(worker->D);
	hawser__about_clear(&worker->about);
	hawser__way_clear(&worker->foretold);
	free(worker);
}

const struct hawser__map_room *hawser__map_worker_room(void *context, int finer)
{
	struct worker *worker = context;

	worker->room.finer = finer;
	return &worker->room;
}

const struct hawser__map_cable *hawser__map_worker_cable(const void *context)
{
	return ((const struct worker *)context)->cable;
}

static double *copy_scaled(double **next, const double *from, size_t count, double factor)
{
	double *to = *next;

	if (!from)
		return NULL;
	for (size_t i = 0; i < count; i++)
		to[i] = factor*from[i];
	*next += count;
	return to;
}

/* The model with its harmonics times `load` and the symmetric part of D times `damping`; its arrays
 * belong to the worker and are valid until the next call. */
static enum hawser_status scale(struct worker *worker, const struct hawser_rom *rom, double load,
                                double damping, struct hawser_report *report)
{
	size_t n = (size_t)rom->n, h = (size_t)rom->harmonics;
	double *numbers, *next, share;
	struct hawser_quad *quad;
	size_t quads = 0;
	struct hawser_harmonic *harmonic;

	for (size_t i = 0; i < h; i++)
		quads += (size_t)rom->harmonic[i].quads;
	if (hawser__resize(&worker->numbers, n*n + h*(n + 2*n*n), sizeof *numbers) ||
	    hawser__resize(&worker->harmonic, h, sizeof *harmonic) ||
	    hawser__resize(&worker->quad, quads, sizeof *quad))
		return hawser__no_memory(report, "map");
	numbers = worker->numbers;
	harmonic = worker->harmonic;
	quad = worker->quad;
	worker->scaled = *rom;
	worker->scaled.D = numbers;
	worker->scaled.harmonic = harmonic;
	for (size_t j = 0; j < n; j++)
		for (size_t k = 0; k < n; k++) {
			double a = rom->D[j*n + k], b = rom->D[k*n + j];

			numbers[j*n + k] = 0.5*damping*(a + b) + 0.5*(a - b);
		}
	next = numbers + n*n;
	for (size_t i = 0; i < h; i++) {
		harmonic[i] = rom->harmonic[i];
		share = hawser__load_share(&rom->harmonic[i], load);
		harmonic[i].f = copy_scaled(&next, rom->harmonic[i].f, n, share);
		harmonic[i].D = copy_scaled(&next, rom->harmonic[i].D, n*n, share);
		harmonic[i].K = copy_scaled(&next, rom->harmonic[i].K, n*n, share);
		harmonic[i].Q = quad;
		for (int e = 0; e < rom->harmonic[i].quads; e++, quad++) {
			*quad = rom->harmonic[i].Q[e];
			quad->value *= share;
		}
	}
	return HAWSER_OK;
}

/* After the model or the value of a point failed: 1 if the map continues. */
int hawser__map_own_failure(struct hawser_map_sample *sample, enum hawser_status status,
                            int steady)
{
	switch (status) {
	case HAWSER_ERR_NO_SOLUTION:
		sample->code = steady == 2 ? HAWSER_MAP_NO_RESPONSE
		               : steady ? HAWSER_MAP_NO_STATE : HAWSER_MAP_NOT_FINITE;
		return 1;
	case HAWSER_ERR_CONVERGENCE: sample->code = HAWSER_MAP_NOT_CONVERGED; return 1;
	case HAWSER_ERR_NAN: sample->code = HAWSER_MAP_NOT_FINITE; return 1;
	case HAWSER_ERR_ARGUMENT:
	case HAWSER_ERR_SCENE: sample->code = HAWSER_MAP_REFUSED; return 1;
	default: return 0;
	}
}

/* The model of the structure with the damping of the scene at this point. */
static enum hawser_status damp(struct worker *worker, const struct hawser__structure *structure,
                               const double at[2], struct hawser_report *report)
{
	const struct hawser_rom *rom = &structure->rom;
	size_t size = (size_t)rom->n*(size_t)rom->n*sizeof *worker->D;
	/* NOLINTNEXTLINE(clang-analyzer-optin.portability.UnixAPI): a model has a coordinate */
	double *D = realloc(worker->D, size);
	struct hawser_scene scene;
	enum hawser_status status;

	if (!D)
		return hawser__no_memory(report, "map");
	worker->D = memcpy(D, rom->D, size);
	worker->damped = *rom;
	worker->damped.D = D;
	status = hawser__map_cable_axes(&scene, worker->cable, at, HAWSER__REACH_RATES, report);
	if (!status)
		status = hawser__rom_damping(&worker->damped, &structure->modes, &scene, report);
	return status;
}

/* The model of a structure, without factors. */
static enum hawser_status of_structure(const struct hawser_rom **rom, struct worker *worker,
                                       const struct hawser__structure *structure,
                                       const double at[2], struct hawser_report *report)
{
	struct hawser_scene scene;
	enum hawser_status status;

	*rom = worker->cable->damps ? &worker->damped
	       : worker->cable->models ? &worker->built : &structure->rom;
	if (worker->cable->damps)
		return damp(worker, structure, at, report);
	if (!worker->cable->models)
		return HAWSER_OK;
	status = hawser__map_cable_axes(&scene, worker->cable, at, HAWSER__REACH_RATES, report);
	if (!status)
		status = hawser__map_cable_model(&worker->built, worker->cable, &structure->modes, &scene,
		                                 report);
	return status;
}

/* The frequency at a point; the factors of load and damping are applied to *rom. */
static enum hawser_status apply(const struct hawser_rom **rom, double *omega, struct worker *worker,
                                const double at[2], struct hawser_report *report)
{
	const struct hawser__map_cable *cable = worker->cable;
	double factor[2] = {1.0, 1.0};
	enum hawser_status status = HAWSER_OK;

	*omega = cable->source.omega;
	for (int k = 0; k < 2; k++) {
		if (cable->reach[k] == HAWSER__REACH_OMEGA)
			*omega = at[k];
		else if (cable->reach[k] == HAWSER__REACH_LOAD || cable->reach[k] == HAWSER__REACH_DAMPING)
			factor[cable->reach[k] == HAWSER__REACH_DAMPING] = at[k];
	}
	if ((*omega != 0.0 || hawser__map_omega_is_axis(cable)) && !(*omega > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "Omega = %.9g: it must be greater than zero", *omega);
	if (factor[0] != 1.0 || factor[1] != 1.0) {
		status = scale(worker, *rom, factor[0], factor[1], report);
		*rom = &worker->scaled;
	}
	return status;
}

/* In place of a model that something moves: that of motions about its response. */
static enum hawser_status respond(const struct hawser_rom **rom, double omega, struct worker *worker,
                                  struct hawser_report *report)
{
	enum hawser_status status;

	if (!worker->cable->moves || !(omega > 0.0) || !hawser_rom_loaded(*rom))
		return HAWSER_OK;
	status = hawser__about_response(&worker->about, *rom, omega*(*rom)->time, report);
	*rom = &worker->about.rom;
	return status;
}

/* The model at a point and the frequency, valid until the next point of the worker. *steady: 1: the
 * structure failed. */
static enum hawser_status of_point(const struct hawser_rom **rom, double *omega, int *steady,
                                   struct worker *worker, const double at[2],
                                   struct hawser_report *report)
{
	const struct hawser__map_cable *cable = worker->cable;
	const struct hawser__structure *structure = cable->varies < 0 ? cable->kept : NULL;
	enum hawser_status status = HAWSER_OK;

	*steady = 0;
	release_point(worker);
	if (cable->source.rom && hawser__map_has_parameter(cable)) {
		struct hawser_parameter parameter[HAWSER_PARAMETERS];
		struct hawser_rom_source file;

		hawser__map_cable_file(&file, parameter, cable, at);
		*rom = &worker->built;
		status = hawser_rom_source_model(&worker->built, &file, report);
	} else if (cable->source.rom) {
		*rom = cable->source.rom;
	} else {
		if (cable->varies == 2)
			hawser__structure_build(&worker->own, cable, at);
		else if (cable->varies >= 0)
			structure = hawser__structure_find(cable, at[cable->varies]);
		structure = structure ? structure : &worker->own;
		status = structure->status;
		*steady = status != HAWSER_OK;
		if (status && report)
			*report = structure->report;
		if (!status)
			status = of_structure(rom, worker, structure, at, report);
	}
	return status ? status : apply(rom, omega, worker, at, report);
}

/* Put the keys of the point in front of the message, which names the frequency only. */
static void name_keys(struct hawser_report *report, const struct hawser__map_cable *cable,
                      const double at[2])
{
	const struct hawser_map_source *source = &cable->source;
	char keys[160] = "", message[sizeof report->message], unit[32];

	for (int k = 0; k < 2; k++)
		if (cable->reach[k] != HAWSER__REACH_OMEGA)
			hawser__append(keys, sizeof keys, ", ", "%.60s = %.9g%s", source->key[k], at[k],
			               source->scene ? hawser__key_unit(source->scene, source->key[k], unit) : "");
	memcpy(message, report->message, sizeof message);
	if (*keys)
		snprintf(report->message, sizeof report->message, "%s: %.470s", keys, message);
}

/* The same; of what moves, the model of motions about its response. *steady: 2: the response failed. */
static enum hawser_status model_at(const struct hawser_rom **rom, double *omega, int *steady,
                                   struct worker *worker, const double at[2],
                                   struct hawser_report *report)
{
	enum hawser_status status = of_point(rom, omega, steady, worker, at, report);

	if (!status) {
		status = respond(rom, *omega, worker, report);
		*steady = status ? 2 : 0;
	}
	if ((status == HAWSER_ERR_NO_SOLUTION || status == HAWSER_ERR_CONVERGENCE) && report)
		name_keys(report, worker->cable, at);
	return status;
}

enum hawser_status hawser__map_worker_way(void *context, struct hawser__way *way,
                                          const struct hawser__way *guide, double x, double y)
{
	struct worker *worker = context;
	const struct hawser_rom *rom = NULL;
	const double at[2] = {x, y};
	double omega;
	int steady;
	enum hawser_status status = of_point(&rom, &omega, &steady, worker, at, NULL);

	if (!status && omega > 0.0 && hawser_rom_loaded(rom))
		status = hawser__about_way(way, guide, rom, omega*rom->time, NULL);
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}

enum hawser_status hawser__map_worker_model(void *context, const struct hawser_rom **rom,
                                            double *omega, int *steady, double x, double y,
                                            struct hawser_report *report)
{
	struct worker *worker = context;
	const double at[2] = {x, y};

	enum hawser_status status = hawser__map_guide(&worker->about.guide, &worker->foretold,
	                                              worker->cable, x, y);

	worker->about.tolerance = 0.0;
	worker->about.counts = 0;
	return status ? hawser__no_memory(report, "map")
	              : model_at(rom, omega, steady, worker, at, report);
}

enum hawser_status hawser__map_worker_coordinates(void *context, int *n, const double at[2],
                                                  struct hawser_report *report)
{
	const struct hawser_rom *rom = NULL;
	double omega;
	int steady;
	enum hawser_status status = of_point(&rom, &omega, &steady, context, at, report);

	if (!status)
		*n = rom->n;
	return status;
}

int hawser__map_worker_prepared(void *context, double x, double y)
{
	const struct worker *worker = context;
	const double at[2] = {x, y};
	int varies = worker->cable->varies;

	return varies != 0 && varies != 1 ? hawser__map_guided(worker->cable, x, y)
	       : hawser__structure_find(worker->cable, at[varies]) != NULL;
}

/* The exponents of the first cable->n coordinates: the model may have further ones behind its modes
 * (dampers of attachments). */
static enum hawser_status exponents(struct worker *worker, double *to, const struct hawser_rom *rom,
                                    double omega, struct hawser_report *report)
{
	int n = worker->cable->n, all = rom->n;
	const double *from = worker->room.exponents + 1;
	enum hawser_status status = hawser__linear_exponents(worker->room.linear, worker->room.exponents,
	                                                     rom, omega, report);

	if (status || all < n)
		return status;
	to[0] = omega;
	memcpy(to + 1, from, (size_t)n*sizeof *to);
	memcpy(to + 1 + n, from + all, (size_t)n*sizeof *to);
	memcpy(to + 1 + 2*n, from + 2*all, 2*(size_t)n*sizeof *to);
	memcpy(to + 1 + 4*n, from + 4*all, 2*(size_t)n*sizeof *to);
	return HAWSER_OK;
}

static enum hawser_status measure(struct worker *worker, struct hawser_map_sample *sample,
                                  double *marks, const struct hawser_rom *rom, double omega,
                                  struct hawser_report *report)
{
	const struct hawser__map_cable *cable = worker->cable;
	enum hawser_status status = hawser__map_room_fit(&worker->room, rom->n, report);

	if (status)
		return status;
	status = cable->quantity->measure(&worker->room, sample, rom, omega*rom->time, report);
	if (!status)
		hawser__map_condensed_note(&worker->condensed, &worker->room);
	if (status || !marks)
		return status;
	if (!cable->quantity->about.nonlinear)
		hawser__linear_margin(worker->room.linear, marks);
	return cable->n > 0 ? exponents(worker, marks + HAWSER__MARGINS, rom, omega*rom->time, report)
	                    : HAWSER_OK;
}

/* Whether an odd number of multipliers are real and above 1, as behind a fold. */
static int is_odd(const struct hawser__map_room *room)
{
	int count = 0;

	for (int i = 0; i < 2*room->n; i++)
		count += room->argument[i] == 0.0 && room->log_modulus[i] > LEVEL;
	return count%2;
}

enum hawser_status hawser__map_worker_point(void *context, struct hawser_map_sample *sample,
                                            double *marks, double x, double y,
                                            struct hawser_report *report)
{
	struct worker *worker = context;
	const double at[2] = {x, y};
	const struct hawser_rom *rom = NULL;
	double omega, asked = worker->cable->source.orbit;
	enum hawser_status status = HAWSER_OK;
	int steady, again = 1;

	*sample = (struct hawser_map_sample){0.0, 0, HAWSER_MAP_OK};
	for (int k = 0; marks && k < worker->cable->marks; k++)
		marks[k] = 0.0;
	if (hawser__map_guide(&worker->about.guide, &worker->foretold, worker->cable, x, y))
		return hawser__no_memory(report, "map");
	worker->about.tolerance = worker->room.finer ? 0.0 : asked > 0.0 ? asked : ORBIT;
	worker->about.counts = 1;
	for (worker->about.slow = 0; again; worker->about.slow = again) {
		worker->about.unsure = 0;
		status = model_at(&rom, &omega, &steady, worker, at, report);
		if (!status)
			status = measure(worker, sample, marks, rom, omega, report);
		again = worker->cable->moves && worker->about.unsure && !worker->about.slow &&
		        ((!status && is_odd(&worker->room)) ||
		         (status == HAWSER_ERR_CONVERGENCE && !steady));
	}
	if (status && hawser__map_own_failure(sample, status, steady)) {
		sample->value = 0.0;
		sample->number = 0;
		return HAWSER_OK;
	}
	if (!status && !isfinite(sample->value))
		*sample = (struct hawser_map_sample){0.0, 0, HAWSER_MAP_NOT_FINITE};
	return status;
}
