/* core/rows3.h - rows of a 3x3 block with a right side beside them: elimination along chains.
 *
 * Rows of [block | right side] are registers of four numbers, and variables without index, so that they
 * stay in registers: to store single numbers and load them as one register stalls a processor.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_ROWS3_H
#define HAWSER_CORE_ROWS3_H

#include "core/hot.h"

struct hawser__rows {
	hawser__vec x, y, z;
};

/* The transposed cofactors c of the block, row by row; returns the determinant. */
HAWSER_PART double hawser__rows_adjugate(double c[9], const struct hawser__rows *m)
{
	const hawser__vec x = m->x, y = m->y, z = m->z;

	c[0] = y[1]*z[2] - y[2]*z[1];
	c[3] = y[2]*z[0] - y[0]*z[2];
	c[6] = y[0]*z[1] - y[1]*z[0];
	c[1] = x[2]*z[1] - x[1]*z[2];
	c[4] = x[0]*z[2] - x[2]*z[0];
	c[7] = x[1]*z[0] - x[0]*z[1];
	c[2] = x[1]*y[2] - x[2]*y[1];
	c[5] = x[2]*y[0] - x[0]*y[2];
	c[8] = x[0]*y[1] - x[1]*y[0];
	return x[0]*c[0] + x[1]*c[3] + x[2]*c[6];
}

/* The block's inverse, of the transposed cofactors and 1/determinant, times the rows of `off`. */
HAWSER_PART void hawser__rows_times(struct hawser__rows *product, const double c[9], double inverse,
                                    const struct hawser__rows *off)
{
	product->x = (c[0]*off->x + c[1]*off->y + c[2]*off->z)*inverse;
	product->y = (c[3]*off->x + c[4]*off->y + c[5]*off->z)*inverse;
	product->z = (c[6]*off->x + c[7]*off->y + c[8]*off->z)*inverse;
}

/* Of an eliminated place, whose rows are [next | y]: x = y - next*neighbour. */
HAWSER_PART void hawser__rows_back(double x[3], const struct hawser__rows *row,
                                   const double neighbour[3])
{
	const double a = neighbour[0], b = neighbour[1], c = neighbour[2];

	x[0] = row->x[3] - (row->x[0]*a + row->x[1]*b + row->x[2]*c);
	x[1] = row->y[3] - (row->y[0]*a + row->y[1]*b + row->y[2]*c);
	x[2] = row->z[3] - (row->z[0]*a + row->z[1]*b + row->z[2]*c);
}

#endif
