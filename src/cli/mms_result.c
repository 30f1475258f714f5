/* cli/mms_result.c - see mms_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/mms_result.h"

static const char axis[] = "xyz";
static const char *const part_name[] = {"mean", "first", "second"};

static const char *unit(const struct cli_mms_result *result, const char *name)
{
	return result->model->rom.scaled ? name : "";
}

/* --- modulation equations --- */

/* "A3" of mode 3, "A3*" its conjugate. */
static void variable(char name[16], const struct hawser_resonance *resonance, int v)
{
	snprintf(name, 16, "A%d%s", resonance->mode[v%resonance->count] + 1,
	         v < resonance->count ? "" : "*");
}

static void monomial_comment(struct hawser__table *table, const struct hawser_modulation *m,
                             const struct hawser_monomial *e)
{
	char name[3][16] = {"", "", ""};

	for (int f = 0; f < 3 && e->factor[f] >= 0; f++)
		variable(name[f], &m->resonance, e->factor[f]);
	if (fabs(e->im) > 1e-12*fabs(e->re))
		hawser__table_comment(table, "    + (%.9g %+.9gi) %s %s %s", e->re, e->im, name[0], name[1],
		                      name[2]);
	else
		hawser__table_comment(table, "    %+.9g %s %s %s", e->re, name[0], name[1], name[2]);
}

static double own_frequency(const struct hawser_modulation *m, int r)
{
	int s = m->resonance.mode[r];

	return sqrt(m->rom->K[(size_t)s*((size_t)m->rom->n + 1)]);
}

void cli_mms_equations(struct hawser__table *table, const struct cli_mms_result *result)
{
	const struct hawser_modulation *m = result->modulation;
	const struct hawser_resonance *resonance = &m->resonance;
	double per_omega = cli_per_omega(result->model);

	hawser__table_comment(table,
	                      "modulation equations (scaled, W = Omega%s): u_j = A_j exp(i p W t) + "
	                      "conjugate", result->base == 1 ? "" : result->base == 2 ? "/2" : "/3");
	for (int r = 0; r < resonance->count; r++) {
		int j = resonance->mode[r], p = resonance->order[r];
		double w = own_frequency(m, r);

		hawser__table_comment(table,
		                      "  mode %d, p = %d, w = %.9g (%.9g%s), detuned by %+.3e: -2 i p W "
		                      "dA%d/dt = (w^2 - p^2 W^2 + i p W %.6g) A%d - load", j + 1, p, w,
		                      w*per_omega, unit(result, " rad/s"), w/(p*resonance->omega0) - 1.0,
		                      j + 1,
		                      m->rom->D[(size_t)j*((size_t)m->rom->n + 1)], j + 1);
		for (int i = 0; i < m->monomials; i++)
			if (m->monomial[i].equation == r)
				monomial_comment(table, m, &m->monomial[i]);
	}
	if (isfinite(m->nearest))
		hawser__table_comment(table,
		                      "nearest resonance left out: mode %d at %d times the reference "
		                      "frequency, off by %.2g in the square", m->nearest_mode + 1,
		                      m->nearest_harmonic, m->nearest);
}

void cli_mms_equations_json(struct hawser__json *json, const struct cli_mms_result *result)
{
	const struct hawser_modulation *m = result->modulation;
	const struct hawser_resonance *resonance = &m->resonance;
	json_t *into = hawser__json_object(json, json->root, "modulation"), *list, *row, *factors;
	char name[16];

	hawser__json_integer(json, into, "base", result->base);
	hawser__json_number(json, into, "reference_scaled", resonance->omega0);
	list = hawser__json_array(json, into, "modes");
	for (int r = 0; r < resonance->count; r++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, row, "mode", resonance->mode[r] + 1);
		hawser__json_integer(json, row, "order", resonance->order[r]);
		hawser__json_number(json, row, "omega", own_frequency(m, r)*cli_per_omega(result->model));
		hawser__json_number(json, row, "detuning",
		                    own_frequency(m, r)/(resonance->order[r]*resonance->omega0) - 1.0);
	}
	list = hawser__json_array(json, into, "monomials_scaled");
	for (int i = 0; i < m->monomials; i++) {
		const struct hawser_monomial *e = &m->monomial[i];

		row = hawser__json_object(json, list, NULL);
		hawser__json_integer(json, row, "mode", resonance->mode[e->equation] + 1);
		factors = hawser__json_array(json, row, "factors");
		for (int f = 0; f < 3 && e->factor[f] >= 0; f++) {
			variable(name, resonance, e->factor[f]);
			hawser__json_text(json, factors, NULL, name);
		}
		hawser__json_number(json, row, "re", e->re);
		hawser__json_number(json, row, "im", e->im);
	}
	if (isfinite(m->nearest)) {
		row = hawser__json_object(json, into, "nearest_left_out");
		hawser__json_integer(json, row, "mode", m->nearest_mode + 1);
		hawser__json_integer(json, row, "harmonic", m->nearest_harmonic);
		hawser__json_number(json, row, "gap", m->nearest);
	}
}

