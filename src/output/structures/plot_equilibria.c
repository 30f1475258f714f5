/* output/structures/plot_equilibria.c - see plot_equilibria.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "output/structures/plot_equilibria.h"
#include "output/drawing/style.h"

static int kind_of(const struct hawser_net_equilibrium *one)
{
	return one->compressed == 0 ? 0 : one->unstable == 0 ? 1 : 2;
}

static void data(FILE *script, const struct hawser_net *net, const struct hawser_net_equilibria *found,
                 int kind)
{
	fprintf(script, "$kind%d << END\nNaN NaN\n\n", kind);
	for (int i = 0; i < found->count; i++)
		for (int c = 0; c < net->cables && kind_of(&found->list[i]) == kind; c++) {
			const double *a = found->list[i].x[net->cable[c].from];
			const double *b = found->list[i].x[net->cable[c].to];

			fprintf(script, "%.7g %.7g\n%.7g %.7g\n\n", a[0], a[1], b[0], b[1]);
		}
	fputs("END\n", script);
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
	const struct hawser__axis x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	const struct hawser__axis y = hawser__axis_of("{/:Italic y}", "m", 0.0);
	struct hawser__legend legend = {0};
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 9.5, report);
	FILE *script = picture.script;
	int present[3] = {0};

	if (status)
		return status;
	for (int i = 0; i < found->count; i++)
		present[kind_of(&found->list[i])] = 1;
	for (int i = 0; i < 3; i++) {
		data(script, net, found, i);
		if (present[i])
			hawser__legend_add(&legend, kind[i].title, "with lines %s", kind[i].style);
	}
	fputs("$supports << END\nNaN NaN\n", script);
	for (int i = 0; i < net->nodes; i++)
		if (net->node[i].support)
			fprintf(script, "%.7g %.7g\n", net->node[i].x[0], net->node[i].x[1]);
	fputs("END\n", script);
	hawser__picture_panel(&picture, 0.13, 0.96, hawser__legend_cm(&legend, 16.0)/9.5, 0.96);
	hawser__picture_ylabel(&picture, "%s", y.title);
	fprintf(script, "set size ratio -1\nunset key\nset xlabel '%s'\n"
	        "set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\nplot ", x.title);
	for (int i = 2; i >= 0; i--)
		fprintf(script, "$kind%d using ($1/%.9g):($2/%.9g) with linespoints pt 7 ps 0.4 %s, ", i, x.per,
		        y.per, kind[i].style);
	fprintf(script, "$supports using ($1/%.9g):($2/%.9g) with points pt 9 ps 1.2 lc rgb 'black'\n",
	        x.per, y.per);
	hawser__legend_draw(&picture, &legend);
	return hawser__picture_finish(&picture, report);
}
