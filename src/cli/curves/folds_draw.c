/* cli/curves/folds_draw.c - the curves in the picture of `folds`: in the upper panel all fold curves in
 * the plane of frequency and load; in the lower one the response at the nominal load and the
 * detached curves, for the displacement (for a model without probes, the coordinate) that is
 * largest.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/folds_result.h"
#include "cli/frame/view.h"
#include "core/report.h"

enum { label_size = 160 };

struct picture {
	struct hawser__folds_picture folds;
	struct hawser__axis x, y;
	double per_omega, per_length; /* shown units per unit of the model */
	struct hawser__folds_line *line;   /* fold curves, then responses */
	struct hawser__folds_mark *mark;
	double *store;
	int *unstable;
	char label[label_size];
	int stride, source; /* the drawn column of a row of probes or of coordinates */
};

static const double *rows(const struct hawser_frf *frf)
{
	return frf->probes > 0 ? frf->probe : frf->coordinate;
}

static void choose(struct picture *picture, const struct cli_folds_result *result)
{
	const struct hawser_frf *frf = &result->folds->response;
	char m[HAWSER__MARKUP_SIZE + 4];
	int k, i;
	double most = -1.0;

	snprintf(m, sizeof m, "%s%s%s", *picture->y.unit ? " (" : "", picture->y.unit,
	         *picture->y.unit ? ")" : "");
	picture->stride = frf->probes > 0 ? 3*frf->probes : frf->n;
	for (k = 0; k < picture->stride; k++)
		for (i = 0; i < frf->points; i++)
			if (rows(frf)[(size_t)i*(size_t)picture->stride + (size_t)k] > most) {
				most = rows(frf)[(size_t)i*(size_t)picture->stride + (size_t)k];
				picture->source = k;
			}
	if (frf->probes > 0)
		cli_probe_label(picture->label, sizeof picture->label, "xyz"[picture->source%3],
		                result->model->rom.shapes.name[picture->source/3], m);
	else
		snprintf(picture->label, sizeof picture->label, "Amplitude of {/:Italic u}_{%d}%s",
		         picture->source + 1, m);
}

static size_t response_points(const struct hawser_folds *folds)
{
	size_t count = (size_t)folds->response.points;
	int i;

	for (i = 0; i < folds->isolas; i++)
		count += (size_t)folds->isola[i].points;
	return count;
}

static int allocate(struct picture *picture, const struct hawser_folds *folds)
{
	size_t points = response_points(folds), lines = (size_t)folds->curves + 1 +
	                                                (size_t)folds->isolas;

	picture->line = calloc(lines, sizeof *picture->line);
	picture->mark = calloc((size_t)folds->events + 1, sizeof *picture->mark);
	picture->store = calloc(2*(points + (size_t)folds->points) + 1, sizeof *picture->store);
	picture->unstable = calloc(points + 1, sizeof *picture->unstable);
	return picture->line && picture->mark && picture->store && picture->unstable;
}

static double *copy_curves(struct picture *picture, const struct cli_folds_result *result)
{
	const struct hawser_folds *folds = result->folds;
	double per_omega = picture->per_omega, *out = picture->store;
	int c, i, e;

	for (c = 0; c < folds->curves; c++) {
		const struct hawser_folds_curve *curve = &folds->curve[c];

		picture->line[c] = (struct hawser__folds_line){.points = curve->points, .x = out,
		                                               .y = out + curve->points};
		for (i = 0; i < curve->points; i++) {
			out[i] = folds->point[curve->first + i].omega*per_omega;
			out[curve->points + i] = folds->point[curve->first + i].load;
		}
		out += 2*curve->points;
	}
	for (e = 0; e < folds->events; e++)
		picture->mark[e] = (struct hawser__folds_mark){folds->event[e].kind,
			folds->event[e].omega*per_omega, folds->event[e].load};
	return out;
}

static void copy_responses(struct picture *picture, const struct cli_folds_result *result,
                           double *out)
{
	const struct hawser_folds *folds = result->folds;
	int k, i, *unstable = picture->unstable;

	for (k = -1; k < folds->isolas; k++) {
		const struct hawser_frf *frf = k < 0 ? &folds->response : &folds->isola[k];

		picture->line[folds->curves + 1 + k] = (struct hawser__folds_line){
			.points = frf->points, .x = out, .y = out + frf->points, .unstable = unstable};
		for (i = 0; i < frf->points; i++) {
			out[i] = frf->point[i].omega*picture->per_omega;
			out[frf->points + i] =
				rows(frf)[(size_t)i*(size_t)picture->stride + (size_t)picture->source]*
				picture->per_length;
			unstable[i] = frf->point[i].unstable > 0;
		}
		out += 2*frf->points;
		unstable += frf->points;
	}
}

enum hawser_status cli_folds_draw(const char *path, const void *context,
                                  struct hawser_report *report)
{
	const struct cli_folds_result *result = context;
	const struct hawser_folds *folds = result->folds;
	struct picture picture = {.line = NULL};
	enum hawser_status status;

	picture.x = cli_frf_axis(result->model);
	picture.y = cli_model_axis(result->model, "", "m");
	picture.per_omega = cli_per_omega(result->model)/picture.x.per;
	picture.per_length = cli_per_length(result->model)/picture.y.per;
	choose(&picture, result);
	if (!allocate(&picture, folds)) {
		status = hawser__no_memory(report, "picture");
		goto done;
	}
	copy_responses(&picture, result, copy_curves(&picture, result));
	picture.folds = (struct hawser__folds_picture){
		.curves = folds->curves, .responses = folds->isolas + 1, .marks = folds->events,
		.x_title = picture.x.title, .curve = picture.line,
		.response = picture.line + folds->curves, .mark = picture.mark,
		.label = picture.label,
		.from = fmin(result->from, result->to)*picture.per_omega,
		.to = fmax(result->from, result->to)*picture.per_omega,
		.load_to = result->load_to,
	};
	status = hawser__plot_folds(path, &picture.folds, report);
done:
	free(picture.line);
	free(picture.mark);
	free(picture.store);
	free(picture.unstable);
	return status;
}
