/* output/report/html.c - see html.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "output/report/html.h"
#include "output/report_page.h" /* made of report.css and report.js */

static void put(FILE *to, const char *text, size_t length)
{
	for (size_t i = 0; i < length; i++) {
		unsigned char c = (unsigned char)text[i];

		if (c == '&')
			fputs("&amp;", to);
		else if (c == '<')
			fputs("&lt;", to);
		else if (c == '>')
			fputs("&gt;", to);
		else if (c == '"')
			fputs("&quot;", to);
		else if (c >= 0x20 || c == '\n' || c == '\t')
			putc(c, to);
	}
}

void hawser__html_text(FILE *to, const char *text)
{
	put(to, text, strlen(text));
}

void hawser__html_element(FILE *to, const char *name, const char *text)
{
	fprintf(to, "<%s>", name);
	hawser__html_text(to, text);
	fprintf(to, "</%s>\n", name);
}

static void lines(FILE *to, const char *const *line)
{
	for (; *line; line++)
		fputs(*line, to);
}

void hawser__html_begin(FILE *to, const char *title)
{
	fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
	      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
	      /* nothing is fetched, whatever a viewer adds */
	      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
	      "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
	      "<link rel=\"icon\" href=\"data:,\">\n<title>", to);
	hawser__html_text(to, title);
	fputs("</title>\n<style>\n", to);
	lines(to, hawser__report_css);
	fputs("</style>\n</head>\n<body>\n", to);
}

void hawser__html_end(FILE *to)
{
	fputs("<script>\n", to);
	lines(to, hawser__report_js);
	fputs("</script>\n</body>\n</html>\n", to);
}

/* --- tables of words --- */

void hawser__html_words_begin(FILE *to, const char *caption)
{
	fputs("<table class=\"words\">\n<caption>", to);
	hawser__html_text(to, caption);
	fputs("</caption>\n<tbody>\n", to);
}

void hawser__html_words_row(FILE *to, const char *heading, const char *text)
{
	fputs("<tr><th scope=\"row\">", to);
	hawser__html_text(to, heading);
	fputs("</th><td>", to);
	hawser__html_text(to, text);
	fputs("</td></tr>\n", to);
}

static void words_across(FILE *to, const char *text, size_t length)
{
	fputs("<tr><td colspan=\"2\">", to);
	put(to, text, length);
	fputs("</td></tr>\n", to);
}

void hawser__html_words_end(FILE *to)
{
	fputs("</tbody>\n</table>\n", to);
}

/* Where the heading of a comment ends, and the text begins: after " = " or ": ", whichever is first;
 * NULL: it has none. A heading with a comma or a semicolon in it is the first half of a sentence. */
static const char *heading_end(const char *line, size_t length, const char **text)
{
	const char *at = NULL;

	for (size_t i = 0; i + 2 < length && !at; i++) {
		if (line[i] == ',' || line[i] == ';')
			return NULL;
		if (strncmp(line + i, " = ", 3) == 0 && i + 3 < length) {
			at = line + i;
			*text = at + 3;
		} else if (strncmp(line + i, ": ", 2) == 0) {
			at = line + i;
			*text = at + 2;
		}
	}
	return at;
}

/* A comment without its "# ". */
struct comment {
	const char *line, *text; /* text: behind the heading; the line itself if there is none */
	size_t length, heading;  /* of the line and of the heading; 0: none */
};

static struct comment comment_at(const char *line)
{
	size_t length = strcspn(line, "\n"), skip = length > 1 ? 2 : 1;
	struct comment it = {line + skip, line + skip, length - skip, 0};
	const char *end = heading_end(it.line, it.length, &it.text);

	it.heading = end ? (size_t)(end - it.line) : 0;
	return it;
}

static const char *next_line(const char *line)
{
	size_t length = strcspn(line, "\n");

	return line + length + (line[length] == '\n');
}

static int same_heading(const struct comment *a, const struct comment *b)
{
	return a->heading && a->heading == b->heading && strncmp(a->line, b->line, a->heading) == 0;
}

