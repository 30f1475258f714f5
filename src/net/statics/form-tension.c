/* net/statics/form-tension.c - form finding with given tensions, as a convex problem.
 *
 * s     1/density of a cable: that of all its elements; n of them
 * l2    sum of l^2 over its elements
 * tau   tension that is wanted: in the root mean square, so that the mean is the given one
 * P(s)  the least energy of the net with these densities: sum of l2/(2 s), other cables, loads
 * F(s)  P(s) + sum of n*tau^2*s/2
 *
 * A cable of constant tension has the energy tau*l, which is the least over s of l^2/(2 s) + tau^2*s/2,
 * and this is convex in l and s together; so F is convex in s, and its minimum is the net with these
 * tensions. dF/ds = (n*tau^2 - l2/s^2)/2 is 0 there. With g the derivative of l2/2 by the positions and
 * K the stiffness at the equilibrium, the second derivatives are
 *     H = diag(l2/s^3) - g'*inv(K)*g/(s^2 s^2)
 *
 * To scale each density by what its tension is off is the method of reweighted least squares: along a
 * nearly straight pair of cables it leaves 1 - sin^2 of their slope of the error in each iteration.
 * Newton's method has no such limit. Steps are damped, as by Levenberg and Marquardt, until F falls.
 *
 * s may go to 0: the ends of the cable come to one place, and there it holds less than tau. Its density
 * then stays as it is, at a length that is nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "net/statics/dual.h"

enum { TRIES = 30, COLUMN = 102 /* LAPACK_COL_MAJOR */ };
static const double ARMIJO = 1e-4;           /* of the decrease that the slope promises */
static const double NOISE = 64*DBL_EPSILON;  /* of the energies: what round-off may add to F */
static const double LEAST = 1e-14, FIRST = 0.1, LESS = 0.1, MORE = 10.0; /* of the damping */
static const double NOTHING = 1e-6;          /* of the longest cable */
static const double NEAR = 0.1, FAR = 10.0;  /* a step changes s by at most these factors */

void hawser__form_clear(struct hawser__form *form)
{
	hawser__sparse_clear(form->sparse);
	free(form->cable);
	free(form->T);
	free(form->x);
	free(form->H);
	free(form->gone);
	memset(form, 0, sizeof *form);
}

enum hawser_status hawser__form_open(struct hawser__form *form, struct hawser__mesh *mesh,
                                     const struct hawser_net *net,
                                     const struct hawser__mesh_options *options,
                                     struct hawser_report *report)
{
	size_t cables = (size_t)net->cables, count;

	*form = (struct hawser__form){.mesh = mesh, .net = net, .options = *options, .damping = FIRST};
	form->cable = malloc((cables + 1)*sizeof *form->cable);
	for (int c = 0; c < net->cables && form->cable; c++)
		if (net->cable[c].given == HAWSER_NET_TENSION)
			form->cable[form->count++] = c;
	count = (size_t)form->count;
	form->T = calloc((size_t)mesh->elements, sizeof *form->T);
	form->x = calloc((size_t)mesh->unknowns + 1, sizeof *form->x);
	form->H = calloc(2*count*count + 2*count + 1, sizeof *form->H);
	form->gone = calloc(cables + 1, 1);
	if (!form->cable || !form->T || !form->x || !form->H || !form->gone)
		return hawser__no_memory(report, "net");
	form->step = form->H + 2*count*count;
	form->before = form->step + count;
	return form->count ? hawser__sparse_open(&form->sparse, mesh, report) : HAWSER_OK;
}

enum hawser_status hawser__form_balance(struct hawser__form *form, struct hawser_report *report)
{
	return hawser__mesh_statics(form->mesh, form->T, &form->found, &form->options, report);
}

/* Sum of the squares of lengths, and their sum; returns the density. */
static double lengths(double *l2, double *sum, const struct hawser__form *form, int i)
{
	const struct hawser__mesh *mesh = form->mesh;
	int c = form->cable[i];
	double e[3];

	*l2 = *sum = 0.0;
	for (int k = mesh->first[c]; k < mesh->first[c + 1]; k++) {
		double l = hawser__mesh_direction(e, mesh, k);

		*l2 += l*l;
		*sum += l;
	}
	return mesh->density[mesh->first[c]];
}

/* n*tau^2. */
static double wanted(const struct hawser__form *form, int i)
{
	int c = form->cable[i], n = form->mesh->first[c + 1] - form->mesh->first[c];
	double l2, sum, T = form->net->cable[c].value, density = lengths(&l2, &sum, form, i);

	(void)density;
	return sum > 0.0 ? n*T*T*(n*l2)/(sum*sum) : n*T*T;
}

/* Vector along an element. */
static void along(double d[3], const struct hawser__mesh *mesh, int element)
{
	for (int k = 0; k < 3; k++)
		d[k] = mesh->q[mesh->end[element][1]][k] - mesh->q[mesh->end[element][0]][k];
}

/* x = g of a cable. */
static void gradient(struct hawser__form *form, int c)
{
	const struct hawser__mesh *mesh = form->mesh;

	memset(form->x, 0, (size_t)mesh->unknowns*sizeof *form->x);
	for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++) {
		double d[3];

		along(d, mesh, e);
		for (int k = 0; k < 3; k++) {
			int a = mesh->unknown[mesh->end[e][0]][k], b = mesh->unknown[mesh->end[e][1]][k];

			if (a >= 0)
				form->x[a] -= d[k];
			if (b >= 0)
				form->x[b] += d[k];
		}
	}
}

