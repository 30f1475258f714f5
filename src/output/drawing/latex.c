/* output/drawing/latex.c - see picture_choice.h.
 *
 * gnuplot's terminal cairolatex writes the drawing as PDF and its texts as they stand, for LaTeX.
 * The texts of all pictures have gnuplot's own markup, so they are translated here, behind gnuplot:
 * numbers of tics and names in data then pass the same code as titles. Letters of a text are set
 * upright outside of formulas; italics, Greek, indices and exponents are formulas.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/file.h"
#include "core/report.h"
#include "output/drawing/picture_choice.h"

#define MARK '\001' /* before a text that begins with a bracket */

/* How letters are set at present: outside of a formula, or in one. */
enum style { PLAIN, SYMBOL, ROMAN, ITALIC };

struct writer {
	FILE *to;
	enum style style;
	int depth;  /* of indices and exponents: 0: none */
	int italic; /* 1: within {/:Italic } */
};

/* What LaTeX has for characters: outside of formulas (NULL: the formula), in a formula. */
static const struct {
	const char *bytes, *plain, *formula;
} signs[] = {
	{"²", NULL, "^2"}, {"³", NULL, "^3"}, {"×", NULL, "\\times "}, {"−", NULL, "-"},
	{"–", "--", "-"}, {"·", NULL, "\\cdot "}, {"±", NULL, "\\pm "}, {"°", NULL, "^\\circ "},
	{"→", NULL, "\\to "}, {"≤", NULL, "\\le "}, {"≥", NULL, "\\ge "}, {"∞", NULL, "\\infty "},
	{"α", NULL, "\\alpha "}, {"β", NULL, "\\beta "}, {"γ", NULL, "\\gamma "},
	{"δ", NULL, "\\delta "}, {"ε", NULL, "\\varepsilon "}, {"ζ", NULL, "\\zeta "},
	{"η", NULL, "\\eta "}, {"θ", NULL, "\\theta "}, {"κ", NULL, "\\kappa "},
	{"λ", NULL, "\\lambda "}, {"μ", NULL, "\\mu "}, {"µ", NULL, "\\mu "}, {"ν", NULL, "\\nu "},
	{"ξ", NULL, "\\xi "}, {"π", NULL, "\\pi "}, {"ρ", NULL, "\\rho "}, {"σ", NULL, "\\sigma "},
	{"τ", NULL, "\\tau "}, {"φ", NULL, "\\varphi "}, {"χ", NULL, "\\chi "}, {"ψ", NULL, "\\psi "},
	{"ω", NULL, "\\omega "}, {"Γ", NULL, "\\Gamma "}, {"Δ", NULL, "\\Delta "},
	{"Θ", NULL, "\\Theta "}, {"Λ", NULL, "\\Lambda "}, {"Σ", NULL, "\\Sigma "},
	{"Φ", NULL, "\\Phi "}, {"Ψ", NULL, "\\Psi "}, {"Ω", NULL, "\\Omega "},
	{"#", "\\#", "\\#"}, {"$", "\\$", "\\$"}, {"%", "\\%", "\\%"}, {"&", "\\&", "\\&"},
	{"_", "\\_", "\\_"}, {"{", "\\{", "\\{"}, {"}", "\\}", "\\}"},
	{"~", "\\textasciitilde{}", "\\sim "}, {"^", "\\textasciicircum{}", "\\wedge "},
	{"\\", "\\textbackslash{}", "\\backslash "}, {"<", NULL, "<"}, {">", NULL, ">"},
	{"|", NULL, "|"}, {"\"", "''", "''"}, {" ", " ", "\\ "},
};
enum { SIGNS = sizeof signs/sizeof *signs };

static void set_style(struct writer *w, enum style style)
{
	if (style == w->style)
		return;
	if (w->style >= ROMAN)
		fputc('}', w->to);
	if (w->style == PLAIN || style == PLAIN)
		fputc('$', w->to);
	if (style >= ROMAN)
		fputs(style == ROMAN ? "\\mathrm{" : "\\mathit{", w->to);
	w->style = style;
}

/* Write the character at text as it stands; returns what is behind it. */
static const char *put_character(struct writer *w, const char *text)
{
	int formula = w->depth || w->italic;

	for (int k = 0; k < SIGNS; k++) {
		size_t length = strlen(signs[k].bytes);

		if (strncmp(text, signs[k].bytes, length) != 0)
			continue;
		formula = formula || !signs[k].plain;
		set_style(w, formula ? SYMBOL : PLAIN);
		fputs(formula ? signs[k].formula : signs[k].plain, w->to);
		return text + length;
	}
	set_style(w, !formula ? PLAIN : isdigit((unsigned char)*text) ? SYMBOL
	          : w->italic && isalpha((unsigned char)*text) ? ITALIC
	          : isalpha((unsigned char)*text) || (*text & 0x80) ? ROMAN : SYMBOL);
	do
		fputc(*text++, w->to);
	while ((*text & 0xC0) == 0x80); /* the rest of a character of several bytes */
	return text;
}

