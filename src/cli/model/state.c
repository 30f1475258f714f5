/* cli/model/state.c - reads an initial state from a result of this program or from another file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/state.h"
#include "core/report.h"

static const size_t most_characters = (size_t)1 << 30;

/* Room for `used` characters, another piece and the terminating zero. */
static int make_room(char **text, size_t *room, size_t used, size_t piece)
{
	char *more;

	if (used + piece < *room)
		return 1;
	*room = 2*(used + piece);
	more = realloc(*text, *room);
	if (more)
		*text = more;
	return more != NULL;
}

static enum hawser_status read_all(char **text, size_t *size, FILE *stream, const char *path,
                                   struct hawser_report *report)
{
	enum { piece = 65536 };
	size_t room = 0, got;

	do {
		if (!make_room(text, &room, *size, piece))
			return hawser__no_memory(report, "state");
		got = fread(*text + *size, 1, piece, stream);
		*size += got;
	} while (got > 0 && *size <= most_characters);
	if (ferror(stream))
		return hawser__fail(report, hawser__unreadable(errno), "state", "cannot read %s: %s",
		                    path, strerror(errno));
	if (*size > most_characters)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "state",
		                    "%s is larger than 1 GiB: give a file with the last state alone",
		                    path);
	(*text)[*size] = '\0';
	return HAWSER_OK;
}

/* *text is to be freed in any case. */
static enum hawser_status slurp(char **text, size_t *size, const char *path,
                                struct hawser_report *report)
{
	FILE *stream = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
	enum hawser_status status;

	if (!stream)
		return hawser__fail(report, hawser__unreadable(errno), "state", "cannot read %s: %s",
		                    path, strerror(errno));
	status = read_all(text, size, stream, path, report);
	if (stream != stdin)
		fclose(stream);
	return status;
}

enum hawser_status cli_state_refuse(struct hawser_report *report, const char *path, int n,
                                    const char *why)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "state",
	                    "%s: %s; a state of this model is %d numbers, u_1 to u_%d and then their "
	                    "velocities", path, why, 2*n, n);
}

/* Returns 0 if the list does not consist of `count` numbers. */
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

static const json_t *last_of(const json_t *list)
{
	return json_array_get(list, json_array_size(list) - 1);
}

static int from_json(double *state, int n, const json_t *root)
{
	const json_t *rows = json_object_get(root, "states"), *v = json_object_get(root, "v");
	const json_t *points = json_object_get(root, "points");

	if (json_is_array(root))
		return from_list(state, 2*n, root);
	if (json_object_get(root, "state"))
		return from_list(state, 2*n, json_object_get(root, "state"));
	if (json_array_size(rows) > 0)
		return from_list(state, 2*n, last_of(rows));
	if (json_array_size(points) > 0)
		return from_list(state, 2*n, json_object_get(last_of(points), "state"));
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

/* jansson reports a failed allocation as an error of the text. An error of the text occurs the second
 * time too. */
static enum hawser_status read_json(json_t **root, const char *text, size_t size, const char *path,
                                    struct hawser_report *report)
{
	json_error_t error;

	*root = json_loadb(text, size, 0, &error);
	if (!*root)
		*root = json_loadb(text, size, 0, &error);
	if (*root)
		return HAWSER_OK;
	if (error.line < 1 && !*error.text)
		return hawser__no_memory(report, "state");
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "state", "%s:%d: %s", path, error.line,
	                    error.text);
}

/* Text that begins like JSON is read as JSON, so that the line of an error can be reported. */
static int like_json(const char *text)
{
	char first = text[strspn(text, " \t\r\n")];

	return first == '{' || first == '[';
}

static enum hawser_status parse(int *read, double *state, int n, const char *text, size_t size,
                                const char *path, struct hawser_report *report)
{
	enum hawser_status status;
	json_t *root;

	if (!like_json(text)) {
		*read = strlen(text) == size && from_text(state, 2*n, text);
		return HAWSER_OK;
	}
	status = read_json(&root, text, size, path, report);
	if (!status)
		*read = from_json(state, n, root);
	json_decref(root);
	return status;
}

enum hawser_status cli_state_check(const char *option, const char *path,
                                   const struct cli_common *common, struct hawser_report *report)
{
	if (!path || strcmp(path, "-") != 0 || strcmp(common->input, "-") != 0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "state",
	                    "--%s - and the input - are both standard input: give one of them as a "
	                    "file", option);
}

/* Converts to the model's scale. Returns 1 if all numbers are finite. */
static int scale(double *state, const struct cli_model *model)
{
	double length = cli_per_length(model), rate = length*cli_per_omega(model);
	int n = model->rom.n, good = 1;

	for (int i = 0; i < 2*n; i++) {
		good &= isfinite(state[i]) != 0;
		state[i] /= i < n ? length : rate;
	}
	return good;
}

int cli_state_take(double *state, const json_t *list, const struct cli_model *model)
{
	return from_list(state, 2*model->rom.n, list) && scale(state, model);
}

enum hawser_status cli_state_open(double **state, const char *path, const struct cli_model *model,
                                  struct hawser_report *report)
{
	int n = model->rom.n, read = 0;
	char *text = NULL;
	size_t size = 0;
	enum hawser_status status = slurp(&text, &size, path, report);

	*state = status ? NULL : calloc(2*(size_t)n, sizeof **state);
	if (!status && !*state)
		status = hawser__no_memory(report, "state");
	if (!status)
		status = parse(&read, *state, n, text, size, path, report);
	free(text);
	if (!status && !(read && scale(*state, model)))
		status = cli_state_refuse(report, path, n, "does not hold a state");
	if (status) {
		free(*state);
		*state = NULL;
	}
	return status;
}

enum hawser_status cli_state_root(json_t **root, const char *path, struct hawser_report *report)
{
	char *text = NULL;
	size_t size = 0;
	enum hawser_status status = slurp(&text, &size, path, report);

	*root = NULL;
	if (!status && like_json(text))
		status = read_json(root, text, size, path, report);
	free(text);
	return status;
}
