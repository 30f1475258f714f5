/* response/locus/locus.h - the equations of a bifurcation in two parameters.
 *
 *   y        Fourier coefficients of the orbit [2H + 1][n]: constant, cos 1, sin 1, ...
 *   z        unknowns [size]: Omega or a first parameter, parameter, kappa, then y. kappa is constant
 *            except for tori
 *   kappa    angle of the critical multiplier over 2 pi: 0 for folds and branch points, 1/2 for period
 *            doublings, unknown for tori
 *   F(z)     defects of the orbit, as in balance.h
 *   H        Hill matrix of perturbations exp(i kappa tau) sum v_m exp(i m tau), with the blocks
 *            K_(m-l) + i omega (l + kappa) D_(m-l) - (m + kappa)^2 omega^2
 *   g        [H b; c^H 0] [v; g] = [0; 1]: zero where H is singular. It is real for the real kinds,
 *            whose matrices and borders have conjugate symmetry, and complex for tori
 *   w        the same of the adjoint, so that the derivative of g is - w^H (dH) v
 *
 * For resonances (locus_phase.c) g is the phase of the motion instead, without H.
 *
 * Equations: F = 0, g = 0, and that of the plane of a continuation step. At a branch point F_y is
 * singular, too: the orbit is symmetric, while v is not. The coefficients of the orbit that are of the
 * kind of v (coordinate, and odd or even harmonic) are then barred: they stay zero, and F_y is regular.
 *
 * The matrix of the whole system is made and factorised. It is regular, too, where F_y is singular
 * along a locus of another kind (fold-flip and others), at which a block elimination would fail.
 *
 * Reference: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, chapters 3
 * and 4; Detroux, Renson, Masset and Kerschen, Comput. Methods Appl. Mech. Engrg. 296 (2015), for
 * Hill's matrix.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LOCUS_H
#define HAWSER_RESPONSE_LOCUS_H

#include <complex.h>

#include <hawser/locus.h>

#include "continuation/metric.h"
#include "response/floquet/monodromy.h"

enum { LOCUS_OMEGA = 0, LOCUS_PARAMETER, LOCUS_KAPPA, LOCUS_FIRST };

/* Scalars along a curve whose zeros are special points. */
enum {
	LOCUS_TEST_CUSP = 0, LOCUS_TEST_DEGENERATE, LOCUS_TEST_DOUBLE, LOCUS_TEST_FOLD,
	LOCUS_TEST_DOUBLING, LOCUS_TEST_UNITY, LOCUS_TEST_HALF, LOCUS_TEST_THIRD, LOCUS_TEST_QUARTER,
	LOCUS_TEST_PAIRS, LOCUS_TEST_START,
	LOCUS_TESTS
};

