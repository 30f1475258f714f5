/* output/plot_net.c - see plot_net.h. The eye looks at the middle of the net from above and from one
 * side, from a distance of some times its size. A plane net is seen from the front.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/plot_net.h"
#include "output/style.h"

#define AZIMUTH 0.35  /* rad, about the vertical */
#define ELEVATION 0.6 /* rad, above the horizon */
#define DISTANCE 3.0  /* of the eye, over the size of the net */
enum { NAMED = 30, FEW = 300 }; /* most nodes whose names are shown; that are drawn large */

struct eye {
	double middle[3], size, azimuth, elevation;
};

static void look(struct eye *eye, const struct hawser_net_statics *st)
{
	double low[3], high[3];

	for (int k = 0; k < 3; k++) {
		low[k] = high[k] = st->x[0][k];
		for (int i = 0; i < st->points; i++) {
			low[k] = fmin(low[k], st->point[i].x[k]);
			high[k] = fmax(high[k], st->point[i].x[k]);
		}
		eye->middle[k] = (low[k] + high[k])/2.0;
	}
	eye->size = fmax(fmax(high[0] - low[0], high[1] - low[1]), high[2] - low[2]);
	eye->size = eye->size > 0.0 ? eye->size : 1.0;
	eye->azimuth = high[2] - low[2] > 1e-6*eye->size ? AZIMUTH : 0.0;
	eye->elevation = eye->azimuth > 0.0 ? ELEVATION : 0.0;
}

static void project(double to[2], const struct eye *eye, const double x[3])
{
	double a = x[0] - eye->middle[0], b = x[1] - eye->middle[1], c = x[2] - eye->middle[2];
	double right = a*cos(eye->azimuth) - c*sin(eye->azimuth);
	double near = a*sin(eye->azimuth) + c*cos(eye->azimuth);
	double up = b*cos(eye->elevation) - near*sin(eye->elevation);
	double far = DISTANCE*eye->size - near*cos(eye->elevation) - b*sin(eye->elevation);
	double scale = eye->elevation > 0.0 ? DISTANCE*eye->size/far : 1.0;

	to[0] = right*scale;
	to[1] = up*scale;
}

/* Tensions are in units of `per` newton. */
static void cable_data(FILE *script, const struct hawser_net_statics *st, const struct eye *eye,
                       double per)
{
	fputs("$cables << END\n", script);
	for (int i = 0; i < st->points; i++) {
		const struct hawser_net_point *point = &st->point[i];
		double to[2];

		if (i > 0 && point->cable != st->point[i - 1].cable)
			fputs("\n", script);
		project(to, eye, point->x);
		fprintf(script, "%.7g %.7g %.7g\n", to[0], to[1], point->T/per);
	}
	fputs("END\n", script);
}

static void node_data(FILE *script, const struct hawser_net *net, const struct hawser_net_statics *st,
                      const struct eye *eye, int support)
{
	fprintf(script, "$%s << END\n", support ? "supports" : "joints");
	for (int i = 0; i < st->nodes; i++) {
		double to[2];

		if (net->node[i].support != support)
			continue;
		project(to, eye, st->x[i]);
		fprintf(script, "%.7g %.7g %s\n", to[0], to[1], net->node[i].name);
	}
	fputs("NaN NaN x\nEND\n", script);
}

enum hawser_status hawser__plot_net(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st, struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 9.5, report);
	FILE *script = picture.script;
	int few = st->nodes <= FEW;
	double most = 0.0;
	struct eye eye;

	if (status)
		return status;
	look(&eye, st);
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
	      "set colorbox user origin 0.88, 0.15 size 0.02, 0.7\n", script);
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
