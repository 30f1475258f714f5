/* cli/frame/view.c - how results of a model are shown: its scale, and the names of displacements
 * at probes and of coordinates. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include "cli/frame/view.h"

struct hawser__scale cli_scale(const struct cli_model *model)
{
	const struct hawser_rom *rom = &model->rom;

	return hawser__scale_of(cli_per_length(model), cli_per_omega(model),
	                        rom->scaled ? rom->force*rom->length : 1.0, rom->scaled);
}

struct hawser__view cli_view(const struct cli_model *model, unsigned options)
{
	return (struct hawser__view){cli_scale(model), model, options};
}

struct hawser__view cli_si_view(unsigned options)
{
	return (struct hawser__view){.scale = hawser__si, .options = options};
}

struct cli_head cli_model_head(const struct cli_common *common, const char *command,
                               const char *method, const struct cli_model *model, unsigned options)
{
	return (struct cli_head){common, command, method, model->has_scene ? &model->scene : NULL,
	                         cli_view(model, options), NULL, NULL, NULL};
}

struct cli_head cli_si_head(const struct cli_common *common, const char *command, const char *method,
                            const void *context, unsigned options)
{
	return (struct cli_head){common, command, method, NULL, {hawser__si, context, options}, NULL, NULL,
	                         NULL};
}

const char *cli_unit(const struct cli_model *model, const char *name)
{
	return model && model->rom.scaled ? name : "";
}

struct hawser__axis cli_model_axis(const struct cli_model *model, const char *quantity, const char *si)
{
	return hawser__axis_of(quantity, cli_unit(model, si), 0.0);
}

HAWSER__OF(probes, int, struct cli_model, 3*of->rom.shapes.points)

static void probe_name(char *text, size_t size, const void *context, int k)
{
	const struct cli_model *model = context;

	snprintf(text, size, "%c_%s", "xyz"[k % 3], model->rom.shapes.name[k/3]);
}

HAWSER__OF(coordinates, int, struct cli_model, of->rom.n)

static void number_name(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, "%d", k + 1);
}

static int states(const void *context)
{
	return 2*coordinates(context);
}

HAWSER__OF(naturals, int, struct cli_model, of->naturals)

static int axes(const void *context)
{
	(void)context;
	return 3;
}

static void axis_name(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, "%c", "xyz"[k]);
}

const struct hawser__vector cli_axes = {.shown = "AXIS", .count = axes, .name = axis_name};
const struct hawser__vector cli_probes = {
	.shown = "x_PROBE", .count = probes, .name = probe_name, .object = 1};
const struct hawser__vector cli_coordinates = {
	.shown = "J", .count = coordinates, .name = number_name};
const struct hawser__vector cli_states = {.count = states, .rate = HAWSER__M_S};
static const struct hawser__vector natural_vector = {.count = naturals};

const struct hawser__field cli_si_field[] = {
	{"si", NULL, "false where the model has no units",
	 HAWSER__FLAG_AT(struct cli_model, rom.scaled)},
	HAWSER__END,
};
const struct hawser__field cli_naturals_field[] = {
	{"natural_frequencies", NULL, "undamped, of the model", .unit = HAWSER__RAD_S,
	 .kind = HAWSER__VECTOR, HAWSER__PLACE(struct cli_model, natural), .vector = &natural_vector},
	HAWSER__END,
};
