/* scene/page/manpage.c - a program of the build that writes hawser-scene(5), in man(7): it copies
 * man/hawser-scene.5.in from standard input, and puts what the tables of keys say in the place of lines
 *
 *   .\" @sections span     the sections of spans with their keys
 *   .\" @keys PATH         the keys directly in a mapping
 *   .\" @kind KIND         all keys of a kind
 *   .\" @example, .\" @plausible
 *
 * and of "@VERSION@", and "@most span.attach@", the largest number of items.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include <hawser/plausible.h>

#include "scene/page/schema.h"
#include "scene/tree_keys.h"

/* Backslashes, and hyphens as minus. */
static void put_text(const char *from)
{
	if (*from == '.' || *from == '\'')
		fputs("\\&", stdout);
	for (; *from; from++)
		if (*from == '\\')
			fputs("\\e", stdout);
		else if (*from == '-')
			fputs("\\-", stdout);
		else if (*from == '^')
			fputs("\\(ha", stdout);
		else
			putchar(*from);
}

/* capital: 1, it begins with a capital letter. */
static void put_sentence(const char *from, int capital)
{
	int column = 0;

	while (*from) {
		int length = (int)strcspn(from, " ");

		if (column && column + length > 72) {
			putchar('\n');
			column = 0;
		}
		if (column)
			column += printf(" ");
		for (column += length; length > 0; length--, from++)
			if (*from == '^')
				fputs("\\(ha", stdout);
			else {
				putchar(capital ? toupper((unsigned char)*from) : *from);
				capital = 0;
			}
		from += *from == ' ';
	}
}

/* "cables[].EA", "nodes.NAME" */
static void path_of(const char *path)
{
	for (path = strchr(path, '.') + 1; *path; path++)
		if (*path == '*') {
			fputs("NAME", stdout);
			path += path[1] == '*';
		} else {
			putchar(*path);
		}
	putchar('\n');
}

static void form(const struct hawser__tree_key *row)
{
	int number = row->type == HAWSER__TREE_NUMBER;
	const char *unit = number && row->unit && strcmp(row->unit, "1") != 0 ? row->unit : "";
	char what[400];

	if (row->type == HAWSER__TREE_INTEGER)
		snprintf(what, sizeof what, "Whole number from %.0f to %.0f", row->least, row->most);
	else if (row->type == HAWSER__TREE_POSITION)
		snprintf(what, sizeof what, "Fraction of the length, or length in m");
	else if (row->type == HAWSER__TREE_WORD || row->type == HAWSER__TREE_LIMIT)
		snprintf(what, sizeof what, "%s%s", strchr(row->unit, '|') ? "One of " : "The word ",
		         row->unit);
	else if (row->count)
		snprintf(what, sizeof what, "List of %d numbers", row->count);
	else
		snprintf(what, sizeof what, "%s", number ? "Number"
		         : row->type == HAWSER__TREE_TEXT ? "Name"
		         : row->type == HAWSER__TREE_LIST ? "List" : "Mapping");
	put_sentence(row->doc, 0);
	fputs(".\n", stdout);
	put_text(what);
	fputs(*unit ? " in " : "", stdout);
	put_text(unit);
	if (row->range) {
		fputs(", ", stdout);
		put_text(hawser__tree_limits(row->range)->text);
	}
	if (number && row->most > 0.0)
		printf(", at most %g", row->most);
	if (row->need == HAWSER__TREE_REQUIRED || row->need == HAWSER__TREE_ONE_OF)
		fputs(row->need == HAWSER__TREE_REQUIRED ? "; required" : "; one of these", stdout);
	if (row->given && *row->given) {
		fputs("; default ", stdout);
		put_text(row->given);
	}
	fputs(".\n", stdout);
}

static void key(const struct hawser__tree_key *row)
{
	const char *path = row->path;

	if (hawser__tree_next(NULL, path) != row)
		return;
	fputs(".TP\n.B ", stdout);
	path_of(path);
	for (; row; row = hawser__tree_next(row, path)) {
		form(row);
		if (hawser__tree_next(row, path))
			fputs("Or\n", stdout);
	}
}

