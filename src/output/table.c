/* output/table.c - tab-separated values that pandas and gnuplot read as they are; numpy does with the
 * comments taken off (README.md).
 *
 * A table is kept in memory until it is complete, so that a failed run prints nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "output/output.h"

static char *format_text(const char *format, va_list args)
{
	va_list again;
	char *text;
	int size;

	va_copy(again, args);
	size = vsnprintf(NULL, 0, format, again);
	va_end(again);
	text = size < 0 ? NULL : malloc((size_t)size + 1);
	if (text)
		vsnprintf(text, (size_t)size + 1, format, args);
	return text;
}

/* Names come from files and command lines: none may break a line or a column. */
static char *tame(char *text, char instead)
{
	char *c;

	for (c = text; c && *c; c++)
		if ((unsigned char)*c < ' ' || (instead == '_' && (*c == ' ' || *c == '#')))
			*c = instead;
	return text;
}

static void append(struct hawser__table *table, char ***list, int *count, char *text)
{
	char **grown = realloc(*list, (size_t)(*count + 1)*sizeof **list);

	if (grown)
		*list = grown;
	if (!grown || !text) {
		free(text);
		table->failed = 1;
		return;
	}
	grown[(*count)++] = text;
}

void hawser__table_comment(struct hawser__table *table, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	append(table, &table->comment, &table->comments, tame(format_text(format, args), ' '));
	va_end(args);
}

void hawser__table_column(struct hawser__table *table, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	append(table, &table->column, &table->columns, tame(format_text(format, args), '_'));
	va_end(args);
}

static void put(struct hawser__table *table, struct hawser__cell cell)
{
	size_t capacity = table->capacity ? 2*table->capacity : 256;
	struct hawser__cell *grown;

	if (table->cells == table->capacity) {
		grown = realloc(table->cell, capacity*sizeof *grown);
		if (!grown) {
			table->failed = 1;
			return;
		}
		table->cell = grown;
		table->capacity = capacity;
	}
	table->cell[table->cells++] = cell;
}

void hawser__table_number(struct hawser__table *table, double number)
{
	put(table, (struct hawser__cell){number + 0.0, NULL}); /* -0 becomes 0 */
}

void hawser__table_word(struct hawser__table *table, const char *word)
{
	put(table, (struct hawser__cell){0.0, word});
}

enum hawser_status hawser__table_check(const struct hawser__table *table,
                                       struct hawser_report *report)
{
	size_t i;

	if (table->failed)
		return hawser__no_memory(report, "table");
	for (i = 0; i < table->cells; i++)
		if (!table->cell[i].word && !isfinite(table->cell[i].number))
			return hawser__fail(report, HAWSER_ERR_NAN, "table",
			                    "%s is %g in row %zu: the result is not written",
			                    table->column[i % (size_t)table->columns], table->cell[i].number,
			                    i/(size_t)table->columns + 1);
	return HAWSER_OK;
}

void hawser__table_print_comments(const struct hawser__table *table, FILE *stream)
{
	int i;

	for (i = 0; i < table->comments; i++)
		fprintf(stream, "# %s\n", table->comment[i]);
}

void hawser__table_print(const struct hawser__table *table, FILE *stream)
{
	size_t columns = (size_t)table->columns, i;

	hawser__table_print_comments(table, stream);
	for (i = 0; i < columns; i++)
		fprintf(stream, "%s%c", table->column[i], i + 1 < columns ? '\t' : '\n');
	for (i = 0; i < table->cells; i++) {
		if (table->cell[i].word)
			fputs(table->cell[i].word, stream);
		else
			fprintf(stream, "%.17g", table->cell[i].number);
		fputc((i + 1) % columns ? '\t' : '\n', stream);
	}
}

enum hawser_status hawser__table_write(const struct hawser__table *table, const char *path,
                                       struct hawser_report *report)
{
	struct hawser__file file;
	enum hawser_status status = hawser__table_check(table, report);

	if (!status)
		status = hawser__file_begin(&file, path, report);
	if (status)
		return status;
	hawser__table_print(table, file.stream);
	return hawser__file_commit(&file, report);
}

static void free_list(char **list, int count)
{
	int i;

	for (i = 0; i < count; i++)
		free(list[i]);
	free(list);
}

void hawser__table_clear(struct hawser__table *table)
{
	if (!table)
		return;
	free_list(table->comment, table->comments);
	free_list(table->column, table->columns);
	free(table->cell);
	memset(table, 0, sizeof *table);
}
