/* response/monodromy.h - Floquet multipliers of an orbit that is known as a Fourier series.
 *
 * The variational equation
 *
 *     x'' + D(t) x' + K(t) x = 0,    K = C_0/2 + sum of C_k cos(k Omega t) + S_k sin(k Omega t)
 *
 * is linear with known coefficients, so its transition matrices need no orbit to be integrated with
 * them. Each step is a collocation at 8 Gauss nodes (order 16), in the accelerations a_i at the nodes:
 *
 *     a_i + K_i (x_0 + c_i h v_0 + h^2 sum B_ij a_j) + D_i (v_0 + h sum A_ij a_j) = 0
 *
 * with B = A A (and not the second integral of the interpolated acceleration, with which it would
 * not be A-stable).
 *
 * With the mean damping a = tr D/n taken out by x = exp(-a t/2) z, collocation at Gauss nodes is
 * symplectic for symmetric K and the rest of D zero: moduli are right to round-off, and only phases
 * carry an error. Sorted eigenvalues of the (truncated) Hill matrix would have neither.
 *
 * Coordinates that are far too fast to take part (in a full-order model there are frequencies 1e4
 * times Omega) are condensed first: monodromy_condense.c.
 *
 * Coordinates that nothing couples (out of plane from in plane, antisymmetric from symmetric) are
 * treated apart: the cost is cubic.
 *
 * Reference: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.7; Hairer,
 * Lubich and Wanner, Geometric Numerical Integration, II.1.3 and VI.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_MONODROMY_H
#define HAWSER_RESPONSE_MONODROMY_H

#include <hawser/orbit.h>

#include "response/collocation.h"

/* Variational equations with periodic coefficients, as Fourier series by harmonics: constant (twice
 * its value), cos 1, sin 1, ... */
struct hawser__variational {
	int n, order, order_d;
	const double *K; /* [2 order + 1][n][n] */
	const double *D; /* [2 order_d + 1][n][n] */
	double omega;
};

/* A model is stiff where it has coordinates faster than so many times Omega. */
#define HAWSER__FOLLOW 20.0
/* Of the stiffness, by a fast coordinate that is left out: a bound; measured 1e-6. */
#define HAWSER__NEGLECTED 1e-4
#define HAWSER__HASTE 1e-6    /* the same where every coordinate could be followed, at a high cost */
#define HAWSER__ROUGHER 1e-3  /* the same for a search, whose samples lie farther apart than this moves
                               * anything */
#define HAWSER__SHARPER 1e-10 /* the same for multipliers to compare with */

struct hawser__monodromy {
	int n;                  /* largest number of coordinates */
	int steps;              /* a period */
	int table_steps, order; /* what the table below was made for */
	double error;           /* estimated, of the last multipliers' logarithms */
	double loss;            /* of the product's entries, with round-off */
	double round_off;       /* of the product's entries, round-off alone */
	double neglected;       /* of the logarithms, by coordinates that are left out */
	double spread;          /* the same with round-off, and with what both do where multipliers meet */
	int finer;              /* 0 along a branch. Else every coordinate's phase counts, so many times
	                         * the steps are made, and what would take too many is refused */
	int more;               /* so many quarters more steps than that */
	int sharper;            /* errors at least ten times smaller, to compare with */
	int most;               /* steps */
	int hasty;              /* strict computations of a high cost may leave coordinates out */
	int haste;              /* the present one may */
	int rough;              /* multipliers for a search: errors of 1e-3 will do. Those of the kept
	                         * coordinates come first */
	int kept;               /* coordinates that were followed */
	double left_out;        /* relative, of the slow stiffness: what is neglected of the others */
	double stretch;         /* logarithm of the largest norm of a factor */
	double fastest;         /* frequency up to which a stiff model's coordinates matter, or infinite */
	struct hawser__collocation gauss;
	int *part, *member;     /* [n] component of a coordinate; coordinates by components */
	int parts;
	double *scale;          /* [n] frequency by which displacements are scaled */
	double *table;          /* [steps][8][2 order + 1] 1/2, cos, sin, ... at the nodes */
	size_t table_room;
	double *stiff, *damp;   /* [8][n][n] at the nodes of a step */
	double *matrix;         /* [8 n][8 n] column-major */
	double *rhs;            /* [2 n][8 n] column-major */
	int *pivot;             /* [8 n] */
	double *step, *product; /* [2n][2n] */
	double *factor;         /* [2 factors][2n][2n] */
	double *floquet_work;
	double *memory;
	double *damping;        /* D of the model, as a series */
	size_t damping_room;
	/* monodromy_condense.c */
	double follow;          /* frequency over Omega up to which every coordinate is followed */
	int *slow, *fast;       /* [n] coordinates that are kept, and the others */
	double *frequency;      /* [n] of the mean stiffness */
	double *reach;          /* [n] scratch */
	double *room;           /* what the condensation needs */
	size_t room_size;
};

/* Factors of the product, at most: their room grows with n^2. */
static inline int hawser__monodromy_factors(int n)
{
	return n <= 16 ? 256 : 64;
}

/* --- monodromy_factors.c --- */

struct hawser__factors {
	double *at;      /* [most][m][m] */
	int m, count, most;
	double limit;    /* of the logarithm of a factor's norm */
	double largest;  /* the last factor's; below 0: a new one begins */
	double taken;    /* logarithm of what they were divided by, lest they overflow */
};

