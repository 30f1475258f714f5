/* net/statics/cone.c - equilibrium of a net as a second-order cone program: primal-dual interior point.
 *
 * s = (p, d)  bound on the length of an element, and the vector along it: |d| <= p
 * z = (T, w)  its tension, and minus its force vector: |w| <= T
 * c           length0/EA, so that p = length0 + c*T
 * u           scaling point of Nesterov and Todd: its quadratic representation P(u) has P(u) z = s
 * y, delta    P(u)^-1 = delta*(2 y y' - J) with J = diag(1, -1, -1, -1) and det y = 1
 *
 * The energy is the least of sum of c*T^2/2 - f.q subject to |d(q)| <= length0 + c*T. Both s and z
 * lie in the second-order cone, and s o z = mu e leads to the equilibrium as mu falls to 0. All
 * but this last equation is linear, unlike an interior point for q and T with the curved length
 * l(q), which fails on a third of random nets: this one converges from any start, whatever the
 * strains, ratios of stiffness and slack members are. Each cone is scaled on its own, so that
 * units and sizes do not matter. The matrix is a sum of blocks a*I + b*y*y', positive definite
 * also for rigid elements (c = 0), whose stiffness grows only as mu falls. Mehrotra's predictor
 * and corrector share the factors.
 *
 * Ref.: Andersen, Dahl, Vandenberghe, Interior-point methods for large-scale cone programming,
 * 2011.
 *
 * Near the solution p - |d| loses its digits, and the mean of s.z says nothing about the elements
 * with the smallest tensions. So an element leaves the program as soon as it is certainly taut,
 * and is treated as in net/statics/finish.c from then on; what remains in the end is slack.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/statics/solve.h"

enum { MOST = 100 };
#define FAR 0.99    /* part of the way to the boundary */
#define START 1.5   /* of the first bounds over length and force */
#define TAUT 1e-9   /* slack and errors of the length, relative, below which an element is taut */

struct cone {
	int in; /* 0: it has left the program, with the force work->N */
	double s[4], z[4], ds[4], dz[4];
	double y[4], delta;
	double g[4]; /* right side of this element */
	double c;
};

static double det(const double x[4])
{
	double v = sqrt(hawser__dot(x + 1, x + 1));

	return (x[0] - v)*(x[0] + v);
}

static void scale(struct cone *k)
{
	double ss = sqrt(det(k->s)), zz = sqrt(det(k->z)), gamma = 0.0;

	for (int i = 0; i < 4; i++)
		gamma += k->s[i]/ss*(k->z[i]/zz);
	gamma = 2.0*sqrt((1.0 + gamma)/2.0);
	for (int i = 0; i < 4; i++)
		k->y[i] = (k->z[i]/zz + (i ? -1.0 : 1.0)*k->s[i]/ss)/gamma;
	k->y[0] = sqrt(1.0 + hawser__dot(k->y + 1, k->y + 1));
	k->delta = zz/ss;
}

/* out = P(u)^-1 x. */
static void inverse(double out[4], const struct cone *k, const double x[4])
{
	double sum = 2.0*(k->y[0]*x[0] + hawser__dot(k->y + 1, x + 1));

	for (int i = 0; i < 4; i++)
		out[i] = k->delta*(k->y[i]*sum + (i ? x[i] : -x[0]));
}

/* out = W^-1 x with W^2 = P(u): the same form with the square root of y. */
static void root(double out[4], const struct cone *k, const double x[4])
{
	double n = 1.0/sqrt(2.0*(k->y[0] + 1.0)), v[4], sum, size = sqrt(k->delta);

	for (int i = 0; i < 4; i++)
		v[i] = (k->y[i] + (i == 0))*n;
	sum = 2.0*(v[0]*x[0] + hawser__dot(v + 1, x + 1));
	for (int i = 0; i < 4; i++)
		out[i] = size*(v[i]*sum + (i ? x[i] : -x[0]));
}

/* out = W x. */
static void forth(double out[4], const struct cone *k, const double x[4])
{
	double n = 1.0/sqrt(2.0*(k->y[0] + 1.0)), v[4], sum, size = 1.0/sqrt(k->delta);

	for (int i = 0; i < 4; i++)
		v[i] = (i ? -1.0 : 1.0)*(k->y[i] + (i == 0))*n;
	sum = 2.0*(v[0]*x[0] + hawser__dot(v + 1, x + 1));
	for (int i = 0; i < 4; i++)
		out[i] = size*(v[i]*sum + (i ? x[i] : -x[0]));
}

/* Length of s - (length0 + c*T, d): what the bound and the vector are off. */
static void mismatch(double r[4], const struct cone *k, const struct hawser__mesh *mesh, int i)
{
	const double *a = mesh->q[mesh->end[i][0]], *b = mesh->q[mesh->end[i][1]];

	r[0] = k->s[0] - mesh->length0[i] - k->c*k->z[0];
	for (int j = 0; j < 3; j++)
		r[j + 1] = k->s[j + 1] - (b[j] - a[j]);
}

