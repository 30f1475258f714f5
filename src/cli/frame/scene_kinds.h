/* cli/frame/scene_kinds.h - the kinds of scenes, as hawser init writes them and hawser check
 * tells them. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_SCENE_KINDS_H
#define HAWSER_CLI_SCENE_KINDS_H

#include "cli/frame/cli.h"

enum { CLI_SCENE_FACTS = 400 };
struct cli_scene_kind {
	const char *name;     /* "net" */
	const char *one;      /* "a net of cables" */
	const char *text;     /* a scene with comments; NULL: hawser init has none */
	/* Read the scene and say what it has, lines in text [CLI_SCENE_FACTS], and whether something
	 * forces it; NULL: by the reader of spans. */
	enum hawser_status (*look)(char *text, int *forced, const struct cli_common *common,
	                           struct hawser_report *report);
	enum hawser_kind kind;
	enum cli_takes takes; /* bit of the commands that take it */
};
/* Row `index`, from 0, in the order of the input of hawser init; NULL beyond the last. */
const struct cli_scene_kind *cli_scene_kind(int index);
/* Refuse an input of a kind that this command does not take. Spans, and what cannot be read, are left
 * to the command. */
enum hawser_status cli_scene_kind_check(const struct cli_command *command,
                                        const struct cli_common *common,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Print the commands of a kind that take this scene and, if nothing forces it, what the others need. */
void cli_scene_kind_print(FILE *to, const struct cli_scene_kind *kind, int forced);
/* Whether something forces a span: loads, moving ends, a fluctuating speed. */
int cli_is_forced(const struct hawser_scene *scene);

/* init_scenes.c: the scenes with comments. */
extern const char cli_init_cable[], cli_init_travelling[], cli_init_beam[], cli_init_net[],
                  cli_init_obstacles[], cli_init_ropeway[], cli_init_rod[], cli_init_tow[];

#endif
