/* net/motion/motion-bed.c - beds that give way, planes and others, in the time steps of a mesh.
 *
 * s0, s1  depth of a node in the bed at both ends of the step, below 0 above it
 * p       max(s, 0); W = k*p^2/2 its energy, and c*p' the damping of its rate
 *
 * The force along the normal is the discrete gradient of W, (W1 - W0)/(s1 - s0), and c*(p1 -
 * p0)/h, as that of an element along itself (net/motion/motion-law.c); it does not pull. So the
 * change of W is kept exactly, and the damping only takes energy.
 *
 * Friction T is that of springs along the plane, which slide where |T| would be above mu*N: with the
 * slip x relative to the plane it is T0 - stiff*x, or what is nearest to it in the circle of mu*N, or
 * in the ellipse of two coefficients, whose normal is the way that it slides. It acts over all of the
 * step, so that springs that stick lose some energy too, and none is won.
 *
 * Elements that lie in part add their forces (net/motion/motion-touchdown.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion-bed.h"
#include "net/motion/motion-contact.h"

enum { PROJECTIONS = 30 }; /* most steps of Newton's method for the multiplier; chosen */

/* The friction nearest to q in the ellipse with the half axes a N and b N, and its derivatives by q and
 * N. With A the squares of the half axes and m the multiplier of the constraint, each component is
 * A q/(A + m). */
static void within(double T[2], double by_q[2][2], double by_N[2], const double q[2], double a,
                   double b, double N)
{
	const double A[2] = {a*a*N*N, b*b*N*N};
	double m = 0.0, size, w[2], k;

	memset(by_q, 0, 4*sizeof(double));
	memset(by_N, 0, 2*sizeof *by_N);
	memcpy(T, q, 2*sizeof *T);
	if (A[0]*q[1]*q[1] + A[1]*q[0]*q[0] <= A[0]*A[1] && A[0]*A[1] > 0.0) {
		by_q[0][0] = by_q[1][1] = 1.0;
		return;
	}
	for (int i = 0; i < 2; i++)
		T[i] = 0.0;
	if (!(N > 0.0))
		return;
	for (int n = 0; n < PROJECTIONS; n++) { /* Newton's method for 1/size = 1, exact for a circle */
		size = k = 0.0;
		for (int i = 0; i < 2; i++) {
			double part = q[i]/(A[i] + m);

			size += A[i]*part*part;
			k += A[i]*part*part/(A[i] + m);
		}
		size = sqrt(size);
		if (fabs(size - 1.0) <= 4.0*DBL_EPSILON || !(k > 0.0))
			break;
		m = fmax(m + (size - 1.0)*size*size/k, 0.0);
	}
	for (int i = 0; i < 2; i++) {
		T[i] = A[i]*q[i]/(A[i] + m);
		w[i] = T[i]/(A[i] + m);
	}
	for (int i = 0; i < 2; i++) {
		for (int j = 0; j < 2; j++)
			by_q[i][j] = (i == j ? A[i]/(A[i] + m) : 0.0) - (k > 0.0 ? w[i]*w[j]/k : 0.0);
		by_N[i] = (T[i] - by_q[i][0]*q[0] - by_q[i][1]*q[1])/N; /* T is of degree 1 in q and N */
	}
}

/* Two directions along the plane: that of the cable, at the beginning of the step, and across it. */
static void directions(double e[2][3], const struct hawser__motion *motion,
                       const struct hawser__bed_node *of)
{
	const struct hawser__touch *touch = &motion->mesh->touch[of->touch];
	const int element[2] = {touch->element, touch->other};
	double l;

	memset(e, 0, 6*sizeof(double));
	for (int i = 0; i < 2 && element[i] >= 0; i++) {
		const struct hawser__motion_element *el = &motion->element[element[i]];

		for (int k = 0; k < 3 && el->l > 0.0; k++)
			e[0][k] += el->d[k]/el->l;
	}
	for (int try = 0; try < 3; try++) { /* where the cable is upright, any */
		double off = hawser__dot(e[0], of->n0);

		for (int k = 0; k < 3; k++)
			e[0][k] -= off*of->n0[k];
		l = hawser__norm(e[0]);
		if (l > 0.1)
			break;
		for (int k = 0; k < 3; k++)
			e[0][k] = k == try;
	}
	for (int k = 0; k < 3; k++)
		e[0][k] /= l;
	hawser__cross(e[1], of->n0, e[0]);
}

