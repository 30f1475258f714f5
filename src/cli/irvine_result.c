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
	hawser_irvine_clear(&result->irvine);
	hawser_scene_clear(&result->scene);
	free(result->analytic);
}

double cli_irvine_in_unit(const struct cli_irvine_result *result, double omega, double H)
{
	const struct hawser_span *span = &result->irvine.span;

	switch (result->unit) {
	case CLI_RAD_S: return omega;
	case CLI_HZ: return omega/(2.0*M_PI);
	case CLI_PERIOD: return 2.0*M_PI/omega;
	default: return omega/(M_PI*sqrt(H/span->rho)/span->d);
	}
}

static const char *plane_word(const struct hawser_irvine_branch *branch)
{
	return branch->plane == HAWSER_IN_PLANE ? "in" : "out";
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

static void comments(struct hawser__table *table, const struct cli_irvine_result *result)
{
	const struct hawser_irvine *irvine = &result->irvine;
	int inserted = 0, k;

	for (k = 0; k < irvine->stations; k++)
		inserted += irvine->station[k].inserted;
	hawser__table_comment(table, "sweep: %s from %.12g to %.12g %s, %d stations (%d inserted), %d "
	                             "modal solutions", hawser_given_name(irvine->sweep),
	                      irvine->station[0].value, irvine->station[irvine->stations - 1].value,
	                      cli_irvine_si(irvine->sweep), irvine->stations, inserted,
	                      irvine->solves);
	hawser__table_comment(table, "branches: %d in plane, %d out of plane, numbered at the beginning; "
	                             "least squared correlation %.4f", irvine->in_plane,
	                      irvine->branches - irvine->in_plane, irvine->least_correlation);
	if (result->unit == CLI_NORMALISED)
		hawser__table_comment(table, "normalised: over pi*sqrt(H/rho)/d, the first frequency of a "
		                             "level string");
	if (result->common->plot && !result->overlays)
		hawser__table_comment(table, "no analytic curves in the picture: %s",
		                      cli_irvine_has_analytic() ? "they are the result itself"
		                                                : "there is no method \"analytic\"");
	for (k = 0; k < irvine->crossovers; k++)
		crossover_comment(table, irvine, &irvine->crossover[k]);
}

void cli_irvine_table(struct hawser__table *table, const struct cli_irvine_result *result)
{
	const struct hawser_irvine *irvine = &result->irvine;
	int i, b, by_tension = irvine->sweep == HAWSER_GIVEN_H;

	cli_echo_table(table, result->common, "irvine", &result->scene, irvine->method);
	comments(table, result);
	hawser__table_column(table, "%s_%s", hawser_given_name(irvine->sweep),
	                     cli_irvine_si(irvine->sweep));
	hawser__table_column(table, "irvine");
	hawser__table_column(table, "irvine_source");
	if (!by_tension)
		hawser__table_column(table, "H_N");
	hawser__table_column(table, "inserted");
	for (b = 0; b < irvine->branches; b++)
		hawser__table_column(table, "%s_%d_%s", plane_word(&irvine->branch[b]),
		                     irvine->branch[b].number, suffix[result->unit]);
	for (i = 0; i < irvine->stations; i++) {
		const struct hawser_irvine_station *station = &irvine->station[i];

		hawser__table_number(table, station->value);
		hawser__table_number(table, station->statics.irvine);
		hawser__table_number(table, station->statics.irvine_source);
		if (!by_tension)
			hawser__table_number(table, station->statics.H);
		hawser__table_number(table, station->inserted);
		for (b = 0; b < irvine->branches; b++)
			hawser__table_number(table, cli_irvine_in_unit(result,
			                                               irvine->omega[i*irvine->branches + b],
			                                               station->statics.H));
	}
}

/* --- JSON --- */

static void stations_json(struct hawser__json *json, const struct hawser_irvine *irvine)
{
	json_t *list = hawser__json_array(json, json->root, "stations");
	int i;

	for (i = 0; i < irvine->stations; i++) {
		const struct hawser_irvine_station *station = &irvine->station[i];
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_number(json, row, "value", station->value);
		hawser__json_number(json, row, "H", station->statics.H);
		hawser__json_number(json, row, "irvine", station->statics.irvine);
		hawser__json_number(json, row, "irvine_source", station->statics.irvine_source);
		hawser__json_number(json, row, "string", hawser_irvine_string(station));
		hawser__json_flag(json, row, "inserted", station->inserted);
	}
}

static void branches_json(struct hawser__json *json, const struct hawser_irvine *irvine)
{
	json_t *list = hawser__json_array(json, json->root, "branches"), *row, *column;
	int b, i;

	for (b = 0; b < irvine->branches; b++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "plane", hawser_plane_name(irvine->branch[b].plane));
		hawser__json_integer(json, row, "number", irvine->branch[b].number);
		column = hawser__json_array(json, row, "omega");
		for (i = 0; i < irvine->stations; i++)
			hawser__json_number(json, column, NULL, irvine->omega[i*irvine->branches + b]);
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

static void crossovers_json(struct hawser__json *json, const struct hawser_irvine *irvine)
{
	json_t *list = hawser__json_array(json, json->root, "crossovers"), *row, *pair;
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

void cli_irvine_json(struct hawser__json *json, const struct cli_irvine_result *result)
{
	const struct hawser_irvine *irvine = &result->irvine;
	json_t *stats;

	cli_echo_json(json, result->common, "irvine", &result->scene);
	hawser__json_text(json, json->root, "method", irvine->method);
	hawser__json_text(json, json->root, "sweep", hawser_given_name(irvine->sweep));
	hawser__json_number(json, json->root, "least_correlation", irvine->least_correlation);
	stations_json(json, irvine);
	branches_json(json, irvine);
	crossovers_json(json, irvine);
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "solves", irvine->solves);
}
