/* output/plot_net.c - see plot_net.h. A plane net is seen from the front.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/perspective.h"
#include "output/plot_net.h"
#include "output/style.h"

#define WIDTH 16.0 /* cm */
#define HEIGHT 9.5 /* cm, at most */
#define LEAST 6.0  /* cm: height that the colours and the axes need */
#define LEFT 0.04  /* of the width */
#define RIGHT 0.86 /* of the width: colours and their title are beside */
#define BOTTOM 0.5 /* cm below the net */
#define TOP 0.4    /* cm above it */
#define KEY 0.6    /* cm more above it: a line of symbols, where there are obstacles */
#define ARROWS 2.3 /* cm below the colours: arrows along the axes */
#define EVEN 0.01  /* of the largest tension: ranges of colour are no smaller */
enum { NAMED = 30, FEW = 300 }; /* most nodes whose names are shown; that are drawn large */

static struct hawser__eye eye_of(struct hawser__box *box, const struct hawser_net_statics *st)
{
	struct hawser__eye eye;

	*box = (struct hawser__box){.any = 0};
	for (int i = 0; i < st->nodes; i++)
		hawser__box_add(box, st->x[i], 3);
	for (int i = 0; i < st->points; i++)
		hawser__box_add(box, st->point[i].x, 3);
	hawser__eye_look(&eye, box, HAWSER__IN_SPACE, NULL);
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
		fprintf(script, "%.7g %.7g ", to[0], to[1]);
		hawser__picture_literal(script, net->node[i].name, 1);
		fputc('\n', script);
	}
	fputs("NaN NaN x\nEND\n", script);
}

/* --- obstacles: outlines within the box of the net --- */

enum { ROUND = 96 }; /* sides of a circle */

/* Draws lines, or (script is NULL) adds what it would draw to a box. */
struct pen {
	FILE *script;
	struct hawser__box *seen;
	const struct hawser__eye *eye;
};

static void corner(const struct pen *pen, double x, double y, double z)
{
	double to[2];

	hawser__eye_see(to, pen->eye, (double[3]){x, y, z});
	if (pen->script)
		fprintf(pen->script, "%.7g %.7g\n", to[0], to[1]);
	else
		hawser__box_add(pen->seen, to, 2);
}

static void up(const struct pen *pen)
{
	if (pen->script)
		fputs("\n", pen->script);
}

/* A plane: its part above the box's base or, of a steep one, beside the box's height. */
static void plane_data(const struct pen *pen, const struct hawser_surface *of,
                       const struct hawser__box *box)
{
	const double *n = of->normal, *low = box->low, *high = box->high;
	int upright = fabs(n[1]) < 0.3, flat = low[2] == high[2];

	for (int i = 0; i < (flat ? 2 : 5); i++) {
		double one = i == 1 || i == 2 ? 1.0 : 0.0, z = i == 2 || i == 3 ? high[2] : low[2];
		double x = low[0] + one*(high[0] - low[0]), y = low[1] + one*(high[1] - low[1]);
		double rest = n[0]*of->at[0] + n[1]*of->at[1] + n[2]*of->at[2] - n[2]*z;

		if (upright && fabs(n[0]) < 0.3)
			return;
		if (upright)
			corner(pen, (rest - n[1]*y)/n[0], y, z);
		else
			corner(pen, x, (rest - n[0]*x)/n[1], z);
	}
	up(pen);
}

static void surface_data(const struct pen *pen, const struct hawser_surface *of,
                         const struct hawser__box *box)
{
	if (of->kind == HAWSER_SURFACE_PLANE) {
		plane_data(pen, of, box);
		return;
	}
	for (int side = 0; side < (box->low[2] == box->high[2] ? 1 : 2); side++) {
		double z = side ? box->high[2] : box->low[2];
		int circle = of->kind == HAWSER_SURFACE_CIRCLE;

		for (int i = 0; i <= (circle ? ROUND : 1); i++) {
			double angle = 2.0*acos(-1.0)*i/ROUND;

			if (circle)
				corner(pen, of->at[0] + of->radius*cos(angle),
				       of->at[1] + of->radius*sin(angle), z);
			else
				corner(pen, i ? of->to[0] : of->at[0], i ? of->to[1] : of->at[1], z);
		}
		up(pen);
	}
}

static void contact_data(FILE *script, const struct hawser_net *net,
                         const struct hawser_net_statics *st, const struct hawser__box *box,
                         const struct hawser__eye *eye)
{
	const struct pen pen = {script, NULL, eye};

	fputs("$obstacles << END\n", script);
	for (int i = 0; i < net->surfaces; i++)
		surface_data(&pen, &net->surface[i], box);
	fputs("NaN NaN\nEND\n", script);
	for (int sticks = 0; sticks < 2; sticks++) {
		fprintf(script, "$%s << END\n", sticks ? "stick" : "slip");
		for (int i = 0; i < st->contacts; i++)
			if (st->contact[i].sticks == sticks)
				corner(&pen, st->contact[i].x[0], st->contact[i].x[1], st->contact[i].x[2]);
		fputs("NaN NaN\nEND\n", script);
	}
}

