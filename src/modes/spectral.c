/* modes/spectral.c - hp Legendre-Galerkin modes of the elastic catenary, strains as unknowns.
 *
 *   u          slope eta + delta*s; theta = asinh(u)
 *   psi        angle of the tangent e from the tangent at mid-length: the frame of the displacements
 *   sa, sb     sqrt(compliance) of stretching and turning: a = sa*strain_0, b = sb*strain_1, with
 *              sa^2 = epsilon, sb^2 = g/T, T = sqrt(1+u^2), g = 1 + epsilon*T (b and c alike)
 *   p          Legendre polynomials a strain and element; p*elements - 1 functions a component are
 *              left once the far end is held
 *
 * T and psi have branch points at u = +-i, a distance 1/delta from the lowest point: elements equal
 * in theta keep them all equally far off, in units of an element, so one p serves every element
 * however deep the sag. compliance.c says why strains and not displacements.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/compliance.h"
#include "modes/label.h"
#include "modes/spectral.h"

static const double theta_span = 2.5; /* largest element, in theta */
/* Shapes are less accurate than frequencies, by about the square root: ask this much more, down to
 * what round-off allows, so that a reduced model gets shapes to nearly the tolerance too. */
static const double shape_factor = 1e-3;
/* Floor of every error estimate: this and as much again for each element. Measured. */
static const double round_off = 4e-15;
/* Below this an estimate that does not fall any more has met round-off. */
static const double stalled = 1e-9;
enum { UNKNOWNS_MAX = 2400, LEAST_DEGREE = 3, PLANES = 2, FIELDS = 3 };

/* Where a mode came from. */
struct place {
	int plane, pair;
};

/* One try with given p. */
struct attempt {
	struct hawser_grid grid;
	struct hawser__reference reference;
	double *edges;     /* [3][elements+1] slopes and positions of the edges, lengths */
	double *field;     /* [FIELDS][points]: cos psi, sin psi, sb */
	double *direction; /* [4 + 1][points] of the in-plane and the out-of-plane problem */
	struct hawser__plane plane[PLANES];
	struct hawser__pairs pairs[PLANES];
	struct place *place; /* [n] of each kept mode, ascending omega */
};

static void attempt_clear(struct attempt *t)
{
	hawser__grid_clear(&t->grid);
	hawser__reference_clear(&t->reference);
	for (int q = 0; q < PLANES; q++)
		hawser__pairs_clear(&t->pairs[q]);
	free(t->edges);
	free(t->field);
	free(t->direction);
	free(t->place);
	*t = (struct attempt){0};
}

/* Elements equal in theta. */
static int element_count(const struct hawser_statics *st)
{
	double range = asinh(st->eta + st->delta*st->l) - asinh(st->eta);

	return range <= theta_span ? 1 : (int)ceil(range/theta_span);
}

/* Slopes u[elements+1] and positions of the edges, and lengths. Near the lowest point of a very slack
 * cable an element is so much shorter than its distance from end A that it must not be had as a
 * difference of positions, nor u as eta + delta*s. */
static void place_edges(double *u, double *edge, double *length, int elements,
                        const struct hawser_statics *st)
{
	double first = asinh(st->eta), last = asinh(st->eta + st->delta*st->l);

	for (int e = 0; e <= elements; e++) {
		u[e] = sinh(first + (last - first)*e/elements);
		edge[e] = (u[e] - st->eta)/st->delta;
	}
	edge[0] = 0.0;
	edge[elements] = st->l;
	for (int e = 0; e < elements; e++)
		length[e] = elements == 1 ? st->l : (u[e + 1] - u[e])/st->delta;
}

/* The tangent is measured from the one at mid-length, where u - um = delta*(s - l/2) has no
 * cancellation: a nearly straight cable keeps the digits of its small angles whatever its slope. */
