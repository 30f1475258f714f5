/* rom/condense/support_energy.c - terms of the strain energy that contain the motion of the
 * supports, or the static response to the load.
 *
 *    s_x    displacement of end B relative to end A along axis x, a periodic function of the phase; of
 *           a cable with springs, also that of end A
 *    psi_x  the quasi-static displacement that belongs to it (support_shape.c); only its strains count
 *           here
 *    u      coordinates of the model
 *
 * The energy is a function of s and u, and the psi_x are coordinates of it like the modes, with given
 * values. Third and fourth derivatives by all of them come from project.c, with the response of the
 * condensed modes to their products. In the equation of u_j, the terms of degree 3 give f (s s) and K
 * (s u), those of degree 4 give f (s s s), K (s s u) and Q (s u u). Those of degree 2 vanish, since
 * psi_x is orthogonal in the stiffness to everything that vanishes at the ends (with springs: together
 * with theirs, which have no terms of higher degree). Products of the signals
 * are sums of harmonics, the constant one among them.
 *
 * The static response of the condensed modes to a harmonic of the load (follow.h) is one more such
 * field, with the signal cos(k tau) or sin(k tau): what follows moves with the load, and the tension
 * that it causes acts on the modes. Its terms of degree 2 vanish as well: it is orthogonal in the
 * stiffness to the modes, and along the response to pairs the load does the work that it takes. Its
 * K (s u) is that of condense_load.c and is left out here. Its inertia is neglected.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/condense/condense.h"
#include "rom/terms/ends.h"
#include "rom/terms/history.h"
#include "rom/energy/kernel.h"
#include "rom/condense/load_fields.h"
#include "rom/energy/project.h"
#include "rom/condense/support.h"

enum {
	TOP = 3*HAWSER__SUPPORT_TOP,
	MOST = HAWSER__SUPPORT_MOST + HAWSER__LOAD_FIELDS,
	ENDS = 1, LOAD = 2, /* fields */
	PAIRS = MOST*(MOST + 1)/2,
	TRIPLES = MOST*(MOST + 1)*(MOST + 2)/6
};

/* What multiplies a product of signals. */
struct share {
	double *f, *K; /* [n], [n][n]; NULL if there is none */
	int quads;
	struct hawser_quad *Q;
};

struct work {
	int n, m, moving;                    /* modes and shapes; fields; modes */
	int size;                            /* coordinates of the model */
	int ends;                            /* of the m fields, those of the supports: the first ones */
	int number[MOST];                    /* [ends] of the shapes (support.h) */
	struct hawser__load_fields loads;    /* the others */
	struct hawser__signal signal[MOST];  /* [m] */
	struct hawser_modes wide;            /* the first `moving` modes, psi [m], the other modes */
	struct hawser__condensed condensed;
	struct hawser_rom big;               /* tensors of `wide` */
	struct share one[MOST], two[PAIRS], three[TRIPLES];
};

static void share_clear(struct share *share)
{
	free(share->f);
	free(share->K);
	free(share->Q);
}

static void work_clear(struct work *work)
{
	for (int i = 0; i < MOST; i++)
		share_clear(&work->one[i]);
	for (int i = 0; i < PAIRS; i++)
		share_clear(&work->two[i]);
	for (int i = 0; i < TRIPLES; i++)
		share_clear(&work->three[i]);
	hawser__condensed_clear(&work->condensed);
	hawser__load_fields_clear(&work->loads);
	free(work->big.Q);
	free(work->big.C);
	free(work->wide.mode);
	free(work->wide.slope);
	free(work->wide.shape);
	free(work->wide.stroke);
}

/* --- the tensors --- */

static void add_answer(struct work *work, int i)
{
	struct hawser_modes *wide = &work->wide;
	size_t each = 3*(size_t)wide->grid.points, at = (size_t)(work->moving + i);

	i -= work->ends;
	memcpy(wide->slope + at*each, work->loads.strain + (size_t)i*each, each*sizeof(double));
	wide->mode[at] = (struct hawser_mode){.omega = INFINITY, .plane = work->loads.plane[i],
		.symmetry = HAWSER_MIXED};
}

static void add_psi(struct work *work, int i, const struct hawser__support_shapes *shapes)
{
	struct hawser_modes *wide = &work->wide;
	size_t each = 3*(size_t)wide->grid.points, at = (size_t)(work->moving + i);
	int axis = work->number[i]%HAWSER__AXES;

	memcpy(wide->slope + at*each, shapes->strain + (size_t)work->number[i]*each,
	       each*sizeof(double));
	/* infinite: nothing of a response is removed along psi. About mid-span, opposite displacements of
	 * the ends are symmetric along x and antisymmetric along y and z */
	wide->mode[at] = (struct hawser_mode){.omega = INFINITY,
		.plane = axis == 2 ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE,
		.symmetry = axis == 0 ? HAWSER_SYMMETRIC : HAWSER_ANTISYMMETRIC};
}