/* All that is drawn, as it is seen; returns the height of the picture that it fills, cm. */
static double see_all(struct hawser__box *seen, const struct hawser_net *net,
                      const struct hawser_net_statics *st, const struct hawser__box *box,
                      const struct hawser__eye *eye)
{
	const struct pen pen = {NULL, seen, eye};
	double wide, tall;

	for (int i = 0; i < st->nodes; i++)
		corner(&pen, st->x[i][0], st->x[i][1], st->x[i][2]);
	for (int i = 0; i < st->points; i++)
		corner(&pen, st->point[i].x[0], st->point[i].x[1], st->point[i].x[2]);
	for (int i = 0; i < net->surfaces; i++)
		surface_data(&pen, &net->surface[i], box);
	wide = seen->high[0] - seen->low[0];
	tall = seen->high[1] - seen->low[1];
	return fmin(fmax((wide > 0.0 ? tall/wide : HEIGHT)*(RIGHT - LEFT)*WIDTH + BOTTOM + TOP +
	                 (net->surfaces ? KEY : 0.0), LEAST), HEIGHT);
}

/* Colours over the tensions; where these are all but equal, over a part of them. */
static void colours(FILE *script, const struct hawser_net_statics *st, double most, double per,
                    double height)
{
	double least = most;

	for (int c = 0; c < st->cables; c++)
		least = fmin(least, st->member[c].T_min);
	if (most - least < EVEN*most)
		fprintf(script, "set cbrange [%.7g:%.7g]\n", (1.0 - EVEN)*most/per, (1.0 + EVEN)*most/per);
	fprintf(script, "set cblabel 'Tension {/:Italic T} (%s)' offset 1, 0\n"
	        "set palette defined (0 '#4575B4', 1 '#91BFDB', 2 '#FEE090', 3 '#FC8D59', 4 '#D73027')\n"
	        "set colorbox user origin 0.88, %.4f size 0.02, %.4f\n", per > 1.0 ? "kN" : "N",
	        ARROWS/height, 1.0 - (ARROWS + KEY)/height);
}

enum hawser_status hawser__plot_net(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st, struct hawser_report *report)
{
	struct hawser__box box, seen = {.any = 0};
	struct hawser__eye eye = eye_of(&box, st);
	double height = see_all(&seen, net, st, &box, &eye), most = 0.0, bottom, top, per;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, WIDTH, height, report);
	FILE *script = picture.script;
	int few = st->nodes <= FEW, joints = 0;

	if (status)
		return status;
	for (int c = 0; c < st->cables; c++)
		most = fmax(most, st->member[c].T_max);
	per = most >= 1e4 ? 1e3 : 1.0;
	cable_data(script, st, &eye, per);
	node_data(script, net, st, &eye, 1);
	node_data(script, net, st, &eye, 0);
	if (net->surfaces)
		contact_data(script, net, st, &box, &eye);
	bottom = BOTTOM/height;
	top = 1.0 - (net->surfaces ? TOP + KEY : TOP)/height;
	hawser__picture_panel(&picture, LEFT, RIGHT, bottom, top);
	fputs("unset border\nunset xtics\nunset ytics\nunset grid\nunset key\n", script);
	colours(script, st, most, per, height);
	hawser__eye_fit(script, &seen, (RIGHT - LEFT)*WIDTH, (top - bottom)*height);
	hawser__eye_axes(script, &eye, &(struct hawser__corner){14.6, 0.8, WIDTH, height});
	if (net->surfaces)
		fprintf(script, "set key at screen 0.84, screen %.4f right center horizontal font ',9'\n",
		        1.0 - 0.5*KEY/height);
	fprintf(script, "plot %s$cables using 1:2:3 with lines lw %g lc palette notitle, "
	        "$supports using 1:2 with points pt 9 ps %g lc rgb 'black' notitle", net->surfaces
	        ? "$obstacles using 1:2 with lines lw 2.5 lc rgb '#999999' title 'obstacles', " : "",
	        few ? 2.0 : 0.8,
	        few ? 1.2 : 0.5);
	if (few)
		fputs(", $joints using 1:2 with points pt 7 ps 0.5 lc rgb 'black' notitle", script);
	/* gnuplot ends by a signal where no label of a list has a place */
	for (int i = 0; i < st->nodes; i++)
		joints += !net->node[i].support;
	if (st->nodes <= NAMED && joints > 0)
		fputs(", $joints using 1:2:3 with labels offset 0.9, 0.6 font ',9' notitle", script);
	if (st->nodes <= NAMED && joints < st->nodes)
		fputs(", $supports using 1:2:3 with labels offset 0.9, 0.6 font ',9' notitle",
		      script);
	if (st->contacts)
		fputs(", $slip using 1:2 with points pt 6 ps 0.45 lc rgb '#1A9850' title 'slip'"
		      ", $stick using 1:2 with points pt 7 ps 0.45 lc rgb '#762A83' title 'stick'", script);
	fputs("\n", script);
	return hawser__picture_finish(&picture, report);
}
