/* response/orbit/balance.h - harmonic balance for forced periodic orbits; a method of method.h.
 *
 *   tau    phase Omega t
 *   u_j    = y_0j + sum over h of y_{2h-1,j} cos(h tau) + y_{2h,j} sin(h tau)
 *   y      unknowns [size]: coefficients [2 top + 1][n] by harmonics (constant, cos 1, sin 1, ...),
 *          then Omega. The layout is the same whatever is solved for, so that neighbouring points of a
 *          branch can be combined
 *   pair   a harmonic h and a coordinate j. Only the active pairs are solved for, the others are 0.
 *          Pairs that symmetry excludes cost nothing; each coordinate has the harmonics it needs
 *   H      order, the highest harmonic of an active pair; P unknowns, the active pairs' coefficients
 *   r      defects [2 reach + 1][n] by harmonics, of Omega^2 u'' + Omega D u' + restoring(u) - forcing.
 *          Those of the active pairs are the equations; those of the others estimate the truncation
 *   T      tangent's Fourier coefficients [2 spread + 1][n][n], by harmonics, the constant twice:
 *          the Jacobian is made of their sums and differences. spread is 2H, or a parameter's
 *          harmonic
 *   R      rows: samples of a period
 *
 * Alternating frequency and time (Cameron and Griffin 1989): products are formed at samples. A
 * product of three harmonics up to H reaches 3H; with R >= 3H + reach + 1 equidistant samples none
 * of it is aliased to harmonics up to `reach`. For the polynomial model the Fourier coefficients of the
 * force are therefore exact; so they are with terms of any degree, which take more samples
 * (balance_terms.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_BALANCE_H
#define HAWSER_RESPONSE_BALANCE_H

#include "core/hold.h"
#include "response/orbit/balance_blocks.h"
#include "response/orbit/method.h"
#include "response/floquet/monodromy.h"

#define HAWSER__PART 1e-5 /* smallest pair taken from another model, or with exact energy, by the
                           * roots of their energies: small motions along the cable stretch it;
                           * chosen */
#define HAWSER__KRYLOV 72 /* largest number of iterations of GMRES */
#define HAWSER__LEARNED 24 /* number of vectors that correct old factors; chosen */

