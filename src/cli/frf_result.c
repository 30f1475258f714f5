/* cli/frf_result.c - a frequency response as a table, as JSON and as a picture, in SI where the
 * model has units. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/backbone.h"
#include "cli/mms_result.h"
#include "core/report.h"

static const char axis[] = "xyz";

static double event_omega(const struct cli_frf_result *result, int k)
{
	return result->frf->event[k].omega*cli_per_omega(result->model);
}

static const char *unit(const struct cli_frf_result *result, const char *name)
{
	return result->model->rom.scaled ? name : "";
}

/* Why the curve ended, for people. */
static const char *sentence(enum hawser_frf_end end)
{
	switch (end) {
	case HAWSER_END_RANGE: return "the curve reached an end of the range";
	case HAWSER_END_RETURNED: return "the curve came back to the end of the range where it began; "
		                         "the other end was not reached";
	case HAWSER_END_CLOSED: return "the curve closed on itself";
	case HAWSER_END_MAX_POINTS: return "the limit --max-points was reached";
	case HAWSER_END_INTERRUPTED: return "interrupted; the curve is incomplete";
	case HAWSER_END_AT_REST: return "the motion shrinks to rest";
	case HAWSER_END_FAILED: return "the corrector failed; the curve is incomplete";
	}
	return "";
}

int cli_frf_slack(char *text, size_t size, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;
	int at = 0, count = 0, slower = -1;

	if (!frf->tension)
		return 0;
	for (int i = 0; i < frf->points; i++) {
		double missing = cli_speeding_tension(result->model, frf->point[i].omega);

		if (slower < 0 && frf->tension[2*i] < missing)
			slower = i;
		count += frf->tension[2*i] < 0.0;
		if (frf->tension[2*i] < frf->tension[2*at])
			at = i;
	}
	if (count == 0 && slower >= 0)
		snprintf(text, size, "slack: at Omega = %.9g%s the model's least tension is %.4g N, and the "
		         "change of speed takes about %.4g N more, which it has not: model.condense: static "
		         "and model.energy: exact have it",
		         frf->point[slower].omega*cli_per_omega(result->model), unit(result, " rad/s"),
		         frf->tension[2*slower],
		         cli_speeding_tension(result->model, frf->point[slower].omega));
	if (count == 0)
		return slower >= 0;
	snprintf(text, size, "slack: the model's tension falls to %.4g N at Omega = %.9g%s, and below "
	         "zero at %d of %d points; a cable bears no compression, so the response there is not "
	         "that of a cable", frf->tension[2*at],
	         frf->point[at].omega*cli_per_omega(result->model),
	         unit(result, " rad/s"), count, frf->points);
	return 1;
}

/* --- table --- */

static double largest_error(const struct hawser_frf *frf)
{
	double largest = 0.0;
	int i;

	for (i = 0; i < frf->points; i++)
		if (!(frf->point[i].error <= largest))
			largest = frf->point[i].error;
	return largest;
}

static void comment_event(struct hawser__table *table, const struct cli_frf_result *result, int k)
{
	const struct hawser_frf_event *event = &result->frf->event[k];
	double per_omega = cli_per_omega(result->model);
	const char *rad_s = unit(result, " rad/s");

	if (event->kind == HAWSER_UNEXPLAINED)
		hawser__table_comment(table, "event: unexplained between Omega = %.12g and %.12g%s: the "
		                      "number of unstable multipliers changes from %d to %d, and no "
		                      "located event explains it", event->bracket[0]*per_omega,
		                      event->bracket[1]*per_omega, rad_s, event->unstable[0],
		                      event->unstable[1]);
	else
		hawser__table_comment(table, "event%s: %s at Omega = %.12g%s%s (relative error %.1e)",
		                      event->located ? "" : " not located",
		                      hawser_event_name(event->kind), event_omega(result, k), rad_s,
		                      event->suspected ? " (suspected)" : "", event->error);
}

