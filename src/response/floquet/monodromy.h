/* response/floquet/monodromy.h - Floquet multipliers of an orbit that is given as a Fourier series.
 *
 * The variational equation
 *
 *      x'' + D(t) x' + K(t) x = 0,    K = C_0/2 + sum of C_k cos(k Omega t) + S_k sin(k Omega t)
 *
 * is linear with known coefficients, so that the orbit need not be integrated. Each step is a
 * collocation at 8 Gauss nodes (order 16), with the accelerations a_i at the nodes as unknowns:
 *
 *      a_i + K_i (x_0 + c_i h v_0 + h^2 sum B_ij a_j) + D_i (v_0 + h sum A_ij a_j) = 0
 *
 * with B = A A. (With the second integral of the interpolated acceleration for B, the method would
 * not be A-stable.)
 *
 * The mean damping a = tr D/n is removed by x = exp(-a t/2) z. For symmetric K and no other
 * damping, collocation at Gauss nodes is symplectic: the moduli are exact to round-off, and only
 * the phases have an error. Sorted eigenvalues of the (truncated) Hill matrix have neither
 * property.
 *
 * Coordinates that are far too fast to take part in an instability (the frequencies of a full-order
 * model reach 1e4 times Omega) are condensed first: monodromy_condense.c.
 *
 * Coordinates that are not coupled (in plane and out of plane, symmetric and antisymmetric) are
 * treated separately, since the cost is cubic.
 *
 * Reference: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.7; Hairer,
 * Lubich and Wanner, Geometric Numerical Integration, II.1.3 and VI.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_MONODROMY_H
#define HAWSER_RESPONSE_MONODROMY_H

#include <hawser/orbit.h>

#include <math.h>

#include "response/orbit/collocation.h"

/* Variational equations with periodic coefficients, as Fourier series ordered by harmonics:
 * constant (twice its value), cos 1, sin 1, ... */
struct hawser__variational {
	int n, order, order_d;
	const double *K; /* [2 order + 1][n][n] */
	const double *D; /* [2 order_d + 1][n][n] */
	double omega;
};

/* Row of such a series to which a harmonic of the model belongs, and what its D or K is multiplied by
 * there. A constant term (k = 0) has the phase cos, so that 2 k - 1 would be the row before the
 * first. */
static inline size_t hawser__series_row(const struct hawser_harmonic *harmonic)
{
	return harmonic->k ? 2*(size_t)harmonic->k - (harmonic->phase == HAWSER_COS) : 0;
}
static inline double hawser__series_factor(const struct hawser_harmonic *harmonic, double omega)
{
	return (harmonic->k ? 1.0 : 2.0)*pow(omega, harmonic->omega_power);
}

/* A model is stiff if it has coordinates faster than this multiple of Omega. */
#define HAWSER__FOLLOW 20.0
/* Largest relative error of the slow stiffness by the condensation; chosen. */
#define HAWSER__NEGLECTED 1e-4
#define HAWSER__HASTE 1e-6    /* the same for models whose coordinates could all be integrated, but
                               * at a high cost */
#define HAWSER__ROUGHER 1e-3  /* the same for a search, which samples at larger intervals than this
                               * shifts a boundary */
#define HAWSER__EXPECTED 4    /* initial value of hawser__monodromy.expected; chosen */
#define HAWSER__SHARPER 1e-10 /* the same for multipliers that serve for comparison */

/* Coordinates that are coupled with each other and with no others: in plane, for instance. Condensed
 * coordinates are computed by blocks, since the work is cubic. */
struct hawser__block {
	int ns, nf;   /* of its slow and fast coordinates */
	int s, f;     /* the first of them */
	size_t F, N;  /* where its part of a row begins */
};

