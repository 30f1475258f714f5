/* cli/frame/deliver.c - output of results: files first, standard output last, so that a failed
 * run prints nothing. A full disk or a missing gnuplot that prevents a picture takes no numbers with
 * it: they are written, and printed if there is no other file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/frame/view.h"
#include "cli/frame/within.h"
#include "core/file.h"
#include "core/report.h"

enum { OUTPUTS = 4 }; /* of every command */

static int is_stdout(const char *path)
{
	return path && strcmp(path, "-") == 0;
}

/* The absolute path of the folder, without links and dots; the caller frees it. NULL on failure. */
static char *folder_of(const char *path)
{
	size_t length = (size_t)(hawser__file_name(path) - path);
	char *folder = strndup(length ? path : ".", length ? length : 1), *real;

	real = folder ? realpath(folder, NULL) : NULL;
	free(folder);
	return real;
}

/* For a name that does not exist yet, and for a broken link, the file that rename(2) will create. */
static int same_new_name(const char *a, const char *b)
{
	char *folder = folder_of(a), *other = folder_of(b);
	int same = folder && other && strcmp(folder, other) == 0 &&
	           strcmp(hawser__file_name(a), hawser__file_name(b)) == 0;

	free(folder);
	free(other);
	return same;
}

/* "-" is standard input for the input; it is not a file that can be compared. */
static int look(struct stat *info, const char *path, int input)
{
	return is_stdout(path) && input ? fstat(STDIN_FILENO, info) == 0 : stat(path, info) == 0;
}

/* Devices and pipes may be named twice, since no content is lost. */
static int same_file(const struct cli_output *output, const struct cli_output *other, int input)
{
	struct stat info, second;
	int exists, other_exists;

	if (strcmp(output->path, other->path) == 0 && !(input && is_stdout(output->path)))
		return 1;
	if (is_stdout(output->path) || (is_stdout(other->path) && !input))
		return 0;
	exists = look(&info, output->path, 0);
	other_exists = look(&second, other->path, input);
	if (exists && other_exists)
		return S_ISREG(info.st_mode) && info.st_dev == second.st_dev &&
		       info.st_ino == second.st_ino;
	return !exists && !other_exists && same_new_name(output->path, other->path);
}

static enum hawser_status check_clash(const struct cli_output *output,
                                      const struct cli_output *other, int input,
                                      struct hawser_report *report)
{
	const char *path = output->path;

	if (!path || !other->path || !same_file(output, other, input))
		return HAWSER_OK;
	if (strcmp(path, other->path) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "output",
		                    input ? "--%s would overwrite the %s %s"
		                          : "--%s and --%s both write to %s",
		                    output->option, other->option,
		                    is_stdout(path) ? "standard output" : path);
	if (input)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "output",
		                    "--%s %s would overwrite the input %s, which is the same file",
		                    output->option, path,
		                    is_stdout(other->path) ? "on standard input" : other->path);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "output",
	                    "--%s %s and --%s %s both write to the same file", output->option, path,
	                    other->option, other->path);
}

enum hawser_status cli_outputs_check_with(const struct cli_common *common,
                                          const struct cli_output *more, int count,
                                          struct hawser_report *report)
{
	const struct cli_output input = {"input", common->input};
	struct cli_output list[OUTPUTS + CLI_MORE_OUTPUTS] = {
		{"json", common->json}, {"tsv", common->tsv}, {"plot", common->plot}, {"gp", common->gp},
	};
	enum hawser_status status = HAWSER_OK;
	int i, j;

	for (i = 0; i < count; i++)
		list[OUTPUTS + i] = more[i];
	for (i = 0; i < OUTPUTS + count && !status; i++) {
		for (j = i + 1; j < OUTPUTS + count && !status; j++)
			status = check_clash(&list[i], &list[j], 0, report);
		if (!status)
			status = check_clash(&list[i], &input, 1, report);
		for (j = 0; j < common->mores && !status; j++)
			status = check_clash(&list[i], &(struct cli_output){"input", common->more[j]}, 1, report);
	}
	if (!status)
		status = hawser__picture_check(common->plot, report);
	if (!status)
		status = hawser__picture_check(common->gp, report);
	if (!status)
		status = hawser__file_check(common->json, report);
	if (!status)
		status = hawser__file_check(common->tsv, report);
	return status;
}

