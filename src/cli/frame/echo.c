/* cli/frame/echo.c - the beginning of every result: version, command, and all keys of the scene,
 * from the table of keys. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/progress.h"
#include "cli/frame/within.h"
#include "output/drawing/style.h"

/* Of a scene that the table of keys does not describe; NULL of others. */
static const char *other_kind(const struct cli_common *common)
{
	enum hawser_kind kind = cli_kind(common);

	return kind == HAWSER_KIND_SPAN || kind == HAWSER_KIND_MODEL ? NULL
	       : kind == HAWSER_KIND_OBSTACLES                       ? "span"
	                                                             : hawser_kind_name(kind);
}

const char *cli_input_name(const struct cli_common *common)
{
	return common->input && strcmp(common->input, "-") == 0 ? "<stdin>" : common->input;
}

void cli_echo_table(struct hawser__table *table, const struct cli_common *common,
                    const char *command, const struct hawser_scene *scene, const char *method)
{
	const char *kind = scene ? NULL : other_kind(common);
	int i;

	hawser__table_comment(table, "hawser %s %s", hawser_version(), command);
	if (scene || common->input)
		hawser__table_remark(table, "%s: %s", scene || kind ? "scene" : "model",
		                     scene && scene->name ? scene->name : cli_input_name(common));
	for (i = 0; i < common->mores; i++)
		hawser__table_remark(table, "scene: %s", common->more[i]);
	for (i = 0; i < common->sets; i++)
		hawser__table_remark(table, "set: %s", common->set[i]);
	hawser__table_remark(table, "method: %s", method);
	if (scene)
		hawser__table_comment(table, "g = %.10g m/s^2", scene->g);
}

/* The object that "damping.rayleigh" names, created if missing; *name is the rest of the name. */
static json_t *walk(struct hawser__json *json, json_t *echo, const char **name, const char *path)
{
	const char *dot;
	json_t *inner;
	char part[64];

	for (; (dot = strchr(path, '.')) != NULL; path = dot + 1, echo = inner) {
		snprintf(part, sizeof part, "%.*s", (int)(dot - path), path);
		inner = json_object_get(echo, part);
		if (!inner)
			inner = hawser__json_object(json, echo, part);
	}
	*name = path;
	return echo;
}

/* Elements of a list, which have names like "load.per_length[2]". */
static void echo_list(struct hawser__json *json, json_t *echo, const struct hawser_scene *scene,
                      const char *path)
{
	json_t *list = NULL;
	char element[96];
	const char *name;
	double value;
	int i;

	for (i = 0;; i++) {
		snprintf(element, sizeof element, "%s[%d]", path, i);
		if (hawser_scene_get(scene, &value, element, NULL) != HAWSER_OK)
			return;
		if (!list) {
			json_t *section = walk(json, echo, &name, path);

			list = hawser__json_array(json, section, name);
		}
		if (isinf(value))
			hawser__json_text(json, list, NULL, ".inf");
		else
			hawser__json_number(json, list, NULL, value);
	}
}

/* Write the value of this key; nothing if the scene does not have it. */
static void echo_key(struct hawser__json *json, json_t *echo, const struct hawser_scene *scene,
                     const struct hawser_scene_key *key)
{
	char word[HAWSER_WORD_SIZE];
	json_t *section;
	const char *name;
	double value;

	if (strncmp(key->type, "numbers", 7) == 0 ||
	    (strcmp(key->type, "series") == 0 &&
	     hawser_scene_get(scene, &value, key->path, NULL) != HAWSER_OK)) {
		echo_list(json, echo, scene, key->path);
	} else if (key->words && hawser_scene_word(scene, word, key->path, NULL) == HAWSER_OK) {
		section = walk(json, echo, &name, key->path);
		hawser__json_text(json, section, name, word);
	} else if (hawser_scene_get(scene, &value, key->path, NULL) == HAWSER_OK) {
		section = walk(json, echo, &name, key->path);
		if (isinf(value))
			hawser__json_text(json, section, name, ".inf");
		else if (strcmp(key->type, "integer") == 0)
			hawser__json_integer(json, section, name, (long)value);
		else
			hawser__json_number(json, section, name, value);
	}
}

/* Rows of numbers below wind. */
static void echo_rows(struct hawser__json *json, json_t *wind, const char *key, const double *value,
                      int count, int columns)
{
	json_t *list = count ? hawser__json_array(json, wind, key) : NULL;

	for (int i = 0; i < count; i++) {
		json_t *row = hawser__json_array(json, list, NULL);

		for (int c = 0; c < columns; c++)
			hawser__json_number(json, row, NULL, value[i*columns + c]);
	}
}

static void echo_wind(struct hawser__json *json, json_t *echo, const struct hawser_wind *wind)
{
	const char *name;
	json_t *section = walk(json, echo, &name, "wind.profile");

	echo_rows(json, section, "profile", wind->profile[0], wind->profiles, 2);
	echo_rows(json, section, "table", wind->table[0], wind->tables, 3);
	echo_rows(json, section, "reynolds", wind->reynolds[0], wind->crises, 2);
}

