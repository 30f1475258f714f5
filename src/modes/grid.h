/* modes/grid.h - the composite Gauss-Legendre grid, and running integrals on it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_GRID_H
#define HAWSER_MODES_GRID_H

#include <hawser/modes.h>

/* Tables of the spectral method on the reference element [-1, 1]. */
struct hawser__reference {
	int order, degree;
	double *legendre; /* [degree+1][order] P_j at the nodes */
	double *running;  /* [order][order] row i: integral from -1 to node i, exact to degree
	                   * order-1 */
	double *weight;   /* [order] Gauss weights */
	double *half;     /* [elements] half lengths */
};

/* Fill `grid` on the edges edge[elements+1] with `order` nodes per element. length[elements] are
 * the lengths of the elements if they are known more accurately than as differences of edges, else
 * NULL. */
enum hawser_status hawser__grid_init(struct hawser_grid *grid, int elements, int order,
                                     const double *edge, const double *length,
                                     struct hawser_report *report);
void hawser__grid_clear(struct hawser_grid *grid);

/* Tables for Legendre polynomials up to `degree` at the nodes of `grid`. */
enum hawser_status hawser__reference_init(struct hawser__reference *reference,
                                          const struct hawser_grid *grid, int degree,
                                          struct hawser_report *report);
void hawser__reference_clear(struct hawser__reference *reference);

/* out[points] = integral of in[points] from 0 to each node; returns the integral over [0, l]. */
double hawser__grid_running(double *out, const struct hawser_grid *grid,
                            const struct hawser__reference *reference, const double *in);

/* weight [order] of the points of the element at s, whose index it returns: a field's value at s is
 * their sum. */
int hawser__grid_weights(double *weight, const struct hawser_grid *grid, double s);

/* Values at s of `fields` fields stored as in[points][stride], field f at offset f. */
void hawser__grid_at(double *out, const struct hawser_grid *grid, const double *in, int stride,
                     int fields, double s);

#endif
