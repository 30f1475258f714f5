/* cli/sweep/cmd_sweep.c - hawser sweep: any command over variations of a scene, its results in
 * one table. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/frame/part.h"
#include "cli/sweep/sweep.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "core/share.h"
#include "output/fields/units.h"

struct overs {
	const char *text[CLI_SWEEP_OVERS];
	int count;
};
struct settings {
	struct cli_common common;
	struct overs over;
	const char *list, *rows, *keep, *max, *min, *checkpoint, *part;
	int last, threads;
};
static const struct settings defaults = {.list = NULL};

static enum hawser_status store_over(void *field, const struct cli_option *option,
                                     const char *const *values, struct hawser_report *report)
{
	struct overs *overs = field;

	if (overs->count == CLI_SWEEP_OVERS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "more than %d times --%s: put the "
		                    "variations into a file for --list", CLI_SWEEP_OVERS, option->name);
	overs->text[overs->count++] = values[0];
	return HAWSER_OK;
}

static const struct cli_option options[] = {
	{"over", 0, "KEY=VALUES", "vary a key: A:B:N, A:B, [a, b] or a,b; may be repeated",
	 CLI_STORED(store_over, over)},
	{"list", 0, "FILE", "a table of variations: a row of keys, then a row of values for each",
	 CLI_TEXT(list)},
	{"rows", 0, "LIST", "values, table, or a list of the result such as peaks (by command)",
	 CLI_TEXT(rows)},
	{"keep", 0, "COLUMNS", "only these columns of the result, separated by commas", CLI_TEXT(keep)},
	CLI_HEADING("Choice of a row"),
	{"last", 0, "", "of several rows of a variation the last", CLI_FLAG(last),
	 .excludes = "max, min"},
	{"max", 0, "COLUMN", "the row in which this column is largest", CLI_TEXT(max),
	 .excludes = "min"},
	{"min", 0, "COLUMN", "the row in which this column is least", CLI_TEXT(min)},
	CLI_HEADING("Running"),
	{"threads", 'j', "N", "variations that are computed at the same time (all processors)",
	 CLI_INTEGER(threads)},
	{"checkpoint", 0, "FILE", "save results to this file, and continue from those in it",
	 CLI_TEXT(checkpoint)},
	{"part", 0, "K/N", "compute part K of N into the checkpoint; hawser merge joins them",
	 CLI_TEXT(part)},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Runs the command once for each combination of the values. The options of the sweep stand before",
	"the --, those of the command after it. The varied keys are the first columns, then the status of",
	"each run, then the values of its result; a run that fails is a row without these.",
	"VALUES: \"60 kN:100 kN:9\", \"0.01:1:9:log\" (equal ratios), \"[taut, slack]\";",
	"without a number there are 21 values.",
	NULL,
};

static const struct hawser__field column_field[] = {
	{NULL, "KEY", "each varied key, with its unit", .kind = HAWSER__CALL},
	{NULL, "status", "exit status of the run; the results stand behind it", .kind = HAWSER__CALL},
	HAWSER__END,
};
static const struct hawser__field result_field[] = {
	{"line", NULL, "the command that was run", .kind = HAWSER__CALL},
	{"over", NULL, "a list: key, column and unit of each varied key", .kind = HAWSER__CALL},
	{"variations", NULL, "their number", .kind = HAWSER__CALL},
	{"failed", NULL, "number of those without result", .kind = HAWSER__CALL},
	{"rows", NULL, "the rows of the table, objects with the columns as names", .kind = HAWSER__CALL},
	{"failures", NULL, "a list: variation (from 0), its keys, status, message", .kind = HAWSER__CALL},
	{"warnings", NULL, "the same with the first warning of a variation", .kind = HAWSER__CALL},
	HAWSER__END,
};
static const struct cli_listing listing[] = {
	{"Columns of the table:", column_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

/* Commands of whose result the rows, and not the values, are what is asked for. */
static const struct {
	const char *command, *rows;
} usual[] = {{"modes", "table"}, {"frf", "peaks"}};

/* --- the command --- */

/* The name of the option in a word, if it writes a file; or NULL. */
static const char *writes(const struct cli_command *command, const char *word)
{
	const struct cli_option *row = command->options;
	size_t length = strncmp(word, "--", 2) == 0 ? strcspn(word + 2, "=") : 0;

	for (; length > 0 && row->name; row++)
		if (row->store && strlen(row->name) == length && strncmp(row->name, word + 2, length) == 0 &&
		    *row->arguments && (strstr(row->doc, "write ") || strstr(row->doc, "save ")))
			return row->name;
	return NULL;
}