struct hawser__monodromy {
	int n;                  /* largest number of coordinates */
	int steps;              /* number of steps per period */
	int table_steps, order; /* parameters of the table below, */
	const struct hawser__collocation *table_nodes; /* and the nodes of its steps */
	double error;           /* estimated error of the last multipliers' logarithms */
	double loss;            /* error of the entries of the product, with round-off */
	double round_off;       /* its part that is due to round-off */
	double neglected;       /* error of the logarithms by condensed coordinates */
	double spread;          /* the same with round-off, and amplified at double multipliers */
	int finer;              /* 0 along a branch. Otherwise the phase of every coordinate counts,
	                         * this is a factor on the number of steps, and the computation fails if
	                         * it needs too many */
	int more;               /* further increase of the number of steps, in quarters */
	int sharper;            /* 1: errors at least ten times smaller, for comparison */
	int most;               /* largest number of steps */
	double allowed;         /* error from which on a tentative number of steps is given up; infinite
	                         * without one */
	int hasty;              /* 1: expensive strict computations may condense coordinates */
	int haste;              /* 1: the present one may */
	int rough;              /* 1: multipliers for a search, with errors of 1e-3. Those of the kept
	                         * coordinates come first */
	int kept;               /* number of coordinates that were not condensed */
	double operations;      /* additions and multiplications of all steps; the caller may reset it */
	double left_out;        /* error of the slow stiffness by the condensation, relative */
	double stretch;         /* logarithm of the largest norm of a factor */
	int phases;             /* number of steps that the phases of the kept coordinates of a stiff
	                         * model needed last; 0: no more than planned */
	int resolved;           /* 1: the steps of a stiff model resolve all kept coordinates */
	double fastest;         /* largest relevant frequency of a stiff model, or infinite */
	double top;             /* frequency of the fastest kept coordinate of a stiff model */
	struct hawser__collocation gauss, radau;
	int *part, *member;     /* [n] component of a coordinate; coordinates by components */
	int *sign;              /* [n] of the coordinates of a component (hawser__monodromy_repeats) */
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
	double *grouped;        /* [2][2n] logarithms and arguments of the last multipliers: those of a
	                         * component at 2 j and 2 j + 1 of its coordinates j */
	double *kind;           /* [2n] of the last multipliers (floquet.h) */
	int kinds;              /* 1: kinds are defined: K and D are symmetric, D is constant */
	double *memory;
	double *damping;        /* D of the model, as a series */
	size_t damping_room;
	const double *resist;   /* [2 resist_order + 1][n][n] further damping of the caller, as a series, or
	                         * NULL */
	int resist_order;
	const double *rest;     /* [n][n] stiffness at rest of a model whose coordinates are its
	                         * modes at rest, ascending, and that moves far
	                         * (monodromy_rest.c), or NULL */
	double *reduced;        /* [2 order + 1][reduced_n][reduced_n] S (monodromy_rest.c) */
	int reduced_n;
	size_t reduced_room;
	/* monodromy_condense.c */
	double follow;          /* frequency, relative to Omega, up to which no coordinate is condensed */
	int *slow, *fast;       /* [n] coordinates that are kept, and those that are condensed */
	struct hawser__block *block; /* [n] workspace */
	int expected;           /* level: number of iterations of the condensation that are expected to
	                         * converge. A model with rest has others: with less error, and more
	                         * coordinates, below 0, with more error above HAWSER__EXPECTED */
	int stay;               /* orbits before a higher level is tried */
	int needed;             /* harmonics that the condensed equations last had; 0: not known */
	double *frequency;      /* [n] of the mean stiffness */
	double *reach;          /* [n] workspace */
	double *room;           /* workspace of the condensation */
	size_t room_size;
};

/* Largest number of factors of the product: their memory grows with n^2. */
static inline int hawser__monodromy_factors(int n)
{
	return n <= 16 ? 256 : 64;
}

/* --- monodromy_factors.c --- */

struct hawser__component;

struct hawser__factors {
	double *at;      /* [most][m][m] */
	int m, count, most;
	double limit;    /* largest logarithm of the norm of a factor */
	double largest;  /* that of the last factor; negative: a new factor begins */
	double taken;    /* logarithm of the scale by which factors were divided to prevent overflow */
};

#define HAWSER__EIGEN_WORK 34 /* of order m, in doubles over m: blocks of 32 */

/* Multiply the last factor by the matrix of a step from the left. If this would make some motions
 * grow much more than others, a new factor begins. */
void hawser__factors_add(struct hawser__monodromy *monodromy, struct hawser__factors *factors);

/* log_modulus, argument and kind [m] of the product, which is overwritten, divided by
 * exp(factors->taken). */
enum hawser_status hawser__factors_multipliers(struct hawser__monodromy *monodromy,
                                               double *log_modulus, double *argument,
                                               double *kind,
                                               const struct hawser__component *c,
                                               struct hawser__factors *factors,
                                               struct hawser_report *report);

/* R M of the product M over half a period, R the signs: that over the whole period is (R M)^2. */
void hawser__factors_reverse(struct hawser__factors *factors, const int *sign);

/* The multipliers of the square of a matrix; the first of a pair has the positive argument. */
void hawser__factors_square(double *log_modulus, double *argument, double *kind, int m);

/* Error of a product of m by m matrices: that of the steps, `error`, and round-off. */
double hawser__factors_loss(int m, int steps, double stretch, double error);

/* Errors of the logarithms [m] by errors of the factors (steps and round-off): the larger, the
 * nearer two multipliers are to each other; at a double multiplier the square root. */
double hawser__factors_error(const double *log_modulus, const double *argument, int m, double loss,
                             double error);

/* The same for multiplier i only. */
double hawser__factors_error_of(int i, const double *log_modulus, const double *argument, int m,
                                double loss);

/* --- monodromy_step.c --- */

#define HAWSER__STEP_ERROR 2.2e-19 /* error of a step of one radian; it grows with the 17th power of
                                    * the step */

struct hawser__component {
	const int *member; /* [w] coordinates */
	int n;             /* coordinates of the whole system */
	int w;             /* of the component */
	double damping;    /* a */
	double h;          /* time step */
	int overdamped;    /* 1: some coordinates decay within a step */
	const struct hawser__collocation *table;
};

/* Sets c->damping, overdamped and table; c->damping is 0. Returns the rate at which the damping that
 * differs between coordinates separates motions. */
double hawser__component_damping(struct hawser__component *c, const struct hawser__monodromy *monodromy,
                                 const struct hawser__variational *system);

