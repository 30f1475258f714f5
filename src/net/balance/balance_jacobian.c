/* net/balance/balance_jacobian.c - the derivative of what is not in balance by the motion, as blocks of
 * nodes: of each element G at both its ends and -G between them, with the derivatives of its force at
 * the samples,
 *
 *   G = project (B basis + Omega C rate),   B = dF/dd, C = dF/dd'
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <string.h>

#include "net/balance/balance.h"

enum { PARTS = HAWSER__MESH_PARTS };

/* +- G into the block of two ends. */
static void put(struct hawser__mesh_balance *balance, int e, int to, int from, const double *G)
{
	const struct hawser__mesh *mesh = balance->mesh;
	const int *row = mesh->unknown[mesh->end[e][to]], *column = mesh->unknown[mesh->end[e][from]];
	int width = balance->width;
	double *block, sign = to == from ? 1.0 : -1.0;

	if (balance->blocks.row[mesh->end[e][to]] < 0 || balance->blocks.row[mesh->end[e][from]] < 0)
		return;
	block = hawser__nodal_at(&balance->blocks, balance->blocks.row[mesh->end[e][to]],
	                          balance->blocks.row[mesh->end[e][from]]);
	for (int p = 0; p < PARTS; p++)
		for (int b = 0; b < width && row[p/3] >= 0 && column[p%3] >= 0; b++)
			cblas_daxpy(width, sign, G + (b*PARTS + p)*width, 1,
			            block + (p%3*width + b)*3*width + p/3*width, 1);
}

/* Project the entries of B, or of C. */
static void weigh(struct hawser__mesh_balance *balance, int e, int rates)
{
	int width = balance->width;

	for (int t = 0; t < balance->rows; t++) {
		struct hawser__mesh_stretch s;

		hawser__mesh_balance_stretch(&s, balance, e, t, balance->Omega);
		for (int p = 0; p < PARTS; p++) {
			double pair = s.e[p/3]*s.e[p%3], value;

			value = rates ? s.viscous*pair*balance->Omega
			        : (s.stiff - s.T/s.l)*pair + s.viscous*s.e[p/3]*s.aside[p%3] +
			          (p/3 == p%3 ? s.T/s.l : 0.0);
			for (int a = 0; a < width; a++)
				balance->weighted[(t*PARTS + p)*width + a] = value*balance->project[t*width + a];
		}
	}
}

static void add_element(struct hawser__mesh_balance *balance, int e)
{
	int width = balance->width;

	for (int rates = 0; rates < (balance->mesh->axial[e] > 0.0 ? 2 : 1); rates++) {
		weigh(balance, e, rates);
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, width, PARTS*width, balance->rows, 1.0,
		            rates ? balance->rate : balance->basis, balance->rows, balance->weighted,
		            PARTS*width, rates, balance->G, PARTS*width);
	}
	for (int i = 0; i < 4; i++)
		put(balance, e, i/2, i%2, balance->G);
}

/* Inertia and damping between directions of two nodes: kg, and kg/s of its damping. */
static void add_mass(struct hawser__mesh_balance *balance, const struct hawser__mesh_pair *pair,
                     double damping, double ratio)
{
	const struct hawser__mesh *mesh = balance->mesh;
	int width = balance->width;
	double *block, Omega = balance->Omega, mass = pair->mass;

	if (mesh->unknown[pair->node][pair->axis] < 0 || mesh->unknown[pair->other][pair->other_axis] < 0)
		return;
	block = hawser__nodal_at(&balance->blocks, balance->blocks.row[pair->node],
	                         balance->blocks.row[pair->other]);
	for (int c = 1; c < width; c++) {
		int row = pair->axis*width + c, column = pair->other_axis*width + c, k = (c + 1)/2;
		int turned = c%2 ? column + 1 : column - 1;
		double speed = Omega*k*(damping + 2.0*ratio*Omega*k*mass);

		block[column*3*width + row] -= Omega*Omega*k*k*mass;
		block[turned*3*width + row] += c%2 ? speed : -speed;
	}
}

/* Masses, dampers and springs of nodes. */
static void add_nodes(struct hawser__mesh_balance *balance)
{
	const struct hawser__mesh *mesh = balance->mesh;
	struct hawser__mesh_pair pair;

	for (int i = 0; i < 3*mesh->nodes; i++) {
		int row = balance->blocks.row[i/3], width = balance->width;

		pair = (struct hawser__mesh_pair){i/3, i%3, i/3, i%3, mesh->mass[i/3]};
		add_mass(balance, &pair, balance->mass_rate*pair.mass + mesh->damper[i/3][i%3], balance->ratio);
		for (int c = i%3*width; c < (i%3 + 1)*width && mesh->unknown[i/3][i%3] >= 0; c++)
			hawser__nodal_at(&balance->blocks, row, row)[c*(3*width + 1)] += mesh->spring[i/3][i%3];
	}
	for (int j = 0; hawser__absorbers_mass(&pair, mesh, j); j++)
		add_mass(balance, &pair, balance->mass_rate*pair.mass, balance->stroke_ratio);
}

/* 1 where a direction is held. */
static void hold_rest(struct hawser__mesh_balance *balance)
{
	const struct hawser__mesh *mesh = balance->mesh;
	int width = balance->width;

	for (int i = 0; i < 3*mesh->nodes; i++) {
		int row = balance->blocks.row[i/3];

		for (int c = 0; c < width && row >= 0 && mesh->unknown[i/3][i%3] < 0; c++)
			hawser__nodal_at(&balance->blocks, row, row)[(i%3*width + c)*(3*width + 1)] = 1.0;
	}
}

int hawser__mesh_balance_factor(struct hawser__mesh_balance *balance, const double *y)
{
	const struct hawser__mesh *mesh = balance->mesh;

	hawser__mesh_balance_residual(balance, balance->work, y);
	hawser__nodal_zero(&balance->blocks);
	for (int e = 0; e < mesh->elements; e++) {
		double mass = mesh->rho[e]*mesh->length0[e];
		double damping = balance->mass_rate*mass + mesh->alpha*mesh->length0[e];

		add_element(balance, e);
		for (int i = 0; i < 12; i++) {
			int to = i/2%2, from = i%2;
			double share = to == from ? 5.0/12.0 : 1.0/12.0;

			const struct hawser__mesh_pair pair = {mesh->end[e][to], i/4, mesh->end[e][from], i/4,
			                                       share*mass};

			add_mass(balance, &pair, share*damping, balance->ratio);
		}
	}
	add_nodes(balance);
	hold_rest(balance);
	balance->factored = hawser__nodal_factor(&balance->blocks);
	if (!balance->factored)
		return 0;
	memset(balance->spare, 0, balance->size*sizeof *balance->spare);
	balance->spare[balance->size - 1] = 1.0;
	hawser__mesh_balance_product(balance, balance->sweep, balance->spare);
	hawser__nodal_solve(&balance->blocks, balance->sweep);
	balance->sweep[balance->size - 1] = -1.0;
	return 1;
}
