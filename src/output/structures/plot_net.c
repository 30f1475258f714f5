/* output/structures/plot_net.c - see plot_net.h. A plane net is seen from the front.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/drawing/outline.h"
#include "output/drawing/perspective.h"
#include "output/structures/plot_net.h"
#include "output/drawing/style.h"

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

static void contact_data(FILE *script, const struct hawser_net *net,
                         const struct hawser_net_statics *st, const struct hawser__box *box,
                         const struct hawser__eye *eye)
{
	const struct hawser__pen pen = {script, NULL, eye, {0.0, 0.0}};

	fputs("$obstacles << END\n", script);
	for (int i = 0; i < net->surfaces; i++)
		hawser__pen_surface(&pen, &net->surface[i], box);
	fputs("NaN NaN\nEND\n", script);
	for (int sticks = 0; sticks < 2; sticks++) {
		fprintf(script, "$%s << END\n", sticks ? "stick" : "slip");
		for (int i = 0; i < st->contacts; i++)
			if (st->contact[i].sticks == sticks)
				hawser__pen_put(&pen, st->contact[i].x);
		fputs("NaN NaN\nEND\n", script);
	}
}

/* All that is drawn, as it is seen; returns the height of the picture that it fills, cm. */
static double see_all(struct hawser__box *seen, const struct hawser_net *net,
                      const struct hawser_net_statics *st, const struct hawser__box *box,
                      const struct hawser__eye *eye)
{
	const struct hawser__pen pen = {NULL, seen, eye, {0.0, 0.0}};
	double wide, tall;

	for (int i = 0; i < st->nodes; i++)
		hawser__pen_put(&pen, st->x[i]);
	for (int i = 0; i < st->points; i++)
		hawser__pen_put(&pen, st->point[i].x);
	for (int i = 0; i < net->surfaces; i++)
		hawser__pen_surface(&pen, &net->surface[i], box);
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