static void triple(struct hawser__json *json, json_t *into, const char *name, const double *value)
{
	json_t *list = hawser__json_array(json, into, name);

	for (int c = 0; c < 3; c++)
		hawser__json_number(json, list, NULL, value[c]);
}

/* The attachments as the scene has them; `at` is a fraction or, with the unit, a length. */
static void echo_attachments(struct hawser__json *json, json_t *echo,
                             const struct hawser_scene *scene)
{
	json_t *list = hawser__json_array(json, echo, "attach");

	for (int i = 0; i < scene->attachments; i++) {
		const struct hawser_attachment *a = &scene->attach[i];
		json_t *item = hawser__json_object(json, list, NULL);

		hawser__json_number(json, item, a->by_length ? "at_m" : "at", a->at);
		hawser__json_number(json, item, "mass", a->mass);
		if (a->force[0] != 0.0 || a->force[1] != 0.0 || a->force[2] != 0.0)
			triple(json, item, "force", a->force);
		triple(json, item, "spring", a->spring);
		triple(json, item, "damper", a->damper);
		if (a->absorber_mass > 0.0) {
			hawser__json_number(json, item, "absorber_mass", a->absorber_mass);
			hawser__json_number(json, item, "absorber_stiffness", a->absorber_stiffness);
			hawser__json_number(json, item, "absorber_damping", a->absorber_damping);
			hawser__json_number(json, item, "absorber_cubic", a->absorber_cubic);
			triple(json, item, "absorber_direction", a->absorber_direction);
		}
		if (*a->name)
			hawser__json_text(json, item, "name", a->name);
	}
}

static void echo_loads(struct hawser__json *json, json_t *echo, const struct hawser_scene *scene)
{
	json_t *list = hawser__json_array(json, echo, "loads");

	for (int i = 0; i < scene->loads; i++) {
		const struct hawser_load_piece *a = &scene->piece[i];
		json_t *item = hawser__json_object(json, list, NULL);

		if (a->force[0] != 0.0 || a->force[1] != 0.0 || a->force[2] != 0.0) {
			triple(json, item, "force", a->force);
			hawser__json_number(json, item, a->at_length ? "at_m" : "at", a->at);
		} else {
			triple(json, item, "per_length", a->per_length);
			hawser__json_number(json, item, a->from_length ? "from_m" : "from", a->from);
			hawser__json_number(json, item, a->to_length ? "to_m" : "to", a->to);
			hawser__json_number(json, item, "wave", a->wave);
		}
		hawser__json_text(json, item, "frame",
		                  a->frame == HAWSER_FRAME_GLOBAL ? "global" : "local");
		hawser__json_number(json, item, "harmonic", a->harmonic);
		hawser__json_number(json, item, "phase", a->phase);
		if (*a->name)
			hawser__json_text(json, item, "name", a->name);
	}
}

static void echo_cases(struct hawser__json *json, json_t *echo, const struct hawser_scene *scene)
{
	json_t *list = hawser__json_array(json, echo, "cases");

	for (int i = 0; i < scene->cases; i++) {
		const struct hawser_case *c = &scene->load_case[i];
		json_t *item = hawser__json_object(json, list, NULL);

		hawser__json_text(json, item, "name", c->name);
		if (c->loaded) {
			json_t *load = hawser__json_object(json, item, "load");
			json_t *still = hawser__json_object(json, load, "static");

			triple(json, still, "per_length", c->per_length);
			hawser__json_number(json, still, "mass", c->mass);
		}
		if (c->heated) {
			json_t *temperature = hawser__json_object(json, item, "temperature");

			hawser__json_number(json, temperature, "change", c->change);
			hawser__json_number(json, temperature, "expansion", c->expansion);
		}
		if (c->wind > 0.0)
			hawser__json_number(json, hawser__json_object(json, item, "wind"), "speed", c->wind);
	}
}

static void echo_other(struct hawser__json *json, json_t *echo, const struct cli_common *common,
                       const char *kind)
{
	json_t *set;

	hawser__json_text(json, echo, "kind", kind);
	if (common->mores > 0) {
		json_t *more = hawser__json_array(json, echo, "more");

		for (int i = 0; i < common->mores; i++)
			hawser__json_text(json, more, NULL, common->more[i]);
	}
	if (common->sets == 0)
		return;
	set = hawser__json_array(json, echo, "set");
	for (int i = 0; i < common->sets; i++)
		hawser__json_text(json, set, NULL, common->set[i]);
}

