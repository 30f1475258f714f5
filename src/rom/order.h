/* rom/order.h - the force on its modes that a condensed model omits: see order.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ORDER_H
#define HAWSER_ROM_ORDER_H

#include <hawser/choose.h>

#include "rom/weigh.h"

enum { HAWSER__OMITTED_WAVES = 5 }; /* number of harmonics of du; chosen */

struct hawser__omitted {
	const struct hawser_choice *choice;
	const struct hawser_rom *exact, *all, *model;
	int n, N, rows, stride, frees, held, functions, places;
	double omega;
	int *freed, *mode;      /* [frees] relaxed coordinates of `exact`, [held] the kept modes */
	char *beyond;           /* [frees] 1: not a candidate */
	double *u, *y, *trial;  /* [n], [N], [N] */
	double *R, *T, *step;   /* [N], [N][N], [N] */
	double *matrix, *mixed; /* [frees][frees], [frees][held] */
	double *plus, *minus, *J, *J_minus; /* [n], [n], [n][n], [n][n], of `all` */
	double *stiff, *led;    /* [rows][held][held] T, [rows][frees][held] W */
	double *motion, *rate, *bend; /* [rows][N] y, y', y'' */
	double *G, *kept;       /* [rows][held] G, u */
	double *off;            /* [rows][places] displacements at the shape points that (u, v) omits */
	double *spin;           /* [2][rows] the kernels of y' and y'' */
	double *wave;           /* [functions][rows] orthonormal over the period */
	double *turn;           /* [rows][2] cos(tau), sin(tau) */
};

/* w->plus: restoring force of the condensed model at w->u; w->u: the condensed modes too. */
void hawser__omitted_condensed(struct hawser__omitted *w);

/* Displacements at the shape points [3*points]. */
void hawser__omitted_displace(double *xyz, const struct hawser_rom *rom, const double *u);

/* The effect of G: omitted[0] with the inertia and damping of the relaxed coordinates that are not
 * candidates, [1] without, [2] with those of all relaxed coordinates. order_effect.c. */
enum hawser_status hawser__omitted_effect(double omitted[HAWSER__OMITTED], struct hawser__omitted *w,
                                       unsigned peaks, struct hawser_report *report);

#endif
