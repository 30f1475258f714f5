/* rom/energy/block.c - restoring forces and tangents at many states in one call.
 *
 *    x     one quantity at 4 or 8 states: a "column" of `vecs` vectors
 *    a, b  sums over a row of A and of B (kernel.h): force (K + a + b) u, tangent K + 2a + 3b
 *
 * The period map (with independent segments) and Fourier methods (with the samples of a period)
 * need many states at once. The vectors run over the states: every nonzero of the tensors is read
 * once for four or eight states and four rows, and there are no sums across a vector.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "core/hot.h"
#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"
#include "rom/terms/vary.h"

#define WIDE 2 /* vectors per column if there are enough states: hides the latency of a sum */

/* pair [n(n+1)/2][vecs] = products u_l u_m, l <= m. */
HAWSER_PART void multiply_pairs(hawser__vec *pair, const hawser__vec *u, int n, const int vecs)
{
	for (int m = 0; m < n; m++)
		for (int l = 0; l <= m; l++)
			HAWSER_UNROLL
			for (int v = 0; v < vecs; v++)
				*pair++ = u[l*vecs + v]*u[m*vecs + v];
}

/* sum [rows][vecs] = entries [begin, end) of a panel's rows times their columns of x. */
HAWSER_PART void sum_up(hawser__vec *sum, const hawser__vec *x,
                        const struct hawser__kernel_panels *panels,
                        int begin, int end, const int rows, const int vecs)
{
	const double *value = panels->value + 4*begin;
	hawser__vec zero = {0.0};

	HAWSER_UNROLL
	for (int i = 0; i < rows*vecs; i++)
		sum[i] = zero;
	for (int c = begin; c < end; c++, value += 4) {
		const hawser__vec *column = x + panels->column[c]*vecs;

		HAWSER_UNROLL
		for (int r = 0; r < rows; r++)
			HAWSER_UNROLL
			for (int v = 0; v < vecs; v++)
				sum[r*vecs + v] += value[r]*column[v];
	}
}

/* Adds the force [n][vecs] of a panel and stores its tangents, [n][n][vecs], unless NULL. */
HAWSER_PART void add_panel(hawser__vec *force, hawser__vec *tangent, const hawser__vec *u,
                           const hawser__vec *pair, const struct hawser__kernel_panels *panels,
                           const struct hawser__panel *panel, int n, int symmetric, const int rows,
                           const int vecs)
{
	hawser__vec a[4*WIDE], b[4*WIDE];

	sum_up(a, u, panels, panel->a, panel->a_end, rows, vecs);
	sum_up(b, pair, panels, panel->b, panel->b_end, rows, vecs);
	HAWSER_UNROLL
	for (int i = 0; i < rows*vecs; i++) {
		int j = panel->j[i/vecs], k = panel->k[i/vecs], v = i%vecs;
		double constant = panel->constant[i/vecs];
		hawser__vec both = a[i] + b[i], g = constant + both;

		force[j*vecs + v] += g*u[k*vecs + v];
		if (symmetric && j != k)
			force[k*vecs + v] += g*u[j*vecs + v];
		if (!tangent)
			continue;
		tangent[(j*n + k)*vecs + v] = g + both + b[i];
		if (symmetric && j != k)
			tangent[(k*n + j)*vecs + v] = g + both + b[i];
	}
}

HAWSER_PART void evaluate(const struct hawser_rom *rom, hawser__vec *force, hawser__vec *tangent,
                          const hawser__vec *u, hawser__vec *pair, const int vecs)
{
	const struct hawser__kernel_panels *panels = rom->kernel->panels;
	int n = rom->n, symmetric = rom->kernel->symmetric;

	multiply_pairs(pair, u, n, vecs);
	memset(force, 0, (size_t)n*vecs*sizeof *force);
	if (tangent)
		memset(tangent, 0, (size_t)n*n*vecs*sizeof *tangent);
	for (int p = 0; p < panels->count; p++) {
		const struct hawser__panel *panel = &panels->panel[p];

		switch (panel->rows) {
		case 4:
			add_panel(force, tangent, u, pair, panels, panel, n, symmetric, 4, vecs);
			break;
		case 3:
			add_panel(force, tangent, u, pair, panels, panel, n, symmetric, 3, vecs);
			break;
		case 2:
			add_panel(force, tangent, u, pair, panels, panel, n, symmetric, 2, vecs);
			break;
		default:
			add_panel(force, tangent, u, pair, panels, panel, n, symmetric, 1, vecs);
		}
	}
}

