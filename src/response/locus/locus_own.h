/* response/locus/locus_own.h - loci of autonomous models. See locus_own.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LOCUS_OWN_H
#define HAWSER_RESPONSE_LOCUS_OWN_H

#include "core/hold.h"
#include "response/locus/locus_walk.h"

/* What changes its sign at special points; NAN where there is none. */
enum hawser__own_test {
	HAWSER__OWN_DEGENERATE = 0, /* l1 of a Hopf point */
	HAWSER__OWN_REAL,           /* the real eigenvalue next to the axis, but for the critical ones */
	HAWSER__OWN_PAIR,           /* the real part of the pair next to it */
	HAWSER__OWN_TESTS
};

/* A bifurcation on a locus. */
struct hawser__own_spot {
	double at[2];               /* the parameters, in units of their ranges */
	double omega;               /* of the critical motion or of the cycle, scaled; 0: equilibrium */
	double time;                /* unit of time of the model there, s */
	double angle, error;
	double test[HAWSER__OWN_TESTS];
	int unstable;               /* besides the critical ones */
	double *state;              /* [2n] of it */
	struct hawser__own_beside {
		double *state, t, omega; /* [2n] an equilibrium or cycle on the line, beside it */
	} beside[2];                /* far, from which the branch on the next line begins, and near, from
	                            * which it does if that fails */
};

/* A line in the plane of the parameters: base + t normal. */
struct hawser__own_line {
	const struct hawser_rom_plane *plane;
	enum hawser_event_kind kind;
	int n, cycles;              /* 1: of limit cycles */
	double extent[2];           /* of the ranges */
	double base[2], normal[2];
	struct hawser_rom_family family; /* over t */
	double tolerance;
};

/* The bifurcation *to on the line, next to t = 0, from that on a line nearby; *found: there is one
 * within `reach`. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__own_meet(struct hawser__own_spot *to, int *found,
                                    struct hawser__own_line *line,
                                    const struct hawser__own_spot *from, double reach,
                                    struct hawser_report *report);

/* A locus that is being followed. */
struct hawser__own {
	const struct hawser_locus_options *o;
	struct hawser_locus *locus;
	struct hawser__own_line line;
	struct hawser__own_spot prev, here, next, trial, start;
	double along[2];            /* direction of the curve here */
	struct hawser__locus_list *list;
	struct hawser_report *report;
	double first_omega, time; /* of the first model, s */
	int stopped;
	struct hawser__hold hold;
};

void hawser__own_copy(struct hawser__own_spot *to, const struct hawser__own_spot *from, int n);
double hawser__own_distance(const double a[2], const double b[2]);
/* The point of the locus on the line through `base` at right angles to the direction. */
enum hawser_status hawser__own_across(struct hawser__own *own, struct hawser__own_spot *to, int *found,
                                      const double base[2], const double direction[2], double reach,
                                      const struct hawser__own_spot *from,
                                      struct hawser_report *report);

/* own_special.c. Whether the tests tell where the count of unstable eigenvalues changes from own->here
 * to own->next; the special points between these two; and, where the curve ends at own->here, the one
 * at which the frequency of Hopf points becomes 0. */
int hawser__own_explained(const struct hawser__own *own);
enum hawser_status hawser__own_specials(struct hawser__own *own, struct hawser_report *report);
enum hawser_status hawser__own_takens(struct hawser__own *own, struct hawser_report *report);

/* hawser_locus_trace of a plane whose frequency is 0. */
enum hawser_status hawser__own_locus(struct hawser_locus *locus,
                                     const struct hawser_locus_options *options,
                                     struct hawser_report *report);
/* locus.c: the curve of part[1], from its end to the start, and part[0], becomes one of *to. */
enum hawser_status hawser__locus_join(struct hawser_locus *to, const struct hawser__locus_list part[2],
                                      struct hawser_report *report);

#endif
