/* cli/campbell_result.c - a Campbell diagram's table and JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "cli/campbell_result.h"

const char *const cli_campbell_units[2] = {"rad/s", "Hz"};
static const char *const suffix[] = {"rad_s", "Hz"};

double cli_campbell_in_unit(const struct cli_campbell_result *result, double omega)
{
	return result->hertz ? omega/(2.0*M_PI) : omega;
}

void cli_campbell_free(struct cli_campbell_result *result)
{
	hawser_campbell_clear(&result->campbell);
	hawser_scene_clear(&result->scene);
	free(result->resonance);
}

static const char *plane_word(const struct hawser_irvine_branch *branch)
{
	return branch->plane == HAWSER_IN_PLANE ? "in" : "out";
}

/* --- the table --- */

static void crossover_comments(struct hawser__table *table, const struct hawser_campbell *campbell)
{
	int k;

	for (k = 0; k < campbell->crossovers; k++) {
		const struct hawser_campbell_crossover *at = &campbell->crossover[k];

		hawser__table_comment(table, "%s: in-plane branches %d and %d, speed = %.10g m/s, omega = "
		                             "%.10g rad/s, gap = %.3g rad/s (relative %.3g)",
		                      hawser_crossover_name(at->kind), at->below, at->above, at->speed,
		                      at->omega, at->gap, at->relative_gap);
	}
}

static void resonance_comments(struct hawser__table *table, const struct cli_campbell_result *result)
{
	int k;

	if (result->harmonics > 0)
		hawser__table_comment(table, "excitation: n*2*pi*v/%.10g m, n up to %d; meetings with the "
		                             "branches are interpolated", result->spacing,
		                      result->harmonics);
	for (k = 0; k < result->resonances; k++) {
		const struct hawser_campbell_resonance *at = &result->resonance[k];

		hawser__table_comment(table, "resonance: harmonic %d with %s %d at %.8g m/s, omega = %.8g "
		                             "rad/s", at->harmonic,
		                      plane_word(&result->campbell.branch[at->branch]),
		                      result->campbell.branch[at->branch].number, at->speed, at->omega);
	}
}

static void comments(struct hawser__table *table, const struct cli_campbell_result *result)
{
	const struct hawser_campbell *campbell = &result->campbell;
	int inserted = 0, k;

	for (k = 0; k < campbell->stations; k++)
		inserted += campbell->station[k].inserted;
	hawser__table_comment(table, "sweep: speed from %.12g to %.12g m/s with the %s held, %d stations "
	                             "(%d inserted), %d modal solutions", campbell->station[0].speed,
	                      campbell->station[campbell->stations - 1].speed,
	                      result->scene.travel.hold == HAWSER_HOLD_LENGTH ? "length" : "tension",
	                      campbell->stations, inserted, campbell->solves);
	hawser__table_comment(table, "travel.speed of the scene is not used; travel.fluctuation = %.10g "
	                             "m/s is, by its mean square", result->scene.travel.fluctuation);
	if (result->scene.damping.kind != HAWSER_DAMPING_NONE)
		hawser__table_comment(table, "the scene's damping is left out: eigenvalues of the undamped "
		                             "cable");
	hawser__table_comment(table, "limit = %.12g m/s, end of the steady state", campbell->limit);
	for (k = 0; k < campbell->criticals; k++)
		hawser__table_comment(table, "critical: %s at %.12g m/s, %s",
		                      hawser_critical_name(campbell->critical[k].kind),
		                      campbell->critical[k].speed,
		                      hawser_plane_name(campbell->critical[k].plane));
	hawser__table_comment(table, "branches: %d in plane, %d out of plane, numbered at the beginning; "
	                             "least squared correlation %.4f; %d stations where they could not "
	                             "be told apart", campbell->in_plane,
	                      campbell->branches - campbell->in_plane, campbell->least_correlation,
	                      campbell->unsure);
	crossover_comments(table, campbell);
	resonance_comments(table, result);
}

void cli_campbell_table(struct hawser__table *table, const void *of)
{
	const struct cli_campbell_result *result = of;
	const struct hawser_campbell *campbell = &result->campbell;
	int i, b;

	cli_echo_table(table, result->common, "campbell", &result->scene, campbell->method);
	comments(table, result);
	hawser__table_column(table, "speed_m_s");
	hawser__table_column(table, "plane");
	hawser__table_column(table, "branch");
	hawser__table_column(table, "re_%s", suffix[result->hertz]);
	hawser__table_column(table, "im_%s", suffix[result->hertz]);
	hawser__table_column(table, "place");
	hawser__table_column(table, "family");
	hawser__table_column(table, "downstream");
	hawser__table_column(table, "residual");
	hawser__table_column(table, "inserted");
	for (i = 0; i < campbell->stations; i++)
		for (b = 0; b < campbell->branches; b++) {
			int at = i*campbell->branches + b;

			hawser__table_number(table, campbell->station[i].speed);
			hawser__table_word(table, plane_word(&campbell->branch[b]));
			hawser__table_number(table, campbell->branch[b].number);
			hawser__table_number(table, cli_campbell_in_unit(result, campbell->re[at]));
			hawser__table_number(table, cli_campbell_in_unit(result, campbell->im[at]));
			hawser__table_number(table, campbell->place[at] + 1);
			hawser__table_word(table, hawser_family_name(campbell->family[at]));
			hawser__table_number(table, campbell->downstream[at]);
			hawser__table_number(table, campbell->residual[at]);
			hawser__table_number(table, campbell->station[i].inserted);
		}
}

