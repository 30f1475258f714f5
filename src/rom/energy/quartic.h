/* rom/energy/quartic.h - the expanded strain energy of a cable as a function: forces and
 * tangents from the strains at the points of a grid, without tensors. See quartic.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_QUARTIC_H
#define HAWSER_ROM_QUARTIC_H

#include <hawser/rom.h>

#include "core/hold.h"
#include "rom/condense/condense.h"
#include "rom/energy/kernel.h"

/* Largest number of points of the grid, padded: strains are stored on the stack. */
#define HAWSER__QUARTIC_POINTS 512
#define HAWSER__QUARTIC_ROWS (HAWSER_ROM_MAX + 2*HAWSER__QUARTIC_WIDTH)
#define HAWSER__QUARTIC_WIDTH 8 /* rows of the tables are padded with zeros to a multiple of this */

/* Coordinates are separated by plane: `in` of them determine a and b, the others, `out`, determine
 * c. In each plane, modes come first and second-order shapes (inertia.h) last. A "row" is a
 * coordinate of a plane or, behind these, a component of the end forces (condense.c): two in the
 * plane, one out of it, and none if no modes are condensed. */
struct hawser__quartic {
	int n, points, width;    /* width: of a table's rows, the points padded with zeros */
	int mirror;              /* 1: the cable is its own mirror image (quartic_make.c) */
	int *kind;               /* [n] of a coordinate, by plane: 2 out of the plane, plus 1 if it is
	                          * antisymmetric about mid-span and `mirror` */
	int in, out;             /* coordinates */
	int moving_in, moving_out; /* those that are modes */
	int rows_in, rows_out;   /* coordinates and components of the end forces */
	int condensed;
	int *index;              /* [n] index in the model of the in-plane coordinates, then of the
	                          * others */
	int diagonal;            /* K has no entries beside its diagonal */
	double *K;               /* [n] if diagonal, else [n][n]; in the order of the model */
	/* Rows of tables and fields have two halves, of width/2 points each. Each half of a row in the
	 * plane has a at all its points, then b. */
	double *ab;              /* [rows_in][2][2][width/2] strains a, b of the rows */
	double *c;               /* [rows_out][2][width/2] strain c */
	double *third;           /* [width] weight/(g^2 eps) */
	double *square, *mixed;  /* [width] coefficients of sigma^2 and -a^2 sigma in the energy */
	int padded_in, padded_out; /* rows_in and rows_out, padded */
	double *bend_in;         /* [rows_in][padded_in] and [rows_out][padded_out]: B of quartic.c */
	double *bend_out;
	/* Derivatives of y by two modes, if condensed: for each mode s of the plane, a matrix that is
	 * linear in its coordinate (quartic_tangent.c). */
	double *pull_in;         /* [moving_in][rows_in*moving_in + rows_out*moving_out] */
	double *pull_out;        /* [moving_out][rows_in*moving_out + rows_out*moving_in] */
	struct hawser__hold hold; /* its arrays */
};

/* A field at the points: strains or stresses. */
struct hawser__quartic_field {
	double ab[2*HAWSER__QUARTIC_POINTS]; /* [2][2][width/2] */
	double c[HAWSER__QUARTIC_POINTS];    /* [2][width/2] */
};

/* What a tangent needs of a force. */
struct hawser__quartic_state {
	double v[HAWSER__QUARTIC_ROWS];            /* [n] coordinates by plane */
	struct hawser__quartic_field at, along;    /* strains of the modes; U d of quartic.c */
};

/* Where a and b of the point in column p, 0 <= p < width, are in a row in the plane. */
#define HAWSER__QUARTIC_A(p, width) ((p) < (width)/2 ? (p) : (p) + (width)/2)
#define HAWSER__QUARTIC_B(p, width) (HAWSER__QUARTIC_A(p, width) + (width)/2)

/* The energy of `modes`, with the others condensed unless `condensed` is NULL (project.h). *made is
 * NULL if the grid has too many points. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__quartic_new(struct hawser__quartic **made, const struct hawser_rom *rom,
                                       const struct hawser_modes *modes,
                                       const struct hawser__condensed *condensed,
                                       struct hawser_report *report);
void hawser__quartic_free(struct hawser__quartic *quartic);

/* Restoring force [n] at u [n]. */
void hawser__quartic_force(const struct hawser__quartic *quartic, double *restoring,
                           const double *u);

/* The same, with what a tangent needs. */
void hawser__quartic_strain(const struct hawser__quartic *quartic, double *restoring,
                            struct hawser__quartic_state *state, const double *u);

/* Restoring force [n] and tangent [n][n] at u [n]. quartic_tangent.c. */
void hawser__quartic_tangent(const struct hawser__quartic *quartic, double *restoring,
                             double *tangent, const double *u);

/* Kind of row r of a plane. quartic_make.c. */
int hawser__quartic_kind(const struct hawser__quartic *quartic, int r, int out_of_plane);

/* Tables of the tangent, once all others are filled. Returns 1 if there is no memory. */
int hawser__quartic_pull(struct hawser__quartic *quartic);

/* Potential at u [n], 0 at rest. */
double hawser__quartic_potential(const struct hawser__quartic *quartic, const double *u);

#endif
