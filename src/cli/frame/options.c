/* cli/frame/options.c - parse command lines by tables of options.
 *
 * getopt_long would only split the arguments. Suggestions of names, help, and options with two
 * arguments need own code anyway, which makes the splitting a few lines.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/model/label.h"
#include "cli/frame/kinds.h"
#include "cli/frame/view.h"
#include "core/report.h"

enum { most_arguments = 2, most_names = 64 };

const struct cli_option cli_common_options[] = {
	{"json", 0, "FILE", "write the result as JSON (- is standard output)",
	 CLI_STORED_IN(struct cli_common, cli_store_text, json)},
	{"tsv", 0, "FILE", "write the table to a file",
	 CLI_STORED_IN(struct cli_common, cli_store_text, tsv)},
	{"plot", 0, "FILE", "draw a picture: .svg, .png, .pdf, .eps or .tex",
	 CLI_STORED_IN(struct cli_common, cli_store_text, plot)},
	CLI_SET_OPTION,
	CLI_HEADING("Picture"),
	{"title", 0, "TEXT", "a title above the picture",
	 CLI_STORED_IN(struct cli_common, cli_store_title, picture)},
	{"xrange", 0, "A:B", "range of its horizontal axis",
	 CLI_STORED_IN(struct cli_common, cli_store_range, picture.range[0])},
	{"yrange", 0, "A:B", "range of its vertical axis",
	 CLI_STORED_IN(struct cli_common, cli_store_range, picture.range[1])},
	{"size", 0, "WxH", "width and height of the picture in cm",
	 CLI_STORED_IN(struct cli_common, cli_store_size, picture)},
	{"gp", 0, "FILE", "write the picture as a script of gnuplot with its data",
	 CLI_STORED_IN(struct cli_common, cli_store_text, gp)},
	CLI_HEADING("Output"),
	{"units", 0, "LIST", "units of table and picture, such as \"kN, ft, Hz\" (SI)",
	 CLI_STORED_IN(struct cli_common, cli_store_text, units)},
	{"quiet", 'q', "", "no progress and no summary",
	 CLI_STORED_IN(struct cli_common, cli_store_flag, quiet)},
	{"reproducible", 0, "", "no times in results: two runs give the same bytes",
	 CLI_STORED_IN(struct cli_common, cli_store_flag, reproducible)},
	CLI_HELP_OPTION,
	CLI_NO_OPTION,
};

enum hawser_status cli_store_flag(void *field, const struct cli_option *option,
                                  const char *const *values, struct hawser_report *report)
{
	(void)option;
	(void)values;
	(void)report;
	*(int *)field = 1;
	return HAWSER_OK;
}

/* 1 if the word is in a list, whose words are separated by any of `between`. */
static int among(const char *list, const char *between, const char *word, size_t length)
{
	for (; *list; list += strspn(list, between)) {
		size_t own = strcspn(list, between);

		if (own == length && strncmp(list, word, own) == 0)
			return 1;
		list += own;
	}
	return 0;
}

static enum hawser_status not_among(const struct cli_option *option, const char *text,
                                    struct hawser_report *report)
{
	char list[160];
	size_t used = 0;

	for (const char *c = option->words; *c && used < sizeof list - 2; c++) {
		list[used++] = (char)(*c == '|' ? ',' : *c);
		if (*c == '|')
			list[used++] = ' ';
	}
	list[used] = '\0';
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options", "--%s %s: must be one of %s",
	                    option->name, text, list);
}

enum hawser_status cli_store_text(void *field, const struct cli_option *option,
                                  const char *const *values, struct hawser_report *report)
{
	if (!*values[0])
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options", "--%s: the %s is empty",
		                    option->name, option->arguments);
	if (option->words && !among(option->words, "|", values[0], strlen(values[0])))
		return not_among(option, values[0], report);
	*(const char **)field = values[0];
	return HAWSER_OK;
}

enum hawser_status cli_store_two(void *field, const struct cli_option *option,
                                 const char *const *values, struct hawser_report *report)
{
	enum hawser_status status = cli_store_text(field, option, values, report);

	return status ? status : cli_store_text((const char **)field + 1, option, values + 1, report);
}

