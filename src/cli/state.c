/* cli/state.c - a state to start from, out of a file that this program or anyone else wrote.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "core/report.h"

enum { most_characters = 1 << 24 };

static char *slurp(const char *path, struct hawser_report *report)
{
	FILE *stream = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
	char *text = stream ? malloc(most_characters) : NULL;
	size_t got = 0;

	if (text)
		got = fread(text, 1, most_characters - 1, stream);
	if (!stream || (text && ferror(stream))) {
		(void)hawser__fail(report, HAWSER_ERR_IO, "state", "cannot read %s: %s", path,
		                   strerror(errno));
		free(text);
		text = NULL;
	} else if (!text) {
		(void)hawser__no_memory(report, "state");
	} else {
		text[got] = '\0';
	}
	if (stream && stream != stdin)
		fclose(stream);
	return text;
}

static enum hawser_status refuse(struct hawser_report *report, const char *path, int n,
                                 const char *why)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "state",
	                    "%s: %s; a state of this model is %d numbers, u_1 to u_%d and then their "
	                    "velocities", path, why, 2*n, n);
}

/* count numbers from a list, or 0. */
static int from_list(double *state, int count, const json_t *list)
{
	int i;

	if (!json_is_array(list) || json_array_size(list) != (size_t)count)
		return 0;
	for (i = 0; i < count; i++) {
		const json_t *number = json_array_get(list, (size_t)i);

		if (!json_is_number(number))
			return 0;
		state[i] = json_number_value(number);
	}
	return 1;
}

static int from_json(double *state, int n, const json_t *root)
{
	const json_t *rows = json_object_get(root, "states"), *v = json_object_get(root, "v");

	if (json_is_array(root))
		return from_list(state, 2*n, root);
	if (json_object_get(root, "state"))
		return from_list(state, 2*n, json_object_get(root, "state"));
	if (json_is_array(rows) && json_array_size(rows) > 0)
		return from_list(state, 2*n, json_array_get(rows, json_array_size(rows) - 1));
	return from_list(state, n, json_object_get(root, "u")) && (!v || from_list(state + n, n, v));
}

/* Numbers between blanks, commas or line ends; lines that begin with # are skipped. */
static int from_text(double *state, int count, const char *text)
{
	int found = 0;
	char *end;

	for (;;) {
		text += strspn(text, " \t\r\n,;");
		if (*text == '#') {
			text += strcspn(text, "\n");
			continue;
		}
		if (!*text)
			return found == count;
		if (found == count)
			return 0;
		state[found++] = strtod(text, &end);
		if (end == text)
			return 0;
		text = end;
	}
}

enum hawser_status cli_state_open(double **state, const char *path, const struct cli_model *model,
                                  struct hawser_report *report)
{
	int n = model->rom.n, read = 0, i;
	double length = cli_per_length(model), rate = length*cli_per_omega(model);
	char *text = slurp(path, report);
	json_t *root;

	*state = text ? calloc((size_t)(2*n), sizeof **state) : NULL;
	if (!*state) {
		free(text);
		return text ? hawser__no_memory(report, "state") : report ? report->status : HAWSER_ERR_IO;
	}
	root = json_loads(text, 0, NULL);
	read = root ? from_json(*state, n, root) : from_text(*state, 2*n, text);
	json_decref(root);
	free(text);
	for (i = 0; i < 2*n && read; i++) {
		read = isfinite((*state)[i]);
		(*state)[i] /= i < n ? length : rate;
	}
	if (read)
		return HAWSER_OK;
	free(*state);
	*state = NULL;
	return refuse(report, path, n, "does not hold a state");
}
