/* cli/report/report.h - the report of a scene: running the parts, and the page that shows them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_REPORT_H
#define HAWSER_CLI_REPORT_H

#include "cli/report/report_parts.h"

/* What a part printed; owned. */
struct cli_report_result {
	const struct cli_report_part *part;
	char *command;  /* as a user would write it */
	char *tsv, *svg; /* NULL: none */
	char *warnings; /* a line each; NULL: none */
	char *failure;  /* why there is no result; NULL: it has succeeded */
};

struct cli_report_page {
	const struct cli_common *common;
	const char *title;
	const char *text; /* of the scene */
	size_t size;
	struct hawser_scene scene; /* if has_scene */
	int has_scene;
	struct cli_report_result result[CLI_REPORT_PARTS]; /* [results] */
	int results;
};

/* --- report_run.c --- */

/* *text: the whole file; owned by the caller. */
enum hawser_status cli_report_text(char **text, size_t *size, const char *path,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* "hawser statics 'a scene.yaml'": the command `name` with word [words]; NULL without memory. Owned by
 * the caller. */
char *cli_report_command(const char *name, int words, char *const *word);
/* Options of the report that are passed on; NULL and 0: not given. */
struct cli_report_given {
	const char *from, *to;
	int n;
};
/* A folder for files between commands, which cli_report_folder_close removes with its files. */
enum hawser_status cli_report_folder_open(struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_report_folder_close(void);
/* Run a part. A failure of an essential one, or an interrupt, is returned, another is part of the
 * result. */
enum hawser_status cli_report_run(struct cli_report_result *result,
                                  const struct cli_report_part *part,
                                  const struct cli_common *common,
                                  const struct cli_report_given *given,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_report_result_clear(struct cli_report_result *result);

/* --- report_page.c --- */

void cli_report_write(FILE *to, const struct cli_report_page *page);

#endif
