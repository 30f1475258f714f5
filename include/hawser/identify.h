/* hawser/identify.h - parameters of a scene from measured natural frequencies.
 *
 * Weighted least squares of the logarithms of the frequencies: the residual of a measurement is
 * log(computed/measured), divided by the standard deviation of log(measured). Positive parameters
 * are fitted by their logarithms, so that they stay positive.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_IDENTIFY_H
#define HAWSER_IDENTIFY_H

#include <hawser/modes.h>
#include <hawser/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_IDENTIFY_KEYS = 8 }; /* largest number of free parameters */

/* Measurements whose mode is not known are assigned in ascending order to modes, with the least sum of
 * chi2 and this number for each mode that is left out: 2 log(20), as if one mode of twenty were
 * missed. Where no deviations are given, HAWSER_IDENTIFY_NOMINAL is taken for this. */
#define HAWSER_IDENTIFY_SKIP 6.0
#define HAWSER_IDENTIFY_NOMINAL 0.01

/* A measured natural frequency and what is known of its mode. */
struct hawser_measured {
	double omega;     /* rad/s */
	double deviation; /* rad/s, its standard deviation; 0: not known. Either all measurements have
	                   * one or none has */
	int plane;        /* enum hawser_plane, or -1: not known */
	int place;        /* number of the mode by frequency, from 1, both planes together; 0: not
	                   * known */
	int number;       /* the same in its plane, which must be known; 0: not known */
};

struct hawser_identify_options {
	const char *const *key; /* [keys] paths of the free parameters, such as "tension.T0" */
	int keys;
	double confidence; /* of the intervals; 0: 0.95 */
};
/* Replace zeros by the defaults. */
void hawser_identify_settle(struct hawser_identify_options *options);

/* A fitted parameter, in SI. */
struct hawser_identified_key {
	const char *key;        /* of the options */
	double start, value;    /* in the scene, and fitted */
	double low, high;       /* confidence interval; NAN without degrees of freedom */
	double relative;        /* half of the interval's width, relative to the value; NAN */
	int logarithmic;        /* 1: fitted by its logarithm */
};

/* A measurement and the mode that it belongs to. */
struct hawser_identified_mode {
	double measured, computed; /* rad/s */
	double before;     /* rad/s, the frequency of this mode in the scene as given; NAN if it has no
	                    * such mode */
	double difference; /* computed/measured - 1 */
	double deviation;  /* of log(measured): as given, or as estimated from the residuals; NAN */
	enum hawser_plane plane;
	int place, number; /* as in struct hawser_mode */
	int matched;       /* 1: the mode was found by its frequency; 0: it was given */
};

struct hawser_identified {
	int keys, count;
	struct hawser_identified_key key[HAWSER_IDENTIFY_KEYS]; /* [keys] */
	struct hawser_identified_mode *mode;                    /* [count] in the order given */
	double correlation[HAWSER_IDENTIFY_KEYS][HAWSER_IDENTIFY_KEYS]; /* [keys][keys] of the fitted
	                                                                 * parameters */
	int freedom;        /* degrees of freedom, count - keys */
	double spread;      /* root mean square of log(computed/measured), by the degrees of freedom;
	                     * NAN if there are none */
	double chi2;        /* sum of squares of the weighted residuals; NAN without deviations */
	double probability; /* of a larger chi2 if scene and deviations are right; NAN */
	double weakness;    /* standard deviation (relative) of the combination of parameters that is known
	                     * worst */
	int skipped;        /* modes below the highest measured one to which no measurement belongs */
	double margin;      /* by which the next best assignment of modes is worse, in chi2, to which
	                     * HAWSER_IDENTIFY_SKIP is added for each mode skipped; INFINITY: there is
	                     * no other */
	int doubtful;       /* index of the measurement that could most easily belong to another mode,
	                     * with all others as they are; -1: none */
	double doubt;       /* by how much chi2 would be larger then, at the fitted values; INFINITY */
	enum hawser_plane other_plane; /* that mode */
	int other_number;
	int evaluations;    /* number of computations of modes */
	struct hawser_scene scene; /* with the fitted values; a copy made by assignment, not to be
	                            * cleared */
};

/* Fit the parameters to measured [count]. *identified is overwritten; release it with _clear.
 * HAWSER_ERR_ARGUMENT: fewer measurements than parameters, a measurement that is not positive, a key
 * that does not exist, is 0 or does not change the frequencies, parameters that only change them
 * together. HAWSER_ERR_NO_SOLUTION: the scene has no equilibrium at the start. HAWSER_ERR_CONVERGENCE
 * and HAWSER_ERR_MEMORY. */
enum hawser_status hawser_identify(struct hawser_identified *identified,
                                   const struct hawser_scene *scene,
                                   const struct hawser_measured *measured, int count,
                                   const struct hawser_identify_options *options,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_identified_clear(struct hawser_identified *identified);

#ifdef __cplusplus
}
#endif
#endif
