/* study/hill/hill_field.c - the fields over which hill.c follows boundaries: cables and models, through
 * the points of maps, and Mathieu's equation.
 *
 * The worker of a map keeps the multipliers of its last point. Evaluating a point of the map
 * therefore yields them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/report.h"
#include "core/share.h"
#include "study/hill/hill.h"
#include "study/map/map_cable.h"

/* Factor on the steps of maps, whose multipliers have errors of 1e-10: with order 16 only round-off
 * remains. */
#define FINER 2

struct cable {
	struct hawser_map_field map;
	void **worker; /* [workers] */
	int workers, n; /* coordinates of the models */
	struct hawser_map_condensed condensed;
};

static enum hawser_status refuse(double x, double y, enum hawser_map_code code,
                                 struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "hill",
	                    "no multipliers at %.9g, %.9g (%s): leave that out of the rectangle",
	                    x, y, hawser_map_code_name(code));
}

/* Where there is no response, the report says why. */
static enum hawser_status failed_at(double x, double y, enum hawser_map_code code,
                                    struct hawser_report *report)
{
	return code == HAWSER_MAP_NO_RESPONSE ? HAWSER_ERR_CONVERGENCE : refuse(x, y, code, report);
}

/* Rooms are for n coordinates: a key such as model.modes changes their number. */
static enum hawser_status same_number(const struct cable *cable, int n, double x, double y,
                                      struct hawser_report *report)
{
	return n == cable->n ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
	                      "the model at %.9g, %.9g has %d coordinates, others in the rectangle have "
	                      "%d: boundaries are followed only where the number stays; hawser map takes "
	                      "keys that change it", x, y, n, cable->n);
}

static enum hawser_status of_cable(void *context, double *log_modulus, double *argument, double x,
                                   double y, struct hawser_report *report)
{
	struct cable *cable = context;
	const struct hawser__map_room *room = hawser__map_worker_room(cable->worker[0], FINER);
	struct hawser_map_sample sample = {.code = HAWSER_MAP_OK};
	enum hawser_status status = cable->map.prepare(cable->map.context, &x, &y, 1, 1, report);

	if (!status)
		status = cable->map.point(cable->worker[0], &sample, NULL, x, y, report);
	if (!status && sample.code != HAWSER_MAP_OK)
		status = failed_at(x, y, sample.code, report);
	if (!status)
		status = same_number(cable, room->n, x, y, report);
	for (int i = 0; !status && i < 2*room->n; i++) {
		log_modulus[i] = room->log_modulus[i];
		argument[i] = room->argument[i];
	}
	if (!status)
		hawser__map_condensed_note(&cable->condensed, room);
	return status;
}

/* Worker 0 belongs to the calling thread, which also evaluates points that were not announced by
 * `prepare`. */
static enum hawser_status model_of_cable(void *context, const struct hawser_rom **rom, double *omega,
                                         int worker, double x, double y,
                                         struct hawser_report *report)
{
	struct cable *cable = context;
	struct hawser_map_sample sample = {.code = HAWSER_MAP_OK};
	enum hawser_status status;
	int steady;

	if (!hawser__map_worker_prepared(cable->worker[worker], x, y) &&
	    (status = cable->map.prepare(cable->map.context, &x, &y, 1, 1, report)))
		return status;
	status = hawser__map_worker_model(cable->worker[worker], rom, omega, &steady, x, y, report);
	if (status && hawser__map_own_failure(&sample, status, steady))
		return failed_at(x, y, sample.code, report);
	if (!status)
		*omega *= (*rom)->time;
	return status ? status : same_number(cable, (*rom)->n, x, y, report);
}

static enum hawser_status prepare_cable(void *context, const double *x, const double *y, int count,
                                        int threads, struct hawser_report *report)
{
	struct cable *cable = context;

	return cable->map.prepare(cable->map.context, x, y, count, threads, report);
}

static enum hawser_status open_workers(struct cable *cable, int threads,
                                       struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	cable->worker = calloc((size_t)threads, sizeof *cable->worker);
	if (!cable->worker)
		return hawser__no_memory(report, "hill");
	for (; cable->workers < threads && !status; cable->workers++)
		status = cable->map.open(&cable->worker[cable->workers], cable->map.context, report);
	return status;
}

/* The number of coordinates, which may be larger than that of the modes: of the first model among
 * those of the middle and the corners, whether or not it has a response there. */
