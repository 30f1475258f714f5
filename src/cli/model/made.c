/* cli/model/made.c - what models of scenes that are no spans have in common: see made.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/model/made.h"
#include "core/append.h"
#include "core/report.h"

enum { LIST = 400 }; /* characters of a list of modes */

void cli_made_modes_clear(struct cli_made_modes *modes)
{
	if (modes->lines.n > 0)
		modes->modes.mode = NULL;
	hawser_line_modes_clear(&modes->lines);
	hawser_modes_clear(&modes->modes);
}

void cli_made_free(struct cli_made *made)
{
	if (!made)
		return;
	cli_made_modes_clear(&made->modes);
	made->by->clear(made);
	free(made);
}

enum hawser_status cli_made_keep(int *kept, int *count, int *n, const char *list,
                                 const struct cli_maker *by, struct hawser_report *report)
{
	const char *from = list;
	char *end;
	int last = 0;

	if (*n > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "--keep %s says which modes are kept: "
		                    "leave out --modes %d", list, *n);
	do {
		long index = strtol(from, &end, 10);

		if (end == from || index <= last || index > by->most || (*end && *end != ','))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "--keep %s: give numbers of modes "
			                    "from 1 to %d, ascending, such as 1,4,6", list, by->most);
		kept[(*count)++] = (last = (int)index) - 1;
		from = end + 1;
	} while (*end);
	*n = last;
	return HAWSER_OK;
}

void cli_made_warn(const struct cli_model *model)
{
	if (model->made && model->made->modes.alone)
		cli_warn("the modes of the net's mesh and of one with half as many elements are not alike, and "
		         "an error of second order in the length of the elements stays in the model: give "
		         "cables more elements, or keep fewer modes (-n)");
}

int cli_made_loaded(const struct hawser_rom *rom, int j)
{
	double all = 0.0, own = 0.0;

	for (int h = 0; h < rom->harmonics; h++)
		for (int k = 0; rom->harmonic[h].f && k < rom->n; k++) {
			double f = fabs(rom->harmonic[h].f[k])/rom->K[k*(rom->n + 1)];

			all = fmax(all, f);
			own = k == j ? fmax(own, f) : own;
		}
	return own > 1e-12*all; /* chosen: loads of modes out of the plane are 0 up to some 1e-16 */
}

/* "1,4,6" */
static const char *list_of(char *list, size_t size, const struct hawser_modes *modes)
{
	*list = '\0';
	for (int k = 0; k < modes->n; k++)
		hawser__append(list, size, ",", "%d", modes->mode[k].place);
	return list;
}

void cli_made_chosen(struct hawser__table *table, const struct cli_model *model)
{
	const struct cli_made *made = model->made;
	char list[LIST];

	if (made->chosen > 0)
		hawser__table_comment(table, "%d of %d modes chosen: --keep %s", made->modes.modes.n,
		                      made->chosen, list_of(list, sizeof list, &made->modes.modes));
}

void cli_made_breaking_warn(const struct cli_model *model, double omega)
{
	double most = model->made ? model->made->breaking : 0.0, at = omega*cli_per_omega(model);
	char text[CLI_WARNING_SIZE];

	if (!(most > 0.0) || !(at > most*(1.0 + 1e-9)))
		return;
	snprintf(text, sizeof text, "waves of this height break above Omega = %.6g rad/s, and Omega "
	         "reaches %.6g rad/s: there are no such waves", most, at);
	cli_warn(text);
}

void cli_made_inertia(struct hawser__table *table, const struct hawser_rom *rom)
{
	if (rom->inertia.shift > 0.0)
		hawser__table_comment(table, "inertia of what follows: frequencies of resonance lower by up "
		                      "to %.1e, of which %d second-order shapes leave %.1e",
		                      rom->inertia.shift, rom->inertia.shapes,
		                      rom->inertia.left);
}

/* --- the options by which a model is made again --- */

static const struct {
	const char *key;
	size_t at;
} by_text[] = {
	{"load", offsetof(struct cli_lane_choice, load)},
	{"carriers", offsetof(struct cli_lane_choice, carriers)},
	{"lane", offsetof(struct cli_lane_choice, lane)},
	{"contact", offsetof(struct cli_lane_choice, contact)},
	{"case", offsetof(struct cli_lane_choice, load_case)},
	{"keep", offsetof(struct cli_lane_choice, keep)},
}, by_number[] = {
	{"ripple", offsetof(struct cli_lane_choice, ripple)},
	{"damping", offsetof(struct cli_lane_choice, damping)},
};
enum { TEXTS = sizeof by_text/sizeof *by_text, NUMBERS = sizeof by_number/sizeof *by_number };

void cli_made_json(struct hawser__json *json, json_t *into, const void *row)
{
	const struct cli_frf_result *result = row;
	struct cli_lane_choice choice = result->common->lane;
	char list[LIST];
	json_t *object, *sets;

	if (!result->model->made && result->common->sets == 0)
		return;
	object = hawser__json_object(json, into, "made");
	sets = result->common->sets > 0 ? hawser__json_array(json, object, "set") : NULL;
	for (int i = 0; i < result->common->sets; i++)
		hawser__json_text(json, sets, NULL, result->common->set[i]);
	if (!result->model->made)
		return;
	choice.keep = list_of(list, sizeof list, &result->model->made->modes.modes);
	for (int i = 0; i < TEXTS; i++) {
		const char *text = *(const char *const *)((const char *)&choice + by_text[i].at);

		if (text)
			hawser__json_text(json, object, by_text[i].key, text);
	}
	for (int i = 0; i < NUMBERS; i++) {
		double value = *(const double *)(const void *)((const char *)&choice + by_number[i].at);

		if (value > 0.0)
			hawser__json_number(json, object, by_number[i].key, value);
	}
}

void cli_made_as(struct cli_common *common, int n, const json_t *root)
{
	const json_t *made = json_object_get(root, "made"), *sets = json_object_get(made, "set");
	struct cli_lane_choice *to = &common->lane;
	int old = common->sets, more = (int)json_array_size(sets);

	/* before those of this command, which win */
	if (old + more <= CLI_SETS) {
		memmove(common->set + more, common->set, (size_t)old*sizeof *common->set);
		for (int i = 0; i < more; i++) {
			const char *text = json_string_value(json_array_get(sets, (size_t)i));

			common->set[i] = text ? text : "";
		}
		common->sets += more;
	}
	for (int i = 0; i < TEXTS; i++) {
		const char **text = (const char **)((char *)to + by_text[i].at);

		if (!*text && !(n > 0 && text == &to->keep))
			*text = json_string_value(json_object_get(made, by_text[i].key));
	}
	for (int i = 0; i < NUMBERS; i++) {
		double *value = (double *)(void *)((char *)to + by_number[i].at);

		if (!(*value > 0.0))
			*value = json_number_value(json_object_get(made, by_number[i].key));
	}
}
