/* rom/condense/order.h - the force on its modes that a condensed model omits: see order.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ORDER_H
#define HAWSER_ROM_ORDER_H

#include <hawser/choose.h>

#include "core/hold.h"
#include "rom/energy/law.h"
#include "rom/choose/weigh.h"

enum { HAWSER__OMITTED_WAVES = 5 }; /* number of harmonics of dx; chosen */

struct hawser__omitted {
	const struct hawser_choice *choice;
	const struct hawser_rom *exact, *all;
	struct hawser__orbit_of orbit; /* of `rows`*`stride` rows */
	struct hawser__relax relax;     /* of `exact`: all but the kept modes */
	int n, N, rows, stride, held, functions, places;
	double omega;
	int *mode;              /* [held] the kept modes */
	int *place;             /* [held] index of a kept mode in the model of the orbit */
	char *beyond;           /* [relax.frees] 1: not a candidate */
	double *u;              /* [n] */
	double *plus, *minus, *J, *J_minus; /* [n], [n], [n][n], [n][n], of `all` */
	double *led;            /* [rows][relax.frees][held] W */
	double *motion;         /* [rows][N] y */
	double *force;          /* [rows][N] r of relaxed coordinates, a_full of kept modes */
	double *pull;           /* [rows][N] r without inertia and damping: the load */
	double *rate;           /* [rows] workspace */
	double *G, *kept;       /* [rows][held] G, u */
	double *off;            /* [rows][places] displacements at the shape points that (u, v) omits */
	double *spin;           /* [2][rows] the kernels of y' and y'' */
	double *wave;           /* [functions][rows] orthonormal over the period */
	double *turn;           /* [rows][2] cos(tau), sin(tau) */
	struct hawser__hold hold;
};

/* w->plus: restoring force of the condensed model at w->u; w->u: the condensed modes too. */
void hawser__omitted_condensed(struct hawser__omitted *w);

/* Kept mode k's value of x[N], with the sign of the mode. */
double hawser__omitted_twin(const struct hawser__omitted *w, int k, const double *x);

/* Displacements at the shape points [3*points]. */
void hawser__omitted_displace(double *xyz, const struct hawser_rom *rom, const double *u);

/* The effect of G: omitted[0] with the inertia and damping of the relaxed coordinates that are not
 * candidates, [1] by the energy alone, [2] with those of all relaxed coordinates. order_effect.c. */
enum hawser_status hawser__omitted_effect(double omitted[HAWSER__OMITTED], struct hawser__omitted *w,
                                       unsigned peaks, struct hawser_report *report);

#endif
