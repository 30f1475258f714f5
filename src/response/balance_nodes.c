/* response/balance_nodes.c - stiffness and damping at the nodes of the blocks of balance_blocks.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>

#include "response/balance.h"

#define S HAWSER__NODES

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

void hawser__blocks_evaluate(struct hawser__blocks *blocks, const struct hawser__balance *balance,
                             int step)
{
	const struct hawser_rom *rom = balance->base.rom;
	int n2 = rom->n*rom->n, columns = 2*blocks->width + 1;
	float *table = blocks->table + (size_t)step*S*columns;

	for (int i = 0; i < S; i++)
		table[i*columns] = 0.5; /* T's constant is twice the mean */
	cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, S, n2, 2*balance->spread + 1, 1.0, table,
	            columns, blocks->T, n2, 0.0, blocks->stiff, n2);
	for (int i = 0; i < S; i++) {
		float *damp = blocks->damp + (size_t)i*n2;

		table[i*columns] = 1.0;
		for (int e = 0; e < n2; e++)
			damp[e] = (float)rom->D[e];
		for (int p = 0; p < rom->harmonics; p++) {
			const struct hawser_harmonic *harmonic = &rom->harmonic[p];
			int at = 2*harmonic->k - (harmonic->phase == HAWSER_COS);

			if (!harmonic->D || harmonic->k > blocks->width)
				continue;
			for (int e = 0; e < n2; e++)
				damp[e] += (float)(pow(blocks->omega, harmonic->omega_power)*
				                   table[i*columns + at]*harmonic->D[e]);
		}
	}
}
