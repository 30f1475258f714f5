/* cli/frame/main.c - the hawser program but for main(): find the command, read its options, run
 * it, report a failure. SPDX-License-Identifier: GPL-3.0-or-later */
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/auxv.h>
#endif

#include <cblas.h>

#include "cli/frame/cli.h"
#include "cli/frame/kinds.h"
#include "cli/frame/view.h"
#include "cli/frame/progress.h"
#include "cli/frame/ranks.h"
#include "cli/frame/within.h"
#include "core/report.h"

#define ADDRESS(command) &cli_##command,
static const struct cli_command *const commands[] = {CLI_COMMANDS(CLI_NO_GROUP, ADDRESS)};
enum { command_count = sizeof commands/sizeof *commands };

const struct cli_command *cli_command_row(int index)
{
	return index >= 0 && index < command_count ? commands[index] : NULL;
}

#define TITLE(text) {text, NULL},
#define ROW(command) {NULL, &cli_##command},
/* The lines of the list: a title, or a command. */
static const struct {
	const char *title;
	const struct cli_command *command;
} listed[] = {CLI_COMMANDS(TITLE, ROW)};

static void print_usage(FILE *stream)
{
	fputs("Usage: hawser COMMAND SCENE [options]\n\n"
	      "Linear and nonlinear dynamics of cables: from a scene file to static shape, modes,\n"
	      "reduced model, time response and certified frequency response.\n\nCommands:\n", stream);
	for (size_t i = 0; i < sizeof listed/sizeof *listed; i++)
		if (listed[i].title)
			fprintf(stream, "\n %s\n", listed[i].title);
		else
			fprintf(stream, "  %-16s %s\n", listed[i].command->name, listed[i].command->summary);
	fputs("\nOptions:\n"
	      "  -h, --help     print this help; hawser COMMAND --help, or hawser help COMMAND, prints a\n"
	      "                 command's options; hawser help columns COMMAND what its results hold\n"
	      "  -V, --version  print version and licence\n\n"
	      "SCENE is a YAML file (man hawser-scene), or - for standard input.\n"
	      "Exit status: 0 done, 1 usage or scene, 2 no answer exists, 3 not converged,\n"
	      "4 system, 128+N interrupted by signal N.\n", stream);
}

static void print_version(void)
{
	printf("hawser %s\n"
	       "Licence GPL-3.0-or-later: <https://gnu.org/licenses/gpl.html>\n"
	       "This is free software; there is NO WARRANTY, to the extent permitted by law.\n",
	       hawser_version());
}

/* Flush and check standard output. */
static enum hawser_status flush_stdout(struct hawser_report *report)
{
	struct hawser__file file;
	enum hawser_status status = hawser__file_begin(&file, "-", report);

	return status ? status : hawser__file_commit(&file, report);
}

/* Length of the first word of a command's name. */
static int first_word(const struct cli_command *command)
{
	return (int)strcspn(command->name, " ");
}

/* 1 if the first `words` words of argv are the name of this command. */
static int is_called(const struct cli_command *command, const char *word, const char *object,
                     int words)
{
	int first = first_word(command);
	const char *rest = command->name + first;

	if ((int)strlen(word) != first || strncmp(word, command->name, (size_t)first) != 0)
		return 0;
	return words == 1 ? !*rest : *rest && strcmp(object, rest + 1) == 0;
}

static enum hawser_status unknown_command(const char *name, struct hawser_report *report)
{
	char word[command_count][16];
	const char *names[command_count], *best;
	struct stat file;
	int i;

	for (i = 0; i < command_count; i++) {
		snprintf(word[i], sizeof word[i], "%.*s", first_word(commands[i]), commands[i]->name);
		names[i] = word[i];
	}
	for (i = 0; i < command_count; i++) /* the first word of a command of two, alone */
		if (is_called(commands[i], name, commands[i]->name + first_word(commands[i]) + 1, 2))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "main",
			                    "%s needs a second word: hawser %s", name, commands[i]->name);
	if (name[0] != '-' && stat(name, &file) == 0 && S_ISREG(file.st_mode))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "main", "%s is a file, and no command comes "
		                    "before it: hawser check %s tells which commands take it", name, name);
	best = cli_nearest(name, names, command_count);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "main",
	                    "unknown %s %s%s%s%s (hawser --help lists the commands)",
	                    name[0] == '-' ? "option" : "command", name,
	                    best ? "; did you mean " : "", best ? best : "", best ? "?" : "");
}

void *cli_settings(const struct cli_command *command)
{
	void *settings = calloc(1, command->size);

	if (settings && command->defaults)
		memcpy(settings, command->defaults, command->size);
	return settings;
}

static enum hawser_status execute(const struct cli_command *command, int argc, char **argv,
                                  struct hawser_report *report)
{
	struct cli_common *common = cli_settings(command);
	struct hawser_document document = {.name = NULL};
	enum hawser_status status;

