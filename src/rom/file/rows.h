/* rom/file/rows.h - the forces of a model as one list of products, for exports. See rows.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ROWS_H
#define HAWSER_ROM_ROWS_H

#include <hawser/rom.h>

/* value times wave h (0: 1; from 1: that of harmonic h - 1) times the product of states, on the right
 * side of equation j. States are u, then v; `damping`: of the D of the model. */
struct hawser__row {
	int j, h, damping, factors;
	int factor[HAWSER_TERM_FACTORS];
	double value;
};

/* *row [*rows] of a model, to be freed; NULL: memory is short. */
void hawser__rows(struct hawser__row **row, int *rows, const struct hawser_rom *rom);

#endif
