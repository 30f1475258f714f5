/* cli/motion/integrate_result.h - a time response as a table, as JSON and as a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_INTEGRATE_RESULT_H
#define HAWSER_CLI_INTEGRATE_RESULT_H

#include <hawser/lyapunov.h>

#include "cli/frame/view.h"

/* hawser orbit: the periodic motion that the run is. */
struct cli_orbit {
	int label, period;   /* periods of the load in one of the motion */
	const char *kind;    /* of the event, or "" */
	double closure;      /* change of the state over a period of the motion, relative */
	int harmonics;
	int *k;              /* [harmonics] multiples of the frequency of the motion, from 0 */
	double *amplitude;   /* [harmonics][n] of each coordinate, scaled */
	const double *multiplier; /* [2n][2] log modulus, argument; NULL: not known */
	double form, form_error;  /* coefficient of the normal form of an event, SI; NAN: none */
	const char *verdict;      /* "supercritical", ... or "" */
	char formless[512];       /* why there is none, or "" */
};

struct cli_integrate_result {
	const struct cli_orbit *orbit; /* of hawser orbit, else NULL */
	const struct cli_common *common;
	const struct cli_model *model;
	struct hawser_trajectory run;
	double omega, every; /* scaled */
	struct hawser_integrate_options forcing; /* omega, omega_to, begin and until of the run */
	struct hawser_lyapunov lyapunov; /* m 0: not computed */
	struct cli_model_error model_error;
	double *error;       /* [rows] of hawser_integrate_error, or NULL */
	double period;       /* scaled, of the forcing or the first natural frequency */
	int signals, probed; /* probed: displacement components at probes; else coordinates */
	int tensions;        /* 1: the tension at the probes is known */
	double *value, *rate; /* [signals][rows] m and m/s, for a picture or a spectrum only */
	double least, most;  /* N, tension anywhere on the cable at the output times; NAN: not known */
	int least_at;        /* row of the smallest tension */
	int rest;            /* 1: from rest, not from a state that is given */
	int surges;          /* 1: `surge` is known, as the travel speed of a scene changes */
	struct hawser_surge surge; /* the tension with the axial waves of that change */
	int spectrum;        /* 1: the table is the spectrum */
	int failed;          /* 1: the run ended before its time */
	struct hawser_spectrum_window window; /* the last of the equidistant rows */
	int bins;            /* 0: not computed */
	double *frequency;   /* [bins] Hz */
	double *amplitude;   /* [signals][bins] m */
	double folded[2];    /* Hz, m: where the largest line appears that is above the spectrum; 0: none */
	int folds;           /* the signal that has it */
};
/* The error of the model, from the last period of the forcing, unless it is stated already. */
enum hawser_status cli_integrate_judge(struct cli_integrate_result *result,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* integrate_exact.c: replace run, model and error by those of the exact energy, and *choice and *state
 * (of choice->initial, or NULL) by those with which the run began. after: scaled, see
 * cli_integrate_settle; 0: none. Without an answer everything stays, and model->exact says why. */
enum hawser_status cli_integrate_exact(struct cli_integrate_result *result, struct cli_model *model,
                                       struct hawser_integrate_options *choice, double **state,
                                       double after, struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_integrate_fill(struct cli_integrate_result *result,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* "y_mid" or "u_1", the name of signal k. */
enum { CLI_NAME_SIZE = 64 };
void cli_signal_name(char name[CLI_NAME_SIZE], const struct cli_integrate_result *result, int k);
/* Signal k in that row, scaled; rate: its derivative by time. */
double cli_integrate_signal(const struct cli_integrate_result *result, int k, size_t row, int rate);
/* N, at probe p. */
double cli_integrate_tension(const struct cli_integrate_result *result, int p, size_t row);
const char *cli_integrate_end(const void *result); /* "complete" */
/* integrate_exponents.c: run from choice->begin to `after`; the state there replaces *state, and the
 * rest of the run begins with it. */
enum hawser_status cli_integrate_settle(double **state, struct hawser_integrate_options *choice,
                                        double after, const struct hawser_rom *rom,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* Lyapunov exponents of the rows of the run, or of its second half. */
enum hawser_status cli_integrate_exponents(struct cli_integrate_result *result, int half,
                                           const struct hawser_integrate_options *choice,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
/* 1 if the rows are a stroboscopic section: a whole number of periods apart. */
int cli_integrate_section(const struct cli_integrate_result *result);
void cli_integrate_comments(struct hawser__table *table, const void *result);
void cli_integrate_free(struct cli_integrate_result *result);
/* As cli_frf_slack. */
int cli_integrate_slack(char *text, size_t size, const struct cli_integrate_result *result);
/* The same of ends that move when a run from rest begins. */
int cli_integrate_moves(char *text, size_t size, const struct cli_integrate_result *result);
/* Say what is wrong with it, at this forcing frequency (scaled). */
void cli_integrate_warn(struct cli_model *model, double omega,
                        const struct cli_integrate_result *result);
/* The same of a wind: nothing moves, or too fast for the force to the third order. */
int cli_integrate_wind(char *text, size_t size, const struct cli_integrate_result *result);
/* surge.c: axial waves if the travel speed changes and the model is not of full order, comments and a
 * warning. */
enum hawser_status cli_surge_look(struct cli_integrate_result *result,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
int cli_surge_warning(char *text, size_t size, const struct cli_integrate_result *result);
void cli_surge_comments(struct hawser__table *table, const struct cli_integrate_result *result);
extern const struct hawser__field cli_surge_field[]; /* of a struct hawser_surge */
extern const struct cli_showing cli_integrate_showing;
struct hawser__axis cli_integrate_axis(const struct cli_integrate_result *result);
enum hawser_status cli_integrate_draw(const char *path, const void *result,
                                      struct hawser_report *report);

#endif
