/* response/backbone/backbone_branch.c - see backbone.h; the end of a backbone's memory.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "continuation/false_position.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/backbone/backbone.h"

static const char where[] = "backbone";

#define SAME 1e-4  /* relative difference of branch points that are one; chosen */
/* Pivot, where rows of the whole derivative have the length 1: singular all along the curve, as where
 * planes are equal; larger than the error of integration, chosen. */
#define NOTHING 1e-6
#define CLOSE 1e-6 /* width of the bracket of a branch point, relative to the step; chosen */
#define BESIDE 1e-4 /* the same in the motion's own class: nearer to it, corrections are round-off
                     * divided by a small pivot; chosen */

enum { MOST = 40 }; /* tries for a branch point */

static enum hawser_status add(struct hawser_backbone *to, const double *start,
                              const double *direction, const int *sign, double energy, int turned,
                              struct hawser_report *report)
{
	size_t size = (size_t)to->n + 1, at = (size_t)to->branches;

	if (hawser__more(&to->branch, to->branches, sizeof *to->branch) ||
	    hawser__more(&to->branch_start, to->branches, size*sizeof *to->branch_start) ||
	    hawser__more(&to->branch_direction, to->branches, size*sizeof *to->branch_direction) ||
	    hawser__more(&to->branch_sign, to->branches, size*sizeof *to->branch_sign))
		return hawser__no_memory(report, where);
	to->branch[at] = (struct hawser_backbone_branch){start[to->n], energy, to->points - 1, turned};
	memcpy(to->branch_start + at*size, start, size*sizeof *start);
	memcpy(to->branch_direction + at*size, direction, size*sizeof *direction);
	memcpy(to->branch_sign + at*(size - 1), sign, (size - 1)*sizeof *sign);
	to->branches++;
	return HAWSER_OK;
}

static void evaluate(struct hawser__free_walk *walk, int e, double least, double *to)
{
	double value;

	if (e == 0) {
		to[1] = hawser__half_determinant(&walk->half, &to[0]);
		return;
	}
	value = hawser__half_class_determinant(&walk->half, (e + 1)/2, e % 2 == 0, least);
	to[0] = (value > 0.0) - (value < 0.0);
	to[1] = value != 0.0 ? log(fabs(value)) : 0.0;
}

void hawser__free_events(struct hawser__free_walk *walk, double *event)
{
	for (int e = 0; e < (walk->options->branches ? walk->events : 1); e++)
		evaluate(walk, e, NOTHING, event + 2*(size_t)e);
}

/* at = the point at the share s of the step, by interpolation; at_t its tangent. */
static void interpolate(struct hawser__free_walk *walk, double s)
{
	const struct hawser__node from = {walk->y, walk->t}, to = {walk->next, walk->next_t};
	const struct hawser__metric metric = hawser__orbit_metric(&walk->half.base);

	hawser__curve_between(walk->at, walk->at_t, &from, &to, s, &metric);
}

/* The same, corrected; *value: its determinant, relative. Where the kernel has two dimensions, the
 * system has no tangent of its own, and at_t remains the interpolated one. */
static enum hawser_status between(struct hawser__free_walk *walk, int e, double s, double *value,
                                  int *failed)
{
	struct hawser__correction correction;
	double to[2];
	enum hawser_status status;

	interpolate(walk, s);
	status = hawser__free_correct(walk, walk->at, walk->at_t, &correction, failed, walk->report);
	if (status || *failed)
		return status;
	evaluate(walk, e, 0.0, to);
	*value = to[0]*exp(fmin(to[1] - walk->event[2*e + 1], 600.0));
	return HAWSER_OK;
}

static int is_known(const struct hawser__free_walk *walk, double omega, double energy)
{
	for (int i = 0; i < walk->options->known_count; i++)
		if (fabs(walk->options->known[2*i]/omega - 1.0) < SAME &&
		    fabs(walk->options->known[2*i + 1]/energy - 1.0) < SAME)
			return 1;
	return 0;
}

/* What begins at `at` has the opposite signs in class c: flip [n]. Another class that is at rest
 * there may have any. */
static enum hawser_status turned_signs(struct hawser__free_walk *walk, int c, int *flip)
{
	const struct hawser__half *half = &walk->half;
	int j = 0, none = 0;
	enum hawser_status status;

