/* response/family/factor.c - models multiplied by a factor; see hawser/family.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/family.h>

#include "core/names.h"
#include "core/report.h"
#include "response/orbit/load.h"
#include "rom/energy/kernel.h"
#include "rom/terms/terms.h"

#define MODELS 6 /* kept at the same time: those of the last calls */

struct factor {
	enum hawser_factor factor;
	const struct hawser_rom *rom;
	int next;
	double value[MODELS];
	struct hawser__load load[MODELS]; /* .rom is the model; its D is replaced for the damping */
	double *D[MODELS];                /* [n][n], or NULL */
	struct hawser_rom_kernel kernel[MODELS]; /* with its own d_val, where there is a D */
};

HAWSER__NAMES(hawser_factor_name, enum hawser_factor, "load", "damping")

static enum hawser_status model(void *context, const struct hawser_rom **rom, double p,
                                struct hawser_report *report)
{
	struct factor *factor = context;
	size_t n = (size_t)factor->rom->n;
	int i = factor->next;

	(void)report;
	for (int k = 0; k < MODELS; k++)
		if (factor->value[k] == p)
			i = k;
	*rom = &factor->load[i].rom;
	if (factor->value[i] == p)
		return HAWSER_OK;
	factor->next = (i + 1)%MODELS;
	factor->value[i] = p;
	if (factor->factor == HAWSER_FACTOR_LOAD)
		hawser__load_set(&factor->load[i], p);
	for (size_t k = 0; factor->D[i] && k < n*n; k++)
		factor->D[i][k] = p*factor->rom->D[k];
	for (int k = 0; factor->D[i] && k < factor->rom->kernel->d_entries; k++)
		factor->kernel[i].d_val[k] = p*factor->rom->kernel->d_val[k];
	return HAWSER_OK;
}

/* Model i has a damping of its own, and a compiled form with it. */
static enum hawser_status own_damping(struct factor *factor, int i, struct hawser_report *report)
{
	const struct hawser_rom *rom = factor->rom;
	size_t n2 = (size_t)rom->n*(size_t)rom->n, entries = (size_t)rom->kernel->d_entries;
	double *D = malloc((n2 + 1)*sizeof *D), *value = malloc((entries + 1)*sizeof *value);

	factor->D[i] = D;
	factor->kernel[i] = *rom->kernel;
	factor->kernel[i].d_val = value;
	if (!D || !value)
		return hawser__no_memory(report, "frf");
	memcpy(D, rom->D, n2*sizeof *D);
	memcpy(value, rom->kernel->d_val, entries*sizeof *value);
	factor->load[i].rom.D = D;
	factor->load[i].rom.kernel = &factor->kernel[i];
	return HAWSER_OK;
}

void hawser_factor_close(struct hawser_rom_family *family)
{
	struct factor *factor = family->context;

	for (int i = 0; factor && i < MODELS; i++) {
		hawser__load_clear(&factor->load[i]);
		free(factor->D[i]);
		free(factor->kernel[i].d_val);
	}
	free(factor);
	*family = (struct hawser_rom_family){0.0, NULL, NULL};
}

enum hawser_status hawser_factor_open(struct hawser_rom_family *family, const struct hawser_rom *rom,
                                      enum hawser_factor which, double omega,
                                      struct hawser_report *report)
{
	struct factor *factor = calloc(1, sizeof *factor);
	enum hawser_status status = HAWSER_OK;

	if (rom->plug) {
		free(factor);
		return hawser__more_refuse(rom, "a factor of load or damping", report);
	}
	if (rom->first && which == HAWSER_FACTOR_DAMPING) {
		free(factor);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "a model of first_order has no damping that factor.damping multiplies: "
		                    "name a number of the file as a parameter");
	}
	*family = (struct hawser_rom_family){omega, model, factor};
	if (!factor)
		return hawser__no_memory(report, "frf");
	factor->rom = rom;
	factor->factor = which;
	for (int i = 0; !status && i < MODELS; i++) {
		factor->value[i] = 1.0;
		status = hawser__load_open(&factor->load[i], rom, report);
		if (status || which != HAWSER_FACTOR_DAMPING)
			continue;
		status = own_damping(factor, i, report);
	}
	if (status)
		hawser_factor_close(family);
	return status;
}
