/* modes/bending/flexure_solve.c - modes of a cable with bending stiffness: a Ritz method on
 * elements that are refined at boundary layers, with error control.
 *
 *   p      degree of the rotation in each element
 *   layer  sqrt(EI/T), the width of the boundary layer beside an end or a mass
 *
 * Each of the last two degrees gives upper bounds of the frequencies. Their difference exceeds the
 * error of the better ones, which are returned, as soon as the method converges.
 * Elements beside an end have the length of 0.8 p layers, which exp(-s/layer) and the rest of
 * the span both allow with the same p (Schwab, p- and hp-Finite Element Methods, 1998, 3.4:
 * exponential
 * convergence for any width of the layer).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/bending/bending.h"
#include "modes/bending/flexure.h"
#include "modes/label.h"
#include "modes/spectral.h"

static const double layers = 0.8;      /* length of an end element in layers, over p */
static const double part_most = 0.25;  /* and its largest part of the piece of cable */
static const double thick = 3.0;       /* in layers: a shorter one is not needed */
static const double theta_span = 2.5;  /* longest element in asinh(u), as in cable.c */
static const double phase = 8.0;       /* longest element over the half wave, times pi/2 */
/* Round-off of an eigenvalue of a matrix, relative to the largest one; chosen, above the errors that
 * tests/property/test-modes-bending finds. */
static const double matrix_round_off = 2e-15;
static const double moment_round_off = 1e-11; /* of a moment, a difference of shapes; chosen so too */
enum { FIRST = 22, MORE = 6, MOST = 52, FUNCTIONS_MAX = 3000 };

/* --- edges --- */

double hawser__layer_at(const struct hawser_statics *st, double s)
{
	struct hawser_frame_point at = hawser_statics_frame(st, s);

	return sqrt(st->bending.EI/(st->H*hypot(1.0, at.u)*(1.0 + at.strain)))/st->span.d;
}

/* Edges of the piece from `from` to `to` behind edge[0..count-1], the last of which is `from`; NULL:
 * only
 * count. Returns their number. */
static int piece(double *edge, int count, const struct hawser_statics *st, double from, double to,
                 int degree, double waves)
{
	double length = to - from, shift = 1e-12*length;
	double low = asinh(hawser_statics_frame(st, from).u);
	double high = asinh(hawser_statics_frame(st, to - shift).u), start = from, stop = to;
	double first = hawser__layer_at(st, from), last = hawser__layer_at(st, to);
	int n = (int)fmax(1.0, fmax(ceil((high - low)/theta_span),
	                            ceil(0.5*M_PI*waves*length/st->l/phase)));

	if (part_most*length > thick*first)
		start = from + fmin(part_most*length, layers*degree*first);
	if (part_most*length > thick*last)
		stop = to - fmin(part_most*length, layers*degree*last);
	if (start > from && edge)
		edge[count] = start;
	count += start > from;
	low = asinh(hawser_statics_frame(st, start).u);
	high = asinh(hawser_statics_frame(st, stop - shift).u);
	for (int i = 1; i < n; i++, count++)
		if (edge)
			edge[count] = high - low < 1e-3
			              ? start + (stop - start)*i/n
			              : start + (stop - start)*(sinh(low + (high - low)*i/n) - sinh(low))/
			                                (sinh(high) - sinh(low));
	if (stop < to && edge)
		edge[count] = stop;
	count += stop < to;
	if (edge)
		edge[count] = to;
	return count + 1;
}

static int place(double *edge, const struct hawser_statics *st, int degree, double waves)
{
	int count = 1;

	if (edge)
		edge[0] = 0.0;
	for (int i = 0; i <= st->attachments; i++)
		count = piece(edge, count, st, i > 0 ? st->attached[i - 1].s : 0.0,
		              i < st->attachments ? st->attached[i].s : st->l, degree, waves);
	return count;
}

