/* cli/sweep/sweep_plan.c - the variations of a sweep, from --over and --list. See sweep.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/model/key_sweep.h"
#include "cli/report/report.h"
#include "cli/sweep/sweep.h"
#include "core/append.h"
#include "core/report.h"

/* --- values --- */

/* The blanks at both ends are cut off. */
static char *trim(char *text)
{
	size_t length;

	text += strspn(text, " \t");
	length = strlen(text);
	while (length > 0 && isspace((unsigned char)text[length - 1]))
		text[--length] = '\0';
	return text;
}

/* A finite number, and the unit behind it; 0 if the text is something else. */
static int number_of(double *number, const char **unit, const char *text)
{
	char *end;

	if (!strchr("+-.0123456789", *text) || !*text)
		return 0;
	*number = strtod(text, &end);
	*unit = end + strspn(end, " ");
	return end != text && isfinite(*number);
}

/* Numbers, if all texts of the key are, with the same unit. A number without unit among such
 * with one would be in SI, which nobody means. */
static enum hawser_status read_numbers(struct cli_sweep_key *key, long values, const char *option,
                                       struct hawser_report *report)
{
	const char *unit = "", *first = NULL;
	int bare = 0, united = 0;

	key->number = calloc((size_t)values, sizeof *key->number);
	if (!key->number)
		return hawser__no_memory(report, "sweep");
	for (long i = 0; i < values; i++)
		if (strlen(key->key) + 1 + strlen(key->text[i]) >= CLI_SWEEP_SET)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "--%s: value %ld of %s has more "
			                    "than %d characters: put it into the scene", option, i + 1, key->key,
			                    CLI_SWEEP_SET - 2 - (int)strlen(key->key));
	key->numbers = 1;
	for (long i = 0; i < values && key->numbers; i++) {
		key->numbers = number_of(&key->number[i], &unit, key->text[i]);
		bare += key->numbers && !*unit;
		united += key->numbers && *unit;
		if (!first)
			first = unit;
		if (bare && united)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
			                    "--%s: some values of %s have a "
			                    "unit and some have none: write it at each", option, key->key);
		key->numbers = key->numbers && strcmp(unit, first) == 0 && strlen(unit) < sizeof key->unit;
	}
	if (key->numbers && first)
		snprintf(key->unit, sizeof key->unit, "%s", first);
	return HAWSER_OK;
}

/* The name of the key's column: with its unit, or the SI unit of numbers where it is known. */
static void name_column(struct cli_sweep_key *key)
{
	char end[HAWSER__UNIT_SIZE + 2];
	const char *unit = key->unit;

	if (!*unit && key->numbers && strcmp(cli_key_unit(key->key), "1") != 0)
		unit = cli_key_unit(key->key);
	hawser__unit_end(end, sizeof end, unit);
	snprintf(key->column, sizeof key->column, "%s%s", key->key, end);
}

/* --- --over KEY=FROM:TO:N and KEY=a,b,c --- */

static enum hawser_status read_range(struct cli_sweep_key *key, struct cli_sweep_axis *axis,
                                     const char *over, struct hawser_report *report)
{
	struct cli_key_sweep range = {.command = "sweep", .over = over, .most = CLI_SWEEP_MOST,
	                              .example = "tension.T0=60 kN:100 kN:9"};
	enum hawser_status status = cli_key_sweep_read(&range, report);

	key->number = range.value;
	if (status)
		return status;
	key->numbers = 1;
	axis->values = range.points;
	snprintf(key->unit, sizeof key->unit, "%s", trim(range.si));
	return HAWSER_OK;
}

/* How often the text has the letter outside of brackets and quotes. */
static long count_outside(const char *text, char wanted)
{
	long count = 0;
	int depth = 0, quoted = 0;

	for (; *text; text++) {
		quoted ^= *text == '"';
		depth += (*text == '[' || *text == '{') - (*text == ']' || *text == '}');
		count += *text == wanted && depth == 0 && !quoted;
	}
	return count;
}