#define HAWSER__EIGEN_WORK 34 /* of order m, in doubles over m: blocks of 32 */

/* The step's matrix before the last factor; the next one begins a new factor where this one stretches
 * some motions much more than others. */
void hawser__factors_add(struct hawser__monodromy *monodromy, struct hawser__factors *factors);

/* log_modulus and argument [m] of the product, which is overwritten, over exp(factors->taken). */
enum hawser_status hawser__factors_multipliers(struct hawser__monodromy *monodromy,
                                               double *log_modulus, double *argument,
                                               struct hawser__factors *factors,
                                               struct hawser_report *report);

/* Error of a product of m by m matrices: that of the steps, `error`, and round-off. */
double hawser__factors_loss(int m, int steps, double stretch, double error);

/* What errors of the factors, those of the steps and round-off, make of the logarithms [m]: more, the
 * nearer two multipliers are to each other; their root where they meet. */
double hawser__factors_error(const double *log_modulus, const double *argument, int m, double loss,
                             double error);

/* The same for multiplier i alone. */
double hawser__factors_error_of(int i, const double *log_modulus, const double *argument, int m,
                                double loss);

/* --- monodromy_step.c --- */

#define HAWSER__STEP_ERROR 2.2e-19 /* of a step of one radian; it grows with the 17th power */

struct hawser__component {
	const int *member; /* [w] coordinates */
	int n;             /* coordinates of the whole system */
	int w;             /* of the component */
	double damping;    /* a */
	double h;          /* of a step, time */
};

/* Make monodromy->step [2w][2w] the transition matrix of one step; *error grows by its estimated
 * error. HAWSER_ERR_CONVERGENCE: the step is singular. */
enum hawser_status hawser__monodromy_step(struct hawser__monodromy *monodromy, double *error,
                                          const struct hawser__variational *system,
                                          const struct hawser__component *c, int step,
                                          struct hawser_report *report);

/* --- monodromy_plan.c --- */

#define HAWSER__MONODROMY_GOAL 1e-10 /* error of the multipliers' logarithms */

/* Sets monodromy->most and, for a strict computation, follow and haste. `widest` is the number of
 * coordinates of the largest component. */
void hawser__monodromy_limits(struct hawser__monodromy *monodromy,
                              const struct hawser__variational *system, int widest);
/* Sets monodromy->most anew for what a condensation has left. */
void hawser__monodromy_afford(struct hawser__monodromy *monodromy, int widest);
/* Sets the number of steps to begin with, after the condensation. HAWSER_ERR_CONVERGENCE where a strict
 * computation would take too many. */
enum hawser_status hawser__monodromy_plan(struct hawser__monodromy *monodromy,
                                          const struct hawser__variational *system,
                                          struct hawser_report *report);
/* The number of steps that brings the error of the last ones to a third of the goal. */
int hawser__monodromy_better(const struct hawser__monodromy *monodromy);
/* Error of a stiff model's multipliers by the steps. */
double hawser__monodromy_stiff_error(const struct hawser__monodromy *monodromy);

/* --- monodromy.c --- */

enum hawser_status hawser__monodromy_init(struct hawser__monodromy *monodromy, int n,
                                          struct hawser_report *report);
void hawser__monodromy_release(struct hawser__monodromy *monodromy);

/* Sets D and order_d of *system: the damping of the model and its harmonics at system->omega.
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__monodromy_damping(struct hawser__monodromy *monodromy,
                                             struct hawser__variational *system,
                                             const struct hawser_rom *rom,
                                             struct hawser_report *report);

/* log_modulus and argument [2n] of the orbit whose tangent has the Fourier coefficients T
 * [2 order + 1][n][n] (the constant one twice); rom gives D and its harmonics. */
enum hawser_status hawser__monodromy_multipliers(struct hawser__monodromy *monodromy,
                                                 double *log_modulus, double *argument,
                                                 const struct hawser_rom *rom, const double *T,
                                                 int order, double omega,
                                                 struct hawser_report *report);

/* monodromy_condense.c: replace *system by one of the slow coordinates alone, where there are fast
 * ones; sets monodromy->slow, fast, frequency and fastest. *kept of the n coordinates remain. */
enum hawser_status hawser__monodromy_condense(struct hawser__monodromy *monodromy,
                                              struct hawser__variational *system, int *kept,
                                              struct hawser_report *report);

/* --- monodromy_fast.c --- */

/* Sets system->order, without harmonics of K that are slight, and monodromy->fastest. */
void hawser__fast_find_range(struct hawser__monodromy *monodromy,
                             struct hawser__variational *system);
/* By how much what is neglected of coordinate j moves the slow ones' stiffness, relative. */
double hawser__fast_neglects(const struct hawser__monodromy *monodromy,
                             const struct hawser__variational *system, int j);
/* Whether K is symmetric at all phases. */
int hawser__fast_symmetric(const struct hawser__variational *system);
/* Whether all combinations of the nf fast coordinates are fast. */
int hawser__fast_separate(struct hawser__monodromy *monodromy,
                          const struct hawser__variational *system, int nf);

/* The larger of `fastest` and of the rate at which the mean stiffness makes motions
 * grow; steps have to resolve it. */
double hawser__monodromy_pace(struct hawser__monodromy *monodromy,
                              const struct hawser__variational *system);

#endif
