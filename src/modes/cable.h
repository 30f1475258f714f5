/* modes/cable.h - the static cable on a Gauss-Legendre grid: what every method reads of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_CABLE_H
#define HAWSER_MODES_CABLE_H

#include "modes/compliance.h"

enum { HAWSER__PLANES = 2, HAWSER__FIELDS = 3 };

struct hawser__cable {
	struct hawser_grid grid;
	struct hawser__reference reference;
	double *edges;     /* [3][elements+1] slopes and positions of the edges, lengths */
	double *field;     /* [3][points]: cos psi, sin psi, sb (spectral.c) */
	double *direction; /* [4 + 1][points] of the in-plane and the out-of-plane problem */
	double sa;         /* sqrt(epsilon) */
	struct hawser__plane plane[HAWSER__PLANES]; /* by enum hawser_plane */
};

/* Elements that keep the branch points of the profile away: equal in theta, none over 2.5. */
int hawser__cable_elements(const struct hawser_statics *statics);

/* Polynomials an element that the wave of the last of n modes needs, and the branch points. */
int hawser__cable_degree(int elements, int n);

/* A given basis shared out: *elements, and polynomials an element as the value. */
int hawser__cable_split(int *elements, const struct hawser_statics *statics, int basis);

/* Grid of 2*p nodes an element, with tables for p polynomials. The caller clears *cable whatever
 * happens. Status: _MEMORY. */
enum hawser_status hawser__cable_init(struct hawser__cable *cable,
                                      const struct hawser_statics *statics, int elements, int p,
                                      struct hawser_report *report);

/* Are the elements, of a given small basis, twice too long? A refinement sees the profile through the
 * same few points then, and its step tells nothing about the error. */
int hawser__cable_coarse(const struct hawser__cable *cable);

/* Displacement P, Q, B and derivative a, b, c in the local frame, shape and slope [points][3] and zero
 * on entry, from strain and displacement [D][points] of the problem of one plane. */
void hawser__cable_fields(double *shape, double *slope, const struct hawser__cable *cable, int plane,
                          const double *strain, const double *displacement);

void hawser__cable_clear(struct hawser__cable *cable);

#endif
