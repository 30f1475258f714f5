/* bench/estimates-accuracy.c - responses with a required accuracy (model.modes: auto) and with a
 * given number of modes, in whose place the exact energy answers by default where their error is
 * large: the estimated error (estimates.h) against full-order models (estimates-reference.c).
 *
 * Spans are taut to deeply sagging. The ranges contain one of the lowest modes, whose peak may lie
 * near an end of the range; amplitudes at resonance are up to a tenth of the sag.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "bench/clock.h"
#include "bench/estimates.h"

enum { MODES = 6, POINTS = 1000 };
/* Range of the requested accuracies, as users choose them. */
static const double finest = 0.003, coarsest = 0.03;
static const double known_to = 4.0; /* factor on the upper end of the range, as in hawser frf
                                     * (cli/model/known.c) */

static int draw_span(struct hawser_statics *st, struct chance *chance)
{
	double d = chance_log(chance, 1.0, 500.0), rho = chance_log(chance, 0.05, 50.0);
	double slope = chance_unit(chance) < 0.3 ? 0.0 : chance_between(chance, -0.8, 0.8);
	double sag = chance_unit(chance) < 0.5 ? chance_log(chance, 3e-3, 0.1)
	                                       : chance_between(chance, 0.1, 0.35);
	struct hawser_span span = {.rho = rho, .g = 9.81, .d = d, .h = slope*d};

	span.EA = rho*span.g*d/(8.0*sag)/chance_log(chance, 1e-6, 3e-3);
	return hawser_statics_solve(st, &span, HAWSER_GIVEN_SAG, sag*d, HAWSER_BRANCH_TAUT,
	                            NULL) != HAWSER_OK;
}

/* The accuracy of a scene has a generator of its own, so that the other draws do not depend on it. */
static double draw_accuracy(const struct chance *chance)
{
	struct chance own = chance_at(chance->state, 0, 0);

	return chance_log(&own, finest, coarsest);
}

/* A load with which the amplitude at the resonance is `part` of the sag: f/(D w) in the scaled
 * equations. */
static void draw_load(struct hawser_scene *scene, struct chance *chance,
                      const struct hawser_statics *st, double omega)
{
	double ratio = chance_log(chance, 3e-3, 0.03), part = chance_log(chance, 1e-3, 0.1);
	double size = 2.0*ratio*omega*omega*part*st->sag/st->span.d*st->H/st->span.d;

	*scene = (struct hawser_scene){.g = st->span.g};
	scene->load.present = 1;
	scene->load.frame = HAWSER_FRAME_GLOBAL;
	scene->load.extent[1] = 1.0;
	for (int i = 0; i < 3; i++)
		scene->load.per_length[i] = size*chance_between(chance, 0.2, 1.0);
	scene->damping.kind = HAWSER_DAMPING_RATIO;
	scene->damping.ratio = ratio;
	scene->model.modes = HAWSER_MODES_AUTO;
	scene->model.condense = HAWSER_CONDENSE_STATIC;
	scene->model.inertia = HAWSER_INERTIA_AUTO;
}

/* The last model, that of the response; functions = 0: a condensed model. */
static struct hawser_accuracy_try last(const struct hawser_accuracy *accuracy)
{
	return accuracy->tries > 0 ? accuracy->attempt[accuracy->tries - 1]
	                           : (struct hawser_accuracy_try){.functions = 0};
}