/* Friction of the step, for the force N across the plane, and what it adds to the block of the node
 * and to what follows N. */
static void rub(double T[3], double *block, const struct hawser__motion *motion,
                struct hawser__bed_node *of, double N, double h)
{
	const struct hawser__touch *touch = &motion->mesh->touch[of->touch];
	const struct hawser_surface *plane = touch->surface;
	const struct hawser__motion_touch *now = &motion->contact->touch[of->touch];
	const double *x = motion->x[touch->node], stiff = HAWSER__STIFFER_ALONG*of->k;
	double e[2][3], q[2] = {0.0}, along[2], by_q[2][2], by_N[2];

	directions(e, motion, of);
	for (int k = 0; k < 6; k++)
		q[k/3] += e[k/3][k % 3]*(now->T[k % 3] - stiff*(x[k % 3] - h*of->v[k % 3]));
	within(along, by_q, by_N, q, plane->axial > 0.0 ? plane->axial : plane->friction, plane->friction,
	       N);
	for (int k = 0; k < 3; k++) {
		T[k] = along[0]*e[0][k] + along[1]*e[1][k];
		of->push[k] += by_N[0]*e[0][k] + by_N[1]*e[1][k];
	}
	for (int i = 0; i < 36 && block; i++)
		block[i/4] += stiff*by_q[i % 4/2][i % 2]*e[i % 4/2][i/12]*e[i % 2][i/4 % 3];
}

/* Depth of a node with the displacements u, and the normal there; far above the bed more than it. */
static double depth(double n[3], const struct hawser__motion *motion, struct hawser__bed_node *of,
                    const double (*u)[3])
{
	const struct hawser__touch *touch = &motion->mesh->touch[of->touch];
	double at[3];

	for (int k = 0; k < 3; k++)
		at[k] = motion->reference[touch->node][k] + u[touch->node][k];
	return -hawser__clear_gap(n, &of->clear, touch->surface, at, motion->bed->reach);
}

/* s1 and the normals, for motion->x. Of a plane they are those of the beginning; what stays above all
 * elements that may lie keeps its depth. */
static void follow(struct hawser__bed_node *of, const struct hawser__motion *motion, int at_rest)
{
	const struct hawser__touch *touch = &motion->mesh->touch[of->touch];
	const double *x = motion->x[touch->node];
	double from[3], to[3], H[3][3];

	if (!touch->surface->heights) {
		of->s1 = of->s0 - hawser__dot(of->n0, x);
		return;
	}
	of->s1 = of->s0;
	if (-of->s0 - hawser__norm(x) > motion->bed->reach)
		return;
	for (int k = 0; k < 3; k++) {
		from[k] = motion->reference[touch->node][k] + motion->u0[touch->node][k];
		to[k] = from[k] + x[k];
	}
	if (-of->s0 > motion->bed->reach) /* it is known to be above that alone */
		of->s0 = -hawser__clear_gap(of->n0, &of->clear, touch->surface, from, INFINITY);
	of->s1 = -hawser_surface_gap(of->n1, H, touch->surface, to);
	memcpy(of->n, of->n1, sizeof of->n);
	memcpy(of->n_x, H, sizeof H);
	if (!at_rest)
		hawser__mean_normal(of->n, of->n_x, touch->surface, from, to, of->s0 - of->s1, of->n0, of->n1,
		                    (const double (*)[3])H);
}