/* Compute the transition matrix of one step, monodromy->step [2w][2w]; its estimated error is added
 * to *error. HAWSER_ERR_CONVERGENCE: the equations of the step are singular. */
enum hawser_status hawser__monodromy_step(struct hawser__monodromy *monodromy, double *error,
                                          const struct hawser__variational *system,
                                          const struct hawser__component *c, int step,
                                          struct hawser_report *report);

/* --- monodromy_plan.c --- */

#define HAWSER__MONODROMY_GOAL 1e-10 /* error of the multipliers' logarithms, above round-off and
                                      * small enough to locate events; chosen */

/* Sets monodromy->most; for a strict computation also follow and haste. `widest` is the number of
 * coordinates of the largest component. */
void hawser__monodromy_limits(struct hawser__monodromy *monodromy,
                              const struct hawser__variational *system, int widest);
/* Sets monodromy->most again after the condensation. */
void hawser__monodromy_afford(struct hawser__monodromy *monodromy, int widest);
/* Sets the initial number of steps, after the condensation. HAWSER_ERR_CONVERGENCE if a strict
 * computation would need too many. */
enum hawser_status hawser__monodromy_plan(struct hawser__monodromy *monodromy,
                                          const struct hawser__variational *system,
                                          struct hawser_report *report);
/* The number of steps with which the error becomes a third of this goal. */
int hawser__monodromy_better(const struct hawser__monodromy *monodromy, double goal);
/* Of a stiff model: the number with which the phases of all kept coordinates may be resolved; the
 * present one, if they are, or cannot be. */
int hawser__monodromy_raised(const struct hawser__monodromy *monodromy);
/* Whether the second half of the period repeats the first with the coordinates of negative sign [c->w]
 * reversed: even harmonics couple coordinates of equal signs, odd ones those of opposite signs. */
int hawser__monodromy_repeats(int *sign, const struct hawser__variational *system,
                              const struct hawser__component *c);
/* Error of the multipliers of a stiff model by the steps. */
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

/* Set part and member: the components of the equations, and its coordinates by components. */
void hawser__monodromy_parts(struct hawser__monodromy *monodromy,
                             const struct hawser__variational *system);

/* log_modulus and argument [2n] of the orbit whose tangent has the Fourier coefficients T
 * [2 order + 1][n][n] (the constant one twice); rom gives D and its harmonics. */
enum hawser_status hawser__monodromy_multipliers(struct hawser__monodromy *monodromy,
                                                 double *log_modulus, double *argument,
                                                 const struct hawser_rom *rom, const double *T,
                                                 int order, double omega,
                                                 struct hawser_report *report);

/* monodromy_condense.c: if there are fast coordinates, replace *system by one of the slow
 * coordinates; sets monodromy->slow, fast, frequency and fastest. *kept is the number of slow
 * coordinates. */
enum hawser_status hawser__monodromy_condense(struct hawser__monodromy *monodromy,
                                              struct hawser__variational *system, int *kept,
                                              struct hawser_report *report);

/* The room of the condensation has at least `need` numbers. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__monodromy_room(struct hawser__monodromy *monodromy, size_t need,
                                          struct hawser_report *report);

/* --- monodromy_rest.c --- */

/* basis [rows][2 order + 1]: 1/2, cos, sin, ... at equidistant phases. */
void hawser__monodromy_phases(double *basis, int rows, int order);
/* Sets system->order, monodromy->fastest from the stiffness with which slow motions move, and
 * reduced. *noise: error of this stiffness, relative, that harmonics left out may have; then what is
 * left out, relative to two frequencies. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__monodromy_resonances(struct hawser__monodromy *monodromy,
                                                struct hawser__variational *system, double *noise,
                                                struct hawser_report *report);

/* --- monodromy_fast.c --- */

/* Sets system->order without negligible harmonics of K, and monodromy->fastest. */
void hawser__fast_find_range(struct hawser__monodromy *monodromy,
                             struct hawser__variational *system);
/* Sets monodromy->slow and fast: coordinates are fast if `expected` iterations of the condensation
 * make the relative error of the slow stiffness less than `limit`. Returns the largest frequency of
 * the `kept` slow coordinates. */
double hawser__fast_split(struct hawser__monodromy *monodromy,
                          const struct hawser__variational *system, double limit,
                          int expected, int *kept);
/* Of a model with rest: the number of coordinates below the widest gap of their frequencies above
 * which all are at least `least`; n if there is none. */
int hawser__fast_gap(const struct hawser__monodromy *monodromy, int n, double least);
/* Whether a series [2 order + 1][n][n] is symmetric at all phases. */
int hawser__fast_symmetric(const double *series, int order, int n);
/* Whether all combinations of the nf fast coordinates are fast. */
int hawser__fast_separate(struct hawser__monodromy *monodromy,
                          const struct hawser__variational *system, int nf);

/* The larger of `fastest` and of the growth rate of the mean stiffness, which the steps must
 * resolve. */
double hawser__monodromy_pace(struct hawser__monodromy *monodromy,
                              const struct hawser__variational *system);

#endif