/* The end of a group that begins at text: its brace, or the end of the text. */
static const char *group_end(const char *text)
{
	int depth = 0;

	for (; *text; text++) {
		if (*text == '\\' && text[1])
			text++;
		else if (*text == '{')
			depth++;
		else if (*text == '}' && --depth == 0)
			break;
	}
	return text;
}

static void put_range(struct writer *w, const char *text, const char *end);

/* A group: "{...}" or "{/:Italic ...}". Other fonts and sizes have no effect. */
static const char *put_group(struct writer *w, const char *text)
{
	static const char italic[] = "/:Italic ";
	const char *end = group_end(text), *from = text + 1;
	int before = w->italic;

	if (!strncmp(from, italic, strlen(italic))) {
		w->italic = 1;
		from += strlen(italic);
	} else if (*from == '/') {
		from += strcspn(from, " }");
		from += *from == ' ';
	}
	if (from < end)
		put_range(w, from, end);
	w->italic = before;
	return *end ? end + 1 : end;
}

/* One item of the markup: a character, a group, or an index or exponent. */
static const char *put_item(struct writer *w, const char *text)
{
	int italic = w->italic;

	if (*text == '\\' && text[1])
		return put_character(w, text + 1);
	if (*text == '{')
		return put_group(w, text);
	if ((*text != '_' && *text != '^') || !text[1])
		return put_character(w, text);
	set_style(w, SYMBOL);
	fprintf(w->to, "%c{", *text);
	w->depth++;
	w->italic = 0;
	text = put_item(w, text + 1);
	set_style(w, SYMBOL);
	fputc('}', w->to);
	w->depth--;
	w->italic = italic;
	return text;
}

static void put_range(struct writer *w, const char *text, const char *end)
{
	while (text < end)
		text = put_item(w, text);
}

/* A number as a formula: its minus is one, and 1e-05 is 1·10^-5. Returns 0 for other texts. */
static int put_number(FILE *to, const char *text)
{
	const char *power = strpbrk(text, "eE");
	char *end;

	if (!*text || text[strspn(text, "+-.0123456789eE")])
		return 0;
	(void)strtod(text, &end);
	if (*end || end == text)
		return 0;
	if (power)
		fprintf(to, "$%.*s\\cdot10^{%ld}$", (int)(power - text), text, strtol(power + 1, NULL, 10));
	else
		fprintf(to, "$%s$", text);
	return 1;
}

/* Write a text with gnuplot's markup ("{/:Italic u}_{3} (rad/s²)") as LaTeX sets it. */
static void put_text(FILE *to, const char *text)
{
	struct writer w = {.to = to};

	if (put_number(to, text))
		return;
	put_range(&w, text, text + strlen(text));
	set_style(&w, PLAIN);
}

/* --- the file --- */

/* The text of a line "\put(...){\makebox(0,0)[l]{\strut{}TEXT}}%"; *length of it, or NULL. */
static const char *text_of(const char *line, size_t *length)
{
	static const char start[] = "{\\strut{}";
	const char *box = strstr(line, "\\makebox(0,0)"), *text = box ? strstr(box, start) : NULL;
	size_t tail = strstr(line, "\\rotatebox{") ? 3 : 2; /* braces */

	if (!text || strncmp(line + strspn(line, " "), "\\put(", 5) != 0)
		return NULL;
	text += strlen(start);
	*length = strcspn(text, "\n");
	while (*length && text[*length - 1] == '%')
		--*length;
	if (*length < tail)
		return NULL;
	*length -= tail;
	return text;
}

static void copy_line(FILE *to, char *line, const char *drawing)
{
	static const char graphics[] = "\\includegraphics[";
	const char *at = strstr(line, graphics), *name = at ? strstr(at, "]{") : NULL;
	size_t length = 0;
	char *text = (char *)text_of(line, &length);

	if (name && !strncmp(line + strspn(line, " "), "\\put(", 5)) {
		fprintf(to, "%.*s]{%s}}%%\n", (int)(name - line), line, drawing);
	} else if (text) {
		char last = text[length];

		fwrite(line, 1, (size_t)(text - line), to);
		text[length] = '\0';
		put_text(to, text + (*text == MARK));
		text[length] = last;
		fputs(text + length, to);
	} else {
		fputs(line, to);
	}
}