	if (!common)
		return hawser__no_memory(report, "main");
	cli_ranks_silence(command->name);
	common->document = &document;
	common->started = cli_seconds();
	common->word = argv;
	common->words = argc;
	status = cli_parse(common, command, argc, argv, report);
	if (!status && common->help)
		cli_print_help(command, stdout);
	else if (!status && !common->input && command->needs_input)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "main",
		                      "%s needs a %s (hawser %s --help)", command->name, command->input,
		                      command->name);
	if (!status && !common->help)
		status = hawser__units_choose(common->units, report);
	if (!status && !common->help)
		status = cli_picture_choose(common, report);
	if (!status && !common->help && common->input)
		status = cli_kind_check(command, common, report);
	if (!status && !common->help)
		status = cli_rules_check(command, common, report);
	if (!status && !common->help)
		status = command->run(common, report);
	hawser_document_clear(&document);
	free(common);
	return status;
}

const struct cli_command *cli_find(int *words, int argc, char **argv)
{
	const char *name = argv[0], *object = argc > 1 ? argv[1] : "";
	int i;

	/* `compare modes` before `compare` with a scene of that name */
	for (*words = 2; *words >= 1; --*words)
		for (i = 0; i < command_count; i++)
			if (is_called(commands[i], name, object, *words))
				return commands[i];
	return NULL;
}

/* hawser help [columns] [COMMAND] */
static enum hawser_status help(int argc, char **argv, struct hawser_report *report)
{
	int words, columns = argc > 0 && strcmp(argv[0], "columns") == 0;
	const struct cli_command *command;

	argc -= columns;
	argv = columns ? argv + 1 : argv; /* NULL where argc is 0 */
	if (columns && argc < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "main",
		                    "help columns needs a COMMAND, such as frf (hawser --help lists the "
		                    "commands)");
	if (argc < 1 || strcmp(argv[0], "help") == 0) {
		print_usage(stdout);
		return HAWSER_OK;
	}
	command = cli_find(&words, argc, argv);
	if (!command)
		return unknown_command(argv[0], report);
	if (columns)
		cli_print_columns(command, stdout);
	else
		cli_print_help(command, stdout);
	return HAWSER_OK;
}

const struct cli_command *cli_command_called(const char *line)
{
	const struct cli_command *found = NULL;
	const char *name = strncmp(line, "hawser ", 7) == 0 ? line + 7 : line;

	for (int i = 0; i < command_count; i++) {
		size_t length = strlen(commands[i]->name);

		if (strncmp(name, commands[i]->name, length) == 0 && name[length] == ' ' &&
		    (!found || length > strlen(found->name)))
			found = commands[i];
	}
	return found;
}

enum hawser_status cli_execute(int argc, char **argv, struct hawser_report *report)
{
	int words;
	const struct cli_command *command = cli_find(&words, argc, argv);

	return command ? execute(command, argc - words, argv + words, report)
	               : unknown_command(argv[0], report);
}

static enum hawser_status dispatch(int argc, char **argv, struct hawser_report *report)
{
	const char *name = argv[1];

	if (strcmp(name, "help") == 0)
		return help(argc - 2, argv + 2, report);
	if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0)
		return help(0, NULL, report);
	if (strcmp(name, "--version") == 0 || strcmp(name, "-V") == 0) {
		print_version();
		return HAWSER_OK;
	}
	return cli_execute(argc - 1, argv + 1, report);
}

static const char unit_file[] = "/../share/hawser/udunits/udunits2.xml"; /* from the program's folder */

/* Let udunits2 find its units in ../share/hawser/udunits, if they are there: in a program that was
 * unpacked from a tarball (packaging/static.sh). The environment's UDUNITS2_XML_PATH has priority. */
static void unpacked_units(void)
{
#ifdef __linux__
	/* the name by which the system started the program: /proc need not be there */
	const char *name = (const char *)getauxval(AT_EXECFN);
	char *program = name ? realpath(name, NULL) : NULL, *slash = program ? strrchr(program, '/') : NULL;
	char *path = slash ? malloc((size_t)(slash - program) + sizeof unit_file) : NULL;

	if (path) {
		memcpy(path, program, (size_t)(slash - program));
		/* NOLINTNEXTLINE(clang-analyzer-security.insecureAPI.strcpy): path has its room */
		strcpy(path + (slash - program), unit_file);
		if (access(path, R_OK) == 0)
			(void)setenv("UDUNITS2_XML_PATH", path, 0);
	}
	free(path);
	free(program);
#endif
}

int cli_main(int argc, char **argv)
{
	struct hawser_report report = {0};
	enum hawser_status status;

	if (argc < 2) {
		print_usage(stderr);
		return 1;
	}
	/* a limit on the size of files is told as a full disk is, and leaves no part of a file */
	(void)signal(SIGXFSZ, SIG_IGN);
	unpacked_units();
	cli_catch_questions();
	cli_catch_interrupts();
	/* Matrices here are of orders up to some hundreds: threads cost more than they give, most of
	 * all on a busy machine. */
	openblas_set_num_threads(1);
	status = dispatch(argc, argv, &report);
	if (!status)
		status = flush_stdout(&report);
	if (status)
		cli_say(CLI_ERROR, report.message);
	return cli_interrupted() ? 128 + cli_interrupted() : hawser_status_exit(status);
}
