/* net/waves/linear.h - the linear mesh in waves: its matrices, and one solution.
 *
 * Complex amplitudes are those of exp(-i omega t): a quantity is the real part of amplitude times it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_WAVES_LINEAR_H
#define HAWSER_NET_WAVES_LINEAR_H

#include <complex.h>

#include "core/hold.h"
#include "net/net.h"
#include "net/water/water.h"

/* What of the water acts at a place: an end of an element, or a buoy. */
struct hawser__wetted {
	int node, element, end;
	const struct hawser__mesh_buoy *buoy; /* NULL: an end of an element */
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
	struct hawser_net seated;      /* with its bodies in equilibrium */
	const struct hawser_net *net;  /* this */
	double *T;                     /* [elements] N */
	double (*K)[6][6], (*M)[6][6]; /* [elements] in the directions of the unknowns, with what is at
	                                * nodes */
	double (*C)[6][6];             /* of the scene */
	struct hawser__wetted *wet;    /* [wets] */
	int wets;
	struct hawser__klu *re, *im;
	double *right;                 /* [2 unknowns] */
	double complex (*x)[3];        /* [nodes] displacements, m/m */
	/* of rigid bodies with n motions: displacements for each, [n][nodes]; their equations, [n][n]; the
	 * motions, [n]; and real and imaginary parts of forces along them, [2][n] */
	double complex (*column)[3], *S, *z;
	double *load;
	int *pivot;                    /* [n] */
	struct hawser__hold hold;
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
/* x [nodes] of what linear->right has, but at rigid nodes. */
void hawser__linear_mesh_places(double complex (*x)[3], const struct hawser__linear_mesh *linear);
/* linear-body.c: memory; to linear->load, a force at a rigid node; and the bodies in linear->x, where
 * they are held, with the forces in linear->load, after linear->re has been factored. */
enum hawser_status hawser__linear_bodies_open(struct hawser__linear_mesh *linear,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__linear_push(struct hawser__linear_mesh *linear, int node, const double complex f[3]);
enum hawser_status hawser__linear_bodies(struct hawser__linear_mesh *linear, double omega,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* The relative velocity r of water and line at a place, per metre. */
void hawser__linear_mesh_relative(double complex r[3], const struct hawser__linear_mesh *linear,
                                  const struct hawser__wetted *wet, double omega);

#endif