/* Copy the texts, with the name of the drawing. */
static void copy(FILE *to, FILE *from, const char *drawing, double size)
{
	char *line = NULL;
	size_t room = 0;

	fprintf(to, "%% A picture of hawser, for \\input in a document with \\usepackage{graphicx,color}.\n"
	        "%% Its drawing is %s, which LaTeX looks for where \\graphicspath says.\n"
	        "%% Another size of its letters: \\newcommand\\hawserfont{\\footnotesize}\n", drawing);
	for (int begun = 0; getline(&line, &room, from) >= 0;) {
		copy_line(to, line, drawing);
		if (!begun && !strncmp(line, "\\begingroup", strlen("\\begingroup"))) {
			fprintf(to, "  \\providecommand\\hawserfont{\\fontsize{%.4g}{%.4g}\\selectfont}%%\n"
			        "  \\hawserfont\n", size, 1.2*size); /* lines as far apart as LaTeX has them */
			begun = 1;
		}
	}
	free(line);
}

/* "a/x.pdf" of "a/x.tex"; the caller frees it. */
static char *drawing_of(const char *path)
{
	char *drawing = strdup(path);

	if (drawing)
		/* NOLINTNEXTLINE(bugprone-not-null-terminated-result): the zero is there */
		memcpy(drawing + strlen(drawing) - 3, "pdf", 3);
	return drawing;
}

static enum hawser_status no_file(struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, "picture",
	                    "cannot write a temporary file for gnuplot: %s", strerror(errno));
}

enum hawser_status hawser__latex_check(const char *path, struct hawser_report *report)
{
	enum hawser_status status;
	char *drawing;

	for (const char *name = hawser__file_name(path); *name; name++)
		if (!isalnum((unsigned char)*name) && !strchr(".-+_=", *name))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "picture",
			                    "%s: LaTeX has to read the name of the drawing beside it: use letters, "
			                    "digits and . - + _ =", path);
	drawing = drawing_of(path);
	if (!drawing)
		return hawser__no_memory(report, "picture");
	status = hawser__file_check(drawing, report);
	free(drawing);
	return status;
}

enum hawser_status hawser__latex_begin(struct hawser__latex *latex, FILE *script,
                                       struct hawser_report *report)
{
	int c, last = 0, lines = 0;

	latex->script = tmpfile();
	if (!hawser__temporary_folder(latex->folder, sizeof latex->folder) || !latex->script)
		return no_file(report);
	while ((c = getc(script)) != EOF) {
		if ((last == '\'' || last == '"') && (c == '{' || c == '['))
			putc(MARK, latex->script);
		putc(c, latex->script);
		if (c == '\n' && lines++ == 0) {
			fputs("set output '", latex->script);
			for (const char *path = latex->folder; *path; path++)
				fprintf(latex->script, "%s%c", *path == '\'' ? "'" : "", *path);
			fputs("/picture.tex'\n", latex->script);
		}
		last = c;
	}
	fputs("set output\n", latex->script);
	if (ferror(script) || fflush(latex->script) != 0 || ferror(latex->script))
		return no_file(report);
	rewind(latex->script);
	return HAWSER_OK;
}

/* One of gnuplot's two files. */
static FILE *open_one(const struct hawser__latex *latex, const char *name)
{
	char path[sizeof latex->folder + 16]; /* "/picture.tex" */

	snprintf(path, sizeof path, "%s/%s", latex->folder, name);
	return fopen(path, "rb");
}

static enum hawser_status write_drawing(const struct hawser__latex *latex, const char *path,
                                        struct hawser_report *report)
{
	FILE *from = open_one(latex, "picture.pdf");
	struct hawser__file file = {0};
	enum hawser_status status = from ? hawser__file_begin(&file, path, report) : no_file(report);
	int c;

	while (!status && (c = getc(from)) != EOF)
		putc(c, file.stream);
	if (!status && ferror(from)) {
		status = no_file(report);
		hawser__file_abort(&file);
	} else if (!status) {
		status = hawser__file_commit(&file, report);
	}
	if (from)
		fclose(from);
	return status;
}

enum hawser_status hawser__latex_write(struct hawser__latex *latex, FILE *to, const char *path,
                                       double size, struct hawser_report *report)
{
	char *drawing = drawing_of(path);
	enum hawser_status status = drawing ? write_drawing(latex, drawing, report)
	                                    : hawser__no_memory(report, "picture");
	FILE *from = status ? NULL : open_one(latex, "picture.tex");

	if (from) {
		copy(to, from, hawser__file_name(drawing), size);
		if (ferror(from))
			status = no_file(report);
		fclose(from);
	} else if (!status) {
		status = no_file(report);
	}
	free(drawing);
	return status;
}

void hawser__latex_clear(struct hawser__latex *latex)
{
	static const char *const name[] = {"picture.tex", "picture.pdf"};
	char path[sizeof latex->folder + 16]; /* "/picture.tex" */

	for (size_t i = 0; *latex->folder && i < sizeof name/sizeof *name; i++) {
		snprintf(path, sizeof path, "%s/%s", latex->folder, name[i]);
		unlink(path);
	}
	if (*latex->folder)
		rmdir(latex->folder);
	if (latex->script)
		fclose(latex->script);
	memset(latex, 0, sizeof *latex);
}