enum hawser_status hawser__flexure_edges(double **edge, int *elements, const struct hawser_statics *st,
                                         int degree, double waves, struct hawser_report *report)
{
	int count = place(NULL, st, degree, waves);

	*elements = count - 1;
	*edge = malloc((size_t)count*sizeof **edge);
	if (!*edge)
		return hawser__no_memory(report, "modes");
	place(*edge, st, degree, waves);
	return HAWSER_OK;
}

/* --- one solution --- */

/* The lowest modes of one plane: frequencies, and coefficients of the functions. */
struct pairs {
	int count;
	double *omega; /* [count] */
	double *z;     /* [count][free] coordinates */
};

struct attempt {
	struct hawser_grid grid;
	struct hawser__flexure plane[2]; /* by enum hawser_plane */
	struct pairs pairs[2];
};

static void attempt_clear(struct attempt *t)
{
	for (int q = 0; q < 2; q++) {
		hawser__flexure_clear(&t->plane[q]);
		free(t->pairs[q].omega);
		free(t->pairs[q].z);
	}
	hawser__grid_clear(&t->grid);
	*t = (struct attempt){0};
}

/* The largest eigenvalues 1/omega^2 of the mass, where the stiffness is a unit matrix. */
static enum hawser_status eigen(struct pairs *pairs, const struct hawser__flexure *t,
                                const struct hawser_statics *st, int count,
                                struct hawser_report *report)
{
	int n = t->free, keep = count < n ? count : n, info;
	double *root = NULL, *M = malloc((size_t)n*(size_t)n*sizeof *M);
	double *mu = malloc((size_t)n*sizeof *mu), *z = malloc((size_t)n*(size_t)keep*sizeof *z);
	lapack_int *support = malloc(2*(size_t)keep*sizeof *support), found = 0;
	enum hawser_status status = hawser__flexure_roots(&root, t, st, report);

	*pairs = (struct pairs){.count = keep, .omega = malloc((size_t)keep*sizeof(double)),
	                        .z = malloc((size_t)n*(size_t)keep*sizeof(double))};
	if (!status && (!M || !mu || !z || !support || !pairs->omega || !pairs->z))
		status = hawser__no_memory(report, "modes");
	if (status)
		goto done;
	cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, n, t->rows, 1.0, root, t->rows, 0.0, M, n);
	info = LAPACKE_dsyevr(LAPACK_COL_MAJOR, 'V', 'I', 'L', n, M, n, 0.0, 0.0, n - keep + 1, n, 0.0,
	                      &found, mu, z, n, support);
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(report, "modes");
	else if (info || found != keep || !(mu[0] > 0.0))
		status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                      "the modes of a cable with cable.EI did not come out: check EA, EI, "
		                      "rho, d and the tension of the span");
	for (int k = 0; !status && k < keep; k++) {
		pairs->omega[k] = 1.0/sqrt(mu[keep - 1 - k]);
		memcpy(pairs->z + (size_t)k*(size_t)n, z + (size_t)(keep - 1 - k)*(size_t)n,
		       (size_t)n*sizeof *z);
	}
done:
	free(root);
	free(M);
	free(mu);
	free(z);
	free(support);
	return status;
}

static enum hawser_status attempt_solve(struct attempt *t, const struct hawser_statics *st, int p,
                                        int n,
                                        struct hawser_report *report)
{
	double *edge = NULL;
	int elements;
	enum hawser_status status = hawser__flexure_edges(&edge, &elements, st, p, 0.5*n + 1.0, report);

	*t = (struct attempt){0};
	if (!status && 2*elements*p > FUNCTIONS_MAX)
		status = hawser__spectral_too_many(n, elements*p, FUNCTIONS_MAX/2, report);
	if (!status)
		status = hawser__grid_init(&t->grid, elements, 2*p, edge, NULL, report);
	free(edge);
	for (int q = 0; q < 2 && !status; q++) {
		status = hawser__flexure_init(&t->plane[q], st, &t->grid, p, q, report);
		if (!status)
			status = eigen(&t->pairs[q], &t->plane[q], st, n, report);
	}
	return status;
}