enum { LINES = 12 }; /* of one heading that are shown; a list of more lines can be opened */

/* Number of comments from `line` on with this heading. */
static int lines_of(const struct comment *first, const char *line)
{
	int count = 0;

	for (; *line == '#'; line = next_line(line)) {
		struct comment it = comment_at(line);

		count += same_heading(&it, first);
	}
	return count;
}

/* One row for all comments from `line` on with the heading of the first. */
static void comments_row(FILE *to, const struct comment *first, const char *line)
{
	int count = lines_of(first, line);

	if (!first->heading) {
		words_across(to, first->line, first->length);
		return;
	}
	fputs("<tr><th scope=\"row\">", to);
	put(to, first->line, first->heading);
	fputs("</th><td>", to);
	if (count > LINES)
		fprintf(to, "<details><summary>%d lines</summary>\n", count);
	for (; *line == '#'; line = next_line(line)) {
		struct comment it = comment_at(line);

		if (!same_heading(&it, first))
			continue;
		fputs(count > 1 ? "<div>" : "", to);
		put(to, it.text, it.length - (size_t)(it.text - it.line));
		fputs(count > 1 ? "</div>\n" : "", to);
	}
	fprintf(to, "%s</td></tr>\n", count > LINES ? "</details>" : "");
}

static int is_first(const struct comment *it, const char *from)
{
	for (; from + 2 < it->line; from = next_line(from)) {
		struct comment other = comment_at(from);

		if (other.line != it->line && same_heading(&other, it))
			return 0;
	}
	return 1;
}

int hawser__html_comments(FILE *to, const char *tsv, const char *caption)
{
	const char *from = tsv;
	int count = 0;

	for (int head = 0; head < 2 && *from == '#'; head++)
		from = next_line(from);
	if (*from != '#')
		return 0;
	hawser__html_words_begin(to, caption);
	for (const char *line = from; *line == '#'; line = next_line(line)) {
		struct comment it = comment_at(line);

		if (!is_first(&it, from))
			continue;
		comments_row(to, &it, line);
		count++;
	}
	hawser__html_words_end(to);
	return count;
}

/* --- tables of numbers --- */

static void cell(FILE *to, const char *text, size_t length)
{
	char number[64] = "", *end = number;
	double value = 0.0;

	if (length > 0 && length < sizeof number) {
		memcpy(number, text, length);
		number[length] = '\0';
		value = strtod(number, &end);
	}
	if (end != number && !*end) {
		fprintf(to, "<td class=\"n\">%.8g</td>", value);
	} else {
		fputs("<td>", to);
		put(to, text, length);
		fputs("</td>", to);
	}
}

static void row(FILE *to, const char *line, int heads)
{
	fputs("<tr>", to);
	for (;;) {
		size_t length = strcspn(line, "\t\n");

		if (heads) {
			fputs("<th scope=\"col\">", to);
			put(to, line, length);
			fputs("</th>", to);
		} else {
			cell(to, line, length);
		}
		if (line[length] != '\t')
			break;
		line += length + 1;
	}
	fputs("</tr>\n", to);
}

static int is_chosen(int index, int rows, int most)
{
	if (rows <= most)
		return 1;
	/* where index (most - 1)/(rows - 1) reaches another whole number */
	return index == 0 ||
	       (long)index*(most - 1)/(rows - 1) != ((long)index - 1)*(most - 1)/(rows - 1);
}

