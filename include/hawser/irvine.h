/* hawser/irvine.h - natural frequencies along a sweep of the tension: the Irvine diagram.
 *
 * A cable between two fixed ends has one equilibrium for each horizontal tension H. A sweep varies
 * H, or another quantity that determines H, and follows each branch of frequencies through
 * crossings (two frequencies become equal and each mode keeps its shape; this requires symmetry,
 * that is a level span) and veerings (the frequencies approach and separate again, and the two
 * modes exchange their shapes). doc/theory-irvine.md has the algorithm.
 *
 * Quantities are in SI, frequencies in rad/s, not scaled, since the time unit varies along a sweep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_IRVINE_H
#define HAWSER_IRVINE_H

#include <hawser/modes.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_crossover_kind {
	HAWSER_CROSSING = 0, /* the smallest gap is within the tolerance: each branch keeps its shape */
	HAWSER_VEERING       /* the gap is larger: the branches keep their order and exchange shapes */
};

/* Branches are numbered from 1 in each plane, by frequency at the start of the sweep. */
struct hawser_irvine_branch {
	enum hawser_plane plane;
	int number;
};

struct hawser_irvine_station {
	struct hawser_statics statics; /* if the cable travels, with the apparent quantities */
	double value;  /* of the swept quantity, N or m */
	double moved;  /* relative distance from the requested grid point; nonzero if two branches cross
	                * at the grid point, where their shapes are undetermined */
	int inserted;  /* 0: a requested point; 1: added by the refinement */
};

/* The point at which two in-plane branches are closest. Branches are numbered as in struct
 * hawser_irvine_branch; branches above the kept ones continue the numbering. */
struct hawser_irvine_crossover {
	enum hawser_crossover_kind kind;
	double value;                 /* of the swept quantity, N or m */
	double H;                     /* N, the actual one */
	double irvine, irvine_source; /* as in struct hawser_statics */
	int below, above;             /* numbers of the lower and the upper branch before it */
	double omega;                 /* rad/s, mean of the two frequencies */
	double gap, relative_gap;     /* rad/s, and over omega */
};

struct hawser_irvine {
	struct hawser_span span;
	enum hawser_given sweep;
	double speed, fluctuation; /* m/s */
	const char *method;  /* static string */
	int stations, branches, crossovers;
	int in_plane;        /* branches in the plane; they come first, by number */
	int solves;          /* number of modal solutions computed */
	double least_correlation; /* smallest squared correlation of an in-plane branch's shapes between
	                           * neighbouring stations with no crossover between them; 1: no
	                           * change */
	struct hawser_irvine_station *station;     /* [stations] in the order of the sweep */
	struct hawser_irvine_branch *branch;       /* [branches] */
	struct hawser_irvine_crossover *crossover; /* [crossovers] in the order of the sweep */
	double *omega;                  /* [stations][branches] rad/s */
	double *residual;               /* [stations][branches] error estimates, as in struct
	                                 * hawser_mode or, if the cable travels, struct
	                                 * hawser_complex_mode */
	int *place;                     /* [stations][branches] from 0, by frequency in its plane */
	enum hawser_symmetry *symmetry; /* [stations][branches]; mixed if the cable travels */
	enum hawser_family *family;     /* [stations][branches] */
	void *held; /* memory of the arrays */
};

struct hawser_irvine_options {
	enum hawser_given sweep; /* HAWSER_GIVEN_NONE: H */
	double from, to;         /* N or m; 0 for either: see hawser_irvine_range */
	double contained; /* N, horizontal tension (of the apparent cable, if it travels) that the default
	                   * range contains, with a quarter of it on both sides where the bounds of
	                   * strain and sag allow that; 0: none */
	double speed, fluctuation; /* m/s, as in struct hawser_motion, constant over the sweep; the
	                            * swept quantity is then that of the steady state */
	const struct hawser_attachment *attach; /* [attachments] of a cable at rest, in any order */
	int attachments;
	double gravity; /* m/s^2, of their masses, along the force per length; 0: g of the span */
	const struct hawser_held *held; /* [2] ends A and B; NULL: rigid */
	struct hawser_bending bending;  /* 0: none; of a cable at rest without held ends */
	int points;     /* stations before refinement, >= 2; 0: 200. Equidistant in the logarithm of the
	                 * value, or of H if length0 is swept. For T0, T1: taut solutions */
	int n;          /* number of branches: the lowest at `from`, both planes together; 0: 10 */
	const char *method; /* name of a hawser_modes_method, or, if the cable travels, of a
	                     * hawser_complex_modes_method; NULL: "spectral" */
	int basis;          /* as in struct hawser_modes_options */
	double tolerance;   /* as in struct hawser_modes_options */
	double correlation; /* a step with a smaller squared correlation is halved; 0: 0.9 */
	double crossing;    /* largest relative gap of a crossing; 0: 1e-10 */
};

/* The range of B's figures 4.4 and 4.5: *from and *to are the values of the swept quantity at which
 * Irvine's parameter (irvine_source) is 0.1 pi (taut) and 10 pi (slack). The range is shortened so
 * that the strain H/EA is at most 0.1, that H is at least rho*g*d/4 (a sag of about 0.7 d), and,
 * for T0 or T1, that it ends at the least tension. Statuses: those of hawser_statics_solve, and
 * HAWSER_ERR_NO_SOLUTION (an inextensible cable, or an empty range). */
enum hawser_status hawser_irvine_range(double *from, double *to, const struct hawser_span *span,
                                       enum hawser_given sweep,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Sweep. *irvine is overwritten; release it with hawser_irvine_clear. Statuses: HAWSER_ERR_ARGUMENT
 * (range, counts), HAWSER_ERR_CONVERGENCE (branches could not be distinguished with the smallest
 * step; the message states where), and those of hawser_statics_solve and hawser_modes_solve. */
enum hawser_status hawser_irvine_trace(struct hawser_irvine *irvine,
                                       const struct hawser_span *span,
                                       const struct hawser_irvine_options *options,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_irvine_clear(struct hawser_irvine *irvine);

/* pi*sqrt(H/rho)/d of a station in rad/s, with the actual H: the first frequency of a level string
 * at rest under that tension. Frequencies are normalised by it. */
double hawser_irvine_string(const struct hawser_irvine_station *station);

/* The actual swept quantity of a static solution, N or m; NAN for HAWSER_GIVEN_NONE. */
double hawser_irvine_value(const struct hawser_statics *statics, enum hawser_given sweep);

const char *hawser_given_name(enum hawser_given given);              /* "length0" */
const char *hawser_crossover_name(enum hawser_crossover_kind kind);  /* "crossing" */

#ifdef __cplusplus
}
#endif
#endif
