/* cli/sweep/sweep_pack.c - run a command in this process and pack its result as text: it goes through
 * pipes, into checkpoints, and is kept until the table is written. Lines:
 *
 *    S status        enum hawser_status
 *    M message       why there is no result
 *    W warning       any number of them
 *    X message       what was asked for and is not in the result
 *    C column ...    names, tabs between them; if there is a row
 *    R cell ...      a row; cells as in struct cli_sweep_row
 *
 * Numbers are written with 17 digits, as tables do, and are not changed any more.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/sweep/sweep.h"
#include "core/report.h"
#include "output/fields/visit.h"

static enum hawser_status take(void *data, const struct cli_taken *result,
                               struct hawser_report *report)
{
	const struct cli_sweep_choice *choice = ((void **)data)[0];
	struct cli_sweep_rows *rows = ((void **)data)[1];

	cli_sweep_take(rows, result, choice);
	return rows->failed ? hawser__no_memory(report, "sweep") : HAWSER_OK;
}

static void put_line(FILE *to, char kind, const char *text, size_t length)
{
	fprintf(to, "%c ", kind);
	for (size_t i = 0; i < length; i++)
		fputc(text[i] == '\t' || text[i] == '\n' ? ' ' : text[i], to);
	fputc('\n', to);
}

/* A line for each line of the text. */
static void put_lines(FILE *to, char kind, const char *text)
{
	while (text && *text) {
		size_t length = strcspn(text, "\n");

		put_line(to, kind, text, length);
		text += length + (text[length] == '\n');
	}
}

static void put_rows(FILE *to, const struct cli_sweep_rows *rows)
{
	if (rows->rows == 0)
		return;
	fputs("C ", to);
	for (int c = 0; c < rows->columns; c++)
		fprintf(to, "%s%s", rows->column[c].name, c + 1 < rows->columns ? "\t" : "\n");
	for (long r = 0; r < rows->rows; r++) {
		const struct cli_sweep_row *row = &rows->row[r];

		fputs("R ", to);
		for (int c = 0; c < rows->columns; c++)
			fprintf(to, "%s%c", c < row->cells && row->cell[c] ? row->cell[c] : "",
			        c + 1 < rows->columns ? '\t' : '\n');
	}
}

static enum hawser_status write_packed(struct cli_sweep_packed *packed, enum hawser_status status,
                                       const char *message, const char *warnings,
                                       const struct cli_sweep_rows *rows,
                                       struct hawser_report *report)
{
	FILE *to = open_memstream(&packed->text, &packed->size);

	if (!to)
		return hawser__no_memory(report, "sweep");
	fprintf(to, "S %d\n", (int)status);
	if (status)
		put_line(to, 'M', message, strlen(message));
	put_lines(to, 'W', warnings);
	put_lines(to, 'X', rows->missing);
	if (rows->columns > 0)
		put_rows(to, rows);
	if (fclose(to) == 0)
		return HAWSER_OK;
	free(packed->text);
	*packed = (struct cli_sweep_packed){NULL, 0};
	return hawser__no_memory(report, "sweep");
}

enum hawser_status cli_sweep_pack(struct cli_sweep_packed *packed,
                                  const struct cli_sweep_choice *choice,
                                  int argc, char **argv, struct hawser_report *report)
{
	struct cli_sweep_rows rows = {.columns = 0};
	struct cli_sweep_choice copy = *choice;
	void *data[] = {&copy, &rows};
	const struct cli_taker taker = {take, data};
	struct hawser_report why = {0};
	char *warnings = NULL;
	enum hawser_status status, packing;

	cli_show_to(&taker);
	cli_warn_into(&warnings);
	hawser__fields_with_units(1);
	status = cli_execute(argc, argv, &why);
	hawser__fields_with_units(0);
	cli_warn_into(NULL);
	cli_show_to(NULL);
	packing = rows.failed ? hawser__no_memory(report, "sweep")
	                      : write_packed(packed, status, why.message, warnings, &rows, report);
	cli_sweep_rows_clear(&rows);
	free(warnings);
	return packing;
}

enum hawser_status cli_sweep_pack_failure(struct cli_sweep_packed *packed,
                                          enum hawser_status status,
                                          const char *message, struct hawser_report *report)
{
	const struct cli_sweep_rows none = {.columns = 0};

	return write_packed(packed, status, message, NULL, &none, report);
}

enum hawser_status cli_sweep_status(const char *packed)
{
	return (enum hawser_status)strtol(packed + 2, NULL, 10);
}

const char *cli_sweep_why(const struct cli_sweep_packed *packed, int *length)
{
	const char *message = packed->text && strncmp(packed->text, "S 0\n", 4) != 0
	                      ? strstr(packed->text, "\nM ") : NULL;

	if (!message)
		return NULL;
	message += 3;
	*length = (int)strcspn(message, "\n");
	return message;
}
