/* study/accuracy_full.c - full-order models of growing bases, for an accuracy that no condensed model
 * reaches.
 *
 * No mode makes up for the terms of the energy that a condensed model lacks. A full-order model has
 * them all; its error is that of its basis. The error falls so fast that what the last basis moved is
 * mostly far more than what it lacks. Where a harmonic of the response meets a high mode, which only
 * a large basis has at the right frequency, moves of one size follow each other (B Table 4.4, line 2:
 * 1.2e-4 from 12 functions to 14, 1.5e-4 from 14 to 16). So the estimate is a multiple of the move.
 *
 * Two bases that do not resolve the linear modes of the range agree on nothing. Such a basis is passed
 * over without a response. The first that is traced is compared with the last condensed model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "core/report.h"
#include "study/accuracy.h"

#define SAFETY_BASIS 3.0 /* bench/accuracy.c calibrates it */
#define FINEST 1e-9      /* tolerance of orbits */
#define MIDDLING 12      /* functions a component, from which on a failure may be the tolerance's */
#define RESOLVED 0.1     /* of the accuracy: largest error of the frequencies in the range, */
#define ROUGHLY 1.0      /* and of those up to REACH times its upper end, which the second harmonic */
#define REACH 2.0        /* meets */

/* Functions a component. */
static const int bases[] = {6, 8, 10, 12, 14, 16, 20, 24};
enum { BASES = sizeof bases/sizeof *bases };

/* Relative error of the frequency of candidate j in the full-order model; 1: it has no such mode. */
static double frequency_error(const struct hawser_accuracy *a, int j)
{
	const struct hawser_rom *full = &a->rom;

	for (int i = 0; i < full->n; i++)
		if (strcmp(full->label[i], a->choice.all.label[j]) == 0)
			return fabs(sqrt(full->K[i*(full->n + 1)])/a->modes.mode[j].omega - 1.0);
	return 1.0;
}

static int resolves(const struct hawser_accuracy *a)
{
	for (int j = 0; j < a->choice.n; j++) {
		double omega = a->modes.mode[j].omega, to = a->choice.to;

		if (omega <= REACH*to &&
		    frequency_error(a, j) > (omega <= to ? RESOLVED : ROUGHLY)*a->asked)
			return 0;
	}
	return 1;
}

/* Harmonic balance bounds the error of folds and peaks, not of the orbit's ends: a coarser tolerance
 * does. */
static struct hawser_frf_options settle(const struct hawser_accuracy_options *options,
                                        double accuracy)
{
	struct hawser_frf_options frf = hawser__accuracy_settle(options, accuracy);

	if (options->frf.tolerance == 0.0)
		frf.tolerance = fmin(fmax(1e-3*accuracy, FINEST), 1e-6);
	return frf;
}

/* No model reached the accuracy: fail with the reason of the last. */
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

/* A basis that is too small for the motion, or a tolerance that is too coarse for it, ends a trace
 * early. Returns 1 to go on, with the next basis or with a finer tolerance on the same. */
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

enum hawser_status hawser__accuracy_full(struct hawser_accuracy *a, struct hawser__marks *marks,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	struct hawser_frf_options frf = settle(options, a->asked);
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; !status && i < BASES && a->tries < HAWSER_ACCURACY_TRIES; i++) {
		double moved;

		status = build(a, scene, bases[i], report);
		if (status || (!resolves(a) && i + 1 < BASES))
			continue;
		/* the first is there to be compared with: its points need no second method */
		frf.samples = marks->curve.points > 0 ? options->frf.samples : HAWSER_NONE;
		status = hawser__accuracy_attempt(a, marks, scene, bases[i], &frf, report);
		if (retry(status, &i, &frf, options)) {
			status = HAWSER_OK;
			continue;
		}
		if (status || hawser__accuracy_cut(a))
			break;
		moved = a->attempt[a->tries - 1].moved;
		if (isfinite(moved))
			hawser__accuracy_claim(a, SAFETY_BASIS*moved, marks);
		if (isfinite(moved) && a->estimated <= a->asked)
			break;
	}
	return status == HAWSER_ERR_CONVERGENCE ? lost(a, report) : status;
}
