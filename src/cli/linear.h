/* cli/linear.h - modes of a scene, at rest or travelling: what a comparison of methods asks of
 * either.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_LINEAR_H
#define HAWSER_CLI_LINEAR_H

#include <hawser/hawser.h>

struct cli_linear {
	int travels; /* which of the two */
	struct hawser_modes resting;
	struct hawser_complex_modes travelling;
};

struct cli_linear_mode {
	double omega, rad_s, residual; /* scaled, and in rad/s */
	enum hawser_plane plane;
};

/* The i-th method's name for such a cable, NULL after the last. */
const char *cli_linear_row(const struct hawser_statics *statics, int i);
enum hawser_status cli_linear_solve(struct cli_linear *modes, const struct hawser_statics *statics,
                                    const struct hawser_modes_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* error [count of modes]. */
enum hawser_status cli_linear_compare(struct hawser_modes_error *error,
                                      const struct cli_linear *modes,
                                      const struct cli_linear *reference,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
struct cli_linear_mode cli_linear_mode(const struct cli_linear *modes, int k);
int cli_linear_count(const struct cli_linear *modes);
int cli_linear_basis(const struct cli_linear *modes);
const char *cli_linear_method(const struct cli_linear *modes);
void cli_linear_clear(struct cli_linear *modes);

#endif
