/* Harmonic balance by blocks (balance_blocks.h): products with the Jacobian and solutions against the
 * matrix, with coordinates below, above and far above the harmonics.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>

#include "response/orbit/balance.h"
#include "tests/balance-model.h"
#include "tests/tap.h"

/* A fast coordinate of stiffness `fast` in addition to those of make_general, coupled by quadratic
 * terms. */
static int make_stiff(struct hawser_rom *rom, double fast)
{
	if (make_general(rom))
		return 1;
	rom->Q = realloc(rom->Q, 4*sizeof *rom->Q);
	rom->Q[rom->quads++] = (struct hawser_quad){1, 0, 1, 0.02*fast};
	rom->Q[rom->quads++] = (struct hawser_quad){0, 1, 1, 0.01*fast};
	rom->K[3] = fast;
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* The product for a vector x that is 0 below the separate harmonics, which may omit the others. */
static void check_last_harmonics(struct hawser__balance *by, double *a, double *b, double *x)
{
	int count = by->unknowns + 1;
	double off = 0.0;

	for (int i = 0; i < count - 1 - by->top_count; i++)
		x[i] = 0.0;
	hawser__balance_product(by, a, x, 0);
	hawser__balance_product(by, b, x, by->top_from);
	for (int i = 0; i < count; i++)
		off = fmax(off, fabs(a[i] - b[i]));
	ok(by->top_from > 1 && off < 1e-12, "product for the last harmonics: %.1e", off);
}

/* The solution of equations of order 8 and 24 from their factors has small residuals. */
static void check_substitution(int count)
{
	float A[24*24], lu[24*24], x[24];
	int pivot[24];
	double off = 0.0;

	for (int i = 0; i < count*count; i++)
		lu[i] = A[i] = (float)sin(2.385*i*i);
	for (int i = 0; i < count; i++)
		x[i] = (float)cos(1.7*i);
	ok(!LAPACKE_sgetrf_work(LAPACK_COL_MAJOR, count, count, lu, count, pivot), "factors");
	hawser__blocks_invert_diagonal(lu, count);
	hawser__blocks_substitute(x, lu, pivot, count);
	for (int i = 0; i < count; i++) {
		double sum = -cos(1.7*i);

		for (int j = 0; j < count; j++)
			sum += (double)A[j*count + i]*x[j];
		off = fmax(off, fabs(sum));
	}
	ok(off < 1e-5, "order %d: residual %.1e", count, off);
}

/* Solutions by blocks with GMRES, and products without a matrix, agree with those of the matrix. */
static void check_blocks(double fast, const char *what)
{
	struct hawser_rom rom;
	struct hawser__balance by[2];
	double *y, *row, *dy[2], *x, *image[2], gap = 0.0, size = 0.0, off = 0.0, top = 0.0;
	int count, last, iterations;

	if (make_stiff(&rom, fast) || hawser__balance_init(&by[0], &rom, NULL) ||
	    hawser__balance_init(&by[1], &rom, NULL))
		return;
	by[1].dense = 1;
	y = some_orbit(&by[0], 5, 1.17);
	last = by[0].base.size - 1;
	for (int i = 1; i < last; i += 2)
		y[i] *= 4.1/fast; /* it follows the other coordinate statically */
	row = calloc((size_t)last + 1, sizeof *row);
	x = calloc((size_t)last + 1, sizeof *x);
	for (int i = 0; i <= last; i++)
		row[i] = i < 60 || i == last ? sin(i + 0.4)*exp(-0.1*(i%last)) : 0.0;
	for (int i = 0; i < 2; i++) {
		dy[i] = calloc((size_t)last + 1, sizeof *y);
		image[i] = calloc((size_t)last + 1, sizeof *y);
		if (activate(&by[i], 40))
			return;
		by[i].base.ops->metric(&by[i].base, y);
		(void)by[i].base.ops->defects(&by[i].base, y, 1);
		(void)by[i].base.ops->factor(&by[i].base, row);
	}
	ok(by[0].blockwise && !by[1].blockwise, "%s: by blocks and by the matrix", what);
	count = by[0].unknowns + 1;
	for (int i = 0; i < count; i++)
		x[i] = cos(1.7*i)*exp(-0.05*i);
	hawser__balance_product(&by[0], image[0], x, 0);
	for (int i = 0; i < count; i++) {
		for (int c = 0; c < count; c++)
			image[1][i] += by[1].matrix[(size_t)i*count + c]*x[c];
		off = fmax(off, fabs(image[0][i] - image[1][i]));
		top = fmax(top, fabs(image[1][i]));
	}
	ok(off < 1e-12*top, "%s: product without a matrix: %.1e of %.1e", what, off, top);
	check_last_harmonics(&by[0], image[0], image[1], x);
	for (int homogeneous = 0; homogeneous < 2; homogeneous++) {
		int before = by[0].iterations;

		for (int i = 0; i < 2; i++)
			by[i].base.ops->solve(&by[i].base, dy[i], homogeneous, homogeneous);
		gap = size = 0.0;
		for (int i = 0; i <= last; i++) {
			gap = fmax(gap, fabs(dy[0][i] - dy[1][i]));
			size = fmax(size, fabs(dy[1][i]));
		}
		iterations = by[0].iterations - before;
		ok(by[0].blockwise && iterations <= 8, "%s: %d iterations", what, iterations);
		/* residuals of 1e-9 and 1e-5, times the condition of the matrix */
		ok(gap < (homogeneous ? 1e-7 : 1e-3)*size, "%s: solutions %.1e of %.1e apart", what, gap, size);
	}
	for (int i = 0; i < 2; i++) {
		free(dy[i]);
		free(image[i]);
		hawser__balance_release(&by[i]);
	}
	free(y);
	free(row);
	free(x);
	hawser_rom_clear(&rom);
}

CASE(unit_balance_blocks)
{
	check_substitution(8);
	check_substitution(24);
	check_blocks(4.1, "slow coordinates");
	check_blocks(4e3, "a coordinate above the harmonics");
	check_blocks(4e6, "a coordinate far above the harmonics");
	return done_testing();
}
