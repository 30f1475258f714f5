/* hawser/lyapunov.h - Lyapunov exponents of a motion of a reduced model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_LYAPUNOV_H
#define HAWSER_LYAPUNOV_H

#include <hawser/progress.h>
#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The fewest periods over which exponents are averaged. */
#define HAWSER_LYAPUNOV_FEWEST 100

struct hawser_lyapunov_options {
	double omega;   /* scaled forcing frequency, > 0; of a model without forcing any frequency, which
	                 * says how long a "period" is */
	double begin;   /* scaled time of the initial state */
	const double *initial; /* [2n] u then u', on the motion: transients have decayed */
	long periods;   /* HAWSER_LYAPUNOV_FEWEST or more. The first tenth lets the directions settle, the
	                 * others are averaged */
	double rtol;    /* largest estimated error of a period, relative to the largest state so far;
	                 * 0: 1e-10 */
	struct hawser_progress progress; /* called after each period */
};

/* Exponents in the unit 1/(scaled time), from the largest. Their sum is the mean divergence of the
 * flow. */
struct hawser_lyapunov {
	int m;            /* 2n */
	double *exponent; /* [m] */
	double *error;    /* [m] statistical error and that of the integration */
	double *scatter;  /* [m] the statistical part: 95 % range of the mean, from eight blocks */
	long averaged;    /* number of periods in the average */
	int steps;        /* of integration, per period at the end */
	int interrupted;  /* 1: nothing is known */
};

/* Integrate the variational equations along the motion. Release with hawser_lyapunov_clear, whatever
 * the status: HAWSER_ERR_ARGUMENT (options; a model with a ramp or a history of forces, or of first
 * order), HAWSER_ERR_NAN (the motion escapes), HAWSER_ERR_CONVERGENCE (too many steps a period),
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_lyapunov_find(struct hawser_lyapunov *result, const struct hawser_rom *rom,
                                        const struct hawser_lyapunov_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_lyapunov_clear(struct hawser_lyapunov *result);

#ifdef __cplusplus
}
#endif
#endif