/* g of a cable times x. */
static double product(const struct hawser__form *form, int c)
{
	const struct hawser__mesh *mesh = form->mesh;
	double sum = 0.0;

	for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++) {
		double d[3];

		along(d, mesh, e);
		for (int k = 0; k < 3; k++) {
			int a = mesh->unknown[mesh->end[e][0]][k], b = mesh->unknown[mesh->end[e][1]][k];

			sum += d[k]*((b >= 0 ? form->x[b] : 0.0) - (a >= 0 ? form->x[a] : 0.0));
		}
	}
	return sum;
}

static enum hawser_status stiffness(struct hawser__form *form, int *definite,
                                    struct hawser_report *report)
{
	const struct hawser__mesh *mesh = form->mesh;

	hawser__sparse_zero(form->sparse);
	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = hawser__mesh_direction(e, mesh, i), T = form->T[i];

		if (mesh->density[i] > 0.0)
			hawser__sparse_add(form->sparse, i, mesh->density[i], 0.0, e);
		else if (T > 0.0)
			hawser__sparse_add(form->sparse, i, T/l, mesh->EA[i]/mesh->length0[i] - T/l, e);
	}
	return hawser__sparse_factor(form->sparse, definite, report);
}

/* H in units of 1/s: s*s*H, in its first half. *definite 0: slack parts have no stiffness. */
static enum hawser_status curvature(struct hawser__form *form, int *definite,
                                    struct hawser_report *report)
{
	int n = form->count;
	enum hawser_status status = stiffness(form, definite, report);

	for (int j = 0; j < n && !status && *definite; j++) {
		double l2, sum, density = lengths(&l2, &sum, form, j);

		gradient(form, form->cable[j]);
		status = hawser__sparse_solve(form->x, form->sparse, report);
		for (int i = 0; i < n && !status; i++) {
			double other = form->mesh->density[form->mesh->first[form->cable[i]]];

			form->H[j*n + i] = (i == j ? density*l2 : 0.0) -
			                   density*other*product(form, form->cable[i]);
		}
	}
	return status;
}

/* form->step: the relative change of s, for a damping of H. Returns the slope of F along it; NAN where
 * the matrix is not positive definite. */
static double direction(struct hawser__form *form, int definite)
{
	int n = form->count, info;
	double *A = form->H + n*n, slope = 0.0;

	for (int i = 0; i < n; i++) {
		double l2, sum, density = lengths(&l2, &sum, form, i);
		int gone = form->gone[form->cable[i]];

		for (int j = 0; j < n; j++)
			A[i*n + j] = definite && !gone && !form->gone[form->cable[j]] ? form->H[i*n + j]
				: i == j ? density*l2 : 0.0;
		A[i*n + i] += form->damping*density*l2;
		form->step[i] = gone ? 0.0 : 0.5*(density*l2 - wanted(form, i)/density);
	}
	info = LAPACKE_dposv(COLUMN, 'L', n, 1, A, n, form->step, n);
	for (int i = 0; i < n; i++) {
		double l2, sum, density = lengths(&l2, &sum, form, i);

		slope -= 0.5*(density*l2 - wanted(form, i)/density)*form->step[i];
	}
	return info == 0 ? slope : NAN;
}

static void set_density(struct hawser__mesh *mesh, int c, double density)
{
	for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++)
		mesh->density[e] = density;
}

/* F for `want` [count]: n*tau^2. */
static double function(const struct hawser__form *form, const double *want)
{
	double sum = form->found.energy;

	for (int i = 0; i < form->count; i++)
		sum += 0.5*want[i]/form->mesh->density[form->mesh->first[form->cable[i]]];
	return sum;
}

/* Cables that have come to no length; they get one again when they are to hold more than their
 * tension. */
static void vanish(struct hawser__form *form)
{
	const struct hawser__mesh *mesh = form->mesh;
	double longest = 0.0, e[3];

	for (int c = 0; c < mesh->cables; c++) {
		double length = 0.0;

		for (int k = mesh->first[c]; k < mesh->first[c + 1]; k++)
			length += hawser__mesh_direction(e, mesh, k);
		longest = fmax(longest, length);
	}
	for (int i = 0; i < form->count; i++) {
		double l2, sum, density = lengths(&l2, &sum, form, i);

		unsigned char *gone = &form->gone[form->cable[i]];

		*gone = (*gone || sum < NOTHING*longest) && density*density*l2 < wanted(form, i);
	}
}

enum hawser_status hawser__form_step(struct hawser__form *form, struct hawser_report *report)
{
	struct hawser__mesh *mesh = form->mesh;
	double *want = calloc((size_t)form->count + 1, sizeof *want), F = 0.0, size = 0.0;
	int definite = 0, done = form->count == 0;
	enum hawser_status status = want ? HAWSER_OK : hawser__no_memory(report, "net");

	if (!status && !done)
		status = curvature(form, &definite, report);
	for (int i = 0; i < form->count && !status; i++) {
		want[i] = wanted(form, i);
		form->before[i] = mesh->density[mesh->first[form->cable[i]]];
		size += want[i]/form->before[i];
	}
	F = status ? 0.0 : function(form, want);
	for (int k = 0; k < TRIES && !done && !status; k++) {
		double slope;

		for (int i = 0; i < form->count; i++)
			set_density(mesh, form->cable[i], form->before[i]);
		slope = direction(form, definite);
		for (int i = 0; i < form->count && slope < 0.0; i++)
			set_density(mesh, form->cable[i],
			            form->before[i]/fmin(fmax(1.0 + form->step[i], NEAR), FAR));
		if (slope < 0.0)
			status = hawser__form_balance(form, report);
		done = slope >= 0.0 || (slope < 0.0 && !status &&
		                        function(form, want) <= F + ARMIJO*slope + NOISE*size);
		form->damping = done ? fmax(LESS*form->damping, LEAST) : MORE*form->damping;
	}
	free(want);
	if (!status)
		vanish(form);
	return status;
}