/* --- the result --- */

static double round_off(const struct attempt *t, int q, int k)
{
	double ratio = t->pairs[q].omega[k]/t->pairs[q].omega[0];

	return hawser__spectral_round_off(t->grid.elements) + matrix_round_off*ratio*ratio;
}

/* The n lowest modes by their planes and indices; returns the largest error estimate, by the change
 * from `before`. */
static double order(int *plane, int *index, double *error, const struct attempt *t,
                    const struct attempt *before, int n)
{
	int next[2] = {0};
	double worst = 0.0;

	for (int k = 0; k < n; k++) {
		const struct pairs *in = &t->pairs[0], *out = &t->pairs[1];
		int q = next[1] == out->count ||
		        (next[0] < in->count && in->omega[next[0]] <= out->omega[next[1]]) ? 0 : 1;
		int i = next[q]++;

		plane[k] = q;
		index[k] = i;
		error[k] = i < before->pairs[q].count
		           ? fabs(before->pairs[q].omega[i]/t->pairs[q].omega[i] - 1.0) : 1.0;
		error[k] += round_off(t, q, i);
		worst = fmax(worst, error[k]);
	}
	return worst;
}

/* Displacement from the strains of the mode: rows of the fixed axes, turned into the local frame. */
static void shape_of(double *shape, const struct hawser__flexure *t, const struct hawser_statics *st,
                     const double *y)
{
	for (int i = 0; i < t->points; i++, shape += 3) {
		double x = cblas_ddot(t->functions, y, 1, t->x + i, t->rows), normal, c, s;

		if (t->D == 1) {
			shape[2] = x;
			continue;
		}
		normal = cblas_ddot(t->functions, y, 1, t->x + t->points + i, t->rows);
		hawser__flexure_axes(&c, &s, st, t->grid->s[i]);
		shape[0] = c*x + s*normal;
		shape[1] = c*normal - s*x;
	}
}

/* Changes of curvature at both ends in pair k of plane q. Modes of two attempts have the same
 * energy, so
 * that these are comparable up to a sign. */
static enum hawser_status ends_of(double ends[2], const struct attempt *t,
                                  const struct hawser_statics *st,
                                  int q, int k, struct hawser_report *report)
{
	const struct hawser__flexure *f = &t->plane[q];
	size_t points = (size_t)t->grid.points;
	double *strain = calloc(5*points + (size_t)f->functions, sizeof *strain), both[4] = {0.0};
	enum hawser_status status = strain ? HAWSER_OK : hawser__no_memory(report, "modes");

	if (!status)
		status = hawser__flexure_expand(strain + 5*points, f,
		                                t->pairs[q].z + (size_t)k*(size_t)f->free, report);
	if (!status) {
		hawser__flexure_strain(strain, f, strain + 5*points);
		status = hawser__curvature(strain + 3*points, both, st, &t->grid, strain, report);
	}
	ends[0] = both[q];
	ends[1] = both[2 + q];
	free(strain);
	return status;
}

/* The change of the end moments of each mode from `before`, relative to the larger one. */
static enum hawser_status moment_errors(struct hawser_modes *modes, const struct attempt *t,
                                        const struct attempt *before, const int *plane,
                                        const int *index, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; !status && k < modes->n; k++) {
		double now[2], then[2], same, other, most;

		modes->mode[k].moment_error = 1.0;
		if (index[k] >= before->pairs[plane[k]].count)
			continue;
		status = ends_of(now, t, &modes->statics, plane[k], index[k], report);
		if (!status)
			status = ends_of(then, before, &modes->statics, plane[k], index[k], report);
		if (status)
			break;
		same = hypot(now[0] - then[0], now[1] - then[1]);
		other = hypot(now[0] + then[0], now[1] + then[1]);
		most = fmax(fabs(now[0]), fabs(now[1]));
		modes->mode[k].moment_error = most > 0.0 ? fmin(1.0, fmin(same, other)/most + moment_round_off)
		                                         : 0.0;
	}
	return status;
}

