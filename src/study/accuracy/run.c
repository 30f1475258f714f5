/* study/accuracy/run.c - one fidelity on one scene: its model, its response, its landmarks, and
 * their cost. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "hawser/accuracy.h"
#include "rom/terms/drag.h"
#include "study/compare/distance.h"
#include "study/accuracy/landmark.h"
#include "study/accuracy/respond.h"

static const struct hawser__sharpening sharpening = {.wanted = 2e-6};

/* Extremes of the tension over all points of the curve. */
static void find_tension(struct hawser_study_curve *curve)
{
	const struct hawser_frf *frf = &curve->frf;

	for (int i = 0; i < frf->points && frf->tension; i++) {
		curve->least_tension = fmin(curve->least_tension, frf->tension[2*i]);
		curve->tension = fmax(curve->tension, frf->tension[2*i + 1]);
	}
}

/* --- responses --- */

enum hawser_status hawser__study_trace(struct hawser_study_curve *curve,
                                       struct hawser_rom *rom,
                                       const struct hawser_statics *statics,
                                       const struct hawser_scene *scene,
                                       const struct hawser_frf_options *options,
                                       struct hawser_report *report)
{
	enum hawser_status status = hawser_frf_trace(&curve->frf, rom, options, report);

	(void)statics;
	(void)scene;
	return status ? status : hawser_landmarks(&curve->landmark, &curve->landmarks, &curve->frf,
	                                          NULL, report);
}

enum hawser_status hawser__study_balance(struct hawser_study_curve *curve,
                                         struct hawser_rom *rom,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_frf_options *options,
                                         struct hawser_report *report)
{
	struct hawser_frf_options balance = *options;

	balance.method = "balance";
	return hawser__study_trace(curve, rom, statics, scene, &balance, report);
}

/* The scene for which an accuracy is requested, whose `name` is owned by the caller; and this
 * accuracy. */
static struct hawser_scene auto_scene(const struct hawser_scene *scene)
{
	struct hawser_scene changed = *scene;

	changed.model.modes = HAWSER_MODES_AUTO;
	changed.model.condense = HAWSER_CONDENSE_STATIC;
	changed.model.energy = HAWSER_ENERGY_QUARTIC;
	return changed;
}

static double auto_accuracy(const struct hawser_fidelity_choice *choice,
                            const struct hawser_scene *scene)
{
	return choice->number > 0.0 ? choice->number/100.0 : scene->model.accuracy;
}

/* The search for a model of this accuracy, as in hawser__study_auto. *accuracy is filled even if
 * the search is interrupted. *settings becomes the options of the search. Statuses of
 * hawser_accuracy_trace. */
static enum hawser_status study_search(struct hawser_accuracy *accuracy,
                                       struct hawser_accuracy_options *settings,
                                       const struct hawser_fidelity_choice *choice,
                                       const struct hawser_statics *statics,
                                       const struct hawser_scene *scene,
                                       const struct hawser_frf_options *options,
                                       struct hawser_report *report)
{
	struct hawser_scene changed = auto_scene(scene);

	*settings = (struct hawser_accuracy_options){.most = 0};
	settings->accuracy = auto_accuracy(choice, scene);
	settings->frf.from = options->from;
	settings->frf.to = options->to;
	settings->frf.progress = options->progress;
	return hawser_accuracy_trace(accuracy, statics, &changed, settings, report);
}

/* The search computes model and response together; both are moved to the curve. */
enum hawser_status hawser__study_auto(struct hawser_study_curve *curve, struct hawser_rom *rom,
                                      const struct hawser_statics *statics,
                                      const struct hawser_scene *scene,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report)
{
	struct hawser_accuracy *accuracy = calloc(1, sizeof *accuracy);
	struct hawser_accuracy_options settings;
	enum hawser_status status;

	if (!accuracy)
		return hawser__no_memory(report, "study");
	status = study_search(accuracy, &settings, &curve->choice, statics, scene, options,
	                      report);
	if (!status) {
		curve->unreached = !accuracy->reached;
		curve->estimated = accuracy->estimated;
		*rom = accuracy->rom;
		curve->frf = accuracy->frf;
		memset(&accuracy->rom, 0, sizeof accuracy->rom);
		memset(&accuracy->frf, 0, sizeof accuracy->frf);
		status = hawser_landmarks(&curve->landmark, &curve->landmarks, &curve->frf, NULL,
		                          report);
	}
	hawser_accuracy_clear(accuracy);
	free(accuracy);
	return status;
}