/* The rows of list items that are those of a single value, too, such as "rod.rod[].EA". */
static int twin(const struct hawser__tree_table *table, const char *path)
{
	const char *item = strstr(path, "[]");

	for (int i = 0; item && i < table->rows; i++) {
		const char *other = table->row[i].path;
		size_t length = (size_t)(item - path);

		if (!strncmp(other, path, length) && !strcmp(other + length, item + 2) &&
		    (item[2] || table->row[i].type == HAWSER__TREE_MAPPING))
			return 1;
	}
	return 0;
}

/* --- the parts --- */

static void all_keys(const char *kind)
{
	const struct hawser__tree_table *table = hawser__tree_table(kind);

	for (int i = 0; i < table->rows; i++)
		if (!twin(table, table->row[i].path) && table->row[i].need != HAWSER__TREE_MESH)
			key(&table->row[i]);
}

static void keys_in(const char *of)
{
	const struct hawser__tree_table *table = hawser__tree_table(of);

	for (int i = 0; i < table->rows; i++)
		if (hawser__tree_key_of(table->row[i].path, of) && table->row[i].type < HAWSER__TREE_MAPPING)
			key(&table->row[i]);
}

static void sections(const char *kind)
{
	const struct hawser__tree_table *table = hawser__tree_table(kind);

	fputs(".SS Top level\n", stdout);
	keys_in(kind);
	for (int i = 0; i < table->rows; i++) {
		const struct hawser__tree_key *row = &table->row[i];

		if (row->type != HAWSER__TREE_MAPPING || strchr(row->path, '['))
			continue;
		fputs(".SS ", stdout);
		put_text(strchr(row->path, '.') + 1);
		printf(" (%s)\n", row->need == HAWSER__TREE_REQUIRED ? "required" : "optional");
		put_sentence(row->doc, 1);
		fputs(".\n", stdout);
		keys_in(row->path);
	}
}

static void example(const char *unused)
{
	(void)unused;
	for (const char *line = hawser__scene_example; *line;) {
		char copy[128];
		size_t length = strcspn(line, "\n");

		snprintf(copy, sizeof copy, "%.*s", (int)length, line);
		put_text(copy);
		putchar('\n');
		line += length + (line[length] == '\n');
	}
}

/* Write the rules of plausibility. */
static void plausible(const char *unused)
{
	const struct hawser_plausible_rule *rule;

	(void)unused;
	for (int i = 0; (rule = hawser_plausible_rule(i)); i++) {
		char line[400], low[32] = "up";

		if (rule->low > 0.0)
			snprintf(low, sizeof low, "from %g", rule->low);
		snprintf(line, sizeof line, "%s%s%s", rule->name, *rule->formula ? ", " : "",
		         rule->formula);
		fputs(".TP\n", stdout);
		put_sentence(line, 0);
		fputs("\n", stdout);
		snprintf(line, sizeof line, "%s to %g%s%s (%s).", low, rule->high,
		         *rule->unit ? " " : "", rule->unit, rule->keys);
		put_sentence(line, 0);
		fputs("\n", stdout);
		put_sentence(rule->why, 0);
		if (*rule->why)
			fputs("\n", stdout);
	}
}

static const struct {
	const char *name;
	void (*write)(const char *of);
} part[] = {{"sections", sections}, {"keys", keys_in}, {"kind", all_keys}, {"example", example},
            {"plausible", plausible}};

/* A line, with what stands between two @ replaced. */
static void copy(char *line)
{
	for (char *at; (at = strchr(line, '@')) != NULL; line = at + 1) {
		*at++ = '\0';
		fputs(line, stdout);
		line = at;
		at += strcspn(at, "@");
		*at = '\0';
		if (strncmp(line, "most ", 5) == 0)
			printf("%.0f", hawser__tree_next(NULL, line + 5)->most);
		else
			fputs(PACKAGE_VERSION, stdout);
	}
	fputs(line, stdout);
}

int main(void)
{
	char line[400], name[20], of[40];

	fputs(".\\\" Written from man/hawser-scene.5.in and the tables of keys (src/scene/page/manpage.c): "
	      "change these.\n", stdout);
	while (fgets(line, sizeof line, stdin)) {
		int words = sscanf(line, ".\\\" @%19s %39s", name, of);

		if (words < 1)
			copy(line);
		for (size_t i = 0; i < sizeof part/sizeof *part && words > 0; i++)
			if (strcmp(part[i].name, name) == 0)
				part[i].write(of);
	}
	return fflush(stdout) || ferror(stdout);
}