/* --- one mode in closed form --- */

static void head(struct hawser__table *table, const struct cli_mms_result *result)
{
	const struct hawser_primary *primary = result->primary;
	double length = cli_per_length(result->model), per_omega = cli_per_omega(result->model);
	const char *rad_s = unit(result, " rad/s"), *m = unit(result, " m");

	cli_echo_table(table, result->common, "mms",
	               result->model->has_scene ? &result->model->scene : NULL,
	               "multiple scales, closed form of one mode at primary resonance");
	cli_choice_comments(table, result->model);
	hawser__table_comment(table, "mode %d: omega = %.12g%s, damping = %.9g%s, load = %.9g%s",
	                      primary->mode + 1, primary->omega*per_omega, rad_s,
	                      primary->damping*per_omega, unit(result, " 1/s"),
	                      hypot(primary->load[0], primary->load[1])*length*per_omega*per_omega,
	                      unit(result, " m/s^2"));
	hawser__table_comment(table, "cubic coefficient (scaled): own %.9g, effective %.9g",
	                      primary->own,
	                      primary->cubic);
	hawser__table_comment(table, "backbone: Omega = omega %+.9g a^2%s: %s",
	                      primary->gamma*per_omega/(length*length), unit(result, " (rad/s, m)"),
	                      primary->gamma > 0.0 ? "hardening" : "softening");
	hawser__table_comment(table, "peak: a = %.9g%s at Omega = %.12g%s", primary->peak*length, m,
	                      primary->peak_omega*per_omega, rad_s);
	for (int k = 0; k < primary->folds; k++)
		hawser__table_comment(table, "fold: a = %.9g%s at Omega = %.12g%s",
		                      primary->fold[k]*length, m,
		                      primary->fold_omega[k]*per_omega, rad_s);
	if (!primary->folds)
		hawser__table_comment(table,
		                      "no fold: the load is below the one at which the curve leans over");
	cli_mms_equations(table, result);
}

void cli_mms_table(struct hawser__table *table, const void *of)
{
	const struct cli_mms_result *result = of;
	const struct hawser_rom *rom = &result->model->rom;
	const struct hawser_frf *frf = &result->curve->frf;
	double length = cli_per_length(result->model);
	const char *m = unit(result, "_m");

	head(table, result);
	hawser__table_column(table, "Omega%s", unit(result, "_rad_s"));
	hawser__table_column(table, "stable");
	hawser__table_column(table, "a%s", m);
	for (int p = 0; p < frf->probes; p++)
		for (int c = 0; c < 3; c++) {
			hawser__table_column(table, "%c_%s%s", axis[c], rom->shapes.name[p], m);
			for (int h = 0; h < 3; h++)
				hawser__table_column(table, "%c_%s_%s%s", axis[c], rom->shapes.name[p],
				                     part_name[h], m);
		}
	for (int i = 0; i < frf->points; i++) {
		hawser__table_number(table, frf->point[i].omega*cli_per_omega(result->model));
		hawser__table_number(table, !frf->point[i].unstable);
		hawser__table_number(table, result->curve->amplitude[i]*length);
		for (int k = 0; k < 3*frf->probes; k++) {
			size_t row = (size_t)i*(size_t)frf->probes*3 + (size_t)k;

			hawser__table_number(table, frf->probe[row]*length);
			for (int h = 0; h < 3; h++)
				hawser__table_number(table, result->curve->part[3*row + (size_t)h]*length);
		}
	}
}

