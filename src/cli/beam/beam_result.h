/* cli/beam/beam_result.h - results of hawser beam as tables, JSON and pictures.
 *
 * A result is a list of variants of the scene's beam, which differ in the key of --vary. Without
 * --vary there is one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_BEAM_RESULT_H
#define HAWSER_CLI_BEAM_RESULT_H

#include "cli/frame/cli.h"

enum { CLI_BEAM_VARIANTS = 8 };

/* The options of the command. */
enum cli_beam_kind { CLI_BEAM_EIGENVALUES = 0, CLI_BEAM_SWEEP, CLI_BEAM_BOUNDARY, CLI_BEAM_MOTION };

struct cli_beam_variant {
	double value; /* value of the varied key */
	struct hawser_scene scene; /* a shallow copy of the scene with that value; not to be cleared */
	struct hawser_beam beam;
	int size;
	double error; /* relative error of the discretisation */
	struct hawser_beam_integrals integrals;
	struct hawser_beam_eigenvalue *eigenvalue; /* [found] eigenvalues at the scene's speed */
	int found;
	struct hawser_beam_limits limits;
	struct hawser_beam_sweep sweep;
	struct hawser_beam_motion motion;
	struct hawser_beam_boundary boundary[2]; /* boundaries of v_crit, and of v_bif if requested */
};

struct cli_beam_result {
	const struct cli_common *common;
	struct hawser_scene scene;
	const struct hawser_beam_method *method;
	enum cli_beam_kind kind;
	const char *vary;     /* key, or NULL */
	const char *boundary; /* key of a boundary */
	int variants, n;   /* n: modes */
	struct cli_beam_variant variant[CLI_BEAM_VARIANTS];
	char warning[CLI_WARNING_SIZE]; /* or "" */
};

/* Factors to SI, 1 without dimensions: of speeds and of eigenvalues. */
double cli_beam_per_speed(const struct hawser_beam *beam);
double cli_beam_per_rate(const struct hawser_beam *beam);

extern const struct cli_showing cli_beam_showing;
void cli_beam_comments(struct hawser__table *table, const void *of);
enum hawser_status cli_beam_draw(const char *path, const void *result, struct hawser_report *report);

void cli_beam_boundary_comments(struct hawser__table *table,
                                const struct cli_beam_result *result);
enum hawser_status cli_beam_boundary_draw(const char *path, const struct cli_beam_result *result,
                                          struct hawser_report *report);

/* Read a shape from a file into the options: lines of x (0 to 1, equidistant or not), y and dy/dt,
 * as fractions of the length or in m and m/s. The caller frees *shape. */
enum hawser_status cli_beam_shape(double **shape, struct hawser_beam_motion_options *options,
                                  const char *path, const struct hawser_beam *beam,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_beam_motion_comments(struct hawser__table *table, const struct cli_beam_result *result);
enum hawser_status cli_beam_motion_draw(const char *path, const struct cli_beam_result *result,
                                        struct hawser_report *report);
/* Largest difference between dE/dt and the sum of the power terms, relative to the largest of these
 * terms. */
double cli_beam_unbalanced(const struct hawser_beam_motion *motion);
/* Growth rate in the last fifth of the motion (scaled), from the largest deflections. */
double cli_beam_growth(const struct hawser_beam_motion *motion);

/* Titles of axes. */
enum { CLI_BEAM_SPEED, CLI_BEAM_RE, CLI_BEAM_IM, CLI_BEAM_AXES };
void cli_beam_sweep_axes(struct hawser__axis axis[CLI_BEAM_AXES], const struct cli_beam_result *result);
enum { CLI_BEAM_TIME, CLI_BEAM_Y, CLI_BEAM_RATE };
void cli_beam_motion_axes(struct hawser__axis axis[CLI_BEAM_AXES],
                          const struct cli_beam_result *result);

/* "ρ = 10, v_crit", in gnuplot's markup; `what` may be "". */
void cli_beam_label(char *label, size_t size, const struct cli_beam_result *result,
                    const struct cli_beam_variant *v, const char *what);

/* Print the scaled beam and the scene's values. */
void cli_beam_print_scales(FILE *stream, const struct hawser_scene *scene,
                           const struct hawser_beam *beam);
/* If the lower end of the beam is slack, write a warning and return 1; else return 0. */
int cli_beam_slack(char *text, size_t size, const struct hawser_beam *beam);

#endif
