/* rom/kernel.c - restoring force, tangent and energy of a compiled model: the innermost loops.
 *
 * Why not a loop over monomials: each cubic monomial would be touched once for the force and three
 * times for the tangent, with scattered writes. In the form of kernel.h every nonzero is one
 * multiply-add into a register, and the tangent is free.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "rom/kernel.h"

/* u_l u_m for l <= m, in the order (0,0) (0,1) (1,1) (0,2) ... : the index of a pair does not
 * depend on n. */
static void products(double *pair, const double *u, int n)
{
	for (int m = 0; m < n; m++)
		for (int l = 0; l <= m; l++)
			*pair++ = u[l]*u[m];
}

static double gather(const int *col, const double *val, int begin, int end, const double *x)
{
	double sum = 0.0;

	for (int i = begin; i < end; i++)
		sum += val[i]*x[col[i]];
	return sum;
}

void hawser_rom_restoring(const struct hawser_rom *rom, double *restoring, const double *u)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	double pair[HAWSER_ROM_MAX_PAIRS];

	products(pair, u, rom->n);
	memset(restoring, 0, (size_t)rom->n*sizeof *restoring);
	for (const struct hawser__row *row = kernel->row; row < kernel->row + kernel->rows; row++) {
		double g = row->constant + gather(kernel->col, kernel->val, row->a, row->a_end, u) +
		           gather(kernel->col, kernel->val, row->b, row->b_end, pair);

		restoring[row->j] += g*u[row->k];
		if (kernel->symmetric && row->j != row->k)
			restoring[row->k] += g*u[row->j];
	}
}

void hawser_rom_tangent(const struct hawser_rom *rom, double *restoring, double *tangent,
                        const double *u)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	int n = rom->n;
	double pair[HAWSER_ROM_MAX_PAIRS];

	products(pair, u, n);
	memset(restoring, 0, (size_t)n*sizeof *restoring);
	memset(tangent, 0, (size_t)n*n*sizeof *tangent);
	for (const struct hawser__row *row = kernel->row; row < kernel->row + kernel->rows; row++) {
		double a = gather(kernel->col, kernel->val, row->a, row->a_end, u);
		double b = gather(kernel->col, kernel->val, row->b, row->b_end, pair);
		double g = row->constant + a + b, t = row->constant + 2.0*a + 3.0*b;
		int j = row->j, k = row->k;

		restoring[j] += g*u[k];
		tangent[j*n + k] = t;
		if (kernel->symmetric && j != k) {
			restoring[k] += g*u[j];
			tangent[k*n + j] = t;
		}
	}
}

double hawser_rom_energy(const struct hawser_rom *rom, const double *u, const double *v)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	double pair[HAWSER_ROM_MAX_PAIRS], energy = 0.0;

	products(pair, u, rom->n);
	for (int j = 0; j < rom->n; j++)
		energy += 0.5*v[j]*v[j];
	for (const struct hawser__row *row = kernel->row; row < kernel->row + kernel->rows; row++) {
		double a = gather(kernel->col, kernel->val, row->a, row->a_end, u);
		double b = gather(kernel->col, kernel->val, row->b, row->b_end, pair);
		double twice = kernel->symmetric && row->j != row->k ? 2.0 : 1.0;

		energy += twice*(row->constant/2.0 + a/3.0 + b/4.0)*u[row->j]*u[row->k];
	}
	return energy;
}

double hawser_rom_asymmetry(const struct hawser_rom *rom)
{
	return rom->kernel->asymmetry;
}

void hawser__kernel_free(struct hawser_rom_kernel *kernel)
{
	if (!kernel)
		return;
	free(kernel->row);
	free(kernel->col);
	free(kernel->val);
	free(kernel->d_j);
	free(kernel->d_k);
	free(kernel->d_val);
	free(kernel);
}
