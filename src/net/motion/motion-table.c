/* net/motion/motion-table.c - elements of cables with a table of strains and tensions, in time steps.
 *
 * W is the energy of the table, T = dW/dp. The mean tension of a step is (W1 - W0)/(p1 - p0), as that
 * of a straight law, so that the ledger has the change of W exactly: the area under the straight pieces
 * between both stretches.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "net/motion/motion.h"

/* Tension at a strain, and its slope there, N. */
static double tension(double *slope, const struct hawser_net_cable *law, double strain)
{
	double from[2] = {0.0, 0.0};

	*slope = 0.0;
	if (!(strain > 0.0))
		return 0.0;
	for (int i = 0; i < law->rows; i++) {
		const double *to = law->law[i];

		*slope = (to[1] - from[1])/(to[0] - from[0]);
		if (strain <= to[0] || i + 1 == law->rows)
			break;
		from[0] = to[0];
		from[1] = to[1];
	}
	return from[1] + *slope*(strain - from[0]);
}

double hawser__table_tension(const struct hawser__motion_element *el, double p)
{
	double slope;

	return tension(&slope, el->law, el->offset + p/el->length);
}

double hawser__table_mean(double *slope, const struct hawser__motion_element *el, double p0, double p1)
{
	const struct hawser_net_cable *law = el->law;
	const double e0 = el->offset + p0/el->length, e1 = el->offset + p1/el->length;
	double low = fmin(e0, e1), high = fmax(e0, e1), at = low, area = 0.0, mean, own;
	double before = tension(&own, law, low), T1 = tension(&own, law, e1);

	*slope = 0.5*own/el->length;
	for (int i = -1; i < law->rows; i++) {
		double knot = i < 0 ? 0.0 : law->law[i][0], T = i < 0 ? 0.0 : law->law[i][1];

		if (!(knot > low && knot < high))
			continue;
		area += 0.5*(before + T)*(knot - at);
		at = knot;
		before = T;
	}
	if (at == low)
		return 0.5*(before + tension(&own, law, high));
	mean = (area + 0.5*(before + tension(&own, law, high))*(high - at))/(high - low);
	*slope = (T1 - mean)/(p1 - p0);
	return mean;
}
