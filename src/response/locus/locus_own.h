/* response/locus/locus_own.h - loci of autonomous models. See locus_own.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LOCUS_OWN_H
#define HAWSER_RESPONSE_LOCUS_OWN_H

#include <math.h>

#include "core/hold.h"
#include "response/locus/locus_walk.h"

/* What changes its sign at special points (own_tests.c); NAN where there is none. Multipliers are those
 * besides the critical ones. */
enum hawser__own_test {
	HAWSER__OWN_DEGENERATE = 0, /* l1 of a Hopf point; the third coefficient of a doubling or a torus */
	HAWSER__OWN_ONE,            /* a multiplier is 1, of an equilibrium an eigenvalue 0 */
	HAWSER__OWN_MINUS,          /* a multiplier is -1 */
	HAWSER__OWN_PAIR,           /* a pair on the unit circle, of an equilibrium on the axis */
	HAWSER__OWN_THIRD,          /* of a torus the angle's cosine less that of 2 pi/3, */
	HAWSER__OWN_QUARTER,        /* of pi/2 */
	HAWSER__OWN_START,          /* the second parameter less that of the response */
	HAWSER__OWN_TESTS
};

/* A bifurcation on a locus. */
struct hawser__own_spot {
	double at[2];               /* the parameters, in units of their ranges */
	double omega;               /* of the critical motion or of the cycle, scaled; 0: equilibrium */
	double time;                /* unit of time of the model there, s */
	double angle, error;        /* angle: of tori continued through 0 and pi; 0: not known yet */
	double vanish;              /* the quantity that goes to 0 where the locus ends, as the square root
	                            * of the distance from there: frequency of a Hopf point, sine of a
	                            * torus' angle, second coefficient of a fold. NAN: there is none */
	double beside_pair;         /* | |mu|^2 - 1 | of the complex pair mu, besides the critical
	                            * multipliers, that is nearest to the unit circle */
	double test[HAWSER__OWN_TESTS];
	int unstable;               /* besides the critical ones */
	double *state;              /* [2n] of it */
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
	int steps;                  /* of a period; 0: not known yet */
	int gone;                   /* directions in which a cycle is not determined: along its motion, and
	                            * the rotation that leaves the model as it is; 0: not known yet */
};

/* own_tests.c: tests and number of unstable multipliers of an equilibrium or a cycle, and the angle of
 * a torus if it is not known. */
enum hawser_status hawser__own_judge_rest(struct hawser__own_spot *spot, const struct hawser_rom *rom,
                                          struct hawser_report *report);
enum hawser_status hawser__own_judge_cycle(struct hawser__own_spot *spot, const struct hawser_rom *rom,
                                           const struct hawser__own_line *line,
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
	double most;              /* largest |vanish| so far */
	double time;              /* of the first model, s */
	int stopped;
	struct hawser__hold hold;
};

void hawser__own_copy(struct hawser__own_spot *to, const struct hawser__own_spot *from, int n);
/* From 0 to pi. */
static inline double hawser__own_angle(const struct hawser__own_spot *spot)
{
	return fabs(remainder(spot->angle, 2.0*M_PI));
}
double hawser__own_distance(const double a[2], const double b[2]);
/* *to is a guess at the part s of the way from a to b, also outside. */
void hawser__own_between(struct hawser__own_spot *to, const struct hawser__own_spot *a,
                         const struct hawser__own_spot *b, double s, int n);
/* The point of the locus on the line through `base` at right angles to the direction, from a guess. */
enum hawser_status hawser__own_across(struct hawser__own *own, struct hawser__own_spot *spot,
                                      int *found, const double base[2], const double direction[2],
                                      double reach, struct hawser_report *report);
/* own->trial becomes the point at the part s of the way from own->here to own->next. */
enum hawser_status hawser__own_at(struct hawser__own *own, double s, int *found,
                                  struct hawser_report *report);

/* own_special.c. Whether the tests tell where the count of unstable multipliers changes from own->here
 * to own->next; the special points between these two; and the one at which the curve ends beyond
 * own->here, where something vanishes: *found. */
int hawser__own_explained(const struct hawser__own *own);
enum hawser_status hawser__own_specials(struct hawser__own *own, struct hawser_report *report);
enum hawser_status hawser__own_end(struct hawser__own *own, int *found, struct hawser_report *report);

/* hawser_locus_trace of a plane whose frequency is 0. */
enum hawser_status hawser__own_locus(struct hawser_locus *locus,
                                     const struct hawser_locus_options *options,
                                     struct hawser_report *report);
/* locus.c: the curve of part[1], from its end to the start, and part[0], becomes one of *to. */
enum hawser_status hawser__locus_join(struct hawser_locus *to, const struct hawser__locus_list part[2],
                                      struct hawser_report *report);

#endif
