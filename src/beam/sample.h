/* beam/sample.h - the eigenvalues of a beam at one speed, sorted into pairs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_SAMPLE_H
#define HAWSER_BEAM_SAMPLE_H

#include <hawser/beam.h>

/* --- spectrum.c: eigenvalues with right and left vectors, and properties of its equation --- */

/* As hawser_beam_eigenvalues, with the left vectors in left [count][2][n]; left may be NULL. */
enum hawser_status hawser__beam_eigen(struct hawser_beam_eigenvalue *value, double *vector,
                                      double *left, int *found,
                                      const struct hawser_beam_integrals *integrals,
                                      const struct hawser_beam *beam, int count,
                                      struct hawser_report *report);

/* HAWSER_ERR_ARGUMENT if a quantity of the beam is out of its range. */
enum hawser_status hawser__beam_check(const struct hawser_beam *beam, struct hawser_report *report);

/* The first frequency of a level beam at rest with simple ends: the scale of the lowest
 * frequencies. */
double hawser__beam_rest_frequency(const struct hawser_beam *beam);

/* 1: the flux of rotary momentum through the supports is not balanced (simple ends, free
 * moments). */
int hawser__beam_flux(const struct hawser_beam *beam);

/* 1: C is skew-symmetric and K symmetric. */
int hawser__beam_gyroscopic(const struct hawser_beam *beam);

/* A conjugate pair, or two real eigenvalues that come from a conjugate pair or may become one. */
struct hawser__beam_pair {
	double re[2], im;    /* im > 0: conjugate, re[0] = re[1]; im = 0: real, re[0] >= re[1] */
	int first, second;   /* indices into value, right and left of the sample */
	double slope_re, slope_im; /* derivative of the first eigenvalue with respect to the speed */
	double residual, condition; /* maximum over the two eigenvalues */
	double growth;       /* re[0] minus the round-off threshold; the pair grows if it is positive */
	int energy;          /* gyroscopic system: sign of the energy of the mode; otherwise 0 */
	int growing;         /* 1: growth > 0 */
};

struct hawser__beam_sample {
	double speed;
	int n, found, pairs;  /* pairs are sorted by modulus */
	int growing;          /* number of growing pairs among the first `watched` */
	int real;             /* number of real pairs among the first `watched` */
	int inserted;         /* 1: added by the refinement of a sweep */
	struct hawser_beam_eigenvalue *value; /* [found] */
	double *right, *left; /* [found][2][n] */
	struct hawser__beam_pair *pair; /* [pairs] */
};

/* Solve the eigenvalue problem at `speed` (beam->speed is ignored). The sample has at least
 * `watched` pairs, or all pairs if the discretisation has fewer. */
enum hawser_status hawser__beam_sample(struct hawser__beam_sample *sample,
                                       const struct hawser_beam_integrals *integrals,
                                       const struct hawser_beam *beam, double speed, int watched,
                                       struct hawser_report *report);
void hawser__beam_sample_clear(struct hawser__beam_sample *sample);

/* Correlation of the pairs of two samples: |y_a* [(l_a + l_b) M + C] x_b|^2, each row divided by
 * its sum, in share [a->pairs][b->pairs]. M and C are those at the mean of the two speeds. */
enum hawser_status hawser__beam_correlate(double *share, const struct hawser__beam_sample *a,
                                          const struct hawser__beam_sample *b,
                                          const struct hawser_beam_integrals *integrals,
                                          const struct hawser_beam *beam,
                                          struct hawser_report *report);

/* --- change.c: the speed at which the number of growing pairs, or of real pairs, changes --- */

enum hawser__beam_counted { HAWSER__BEAM_GROWING, HAWSER__BEAM_REAL };

/* Solves the eigenvalue problem at a speed; `watched` as in hawser__beam_sample. */
struct hawser__beam_solver {
	enum hawser_status (*solve)(struct hawser__beam_sample *sample, void *context, double speed,
	                            struct hawser_report *report);
	void *context;
	int watched;
};

/* A located change. */
struct hawser__beam_change {
	double speed;        /* middle of the bracket */
	double beyond;       /* end of the bracket at which the number has changed */
	int before, after;   /* numbers at the two ends */
	double im;           /* at `beyond`, imaginary part of the growing pair of smallest real part;
	                      * 0: the pair is real, or no pair grows */
};

/* Locate a change between the speeds of `a` and `b`, whose numbers must differ, in a bracket of
 * relative width 1e-13. Returns the status of `solve` if that fails. */
enum hawser_status hawser__beam_change(struct hawser__beam_change *change,
                                       const struct hawser__beam_solver *solver,
                                       const struct hawser__beam_sample *a,
                                       const struct hawser__beam_sample *b,
                                       enum hawser__beam_counted counted,
                                       struct hawser_report *report);

/* --- integrals.c: rows of the table of discretisations, and the memory of their integrals --- */

extern const struct hawser_beam_method hawser__beam_legendre, hawser__beam_sine, hawser__beam_hermite;

/* Allocate the integrals of n functions, all zero. */
enum hawser_status hawser__beam_integrals_init(struct hawser_beam_integrals *integrals, int n,
                                               int band, struct hawser_report *report);

#endif
