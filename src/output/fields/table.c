/* output/fields/table.c - tab-separated values that pandas and gnuplot can read directly, and numpy
 * after the comments are removed (doc/commands.md).
 *
 * A table is stored until it is complete, so that a failed run prints nothing. Rows that can be
 * computed from the result are not stored but generated on output (_rows).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "output/fields/visit.h"

#define SHORT "%.7g" /* digits of a number that is read on a terminal; chosen */

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

/* Replace tabs and line ends in a name, which comes from a file or a command line. */
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
	if (hawser__more(list, *count, sizeof **list) || !text) {
		free(text);
		table->failed = 1;
		return;
	}
	(*list)[(*count)++] = text;
}

void hawser__table_remark(struct hawser__table *table, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	append(table, &table->comment, &table->comments, tame(format_text(format, args), ' '));
	va_end(args);
}

void hawser__table_comment(struct hawser__table *table, const char *format, ...)
{
	va_list args;
	char *text;

	va_start(args, format);
	text = format_text(format, args);
	va_end(args);
	append(table, &table->comment, &table->comments,
	       text ? tame(hawser__units_text(text), ' ') : NULL);
	free(text);
}

void hawser__table_column(struct hawser__table *table, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	append(table, &table->column, &table->columns, tame(format_text(format, args), '_'));
	va_end(args);
}

/* The text without {/:Italic } around words; the caller frees it. */
static char *without_markup(const char *text)
{
	static const char italic[] = "{/:Italic ";
	char *plain = malloc(strlen(text) + 1), *end = plain;
	int inside = 0;

	while (plain && *text)
		if (strncmp(text, italic, sizeof italic - 1) == 0) {
			text += sizeof italic - 1;
			inside = 1;
		} else if (*text == '}' && inside) {
			text++;
			inside = 0;
		} else {
			*end++ = *text++;
		}
	if (plain)
		*end = '\0';
	return plain;
}

void hawser__table_about(struct hawser__table *table, const char *key, const char *title,
                         const char *meaning, const char *unit)
{
	char *plain = without_markup(title);
	json_t *one = table->failed || !plain ? NULL
	            : json_pack("{s:s, s:s, s:s, s:s, s:s}", "name", table->column[table->columns - 1],
	                        "key", key, "title", plain, "meaning", meaning, "unit", unit);

	if (!table->about)
		table->about = json_array();
	table->failed |= !one || json_array_append_new(table->about, one);
	free(plain);
}