static enum hawser_status widen(struct work *work, const struct hawser_modes *modes,
                                const struct hawser__support_shapes *shapes,
                                struct hawser_report *report)
{
	struct hawser_modes *wide = &work->wide;
	size_t each = 3*(size_t)modes->grid.points, n = (size_t)work->n, m = (size_t)work->m;
	size_t moving = (size_t)work->moving;

	if (work->n + work->m > HAWSER_ROM_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%d modes of a cable whose supports move in %d ways: at most %d "
		                    "together are possible, keep fewer modes (model.modes)", work->n,
		                    work->m, HAWSER_ROM_MAX);
	*wide = *modes;
	wide->n = work->n + work->m;
	wide->mode = malloc((n + m)*sizeof *wide->mode);
	wide->slope = malloc((n + m)*each*sizeof *wide->slope);
	wide->shape = calloc((n + m)*each, sizeof *wide->shape); /* 0 for psi: not a part of a response */
	wide->stroke = NULL;
	if (modes->stroke)
		wide->stroke = calloc(n + m, (size_t)modes->statics.attachments*sizeof *wide->stroke);
	if (!wide->mode || !wide->slope || !wide->shape || (modes->stroke && !wide->stroke))
		return hawser__no_memory(report, "rom");
	memcpy(wide->mode, modes->mode, moving*sizeof *wide->mode);
	memcpy(wide->mode + moving + m, modes->mode + moving, (n - moving)*sizeof *wide->mode);
	for (int k = 0; k < 2; k++) {
		double *to = k ? wide->shape : wide->slope;
		const double *from = k ? modes->shape : modes->slope;

		memcpy(to, from, moving*each*sizeof *to);
		memcpy(to + (moving + m)*each, from + moving*each, (n - moving)*each*sizeof *to);
	}
	if (wide->stroke) {
		size_t marks = (size_t)modes->statics.attachments;

		memcpy(wide->stroke, modes->stroke, moving*marks*sizeof *wide->stroke);
		memcpy(wide->stroke + (moving + m)*marks, modes->stroke + moving*marks,
		       (n - moving)*marks*sizeof *wide->stroke);
	}
	for (int i = 0; i < work->ends; i++)
		add_psi(work, i, shapes);
	for (int i = work->ends; i < work->m; i++)
		add_answer(work, i);
	return HAWSER_OK;
}

/* --- products of psi --- */

/* Index of the product of two (i <= j) or three axes. */
static int pair_of(int i, int j)
{
	return j*(j + 1)/2 + i;
}

static int triple_of(int i, int j, int k)
{
	return k*(k + 1)*(k + 2)/6 + pair_of(i, j);
}

/* Coordinate of the model of index `at` of `wide`; -1 - i for psi number i. */
static int coordinate(const struct work *work, int at)
{
	if (at < work->moving)
		return at;
	return at < work->moving + work->m ? work->moving - at - 1 : at - work->m;
}

static double *room(double **array, size_t count)
{
	if (!*array)
		*array = calloc(count, sizeof **array);
	return *array;
}

/* A monomial value*product of equation e, `count` factors index[] of `wide` in ascending order. Returns
 * 0 when out of memory. */
static int sort_in(struct work *work, int e, const int *index, int count, double value)
{
	int equation = coordinate(work, e), psi[3], psis = 0, u[3], us = 0, n = work->size;
	struct share *share;

	for (int i = 0; i < count; i++) {
		int at = coordinate(work, index[i]);

		if (at < 0)
			psi[psis++] = -1 - at;
		else
			u[us++] = at;
	}
	if (equation < 0 || psis == 0)
		return 1;
	share = psis == 1 ? &work->one[psi[0]] : psis == 2 ? &work->two[pair_of(psi[0], psi[1])]
	        : &work->three[triple_of(psi[0], psi[1], psi[2])];
	if (us == 2) {
		struct hawser_quad *Q = realloc(share->Q, ((size_t)share->quads + 1)*sizeof *Q);

		if (!Q)
			return 0;
		share->Q = Q;
		Q[share->quads++] = (struct hawser_quad){equation, u[0], u[1], value};
		return 1;
	}
	if (!room(us ? &share->K : &share->f, us ? (size_t)n*(size_t)n : (size_t)n))
		return 0;
	if (us && psis == 1 && psi[0] >= work->ends)
		return 1; /* condense_load.c */
	if (us)
		share->K[equation*n + u[0]] += value;
	else
		share->f[equation] -= value; /* on the right side */
	return 1;
}