void cli_echo_json(struct hawser__json *json, const struct cli_common *common,
                   const char *command, const struct hawser_scene *scene)
{
	const struct hawser_scene_key *key;
	json_t *echo;
	const char *kind = scene ? NULL : other_kind(common);

	hawser__json_begin(json);
	hawser__json_text(json, json->root, "command", command);
	hawser__json_text(json, json->root, "version", hawser_version());
	if (!scene && !common->input) {
		hawser__json_null(json, json->root, "scene");
		return;
	}
	echo = hawser__json_object(json, json->root, "scene");
	hawser__json_text(json, echo, scene || kind ? "name" : "model_file",
	                  scene && scene->name ? scene->name : cli_input_name(common));
	if (kind)
		echo_other(json, echo, common, kind);
	if (!scene)
		return;
	for (int i = 0; !json->status && (key = hawser_scene_key(i)); i++)
		if (!strchr(key->path, '['))
			echo_key(json, echo, scene, key);
	if (scene->wind.present)
		echo_wind(json, echo, &scene->wind);
	if (scene->attachments)
		echo_attachments(json, echo, scene);
	if (scene->loads)
		echo_loads(json, echo, scene);
	if (scene->cases)
		echo_cases(json, echo, scene);
}

json_t *cli_stats_json(struct hawser__json *json, const struct cli_common *common)
{
	json_t *stats = hawser__json_object(json, json->root, "stats");

	if (!common->reproducible)
		hawser__json_number(json, stats, "wall_time_secs", cli_seconds() - common->started);
	return stats;
}

/* Models with axial modes include this tension: the full strain energy has them, and condensed
 * modes include their static response. */
double cli_speeding_tension(const struct cli_model *model, double omega)
{
	const struct hawser_scene *scene = &model->scene;
	double rho = scene->cable.rho + scene->static_load.mass, EA = scene->cable.EA, length, rate;

	if (!model->has_scene || !scene->travel.present || model->rom.exact || !model->rom.scaled ||
	    scene->model.condense == HAWSER_CONDENSE_STATIC)
		return 0.0;
	length = hawser_statics_actual(&model->statics).length0;
	omega *= cli_per_omega(model);
	rate = scene->travel.fluctuation*omega;
	return hawser_surge_steady(rho, EA, length, rate, omega);
}

void cli_speeding_comment(struct hawser__table *table, const struct cli_model *model, double omega)
{
	double missing = cli_speeding_tension(model, omega);

	if (missing > 0.0)
		hawser__table_comment(table, "not in the model's tension: what the change of speed itself puts "
		                      "on the cable, about +-%.4g N at its ends (model.condense: static and "
		                      "model.energy: exact have it)", missing);
}

void cli_warn_doubts(const struct hawser_scene *scene)
{
	struct hawser_doubt doubt[HAWSER_DOUBTS];
	int count = hawser_scene_doubts(doubt, scene);

	if (count == 1)
		cli_warn(doubt->text);
	else if (count > 1) {
		char text[CLI_WARNING_SIZE + 100];

		snprintf(text, sizeof text, "%s; besides, %d more quantities are implausible "
		         "(hawser-scene(5), PLAUSIBILITY)", doubt->text, count - 1);
		cli_warn(text);
	}
}

void cli_warn_wake(const struct hawser_scene *scene, const struct hawser_statics *statics)
{
	const struct hawser_wind *wind = &scene->wind;
	double frequency, number;
	char text[CLI_WARNING_SIZE];

	if (!wind->present || !wind->wake.present || scene->model.modes == HAWSER_MODES_AUTO)
		return;
	frequency = wind->wake.strouhal*wind->speed/wind->diameter;
	number = 2.0*frequency*statics->span.d/sqrt(statics->H/statics->span.rho);
	if (number <= scene->model.modes)
		return;
	snprintf(text, sizeof text, "vortices are shed at %.4g Hz (wind.wake.strouhal times speed over "
	         "diameter), where mode %.0f of a plane is, and the model has %d modes of both planes: "
	         "such vortices move none of them much; raise model.modes (-n), or see what a lower "
	         "wind.speed does", frequency, number, scene->model.modes);
	cli_warn(text);
}

static char **kept, *said; /* lines; `said`: since the last result */
static int silent;

char **cli_warn_into(char **text)
{
	char **before = kept;

	kept = text;
	return before;
}

/* Add a line to the text; without memory it is not kept. */
static void keep(char **into, const char *line)
{
	size_t used = *into ? strlen(*into) : 0, more = strlen(line);
	char *text = realloc(*into, used + more + 2);

	if (!text)
		return;
	snprintf(text + used, more + 2, "%s\n", line);
	*into = text;
}

void cli_warn_off(int off)
{
	silent = off;
}

void cli_warn(const char *warning)
{
	if (silent)
		return;
	keep(&said, warning);
	if (kept)
		keep(kept, warning);
	else
		cli_say(CLI_WARNING, warning);
}

void cli_caution(const char *brief, const char *warning)
{
	hawser__legend_caution(brief);
	cli_warn(warning);
}

void cli_warnings_json(struct hawser__json *json)
{
	json_t *list = json_object_get(json->root, "warnings") ? NULL /* a list of its own */
	               : hawser__json_array(json, json->root, "warnings");

	for (char *line = list ? said : NULL, *end; line && (end = strchr(line, '\n')); line = end + 1) {
		*end = '\0';
		hawser__json_text(json, list, NULL, line);
		*end = '\n';
	}
}

void cli_warnings_end(void)
{
	free(said);
	said = NULL;
	hawser__legend_caution(NULL);
}
