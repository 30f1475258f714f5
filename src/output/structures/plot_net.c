/* output/structures/plot_net.c - see structures.h. A plane net is seen from the front.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/drawing/labels.h"
#include "output/structures/structures.h"

#define WIDTH 16.0 /* cm */
#define HEIGHT 9.5 /* cm, at most */
#define LEAST 6.0  /* cm: height that the colours and the axes need */
#define LEFT 0.04  /* of the width */
#define RIGHT 0.86 /* of the width: colours and their title are beside */
#define BOTTOM 0.5 /* cm below the net */
#define TOP 0.4    /* cm above it */
#define KEY 0.6    /* cm more below it: the legend, where there are obstacles */
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

static void draw_cables(struct hawser__figure *figure, const struct hawser_net_statics *st,
                        const struct hawser__eye *eye, double per)
{
	for (int i = 0; i < st->points; i++) {
		const struct hawser_net_point *point = &st->point[i];
		double row[3];

		if (i > 0 && point->cable != st->point[i - 1].cable)
			hawser__figure_gap(figure);
		hawser__eye_see(row, eye, point->x);
		row[2] = point->T/per;
		hawser__figure_row(figure, "xy.", row);
	}
	hawser__figure_draw(figure, NULL, "using 1:2:3 with lines lw %g lc palette", st->nodes <= FEW
	                    ? 2.0 : 0.8);
}

/* Supports or joints, with their names if there are not many. */
static void draw_nodes(struct hawser__figure *figure, const struct hawser_net *net,
                       const struct hawser_net_statics *st, const struct hawser__eye *eye, int support)
{
	for (int i = 0; i < st->nodes; i++)
		if (net->node[i].support == support && (support || st->nodes <= FEW))
			hawser__figure_see(figure, eye, st->x[i]);
	if (support)
		hawser__figure_draw(figure, NULL, "with points pt 9 ps %g lc rgb 'black'",
		                    st->nodes <= FEW ? 1.2 : 0.5);
	else
		hawser__figure_draw(figure, NULL, "with points pt 7 ps 0.5 lc rgb 'black'");
	for (int i = 0; i < st->nodes && st->nodes <= NAMED; i++) {
		double to[2];

		if (net->node[i].support != support)
			continue;
		hawser__eye_see(to, eye, st->x[i]);
		hawser__figure_name(figure, to[0], to[1], "center offset 0.9, 0.6 font ',9'",
		                    net->node[i].name);
	}
}

static void draw_contacts(struct hawser__figure *figure, const struct hawser_net_statics *st,
                          const struct hawser__eye *eye, int sticks)
{
	for (int i = 0; i < st->contacts; i++)
		if (st->contact[i].sticks == sticks)
			hawser__figure_see(figure, eye, st->contact[i].x);
	hawser__figure_draw(figure, sticks ? "stick" : "slip", sticks
	                    ? "with points pt 7 ps 0.45 lc rgb '#762A83'"
	                    : "with points pt 6 ps 0.45 lc rgb '#1A9850'");
}

/* All that is drawn, as it is seen; returns the height of the picture that it fills, cm. */
static double see_all(struct hawser__box *seen, const struct hawser_net *net,
                      const struct hawser_net_statics *st, const struct hawser__box *box,
                      const struct hawser__eye *eye)
{
	const struct hawser__pen pen = {NULL, NULL, seen, eye, {0.0, 0.0}};
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
	        "set colorbox user origin screen 0.88, screen up(%.4f) size screen 0.02, screen %.4f\n",
	        per > 1.0 ? "kN" : "N",
	        ARROWS/height, 1.0 - (ARROWS + KEY)/height);
}

enum hawser_status hawser__plot_net(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st, struct hawser_report *report)
{
	struct hawser__box box, seen = {.any = 0};
	struct hawser__eye eye = eye_of(&box, st);
	double height = see_all(&seen, net, st, &box, &eye), most = 0.0, per;
	double bottom = (net->surfaces ? BOTTOM + KEY : BOTTOM)/height;
	struct hawser__figure figure = {0};
	const struct hawser__pen pen = {&figure, NULL, NULL, &eye, {0.0, 0.0}};
	enum hawser_status status = hawser__figure_begin(&figure, path, WIDTH, height, report);

	if (status)
		return status;
	for (int c = 0; c < st->cables; c++)
		most = fmax(most, st->member[c].T_max);
	per = most >= 1e4 ? 1e3 : 1.0;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){LEFT, RIGHT, bottom, 1.0 - TOP/height,
		.view = 1, .x = {.from = seen.low[0], .to = seen.high[0]},
		.y = {.from = seen.low[1], .to = seen.high[1]}});
	colours(figure.out.script, st, most, per, height);
	hawser__eye_axes(figure.out.script, &eye, &(struct hawser__corner){14.6, 0.8, WIDTH, height});
	for (int i = 0; i < net->surfaces; i++)
		hawser__pen_surface(&pen, &net->surface[i], &box);
	hawser__figure_draw(&figure, "obstacles", "with lines lw 2.5 lc rgb '#999999'");
	draw_cables(&figure, st, &eye, per);
	for (int support = 1; support >= 0; support--)
		draw_nodes(&figure, net, st, &eye, support);
	for (int sticks = 0; sticks < 2; sticks++)
		draw_contacts(&figure, st, &eye, sticks);
	return hawser__figure_finish(&figure, report);
}
