/* study/accuracy/fixed.c - estimated error of a response with a given number of modes.
 *
 * Two first-order terms are evaluated in the motions of the response at its folds, peaks and ends:
 *
 *    followed  effect of the inertia and damping of all condensed modes, and of the truncated energy:
 *              one solution of the linearised equations along the curve (rom/condense/order.c). It
 *              adds with signs and includes the detuning of modes in resonance at a peak
 *    rest      dynamic part of the omitted modes, one by one (rom/choose/weigh.c): it adds magnitudes
 *
 * With a full-order model, `followed` is the whole error to first order; the square of the sum of
 * both is of the order of what is neglected, and a small part of `rest` is added. Of 40 ordinary cables
 * (bench/practical.py), the error is 0.6 to 1.5 times `followed` where that counts. In B Table 4.4,
 * line 2, 0.8 to 1.6 w1, a 1:2 resonance lies between folds 0.1 % apart, and the error of 9 modes is
 * 2.45e-2: rest 3.6e-3, truncation alone 6.1e-3, followed 2.36e-2. Without one (ropeways, nets), the
 * sum is multiplied by HAWSER__SAFETY, as in the choice of modes, and the effect of modes above the
 * candidates is added. The error of the located peaks is added to both.
 *
 * No other response is traced, so that the estimate takes a fraction of the time of the response.
 * The candidates are those for an accuracy of LOOKED_FOR, and the full-order model must be made
 * once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>
#include <time.h>

#include "core/report.h"
#include "study/accuracy/accuracy.h"
#include "study/accuracy/landmark.h"
#include "study/accuracy/motions.h"

/* accuracy that determines the highest candidate; chosen, so that few candidates suffice */
static const double looked_for = 0.1;
enum { MORE = 6 };                     /* fewest candidates beyond the kept modes; chosen */
enum { BETWEEN = 8 };                  /* number of further motions, which are examined for
                                        * instability only; chosen */

/* half the range about the frequency of a single motion; chosen */
static const double around = 1.05;

static double now(void)
{
	struct timespec time;

	clock_gettime(CLOCK_MONOTONIC, &time);
	return (double)time.tv_sec + 1e-9*(double)time.tv_nsec;
}

static enum hawser_status check(const struct hawser_rom *rom, const struct hawser_scene *scene,
                                struct hawser_report *report)
{
	if (rom->exact)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                    "a full-order model leaves no mode of its basis out: compare with a "
		                    "larger model.basis");
	if (scene->model.condense != HAWSER_CONDENSE_STATIC)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                    "modes that are not kept are at rest (model.condense: none), which is "
		                    "a large error: use static");
	return HAWSER_OK;
}

/* Candidates for a range, and the choice that keeps the lowest ones. */
static enum hawser_status begin(struct hawser_choice *choice, struct hawser_modes *modes, int kept,
                                const struct hawser_statics *statics,
                                const struct hawser_scene *scene, double from, double to,
                                struct hawser_report *report)
{
	int fewest = kept + MORE > HAWSER__FEWEST ? kept + MORE : HAWSER__FEWEST;
	enum hawser_status status = hawser__accuracy_candidates(modes, statics, scene, from, to, looked_for,
	                                                        fewest, report);

	if (!status)
		status = hawser__choice_begin(choice, modes, scene, from, to, looked_for, 0, report);
	for (int j = 0; !status && j < choice->n; j++)
		choice->mode[j].kept = j < kept;
	return status;
}

static const double least_peak = 0.2; /* smallest peak that counts, relative to the largest; chosen */

/* What is named: more than these parts of the largest measure, and of the response; chosen. */
static const double named_part = 0.1, named_least = 0.01;

/* The omitted mode with the largest measure below `most`, or -1. */
static int next_omission(const struct hawser_choice *choice, double most)
{
	int best = -1;

	for (int j = 0; j < choice->n; j++)
		if (!choice->mode[j].kept && choice->mode[j].measure < most &&
		    (best < 0 || choice->mode[j].measure > choice->mode[best].measure))
			best = j;
	return best;
}

static void name_omissions(struct hawser_accuracy_fixed *fixed, const struct hawser_choice *choice)
{
	int j = next_omission(choice, INFINITY);
	double least = j < 0 ? 0.0 : fmax(named_part*choice->mode[j].measure,
	                                  named_least/HAWSER__SAFETY);

	for (; j >= 0 && choice->mode[j].measure > least && fixed->omissions < HAWSER_ACCURACY_NAMED;
	     j = next_omission(choice, choice->mode[j].measure))
		fixed->omission[fixed->omissions++] = (struct hawser_accuracy_omission){
			j + 1, choice->mode[j].harmonic, choice->modes->mode[j].omega,
			choice->mode[j].measure};
}

/* Part of `rest` for what is small beside the largest motion, and for resonances: with less of it, a
 * small component of a footbridge cable and a peak of B Table 4.4, line 2, between folds are off by
 * more than is stated (bench/practical.py 40 1, bench/accuracy). */