static void take_names(struct hawser_study_curve *curve, const struct hawser_rom *rom)
{
	const int most = (int)(sizeof curve->probe/sizeof *curve->probe);

	curve->probes = rom->shapes.points < most ? rom->shapes.points : most;
	for (int p = 0; p < curve->probes; p++)
		snprintf(curve->probe[p], sizeof curve->probe[p], "%s", rom->shapes.name[p]);
}

/* The response of *rom and its landmarks. */
static enum hawser_status respond(struct hawser_study_curve *curve, struct hawser_rom *rom,
                                  const struct hawser_statics *statics,
                                  const struct hawser_scene *scene,
                                  const struct hawser_frf_options *options)
{
	struct hawser_frf_options settled = *options, again;
	double start = hawser__wall_seconds(), busy = hawser__processor_seconds();
	enum hawser_status status;

	hawser_frf_settle(&settled);
	again = settled;
	status = curve->choice.fidelity->respond(curve, rom, statics, scene, &settled, &curve->report);
	curve->n = rom->n;
	curve->quads = rom->quads;
	curve->cubics = rom->cubics;
	take_names(curve, rom);
	curve->respond_seconds = hawser__wall_seconds() - start;
	curve->processor_seconds += hawser__processor_seconds() - busy;
	/* part of the comparison, not of the cost of the response; omitted if the run was interrupted */
	again.method = curve->frf.method;
	if (!status && curve->frf.points > 0 && curve->frf.end != HAWSER_END_INTERRUPTED &&
	    curve->frf.end != HAWSER_END_MAX_POINTS)
		status = hawser__study_sharpen(curve, rom, &again, &sharpening, &curve->report);
	find_tension(curve);
	return status;
}

static void begin(struct hawser_study_curve *curve, const struct hawser_fidelity_choice *choice)
{
	memset(curve, 0, sizeof *curve);
	curve->choice = *choice;
	curve->tension = curve->least_tension = curve->estimated = NAN;
}

static enum hawser_status end(struct hawser_study_curve *curve, enum hawser_status status,
                              struct hawser_report *report)
{
	curve->status = status;
	if (status && report)
		*report = curve->report;
	return status;
}

enum hawser_status hawser_study_run(struct hawser_study_curve *curve,
                                    const struct hawser_statics *statics,
                                    const struct hawser_scene *scene,
                                    const struct hawser_fidelity_choice *choice,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report)
{
	struct hawser_rom rom = {.n = 0};
	double start = hawser__wall_seconds(), busy = hawser__processor_seconds();
	enum hawser_status status = HAWSER_OK;

	begin(curve, choice);
	if (scene->damping.drag > 0.0)
		return hawser__drag_refuse(NULL, "a comparison of responses", report);
	if (choice->fidelity->build)
		status = choice->fidelity->build(&rom, statics, scene, choice->number, &curve->report);
	curve->build_seconds = hawser__wall_seconds() - start;
	curve->processor_seconds = hawser__processor_seconds() - busy;
	if (!status)
		status = respond(curve, &rom, statics, scene, options);
	hawser_rom_clear(&rom);
	return end(curve, status, report);
}

enum hawser_status hawser_study_model(struct hawser_study_curve *curve, struct hawser_rom *rom,
                                      const struct hawser_fidelity_choice *choice,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report)
{
	begin(curve, choice);
	return end(curve, respond(curve, rom, NULL, NULL, options), report);
}

void hawser_study_clear(struct hawser_study_curve *curve)
{
	if (!curve)
		return;
	hawser_frf_clear(&curve->frf);
	free(curve->landmark);
	memset(curve, 0, sizeof *curve);
}

/* --- comparison of two responses --- */

static void take(double *worst, int *at, double difference, int i)
{
	if (*at >= 0 && fabs(difference) <= fabs(*worst))
		return;
	*worst = difference;
	*at = i;
}

