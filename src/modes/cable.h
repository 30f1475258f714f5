/* modes/cable.h - the static cable on a Gauss-Legendre grid, for all methods.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_CABLE_H
#define HAWSER_MODES_CABLE_H

#include "modes/compliance.h"

enum { HAWSER__PLANES = 2, HAWSER__FIELDS = 3 };

struct hawser__cable {
	struct hawser_grid grid;
	struct hawser__reference reference;
	double *edges;     /* [4][elements+1] slopes and positions of the edges, lengths; with
	                    * attachments, slopes at the beginnings of the elements, and these minus the
	                    * slope at mid-length */
	double *field;     /* [3][points]: cos psi, sin psi, sb (spectral.c); in space [9 + 1]: R, sb */
	double *direction; /* [4 + 1][points] of the in-plane and the out-of-plane problem; in space [9] */
	double sa;         /* sqrt(epsilon) */
	int space;         /* 1: one problem of three components, in the place of that in the plane */
	int elastic;       /* 1: the first and the last lump are elastic supports */
	int pieces;        /* 1: elements between attachments, else over the whole length */
	/* the attachments, between elastic supports, without absorbers that move in the plane */
	struct hawser__lump lump[HAWSER__PLANES][HAWSER__MAX_LUMPS];
	struct hawser__spring spring[HAWSER__PLANES][HAWSER__MAX_SPRINGS];
	struct hawser__joint joint[HAWSER__PLANES][HAWSER__MAX_JOINTS];
	struct hawser__absorber absorber[HAWSER__PLANES][HAWSER__MAX_ABSORBERS];
	struct hawser__plane plane[HAWSER__PLANES]; /* by enum hawser_plane */
};

/* Number of elements of equal length in theta, at most 2.5 each, for the branch points of the
 * profile; with attachments, between neighbours. */
int hawser__cable_elements(const struct hawser_statics *statics);

/* Polynomials per element that resolve the wave of the highest of n modes and the branch points. */
int hawser__cable_degree(int elements, int n);

/* The same for a cable with attachments, whose elements have different lengths. */
int hawser__cable_degree_attached(const struct hawser_statics *statics, int n);

/* Distribute a given basis: sets *elements and returns the polynomials per element. */
int hawser__cable_split(int *elements, const struct hawser_statics *statics, int basis);

/* Grid of 2*p nodes per element, with tables for p polynomials. The caller clears *cable, also on
 * failure. Status: _MEMORY. */
enum hawser_status hawser__cable_init(struct hawser__cable *cable,
                                      const struct hawser_statics *statics, int elements, int p,
                                      struct hawser_report *report);

/* 1 if the elements of a given small basis are more than twice too long. A refinement then uses the
 * same few points of the profile, and its change does not estimate the error. */
int hawser__cable_coarse(const struct hawser__cable *cable);

/* Displacement P, Q, B and derivative a, b, c in the local frame, shape and slope [points][3] and
 * zero on entry, from strain and displacement [D][points] of the problem of one plane. */
void hawser__cable_fields(double *shape, double *slope, const struct hawser__cable *cable, int plane,
                          const double *strain, const double *displacement);

/* stroke [attachments], zero on entry: of the absorbers of one plane, from strain as above. */
void hawser__cable_strokes(double *stroke, const struct hawser__cable *cable, int plane,
                           const double *strain);

/* Of a cable in space (cable_space.c): slopes at both ends of the piece before attachment i, returns
 * what the slope increases per length; fields and directions on the grid; x, y and z along the axes of
 * the displacements; and the fields of a mode. */
double hawser__space_slopes(double *first, double *last, const struct hawser_statics *st, int i);
void hawser__space_fields(struct hawser__cable *cable, const struct hawser_statics *st);
void hawser__space_axes(double axis[3][HAWSER__MAX_D], const struct hawser_statics *st);
void hawser__space_shape(double *shape, double *slope, const struct hawser__cable *cable,
                         const double *strain, const double *displacement);

void hawser__cable_clear(struct hawser__cable *cable);

#endif
