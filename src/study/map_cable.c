/* study/map_cable.c - the field of a scene or a model over two of its parameters.
 *
 * A parameter matters to a part of the way from scene to value: Omega and the factors to the last
 * step only, the scene's damping to D of a linear model, its load to the model that is made from
 * the modes, all others to statics and modes. What does not depend on either axis is computed
 * once; what depends on one of them alone is kept for each of its values, of which a map has few.
 *
 *   structure   what statics and modes make of the scene: modes, and the model where no axis of the
 *               map changes it
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/linear_margin.h"
#include "rom/build.h"
#include "study/map.h"
#include "study/map_cable.h"

enum { HARMONICS = 2 }; /* multiples of Omega to which frequencies are compared, at least */

struct worker {
	struct hawser__map_cable *cable;
	struct hawser__map_room room;
	struct hawser_rom scaled; /* a model's copy with factors: arrays below */
	double *numbers;
	struct hawser_harmonic *harmonic;
	struct hawser_rom damped; /* a model with another D */
	double *D;
	struct hawser_map_condensed condensed;
};

static enum hawser_status open_worker(void **to, void *context, struct hawser_report *report)
{
	struct worker *worker = calloc(1, sizeof *worker);

	*to = worker;
	if (!worker)
		return hawser__no_memory(report, "map");
	worker->cable = context;
	return HAWSER_OK;
}

static void merge(struct hawser_map_condensed *all, const struct hawser_map_condensed *part)
{
	if (part->points == 0)
		return;
	all->kept = all->points && all->kept < part->kept ? all->kept : part->kept;
	all->neglected = fmax(all->neglected, part->neglected);
	all->points += part->points;
}

void hawser__map_condensed_note(struct hawser_map_condensed *condensed,
                                const struct hawser__map_room *room)
{
	struct hawser_map_condensed one = {.points = 1, .kept = room->n};

	if (room->linear)
		one.kept = hawser__linear_kept(room->linear, &one.neglected);
	if (one.neglected > 0.0)
		merge(condensed, &one);
}

static void close_worker(void *context)
{
	struct worker *worker = context;

	if (!worker)
		return;
	merge(&worker->cable->condensed, &worker->condensed);
	hawser__map_room_clear(&worker->room);
	free(worker->numbers);
	free(worker->harmonic);
	free(worker->D);
	free(worker);
}

const struct hawser__map_room *hawser__map_worker_room(void *context, int finer)
{
	struct worker *worker = context;

	worker->room.finer = finer;
	return &worker->room;
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

/* A model with its harmonics times `load` and the symmetric part of D times `damping`; its arrays
 * are the worker's, and serve until the next. */
static enum hawser_status scale(struct worker *worker, const struct hawser_rom *rom, double load,
                                double damping, struct hawser_report *report)
{
	size_t n = (size_t)rom->n, h = (size_t)rom->harmonics;
	double *numbers = realloc(worker->numbers, (n*n + h*(n + 2*n*n))*sizeof *numbers), *next;
	struct hawser_harmonic *harmonic = realloc(worker->harmonic, (h + 1)*sizeof *harmonic);

	worker->numbers = numbers ? numbers : worker->numbers;
	worker->harmonic = harmonic ? harmonic : worker->harmonic;
	if (!numbers || !harmonic)
		return hawser__no_memory(report, "map");
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
		harmonic[i].f = copy_scaled(&next, rom->harmonic[i].f, n, load);
		harmonic[i].D = copy_scaled(&next, rom->harmonic[i].D, n*n, load);
		harmonic[i].K = copy_scaled(&next, rom->harmonic[i].K, n*n, load);
	}
	return HAWSER_OK;
}

/* What becomes of a point whose model, or value, failed: 1 where the map goes on. */
static int own_failure(struct hawser_map_sample *sample, enum hawser_status status, int steady)
{
	switch (status) {
	case HAWSER_ERR_NO_SOLUTION:
		sample->code = steady ? HAWSER_MAP_NO_STATE : HAWSER_MAP_NOT_FINITE;
		return 1;
	case HAWSER_ERR_CONVERGENCE: sample->code = HAWSER_MAP_NOT_CONVERGED; return 1;
	case HAWSER_ERR_NAN: sample->code = HAWSER_MAP_NOT_FINITE; return 1;
	case HAWSER_ERR_ARGUMENT:
	case HAWSER_ERR_SCENE: sample->code = HAWSER_MAP_REFUSED; return 1;
	default: return 0;
	}
}

