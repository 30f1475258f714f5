/* cli/model/exact_plane.c - the error of the modes over a plane of parameters, and the exact energy
 * where they are not good enough.
 *
 * Where an axis is a key of the scene, the responses over the frequencies are followed at its ends and
 * in its middle, and the largest error is stated: of conductor.yaml it is 0.056 at -30 K and 0.11 at
 * 20 K.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/curves/frf_over.h"
#include "cli/frame/within.h"
#include "cli/model/exact.h"
#include "cli/model/key_sweep.h"

/* Of a map of amplitudes: work of a row over that of a draft (three rows of a footbridge: 2.7), and the
 * range about one frequency; chosen. */
static const double row = 3.0, around = 1.05;

/* rad/s; there is the scene alone, which then has the keys of the exact energy. report: NULL: a
 * trial. */
static enum hawser_status choose_for(struct cli_model *model, int n, double from, double to,
                                     double after, const struct cli_common *common,
                                     struct hawser_report *report)
{
	struct cli_model own = {.has_scene = 0};
	enum hawser_status status = cli_model_load(&own, common, n, report);
	double unit = cli_per_omega(&own);

	if (!status)
		status = cli_exact_range(&own, from/unit, to/unit, after, common, report);
	if (!status && own.exact.functions) {
		model->scene.model.energy = HAWSER_ENERGY_EXACT;
		model->scene.model.basis = own.exact.functions;
	}
	if (!status && report)
		cli_known_warn(&own, to/unit);
	model->exact = own.exact;
	model->error = own.error;
	cli_model_clear(&own);
	return status;
}

/* The scene at ends of the axes that are keys of it (bits: 1: of x, 2: of y), or in their middle. */
enum { MIDDLE = 4 };
struct corner {
	struct cli_common common;
	char set[2][CLI_KEY_SWEEP_SET];
	int keys; /* 0: no axis is */
};

static int is_key(const char *axis)
{
	return strcmp(axis, "Omega") != 0 && cli_over_needs_scene(axis);
}

static void set_corner(struct corner *corner, const struct cli_plane *plane, int which,
                       const struct cli_common *common)
{
	corner->common = *common;
	corner->keys = 0;
	for (int k = 0; k < 2; k++) {
		if (!is_key(plane->key[k]) || corner->common.sets == CLI_SETS)
			continue;
		snprintf(corner->set[corner->keys], sizeof corner->set[0], "%s=%.17g", plane->key[k],
		         which == MIDDLE ? 0.5*(plane->from[k] + plane->to[k])
		                         : which >> k & 1 ? plane->to[k] : plane->from[k]);
		corner->common.set[corner->common.sets++] = corner->set[corner->keys++];
	}
}

/* Where of these the error of the modes is largest, and of how many it is not known; the scene as it is
 * where no axis is a key of it, or none has one. */
static enum hawser_status worst_corner(struct corner *worst, int *lost, const struct cli_plane *plane,
                                       const struct cli_model *model, int n, double from, double to,
                                       const struct cli_common *common)
{
	enum hawser_status status = HAWSER_OK;
	double most = -1.0;
	int found = -1;

	*lost = 0;
	set_corner(worst, plane, 0, common);
	cli_warn_off(1);
	for (int which = 0; worst->keys > 0 && which <= MIDDLE && status != HAWSER_ERR_MEMORY; which++) {
		struct cli_model own = *model;

		if ((which & 1 && !is_key(plane->key[0])) ||
		    (which & 2 && !is_key(plane->key[1])))
			continue;
		set_corner(worst, plane, which, common);
		status = choose_for(&own, n, from, to, -1.0, &worst->common, NULL);
		*lost += status || !isfinite(own.error.fixed.estimated);
		if (!status && own.error.fixed.estimated > most) {
			most = own.error.fixed.estimated;
			found = which;
		}
	}
	cli_warn_off(0);
	if (found >= 0) {
		set_corner(worst, plane, found, common);
	} else {
		worst->common = *common;
		worst->keys = 0;
	}
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}

enum hawser_status cli_exact_plane(const struct cli_plane *plane, struct cli_model *model, int n,
                                   const struct cli_common *common, struct hawser_report *report)
{
	int k = strcmp(plane->key[1], "Omega") == 0, axis = k || strcmp(plane->key[0], "Omega") == 0;
	double from = axis ? plane->from[k] : plane->omega/around;
	double to = axis ? plane->to[k] : plane->omega*around;
	struct corner worst;
	int lost;
	enum hawser_status status;

	if (!model->has_scene && from > 0.0)
		model->error.to = to/cli_per_omega(model);
	if (!model->has_scene || model->scene.beam.form || !(from > 0.0) ||
	    (model->scene.travel.present && plane->rows == 0)) /* of which judged.h states the error */
		return HAWSER_OK;
	status = worst_corner(&worst, &lost, plane, model, n, from, to, common);
	if (!status)
		status = choose_for(model, n, from, to, plane->rows > 0 ? row*plane->rows : -1.0, &worst.common,
		                    report);
	if (worst.keys > 0 && model->error.stated)
		model->error.about = model->exact.functions
			? "folds and peaks where the modes are worst, of corners and middle of the plane"
			: lost > 0 ? "folds and peaks at the worst of those corners and middle of the plane where "
			  "the error is known"
			: "folds and peaks at the worst of corners and middle of the plane";
	return status;
}