enum hawser_status cli_store_set(void *field, const struct cli_option *option,
                                 const char *const *values, struct hawser_report *report)
{
	struct cli_common *common = field;

	if (!strchr(values[0], '='))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: write KEY=VALUE, such as cable.EA=\"100 MN\"", option->name,
		                    values[0]);
	if (common->sets == CLI_SETS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "more than %d times --%s: put them into the scene", CLI_SETS,
		                    option->name);
	common->set[common->sets++] = values[0];
	return HAWSER_OK;
}

static enum hawser_status check_most(const struct cli_option *option, const char *text, double value,
                                     struct hawser_report *report)
{
	return !(option->most > 0.0 && value > option->most) ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, "options", "--%s %s: must be at most %g",
		               option->name, text, option->most);
}

enum hawser_status cli_store_positive(void *field, const struct cli_option *option,
                                      const char *const *values, struct hawser_report *report)
{
	char *end;
	double value = strtod(values[0], &end);

	if (end == values[0] || *end || !(value > 0.0) || value > 1e300)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: write a number greater than zero", option->name, values[0]);
	*(double *)field = value;
	return check_most(option, values[0], value, report);
}

static enum hawser_status store_integer(int *field, const struct cli_option *option,
                                        const char *text, long smallest,
                                        struct hawser_report *report)
{
	char *end;
	long value;

	errno = 0;
	value = strtol(text, &end, 10);
	if (end == text || *end || errno || value > INT_MAX || value < INT_MIN)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: write a whole number", option->name, text);
	if (value < smallest)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: must be at least %ld", option->name, text, smallest);
	*field = (int)value;
	return check_most(option, text, (double)value, report);
}

#define INTEGERS(name, smallest) \
	enum hawser_status cli_store_##name(void *field, const struct cli_option *option, \
	                                    const char *const *values, struct hawser_report *report) \
	{ \
		return store_integer(field, option, values[0], smallest, report); \
	}
INTEGERS(integer, 1)
INTEGERS(count, 2)
INTEGERS(every, 0)

const struct cli_option *cli_common_of(const struct cli_command *command)
{
	const struct cli_option *row = command->options;

	while (row->name && strcmp(row->name, "help") != 0)
		row++;
	return row->name ? row + 1 : cli_common_options;
}

/* --- reading a command line --- */

struct reader {
	const struct cli_command *command;
	char *settings;
	char **argument; /* what is left */
	int left;
};

static const struct cli_option *in_table(const struct cli_option *row, const char *name,
                                         size_t length, char letter)
{
	for (; row->name; row++)
		if (row->store && (letter ? row->letter == letter : strlen(row->name) == length &&
		                                                    strncmp(row->name, name, length) == 0))
			return row;
	return NULL;
}

static const struct cli_option *find(const struct reader *reader, const char *name, size_t length,
                                     char letter)
{
	const struct cli_option *row = in_table(reader->command->options, name, length, letter);

	return row ? row : in_table(cli_common_of(reader->command), name, length, letter);
}

const struct cli_option *cli_option_row(const struct cli_command *command, int index)
{
	const struct cli_option *table[] = {command->options, cli_common_of(command)}, *row;

	for (int k = 0; k < 2; k++)
		for (row = table[k]; row->name; row++)
			if (row->store && !(k && in_table(table[0], row->name, strlen(row->name), 0)) &&
			    index-- == 0)
				return row;
	return NULL;
}

static enum hawser_status unknown(const struct reader *reader, const char *name,
                                  struct hawser_report *report)
{
	const struct cli_option *row;
	const char *names[most_names], *best;
	char bare[64];
	int count = 0;

	for (; count < most_names && (row = cli_option_row(reader->command, count)); count++)
		names[count] = row->name;
	snprintf(bare, sizeof bare, "%s", name + strspn(name, "-"));
	bare[strcspn(bare, "=")] = '\0';
	best = cli_nearest(bare, names, count);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
	                    "%s: unknown option %s%s%s%s (hawser %s --help lists all)",
	                    reader->command->name, name, best ? "; did you mean --" : "",
	                    best ? best : "", best ? "?" : "", reader->command->name);
}

/* Number of arguments, by the words of their description. */
static int wanted(const struct cli_option *option)
{
	return !*option->arguments ? 0 : strchr(option->arguments, ' ') ? 2 : 1;
}