static int omega_is_axis(const struct hawser__map_cable *cable)
{
	return cable->reach[0] == HAWSER__REACH_OMEGA || cable->reach[1] == HAWSER__REACH_OMEGA;
}

static enum hawser_status measure(struct worker *worker, struct hawser_map_sample *sample,
                                  double *marks, const struct hawser_rom *rom, const double at[2],
                                  struct hawser_report *report)
{
	const struct hawser__map_cable *cable = worker->cable;
	double omega = cable->source.omega, factor[2] = {1.0, 1.0};
	enum hawser_status status = hawser__map_room_fit(&worker->room, rom->n, report);

	for (int k = 0; k < 2; k++) {
		if (cable->reach[k] == HAWSER__REACH_OMEGA)
			omega = at[k];
		else if (cable->reach[k] == HAWSER__REACH_LOAD || cable->reach[k] == HAWSER__REACH_DAMPING)
			factor[cable->reach[k] == HAWSER__REACH_DAMPING] = at[k];
	}
	if (!status && (omega != 0.0 || omega_is_axis(cable)) && !(omega > 0.0))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                      "Omega = %.9g: it must be greater than zero", omega);
	if (!status && (factor[0] != 1.0 || factor[1] != 1.0)) {
		status = scale(worker, rom, factor[0], factor[1], report);
		rom = &worker->scaled;
	}
	if (!status)
		status = cable->quantity->measure(&worker->room, sample,
		                                  marks && cable->n > 0 ? marks + HAWSER__MARGINS : NULL,
		                                  rom, omega*rom->time, report);
	if (!status)
		hawser__map_condensed_note(&worker->condensed, &worker->room);
	if (status || !marks)
		return status;
	if (!cable->quantity->about.nonlinear)
		hawser__linear_margin(worker->room.linear, marks);
	if (cable->n > 0)
		marks[HAWSER__MARGINS + rom->n] = omega*rom->time;
	return status;
}

/* The structure's model with the damping of the scene at this point. */
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
		hawser__rom_damping(&worker->damped, &structure->modes, &scene);
	return status;
}

static enum hawser_status with_model(struct worker *worker, struct hawser_map_sample *sample,
                                     double *marks, const struct hawser__structure *structure,
                                     const double at[2], struct hawser_report *report)
{
	struct hawser_scene scene;
	struct hawser_rom rom;
	enum hawser_status status;

	if (worker->cable->damps) {
		status = damp(worker, structure, at, report);
		return status ? status : measure(worker, sample, marks, &worker->damped, at, report);
	}
	if (!worker->cable->models)
		return measure(worker, sample, marks, &structure->rom, at, report);
	status = hawser__map_cable_axes(&scene, worker->cable, at, HAWSER__REACH_RATES, report);
	if (!status)
		status = hawser__map_cable_model(&rom, worker->cable, &structure->modes, &scene, report);
	if (status)
		return status;
	status = measure(worker, sample, marks, &rom, at, report);
	hawser_rom_clear(&rom);
	return status;
}

static enum hawser_status point(void *context, struct hawser_map_sample *sample, double *marks,
                                double x, double y, struct hawser_report *report)
{
	struct worker *worker = context;
	const struct hawser__map_cable *cable = worker->cable;
	const double at[2] = {x, y};
	const struct hawser__structure *structure = cable->varies < 0 ? cable->kept : NULL;
	struct hawser__structure own = {.value = 0.0};
	enum hawser_status status;
	int steady = 0;

	*sample = (struct hawser_map_sample){0.0, 0, HAWSER_MAP_OK};
	for (int k = 0; marks && k < cable->marks; k++)
		marks[k] = 0.0;
	if (cable->source.rom) {
		status = measure(worker, sample, marks, cable->source.rom, at, report);
	} else {
		if (cable->varies == 2)
			hawser__structure_build(&own, cable, at);
		else if (cable->varies >= 0)
			structure = hawser__structure_find(cable, at[cable->varies]);
		structure = structure ? structure : &own;
		status = structure->status;
		steady = status != HAWSER_OK;
		if (status && report)
			*report = structure->report;
		if (!status)
			status = with_model(worker, sample, marks, structure, at, report);
		hawser__structure_clear(&own);
	}
	if (status && own_failure(sample, status, steady)) {
		sample->value = 0.0;
		sample->number = 0;
		return HAWSER_OK;
	}
	if (!status && !isfinite(sample->value))
		*sample = (struct hawser_map_sample){0.0, 0, HAWSER_MAP_NOT_FINITE};
	return status;
}