/* The length of the text up to the next comma outside of brackets and quotes. */
static size_t part_length(const char *text)
{
	size_t length = 0;
	int depth = 0, quoted = 0;

	for (; text[length] && !(text[length] == ',' && depth == 0 && !quoted); length++) {
		quoted ^= text[length] == '"';
		depth += (text[length] == '[' || text[length] == '{') -
		         (text[length] == ']' || text[length] == '}');
	}
	return length;
}

static enum hawser_status read_parts(struct cli_sweep_key *key, struct cli_sweep_axis *axis,
                                     const char *values, struct hawser_report *report)
{
	const char *from = values;

	axis->values = count_outside(values, ',') + 1;
	key->text = calloc((size_t)axis->values, sizeof *key->text);
	if (!key->text)
		return hawser__no_memory(report, "sweep");
	for (long i = 0; i < axis->values; i++) {
		size_t length = part_length(from);
		char *part = strndup(from, length);

		key->text[i] = part ? strdup(trim(part)) : NULL;
		free(part);
		if (!key->text[i])
			return hawser__no_memory(report, "sweep");
		if (!*key->text[i])
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
			                    "--over %s=%s: value %ld is empty",
			                    key->key, values, i + 1);
		from += length + 1;
	}
	return HAWSER_OK;
}

/* `listed`: the values are in brackets. */
static enum hawser_status read_values(struct cli_sweep_key *key, struct cli_sweep_axis *axis,
                                      const char *given, int listed, struct hawser_report *report)
{
	char *values = strdup(given + listed);
	enum hawser_status status;

	if (!values)
		return hawser__no_memory(report, "sweep");
	if (listed)
		values[strlen(values) - 1] = '\0';
	status = read_parts(key, axis, values, report);
	free(values);
	return status ? status : read_numbers(key, axis->values, "over", report);
}

static enum hawser_status new_key(struct cli_sweep_key **key, struct cli_sweep_plan *plan,
                                  const char *name, size_t length, const char *option,
                                  struct hawser_report *report)
{
	*key = &plan->key[plan->keys];
	if (plan->keys == CLI_SWEEP_KEYS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "a sweep varies at most %d keys",
		                    CLI_SWEEP_KEYS);
	if (length == 0 || length >= sizeof (*key)->key)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "--%s %s: the name of the key is "
		                    "%s", option, name, length ? "too long" : "missing");
	snprintf((*key)->key, sizeof (*key)->key, "%.*s", (int)length, name);
	for (int k = 0; k < plan->keys; k++)
		if (strcmp(plan->key[k].key, (*key)->key) == 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
			                    "%s is varied twice: write all "
			                    "its values in one option", (*key)->key);
	plan->keys++;
	return HAWSER_OK;
}

/* Whether the values are one list "[A, B, C]": not where the key has such a list as its value. */
static int is_list(const struct cli_common *common, const char *over, const char *values)
{
	char set[1][CLI_SWEEP_SET];
	size_t length = strlen(values);

	if (*values != '[' || values[length - 1] != ']' || count_outside(values, ',') > 0)
		return 0;
	snprintf(set[0], sizeof set[0], "%s", over);
	return cli_kind(common) == HAWSER_KIND_MODEL || cli_sweep_reads(common, set, 1, NULL);
}

static enum hawser_status add_over(struct cli_sweep_plan *plan, const struct cli_common *common,
                                   const char *over, struct hawser_report *report)
{
	struct cli_sweep_axis *axis = &plan->axis[plan->axes++];
	const char *equals = strchr(over, '=');
	struct cli_sweep_key *key;
	long colons;
	enum hawser_status status;

	*axis = (struct cli_sweep_axis){.first = plan->keys};
	if (!equals || !equals[1])
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "--over %s: write KEY=FROM:TO:N, such "
		                    "as \"tension.T0=60 kN:100 kN:9\", or KEY=a,b,c", over);
	status = new_key(&key, plan, over, (size_t)(equals - over), "over", report);
	if (status)
		return status;
	axis->keys = 1;
	colons = count_outside(equals + 1, ':');
	status = colons > 0 ? read_range(key, axis, over, report)
	                    : read_values(key, axis, equals + 1, is_list(common, over, equals + 1), report);
	name_column(key);
	return status;
}

