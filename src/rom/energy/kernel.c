/* rom/energy/kernel.c - restoring force, tangent and energy of a compiled model: the innermost loops.
 *
 * A loop over monomials would access each cubic monomial once for the force and three times for the
 * tangent, with scattered writes. In the form of kernel.h every nonzero is one multiply-add into a
 * register, four at a time, and the tangent costs little in addition.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/hot.h"
#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"
#include "rom/energy/quartic.h"
#include "rom/file/plug.h"
#include "rom/terms/terms.h"

/* The factors of the rows: u and the products of its components, in the kernel's order of columns.
 * The last block of a run may extend past the end, with zeros for values. */
struct operands {
	double single[HAWSER_ROM_MOST + HAWSER_BLOCK];
	double pair[HAWSER_ROM_MOST_PAIRS + HAWSER_BLOCK];
};

HAWSER_PART void prepare(struct operands *x, const struct hawser_rom_kernel *kernel,
                         const double *u, int n)
{
	int pairs = n*(n + 1)/2;

	for (int c = 0; c < n; c++)
		x->single[c] = u[kernel->single[c]];
	for (int c = 0; c < pairs; c++)
		x->pair[c] = u[kernel->pair_l[c]]*u[kernel->pair_m[c]];
	for (int c = 0; c < HAWSER_BLOCK; c++)
		x->single[n + c] = x->pair[pairs + c] = 0.0;
}

/* Sum of the runs' values times the columns of x; two sums hide the latency of an addition. */
HAWSER_PART double gather(const struct hawser_rom_kernel *kernel, int begin, int end,
                          const double *x)
{
	hawser__vec even = {0.0}, odd = {0.0};

	for (int r = begin; r < end; r++) {
		const struct hawser__run *run = &kernel->run[r];
		const hawser__vec *v = (const hawser__vec *)(kernel->value + run->at);
		const hawser__vec *c = (const hawser__vec *)(x + run->col);
		int b = 0;

		for (; b + 2 <= run->blocks; b += 2) {
			even += v[b]*c[b];
			odd += v[b + 1]*c[b + 1];
		}
		if (b < run->blocks)
			even += v[b]*c[b];
	}
	even += odd;
	return (even[0] + even[1]) + (even[2] + even[3]);
}

HAWSER_HOT
static void restore(const struct hawser_rom *rom, double *restoring, const double *u)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	struct operands x;

	prepare(&x, kernel, u, rom->n);
	memset(restoring, 0, (size_t)rom->n*sizeof *restoring);
	for (const struct hawser__kernel_row *row = kernel->row; row < kernel->row + kernel->rows; row++) {
		double g = row->constant + gather(kernel, row->a, row->a_end, x.single) +
		           gather(kernel, row->b, row->b_end, x.pair);

		restoring[row->j] += g*u[row->k];
		if (kernel->symmetric && row->j != row->k)
			restoring[row->k] += g*u[row->j];
	}
}

HAWSER_HOT
static void differentiate(const struct hawser_rom *rom, double *restoring, double *tangent,
                          const double *u)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	int n = rom->n;
	struct operands x;

	prepare(&x, kernel, u, n);
	memset(restoring, 0, (size_t)n*sizeof *restoring);
	memset(tangent, 0, (size_t)n*n*sizeof *tangent);
	for (const struct hawser__kernel_row *row = kernel->row; row < kernel->row + kernel->rows; row++) {
		double a = gather(kernel, row->a, row->a_end, x.single);
		double b = gather(kernel, row->b, row->b_end, x.pair);
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

/* A function that is compiled for several processors is a resolver to the linker, which libtool
 * does not export. The public functions therefore call these. */
void hawser_rom_restoring(const struct hawser_rom *rom, double *restoring, const double *u)
{
	if (rom->exact)
		hawser__exact_tangent(rom->exact, restoring, NULL, u);
	else if (rom->kernel->by_function[HAWSER__FORCE])
		hawser__quartic_force(rom->kernel->quartic, restoring, u);
	else
		restore(rom, restoring, u);
}

void hawser_rom_tangent(const struct hawser_rom *rom, double *restoring, double *tangent,
                        const double *u)
{
	if (rom->exact)
		hawser__exact_tangent(rom->exact, restoring, tangent, u);
	else if (rom->kernel->by_function[HAWSER__TANGENT])
		hawser__quartic_tangent(rom->kernel->quartic, restoring, tangent, u);
	else
		differentiate(rom, restoring, tangent, u);
}

int hawser_rom_autonomous(const struct hawser_rom *rom)
{
	for (int h = 0; h < rom->harmonics; h++)
		if (rom->harmonic[h].k > 0)
			return 0;
	return !rom->ramp && !rom->history && (!rom->plug || rom->plug->still);
}

int hawser_rom_loaded(const struct hawser_rom *rom)
{
	for (int h = 0; h < rom->harmonics; h++)
		for (int j = 0; rom->harmonic[h].f && j < rom->n; j++)
			if (rom->harmonic[h].f[j] != 0.0)
				return 1;
	return 0;
}

double hawser_rom_energy(const struct hawser_rom *rom, const double *u, const double *v)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	struct operands x;
	double energy = 0.0;

	for (int j = 0; j < rom->n; j++)
		energy += 0.5*v[j]*hawser__rom_weighed(rom, v, j);
	if ((rom->plug && !rom->plug->water) || rom->first)
		return energy;
	if (rom->exact)
		return energy + hawser__exact_potential(rom->exact, u);
	if (kernel->by_function[HAWSER__FORCE])
		return energy + hawser__quartic_potential(kernel->quartic, u);
	prepare(&x, kernel, u, rom->n);
	for (const struct hawser__kernel_row *row = kernel->row; row < kernel->row + kernel->rows; row++) {
		double a = gather(kernel, row->a, row->a_end, x.single);
		double b = gather(kernel, row->b, row->b_end, x.pair);
		double twice = kernel->symmetric && row->j != row->k ? 2.0 : 1.0;
		double both = hawser__rom_weighed(rom, u, row->j)*u[row->k];

		if (rom->mass && twice > 1.0) /* the entry (k, j), which is not the same with a mass */
			both = 0.5*(both + hawser__rom_weighed(rom, u, row->k)*u[row->j]);
		energy += twice*(row->constant/2.0 + a/3.0 + b/4.0)*both;
	}
	return energy + hawser__terms_potential(rom, u);
}

double hawser_rom_asymmetry(const struct hawser_rom *rom)
{
	return rom->kernel->asymmetry;
}

void hawser__kernel_free(struct hawser_rom_kernel *kernel)
{
	if (!kernel)
		return;
	hawser__hold_clear(&kernel->hold);
	hawser__panels_free(kernel->panels);
	hawser__panels_free(kernel->gradient);
	hawser__quartic_free(kernel->quartic);
	hawser__rates_free(kernel->rates);
	free(kernel);
}
