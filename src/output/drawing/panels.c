/* output/drawing/panels.c - layout of pictures with one panel per mode.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/panels.h"

double hawser__panels_magnify(double mine, double other)
{
	double room = mine > 0.0 ? 0.45*other/mine : 1.0, power = pow(10.0, floor(log10(room)));

	if (room < 2.0 || room > 1e9)
		return 1.0;
	return room >= 5.0*power ? 5.0*power : room >= 2.0*power ? 2.0*power : power;
}

struct hawser__panels hawser__panels_arrange(int modes)
{
	int panels = modes < HAWSER__PANELS ? modes : HAWSER__PANELS;
	struct hawser__panels at = {.panels = panels, .columns = panels == 1 ? 1 : panels <= 4 ? 2 : 3};

	at.rows = (panels + at.columns - 1)/at.columns;
	at.height = 3.2 + 4.2*at.rows;
	at.bottom = 2.7/at.height;
	at.top = 1.0 - 0.05/at.height;
	at.left = 0.122;
	at.width = (1.0 - at.left)/at.columns;
	at.tall = (at.top - at.bottom)/at.rows;
	return at;
}

void hawser__panels_place(struct hawser__picture *picture, const struct hawser__panels *at, int k)
{
	int column = k % at->columns;
	/* NOLINTNEXTLINE(bugprone-integer-division): the integer quotient is intended */
	double x = at->left + at->width*column, y = at->top - at->tall*(k/at->columns + 1);

	hawser__picture_panel(picture, x, x + at->width - 0.032, y, y + at->tall - 0.95/at->height);
}

void hawser__panels_open(struct hawser__picture *picture, const struct hawser__panels *at, int k,
                         const char *xlabel, const char *ylabel)
{
	int column = k % at->columns, last = k + at->columns >= at->panels;

	fprintf(picture->script, "set format x '%s'\nset format y '%s'\n", last ? "%g" : "",
	        column == 0 ? "%g" : "");
	if (last)
		fprintf(picture->script, "set xlabel '%s' offset 0,0.4\n", xlabel);
	else
		fputs("unset xlabel\n", picture->script);
	hawser__panels_place(picture, at, k);
	fputs("unset label\n", picture->script);
	if (k == 0) {
		/* once for all rows: the title of a row may be longer than the row is high */
		picture->middle = 0.5*(at->bottom + at->top - 0.95/at->height);
		hawser__picture_ylabel(picture, "%s", ylabel);
	}
}

void hawser__panels_frequency(FILE *script, int k, double omega, const char *what)
{
	const struct hawser__axis axis = hawser__axis_of("", "Hz", 0.0);

	fprintf(script, "set title '%d:  %.4g %s,  %s' offset 0,-0.6\n", k + 1, omega/(2.0*M_PI)/axis.per,
	        axis.unit, what);
}
