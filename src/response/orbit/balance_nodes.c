/* response/orbit/balance_nodes.c - stiffness and damping at the nodes of the blocks of
 * balance_blocks.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>

#include "response/orbit/balance.h"

#define S HAWSER__BLOCK_NODES
#define SLIGHT 1e-5 /* chosen, far below the errors of the steps (balance_blocks.c) */

void hawser__blocks_tabulate(struct hawser__blocks *blocks)
{
	int columns = 2*blocks->width + 1;

	for (int i = 0; i < (S + 1)*blocks->steps; i++) {
		int step = i < S*blocks->steps ? i/S : i - S*blocks->steps;
		double node = i < S*blocks->steps ? blocks->radau.node[i%S] : 0.0;
		double tau = 2.0*M_PI*(step + node)/blocks->steps;
		float *row = blocks->table + (size_t)i*columns; /* `start` follows the table in memory */

		row[0] = 1.0;
		for (int k = 1; k <= blocks->width; k++) {
			row[2*k - 1] = cos(k*tau);
			row[2*k] = sin(k*tau);
		}
	}
}

/* Harmonics of the tangent whose sizes, relative to the stiffnesses of their coordinates, add up to
 * more than SLIGHT: the others matter less to the preconditioner than the errors of its steps. */
int hawser__blocks_harmonics(const struct hawser__balance *balance)
{
	int n = balance->base.n;
	double least = balance->derived_at*balance->derived_at, sum = 0.0;

	for (int k = balance->spread; k > 0; k--) {
		double part = 0.0;

		for (int i = 0; i < n; i++)
			for (int j = 0; j < n; j++) {
				double c = balance->T[hawser__cos(n*n, k, i*n + j)];
				double s = balance->T[hawser__sin(n*n, k, i*n + j)];
				double scale = fmax(fabs(balance->stiffness[i]), least)*
				               fmax(fabs(balance->stiffness[j]), least);

				part = fmax(part, (c*c + s*s)/scale);
			}
		sum += sqrt(part);
		if (sum > SLIGHT)
			return k;
	}
	return 0;
}

void hawser__blocks_evaluate(struct hawser__blocks *blocks, const struct hawser__balance *balance,
                             int step)
{
	const struct hawser_rom *rom = balance->base.rom;
	int n2 = rom->n*rom->n, columns = 2*blocks->width + 1;
	float *table = blocks->table + (size_t)step*S*columns;

	for (int i = 0; i < S; i++)
		table[i*columns] = 0.5; /* T's constant is twice the mean */
	cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, S, n2, 2*blocks->harmonics + 1, 1.0, table,
	            columns, blocks->T, n2, 0.0, blocks->stiff, n2);
	if (blocks->more)
		cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, S, n2,
		            2*balance->monodromy.resist_order + 1, 1.0, table, columns, blocks->resist, n2,
		            0.0, blocks->damp, n2);
	for (int i = 0; i < S; i++) {
		float *damp = blocks->damp + (size_t)i*n2;

		table[i*columns] = 1.0;
		for (int e = 0; e < n2; e++)
			damp[e] = (float)rom->D[e] + (blocks->more ? damp[e] : 0.0F);
		for (int p = 0; p < rom->harmonics; p++) {
			const struct hawser_harmonic *harmonic = &rom->harmonic[p];
			size_t at = hawser__series_row(harmonic);

			if (!harmonic->D || harmonic->k > blocks->width)
				continue;
			for (int e = 0; e < n2; e++)
				damp[e] += (float)(pow(blocks->omega, harmonic->omega_power)*
				                   table[(size_t)(i*columns) + at]*harmonic->D[e]);
		}
	}
}
