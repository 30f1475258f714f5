/* cli/folds_result.c - fold curves as a table and as JSON, in SI where the model has units.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "core/report.h"

static const char axis[] = "xyz";

static const char *unit(const struct cli_folds_result *result, const char *name)
{
	return result->model->rom.scaled ? name : "";
}

/* --- table --- */

/* ", load.per_length 0.61, 0.61, 0.61 N/m" for a scene's load at this factor, else "". */
static void load_text(char *text, size_t size, const struct cli_folds_result *result,
                      double factor)
{
	const struct hawser_scene *scene = &result->model->scene;
	const double *f = scene->load.per_length;

	text[0] = '\0';
	if (result->model->has_scene && scene->load.present)
		snprintf(text, size, " (%.6g, %.6g, %.6g N/m)", factor*f[0], factor*f[1], factor*f[2]);
}

static const char *meaning(const struct hawser_folds_event *event)
{
	switch (event->kind) {
	case HAWSER_FOLDS_CUSP:
		return event->minimum > 0 ? "two folds appear as the load grows: jumps begin"
		                          : "two folds vanish as the load grows";
	case HAWSER_FOLDS_ISOLA:
		return event->minimum > 0 ? "a closed response curve appears as the load grows"
		                          : "a closed response curve vanishes as the load grows";
	case HAWSER_FOLDS_BIFURCATION:
		return event->minimum > 0 ? "two response curves part as the load grows"
		                          : "two response curves join as the load grows";
	default:
		return "";
	}
}

static void comment_event(struct hawser__table *table, const struct cli_folds_result *result, int c,
                          int e)
{
	const struct hawser_folds_event *event = &result->folds->event[e];
	char load[96];

	if (event->kind == HAWSER_FOLDS_NOMINAL)
		return;
	load_text(load, sizeof load, result, event->load);
	hawser__table_comment(table, "curve %d: %s at Omega = %.12g%s, load factor %.12g%s: %s", c + 1,
	                      hawser_folds_kind_name(event->kind),
	                      event->omega*cli_per_omega(result->model), unit(result, " rad/s"),
	                      event->load, load, meaning(event));
}

static void comment_curve(struct hawser__table *table, const struct cli_folds_result *result, int c)
{
	const struct hawser_folds_curve *curve = &result->folds->curve[c];
	char load[96];
	int e;

	for (e = curve->first_event; e < curve->first_event + curve->events; e++)
		comment_event(table, result, c, e);
	load_text(load, sizeof load, result, curve->least_load);
	hawser__table_comment(table, "curve %d: folds from load factor %.12g%s upward (%s); ends: %s, "
	                      "%s%s%s", c + 1, curve->least_load, load,
	                      curve->least_event >= 0
	                      ? hawser_folds_kind_name(result->folds->event[curve->least_event].kind)
	                      : "the end of the curve", hawser_folds_end_name(curve->end[0]),
	                      hawser_folds_end_name(curve->end[1]), *curve->message ? ": " : "",
	                      curve->message);
}

/* The least load with a fold, what it is, and what was searched for it. */
static void comment_least(struct hawser__table *table, const struct cli_folds_result *result)
{
	const struct hawser_folds *folds = result->folds;
	double per_omega = cli_per_omega(result->model);
	const char *rad_s = unit(result, " rad/s");
	char load[96];

	if (folds->curves == 0)
		return;
	load_text(load, sizeof load, result, folds->least_load);
	if (folds->interrupted)
		hawser__table_comment(table, "jumps: at load factor %.12g%s already, by the curves so far",
		                      folds->least_load, load);
	else if (folds->least_kind == HAWSER_FOLDS_LEAST_BOUND)
		hawser__table_comment(table, "jumps: at load factor %.12g%s already, at Omega = %.12g%s: a "
		                      "bound, for the search at lower loads is incomplete",
		                      folds->least_load, load, folds->least_omega*per_omega, rad_s);
	else if (folds->least_kind == HAWSER_FOLDS_LEAST_LOAD)
		hawser__table_comment(table, "jumps: at load factor %.12g%s already, the smallest one asked "
		                      "for, at Omega = %.12g%s: lower --load-from to see where they begin",
		                      folds->least_load, load, folds->least_omega*per_omega, rad_s);
	else
		hawser__table_comment(table, "jumps begin at load factor %.12g%s, at Omega = %.12g%s (%s)",
		                      folds->least_load, load, folds->least_omega*per_omega, rad_s,
		                      hawser_folds_least_name(folds->least_kind));
	for (int i = 0; i < folds->levels; i++)
		hawser__table_comment(table, "searched: load factor %.6g, Omega from %.6g to %.6g%s, from "
		                      "both ends: %d folds", folds->level[i].load,
		                      folds->level[i].from*per_omega, folds->level[i].to*per_omega, rad_s,
		                      folds->level[i].folds);
	if (folds->nearly_linear)
		hawser__table_comment(table, "searched: the last of these responses is nearly linear");
}