void hawser__bed_prepare(struct hawser__motion *motion)
{
	struct hawser__bed *bed = motion->bed;

	for (int i = 0; i < bed->nodes; i++) {
		struct hawser__bed_node *at = &bed->node[i];
		const struct hawser__touch *touch = &motion->mesh->touch[at->touch];
		double place[3];

		at->s0 = depth(at->n0, motion, at, (const double (*)[3])motion->u0);
		memcpy(at->n1, at->n0, sizeof at->n0);
		memcpy(at->n, at->n0, sizeof at->n0);
		memcpy(at->v, touch->surface->velocity, sizeof at->v);
		for (int k = 0; k < 3; k++)
			place[k] = motion->reference[touch->node][k] + motion->u0[touch->node][k];
		if (touch->surface->speed != 0.0)
			hawser_surface_velocity(at->v, touch->surface, place);
	}
	for (int i = 0; i < bed->touchdowns; i++) {
		struct hawser__touchdown *at = &bed->touchdown[i];

		hawser__touchdown_begin(at, (const double [2]){bed->node[at->end[0]].s0,
		                                               bed->node[at->end[1]].s0});
	}
}

/* Force of the step, and its derivative by s1. */
static double force(double *slope, const struct hawser__bed_node *of,
                    const struct hawser__motion_rule *rule, double h)
{
	double p0 = fmax(of->s0, 0.0), p1 = fmax(of->s1, 0.0), N = of->more, ratio;

	*slope = of->slope;
	if (rule->weight >= 0.0) { /* an equilibrium, or the accelerations of a state */
		*slope += p1 > 0.0 ? of->k : 0.0;
		return N + of->k*p1;
	}
	if (p0 > 0.0 && p1 > 0.0) {
		N += 0.5*of->k*(p0 + p1);
		*slope += 0.5*of->k;
	} else if (p1 > 0.0) {
		ratio = p1/(of->s1 - of->s0);
		N += 0.5*of->k*p1*ratio;
		*slope += of->k*ratio*(1.0 - 0.5*ratio);
	} else if (p0 > 0.0) {
		ratio = p0/(of->s0 - of->s1);
		N += 0.5*of->k*p0*ratio;
		*slope += 0.5*of->k*ratio*ratio;
	}
	N += of->c*(p1 - p0)/h;
	*slope += p1 > 0.0 ? of->c/h : 0.0;
	if (N >= 0.0)
		return N;
	*slope = 0.0;
	return 0.0;
}

/* The elements with both ends in the list. */
static void touchdowns(struct hawser__motion *motion)
{
	struct hawser__bed *bed = motion->bed;
	const struct hawser__mesh *mesh = motion->mesh;

	bed->touchdowns = 0;
	memset(bed->first, 0, (size_t)motion->nodes*sizeof *bed->first);
	for (int i = bed->nodes; i > 0; i--)
		bed->first[mesh->touch[bed->node[i - 1].touch].node] = i;
	for (int e = 0; e < motion->elements; e++) {
		int a = bed->first[motion->element[e].a] - 1, b = bed->first[motion->element[e].b] - 1;
		const struct hawser_surface *plane;

		if (a < 0 || b < 0 || motion->element[e].rod)
			continue;
		plane = mesh->touch[bed->node[a].touch].surface;
		if (mesh->touch[bed->node[b].touch].surface == plane &&
		    hawser__touchdown_of(&bed->touchdown[bed->touchdowns], motion, e, plane)) {
			const struct hawser__touchdown *of = &bed->touchdown[bed->touchdowns];

			bed->reach = fmax(bed->reach, 0.5*of->curvature*of->L*of->L);
			bed->touchdown[bed->touchdowns].end[0] = a;
			bed->touchdown[bed->touchdowns++].end[1] = b;
		}
	}
}

static void list(struct hawser__motion *motion)
{
	const struct hawser__mesh *mesh = motion->mesh;
	struct hawser__bed *bed = motion->bed;

	bed->nodes = 0;
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		struct hawser__bed_node *to = &bed->node[bed->nodes];

		if (!(touch->give > 0.0))
			continue;
		*to = (struct hawser__bed_node){.touch = i, .k = 1.0/touch->give};
		to->c = to->k*touch->surface->damping/touch->surface->stiffness;
		(void)hawser_surface_gap(to->n, NULL, touch->surface, mesh->q[touch->node]);
		bed->nodes++;
	}
	touchdowns(motion);
}