struct hawser__locus {
	enum hawser_event_kind kind;
	const struct hawser_rom_family *family;
	const struct hawser_rom_plane *plane; /* NULL: the first parameter is Omega */
	const struct hawser_rom *rom; /* at the present parameter */
	double time;                  /* unit of time of the model at the start */
	double extent[2];             /* lengths of the ranges of Omega and of the parameter */
	double centre[2];             /* values of the parameters for the derivatives by them */
	double omega;                 /* scaled by the present model's unit of time */
	int harmonic;                 /* of a resonance */
	double *load;                 /* [2][n] its load */
	double kappa;
	int n, most;                  /* coordinates; largest number of harmonics */
	int order, rows, width;       /* harmonics, samples, highest harmonic of the tables */
	int coefficients, size;       /* of y; of z */
	int low, blocks, wide;        /* first m, number of m, rows of H */
	int varying_damping;
	int more;                     /* 1: the model has terms (rom.h). Only then: */
	double *slope, *plus_v, *minus_v; /* [rows][n][n] derivative of the terms by velocities, at the
	                               * orbit and on both sides of it */
	double *resist;               /* [2 width + 1][n][n] series of slope */
	double *velocity, *shifted_v; /* [rows][n] */
	double complex *q_v;          /* [rows][n] as q, of the velocities */
	double complex *kept[3];      /* [rows][n] scratch of the coefficient of a torus */
	double *memory;
	double *basis;                /* [rows][2 width + 1] */
	double *u, *du;               /* [rows][n] */
	double *force, *tangent;      /* [rows][n], [rows][n][n] */
	double *damping;              /* [rows][n][n] */
	double *plus, *minus;         /* [rows][n][n] */
	double *shifted, *square;     /* [rows][n] */
	double *work;
	double *T, *D;                /* [2 width + 1][n][n], the constant twice */
	double *F;                    /* [2 width + 1][n] */
	double *other[2];             /* [2 width + 1][n] */
	double *by[2];                /* [coefficients] dF by Omega and the parameter */
	double *J;                    /* [coefficients][coefficients] column-major */
	double *J_factors;            /* the same, factorised */
	double *M, *rhs;              /* the whole system, column-major */
	double *balance;              /* [size] */
	int orientation;              /* sign of its determinant when it was solved last */
	unsigned char *barred;        /* [n][2] coordinate; even, odd harmonics: stay zero */
	int *pivot, *pivot_M;
	double closeness;             /* distance of the system that M has factorised; INFINITY: none */
	double *R, *x;                /* [wide + 1][wide + 1], [wide + 1]: H of a real kind, real */
	double complex *memory_c;
	double complex *A;            /* [wide + 1][wide + 1] column-major */
	double complex *b, *c;        /* [wide] borders, scaled */
	double complex *v, *w;        /* [wide + 1] scaled */
	double complex *wave;         /* [wide] */
	double complex *exponential;  /* [rows][blocks] exp(i (m + kappa) tau) */
	double complex *vt, *dv, *ddv, *wt, *q; /* [rows][n] at the samples; w with 1/rows */
	double complex *g_y;          /* [coefficients] */
	double complex *T_c, *D_c;    /* [width + 1][n][n] */
	double complex *pair;         /* [2][n][n] */
	double *scale;                /* [wide] */
	double complex g, g_p[2], g_kappa;
	double second;                /* w f''(v, v) */
	double mesh;                  /* relative */
	double size_y;
	struct hawser__monodromy monodromy;
	double *log_modulus, *argument; /* [2n] */
	long solves;
	double spent;                 /* work of responses, s, as counted (hawser_orbit_work) */
	double dense;                 /* additions and multiplications in the factorisations */
	struct hawser_report *report;
};

enum hawser_status hawser__locus_open(struct hawser__locus *locus,
                                      const struct hawser_rom_family *family,
                                      const struct hawser_locus_options *options,
                                      struct hawser_report *report);
void hawser__locus_close(struct hawser__locus *locus);

/* Change the number of harmonics. The borders are lost. */
enum hawser_status hawser__locus_arrange(struct hawser__locus *locus, int order);
static inline int hawser__locus_is_barred(const struct hawser__locus *locus, int coefficient)
{
	return locus->barred[2*(coefficient%locus->n) + (coefficient/locus->n + 1)/2%2];
}
static inline int hawser__locus_size(const struct hawser__locus *locus, int order)
{
	return LOCUS_FIRST + locus->n*(2*order + 1);
}

/* locus_sample.c: make the model at Omega and the parameter the present one. */
enum hawser_status hawser__locus_place(struct hawser__locus *locus, double omega, double parameter);
/* The orbit of z at the samples; forces, tangents and defects F, up to 2 order. */
void hawser__locus_orbit(struct hawser__locus *locus, const double *z);
void hawser__locus_fields(struct hawser__locus *locus, double *F, const double *z, int derive);

/* locus_terms.c: the highest degree of the terms, at least 3; force += and, unless NULL, tangent +=
 * those of the terms at u and du [rows][n], slope = their derivative by velocities; the series of
 * locus->slope; g_y and q_v from both sides at the distance h. Nothing without terms. */
int hawser__locus_degree(const struct hawser_rom *rom);
void hawser__locus_terms(struct hawser__locus *locus, double *tangent, double *slope, const double *u,
                         const double *du);