static void comment_lost(struct hawser__table *table, const struct cli_folds_result *result)
{
	const struct hawser_folds *folds = result->folds;

	for (int i = 0; i < folds->lost; i++)
		hawser__table_comment(table, "not followed: the fold at Omega = %.12g%s, load factor %.6g: "
		                      "no curve could be begun there; where no other one passes it, change "
		                      "%s a little",
		                      folds->lost_at[i].omega*cli_per_omega(result->model),
		                      unit(result, " rad/s"), folds->lost_at[i].load,
		                      folds->lost_at[i].load == 1.0 ? "--tolerance" : "--load-to");
}

static void head(struct hawser__table *table, const struct cli_folds_result *result)
{
	const struct hawser_folds *folds = result->folds;
	const struct cli_model *model = result->model;
	double per_omega = cli_per_omega(model);
	const char *rad_s = unit(result, " rad/s");
	int c, e, i;

	cli_echo_table(table, result->common, "folds", model->has_scene ? &model->scene : NULL,
	               "harmonic balance, minimally augmented fold, pseudo-arclength continuation");
	hawser__table_comment(table, "range: Omega from %.12g to %.12g%s, load factor from %.12g to "
	                      "%.12g", result->from*per_omega, result->to*per_omega, rad_s,
	                      result->load_from, result->load_to);
	cli_choice_comments(table, model);
	cli_basis_comment(table, model);
	for (c = 0; c < folds->curves; c++)
		comment_curve(table, result, c);
	comment_least(table, result);
	for (i = 0; i < folds->isolas; i++) {
		const struct hawser_frf *frf = &folds->isola[i];

		hawser__table_comment(table, "detached response curve %d at the model's load: %d points, "
		                      "%s", i + 1, frf->points, hawser_frf_end_name(frf->end));
		for (e = 0; e < frf->events; e++)
			hawser__table_comment(table, "detached response curve %d: %s at Omega = %.12g%s",
			                      i + 1, hawser_event_name(frf->event[e].kind),
			                      frf->event[e].omega*per_omega, rad_s);
	}
	comment_lost(table, result);
	if (folds->note[0])
		hawser__table_comment(table, "note: %s", folds->note);
	if (folds->interrupted)
		hawser__table_comment(table, "interrupted: the curves are incomplete");
	hawser__table_comment(table, "%d curves, %d points", folds->curves, folds->points);
}

static void columns(struct hawser__table *table, const struct cli_folds_result *result)
{
	const struct hawser_rom *rom = &result->model->rom;
	const char *m = unit(result, "_m");
	int p, c, j;

	hawser__table_column(table, "curve");
	hawser__table_column(table, "Omega%s", unit(result, "_rad_s"));
	hawser__table_column(table, "load_factor");
	hawser__table_column(table, "kind");
	for (p = 0; p < result->folds->probes; p++)
		for (c = 0; c < 3; c++)
			hawser__table_column(table, "%c_%s%s", axis[c], rom->shapes.name[p], m);
	for (j = 0; j < rom->n; j++)
		hawser__table_column(table, "u_%d%s", j + 1, m);
	hawser__table_column(table, "residual");
	hawser__table_column(table, "truncation");
	hawser__table_column(table, "harmonics");
}

static void point_row(struct hawser__table *table, const struct cli_folds_result *result, int c,
                      size_t i)
{
	const struct hawser_folds *folds = result->folds;
	const struct hawser_folds_point *point = &folds->point[i];
	double length = cli_per_length(result->model);
	size_t n = (size_t)folds->n, probes = 3*(size_t)folds->probes, k;

	hawser__table_number(table, c + 1);
	hawser__table_number(table, point->omega*cli_per_omega(result->model));
	hawser__table_number(table, point->load);
	hawser__table_word(table, "fold");
	for (k = 0; k < probes; k++)
		hawser__table_number(table, length*folds->probe[i*probes + k]);
	for (k = 0; k < n; k++)
		hawser__table_number(table, length*folds->coordinate[i*n + k]);
	hawser__table_number(table, point->residual);
	hawser__table_number(table, point->mesh);
	hawser__table_number(table, point->harmonics);
}