/* Remember an option that has rules. */
static void note(struct reader *reader, const struct cli_option *option)
{
	struct cli_common *common = (struct cli_common *)reader->settings;

	for (int i = 0; i < common->givens; i++)
		if (common->given[i] == option)
			return;
	if (common->givens < CLI_GIVEN)
		common->given[common->givens++] = option;
}

/* `attached`: the text after the = or the letter, or NULL. */
static enum hawser_status take(struct reader *reader, const struct cli_option *option,
                               const char *attached, struct hawser_report *report)
{
	const char *values[most_arguments];
	int count = wanted(option), have = 0;

	if (attached && count == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options", "--%s takes no argument",
		                    option->name);
	if (attached)
		values[have++] = attached;
	for (; have < count && reader->left > 0; reader->left--)
		values[have++] = *reader->argument++;
	if (have < count)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options", "--%s needs %s", option->name,
		                    option->arguments);
	note(reader, option);
	return option->store(reader->settings + option->offset, option, values, report);
}

static enum hawser_status long_option(struct reader *reader, const char *text,
                                      struct hawser_report *report)
{
	const char *name = text + 2, *equals = strchr(name, '=');
	size_t length = equals ? (size_t)(equals - name) : strlen(name);
	const struct cli_option *option = find(reader, name, length, 0);

	if (!option)
		return unknown(reader, text, report);
	return take(reader, option, equals ? equals + 1 : NULL, report);
}

static enum hawser_status short_option(struct reader *reader, const char *text,
                                       struct hawser_report *report)
{
	const struct cli_option *option = find(reader, NULL, 0, text[1]);

	if (!option || (text[2] && wanted(option) == 0))
		return unknown(reader, text, report);
	return take(reader, option, text[2] ? text + 2 : NULL, report);
}

static enum hawser_status positional(struct reader *reader, const char *text,
                                     struct hawser_report *report)
{
	struct cli_common *common = (struct cli_common *)reader->settings;

	if (common->input && !common->second && strchr(reader->command->input, ' ')) {
		common->second = text;
		return HAWSER_OK;
	}
	if (common->input && strstr(reader->command->input, "...")) {
		if (common->mores == CLI_MORE_INPUTS)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options", "%s takes at most %d files",
			                    reader->command->name, CLI_MORE_INPUTS + 1);
		common->more[common->mores++] = text;
		return HAWSER_OK;
	}
	if (common->input)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "%s takes one %s, but %s and %s are given%s", reader->command->name,
		                    reader->command->input, common->input, text,
		                    access(text, F_OK) ? " (quote a value with a blank, such as \"5 m\")" : "");
	common->input = text;
	return HAWSER_OK;
}

enum hawser_status cli_parse(void *settings, const struct cli_command *command, int argc,
                             char **argv, struct hawser_report *report)
{
	struct reader reader = {command, settings, argv, argc};
	enum hawser_status status = HAWSER_OK;
	int options = 1;

	while (!status && reader.left > 0) {
		const char *text = *reader.argument++;

		reader.left--;
		if (options && strcmp(text, "--") == 0)
			options = 0;
		else if (options && strncmp(text, "--", 2) == 0)
			status = long_option(&reader, text, report);
		else if (options && text[0] == '-' && text[1])
			status = short_option(&reader, text, report);
		else
			status = positional(&reader, text, report);
	}
	return status;
}

/* --- rules between options --- */

/* 1 if an option is given or, "model=fe", has this value. */
static int holds(const struct cli_command *command, const struct cli_common *common, const char *rule,
                 size_t length)
{
	size_t name = strcspn(rule, "=");
	const struct cli_option *row;
	const char *text;

	for (int i = 0; name >= length && i < common->givens; i++)
		if (strlen(common->given[i]->name) == length && !strncmp(common->given[i]->name, rule, length))
			return 1;
	if (name >= length)
		return 0;
	row = in_table(command->options, rule, name, 0);
	text = row ? *(const char *const *)((const char *)common + row->offset) : NULL;
	length -= name + 1;
	return text && strlen(text) == length && !strncmp(text, rule + name + 1, length);
}

/* The first option of a list that holds, or NULL. */
static const char *first_of(const struct cli_command *command, const struct cli_common *common,
                            const char *list)
{
	for (; *list; list += strspn(list, ", ")) {
		size_t length = strcspn(list, ",");

		if (holds(command, common, list, length))
			return list;
		list += length;
	}
	return NULL;
}

