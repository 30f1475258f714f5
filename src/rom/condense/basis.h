/* rom/condense/basis.h - displacements of a cable as rows of numbers, for their products in mass
 * and in stiffness.
 *
 * A row has P, Q, B at the points of the grid, [points][3]; the displacements along x, y, z of the
 * points of label.h, [.][3]; with absorbers, for every attachment the displacement along x, y, z of its
 * absorber's mass and its stroke, [attachments][4]; and a, b, c at the points of the grid. Masses are
 * those of all but the last part, stiffnesses those of all but the first one, and of the derivatives of
 * b and c (bend.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_BASIS_H
#define HAWSER_ROM_BASIS_H

#include "rom/condense/follow.h"

struct hawser__basis {
	const struct hawser_modes *modes;
	int own, tail, width;  /* numbers of the first part and of the last one; between them; of a row */
	double *row;           /* [most][width] for the caller to fill */
	double *mass, *stiff;  /* [own + tail] square roots of masses, and of stiffnesses from `own` on */
	double *work;          /* [2*own] */
	struct hawser__reference reference;
	struct hawser__stations stations; /* the points of the grid */
	struct hawser__hold hold;
};

/* Room for `most` rows, zero. Clear, on failure too. Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__basis_make(struct hawser__basis *m, const struct hawser_modes *modes,
                                        int most, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__basis_clear(struct hawser__basis *m);

/* Fill a row from strains [points][3], the displacement of end A, and strokes [attachments], of
 * absorbers alone. */
void hawser__basis_put(struct hawser__basis *m, double *row, const double *strain,
                         const double start[3], const double *stroke);
/* Fill it from mode k of other modes of the cable. */
void hawser__basis_mode(const struct hawser__basis *m, double *row,
                          const struct hawser_modes *of, int k);
/* Product of two rows in mass; of the first `count` rows in mass and in stiffness, [count][count], in
 * the lower triangle. Status: _MEMORY. */
double hawser__basis_product(const struct hawser__basis *m, const double *x, const double *y);
enum hawser_status hawser__basis_products(double *mass, double *stiffness,
                                            const struct hawser__basis *m, int count,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
/* A row becomes mode k of `with`. */
void hawser__basis_take(struct hawser_modes *with, int k, const struct hawser__basis *m,
                          const double *row, double omega);

#endif