static void event_row(struct hawser__table *table, const struct cli_folds_result *result, int c,
                      int e)
{
	const struct hawser_folds *folds = result->folds;
	const struct hawser_folds_event *event = &folds->event[e];
	int k, empty = 3*folds->probes + folds->n + 3;

	hawser__table_number(table, c + 1);
	hawser__table_number(table, event->omega*cli_per_omega(result->model));
	hawser__table_number(table, event->load);
	hawser__table_word(table, hawser_folds_kind_name(event->kind));
	for (k = 0; k < empty; k++)
		hawser__table_word(table, "");
}

void cli_folds_table(struct hawser__table *table, const void *of)
{
	const struct cli_folds_result *result = of;
	const struct hawser_folds *folds = result->folds;
	int c, i, e;

	head(table, result);
	columns(table, result);
	for (c = 0; c < folds->curves; c++) {
		const struct hawser_folds_curve *curve = &folds->curve[c];

		e = curve->first_event;
		for (i = curve->first; i < curve->first + curve->points; i++) {
			point_row(table, result, c, (size_t)i);
			for (; e < curve->first_event + curve->events && folds->event[e].after == i; e++)
				event_row(table, result, c, e);
		}
	}
}

/* --- JSON --- */

static void point_json(struct hawser__json *json, json_t *list,
                       const struct cli_folds_result *result, size_t i)
{
	const struct hawser_folds *folds = result->folds;
	const struct hawser_folds_point *point = &folds->point[i];
	json_t *row = hawser__json_object(json, list, NULL);
	size_t n = (size_t)folds->n;

	hawser__json_number(json, row, "Omega", point->omega*cli_per_omega(result->model));
	hawser__json_number(json, row, "load", point->load);
	cli_amplitude_json(json, row, result->model, folds->probe + i*(size_t)folds->probes*3);
	hawser__json_numbers(json, row, "coordinates", folds->coordinate + i*n, folds->n,
	                     cli_per_length(result->model));
	hawser__json_number(json, row, "residual", point->residual);
	hawser__json_number(json, row, "truncation", point->mesh);
	hawser__json_integer(json, row, "harmonics", point->harmonics);
	hawser__json_integer(json, row, "iterations", point->iterations);
	hawser__json_number(json, row, "arc", point->arc);
	cli_state_json(json, row, result->model, folds->state + i*2*n);
}

static void event_json(struct hawser__json *json, json_t *list,
                       const struct cli_folds_result *result, int e, int first)
{
	const struct hawser_folds_event *event = &result->folds->event[e];
	json_t *row = hawser__json_object(json, list, NULL);

	hawser__json_text(json, row, "kind", hawser_folds_kind_name(event->kind));
	hawser__json_number(json, row, "Omega", event->omega*cli_per_omega(result->model));
	hawser__json_number(json, row, "load", event->load);
	if (event->kind != HAWSER_FOLDS_NOMINAL)
		hawser__json_integer(json, row, "minimum", event->minimum);
	hawser__json_number(json, row, "residual", event->residual);
	hawser__json_integer(json, row, "after", event->after - first);
	cli_state_json(json, row, result->model,
	               result->folds->event_state + (size_t)e*2*(size_t)result->folds->n);
}

static void curve_json(struct hawser__json *json, json_t *list,
                       const struct cli_folds_result *result, int c)
{
	const struct hawser_folds_curve *curve = &result->folds->curve[c];
	json_t *row = hawser__json_object(json, list, NULL), *inner;
	int i;

	hawser__json_number(json, row, "least_load", curve->least_load);
	hawser__json_number(json, row, "least_Omega", curve->least_omega*cli_per_omega(result->model));
	hawser__json_text(json, row, "least_kind", curve->least_event >= 0
	                  ? hawser_folds_kind_name(result->folds->event[curve->least_event].kind)
	                  : "end");
	inner = hawser__json_array(json, row, "ends");
	for (i = 0; i < 2; i++)
		hawser__json_text(json, inner, NULL, hawser_folds_end_name(curve->end[i]));
	if (*curve->message)
		hawser__json_text(json, row, "message", curve->message);
	inner = hawser__json_array(json, row, "events");
	for (i = curve->first_event; i < curve->first_event + curve->events; i++)
		event_json(json, inner, result, i, curve->first);
	inner = hawser__json_array(json, row, "points");
	for (i = curve->first; i < curve->first + curve->points; i++)
		point_json(json, inner, result, (size_t)i);
}

