/* rod/water.c - the loads of the water on a rod: Morison's equation at the ends of its elements
 * (water/morison.h), with the flow there and the direction of the element.
 *
 * In statics the axes may move with a towing point. In a motion flow, velocity and acceleration are
 * those of the state; of the flow the derivatives by the place are not in the matrix, which Newton's
 * method makes up for in its iterations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "rod/motion.h"
#include "water/morison.h"
#include "water/water.h"

enum { FREE = HAWSER__ROD_FREE };

static struct hawser__morison element(const struct hawser__rod_mesh *mesh, int e)
{
	return (struct hawser__morison){&mesh->rod->segment[mesh->segment[e]].line,
	                                mesh->water.of->density, mesh->rod->g, mesh->element[e].h,
	                                mesh->water.band};
}

static void chord(double d[3], const struct hawser__rod_node node[2])
{
	for (int k = 0; k < 3; k++)
		d[k] = node[1].x[k] - node[0].x[k];
}

/* What flows past a node at rest in the axes; U: derivatives of the relative velocity by the place. */
static void still(struct hawser__water_past *past, double (*U)[3], const struct hawser__rod_mesh *mesh,
                  int i)
{
	const struct hawser__rod_water *water = &mesh->water;
	const double *x = mesh->node[i].x, spin = water->spin, y = x[1] + water->lift;
	double u_y[3];

	*past = (struct hawser__water_past){.height = y - water->of->surface};
	hawser__water_current(past->u, u_y, water->of, y);
	for (int k = 0; k < 3; k++) {
		past->r[k] = past->u[k] - water->velocity[k];
		past->a[k] = k == 1 ? 0.0 : -spin*spin*x[k];
		U[k][0] = U[k][2] = 0.0;
		U[k][1] = u_y[k];
	}
	past->r[0] -= spin*x[2];
	past->r[2] += spin*x[0];
	U[0][2] = -spin;
	U[2][0] = spin;
}

/* Subtract factor A from the matrix. */
static void take(struct hawser__rod_mesh *mesh, int i, int j, const double (*A)[3], double factor)
{
	for (int k = 0; k < 9; k++)
		*hawser__band_at(&mesh->band, FREE*i + k/3, FREE*j + k%3) -= factor*A[k/3][k%3];
}

/* By the place of the node itself: of the flow and of the acceleration. */
static void take_place(struct hawser__rod_mesh *mesh, int i, const struct hawser__water_end *end,
                       const double (*U)[3])
{
	const double square = mesh->water.spin*mesh->water.spin;
	double A[3][3];

	for (int k = 0; k < 9; k++) {
		A[k/3][k%3] = k%3 == 1 ? 0.0 : square*end->mass[k/3][k%3];
		for (int l = 0; l < 3; l++)
			A[k/3][k%3] += end->by_r[k/3][l]*U[l][k%3];
	}
	take(mesh, i, i, (const double (*)[3])A, mesh->water.part);
}

static void load_element(struct hawser__rod_mesh *mesh, int e, int tangent)
{
	struct hawser__rod_water *water = &mesh->water;
	const struct hawser__morison of = element(mesh, e);
	struct hawser__water_past past[2];
	struct hawser__water_end end[2];
	double d[3], U[2][3][3];

	chord(d, &mesh->node[e]);
	for (int i = 0; i < 2; i++)
		still(&past[i], U[i], mesh, e + i);
	hawser__morison_ends(end, &of, d, past, tangent);
	water->wet += end[0].wet + end[1].wet;
	for (int i = 0; i < 2; i++) {
		for (int k = 0; k < 3; k++) {
			water->load[e][i][k] = water->part*end[i].load[k];
			mesh->r[FREE*(e + i) + k] += water->load[e][i][k];
		}
		if (!tangent)
			continue;
		take_place(mesh, e + i, &end[i], (const double (*)[3])U[i]);
		for (int j = 0; j < 2; j++) {
			take(mesh, e + i, e + j, (const double (*)[3])end[i].by_d, j ? water->part : -water->part);
			for (int k = 0; k < 3; k++)
				*hawser__band_at(&mesh->band, FREE*(e + i) + k, FREE*(e + j) + 1) -=
					water->part*end[i].by_y[j][k];
		}
	}
}

