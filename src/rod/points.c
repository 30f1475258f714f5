/* rod/points.c - places, forces and moments at the nodes of a mesh, and the forces of the supports.
 *
 * The force and the moment in a section at a node are those of the element before it, less the loads on
 * that element's half; they balance loads and supports to round-off, and their error is of order h^2.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/mesh.h"
#include "rod/so3.h"

/* Loads on half an element at a node, as they act on its unknowns. */
static void half_load(double r[6], const struct hawser__rod_mesh *mesh, int e, int side,
                      const double R[9])
{
	const struct hawser__rod_force *of = &mesh->line[e];
	double follow[3], moment[3], half = 0.5*mesh->element[e].h;

	hawser__apply(follow, R, of->follow);
	hawser__apply_left(moment, R, of->moment);
	for (int k = 0; k < 3; k++) {
		r[k] = half*(of->force[k] + follow[k]) + (mesh->water.of ? mesh->water.load[e][side][k] : 0.0);
		r[3 + k] = half*(of->turn[k] + moment[k]);
	}
}

static void point(struct hawser_rod_point *to, struct hawser__rod_mesh *mesh, int i)
{
	int e = i > 0 ? i - 1 : 0, side = i > 0;
	double sign = side ? 1.0 : -1.0, f[HAWSER__ROD_PAIR], R[9], own[6], n[3];

	hawser__rod_forces(f, NULL, &mesh->element[e], &mesh->strain[e]);
	hawser__quaternion_matrix(R, mesh->node[i].q);
	half_load(own, mesh, e, side, R);
	to->s = mesh->s[i];
	memcpy(to->x, mesh->node[i].x, sizeof to->x);
	memcpy(to->q, mesh->node[i].q, sizeof to->q);
	for (int k = 0; k < 3; k++) {
		n[k] = sign*(f[6*side + k] - own[k]);
		to->M[k] = sign*(f[6*side + 3 + k] - own[3 + k]);
		to->k[k] = mesh->element[e].k0[k] + to->M[k]/mesh->element[e].EI[k];
	}
	hawser__apply_left(to->N, R, n);
}

/* The supports bear what is not balanced. */
static void supports(struct hawser_rod_statics *st, struct hawser__rod_mesh *mesh)
{
	unsigned char *held = mesh->held;
	unsigned char none[2*HAWSER__ROD_FREE];

	memcpy(none, held, HAWSER__ROD_FREE);
	memcpy(none + 6, held + mesh->n - 6, HAWSER__ROD_FREE);
	memset(held, 0, HAWSER__ROD_FREE);
	memset(held + mesh->n - 6, 0, HAWSER__ROD_FREE);
	hawser__rod_residual(mesh);
	memcpy(held, none, HAWSER__ROD_FREE);
	memcpy(held + mesh->n - 6, none + 6, HAWSER__ROD_FREE);
	st->residual = 0.0;
	for (int end = 0; end < 2; end++) {
		int node = end ? mesh->nodes - 1 : 0;
		double *r = mesh->r + (long)HAWSER__ROD_FREE*node, R[9], moment[3];

		hawser__quaternion_matrix(R, mesh->node[node].q);
		for (int k = 0; k < 3; k++) {
			int own = HAWSER__ROD_FREE*node + k;

			st->force[end][k] = held[own] ? -r[k] : 0.0;
			moment[k] = held[own + 3] ? -r[3 + k] : 0.0;
			if (held[own])
				r[k] = 0.0;
		}
		hawser__apply(st->moment[end], R, moment);
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			st->residual = fmax(st->residual, fabs(mesh->r[(long)HAWSER__ROD_FREE*i + k]));
}

enum hawser_status hawser__rod_points(struct hawser_rod_statics *st, struct hawser__rod_mesh *mesh,
                                      struct hawser_report *report)
{
	st->point = calloc((size_t)mesh->nodes, sizeof *st->point);
	st->rest = calloc((size_t)mesh->nodes, sizeof *st->rest);
	if (!st->point || !st->rest)
		return hawser__no_memory(report, "statics");
	st->points = mesh->nodes;
	st->T_min = INFINITY;
	st->T_max = -INFINITY;
	st->M_max = -1.0;
	(void)hawser__rod_strains(mesh);
	hawser__rod_residual(mesh);
	for (int i = 0; i < mesh->nodes; i++) {
		const struct hawser_rod_point *at = &st->point[i];
		double moment;

		memcpy(st->rest[i], mesh->rest[i].x, sizeof st->rest[i]);
		point(&st->point[i], mesh, i);
		moment = sqrt(hawser__dot(at->M, at->M));
		st->T_min = fmin(st->T_min, at->N[0]);
		st->T_max = fmax(st->T_max, at->N[0]);
		if (moment > st->M_max) {
			st->M_max = moment;
			st->M_max_s = at->s;
		}
		for (int k = 0; k < 3; k++)
			if (!isfinite(at->x[k]) || !isfinite(at->N[k]) || !isfinite(at->M[k]))
				return hawser__fail(report, HAWSER_ERR_NAN, "statics", "not a number at s = %.9g m",
				                    at->s);
	}
	for (int e = 0; e < mesh->elements; e++)
		for (int k = 0; k < 3; k++)
			st->strain = fmax(st->strain, fabs(mesh->strain[e].w[k] - mesh->element[e].w0[k]));
	st->energy = hawser__rod_strain_energy(mesh);
	st->wet = mesh->water.wet;
	supports(st, mesh);
	return HAWSER_OK;
}
