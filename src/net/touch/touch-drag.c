/* net/touch/touch-drag.c - linear equations of statics that are not symmetric: where nodes slide
 * friction follows the force r, and loads of the water follow the places.
 *
 * r     force of the obstacle along n, which a step d changes to r - k*(g + n.d)
 * drag  friction over r, along the surface: that of a node that slides is r*drag
 *
 * With k*n*n' the matrix has k*drag*n' as well, and is not symmetric. Without this term the
 * friction of a step is that of the last r, and the iteration has the ratio of what the tension
 * gives back to r and the friction: it was 0.57 for a cable that touches a floor with two of its
 * nodes, above 1 for others, and for a rope on a circle the errors are the terms of the series of
 * e^(friction*angle).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "net/motion/motion.h"
#include "net/touch/touch.h"
#include "net/water/water.h"

/* The matrix of hawser__net_factor, with what is not symmetric. */
static void assemble(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	const double damp[2] = {0.5*work->damp, 0.0}; /* of both elements of a node */

	hawser__klu_zero(work->klu);
	for (int i = 0; i < mesh->elements; i++) {
		const double *e = work->e[i];
		double B[9];

		for (int k = 0; k < 9; k++)
			B[k] = work->b[i]*e[k/3]*e[k%3] + (k%4 == 0 ? work->a[i] : 0.0);
		hawser__klu_element(work->klu, i, B, damp);
	}
	if (mesh->water && mesh->water->follows)
		hawser__water_matrix(work->klu, mesh);
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		double block[3][3];

		if (!(touch->stiff > 0.0))
			continue;
		for (int k = 0; k < 9; k++)
			block[k/3][k%3] = touch->block[k/3][k%3] + touch->turn[k/3][k%3] +
			                  touch->stiff*touch->drag[k/3]*touch->n[k%3];
		hawser__klu_node(work->klu, touch->element, touch->end, block);
		hawser__touch_oval_matrix(work->klu, mesh, touch);
	}
}

enum hawser_status hawser__touch_divide(struct hawser__net_work *work, int *good,
                                        struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status = HAWSER_OK;
	int slides = mesh->water && mesh->water->follows;

	*good = 1;
	for (int i = 0; i < mesh->touches && !slides; i++) {
		const double *drag = mesh->touch[i].drag;

		slides = mesh->touch[i].stiff > 0.0 && (drag[0] != 0.0 || drag[1] != 0.0 || drag[2] != 0.0);
	}
	if (!slides)
		return hawser__sparse_solve(work->x, work->sparse, report);
	if (!work->klu)
		status = hawser__klu_open(&work->klu, mesh, report);
	if (status)
		return status;
	assemble(work);
	hawser__klu_forget(work->klu);
	return hawser__klu_divide(work->x, good, work->klu, report);
}
