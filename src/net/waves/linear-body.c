/* net/waves/linear-body.c - rigid bodies in the linear response.
 *
 * Z     K - omega^2 M - i omega C over all nodes
 * x0    what the waves move with the bodies held
 * x_j   what motion j of the bodies moves: itself at their nodes, and Z x_j = 0 at all others
 *
 * x = x0 + sum z_j x_j, with the forces on the bodies in balance along each of their motions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "net/body.h"
#include "net/motion/motion.h"
#include "net/waves/linear.h"

enum hawser_status hawser__linear_bodies_open(struct hawser__linear_mesh *linear,
                                              struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	size_t n = (size_t)mesh->body_unknowns, nodes = (size_t)mesh->nodes;

	linear->column = hawser__hold(&linear->hold, n*nodes + 1, sizeof *linear->column);
	linear->S = hawser__hold(&linear->hold, n*n + 1, sizeof *linear->S);
	linear->z = hawser__hold(&linear->hold, n + 1, sizeof *linear->z);
	linear->load = hawser__hold(&linear->hold, 2*n + 1, sizeof *linear->load);
	linear->pivot = hawser__hold(&linear->hold, n + 1, sizeof *linear->pivot);
	return linear->hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

void hawser__linear_push(struct hawser__linear_mesh *linear, int node, const double complex f[3])
{
	const struct hawser__mesh *mesh = &linear->mesh;
	int n = mesh->body_unknowns;
	int first = mesh->body[mesh->rigid[node] - 1].first - (mesh->unknowns - n);

	hawser__body_push(linear->load + first, mesh, node,
	                  (const double [3]){creal(f[0]), creal(f[1]), creal(f[2])});
	hawser__body_push(linear->load + n + first, mesh, node,
	                  (const double [3]){cimag(f[0]), cimag(f[1]), cimag(f[2])});
}

/* What an element with the displacements x of its ends does at one of them, along the unknowns
 * there. */
static void at_end(double complex f[3], const struct hawser__linear_mesh *linear, int e, int end,
                   const double complex (*x)[3], double omega)
{
	const struct hawser__mesh *mesh = &linear->mesh;

	memset(f, 0, 3*sizeof *f);
	for (int c = 0; c < 6; c++) {
		int node = mesh->end[e][c/3];
		double axis[3];
		double complex u;

		hawser__mesh_axis(axis, mesh, node, c % 3);
		u = axis[0]*x[node][0] + axis[1]*x[node][1] + axis[2]*x[node][2];
		for (int k = 0; k < 3; k++) {
			int row = 3*end + k;

			f[k] += (linear->K[e][row][c] - omega*omega*linear->M[e][row][c] -
			         I*omega*linear->C[e][row][c])*u;
		}
	}
}

/* The forces of displacements x [nodes] on the bodies, into linear->load. */
static void forces(struct hawser__linear_mesh *linear, const double complex (*x)[3],
                   const double complex *z, double omega)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	int n = mesh->body_unknowns, nodes = mesh->unknowns - n;
	double complex f[3];

	memset(linear->load, 0, 2*(size_t)n*sizeof *linear->load);
	for (int e = 0; e < 2*mesh->elements; e++)
		if (mesh->rigid[mesh->end[e/2][e % 2]]) {
			at_end(f, linear, e/2, e % 2, x, omega);
			hawser__linear_push(linear, mesh->end[e/2][e % 2], f);
		}
	for (int i = 0; i < mesh->nodes; i++) {
		for (int k = 0; k < 3; k++)
			f[k] = -omega*mesh->mass[i]*(omega + I*linear->net->mass_rate)*x[i][k];
		if (mesh->rigid[i])
			hawser__linear_push(linear, i, f);
	}
	for (int i = 0; i < linear->wets; i++) {
		const struct hawser__wetted *wet = &linear->wet[i];
		const double complex *u = x[wet->node];

		for (int k = 0; k < 3; k++) {
			f[k] = 0.0;
			for (int j = 0; j < 3; j++)
				f[k] -= I*omega*wet->C[k][j]*u[j];
			if (wet->buoy) {
				f[k] -= omega*omega*wet->displaced*wet->added[0]*u[k];
				for (int j = 0; j < 3; j++)
					f[k] -= wet->buoy->slope[k][j]*u[j];
			}
		}
		if (mesh->rigid[wet->node])
			hawser__linear_push(linear, wet->node, f);
	}
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];
		const double complex *u = x[touch->node];

		for (int k = 0; k < 3; k++)
			f[k] = -touch->r*(touch->H[k][0]*u[0] + touch->H[k][1]*u[1] + touch->H[k][2]*u[2]);
		if (touch->r > 0.0 && mesh->rigid[touch->node])
			hawser__linear_push(linear, touch->node, f);
	}
	for (int b = 0; b < mesh->net->bodies; b++) {
		const struct hawser__mesh_body *body = &mesh->body[b];
		int first = body->first - nodes;

		for (int i = 0; i < body->motions*body->motions && z; i++) {
			double complex by = body->turned[i/body->motions][i % body->motions]*
			                    z[first + i % body->motions];

			linear->load[first + i/body->motions] += creal(by);
			linear->load[n + first + i/body->motions] += cimag(by);
		}
	}
}

