/* cli/backbone/backbone.c - see backbone.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/backbone/backbone.h"
#include "cli/frame/progress.h"
#include "core/report.h"
#include "output/drawing/figure.h"

enum { PARABOLA = 201 };

static enum hawser_status frequencies(struct cli_backbone *backbone, struct hawser_report *report)
{
	int own = backbone->run.points, other = backbone->parabola.frf.points;

	backbone->omega = malloc(((size_t)own + (size_t)other + 1)*sizeof *backbone->omega);
	if (!backbone->omega)
		return hawser__no_memory(report, "frf");
	for (int i = 0; i < own; i++)
		backbone->omega[i] = backbone->run.point[i].omega;
	for (int i = 0; i < other; i++)
		backbone->omega[own + i] = backbone->parabola.frf.point[i].omega;
	return HAWSER_OK;
}

enum hawser_status cli_backbone_trace(struct cli_backbone *backbone, struct cli_frf_result *result,
                                      int mode, struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	const struct hawser_frf *frf = result->frf;
	struct hawser_backbone_options choice = {.mode = 0};
	struct cli_watch watch = {.progress = {.quiet = result->common->quiet}};
	enum hawser_status status;
	double most = 0.0;

	if (mode >= frf->n)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--backbone %d: the model has modes 1 to %d", mode + 1, frf->n);
	for (int i = 0; i < frf->points; i++)
		most = fmax(most, frf->coordinate[(size_t)i*(size_t)frf->n + (size_t)mode]);
	most = most > 0.0 ? 1.2*most : 1e-3;
	result->backbone = backbone;
	backbone->mode = mode;
	choice.mode = mode;
	choice.size = most;
	choice.lo = fmin(result->from, result->to);
	choice.hi = fmax(result->from, result->to);
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	status = hawser_backbone_trace(&backbone->run, &model->rom, &choice, report);
	cli_progress_end(&watch.progress);
	/* if multiple scales cannot be applied (a resonant mode, the exact energy), only the backbone
	 * is shown */
	if (!status && hawser_primary_backbone(&backbone->parabola, &backbone->gamma, &model->rom,
	                                       mode, most, PARABOLA, NULL))
		backbone->gamma = NAN;
	return status ? status : frequencies(backbone, report);
}

void cli_backbone_clear(struct cli_backbone *backbone)
{
	hawser_backbone_clear(&backbone->run);
	hawser_primary_curve_clear(&backbone->parabola);
	free(backbone->omega);
	backbone->omega = NULL;
}

int cli_backbone_overlays(struct cli_overlay *overlay, const struct cli_backbone *backbone)
{
	const struct hawser_frf *parabola = &backbone->parabola.frf;
	int own = backbone->run.points;

	overlay[0] = (struct cli_overlay){"backbone", own, backbone->omega, backbone->run.probe,
	                                  backbone->run.coordinate, 0};
	overlay[1] = (struct cli_overlay){"by multiple scales", parabola->points, backbone->omega + own,
	                                  parabola->probe, parabola->coordinate, 0};
	return parabola->points > 0 ? 2 : 1;
}

const char *cli_backbone_end(enum hawser_backbone_end end)
{
	switch (end) {
	case HAWSER_BACKBONE_SIZE: return "the largest amplitude asked for";
	case HAWSER_BACKBONE_RANGE: return "the end of the range of frequencies";
	case HAWSER_BACKBONE_REST: return "rest, again";
	case HAWSER_BACKBONE_MAX_POINTS: return "the most points";
	case HAWSER_BACKBONE_ENERGY: return "the largest energy";
	case HAWSER_BACKBONE_MEETS: return "a branch point of another curve";
	case HAWSER_BACKBONE_STOPPED: return "an interruption";
	}
	return "";
}

void cli_backbone_comments(struct hawser__table *table, const struct cli_frf_result *result)
{
	const struct cli_backbone *backbone = result->backbone;
	double length = cli_per_length(result->model), w = cli_per_omega(result->model);
	const char *units = cli_unit(result->model, " (rad/s, m)");

	hawser__table_comment(table, "backbone of mode %d: %d points, ends at %s", backbone->mode + 1,
	                      backbone->run.points, cli_backbone_end(backbone->run.end));
	if (isfinite(backbone->gamma))
		hawser__table_comment(table, "by multiple scales: Omega = omega %+.9g a^2%s",
		                      backbone->gamma*w/(length*length), units);
}

enum hawser_status cli_backbone_draw(const char *path, const void *context,
                                     struct hawser_report *report)
{
	const struct cli_frf_result *result = context;
	const struct hawser_backbone *run = &result->backbone->run;
	struct hawser__scale scale = cli_scale(result->model);
	struct hawser__axis energy = cli_backbone_axis("energy", result->model);
	struct hawser__axis frequency = cli_backbone_axis("Omega", result->model);
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 14.0, 9.0, report);

	if (status)
		return status;
	/* tics of frequencies that hardly differ are long */
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.175, 0.95, 0.18, 0.95, .aside = 0.137,
		.x = {&energy, .logarithmic = 1}, .y = {&frequency, .tics = 7, .open = 1}});
	for (int i = 0; i < run->points; i++)
		if (run->point[i].energy > 0.0)
			hawser__figure_put(&figure, hawser__in_unit(run->point[i].energy, HAWSER__J, &scale),
			                   hawser__in_unit(run->point[i].omega, HAWSER__RAD_S, &scale));
	hawser__figure_draw(&figure, NULL, "with lines lt 1");
	return hawser__figure_finish(&figure, report);
}
