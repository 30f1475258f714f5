/* cli/frame/kinds.h - the kinds of inputs: a record of each, from which follow which commands take an
 * input, what check says of it, and what is refused. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_KINDS_H
#define HAWSER_CLI_KINDS_H

#include "cli/frame/cli.h"

/* What a command does with inputs of a kind, and the tables that help columns shows for it, NULL if the
 * command's own have them. `settings`: of the command, which begin with struct cli_common; those of
 * statics are struct cli_statics_kinds, those of integrate struct cli_integrate_net. */
typedef enum hawser_status cli_run(const void *settings, struct hawser_report *report);
struct cli_part {
	cli_run *run;
	const struct cli_listing *listing;
};

enum { CLI_SCENE_FACTS = 400 };
struct cli_kind_record {
	const char *name;          /* "net": for hawser init */
	const char *one;           /* "a net of cables" */
	const char *called, *many; /* "a net", "nets": in refusals */
	const char *text;          /* a scene with comments; NULL: hawser init has none */
	/* Read the scene and say what it has, lines in text [CLI_SCENE_FACTS], and whether something
	 * forces it; NULL: by the reader of spans. */
	enum hawser_status (*look)(char *text, int *forced, const struct cli_common *common,
	                           struct hawser_report *report);
	enum hawser_kind kind;
	int models; /* 1: commands of models take it (CLI_MODELS) */
	const char *unmade; /* why they do not, and what to do, for a message; NULL: nothing to say */
	const struct cli_maker *maker; /* how models are made (model/made.h); NULL: as of spans and files */
	struct cli_part statics, modes, integrate, plan; /* all zero: these do not take it */
};
/* The .part of a command. */
#define CLI_PART(member) offsetof(struct cli_kind_record, member)
#define CLI_DECLARE_KIND(name, BIT) extern const struct cli_kind_record cli_kind_##name;
CLI_KINDS(CLI_DECLARE_KIND)
#undef CLI_DECLARE_KIND

/* Record `index`, CLI_NUMBER_CABLE and so on; NULL beyond the last. */
const struct cli_kind_record *cli_kind_record(int index);
/* The number of the first record of the kind that is among these bits, or of its first: a span has
 * three. */
int cli_kind_number(enum hawser_kind kind, unsigned bits);
/* What a command with .part does with inputs of kind `index`, and with this input; one that cannot be
 * read is taken for a span. */
const struct cli_part *cli_part_of(const struct cli_command *command, int index);
const struct cli_part *cli_part(const struct cli_command *command, const struct cli_common *common);

extern cli_run cli_statics_span, cli_statics_net, cli_statics_obstacles, cli_statics_ropeway,
               cli_statics_rod, cli_modes_of_span, cli_modes_of_net, cli_modes_of_obstacles,
               cli_modes_of_ropeway, cli_modes_of_model, cli_integrate_net, cli_integrate_rod,
               cli_plan_of_span, cli_plan_of_net, cli_plan_ropeway, cli_plan_of_model;

/* Refuse an input of a kind that this command does not take (spans, and what cannot be read, are left
 * to the command), and the first option that is given and is not for inputs of this kind. */
enum hawser_status cli_kind_check(const struct cli_command *command, const struct cli_common *common,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;

/* Print the commands that take a scene of kind `index` and, if nothing forces it, what others need. */
void cli_kind_print(FILE *to, int index, int forced);
/* Whether something forces a span: loads, moving ends, a fluctuating speed. */
int cli_is_forced(const struct hawser_scene *scene);

/* --- the input of commands that is a word: "bash|zsh|fish", or "[cable|net]" where it may be
 * left out --- */

/* Word `index` of the input of a command, from 0 on; returns 0 beyond the last, and where the input is
 * a file. */
enum { CLI_INPUT_WORD = 24 };
int cli_input_word(char word[CLI_INPUT_WORD], const struct cli_command *command, int index);

/* The index of `text`, or 0 where it is NULL; otherwise the message names all words. */
enum hawser_status cli_choose_input(int *index, const struct cli_command *command, const char *text,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
