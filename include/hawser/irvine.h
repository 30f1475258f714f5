/* hawser/irvine.h - natural frequencies along a sweep of the tension: the Irvine diagram.
 *
 * One cable between two fixed ends has one equilibrium for each horizontal tension H. A sweep runs
 * over them, by H or by any quantity that fixes it, and follows each branch of frequencies through
 * crossings (the branches pass through each other, which only symmetry allows: a level span) and
 * veerings (they turn away, and the shapes change hands). doc/theory-irvine.md has the algorithm.
 *
 * SI, and rad/s: the scale of time changes along a sweep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_IRVINE_H
#define HAWSER_IRVINE_H

#include <hawser/modes.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_crossover_kind {
	HAWSER_CROSSING = 0, /* gap within the tolerance: the branches pass through each other */
	HAWSER_VEERING       /* a gap is left: they keep their order, and the shapes change hands */
};

/* A branch is numbered from 1 in its plane, by frequency at the start of the sweep. */
struct hawser_irvine_branch {
	enum hawser_plane plane;
	int number;
};

struct hawser_irvine_station {
	struct hawser_statics statics; /* at a speed with its apparent quantities */
	double value;  /* of the swept quantity, N or m */
	double moved;  /* relative distance from its place in the grid; nonzero where two branches meet
	                * there, whose shapes are then undetermined */
	int inserted;  /* 0: one of the points asked for; 1: added by the refinement */
};

/* Two branches in the plane at their closest. The number is from 1, as in struct
 * hawser_irvine_branch; a branch that is not among those kept has a number after theirs. */
struct hawser_irvine_crossover {
	enum hawser_crossover_kind kind;
	double value;                 /* of the swept quantity, N or m */
	double H;                     /* N, the actual one */
	double irvine, irvine_source; /* as in struct hawser_statics */
	int below, above;             /* numbers of the branches, as they stand before it */
	double omega;                 /* rad/s, mean of the two */
	double gap, relative_gap;     /* rad/s, and over omega */
};

struct hawser_irvine {
	struct hawser_span span;
	enum hawser_given sweep;
	double speed, fluctuation; /* m/s */
	const char *method;  /* static string */
	int stations, branches, crossovers;
	int in_plane;        /* branches in the plane; they come first, by number */
	int solves;          /* modal solutions it took */
	double least_correlation; /* of a branch's shape in the plane between neighbouring stations that
	                           * hold no crossover; squared, so 1 is no change */
	struct hawser_irvine_station *station;     /* [stations] in the order of the sweep */
	struct hawser_irvine_branch *branch;       /* [branches] */
	struct hawser_irvine_crossover *crossover; /* [crossovers] in the order of the sweep */
	double *omega;                  /* [stations][branches] rad/s */
	double *residual;               /* [stations][branches] as in struct hawser_mode; at a speed as in
	                                 * struct hawser_complex_mode */
	int *place;                     /* [stations][branches] from 0, by frequency in its plane */
	enum hawser_symmetry *symmetry; /* [stations][branches]; mixed at a speed */
	enum hawser_family *family;     /* [stations][branches] */
};

struct hawser_irvine_options {
	enum hawser_given sweep; /* HAWSER_GIVEN_NONE: H */
	double from, to;         /* N or m; 0 for either: see hawser_irvine_range */
	double speed, fluctuation; /* m/s, as in struct hawser_motion: the cable travels so all along the
	                            * sweep; the swept quantity is that of the steady state */
	int points;     /* stations before refinement, >= 2; 0: 200. Equidistant in the logarithm of the
	                 * value, or of H where length0 is swept. T0, T1: the taut solution */
	int n;          /* branches: the lowest at `from`, both planes together; 0: 10 */
	const char *method; /* of hawser_modes_methods, at a speed of hawser_complex_modes_methods; NULL:
	                     * "spectral" */
	int basis;          /* as in struct hawser_modes_options */
	double tolerance;   /* as in struct hawser_modes_options */
	double correlation; /* steps are halved where a squared correlation is below; 0: 0.9 */
	double crossing;    /* largest relative gap of a crossing; 0: 1e-10 */
};

/* The range that B's figures 4.4 and 4.5 show: *from and *to are the values of the quantity where
 * Irvine's parameter (irvine_source) is 0.1 pi and 10 pi, from taut to slack; less where the
 * strain H/EA would be above 0.1, where the cable would hang deeper than some 0.7 d (H =
 * rho*g*d/4), and no further than to the least T0 or T1 when these are swept. Statuses: those of
 * hawser_statics_solve, and HAWSER_ERR_NO_SOLUTION (an inextensible cable, or an empty range). */
enum hawser_status hawser_irvine_range(double *from, double *to, const struct hawser_span *span,
                                       enum hawser_given sweep,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Sweep. *irvine is overwritten, release with hawser_irvine_clear. Statuses: HAWSER_ERR_ARGUMENT
 * (range, counts), HAWSER_ERR_CONVERGENCE (branches could not be told apart with the smallest step;
 * the message says where), and those of hawser_statics_solve and hawser_modes_solve. */
enum hawser_status hawser_irvine_trace(struct hawser_irvine *irvine,
                                       const struct hawser_span *span,
                                       const struct hawser_irvine_options *options,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_irvine_clear(struct hawser_irvine *irvine);

/* pi*sqrt(H/rho)/d of a station in rad/s, with the actual H: the first frequency of a level string at
 * rest under that tension, by which frequencies are normalised. */
double hawser_irvine_string(const struct hawser_irvine_station *station);

/* The swept quantity of a static solution, the actual one, N or m; NAN for HAWSER_GIVEN_NONE. */
double hawser_irvine_value(const struct hawser_statics *statics, enum hawser_given sweep);

const char *hawser_given_name(enum hawser_given given);              /* "length0" */
const char *hawser_crossover_name(enum hawser_crossover_kind kind);  /* "crossing" */

#ifdef __cplusplus
}
#endif
#endif
