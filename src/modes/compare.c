/* modes/compare.c - errors of modes with respect to reference modes of the same span.
 *
 * The i-th mode of a plane is paired with the i-th reference mode of that plane. If a method misses
 * a mode, or computes a spurious one, all modes above it are wrong, as they should be. Two
 * neighbours are swapped if each correlates better with the partner of the other one: frequency
 * curves that cross at a slightly different parameter are not an error of the shapes. The swap
 * requires that more than half of the energy of each mode is in the other's partner. Otherwise,
 * above a missing mode, round-off could decide between shapes that correlate with neither partner.
 *
 * If reference frequencies of one plane are within `together` of each other, a relative error e of
 * the operator rotates their shapes by e over the gap: their span is well determined, the single
 * shapes are not. Such modes are compared as a group, after the orthogonal transformation that
 * minimises the distance of the groups (orthogonal Procrustes problem: for G = integral of Phi.Psi
 * = U S V^T it is U V^T). For a single mode this chooses the sign. The difference is formed
 * pointwise and then integrated; the formula 2 - 2 G would lose half of the digits.
 *
 * Complex modes are compared one by one, for the phase that minimises their distance: that of z, the
 * integral of conj(Phi) . Psi, whose modulus is the correlation of the shapes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/label.h"

static const double together = 1e-3;

struct work {
	const struct hawser_modes *modes, *reference;
	const struct hawser_grid *grid; /* of the reference */
	int owns, others;  /* number of modes and of reference modes of the current plane */
	int *own, *other;  /* [owns], [others] their indices; partners have the same position */
	double *shape;     /* [modes->n][parts][points][3] shapes of the modes on that grid */
	double *turned;    /* [points][3] */
	double *G, *U, *Vt, *S, *superb; /* decomposition of a group */
	int starved;       /* 1: LAPACKE could not allocate work space */
	struct hawser__hold hold;
};

static int gather(int *index, const struct hawser_modes *modes, enum hawser_plane plane)
{
	int count = 0;

	for (int k = 0; k < modes->n; k++)
		if (modes->mode[k].plane == plane)
			index[count++] = k;
	return count;
}

static double product(const struct hawser_grid *grid, const double *x, const double *y)
{
	double sum = 0.0;

	for (int p = 0; p < grid->points; p++)
		sum += grid->weight[p]*(x[3*p]*y[3*p] + x[3*p + 1]*y[3*p + 1] + x[3*p + 2]*y[3*p + 2]);
	return sum;
}

static const double *own_shape(const struct work *w, int place)
{
	return w->shape + (size_t)w->own[place]*hawser__modes_row(w->reference);
}

static const double *other_shape(const struct work *w, int place)
{
	return w->reference->shape + (size_t)w->other[place]*hawser__modes_row(w->reference);
}

/* *re and *im of z; returns its modulus, for real modes that of the integral of Phi.Psi. */
static double correlation(double *re, double *im, const struct work *w, int own, int other)
{
	size_t size = 3*(size_t)w->grid->points;
	const double *x = own_shape(w, own), *y = other_shape(w, other);

	*re = *im = 0.0;
	if (!w->reference->gyroscopic) {
		*re = product(w->grid, x, y);
		return fabs(*re);
	}
	for (size_t k = 0; k < size; k++) {
		double weight = w->grid->weight[k/3];

		*re += weight*(x[k]*y[k] + x[size + k]*y[size + k]);
		*im += weight*(x[k]*y[size + k] - x[size + k]*y[k]);
	}
	return hypot(*re, *im);
}

/* Is mode i of the plane closer to the partner of its neighbour j than to its own? */
static int exchanged(const struct work *w, int i, int j)
{
	double re, im, neighbour = correlation(&re, &im, w, i, j);

	return neighbour > correlation(&re, &im, w, i, i) && neighbour*neighbour > 0.5;
}

static void exchange_neighbours(struct work *w)
{
	for (int i = 0; i + 1 < w->owns && i + 1 < w->others; i++)
		if (exchanged(w, i, i + 1) && exchanged(w, i + 1, i)) {
			int kept = w->own[i];

			w->own[i] = w->own[i + 1];
			w->own[i + 1] = kept;
			i++;
		}
}

/* Number of reference modes in the group that begins at `first`. */
static int group_size(const struct work *w, int first)
{
	int i = first;

	while (!w->reference->gyroscopic && i + 1 < w->others) {
		double omega = w->reference->mode[w->other[i]].omega;

		if (w->reference->mode[w->other[i + 1]].omega - omega >= together*omega)
			break;
		i++;
	}
	return i + 1 - first;
}

/* Distance of the j-th real mode of a group from the transformed reference shapes; G contains U V^T. */
static double group_distance(struct work *w, int first, int j, int owns, int others)
{
	const double *mine = own_shape(w, first + j);
	size_t size = 3*(size_t)w->grid->points;

	memcpy(w->turned, mine, size*sizeof *mine);
	for (int k = 0; k < others; k++) {
		const double *shape = other_shape(w, first + k);
		double R = w->G[j + owns*k];

		for (size_t i = 0; i < size; i++)
			w->turned[i] -= R*shape[i];
	}
	return sqrt(product(w->grid, w->turned, w->turned));
}

/* Smallest of |Phi exp(i phase) - Psi| of the i-th complex mode of the plane and its partner. */
static double phase_distance(const struct work *w, int i)
{
	size_t size = 3*(size_t)w->grid->points;
	const double *x = own_shape(w, i), *y = other_shape(w, i);
	double re, im, modulus = correlation(&re, &im, w, i, i), sum = 0.0;
	double c = modulus > 0.0 ? re/modulus : 1.0, s = modulus > 0.0 ? im/modulus : 0.0;

	for (size_t k = 0; k < size; k++)
		sum += w->grid->weight[k/3]*(pow(c*x[k] - s*x[size + k] - y[k], 2.0)
		                             + pow(s*x[k] + c*x[size + k] - y[size + k], 2.0));
	return sqrt(sum);
}