static void head(struct hawser__table *table, const struct cli_frf_result *result)
{
	char text[CLI_WARNING_SIZE];
	const struct hawser_frf *frf = result->frf;
	const struct cli_model *model = result->model;
	double per_omega = cli_per_omega(model);
	const char *rad_s = unit(result, " rad/s");
	char method[80];
	int k;

	snprintf(method, sizeof method, "%s, pseudo-arclength continuation", frf->method);
	cli_echo_table(table, result->common, result->command ? result->command : "frf",
	               model->has_scene ? &model->scene : NULL, method);
	hawser__table_comment(table, "range: Omega from %.12g to %.12g%s", result->from*per_omega,
	                      result->to*per_omega, rad_s);
	cli_choice_comments(table, model);
	cli_basis_comment(table, model);
	cli_fixed_comments(table, result);
	if (result->scales)
		cli_mms_equations(table, result->scales);
	for (k = 0; k < model->naturals; k++)
		hawser__table_comment(table, "natural frequency w%d = %.12g%s", k + 1,
		                      model->natural[k]*per_omega, rad_s);
	for (k = 0; k < frf->events; k++)
		comment_event(table, result, k);
	cli_frf_peak_comments(table, result);
	for (k = 0; k < result->sweeps; k++)
		hawser__table_comment(table, "sweep %+d: %d frequencies%s", result->sweep[k].direction,
		                      result->sweep[k].run.points,
		                      result->sweep[k].run.interrupted ? ", interrupted" : "");
	if (frf->points > 0)
		hawser__table_comment(table, "largest estimated error of a point: %.1e",
		                      largest_error(frf));
	if (frf->sampled > 0 && !isfinite(frf->sample_gap))
		hawser__table_comment(table,
		                      "%d points computed again by another method: not all were found "
		                      "again, so far are these from the model's motions", frf->sampled);
	else if (frf->sampled > 0)
		hawser__table_comment(table, "%d points computed again by another method: off by %.1e at "
		                      "most, stability %s", frf->sampled, frf->sample_gap,
		                      frf->sample_disagreements ? "NOT the same" : "the same");
	if (result->backbone)
		cli_backbone_comments(table, result);
	cli_speeding_comment(table, model, fmax(result->from, result->to));
	if (cli_frf_slack(text, sizeof text, result))
		hawser__table_comment(table, "warning: %s", text);
	hawser__table_comment(table, "end: %s - %s", hawser_frf_end_name(frf->end),
	                      sentence(frf->end));
	hawser__table_comment(table, "%d points", frf->points);
}

static void columns(struct hawser__table *table, const struct cli_frf_result *result)
{
	const struct hawser_rom *rom = &result->model->rom;
	const char *m = unit(result, "_m");
	int p, c, j;

	hawser__table_column(table, "Omega%s", unit(result, "_rad_s"));
	hawser__table_column(table, "stable");
	hawser__table_column(table, "unstable");
	for (p = 0; p < result->frf->probes; p++)
		for (c = 0; c < 3; c++)
			hawser__table_column(table, "%c_%s%s", axis[c], rom->shapes.name[p], m);
	if (result->frf->tension) {
		hawser__table_column(table, "T_min_N");
		hawser__table_column(table, "T_max_N");
	}
	for (j = 0; j < rom->n; j++)
		hawser__table_column(table, "u_%d%s", j + 1, m);
	hawser__table_column(table, "residual");
	hawser__table_column(table, "mesh");
	hawser__table_column(table, "error");
	hawser__table_column(table, "liouville");
	if (result->sweeps > 0)
		hawser__table_column(table, "sweep");
	if (result->backbone) {
		hawser__table_column(table, "backbone");
		hawser__table_column(table, "energy%s", unit(result, "_J"));
	}
}

static void scaled_cells(struct hawser__table *table, const double *numbers, int count,
                         double factor)
{
	int i;

	for (i = 0; i < count; i++)
		hawser__table_number(table, factor*numbers[i]);
}

static void blanks(struct hawser__table *table, int count)
{
	for (int k = 0; k < count; k++)
		hawser__table_word(table, "");
}

static void trace_row(struct hawser__table *table, const void *context, size_t i)
{
	const struct cli_frf_result *result = context;
	const struct hawser_frf *frf = result->frf;
	const struct hawser_frf_point *point = &frf->point[i];
	double length = cli_per_length(result->model);

	hawser__table_number(table, point->omega*cli_per_omega(result->model));
	hawser__table_number(table, point->unstable == 0);
	hawser__table_number(table, point->unstable);
	scaled_cells(table, frf->probe + i*(size_t)frf->probes*3, 3*frf->probes, length);
	if (frf->tension)
		scaled_cells(table, frf->tension + i*2, 2, 1.0);
	scaled_cells(table, frf->coordinate + i*(size_t)frf->n, frf->n, length);
	hawser__table_number(table, point->residual);
	hawser__table_number(table, point->mesh);
	hawser__table_number(table, point->error);
	hawser__table_number(table, point->liouville);
	if (result->sweeps > 0)
		hawser__table_number(table, 0);
	blanks(table, result->backbone ? 2 : 0);
}