int hawser__html_rows(FILE *to, const char *tsv, int most, const char *full)
{
	enum { OPEN = 12 }; /* longer tables are folded */
	enum { PAPER = 12 }; /* columns on paper, as report.css has it: more would leave the page */
	const char *line = tsv, *head;
	int rows = 0, shown, index = 0, columns = 1;

	while (*line == '#')
		line = next_line(line);
	head = line;
	if (!*head)
		return 0;
	for (line = next_line(head); *line; line = next_line(line))
		rows++;
	for (const char *c = head; *c && *c != '\n'; c++)
		columns += *c == '\t';
	shown = rows < most ? rows : most;
	fprintf(to, "<details%s>\n<summary>Table: %d of %d rows</summary>\n"
	        "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Table\">\n"
	        "<table class=\"rows\">\n<caption>Numbers rounded to eight digits; in full and all rows: "
	        "<code>", shown <= OPEN ? " open" : "", shown, rows);
	hawser__html_text(to, full);
	fputs("</code>", to);
	if (columns > PAPER)
		fprintf(to, "<span class=\"paper\">. Here the first %d of %d columns</span>", PAPER, columns);
	fputs("</caption>\n<thead>", to);
	row(to, head, 1);
	fputs("</thead>\n<tbody>\n", to);
	for (line = next_line(head); *line; line = next_line(line))
		if (is_chosen(index++, rows, most))
			row(to, line, 0);
	fputs("</tbody>\n</table>\n</div>\n</details>\n", to);
	return rows;
}

/* --- pictures --- */

/* Names of elements are unique in a page, and gnuplot's are the same in each picture: they get the
 * figure's number. */
static const char *const references[] = {
	" id='", " id=\"", "xlink:href='#", "xlink:href=\"#", " href='#", "url(#",
};
enum { REFERENCES = sizeof references/sizeof *references };

/* gnuplot's own titles, which browsers would show at the pointer, its description, and the size, which
 * is the page's. Returns the length of what is to be left out at this place, or 0. */
static size_t left_out(const char *at, int root)
{
	static const char *const element[][2] = {{"<title>", "</title>"}, {"<desc>", "</desc>"}};

	for (int i = 0; i < 2; i++)
		if (strncmp(at, element[i][0], strlen(element[i][0])) == 0) {
			const char *end = strstr(at, element[i][1]);

			return end ? (size_t)(end - at) + strlen(element[i][1]) : 0;
		}
	if (root && (strncmp(at, " width=\"", 8) == 0 || strncmp(at, " height=\"", 9) == 0)) {
		const char *end = strchr(strchr(at, '"') + 1, '"');

		return end ? (size_t)(end - at) + 1 : 0;
	}
	return 0;
}

/* Copy from the attributes of the outermost element on. `title`, `description`: its first children. */
static void copy_svg(FILE *to, const char *at, int number, const char *title,
                     const char *description)
{
	int root = 1; /* in the outermost element's attributes */

	while (*at) {
		size_t skip = left_out(at, root), length = 1;
		int i = 0;

		if (skip) {
			at += skip;
			continue;
		}
		while (i < REFERENCES && strncmp(at, references[i], strlen(references[i])) != 0)
			i++;
		if (i < REFERENCES)
			length = strlen(references[i]);
		fwrite(at, 1, length, to);
		if (i < REFERENCES)
			fprintf(to, "f%d-", number);
		if (root && *at == '>') {
			root = 0;
			fprintf(to, "<title id=\"t%d\">", number);
			hawser__html_text(to, title);
			fprintf(to, "</title><desc id=\"d%d\">", number);
			hawser__html_text(to, description);
			fputs("</desc>", to);
		}
		at += length;
	}
}

void hawser__html_picture(FILE *to, const char *svg, int number, const char *title,
                          const char *description)
{
	static const char root[] = "<svg";
	const char *at = strstr(svg, root);

	if (!at)
		return;
	fprintf(to, "<figure>\n<div class=\"plot\" tabindex=\"0\" role=\"group\" "
	        "aria-label=\"Picture %d: keys + and - enlarge and reduce it, arrows move it, 0 shows the "
	        "whole\">\n<svg role=\"img\" aria-labelledby=\"t%d d%d\"", number, number, number);
	copy_svg(to, at + strlen(root), number, title, description);
	fputs("</div>\n<div class=\"tools\"><button type=\"button\" value=\"+\">Enlarge</button>"
	      "<button type=\"button\" value=\"-\">Reduce</button>"
	      "<button type=\"button\" value=\"0\">Whole</button>"
	      "<output aria-live=\"polite\"></output></div>\n<figcaption>", to);
	fprintf(to, "Figure %d. ", number);
	hawser__html_text(to, title);
	fputs("</figcaption>\n</figure>\n", to);
}
