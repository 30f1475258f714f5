/* cli/model/fixed.h - the error of a model with a given number of modes: an estimate, what is
 * said of it, and its members in JSON (cli_fixed_field in view.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FIXED_H
#define HAWSER_CLI_FIXED_H

#include <hawser/accuracy.h>

struct cli_common;
struct cli_frf_result;
struct cli_model;
struct hawser__table;

struct cli_model_error {
	int stated;        /* 1: it, or why it is not known, belongs to the result */
	int compared;      /* 1: by the motion of a model of another size, else mode by mode */
	double per_omega;  /* rad/s per scaled frequency */
	double to;         /* scaled: largest frequency of the command */
	int timed;         /* 1: with the time that the estimate took */
	const char *about, *advice; /* "folds and peaks"; what may be closer */
	struct hawser_accuracy_fixed fixed; /* estimated: NAN if it is not known */
	int corrected;     /* 1: `estimated` is by correction in the structure (certificate.h), and */
	double before;     /* it was this by the parts of `fixed`; NAN: not known */
	char unknown[640]; /* why: a report's message */
	int unweighed;     /* 1: since no mode is weighed in such a scene */
};

extern const char cli_fixed_advice[]; /* of spans */

/* The exact energy in place of modes that are not good enough (exact.h). */
struct cli_exact {
	int modes;        /* asked for */
	int functions;    /* per component of the model that took their place; 0: none */
	int coordinates;  /* of that model */
	double before;    /* error with the modes; NAN: no answer */
	double beyond;    /* the part that no number of them makes up for */
	double until;     /* rad/s, where its response ends before the range asked for; 0: nowhere */
	char rest[640];   /* why */
	char failed[640]; /* why there is none though it was called for; "": it was not */
};

/* Not known yet; about: "folds and peaks". */
struct cli_model_error cli_fixed_unknown(const struct cli_model *model, const char *about, int timed);
/* Does nothing for the first branch with modes: auto, and where it is stated. Status:
 * HAWSER_ERR_MEMORY. */
enum hawser_status cli_fixed_estimate(struct cli_frf_result *result,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same of a response and of its other branches, with their peaks as they are located last. */
enum hawser_status cli_fixed_conclude(struct cli_frf_result *result, struct cli_frf_result *other,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Relative tolerance of the peaks of a response with such an error; exact: of the exact energy. */
double cli_fixed_tolerance(const struct cli_model_error *error, int exact);
/* The same for one motion of a model of a scene; of a ropeway, for its steady motion. */
enum hawser_status cli_fixed_once(struct cli_model_error *error, const struct cli_model *model,
                                  const struct cli_common *common,
                                  const struct hawser_accuracy_motion *motion,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* number: of the branch; from the second on it is named. */
void cli_fixed_comments(struct hawser__table *table, const struct cli_model_error *error, int branch);
/* Says on standard error that the error is more than a tenth. */
void cli_fixed_warn(const struct cli_model_error *error);
/* The same of the branch of a response with the largest error. */
/* The branch with the largest error that is warned of; NULL: none is. */
void cli_fixed_warn_worst(const struct cli_frf_result *result);

/* Largest |u_j| [n] of the coordinates u[rows][stride], the first n of each row, and of `reached`,
 * which is NULL or what this returned before; NULL if the model has no ranges. */
double *cli_range_reach(double *reached, const struct cli_model *model, const double *u, int rows,
                        int stride);
/* Says on standard error that a coordinate moves beyond its range (law.h), and frees `reached`. The
 * ranges of a model of a scene are sought up to there. */
void cli_range_warn(struct cli_model *model, double *reached);
/* The same for the curves of a response. */
void cli_range_warn_frf(struct cli_model *model, const struct cli_frf_result *result);

#endif