static enum hawser_status count(struct cable *cable, const struct hawser_map_source *source,
                                struct hawser_report *report)
{
	static const double place[][2] = {{0.5, 0.5}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}};
	enum hawser_status status = HAWSER_OK;

	cable->n = source->rom ? source->rom->n : source->scene->model.modes;
	for (size_t i = 0; i < sizeof place/sizeof *place; i++) {
		double at[2];

		for (int k = 0; k < 2; k++)
			at[k] = source->from[k] + place[i][k]*(source->to[k] - source->from[k]);
		status = cable->map.prepare(cable->map.context, &at[0], &at[1], 1, 1, NULL);
		if (!status)
			status = hawser__map_worker_coordinates(cable->worker[0], &cable->n, at, NULL);
		if (!status)
			return HAWSER_OK;
		if (status == HAWSER_ERR_MEMORY)
			return hawser__no_memory(report, "hill");
	}
	return HAWSER_OK;
}

enum hawser_status hawser_hill_cable_open(struct hawser_hill_field *field,
                                          const struct hawser_map_source *source,
                                          struct hawser_report *report)
{
	struct hawser_map_source whole = *source;
	struct cable *cable = calloc(1, sizeof *cable);
	enum hawser_status status;

	*field = (struct hawser_hill_field){.multipliers = of_cable, .model = model_of_cable,
		.prepare = prepare_cable, .context = cable};
	if (!cable)
		return hawser__no_memory(report, "hill");
	field->condensed = &cable->condensed;
	whole.quantity = "multiplier";
	status = hawser_map_cable_open(&cable->map, &whole, report);
	if (!status)
		status = open_workers(cable, hawser__processors(), report);
	field->responds = cable->map.responds;
	field->workers = cable->workers;
	if (!status)
		status = count(cable, source, report);
	field->m = 2*cable->n;
	if (!status)
		field->cheap = hawser__map_cable_cheap(cable->map.context);
	if (status)
		hawser_hill_cable_close(field);
	return status;
}

void hawser_hill_cable_close(struct hawser_hill_field *field)
{
	struct cable *cable = field ? field->context : NULL;

	if (!cable)
		return;
	for (int t = 0; cable->map.close && t < cable->workers; t++)
		cable->map.close(cable->worker[t]);
	free(cable->worker);
	hawser_map_cable_close(&cable->map);
	free(cable);
	*field = (struct hawser_hill_field){.m = 0};
}

/* --- Mathieu's equation --- */

struct mathieu {
	struct hawser_linear *linear;
	struct hawser_harmonic harmonic;
	struct hawser_rom rom;
	double stiffness, damping, excitation;
};

static enum hawser_status of_mathieu(void *context, double *log_modulus, double *argument, double x,
                                     double y, struct hawser_report *report)
{
	struct mathieu *mathieu = context;

	mathieu->stiffness = x;
	mathieu->excitation = 2.0*y;
	return hawser_linear_multipliers(mathieu->linear, log_modulus, argument, NULL, &mathieu->rom,
	                                 2.0, report);
}

static enum hawser_status model_of_mathieu(void *context, const struct hawser_rom **rom,
                                           double *omega, int worker, double x, double y,
                                           struct hawser_report *report)
{
	struct mathieu *mathieu = context;

	(void)worker;
	(void)report;
	mathieu->stiffness = x;
	mathieu->excitation = 2.0*y;
	*rom = &mathieu->rom;
	*omega = 2.0;
	return HAWSER_OK;
}

enum hawser_status hawser_mathieu_open(struct hawser_hill_field *field, double damping,
                                       struct hawser_report *report)
{
	struct mathieu *mathieu = calloc(1, sizeof *mathieu);
	enum hawser_status status;

	*field = (struct hawser_hill_field){.m = 2, .multipliers = of_mathieu, .context = mathieu,
		.model = model_of_mathieu, .workers = 1};
	if (!mathieu)
		return hawser__no_memory(report, "hill");
	mathieu->damping = 2.0*damping;
	mathieu->harmonic = (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS, .K =
	                                             &mathieu->excitation};
	mathieu->rom = (struct hawser_rom){.n = 1, .D = &mathieu->damping, .K = &mathieu->stiffness,
		.harmonics = 1, .harmonic = &mathieu->harmonic, .length = 1.0, .time = 1.0, .force = 1.0};
	status = hawser_linear_open(&mathieu->linear, 1, report);
	if (status)
		hawser_mathieu_close(field);
	else
		hawser_linear_refine(mathieu->linear, FINER);
	return status;
}

void hawser_mathieu_close(struct hawser_hill_field *field)
{
	struct mathieu *mathieu = field ? field->context : NULL;

	if (!mathieu)
		return;
	hawser_linear_free(mathieu->linear);
	free(mathieu);
	*field = (struct hawser_hill_field){.m = 0};
}
