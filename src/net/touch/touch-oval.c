/* net/touch/touch-oval.c - friction of a plane that moves under cables which it holds less along
 * themselves than across: the friction over r is in an ellipse, whose axes turn with the cable.
 *
 * v, s   velocity of the plane; direction of an element in the plane
 * a, b   coefficients along and across the element; a' = v.s
 * D      (b^2 v + (a^2 - b^2) a' s)/sqrt(b^2 v^2 + (a^2 - b^2) a'^2)
 *
 * D is where the ellipse has the outward normal v, so that no other friction takes more power, and
 * the set is convex. A node has the mean of both its elements.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/vec3.h"
#include "net/motion/motion.h"
#include "net/touch/touch.h"

/* D of an element, and unless NULL its derivative by the vector along the element. */
static void one(double D[3], double (*by)[3], const struct hawser__touch *touch, const double v[3],
                const double d[3])
{
	const struct hawser_surface *surface = touch->surface;
	const double across = surface->friction*surface->friction;
	const double more = surface->axial*surface->axial - across, *n = touch->n;
	double s[3], off = hawser__dot(d, n), l, along, size;

	for (int k = 0; k < 3; k++)
		s[k] = d[k] - off*n[k];
	l = hawser__norm(s);
	for (int k = 0; k < 3; k++)
		s[k] = l > 0.0 ? s[k]/l : 0.0;
	along = hawser__dot(v, s);
	size = sqrt(across*hawser__dot(v, v) + more*along*along);
	for (int k = 0; k < 3; k++)
		D[k] = (across*v[k] + more*along*s[k])/size;
	/* ds = (I - n n' - s s') dd/l */
	for (int i = 0; by && i < 3; i++)
		for (int j = 0; j < 3; j++) {
			double sum = 0.0;

			for (int k = 0; k < 3; k++) {
				double ds = ((k == j) - n[k]*n[j] - s[k]*s[j])/l;
				double D_s = more/size*(s[i]*v[k] + (i == k ? along : 0.0) - D[i]*along*v[k]/size);

				sum += l > 0.0 ? D_s*ds : 0.0;
			}
			by[i][j] = sum;
		}
}

static double part_of(double D[3], double (*by)[3], const struct hawser__mesh *mesh,
                      const struct hawser__touch *touch, const double v[3], int element)
{
	const double *a = mesh->q[mesh->end[element][0]], *b = mesh->q[mesh->end[element][1]];

	one(D, by, touch, v, (const double[3]){b[0] - a[0], b[1] - a[1], b[2] - a[2]});
	return touch->other < 0 ? 1.0 : 0.5;
}

void hawser__touch_oval(double D[3], const struct hawser__mesh *mesh, const struct hawser__touch *touch,
                        const double v[3])
{
	const int element[2] = {touch->element, touch->other};
	double own[3];

	memset(D, 0, 3*sizeof *D);
	for (int i = 0; i < 2 && element[i] >= 0; i++) {
		double part = part_of(own, NULL, mesh, touch, v, element[i]);

		for (int k = 0; k < 3; k++)
			D[k] += part*own[k];
	}
}

void hawser__touch_oval_matrix(struct hawser__klu *klu, const struct hawser__mesh *mesh,
                               const struct hawser__touch *touch)
{
	const int element[2] = {touch->element, touch->other};
	double v[3], own[3], by[3][3];

	if (!(touch->surface->axial > 0.0) || !(touch->r > 0.0))
		return;
	hawser_surface_velocity(v, touch->surface, mesh->q[touch->node]);
	for (int i = 0; i < 2 && element[i] >= 0; i++) {
		double block[6][6] = {{0.0}}, part = part_of(own, by, mesh, touch, v, element[i]);
		int row = 3*(mesh->end[element[i]][1] == touch->node);

		for (int k = 0; k < 9; k++) {
			block[row + k/3][k%3] = -by[k/3][k%3];
			block[row + k/3][3 + k%3] = by[k/3][k%3];
		}
		hawser__klu_ends(klu, element[i], (const double (*)[6])block, -part*touch->r);
	}
}