/* Whether this peak is the largest of its component. */
static int is_largest(const struct hawser_study_curve *curve, int i)
{
	const struct hawser_landmark *peak = &curve->landmark[i];

	for (int k = 0; k < curve->landmarks; k++)
		if (curve->landmark[k].kind == HAWSER_LANDMARK_PEAK &&
		    curve->landmark[k].probe == peak->probe && curve->landmark[k].axis == peak->axis &&
		    curve->landmark[k].size > peak->size)
			return 0;
	return 1;
}

static int is_counted(const struct hawser_study_curve *curve, int i,
                      enum hawser_landmark_kind kind, int largest)
{
	return curve->landmark[i].kind == kind && (!largest || is_largest(curve, i));
}

static void add_up(struct hawser_study_error *error, struct hawser_study_kind_error *kind_error,
                   const struct hawser_study_curve *curve,
                   const struct hawser_study_curve *reference, enum hawser_landmark_kind kind,
                   int largest)
{
	*kind_error = (struct hawser_study_kind_error){.omega = NAN, .size = NAN, .omega_at = -1,
	                                               .size_at = -1};
	for (int i = 0; i < curve->landmarks; i++) {
		const struct hawser_landmark *own = &curve->landmark[i], *other;
		int k = error->partner[i];

		if (own->kind != kind)
			continue;
		kind_error->extra += k < 0 && is_counted(curve, i, kind, largest);
		if (k < 0 || !is_counted(reference, k, kind, largest))
			continue;
		other = &reference->landmark[k];
		kind_error->matched++;
		take(&kind_error->omega, &kind_error->omega_at, own->omega/other->omega - 1.0, i);
		take(&kind_error->size, &kind_error->size_at, own->size/other->size - 1.0, i);
		error->floor = fmax(error->floor, fmax(own->omega_error, other->omega_error));
	}
	kind_error->missing = -kind_error->matched;
	for (int i = 0; i < reference->landmarks; i++)
		kind_error->missing += is_counted(reference, i, kind, largest);
}

static enum hawser_status distance_of(double *distance, const struct hawser_study_curve *curve,
                                      const struct hawser_study_curve *reference,
                                      struct hawser_report *report)
{
	struct hawser__marks own = {0}, other = {0};
	enum hawser_status status;

	*distance = NAN;
	if (curve->frf.points == 0 || reference->frf.points == 0)
		return HAWSER_OK;
	status = hawser__marks_of(&own, curve, report);
	if (!status)
		status = hawser__marks_of(&other, reference, report);
	if (!status)
		status = hawser__marks_distance(distance, &own, &other, report);
	hawser__marks_clear(&own);
	hawser__marks_clear(&other);
	return status;
}

enum hawser_status hawser_study_compare(struct hawser_study_error *error,
                                        const struct hawser_study_curve *curve,
                                        const struct hawser_study_curve *reference,
                                        const struct hawser_match_options *options,
                                        struct hawser_report *report)
{
	enum hawser_status status;

	memset(error, 0, sizeof *error);
	error->partner = calloc((size_t)curve->landmarks + 1, sizeof *error->partner);
	if (!error->partner)
		return hawser__no_memory(report, "study");
	status = hawser_landmarks_match(error->partner, curve->landmark, curve->landmarks,
	                                reference->landmark, reference->landmarks, options, report);
	if (!status)
		status = distance_of(&error->distance, curve, reference, report);
	if (status) {
		hawser_study_error_clear(error);
		return status;
	}
	add_up(error, &error->fold, curve, reference, HAWSER_LANDMARK_FOLD, 0);
	add_up(error, &error->peak, curve, reference, HAWSER_LANDMARK_PEAK, 0);
	add_up(error, &error->largest, curve, reference, HAWSER_LANDMARK_PEAK, 1);
	error->tension = curve->tension/reference->tension - 1.0;
	return HAWSER_OK;
}

void hawser_study_error_clear(struct hawser_study_error *error)
{
	if (!error)
		return;
	free(error->partner);
	memset(error, 0, sizeof *error);
}