int estimate_reached(struct tally *tally, const struct hawser_statics *st,
                     const struct hawser_scene *scene, double from, double to, const char *what)
{
	struct hawser_accuracy_options options = {.most = 0};
	struct hawser_accuracy accuracy = {.tries = 0};
	struct estimate_truth truth;
	struct estimate_response response = {.frf = &accuracy.frf, .rom = &accuracy.rom,
		.statics = st, .scene = scene, .from = from, .to = to};
	int refused;

	options.frf.from = from;
	options.frf.to = to;
	options.frf.step_max = ESTIMATE_STEP;
	options.frf.samples = HAWSER_NONE;
	refused = hawser_accuracy_trace(&accuracy, st, scene, &options, NULL) || !accuracy.reached ||
	          estimate_truth(&truth, &response, last(&accuracy).functions, accuracy.estimated);
	if (!refused)
		tally_note(tally, truth.distance, accuracy.estimated,
		           "asked %.2g, %d coordinates%s%s, sag %.3g, slope %.2g, epsilon %.2g, Omega %.4g "
		           "to %.4g, left out %.2g, truncated %.2g, moved %.2g; the reference has %d "
		           "functions and moved by %.1e", scene->model.accuracy, accuracy.rom.n,
		           accuracy.full ? ", full order" : "", what, st->sag/st->span.d, st->hs,
		           st->epsilon, from, to, last(&accuracy).rest, last(&accuracy).truncation,
		           last(&accuracy).moved, truth.functions, truth.move);
	hawser_accuracy_clear(&accuracy);
	return refused;
}

int estimate_accuracy(struct tally *tally, struct chance *chance)
{
	struct hawser_modes_options lowest = {.n = MODES};
	struct hawser_modes modes = {.n = 0};
	struct hawser_statics st;
	struct hawser_scene scene;
	double omega, from, to, asked = draw_accuracy(chance);

	if (draw_span(&st, chance) || hawser_modes_solve(&modes, &st, &lowest, NULL)) {
		hawser_modes_clear(&modes);
		return 1;
	}
	omega = modes.mode[chance_int(chance, 0, MODES - 1)].omega;
	hawser_modes_clear(&modes);
	draw_load(&scene, chance, &st, omega);
	scene.model.accuracy = asked;
	from = omega*(1.0 - chance_log(chance, 5e-3, 0.2));
	to = omega*(1.0 + chance_log(chance, 5e-3, 0.2));
	return estimate_reached(tally, &st, &scene, from, to, "");
}

/* The response of the lowest n modes. */
static int trace_lowest(struct hawser_frf *frf, struct hawser_rom *rom, struct hawser_modes *modes,
                        const struct hawser_statics *st, const struct hawser_scene *scene, int n,
                        const struct hawser_frf_options *range, struct hawser_report *report)
{
	struct hawser_modes_options lowest = {.n = n};
	struct hawser_frf_options options = {.method = NULL};

	options.from = range->from;
	options.to = range->to;
	options.step_max = ESTIMATE_STEP;
	options.samples = HAWSER_NONE;
	options.max_points = POINTS;
	return hawser_modes_solve(modes, st, &lowest, report) ||
	       hawser_rom_build(rom, modes, scene, report) ||
	       hawser_rom_know_below(rom, modes, scene, known_to*range->to, report) ||
	       hawser_frf_trace(frf, rom, &options, report) || frf->end == HAWSER_END_MAX_POINTS;
}

/* Loads along the axes of the cable, on a part of it, and also damping by air. */
static void vary_load(struct hawser_scene *scene, struct chance *chance,
                      const struct hawser_modes *modes)
{
	scene->model.modes = 0;
	if (chance_unit(chance) < 0.5)
		scene->load.frame = HAWSER_FRAME_LOCAL;
	if (chance_unit(chance) < 0.3) {
		scene->load.extent[0] = chance_between(chance, 0.0, 0.4);
		scene->load.extent[1] = chance_between(chance, 0.6, 1.0);
	}
	if (chance_unit(chance) < 0.4) {
		scene->damping.kind = HAWSER_DAMPING_ALPHA;
		scene->damping.alpha = 2.0*scene->damping.ratio*modes->mode[0].omega*
		                       modes->statics.span.rho/modes->time_unit;
	}
}

/* What hawser frf answers by default where the error of the modes is large: the exact energy. Returns
 * 1 if that is not called for or not found; the modes' response then stays with its own error. */
