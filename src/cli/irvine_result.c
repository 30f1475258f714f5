/* cli/irvine_result.c - a sweep's table and JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "cli/irvine_result.h"

const char *const cli_irvine_units[] = {"normalised", "rad/s", "Hz", "s"};
static const char *const suffix[] = {"normalised", "rad_s", "Hz", "s"};

const char *cli_irvine_si(enum hawser_given sweep)
{
	return sweep == HAWSER_GIVEN_LENGTH0 || sweep == HAWSER_GIVEN_SAG ? "m" : "N";
}

void cli_irvine_free(struct cli_irvine_result *result)
{
	int k;

	for (k = 0; k < result->sweeps; k++) {
		hawser_irvine_clear(&result->sweep[k].irvine);
		free(result->sweep[k].analytic);
	}
	hawser_scene_clear(&result->scene);
}

double cli_irvine_tension(const struct hawser_irvine_station *station)
{
	return hawser_irvine_value(&station->statics, HAWSER_GIVEN_H);
}

double cli_irvine_in_unit(const struct cli_irvine_result *result, double omega, double H)
{
	const struct hawser_span *span = &result->sweep[0].irvine.span;

	switch (result->unit) {
	case CLI_RAD_S: return omega;
	case CLI_HZ: return omega/(2.0*M_PI);
	case CLI_PERIOD: return 2.0*M_PI/omega;
	default: return omega/(M_PI*sqrt(H/span->rho)/span->d);
	}
}

/* --- the table --- */

static void crossover_comment(struct hawser__table *table, const struct hawser_irvine *irvine,
                              const struct hawser_irvine_crossover *at)
{
	char value[64] = "";

	if (irvine->sweep != HAWSER_GIVEN_H)
		snprintf(value, sizeof value, "%s = %.10g %s, ", hawser_given_name(irvine->sweep),
		         at->value, cli_irvine_si(irvine->sweep));
	hawser__table_comment(table, "%s: in-plane branches %d and %d, %sH = %.10g N, irvine = %.10g, "
	                             "irvine_source = %.10g, omega = %.10g rad/s, gap = %.3g rad/s "
	                             "(relative %.3g)", hawser_crossover_name(at->kind), at->below,
	                      at->above, value, at->H, at->irvine, at->irvine_source, at->omega,
	                      at->gap, at->relative_gap);
}

static double largest_error(const struct hawser_irvine *irvine)
{
	double largest = 0.0;

	for (int k = 0; k < irvine->stations*irvine->branches; k++)
		largest = fmax(largest, irvine->residual[k]);
	return largest;
}

static void comments(struct hawser__table *table, const struct cli_irvine_result *result,
                     const struct cli_irvine_sweep *sweep)
{
	const struct hawser_irvine *irvine = &sweep->irvine;
	int inserted = 0, k;

	for (k = 0; k < irvine->stations; k++)
		inserted += irvine->station[k].inserted;
	if (result->moving)
		hawser__table_comment(table, "speed = %.12g m/s, fluctuation = %.12g m/s: H, T0, T1 and "
		                             "length0 are those of the steady state, both irvine those of "
		                             "the apparent cable", irvine->speed, irvine->fluctuation);
	hawser__table_comment(table, "sweep: %s from %.12g to %.12g %s, %d stations (%d inserted), %d "
	                             "modal solutions", hawser_given_name(irvine->sweep),
	                      irvine->station[0].value, irvine->station[irvine->stations - 1].value,
	                      cli_irvine_si(irvine->sweep), irvine->stations, inserted,
	                      irvine->solves);
	hawser__table_comment(table, "branches: %d in plane, %d out of plane, numbered at the beginning; "
	                             "least squared correlation %.4f", irvine->in_plane,
	                      irvine->branches - irvine->in_plane, irvine->least_correlation);
	if (result->unit == CLI_NORMALISED && sweep == result->sweep)
		hawser__table_comment(table, "normalised: over pi*sqrt(H/rho)/d, the first frequency of a "
		                             "level string%s", result->moving ? " at rest" : "");
	if (result->common->plot && !sweep->overlays)
		hawser__table_comment(table, "no analytic curves in the picture: %s",
		                      cli_irvine_has_analytic(irvine)
		                          ? "they are the result itself"
		                          : "there is no method \"analytic\"");
	hawser__table_comment(table, "largest estimated relative error of a frequency: %.1e",
	                      largest_error(irvine));
	for (k = 0; k < irvine->crossovers; k++)
		crossover_comment(table, irvine, &irvine->crossover[k]);
}