/* --- --list FILE: a table with a column for each key, a row for each variation --- */

/* The next line of the text, without comments and blank ones; NULL at its end. */
static char *next_line(char **text, long *number)
{
	while (*text && **text) {
		char *line = *text, *end = strchr(line, '\n');

		*text = end ? end + 1 : NULL;
		if (end)
			*end = '\0';
		++*number;
		if (line[strspn(line, " \t\r")] != '\0' && line[strspn(line, " ")] != '#')
			return line;
	}
	return NULL;
}

static int count_tabs(const char *line)
{
	int count = 0;

	for (; *line; line++)
		count += *line == '\t';
	return count;
}

/* Keys from the first line; "KEY (UNIT)": that unit is put behind each number. */
static enum hawser_status list_keys(struct cli_sweep_plan *plan, struct cli_sweep_axis *axis,
                                    char unit[][HAWSER__UNIT_SIZE], char *line,
                                    struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	char *cell;

	while (!status && (cell = strsep(&line, "\t"))) {
		char *open = strchr(cell, '('), *close = open ? strchr(open, ')') : NULL;
		struct cli_sweep_key *key;

		if (open)
			*open = '\0';
		if (close)
			*close = '\0';
		cell = trim(cell);
		status = new_key(&key, plan, cell, strlen(cell), "list", report);
		if (!status)
			snprintf(unit[axis->keys++], HAWSER__UNIT_SIZE, "%s", close ? trim(open + 1) : "");
	}
	return status;
}

static enum hawser_status list_row(struct cli_sweep_plan *plan, const struct cli_sweep_axis *axis,
                                   char unit[][HAWSER__UNIT_SIZE], char *line, const char *path,
                                   long number, struct hawser_report *report)
{
	if (count_tabs(line) + 1 != axis->keys)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "%s:%ld: %d values, but the first row "
		                    "names %d keys: tabs separate them", path, number, count_tabs(line) + 1,
		                    axis->keys);
	for (int k = 0; k < axis->keys; k++) {
		struct cli_sweep_key *key = &plan->key[axis->first + k];
		char *cell = trim(strsep(&line, "\t"));
		int length;

		if (!*cell)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
			                    "%s:%ld: the value of %s is empty",
			                    path, number, key->key);
		length = (int)(strlen(cell) + strlen(unit[k]) + 2);
		key->text[axis->values - 1] = malloc((size_t)length);
		if (!key->text[axis->values - 1])
			return hawser__no_memory(report, "sweep");
		snprintf(key->text[axis->values - 1], (size_t)length, "%s%s%s", cell, *unit[k] ? " " : "",
		         unit[k]);
	}
	return HAWSER_OK;
}

static enum hawser_status list_rows(struct cli_sweep_plan *plan, struct cli_sweep_axis *axis,
                                    char *text, size_t most, const char *path,
                                    struct hawser_report *report)
{
	char unit[CLI_SWEEP_KEYS][HAWSER__UNIT_SIZE];
	long number = 0;
	char *line = next_line(&text, &number);
	enum hawser_status status = HAWSER_OK;

	if (line)
		status = list_keys(plan, axis, unit, line, report);
	for (int k = 0; k < axis->keys && !status; k++) {
		plan->key[axis->first + k].text = calloc(most, sizeof(char *));
		if (!plan->key[axis->first + k].text)
			status = hawser__no_memory(report, "sweep");
	}
	while (!status && (line = next_line(&text, &number))) {
		axis->values++;
		status = list_row(plan, axis, unit, line, path, number, report);
	}
	if (!status && axis->values == 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                      "--list %s has no variations: write "
		                      "a row of keys, and below it a row of values for each, separated by "
		                      "tabs", path);
	return status;
}

