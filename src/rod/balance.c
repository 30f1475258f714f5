/* rod/balance.c - loads, internal forces and the tangent of a mesh (mesh.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "rod/mesh.h"
#include "rod/so3.h"

/* A hinged or free end may be able to spin about the rod without any change of energy. The matrix is
 * made regular by this part of the torsional stiffness of the element; increments only, and not the
 * equilibrium, depend on it. */
#define SPIN 1e-7

void hawser__rod_force_add(struct hawser__rod_force *to, const struct hawser__rod_force *one,
                           double factor)
{
	for (int i = 0; i < 3; i++) {
		to->force[i] += factor*one->force[i];
		to->moment[i] += factor*one->moment[i];
		to->follow[i] += factor*one->follow[i];
		to->turn[i] += factor*one->turn[i];
	}
}

void hawser__rod_loads(struct hawser__rod_mesh *mesh, const double *factor, double part)
{
	const struct hawser_rod *rod = mesh->rod;

	mesh->water.part = part;
	memset(mesh->line, 0, (size_t)mesh->elements*sizeof *mesh->line);
	memset(mesh->point, 0, (size_t)mesh->nodes*sizeof *mesh->point);
	for (int e = 0; e < mesh->elements; e++)
		mesh->line[e].force[1] = -part*rod->g*rod->segment[mesh->segment[e]].rho;
	for (int l = 0; l < rod->loads; l++) {
		const struct hawser_rod_load *load = &rod->load[l];
		struct hawser__rod_force one = {.force = {0}};

		memcpy(load->follower ? one.follow : one.force, load->force, sizeof load->force);
		memcpy(load->follower ? one.turn : one.moment, load->moment, sizeof load->moment);
		if (!load->distributed)
			hawser__rod_force_add(&mesh->point[mesh->place[2*l]], &one, part*factor[l]);
		for (int e = mesh->place[2*l]; load->distributed && e < mesh->place[2*l + 1]; e++)
			hawser__rod_force_add(&mesh->line[e], &one, part*factor[l]);
	}
	memcpy(mesh->sum, mesh->point, (size_t)mesh->nodes*sizeof *mesh->sum);
	for (int e = 0; e < mesh->elements; e++)
		for (int k = 0; k < 2; k++)
			hawser__rod_force_add(&mesh->sum[e + k], &mesh->line[e], 0.5*mesh->element[e].h);
}

int hawser__rod_strains(struct hawser__rod_mesh *mesh)
{
	int first = -1;

	for (int e = 0; e < mesh->elements; e++)
		if (hawser__rod_strain(&mesh->strain[e], &mesh->element[e], &mesh->node[e]) && first < 0)
			first = e;
	return first;
}

void hawser__rod_load(double r[HAWSER__ROD_FREE], const struct hawser__rod_mesh *mesh, int i)
{
	const struct hawser__rod_force *of = &mesh->sum[i];
	double R[9], follow[3], moment[3];

	hawser__quaternion_matrix(R, mesh->node[i].q);
	hawser__apply(follow, R, of->follow);
	hawser__apply_left(moment, R, of->moment);
	for (int k = 0; k < 3; k++) {
		r[k] = of->force[k] + follow[k];
		r[3 + k] = of->turn[k] + moment[k];
	}
}

/* The loads change with the turn t of the node: R exp(t) f = R f - R f~ t, and exp(-t) R'm = R'm +
 * (R'm)~ t. */
void hawser__rod_load_tangent(struct hawser__rod_mesh *mesh, int i)
{
	const struct hawser__rod_force *of = &mesh->sum[i];
	double R[9], moment[3], follow[9], turn[9], part[9];

	hawser__quaternion_matrix(R, mesh->node[i].q);
	hawser__apply_left(moment, R, of->moment);
	hawser__skew(part, of->follow);
	hawser__mul(follow, R, part);
	hawser__skew(turn, moment);
	for (int k = 0; k < 9; k++) {
		int row = HAWSER__ROD_FREE*i + k/3, column = HAWSER__ROD_FREE*i + 3 + k % 3;

		*hawser__band_at(&mesh->band, row, column) += follow[k];
		*hawser__band_at(&mesh->band, row + 3, column) -= turn[k];
	}
}

