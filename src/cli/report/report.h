/* cli/report/report.h - the report of a scene: running the parts, and the page that shows them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_REPORT_H
#define HAWSER_CLI_REPORT_H

#include "cli/frame/cli.h"

/* --- report_parts.c: of what a report consists: commands of the program, by the kind of the
 * scene --- */

enum { CLI_REPORT_WORDS = 6, CLI_REPORT_PARTS = 16 };
struct cli_report_part {
	const char *name, *title, *about; /* name: for --parts; about: a sentence below the title */
	const char *word[CLI_REPORT_WORDS]; /* the command and its options, ended by NULL */
	unsigned kinds;   /* of scenes (report_parts.c); 0: all that have statics */
	int essential;    /* 1: there is no report without it */
	int no_picture;   /* 1: the command draws none */
	int modes, range; /* 1: it takes -n; --from and --to of a response */
	const char *drawn; /* name of a picture without which the command does something else; or NULL */
};

/* part [CLI_REPORT_PARTS], *count: the parts of a report of the scene common->input. `list`: names of
 * parts, separated by commas, to be taken alone; or NULL. *scene is 1 if *span is the scene, which is
 * then to be cleared; of spans and beams. */
enum hawser_status cli_report_choose(const struct cli_report_part *part[], int *count,
                                     struct hawser_scene *span, int *scene,
                                     const struct cli_common *common, const char *list,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

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
