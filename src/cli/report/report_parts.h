/* cli/report/report_parts.h - of what a report consists: commands of the program, by the kind of
 * the scene. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_REPORT_PARTS_H
#define HAWSER_CLI_REPORT_PARTS_H

#include "cli/frame/cli.h"

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

#endif
