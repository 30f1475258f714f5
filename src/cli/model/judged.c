/* cli/model/judged.c - the model by which the response of a travelling cable is judged.
 *
 *   w_j     natural frequencies of the cable as it travels, with gyroscopic forces (gyroscopic.h)
 *   error   the largest relative distance of a w_j from the nearest one of the model, for as many w_j
 *           as the model has coordinates
 *
 * Modes of the apparent cable are coupled by the speed with all others, and the frequencies of a model
 * of n of them converge like 1/n^3: at a third of the wave speed, those of five modes are off by 4e-3,
 * more than the width of most regions of instability, which lie at multiples of sums of frequencies and
 * are displaced by as much. All functions of a basis converge exponentially, and cost less than the
 * number of modes that would be as good. So the number of coordinates follows from the speed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/gyroscopic.h>
#include <hawser/linear.h>

#include "cli/model/exact.h"
#include "cli/model/judged.h"
#include "core/report.h"

/* Error of a natural frequency that is small enough: narrow regions of instability have widths of a
 * thousandth of their frequency, and are placed to a thousandth of that; chosen. */
static const double enough = 2e-6;
enum { FEWEST = 6, MOST = 16, MORE = 2 }; /* functions a component */
static const double WIDE = 0.01;  /* of a region's width: error of an edge, warned of; chosen */
static const double ROUGH = 1e-4; /* error that is warned of: some tenth of a region's width; chosen */
enum { LISTED = 16 }; /* natural frequencies that are looked at; chosen */

int cli_judged_free(const struct cli_model *model, int n)
{
	return n == 0 && cli_exact_calls(model, NULL) &&
	       !hawser_scene_written(&model->scene, "model.modes") &&
	       !hawser_scene_written(&model->scene, "model.basis");
}

/* The natural frequencies [n] of a model without damping, scaled. */
static enum hawser_status frequencies(double *to, const struct hawser_rom *rom,
                                      struct hawser_report *report)
{
	size_t n = (size_t)rom->n;
	struct hawser_rom plain = *rom;
	struct hawser_linear *linear = NULL;
	double growth;
	int growing;
	enum hawser_status status = hawser_linear_open(&linear, rom->n, report);

	plain.D = malloc(n*n*sizeof *plain.D);
	if (!status && !plain.D)
		status = hawser__no_memory(report, "hill");
	for (size_t e = 0; !status && e < n*n; e++)
		plain.D[e] = 0.5*(rom->D[e] - rom->D[e%n*n + e/n]);
	if (!status)
		status = hawser_linear_growth(linear, &growth, &growing, to, &plain, report);
	hawser_linear_free(linear);
	free(plain.D);
	return status;
}

/* judged->error of a model against the modes of the travelling cable. */
static enum hawser_status measure(struct cli_judged *judged, const struct hawser_rom *rom,
                                  const struct hawser_modes *exact, double top,
                                  struct hawser_report *report)
{
	double *own = malloc((size_t)rom->n*sizeof *own);
	enum hawser_status status = own ? frequencies(own, rom, report)
	                            : hawser__no_memory(report, "hill");

	judged->error = 0.0;
	/* modes beyond those of the model are missing, which the number of modes says */
	for (int j = 0; !status && j < exact->n && j < rom->n; j++) {
		double omega = exact->mode[j].omega, nearest = INFINITY;

		if (omega > top*exact->time_unit && j > 0)
			break;
		judged->to = omega/exact->time_unit;
		for (int k = 0; k < rom->n; k++)
			nearest = fmin(nearest, fabs(own[k] - omega));
		judged->error = fmax(judged->error, nearest/omega);
	}
	judged->coordinates = rom->n;
	judged->stated = !status;
	free(own);
	return status;
}

static enum hawser_status choose(struct cli_judged *judged, struct cli_model *model,
                                 const struct hawser_modes *exact, double top,
                                 struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int functions = FEWEST; functions <= MOST; functions += MORE) {
		hawser_rom_clear(&model->rom);
		status = hawser_rom_build_full(&model->rom, &exact->statics, &model->scene, functions, report);
		if (!status)
			status = measure(judged, &model->rom, exact, top, report);
		judged->functions = functions;
		if (status || judged->error <= enough)
			break;
	}
	model->scene.model.energy = HAWSER_ENERGY_EXACT;
	model->scene.model.basis = judged->functions;
	return status;
}

