/* cli/compare/compare_made.c - see compare_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/compare/compare_result.h"
#include "cli/model/made.h"
#include "core/report.h"

static const struct hawser_fidelity mesh = {
	"mesh", "the whole mesh, by harmonic balance from the folds and peaks of the largest model",
	"doc/theory-rom.md, Nets", HAWSER_NUMBER_MODES, 1, 0, NULL, NULL, NULL};

int cli_compare_is_mesh(const struct cli_compare_result *result, int i)
{
	return result->curve[i].choice.fidelity == &mesh;
}

static int is_condensed(const struct hawser_fidelity_choice *choice)
{
	return strcmp(choice->fidelity->name, "condensed") == 0;
}

/* The model with the largest number of modes; -1: none. */
static int largest(const struct cli_compare_result *result)
{
	int best = -1;

	for (int i = 0; i < result->count; i++)
		if (is_condensed(&result->curve[i].choice) &&
		    (best < 0 || result->curve[i].choice.number > result->curve[best].choice.number))
			best = i;
	return best;
}

enum hawser_status cli_compare_made_choose(struct cli_compare_result *result, int *most, int net,
                                           struct hawser_report *report)
{
	*most = 0;
	for (int i = 0; i < result->count; i++) {
		const struct hawser_fidelity_choice *choice = &result->curve[i].choice;

		if (!is_condensed(choice) && strcmp(choice->fidelity->name, "multiple-scales") != 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare",
			                    "%s: of nets and ropeways, condensed N and multiple-scales N are "
			                    "compared, since their models have no other forms", choice->name);
		*most = choice->number > *most ? (int)choice->number : *most;
	}
	if (!net || result->reference >= 0)
		return HAWSER_OK;
	if (largest(result) < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare",
		                    "name condensed N too: the folds and peaks of the largest of these models "
		                    "are corrected in the mesh, which is the reference");
	result->reference = result->count++;
	result->curve[result->reference].choice = (struct hawser_fidelity_choice){.fidelity = &mesh,
	                                                                          .name = "mesh"};
	return HAWSER_OK;
}

/* The model of the first n modes, and its curve. */
static enum hawser_status follow(struct cli_compare_result *result, int i,
                                 const struct hawser_frf_options *options, struct hawser_report *report)
{
	const struct hawser_fidelity_choice choice = result->curve[i].choice;
	const struct cli_made *made = result->model->made;
	double start = cli_seconds(), busy = cli_processor_seconds(), wall;
	int n = (int)choice.number, *kept = calloc((size_t)n, sizeof *kept);
	struct cli_made_modes modes = {.alone = 0};
	struct hawser_rom rom = {.n = 0};
	enum hawser_status status = kept ? HAWSER_OK : hawser__no_memory(report, "compare");

	for (int j = 0; j < n && kept; j++)
		kept[j] = j;
	if (!status)
		status = made->by->again(&rom, &modes, made, n, kept, n, report);
	wall = cli_seconds() - start;
	busy = cli_processor_seconds() - busy;
	if (!status) {
		status = hawser_study_model(&result->curve[i], &rom, &choice, options, report);
		result->curve[i].build_seconds = wall;
		result->curve[i].processor_seconds += busy;
	} else {
		result->curve[i].status = status;
		result->curve[i].report = *report;
	}
	free(kept);
	hawser_rom_clear(&rom);
	cli_made_modes_clear(&modes);
	return status;
}

static struct hawser_landmark landmark_of(const struct hawser_certified *item, double rank)
{
	return (struct hawser_landmark){.kind = item->kind, .probe = item->probe, .axis = item->axis,
	                                .turn = item->turn, .arc = rank, .omega = item->exact_omega,
	                                .size = item->exact_size};
}

/* Where the landmark is on the model's curve. */
static double arc_of(const struct hawser_study_curve *curve, const struct hawser_certified *item)
{
	for (int i = 0; i < curve->landmarks; i++)
		if (curve->landmark[i].kind == item->kind && curve->landmark[i].omega == item->omega)
			return curve->landmark[i].arc;
	return 0.0;
}

