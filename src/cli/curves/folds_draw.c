/* cli/curves/folds_draw.c - the picture of `folds`: in the upper panel all fold curves in the plane of
 * frequency and load, with their special points and a line at the load of the model; in the lower one
 * the response at that load and the curves detached from it, by the probe, or coordinate, that
 * moves most. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/curves/folds_result.h"
#include "cli/frame/view.h"
#include "output/drawing/figure.h"

/* The drawn column of a row of probes or of coordinates. */
struct column {
	int stride, source;
	struct hawser__axis axis;
	double per_omega, per_length; /* in the unit of the axes' values, per unit of the model */
};

static const double *rows(const struct hawser_frf *frf)
{
	return frf->probes > 0 ? frf->probe : frf->coordinate;
}

static void choose(struct column *column, const struct cli_folds_result *result)
{
	const struct hawser_frf *frf = &result->folds->response;
	char unit[HAWSER__MARKUP_SIZE + 4];
	double most = -1.0;

	column->axis = cli_model_axis(result->model, "", "m");
	snprintf(unit, sizeof unit, "%s%s%s", *column->axis.unit ? " (" : "", column->axis.unit,
	         *column->axis.unit ? ")" : "");
	column->stride = frf->probes > 0 ? 3*frf->probes : frf->n;
	for (int k = 0; k < column->stride; k++)
		for (int i = 0; i < frf->points; i++)
			if (rows(frf)[(size_t)i*(size_t)column->stride + (size_t)k] > most) {
				most = rows(frf)[(size_t)i*(size_t)column->stride + (size_t)k];
				column->source = k;
			}
	if (frf->probes > 0)
		cli_probe_label(column->axis.title, sizeof column->axis.title, "xyz"[column->source%3],
		                result->model->rom.shapes.name[column->source/3], unit);
	else
		snprintf(column->axis.title, sizeof column->axis.title, "Amplitude of {/:Italic u}_{%d}%.*s",
		         column->source + 1, (int)sizeof unit, unit);
}

static void draw_plane(struct hawser__figure *figure, const struct hawser_folds *folds,
                       double per_omega)
{
	/* the legend's names of the special points */
	static const struct {
		const char *style, *title;
	} mark[] = {
		[HAWSER_FOLDS_NOMINAL] = {"pt 7 ps 0.5 lc rgb '#404040'", "folds at that load"},
		[HAWSER_FOLDS_CUSP] = {"pt 9 ps 0.9 lc rgb '#D55E00'", "cusp"},
		[HAWSER_FOLDS_ISOLA] = {"pt 7 ps 0.8 lc rgb '#009E73'", "isola centre"},
		[HAWSER_FOLDS_BIFURCATION] = {"pt 13 ps 1 lc rgb '#CC79A7'", "curves join or part"},
	};

	/* linetypes whose colours no mark has, each in every dash: twelve curves differ */
	enum { COLOURS = 4, DASHES = 3 };
	static const int colour[COLOURS] = {1, 5, 6, 8};
	static const char *const dash[DASHES] = {"solid", "(12,5)", "(3,3)"};
	char title[40] = "folds";

	hawser__figure_function(figure, "given load", "1 with lines lc rgb '#404040' lw 0.8 dt (4,4)");
	for (int c = 0; c < folds->curves; c++) {
		for (int i = folds->curve[c].first; i < folds->curve[c].first + folds->curve[c].points; i++)
			hawser__figure_put(figure, folds->point[i].omega*per_omega, folds->point[i].load);
		if (folds->curves > 1)
			snprintf(title, sizeof title, "folds %d", c + 1);
		hawser__figure_draw(figure, c < COLOURS*DASHES ? title : NULL, "with lines lt %d dt %s",
		                    colour[c%COLOURS], dash[c/COLOURS%DASHES]);
	}
	for (int kind = 0; kind < (int)(sizeof mark/sizeof *mark); kind++) {
		for (int e = 0; e < folds->events; e++)
			if ((int)folds->event[e].kind == kind)
				hawser__figure_put(figure, folds->event[e].omega*per_omega, folds->event[e].load);
		hawser__figure_draw(figure, mark[kind].title, "with points %s", mark[kind].style);
	}
}

/* The stable or the unstable parts of a response; each part begins at the end of the previous one. */
static void put_part(struct hawser__figure *figure, const struct hawser_frf *frf,
                     const struct column *column, int unstable)
{
	for (int i = 0; i < frf->points; i++) {
		int mine = (frf->point[i].unstable > 0) == unstable;

		if (mine || (i > 0 && (frf->point[i - 1].unstable > 0) == unstable))
			hawser__figure_put(figure, frf->point[i].omega*column->per_omega, column->per_length*
			                   rows(frf)[(size_t)i*(size_t)column->stride + (size_t)column->source]);
		if (!mine)
			hawser__figure_gap(figure);
	}
}

static void draw_responses(struct hawser__figure *figure, const struct hawser_folds *folds,
                           const struct column *column)
{
	hawser__legend_once(&figure->legend, "stable", "with lines lt 7");
	hawser__legend_once(&figure->legend, "unstable", "with lines lt 7 lw 1 " HAWSER__UNSTABLE_DASH);
	for (int k = -1; k < folds->isolas; k++) {
		const struct hawser_frf *frf = k < 0 ? &folds->response : &folds->isola[k];

		put_part(figure, frf, column, 1);
		hawser__figure_draw(figure, NULL, "with lines lt %d lw 1 " HAWSER__UNSTABLE_DASH, k < 0
		                    ? 7 : 2);
		put_part(figure, frf, column, 0);
		hawser__figure_draw(figure, NULL, "with lines lt %d", k < 0 ? 7 : 2);
	}
	if (folds->isolas > 0)
		hawser__legend_once(&figure->legend, "detached", "with lines lt 2");
}

enum hawser_status cli_folds_draw(const char *path, const void *context,
                                  struct hawser_report *report)
{
	static const struct hawser__axis load = {"Load, as a factor of the given one", "", 1.0};
	const struct cli_folds_result *result = context;
	const struct hawser__axis x = cli_frf_axis(result->model);
	const double height = 16.0, bottom = HAWSER__LEGEND_CM/height, top = 1.0 - 0.4/height;
	const double middle = 0.5*(bottom + top), per = cli_per_omega(result->model);
	struct hawser__panel_axis across = {&x, fmin(result->from, result->to)*per,
	                                    fmax(result->from, result->to)*per, .tics = 10, .bare = 1};
	struct column column = {.per_omega = per, .per_length = cli_per_length(result->model)};
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 17.0, height, report);

	if (status)
		return status;
	choose(&column, result);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.965, middle + 0.25/height, top,
		.x = across, .y = {&load, 0.0, result->load_to, .tics = 8}});
	draw_plane(&figure, result->folds, per);
	across.bare = 0;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.965, bottom,
		middle - 0.25/height,
		.x = across, .y = {&column.axis, .zero = 1, .tics = 6, .open = 1}});
	draw_responses(&figure, result->folds, &column);
	return hawser__figure_finish(&figure, report);
}