static int sort_all(struct work *work)
{
	int good = 1;

	for (int i = 0; good && i < work->big.quads; i++) {
		const struct hawser_quad *q = &work->big.Q[i];

		good = sort_in(work, q->j, (int[]){q->k, q->l}, 2, q->value);
	}
	for (int i = 0; good && i < work->big.cubics; i++) {
		const struct hawser_cubic *c = &work->big.C[i];

		good = sort_in(work, c->j, (int[]){c->k, c->l, c->m}, 3, c->value);
	}
	return good;
}

/* --- products of signals --- */

static void multiply(struct hawser__signal *out, const struct hawser__signal *a,
                     const struct hawser__signal *b)
{
	struct hawser__signal sum = {{0.0}, {0.0}};

	for (int k = 0; k <= TOP; k++)
		for (int l = 0; l <= TOP - k; l++) {
			int d = abs(k - l), sign = k > l ? 1 : -1;

			sum.c[k + l] += 0.5*(a->c[k]*b->c[l] - a->s[k]*b->s[l]);
			sum.c[d] += 0.5*(a->c[k]*b->c[l] + a->s[k]*b->s[l]);
			sum.s[k + l] += 0.5*(a->c[k]*b->s[l] + a->s[k]*b->c[l]);
			sum.s[d] += 0.5*sign*(a->s[k]*b->c[l] - a->c[k]*b->s[l]);
		}
	sum.s[0] = 0.0;
	*out = sum;
}

/* The harmonic of the model from `first` on with these properties, appended if there is none. */
static struct hawser_harmonic *find(struct hawser_rom *rom, int first, int k, enum hawser_phase phase,
                                    int power)
{
	struct hawser_harmonic *h;

	for (int i = first; i < rom->harmonics; i++)
		if (rom->harmonic[i].k == k && rom->harmonic[i].phase == phase &&
		    rom->harmonic[i].load_power == power)
			return &rom->harmonic[i];
	h = realloc(rom->harmonic, ((size_t)rom->harmonics + 1)*sizeof *h);
	if (!h)
		return NULL;
	rom->harmonic = h;
	h += rom->harmonics++;
	*h = (struct hawser_harmonic){.k = k, .phase = phase, .load_power = power};
	return h;
}

/* Add factor * share to a harmonic. Returns 0 when out of memory. */
static int put(struct hawser_harmonic *h, const struct share *share, double factor, size_t n)
{
	if (!h)
		return 0;
	if (share->f && !room(&h->f, n))
		return 0;
	if (share->K && !room(&h->K, n*n))
		return 0;
	for (size_t i = 0; share->f && i < n; i++)
		h->f[i] += factor*share->f[i];
	for (size_t i = 0; share->K && i < n*n; i++)
		h->K[i] += factor*share->K[i];
	if (share->quads > 0) {
		size_t count = (size_t)h->quads + (size_t)share->quads;
		struct hawser_quad *Q = realloc(h->Q, count*sizeof *Q);

		if (!Q)
			return 0;
		h->Q = Q;
		for (int i = 0; i < share->quads; i++) {
			Q[h->quads] = share->Q[i];
			Q[h->quads++].value *= factor;
		}
	}
	return 1;
}

static int spread(struct hawser_rom *rom, int first, const struct share *share,
                  const struct hawser__signal *signal, int power)
{
	size_t n = (size_t)rom->n;
	double largest = 0.0;

	if (!share->f && !share->K && !share->quads)
		return 1;
	for (int k = 0; k <= TOP; k++)
		largest = fmax(largest, fmax(fabs(signal->c[k]), fabs(signal->s[k])));
	for (int k = 0; k <= TOP; k++) {
		/* what cancels but for round-off is left out */
		if (fabs(signal->c[k]) > 1e-15*largest &&
		    !put(find(rom, first, k, HAWSER_COS, power), share, signal->c[k], n))
			return 0;
		if (fabs(signal->s[k]) > 1e-15*largest &&
		    !put(find(rom, first, k, HAWSER_SIN, power), share, signal->s[k], n))
			return 0;
	}
	return 1;
}

/* The share as a term of the history, with the product of `count` of the shapes. */
static enum hawser_status give(struct hawser_rom *rom, const struct work *work, struct share *share,
                               int count, const int shape[3], struct hawser_report *report)
{
	struct hawser_history_factor factor = {.count = count};
	struct hawser_ramp_term *term;

	if (!share->f && !share->K && !share->quads)
		return HAWSER_OK;
	for (int i = 0; i < count; i++)
		factor.signal[i] = work->number[shape[i]];
	term = hawser__history_term(rom, &factor);
	if (!term)
		return hawser__no_memory(report, "rom");
	*term = (struct hawser_ramp_term){.f = share->f, .K = share->K, .quads = share->quads,
		.Q = share->Q};
	*share = (struct share){.quads = 0};
	rom->history->motions = rom->history->terms;
	return HAWSER_OK;
}

