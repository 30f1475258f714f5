/* cli/model/certificate.c - folds and peaks of a response corrected in the structure itself: see
 * certificate.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/frame/view.h"
#include "cli/model/certificate.h"
#include "cli/model/made.h"

static const double bearable = 10.0; /* s of processor time that nobody asked for; chosen */
static const double large = 0.05; /* error beyond which starts are too far; chosen */

static enum hawser_status certify_span(struct cli_certificate *certificate,
                                       const struct cli_frf_result *result, int asked,
                                       struct hawser_report *report)
{
	static const struct hawser_modes none; /* of modes that were chosen, or of exact energy */
	const struct cli_model *model = result->model;
	enum hawser_status status =
		hawser_span_certify(&certificate->own, &model->scene, model->automatic ? &none : &model->modes,
		                    certificate->rom, result->frf, result->peak, result->peaks,
		                    asked ? 0.0 : bearable, report);

	for (int k = 0; k < certificate->own.count; k++)
		certificate->cable[k] = "A-B";
	return status;
}

/* What a mesh does not have is a warning: the response is there. */
static enum hawser_status soften(enum hawser_status status, const struct cli_frf_result *result,
                                 int asked, const struct hawser_report *report)
{
	char text[CLI_WARNING_SIZE];

	if (status != HAWSER_ERR_SCENE && status != HAWSER_ERR_ARGUMENT)
		return status;
	snprintf(text, sizeof text, "folds and peaks are not corrected in a mesh: %.400s",
	         report->message);
	if (result->frf->branch <= 1 && asked)
		cli_warn(text);
	return HAWSER_OK;
}

/* Unless asked for, of models of modes whose error is not large, or not known because of attachments:
 * a model with exact energy has its own comparison, and one of modes that was compared with it was
 * compared as a whole curve. */
static int of_span(const struct cli_frf_result *result, int asked)
{
	const struct cli_model *model = result->model;
	double estimate = result->error.fixed.estimated;

	if (!model->has_scene || asked)
		return model->has_scene;
	return !model->automatic && !(result->error.compared && model->exact.functions) &&
	       (isfinite(estimate) ? estimate < large : model->scene.attachments > 0 &&
	        model->scene.model.condense == HAWSER_CONDENSE_STATIC);
}

/* Whether a fold was not found. The largest peaks tell by themselves that they were. */
static int lacks_fold(const struct hawser_certificate *of)
{
	int lacks = 0;

	for (int k = 0; k < of->count; k++)
		lacks |= of->item[k].kind == HAWSER_LANDMARK_FOLD && isnan(of->item[k].exact_omega);
	return lacks;
}

/* Of further branches, which result->certificate has only if the first one has no landmarks. */
enum hawser_status cli_certify(struct cli_frf_result *result, struct hawser_report *report)
{
	const struct cli_made *made = result->model->made;
	struct cli_certificate *shown = result->certificate, own;
	struct cli_model_error *error = &result->error;
	int asked = shown && strcmp(shown->how, "yes") == 0;
	double known;
	enum hawser_status status;

	if (!shown || !result->located || strcmp(shown->how, "no") == 0 ||
	    !(made ? made->by->certify != NULL : of_span(result, asked)) || cli_interrupted())
		return HAWSER_OK;
	own = *shown;
	own.rom = &result->model->rom;
	status = made ? made->by->certify(&own, result, asked ? 0.0 : bearable, report)
	              : certify_span(&own, result, asked, report);
	if (status)
		return soften(status, result, asked, report);
	if (result->common->reproducible)
		own.own.seconds = NAN;
	if (result->frf->branch <= 1 || shown->own.count == 0)
		*shown = own;
	if (!isfinite(own.own.distance) &&
	    !(own.own.refused > 0 && !isfinite(error->fixed.estimated)))
		return HAWSER_OK;
	error->corrected = 1;
	error->before = error->compared ? NAN : error->fixed.estimated;
	error->compared = 0;
	known = error->fixed.estimated;
	error->fixed.estimated = fmin(own.own.error, 1.0);
	error->fixed.largest = own.own.largest;
	if (own.own.refused > 0) { /* of which nothing is known but that they are far away */
		error->fixed.estimated = isfinite(known) ? fmax(known, error->fixed.estimated) : 1.0;
		if (lacks_fold(&own.own))
			error->fixed.largest = 0.0;
	}
	return HAWSER_OK;
}

/* --- what is shown --- */

static const char *kind_name(int kind)
{
	return kind == HAWSER_LANDMARK_FOLD ? "fold" : "peak";
}

static const char *component_of(const struct hawser_certified *item)
{
	static const char *const name[] = {"x", "y", "z"};

	return item->kind == HAWSER_LANDMARK_FOLD ? NULL : name[item->axis];
}

/* "peak of y of J" */
static const char *called(char *text, size_t size, const struct cli_certificate *of, int k)
{
	const struct hawser_certified *item = &of->own.item[k];

	if (item->kind == HAWSER_LANDMARK_FOLD)
		snprintf(text, size, "fold");
	else
		snprintf(text, size, "peak of %s, %s", component_of(item), of->rom->shapes.name[item->probe]);
	return text;
}

