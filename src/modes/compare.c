/* modes/compare.c - how far modes are from reference modes of the same span.
 *
 * Partners are the i-th of a plane on either side: frequencies of the two planes cross freely, and
 * a method that misses a mode, or finds one too many, is wrong from there on, as it should be.
 *
 * Where reference frequencies of one plane lie within `together` of each other, an operator wrong by
 * a relative e turns their shapes by e over the gap: the space is determined, the shapes in it
 * hardly. Such modes are compared as a group, after the rotation that brings the two groups closest
 * (orthogonal Procrustes problem: with G = integral of Phi.Psi = U S V^T, it is U V^T). For a mode
 * alone this is the choice of its sign. The difference is formed point by point and then
 * integrated: from G it would come out of 2 - 2 G, with half of the digits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/grid.h"

static const double together = 1e-3;

struct work {
	const struct hawser_modes *modes, *reference;
	const struct hawser_grid *grid; /* of the reference */
	double *shape;  /* [group of modes][points][3] on that grid */
	double *turned; /* [points][3] */
	double *G, *U, *Vt, *S, *superb; /* for the group */
	int *own, *other; /* [group] indices of modes and of the reference's */
};

/* The mode of the reference that mode k has as its partner, or -1. */
static int partner(const struct hawser_modes *reference, const struct hawser_modes *modes, int k)
{
	int place = 0, i;

	for (i = 0; i < k; i++)
		place += modes->mode[i].plane == modes->mode[k].plane;
	for (i = 0; i < reference->n; i++)
		if (reference->mode[i].plane == modes->mode[k].plane && place-- == 0)
			return i;
	return -1;
}

/* The next one of the same plane, or -1. */
static int following(const struct hawser_modes *modes, int k)
{
	for (int i = k + 1; i < modes->n; i++)
		if (modes->mode[i].plane == modes->mode[k].plane)
			return i;
	return -1;
}

static int is_close(const struct hawser_modes *reference, int i, int j)
{
	return j >= 0 && reference->mode[j].omega - reference->mode[i].omega
	                 < together*reference->mode[i].omega;
}

/* The group that begins with mode k and its partner: *others of the reference, as many or fewer
 * of the modes. */
static int gather(struct work *w, int *others, int k, int first)
{
	int owns = 0;

	*others = 0;
	for (;;) {
		w->other[(*others)++] = first;
		if (k >= 0)
			w->own[owns++] = k;
		if (!is_close(w->reference, first, following(w->reference, first)))
			return owns;
		first = following(w->reference, first);
		k = k < 0 ? -1 : following(w->modes, k);
	}
}

static const double *reference_shape(const struct work *w, int i)
{
	return w->reference->shape + (size_t)w->other[i]*3*(size_t)w->grid->points;
}

static double product(const struct hawser_grid *grid, const double *x, const double *y)
{
	double sum = 0.0;

	for (int p = 0; p < grid->points; p++)
		sum += grid->weight[p]*(x[3*p]*y[3*p] + x[3*p + 1]*y[3*p + 1] + x[3*p + 2]*y[3*p + 2]);
	return sum;
}

/* Distance of own mode j from the turned shapes of the reference; U V^T is in G. */
static double distance(struct work *w, int j, int owns, int others)
{
	size_t size = 3*(size_t)w->grid->points;

	for (size_t i = 0; i < size; i++)
		w->turned[i] = w->shape[(size_t)j*size + i];
	for (int k = 0; k < others; k++) {
		const double *shape = reference_shape(w, k);
		double R = w->G[j + owns*k];

		for (size_t i = 0; i < size; i++)
			w->turned[i] -= R*shape[i];
	}
	return sqrt(product(w->grid, w->turned, w->turned));
}