static void backbone_rows(struct hawser__table *table, const struct cli_frf_result *result)
{
	const struct hawser_backbone *run = &result->backbone->run;
	const struct cli_model *model = result->model;
	double length = cli_per_length(model);

	for (int i = 0; i < run->points; i++) {
		const struct hawser_backbone_point *point = &run->point[i];

		hawser__table_number(table, point->omega*cli_per_omega(model));
		hawser__table_number(table, point->unstable == 0);
		hawser__table_number(table, point->unstable);
		scaled_cells(table, run->probe + (size_t)i*(size_t)run->probes*3, 3*run->probes, length);
		blanks(table, result->frf->tension ? 2 : 0);
		scaled_cells(table, run->coordinate + (size_t)i*(size_t)run->n, run->n, length);
		hawser__table_number(table, point->residual);
		hawser__table_number(table, point->mesh);
		blanks(table, result->sweeps > 0 ? 3 : 2);
		hawser__table_number(table, result->backbone->mode + 1);
		hawser__table_number(table, point->energy*(model->rom.scaled ?
		                                           model->rom.force*model->rom.length : 1.0));
	}
}

static void sweep_rows(struct hawser__table *table, const struct cli_frf_result *result,
                       const struct cli_sweep *sweep)
{
	const struct hawser_sweep *run = &sweep->run;
	double length = cli_per_length(result->model);
	int i;

	for (i = 0; i < run->points; i++) {
		hawser__table_number(table, run->omega[i]*cli_per_omega(result->model));
		hawser__table_word(table, "");
		hawser__table_word(table, "");
		scaled_cells(table, run->probe + (size_t)i*(size_t)run->probes*3, 3*run->probes, length);
		for (int k = 0; k < 2 && result->frf->tension; k++)
			hawser__table_word(table, "");
		scaled_cells(table, run->coordinate + (size_t)i*(size_t)run->n, run->n, length);
		hawser__table_number(table, run->residual[i]);
		hawser__table_word(table, "");
		hawser__table_word(table, "");
		hawser__table_word(table, "");
		hawser__table_number(table, sweep->direction);
		blanks(table, result->backbone ? 2 : 0);
	}
}

void cli_frf_table(struct hawser__table *table, const void *of)
{
	const struct cli_frf_result *result = of;
	int k;

	head(table, result);
	columns(table, result);
	hawser__table_rows(table, (size_t)result->frf->points, trace_row, result);
	for (k = 0; k < result->sweeps; k++)
		sweep_rows(table, result, &result->sweep[k]);
	if (result->backbone)
		backbone_rows(table, result);
}

/* --- JSON --- */

static void multipliers_json(struct hawser__json *json, json_t *into, const double *multiplier,
                             int count)
{
	json_t *list = hawser__json_array(json, into, "multipliers"), *row;
	int i;

	for (i = 0; i < count; i++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "log_modulus", multiplier[2*i]);
		hawser__json_number(json, row, "argument", multiplier[2*i + 1]);
	}
}

static void point_json(struct hawser__json *json, json_t *list, const void *context, int part,
                       size_t i)
{
	const struct cli_frf_result *result = context;
	const struct hawser_frf *frf = result->frf;
	const struct hawser_frf_point *point = &frf->point[i];
	json_t *row = hawser__json_object(json, list, NULL), *certificate;
	size_t n = (size_t)frf->n;

	(void)part;
	hawser__json_number(json, row, "Omega", point->omega*cli_per_omega(result->model));
	hawser__json_flag(json, row, "stable", point->unstable == 0);
	hawser__json_integer(json, row, "unstable", point->unstable);
	cli_amplitude_json(json, row, result->model, frf->probe + i*(size_t)frf->probes*3);
	hawser__json_numbers(json, row, "coordinates", frf->coordinate + i*n, frf->n,
	                     cli_per_length(result->model));
	if (frf->tension)
		cli_tension_json(json, row, frf->tension[2*i], frf->tension[2*i + 1]);
	certificate = hawser__json_object(json, row, "certificate");
	hawser__json_number(json, certificate, "residual", point->residual);
	hawser__json_number(json, certificate, "mesh", point->mesh);
	hawser__json_number(json, certificate, "error", point->error);
	hawser__json_number(json, certificate, "liouville", point->liouville);
	hawser__json_number(json, row, "arc", point->arc);
	hawser__json_integer(json, row, "iterations", point->iterations);
	hawser__json_integer(json, row, "steps", point->steps);
	cli_state_json(json, row, result->model, frf->state + i*2*n);
	if (result->multipliers)
		multipliers_json(json, row, frf->multiplier + i*4*n, 2*frf->n);
}

