/* cli/report/report_run.c - the parts of a report, each a command of the program run in this
 * process: one place computes and formats each result, and the report shows what the command writes
 * with --tsv and --plot.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/report/report.h"
#include "cli/frame/within.h"
#include "core/file.h"
#include "core/report.h"

/* --- files between the commands --- */

static const char *const file_names[] = {"tsv", "svg"};
enum { FILES = sizeof file_names/sizeof *file_names };
static char folder[PATH_MAX - 16], file_path[FILES][PATH_MAX];

/* Also called by the handler of a signal: unlink and rmdir are allowed there. */
void cli_report_folder_close(void)
{
	int error = errno;

	if (!folder[0])
		return;
	for (int i = 0; i < FILES; i++)
		unlink(file_path[i]);
	rmdir(folder);
	folder[0] = '\0';
	errno = error;
}

enum hawser_status cli_report_folder_open(struct hawser_report *report)
{
	if (!hawser__temporary_folder(folder, sizeof folder))
		return hawser__fail(report, HAWSER_ERR_IO, "report",
		                    "cannot make a folder for temporary files below TMPDIR, or /tmp: %s",
		                    strerror(errno));
	for (int i = 0; i < FILES; i++)
		snprintf(file_path[i], sizeof file_path[i], "%s/part.%s", folder, file_names[i]);
	cli_temporary(cli_report_folder_close);
	return HAWSER_OK;
}

/* The path of a file in it; a static buffer for each of the names "tsv", "svg". */
static const char *report_path(const char *name)
{
	int i = 0;

	while (i < FILES - 1 && strcmp(file_names[i], name) != 0)
		i++;
	return file_path[i];
}

enum hawser_status cli_report_text(char **text, size_t *size, const char *path,
                                   struct hawser_report *report)
{
	FILE *stream = fopen(path, "r");
	size_t room = 0;
	ssize_t length;

	*text = NULL;
	*size = 0;
	if (!stream)
		return hawser__fail(report, errno == ENOENT ? HAWSER_ERR_ARGUMENT : HAWSER_ERR_IO, "report",
		                    "cannot read %s: %s", path, strerror(errno));
	errno = 0;
	length = getdelim(text, &room, '\0', stream); /* no text has a zero in it */
	if (length < 0 && ferror(stream)) {
		enum hawser_status status = hawser__fail(report, HAWSER_ERR_IO, "report", "cannot read %s: %s",
		                                         path, strerror(errno));

		fclose(stream);
		free(*text);
		*text = NULL;
		return status;
	}
	fclose(stream);
	if (length < 0) { /* empty */
		free(*text);
		*text = calloc(1, 1);
		return *text ? HAWSER_OK : hawser__no_memory(report, "report");
	}
	*size = (size_t)length;
	return HAWSER_OK;
}

/* --- a part --- */

/* Words of its command line; owned. */
struct line {
	char *word[2*CLI_SETS + 32];
	int words;
	int failed;
};

static void add(struct line *line, const char *word)
{
	char *copy = strdup(word);

	line->failed = line->failed || !copy;
	if (copy)
		line->word[line->words++] = copy;
}

static void add_option(struct line *line, const char *name, const char *value)
{
	if (value) {
		add(line, name);
		add(line, value);
	}
}

/* What a user would write. */
static void compose(struct line *line, const struct cli_report_part *part,
                    const struct cli_common *common, const struct cli_report_given *given)
{
	char number[16];
	int i = 0;

	while (i < CLI_REPORT_WORDS && part->word[i] && part->word[i][0] != '-')
		add(line, part->word[i++]);
	add(line, common->input);
	for (; i < CLI_REPORT_WORDS && part->word[i]; i++)
		add(line, part->word[i]);
	if (part->modes && given->n > 0) {
		snprintf(number, sizeof number, "%d", given->n);
		add_option(line, "-n", number);
	}
	if (part->range) {
		add_option(line, "--from", given->from);
		add_option(line, "--to", given->to);
	}
	for (i = 0; i < common->sets; i++)
		add_option(line, "--set", common->set[i]);
	add_option(line, "--units", common->units);
	if (common->reproducible)
		add(line, "--reproducible");
}

char *cli_report_command(const char *name, int words, char *const *word)
{
	static const char unquoted[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
	                               "_-+=.,:/%^@";
	char *text = NULL;
	size_t size;
	FILE *to = open_memstream(&text, &size);

	if (!to)
		return NULL;
	fprintf(to, "hawser %s", name);
	for (int i = 0; i < words; i++) {
		int plain = *word[i] && word[i][strspn(word[i], unquoted)] == '\0';

		fputs(plain ? " " : " '", to);
		for (const char *c = word[i]; *c; c++)
			if (*c == '\'')
				fputs("'\\''", to);
			else
				putc(*c, to);
		fputs(plain ? "" : "'", to);
	}
	return fclose(to) ? (free(text), NULL) : text;
}

/* The file, if it is there. */
static char *take(const char *name)
{
	char *text;
	size_t size;

	if (access(report_path(name), R_OK) != 0 ||
	    cli_report_text(&text, &size, report_path(name), NULL))
		return NULL;
	unlink(report_path(name));
	return text;
}

static enum hawser_status execute(struct cli_report_result *result, struct line *line,
                                  struct hawser_report *report)
{
	const struct cli_report_part *part = result->part;
	enum hawser_status status;

	add(line, "--quiet");
	add_option(line, "--tsv", report_path("tsv"));
	add_option(line, "--plot", part->no_picture ? NULL : report_path("svg"));
	if (line->failed)
		return hawser__no_memory(report, "report");
	cli_warn_into(&result->warnings);
	status = cli_execute(line->words, line->word, report);
	cli_warn_into(NULL);
	if (!status) {
		result->tsv = take("tsv");
		result->svg = take("svg");
	}
	return status;
}

enum hawser_status cli_report_run(struct cli_report_result *result,
                                  const struct cli_report_part *part,
                                  const struct cli_common *common,
                                  const struct cli_report_given *given,
                                  struct hawser_report *report)
{
	struct line line = {.words = 0};
	struct hawser_report why = {0};
	enum hawser_status status;
	int fatal, words;

	result->part = part;
	compose(&line, part, common, given);
	words = line.words;
	add_option(&line, "--plot", part->drawn);
	if (!line.failed)
		result->command = cli_report_command(line.word[0], line.words - 1, line.word + 1);
	while (line.words > words)
		free(line.word[--line.words]);
	status = line.failed || !result->command ? hawser__no_memory(&why, "report")
	                                         : execute(result, &line, &why);
	for (int i = 0; i < line.words; i++)
		free(line.word[i]);
	/* a range that the user gave is refused, not left out of the report */
	fatal = part->essential || status == HAWSER_ERR_MEMORY || cli_interrupted() ||
	        (status == HAWSER_ERR_ARGUMENT && part->range && (given->from || given->to));
	if (status && !fatal) {
		result->failure = strdup(why.message);
		status = HAWSER_OK;
	}
	if (status)
		*report = why;
	return status;
}

void cli_report_result_clear(struct cli_report_result *result)
{
	free(result->command);
	free(result->tsv);
	free(result->svg);
	free(result->warnings);
	free(result->failure);
	memset(result, 0, sizeof *result);
}