enum hawser_status hawser__bed_open(struct hawser__motion *motion, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = motion->mesh;
	size_t nodes = (size_t)motion->nodes, count = 0;
	struct hawser__bed *bed;

	for (int i = 0; i < mesh->touches; i++)
		count += mesh->touch[i].give > 0.0;
	if (!count)
		return HAWSER_OK;
	bed = motion->bed = calloc(1, sizeof *bed);
	if (!bed)
		return hawser__no_memory(report, "net");
	count += (size_t)(mesh->net->failures*mesh->net->surfaces); /* where cables may part */
	bed->node = hawser__hold(&bed->hold, count, sizeof *bed->node);
	bed->first = hawser__hold(&bed->hold, nodes + 1, sizeof *bed->first);
	bed->touchdown = hawser__hold(&bed->hold, (size_t)motion->elements + 1, sizeof *bed->touchdown);
	if (!motion->block)
		motion->block = hawser__hold(&bed->hold, nodes, sizeof *motion->block);
	if (!motion->other)
		motion->other = hawser__hold(&bed->hold, (size_t)motion->elements + 1, sizeof *motion->other);
	if (bed->hold.short_of_memory)
		return hawser__no_memory(report, "net");
	list(motion);
	return HAWSER_OK;
}

void hawser__bed_part(struct hawser__motion *motion, int from, int to)
{
	struct hawser__mesh *mesh = motion->mesh;

	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *a = &mesh->touch[i];

		for (int j = 0; j < mesh->touches && a->node == from && a->give > 0.0; j++) {
			struct hawser__touch *b = &mesh->touch[j];

			for (int k = 0; k < 3 && b->node == to && b->number == a->number; k++) {
				b->friction[k] = a->friction[k]*a->give/(a->give + b->give);
				a->friction[k] -= b->friction[k];
			}
		}
	}
	list(motion);
}

void hawser__bed_clear(struct hawser__bed *bed)
{
	if (!bed)
		return;
	hawser__hold_clear(&bed->hold);
	free(bed);
}

/* What an element that lies in part adds at its ends. */
static void lay(struct hawser__bed *bed, struct hawser__touchdown *of, int at_rest)
{
	struct hawser__bed_node *end[2] = {&bed->node[of->end[0]], &bed->node[of->end[1]]};
	const double s0[2] = {end[0]->s0, end[1]->s0}, s1[2] = {end[0]->s1, end[1]->s1};
	double F[2];

	if (at_rest)
		(void)hawser__touchdown_energy(F, of->F_s, of, s1);
	else
		hawser__touchdown_mean(F, of->F_s, of, s0, s1);
	for (int i = 0; i < 2; i++) {
		end[i]->more += F[i];
		end[i]->slope += of->F_s[i][i];
	}
}

/* In the matrix, what the depth of one end changes at the other. */
static void couple(struct hawser__motion *motion, const struct hawser__touchdown *of)
{
	double *B[2] = {motion->B[of->element], motion->other[of->element]};

	for (int i = 0; i < 2; i++) {
		const struct hawser__bed_node *end = &motion->bed->node[of->end[i]];
		const struct hawser__bed_node *other = &motion->bed->node[of->end[!i]];
		double *block = motion->block[motion->mesh->touch[end->touch].node];

		for (int k = 0; k < 9; k++) {
			double change = of->F_s[i][!i]*end->push[k/3]*other->n1[k % 3];

			B[i][k] -= change;
			block[k] += change; /* B is there too */
		}
	}
}