/* A response at the model's own load: the points in short, hawser frf has the rest. */
static void response_json(struct hawser__json *json, json_t *into,
                          const struct cli_folds_result *result, const struct hawser_frf *frf)
{
	double per_omega = cli_per_omega(result->model);
	json_t *list, *row;
	int i;

	hawser__json_text(json, into, "end", hawser_frf_end_name(frf->end));
	hawser__json_text(json, into, "method", frf->method);
	list = hawser__json_array(json, into, "events");
	for (i = 0; i < frf->events; i++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_text(json, row, "kind", hawser_event_name(frf->event[i].kind));
		hawser__json_number(json, row, "Omega", frf->event[i].omega*per_omega);
	}
	list = hawser__json_array(json, into, "points");
	for (i = 0; i < frf->points; i++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "Omega", frf->point[i].omega*per_omega);
		hawser__json_flag(json, row, "stable", frf->point[i].unstable == 0);
		hawser__json_integer(json, row, "unstable", frf->point[i].unstable);
		cli_amplitude_json(json, row, result->model,
		                   frf->probe + (size_t)i*(size_t)frf->probes*3);
		hawser__json_numbers(json, row, "coordinates",
		                     frf->coordinate + (size_t)i*(size_t)frf->n, frf->n,
		                     cli_per_length(result->model));
		hawser__json_number(json, row, "error", frf->point[i].error);
		cli_state_json(json, row, result->model, frf->state + (size_t)i*2*(size_t)frf->n);
	}
}

static void lost_json(struct hawser__json *json, const struct cli_folds_result *result)
{
	const struct hawser_folds *folds = result->folds;
	json_t *list = hawser__json_array(json, json->root, "not_followed");

	for (int i = 0; i < folds->lost; i++) {
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_number(json, row, "Omega",
		                    folds->lost_at[i].omega*cli_per_omega(result->model));
		hawser__json_number(json, row, "load", folds->lost_at[i].load);
	}
}

static void least_json(struct hawser__json *json, const struct cli_folds_result *result)
{
	const struct hawser_folds *folds = result->folds;
	double per_omega = cli_per_omega(result->model);
	json_t *list;

	if (folds->curves > 0) {
		hawser__json_number(json, json->root, "least_load", folds->least_load);
		hawser__json_number(json, json->root, "least_Omega", folds->least_omega*per_omega);
		hawser__json_text(json, json->root, "least_kind",
		                  hawser_folds_least_name(folds->least_kind));
	}
	list = hawser__json_array(json, json->root, "searched");
	for (int i = 0; i < folds->levels; i++) {
		const double range[] = {folds->level[i].from, folds->level[i].to};
		json_t *row = hawser__json_object(json, list, NULL);

		hawser__json_number(json, row, "load", folds->level[i].load);
		hawser__json_numbers(json, row, "range", range, 2, per_omega);
		hawser__json_integer(json, row, "folds", folds->level[i].folds);
	}
	hawser__json_flag(json, json->root, "nearly_linear", folds->nearly_linear);
}

void cli_folds_json(struct hawser__json *json, const void *of)
{
	const struct cli_folds_result *result = of;
	const struct hawser_folds *folds = result->folds;
	const struct cli_model *model = result->model;
	const double ends[] = {result->from, result->to}, loads[] = {result->load_from,
	                                                             result->load_to};
	json_t *list, *stats;
	int c;

	cli_echo_json(json, result->common, "folds", model->has_scene ? &model->scene : NULL);
	cli_choice_json(json, model, result->common);
	hawser__json_flag(json, json->root, "si", model->rom.scaled);
	hawser__json_numbers(json, json->root, "range", ends, 2, cli_per_omega(model));
	hawser__json_numbers(json, json->root, "load_range", loads, 2, 1.0);
	least_json(json, result);
	list = hawser__json_array(json, json->root, "curves");
	for (c = 0; c < folds->curves; c++)
		curve_json(json, list, result, c);
	response_json(json, hawser__json_object(json, json->root, "response"), result,
	              &folds->response);
	list = hawser__json_array(json, json->root, "isolas");
	for (c = 0; c < folds->isolas; c++)
		response_json(json, hawser__json_object(json, list, NULL), result, &folds->isola[c]);
	lost_json(json, result);
	if (folds->note[0])
		hawser__json_text(json, json->root, "note", folds->note);
	hawser__json_flag(json, json->root, "interrupted", folds->interrupted);
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "points", folds->points);
	hawser__json_integer(json, stats, "solves", folds->solves);
}