/* The right side g of the linear equation dz + P(u)^-1 ds = v, with the mismatch. */
static void right(struct cone *k, const double v[4], const struct hawser__mesh *mesh, int i)
{
	double r[4], Hr[4];

	mismatch(r, k, mesh, i);
	inverse(Hr, k, r);
	for (int j = 0; j < 4; j++)
		k->g[j] = v[j] + Hr[j];
}

/* 1 + c*H00 with H = P(u)^-1. */
static double soft(const struct cone *k)
{
	return 1.0 + k->c*k->delta*(2.0*k->y[0]*k->y[0] - 1.0);
}

static void to_nodes(struct hawser__net_work *work, int i, const double force[3])
{
	const struct hawser__mesh *mesh = work->mesh;

	for (int end = 0; end < 2; end++)
		for (int k = 0; k < 3; k++) {
			int u = mesh->unknown[mesh->end[i][end]][k];

			if (u >= 0)
				work->x[u] += end ? force[k] : -force[k];
		}
}

/* work->x = step of the positions for the right sides g of the elements. */
static enum hawser_status solve(struct hawser__net_work *work, const struct cone *cones,
                                struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;

	hawser__net_right_loads(work);
	for (int i = 0; i < mesh->elements; i++) {
		const struct cone *k = &cones[i];
		double force[3], e[3], part = k->in ? 2.0*k->c*k->delta*k->y[0]*k->g[0]/soft(k) : 0.0;

		if (!k->in)
			hawser__mesh_direction(e, mesh, i);
		for (int j = 0; j < 3; j++)
			force[j] = k->in ? k->z[j + 1] + k->g[j + 1] - part*k->y[j + 1] : -work->T[i]*e[j];
		to_nodes(work, i, force);
	}
	return hawser__sparse_solve(work->x, work->sparse, report);
}

static enum hawser_status factor(struct hawser__net_work *work, const struct cone *cones, int *definite,
                                 struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;

	hawser__sparse_zero(work->sparse);
	for (int i = 0; i < mesh->elements; i++) {
		const struct cone *k = &cones[i];
		double e[3];

		if (k->in)
			hawser__sparse_add(work->sparse, i, k->delta,
			                   2.0*k->delta*(1.0 - k->c*k->delta)/soft(k), k->y + 1);
		else {
			hawser__mesh_direction(e, mesh, i);
			hawser__sparse_add(work->sparse, i, work->a[i], work->b[i], e);
		}
	}
	return hawser__sparse_factor(work->sparse, definite, report);
}

/* The steps of s and z that go with the step of the positions. */
static void follow(struct cone *k, const struct hawser__net_work *work, int i)
{
	double r[4], Hs[4];

	mismatch(r, k, work->mesh, i);
	hawser__net_stretch(k->ds + 1, work, i);
	k->ds[0] = (k->g[0] - 2.0*k->delta*k->y[0]*hawser__dot(k->y + 1, k->ds + 1))/soft(k)*k->c;
	inverse(Hs, k, k->ds);
	for (int j = 0; j < 4; j++) {
		k->dz[j] = k->g[j] - Hs[j];
		k->ds[j] -= r[j];
	}
}

/* Longest step from x along dx within the cone, at most 1/FAR. */
static double reach(const double x[4], const double dx[4])
{
	double a = det(dx), b = x[0]*dx[0] - hawser__dot(x + 1, dx + 1), c = det(x), root = b*b - a*c;
	double below;

	if (dx[0] < 0.0 && x[0] + dx[0]/FAR < 0.0 && root < 0.0)
		return -x[0]/dx[0];
	if (root < 0.0)
		return 1.0/FAR;
	below = sqrt(root) - b;
	return below > FAR*c ? c/below : 1.0/FAR;
}

static double longest(const struct cone *cones, const struct hawser__mesh *mesh)
{
	double step = 1.0/FAR;

	for (int i = 0; i < mesh->elements; i++)
		if (cones[i].in)
			step = fmin(step, fmin(reach(cones[i].s, cones[i].ds), reach(cones[i].z, cones[i].dz)));
	return step;
}

/* v = W^-1 (lambda \ (sigma*mu*e - lambda o lambda - (W^-1 ds) o (W dz))), the corrector. */
static void correct(double v[4], const struct cone *k, double mu)
{
	double lambda[4], s[4], z[4], r[4], x[4], sum = 0.0, own = 0.0;

	forth(lambda, k, k->z);
	root(s, k, k->ds);
	forth(z, k, k->dz);
	for (int i = 0; i < 4; i++) {
		sum += s[i]*z[i];
		own += lambda[i]*lambda[i];
	}
	r[0] = mu - own - sum;
	for (int i = 1; i < 4; i++)
		r[i] = -2.0*lambda[0]*lambda[i] - s[0]*z[i] - z[0]*s[i];
	x[0] = (lambda[0]*r[0] - hawser__dot(lambda + 1, r + 1))/det(lambda);
	for (int i = 1; i < 4; i++)
		x[i] = (r[i] - x[0]*lambda[i])/lambda[0];
	root(v, k, x);
}