	while (half->class_of[j] != c)
		j++;
	for (int k = 0; k < half->base.n; k++)
		walk->member[k] = half->class_of[k] == 0;
	status = hawser__signs_flip(&walk->signs, walk->member, j, flip, &none, walk->report);
	return status || !none ? status : hawser__fail(walk->report, HAWSER_ERR_PROGRAM, where,
	                                               "class %d of coordinates has no reflection", c);
}

static enum hawser_status add_branch(struct hawser__free_walk *walk, int e)
{
	struct hawser__half *half = &walk->half;
	int n = walk->backbone->n, c = (e + 1)/2, turned = e > 0 && e % 2 == 0;
	int *sign = malloc((size_t)n*sizeof *sign);
	double energy;
	enum hawser_status status = HAWSER_OK;

	if (!sign)
		return hawser__no_memory(walk->report, where);
	hawser__half_state(half, half->x, walk->at);
	energy = hawser_rom_energy(&half->model, half->x, half->x + n);
	if (is_known(walk, walk->at[n], energy)) {
		walk->met = 1;
		free(sign);
		return HAWSER_OK;
	}
	for (int k = 0; k < n; k++)
		sign[k] = 1;
	if (turned)
		status = turned_signs(walk, c, sign);
	for (int k = 0; k < n; k++)
		sign[k] *= half->sign[k];
	if (!status)
		status = e > 0 ? hawser__half_class_other(half, walk->other, c, turned, walk->report)
		               : hawser__half_other(half, walk->other, walk->at_t, walk->report);
	if (!status)
		status = add(walk->backbone, walk->at, walk->other, sign, energy, turned, walk->report);
	free(sign);
	return status;
}

/* The branch point in the step: the determinant with the tangent changes its sign. Near one of the own
 * class the system is nearly singular: the zero is that of the line through the bracket. */
static enum hawser_status find_branch(struct hawser__free_walk *walk, int e)
{
	struct hawser__bracketed in = {.a = 0.0, .b = 1.0, .fa = walk->event[2*e]};
	double value = 0.0, s = 0.5;
	int failed = 0;
	enum hawser_status status = HAWSER_OK;

	in.fb = walk->next_event[2*e]*exp(fmin(walk->next_event[2*e + 1] - walk->event[2*e + 1], 600.0));
	for (int i = 0; i < MOST && in.b - in.a > (e > 0 ? CLOSE : BESIDE) && !failed; i++) {
		s = hawser__false_position(&in, i);
		if ((status = between(walk, e, s, &value, &failed)))
			return status;
		for (int side = 0; failed && side < 2; side++) {
			s = in.a + (side ? 0.8 : 0.2)*(in.b - in.a);
			if ((status = between(walk, e, s, &value, &failed)))
				return status;
		}
		if (!failed && value == 0.0)
			break;
		if (!failed)
			hawser__false_position_take(&in, s, value);
	}
	interpolate(walk, failed || (e == 0 && value != 0.0) ? hawser__false_position(&in, 0) : s);
	if (!failed && e > 0) {
		struct hawser__correction correction;

		status = hawser__free_correct(walk, walk->at, walk->at_t, &correction, &failed, walk->report);
		if (status)
			return status;
	}
	walk->half.base.ops->defects(&walk->half.base, walk->at, 1);
	return add_branch(walk, e);
}

enum hawser_status hawser__free_branches(struct hawser__free_walk *walk, int *moved)
{
	enum hawser_status status = HAWSER_OK;

	*moved = 0;
	for (int e = 0; !status && e < walk->events; e++) {
		double *now = walk->event + 2*(size_t)e, *next = walk->next_event + 2*(size_t)e;

		if (now[0]*next[0] < 0.0) {
			*moved = 1;
			status = find_branch(walk, e);
		}
		if (next[0] != 0.0)
			memcpy(now, next, 2*sizeof *now);
	}
	return status;
}

void hawser_backbone_clear(struct hawser_backbone *backbone)
{
	if (!backbone)
		return;
	free(backbone->point);
	free(backbone->coordinate);
	free(backbone->probe);
	free(backbone->start);
	free(backbone->branch);
	free(backbone->branch_start);
	free(backbone->branch_direction);
	free(backbone->branch_sign);
	free(backbone->sign);
	memset(backbone, 0, sizeof *backbone);
}