/* Branches of one plane in the sweep that has most of them. */
static int most(const struct cli_irvine_result *result, enum hawser_plane plane)
{
	int count = 0, k;

	for (k = 0; k < result->sweeps; k++) {
		const struct hawser_irvine *irvine = &result->sweep[k].irvine;
		int here = plane == HAWSER_IN_PLANE ? irvine->in_plane
		                                    : irvine->branches - irvine->in_plane;

		count = here > count ? here : count;
	}
	return count;
}

static void columns(struct hawser__table *table, const struct cli_irvine_result *result)
{
	enum hawser_given sweep = result->sweep[0].irvine.sweep;
	int plane, b;

	if (result->moving)
		hawser__table_column(table, "speed_m_s");
	hawser__table_column(table, "%s_%s", hawser_given_name(sweep), cli_irvine_si(sweep));
	hawser__table_column(table, "irvine");
	hawser__table_column(table, "irvine_source");
	if (sweep != HAWSER_GIVEN_H)
		hawser__table_column(table, "H_N");
	hawser__table_column(table, "inserted");
	for (plane = HAWSER_IN_PLANE; plane <= HAWSER_OUT_OF_PLANE; plane++)
		for (b = 0; b < most(result, (enum hawser_plane)plane); b++)
			hawser__table_column(table, "%s_%d_%s", plane == HAWSER_IN_PLANE ? "in" : "out",
			                     b + 1, suffix[result->unit]);
}

/* Branches first..end-1, in so many columns. */
static void frequencies(struct hawser__table *table, const struct cli_irvine_result *result,
                        const struct hawser_irvine *irvine, int i, int first, int end, int wide)
{
	int b;

	for (b = first; b < first + wide; b++)
		if (b < end)
			hawser__table_number(table, cli_irvine_in_unit(
				result, irvine->omega[i*irvine->branches + b],
				cli_irvine_tension(&irvine->station[i])));
		else
			hawser__table_word(table, "");
}

static void rows(struct hawser__table *table, const struct cli_irvine_result *result,
                 const struct hawser_irvine *irvine)
{
	int in = most(result, HAWSER_IN_PLANE), out = most(result, HAWSER_OUT_OF_PLANE), i;

	for (i = 0; i < irvine->stations; i++) {
		const struct hawser_irvine_station *station = &irvine->station[i];

		if (result->moving)
			hawser__table_number(table, irvine->speed);
		hawser__table_number(table, station->value);
		hawser__table_number(table, station->statics.irvine);
		hawser__table_number(table, station->statics.irvine_source);
		if (irvine->sweep != HAWSER_GIVEN_H)
			hawser__table_number(table, cli_irvine_tension(station));
		hawser__table_number(table, station->inserted);
		frequencies(table, result, irvine, i, 0, irvine->in_plane, in);
		frequencies(table, result, irvine, i, irvine->in_plane, irvine->branches, out);
	}
}

void cli_irvine_table(struct hawser__table *table, const void *of)
{
	const struct cli_irvine_result *result = of;
	int k;

	cli_echo_table(table, result->common, "irvine", &result->scene,
	               result->sweep[0].irvine.method);
	for (k = 0; k < result->sweeps; k++)
		comments(table, result, &result->sweep[k]);
	columns(table, result);
	for (k = 0; k < result->sweeps; k++)
		rows(table, result, &result->sweep[k].irvine);
}

/* --- JSON --- */