enum hawser_status cli_outputs_check(const struct cli_common *common, struct hawser_report *report)
{
	return cli_outputs_check_with(common, NULL, 0, report);
}

enum hawser_status cli_outputs_check_scales(const struct cli_common *common, const char *axes,
                                            struct hawser_report *report)
{
	enum hawser_status status = cli_outputs_check(common, report);

	for (; !status && *axes; axes++)
		status = hawser__picture_logarithmic(*axes, report);
	return status;
}

enum hawser_status cli_vtk_check(const char *path, const char *command, struct hawser_report *report)
{
	size_t length = path ? strlen(path) : 0;

	if (path && (length < 5 || strcmp(path + length - 4, ".vtk") != 0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command, "--vtk %s: programs tell the kind of "
		                    "file by its name, which must end in .vtk", path);
	return hawser__file_check(path, report);
}

/* perhaps a pipe that nobody reads */
static int may_block(const char *path)
{
	struct stat info;

	return path && !is_stdout(path) && stat(path, &info) == 0 && !S_ISREG(info.st_mode);
}

static enum hawser_status write_json(const char *path, const struct hawser__json *json,
                                     struct hawser_report *report)
{
	enum hawser_status status = hawser__json_write(json, path, report);

	if (!status)
		cli_written(path);
	return status;
}

static enum hawser_status write_table(const char *path, const struct hawser__table *table,
                                      struct hawser_report *report)
{
	enum hawser_status status = hawser__table_write(table, path, report);

	if (!status)
		cli_written(path);
	return status;
}

/* Write the outputs that go to files or, in a second call, the one that goes to standard output;
 * *drawn: the status of the picture, in whose favour no numbers are lost. */
static enum hawser_status write_some(enum hawser_status *drawn, const struct cli_common *common,
                                     int to_stdout,
                                     const struct hawser__table *table,
                                     const struct hawser__json *json,
                                     const struct cli_drawing *drawing,
                                     struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if ((common->plot || common->gp) && !drawing->draw)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "main", "this result has no picture: leave "
		                    "out --%s", common->plot ? "plot" : "gp");
	cli_writing(!to_stdout && !may_block(common->plot) && !may_block(common->json) &&
	            !may_block(common->tsv));
	if (common->plot && is_stdout(common->plot) == to_stdout)
		*drawn = drawing->draw(common->plot, drawing->context, report);
	if (!*drawn && is_stdout(common->plot) == to_stdout)
		cli_written(common->plot);
	if (!*drawn && common->gp && !to_stdout)
		*drawn = drawing->draw(common->gp, drawing->context, report);
	if (*drawn && *drawn != HAWSER_ERR_IO && *drawn != HAWSER_ERR_PROGRAM && !cli_interrupted())
		return *drawn;
	if (common->json && is_stdout(common->json) == to_stdout)
		status = write_json(common->json, json, report);
	if (!status && common->tsv && is_stdout(common->tsv) == to_stdout)
		status = write_table(common->tsv, table, report);
	return status;
}

/* JSON alone checks its own numbers; the rows of a table that nobody wants are not generated. */
static enum hawser_status check_table(const struct cli_common *common,
                                      const struct hawser__table *table,
                                      struct hawser_report *report)
{
	if (table->failed || !common->json || common->tsv || common->plot || common->delivered)
		return hawser__table_check(table, report);
	return HAWSER_OK;
}

