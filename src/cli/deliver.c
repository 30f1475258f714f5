/* cli/deliver.c - results to where the user wants them: files first, standard output last, so that
 * a run that fails has printed nothing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "cli/cli.h"
#include "core/report.h"

static int is_stdout(const char *path)
{
	return path && strcmp(path, "-") == 0;
}

static enum hawser_status check_clash(const char *name, const char *path, const char *other_name,
                                      const char *other, struct hawser_report *report)
{
	if (!path || !other || strcmp(path, other) != 0)
		return HAWSER_OK;
	if (strcmp(other_name, "input") == 0 && is_stdout(path))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "output",
	                    strcmp(other_name, "input") == 0
	                        ? "--%s would overwrite the %s %s"
	                        : "--%s and --%s both write to %s",
	                    name, other_name, is_stdout(path) ? "standard output" : path);
}

enum hawser_status cli_outputs_check(const struct cli_common *common, struct hawser_report *report)
{
	const char *name[] = {"json", "tsv", "plot", "input"};
	const char *path[] = {common->json, common->tsv, common->plot, common->input};
	enum hawser_status status = HAWSER_OK;
	int i, j;

	for (i = 0; i < 3; i++)
		for (j = i + 1; j < 4 && !status; j++)
			status = check_clash(name[i], path[i], name[j], path[j], report);
	if (!status)
		status = hawser__picture_check(common->plot, report);
	if (!status)
		status = hawser__file_check(common->json, report);
	if (!status)
		status = hawser__file_check(common->tsv, report);
	return status;
}

/* The outputs that go to files (or, second time, the one that goes to standard output). */
static enum hawser_status write_some(const struct cli_common *common, int to_stdout,
                                     const struct hawser__table *table,
                                     const struct hawser__json *json,
                                     const struct cli_drawing *drawing,
                                     struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (common->plot && is_stdout(common->plot) == to_stdout)
		status = drawing->draw(common->plot, drawing->context, report);
	if (!status && common->json && is_stdout(common->json) == to_stdout)
		status = hawser__json_write(json, common->json, report);
	if (!status && common->tsv && is_stdout(common->tsv) == to_stdout)
		status = hawser__table_write(table, common->tsv, report);
	return status;
}

enum hawser_status cli_deliver(const struct cli_common *common, const struct hawser__table *table,
                               const struct hawser__json *json,
                               const struct cli_drawing *drawing, struct hawser_report *report)
{
	int any = common->json || common->tsv || common->plot;
	int taken = is_stdout(common->json) || is_stdout(common->tsv) || is_stdout(common->plot);
	enum hawser_status status = hawser__table_check(table, report);

	if (!status && json && json->status) {
		if (report)
			*report = json->report;
		status = json->status;
	}
	if (!status)
		status = write_some(common, 0, table, json, drawing, report);
	if (!status)
		status = write_some(common, 1, table, json, drawing, report);
	if (status || taken)
		return status;
	if (!any)
		return hawser__table_write(table, "-", report);
	if (!common->quiet)
		hawser__table_print_comments(table, stdout);
	return HAWSER_OK;
}
