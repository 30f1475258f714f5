/* output/drawing/style.c - appearance common to all pictures.
 *
 * The colours are the palette of Okabe and Ito, which people with any colour vision can
 * distinguish.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "output/output.h"
#include "output/drawing/style.h"

#define HAWSER__AXES \
	"set border 3 lw 0.8 lc rgb '#404040'\nset xtics\nset ytics\n" \
	"set tics nomirror out scale 0.6\nset grid lw 0.5 lc rgb '#d8d8d8' dt solid\n"
const char hawser__picture_axes[] = HAWSER__AXES;
const char hawser__picture_look[] =
	"set encoding utf8\n"
	"set linetype 1 lc rgb '#0072B2' lw 1.6\n"
	"set linetype 2 lc rgb '#D55E00' lw 1.6\n"
	"set linetype 3 lc rgb '#009E73' lw 1.6\n"
	"set linetype 4 lc rgb '#CC79A7' lw 1.6\n"
	"set linetype 5 lc rgb '#E69F00' lw 1.6\n"
	"set linetype 6 lc rgb '#56B4E9' lw 1.6\n"
	"set linetype 7 lc rgb '#000000' lw 1.6\n"
	"set linetype 8 lc rgb '#8a8a8a' lw 1.6\n"
	"set format '%g'\n" HAWSER__AXES
	"set key reverse Left\nset key off\n"
	"set multiplot\n";

void hawser__picture_literal(FILE *script, const char *text, int data)
{
	for (; *text; text++) {
		if (strchr("_^{}@&~\\", *text))
			fputs(data ? "\\\\" : "\\", script);
		if (*text == '\'' && !data)
			putc('\'', script);
		if (*text == '\\' && data)
			putc('\\', script);
		putc(*text == '\n' ? ' ' : *text, script);
	}
}

void hawser__legend_add(struct hawser__legend *legend, const char *title, const char *style, ...)
{
	struct hawser__legend_entry *entry = &legend->entry[legend->count];
	va_list args;

	if (legend->count == HAWSER__LEGEND_MOST)
		return;
	va_start(args, style);
	vsnprintf(entry->style, sizeof entry->style, style, args);
	va_end(args);
	snprintf(entry->title, sizeof entry->title, "%s", title);
	legend->count++;
}

void hawser__legend_once(struct hawser__legend *legend, const char *title, const char *style)
{
	for (int k = 0; k < legend->count; k++)
		if (strcmp(legend->entry[k].title, title) == 0)
			return;
	hawser__legend_add(legend, title, "%s", style);
}

enum { CAUTIONS = 6 };
static char caution[CAUTIONS][80];
static int cautions;

void hawser__legend_caution(const char *brief)
{
	if (!brief)
		cautions = 0;
	else if (cautions < CAUTIONS)
		snprintf(caution[cautions++], sizeof *caution, "%s", brief);
}

void hawser__legend_cautions(struct hawser__legend *legend)
{
	for (int k = 0; k < cautions; k++)
		hawser__legend_once(legend, caution[k], "with points pt 8 ps 1.2 lc rgb '#b00020'");
}

/* Width of an entry in cm, with its sample and the gap to the next entry. Markup and continuation
 * bytes of UTF-8 have no width; a letter has 0.6 of the font size of 12 px. */
static double entry_width(const struct hawser__legend_entry *entry)
{
	static const char italic[] = "{/:Italic ";
	const double letter = 0.19, sample = 1.15, gap = 0.55;
	int letters = 0;

	for (const char *c = entry->title; *c; c++)
		if (strncmp(c, italic, sizeof italic - 1) == 0)
			c += sizeof italic - 2;
		else
			letters += ((unsigned char)*c & 0xC0) != 0x80 && !strchr("{}_", *c);
	return sample + gap + letter*letters;
}

/* Widths of the columns, which are filled one after another: width [columns]; returns their sum. */
static double columns(double *width, const struct hawser__legend *legend, int rows)
{
	double sum = 0.0;

	for (int k = 0; k < legend->count; k++) {
		double *mine = &width[k/rows], wide = entry_width(&legend->entry[k]);

		if (k % rows == 0)
			*mine = 0.0;
		sum += wide > *mine ? wide - *mine : 0.0;
		*mine = wide > *mine ? wide : *mine;
	}
	return sum;
}

static const double pitch = 0.5, foot = 0.12; /* cm: of rows, and below the last */

/* The fewest rows that fit a picture of that width (cm); width [columns], and *sum of them. */
static int rows_for(double *width, double *sum, const struct hawser__legend *legend, double room)
{
	int rows = 0;

	do
		*sum = columns(width, legend, ++rows);
	while (rows < legend->count && *sum > room - 0.3);
	return rows;
}

void hawser__legend_draw(struct hawser__picture *picture, const struct hawser__legend *legend)
{
	double width[HAWSER__LEGEND_MOST], sum, x;
	int rows = rows_for(width, &sum, legend, picture->width);

	picture->more = pitch*fmax(rows - 2.0, 0.0);
	hawser__picture_panel(picture, 0.05, 0.95, 0.001, 0.004);
	fprintf(picture->script,
	        "unset arrow\nunset label\nunset object\nunset title\nunset border\nunset tics\n"
	        "unset colorbox\nunset grid\nunset xlabel\nunset xzeroaxis\nunset logscale\n"
	        "set xrange [0:1]\nset yrange [0:1]\n");
	x = fmax(0.5*(picture->width - sum), 0.05);
	for (int k = 0; k < legend->count; k++) {
		double y = foot + pitch*(rows - 1 - k % rows);

		fprintf(picture->script,
		        "set key at screen %.4f, screen up(%.5f) left bottom Left reverse samplen 2.5\n"
		        "plot NaN %s title '%s'\n", x/picture->width, (y - picture->more)/picture->height,
		        legend->entry[k].style, legend->entry[k].title);
		if (k % rows == rows - 1)
			/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): rows_for() fills all columns */
			x += width[k/rows];
	}
}

void hawser__picture_head(FILE *to, FILE *from)
{
	static const char root[] = "<svg ";
	size_t in_root = 0;
	int c;

	while (root[in_root] && (c = getc(from)) != EOF) {
		in_root = root[in_root] == c ? in_root + 1 : c == '<';
		putc(c, to);
	}
}

void hawser__picture_spaces(FILE *to, FILE *from)
{
	static const char text[] = "<text", image[] = "<image";
	size_t in_text = 0, in_image = 0;
	int c;

	while ((c = getc(from)) != EOF) {
		if (text[in_text] == '\0' && c == '>') /* gnuplot adds it to some elements */
			fputs(" xml:space=\"preserve\"", to);
		if (image[in_image] == '\0' && c == ' ')
			fputs(" style='image-rendering:pixelated'", to);
		in_text = text[in_text] == c && c ? in_text + 1 : c == '<';
		in_image = image[in_image] == c && c ? in_image + 1 : c == '<';
		putc(c, to);
	}
}
