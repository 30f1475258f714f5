/* cli/frame/option.h - options of commands: parsing, --help and refusals follow from one table
 * (options.c). SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_OPTION_H
#define HAWSER_CLI_OPTION_H

#include <stddef.h>

#include <hawser/document.h>

/* A row is an option or a heading. --help and the manual page have the options before the first heading
 * first, the command's and the common ones, and then the others below their headings; a command of more
 * than 20 options has some ten before it.
 *
 * An option: long name, one letter or 0, names of its arguments ("", "FILE", "FORMAT STEM"), a
 * description of one line, and the function that stores its arguments at `offset` in the settings of
 * the command. */
struct cli_option {
	const char *name;
	char letter;
	const char *arguments;
	const char *doc;
	enum hawser_status (*store)(void *field, const struct cli_option *option,
	                            const char *const *values, struct hawser_report *report);
	size_t offset;
	unsigned kinds; /* bits of enum cli_kind: of the inputs that it is for; 0: of all */
	const char *words; /* "up|down|both": those that a text may be; NULL: any */
	double most;       /* of a number; 0: any */
	/* Other options, "over, model=fe": given, or with this value. One of `needs` must be, none of
	 * `excludes`; NULL: none. */
	const char *needs, *excludes;
};
/* All kinds of inputs, in the order of hawser init and check, each with its record cli_kind_NAME
 * (kinds.h). FIRST is X for the first of those that hawser init writes. */
#define CLI_KINDS_WRITTEN(FIRST, X) \
	FIRST(cable, CABLE) X(travelling, TRAVELLING) X(beam, BEAM) HAWSER_SCENE_KINDS(X)
#define CLI_KINDS(X) CLI_KINDS_WRITTEN(X, X) X(model, MODEL)
#define CLI_NUMBER_OF(name, BIT) CLI_NUMBER_##BIT,
enum { CLI_KINDS(CLI_NUMBER_OF) CLI_KINDS_ALL };
#undef CLI_NUMBER_OF
/* The same as bits, and what several commands and options are for. */
#define CLI_BIT_OF(name, BIT) CLI_##BIT = 1 << CLI_NUMBER_##BIT,
enum cli_kind {
	CLI_KINDS(CLI_BIT_OF)
	CLI_MODELS = 1 << CLI_KINDS_ALL, /* of commands: kinds of which models are made */
	CLI_FORCED = 2*CLI_MODELS,       /* besides: of these, inputs that something forces */
	CLI_EVERY = CLI_MODELS - 1,
	CLI_SPAN = CLI_CABLE | CLI_TRAVELLING | CLI_BEAM,
	CLI_MESHES = CLI_NET | CLI_ROD,
	CLI_MODELLED = CLI_SPAN | CLI_ROPEWAY | CLI_MODEL
};
#undef CLI_BIT_OF

enum hawser_status cli_store_flag(void *field, const struct cli_option *option,
                                  const char *const *values, struct hawser_report *report);
enum hawser_status cli_store_text(void *field, const struct cli_option *option,
                                  const char *const *values, struct hawser_report *report);
/* Into const char *[2]. */
enum hawser_status cli_store_two(void *field, const struct cli_option *option,
                                 const char *const *values, struct hawser_report *report);
/* The option --set, of any command: at offset 0. */
enum hawser_status cli_store_set(void *field, const struct cli_option *option,
                                 const char *const *values, struct hawser_report *report);
enum hawser_status cli_store_library(void *field, const struct cli_option *option,
                                     const char *const *values, struct hawser_report *report);
enum hawser_status cli_store_positive(void *field, const struct cli_option *option,
                                      const char *const *values, struct hawser_report *report);
/* Integers: any, and >= 2. */
enum hawser_status cli_store_integer(void *field, const struct cli_option *option,
                                     const char *const *values, struct hawser_report *report);
enum hawser_status cli_store_count(void *field, const struct cli_option *option,
                                   const char *const *values, struct hawser_report *report);

/* The end of a row: the function that stores the argument, the member of `struct settings` of the
 * command, and, in those that end in _FOR, the kinds of inputs. */
#define CLI_STORED_FOR(of, member, inputs) \
	.store = of, .offset = offsetof(struct settings, member), .kinds = inputs
#define CLI_STORED_IN(type, of, member) .store = of, .offset = offsetof(type, member)
#define CLI_STORED(store, member) CLI_STORED_FOR(store, member, 0)
#define CLI_FLAG_FOR(member, kinds) CLI_STORED_FOR(cli_store_flag, member, kinds)
#define CLI_TEXT_FOR(member, kinds) CLI_STORED_FOR(cli_store_text, member, kinds)
#define CLI_POSITIVE_FOR(member, kinds) CLI_STORED_FOR(cli_store_positive, member, kinds)
#define CLI_INTEGER_FOR(member, kinds) CLI_STORED_FOR(cli_store_integer, member, kinds)
#define CLI_COUNT_FOR(member, kinds) CLI_STORED_FOR(cli_store_count, member, kinds)
#define CLI_FLAG(member) CLI_STORED(cli_store_flag, member)
#define CLI_TEXT(member) CLI_STORED(cli_store_text, member)
#define CLI_TWO(member) CLI_STORED(cli_store_two, member)
#define CLI_POSITIVE(member) CLI_STORED(cli_store_positive, member)
#define CLI_INTEGER(member) CLI_STORED(cli_store_integer, member)
#define CLI_COUNT(member) CLI_STORED(cli_store_count, member)

/* Options of several commands. The command's `struct settings` has a member of the same name. */
#define CLI_TEXT_OPTION(name, arguments, doc) \
	{#name, 0, arguments, doc, CLI_TEXT(name)}
#define CLI_TEXT_WITH(name, arguments, doc, ...) \
	{#name, 0, arguments, doc, CLI_TEXT(name), __VA_ARGS__}
#define CLI_RANGE_OPTIONS(from_doc, to_doc) \
	CLI_TEXT_OPTION(from, "FREQUENCY", from_doc), CLI_TEXT_OPTION(to, "FREQUENCY", to_doc)
#define CLI_LIBRARY_OPTION \
	{"model-library", 0, "FILE", "a function in C as the model, in place of SCENE", \
	 CLI_STORED(cli_store_library, common)}
#define CLI_MODES_OPTION \
	{"modes", 'n', "N", "number of modes (the scene's model.modes)", CLI_INTEGER(n)}
#define CLI_TOLERANCE_OPTION(doc) \
	{"tolerance", 0, "NUMBER", doc, CLI_POSITIVE(tolerance)}
#define CLI_STEP_OPTION \
	{"step", 0, "NUMBER", "longest step, as a part of the range (0.005)", CLI_POSITIVE(step), \
	 .most = 1.0}
#define CLI_POINTS_OPTION(doc) \
	{"max-points", 0, "N", doc, CLI_COUNT(points)}
#define CLI_SET_OPTION \
	{"set", 0, "KEY=VALUE", "override a key of the scene; may be repeated", \
	 .store = cli_store_set}
#define CLI_HELP_OPTION \
	{"help", 'h', "", "print this help", CLI_STORED_IN(struct cli_common, cli_store_flag, help)}
/* The heading of the rows that follow, up to the next one. */
#define CLI_HEADING(text) {.name = "", .arguments = "", .doc = text}
#define CLI_NO_OPTION {.name = NULL}

#endif
