/* study/accuracy_full.c - full-order models of increasing bases, for an accuracy that no condensed
 * model reaches.
 *
 * A condensed model lacks terms of the energy that no further modes replace. A full-order model has
 * all terms; its error is that of its basis. This error mostly decreases so fast that the
 * difference of two successive bases is far larger than the error of the second. An exception is a
 * harmonic of the response near resonance with a high mode, whose frequency only a large basis has
 * accurately. Successive differences are then of similar size (B Table 4.4, line 2: 1.2e-4 from 12
 * to 14 functions, 1.5e-4 from 14 to 16). Therefore the estimated error is a multiple of the
 * difference.
 *
 * Each basis is checked with the next, whose curve has long steps and no multipliers: each point of
 * either curve is compared with the curve through the others, not with points (curve.c).
 *
 * The agreement of two bases that do not resolve the linear modes of the range, or the load, means
 * nothing. Such a basis is skipped without a response. So is one with as many coordinates as the
 * last: attachments divide the cable into elements, which share the functions out, so that 6 and 8
 * of them may give the same model. The first response is compared with that of the last condensed
 * model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "study/accuracy.h"

#define SAFETY_BASIS 3.0 /* factor on the difference, calibrated by bench/accuracy.c */
#define FINEST 1e-9      /* smallest tolerance of the orbits; chosen, far below any accuracy */
#define MIDDLING 12      /* functions per component from which on a failure is attributed to the
                          * tolerance, not to the basis; chosen */
#define RESOLVED 0.1     /* largest error of the frequencies in the range, relative to the accuracy;
                          * chosen */
#define ROUGHLY 1.0      /* the same for modes up to REACH times the upper end of the range; chosen */
#define LACKS 0.02       /* largest part of the static response to the load that a basis lacks;
                          * chosen */
#define LONG 0.2         /* largest step of a curve for comparison, relative to the range; chosen */
#define REACH 2.0        /* 2: the second harmonic of the response may be in resonance with them */

/* Numbers of functions per component, in the order in which they are tried. */
static const int bases[] = {6, 8, 10, 12, 14, 16, 20, 24};
enum { BASES = sizeof bases/sizeof *bases };

/* Relative error of the frequency of candidate j in the full-order model; 1: the model has no such
 * mode. */
static double frequency_error(const struct hawser_accuracy *a, int j)
{
	const struct hawser_rom *full = &a->rom;

	for (int i = 0; i < full->n; i++)
		if (strcmp(full->label[i], a->choice.all.label[j]) == 0)
			return fabs(sqrt(full->K[i*(full->n + 1)])/a->modes.mode[j].omega - 1.0);
	return 1.0;
}

static int resolves_modes(const struct hawser_accuracy *a)
{
	for (int j = 0; j < a->choice.n; j++) {
		double omega = a->modes.mode[j].omega, to = a->choice.to;

		if (omega <= REACH*to &&
		    frequency_error(a, j) > (omega <= to ? RESOLVED : ROUGHLY)*a->asked)
			return 0;
	}
	return 1;
}

/* Whether the basis of the model holds the linear modes and the load. */
static enum hawser_status resolves(int *good, const struct hawser_accuracy *a,
                                   const struct hawser_scene *scene, int functions,
                                   struct hawser_report *report)
{
	double lacks = 0.0;
	enum hawser_status status = HAWSER_OK;

	*good = resolves_modes(a);
	if (*good)
		status = hawser_rom_full_lacks(&lacks, &a->modes.statics, scene, functions, report);
	*good &= lacks <= LACKS;
	return status;
}

/* In harmonic balance, the tolerance limits the error of every orbit, which is larger than that of
 * folds and peaks. A larger tolerance is therefore sufficient. */
static struct hawser_frf_options settle(const struct hawser_accuracy_options *options,
                                        double accuracy)
{
	struct hawser_frf_options frf = hawser__accuracy_settle(options, accuracy);

	if (options->frf.tolerance == 0.0)
		frf.tolerance = fmin(fmax(1e-3*accuracy, FINEST), 1e-6);
	return frf;
}

/* No model reached the accuracy: fail with the reason of the last model. */
static enum hawser_status lost(const struct hawser_accuracy *a, struct hawser_report *report)
{
	struct hawser_report last;

	if (!report)
		return HAWSER_ERR_CONVERGENCE;
	last = *report;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "accuracy", last.iteration,
	                       last.residual, "an accuracy of %g is not reached with condensed models, "
	                       "and the full-order one that was to replace them fails: %s", a->asked,
	                       last.message);
}

/* Decide what follows a trace that failed because the basis is too small for the motion, or the
 * tolerance too large. Returns 1 to go on, with the next basis or with a smaller tolerance and the
 * same basis. */