static void load_buoy(struct hawser__rod_mesh *mesh, int tangent)
{
	const struct hawser__rod_water *water = &mesh->water;
	int node = water->buoy.node;
	struct hawser__water_past past;
	struct hawser__water_end end;
	double U[3][3];

	still(&past, U, mesh, node);
	hawser__morison_buoy(&end, &water->buoy.of, water->of->density, mesh->rod->g, 0.0, &past);
	for (int k = 0; k < 3; k++) {
		mesh->r[FREE*node + k] += water->part*end.load[k];
		if (tangent)
			*hawser__band_at(&mesh->band, FREE*node + k, FREE*node + 1) -= water->part*end.by_y[0][k];
	}
	if (tangent)
		take_place(mesh, node, &end, (const double (*)[3])U);
}

void hawser__rod_water_load(struct hawser__rod_mesh *mesh, int tangent)
{
	mesh->water.wet = 0.0;
	for (int e = 0; e < mesh->elements; e++)
		load_element(mesh, e, tangent);
	if (mesh->water.buoy.node >= 0)
		load_buoy(mesh, tangent);
}

/* --- in motion --- */

static void moving(struct hawser__water_past *past, const struct hawser__rod_motion *motion, int i)
{
	const double *x = motion->mesh->node[i].x, *v = motion->velocity[i], *a = motion->rate[i];
	struct hawser__water_there there;

	hawser__water_flow_at(&there, &motion->mesh->water.flow, i, x);
	past->height = x[1] - there.surface;
	for (int k = 0; k < 3; k++) {
		past->u[k] = there.u[k];
		past->r[k] = there.u[k] - v[k];
		past->du[k] = there.du[k];
		past->a[k] = a[k];
	}
}

/* The load on node i, and its derivatives by the velocity of that node and by the places of the nodes
 * from `first` on: by_d of the chord, or NULL. */
static void push(struct hawser__rod_motion *motion, int i, const struct hawser__water_end *end,
                 int first, int nodes, int tangent)
{
	double f[6] = {end->load[0], end->load[1], end->load[2]}, by[36] = {0.0};

	hawser__rod_push(motion, i, f);
	hawser__rod_push_mass(motion, i, end->mass);
	for (int k = 0; k < 9; k++)
		by[6*(k/3) + k%3] = -end->by_r[k/3][k%3];
	for (int j = 0; j < nodes && tangent; j++) {
		double at[36] = {0.0};

		for (int k = 0; k < 9 && nodes > 1; k++)
			at[6*(k/3) + k%3] = j ? end->by_d[k/3][k%3] : -end->by_d[k/3][k%3];
		for (int k = 0; k < 3; k++)
			at[6*k + 1] += end->by_y[j][k];
		hawser__rod_push_tangent(motion, i, first + j, at, first + j == i ? by : NULL);
	}
}

int hawser__rod_water_push(void *data, struct hawser__rod_motion *motion, double t, int tangent)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	struct hawser__rod_water *water = &mesh->water;
	struct hawser__water_past past[2];
	struct hawser__water_end end[2];

	(void)data;
	hawser__water_flow_time(&water->flow, t);
	moving(&past[1], motion, 0);
	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser__morison of = element(mesh, e);
		double d[3];

		past[0] = past[1];
		moving(&past[1], motion, e + 1);
		chord(d, &mesh->node[e]);
		hawser__morison_ends(end, &of, d, past, tangent);
		for (int i = 0; i < 2; i++)
			push(motion, e + i, &end[i], e, 2, tangent);
	}
	if (water->buoy.node >= 0) {
		moving(past, motion, water->buoy.node);
		hawser__morison_buoy(end, &water->buoy.of, water->of->density, mesh->rod->g, 0.0, past);
		push(motion, water->buoy.node, end, water->buoy.node, 1, tangent);
	}
	return 0;
}
