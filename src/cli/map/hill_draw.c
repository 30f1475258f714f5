/* cli/map/hill_draw.c - the picture of boundaries, over characteristic values and expansions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "cli/model/axis.h"
#include "cli/map/hill_result.h"
#include "output/drawing/figure.h"

enum { SAMPLES = 200 };

/* The smallest order of a boundary. */
static int first_order(const struct hawser_hill_chart *chart)
{
	int first = chart->boundaries ? chart->boundary[0].order : 0;

	for (int b = 1; b < chart->boundaries; b++)
		first = chart->boundary[b].order < first ? chart->boundary[b].order : first;
	return first;
}

/* Characteristic values of Mathieu's equation, or their expansions. */
static void compared(struct hawser__figure *figure, const struct cli_hill_result *result, int expansion)
{
	double low = result->axis[1].from, step = (result->axis[1].to - low)/(SAMPLES - 1), value;
	int first = first_order(&result->chart);

	for (int r = first; r < first + CLI_HILL_ORDERS; r++)
		for (int odd = 0; odd < 2; odd++) {
			if ((odd && !r) || (expansion && r > 4))
				continue;
			for (int i = 0; i < SAMPLES; i++)
				if (expansion)
					hawser__figure_put(figure, hawser_mathieu_expansion(r, odd, low + step*i, 0),
					                   low + step*i);
				else if (!hawser_mathieu_value(&value, r, odd, low + step*i, NULL))
					hawser__figure_put(figure, value, low + step*i);
			hawser__figure_gap(figure);
		}
	if (expansion)
		hawser__figure_draw(figure, "expansion to second order",
		                    "with lines lc rgb '#707070' lw 0.8 dt (10,6)");
	else
		hawser__figure_draw(figure, "characteristic values",
		                    "with lines lc rgb 'black' lw 0.8 dt (3,7)");
}

static void boundaries(struct hawser__figure *figure, const struct hawser_hill_chart *chart)
{
	static const struct {
		enum hawser_hill_kind kind;
		const char *title;
	} shown[] = {{HAWSER_HILL_PLUS, "multiplier +1"}, {HAWSER_HILL_MINUS, "multiplier −1"},
	             {HAWSER_HILL_TORUS, "complex pair"}};

	for (int k = 0; k < 3; k++) {
		for (int b = 0; b < chart->boundaries; b++) {
			const struct hawser_hill_boundary *line = &chart->boundary[b];

			for (int i = 0; line->kind == shown[k].kind && i < line->points; i++)
				hawser__figure_put(figure, line->at[2*i], line->at[2*i + 1]);
			hawser__figure_gap(figure);
		}
		hawser__figure_draw(figure, shown[k].title, "with lines lt %d", k + 1);
	}
}

/* Of Mathieu's equation. */
static const struct hawser__axis mathieu[2] = {{"{/:Italic δ}", "", 1.0}, {"{/:Italic ε}", "", 1.0}};

enum hawser_status cli_hill_draw(const char *path, const void *context,
                                 struct hawser_report *report)
{
	static const char silent[] = "#b4b4b4"; /* as of maps, plot_map.c */
	static const char sample[] = "with boxes fs solid border lc rgb '#808080' fc rgb '%s'";
	const struct cli_hill_result *result = context;
	struct hawser__figure figure = {0};
	struct hawser__axis axis[2];
	struct cli_hill_boxes boxes[2];
	enum hawser_status status = cli_hill_unstable(boxes, result, report);

	if (!status)
		status = hawser__figure_begin(&figure, path, 17.0, 12.8, report);
	if (status)
		goto done;
	for (int k = 0; k < 2; k++)
		axis[k] = result->model ? cli_axis(result->axis[k].key, result->axis[k].unit,
		                                   result->axis[k].to)
		                        : mathieu[k];
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.965, 0.28, 0.97,
		.x = {&axis[0], result->axis[0].from, result->axis[0].to, .tics = 10},
		.y = {&axis[1], result->axis[1].from, result->axis[1].to, .tics = 8}});
	hawser__legend_add(&figure.legend, boxes[0].count ? "unstable" : "no instability found", sample,
	                   boxes[0].count ? HAWSER__UNSTABLE_FILL : "#ffffff");
	if (boxes[1].count)
		hawser__legend_add(&figure.legend, "no response found", sample, silent);
	for (int of = 0; of < 2; of++) {
		for (int k = 0; k < boxes[of].count; k++)
			hawser__figure_row(&figure, "xyxy", boxes[of].box + 4*k);
		hawser__figure_draw(&figure, NULL,
		                    "using 1:2:1:3:2:4 with boxxyerror fs solid noborder lc rgb '%s'",
		                    of ? silent : HAWSER__UNSTABLE_FILL);
	}
	boundaries(&figure, &result->chart);
	for (int expansion = 0; expansion < 2 && !result->model; expansion++)
		compared(&figure, result, expansion);
	status = hawser__figure_finish(&figure, report);
done:
	free(boxes[0].box);
	free(boxes[1].box);
	return status;
}