/* w_j + w_k - m Omega; line = (m - 1) pairs + the pair. */
static double line(const void *context, int index, const double *marks)
{
	const struct hawser__map_cable *cable = context;
	int pairs = cable->n*(cable->n + 1)/2, pair = index%pairs, k = 0;

	marks += HAWSER__MARGINS;
	while ((k + 1)*(k + 2)/2 <= pair)
		k++;
	/* NOLINTNEXTLINE(bugprone-integer-division): the whole part is meant */
	return marks[pair - k*(k + 1)/2] + marks[k] - (index/pairs + 1)*marks[cable->n];
}

/* --- opening --- */

static enum hawser_status reach_of(enum hawser__reach *reach,
                                   const struct hawser_map_source *source, int k,
                                   struct hawser_report *report)
{
	const char *key = source->key[k];
	double unused;

	if (strcmp(key, "Omega") == 0)
		*reach = HAWSER__REACH_OMEGA;
	else if (strcmp(key, "factor.load") == 0)
		*reach = HAWSER__REACH_LOAD;
	else if (strcmp(key, "factor.damping") == 0)
		*reach = HAWSER__REACH_DAMPING;
	else if (source->rom)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "%.60s: the parameters of a reduced-model file are Omega, factor.load "
		                    "and factor.damping", key);
	else if (strncmp(key, "damping.", 8) == 0)
		*reach = HAWSER__REACH_RATES;
	else if (strncmp(key, "load.", 5) == 0)
		*reach = HAWSER__REACH_MODEL;
	else
		*reach = HAWSER__REACH_STRUCTURE;
	return *reach < HAWSER__REACH_RATES ? HAWSER_OK
	       : hawser_scene_get(source->scene, &unused, key, report);
}

static enum hawser_status check(struct hawser__map_cable *cable, struct hawser_report *report)
{
	const struct hawser_map_source *source = &cable->source;
	const char *name = source->quantity;
	enum hawser_status status = HAWSER_OK;
	int excited = 0;

	cable->quantity = hawser__map_quantity(name);
	if (!cable->quantity)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "there is no quantity \"%.40s\": write growth, multiplier, unstable "
		                    "or amplitude", name);
	for (int k = 0; k < 2 && !status; k++)
		status = reach_of(&cable->reach[k], source, k, report);
	if (status)
		return status;
	excited = source->omega > 0.0 || omega_is_axis(cable);
	if (strcmp(source->key[0], source->key[1]) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map", "both axes are %s",
		                    source->key[0]);
	if (cable->quantity->about.needs_omega && !excited)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "the quantity %s needs a forcing frequency: give Omega, or make it an "
		                    "axis", name);
	if (cable->quantity->about.nonlinear &&
	    (cable->reach[0] == HAWSER__REACH_DAMPING || cable->reach[1] == HAWSER__REACH_DAMPING))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "factor.damping is for linear quantities: for the %s give a key of "
		                    "the scene's damping", name);
	if (source->scene && source->scene->model.energy == HAWSER_ENERGY_EXACT &&
	    cable->quantity->resonant && excited)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "the quantity %s is about rest, where the full-order model "
		                    "(model.energy: exact) is not excited: set model.energy=quartic, or "
		                    "map the amplitude, whose number counts multipliers of the response",
		                    name);
	if (source->scene && source->scene->model.modes == HAWSER_MODES_AUTO)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "model.modes: auto chooses for one response, not for a map: give a "
		                    "number of modes");
	return HAWSER_OK;
}

static enum hawser_status describe(struct hawser__map_cable *cable, struct hawser_report *report)
{
	const struct hawser_map_source *source = &cable->source;
	enum hawser_status status = HAWSER_OK;
	char *model = NULL, *text = NULL;
	size_t size = 0;
	FILE *stream;