/* Column j, of a factored Z of the other nodes. */
static enum hawser_status column(struct hawser__linear_mesh *linear, int j, double omega,
                                 struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	int n = mesh->body_unknowns, nodes = mesh->unknowns - n;
	double complex (*x)[3] = linear->column + (size_t)j*(size_t)mesh->nodes, f[3];
	double unit[6] = {0.0}, at[3];
	enum hawser_status status;

	memset(x, 0, (size_t)mesh->nodes*sizeof *x);
	memset(linear->right, 0, 2*(size_t)nodes*sizeof *linear->right);
	for (int i = 0; i < mesh->nodes; i++) {
		const struct hawser__mesh_body *body = mesh->rigid[i] ? &mesh->body[mesh->rigid[i] - 1] : NULL;
		int own = body ? j - (body->first - nodes) : -1;

		if (own < 0 || own >= body->motions)
			continue;
		unit[own] = 1.0;
		hawser__body_place(at, unit, mesh, i);
		unit[own] = 0.0;
		for (int k = 0; k < 3; k++)
			x[i][k] = at[k];
	}
	for (int e = 0; e < 2*mesh->elements; e++) {
		const int *unknown = mesh->unknown[mesh->end[e/2][e % 2]];

		if (mesh->rigid[mesh->end[e/2][e % 2]] || !mesh->rigid[mesh->end[e/2][!(e % 2)]])
			continue;
		at_end(f, linear, e/2, e % 2, (const double complex (*)[3])x, omega);
		for (int k = 0; k < 3; k++)
			if (unknown[k] >= 0) {
				linear->right[2*unknown[k]] -= creal(f[k]);
				linear->right[2*unknown[k] + 1] -= cimag(f[k]);
			}
	}
	status = hawser__klu_again_complex(linear->right, linear->re, report);
	if (!status)
		hawser__linear_mesh_places(x, linear);
	return status;
}

enum hawser_status hawser__linear_bodies(struct hawser__linear_mesh *linear, double omega,
                                         struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	int n = mesh->body_unknowns;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < n; i++)
		linear->z[i] = linear->load[i] + I*linear->load[n + i];
	forces(linear, (const double complex (*)[3])linear->x, NULL, omega);
	for (int i = 0; i < n; i++)
		linear->z[i] -= linear->load[i] + I*linear->load[n + i];
	for (int j = 0; j < n && !status; j++) {
		double complex *S = linear->S + (size_t)j*(size_t)n;

		status = column(linear, j, omega, report);
		memset(S, 0, (size_t)n*sizeof *S);
		S[j] = 1.0;
		forces(linear, (const double complex (*)[3])(linear->column + (size_t)j*(size_t)mesh->nodes), S,
		       omega);
		for (int i = 0; i < n; i++)
			S[i] = linear->load[i] + I*linear->load[n + i];
	}
	if (status)
		return status;
	if (LAPACKE_zgesv_work(LAPACK_COL_MAJOR, n, 1, linear->S, n, linear->pivot, linear->z, n) != 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: nothing holds the rigid bodies "
		                    "at %g rad/s, by mass or stiffness", linear->net->name, omega);
	for (int j = 0; j < n; j++)
		for (int i = 0; i < mesh->nodes; i++)
			for (int k = 0; k < 3; k++)
				linear->x[i][k] += linear->z[j]*linear->column[(size_t)j*(size_t)mesh->nodes +
				                                               (size_t)i][k];
	return HAWSER_OK;
}
