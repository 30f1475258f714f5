/* cli/linear.c - modes of a scene, at rest or travelling.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "cli/linear.h"

const char *cli_linear_row(const struct hawser_statics *statics, int i)
{
	int count;

	if (statics->motion.nu == 0.0) {
		const struct hawser_modes_method *row = hawser_modes_methods(&count);

		return i < count ? row[i].name : NULL;
	} else {
		const struct hawser_complex_modes_method *row = hawser_complex_modes_methods(&count);

		return i < count ? row[i].name : NULL;
	}
}

enum hawser_status cli_linear_solve(struct cli_linear *modes, const struct hawser_statics *statics,
                                    const struct hawser_modes_options *options,
                                    struct hawser_report *report)
{
	*modes = (struct cli_linear){.travels = statics->motion.nu != 0.0};
	return modes->travels ? hawser_complex_modes_solve(&modes->travelling, statics, options, report)
	                      : hawser_modes_solve(&modes->resting, statics, options, report);
}

enum hawser_status cli_linear_compare(struct hawser_modes_error *error,
                                      const struct cli_linear *modes,
                                      const struct cli_linear *reference, struct hawser_report *report)
{
	return modes->travels
	           ? hawser_complex_modes_compare(error, &modes->travelling, &reference->travelling, report)
	           : hawser_modes_compare(error, &modes->resting, &reference->resting, report);
}

struct cli_linear_mode cli_linear_mode(const struct cli_linear *modes, int k)
{
	struct cli_linear_mode mode;

	if (modes->travels) {
		const struct hawser_complex_mode *from = &modes->travelling.mode[k];

		mode = (struct cli_linear_mode){from->im, from->im/modes->travelling.time_unit, from->residual,
		                                from->plane};
	} else {
		const struct hawser_mode *from = &modes->resting.mode[k];

		mode = (struct cli_linear_mode){from->omega, from->omega/modes->resting.time_unit,
		                                from->residual, from->plane};
	}
	return mode;
}

int cli_linear_count(const struct cli_linear *modes)
{
	return modes->travels ? modes->travelling.n : modes->resting.n;
}

int cli_linear_basis(const struct cli_linear *modes)
{
	return modes->travels ? modes->travelling.basis : modes->resting.basis;
}

const char *cli_linear_method(const struct cli_linear *modes)
{
	return modes->travels ? modes->travelling.method : modes->resting.method;
}

void cli_linear_clear(struct cli_linear *modes)
{
	hawser_modes_clear(&modes->resting);
	hawser_complex_modes_clear(&modes->travelling);
}