/* The first bounds: around the lengths and forces of the start. */
static void begin(struct hawser__net_work *work, struct cone *cones)
{
	const struct hawser__mesh *mesh = work->mesh;
	double mu = 0.0, e[3];

	for (int i = 0; i < mesh->elements; i++) {
		double l = hawser__mesh_direction(e, mesh, i), L = mesh->length0[i];

		if (!(mesh->density[i] > 0.0))
			mu = fmax(mu, work->N[i]*fmax(l/L, 1.0)*fmax(l, L));
	}
	for (int i = 0; i < mesh->elements; i++) {
		struct cone *k = &cones[i];
		double l = hawser__mesh_direction(e, mesh, i), L = mesh->length0[i];
		double N = work->N[i]*l/L;

		k->c = L/mesh->EA[i];
		k->in = mesh->density[i] == 0.0;
		k->z[0] = fmax(START*N, 2.0*mu/(L + sqrt(L*L + 4.0*k->c*mu)));
		k->s[0] = fmax(L + k->c*k->z[0], START*l);
		for (int j = 0; j < 3; j++) {
			k->s[j + 1] = l*e[j];
			k->z[j + 1] = -N*e[j];
		}
	}
}

/* Mean of s.z. */
static double mean(const struct cone *cones, const struct hawser__mesh *mesh)
{
	double sum = 0.0;
	int count = 0;

	for (int i = 0; i < mesh->elements; i++)
		if (cones[i].in) {
			sum += cones[i].s[0]*cones[i].z[0] + hawser__dot(cones[i].s + 1, cones[i].z + 1);
			count++;
		}
	return count ? sum/count : 0.0;
}

/* Predictor, corrector, step; returns the length of the step in *step. */
static enum hawser_status iterate(struct hawser__net_work *work, struct cone *cones, double mu,
                                  double *step, struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status;
	int definite;

	*step = 0.0;
	for (int i = 0; i < mesh->elements; i++) {
		double v[4];

		if (!cones[i].in) {
			hawser__net_linear(work, i);
			continue;
		}
		scale(&cones[i]);
		for (int j = 0; j < 4; j++)
			v[j] = -cones[i].z[j];
		right(&cones[i], v, mesh, i);
	}
	status = factor(work, cones, &definite, report);
	if (status || !definite)
		return status;
	for (int pass = 0; pass < 2 && !status; pass++) {
		for (int i = 0; pass && i < mesh->elements; i++)
			if (cones[i].in) {
				double v[4];

				correct(v, &cones[i], mu*pow(1.0 - fmin(*step, 1.0), 3.0));
				right(&cones[i], v, mesh, i);
			}
		status = solve(work, cones, report);
		for (int i = 0; i < mesh->elements && !status; i++)
			if (cones[i].in)
				follow(&cones[i], work, i);
		*step = FAR*longest(cones, mesh);
	}
	for (int i = 0; i < mesh->elements && !status; i++)
		for (int j = 0; j < 4; j++) {
			cones[i].s[j] += *step*cones[i].ds[j];
			cones[i].z[j] += *step*cones[i].dz[j];
			if (!cones[i].in && j == 0)
				work->N[i] += *step*(hawser__net_force_after(work, i) - work->N[i]);
		}
	if (!status)
		hawser__net_move(work, *step);
	return status;
}

/* Take the elements out of the program that are taut. Returns 1 if no other has a tension. */
static int sort_out(struct hawser__net_work *work, struct cone *cones)
{
	const struct hawser__mesh *mesh = work->mesh;
	int left = 0;

	for (int i = 0; i < mesh->elements; i++) {
		struct cone *k = &cones[i];
		double off = 0.0, r[4];

		if (!k->in)
			continue;
		mismatch(r, k, mesh, i);
		for (int j = 0; j < 4; j++)
			off = fmax(off, fabs(r[j]));
		k->in = k->s[0] - sqrt(hawser__dot(k->s + 1, k->s + 1)) > TAUT*k->s[0] || off > TAUT*k->s[0];
		work->N[i] = k->in ? 0.0 : sqrt(hawser__dot(k->z + 1, k->z + 1));
		left += k->in && k->z[0] > 0.1*work->wanted;
	}
	return !left;
}

/* The program: to N, positions and slack elements near the solution. */
static enum hawser_status first(struct hawser__net_work *work, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	struct cone *cones = calloc((size_t)mesh->elements, sizeof *cones);
	int most = work->most ? work->most : MOST;
	int done = 0;
	enum hawser_status status = cones ? HAWSER_OK : hawser__no_memory(report, "net");

	if (cones)
		begin(work, cones);
	for (int i = 0; i < most && !status && !done; i++) {
		double mu = mean(cones, mesh), step;

		status = iterate(work, cones, mu, &step, report);
		work->iterations++;
		work->factored = 0;
		if (!status)
			done = sort_out(work, cones);
		if (!(step > 1e-8) || !isfinite(mu))
			break;
	}
	free(cones);
	return status;
}

enum hawser_status hawser__net_cone(struct hawser__net_work *work, int *done,
                                    struct hawser_report *report)
{
	enum hawser_status status = first(work, report);

	*done = 0;
	return status ? status : hawser__net_finish(work, done, report);
}
