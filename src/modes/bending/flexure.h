/* modes/bending/flexure.h - a cable with bending stiffness in one plane: C1 functions of displacement,
 * stiffness and mass (doc/theory-bending.md).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_FLEXURE_H
#define HAWSER_MODES_FLEXURE_H

#include "core/hold.h"
#include "modes/grid.h"

enum { HAWSER__FLEX_D = 2 };

/* Matrices are column-major. The coordinates z are those in which the energy is z.z/2 and end B is at
 * rest: strains and displacements of coordinate j are columns. */
struct hawser__flexure {
	int plane;      /* enum hawser_plane */
	int D;          /* displacements: 2 in the plane, else 1 */
	int functions;  /* of rotation and, in the plane, of stretch */
	int free;       /* coordinates: functions - D */
	int points, rows; /* rows: D*points, and D for each point mass */
	int elements, degree;
	double *K;      /* [functions][functions] upper factor of the stiffness */
	double *C, *tau; /* [functions][D] Householder vectors of the displacement of end B */
	double *end;     /* [functions][D] the displacement of end B */
	double *table;  /* [3][degree + 2][order] functions of an element, by x: stretch, rotation and its
	                 * derivative; the last two rows of a rotation are those of its edges */
	double *x;      /* [rows][functions], rows contiguous: displacements of the functions */
	double *a, *b;  /* [points] stretch and slope of a unit of both unknowns: sqrt(eps), 1 + strain */
	double *k;      /* [points] stiffness of the rotation */
	double *half;   /* [elements] half lengths of the elements */
	int *first;     /* [elements + 1] index of the rotation of edge e, -1 if it is clamped */
	const struct hawser_grid *grid;
	double beta;
	struct hawser__hold hold;
};

/* Functions of `degree` in each element of `grid`, and their stiffness, factored. `grid` is kept, not
 * copied. The caller clears *t, also on failure. Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__flexure_init(struct hawser__flexure *t, const struct hawser_statics *st,
                                        const struct hawser_grid *grid, int degree, int plane,
                                        struct hawser_report *report);
void hawser__flexure_clear(struct hawser__flexure *t);

/* Strains [points][3] (a, b or c added to what is there) of coefficients y[functions]. */
void hawser__flexure_strain(double *strain, const struct hawser__flexure *t, const double *y);

/* From coordinates z[free] to coefficients y[functions]. */
enum hawser_status hawser__flexure_expand(double *y, const struct hawser__flexure *t, const double *z,
                                          struct hawser_report *report);

/* Correct y[functions] so that end B is at rest but for round-off relative to its terms: where y is of
 * the highest modes, the reflections leave more. */
enum hawser_status hawser__flexure_hold(double *y, const struct hawser__flexure *t,
                                        struct hawser_report *report);

/* Twice the energy of y in the two highest functions of each element. */
double hawser__flexure_tail(const struct hawser__flexure *t, const double *y);

/* Displacements in fixed axes (tangent and normal at mid-length; z) of all coordinates, times the
 * square roots of weights and masses: *root [rows][free], to be freed. The product of its transpose
 * with itself is the mass. */
enum hawser_status hawser__flexure_roots(double **root, const struct hawser__flexure *t,
                                         const struct hawser_statics *st,
                                         struct hawser_report *report);

/* Edges of a grid for a span with bending stiffness: *edge [*elements + 1], to be freed. There are
 * elements of some widths of the boundary layers, which `degree` resolves, at the ends and beside
 * masses. `waves`: half waves of the highest mode. */
enum hawser_status hawser__flexure_edges(double **edge, int *elements, const struct hawser_statics *st,
                                         int degree, double waves, struct hawser_report *report);

/* cosine and sine of the angle of the tangent from that at mid-length, at s. */
void hawser__flexure_axes(double *cosine, double *sine, const struct hawser_statics *st, double s);

#endif