/* --- JSON --- */

static void eigenvalues_json(struct hawser__json *json, json_t *row,
                             const struct hawser_campbell *campbell, int i)
{
	json_t *list = hawser__json_array(json, row, "eigenvalues"), *one;
	int b;

	for (b = 0; b < campbell->branches; b++) {
		int at = i*campbell->branches + b;

		one = hawser__json_object(json, list, NULL);
		hawser__json_number(json, one, "re", campbell->re[at]);
		hawser__json_number(json, one, "im", campbell->im[at]);
		hawser__json_text(json, one, "plane", hawser_plane_name(campbell->branch[b].plane));
		hawser__json_integer(json, one, "branch", campbell->branch[b].number);
		hawser__json_integer(json, one, "place", campbell->place[at] + 1);
		hawser__json_text(json, one, "family", hawser_family_name(campbell->family[at]));
		hawser__json_number(json, one, "downstream", campbell->downstream[at]);
		hawser__json_number(json, one, "residual", campbell->residual[at]);
	}
}

static void speeds_json(struct hawser__json *json, const struct hawser_campbell *campbell)
{
	json_t *list = hawser__json_array(json, json->root, "speeds"), *row;
	int i;

	for (i = 0; i < campbell->stations; i++) {
		const struct hawser_campbell_station *station = &campbell->station[i];
		struct hawser_statics actual = hawser_statics_actual(&station->statics);

		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "speed", station->speed);
		hawser__json_number(json, row, "nu", station->statics.motion.nu);
		hawser__json_number(json, row, "T0", actual.T0);
		hawser__json_number(json, row, "apparent_H", station->statics.H);
		hawser__json_number(json, row, "sag", station->statics.sag);
		hawser__json_flag(json, row, "inserted", station->inserted);
		hawser__json_flag(json, row, "unsure", station->unsure);
		eigenvalues_json(json, row, campbell, i);
	}
}

static void critical_json(struct hawser__json *json, const struct hawser_campbell *campbell)
{
	json_t *list = hawser__json_array(json, json->root, "critical"), *row;
	int k;

	hawser__json_number(json, json->root, "limit", campbell->limit);
	for (k = 0; k < campbell->criticals; k++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "speed", campbell->critical[k].speed);
		hawser__json_text(json, row, "kind", hawser_critical_name(campbell->critical[k].kind));
		hawser__json_text(json, row, "plane", hawser_plane_name(campbell->critical[k].plane));
	}
}

static void crossovers_json(struct hawser__json *json, const struct hawser_campbell *campbell)
{
	json_t *list = hawser__json_array(json, json->root, "crossovers"), *row, *pair;
	int k;

	for (k = 0; k < campbell->crossovers; k++) {
		const struct hawser_campbell_crossover *at = &campbell->crossover[k];

		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "kind", hawser_crossover_name(at->kind));
		hawser__json_text(json, row, "plane", hawser_plane_name(HAWSER_IN_PLANE));
		pair = hawser__json_array(json, row, "numbers");
		hawser__json_integer(json, pair, NULL, at->below);
		hawser__json_integer(json, pair, NULL, at->above);
		hawser__json_number(json, row, "speed", at->speed);
		hawser__json_number(json, row, "omega", at->omega);
		hawser__json_number(json, row, "gap", at->gap);
		hawser__json_number(json, row, "relative_gap", at->relative_gap);
	}
}

static void resonances_json(struct hawser__json *json, const struct cli_campbell_result *result)
{
	json_t *list, *row;
	int k;

	if (result->harmonics == 0)
		return;
	hawser__json_number(json, json->root, "spacing", result->spacing);
	list = hawser__json_array(json, json->root, "resonances");
	for (k = 0; k < result->resonances; k++) {
		const struct hawser_campbell_resonance *at = &result->resonance[k];
		const struct hawser_irvine_branch *branch = &result->campbell.branch[at->branch];

		row = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, row, "harmonic", at->harmonic);
		hawser__json_text(json, row, "plane", hawser_plane_name(branch->plane));
		hawser__json_integer(json, row, "branch", branch->number);
		hawser__json_number(json, row, "speed", at->speed);
		hawser__json_number(json, row, "omega", at->omega);
	}
}

void cli_campbell_json(struct hawser__json *json, const void *of)
{
	const struct cli_campbell_result *result = of;
	const struct hawser_campbell *campbell = &result->campbell;
	json_t *stats;

	cli_echo_json(json, result->common, "campbell", &result->scene);
	hawser__json_text(json, json->root, "method", campbell->method);
	hawser__json_number(json, json->root, "least_correlation", campbell->least_correlation);
	hawser__json_integer(json, json->root, "unsure", campbell->unsure);
	critical_json(json, campbell);
	crossovers_json(json, campbell);
	resonances_json(json, result);
	speeds_json(json, campbell);
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "solves", campbell->solves);
	hawser__json_integer(json, stats, "basis", campbell->basis);
}