static void stations_json(struct hawser__json *json, json_t *into,
                          const struct hawser_irvine *irvine)
{
	json_t *list = hawser__json_array(json, into, "stations");
	int i;

	for (i = 0; i < irvine->stations; i++) {
		const struct hawser_irvine_station *station = &irvine->station[i];
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_number(json, row, "value", station->value);
		hawser__json_number(json, row, "H", cli_irvine_tension(station));
		hawser__json_number(json, row, "irvine", station->statics.irvine);
		hawser__json_number(json, row, "irvine_source", station->statics.irvine_source);
		hawser__json_number(json, row, "string", hawser_irvine_string(station));
		hawser__json_flag(json, row, "inserted", station->inserted);
	}
}

static void branches_json(struct hawser__json *json, json_t *into,
                          const struct hawser_irvine *irvine)
{
	json_t *list = hawser__json_array(json, into, "branches"), *row, *column;
	int b, i;

	for (b = 0; b < irvine->branches; b++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "plane", hawser_plane_name(irvine->branch[b].plane));
		hawser__json_integer(json, row, "number", irvine->branch[b].number);
		column = hawser__json_array(json, row, "omega");
		for (i = 0; i < irvine->stations; i++)
			hawser__json_number(json, column, NULL, irvine->omega[i*irvine->branches + b]);
		column = hawser__json_array(json, row, "residual");
		for (i = 0; i < irvine->stations; i++)
			hawser__json_number(json, column, NULL, irvine->residual[i*irvine->branches + b]);
		column = hawser__json_array(json, row, "symmetry");
		for (i = 0; i < irvine->stations; i++)
			hawser__json_text(json, column, NULL,
			                  hawser_symmetry_name(irvine->symmetry[i*irvine->branches + b]));
		column = hawser__json_array(json, row, "family");
		for (i = 0; i < irvine->stations; i++)
			hawser__json_text(json, column, NULL,
			                  hawser_family_name(irvine->family[i*irvine->branches + b]));
	}
}

static void crossovers_json(struct hawser__json *json, json_t *into,
                            const struct hawser_irvine *irvine)
{
	json_t *list = hawser__json_array(json, into, "crossovers"), *row, *pair;
	int k;

	for (k = 0; k < irvine->crossovers; k++) {
		const struct hawser_irvine_crossover *at = &irvine->crossover[k];

		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "kind", hawser_crossover_name(at->kind));
		hawser__json_text(json, row, "plane", hawser_plane_name(HAWSER_IN_PLANE));
		pair = hawser__json_array(json, row, "numbers");
		hawser__json_integer(json, pair, NULL, at->below);
		hawser__json_integer(json, pair, NULL, at->above);
		hawser__json_number(json, row, "value", at->value);
		hawser__json_number(json, row, "H", at->H);
		hawser__json_number(json, row, "irvine", at->irvine);
		hawser__json_number(json, row, "irvine_source", at->irvine_source);
		hawser__json_number(json, row, "omega", at->omega);
		hawser__json_number(json, row, "gap", at->gap);
		hawser__json_number(json, row, "relative_gap", at->relative_gap);
	}
}

static void sweep_json(struct hawser__json *json, json_t *into, const struct hawser_irvine *irvine)
{
	hawser__json_number(json, into, "speed", irvine->speed);
	hawser__json_number(json, into, "least_correlation", irvine->least_correlation);
	stations_json(json, into, irvine);
	branches_json(json, into, irvine);
	crossovers_json(json, into, irvine);
}

/* One sweep is the result itself; several are a list. */
void cli_irvine_json(struct hawser__json *json, const void *of)
{
	const struct cli_irvine_result *result = of;
	const struct hawser_irvine *first = &result->sweep[0].irvine;
	json_t *stats, *list;
	int solves = 0, k;

	cli_echo_json(json, result->common, "irvine", &result->scene);
	hawser__json_text(json, json->root, "method", first->method);
	hawser__json_text(json, json->root, "sweep", hawser_given_name(first->sweep));
	if (result->sweeps == 1) {
		sweep_json(json, json->root, first);
	} else {
		list = hawser__json_array(json, json->root, "diagrams");
		for (k = 0; k < result->sweeps; k++)
			sweep_json(json, hawser__json_object(json, list, NULL),
			           &result->sweep[k].irvine);
	}
	for (k = 0; k < result->sweeps; k++)
		solves += result->sweep[k].irvine.solves;
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "solves", solves);
}
