/* cli/model/exact.h - a response with the exact energy, where the reduced model is not good enough.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_EXACT_H
#define HAWSER_CLI_EXACT_H

#include "cli/frame/cli.h"

/* Seconds of processor time, as counted (hawser_orbit_work), that nobody has to ask for: of a curve of
 * modes, and of a search for further branches; chosen. */
#define CLI_BEARABLE 15.0
/* The same of a search for bifurcations: less with a model that may be off by more than 100 %; 0, no
 * limit, of the exact energy. */
double cli_exact_allowed(const struct cli_model *model);
/* Says on standard error that one ended there. */
void cli_exact_costly(const struct cli_model *model, int costly);

/* Whether model.energy: auto calls for it: a span of condensed modes with this error, or (NULL) one
 * whose modes give no answer. */
int cli_exact_calls(const struct cli_model *model, const struct cli_model_error *error);

/* Whether it called for it, got none, and the modes may be off by more than 100 %. */
int cli_exact_failed(const struct cli_model *model, const struct cli_model_error *error);

/* The curve of hawser_frf_trace. Where its modes are not good enough or fail, curve, model and error
 * are replaced by those of the exact energy, and the options by those with which it was traced; the
 * scene then has the keys model.energy and model.basis that give this model. A curve that takes long is
 * judged while it is traced. step: 1: the longest step of the options is the user's. If there is no
 * such response, that of the modes stays, and model->exact says why. The status of its trace if that
 * failed and is not replaced; HAWSER_ERR_MEMORY. */
enum hawser_status cli_exact_trace(struct hawser_frf *frf, struct hawser_frf_options *options,
                                   struct cli_model *model, struct cli_frf_result *result, int step,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* For commands that do not trace that response: model->error becomes the error of the modes in the
 * response over the range (scaled), and where they are not good enough, the model becomes that of the
 * exact energy, if two of its bases agree there. after: the time of the command, over that of the
 * curve with long steps that chooses a basis; below 0: the error alone. Does nothing for other
 * models, or where nothing drives them. */
enum hawser_status cli_exact_range(struct cli_model *model, double from, double to, double after,
                                   const struct cli_common *common,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for a plane of two parameters, of a span at rest: by the responses of the scene itself over
 * its frequencies. The scene then has the keys of the exact energy. n: of cli_model_load. */
struct cli_plane {
	const char *key[2];
	double from[2], to[2], omega; /* rad/s */
	int rows; /* responses that are followed; 0: the error alone */
};
enum hawser_status cli_exact_plane(const struct cli_plane *plane, struct cli_model *model, int n,
                                   const struct cli_common *common,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_exact_range_comments(struct hawser__table *table, const struct cli_model *model);
void cli_exact_range_warn(const struct cli_model *model);
/* Says on standard error why the exact energy was not taken where it was called for. */
void cli_exact_warn(const struct cli_model *model);
/* What was done, and why. */
void cli_exact_comment(struct hawser__table *table, const struct cli_model *model);

#endif
