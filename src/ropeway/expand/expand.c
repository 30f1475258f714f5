/* ropeway/expand/expand.c - the energy of a rope over sheaves to fourth order in given shapes.
 *
 *   a, b, c    slopes of the shapes along the tangent, the normal and z
 *   g, eps     |x'| of the statics; unit of force/EA
 *   u          displacement along the circle, on arcs
 *
 * Free rope: V3 = a (b^2 + c^2)/(2 g^2 eps), V4 = [(b^2 + c^2)^2/8 - a^2 (b^2 + c^2)/2]/(g^3 eps),
 * as in any span. On a circle the strain is linear in u, so that the weight alone has terms of
 * third and of fourth order. The ends of the free rope have the terms of expand_ends.c. The rest
 * of the rope follows statically (expand_follow.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/report.h"
#include "ropeway/expand/expand.h"

/* Of the free rope. */
static double free_third(const struct hawser__lexpand *t, int j, int k, int l)
{
	const double *x = t->slope + 3*(size_t)t->points*(size_t)j;
	const double *y = t->slope + 3*(size_t)t->points*(size_t)k;
	const double *z = t->slope + 3*(size_t)t->points*(size_t)l;
	double sum = 0.0;

	for (int p = 0; p < t->points; p++, x += 3, y += 3, z += 3)
		sum += t->weight[p]/(t->stretch[p]*t->stretch[p]*t->epsilon[p])*hawser__third_at(x, y, z);
	return sum;
}

/* Of the weight on arcs: the derivative of order count, 3 or 4. */
static double arcs(const struct hawser__lexpand *t, const int *index, int count)
{
	int own = t->shape[index[0]].system;
	const struct hawser__lmode_system *system = &t->rope->system[own];
	double sum = 0.0;

	for (int i = 1; i < count; i++)
		if (t->shape[index[i]].system != own)
			return 0.0;
	for (int i = 0; i < system->segments; i++) {
		const struct hawser__lmode_segment *s = &system->segment[i];

		for (int p = 0; s->arc && system->plane == HAWSER_IN_PLANE && p < s->grid.points; p++) {
			double derivative[2], value = s->grid.weight[p];

			hawser__lexpand_arc(derivative, t, s, p);
			for (int k = 0; k < count; k++)
				value *= t->shape[index[k]].x[s->at + p];
			sum += derivative[count - 3]*value;
		}
	}
	return sum;
}

static double third(const void *of, int j, int k, int l)
{
	const struct hawser__lexpand *t = of;
	const int index[3] = {j, k, l};

	return free_third(t, j, k, l) + arcs(t, index, 3) + hawser__lexpand_ends_third(t, j, k, l);
}

double hawser__lexpand_fourth(const struct hawser__lexpand *t, const int index[4])
{
	return arcs(t, index, 4) + hawser__lexpand_ends_fourth(t, index) +
	       hawser__pairings(t->pairing, t->pairs, index);
}

static enum hawser_status check(const struct hawser__lexpand *t, struct hawser_report *report)
{
	const struct hawser__lmode *rope = t->rope;

	if (rope->options.contact == HAWSER_LINE_ROLL || rope->options.loose || rope->options.printed)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "the nonlinear model is of a "
		                    "rope that slips or sticks in the grooves of its sheaves: contact roll, "
		                    "loose and printed are for modes only");
	if (rope->nu != 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "the rope runs at %g m/s: the "
		                    "nonlinear model is of a rope without speed, set it to 0",
		                    rope->lane[0]->line->speed);
	for (int i = 0; i < rope->systems; i++)
		if (rope->system[i].circulates)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "the loop circulates freely, "
			                    "which is no small motion: hold it at its drive");
	return HAWSER_OK;
}

enum hawser_status hawser__lexpand_open(struct hawser__lexpand *t, struct hawser__lmode *rope,
                                        const struct hawser__lexpand_shape *shape, int n, int held,
                                        struct hawser_report *report)
{
	size_t count = (size_t)n, pairs = count*(count + 1)/2;
	enum hawser_status status;

	*t = (struct hawser__lexpand){.rope = rope, .shape = shape, .n = n, .pairs = (int)pairs,
	                              .held = held};
	status = check(t, report);
	if (status)
		return status;
	t->third = hawser__hold(&t->hold, count*count*count, sizeof *t->third);
	t->pairing = hawser__hold(&t->hold, pairs*pairs, sizeof *t->pairing);
	status = t->third && t->pairing ? hawser__lexpand_points(t, report)
	         : hawser__no_memory(report, "line rom");
	if (!status)
		status = hawser__third_fill(t->third, t->n, third, t, "line rom", report);
	if (!status)
		status = hawser__lexpand_follow(t, report);
	if (status)
		hawser__lexpand_clear(t);
	return status;
}

void hawser__lexpand_clear(struct hawser__lexpand *t)
{
	for (int i = 0; t->end && i < t->ends; i++)
		for (int f = 0; f < HAWSER__FORMS; f++)
			free(t->end[i].form[f]);
	for (int i = 0; t->mass && i < t->weights; i++)
		free(t->mass[i].u);
	free(t->second);
	hawser__hold_clear(&t->hold);
	*t = (struct hawser__lexpand){.rope = NULL};
}
