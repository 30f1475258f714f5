/* cli/beam_json.c - JSON of hawser beam.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "cli/beam_result.h"

/* A speed, or null where there is none. */
static void speed_json(struct hawser__json *json, json_t *into, const char *key, double v,
                       const struct hawser_beam *beam)
{
	if (isnan(v))
		hawser__json_null(json, into, key);
	else
		hawser__json_number(json, into, key, v*cli_beam_per_speed(beam));
}

static void beam_json(struct hawser__json *json, json_t *into, const struct cli_beam_variant *v)
{
	const struct hawser_beam *beam = &v->beam;
	json_t *scaled = hawser__json_object(json, into, "scaled");

	hawser__json_number(json, scaled, "theta", beam->theta);
	hawser__json_number(json, scaled, "tension", beam->tension);
	hawser__json_number(json, scaled, "weight", beam->weight);
	hawser__json_number(json, scaled, "drag", beam->drag);
	hawser__json_number(json, scaled, "rotary", beam->rotary);
	hawser__json_number(json, scaled, "speed", beam->speed);
	hawser__json_number(json, scaled, "across", beam->across);
	hawser__json_number(json, scaled, "length", beam->time > 0.0 ? beam->length : 1.0);
	hawser__json_number(json, scaled, "time", beam->time > 0.0 ? beam->time : 1.0);
}

static void limits_json(struct hawser__json *json, json_t *into, const struct cli_beam_variant *v)
{
	speed_json(json, into, "v_crit", v->limits.v_crit, &v->beam);
	speed_json(json, into, "v_crit_first", v->limits.v_first, &v->beam);
	speed_json(json, into, "v_bif", v->limits.v_bif, &v->beam);
	speed_json(json, into, "searched", v->limits.searched, &v->beam);
	hawser__json_text(json, into, "cause", hawser_beam_cause_name(v->limits.cause));
	hawser__json_number(json, into, "growth_slope", v->limits.slope/(v->beam.time > 0.0
	                                                                  ? v->beam.length : 1.0));
}

static void eigenvalues_json(struct hawser__json *json, json_t *into,
                             const struct cli_beam_variant *v)
{
	json_t *list = hawser__json_array(json, into, "eigenvalues");
	double rate = cli_beam_per_rate(&v->beam);

	for (int k = 0; k < v->found; k++) {
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_number(json, row, "re", v->eigenvalue[k].re*rate);
		hawser__json_number(json, row, "im", v->eigenvalue[k].im*rate);
		hawser__json_number(json, row, "residual", v->eigenvalue[k].residual);
		hawser__json_number(json, row, "condition", v->eigenvalue[k].condition);
	}
}

static void station_json(struct hawser__json *json, json_t *list, const struct cli_beam_variant *v,
                         int i)
{
	const struct hawser_beam_sweep *sweep = &v->sweep;
	json_t *row = hawser__json_object(json, list, NULL), *values;
	double rate = cli_beam_per_rate(&v->beam);

	hawser__json_number(json, row, "speed", sweep->station[i].speed*cli_beam_per_speed(&v->beam));
	hawser__json_integer(json, row, "growing", sweep->station[i].growing);
	hawser__json_flag(json, row, "inserted", sweep->station[i].inserted);
	values = hawser__json_array(json, row, "branches");
	for (int b = 0; b < sweep->branches; b++) {
		int cell = i*sweep->branches + b;
		json_t *value = hawser__json_object(json, values, NULL);

		hawser__json_integer(json, value, "branch", b + 1);
		hawser__json_numbers(json, value, "re", &sweep->re[2*cell], 2, rate);
		hawser__json_number(json, value, "im", sweep->im[cell]*rate);
	}
}

static void sweep_json(struct hawser__json *json, json_t *into, const struct cli_beam_variant *v)
{
	json_t *list = hawser__json_array(json, into, "speeds");

	for (int i = 0; i < v->sweep.stations; i++)
		station_json(json, list, v, i);
	list = hawser__json_array(json, into, "events");
	for (int k = 0; k < v->sweep.events; k++) {
		const struct hawser_beam_event *event = &v->sweep.event[k];
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_text(json, row, "kind", hawser_beam_event_name(event->kind));
		speed_json(json, row, "speed", event->speed, &v->beam);
		hawser__json_number(json, row, "im", event->im*cli_beam_per_rate(&v->beam));
		hawser__json_integer(json, row, "growing_before", event->growing[0]);
		hawser__json_integer(json, row, "growing_beyond", event->growing[1]);
	}
	hawser__json_number(json, into, "least_correlation", v->sweep.least_correlation);
	hawser__json_integer(json, into, "unsure", v->sweep.unsure);
}

static void variant_json(struct hawser__json *json, json_t *into,
                         const struct cli_beam_result *result, const struct cli_beam_variant *v)
{
	if (result->vary)
		hawser__json_number(json, into, "value", v->value);
	beam_json(json, into, v);
	hawser__json_integer(json, into, "size", v->size);
	hawser__json_number(json, into, "discretisation_error", v->error);
	limits_json(json, into, v);
	eigenvalues_json(json, into, v);
	if (result->kind == CLI_BEAM_SWEEP)
		sweep_json(json, into, v);
	cli_beam_boundary_json(json, into, v);
	if (result->kind == CLI_BEAM_MOTION)
		cli_beam_motion_json(json, into, v);
}

/* The first variant's members stand at the top, the others in "variants". */
void cli_beam_json(struct hawser__json *json, const void *of)
{
	const struct cli_beam_result *result = of;
	json_t *list;

	cli_echo_json(json, result->common, "beam", &result->scene);
	hawser__json_text(json, json->root, "method", result->method->name);
	if (result->vary)
		hawser__json_text(json, json->root, "vary", result->vary);
	variant_json(json, json->root, result, &result->variant[0]);
	if (result->variants > 1) {
		list = hawser__json_array(json, json->root, "variants");
		for (int i = 0; i < result->variants; i++)
			variant_json(json, hawser__json_object(json, list, NULL), result, &result->variant[i]);
	}
	cli_warnings_json(json, *result->warning ? result->warning : NULL);
	(void)cli_stats_json(json, result->common);
}
