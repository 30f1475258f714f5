/* output/report/html.h - the elements of a report in HTML: one file without links to others, whose
 * style and script are report.css and report.js.
 *
 * All texts are escaped. What a computation printed is given as the text of its table (table.c) and of
 * its picture (gnuplot.c). Failures of the stream are left to the caller.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_HTML_H
#define HAWSER_OUTPUT_HTML_H

#include <stdio.h>

void hawser__html_begin(FILE *to, const char *title);
void hawser__html_end(FILE *to); /* with the script */
void hawser__html_text(FILE *to, const char *text);
/* An element of that name with this text. */
void hawser__html_element(FILE *to, const char *name, const char *text);

/* A table of two columns, the first with headings: _begin, _row, _end. */
void hawser__html_words_begin(FILE *to, const char *caption);
void hawser__html_words_row(FILE *to, const char *heading, const char *text);
void hawser__html_words_end(FILE *to);
/* The comments of a table, but for the first two (the command and the scene), as such a table: "a = b"
 * and "a: b" have the heading a, and those of one heading share a row. Returns the number of rows; 0:
 * nothing is written. */
int hawser__html_comments(FILE *to, const char *tsv, const char *caption);
/* Its rows, `most` of them at most, evenly chosen, with the first and the last. Numbers are rounded to
 * eight digits. `full`: the command that writes them all. Returns the number of all rows; 0: nothing
 * is written. */
int hawser__html_rows(FILE *to, const char *tsv, int most, const char *full);
/* The picture of figure `number`, with a text for those who do not see it. */
void hawser__html_picture(FILE *to, const char *svg, int number, const char *title,
                          const char *description);

#endif
