/* study/identify/identify.h - the fit of measured frequencies, between its files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_IDENTIFY_H
#define HAWSER_STUDY_IDENTIFY_H

#include <hawser/identify.h>
#include <hawser/status.h>

/* A mode by its number in its plane, from 1; number 0: none. */
struct hawser__mate {
	int plane, number;
};

struct hawser__fit {
	const struct hawser_scene *scene;
	const struct hawser_measured *measured; /* [count] */
	int count;
	const char *const *key; /* [keys] */
	int keys;
	double start[HAWSER_IDENTIFY_KEYS]; /* value in the scene; parameters are relative to it */
	int logarithmic[HAWSER_IDENTIFY_KEYS];
	double *weight;            /* [count] of the logarithms of the frequencies */
	struct hawser__mate *mate; /* [count] mode of each measurement */
	int modes, basis;          /* number of modes that are computed, and functions per component */
	int evaluations;
	struct hawser_report report; /* of the last evaluation that failed */
};

/* A fit that has ended. */
struct hawser__identify_end {
	double x[HAWSER_IDENTIFY_KEYS], chi2;
	int skipped;
	double cost; /* chi2 and what the skipped modes add */
};

/* identify_modes.c */

/* Value in SI of parameter k, whose variable is x. */
double hawser__fit_value(const struct hawser__fit *fit, int k, double x);
/* The scene with the variables x [keys]; not to be cleared. */
enum hawser_status hawser__fit_scene(struct hawser_scene *scene, const struct hawser__fit *fit,
                                     const double *x, struct hawser_report *report);
/* Modes at x [keys]; the first call chooses the basis. Release with hawser_modes_clear. */
enum hawser_status hawser__fit_modes(struct hawser_modes *modes, struct hawser__fit *fit,
                                     const double *x, struct hawser_report *report);
/* The mode, or NULL if it is not among them. */
const struct hawser_mode *hawser__fit_find(const struct hawser_modes *modes,
                                           struct hawser__mate mate);
/* r [count], weighted residuals at x [keys]. */
enum hawser_status hawser__fit_residuals(double *r, struct hawser__fit *fit, const double *x,
                                         struct hawser_report *report);
/* J [keys + 1][count]: their derivatives by central differences; the last row is work space. */
enum hawser_status hawser__fit_jacobian(double *J, struct hawser__fit *fit, const double *x,
                                        struct hawser_report *report);

/* identify_match.c */

/* Assign modes to all measurements, into mate [count], as if computed frequencies were multiplied by
 * `scale`. *skipped: number of modes left out. HAWSER_ERR_ARGUMENT: there are fewer modes. */
enum hawser_status hawser__fit_match(struct hawser__mate *mate, int *skipped,
                                     const struct hawser__fit *fit,
                                     const struct hawser_modes *modes, double scale,
                                     struct hawser_report *report);
/* doubtful, doubt, other_plane and other_number of the result, at the fitted values. */
void hawser__fit_doubt(struct hawser_identified *identified, const struct hawser__fit *fit,
                       const struct hawser_modes *modes);
/* 1 if the mode of measurement i is given. */
int hawser__fit_given(const struct hawser_measured *measured);

/* identify_result.c: everything of *identified but `margin`, from the fit that has ended. */
enum hawser_status hawser__fit_finish(struct hawser_identified *identified, struct hawser__fit *fit,
                                      const struct hawser__identify_end *best, double confidence,
                                      struct hawser_report *report);

/* --- least_squares.c: nonlinear least squares by Levenberg and Marquardt's method --- */

struct hawser__least_squares {
	int unknowns, count; /* count >= unknowns */
	/* Residuals r [count] at x [unknowns] or, with r NULL, their derivatives J [unknowns][count].
	 * HAWSER_ERR_MEMORY ends the fit; after another status from residuals x is not accepted. */
	enum hawser_status (*residuals)(void *context, double *r, double *J, const double *x);
	void *context;
	double least_step; /* the fit has converged if a step changes no unknown by more than this */
	int steps;         /* largest number */
};

/* Improve x [unknowns] from where it is. *sum: the sum of squares there. *steps: those made; if it is
 * problem->steps, the fit has not converged. The status is that of `residuals` at the beginning, of
 * the derivatives, or HAWSER_ERR_MEMORY. */
enum hawser_status hawser__least_squares(double *x, double *sum, int *steps,
                                         const struct hawser__least_squares *problem);

#endif
