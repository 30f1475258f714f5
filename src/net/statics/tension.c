/* net/statics/tension.c - tensions at the nodes of a mesh.
 *
 * F     force vector of an element, T*e, along the cable
 * t     tension vector at a node, along the cable
 * f     load on half an element: weight, forces per length, less inertia and drag; of an obstacle too
 *
 * F is constant along an element, and equals t at its middle to second order: at a node it is off by
 * half an element's load, of first order. The balance of the half element gives t = F + f at the end
 * `from` of a cable, t = F - f at the end `to`, and the mean of both elements at nodes between: second
 * order everywhere, and without a jump at a joint of two cables. On an obstacle, where F turns by the
 * angle between two elements without a change of |F|, it is the mean of the two |F|.
 *
 * A node that a support holds on an obstacle has no contact of its own: the half element there is
 * carried as the other half next to it is, with the force per length of the next node. So an anchor on
 * the sea bed gets no weight. Friction there is at most what is left to hold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/vec3.h"
#include "net/statics/solve.h"
#include "net/water/water.h"

/* Of an element: a support this near to an obstacle is on it. */
static const double ON = 1e-6;

/* Unit vector along an element. */
static void direction(double e[3], const struct hawser__tensions *of, int element)
{
	const int *end = of->mesh->end[element];
	double l;

	for (int k = 0; k < 3; k++)
		e[k] = of->x[end[1]][k] - of->x[end[0]][k];
	l = sqrt(hawser__dot(e, e));
	for (int k = 0; k < 3; k++)
		e[k] = l > 0.0 ? e[k]/l : 0.0;
}

/* The obstacle that a node of this element is on, with its normal n; -1: none. */
static int obstacle_at(double n[3], const struct hawser__tensions *of, int node, int element)
{
	double H[3][3];

	for (int s = 0; of->obstacle && s < of->net->surfaces; s++)
		if (fabs(hawser_surface_gap(n, H, &of->net->surface[s], of->x[node])) <=
		    ON*of->mesh->length0[element])
			return s;
	return -1;
}

/* Unstretched length of the halves of elements at a node. */
static double halves(const struct hawser__mesh *mesh, int node)
{
	double sum = 0.0;

	for (int i = 0; i < 2*mesh->elements; i++)
		sum += mesh->end[i/2][i%2] == node ? mesh->length0[i/2]/2.0 : 0.0;
	return sum;
}

/* Friction: what of a force, in the direction of its part along the surface at `from`, is along that at
 * an end with the normal n. *N: its part along the normal. */
static void turned(double friction[3], double *N, const double n[3], const struct hawser__tensions *of,
                   int surface, int from)
{
	double H[3][3], other[3], size, along, left;

	(void)hawser_surface_gap(other, H, &of->net->surface[surface], of->x[from]);
	*N = hawser__dot(of->obstacle[from], other);
	for (int k = 0; k < 3; k++)
		friction[k] = of->obstacle[from][k] - *N*other[k];
	size = sqrt(hawser__dot(friction, friction));
	along = hawser__dot(friction, n);
	for (int k = 0; k < 3; k++)
		friction[k] -= along*n[k];
	left = sqrt(hawser__dot(friction, friction));
	for (int k = 0; k < 3; k++)
		friction[k] *= left > 0.0 ? size/left : 0.0;
}

/* What an obstacle carries of the half of an element at its end `side`: the force per length of the
 * next node or, in a cable of one element, of this one. Returns the obstacle, -1 if there is none. */
static int carried(double f[3], const struct hawser__tensions *of, int element, int side)
{
	const struct hawser__mesh *mesh = of->mesh;
	int c = mesh->cable[element], inner = mesh->first[c + 1] - mesh->first[c] > 1;
	int node = mesh->end[element][side], from = inner ? mesh->end[element][!side] : node;
	double n[3], e[3], N, against, part, scale;
	int surface = obstacle_at(n, of, node, element);

	memset(f, 0, 3*sizeof *f);
	if (surface < 0 || hawser__dot(of->obstacle[from], of->obstacle[from]) == 0.0 ||
	    mesh->rigid[from]) /* the force on a body's node is not that on its line */
		return -1;
	part = inner ? 0.5 : 0.5*mesh->length0[element]/halves(mesh, node);
	turned(f, &N, n, of, surface, from);
	direction(e, of, element);
	against = part*(side ? hawser__dot(f, e) : -hawser__dot(f, e));
	scale = against > of->T[element] ? fmax(of->T[element], 0.0)/against : 1.0;
	for (int k = 0; k < 3; k++)
		f[k] = part*(scale*f[k] + N*n[k]);
	return surface;
}

