/* net/waves/linear.h - the linear mesh in waves: its matrices, and one solution.
 *
 * Complex amplitudes are those of exp(-i omega t): a quantity is the real part of amplitude times it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_WAVES_LINEAR_H
#define HAWSER_NET_WAVES_LINEAR_H

#include <complex.h>

#include "net/net.h"

/* What of the water acts at a place: an end of an element, or a buoy. */
struct hawser__wetted {
	int node, element, end;
	double along[3];     /* direction of the element; 0: a buoy, the same in all directions */
	double drag[2];      /* N s^2/m^2: force over |r| r, across and along */
	double displaced;    /* kg of water */
	double added[2];     /* of it, across and along */
	double spring;       /* N/m: change of the buoyancy with the level of the surface */
	double current[3];   /* m/s */
	double C[3][3];      /* N s/m: linear drag */
	double cov[3][3];    /* m^2/s^2, of the relative velocity of a sea */
	double complex u[3]; /* m/s: water, per metre of the amplitude of a wave */
	double complex elevation; /* m: of the surface above */
};

struct hawser__linear_mesh {
	struct hawser__mesh mesh;
	const struct hawser_net *net;
	double *T;                     /* [elements] N */
	double (*K)[6][6], (*M)[6][6]; /* [elements] in the directions of the unknowns, with what is at
	                                * nodes */
	double (*C)[6][6];             /* of the scene */
	struct hawser__wetted *wet;    /* [wets] */
	int wets;
	struct hawser__klu *re, *im;
	double *right;                 /* [2 unknowns] */
	double complex (*x)[3];        /* [nodes] displacements, m/m */
};

enum hawser_status hawser__linear_mesh_open(struct hawser__linear_mesh *linear,
                                            const struct hawser_net *net,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__linear_mesh_clear(struct hawser__linear_mesh *linear);
/* The velocity of the water of a wave of this frequency, at all places. */
void hawser__linear_mesh_wave(struct hawser__linear_mesh *linear, double omega);
/* linear->x in that wave, with the linear drag that the places have. */
enum hawser_status hawser__linear_mesh_solve(struct hawser__linear_mesh *linear, double omega,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
/* The relative velocity r of water and line at a place, per metre. */
void hawser__linear_mesh_relative(double complex r[3], const struct hawser__linear_mesh *linear,
                                  const struct hawser__wetted *wet, double omega);

#endif