/* Files first, standard output last. `json` may be NULL when common->json is. */
static enum hawser_status put_out(const struct cli_common *common, const struct hawser__table *table,
                                  const struct hawser__json *json,
                                  const struct cli_drawing *drawing, struct hawser_report *report)
{
	int any = common->json || common->tsv || common->delivered;
	int taken = is_stdout(common->json) || is_stdout(common->tsv) || is_stdout(common->plot);
	enum hawser_status status = check_table(common, table, report), drawn = HAWSER_OK;

	if (!status && json && json->status) {
		if (report)
			*report = json->report;
		status = json->status;
	}
	if (!status)
		status = write_some(&drawn, common, 0, table, json, drawing, report);
	if (!status)
		status = write_some(&drawn, common, 1, table, json, drawing, report);
	if (status || taken || (drawn && any))
		return status ? status : drawn;
	cli_writing(0);
	if (!any && (drawn || !common->plot))
		status = isatty(STDOUT_FILENO) ? hawser__table_show(table, report)
		                               : hawser__table_write(table, "-", report);
	else if (!common->quiet)
		hawser__table_print_comments(table, stdout);
	return status ? status : drawn;
}

static void show_table(struct hawser__table *table, const struct cli_showing *showing,
                       const void *result)
{
	struct cli_head head;
	char method[160];

	if (showing->table) {
		showing->table(table, result);
		hawser__units_comments(table);
		return;
	}
	head = showing->head(result);
	snprintf(method, sizeof method, "%s%s", head.method, head.also ? head.also : "");
	cli_echo_table(table, head.common, head.command, head.scene, method);
	if (showing->comments)
		showing->comments(table, result);
	if (head.list || showing->rows)
		hawser__fields_table(table, head.list ? head.list : showing->rows,
		                     head.rows ? head.rows : result, &head.view);
	if (showing->more)
		showing->more(table, result);
	hawser__units_comments(table);
}

static void show_json(struct hawser__json *json, const struct cli_showing *showing,
                      const void *result)
{
	struct cli_head head;
	json_t *stats;

	if (showing->json) {
		showing->json(json, result);
		return;
	}
	head = showing->head(result);
	cli_echo_json(json, head.common, head.command, head.scene);
	hawser__fields_json(json, json->root, showing->fields, result, &head.view);
	stats = cli_stats_json(json, head.common);
	if (showing->stats)
		hawser__fields_json(json, stats, showing->stats, result, &head.view);
}

static const struct cli_taker *taker;

void cli_show_to(const struct cli_taker *to)
{
	taker = to;
}

static enum hawser_status hand_over(const struct cli_common *common, const struct hawser__table *table,
                                    struct hawser__json *json, const struct cli_showing *showing,
                                    const void *result, struct hawser_report *report)
{
	const struct cli_head head = showing->head ? showing->head(result)
	                                           : (struct cli_head){.view = cli_si_view(0)};
	const struct cli_taken taken = {table, common->json ? json : NULL, showing->fields,
	                                &head.view.scale};
	enum hawser_status status = common->json ? json->status : hawser__table_check(table, report);

	if (common->json && status && report)
		*report = json->report;
	return status ? status : taker->take(taker->data, &taken, report);
}

enum hawser_status cli_show(const struct cli_common *common, const struct cli_showing *showing,
                            const void *result, struct hawser_report *report)
{
	const struct cli_drawing drawing = {showing->draw, result};
	struct hawser__table table = {0};
	struct hawser__json json = {0};
	enum hawser_status status;

	if (!taker)
		cli_writing(1); /* formatting is the first part of writing */
	show_table(&table, showing, result);
	if (common->json) {
		show_json(&json, showing, result);
		cli_warnings_json(&json);
	}
	if (common->json && !taker && table.about && !json.status &&
	    !json.members.write) /* a model file has no columns */
		json.status = json_object_set(json.root, "columns", table.about)
		              ? hawser__no_memory(&json.report, "json") : HAWSER_OK;
	status = taker ? hand_over(common, &table, &json, showing, result, report)
	               : put_out(common, &table, &json, &drawing, report);
	cli_warnings_end();
	hawser__json_clear(&json);
	hawser__table_clear(&table);
	return status;
}

void cli_report_also(struct hawser_report *report, const struct hawser_report *second)
{
	size_t used = strlen(report->message);

	snprintf(report->message + used, sizeof report->message - used, "; besides, %s",
	         second->message);
}