/* Replace G by U V^T. */
static int turn(struct work *w, int owns, int others)
{
	int info;

	if (owns == 1 && others == 1) {
		w->G[0] = w->G[0] < 0.0 ? -1.0 : 1.0;
		return 1;
	}
	info = LAPACKE_dgesvd(LAPACK_COL_MAJOR, 'S', 'S', owns, others, w->G, owns, w->S, w->U, owns,
	                      w->Vt, owns, w->superb);
	w->starved = hawser__lapack_starved(info);
	if (info)
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

static int transform(struct work *w, int first, int owns, int others)
{
	for (int j = 0; j < owns; j++)
		for (int k = 0; k < others; k++)
			w->G[j + owns*k] = product(w->grid, own_shape(w, first + j),
			                           other_shape(w, first + k));
	return turn(w, owns, others);
}

static int compare_group(struct hawser_modes_error *error, struct work *w, int first, int others)
{
	int owns = first + others <= w->owns ? others : w->owns - first;

	if (!w->reference->gyroscopic && !transform(w, first, owns, others))
		return 0;
	for (int j = 0; j < owns; j++) {
		struct hawser_modes_error *e = error + w->own[first + j];
		const struct hawser_mode *mode = w->modes->mode + w->own[first + j];
		const struct hawser_mode *reference = w->reference->mode + w->other[first + j];

		e->partner = w->other[first + j];
		e->frequency = hypot(mode->re - reference->re, mode->omega - reference->omega)
		               /hypot(reference->re, reference->omega);
		e->shape = w->reference->gyroscopic ? phase_distance(w, first + j)
		                                    : group_distance(w, first, j, owns, others);
		if (!isfinite(e->frequency) || !isfinite(e->shape))
			return 0;
	}
	return 1;
}

static enum hawser_status compare_plane(struct hawser_modes_error *error, struct work *w,
                                        enum hawser_plane plane, struct hawser_report *report)
{
	int first, others;

	w->owns = gather(w->own, w->modes, plane);
	w->others = gather(w->other, w->reference, plane);
	if (w->owns > w->others)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d %s modes are compared with a reference that has %d of them: ask "
		                    "for more modes of it", w->owns, hawser_plane_name(plane), w->others);
	exchange_neighbours(w);
	for (first = 0; first < w->owns; first += others) {
		others = group_size(w, first);
		if (compare_group(error, w, first, others))
			continue;
		if (w->starved)
			return hawser__no_memory(report, "modes");
		return hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                    "mode %d cannot be compared: its frequency or shape holds numbers "
		                    "that are not finite", w->own[first] + 1);
	}
	return HAWSER_OK;
}

static void release(struct work *w)
{
	hawser__hold_clear(&w->hold);
}

static int allocate(struct work *w)
{
	size_t most = (size_t)(w->reference->n > w->modes->n ? w->reference->n : w->modes->n);
	size_t size = 3*(size_t)w->grid->points;

	w->shape = hawser__hold(&w->hold, (size_t)w->modes->n*hawser__modes_row(w->reference),
	                        sizeof *w->shape);
	w->turned = hawser__hold(&w->hold, size, sizeof *w->turned);
	w->G = hawser__hold(&w->hold, most*most, sizeof *w->G);
	w->U = hawser__hold(&w->hold, most*most, sizeof *w->U);
	w->Vt = hawser__hold(&w->hold, most*most, sizeof *w->Vt);
	w->S = hawser__hold(&w->hold, most, sizeof *w->S);
	w->superb = hawser__hold(&w->hold, most, sizeof *w->superb);
	w->own = hawser__hold(&w->hold, most, sizeof *w->own);
	w->other = hawser__hold(&w->hold, most, sizeof *w->other);
	return !w->hold.short_of_memory;
}

/* The shapes on the reference's grid. */
static void resample(struct work *w)
{
	size_t points = (size_t)w->grid->points, row = hawser__modes_row(w->reference);

	for (int k = 0; k < w->modes->n; k++)
		for (size_t p = 0; p < points; p++) {
			double *to = w->shape + (size_t)k*row + 3*p, value[6];

			hawser_modes_at(w->modes, value, NULL, k, w->grid->s[p]);
			memcpy(to, value, 3*sizeof *to);
			if (w->modes->gyroscopic)
				memcpy(to + 3*points, value + 3, 3*sizeof *to);
		}
}

enum hawser_status hawser_modes_compare(struct hawser_modes_error *error,
                                        const struct hawser_modes *modes,
                                        const struct hawser_modes *reference,
                                        struct hawser_report *report)
{
	struct work w = {.modes = modes, .reference = reference, .grid = &reference->grid};
	enum hawser_status status;

	if (modes->gyroscopic != reference->gyroscopic)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "real modes are compared with complex ones: compute both with or both "
		                    "without the gyroscopic terms");
	if (!(fabs(modes->statics.l - reference->statics.l) <= 1e-9*reference->statics.l))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "modes of different spans are compared: their scaled lengths are "
		                    "%.15g and %.15g", modes->statics.l, reference->statics.l);
	if (!allocate(&w)) {
		release(&w);
		return hawser__no_memory(report, "modes");
	}
	resample(&w);
	status = compare_plane(error, &w, HAWSER_IN_PLANE, report);
	if (!status)
		status = compare_plane(error, &w, HAWSER_OUT_OF_PLANE, report);
	release(&w);
	return status;
}
