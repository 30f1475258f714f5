/* net/statics/interior.c - equilibrium of a net with slack members: primal-dual interior point.
 *
 * N, s  force of an element, and its slack N*c - (l - length0): N >= 0, s >= 0, N*s = mu -> 0
 * c     length0/EA
 * e, l  direction and length of an element
 *
 * Minimises the convex energy with one-sided law as a problem with N*s = mu > 0, whose matrix
 * sum of (N/D)*e*e' + (N/l)*(I - e*e'), D = s + N*c, is positive definite whatever is slack. Newton's
 * method on positions alone has a singular matrix there, and cycles between slack and taut.
 * Rules of mu and of the start: measured on 1600 random cables (doc/theory-net.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "net/touch/touch.h"

/* Iterations without a residual of half the size; with obstacles, whose gaps make steps short, more. */
enum { MOST = 300, IDLE = 15 };

static double length_of(double e[3], const struct hawser__mesh *mesh, int i)
{
	double l = hawser__mesh_direction(e, mesh, i);

	return fmax(l, 1e-12*mesh->length0[i]); /* coincident nodes: direction zero */
}

static void begin(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	double e[3];

	for (int i = 0; i < mesh->elements; i++) {
		double length0 = mesh->length0[i], give = work->N[i]*length0/mesh->EA[i];
		double p = length_of(e, mesh, i) - length0;

		work->s[i] = fmax(fmax(give - p, give), 0.01*length0);
	}
}

/* Mean of N*s over the elements that have a slack, and of r*t over the nodes that may touch. */
static double mean(const struct hawser__net_work *work)
{
	double sum = 0.0;
	int count = 0;

	for (int i = 0; i < work->mesh->elements; i++)
		if (work->mesh->density[i] == 0.0) {
			sum += work->N[i]*work->s[i];
			count++;
		}
	hawser__touch_mean(&sum, &count, work->mesh);
	return count ? sum/count : 0.0;
}

/* The part of the step a of one element that does not depend on its stretch, and its D. */
static double fixed_part(double *D, const struct hawser__net_work *work, int i, double l, double mu)
{
	const struct hawser__mesh *mesh = work->mesh;
	double c = mesh->length0[i]/mesh->EA[i], N = work->N[i], s = work->s[i];
	double r2 = s + l - mesh->length0[i] - N*c;

	*D = s + N*c;
	return (mu - N*s + N*r2)/ *D;
}

static void assemble(struct hawser__net_work *work, double mu)
{
	const struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = length_of(e, mesh, i), D;

		if (mesh->density[i] > 0.0) {
			work->a[i] = mesh->density[i];
			work->b[i] = 0.0;
			continue;
		}
		work->T[i] = work->N[i] + fixed_part(&D, work, i, l, mu);
		work->a[i] = work->N[i]/l;
		work->b[i] = work->N[i]/D - work->a[i];
	}
	hawser__touch_interior(work->mesh, mu);
	hawser__net_right(work, work->T);
}

struct change {
	double N, s, length; /* of a step, length of the difference of its ends */
};

static struct change change_of(const struct hawser__net_work *work, int i, double mu)
{
	const struct hawser__mesh *mesh = work->mesh;
	double e[3], d[3], D, l = length_of(e, mesh, i), a = fixed_part(&D, work, i, l, mu);
	double c = mesh->length0[i]/mesh->EA[i], r2 = work->s[i] + l - mesh->length0[i] - work->N[i]*c;
	double along;
	struct change change;

	hawser__net_stretch(d, work, i);
	along = e[0]*d[0] + e[1]*d[1] + e[2]*d[2];
	change.N = a + work->N[i]/D*along;
	change.s = -r2 - along + change.N*c;
	change.length = sqrt(d[0]*d[0] + d[1]*d[1] + d[2]*d[2]);
	return change;
}

/* Take the longest step that keeps N and s positive; T is used as work space. */
static double advance(struct hawser__net_work *work, double mu)
{
	const struct hawser__mesh *mesh = work->mesh;
	double step = 1.0;

	for (int i = 0; i < mesh->elements; i++) {
		struct change change;

		if (mesh->density[i] > 0.0)
			continue;
		change = change_of(work, i, mu);
		if (change.N < 0.0)
			step = fmin(step, -0.99*work->N[i]/change.N);
		if (change.s < 0.0)
			step = fmin(step, -0.99*work->s[i]/change.s);
		if (change.length*step > 2.0*mesh->length0[i])
			step = 2.0*mesh->length0[i]/change.length;
		work->a[i] = change.N;
		work->T[i] = change.s;
	}
	hawser__touch_limit(&step, work, mu);
	hawser__touch_advance(work, mu, step);
	for (int i = 0; i < mesh->elements; i++)
		if (mesh->density[i] == 0.0) {
			work->N[i] += step*work->a[i];
			work->s[i] += step*work->T[i];
		}
	hawser__net_move(work, step);
	hawser__touch_measure(work->mesh);
	hawser__touch_follow(work->mesh);
	return step;
}

/* With obstacles Newton's method goes on: what touches and what is slack must be clear. */
static int near_enough(const struct hawser__net_work *work, double residual)
{
	double length = work->reach/work->mesh->elements;

	return residual <= fmax(work->tolerance, 1e-6*work->weight) &&
	       mean(work) <= 1e-9*work->weight*length;
}

enum hawser_status hawser__net_interior(struct hawser__net_work *work, int *done,
                                        struct hawser_report *report)
{
	double step = 1.0, best = INFINITY;
	int most = work->most ? work->most : MOST, idle = 0;
	enum hawser_status status = HAWSER_OK;

	*done = 0;
	begin(work);
	hawser__touch_begin(work->mesh, mean(work), work->weight/work->mesh->nodes);
	for (int i = 0; i < most && !status; i++) {
		double mu = (step < 0.5 ? 1.0 : 0.1)*mean(work), residual;
		int definite;

		assemble(work, mu);
		status = hawser__net_factor(work, &definite, report);
		if (status || !definite)
			break;
		status = hawser__touch_divide(work, &definite, report);
		if (status || !definite)
			break;
		step = advance(work, mu);
		work->factored = 0;
		work->iterations++;
		residual = hawser__net_residual(work);
		*done = work->mesh->touches ? near_enough(work, residual) : residual <= work->tolerance;
		idle = residual < 0.5*best ? 0 : idle + 1;
		best = fmin(best, residual);
		if (*done || !isfinite(residual) || idle > (work->mesh->touches ? 4*IDLE : IDLE))
			break;
	}
	return status;
}