static enum hawser_status add_list(struct cli_sweep_plan *plan, const char *path,
                                   struct hawser_report *report)
{
	struct cli_sweep_axis *axis = &plan->axis[plan->axes++];
	char *text;
	size_t size, lines = 2;
	enum hawser_status status = cli_report_text(&text, &size, path, report);

	*axis = (struct cli_sweep_axis){.first = plan->keys};
	for (size_t i = 0; i < size; i++)
		lines += text[i] == '\n';
	if (!status)
		status = list_rows(plan, axis, text, lines, path, report);
	free(text);
	for (int k = axis->first; k < axis->first + axis->keys && !status; k++) {
		status = read_numbers(&plan->key[k], axis->values, "list", report);
		name_column(&plan->key[k]);
	}
	return status;
}

/* --- all --- */

enum hawser_status cli_sweep_plan_open(struct cli_sweep_plan *plan, const struct cli_common *common,
                                       const char *const *over, int overs, const char *list,
                                       struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (overs == 0 && !list)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "nothing is varied: give --over "
		                    "KEY=FROM:TO:N, such as \"tension.T0=60 kN:100 kN:9\", or --list FILE");
	if (list)
		status = add_list(plan, list, report);
	for (int i = 0; i < overs && !status; i++)
		status = add_over(plan, common, over[i], report);
	plan->count = 1;
	for (int k = 0; k < plan->axes && !status; k++) {
		if (plan->axis[k].values > CLI_SWEEP_MOST/plan->count)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
			                    "more than %d variations: give "
			                    "fewer values, or several sweeps", CLI_SWEEP_MOST);
		plan->count *= plan->axis[k].values;
	}
	return status;
}

void cli_sweep_plan_clear(struct cli_sweep_plan *plan)
{
	for (int a = 0; a < plan->axes; a++)
		for (int k = plan->axis[a].first; k < plan->axis[a].first + plan->axis[a].keys; k++) {
			for (long i = 0; plan->key[k].text && i < plan->axis[a].values; i++)
				free(plan->key[k].text[i]);
			free(plan->key[k].text);
			free(plan->key[k].number);
		}
	memset(plan, 0, sizeof *plan);
}

long cli_sweep_at(const struct cli_sweep_plan *plan, int key, long variation)
{
	for (int a = plan->axes - 1; a >= 0; a--) {
		if (key >= plan->axis[a].first)
			return variation % plan->axis[a].values;
		variation /= plan->axis[a].values;
	}
	return 0;
}

void cli_sweep_set(char set[CLI_SWEEP_SET], const struct cli_sweep_plan *plan, int key,
                   long variation)
{
	const struct cli_sweep_key *of = &plan->key[key];
	long at = cli_sweep_at(plan, key, variation);

	if (of->text)
		snprintf(set, CLI_SWEEP_SET, "%s=%s", of->key, of->text[at]);
	else
		snprintf(set, CLI_SWEEP_SET, "%s=%.17g%s%s", of->key, of->number[at], *of->unit ? " " : "",
		         of->unit);
}

void cli_sweep_name(char *text, size_t size, const struct cli_sweep_plan *plan, long variation)
{
	*text = '\0';
	for (int k = 0; k < plan->keys; k++) {
		const struct cli_sweep_key *of = &plan->key[k];
		long at = cli_sweep_at(plan, k, variation);

		if (of->text)
			hawser__append(text, size, ", ", "%s = %s", of->key, of->text[at]);
		else
			hawser__append(text, size, ", ", "%s = %.10g%s%s", of->key, of->number[at],
			               *of->unit ? " " : "", of->unit);
	}
}