static void sample_json(struct hawser__json *json, const struct hawser_frf *frf)
{
	json_t *sample = hawser__json_object(json, json->root, "sample");

	hawser__json_integer(json, sample, "points", frf->sampled);
	if (isfinite(frf->sample_gap))
		hawser__json_number(json, sample, "gap", frf->sample_gap);
	else
		hawser__json_null(json, sample, "gap"); /* not all were found again */
	hawser__json_integer(json, sample, "disagreements", frf->sample_disagreements);
}

static void events_json(struct hawser__json *json, const struct cli_frf_result *result)
{
	json_t *list = hawser__json_array(json, json->root, "events"), *row;
	int k;

	for (k = 0; k < result->frf->events; k++) {
		const struct hawser_frf_event *event = &result->frf->event[k];

		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "kind", hawser_event_name(event->kind));
		hawser__json_number(json, row, "Omega", event_omega(result, k));
		hawser__json_number(json, row, "residual", event->residual);
		hawser__json_number(json, row, "error", event->error);
		hawser__json_flag(json, row, "suspected", event->suspected);
		hawser__json_flag(json, row, "located", event->located);
		hawser__json_integer(json, row, "after", event->after);
		hawser__json_numbers(json, row, "bracket", event->bracket, 2,
		                     cli_per_omega(result->model));
		hawser__json_integer(json, row, "unstable_before", event->unstable[0]);
		hawser__json_integer(json, row, "unstable_after", event->unstable[1]);
	}
}

static void sweeps_json(struct hawser__json *json, const struct cli_frf_result *result)
{
	json_t *list = hawser__json_array(json, json->root, "sweeps"), *row, *points, *point;
	int k, i;

	for (k = 0; k < result->sweeps; k++) {
		const struct hawser_sweep *run = &result->sweep[k].run;

		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "direction", result->sweep[k].direction > 0 ? "up" : "down");
		hawser__json_flag(json, row, "interrupted", run->interrupted);
		points = hawser__json_array(json, row, "points");
		for (i = 0; i < run->points; i++) {
			point = hawser__json_object(json, points, NULL);
			hawser__json_number(json, point, "Omega", run->omega[i]*cli_per_omega(result->model));
			cli_amplitude_json(json, point, result->model,
			                   run->probe + (size_t)i*(size_t)run->probes*3);
			hawser__json_numbers(json, point, "coordinates",
			                     run->coordinate + (size_t)i*(size_t)run->n, run->n,
			                     cli_per_length(result->model));
			hawser__json_number(json, point, "residual", run->residual[i]);
		}
	}
}

static void stats_json(struct hawser__json *json, const struct cli_frf_result *result)
{
	const struct hawser_orbit_cost *cost = &result->frf->cost;
	json_t *stats = cli_stats_json(json, result->common);

	hawser__json_integer(json, stats, "points", result->frf->points);
	hawser__json_integer(json, stats, "maps", cost->maps);
	hawser__json_integer(json, stats, "flows", cost->flows);
	hawser__json_integer(json, stats, "stages", cost->stages);
	hawser__json_integer(json, stats, "solves", cost->solves);
}

void cli_frf_json(struct hawser__json *json, const void *of)
{
	const struct cli_frf_result *result = of;
	const struct cli_model *model = result->model;
	double per_omega = cli_per_omega(model);
	const double ends[] = {result->from, result->to};
	char text[CLI_WARNING_SIZE];

	cli_echo_json(json, result->common, result->command ? result->command : "frf",
	              model->has_scene ? &model->scene : NULL);
	if (result->scales)
		cli_mms_equations_json(json, result->scales);
	hawser__json_flag(json, json->root, "si", model->rom.scaled);
	hawser__json_numbers(json, json->root, "range", ends, 2, per_omega);
	hawser__json_numbers(json, json->root, "natural_frequencies", model->natural, model->naturals,
	                     per_omega);
	cli_choice_json(json, model, result->common);
	cli_fixed_json(json, result);
	hawser__json_list(json, json->root, "points", (size_t)result->frf->points, point_json, result, 0);
	events_json(json, result);
	if (result->located)
		cli_frf_peaks_json(json, result);
	cli_basis_json(json, result->model);
	cli_warnings_json(json, cli_frf_slack(text, sizeof text, result) ? text : NULL);
	if (result->sweeps > 0)
		sweeps_json(json, result);
	if (result->backbone)
		cli_backbone_json(json, result);
	hawser__json_text(json, json->root, "method", result->frf->method);
	if (result->frf->sampled > 0)
		sample_json(json, result->frf);
	hawser__json_text(json, json->root, "end", hawser_frf_end_name(result->frf->end));
	if (result->frf->points > 0)
		hawser__json_integer(json, json->root, "direction",
		                     result->frf->point[result->frf->points - 1].direction);
	stats_json(json, result);
}