void hawser__locus_resist(struct hawser__locus *locus);
/* The sum of q_v times the derivative by the phase of the signal y [2 order + 1][n]. */
double complex hawser__locus_through_velocities(const struct hawser__locus *locus, const double *y);
void hawser__locus_by_velocities(struct hawser__locus *locus, double complex factor, double h);

/* locus_hill.c: H for what follows, from the tangents and damping at the samples. */
void hawser__locus_series(struct hawser__locus *locus);
/* H of a torus at kappa, or with `bordered` [H b; c^H 0], in locus->A; scales. Returns its rows. */
int hawser__locus_hill(struct hawser__locus *locus, double kappa, int bordered);
/* The sign of its determinant at kappa 0 or 1/2, and the logarithm of its modulus. */
double hawser__locus_determinant(struct hawser__locus *locus, double kappa, double *sign);
/* J = F_y, with the rows of the unit matrix for what is barred. */
void hawser__locus_jacobian(struct hawser__locus *locus);
/* Solve for v, w, g. 1 where the matrix is singular. */
int hawser__locus_vectors(struct hawser__locus *locus);

/* locus_second.c: the derivatives of g, and F by the parameters. Changes force and tangent. */
enum hawser_status hawser__locus_differentiate(struct hawser__locus *locus, const double *z);
/* The coefficient whose zero is a degenerate bifurcation, or NAN. Besides sign and logarithm of the
 * determinant of F_y; sign 0: not known. */
double hawser__locus_normal_form(struct hawser__locus *locus, double *sign, double *size_log);
/* plus and minus = tangents at u + h x and u - h x, x [rows][n], the real or the imaginary part of vt;
 * with terms plus_v and minus_v too. Returns h, 0 if x is 0. */
double hawser__locus_both_sides(struct hawser__locus *locus, const double *x, int imaginary);
/* The first 2 order + 1 harmonics of a real signal x [rows][n]. */
void hawser__locus_transform(const struct hawser__locus *locus, double *out, const double *x);

/* locus_phase.c: g of resonances, and its derivatives, after F and J. */
enum hawser_status hawser__locus_quadrature(struct hawser__locus *locus, const double *z);
/* G: what of the motion is in phase with the load. Sets locus->load. */
double hawser__locus_in_phase(struct hawser__locus *locus, const double *z);
/* Amplitude, phase, energy, work and damping of z, which is at the samples. */
void hawser__locus_phase(struct hawser__locus *locus, struct hawser_locus_point *point,
                         const double *z);
/* locus->harmonic, and locus->load; a refusal where the load has none. */
enum hawser_status hawser__locus_choose_harmonic(struct hawser__locus *locus, int harmonic,
                                                 struct hawser_report *report);

/* locus_torus.c: the first Lyapunov coefficient, with J_factors; NAN where it has a pole. */
double hawser__locus_lyapunov(struct hawser__locus *locus);

/* locus_system.c: everything at z. *residual is infinite where it cannot be computed. */
enum hawser_status hawser__locus_evaluate(struct hawser__locus *locus, double *residual,
                                          const double *z);
/* The step dz of Newton's method with <row, dz> = last, or with `homogeneous` the vector of the
 * kernel. 1 where it is singular. */
int hawser__locus_solve(struct hawser__locus *locus, double *dz, const double *z, const double *row,
                        int homogeneous, double last);
/* A vector of the kernel with <row, t> > 0, from the last factors where they are close; `side` where
 * the matrix is singular. */
void hawser__locus_tangent(struct hawser__locus *locus, double *t, const double *z, const double *row,
                           const double *side);
/* Borders from v and w; arbitrary ones. */
void hawser__locus_update(struct hawser__locus *locus);
void hawser__locus_borders(struct hawser__locus *locus);
enum hawser_status hawser__locus_multipliers(struct hawser__locus *locus);

/* Of the metric: the orbit relative to its size, the parameters relative to their ranges. */
void hawser__locus_weights(double *weight, const struct hawser__locus *locus, const double *z);

#endif
