/* output/style.c - what all pictures share.
 *
 * Colours are Okabe and Ito's palette, which all kinds of colour vision tell apart.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "output/output.h"
#include "output/style.h"

const char hawser__picture_look[] =
	"set encoding utf8\n"
	"set linetype 1 lc rgb '#0072B2' lw 1.6\n"
	"set linetype 2 lc rgb '#D55E00' lw 1.6\n"
	"set linetype 3 lc rgb '#009E73' lw 1.6\n"
	"set linetype 4 lc rgb '#CC79A7' lw 1.6\n"
	"set linetype 5 lc rgb '#E69F00' lw 1.6\n"
	"set linetype 6 lc rgb '#56B4E9' lw 1.6\n"
	"set linetype 7 lc rgb '#000000' lw 1.6\n"
	"set border 3 lw 0.8 lc rgb '#404040'\n"
	"set tics nomirror out scale 0.6\n"
	"set format '%g'\n"
	"set grid lw 0.5 lc rgb '#d8d8d8' dt solid\n"
	"set key reverse Left\nset key off\n"
	"set multiplot\n";

void hawser__picture_legend(struct hawser__picture *picture, int most_rows)
{
	hawser__picture_panel(picture, 0.05, 0.95, 0.001, 0.004);
	fprintf(picture->script,
	        "unset arrow\nunset label\nunset title\nunset border\nunset tics\nunset grid\n"
	        "unset xlabel\nunset xzeroaxis\nunset logscale\nset offsets 0, 0, 0, 0\n"
	        "set xrange [0:1]\nset yrange [0:1]\n"
	        "set key at screen 0.54,0.01 center bottom horizontal maxrows %d samplen 2.5\n",
	        most_rows);
}

void hawser__picture_spaces(FILE *to, FILE *from)
{
	static const char tag[] = "<text";
	size_t seen = 0;
	int c;

	while ((c = getc(from)) != EOF) {
		if (tag[seen] == '\0' && c == '>') /* gnuplot says it itself of some */
			fputs(" xml:space=\"preserve\"", to);
		seen = tag[seen] == c && c ? seen + 1 : c == '<';
		putc(c, to);
	}
}
