/* cli/report/report_page.c - the page of a report: contents, parts, scene, provenance.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "cli/report/report.h"
#include "cli/frame/within.h"
#include "core/append.h"
#include "core/file.h"
#include "output/report/html.h"
#include "output/report/sha256.h"

enum {
	MOST_ROWS = 40,    /* of a table in the page: about a page on paper */
	DESCRIBED = 4,     /* comments in the description of a picture */
	DESCRIPTION = 400  /* letters of it, which is read aloud as a whole */
};

static void heading(FILE *to, const char *id, const char *title)
{
	fprintf(to, "<h2 id=\"%s\">", id);
	hawser__html_text(to, title);
	fputs("</h2>\n", to);
}

static void head(FILE *to, const struct cli_report_page *page)
{
	char day[32] = "";
	time_t now = time(NULL);
	struct tm when;

	if (!page->common->reproducible && gmtime_r(&now, &when))
		(void)strftime(day, sizeof day, ", %Y-%m-%d", &when);
	fputs("<a class=\"skip\" href=\"#main\">Skip to the results</a>\n<header>\n", to);
	hawser__html_element(to, "h1", page->title);
	fprintf(to, "<p class=\"faint\">hawser %s%s; scene ", hawser_version(), day);
	hawser__html_text(to, hawser__file_name(page->common->input));
	fputs("</p>\n</header>\n<nav aria-label=\"Contents\">\n<ul>\n", to);
	for (int i = 0; i < page->results; i++) {
		fprintf(to, "<li><a href=\"#%s\">", page->result[i].part->name);
		hawser__html_text(to, page->result[i].part->title);
		fputs("</a></li>\n", to);
	}
	fputs("<li><a href=\"#scene\">Scene</a></li>\n"
	      "<li><a href=\"#provenance\">Provenance</a></li>\n</ul>\n"
	      "</nav>\n<main id=\"main\">\n", to);
}

/* The first comments after the method, for those who do not see the picture. */
static void describe(char *text, size_t size, const char *tsv)
{
	enum { HEAD = 3 };
	int count = 0;

	text[0] = '\0';
	for (const char *line = tsv; line && *line == '#' && count < HEAD + DESCRIBED; count++) {
		size_t length = strcspn(line, "\n");

		if (count >= HEAD && length > 2 && strlen(text) + length < size)
			hawser__append(text, size, "; ", "%.*s", (int)length - 2, line + 2);
		line += length + (line[length] == '\n');
	}
}

/* Lines of text as paragraphs. */
static void notes(FILE *to, const char *lines, const char *before)
{
	for (const char *line = lines; line && *line;) {
		size_t length = strcspn(line, "\n");
		char *copy = strndup(line, length);

		fprintf(to, "<p class=\"note\" role=\"note\">%s", before);
		hawser__html_text(to, copy ? copy : "");
		fputs("</p>\n", to);
		free(copy);
		line += length + (line[length] == '\n');
	}
}

static void part(FILE *to, const struct cli_report_result *result, int *figures)
{
	char description[DESCRIPTION];

	fprintf(to, "<section aria-labelledby=\"%s\">\n", result->part->name);
	heading(to, result->part->name, result->part->title);
	hawser__html_element(to, "p", result->part->about);
	notes(to, result->failure, "Not computed: ");
	notes(to, result->warnings, "Warning: ");
	describe(description, sizeof description, result->tsv);
	if (result->svg)
		hawser__html_picture(to, result->svg, ++*figures, result->part->title, description);
	if (result->tsv) {
		hawser__html_comments(to, result->tsv, "Results");
		hawser__html_rows(to, result->tsv, MOST_ROWS, result->command);
	}
	fputs("</section>\n", to);
}

/* The scene as the library understood it; "" if that fails. */
static void scene_as_read(FILE *to, const struct hawser_scene *scene)
{
	char *text = NULL;
	size_t size;
	FILE *stream = open_memstream(&text, &size);
	enum hawser_status status;

	if (!stream)
		return;
	status = hawser_scene_write(scene, stream, NULL);
	if (fclose(stream) == 0 && !status) {
		fputs("<details>\n<summary>As it was read: in SI units, with overrides and with the "
		      "defaults in use</summary>\n<pre tabindex=\"0\">", to);
		hawser__html_text(to, text);
		fputs("</pre>\n</details>\n", to);
	}
	free(text);
}

