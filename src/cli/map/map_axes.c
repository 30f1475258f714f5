/* cli/map/map_axes.c - axes of maps, and other parameters over a range: KEY=FROM:TO with a key of the
 * scene, Omega, or a component of the state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "cli/curves/frf_over.h"
#include "cli/model/axis.h"
#include "core/report.h"

/* Split KEY=FROM:TO into three texts in *copy, which the caller frees. */
static enum hawser_status split(char **copy, const char *part[3], const char *option,
                                const char *text, struct hawser_report *report)
{
	char *equals, *colon;

	*copy = text ? strdup(text) : NULL;
	if (text && !*copy)
		return hawser__no_memory(report, "map");
	equals = text ? strchr(*copy, '=') : NULL;
	colon = equals ? strchr(equals + 1, ':') : NULL;
	if (!text)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "--%s is missing: write --%s KEY=FROM:TO, such as --%s %s", option,
		                    option, option,
		                    *option == 'x' ? "Omega=0.5w1:3w1" : "travel.fluctuation=0:5");
	if (!colon || equals == *copy || colon == equals + 1 || !colon[1])
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "--%s %s: write KEY=FROM:TO, such as travel.speed=0:20", option, text);
	if (strchr(colon + 1, ':'))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map", "--%s %s: values between the ends are "
		                    "chosen by the command: write KEY=FROM:TO", option, text);
	*equals = *colon = '\0';
	part[0] = *copy;
	part[1] = equals + 1;
	part[2] = colon + 1;
	return HAWSER_OK;
}

/* Natural frequencies in rad/s (or the model's own unit), for multiples such as 0.6w1. */
static enum hawser_status natural(struct cli_model *model, struct hawser_report *report)
{
	struct hawser_modes_options choice = cli_modes_options(&model->scene);
	enum hawser_status status = HAWSER_OK;

	if (model->natural)
		return HAWSER_OK;
	if (!model->has_scene)
		return HAWSER_OK;
	status = hawser_statics_scene(&model->statics, &model->scene, report);
	if (!status)
		status = hawser_modes_solve(&model->modes, &model->statics, &choice, report);
	if (!status)
		status = hawser_rom_build_linear(&model->rom, &model->modes, &model->scene, report);
	return status ? status : cli_natural(model, report);
}

/* In rad/s, or the model's own unit. */
static enum hawser_status frequency(double *omega, const char *text, const char *option,
                                    struct cli_model *model, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int multiple = strchr(text, 'w') != NULL;

	if (model->has_scene && !multiple) {
		struct cli_model plain = {.rom = {.scaled = 1, .time = 1.0}};

		return cli_frequency(omega, text, option, &plain, report);
	}
	status = natural(model, report);
	if (!status)
		status = cli_frequency(omega, text, option, model, report);
	if (!status)
		*omega *= cli_per_omega(model);
	return status;
}

/* Unit of a component of the state; NULL: the key is no such component. */
static const char *component_unit(const char *key, const struct cli_model *model)
{
	if ((*key != 'u' && *key != 'v') || !isdigit((unsigned char)key[1]))
		return NULL;
	return !model->has_scene && !model->rom.scaled ? "" : *key == 'u' ? "m" : "m/s";
}

static const char *unit_of(const char *key, const struct cli_model *model)
{
	const char *unit = component_unit(key, model);

	if (unit)
		return unit;
	if (strcmp(key, "Omega") == 0)
		return model->has_scene || model->rom.scaled ? "rad/s" : "";
	return strcmp(cli_key_unit(key), "1") == 0 ? "" : cli_key_unit(key);
}

static enum hawser_status end_of(double *value, const char *text, const char *option,
                                 const char *key, struct cli_model *model,
                                 struct hawser_report *report)
{
	const char *unit = component_unit(key, model);

	if (strcmp(key, "Omega") == 0)
		return frequency(value, text, option, model, report);
	if (unit)
		return cli_quantity(value, text, *unit ? unit : "1", CLI_ANY, "map", option, report);
	return cli_quantity(value, text, cli_key_unit(key), CLI_ANY, "map", option, report);
}

enum hawser_status cli_map_axis(struct cli_map_axis *to, const char *option, const char *text,
                                struct cli_model *model, struct hawser_report *report)
{
	const char *part[3];
	double from = NAN, end = NAN;
	enum hawser_status status = split(&to->copy, part, option, text, report);

	if (status)
		return status;
	to->key = part[0];
	if (strcasecmp(to->key, "Omega") == 0 && strcmp(to->key, "Omega") != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map", "--%s %s: did you mean Omega, the "
		                    "forcing frequency?", option, text);
	if (model->has_scene && cli_over_needs_scene(to->key) && strcmp(to->key, "Omega") != 0 &&
	    !component_unit(to->key, model) &&
	    (status = hawser_scene_get(&model->scene, &from, to->key, report)))
		return status;
	to->unit = unit_of(to->key, model);
	status = end_of(&from, part[1], option, to->key, model, report);
	if (!status)
		status = end_of(&end, part[2], option, to->key, model, report);
	if (!status && (from == end || !isfinite(from) || !isfinite(end)))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                      "--%s %s=%s:%s: the ends of the range must be finite and different",
		                      option, part[0], part[1], part[2]);
	to->from = fmin(from, end);
	to->to = fmax(from, end);
	to->backwards = from > end;
	return status;
}

enum hawser_status cli_map_frequency(double *omega, const char *text, const char *option,
                                     struct cli_model *model, struct hawser_report *report)
{
	return frequency(omega, text, option, model, report);
}