/* The options of the command, read as it will read them. */
static enum hawser_status check_command(const struct cli_study *sweep, int words,
                                        struct hawser_report *report)
{
	const struct cli_command *command = sweep->choice.command;
	struct cli_common *common = cli_settings(command);
	enum hawser_status status;
	const char *file;

	if (!common)
		return hawser__no_memory(report, "sweep");
	status = cli_sweep_place(sweep, words, report);
	if (!status)
		status = cli_parse(common, command, sweep->words - words, sweep->word + words, report);
	file = common->json ? "json" : common->tsv ? "tsv" : common->plot ? "plot"
	       : common->gp ? "gp" : NULL;
	for (int i = words; i < sweep->words && !file; i++)
		file = writes(command, sweep->word[i]);
	if (!status && common->help)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                      "--help: hawser %s --help lists the "
		                      "options of the command", command->name);
	else if (!status && file)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                      "--%s: each variation would write "
		                      "this file again; write it before the -- for the whole sweep%s", file,
		                      strcmp(file, "json") != 0 && strcmp(file, "tsv") != 0 &&
		                      strcmp(file, "plot") != 0 && strcmp(file, "gp") != 0 &&
		                      strcmp(file, "checkpoint") != 0
		                      ? ", or run that variation alone" : "");
	free(common);
	return status;
}

static enum hawser_status find_command(struct cli_study *sweep, int *words,
                                       const struct cli_common *common, char **name,
                                       struct hawser_report *report)
{
	const struct cli_command *command = cli_find(words, 1 + common->mores, name);

	if (!command)
		return cli_execute(1, name, report); /* says that it is unknown */
	sweep->choice.command = command;
	if (strncmp(command->input, "SCENE", 5) == 0 && command->listing &&
	    strcmp(command->name, "sweep") != 0 && strcmp(command->name, "report") != 0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
	                    "%s has no result of one scene to put "
	                    "into a table", command->name);
}

/* The words of each command line: command, scene, its options, and those that all share. */
static enum hawser_status compose(struct cli_study *sweep, const struct cli_common *common,
                                  struct hawser_report *report)
{
	char **name = calloc((size_t)common->mores + 2, sizeof *name);
	int most = common->mores + 2*common->sets + 16, words = 0;
	enum hawser_status status = HAWSER_OK;

	sweep->word = calloc((size_t)most, sizeof *sweep->word);
	if (!name || !sweep->word) {
		free(name);
		return hawser__no_memory(report, "sweep");
	}
	name[0] = (char *)common->second;
	for (int i = 0; i < common->mores; i++)
		name[1 + i] = (char *)common->more[i];
	status = find_command(sweep, &words, common, name, report);
	if (!status) {
		memcpy(sweep->word, name, (size_t)words*sizeof *name);
		sweep->word[words] = (char *)common->input;
		memcpy(sweep->word + words + 1, name + words,
		       (size_t)(1 + common->mores - words)*sizeof *name);
		sweep->words = 2 + common->mores;
		status = check_command(sweep, words, report);
	}
	free(name);
	return status;
}

static void add_shared(struct cli_study *sweep, const struct cli_common *common)
{
	static char quiet[] = "--quiet", json[] = "--json", standard[] = "-", set[] = "--set",
	            units[] = "--units", same[] = "--reproducible";

	sweep->word[sweep->words++] = quiet;
	if (strcmp(sweep->choice.rows, "table") != 0) {
		sweep->word[sweep->words++] = json;
		sweep->word[sweep->words++] = standard;
	}
	if (common->reproducible)
		sweep->word[sweep->words++] = same;
	if (common->units) {
		sweep->word[sweep->words++] = units;
		sweep->word[sweep->words++] = (char *)common->units;
	}
	for (int i = 0; i < common->sets; i++) {
		sweep->word[sweep->words++] = set;
		sweep->word[sweep->words++] = (char *)common->set[i];
	}
}

/* A key that is varied and set by words of the command: one of the two is a mistake. */
static enum hawser_status check_sets(const struct cli_study *sweep, struct hawser_report *report)
{
	for (int i = 0; i < sweep->words; i++)
		for (int k = 0; k < sweep->plan.keys; k++) {
			const char *key = sweep->plan.key[k].key, *set = sweep->word[i];
			size_t length = strlen(key);

			set = strcmp(set, "--set") == 0 && i + 1 < sweep->words ? sweep->word[i + 1]
			      : strncmp(set, "--set=", 6) == 0 ? set + 6 : "";
			if (strncmp(set, key, length) == 0 && set[length] == '=')
				return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
				                    "--set %s: the sweep varies this key: give it once", set);
		}
	return HAWSER_OK;
}