	if (source->rom && (status = hawser_rom_text(source->rom, &model, report)))
		return status;
	stream = open_memstream(&text, &size);
	if (!stream) {
		free(model);
		return hawser__no_memory(report, "map");
	}
	fprintf(stream, "hawser %s, %s over %s and %s, Omega %a\n%s", hawser_version(),
	        source->quantity, source->key[0], source->key[1], source->omega, model ? model : "");
	if (source->scene)
		status = hawser_scene_write(source->scene, stream, report);
	/* glibc closes such a stream with 0 and without a text where memory ran out */
	if ((fclose(stream) != 0 || !text) && !status)
		status = hawser__no_memory(report, "map");
	free(model);
	cable->identity = text;
	return status;
}

/* Where no structure varies there is one, and its failure is the map's. */
static enum hawser_status first_structure(struct hawser__map_cable *cable, struct hawser_report *report)
{
	const double none[2] = {0.0, 0.0};

	if (cable->source.rom || cable->varies >= 0)
		return HAWSER_OK;
	cable->kept = calloc(1, sizeof *cable->kept);
	if (!cable->kept)
		return hawser__no_memory(report, "map");
	cable->count = cable->room = 1;
	hawser__structure_build(cable->kept, cable, none);
	if (cable->kept->status && report)
		*report = cable->kept->report;
	return cable->kept->status;
}

static void set_marks(struct hawser_map_field *field, struct hawser__map_cable *cable)
{
	const struct hawser_map_source *source = &cable->source;
	const struct hawser_rom *rom = source->rom ? source->rom : cable->count ? &cable->kept->rom : NULL;
	int excited = source->omega > 0.0 || omega_is_axis(cable);

	if (!cable->quantity->about.nonlinear) {
		field->margins = 1;
		field->marks = HAWSER__MARGINS;
	}
	if (!cable->quantity->resonant || !excited || strcmp(source->key[0], "model.modes") == 0 ||
	    strcmp(source->key[1], "model.modes") == 0)
		return;
	cable->n = source->rom ? source->rom->n : source->scene->model.modes;
	cable->multiples = HARMONICS;
	for (int h = 0; rom && h < rom->harmonics; h++)
		if (rom->harmonic[h].k > cable->multiples)
			cable->multiples = rom->harmonic[h].k;
	field->marks = HAWSER__MARGINS + cable->n + 1;
	field->lines = cable->multiples*cable->n*(cable->n + 1)/2;
}

enum hawser_status hawser_map_cable_open(struct hawser_map_field *field,
                                         const struct hawser_map_source *source,
                                         struct hawser_report *report)
{
	struct hawser__map_cable *cable = calloc(1, sizeof *cable);
	enum hawser_status status;

	*field = (struct hawser_map_field){.name = source->quantity};
	if (!cable)
		return hawser__no_memory(report, "map");
	cable->source = *source;
	status = check(cable, report);
	if (!status) {
		int x = cable->reach[0] == HAWSER__REACH_STRUCTURE;
		int y = cable->reach[1] == HAWSER__REACH_STRUCTURE;

		cable->varies = x && y ? 2 : x ? 0 : y ? 1 : -1;
		cable->damps = cable->reach[0] == HAWSER__REACH_RATES ||
		               cable->reach[1] == HAWSER__REACH_RATES;
		cable->models = cable->reach[0] == HAWSER__REACH_MODEL ||
		                cable->reach[1] == HAWSER__REACH_MODEL ||
		                (cable->quantity->about.nonlinear && cable->damps);
		cable->damps = cable->damps && !cable->models;
		status = describe(cable, report);
	}
	if (!status)
		status = first_structure(cable, report);
	*field = (struct hawser_map_field){.name = source->quantity, .context = cable,
		.identity = cable->identity, .open = open_worker, .close = close_worker,
		.prepare = hawser__structure_prepare, .point = point, .line = line};
	if (status) {
		hawser_map_cable_close(field);
		return status;
	}
	field->threshold = cable->quantity->threshold;
	field->logarithmic = cable->quantity->about.logarithmic;
	field->condensed = &cable->condensed;
	set_marks(field, cable);
	cable->marks = field->marks;
	return HAWSER_OK;
}

void hawser_map_cable_close(struct hawser_map_field *field)
{
	struct hawser__map_cable *cable = field ? field->context : NULL;

	if (!cable)
		return;
	for (size_t c = 0; c < cable->count; c++)
		hawser__structure_clear(&cable->kept[c]);
	free(cable->kept);
	free(cable->identity);
	free(cable);
	*field = (struct hawser_map_field){.name = NULL};
}
