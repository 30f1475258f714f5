/* study/map_doubt.c - how far from its bracket a boundary may lie.
 *
 *   c   least growth that counts, less its error, at the end with more instabilities
 *   u   most growth that does not count, plus its error, at the other end
 *
 * Growth is counted beyond what may be round-off, and is not known exactly; a boundary of stability is
 * where it is 0. A bracket with u <= 0 < c is beyond doubt. The root finder may well end at one that is
 * not, since it looks for where the count changes: the line through both ends then says where growth
 * is 0, whatever the errors are. It does so too near the tip of a tongue, where growth bends towards
 * the axis and the line is on the safe side. Of all the brackets on the way to the last, the one
 * that says most is taken: a last one whose ends differ by less than their errors says nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "study/map.h"

#define FURTHEST 1e6 /* edges: beyond that a line says nothing */

/* 0 where nothing is known of growth, and the bracket is all there is. *more: the end with more. */
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

/* Where growth is 0 between or beyond the ends, as a range of places; 0 where errors hide how it
 * changes. */
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