static void primary_json(struct hawser__json *json, const struct cli_mms_result *result)
{
	const struct hawser_primary *primary = result->primary;
	double length = cli_per_length(result->model), per_omega = cli_per_omega(result->model);
	json_t *into = hawser__json_object(json, json->root, "primary"), *list, *row;

	hawser__json_integer(json, into, "mode", primary->mode + 1);
	hawser__json_number(json, into, "omega", primary->omega*per_omega);
	hawser__json_number(json, into, "damping", primary->damping*per_omega);
	hawser__json_number(json, into, "load", hypot(primary->load[0],
	                                              primary->load[1])*length*per_omega
	                                        *per_omega);
	hawser__json_number(json, into, "own_cubic_scaled", primary->own);
	hawser__json_number(json, into, "effective_cubic_scaled", primary->cubic);
	hawser__json_number(json, into, "backbone", primary->gamma*per_omega/(length*length));
	hawser__json_flag(json, into, "hardening", primary->gamma > 0.0);
	row = hawser__json_object(json, into, "peak");
	hawser__json_number(json, row, "Omega", primary->peak_omega*per_omega);
	hawser__json_number(json, row, "a", primary->peak*length);
	list = hawser__json_array(json, into, "folds");
	for (int k = 0; k < primary->folds; k++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "Omega", primary->fold_omega[k]*per_omega);
		hawser__json_number(json, row, "a", primary->fold[k]*length);
	}
}

static void parts_json(struct hawser__json *json, json_t *row, const struct cli_mms_result *result,
                       size_t i)
{
	const struct hawser_frf *frf = &result->curve->frf;
	json_t *into = hawser__json_object(json, row, "parts"), *probe, *component;
	double length = cli_per_length(result->model);

	for (int p = 0; p < frf->probes; p++) {
		probe = hawser__json_object(json, into, result->model->rom.shapes.name[p]);
		for (int c = 0; c < 3; c++) {
			const double *part =
			        result->curve->part + ((i*(size_t)frf->probes + (size_t)p)*3 + (size_t)c)*3;
			const char name[] = {axis[c], '\0'};

			component = hawser__json_object(json, probe, name);
			for (int h = 0; h < 3; h++)
				hawser__json_number(json, component, part_name[h], part[h]*length);
		}
	}
}

void cli_mms_json(struct hawser__json *json, const void *of)
{
	const struct cli_mms_result *result = of;
	const struct cli_model *model = result->model;
	const struct hawser_frf *frf = &result->curve->frf;
	const double ends[] = {result->from, result->to};
	json_t *list, *row;

	cli_echo_json(json, result->common, "mms", model->has_scene ? &model->scene : NULL);
	hawser__json_flag(json, json->root, "si", model->rom.scaled);
	hawser__json_numbers(json, json->root, "range", ends, 2, cli_per_omega(model));
	cli_choice_json(json, model, result->common);
	primary_json(json, result);
	cli_mms_equations_json(json, result);
	list = hawser__json_array(json, json->root, "points");
	for (int i = 0; i < frf->points; i++) {
		row = hawser__json_object(json, list, NULL);
		hawser__json_number(json, row, "Omega", frf->point[i].omega*cli_per_omega(model));
		hawser__json_flag(json, row, "stable", !frf->point[i].unstable);
		hawser__json_number(json, row, "a", result->curve->amplitude[i]*cli_per_length(model));
		cli_amplitude_json(json, row, model, frf->probe + (size_t)i*(size_t)frf->probes*3);
		parts_json(json, row, result, (size_t)i);
	}
	cli_stats_json(json, result->common);
}

enum hawser_status cli_mms_draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct cli_mms_result *result = context;
	const struct cli_frf_result drawn = {.common = result->common, .model = result->model,
	                                     .frf = &result->curve->frf, .from = result->from,
	                                     .to = result->to, .scale = "linear"};

	return cli_frf_draw(path, &drawn, report);
}