static enum hawser_status finish(struct hawser_modes *modes, struct attempt *t,
                                 const struct attempt *before, const int *plane, const int *index,
                                 const double *error, int n, struct hawser_report *report)
{
	size_t row = 3*(size_t)t->grid.points;
	int most = t->plane[0].functions > t->plane[1].functions ? t->plane[0].functions
	                                                         : t->plane[1].functions;
	double *y = malloc((size_t)most*sizeof *y);
	enum hawser_status status = y ? hawser__modes_allocate(modes, n, t->grid.points, report)
	                              : hawser__no_memory(report, "modes");

	for (int k = 0; !status && k < n; k++) {
		const struct hawser__flexure *f = &t->plane[plane[k]];
		const struct pairs *pairs = &t->pairs[plane[k]];

		status = hawser__flexure_expand(y, f, pairs->z + (size_t)index[k]*(size_t)f->free, report);
		if (status)
			break;
		hawser__flexure_strain(modes->slope + (size_t)k*row, f, y);
		shape_of(modes->shape + (size_t)k*row, f, &modes->statics, y);
		modes->mode[k].plane = (enum hawser_plane)plane[k];
		modes->mode[k].omega = pairs->omega[index[k]];
		modes->mode[k].residual = error[k];
	}
	free(y);
	if (!status)
		status = moment_errors(modes, t, before, plane, index, report);
	if (status)
		return status;
	modes->grid = t->grid;
	t->grid = (struct hawser_grid){0};
	status = hawser__modes_label(modes, report);
	return status ? status : hawser__modes_moments(modes, report);
}

static enum hawser_status adapt(struct attempt *t, struct attempt *before, int *plane, int *index,
                                double *error,
                                const struct hawser_statics *st,
                                const struct hawser_modes_options *options,
                                struct hawser_report *report)
{
	double worst = HUGE_VAL, least, target;
	int p = FIRST, tries = 1;
	enum hawser_status status = attempt_solve(before, st, p, options->n, report);

	while (!status) {
		p += MORE;
		status = attempt_solve(t, st, p, options->n, report);
		if (status)
			break;
		least = worst;
		worst = order(plane, index, error, t, before, options->n);
		target = hawser__spectral_target(options, t->grid.elements);
		tries++;
		if (worst <= target || p + MORE > MOST || !hawser__spectral_improves(worst, least))
			break;
		attempt_clear(before);
		*before = *t;
		for (int q = 0; q < 2; q++)
			before->plane[q].grid = &before->grid;
		*t = (struct attempt){0};
	}
	if (!status && !(worst <= options->tolerance))
		status = hawser__spectral_unsettled(options, worst, t->plane[0].free/2, tries, report);
	return status;
}

enum hawser_status hawser__flexure_solve(struct hawser_modes *modes, const struct hawser_statics *st,
                                         const struct hawser_modes_options *options,
                                         struct hawser_report *report)
{
	size_t n = (size_t)options->n;
	struct attempt t = {0}, before = {0};
	int *plane = malloc(2*n*sizeof *plane), *index = plane ? plane + n : NULL;
	double *error = malloc(n*sizeof *error);
	enum hawser_status status = HAWSER_OK;

	if (!plane || !error)
		status = hawser__no_memory(report, "modes");
	else if (st->elastic)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                      "elastic supports of a cable with cable.EI are not modelled: leave "
		                      "support.A.stiffness and support.B.stiffness out, or cable.EI");
	else if (options->basis > 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                      "model.basis = %d with cable.EI: the elements follow the boundary "
		                      "layers; leave model.basis out, and set model.tolerance",
		                      options->basis);
	else
		status = adapt(&t, &before, plane, index, error, st, options, report);
	if (!status) {
		modes->basis = t.plane[HAWSER_OUT_OF_PLANE].free;
		status = finish(modes, &t, &before, plane, index, error, options->n, report);
	}
	attempt_clear(&t);
	attempt_clear(&before);
	free(plane);
	free(error);
	return status;
}
