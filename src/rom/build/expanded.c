/* rom/build/expanded.c - entries of Q and C from an expanded energy, and the second-order displacement:
 * see expanded.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/grow.h"
#include "core/report.h"
#include "rom/build/expanded.h"
#include "rom/build/model.h"

static enum hawser_status set_quads(struct hawser_rom *rom, const struct hawser__expanded *e, int n,
                                    int least, struct hawser_report *report)
{
	for (int j = 0; j < e->equations; j++)
		for (int k = 0; k < n; k++)
			for (int l = k > least ? k : least; l < n; l++) {
				double value = e->third[((size_t)j*(size_t)e->n + (size_t)k)*(size_t)e->n + (size_t)l];

				if (value == 0.0)
					continue;
				if (hawser__more(&rom->Q, rom->quads, sizeof *rom->Q))
					return hawser__no_memory(report, "rom");
				rom->Q[rom->quads++] = (struct hawser_quad){j, k, l, k == l ? 0.5*value : value};
			}
	return HAWSER_OK;
}

/* 6 over the number of orders of three indices. */
static double share(int k, int l, int m)
{
	return k == m ? 6.0 : k == l || l == m ? 2.0 : 1.0;
}

static enum hawser_status set_cubics(struct hawser_rom *rom, const struct hawser__expanded *e, int n,
                                     int least, struct hawser_report *report)
{
	for (int j = 0; j < e->equations; j++)
		for (int k = 0; k < n; k++)
			for (int l = k; l < n; l++)
				for (int m = l > least ? l : least; m < n; m++) {
					int index[4] = {j, k, l, m};
					double value;

					if (!e->even(e->of, index))
						continue;
					/* the same bits for the same derivative */
					for (int a = 0; a < 3 && index[a] > index[a + 1]; a++) {
						index[a] = index[a + 1];
						index[a + 1] = j;
					}
					value = e->fourth(e->of, index);
					if (!isfinite(value))
						return hawser__fail(report, HAWSER_ERR_NAN, "rom", "the tensor C is %g for "
						                    "modes %d, %d, %d, %d: their shapes are not finite",
						                    value, j + 1, k + 1, l + 1, m + 1);
					if (hawser__more(&rom->C, rom->cubics, sizeof *rom->C))
						return hawser__no_memory(report, "rom");
					value /= share(k, l, m);
					rom->C[rom->cubics++] = (struct hawser_cubic){j, k, l, m, value};
				}
	return HAWSER_OK;
}

enum hawser_status hawser__expanded_tensors(struct hawser_rom *rom, const struct hawser__expanded *e,
                                            int n, int least, struct hawser_report *report)
{
	enum hawser_status status = set_quads(rom, e, n, least, report);

	return status ? status : set_cubics(rom, e, n, least, report);
}

void hawser__expanded_second(double *shape, double *slope, double *line, const struct hawser_rom *rom,
                             const struct hawser__expanded *e, int first, int pairs)
{
	int points = rom->shapes.points, along = rom->line.points;

	for (int pair = first; pair < first + pairs; pair++) {
		double u[3];

		for (int p = 0; p < points; p++, shape += 3, slope += 3)
			e->pair_at(shape, slope, e->of, pair, p);
		for (int p = points; p < points + along; p++, line += 3)
			e->pair_at(u, line, e->of, pair, p);
	}
}

enum hawser_status hawser__expanded_pairs(struct hawser_rom *rom, const struct hawser__expanded *e,
                                          struct hawser_report *report)
{
	enum hawser_status status = hawser__rom_init_second(rom, report);

	if (!status)
		hawser__expanded_second(rom->shapes.second_shape, rom->shapes.second_slope,
		                        rom->line.second_slope, rom, e, 0, e->equations*(e->equations + 1)/2);
	return status;
}
