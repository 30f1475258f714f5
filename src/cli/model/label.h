/* cli/model/label.h - labels of a frequency response, and runs that begin at one: FILE#LABEL.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_LABEL_H
#define HAWSER_CLI_LABEL_H

#include "cli/curves/frf_over.h"
#include "cli/frame/cli.h"

enum { CLI_LABEL_LAST = -1 };

/* A motion of an earlier result, in the present model's scale. */
struct cli_label {
	double *state;  /* [2n] u then u' at the start of a period */
	double omega;   /* frequency of the load, or of a cycle; 0: an equilibrium */
	double parameter, anchor; /* of a result with --over: its value there; at the start of that curve */
	int number, period; /* label, or CLI_LABEL_LAST; periods of the load in one of the motion */
	int direction;  /* of the last point of a curve: 1: the parameter increases, -1; else 0 */
	char kind[24];  /* of an event; "" of a point */
	char over[96];  /* key of that result's --over, or "" */
	const char *option; /* by which it was given */
	double least;   /* least tension, N; NAN: not known */
};

/* Label the branches of a result, one after another; the points by its label_every. */
void cli_label_all(struct cli_frf_result *result);
/* Store a whole number, 0 or more, as the functions of cli.h do. */
enum hawser_status cli_store_every(void *field, const struct cli_option *option,
                                   const char *const *values, struct hawser_report *report);

/* Whether the motions have the period of the model, not a multiple. */
int cli_label_plain(const struct hawser_frf *frf, const struct cli_model *model);

/* Split FILE#LABEL, into path [size]. Returns the label, or 0 if the text has none. */
int cli_label_split(char *path, size_t size, const char *text);

/* Read text, which is FILE#LABEL, given with `option`, or FILE for its last point (option continue);
 * the result must be of this model, but for the value of the key `over` (or NULL). Release by
 * cli_label_clear. HAWSER_ERR_ARGUMENT. */
enum hawser_status cli_label_open(struct cli_label *label, const char *option, const char *text,
                                  const char *over, const struct cli_model *model,
                                  const struct cli_common *common,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_label_clear(struct cli_label *label);
/* The file, in scene [size], of the scene or model from which the result in text, FILE#LABEL, was
 * computed, and its model.modes (0: not known); *result: that result, to be released by json_decref.
 * HAWSER_ERR_ARGUMENT: there is none. */
enum hawser_status cli_label_scene(char *scene, size_t size, int *modes, json_t **result,
                                   const char *text, struct hawser_report *report) HAWSER_MUST_CHECK;
/* KEY=VALUE in set [size], of --over at the label of text, FILE#LABEL; 0: the result is not over a key
 * of the scene or model, or has no such label. */
int cli_label_value(char *set, size_t size, const json_t *result, const char *text);

/* The value of a key at the motion: Omega, in the unit of a map's axis, a factor, or a key of the scene
 * or model. NAN: not known. */
double cli_label_at(const struct cli_label *label, const char *key, const struct cli_model *model);

/* Set the first orbit of a trace. `along` [2n], the caller's, is used at a fold.
 * HAWSER_ERR_ARGUMENT: no curve begins there. */
enum hawser_status cli_label_begin(struct hawser_frf_options *choice, double *along,
                                   const struct cli_label *label, const struct cli_over *over,
                                   const struct cli_model *model, const char *text,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* Check that the first orbit of the trace is that of the label. */
enum hawser_status cli_label_kept(const struct cli_label *label, const struct hawser_frf *frf,
                                  const char *text, struct hawser_report *report) HAWSER_MUST_CHECK;

/* Where a result (TEXT: FILE or FILE#LABEL, or NULL) is of the exact energy and the scene leaves the
 * energy open, make the model of the result: its states are of that one. */
enum hawser_status cli_label_exact(struct cli_model *model, const char *text,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