static void fill_fields(double *field, const struct hawser_grid *grid, const double *edge_slope,
                        const struct hawser_statics *st)
{
	double um = st->eta + 0.5*st->delta*st->l, cm = sqrt(1.0 + um*um);
	int points = grid->points;

	for (int i = 0; i < points; i++) {
		int e = i/grid->order;
		double x = grid->node[i%grid->order], T, u, bent;

		if (grid->elements == 1) {
			bent = 0.5*st->delta*st->l*x;
			u = um + bent;
		} else {
			u = edge_slope[e] + 0.5*(edge_slope[e + 1] - edge_slope[e])*(1.0 + x);
			bent = u - um;
		}
		T = sqrt(1.0 + u*u);
		field[i] = (1.0 + u*um)/(T*cm);
		field[points + i] = bent/(T*cm);
		field[2*points + i] = sqrt((1.0 + st->epsilon*T)/T);
	}
}

static void fill_directions(struct attempt *t, double sa)
{
	int points = t->grid.points;
	const double *cosine = t->field, *sine = t->field + points, *sb = t->field + 2*points;
	double *d = t->direction;

	for (int i = 0; i < points; i++) {
		d[i] = sa*cosine[i];
		d[points + i] = sa*sine[i];
		d[2*points + i] = -sb[i]*sine[i];
		d[3*points + i] = sb[i]*cosine[i];
		d[4*points + i] = sb[i];
	}
	t->plane[HAWSER_IN_PLANE] = (struct hawser__plane){2, d};
	t->plane[HAWSER_OUT_OF_PLANE] = (struct hawser__plane){1, d + 4*points};
}

/* How many of the n lowest modes each plane has: keep[PLANES]. */
static void share_out(int *keep, const struct attempt *t, int n)
{
	const struct hawser__pairs *in = &t->pairs[HAWSER_IN_PLANE];
	const struct hawser__pairs *out = &t->pairs[HAWSER_OUT_OF_PLANE];
	int i = 0, o = 0;

	while (i + o < n)
		if (i == in->count || (o < out->count && out->omega[o] < in->omega[i]))
			o++;
		else
			i++;
	keep[HAWSER_IN_PLANE] = i;
	keep[HAWSER_OUT_OF_PLANE] = o;
}

/* The refinement's change is the error of the unrefined frequency: an estimate that the refined one
 * stays well below once it converges, and by this factor before that (doc/theory-modes.md). */
static double estimate(const struct attempt *t, struct place at)
{
	return 3.0*t->pairs[at.plane].moved[at.pair] + round_off*(1 + t->grid.elements);
}

static double omega_of(const struct attempt *t, struct place at)
{
	return t->pairs[at.plane].omega[at.pair];
}

/* Put a mode among the first k, in ascending order. */
static void insert(struct attempt *t, int k, struct place at)
{
	for (; k > 0 && omega_of(t, t->place[k - 1]) > omega_of(t, at); k--)
		t->place[k] = t->place[k - 1];
	t->place[k] = at;
}

/* Refine the n lowest modes and put them in ascending order. *worst is the largest error estimate
 * among them. */
static enum hawser_status refine(double *worst, struct attempt *t, int n,
                                 struct hawser_report *report)
{
	int keep[PLANES], k = 0;
	enum hawser_status status;

	share_out(keep, t, n);
	*worst = 0.0;
	for (int q = 0; q < PLANES; q++) {
		status = hawser__compliance_refine(&t->pairs[q], &t->plane[q], &t->grid,
		                                   &t->reference, keep[q], report);
		if (status)
			return status;
		for (int j = 0; j < keep[q]; j++, k++) {
			insert(t, k, (struct place){q, j});
			*worst = fmax(*worst, estimate(t, (struct place){q, j}));
		}
	}
	return HAWSER_OK;
}