static int earlier(const void *a, const void *b)
{
	const struct hawser_landmark *x = a, *y = b;

	return x->kind != y->kind ? (int)x->kind - (int)y->kind : (x->arc > y->arc) - (x->arc < y->arc);
}

/* Those that were found in the mesh, in the order of the curve. */
static enum hawser_status take(struct hawser_study_curve *curve, const struct hawser_study_curve *model,
                               const struct hawser_certificate *found, struct hawser_report *report)
{
	curve->landmark = calloc((size_t)found->count + 1, sizeof *curve->landmark);
	if (!curve->landmark)
		return hawser__no_memory(report, "compare");
	for (int i = 0; i < found->count; i++) {
		const struct hawser_certified *item = &found->item[i];
		struct hawser_landmark *own = &curve->landmark[curve->landmarks];

		if (!isfinite(item->distance))
			continue;
		*own = landmark_of(item, arc_of(model, item));
		own->omega_error = own->size_error = found->harmonics + found->lengths;
		if (own->kind == HAWSER_LANDMARK_FOLD)
			own->size = item->size;
		curve->least_tension = fmin(curve->least_tension, item->tension);
		curve->landmarks++;
	}
	qsort(curve->landmark, (size_t)curve->landmarks, sizeof *curve->landmark, earlier);
	return HAWSER_OK;
}

static enum hawser_status correct(struct cli_compare_result *result, int i, int from,
                                  struct hawser_report *report)
{
	struct hawser_study_curve *curve = &result->curve[i], *model = &result->curve[from];
	struct cli_certificate found = {.how = "yes"};
	const struct cli_frf_result response = {.common = result->common, .model = result->model,
		.frf = &model->frf, .peak = model->landmark, .peaks = model->landmarks};
	double start = cli_seconds(), busy = cli_processor_seconds(), most = result->limit*result->count;
	enum hawser_status status = result->model->made->by->certify(&found, &response, most, report);

	if (!status && found.own.count == 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "compare", found.own.foreseen > most
		                    ? "to correct the folds and peaks of %s in the mesh takes about %.0f s: "
		                      "raise --limit, or name a --reference of the list"
		                    : "%s has no folds or peaks to compare in this range",
		                    model->choice.name, found.own.foreseen);
	curve->n = found.own.unknowns;
	curve->tension = curve->least_tension = curve->estimated = NAN;
	curve->respond_seconds = cli_seconds() - start;
	curve->processor_seconds = cli_processor_seconds() - busy;
	if (!status)
		status = take(curve, model, &found.own, report);
	if (!status && curve->landmarks == 0)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "compare",
		                      "the mesh has none of the folds and peaks of %s near theirs: name a "
		                      "larger condensed N, or a --reference of the list", model->choice.name);
	return status;
}

enum hawser_status cli_compare_made(struct cli_compare_result *result, int i,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report)
{
	int from = largest(result);
	enum hawser_status status;

	if (!cli_compare_is_mesh(result, i))
		return follow(result, i, options, report);
	status = follow(result, from, options, report);
	result->done[from] = !cli_interrupted();
	return status || !result->done[from] ? status : correct(result, i, from, report);
}

void cli_compare_made_count(struct cli_compare_result *result, int i)
{
	struct hawser_study_curve *curve = &result->curve[i];
	struct hawser_study_error *error = &result->error[i];
	int count = 0;

	for (int k = 0; k < curve->landmarks; k++) {
		if (curve->landmark[k].kind == HAWSER_LANDMARK_PEAK && error->partner[k] < 0)
			continue;
		curve->landmark[count] = curve->landmark[k];
		error->partner[count++] = error->partner[k];
	}
	curve->landmarks = count;
	error->peak.extra = error->largest.extra = 0;
}
