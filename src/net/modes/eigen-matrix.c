/* net/modes/eigen-matrix.c - stiffness and mass of a mesh, as products and as sparse matrices; see
 * eigen.h.
 *
 * Nodes that touch obstacles move in the directions of mesh->frame that are left, and K has -r*H
 * of each touch (H: second derivatives of the gap). The energy along a path on the obstacle has
 * that second derivative: q'' is not 0 there, and the gradient of the energy is r*n. B (3.109)
 * leaves it out. A rope that runs round freely has a K that is only semidefinite; then K +
 * lift*M, whose modes are those of K, is taken in its place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <cblas.h>

#include "core/vec3.h"
#include "net/body.h"
#include "net/modes/eigen.h"
#include "net/water/water.h"

/* y += v at a node. */
static void scatter(double *y, const struct hawser__mesh *mesh, int node, const double v[3])
{
	if (mesh->body && mesh->rigid[node])
		hawser__body_push(y + mesh->body[mesh->rigid[node] - 1].first, mesh, node, v);
	for (int k = 0; k < 3; k++) {
		const double *f = mesh->frame ? mesh->frame[node][k] : NULL;

		if (mesh->unknown[node][k] >= 0)
			y[mesh->unknown[node][k]] += f ? f[0]*v[0] + f[1]*v[1] + f[2]*v[2] : v[k];
	}
}

/* y += the added mass times x: of the motion along one direction, what its inertia is in the whole.
 * */
static void added(double *y, const double *x, const struct hawser__mesh *mesh, unsigned along)
{
	struct hawser__water_mass at;
	double a[3], b[3];

	for (int j = 0; hawser__water_mass(&at, mesh, j); j++) {
		hawser__eigen_place(a, x, mesh, at.node);
		for (int k = 0; k < 3; k++)
			b[k] = along & (1U << k) ? hawser__dot(at.mass[k], a) : 0.0;
		scatter(y, mesh, at.node, b);
	}
}

/* y += what the strokes of absorbers add to the masses of their nodes, times x. */
static void strokes(double *y, const double *x, const struct hawser__mesh *mesh, unsigned along)
{
	for (int i = 0; i < mesh->absorbers; i++) {
		const struct hawser__mesh_absorber *of = &mesh->absorber[i];
		double u[3], stroke[3], force[3], own[3] = {0.0};

		hawser__eigen_place(u, x, mesh, of->node);
		hawser__eigen_place(stroke, x, mesh, of->at);
		for (int k = 0; k < 3; k++) {
			double e = along & (1U << k) ? of->mass*of->e[k] : 0.0;

			force[k] = e*stroke[of->axis];
			own[of->axis] += e*(u[k] + of->e[k]*stroke[of->axis]);
		}
		scatter(y, mesh, of->node, force);
		scatter(y, mesh, of->at, own);
	}
}

void hawser__eigen_mass(double *y, const double *x, const struct hawser__mesh *mesh, unsigned along)
{
	double a[3], b[3], to[3], from[3];

	memset(y, 0, (size_t)mesh->unknowns*sizeof *y);
	for (int i = 0; i < mesh->nodes; i++) {
		if (!(mesh->mass[i] > 0.0))
			continue;
		hawser__eigen_place(a, x, mesh, i);
		for (int k = 0; k < 3; k++)
			a[k] *= along & (1U << k) ? mesh->mass[i] : 0.0;
		scatter(y, mesh, i, a);
	}
	for (int e = 0; e < mesh->elements; e++) {
		double m = mesh->rho[e]*mesh->length0[e]/12.0;

		hawser__eigen_place(a, x, mesh, mesh->end[e][0]);
		hawser__eigen_place(b, x, mesh, mesh->end[e][1]);
		for (int k = 0; k < 3; k++) {
			int with = (along & (1U << k)) != 0;

			from[k] = with ? m*(5.0*a[k] + b[k]) : 0.0;
			to[k] = with ? m*(5.0*b[k] + a[k]) : 0.0;
		}
		scatter(y, mesh, mesh->end[e][0], from);
		scatter(y, mesh, mesh->end[e][1], to);
	}
	added(y, x, mesh, along);
	strokes(y, x, mesh, along);
	for (int i = 0; i < mesh->rotors && along == 7U; i++) /* turns along no axis */
		y[mesh->rotor[i].unknown] += mesh->rotor[i].mass*x[mesh->rotor[i].unknown];
}

void hawser__eigen_place(double x[3], const double *phi, const struct hawser__mesh *mesh, int node)
{
	const int *unknown = mesh->unknown[node];

	if (mesh->body && mesh->rigid[node]) {
		hawser__body_place(x, phi + mesh->body[mesh->rigid[node] - 1].first, mesh, node);
		return;
	}
	if (!mesh->frame) {
		for (int k = 0; k < 3; k++)
			x[k] = unknown[k] >= 0 ? phi[unknown[k]] : 0.0;
		return;
	}
	x[0] = x[1] = x[2] = 0.0;
	for (int k = 0; k < 3; k++)
		for (int i = 0; i < 3 && unknown[k] >= 0; i++)
			x[i] += phi[unknown[k]]*mesh->frame[node][k][i];
}