/* Grid, directions and refined eigenpairs with degree p; the caller clears *t whatever happens. */
static enum hawser_status attempt_solve(double *worst, struct attempt *t,
                                        const struct hawser_statics *st, int elements, int p,
                                        int n, struct hawser_report *report)
{
	size_t edges = (size_t)elements + 1, points;
	enum hawser_status status;

	*t = (struct attempt){0};
	t->edges = malloc(3*edges*sizeof *t->edges);
	if (!t->edges)
		return hawser__no_memory(report, "modes");
	place_edges(t->edges, t->edges + edges, t->edges + 2*edges, elements, st);
	status = hawser__grid_init(&t->grid, elements, 2*p, t->edges + edges, t->edges + 2*edges,
	                           report);
	if (!status)
		status = hawser__reference_init(&t->reference, &t->grid, p, report);
	if (status)
		return status;
	points = (size_t)t->grid.points;
	t->field = malloc(FIELDS*points*sizeof *t->field);
	t->direction = malloc(5*points*sizeof *t->direction);
	t->place = malloc((size_t)n*sizeof *t->place);
	if (!t->field || !t->direction || !t->place)
		return hawser__no_memory(report, "modes");
	fill_fields(t->field, &t->grid, t->edges, st);
	fill_directions(t, sqrt(st->epsilon));
	for (int q = 0; q < PLANES && !status; q++)
		status = hawser__compliance_solve(&t->pairs[q], &t->plane[q], &t->grid,
		                                  &t->reference, p, n, report);
	if (status)
		return status;
	return refine(worst, t, n, report);
}

/* Mode k of the result from its pair: components in the local frame. */
static void fill_mode(struct hawser_modes *modes, const struct attempt *t, int k, double sa)
{
	int points = t->grid.points, in_plane = t->place[k].plane == HAWSER_IN_PLANE;
	const struct hawser__pairs *pairs = &t->pairs[t->place[k].plane];
	size_t first = (size_t)(t->place[k].pair*(in_plane ? 2 : 1))*(size_t)points;
	const double *cosine = t->field, *sine = t->field + points, *sb = t->field + 2*points;
	const double *X = pairs->displacement + first;
	const double *strain = pairs->strain + first;
	double *shape = modes->shape + (size_t)k*3*(size_t)points;
	double *slope = modes->slope + (size_t)k*3*(size_t)points;

	for (int i = 0; i < points; i++, shape += 3, slope += 3) {
		if (!in_plane) {
			shape[2] = X[i];
			slope[2] = sb[i]*strain[i];
			continue;
		}
		shape[0] = cosine[i]*X[i] + sine[i]*X[points + i];
		shape[1] = cosine[i]*X[points + i] - sine[i]*X[i];
		slope[0] = sa*strain[i];
		slope[1] = sb[i]*strain[points + i];
	}
}

static enum hawser_status allocate(struct hawser_modes *modes, int n, size_t points,
                                   struct hawser_report *report)
{
	modes->n = n;
	modes->mode = calloc((size_t)n, sizeof *modes->mode);
	modes->shape = calloc((size_t)n*points, 3*sizeof *modes->shape);
	modes->slope = calloc((size_t)n*points, 3*sizeof *modes->slope);
	if (modes->mode && modes->shape && modes->slope)
		return HAWSER_OK;
	return hawser__no_memory(report, "modes");
}

/* The accepted attempt becomes the result; it keeps the grid. */
static enum hawser_status finish(struct hawser_modes *modes, struct attempt *t,
                                 const struct hawser_statics *st, int n,
                                 struct hawser_report *report)
{
	enum hawser_status status = allocate(modes, n, (size_t)t->grid.points, report);

	if (status)
		return status;
	modes->grid = t->grid;
	for (int k = 0; k < n; k++) {
		fill_mode(modes, t, k, sqrt(st->epsilon));
		modes->mode[k].plane = (enum hawser_plane)t->place[k].plane;
		modes->mode[k].omega = omega_of(t, t->place[k]);
		modes->mode[k].residual = estimate(t, t->place[k]);
		if (!isfinite(hawser__mode_label(modes, k))) {
			status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
			                      "the shape of mode %d came out as not a number: ask "
			                      "for fewer modes or a smaller basis", k + 1);
			break;
		}
	}
	t->grid = (struct hawser_grid){0};
	return status;
}

