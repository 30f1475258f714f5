/* cli/beam/beam_draw.c - pictures of hawser beam.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "cli/model/axis.h"
#include "cli/beam/beam_result.h"
#include "core/report.h"

void cli_beam_label(char *label, size_t size, const struct cli_beam_result *result,
                    const struct cli_beam_variant *v, const char *what)
{
	char value[64] = "";

	if (result->vary)
		cli_axis_value(value, sizeof value, result->vary, v->value);
	snprintf(label, size, "%s%s%s", value, *value && *what ? ", " : "", what);
}

static enum hawser_status draw_sweep(const char *path, const struct cli_beam_result *result,
                                     struct hawser_report *report)
{
	struct hawser__beam_picture picture = {.variants = result->variants};
	struct hawser__beam_curve curve[CLI_BEAM_VARIANTS];

	picture.curve = curve;
	cli_beam_sweep_axes(&picture, result);
	for (int i = 0; i < result->variants; i++) {
		const struct cli_beam_variant *v = &result->variant[i];

		curve[i] = (struct hawser__beam_curve){.sweep = &v->sweep,
			.v_crit = v->limits.v_crit, .v_bif = v->limits.v_bif,
			.per_speed = cli_beam_per_speed(&v->beam)/picture.speed.per,
			.per_re = cli_beam_per_rate(&v->beam)/picture.re.per,
			.per_im = cli_beam_per_rate(&v->beam)/picture.im.per};
		cli_beam_label(curve[i].label, sizeof curve[i].label, result, v, "");
	}
	return hawser__plot_beam_sweep(path, &picture, report);
}

enum hawser_status cli_beam_draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct cli_beam_result *result = context;

	if (result->kind == CLI_BEAM_SWEEP)
		return draw_sweep(path, result, report);
	if (result->kind == CLI_BEAM_BOUNDARY)
		return cli_beam_boundary_draw(path, result, report);
	if (result->kind == CLI_BEAM_MOTION)
		return cli_beam_motion_draw(path, result, report);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
	                    "eigenvalues at one speed are no picture: give a sweep of the speed with --to");
}
