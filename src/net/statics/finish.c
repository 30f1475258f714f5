/* net/statics/finish.c - the last iterations of statics: Newton's method for positions and forces, with
 * slack members.
 *
 * N  force of an element, 0 if it is slack: an unknown of its own, which the law
 *    EA*(l/length0 - 1) gives at the solution only
 *
 * From a start close to the equilibrium: that of net/statics/cone.c, or the catenaries. Newton's method
 * for the positions alone takes T(q) in the geometric stiffness, over-stretches far from the solution
 * and compresses elements. With N as an unknown, eliminated element by element, the matrix
 * sum of (EA/length0)*e*e' + (N/l)*(I - e*e') is positive definite, and 7 iterations do. Slack elements
 * have no force: an element turns slack where its force becomes negative, and taut where its length
 * exceeds length0.
 *
 * Positions in double precision give the tension of a stiff element only to
 * EA*ulp(position)/length0, which may exceed the loads. N does not have this error: what is
 * verified is that the forces N balance, and that each differs by no more than the tolerance from a
 * force by the law at positions that differ by some ulp: an element that is slack has none.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "net/statics/solve.h"
#include "net/touch/touch.h"

enum { MOST = 25, WORSE = 6 };
#define ROUND 8.0   /* operations whose errors of one ulp each add up, in the bounds of round-off */
#define GUARD 1e-10 /* of the loads: what a slack element gives to the matrix, not to the balance */

static double law(const struct hawser__mesh *mesh, int i, double l)
{
	return l > mesh->length0[i] ? mesh->EA[i]*((l - mesh->length0[i])/mesh->length0[i]) : 0.0;
}

/* Largest coordinate of an element, or its length. */
static double reach_of(const struct hawser__mesh *mesh, int i)
{
	const double *a = mesh->q[mesh->end[i][0]], *b = mesh->q[mesh->end[i][1]];
	double reach = mesh->length0[i];

	for (int k = 0; k < 3; k++)
		reach = fmax(reach, fmax(fabs(a[k]), fabs(b[k])));
	return reach;
}

/* Error of a length by that of the positions. */
static double error_of(const struct hawser__mesh *mesh, int i)
{
	return ROUND*DBL_EPSILON*reach_of(mesh, i);
}

double hawser__net_lawful_force(const struct hawser__mesh *mesh, int i, double l, double N)
{
	double error = error_of(mesh, i);

	return fmin(fmax(N, law(mesh, i, l - error)), law(mesh, i, l + error));
}

/* residual = minus the loads; bound = 0. */
static void clear(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; i < mesh->nodes; i++) {
		work->bound[i] = 0.0;
		for (int k = 0; k < 3; k++)
			work->residual[i][k] = -mesh->force[i][k];
	}
}

int hawser__net_settled(struct hawser__net_work *work, double *most, double *floor)
{
	const struct hawser__mesh *mesh = work->mesh;
	int settled = 1;

	clear(work);
	*most = *floor = 0.0;
	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = hawser__mesh_direction(e, mesh, i), T = law(mesh, i, l), N = work->N[i];
		double ulp = error_of(mesh, i);

		if (mesh->density[i] > 0.0)
			N = T = mesh->density[i]*l;
		else if (fabs(N) <= work->wanted)
			N = T; /* so that what is slack has no force at all */
		if (mesh->density[i] <= 0.0 &&
		    !(fabs(N - hawser__net_lawful_force(mesh, i, l, N)) <= work->wanted))
			settled = 0;
		work->T[i] = N;
		for (int end = 0; end < 2; end++) {
			int node = mesh->end[i][end];

			work->bound[node] += N*(ulp/fmax(l, ulp) + ROUND*DBL_EPSILON);
			for (int k = 0; k < 3; k++)
				work->residual[node][k] += end ? N*e[k] : -N*e[k];
		}
	}
	hawser__touch_forces(work->residual, mesh);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			double r = fabs(work->residual[i][k]);

			if (mesh->unknown[i][k] < 0)
				continue;
			if (!(r <= *most))
				*most = r;
			*floor = fmax(*floor, work->bound[i]);
			if (!(r <= fmax(work->wanted, work->bound[i])))
				settled = 0;
		}
	return settled;
}

int hawser__net_lawful(struct hawser__net_work *work)
{
	if (!(hawser__net_residual(work) <= work->wanted))
		return 0;
	work->own = 0;
	return 1;
}

/* The stiffness along an element, which stays within what the factors can tell from that across
 * it. */
static double along_of(const struct hawser__mesh *mesh, int i, double across)
{
	return fmin(mesh->EA[i]/mesh->length0[i], HAWSER__NET_RIGID*across);
}

void hawser__net_linear(struct hawser__net_work *work, int i)
{
	const struct hawser__mesh *mesh = work->mesh;
	double e[3], l = fmax(hawser__mesh_direction(e, mesh, i), 1e-12*mesh->length0[i]), N = work->N[i];

	work->b[i] = work->T[i] = 0.0;
	if (mesh->density[i] > 0.0) {
		work->a[i] = mesh->density[i];
		work->T[i] = mesh->density[i]*l;
	} else if (N > 0.0) {
		double along = along_of(mesh, i, work->a[i] = N/l);

		work->b[i] = along - work->a[i];
		work->T[i] = N + along*(l - mesh->length0[i] - N*mesh->length0[i]/mesh->EA[i]);
	} else
		work->a[i] = GUARD*work->weight/l;
}

double hawser__net_force_after(const struct hawser__net_work *work, int i)
{
	const struct hawser__mesh *mesh = work->mesh;
	double e[3], d[3], l = hawser__mesh_direction(e, mesh, i), longer;

	hawser__net_stretch(d, work, i);
	longer = e[0]*d[0] + e[1]*d[1] + e[2]*d[2];
	if (mesh->density[i] > 0.0)
		return 0.0;
	return work->N[i] > 0.0 ? fmax(work->T[i] + (work->b[i] + work->a[i])*longer, 0.0)
	                        : law(mesh, i, l + longer);
}

static enum hawser_status step(struct hawser__net_work *work, int *definite,
                               struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status;

	for (int i = 0; i < mesh->elements; i++)
		hawser__net_linear(work, i);
	hawser__net_right(work, work->T);
	status = hawser__net_factor(work, definite, report);
	if (status || !*definite)
		return status;
	status = hawser__touch_divide(work, definite, report);
	if (status || !*definite)
		return status;
	for (int i = 0; i < mesh->elements; i++)
		work->N[i] = hawser__net_force_after(work, i);
	hawser__net_move(work, 1.0);
	work->iterations++;
	return HAWSER_OK;
}

enum hawser_status hawser__net_finish(struct hawser__net_work *work, int *done,
                                      struct hawser_report *report)
{
	double best = INFINITY, residual, floor;
	enum hawser_status status = HAWSER_OK;
	int worse = 0, definite = 1;

	work->own = 1;
	*done = hawser__net_settled(work, &residual, &floor);
	for (int i = 0; i < MOST && !*done && !status && definite && worse < WORSE; i++) {
		status = step(work, &definite, report);
		if (!status && definite)
			*done = hawser__net_settled(work, &residual, &floor);
		worse = residual < 0.5*best ? 0 : worse + 1;
		best = fmin(best, residual);
		if (!isfinite(residual))
			break;
	}
	if (!status && !*done)
		*done = hawser__net_lawful(work);
	return status;
}
