/* rom/build/line_tensors.c - entries of Q and C of a rope over sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/build/line.h"

static enum hawser_status set_quads(struct hawser_rom *rom, const struct hawser__lexpand *t, int n,
                                    int least, struct hawser_report *report)
{
	size_t equations = (size_t)rom->n, width = (size_t)n;

	rom->Q = malloc((equations*width*(width + 1)/2 + 1)*sizeof *rom->Q);
	if (!rom->Q)
		return hawser__no_memory(report, "line rom");
	for (int j = 0; j < rom->n; j++)
		for (int k = 0; k < n; k++)
			for (int l = k > least ? k : least; l < n; l++) {
				double value = t->third[(j*t->n + k)*t->n + l];

				if (value != 0.0)
					rom->Q[rom->quads++] = (struct hawser_quad){j, k, l, k == l ? 0.5*value : value};
			}
	return HAWSER_OK;
}

/* 6 over the number of orders of three indices. */
static double share(int k, int l, int m)
{
	return k == m ? 6.0 : k == l || l == m ? 2.0 : 1.0;
}

/* Numbers of planes that occur an odd number of times have no energy. */
static int even(const struct hawser__lexpand *t, const int index[4])
{
	int out = 0;

	for (int i = 0; i < 4; i++)
		out += t->rope->system[t->shape[index[i]].system].plane == HAWSER_OUT_OF_PLANE;
	return out%2 == 0;
}

static enum hawser_status set_cubics(struct hawser_rom *rom, const struct hawser__lexpand *t, int n,
                                     int least, struct hawser_report *report)
{
	size_t equations = (size_t)rom->n, width = (size_t)n;

	rom->C = malloc((equations*width*(width + 1)*(width + 2)/6 + 1)*sizeof *rom->C);
	if (!rom->C)
		return hawser__no_memory(report, "line rom");
	for (int j = 0; j < rom->n; j++)
		for (int k = 0; k < n; k++)
			for (int l = k; l < n; l++)
				for (int m = l > least ? l : least; m < n; m++) {
					int index[4] = {j, k, l, m};
					double value;

					if (!even(t, index))
						continue;
					/* the same bits for the same derivative */
					for (int a = 0; a < 3 && index[a] > index[a + 1]; a++) {
						index[a] = index[a + 1];
						index[a + 1] = j;
					}
					value = hawser__lexpand_fourth(t, index);
					if (!isfinite(value))
						return hawser__fail(report, HAWSER_ERR_NAN, "line rom", "the tensor C is %g "
						                    "for modes %d, %d, %d, %d: their shapes are not finite",
						                    value, j + 1, k + 1, l + 1, m + 1);
					value /= share(k, l, m);
					rom->C[rom->cubics++] = (struct hawser_cubic){j, k, l, m, value};
				}
	return HAWSER_OK;
}

enum hawser_status hawser__line_tensors(struct hawser_rom *rom, const struct hawser__lexpand *t, int n,
                                        int least, struct hawser_report *report)
{
	enum hawser_status status = set_quads(rom, t, n, least, report);

	return status ? status : set_cubics(rom, t, n, least, report);
}