/* Load on the half of an element at its end `side`, which is an end of its cable. */
static void load(double f[3], const struct hawser__tensions *of, int element, int side)
{
	const struct hawser__mesh *mesh = of->mesh;
	const struct hawser_net *net = of->net;
	int node = mesh->end[element][side], other = mesh->end[element][!side], c = mesh->cable[element];
	double L = mesh->length0[element], m = mesh->rho[element]*L, drag = mesh->alpha*L;

	(void)carried(f, of, element, side);
	f[1] -= 0.5*m*net->g;
	for (int k = 0; mesh->water && k < 3; k++)
		f[k] += mesh->water->load[element][side][k];
	for (int i = 0; i < net->loads; i++) {
		const struct hawser_net_load *one = &net->load[i];
		const double *nodal = one->along ? one->along[side ? net->cable[c].elements : 0] : NULL;
		double factor = one->harmonic ? cos(one->Omega*of->t + one->phase) : 1.0;

		for (int k = 0; one->cable == c && (of->v || !one->harmonic) && k < 3; k++)
			f[k] += factor*(nodal ? nodal[k] : hawser__mesh_carried(mesh, one, element, side)*
			                                   one->value[k]);
	}
	for (int k = 0; of->v && k < 3; k++)
		f[k] -= (0.5 - of->far)*(m*of->a[node][k] + drag*of->v[node][k]) +
		        of->far*(m*of->a[other][k] + drag*of->v[other][k]);
}

/* T at node i of a cable; returns whether there is a tension vector t there. */
static int at_node(double t[3], double *T, const struct hawser__tensions *of, int cable, int i)
{
	int first = of->mesh->first[cable], last = of->mesh->first[cable + 1] - 1, node;
	int before = i > 0 ? first + i - 1 : -1, behind = first + i <= last ? first + i : -1;
	double e[3];

	memset(t, 0, 3*sizeof *t);
	if (before < 0 || behind < 0) {
		int element = before < 0 ? first : last;

		load(t, of, element, before >= 0);
		direction(e, of, element);
		for (int k = 0; k < 3; k++)
			t[k] = (before < 0 ? t[k] : -t[k]) + of->T[element]*e[k];
		*T = sqrt(hawser__dot(t, t));
		*T = of->T[element] < 0.0 ? -*T : *T;
		return *T >= 0.0;
	}
	*T = 0.5*(of->T[before] + of->T[behind]);
	node = of->mesh->end[behind][0];
	if (*T < 0.0 || (of->obstacle && hawser__dot(of->obstacle[node], of->obstacle[node]) > 0.0))
		return 0;
	for (int side = 0; side < 2; side++) {
		direction(e, of, side ? behind : before);
		for (int k = 0; k < 3; k++)
			t[k] += 0.5*of->T[side ? behind : before]*e[k];
	}
	*T = sqrt(hawser__dot(t, t));
	return 1;
}

void hawser__tension_vector(double t[3], const struct hawser__tensions *of, int cable, int i)
{
	double T;

	(void)at_node(t, &T, of, cable, i);
}

double hawser__tension_at(const struct hawser__tensions *of, int cable, int i)
{
	double t[3], T;

	(void)at_node(t, &T, of, cable, i);
	return T;
}

/* Between two nodes the load is uniform, so that t is linear; on an obstacle |F| is what there is. */
double hawser__tension_least(const struct hawser__tensions *of, int cable, int i)
{
	double a[3], b[3], T[2], change = 0.0, along = 0.0, part, F = of->T[of->mesh->first[cable] + i];
	int vectors = at_node(a, &T[0], of, cable, i);

	if (!(vectors & at_node(b, &T[1], of, cable, i + 1)))
		return fmin(F, fmin(T[0], T[1]));
	for (int k = 0; k < 3; k++) {
		b[k] -= a[k];
		change += b[k]*b[k];
		along -= a[k]*b[k];
	}
	part = change > 0.0 ? fmin(fmax(along/change, 0.0), 1.0) : 0.0;
	for (int k = 0; k < 3; k++)
		a[k] += part*b[k];
	return sqrt(hawser__dot(a, a));
}

void hawser__tension_obstacles(double (*force)[3], const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		for (int k = 0; k < 3 && touch->r > 0.0; k++)
			force[touch->node][k] += touch->r*touch->n[k] + touch->friction[k];
	}
}

int hawser__tension_rests(double force[3], double *length0, const struct hawser__tensions *of, int node)
{
	const struct hawser__mesh *mesh = of->mesh;
	int surface = -1;

	memset(force, 0, 3*sizeof *force);
	*length0 = 0.0;
	if (!of->obstacle || mesh->unknown[node][0] >= 0 || mesh->unknown[node][1] >= 0 ||
	    mesh->rigid[node])
		return -1;
	for (int i = 0; i < 2*mesh->elements; i++) {
		double f[3];
		int at = mesh->end[i/2][i%2] == node ? carried(f, of, i/2, i%2) : -1;

		for (int k = 0; at >= 0 && k < 3; k++)
			force[k] += f[k];
		if (at >= 0)
			*length0 += mesh->length0[i/2]/2.0;
		surface = at >= 0 ? at : surface;
	}
	return surface;
}