/* y += the springs to the ground times x. */
static void springs(double *y, const double *x, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->nodes; i++) {
		double at[3];

		hawser__eigen_place(at, x, mesh, i);
		for (int k = 0; k < 3; k++)
			at[k] *= mesh->spring[i][k];
		scatter(y, mesh, i, at);
	}
}

/* y -= r*H*x of what touches. */
static void curvature(double *y, const double *x, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		double at[3], force[3];

		if (!(touch->r > 0.0))
			continue;
		hawser__eigen_place(at, x, mesh, touch->node);
		for (int k = 0; k < 3; k++)
			force[k] = -touch->r*(touch->H[k][0]*at[0] + touch->H[k][1]*at[1] + touch->H[k][2]*at[2]);
		scatter(y, mesh, touch->node, force);
	}
}

/* y += the stiffness of the buoyancy where the surface cuts an element or a buoy, times x: along y.
 * */
static void buoyancy(double *y, const double *x, const struct hawser__mesh *mesh)
{
	struct hawser__water_spring at;
	double a[3], b[3], f[3] = {0.0};

	for (int j = 0; hawser__water_spring(&at, mesh, j); j++)
		for (int i = 0; i < 2; i++) {
			hawser__eigen_place(a, x, mesh, at.node[0]);
			hawser__eigen_place(b, x, mesh, at.node[1]);
			f[1] = at.k[i][0]*a[1] + at.k[i][1]*b[1];
			scatter(y, mesh, at.node[i], f);
		}
}

/* y += what the forces at rest do as bodies turn. */
static void turn_bodies(double *y, const double *x, const struct hawser__mesh *mesh)
{
	for (int b = 0; mesh->body && b < mesh->net->bodies; b++) {
		const struct hawser__mesh_body *body = &mesh->body[b];

		for (int i = 0; i < body->motions; i++)
			for (int j = 0; j < body->motions; j++)
				y[body->first + i] += body->turned[i][j]*x[body->first + j];
	}
}

/* y += lift*M*x. */
static void lift(double *y, const double *x, const struct hawser__eigen *eigen)
{
	int n = eigen->mesh->unknowns;

	if (eigen->lift == 0.0)
		return;
	hawser__eigen_mass(eigen->work, x, eigen->mesh, 7U);
	cblas_daxpy(n, eigen->lift, eigen->work, 1, y, 1);
}

void hawser__eigen_stiffness(double *y, const double *x, const struct hawser__eigen *eigen)
{
	const struct hawser__mesh *mesh = eigen->mesh;

	memset(y, 0, (size_t)mesh->unknowns*sizeof *y);
	for (int e = 0; e < mesh->elements; e++) {
		double d[3], a[3], b[3], force[3], l = hawser__mesh_direction(d, mesh, e), along = 0.0;
		double t = eigen->T[e]/l, k = mesh->EA[e]/mesh->length0[e];

		if (eigen->T[e] <= 0.0)
			continue;
		hawser__eigen_place(a, x, mesh, mesh->end[e][0]);
		hawser__eigen_place(b, x, mesh, mesh->end[e][1]);
		for (int i = 0; i < 3; i++)
			along += d[i]*(b[i] - a[i]);
		for (int i = 0; i < 3; i++)
			force[i] = t*(b[i] - a[i]) + (k - t)*along*d[i];
		scatter(y, mesh, mesh->end[e][1], force);
		for (int i = 0; i < 3; i++)
			force[i] = -force[i];
		scatter(y, mesh, mesh->end[e][0], force);
	}
	springs(y, x, mesh);
	curvature(y, x, mesh);
	buoyancy(y, x, mesh);
	turn_bodies(y, x, mesh);
	lift(y, x, eigen);
}

/* to = F*B*G', F and G the frames of two nodes. */
static void turned(double to[3][3], const struct hawser__mesh *mesh, int node, const double B[3][3],
                   int other)
{
	double left[3], right[3];

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			to[i][j] = 0.0;
			hawser__mesh_axis(left, mesh, node, i);
			hawser__mesh_axis(right, mesh, other, j);
			for (int k = 0; k < 9; k++)
				to[i][j] += left[k/3]*B[k/3][k%3]*right[k%3];
		}
}

/* [B, -B; -B, B] in the frames of the ends, B = a*I + b*d*d'. */
static void add_turned(struct hawser__sparse *sparse, const struct hawser__mesh *mesh, int element,
                       double a, double b, const double d[3])
{
	double B[3][3], part[3][3], block[6][6];

	for (int i = 0; i < 9; i++)
		B[i/3][i%3] = b*d[i/3]*d[i%3] + (i/3 == i%3 ? a : 0.0);
	for (int p = 0; p < 4; p++) {
		turned(part, mesh, mesh->end[element][p/2], (const double (*)[3])B, mesh->end[element][p%2]);
		for (int i = 0; i < 9; i++)
			block[3*(p/2) + i/3][3*(p%2) + i%3] = p/2 == p%2 ? part[i/3][i%3] : -part[i/3][i%3];
	}
	hawser__sparse_ends(sparse, element, (const double (*)[6])block);
}