struct hawser__balance {
	struct hawser__orbit base;
	int top;                 /* highest harmonic allowed, by memory or by the basis */
	int limited;             /* 1: top is limited by the model's basis */
	int order, reach, spread, width; /* H; highest harmonics of r, of T, of the basis */
	unsigned char *active;   /* [top + 1][n] */
	unsigned char *coarse;   /* [top + 1][n] active pairs of the coarser discretisation, for
	                          * comparison */
	int unknowns;            /* P */
	int *first;              /* [top + 2] index in list of the first pair of harmonic h */
	int *list;               /* [(top + 1) n] coordinates of the active pairs, by harmonics */
	int *place;              /* [size] unknown of a coefficient, or -1 */
	int *slot;               /* [size] coefficient of an unknown */
	double *given, *at;      /* [size] y of the last defects; the same with inactive pairs 0 */
	double *basis;           /* [R][2 width + 1] 1, cos, sin, ... at the samples */
	double *force, *tangent; /* [R][n], [R][n][n] */
	double *work;            /* of hawser__rom_tangents */
	double *defect, *by_omega; /* [2 reach + 1][n] */
	double *other_samples, *other_defect; /* as above, for the orbit with the missing pairs added */
	double *kept;            /* [size] scratch */
	double *orbit, *before;  /* [size] scratch of the error */
	double *wave;            /* [2 top + 1][n] scratch */
	double *T;               /* of the last derivatives, if */
	int transformed;         /* 1: hawser__balance_transform was called since */
	int more;                /* 1: the model has terms (rom.h), or the exact force of a wind. Then: */
	double *rates;           /* [R][n] velocities at the samples */
	double *slope, *shift;   /* [R][n][n], [R][n] derivatives of these by velocities and Omega */
	double *resist;          /* [2 spread + 1][n][n] Fourier coefficients of slope, as T; else NULL */
	double resist_floor;     /* round-off of them */
	double open;             /* the part of mesh that more active pairs could reduce */
	double strict;           /* factor on the tolerance that open must meet, at most 1 */
	double doubt;            /* estimated error of the last orbit, relative */
	double *stiffness;       /* [n] mean of the tangent's diagonal */
	double *damping;         /* [n] diagonal of D */
	double *size_u, *size_v; /* [n] metric: sizes of the components */
	double derived_at;       /* Omega of the last derivatives */
	double *border;          /* [P + 1] last row of M, the scaled bordered matrix */
	int dense;               /* 1: M itself is required, whatever its size */
	int blockwise;           /* 1: the inverse is approximated by `blocks`; M is not assembled */
	struct hawser__blocks blocks;
	double *direction, *image; /* [size], [2 reach + 1][n] vector and image of a product with the
	                            * Jacobian */
	double *moved;           /* [2][R][n] the same at the samples */
	double *top_block;       /* [top_count][top_count] M's last harmonics */
	float *top_factors;      /* [top_count + 1][top_count] their factors, and a right side */
	int top_from, top_count; /* the first of these harmonics, number of their unknowns */
	int top_more;            /* 1: one harmonic more: new factors took many iterations */
	int *top_pivot;          /* [top_count] */
	double *row;             /* [size] the row of which the border is made */
	double *rest;            /* [3][P + 1] scratch */
	double *free;            /* [P + 1] approximation of M^-1 (0, ..., 0, 1) */
	double *near;            /* [P + 1] approximation of the singular vector of the smallest
	                          * singular value of M */
	double *matrix, *lu;     /* [P + 1][P + 1] M; factors of M or of an earlier M; unused if
	                          * blockwise */
	int factored, fresh;     /* 1: lu has factors; 1: they are those of the present M */
	int single, direct;      /* 1: the factors are floats; 1: they are doubles and of the present M */
	int jacobians, iterations, spent; /* numbers since the factorisation; iterations for the last
	                                   * Jacobian */
	int *pivot;              /* [P + 1] */
	double *rhs;             /* [2][P + 1] */
	double *row_scale, *col_scale; /* [P] */
	double *krylov;          /* [HAWSER__KRYLOV + 1][P + 1] */
	double *flexible;        /* [HAWSER__KRYLOV][P + 1] the same times the approximate inverse */
	int learned;             /* number of vectors stored since the factorisation (balance_solve.c) */
	double *cause, *effect;  /* [HAWSER__LEARNED][P + 1] the last ones and their products with M */
	double norm_inverse;     /* estimate for lu; 0: not computed yet */
	double turn;             /* Omega component over W of the last unit tangent */
	struct hawser__monodromy monodromy;
	struct hawser__hold hold;
};

/* Index in y of the cosine (or constant) and of the sine of coordinate j at harmonic h. */
static inline int hawser__cos(int n, int h, int j)
{
	return (h ? 2*h - 1 : 0)*n + j;
}
static inline int hawser__sin(int n, int h, int j)
{
	return 2*h*n + j;
}

enum hawser_status hawser__balance_init(struct hawser__balance *balance,
                                        const struct hawser_rom *rom, struct hawser_report *report);
/* The lowest harmonic of the load, at least 1: a motion of several of its periods has as many harmonics
 * for each of the load's. */
int hawser__balance_lowest(const struct hawser_rom *rom);
/* Limit top to the harmonics that a full-order model's basis resolves, for orbits at Omega >=
 * lowest. */
void hawser__balance_release(struct hawser__balance *balance);

/* balance_sample.c: defects at y for all harmonics of r; with derive also tangents and by_omega. */
void hawser__balance_evaluate(struct hawser__balance *balance, const double *y, int derive);
/* balance_sample.c: T, with the parametric stiffness: for matrices and multipliers, but not for
 * products with vectors. */
void hawser__balance_transform(struct hawser__balance *balance);

/* balance_terms.c: the numbers of samples and the spread that terms need, at least those on entry. */
void hawser__balance_reach(const struct hawser__balance *balance, int *samples, int *spread);
/* Add the terms to the force at the samples of the orbit `at`, and with derive to the tangent, and set
 * their other derivatives; then the series of these: by_omega +=, resist and what follows from it. */
void hawser__balance_terms(struct hawser__balance *balance, double omega, int derive);
void hawser__balance_terms_transform(struct hawser__balance *balance, double omega);
/* force [R][n] += slope times the velocities of balance->direction. */
void hawser__balance_terms_product(struct hawser__balance *balance, double *force, double omega);
/* Whether row `row` of resist is more than round-off. */
int hawser__balance_resists(const struct hawser__balance *balance, int row);
/* Mean damping of the coordinates, for missing pairs. */
void hawser__balance_set_damping(struct hawser__balance *balance);