/* "statics --points 11" for comments. */
static char *line_of(const struct cli_common *common)
{
	char *text = NULL;
	size_t size;
	FILE *to = open_memstream(&text, &size);

	if (!to)
		return NULL;
	fputs(common->second, to);
	for (int i = 0; i < common->mores; i++)
		fprintf(to, " %s", common->more[i]);
	return fclose(to) ? (free(text), NULL) : text;
}

/* --- the columns --- */

static enum hawser_status read_keep(struct cli_sweep_choice *choice, char *copy,
                                    struct hawser_report *report)
{
	char *part;

	while ((part = strsep(&copy, ","))) {
		part += strspn(part, " ");
		part[strcspn(part, " ")] = '\0';
		if (!*part)
			continue;
		if (choice->keeps == CLI_SWEEP_KEEPS)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "--keep: at most %d columns",
			                    CLI_SWEEP_KEEPS);
		choice->keep[choice->keeps++] = part;
	}
	return HAWSER_OK;
}

static enum hawser_status read_choice(struct cli_sweep_choice *choice,
                                      const struct settings *settings,
                                      char *keep, struct hawser_report *report)
{
	int picks = settings->last || settings->max || settings->min;

	if (picks && settings->rows && strcmp(settings->rows, "values") == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "--rows values has one row for each "
		                    "variation: --%s has nothing to choose from", settings->last ? "last"
		                    : settings->max ? "max" : "min");
	choice->pick = settings->last ? CLI_SWEEP_LAST : settings->max ? CLI_SWEEP_MAX
	               : settings->min ? CLI_SWEEP_MIN : CLI_SWEEP_ALL;
	choice->by = settings->max ? settings->max : settings->min;
	choice->rows = settings->rows;
	for (size_t i = 0; !choice->rows && i < sizeof usual/sizeof *usual && picks == 0; i++)
		if (strcmp(usual[i].command, choice->command->name) == 0)
			choice->rows = usual[i].rows;
	if (!choice->rows)
		choice->rows = picks > 0 ? "table" : "values";
	return read_keep(choice, keep, report);
}

/* --- all --- */

static enum hawser_status check(const struct settings *settings, int worker, int ranks,
                                struct hawser_report *report)
{
	const struct cli_common *common = &settings->common;
	const struct cli_output checkpoint = {"checkpoint", settings->checkpoint};
	struct stat info;

	if (!common->second)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "the command is missing: hawser sweep "
		                    "SCENE --over KEY=FROM:TO:N -- statics, or another command");
	if (ranks && (strcmp(common->input, "-") == 0 ||
	              (stat(common->input, &info) == 0 && !S_ISREG(info.st_mode))))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "each rank reads the scene of the "
		                    "sweep: give a file");
	return worker ? HAWSER_OK : cli_outputs_check_with(common, &checkpoint, 1, report);
}

/* By the exit status of a variation. */
static const enum hawser_status as[] = {HAWSER_OK, HAWSER_ERR_ARGUMENT, HAWSER_ERR_NO_SOLUTION,
                                        HAWSER_ERR_CONVERGENCE, HAWSER_ERR_PROGRAM};

/* What the exit status says of variations without result. */
static enum hawser_status judge(const struct cli_sweep_result *result, struct hawser_report *report)
{
	long first = 0;
	char name[300];

	if (result->failed == 0)
		return HAWSER_OK;
	while (result->status[first] == 0)
		first++;
	cli_sweep_name(name, sizeof name, &result->sweep->plan, first);
	return hawser__fail(report, as[result->status[first]], "sweep", "no result of %ld of %ld "
	                    "variations; the first, %s: %s", result->failed, result->sweep->plan.count,
	                    name, result->message[first] ? result->message[first] : "");
}

/* 1 if no variation has a result because of an option or the scene. */
static int is_useless(const struct cli_sweep_result *result)
{
	for (long i = 0; i < result->sweep->plan.count; i++)
		if (result->status[i] != 1)
			return 0;
	return 1;
}

/* What a part tells in place of a result; its exit status is as of a whole sweep. */
static enum hawser_status end_part(const struct cli_study *sweep, int quiet,
                                   struct hawser_report *report)
{
	const char *first = NULL;
	char name[300];
	long failed = 0, which = 0;
	int length = 0, more;

