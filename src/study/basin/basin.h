/* study/basin/basin.h - stable periodic responses with their neighbourhoods, and ends of motions.
 *
 *    P        map of a period of the load; a response of k periods has k states, fixed points of P^k
 *    M        derivative of P^k there
 *    V        quadratic form z' V z that M contracts: V = W + M' V M, with W = 1 for displacements and
 *             1/Omega^2 for velocities
 *    q        largest factor by which M contracts it: 1 - min z'Wz/z'Vz
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_BASIN_H
#define HAWSER_STUDY_BASIN_H

#include <hawser/basin.h>

#include "response/branch/amplitude.h"
#include "response/time/flow.h"
#include "rom/energy/kernel.h"

enum { HAWSER__MOST_PERIODS_OF_ONE = 8 };

struct hawser__attractor {
	struct hawser_basin about;
	double *state; /* [period][m] */
	double *form;  /* [period][m][m] V */
	int turns;     /* periods of the response over which the form is compared */
	double q;      /* over so many of them */
	double limit;  /* largest z' V z in the neighbourhood */
};

/* Integration over periods with a number of steps that follows the error. */
struct hawser__orbiter {
	struct hawser__flow flow;
	const struct hawser_rom *rom;
	struct hawser__amplitude *amplitude;
	double omega;    /* scaled */
	double size;     /* of states, for errors and for what is beyond all bounds */
	int m, steps;
	long maps;
	double *work;    /* [m (4 m + 8 + MOST)] */
	double *matrix;  /* [m][m] derivative of the last maps */
};

enum hawser__fate { HAWSER__MOVES, HAWSER__ESCAPED, HAWSER__UNRESOLVED };

/* The field. */
struct hawser__basins {
	const struct hawser_map_source *source;
	struct hawser_map_source model_source;
	struct hawser_map_field inner; /* makes the model */
	void *inner_worker;
	const struct hawser_rom *rom;
	double omega;        /* scaled */
	int component[2];    /* of the state, that x and y set */
	double scaled[2];    /* scaled component per unit of x, y */
	double size;         /* of the largest state of the map */
	struct hawser__attractor *attractor; /* [count] */
	int count, periods;
	char *identity;
};

/* basin.c */
enum hawser_status hawser__orbiter_open(struct hawser__orbiter *orbiter, const struct hawser_rom *rom,
                                        double omega, struct hawser_report *report);
void hawser__orbiter_close(struct hawser__orbiter *orbiter);
/* x [m] one period later. _UNRESOLVED: the error is too large with the most steps. */
enum hawser__fate hawser__orbiter_map(struct hawser__orbiter *orbiter, double *x);
/* |x| with the weights W. */
double hawser__orbiter_size(const struct hawser__orbiter *orbiter, const double *x);

/* basin_form.c: the response of `period` periods near the state x, with its neighbourhood. *found: 0:
 * Newton's method does not converge, or what it leads to is not stable, or it has fewer periods. */
enum hawser_status hawser__attractor_find(struct hawser__attractor *attractor, int *found,
                                          struct hawser__orbiter *orbiter, const double *x, int period,
                                          struct hawser_report *report);
void hawser__attractor_clear(struct hawser__attractor *attractor);
/* Which state of the response has x [m] in its neighbourhood; -1: none. *form becomes z' V z relative
 * to the limit. */
int hawser__attractor_has(const struct hawser__attractor *attractor, const double *x, int m,
                          double *form);

#endif