static const double apart = 0.2;

double hawser__model_error(const struct hawser_choice *choice)
{
	double rest = hawser_choice_rest(choice), beyond = hawser_choice_beyond(choice);
	double all = choice->followed + rest + beyond;

	if (choice->exact.n == 0)
		return HAWSER__SAFETY*(rest + fmax(choice->followed, choice->truncation)) + beyond;
	return HAWSER__SAFETY_ORDER*choice->followed + apart*rest + HAWSER__SAFETY*all*fmin(all, 1.0);
}

void hawser__accuracy_add_up(struct hawser_accuracy_fixed *fixed, const struct hawser_choice *choice,
                             double located)
{
	fixed->rest = hawser_choice_rest(choice);
	fixed->beyond = hawser_choice_beyond(choice);
	fixed->truncation = choice->truncation;
	fixed->followed = choice->followed;
	fixed->located = located;
	fixed->looked_at = choice->n;
	name_omissions(fixed, choice);
	for (int j = choice->n - 1; j >= 0; j--)
		if (!choice->mode[j].kept && choice->mode[j].reason == HAWSER_PARAMETRIC &&
		    choice->mode[j].measure >= 1.0)
			fixed->at_risk = j + 1;
	fixed->estimated = fmin(hawser__model_error(choice) + fixed->located, 1.0);
}

void hawser_accuracy_locate(struct hawser_accuracy_fixed *fixed, const struct hawser_landmark *peak,
                            int count)
{
	double largest = 0.0, most = 0.0;

	for (int i = 0; i < count; i++)
		if (peak[i].kind == HAWSER_LANDMARK_PEAK)
			largest = fmax(largest, peak[i].size);
	for (int i = 0; i < count; i++)
		if (peak[i].kind == HAWSER_LANDMARK_PEAK && peak[i].size >= least_peak*largest)
			most = fmax(most, hawser__peak_unread(&peak[i]));
	if (fixed->estimated < 1.0)
		fixed->estimated += most - fixed->located;
	fixed->located = most;
}

enum hawser_status hawser_accuracy_among(struct hawser_accuracy_fixed *fixed,
                                         struct hawser_choice *choice, const struct hawser_rom *rom,
                                         const struct hawser_frf *frf, struct hawser_report *report)
{
	double start = now();
	struct hawser__marks marks = {.count = 0};
	enum hawser_status status = HAWSER_OK;

	*fixed = (struct hawser_accuracy_fixed){.estimated = NAN};
	if (frf->points < 2)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                      "a response of %d points has no motions to examine", frf->points);
	if (!status)
		status = hawser__marks_find(&marks, frf, NULL, NULL, 0.0, report);
	if (!status)
		status = hawser__weigh_response(choice, rom, frf, &marks, BETWEEN, report);
	choice->followed = fmax(choice->followed, rom->inertia.left);
	if (!status)
		hawser__accuracy_add_up(fixed, choice, hawser__marks_located(&marks));
	fixed->seconds = now() - start;
	hawser__marks_clear(&marks);
	return status;
}

enum hawser_status hawser_accuracy_fixed(struct hawser_accuracy_fixed *fixed,
                                         const struct hawser_rom *rom, const struct hawser_frf *frf,
                                         int kept, const struct hawser_statics *statics,
                                         const struct hawser_scene *scene, double from, double to,
                                         struct hawser_report *report)
{
	double start = now();
	struct hawser_choice choice = {.n = 0};
	struct hawser_modes modes = {.n = 0};
	enum hawser_status status = check(rom, scene, report);

	*fixed = (struct hawser_accuracy_fixed){.estimated = NAN};
	if (!status)
		status = begin(&choice, &modes, kept, statics, scene, from, to, report);
	if (!status)
		status = hawser_accuracy_among(fixed, &choice, rom, frf, report);
	fixed->seconds = now() - start;
	hawser_choice_clear(&choice);
	hawser_modes_clear(&modes);
	return status;
}

enum hawser_status hawser_accuracy_once(struct hawser_accuracy_fixed *fixed,
                                        const struct hawser_rom *rom,
                                        const struct hawser_accuracy_motion *motion, int kept,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report)
{
	double start = now(), omega = motion->omega;
	struct hawser_choice choice = {.n = 0};
	struct hawser_modes modes = {.n = 0};
	enum hawser_status status = check(rom, scene, report);

	*fixed = (struct hawser_accuracy_fixed){.estimated = NAN};
	if (!status)
		status = begin(&choice, &modes, kept, statics, scene, omega/around, omega*around, report);
	if (!status)
		status = hawser__weigh_motion(&choice, rom, motion, 1, HAWSER__BY_PLANE, HAWSER__BY_PLANE,
		                              report);
	if (!status)
		hawser__accuracy_add_up(fixed, &choice, 0.0);
	fixed->seconds = now() - start;
	hawser_choice_clear(&choice);
	hawser_modes_clear(&modes);
	return status;
}