	for (long i = sweep->plan.count - 1; i >= 0; i--) {
		const char *why = cli_sweep_why(&sweep->packed[i], &more);

		if (!why)
			continue;
		failed++;
		first = why;
		length = more;
		which = i;
	}
	if (!quiet)
		printf("part %d of %d: %ld variation%s in %s\n", sweep->part, sweep->parts, sweep->done,
		       sweep->done == 1 ? "" : "s", sweep->checkpoint);
	if (!first)
		return HAWSER_OK;
	cli_sweep_name(name, sizeof name, &sweep->plan, which);
	return hawser__fail(report, as[hawser_status_exit(cli_sweep_status(sweep->packed[which].text))],
	                    "sweep", "no result of %ld of %ld variations of this part; the first, %s: %.*s",
	                    failed, sweep->done, name, length, first);
}

static enum hawser_status compute(struct cli_study *sweep, const struct cli_common *own,
                                  struct hawser_report *report)
{
	struct cli_sweep_result result = {.sweep = sweep};
	struct hawser_report failed = {0};
	enum hawser_status judged, status = cli_sweep_run(sweep, report);
	struct cli_common again = *own;

	if (!status && sweep->parts > 0)
		return end_part(sweep, own->quiet, report);
	if (!status)
		status = cli_sweep_result_open(&result, sweep, report);
	/* the commands have chosen theirs in between */
	if (!status)
		status = hawser__units_choose(own->units, report);
	if (!status)
		status = cli_picture_choose(&again, report);
	judged = status ? HAWSER_OK : judge(&result, &failed);
	if (!status && !(judged && is_useless(&result)))
		status = cli_show(sweep->common, &cli_sweep_showing, &result, report);
	if (!status && judged) {
		status = judged;
		*report = failed;
	}
	cli_sweep_result_clear(&result);
	return status;
}

static void clear(struct cli_study *sweep)
{
	for (long i = 0; sweep->packed && i < sweep->plan.count; i++)
		free(sweep->packed[i].text);
	free(sweep->packed);
	free(sweep->word);
	free(sweep->line);
	cli_sweep_plan_clear(&sweep->plan);
}

/* All up to the computation, which is the same in all ranks. */
static enum hawser_status prepare(struct cli_study *sweep, const struct settings *settings,
                                  char *keep, struct hawser_report *report)
{
	const struct hawser_document *document;
	enum hawser_status status = keep ? check(settings, cli_sweep_is_worker(sweep),
	                                         sweep->ranks != NULL, report)
	                                 : hawser__no_memory(report, "sweep");

	if (!status)
		status = cli_document(&document, &settings->common, report);
	if (!status) /* read once for all variations */
		cli_document_within(settings->common.input, document);
	if (!status)
		status = compose(sweep, &settings->common, report);
	if (!status)
		status = read_choice(&sweep->choice, settings, keep, report);
	if (!status)
		status = cli_part_read(&sweep->part, &sweep->parts, settings->part, "sweep",
		                       settings->checkpoint, &settings->common, NULL, report);
	if (!status)
		status = cli_sweep_plan_open(&sweep->plan, &settings->common, settings->over.text,
		                             settings->over.count, settings->list, report);
	if (!status)
		status = cli_sweep_check(sweep, &settings->common, report);
	if (!status && settings->common.plot)
		status = cli_sweep_draw_check(&sweep->plan, report);
	if (status)
		return status;
	add_shared(sweep, &settings->common);
	status = check_sets(sweep, report);
	if (status)
		return status;
	sweep->line = line_of(&settings->common);
	return sweep->line ? HAWSER_OK : hawser__no_memory(report, "sweep");
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_common common = settings->common;
	struct cli_study sweep = {.common = &common, .checkpoint = settings->checkpoint,
	                          .processes = settings->threads > 0 ? settings->threads
	                                                             : hawser__processors()};
	char *keep = strdup(settings->keep ? settings->keep : "");
	enum hawser_status status = cli_sweep_ranks_open(&sweep, settings->threads, report);

	if (!status)
		status = prepare(&sweep, settings, keep, report);
	common.mores = 0; /* these are no scenes */
	if (!status)
		status = cli_sweep_is_worker(&sweep) ? cli_sweep_serve(&sweep, report)
		                                     : compute(&sweep, &settings->common, report);
	cli_document_within(NULL, NULL);
	status = cli_sweep_ranks_close(&sweep, status, report);
	clear(&sweep);
	free(keep);
	return status;
}

const struct cli_command cli_sweep = {
	"sweep", "SCENE --over KEY=VALUES -- COMMAND ...",
	"Any command over variations of a scene, results in one table", notes, options,
	&defaults, sizeof(struct settings), 1, run, listing,
	.takes = CLI_EVERY,
};
