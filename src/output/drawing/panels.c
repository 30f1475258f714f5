/* output/drawing/panels.c - layout of pictures with one panel per mode.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/drawing/figure.h"

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

void hawser__panels_open(struct hawser__figure *figure, const struct hawser__panels *at, int k,
                         const struct hawser__panel_frame *frame)
{
	int column = k % at->columns, row = k/at->columns;
	double x = at->left + at->width*column, y = at->top - at->tall*(row + 1);
	struct hawser__panel_frame own = *frame;

	own.left = x;
	own.right = x + at->width - 0.032;
	own.bottom = y;
	own.top = y + at->tall - 0.95/at->height;
	own.x.bare |= k + at->columns < at->panels;
	own.y.bare |= column > 0;
	own.y.untitled |= k > 0;
	hawser__figure_panel(figure, &own);
	/* once for all rows: the title of a row may be longer than the row is high */
	figure->out.middle = 0.5*(at->bottom + at->top - 0.95/at->height);
}

void hawser__panels_frequency(FILE *script, int k, double omega, const char *what)
{
	const struct hawser__axis axis = hawser__axis_of("", "Hz", 0.0);

	fprintf(script, "set title '%d:  %.4g %s,  %s' offset 0,-0.6\n", k + 1, omega/(2.0*M_PI)/axis.per,
	        axis.unit, what);
}
