/* cli/map/hill_draw.c - the picture of boundaries, over characteristic values and expansions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "cli/model/axis.h"
#include "cli/map/hill_result.h"
#include "core/report.h"

enum { SAMPLES = 200, OVER = 4*CLI_HILL_ORDERS };

/* The smallest order of a boundary. */
static int first_order(const struct hawser_hill_chart *chart)
{
	int first = chart->boundaries ? chart->boundary[0].order : 0;

	for (int b = 1; b < chart->boundaries; b++)
		first = chart->boundary[b].order < first ? chart->boundary[b].order : first;
	return first;
}

/* Characteristic values (kind -1) and expansions (-2), [SAMPLES][2] each. */
static int compared(struct hawser__hill_boundary *line, double *at,
                    const struct cli_hill_result *result)
{
	int count = 0, first = first_order(&result->chart);

	for (int r = first; r < first + CLI_HILL_ORDERS; r++)
		for (int which = 0; which < 4; which++) {
			double *own = at + (size_t)count*SAMPLES*2, low = result->axis[1].from;
			int odd = which%2, expansion = which/2, k = 0;

			if ((odd && !r) || (expansion && r > 4))
				continue;
			for (int i = 0; i < SAMPLES; i++) {
				double e = low + (result->axis[1].to - low)*i/(SAMPLES - 1), value;

				if (expansion)
					value = hawser_mathieu_expansion(r, odd, e, 0);
				else if (hawser_mathieu_value(&value, r, odd, e, NULL))
					continue;
				own[2*k] = value;
				own[2*k++ + 1] = e;
			}
			line[count++] = (struct hawser__hill_boundary){expansion ? -2 : -1, k, own};
		}
	return count;
}

/* Of Mathieu's equation. */
static const struct hawser__axis mathieu[2] = {{"{/:Italic δ}", "", 1.0}, {"{/:Italic ε}", "", 1.0}};

enum hawser_status cli_hill_draw(const char *path, const void *context,
                                 struct hawser_report *report)
{
	const struct cli_hill_result *result = context;
	const struct hawser_hill_chart *chart = &result->chart;
	struct hawser__hill_boundary *line = calloc((size_t)chart->boundaries + OVER, sizeof *line);
	double *at = malloc((size_t)OVER*SAMPLES*2*sizeof *at);
	double *box = NULL;
	struct hawser__hill_picture picture = {.line = line};
	enum hawser_status status;

	if (!line || !at) {
		free(line);
		free(at);
		return hawser__no_memory(report, "hill");
	}
	for (int b = 0; b < chart->boundaries; b++)
		line[picture.lines++] = (struct hawser__hill_boundary){(int)chart->boundary[b].kind,
			chart->boundary[b].points, chart->boundary[b].at};
	if (!result->model)
		picture.lines += compared(line + picture.lines, at, result);
	for (int k = 0; k < 2; k++) {
		const char *key = result->axis[k].key;

		picture.axis[k] = result->model
		                  ? cli_axis(key, result->axis[k].unit, result->axis[k].to)
		                  : mathieu[k];
		picture.from[k] = result->axis[k].from;
		picture.to[k] = result->axis[k].to;
	}
	status = cli_hill_unstable(&box, &picture.boxes, result, report);
	picture.box = box;
	if (!status)
		status = hawser__plot_hill(path, &picture, report);
	free(box);
	free(line);
	free(at);
	return status;
}