double hawser__bed_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                            double h, int tangent)
{
	struct hawser__bed *bed = motion->bed;
	double most = 0.0;

	tangent = tangent && rule->weight != 0.0; /* of accelerations: M a = r */
	for (int i = 0; i < bed->nodes; i++) {
		struct hawser__bed_node *at = &bed->node[i];

		follow(at, motion, rule->weight >= 0.0);
		at->more = at->slope = 0.0;
		memcpy(at->push, at->n, sizeof at->push);
	}
	for (int i = 0; i < bed->touchdowns; i++)
		lay(bed, &bed->touchdown[i], rule->weight >= 0.0);
	for (int i = 0; i < bed->nodes; i++) {
		struct hawser__bed_node *at = &bed->node[i];
		int node = motion->mesh->touch[at->touch].node;
		double slope, N = force(&slope, at, rule, h);

		for (int k = 0; k < 3; k++)
			motion->r[node][k] -= N*at->n[k];
		if (motion->contact) {
			double *T = motion->contact->touch[at->touch].rubbed;

			motion->contact->touch[at->touch].given = N;
			if (motion->mesh->touch[at->touch].surface->friction > 0.0 && rule->weight < 0.0)
				rub(T, tangent ? motion->block[node] : NULL, motion, at, N, h);
			for (int k = 0; k < 3; k++)
				motion->r[node][k] -= T[k];
		}
		for (int k = 0; k < 9 && tangent; k++)
			motion->block[node][k] += slope*at->push[k/3]*at->n1[k % 3] - N*at->n_x[k/3][k % 3];
		most = fmax(most, N);
	}
	for (int i = 0; i < bed->touchdowns && tangent; i++)
		couple(motion, &bed->touchdown[i]);
	return most;
}

void hawser__bed_forces(struct hawser__mesh *mesh, const struct hawser__bed *bed)
{
	for (int i = 0; i < bed->nodes; i++)
		mesh->touch[bed->node[i].touch].r = bed->node[i].k*fmax(bed->node[i].s1, 0.0) +
		                                    bed->node[i].more;
}

double hawser__bed_energy(const struct hawser__motion *motion)
{
	struct hawser__bed *bed = motion->bed;
	const double (*u)[3] = (const double (*)[3])motion->u;
	double sum = 0.0, F[2];

	for (int i = 0; i < bed->nodes; i++) {
		struct hawser__bed_node *at = &bed->node[i];
		const double *T = motion->contact ? motion->contact->touch[at->touch].T : NULL;
		double n[3], p;

		at->s = depth(n, motion, at, u);
		p = fmax(at->s, 0.0);

		sum += 0.5*at->k*p*p;
		sum += T ? 0.5*hawser__dot(T, T)/(HAWSER__STIFFER_ALONG*at->k) : 0.0;
	}
	for (int i = 0; i < bed->touchdowns; i++) {
		const int *end = bed->touchdown[i].end;
		const double s[2] = {bed->node[end[0]].s, bed->node[end[1]].s};

		sum += hawser__touchdown_energy(F, NULL, &bed->touchdown[i], s);
	}
	return sum;
}

/* What the friction of a step takes, and what the plane gives where it moves. */
static void rubbed(struct hawser__motion *motion, const struct hawser__bed_node *of, double h)
{
	const int node = motion->mesh->touch[of->touch].node;
	struct hawser__motion_touch *touch = &motion->contact->touch[of->touch];
	const double *x = motion->x[node], *T = touch->rubbed, *before = touch->T;
	double drives = h*hawser__dot(T, of->v);
	double lost = drives - hawser__dot(T, x) - 0.5*(hawser__dot(T, T) - hawser__dot(before, before))/
	                                    (HAWSER__STIFFER_ALONG*of->k);
	motion->contact->friction += lost;
	motion->contact->surfaces += drives;
	motion->energy.dissipated += lost;
	motion->energy.work += drives;
	memcpy(touch->T, T, sizeof touch->T);
}

void hawser__bed_account(struct hawser__motion *motion, double h)
{
	for (int i = 0; i < motion->bed->nodes; i++) {
		const struct hawser__bed_node *at = &motion->bed->node[i];
		double p0 = fmax(at->s0, 0.0), p1 = fmax(at->s1, 0.0);
		double N = motion->contact->touch[at->touch].given - at->more;

		motion->energy.dissipated += N*(at->s1 - at->s0) - 0.5*at->k*(p1 - p0)*(p1 + p0);
		rubbed(motion, at, h);
	}
}