/* G becomes U V^T. */
static int turn(struct work *w, int owns, int others)
{
	if (owns == 1 && others == 1) {
		w->G[0] = w->G[0] < 0.0 ? -1.0 : 1.0;
		return 1;
	}
	if (LAPACKE_dgesvd(LAPACK_COL_MAJOR, 'S', 'S', owns, others, w->G, owns, w->S, w->U, owns,
	                   w->Vt, owns, w->superb))
		return 0;
	for (int i = 0; i < owns; i++)
		for (int j = 0; j < others; j++) {
			double sum = 0.0;

			for (int k = 0; k < owns; k++)
				sum += w->U[i + owns*k]*w->Vt[k + owns*j];
			w->G[i + owns*j] = sum;
		}
	return 1;
}

static int compare_group(struct hawser_modes_error *error, struct work *w, int owns, int others)
{
	size_t size = 3*(size_t)w->grid->points;

	for (int j = 0; j < owns; j++)
		for (int p = 0; p < w->grid->points; p++)
			hawser_modes_at(w->modes, w->shape + (size_t)j*size + 3*p, NULL, w->own[j],
			                w->grid->s[p]);
	for (int j = 0; j < owns; j++)
		for (int k = 0; k < others; k++)
			w->G[j + owns*k] = product(w->grid, w->shape + (size_t)j*size,
			                           reference_shape(w, k));
	if (!turn(w, owns, others))
		return 0;
	for (int j = 0; j < owns; j++) {
		struct hawser_modes_error *e = error + w->own[j];
		double omega = w->reference->mode[w->other[j]].omega;

		e->partner = w->other[j];
		e->frequency = fabs(w->modes->mode[w->own[j]].omega - omega)/omega;
		e->shape = distance(w, j, owns, others);
	}
	return 1;
}

static void release(struct work *w)
{
	free(w->shape);
	free(w->turned);
	free(w->G);
	free(w->U);
	free(w->Vt);
	free(w->S);
	free(w->superb);
	free(w->own);
	free(w->other);
}

static int allocate(struct work *w)
{
	size_t most = (size_t)(w->reference->n > w->modes->n ? w->reference->n : w->modes->n);
	size_t size = 3*(size_t)w->grid->points;

	w->shape = calloc(most*size, sizeof *w->shape);
	w->turned = calloc(size, sizeof *w->turned);
	w->G = calloc(most*most, sizeof *w->G);
	w->U = calloc(most*most, sizeof *w->U);
	w->Vt = calloc(most*most, sizeof *w->Vt);
	w->S = calloc(most, sizeof *w->S);
	w->superb = calloc(most, sizeof *w->superb);
	w->own = calloc(most, sizeof *w->own);
	w->other = calloc(most, sizeof *w->other);
	return w->shape && w->turned && w->G && w->U && w->Vt && w->S && w->superb && w->own && w->other;
}

enum hawser_status hawser_modes_compare(struct hawser_modes_error *error,
                                        const struct hawser_modes *modes,
                                        const struct hawser_modes *reference,
                                        struct hawser_report *report)
{
	struct work w = {.modes = modes, .reference = reference, .grid = &reference->grid};
	enum hawser_status status = HAWSER_OK;

	if (fabs(modes->statics.l - reference->statics.l) > 1e-9*reference->statics.l)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "modes of different spans are compared: their scaled lengths are "
		                    "%.15g and %.15g", modes->statics.l, reference->statics.l);
	if (!allocate(&w)) {
		release(&w);
		return hawser__no_memory(report, "modes");
	}
	for (int k = 0; k < modes->n; k++)
		error[k] = (struct hawser_modes_error){.partner = -1};
	for (int k = 0; k < modes->n && !status; k++) {
		int others, owns, first = partner(reference, modes, k);

		if (error[k].partner >= 0)
			continue;
		if (first < 0) {
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
			                      "mode %d (%s) has no partner among the reference's %d modes: "
			                      "ask for more of them", k + 1,
			                      hawser_plane_name(modes->mode[k].plane), reference->n);
			break;
		}
		owns = gather(&w, &others, k, first);
		if (!compare_group(error, &w, owns, others))
			status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
			                      "the shapes of mode %d cannot be compared: they hold numbers "
			                      "that are not finite", k + 1);
	}
	release(&w);
	return status;
}
