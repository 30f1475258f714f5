/* tow/steady_rod_loads.c - drag, inertia and the body on a rod at rest in a moving frame.
 *
 *   u, d     flow at the middle of an element, its chord x2 - x1; U the derivative of u by x
 *   f        drag f(u, d) per length, half of it on each node of the element
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "tow/steady.h"

enum { FREE = HAWSER__ROD_FREE };

static double *at(struct hawser__tow_rod *b, int row, int column)
{
	return hawser__band_at(&b->mesh.band, row, column);
}

/* Subtract a block of a derivative from the matrix. */
static void take(struct hawser__tow_rod *b, int row, int column, double (*A)[3], double factor)
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			*at(b, row + i, column + j) -= factor*A[i][j];
}

/* A U, U the derivative of the flow by the place. */
static void by_place(double (*to)[3], double (*A)[3], double spin)
{
	for (int i = 0; i < 3; i++) {
		to[i][0] = A[i][2]*spin;
		to[i][1] = 0.0;
		to[i][2] = -A[i][0]*spin;
	}
}

static struct hawser_drag drag_of(const struct hawser__tow_rod *b, int e)
{
	const struct hawser_tow_segment *segment = &b->frame->tow->segment[b->mesh.segment[e]];

	return (struct hawser_drag){b->frame->tow->density, 0.5*segment->diameter, segment->normal,
	                            segment->tangential};
}

void hawser__tow_rod_drag(double f[3], double (*f_u)[3], double (*f_d)[3],
                          const struct hawser__tow_rod *b, int e)
{
	const struct hawser__rod_node *node = &b->mesh.node[e];
	struct hawser_drag drag = drag_of(b, e);
	double middle[3], d[3], u[3];

	for (int k = 0; k < 3; k++) {
		middle[k] = 0.5*(node[0].x[k] + node[1].x[k]);
		d[k] = node[1].x[k] - node[0].x[k];
	}
	hawser__tow_flow(u, b->frame, middle);
	hawser_drag_line(f, f_u, f_d, &drag, u, d);
}

static void load_element(struct hawser__tow_rod *b, int e)
{
	double f[3], f_u[3][3], f_d[3][3], f_x[3][3], spin = b->frame->spin;
	double half = 0.5*b->mesh.element[e].h;
	double mass = half*b->rod.segment[b->mesh.segment[e]].rho;

	if (b->mesh.water.of) /* it is in the mesh's own loads; without orbits there is no more */
		return;
	hawser__tow_rod_drag(f, f_u, f_d, b, e);
	by_place(f_x, f_u, spin);
	for (int n = 0; n < 2; n++) {
		int row = FREE*(e + n);

		for (int k = 0; k < 3; k++)
			b->mesh.r[row + k] += half*f[k] + (k == 1 ? 0.0 : mass*spin*spin*b->mesh.node[e + n].x[k]);
		*at(b, row, row) -= mass*spin*spin;
		*at(b, row + 2, row + 2) -= mass*spin*spin;
		for (int c = 0; c < 2; c++) {
			take(b, row, FREE*(e + c), f_d, c ? half : -half);
			take(b, row, FREE*(e + c), f_x, 0.5*half);
		}
	}
}

/* A spring between the last two nodes, which are at one place: forces K (x2 - x1), moments k psi with
 * psi = log(R1'R2), which are along psi in the axes of both. */
static void load_spring(struct hawser__tow_rod *b)
{
	int row[2] = {FREE*b->last, FREE*b->end};
	const struct hawser__rod_node *node = &b->mesh.node[b->last];
	const double *psi = b->mesh.strain[b->last].psi;
	struct hawser__so3 so3;
	double Ji[9];

	hawser__so3_at(&so3, psi);
	hawser__so3_ji(Ji, &so3);
	for (int n = 0; n < 2; n++)
		for (int i = 0; i < 3; i++) {
			double sign = n ? -1.0 : 1.0;

			b->mesh.r[row[n] + i] += sign*(b->pull[i] + b->spring[0]*(node[1].x[i] - node[0].x[i]));
			b->mesh.r[row[n] + 3 + i] += sign*b->spring[1]*psi[i];
			for (int c = 0; c < 2; c++)
				*at(b, row[n] + i, row[c] + i) += n == c ? b->spring[0] : -b->spring[0];
			for (int j = 0; j < 3; j++) {
				*at(b, row[n] + 3 + i, row[1] + 3 + j) -= sign*b->spring[1]*Ji[3*i + j];
				*at(b, row[n] + 3 + i, row[0] + 3 + j) += sign*b->spring[1]*Ji[3*j + i];
			}
		}
}

/* The ring, clamped to node `end`. */
static void load_ring(struct hawser__tow_rod *b)
{
	const struct hawser__rod_node *node = &b->mesh.node[b->end];
	int row = FREE*b->end;
	struct hawser__tow_ring ring;
	double R[9], moment[3], turn[9], part[9], slope[9], skew[9];

	hawser__quaternion_matrix(R, node->q);
	for (int k = 0; k < 3; k++)
		b->now.axis[k] = R[3*k];
	hawser__tow_ring_at(&ring, b->frame, node->x, b->now.axis);
	memcpy(b->now.force, ring.n, sizeof ring.n);
	memcpy(b->now.centre, ring.centre, sizeof ring.centre);
	hawser__apply_left(moment, R, ring.moment);
	hawser__skew(skew, moment);
	for (int k = 0; k < 3; k++) {
		b->mesh.r[row + k] += ring.n[k];
		b->mesh.r[row + 3 + k] += moment[k];
	}
	take(b, row, row, ring.n_x, 1.0);
	memcpy(slope, ring.n_turn, sizeof slope);
	hawser__mul(turn, slope, R);
	for (int k = 0; k < 9; k++)
		*at(b, row + k/3, row + 3 + k%3) -= turn[k];
	memcpy(slope, ring.moment_x, sizeof slope);
	hawser__mul_left(turn, R, slope);
	for (int k = 0; k < 9; k++)
		*at(b, row + 3 + k/3, row + k%3) -= turn[k];
	memcpy(slope, ring.moment_turn, sizeof slope);
	hawser__mul_left(part, R, slope);
	hawser__mul(turn, part, R);
	for (int k = 0; k < 9; k++)
		*at(b, row + 3 + k/3, row + 3 + k%3) -= turn[k] + skew[k];
}

/* A body that pulls at the end without a moment; of a ring the change of its attitude with the place
 * is left to the iteration. */
static void load_body(struct hawser__tow_rod *b)
{
	double spin = b->frame->spin, n_x[3][3];
	int row = FREE*b->end;

	if (b->mesh.water.of) { /* the water's part is in the mesh's own loads */
		(void)hawser__tow_body_at(&b->now, b->frame, b->mesh.node[b->end].x);
		b->mesh.r[row + 1] -= b->frame->tow->body.mass*b->frame->tow->g;
		return;
	}
	if (spin != 0.0)
		(void)hawser__tow_body_near(&b->now, b->frame, b->mesh.node[b->end].x, 0);
	else
		b->now = *b->hung;
	hawser__tow_body_slope(n_x, b->frame, b->mesh.node[b->end].x, &b->now);
	for (int k = 0; k < 3; k++)
		b->mesh.r[row + k] += b->now.force[k];
	take(b, row, row, n_x, 1.0);
}

void hawser__tow_rod_assemble(struct hawser__tow_rod *b)
{
	hawser__rod_tangent(&b->mesh);
	for (int e = 0; e < b->last; e++)
		load_element(b, e);
	if (b->end > b->last)
		load_spring(b);
	if (b->hung)
		load_body(b);
	else
		load_ring(b);
}
