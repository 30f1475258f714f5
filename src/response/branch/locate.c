/* response/branch/locate.c - see locate.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "response/branch/bracket.h"
#include "response/branch/event_error.h"
#include "response/branch/locate.h"

#define ZERO 1e-3   /* largest |f| at a zero, relative to the ends of the bracket; at a pole f does
                     * not become small; chosen */

int hawser__event_width(enum hawser_event_kind kind)
{
	return kind == HAWSER_TORUS ? 2 : kind == HAWSER_UNEXPLAINED ? 0 : 1;
}

/* Whether the multiplier that was followed to the unit circle is there what an event of this kind
 * has: one at -1 or 1, or a complex pair. Where a bracket has two events, the test function of one
 * may change its sign while the modulus of the other is followed. */
static int is_claimed(const struct hawser__bracket *bracket)
{
	const struct hawser__station *at = bracket->at;
	double angle, error;

	if (bracket->watched < 0)
		return 1;
	angle = fabs(at->argument[bracket->watched]);
	error = at->bound[bracket->watched];
	return bracket->kind == HAWSER_PERIOD_DOUBLING ? angle >= M_PI - error
	       : bracket->kind == HAWSER_BRANCH_POINT ? angle <= error : angle > 0.0 && angle < M_PI;
}

enum hawser_status hawser__locate(struct hawser_frf_event *event, int *found,
                                  struct hawser__orbit *orbit,
                                  struct hawser__station *scratch,
                                  const struct hawser__station *a, const struct hawser__station *b,
                                  enum hawser_event_kind kind, int sure, double orbit_tolerance,
                                  double tolerance, struct hawser_report *report)
{
	struct hawser__bracket bracket;
	int last = orbit->size - 1;
	double s, f;
	enum hawser_status status = hawser__bracket_init(&bracket, orbit, scratch, a, b, kind,
	                                                  sure, report);

	bracket.tolerance = orbit_tolerance;
	if (!status)
		status = hawser__bracket_zero(&bracket, &s, &f, tolerance, report);
	if (!status) {
		/* a sure test function is discontinuous where a multiplier leaves its error bound, and has
		 * no poles */
		*found = !bracket.several && (bracket.sure || fabs(f) < ZERO) && is_claimed(&bracket) &&
		         (kind != HAWSER_TORUS || hawser__station_torus(a, b, scratch, bracket.sure));
		*event = (struct hawser_frf_event){.kind = kind, .omega = scratch->y[last],
			.arc = a->arc + s*(b->arc - a->arc), .residual = fabs(f)};
		if (*found)
			status = hawser__event_error(&event->error, &bracket, s, f, report);
	}
	hawser__bracket_clear(&bracket);
	return status;
}
