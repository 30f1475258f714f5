/* modes/compliance_springs.c - springs from the cable to ground, in the problem of one plane.
 *
 *   s_j      strain of spring j: g_j . X(lump)
 *   phi_a    constant force of unit size in component a, a < D; force g_j beyond the lump of spring
 *            j, a = D + j. The force along the cable is F = F_inertia + sum of z_a phi_a, z = (F0, s)
 *   <F, G>   integral of (d' F) . (d' G), d the directions: strain of one force times that of another
 *   A        <phi_a, phi_b>, plus the identity for springs: symmetric, positive definite
 *
 * The joints of elastic supports are points of the integral <F, G>: at end A before all lumps, at end
 * B beyond them.
 *
 * The end does not move if <phi_c, F> = 0. Then X(lump) is minus the integral of d d'F beyond the
 * lump, so that the strain of spring j is s_j = -<phi_j, F>. Both are A z = -<phi, F_inertia>.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "modes/compliance.h"

void hawser__spring_constraints(double *constraint, const double *C, int rows, int block,
                                const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	int functions = block*grid->elements;

	for (int j = 0; j < plane->springs; j++, constraint += rows) {
		const struct hawser__spring *spring = &plane->spring[j];
		int before = block*plane->lump[spring->lump].edge;

		for (int f = 0; f < before; f++)
			for (int c = 0; c < plane->D; c++)
				constraint[f] += spring->g[c]*C[c*rows + f];
		constraint[functions + j] = -1.0;
		for (int i = 0; i < plane->joints; i++)
			for (int c = 0; c < plane->D && !plane->joint[i].end; c++)
				constraint[functions + plane->springs + i] +=
					spring->g[c]*plane->joint[i].d[c];
	}
}

/* The component of phi_a along c, at a point beyond `lumps_before` lumps. */
static double phi(const struct hawser__plane *plane, int a, int c, int lumps_before)
{
	const struct hawser__spring *spring;

	if (a < plane->D)
		return a == c ? 1.0 : 0.0;
	spring = &plane->spring[a - plane->D];
	return spring->lump < lumps_before ? spring->g[c] : 0.0;
}

/* Strain of a joint by phi_a. */
static double at_joint(const struct hawser__plane *plane, int a, const struct hawser__joint *joint)
{
	double sum = 0.0;

	for (int c = 0; c < plane->D; c++)
		sum += joint->d[c]*phi(plane, a, c, joint->end ? plane->lumps : 0);
	return sum;
}

/* Integral of d d' over the elements from `from` to `to`. */
static void gram(double W[HAWSER__MAX_D][HAWSER__MAX_D], const struct hawser__plane *plane,
                 const struct hawser_grid *grid, int from, int to)
{
	int D = plane->D, points = grid->points;

	memset(W, 0, HAWSER__MAX_D*sizeof *W);
	for (int k = 0; k < D; k++)
		for (int i = from*grid->order; i < to*grid->order; i++) {
			const double *d = plane->direction + k*D*points + i;

			for (int c = 0; c < D; c++)
				for (int q = 0; q < D; q++)
					W[c][q] += grid->weight[i]*d[c*points]*d[q*points];
		}
}

/* Elements between lump `piece` - 1 and lump `piece`. */
static void piece_of(int *from, int *to, const struct hawser__plane *plane,
                     const struct hawser_grid *grid, int piece)
{
	*from = piece > 0 ? plane->lump[piece - 1].edge : 0;
	*to = piece < plane->lumps ? plane->lump[piece].edge : grid->elements;
}

static void assemble(double *A, int size, const struct hawser__plane *plane,
                     const struct hawser_grid *grid)
{
	int D = plane->D;
	double W[HAWSER__MAX_D][HAWSER__MAX_D];

	memset(A, 0, (size_t)size*(size_t)size*sizeof *A);
	for (int piece = 0; piece <= plane->lumps; piece++) {
		int from, to;

		piece_of(&from, &to, plane, grid, piece);
		gram(W, plane, grid, from, to);
		for (int a = 0; a < size; a++)
			for (int b = 0; b <= a; b++)
				for (int c = 0; c < D; c++)
					for (int q = 0; q < D; q++)
						A[a*size + b] += phi(plane, a, c, piece)*W[c][q]*
						                 phi(plane, b, q, piece);
	}
	for (int j = 0; j < plane->joints; j++)
		for (int a = 0; a < size; a++)
			for (int b = 0; b <= a; b++)
				A[a*size + b] += at_joint(plane, a, &plane->joint[j])*
				                 at_joint(plane, b, &plane->joint[j]);
	for (int a = D; a < size; a++)
		A[a*size + a] += 1.0;
}

void hawser__spring_solve(double *z, const double *b, const struct hawser__plane *plane,
                          const struct hawser_grid *grid)
{
	double A[HAWSER__MAX_FORCES*HAWSER__MAX_FORCES];
	int size = plane->D + plane->springs;

	assemble(A, size, plane, grid);
	memcpy(z, b, (size_t)size*sizeof *z);
	/* rows of the lower triangle are columns of the upper one */
	if (LAPACKE_dposv(LAPACK_COL_MAJOR, 'U', size, 1, A, size, z, size) != 0)
		for (int a = 0; a < size; a++)
			z[a] = NAN; /* reported as the shape of the mode */
}

void hawser__spring_work(double *b, const double *force, double end[2][HAWSER__MAX_D],
                         const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	int D = plane->D, points = grid->points, size = D + plane->springs;

	memset(b, 0, (size_t)size*sizeof *b);
	for (int piece = 0; piece <= plane->lumps; piece++) {
		double moved[HAWSER__MAX_D] = {0.0};
		int from, to;

		piece_of(&from, &to, plane, grid, piece);
		for (int k = 0; k < D; k++)
			for (int i = from*grid->order; i < to*grid->order; i++) {
				const double *d = plane->direction + k*D*points + i;
				double pull = 0.0;

				for (int c = 0; c < D; c++)
					pull += d[c*points]*force[c*points + i];
				for (int c = 0; c < D; c++)
					moved[c] += grid->weight[i]*d[c*points]*pull;
			}
		for (int a = 0; a < size; a++)
			for (int c = 0; c < D; c++)
				b[a] += phi(plane, a, c, piece)*moved[c];
	}
	for (int j = 0; j < plane->joints; j++) {
		const struct hawser__joint *joint = &plane->joint[j];
		double strain = 0.0;

		for (int c = 0; c < D; c++)
			strain += joint->d[c]*end[joint->end][c];
		for (int a = 0; a < size; a++)
			b[a] += at_joint(plane, a, joint)*strain;
	}
}

void hawser__spring_force(double *force, double end[2][HAWSER__MAX_D], const double *z, double factor,
                          const struct hawser__plane *plane, const struct hawser_grid *grid)
{
	int D = plane->D, points = grid->points;

	for (int piece = 0; piece <= plane->lumps; piece++) {
		int from, to;

		piece_of(&from, &to, plane, grid, piece);
		for (int c = 0; c < D; c++) {
			double sum = 0.0;

			for (int a = 0; a < D + plane->springs; a++)
				sum += phi(plane, a, c, piece)*z[a];
			for (int i = from*grid->order; i < to*grid->order; i++)
				force[c*points + i] += factor*sum;
			if (piece == 0)
				end[0][c] += factor*sum;
			if (piece == plane->lumps)
				end[1][c] += factor*sum;
		}
	}
}