/* y[row] += a panel's rows times z. */
HAWSER_PART void add_rows(hawser__vec *y, const hawser__vec *z,
                          const struct hawser__kernel_panels *panels,
                          const struct hawser__panel *panel, const int rows, const int vecs)
{
	hawser__vec sum[4*WIDE];

	sum_up(sum, z, panels, panel->a, panel->b_end, rows, vecs);
	HAWSER_UNROLL
	for (int i = 0; i < rows*vecs; i++)
		y[panel->j[i/vecs]*vecs + i%vecs] += sum[i];
}

/* Forces only, from the potential as a quadratic form (gradient.c). z is u followed by space for
 * the products; y has the same size. */
HAWSER_PART void derive(const struct hawser_rom *rom, hawser__vec *force, hawser__vec *z,
                        hawser__vec *y, const int vecs)
{
	const struct hawser__kernel_panels *panels = rom->kernel->gradient;
	int n = rom->n;
	const hawser__vec *slope = y + n*vecs;

	multiply_pairs(z + n*vecs, z, n, vecs);
	memset(y, 0, (size_t)(n + n*(n + 1)/2)*vecs*sizeof *y);
	for (int p = 0; p < panels->count; p++) {
		const struct hawser__panel *panel = &panels->panel[p];

		switch (panel->rows) {
		case 4:
			add_rows(y, z, panels, panel, 4, vecs);
			break;
		case 3:
			add_rows(y, z, panels, panel, 3, vecs);
			break;
		case 2:
			add_rows(y, z, panels, panel, 2, vecs);
			break;
		default:
			add_rows(y, z, panels, panel, 1, vecs);
		}
	}
	memcpy(force, y, (size_t)n*vecs*sizeof *force);
	for (int m = 0; m < n; m++)
		for (int l = 0; l <= m; l++)
			HAWSER_UNROLL
			for (int v = 0; v < vecs; v++, slope++) {
				force[l*vecs + v] += *slope*z[m*vecs + v];
				force[m*vecs + v] += *slope*z[l*vecs + v];
			}
}

/* work: u and the products, and as much space again */
HAWSER_HOT
static void evaluate_four(const struct hawser_rom *rom, double *force, double *tangent,
                          const double *u, double *work)
{
	int n = rom->n;
	double *y = work + 4*(n + n*(n + 1)/2);

	memcpy(work, u, 4*(size_t)n*sizeof *work);
	if (tangent || !rom->kernel->gradient)
		evaluate(rom, (hawser__vec *)force, (hawser__vec *)tangent, (const hawser__vec *)u,
		         (hawser__vec *)work, 1);
	else
		derive(rom, (hawser__vec *)force, (hawser__vec *)work, (hawser__vec *)y, 1);
}

/* the same; u is the beginning of work */
HAWSER_HOT
static void evaluate_eight(const struct hawser_rom *rom, double *force, double *tangent, double *work)
{
	int n = rom->n;
	double *pair = work + 8*n, *y = work + 8*(n + n*(n + 1)/2);

	if (tangent || !rom->kernel->gradient)
		evaluate(rom, (hawser__vec *)force, (hawser__vec *)tangent,
		         (const hawser__vec *)work, (hawser__vec *)pair, WIDE);
	else
		derive(rom, (hawser__vec *)force, (hawser__vec *)work, (hawser__vec *)y, WIDE);
}

/* Several states by function: as fast as one by one, which is then by function too. */
static int by_function(const struct hawser_rom *rom, int tangent)
{
	return rom->kernel->by_function[tangent ? HAWSER__TANGENTS : HAWSER__FORCES];
}