static enum hawser_status give_all(struct hawser_rom *rom, struct work *work,
                                   struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; !status && k < work->m; k++) {
		status = give(rom, work, &work->one[k], 1, (int[3]){k}, report);
		for (int j = 0; !status && j <= k; j++) {
			status = give(rom, work, &work->two[pair_of(j, k)], 2, (int[3]){j, k}, report);
			for (int i = 0; !status && i <= j; i++)
				status = give(rom, work, &work->three[triple_of(i, j, k)], 3,
				              (int[3]){i, j, k}, report);
		}
	}
	return status;
}

static int spread_all(struct hawser_rom *rom, const struct work *work)
{
	int first = rom->harmonics, good = 1;

	for (int k = 0; good && k < work->m; k++) {
		good = spread(rom, first, &work->one[k], &work->signal[k], 1);
		for (int j = 0; good && j <= k; j++) {
			struct hawser__signal two, three;

			multiply(&two, &work->signal[j], &work->signal[k]);
			good = spread(rom, first, &work->two[pair_of(j, k)], &two, 2);
			for (int i = 0; good && i <= j; i++) {
				multiply(&three, &two, &work->signal[i]);
				good = spread(rom, first, &work->three[triple_of(i, j, k)], &three, 3);
			}
		}
	}
	return good;
}

/* The shapes that move. */
static enum hawser_status list_shapes(struct work *work, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene,
                                      struct hawser__support_shapes *shapes,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (!hawser__support_moves(scene))
		return HAWSER_OK;
	status = hawser__support_shapes_make(shapes, modes, report);
	for (int i = 0; !status && i < shapes->count; i++)
		if (hawser__support_factor(&work->signal[work->m], scene, i, &modes->statics))
			work->number[work->m++] = i;
	work->ends = work->m;
	return status;
}

/* The responses to the load that matter. A table that moves the ends leaves no room for them. */
static enum hawser_status list_answers(struct work *work, const struct hawser_modes *modes,
                                       const struct hawser_scene *scene, struct hawser_report *report)
{
	const struct hawser__load_fields *loads = &work->loads;
	enum hawser_status status = HAWSER_OK;

	if (hawser__loaded(scene) && !hawser__support_given(scene))
		status = hawser__load_fields_make(&work->loads, modes, work->moving, scene, report);
	for (int i = 0; i < loads->count; i++, work->m++) {
		work->signal[work->m] = (struct hawser__signal){{0.0}, {0.0}};
		*(loads->sine[i] ? &work->signal[work->m].s[loads->k[i]]
		  : &work->signal[work->m].c[loads->k[i]]) = 1.0;
	}
	return status;
}

/* The second-order response to the motion of the supports, without that to the load. */
static enum hawser_status condensed_ends(struct hawser_rom *rom, const struct work *work,
                                         struct hawser_report *report)
{
	struct hawser__condensed own = work->condensed;

	own.n = work->moving + work->ends;
	own.pairs = own.n*(own.n + 1)/2;
	return hawser__ends_condensed(rom, &work->wide, &own, report);
}

/* Terms of some of the fields, of the first `moving` modes. */
static enum hawser_status add_fields(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     int moving, int condensed, int fields,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	struct work work = {.n = modes->n, .moving = moving, .size = rom->n};
	struct hawser__support_shapes shapes = {.count = 0};
	enum hawser_status status = HAWSER_OK;

	if (fields & ENDS)
		status = list_shapes(&work, modes, scene, &shapes, report);
	if (!status && condensed && (fields & LOAD))
		status = list_answers(&work, modes, scene, report);
	if (status || work.m == 0) {
		hawser__support_shapes_clear(&shapes);
		work_clear(&work);
		return status;
	}
	status = widen(&work, modes, &shapes, report);
	if (!status && condensed)
		status = hawser__condense(&work.condensed, &work.wide, moving + work.m, report);
	if (!status)
		status = hawser__rom_tensors(&work.big, &work.wide, condensed ? &work.condensed : NULL,
		                             report);
	if (!status && condensed && rom->shapes.second_slope && work.ends > 0)
		status = condensed_ends(rom, &work, report);
	if (!status && !sort_all(&work))
		status = hawser__no_memory(report, "rom");
	if (!status && hawser__support_given(scene))
		status = give_all(rom, &work, report);
	else if (!status && !spread_all(rom, &work))
		status = hawser__no_memory(report, "rom");
	hawser__support_shapes_clear(&shapes);
	work_clear(&work);
	return status;
}

enum hawser_status hawser__support_energy(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          const struct hawser_modes *kept, int condensed,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report)
{
	int together = modes == kept;
	enum hawser_status status = add_fields(rom, modes, kept->n, condensed,
	                                       together ? ENDS | LOAD : ENDS, scene, report);

	return status || together ? status
	       : add_fields(rom, kept, kept->n, condensed, LOAD, scene, report);
}