static void add_curvature(struct hawser__sparse *sparse, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		double block[3][3];

		if (!(touch->r > 0.0) || mesh->rigid[touch->node])
			continue;
		turned(block, mesh, touch->node, touch->H, touch->node);
		for (int k = 0; k < 9; k++)
			block[k/3][k%3] *= -touch->r;
		hawser__sparse_node(sparse, touch->element, touch->end, (const double (*)[3])block);
	}
}

static void add_buoyancy(struct hawser__sparse *sparse, const struct hawser__mesh *mesh)
{
	struct hawser__water_spring at;

	for (int j = 0; hawser__water_spring(&at, mesh, j); j++) {
		double block[6][6], part[3][3];

		if (mesh->rigid[at.node[0]] && mesh->rigid[at.node[1]])
			continue;
		for (int p = 0; p < 4; p++) {
			const double B[3][3] = {[1] = {0.0, at.k[p/2][p%2], 0.0}};

			turned(part, mesh, mesh->end[at.element][p/2], B, mesh->end[at.element][p%2]);
			for (int i = 0; i < 9; i++)
				block[3*(p/2) + i/3][3*(p%2) + i%3] = part[i/3][i%3];
		}
		hawser__sparse_ends(sparse, at.element, (const double (*)[6])block);
	}
}

/* Add a multiple of the added mass. */
static void add_water(struct hawser__sparse *sparse, const struct hawser__mesh *mesh, double factor)
{
	struct hawser__water_mass at;
	double block[3][3];

	for (int j = 0; hawser__water_mass(&at, mesh, j); j++) {
		if (mesh->rigid[at.node])
			continue;
		turned(block, mesh, at.node, at.mass, at.node);
		for (int k = 0; k < 9; k++)
			block[k/3][k%3] *= factor;
		hawser__sparse_node(sparse, at.element, at.end, (const double (*)[3])block);
	}
}

/* The springs, and -shift times the masses of absorbers beside those of their nodes. A spring along an
 * axis stays one where the node is free or held along the axes. */
static void add_attached(struct hawser__sparse *sparse, const struct hawser__mesh *mesh, double shift)
{
	struct hawser__mesh_pair pair;

	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0 && mesh->spring[i/3][i%3] > 0.0)
			hawser__sparse_diagonal(sparse, mesh->unknown[i/3][i%3], mesh->spring[i/3][i%3]);
	for (int j = 0; hawser__absorbers_mass(&pair, mesh, j); j++) {
		int own = mesh->unknown[pair.node][pair.axis];
		int other = mesh->unknown[pair.other][pair.other_axis];

		if (own >= other && other >= 0)
			hawser__sparse_pair(sparse, own, other, -shift*pair.mass);
	}
}

/* The matrix K + (lift - shift)*M. The block of an element in M is m/2*I at both ends, minus
 * m/12*[I, -I; -I, I]. */
void hawser__eigen_assemble(struct hawser__sparse *sparse, const struct hawser__eigen *eigen,
                            double shift)
{
	const struct hawser__mesh *mesh = eigen->mesh;

	shift -= eigen->lift;
	for (int e = 0; e < mesh->elements; e++) {
		double d[3], l = hawser__mesh_direction(d, mesh, e), m = mesh->rho[e]*mesh->length0[e];
		double t = eigen->T[e] > 0.0 ? eigen->T[e]/l : 0.0;
		double k = eigen->T[e] > 0.0 ? mesh->EA[e]/mesh->length0[e] - t : 0.0;

		if (mesh->frame)
			add_turned(sparse, mesh, e, t + shift*m/12.0, k, d);
		else
			hawser__sparse_add(sparse, e, t + shift*m/12.0, k, d);
		for (int i = 0; i < 6 && shift != 0.0; i++)
			if (mesh->unknown[mesh->end[e][i/3]][i%3] >= 0)
				hawser__sparse_diagonal(sparse, mesh->unknown[mesh->end[e][i/3]][i%3], -shift*m/2.0);
	}
	for (int i = 0; i < 3*mesh->nodes && shift != 0.0; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			hawser__sparse_diagonal(sparse, mesh->unknown[i/3][i%3], -shift*mesh->mass[i/3]);
	for (int i = 0; i < mesh->rotors && shift != 0.0; i++)
		hawser__sparse_diagonal(sparse, mesh->rotor[i].unknown, -shift*mesh->rotor[i].mass);
	add_attached(sparse, mesh, shift);
	add_curvature(sparse, mesh);
	add_water(sparse, mesh, -shift);
	add_buoyancy(sparse, mesh);
}