static void put(struct hawser__table *table, struct hawser__cell cell)
{
	if (hawser__more(&table->cell, (long)table->cells, sizeof *table->cell)) {
		table->failed = 1;
		return;
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

void hawser__table_rows(struct hawser__table *table, size_t count,
                        void (*fill)(struct hawser__table *row, const void *context, size_t index),
                        const void *context)
{
	table->rows = count;
	table->fill = fill;
	table->context = context;
}

/* Generate the cells of one row into a separate table; returns 0 if memory ran out. */
static int make_row(struct hawser__table *row, const struct hawser__table *table, size_t index)
{
	row->cells = 0;
	table->fill(row, table->context, index);
	return !row->failed;
}

static enum hawser_status check_cells(const struct hawser__table *table,
                                      const struct hawser__table *cells, size_t *rows,
                                      struct hawser_report *report)
{
	size_t i;

	for (i = 0; i < cells->cells; i++)
		if (!cells->cell[i].word && !isfinite(cells->cell[i].number))
			return hawser__fail(report, HAWSER_ERR_NAN, "table",
			                    "%s is %g in row %zu: the result is not written",
			                    table->column[i % (size_t)table->columns], cells->cell[i].number,
			                    *rows + i/(size_t)table->columns + 1);
	*rows += table->columns ? cells->cells/(size_t)table->columns : 0;
	return HAWSER_OK;
}

enum hawser_status hawser__table_check(const struct hawser__table *table,
                                       struct hawser_report *report)
{
	struct hawser__table row = {0};
	enum hawser_status status = HAWSER_OK;
	size_t i, rows = 0;

	if (table->failed)
		return hawser__no_memory(report, "table");
	for (i = 0; i < table->rows && !status; i++)
		status = make_row(&row, table, i) ? check_cells(table, &row, &rows, report)
		                                  : hawser__no_memory(report, "table");
	hawser__table_clear(&row);
	return status ? status : check_cells(table, table, &rows, report);
}

void hawser__table_print_comments(const struct hawser__table *table, FILE *stream)
{
	int i;

	for (i = 0; i < table->comments; i++)
		fprintf(stream, "# %s\n", table->comment[i]);
}

static int visit_cells(const struct hawser__table *cells, size_t columns, struct hawser__visitor *by)
{
	int stop = 0;

	for (size_t i = 0; i + columns <= cells->cells && !stop && columns; i += columns)
		stop = by->row(by->to, cells->cell + i, columns);
	return stop;
}

int hawser__table_visit(const struct hawser__table *table, struct hawser__visitor *by)
{
	struct hawser__table row = {0};
	size_t columns = (size_t)table->columns;
	int bad = 0, stop = 0;

	for (size_t i = 0; i < table->rows && !bad && !stop; i++) {
		bad = !make_row(&row, table, i);
		stop = !bad && visit_cells(&row, columns, by);
	}
	hawser__table_clear(&row);
	if (!bad && !stop)
		visit_cells(table, columns, by);
	return -bad;
}

/* How cells are written: `width` is NULL for tabs and all digits. */
struct printing {
	FILE *stream;
	const int *width; /* [columns] of columns side by side */
};

/* Characters of a text in UTF-8: bytes but those that continue a character. */
static int characters(const char *text)
{
	int count = 0;

	for (; *text; text++)
		count += ((unsigned char)*text & 0xc0) != 0x80;
	return count;
}

static void put_cell(const struct printing *by, const char *text, size_t i, size_t columns)
{
	fputs(text, by->stream);
	if (by->width && i + 1 < columns)
		fprintf(by->stream, "%*s", by->width[i] - characters(text), "");
	fputs(i + 1 == columns ? "\n" : by->width ? "  " : "\t", by->stream);
}

/* The text of a cell; `number` has room for one. */
static const char *cell_text(char number[32], const struct hawser__cell *cell, const char *format)
{
	if (cell->word)
		return cell->word;
	snprintf(number, 32, format, cell->number);
	return number;
}

static int print_row(void *to, const struct hawser__cell *cell, size_t columns)
{
	const struct printing *by = to;
	char number[32];

	for (size_t i = 0; i < columns; i++)
		put_cell(by, cell_text(number, &cell[i], by->width ? SHORT : "%.17g"), i, columns);
	return ferror(by->stream);
}

static int widen_columns(void *to, const struct hawser__cell *cell, size_t columns)
{
	int *width = to;
	char number[32];

	for (size_t i = 0; i < columns; i++) {
		int length = characters(cell_text(number, &cell[i], SHORT));

		width[i] = width[i] < length ? length : width[i];
	}
	return 0;
}

/* 0, or -1 when memory ran out. */
static int print(const struct hawser__table *table, FILE *stream, const int *width)
{
	struct printing to = {stream, width};
	struct hawser__visitor by = {print_row, &to};

	hawser__table_print_comments(table, stream);
	for (int i = 0; i < table->columns; i++)
		put_cell(&to, table->column[i], (size_t)i, (size_t)table->columns);
	return hawser__table_visit(table, &by);
}

static enum hawser_status write_to(const char *path, const struct hawser__table *table,
                                   const int *width, struct hawser_report *report)
{
	struct hawser__file file;
	enum hawser_status status = hawser__table_check(table, report);

	if (!status)
		status = hawser__file_begin(&file, path, report);
	if (status)
		return status;
	if (print(table, file.stream, width)) {
		hawser__file_abort(&file);
		return hawser__no_memory(report, "table");
	}
	return hawser__file_commit(&file, report);
}

enum hawser_status hawser__table_write(const struct hawser__table *table, const char *path,
                                       struct hawser_report *report)
{
	return write_to(path, table, NULL, report);
}

enum hawser_status hawser__table_show(const struct hawser__table *table, struct hawser_report *report)
{
	int *width = calloc((size_t)table->columns + 1, sizeof *width);
	struct hawser__visitor by = {widen_columns, width};
	enum hawser_status status;

	for (int i = 0; width && i < table->columns; i++)
		width[i] = characters(table->column[i]);
	status = !width || hawser__table_visit(table, &by) ? hawser__no_memory(report, "table")
	         : write_to("-", table, width, report);
	free(width);
	return status;
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
	free(table->owned);
	json_decref(table->about);
	memset(table, 0, sizeof *table);
}
