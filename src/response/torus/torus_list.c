/* response/torus/torus_list.c - see hawser/torus.h: options, conditions and storage of a curve
 * of invariant circles. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/grow.h"
#include "core/names.h"
#include "core/report.h"
#include "response/torus/torus.h"
#include "rom/energy/kernel.h"

#define WHERE "tori"
#define KEEPS 1e-7 /* sum of the logarithms of multipliers that counts as none; chosen */

HAWSER__NAMES(hawser_tori_end_name, enum hawser_tori_end, "range", "torus-point", "max-points",
	"interrupted", "slack", "rough", "lost")

void hawser_tori_settle(struct hawser_tori_options *options)
{
	options->tolerance = options->tolerance > 0.0 ? options->tolerance : 1e-6;
	options->step_max = options->step_max > 0.0 ? options->step_max : 0.02;
	options->max_points = options->max_points > 0 ? options->max_points : 2000;
	options->most_circle = options->most_circle > 0 ? options->most_circle : 127;
}

int hawser__tori_room(struct hawser_tori *list, const struct hawser_rom *rom)
{
	size_t rows = (size_t)list->capacity + 64, n = (size_t)list->n, wide = 3*(size_t)list->probes;
	const size_t each = sizeof(double);

	if (list->points < list->capacity)
		return 0;
	if (hawser__resize(&list->point, rows, sizeof *list->point) ||
	    hawser__resize(&list->coordinate_least, rows*n, each) ||
	    hawser__resize(&list->coordinate_most, rows*n, each) ||
	    hawser__resize(&list->probe_least, rows*wide, each) ||
	    hawser__resize(&list->probe_most, rows*wide, each) ||
	    hawser__resize(&list->state, 2*rows*n, each) ||
	    (hawser__rom_tension_places(rom) > 0 && hawser__resize(&list->tension, 2*rows, each)))
		return 1;
	list->capacity = (int)rows;
	return 0;
}

void hawser_tori_clear(struct hawser_tori *tori)
{
	if (!tori)
		return;
	free(tori->point);
	free(tori->coordinate_least);
	free(tori->coordinate_most);
	free(tori->probe_least);
	free(tori->probe_most);
	free(tori->tension);
	free(tori->state);
	*tori = (struct hawser_tori){.n = 0};
}

/* Whether no orbit of the response loses or gains volume: its circles are not isolated then. At a torus
 * point alone the two multipliers say nothing. */
static int undamped(const struct hawser_frf *frf)
{
	double most = 0.0;

	for (int i = 0; i < frf->points; i++) {
		double sum = 0.0;

		for (int k = 0; k < 2*frf->n; k++)
			sum += frf->multiplier[4*(size_t)i*(size_t)frf->n + 2*(size_t)k];
		most = fmax(most, fabs(sum));
	}
	return most < KEEPS;
}

enum hawser_status hawser__tori_check(const struct hawser_rom *rom, const struct hawser_frf *frf,
                                      int event, const struct hawser_tori_options *options,
                                      struct hawser_report *report)
{
	const struct hawser_frf_event *at = event >= 0 && event < frf->events ? &frf->event[event] : NULL;
	const char *why = options->family && options->family->omega == 0.0
	                  ? "nothing excites it, and its cycles have no period map"
	                  : rom->first ? "it is of first order"
	                  : rom->ramp ? "its speed changes once and for all (travel.braking)"
	                  : rom->history ? "it is moved or loaded by a table over time"
	                  : undamped(frf) ? "the model has no damping, so that circles are not isolated"
	                  : frf->period != hawser__rom_periods(rom)
	                  ? "the branch's motions have several periods of the load" : NULL;

	if (why)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE, "no tori of this response: %s", why);
	if (rom->periods > 1)
		return hawser__periods_refuse(rom, "the search for tori", report);
	if (!at || at->kind != HAWSER_TORUS || !at->located)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "event %d begins no tori: a torus point that was located does", event);
	if (!(fabs(options->to - options->from) > 0.0) || !isfinite(options->to - options->from) ||
	    (!options->family && !(fmin(options->from, options->to) > 0.0)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the range of Omega from %g to %g: it must be positive and not empty",
		                    options->from, options->to);
	if (HAWSER_TORUS_NUMBERS/(2*rom->n) < HAWSER_TORUS_FIRST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "no tori of a model with %d coordinates: a circle of %d points or more has "
		                    "at most %d numbers; use fewer modes (model.modes)", rom->n,
		                    HAWSER_TORUS_FIRST,
		                    HAWSER_TORUS_NUMBERS);
	return HAWSER_OK;
}
