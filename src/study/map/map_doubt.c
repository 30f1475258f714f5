/* study/map/map_doubt.c - how far from its bracket a boundary may lie.
 *
 *    c   smallest growth that counts, minus its error, at the end with more instabilities
 *    u   largest growth that does not count, plus its error, at the other end
 *
 * Growth counts only above a threshold for round-off, and it has an error. The stability boundary,
 * however, is where the growth is 0. A bracket with u <= 0 < c certainly contains the boundary. The
 * root finder may end with another bracket, since it searches for the change of the number. The
 * line through the values at both ends then gives the range in which the growth is 0, errors
 * included. This is on the safe side near the tip of a tongue, where the growth curve bends towards
 * the axis. Of all brackets on the way, the one with the smallest range is used: the last one may
 * have ends that differ by less than their errors, which give no information.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "study/map/map.h"

#define FURTHEST 1e6 /* widest range, in edges: beyond it, the line gives no information; chosen */

/* Returns 0 if no growth is known and only the bracket can be used. *more: the end with more
 * instabilities. */
static int growth(const struct hawser__mapper *mapper, const struct hawser__map_bracket *item,
                  double *c, double *u, int *more)
{
	const struct hawser_map_sample *a = hawser__map_sample(mapper, item->index[0]);
	const struct hawser_map_sample *b = hawser__map_sample(mapper, item->index[1]);

	if (!mapper->field->margins || a->code != HAWSER_MAP_OK || b->code != HAWSER_MAP_OK)
		return 0;
	*more = b->number > a->number;
	*c = hawser__map_marks(mapper, item->index[*more])[0];
	*u = hawser__map_marks(mapper, item->index[!*more])[1];
	return 1;
}

/* The range in which the growth is 0, between or outside the ends; returns 0 if errors hide the
 * slope. */
static int zero(const struct hawser__mapper *mapper, const struct hawser__map_bracket *item,
                double reach[2])
{
	double c, u, slope;
	int more;

	memcpy(reach, item->t, sizeof item->t);
	if (!growth(mapper, item, &c, &u, &more) || (u <= 0.0 && c > 0.0))
		return 1;
	slope = (c - u)/(item->t[1] - item->t[0]);
	reach[more] += (more ? 1.0 : -1.0)*fmax(-c, 0.0)/slope;
	reach[!more] += (more ? -1.0 : 1.0)*fmax(u, 0.0)/slope;
	return slope > 0.0 && reach[1] - reach[0] < FURTHEST;
}

void hawser__map_doubt(const struct hawser__mapper *mapper, struct hawser__map_bracket *item, int anew)
{
	double reach[2];
	int known = zero(mapper, item, reach);

	if (anew) {
		memcpy(item->reach, known ? reach : item->t, sizeof item->reach);
		item->known = known;
	} else if (known && (!item->known || reach[1] - reach[0] < item->reach[1] - item->reach[0])) {
		memcpy(item->reach, reach, sizeof item->reach);
		item->known = 1;
	}
}