static int estimate_exact(struct tally *tally, const struct hawser_accuracy_fixed *fixed, int points,
                          const struct estimate_response *modes, const char *what)
{
	struct hawser_frf_options range = {.from = modes->from, .to = modes->to, .samples = HAWSER_NONE};
	struct hawser_accuracy_options options = hawser_accuracy_instead(fixed, 0, &range);
	struct hawser_accuracy exact = {.tries = 0};
	struct estimate_response response = *modes;
	struct estimate_truth truth;
	int refused;

	options.expected = points;
	response.frf = &exact.frf;
	response.rom = &exact.rom;
	refused = !hawser_accuracy_poor(fixed, 0.0) ||
	          hawser_accuracy_exact(&exact, modes->statics, modes->scene, &options, NULL) ||
	          !exact.reached ||
	          estimate_truth(&truth, &response, exact.functions, exact.estimated);
	if (!refused)
		tally_note(tally, truth.distance, exact.estimated,
		           "exact energy on %d functions in place of %.2g%s, sag %.3g, slope %.2g, epsilon "
		           "%.2g, Omega %.4g to %.4g; the reference has %d functions and moved by %.1e",
		           exact.functions, fixed->estimated, what, modes->statics->sag/modes->statics->span.d,
		           modes->statics->hs, modes->statics->epsilon, modes->from, modes->to,
		           truth.functions, truth.move);
	hawser_accuracy_clear(&exact);
	return refused;
}

int estimate_kept(struct tally *tally, const struct hawser_statics *st,
                  const struct hawser_scene *scene, int n, double from, double to, const char *what)
{
	struct hawser_frf_options range = {.from = from, .to = to};
	struct hawser_accuracy_fixed fixed = {.estimated = NAN};
	struct hawser_modes kept = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	struct estimate_response response = {.frf = &frf, .rom = &rom, .statics = st, .scene = scene,
		.from = from, .to = to};
	struct estimate_truth truth;
	double traced, told;
	struct hawser_report why = {.message = "the reference has no response"};
	int refused, exact;

	traced = cpu_secs();
	refused = trace_lowest(&frf, &rom, &kept, st, scene, n, &range, &why);
	traced = cpu_secs() - traced;
	told = cpu_secs();
	refused = refused || hawser_accuracy_fixed(&fixed, &rom, &frf, n, st, scene, from, to, &why);
	told = cpu_secs() - told;
	exact = !refused && !estimate_exact(tally, &fixed, frf.points, &response, what);
	refused = refused || (!exact && estimate_truth(&truth, &response, 0, fixed.estimated));
	if (!refused && !exact)
		tally_note(tally, truth.distance, fmax(fixed.estimated, ESTIMATE_SURE),
		           "%d modes%s, sag %.3g, slope %.2g, epsilon %.2g, Omega %.4g to %.4g, left out "
		           "%.2g, beyond them %.2g, beyond modes %.2g, followed %.2g, located %.2g; %.0f %% "
		           "of the run's time; the reference has %d functions and moved by %.1e", n, what,
		           st->sag/st->span.d, st->hs, st->epsilon, from, to, fixed.rest, fixed.beyond,
		           fixed.truncation, fixed.followed, fixed.located, 100.0*told/traced,
		           truth.functions, truth.move);
	else if (refused && tally->show > 0.0)
		printf("  scene %d: refused: %s%s\n", tally->scene, why.message, what);
	hawser_modes_clear(&kept);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return refused;
}

int estimate_fixed(struct tally *tally, struct chance *chance)
{
	struct hawser_modes_options lowest = {.n = MODES};
	struct hawser_modes modes = {.n = 0};
	struct hawser_statics st;
	struct hawser_scene scene;
	double omega, from, to;
	int which = chance_int(chance, 0, 2), n = which + 1 + chance_int(chance, 1, 12);

	if (draw_span(&st, chance) || hawser_modes_solve(&modes, &st, &lowest, NULL)) {
		hawser_modes_clear(&modes);
		return 1;
	}
	omega = modes.mode[which].omega;
	draw_load(&scene, chance, &st, omega);
	vary_load(&scene, chance, &modes);
	hawser_modes_clear(&modes);
	from = omega*(1.0 - chance_log(chance, 5e-3, 0.2));
	to = omega*(1.0 + chance_log(chance, 5e-3, 0.2));
	return estimate_kept(tally, &st, &scene, n, from, to, "");
}
