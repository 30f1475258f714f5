/* output/structures/plot_equilibria.c - see plot_equilibria.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "output/structures/plot_equilibria.h"
#include "output/drawing/figure.h"

static int kind_of(const struct hawser_net_equilibrium *one)
{
	return one->compressed == 0 ? 0 : one->unstable == 0 ? 1 : 2;
}

static void put_cables(struct hawser__figure *figure, const struct hawser_net *net,
                       const struct hawser_net_equilibrium *one)
{
	for (int c = 0; c < net->cables; c++) {
		const double *a = one->x[net->cable[c].from], *b = one->x[net->cable[c].to];

		hawser__figure_put(figure, a[0], a[1]);
		hawser__figure_put(figure, b[0], b[1]);
		hawser__figure_gap(figure);
	}
}

enum hawser_status hawser__plot_equilibria(const char *path, const struct hawser_net *net,
                                           const struct hawser_net_equilibria *found,
                                           struct hawser_report *report)
{
	static const struct {
		const char *title, *style;
	} kind[] = {{"without compression, as cables", "lw 3 lc rgb '#4575B4'"},
	            {"compressed, stable", "lw 1.5 lc rgb '#D73027'"},
	            {"compressed, unstable", "lw 0.8 lc rgb '#FC8D59' " HAWSER__UNSTABLE_DASH}};
	const double width = 16.0, height = 9.5; /* cm */
	const struct hawser__axis x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	const struct hawser__axis y = hawser__axis_of("{/:Italic y}", "m", 0.0);
	struct hawser__panel_frame at = {0.13, 0.96, HAWSER__LEGEND_CM/height, 0.96, .x = {&x, .tics = 8},
	                                 .y = {&y, .tics = 6}};
	struct hawser__box box = {.any = 0};
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, width, height, report);

	if (status)
		return status;
	for (int i = 0; i < found->count; i++)
		for (int n = 0; n < net->nodes; n++)
			hawser__box_add(&box, found->list[i].x[n], 2);
	for (int n = 0; n < net->nodes; n++)
		hawser__box_add(&box, net->node[n].x, net->node[n].support ? 2 : 0);
	hawser__panel_even(&at, box.low, box.high, (at.right - at.left)*width,
	                   (at.top - at.bottom)*height, 0);
	hawser__figure_panel(&figure, &at);
	for (int k = 2; k >= 0; k--) {
		for (int i = 0; i < found->count; i++)
			if (kind_of(&found->list[i]) == k)
				put_cables(&figure, net, &found->list[i]);
		hawser__figure_draw(&figure, NULL, "with linespoints pt 7 ps 0.4 %s", kind[k].style);
		hawser__figure_again(&figure, kind[k].title, "using (NaN):1 with lines %s", kind[k].style);
	}
	for (int i = 0; i < net->nodes; i++)
		if (net->node[i].support)
			hawser__figure_put(&figure, net->node[i].x[0], net->node[i].x[1]);
	hawser__figure_draw(&figure, "supports", "with points pt 9 ps 1.2 lc rgb 'black'");
	return hawser__figure_finish(&figure, report);
}