void cli_judged_warn(const struct cli_judged *judged)
{
	const struct hawser_map_shift *edges = &judged->edges;
	char text[CLI_WARNING_SIZE];

	if (edges->compared > 0 && edges->share > WIDE) {
		snprintf(text, sizeof text, "boundaries of stability are off by up to %.2g%s%s, %.2g of the "
		         "width of their region, with %d coordinates: %s", edges->distance,
		         *judged->unit ? " " : "", judged->unit, edges->share, judged->coordinates,
		         judged->waves > 0 ? "hawser hill --Omega has a larger model, for single points"
		         : "leave -n and the keys of model out, and they follow from the speed");
		cli_caution("boundaries are rough", text);
	}
	if (edges->compared > 0)
		return;
	if (!judged->stated || judged->error <= ROUGH)
		return;
	snprintf(text, sizeof text, "natural frequencies of the travelling cable are off by %.1e with %d "
	         "coordinates, and boundaries of stability by as much: take more modes (-n), or --set "
	         "model.energy=exact", judged->error, judged->coordinates);
	cli_caution("boundaries are rough", text);
}

enum hawser_status cli_judged_choose(struct cli_judged *judged, struct cli_model *model, int free,
                                     double top, struct hawser_report *report)
{
	const struct hawser_modes_options options = {.n = LISTED};
	struct hawser_statics statics;
	struct hawser_modes exact = {.n = 0};
	enum hawser_status status;

	*judged = (struct cli_judged){.stated = 0};
	if (!model->has_scene || model->made || !model->scene.travel.present ||
	    model->scene.travel.speed == 0.0)
		return HAWSER_OK;
	status = hawser_statics_scene(&statics, &model->scene, report);
	if (!status && (statics.space || statics.motion.nu == 0.0))
		return HAWSER_OK;
	if (!status)
		status = hawser_complex_modes_solve(&exact, &statics, &options, report);
	if (!status && free)
		status = choose(judged, model, &exact, top, report);
	else if (!status && model->rom.n > 0)
		status = measure(judged, &model->rom, &exact, top, report);
	hawser_modes_clear(&exact);
	return status;
}

void cli_judged_comment(struct hawser__table *table, const struct cli_judged *judged)
{
	const struct hawser_map_shift *edges = &judged->edges;

	if (judged->functions > 0)
		hawser__table_comment(table, "exact energy on %d functions a component, %d coordinates, as the "
		                      "speed requires (--modes keeps modes)", judged->functions,
		                      judged->coordinates);
	if (judged->waves > 0)
		hawser__table_comment(table, "model: %d coordinates, the span of the %d lowest complex modes, "
		                      "as speed and frequencies require (--modes keeps modes)",
		                      judged->coordinates, judged->waves);
	if (judged->stated)
		hawser__table_comment(table, "natural frequencies of the travelling cable up to %.6g rad/s: "
		                      "off by %.1e at most", judged->to, judged->error);
	if (edges->compared > 0)
		hawser__table_comment(table, "boundaries: off by %.2g%s%s at most, %.1e of the width of their "
		                      "region, by what the model leaves out (%d edges compared)",
		                      edges->distance, *judged->unit ? " " : "", judged->unit, edges->share,
		                      edges->compared);
}

HAWSER__GIVEN(is_stated, struct cli_judged, of->stated)
HAWSER__GIVEN(is_compared, struct cli_judged, of->edges.compared > 0)
HAWSER__GIVEN(has_waves, struct cli_judged, of->waves > 0)
#define OF(member) HAWSER__AT(struct cli_judged, member)
const struct hawser__field cli_judged_field[] = {
	{"waves", NULL, "travelling cable: complex modes whose span is the model", OF(waves),
	 .given = has_waves},
	{"frequency_error", NULL, "largest relative error of a natural frequency of the travelling cable",
	 OF(error), .given = is_stated},
	{"edges.error", NULL, "travelling cable: estimated error of a boundary, along Omega if that is an "
	 "axis", OF(edges.distance), .given = is_compared},
	{"edges.of_width", NULL, "the same as a part of the width of its region", OF(edges.share),
	 .given = is_compared},
	{"edges.compared", NULL, "number of edges that were compared with a larger model",
	 OF(edges.compared), .given = is_compared},
	HAWSER__END,
};
#undef OF
