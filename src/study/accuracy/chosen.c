/* study/accuracy/chosen.c - a condensed model of the N most important modes.
 *
 * The importance follows from a response. The first model keeps the modes that estimated motions
 * require (choose.h). Its response is traced with a large tolerance, and the motions at its folds
 * and peaks give each mode a measure. The first N modes in the order of their measures form the
 * model. At a peak of a displacement component, errors are relative to this component, so that a
 * small component counts as much as a large one. At a fold, only errors of the frequency or of the
 * whole amplitude count.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <hawser/choose.h>
#include <hawser/frf.h>

#include "core/report.h"
#include "hawser/accuracy.h"
#include "study/accuracy/motions.h"
#include "study/accuracy/respond.h"

enum { fewest = 24, each = 2, many = 48 }; /* number of candidate modes: at least `fewest` and
                                            * each*N, at most `many` or N; chosen */
enum { first_least = 8 };                  /* smallest number of modes of the first model; chosen */
static const double reach = 5.0;           /* candidates reach up to this multiple of the upper end
                                            * of the range; chosen */
static const double coarse = 1e-7;

/* The first model, and the options with which its response is traced. Must not be moved: choice
 * refers to modes. */
struct chosen {
	struct hawser_choice choice;
	struct hawser_modes modes;
	struct hawser_scene scene;         /* its `name` is owned by the caller */
	struct hawser_frf_options options;
};

static int at_least(int a, int b)
{
	return a > b ? a : b;
}

static enum hawser_status look(struct hawser_choice *choice, struct hawser_modes *modes,
                               const struct hawser_statics *statics,
                               const struct hawser_scene *scene, double from, double to, int n,
                               struct hawser_report *report)
{
	struct hawser_modes_options options = {.n = at_least(fewest, each*n < many ? each*n : many),
	                                       .basis = scene->model.basis};
	double top = reach*fmax(from, to), last;
	enum hawser_status status;

	*choice = (struct hawser_choice){.n = 0};
	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	options.n = at_least(options.n, n);
	status = hawser_modes_solve(modes, statics, &options, report);
	if (!status && options.n < many && (last = modes->mode[options.n - 1].omega) < top) {
		options.n = (int)fmin(ceil(options.n*top/last), many);
		hawser_modes_clear(modes);
		status = hawser_modes_solve(modes, statics, &options, report);
	}
	return status ? status : hawser_choose(choice, modes, scene, from, to, 0.5, report);
}

/* --- the motions of a response --- */

/* Weigh the modes by the traced points nearest to the landmarks; a point that is nearest to several
 * landmarks is used once. */
static enum hawser_status weigh(struct hawser_choice *choice, const struct hawser_rom *rom,
                                const struct hawser_frf *frf, struct hawser_report *report)
{
	unsigned *counted = calloc((size_t)frf->points, sizeof *counted);
	char *marked = calloc((size_t)frf->points, 1);
	struct hawser_landmark *landmark = NULL;
	int count = 0;
	enum hawser_status status = counted && marked ? HAWSER_OK : hawser__no_memory(report, "study");

	if (!status)
		status = hawser_landmarks(&landmark, &count, frf, NULL, report);
	if (!status && count > 0)
		hawser_choice_forget(choice);
	for (int k = 0; !status && k < count; k++) {
		int i = hawser__nearest_point(frf, landmark[k].arc);

		marked[i] = 1;
		if (landmark[k].kind == HAWSER_LANDMARK_PEAK)
			counted[i] |= 1u << (3*landmark[k].probe + landmark[k].axis);
	}
	for (int i = 0; !status && i < frf->points; i++)
		if (marked[i])
			status = hawser__weigh_orbit(choice, rom, frf, i, 1, counted[i], counted[i],
			                             report);
	free(landmark);
	free(marked);
	free(counted);
	return status;
}

/* Find the first model. Statuses of hawser_modes_solve and hawser_choose. Release with
 * chosen_clear, whatever the status. */
static enum hawser_status chosen_begin(struct chosen *begin,
                                       const struct hawser_statics *statics,
                                       const struct hawser_scene *scene,
                                       const struct hawser_frf_options *options, int n,
                                       struct hawser_report *report)
{
	enum hawser_status status;

	*begin = (struct chosen){.scene = *scene, .options = *options};
	begin->scene.model.condense = HAWSER_CONDENSE_STATIC;
	begin->scene.model.energy = HAWSER_ENERGY_QUARTIC;
	begin->options.tolerance = fmax(coarse, options->tolerance);
	begin->options.samples = HAWSER_NONE;
	status = look(&begin->choice, &begin->modes, statics, &begin->scene, options->from, options->to,
	              n, report);
	hawser_rom_clear(&begin->choice.exact); /* not used further: the truncation error of this model
	                                         * is not estimated */
	if (!status)
		hawser_choice_first(&begin->choice, at_least(n, first_least));
	return status;
}

static void chosen_clear(struct chosen *begin)
{
	hawser_choice_clear(&begin->choice);
	hawser_modes_clear(&begin->modes);
}

enum hawser_status hawser__study_chosen(struct hawser_study_curve *curve, struct hawser_rom *rom,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report)
{
	struct hawser_frf frf = {.n = 0};
	struct chosen first;
	int n = (int)curve->choice.number;
	enum hawser_status status = chosen_begin(&first, statics, scene, options, n, report);

	if (!status)
		status = hawser_choice_build(rom, &first.choice, &first.scene, report);
	if (!status)
		status = hawser_frf_trace(&frf, rom, &first.options, report);
	if (!status)
		status = weigh(&first.choice, rom, &frf, report);
	hawser_frf_clear(&frf);
	if (!status) {
		hawser_choice_first(&first.choice, n);
		hawser_rom_clear(rom);
		status = hawser_choice_build(rom, &first.choice, &first.scene, report);
	}
	chosen_clear(&first);
	return status ? status : hawser__study_trace(curve, rom, statics, scene, options, report);
}