/* balance_jacobian.c: the scales of M; the border of M, from `row` [size]; and M, from T, by_omega
 * and the border. */
void hawser__balance_scale(struct hawser__balance *balance);
void hawser__balance_set_border(struct hawser__balance *balance, const double *row);
void hawser__balance_assemble(struct hawser__balance *balance);
/* The block of M for the harmonics from `from` on, without parametric damping, in `matrix`
 * [count][count] unless it is NULL. Returns count, the number of unknowns of these harmonics; they
 * are the last ones. */
int hawser__balance_top(struct hawser__balance *balance, double *matrix, int from);

/* balance_sample.c: out [P + 1] = M x, where x is 0 below the harmonic `from`. */
void hawser__balance_product(struct hawser__balance *balance, double *out, const double *x, int from);

/* balance_sample.c: only the defects at balance->at, which has harmonics up to `order` <= reach. */
void hawser__balance_defects(struct hawser__balance *balance, int order);

/* balance_solve.c (method.h: factor, solve) */
int hawser__balance_factor(struct hawser__orbit *orbit, const double *row);
void hawser__balance_solve(struct hawser__orbit *orbit, double *dy, int homogeneous, double last);
/* x [P + 1] = M^-1 x with the relative residual `goal`. */
void hawser__balance_invert(struct hawser__balance *balance, double *x, double goal);
/* Estimated norm of the inverse of M. */
double hawser__balance_norm_inverse(struct hawser__balance *balance);

/* balance_error.c (method.h: error) */
double hawser__balance_error(struct hawser__orbit *orbit, double residual);

/* balance_active.c: activate the pairs that the loads of the model reach by linear coupling. */
void hawser__balance_seed(struct hawser__balance *balance);
/* To be called after any change of `active`: lists, order, samples and their memory. */
enum hawser_status hawser__balance_arrange(struct hawser__balance *balance,
                                           struct hawser_report *report);
/* Allocate M. Returns 1 on failure. */
int hawser__balance_matrix_room(struct hawser__balance *balance);
/* Linear response of a pair to its defect r, as the rms of a state (u and v). `answer` [2] receives
 * its cosine and sine, unless it is NULL. */
double hawser__balance_missing(const struct hawser__balance *balance, double *answer, int h, int j,
                               double omega);
/* Rms of a pair's part of the state of the last orbit. */
double hawser__balance_amplitude(const struct hawser__balance *balance, int h, int j);
enum hawser_status hawser__balance_refine(struct hawser__orbit *orbit, int *again, double tolerance,
                                          double omega, struct hawser_report *report);
enum hawser_status hawser__balance_relax(struct hawser__orbit *orbit, double tolerance,
                                         struct hawser_report *report);
enum hawser_status hawser__balance_enrich(struct hawser__orbit *orbit, int most,
                                          struct hawser_report *report);
enum hawser_status hawser__balance_sharpen(struct hawser__orbit *orbit, int on,
                                           struct hawser_report *report);

/* balance_fast.c: a coordinate is fast if its frequency exceeds three times that of the
 * highest harmonic; of a model with exact energy that at rest, since the moved cable stretches by a
 * motion across (monodromy_rest.c). */
int hawser__balance_fast(const struct hawser__balance *balance, int j);
/* y [size]: the fast coordinates in static balance with the others at each sample, as far as their
 * active pairs can: one step of Newton's method. */
enum hawser_status hawser__balance_settle(struct hawser__balance *balance, double *y,
                                          struct hawser_report *report);

/* balance_active.c: in blocks a further pair costs nothing, and a pair that is omitted near its
 * resonance costs iterations. All pairs up to the order become active, except those that symmetry
 * excludes by the last defects; hawser__balance_arrange() follows. */
void hawser__balance_fill_up(struct hawser__balance *balance, double omega);

/* balance_state.c: make the harmonics of y up to `order` active that are not small;
 * hawser__balance_arrange() follows. */
void hawser__balance_adopt(struct hawser__balance *balance, const double *y, int order, double part);
/* Make the pairs active of which y has parts, and no others. */
enum hawser_status hawser__balance_hold(struct hawser__balance *balance, const double *y,
                                        struct hawser_report *report);
enum hawser_status hawser__balance_from_state(struct hawser__orbit *orbit, double *y,
                                              const double *x, double omega,
                                              struct hawser_report *report);

#endif