/* "--over KEY=FROM:TO:N or --model fe" */
static void show_rules(char *text, size_t size, const struct cli_command *command, const char *list)
{
	size_t used = 0;

	*text = '\0';
	for (const char *between = ""; *list && used < size; list += strspn(list, ", "), between = " or ") {
		size_t length = strcspn(list, ","), name = strcspn(list, "=,");
		const struct cli_option *row = in_table(command->options, list, name, 0);
		const char *value = name < length ? list + name + 1 : row ? row->arguments : "";
		int shown = name < length ? (int)(length - name - 1) : (int)strlen(value);

		used += (size_t)snprintf(text + used, size - used, "%s--%.*s%s%.*s", between, (int)name, list,
		                         shown ? " " : "", shown, value);
		list += length;
	}
}

enum hawser_status cli_rules_check(const struct cli_command *command, const struct cli_common *common,
                                   struct hawser_report *report)
{
	char text[160];

	for (int i = 0; i < common->givens; i++) {
		const struct cli_option *option = common->given[i];
		const char *other = option->excludes ? first_of(command, common, option->excludes) : NULL;

		if (other) {
			snprintf(text, sizeof text, "%.*s", (int)strcspn(other, ","), other);
			if (strchr(text, '='))
				*strchr(text, '=') = ' ';
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, command->name,
			                    "--%s does not go with --%s: leave out one of them",
			                    option->name, text);
		}
		if (!option->needs || first_of(command, common, option->needs))
			continue;
		show_rules(text, sizeof text, command, option->needs);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command->name, "--%s needs %s: give that",
		                    option->name, text);
	}
	return HAWSER_OK;
}

/* --- help --- */

static void print_option(const struct cli_option *row, FILE *stream)
{
	char left[48];

	snprintf(left, sizeof left, "%s%c%s--%s%s%s", row->letter ? "-" : " ",
	         row->letter ? row->letter : ' ', row->letter ? ", " : "  ", row->name,
	         *row->arguments ? " " : "", row->arguments);
	if (strlen(left) > 27)
		fprintf(stream, "  %s\n%31s%s\n", left, "", row->doc);
	else
		fprintf(stream, "  %-27s  %s\n", left, row->doc);
}

/* The options up to the next heading; returns that, or the last row. `own`: options of the command,
 * which stand in place of common ones of the same name; or NULL. */
static const struct cli_option *print_block(const struct cli_option *row,
                                            const struct cli_option *own, FILE *stream)
{
	for (; row->store; row++)
		if (!own || !in_table(own, row->name, strlen(row->name), 0))
			print_option(row, stream);
	return row;
}

/* The options behind headings. */
static void print_headed(const struct cli_option *row, const struct cli_option *own, FILE *stream)
{
	while (row->name) {
		fprintf(stream, "\n%s:\n", row->doc);
		row = print_block(row + 1, own, stream);
	}
}

void cli_print_help(const struct cli_command *command, FILE *stream)
{
	const struct cli_option *own, *common;
	const char *const *note;

	fprintf(stream, "Usage: hawser %s %s [options]\n\n%s.\n", command->name, command->input,
	        command->summary);
	for (note = command->notes; note && *note; note++)
		fprintf(stream, "%s\n", *note);
	fputs("\nOptions:\n", stream);
	own = print_block(command->options, NULL, stream);
	common = print_block(cli_common_of(command), command->options, stream);
	print_headed(own, NULL, stream);
	print_headed(common, command->options, stream);
	fprintf(stream, "\nMore: man hawser-%.*s, man hawser-scene\n",
	        (int)strcspn(command->name, " "), command->name);
}

void cli_print_columns(const struct cli_command *command, FILE *stream)
{
	const struct cli_listing *row = command->listing;

	fprintf(stream, "Results of hawser %s; man hawser-%.*s says more.\n", command->name,
	        (int)strcspn(command->name, " "), command->name);
	if (!row)
		fputs("It prints no table.\n", stream);
	for (int i = -1; i < (command->part ? CLI_KINDS_ALL : 0); i++)
		for (row = i < 0 ? row : cli_part_of(command, i)->listing; row && row->title; row++)
			hawser__fields_print(stream, row->title, row->field, row->json);
}
