/* output/plot_net.c - see plot_net.h. A plane net is seen from the front.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/perspective.h"
#include "output/plot_net.h"
#include "output/style.h"

#define WIDTH 16.0 /* cm */
#define HEIGHT 9.5 /* cm */
enum { NAMED = 30, FEW = 300 }; /* most nodes whose names are shown; that are drawn large */

static struct hawser__eye eye_of(const struct hawser_net_statics *st)
{
	struct hawser__box box = {.any = 0};
	struct hawser__eye eye;

	for (int i = 0; i < st->nodes; i++)
		hawser__box_add(&box, st->x[i], 3);
	for (int i = 0; i < st->points; i++)
		hawser__box_add(&box, st->point[i].x, 3);
	hawser__eye_look(&eye, &box, HAWSER__IN_SPACE, NULL);
	return eye;
}

/* Tensions are in units of `per` newton. */
static void cable_data(FILE *script, const struct hawser_net_statics *st, const struct hawser__eye *eye,
                       double per)
{
	fputs("$cables << END\n", script);
	for (int i = 0; i < st->points; i++) {
		const struct hawser_net_point *point = &st->point[i];
		double to[2];

		if (i > 0 && point->cable != st->point[i - 1].cable)
			fputs("\n", script);
		hawser__eye_see(to, eye, point->x);
		fprintf(script, "%.7g %.7g %.7g\n", to[0], to[1], point->T/per);
	}
	fputs("END\n", script);
}

static void node_data(FILE *script, const struct hawser_net *net, const struct hawser_net_statics *st,
                      const struct hawser__eye *eye, int support)
{
	fprintf(script, "$%s << END\n", support ? "supports" : "joints");
	for (int i = 0; i < st->nodes; i++) {
		double to[2];

		if (net->node[i].support != support)
			continue;
		hawser__eye_see(to, eye, st->x[i]);
		fprintf(script, "%.7g %.7g %s\n", to[0], to[1], net->node[i].name);
	}
	fputs("NaN NaN x\nEND\n", script);
}

enum hawser_status hawser__plot_net(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st, struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, WIDTH, HEIGHT, report);
	FILE *script = picture.script;
	int few = st->nodes <= FEW;
	double most = 0.0;
	struct hawser__eye eye;

	if (status)
		return status;
	eye = eye_of(st);
	for (int c = 0; c < st->cables; c++)
		most = fmax(most, st->member[c].T_max);
	cable_data(script, st, &eye, most >= 1e4 ? 1e3 : 1.0);
	node_data(script, net, st, &eye, 1);
	node_data(script, net, st, &eye, 0);
	hawser__picture_panel(&picture, 0.04, 0.86, 0.06, 0.96);
	fprintf(script, "set cblabel 'Tension {/:Italic T} (%s)' offset 1, 0\n", most >= 1e4 ? "kN" : "N");
	fputs("set size ratio -1\nunset border\nunset xtics\nunset ytics\nunset grid\nunset key\n"
	      "set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n"
	      "set palette defined (0 '#4575B4', 1 '#91BFDB', 2 '#FEE090', 3 '#FC8D59', 4 '#D73027')\n"
	      "set colorbox user origin 0.88, 0.22 size 0.02, 0.66\n", script);
	hawser__eye_axes(script, &eye, &(struct hawser__corner){14.6, 0.8, WIDTH, HEIGHT});
	fprintf(script, "plot $cables using 1:2:3 with lines lw %g lc palette, "
	        "$supports using 1:2 with points pt 9 ps %g lc rgb 'black'", few ? 2.0 : 0.8,
	        few ? 1.2 : 0.5);
	if (few)
		fputs(", $joints using 1:2 with points pt 7 ps 0.5 lc rgb 'black'", script);
	if (st->nodes <= NAMED)
		fputs(", $joints using 1:2:3 with labels offset 0.9, 0.6 font ',9' noenhanced"
		      ", $supports using 1:2:3 with labels offset 0.9, 0.6 font ',9' noenhanced", script);
	fputs("\n", script);
	return hawser__picture_finish(&picture, report);
}