/* A first p: the wave of the last mode wanted, spread over the elements, and the branch points. */
static int first_degree(int elements, int n)
{
	double waves = 0.5*M_PI*(0.5*n + 1.0);

	if (elements == 1)
		return (int)ceil(waves + 2.0*cbrt(waves)) + 9;
	return 17 + (int)ceil(waves/elements) + elements/4;
}

static enum hawser_status too_many(struct hawser_report *report, int n, int basis)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
	                    "%d modes asked of a basis that carries %d (%d functions a component): "
	                    "ask for fewer modes, or raise model.basis to %d or more", n, 3*basis,
	                    basis, 2*n);
}

/* The basis is given: one attempt, and its error is what it is. */
static enum hawser_status solve_fixed(struct attempt *t, const struct hawser_statics *st,
                                      const struct hawser_modes_options *options,
                                      struct hawser_report *report)
{
	int elements = element_count(st), room = (options->basis + 1)/LEAST_DEGREE;
	double worst;

	elements = elements < room ? elements : room > 1 ? room : 1;
	if (2*(options->basis + 1) > UNKNOWNS_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a basis of %d functions a component is more than the %d that "
		                    "this method takes: lower model.basis", options->basis,
		                    UNKNOWNS_MAX/2 - 1);
	if (options->n > 3*((options->basis + 1)/elements*elements - 1))
		return too_many(report, options->n, (options->basis + 1)/elements*elements - 1);
	return attempt_solve(&worst, t, st, elements, (options->basis + 1)/elements, options->n,
	                     report);
}

/* Raise p until the estimate meets the target; or the tolerance, when round-off stops it before. */
static enum hawser_status solve_adaptive(struct attempt *t, const struct hawser_statics *st,
                                         const struct hawser_modes_options *options,
                                         struct hawser_report *report)
{
	int elements = element_count(st), p = first_degree(elements, options->n), tries = 0;
	int most = UNKNOWNS_MAX/(2*elements);
	double worst = HUGE_VAL, before, target;

	if (p > most)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d modes asked, which need some %d functions a component where "
		                    "%d are the most: ask for fewer modes", options->n,
		                    p*elements - 1, most*elements - 1);
	target = fmin(options->tolerance, fmax(shape_factor*options->tolerance,
	                                       25.0*round_off*(1 + elements)));
	do {
		enum hawser_status status;

		before = worst;
		attempt_clear(t);
		status = attempt_solve(&worst, t, st, elements, p, options->n, report);
		if (status || worst <= target)
			return status;
		tries++;
		p += p/4 > 4 ? p/4 : 4;
	} while (p <= most && (worst > stalled || worst < 0.5*before));
	if (worst <= options->tolerance)
		return HAWSER_OK;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", tries, worst,
	                       "the first %d frequencies have an estimated relative error of %.1e "
	                       "where %.1e was asked, with up to %d functions a component in %d "
	                       "attempts: ask for fewer modes, or for a larger tolerance (round-off "
	                       "allows 1e-13)", options->n, worst, options->tolerance,
	                       t->grid.points/2 - 1, tries);
}

enum hawser_status hawser__spectral_solve(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report)
{
	struct attempt t = {0};
	enum hawser_status status;

	status = options->basis > 0 ? solve_fixed(&t, statics, options, report)
	                            : solve_adaptive(&t, statics, options, report);
	if (!status)
		status = finish(modes, &t, statics, options->n, report);
	if (!status)
		modes->basis = modes->grid.elements*(modes->grid.order/2) - 1;
	attempt_clear(&t);
	return status;
}