/* One state after another, by the kernel for one state. */
static void evaluate_each(const struct hawser_rom *rom, double *restoring, double *tangent,
                          const double *u, int live, double *work)
{
	int n = rom->n;
	double *one = work, *force = one + n, *slope = force + n;

	for (int lane = 0; lane < live; lane++) {
		for (int j = 0; j < n; j++)
			one[j] = u[j*HAWSER_LANES + lane];
		if (tangent)
			hawser_rom_tangent(rom, force, slope, one);
		else
			hawser_rom_restoring(rom, force, one);
		for (int j = 0; j < n; j++)
			restoring[j*HAWSER_LANES + lane] = force[j];
		for (int i = 0; tangent && i < n*n; i++)
			tangent[i*HAWSER_LANES + lane] = slope[i];
	}
}

void hawser__rom_lanes(const struct hawser_rom *rom, double *restoring, double *tangent,
                       const double *u, int live, double *work)
{
	if (live == 1 || rom->exact || by_function(rom, tangent != NULL))
		evaluate_each(rom, restoring, tangent, u, live, work);
	else
		evaluate_four(rom, restoring, tangent, u, work);
}

/* Of eight states: u and the products, as much again, force and tangent. */
size_t hawser__rom_tangents_work(const struct hawser_rom *rom, int count)
{
	size_t n = (size_t)rom->n;

	if (rom->exact)
		return hawser__exact_work(rom->exact, count);
	return count > 1 ? 8*(3*n + n*n + n*(n + 1)) : 0;
}

/* to [live][size] from lanes [size][8]. */
static void spread(double *to, const double *lanes, size_t size, int live)
{
	for (int i = 0; i < live; i++)
		for (size_t e = 0; e < size; e++)
			to[(size_t)i*size + e] = lanes[8*e + (size_t)i];
}

void hawser__rom_tangents(const struct hawser_rom *rom, double *restoring, double *tangent,
                          const double *u, int count, double *work)
{
	size_t n = (size_t)rom->n;
	double *lanes = work, *force = lanes + 8*(2*n + n*(n + 1)), *slope = force + 8*n;
	int each;

	if (rom->exact) {
		hawser__exact_tangents(rom->exact, restoring, tangent, u, count, work);
		hawser__rom_vary_all(rom, restoring, tangent, u, count);
		return;
	}
	each = count == 1 || by_function(rom, tangent != NULL);
	for (int i = 0; each && i < count; i++) {
		size_t at = (size_t)i*n;

		if (tangent)
			hawser_rom_tangent(rom, restoring + at, tangent + at*n, u + at);
		else
			hawser_rom_restoring(rom, restoring + at, u + at);
	}
	if (each)
		hawser__rom_vary_all(rom, restoring, tangent, u, count);
	for (int first = 0; !each && first < count; first += 8) {
		int live = count - first < 8 ? count - first : 8;

		/* unused lanes get the last state */
		for (int i = 0; i < 8; i++) {
			const double *from = u + (size_t)(first + (i < live ? i : live - 1))*n;

			for (size_t j = 0; j < n; j++)
				lanes[8*j + (size_t)i] = from[j];
		}
		evaluate_eight(rom, force, tangent ? slope : NULL, lanes);
		hawser__rom_vary_eight(rom, force, tangent ? slope : NULL, lanes, first, count);
		spread(restoring + (size_t)first*n, force, n, live);
		if (tangent)
			spread(tangent + (size_t)first*n*n, slope, n*n, live);
	}
}

double hawser__rom_flops(const struct hawser_rom *rom, int tangent)
{
	int form = !tangent && rom->kernel->gradient, n = rom->n;
	const struct hawser__kernel_panels *panels = form ? rom->kernel->gradient : rom->kernel->panels;
	/* operations of a row besides its sums: g, the tangent and the force; or the sum of the parts */
	double row = form ? 1.0 : (tangent ? 4.0 : 2.0) + (rom->kernel->symmetric ? 4.0 : 2.0);
	double sum = (form ? 5.0 : 1.0)*(n*(n + 1)/2); /* products u_l u_m, and their part of a force */

	if (rom->exact)
		return rom->exact->points*(tangent ? 60.0 + 3.0*n*n : 40.0 + 6.0*n) +
		       (rom->exact->springs ? 2.0*n*n : 0.0);
	if (by_function(rom, tangent))
		return hawser__function_flops(&rom->kernel->size, tangent);
	for (int p = 0; p < panels->count; p++) {
		const struct hawser__panel *panel = &panels->panel[p];

		sum += panel->rows*(2.0*(panel->b_end - panel->a) + row);
	}
	return sum;
}
