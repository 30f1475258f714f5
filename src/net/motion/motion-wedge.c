/* net/motion/motion-wedge.c - a node that a surface which moves draws into the wedge of two obstacles.
 *
 * n, m  normals of the two contacts
 * f, g  their forces over the normal parts: friction of a surface that moves is along its
 *       velocity, and that of one at rest holds the node back as much as it can
 *
 * Forces a*f + b*g, a >= 0 and b >= 0, hold a node against a drive into the wedge as those along n
 * and m do if the turn from f to g is that from n to m. With more friction of the moving surface
 * than tan(angle of the wedge + atan(friction of the other)) it is the opposite one: the larger the
 * forces, the more they draw, and a step with rigid obstacles has no solution, however short it is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "net/motion/motion-contact.h"

/* The force of a contact that slides, over its normal part, along x and y; of one at rest against
 * `to`, the direction in which the node is drawn. */
static double pushes(double f[2], const struct hawser__motion *motion, int number, const double to[2])
{
	const struct hawser_contact *contact = &motion->contact->contact[number];
	const struct hawser_surface *surface = motion->mesh->touch[motion->contact->which[number]].surface;
	const double *n = contact->normal, *t = contact->tangent[0];
	double at[3], v[3], along, sign;

	for (int k = 0; k < 3; k++)
		at[k] = motion->reference[contact->node][k] + motion->u[contact->node][k];
	hawser_surface_velocity(v, surface, at);
	along = v[0]*t[0] + v[1]*t[1];
	sign = along != 0.0 ? along : -(to[0]*t[0] + to[1]*t[1]);
	for (int k = 0; k < 2; k++)
		f[k] = n[k] + copysign(surface->friction, sign)*t[k];
	return along;
}

void hawser__contact_wedged(struct hawser__motion *motion)
{
	struct hawser__motion_contact *all = motion->contact;

	for (int c = 0; c + 1 < all->candidates; c++) {
		const double *n = all->contact[c].normal, *m = all->contact[c + 1].normal;
		double turn = n[0]*m[1] - n[1]*m[0], f[2], g[2];
		int moves = 0;

		if (all->contact[c].node != all->contact[c + 1].node || n[2] != 0.0 || m[2] != 0.0)
			continue;
		moves += pushes(f, motion, c, (const double[2]){0.0}) != 0.0;
		moves += pushes(g, motion, c + 1, f) != 0.0;
		(void)pushes(f, motion, c, g);
		if (!moves || turn*(f[0]*g[1] - f[1]*g[0]) > 0.0)
			continue;
		(void)hawser__fail(&all->refusal, HAWSER_ERR_NO_SOLUTION, "net", "at %.6g s the friction of a "
		                   "surface that moves draws a node between the obstacles %s and %s, which "
		                   "meet there at %.3g degrees, with forces that nothing balances: give the "
		                   "surface less friction than tan(this angle + atan(friction of the other "
		                   "obstacle)), or leave room between the obstacles", motion->t,
		                   motion->mesh->touch[all->which[c]].surface->name,
		                   motion->mesh->touch[all->which[c + 1]].surface->name,
		                   57.29577951308232*asin(fmin(fabs(turn), 1.0)));
		return;
	}
}