static void scene(FILE *to, const struct cli_report_page *page)
{
	fputs("<section aria-labelledby=\"scene\">\n", to);
	heading(to, "scene", "Scene");
	fputs("<pre tabindex=\"0\" aria-label=\"The file of the scene\">", to);
	hawser__html_text(to, page->text);
	fputs("</pre>\n", to);
	if (page->has_scene)
		scene_as_read(to, &page->scene);
	fputs("</section>\n", to);
}

/* Options that state an accuracy, a step or an amount of points; their lines end with the default in
 * parentheses. */
static int sets_accuracy(const char *name)
{
	static const char *const words[] = {"tol", "step", "points", "elements", "segments", "basis"};

	for (size_t i = 0; i < sizeof words/sizeof *words; i++)
		if (strstr(name, words[i]))
			return 1;
	return 0;
}

static void tolerances(FILE *to, const struct cli_report_page *page)
{
	char heading_text[80];

	hawser__html_words_begin(to, "Tolerances, steps and resolutions of each command, with the value in "
	                         "use in parentheses");
	for (int i = 0; i < page->results; i++) {
		const struct cli_command *command = cli_command_called(page->result[i].command);
		const struct cli_option *row = command ? command->options : NULL;

		for (; row && row->name; row++) {
			if (!sets_accuracy(row->name))
				continue;
			snprintf(heading_text, sizeof heading_text, "%s --%s", command->name, row->name);
			hawser__html_words_row(to, heading_text, row->doc);
		}
	}
	hawser__html_words_end(to);
}

/* model.tolerance and the other numbers of the section model, in force and given or default. */
static void model_keys(FILE *to, const struct hawser_scene *scene)
{
	const struct hawser_scene_key *key;
	char text[64];

	hawser__html_words_begin(to, "Settings of the model (section model of the scene)");
	for (int i = 0; (key = hawser_scene_key(i)) != NULL; i++) {
		char word[HAWSER_WORD_SIZE];
		double value;

		if (strncmp(key->path, "model.", 6) != 0)
			continue;
		if (hawser_scene_get(scene, &value, key->path, NULL) == HAWSER_OK)
			snprintf(text, sizeof text, "%.10g", value);
		else if (hawser_scene_word(scene, word, key->path, NULL) == HAWSER_OK)
			snprintf(text, sizeof text, "%s", word);
		else
			continue;
		hawser__append(text, sizeof text, " ", "(%s)",
		               hawser_scene_written(scene, key->path) ? "given" : "default");
		hawser__html_words_row(to, key->path, text);
	}
	hawser__html_words_end(to);
}

static void provenance(FILE *to, const struct cli_report_page *page)
{
	char digest[HAWSER__SHA256_SIZE];

	fputs("<section aria-labelledby=\"provenance\">\n", to);
	heading(to, "provenance", "Provenance");
	hawser__html_words_begin(to, "How these results were made");
	hawser__html_words_row(to, "Program", "hawser " PACKAGE_VERSION
	                       ", free software under the GNU GPL, version 3 or later");
	hawser__html_words_row(to, "Scene", hawser__file_name(page->common->input));
	hawser__sha256(digest, page->text, page->size);
	hawser__html_words_row(to, "SHA-256 of the scene", digest);
	for (int i = 0; i < page->common->sets; i++)
		hawser__html_words_row(to, "Overridden", page->common->set[i]);
	for (int i = 0; i < page->results; i++)
		hawser__html_words_row(to, page->result[i].part->title, page->result[i].command);
	hawser__html_words_end(to);
	if (page->has_scene && !page->scene.beam.form)
		model_keys(to, &page->scene);
	tolerances(to, page);
	fputs("</section>\n", to);
}

void cli_report_write(FILE *to, const struct cli_report_page *page)
{
	int figures = 0;

	hawser__html_begin(to, page->title);
	head(to, page);
	for (int i = 0; i < page->results; i++)
		part(to, &page->result[i], &figures);
	scene(to, page);
	provenance(to, page);
	fputs("</main>\n", to);
	hawser__html_end(to);
}