static int retry(enum hawser_status status, int *i, struct hawser_frf_options *frf,
                 const struct hawser_accuracy_options *options)
{
	if (status != HAWSER_ERR_CONVERGENCE)
		return 0;
	if (options->frf.tolerance == 0.0 && frf->tolerance > FINEST && bases[*i] >= MIDDLING) {
		frf->tolerance = FINEST;
		(*i)--;
		return 1;
	}
	return *i + 1 < BASES;
}

static enum hawser_status build(struct hawser_accuracy *a, const struct hawser_scene *scene,
                                int functions, struct hawser_report *report)
{
	hawser_rom_clear(&a->rom);
	return hawser_rom_build_full(&a->rom, &a->modes.statics, scene, functions, report);
}

/* The next basis that has more coordinates: its curve is traced with long steps and without
 * multipliers, and its distance from that of the last attempt, which *marks describes, is the result;
 * infinite if it has none. */
static enum hawser_status check(struct hawser_accuracy *a, const struct hawser__marks *marks,
                                const struct hawser_scene *scene, int i, int most,
                                const struct hawser_frf_options *traced, struct hawser_report *report)
{
	struct hawser_accuracy_try *this = &a->attempt[a->tries - 1];
	struct hawser_frf_options frf = *traced;
	struct hawser__drawn_curve curve = {.points = 0};
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf found = {.points = 0};
	double start = hawser__wall_seconds();
	enum hawser_status status = HAWSER_OK;

	while (!status && rom.n <= a->rom.n && ++i < BASES && bases[i] <= most) {
		hawser_rom_clear(&rom);
		status = hawser_rom_build_full(&rom, &a->modes.statics, scene, bases[i], report);
	}
	if (status || rom.n <= a->rom.n) {
		hawser_rom_clear(&rom);
		return status;
	}
	frf.unjudged = frf.skip_events = 1;
	frf.samples = HAWSER_NONE;
	frf.most_unstable = 0;
	frf.step_max = LONG;
	status = hawser_frf_trace(&found, &rom, &frf, report);
	this->moved = INFINITY;
	if (!status)
		status = hawser__curve_copy(&curve, &found, report);
	if (!status && found.end == a->frf.end)
		status = hawser__curve_distance(&this->moved, &marks->curve, &curve, report);
	if (status == HAWSER_ERR_CONVERGENCE)
		status = HAWSER_OK;
	this->checked = rom.n;
	this->seconds += hawser__wall_seconds() - start;
	hawser__curve_clear(&curve);
	hawser_frf_clear(&found);
	hawser_rom_clear(&rom);
	return status;
}

enum hawser_status hawser__accuracy_full(struct hawser_accuracy *a, struct hawser__marks *marks,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	struct hawser_frf_options frf = settle(options, a->asked);
	enum hawser_status status = HAWSER_OK;
	int tried = 0; /* coordinates of the last model with a response */
	int most = options->most_functions > 0 ? options->most_functions : INT_MAX;
	/* the largest basis of all is tried whatever it resolves */
	int last = options->most_functions > 0 ? INT_MAX : BASES;

	for (int i = 0; !status && i < BASES && a->tries < HAWSER_ACCURACY_TRIES; i++) {
		struct hawser_accuracy_try *this;
		int good = 0;

		if (bases[i] > most)
			break;
		status = build(a, scene, bases[i], report);
		if (!status)
			status = resolves(&good, a, scene, bases[i], report);
		if (status || a->rom.n <= tried || (!good && i + 1 < last))
			continue;
		status = hawser__accuracy_attempt(a, marks, scene, bases[i], &frf, report);
		if (retry(status, &i, &frf, options)) {
			status = HAWSER_OK;
			continue;
		}
		if (status || hawser__accuracy_cut(a))
			break;
		tried = a->rom.n;
		this = &a->attempt[a->tries - 1];
		if (!(SAFETY_BASIS*this->moved <= a->asked))
			status = check(a, marks, scene, i, most, &frf, report);
		if (isfinite(this->moved))
			hawser__accuracy_claim(a, SAFETY_BASIS*this->moved, marks);
		if (isfinite(this->moved) && a->estimated <= a->asked)
			break;
	}
	return status == HAWSER_ERR_CONVERGENCE ? lost(a, report) : status;
}

enum hawser_status hawser_accuracy_exact(struct hawser_accuracy *accuracy,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	double start = hawser__wall_seconds();
	struct hawser__marks marks = {0};
	enum hawser_status status = hawser__accuracy_begin(accuracy, statics, scene, options, report);

	if (!status && accuracy->choice.exact.n == 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                      "an inextensible cable has no full-order model");
	if (!status)
		status = hawser__accuracy_full(accuracy, &marks, scene, options, report);
	accuracy->reached = accuracy->estimated <= accuracy->asked && !hawser__accuracy_cut(accuracy);
	accuracy->seconds = hawser__wall_seconds() - start;
	hawser__marks_clear(&marks);
	return status;
}