static void assemble(struct hawser__rod_mesh *mesh, int tangent)
{
	double f[HAWSER__ROD_PAIR], K[HAWSER__ROD_PAIR*HAWSER__ROD_PAIR];

	for (int i = 0; i < mesh->nodes; i++)
		hawser__rod_load(mesh->r + (long)HAWSER__ROD_FREE*i, mesh, i);
	if (mesh->water.of)
		hawser__rod_water_load(mesh, tangent);
	for (int e = 0; e < mesh->elements; e++) {
		int at = HAWSER__ROD_FREE*e;

		/* cppcheck-suppress legacyUninitvar ; it is filled there */
		hawser__rod_forces(f, tangent ? K : NULL, &mesh->element[e], &mesh->strain[e]);
		for (int i = 0; i < HAWSER__ROD_PAIR; i++)
			mesh->r[at + i] -= f[i];
		for (int j = 0; tangent && j < HAWSER__ROD_PAIR; j++)
			for (int i = 0; i < HAWSER__ROD_PAIR; i++)
				*hawser__band_at(&mesh->band, at + i, at + j) += K[HAWSER__ROD_PAIR*i + j];
	}
}

void hawser__rod_residual(struct hawser__rod_mesh *mesh)
{
	assemble(mesh, 0);
	for (int i = 0; i < mesh->n; i++)
		if (mesh->held[i])
			mesh->r[i] = 0.0;
}

void hawser__rod_tangent(struct hawser__rod_mesh *mesh)
{
	hawser__band_zero(&mesh->band);
	assemble(mesh, 1);
	for (int i = 0; i < mesh->nodes; i++)
		hawser__rod_load_tangent(mesh, i);
	for (int end = 0; end < 2; end++) {
		int at = end ? mesh->n - 3 : 3;

		*hawser__band_at(&mesh->band, at, at) += SPIN*mesh->spin[end];
	}
	for (int i = 0; i < mesh->n; i++)
		if (mesh->held[i])
			mesh->r[i] = 0.0;
}

void hawser__rod_move(struct hawser__rod_mesh *mesh, const double *step, double part)
{
	for (int i = 0; i < mesh->nodes; i++) {
		const double *by = step + (long)HAWSER__ROD_FREE*i;
		double turn[3];

		for (int k = 0; k < 3; k++) {
			mesh->node[i].x[k] += part*by[k];
			turn[k] = part*by[3 + k];
		}
		hawser__quaternion_turn(mesh->node[i].q, turn);
	}
}

void hawser__rod_place(struct hawser__rod_mesh *mesh)
{
	for (int e = 0; e < mesh->elements; e++) {
		struct hawser__rod_strain now;
		double d[3];

		(void)hawser__rod_strain(&now, &mesh->element[e], &mesh->node[e]);
		hawser__apply(d, now.R, mesh->strain[e].w);
		for (int k = 0; k < 3; k++)
			mesh->node[e + 1].x[k] = mesh->node[e].x[k] + mesh->element[e].h*d[k];
	}
}

void hawser__rod_follow(struct hawser__rod_mesh *mesh, const double *step)
{
	for (int e = 0; e < mesh->elements; e++) {
		const double *by = step + (long)HAWSER__ROD_FREE*e;
		struct hawser__rod_strain unit = mesh->strain[e];
		double f[HAWSER__ROD_PAIR];

		memset(unit.M, 0, sizeof unit.M);
		for (int k = 0; k < 3; k++) { /* with N = e_k and no M, forces are derivatives of h w_k */
			for (int i = 0; i < 3; i++)
				unit.N[i] = i == k;
			hawser__rod_forces(f, NULL, &mesh->element[e], &unit);
			for (int i = 0; i < HAWSER__ROD_PAIR; i++)
				mesh->strain[e].w[k] += f[i]*by[i]/mesh->element[e].h;
		}
	}
	hawser__rod_move(mesh, step, 1.0);
	hawser__rod_place(mesh);
}

double hawser__rod_strain_energy(const struct hawser__rod_mesh *mesh)
{
	double sum = 0.0;

	for (int e = 0; e < mesh->elements; e++)
		sum += hawser__rod_energy(&mesh->element[e], &mesh->strain[e]);
	return sum;
}
