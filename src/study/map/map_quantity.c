/* study/map/map_quantity.c - the table of quantities.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/frf.h>

#include "core/report.h"
#include "response/floquet/linear_margin.h"
#include "study/map/map_cable.h"

#define MOST_LOG 700.0 /* largest logarithm of a multiplier's modulus, near the range of double */

void hawser__map_room_clear(struct hawser__map_room *room)
{
	hawser_linear_free(room->linear);
	free(room->log_modulus);
	*room = (struct hawser__map_room){.finer = room->finer};
}

enum hawser_status hawser__map_room_fit(struct hawser__map_room *room, int n,
                                        struct hawser_report *report)
{
	enum hawser_status status;

	if (room->n == n)
		return HAWSER_OK;
	hawser__map_room_clear(room);
	status = hawser_linear_open(&room->linear, n, report);
	if (status)
		return status;
	room->log_modulus = malloc((5*(size_t)n + HAWSER__EXPONENTS((size_t)n))*sizeof(double));
	if (!room->log_modulus)
		return hawser__no_memory(report, "map");
	room->argument = room->log_modulus + 2*(size_t)n;
	room->frequency = room->argument + 2*(size_t)n;
	room->exponents = room->frequency + n;
	room->n = n;
	hawser__linear_haste(room->linear, 1);
	if (room->finer > 1)
		hawser_linear_refine(room->linear, room->finer);
	return HAWSER_OK;
}

static enum hawser_status growth(struct hawser__map_room *room, struct hawser_map_sample *sample,
                                 const struct hawser_rom *rom, double omega,
                                 struct hawser_report *report)
{
	enum hawser_status status = hawser_linear_growth(room->linear, &sample->value, &sample->number,
	                                                 room->frequency, rom, report);

	(void)omega;
	sample->value /= rom->time;
	return status;
}

/* The largest multiplier, log [1]; 0 where it is undecided, so that its value is only an error: a map
 * would show a picture of errors. */
static enum hawser_status largest_log(double *log, struct hawser__map_room *room,
                                      struct hawser_map_sample *sample, const struct hawser_rom *rom,
                                      double omega, struct hawser_report *report)
{
	enum hawser_status status = hawser_linear_multipliers(room->linear, room->log_modulus,
	                                                      room->argument, NULL, rom, omega, report);
	struct hawser__circle circle;

	if (status)
		return status;
	circle = hawser__linear_circle(room->linear);
	*log = circle.undecided > 0 && circle.unstable == 0 ? 0.0 : room->log_modulus[0];
	sample->number = circle.unstable;
	return HAWSER_OK;
}

/* That of motions about a response, or of a parametrically excited model: with its sign. */
static enum hawser_status floquet(struct hawser__map_room *room, struct hawser_map_sample *sample,
                                  const struct hawser_rom *rom, double omega,
                                  struct hawser_report *report)
{
	double log;
	enum hawser_status status = largest_log(&log, room, sample, rom, omega, report);

	if (!status)
		sample->value = log*omega/(2.0*M_PI*rom->time);
	return status;
}

static enum hawser_status any_growth(struct hawser__map_room *room, struct hawser_map_sample *sample,
                                     const struct hawser_rom *rom, double omega,
                                     struct hawser_report *report)
{
	return (omega > 0.0 ? floquet : growth)(room, sample, rom, omega, report);
}

static enum hawser_status multiplier(struct hawser__map_room *room, struct hawser_map_sample *sample,
                                     const struct hawser_rom *rom, double omega,
                                     struct hawser_report *report)
{
	double log;
	enum hawser_status status = largest_log(&log, room, sample, rom, omega, report);

	if (!status)
		sample->value = exp(fmin(log, MOST_LOG));
	return status;
}

static enum hawser_status unstable(struct hawser__map_room *room, struct hawser_map_sample *sample,
                                   const struct hawser_rom *rom, double omega,
                                   struct hawser_report *report)
{
	enum hawser_status status = (omega > 0.0 ? multiplier : growth)(room, sample, rom, omega, report);

	sample->value = sample->number;
	return status;
}

/* Over the components of the probes, or over the coordinates of a model without probes. */
static double largest(const struct hawser_frf *frf)
{
	const double *of = frf->probes > 0 ? frf->probe : frf->coordinate;
	int count = frf->probes > 0 ? 3*frf->probes : frf->n;
	double most = 0.0;

	for (int k = 0; k < count; k++)
		most = fmax(most, of[k]);
	return most;
}

/* The first orbit of a frequency response that starts at this frequency. */
static enum hawser_status amplitude(struct hawser__map_room *room, struct hawser_map_sample *sample,
                                    const struct hawser_rom *rom, double omega,
                                    struct hawser_report *report)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_frf frf;
	enum hawser_status status;

	(void)room;
	options.from = omega;
	options.to = 2.0*omega;
	options.max_points = 1;
	options.samples = HAWSER_NONE;
	status = hawser_frf_trace(&frf, rom, &options, report);
	if (!status) {
		sample->value = largest(&frf)*(rom->scaled ? rom->length : 1.0);
		sample->number = frf.point[0].unstable;
		if (frf.tension && frf.tension[0] < 0.0) {
			sample->code = HAWSER_MAP_SLACK;
			(void)hawser__fail(report, HAWSER_OK, "map",
			                   "the least tension in the response is %.4g N: a cable cannot "
			                   "carry that", frf.tension[0]);
		}
	}
	hawser_frf_clear(&frf);
	return status;
}

static const struct hawser__map_quantity rows[] = {
	{{"growth", "largest growth rate, negative where all motions decay", "1/s",
	  "growing modes, or multipliers outside the unit circle", 0, 0, 0}, 0.0, any_growth, 1},
	{{"multiplier", "largest modulus of a Floquet multiplier", "1",
	  "multipliers outside the unit circle", 1, 0, 1}, 1.0, multiplier, 1},
	{{"unstable", "number of unstable multipliers, or of growing modes without Omega",
	  "1", "the same", 0, 0, 0}, 0.5, unstable, 1},
	{{"amplitude", "peak amplitude of the periodic response", "m",
	  "multipliers of the response outside the unit circle", 1, 1, 1}, NAN, amplitude, 0},
	{{"basin", "the response at which a motion from this initial state ends", "1",
	  "the same: 0 is none that is periodic, -1 a motion without bounds", 1, 1, 0}, NAN, NULL, 0},
	{{"critical-speed", "speed of the wind from which on a mode grows", "m/s",
	  "whether wind.speed is above it", 0, 0, 0}, NAN, NULL, 0},
};
#define ROWS ((int)(sizeof rows/sizeof *rows))

const struct hawser_map_quantity *hawser_map_quantity(int index)
{
	return index >= 0 && index < ROWS ? &rows[index].about : NULL;
}

const struct hawser__map_quantity *hawser__map_quantity(const char *name)
{
	for (int i = 0; i < ROWS; i++)
		if (strcmp(rows[i].about.name, name) == 0)
			return &rows[i];
	return NULL;
}