void cli_certificate_comments(struct hawser__table *table, const struct cli_frf_result *result)
{
	const struct cli_certificate *of = result->certificate;
	double per_omega = cli_per_omega(result->model), per_length = cli_per_length(result->model);
	char text[80], size[80];

	if (of && of->own.count == 0 && of->own.foreseen > bearable)
		hawser__table_comment(table, "folds and peaks are not corrected in the mesh, which would take "
		                      "about %.0f s: --certificate yes", of->own.foreseen);
	if (!of || of->own.count == 0)
		return;
	if (of->own.refused == of->own.count)
		hawser__table_comment(table, "the mesh (%d unknowns, %d harmonics) has none of %d folds and "
		                      "peaks near those of the model", of->own.unknowns, of->own.order,
		                      of->own.count);
	else
		hawser__table_comment(table, "corrected in the mesh (%d unknowns, %d harmonics) and one of "
		                      "half as many: %d of %d folds and peaks, off by up to %.1e; more "
		                      "harmonics move them by up to %.1e, shorter elements by %.1e",
		                      of->own.unknowns, of->own.order, of->own.count - of->own.refused,
		                      of->own.count + of->own.omitted, of->own.distance, of->own.harmonics,
		                      of->own.lengths);
	for (int k = 0; k < of->own.count; k++) {
		const struct hawser_certified *item = &of->own.item[k];

		*size = '\0';
		if (item->kind == HAWSER_LANDMARK_PEAK)
			snprintf(size, sizeof size, ", amplitude %.9g m", item->exact_size*per_length);
		if (isfinite(item->distance))
			hawser__table_comment(table, "mesh: %s at Omega = %.12g rad/s%s, off by %.1e; least "
			                      "tension %.6g N, in cable %s", called(text, sizeof text, of, k),
			                      item->exact_omega*per_omega, size, item->distance, item->tension,
			                      of->cable[k]);
		else
			hawser__table_comment(table, "mesh: no %s near Omega = %.12g rad/s was found",
			                      called(text, sizeof text, of, k), item->omega*per_omega);
	}
}

struct row {
	struct hawser_certified of;
	const char *probe, *component, *cable;
};

static const void *row_of(void *to, const void *parent, size_t k)
{
	const struct cli_certificate *certificate = parent;
	const struct hawser_certified *item = &certificate->own.item[k];
	struct row *row = to;

	*row = (struct row){.of = *item, .component = component_of(item), .cable = certificate->cable[k],
		.probe = item->probe < 0 ? NULL : certificate->rom->shapes.name[item->probe]};
	if (item->kind == HAWSER_LANDMARK_FOLD)
		row->of.size = row->of.exact_size = NAN;
	return row;
}

#define OF(member) HAWSER__AT(struct row, member)
static const struct hawser__field item_field[] = {
	{"kind", NULL, "fold or peak", HAWSER__LABEL_AT(struct row, of.kind, kind_name)},
	{"probe", NULL, "of a peak: where", OF(probe), .flags = HAWSER__OMIT},
	{"component", NULL, "of a peak: x, y or z", OF(component), .flags = HAWSER__OMIT},
	{"Omega", NULL, "where the model has it", OF(of.omega), .unit = HAWSER__RAD_S},
	{"Omega_mesh", NULL, "where the mesh has it; null: not found", OF(of.exact_omega),
	 .unit = HAWSER__RAD_S, .flags = HAWSER__NULL},
	{"size", NULL, "of a peak: amplitude of the model", OF(of.size), .unit = HAWSER__M,
	 .flags = HAWSER__OMIT},
	{"size_mesh", NULL, "and of the mesh", OF(of.exact_size), .unit = HAWSER__M,
	 .flags = HAWSER__OMIT},
	{"distance", NULL, "relative difference, the larger one", OF(of.distance), .flags = HAWSER__NULL},
	{"T_min", NULL, "least tension in that motion, of all elements", OF(of.tension),
	 .unit = HAWSER__NEWTON, .flags = HAWSER__NULL},
	{"cable", NULL, "where", OF(cable), .flags = HAWSER__NULL},
	HAWSER__END,
};
#undef OF
static const struct hawser__list item_list =
	HAWSER__MADE_ROWS(struct row, item_field, struct cli_certificate, own.count, row_of);

#define OF(member) HAWSER__AT(struct cli_certificate, member)
const struct hawser__field cli_certificate_field[] = {
	{"distance", NULL, "largest relative difference of model and mesh", OF(own.distance),
	 .flags = HAWSER__NULL},
	{"harmonics", NULL, "change by four more harmonics, relative, where it is largest",
	 OF(own.harmonics)},
	{"refused", NULL, "folds and peaks that were not found near those of the model", OF(own.refused)},
	{"omitted", NULL, "smaller ones that were not looked for", OF(own.omitted)},
	{"unknowns", NULL, "of the mesh", OF(own.unknowns)},
	{"order", NULL, "harmonics", OF(own.order)},
	{"lengths", NULL, "error by the length of elements that is left, relative, estimated",
	 OF(own.lengths)},
	{"seconds", NULL, "wall time (s)", OF(own.seconds), .flags = HAWSER__OMIT},
	{"landmarks", NULL, "folds and peaks", HAWSER__OBJECTS_OF(item_list)},
	HAWSER__END,
};
#undef OF
