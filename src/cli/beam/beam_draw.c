/* cli/beam/beam_draw.c - pictures of hawser beam.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/model/axis.h"
#include "cli/beam/beam_result.h"
#include "output/drawing/figure.h"

void cli_beam_label(char *label, size_t size, const struct cli_beam_result *result,
                    const struct cli_beam_variant *v, const char *what)
{
	char value[64] = "";

	if (result->vary)
		cli_axis_value(value, sizeof value, result->vary, v->value);
	snprintf(label, size, "%s%s%s", value, *value && *what ? ", " : "", what);
}

/* Marks at changes of stability. */
static void draw_events(struct hawser__figure *figure, const struct cli_beam_result *result)
{
	for (int ends = 0; ends < 2; ends++)
		for (int i = 0; i < result->variants; i++) {
			const struct hawser_beam_sweep *sweep = &result->variant[i].sweep;
			double per = cli_beam_per_speed(&result->variant[i].beam);

			for (int k = 0; k < sweep->events; k++)
				if ((sweep->event[k].kind == HAWSER_BEAM_CALM) == ends)
					hawser__figure_upright(figure, NULL, sweep->event[k].speed*per,
					                       "lt %d lw 0.8 dt %s", result->variants > 1 ? i + 1 : 7,
					                       ends ? "(2,4)" : "(8,5)");
		}
}

/* Imaginary parts, or the largest and the smallest real part of each branch. */
static void draw_parts(struct hawser__figure *figure, const struct cli_beam_result *result, int real)
{
	char title[120];

	for (int i = 0; i < result->variants; i++) {
		const struct cli_beam_variant *v = &result->variant[i];
		const struct hawser_beam_sweep *sweep = &v->sweep;
		double rate = cli_beam_per_rate(&v->beam), speed = cli_beam_per_speed(&v->beam);

		for (int k = 0; k < sweep->branches*(real ? 2 : 1); k++) {
			int b = real ? k/2 : k, colour = result->variants > 1 ? i + 1 : b % 6 + 1;

			for (int n = 0; n < sweep->stations; n++) {
				int cell = n*sweep->branches + b;

				hawser__figure_put(figure, sweep->station[n].speed*speed,
				                   rate*(real ? sweep->re[2*cell + k % 2] : sweep->im[cell]));
			}
			snprintf(title, sizeof title, "mode %d", b + 1);
			if (result->variants > 1)
				cli_beam_label(title, sizeof title, result, v, "");
			hawser__figure_draw(figure, result->variants > 1 || b < 6 ? title : NULL,
			                    "with lines lt %d lw 1.4", colour);
		}
	}
}

/* 1 if an instability ends (`ends` nonzero) or begins within the range. */
static int has_event(const struct cli_beam_result *result, int ends)
{
	for (int i = 0; i < result->variants; i++)
		for (int k = 0; k < result->variant[i].sweep.events; k++)
			if ((result->variant[i].sweep.event[k].kind == HAWSER_BEAM_CALM) == ends)
				return 1;
	return 0;
}

static enum hawser_status draw_sweep(const char *path, const struct cli_beam_result *result,
                                     struct hawser_report *report)
{
	struct hawser__axis axis[CLI_BEAM_AXES];
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 15.0, 14.2, report);

	if (status)
		return status;
	cli_beam_sweep_axes(axis, result);
	for (int real = 0; real < 2; real++) {
		hawser__figure_panel(&figure, &(struct hawser__panel_frame){
			0.14, 0.97, real ? 0.255 : 0.635, real ? 0.59 : 0.97,
			.x = {&axis[CLI_BEAM_SPEED], .tics = 8, .bare = !real},
			.y = {&axis[real ? CLI_BEAM_RE : CLI_BEAM_IM], .zero = !real, .tics = 6, .room = 0.04}});
		draw_events(&figure, result);
		draw_parts(&figure, result, real);
	}
	if (has_event(result, 0))
		hawser__legend_once(&figure.legend, "instability begins", "with lines lt 7 lw 0.8 dt (8,5)");
	if (has_event(result, 1))
		hawser__legend_once(&figure.legend, "instability ends", "with lines lt 7 lw 0.8 dt (2,4)");
	return hawser__figure_finish(&figure, report);
}

enum hawser_status cli_beam_draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct cli_beam_result *result = context;

	if (result->kind == CLI_BEAM_BOUNDARY)
		return cli_beam_boundary_draw(path, result, report);
	if (result->kind == CLI_BEAM_MOTION)
		return cli_beam_motion_draw(path, result, report);
	return draw_sweep(path, result, report);
}
