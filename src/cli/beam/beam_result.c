/* cli/beam/beam_result.c - comments of hawser beam.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/beam/beam_result.h"

double cli_beam_per_speed(const struct hawser_beam *beam)
{
	return beam->time > 0.0 ? beam->length/beam->time : 1.0;
}

double cli_beam_per_rate(const struct hawser_beam *beam)
{
	return beam->time > 0.0 ? 1.0/beam->time : 1.0;
}

int cli_beam_slack(char *text, size_t size, const struct hawser_beam *beam)
{
	double least = hawser_beam_least_tension(beam);

	if (least >= 0.0)
		return 0;
	snprintf(text, size, "the lower end is slack: its tension is %.4g of that at the upper; bending "
	                     "carries what hangs there (a string could not)", least/beam->tension);
	return 1;
}

void cli_beam_print_scales(FILE *stream, const struct hawser_scene *scene,
                           const struct hawser_beam *beam)
{
	char warning[CLI_WARNING_SIZE];

	fprintf(stream, "A travelling %s between %s ends, scaled (man hawser-scene):\n"
	                "  theta = %.10g  bending rigidity\n  tension = %.10g  at the end where it leaves\n"
	                "  weight = %.10g  by which the tension falls to the other end\n"
	                "  drag = %.10g\n  rotary = %.10g  (radius of gyration over length)^2\n"
	                "  speed = %.10g\n", beam->theta > 0.0 ? "beam" : "string",
	        beam->ends == HAWSER_ENDS_CLAMPED ? "clamped" : "simple", beam->theta, beam->tension,
	        beam->weight, beam->drag, beam->rotary, beam->speed);
	if (scene->beam.form == HAWSER_BEAM_EI)
		fprintf(stream,
		        "Units: length L = %.10g m, time L sqrt(rhoA/T) = %.10g s, speed sqrt(T/rhoA) = "
		                "%.10g m/s, tension T = %.10g N\n", beam->length, beam->time,
		        beam->length/beam->time, scene->beam.tension_end);
	if (beam->across != 0.0)
		fprintf(stream,
		        "Weight across the travel, scaled %.6g, deflects it statically and does not enter "
		                "small motions.\n", beam->across);
	if (cli_beam_slack(warning, sizeof warning, beam))
		fprintf(stream, "Warning: %s.\n", warning);
	fputs("Eigenvalues, safe speeds, boundaries and motions: hawser beam.\n", stream);
}

/* --- comments --- */

static void say_speed(char text[48], double v, const struct hawser_beam *beam)
{
	if (isnan(v))
		snprintf(text, 48, "none");
	else
		snprintf(text, 48, "%.12g%s", v*cli_beam_per_speed(beam), beam->time > 0.0 ? " m/s" : "");
}

static const char *explanation(const struct hawser_beam_limits *limits)
{
	switch (limits->cause) {
	case HAWSER_BEAM_BUCKLES: return "it buckles under its own weight at rest";
	case HAWSER_BEAM_BY_FLUX: return "by rotary momentum from the supports at every speed";
	case HAWSER_BEAM_DIVERGES: return "divergence";
	case HAWSER_BEAM_FLUTTERS: return "flutter";
	case HAWSER_BEAM_WAVES: return "the speed of waves in a bar: short waves diverge";
	case HAWSER_BEAM_STRING: return "the speed of waves where the tension is least";
	default: return "no growth";
	}
}

static void comment_limits(struct hawser__table *table, const struct cli_beam_variant *v)
{
	const struct hawser_beam_limits *limits = &v->limits;
	char crit[48], first[48], bif[48], searched[48];

	say_speed(crit, limits->v_crit, &v->beam);
	say_speed(first, limits->v_first, &v->beam);
	say_speed(bif, limits->v_bif, &v->beam);
	say_speed(searched, limits->searched, &v->beam);
	hawser__table_comment(table, "v_crit = %s (%s); of the first mode %s; v_bif = %s; %d modes, speeds "
	                             "%s to %s", crit, explanation(limits), first, bif, limits->modes,
	                      v->beam.speed < 0.0 ? "downwards" : "from 0", searched);
	if (limits->cause == HAWSER_BEAM_BY_FLUX)
		hawser__table_comment(table, "growth by that at slow travel: %.6g times the speed (scaled)",
		                      limits->slope);
}

static void comment_beam(struct hawser__table *table, const struct cli_beam_result *result,
                         const struct cli_beam_variant *v)
{
	const struct hawser_beam *beam = &v->beam;

	if (result->vary)
		hawser__table_comment(table, "%s = %.12g:", result->vary, v->value);
	hawser__table_comment(table,
	        "scaled: theta = %.10g, tension = %.10g, weight = %.10g, drag = %.10g, "
	                             "rotary = %.10g, speed = %.10g; ends %s, moment %s", beam->theta,
	                      beam->tension, beam->weight, beam->drag, beam->rotary, beam->speed,
	                      beam->ends == HAWSER_ENDS_CLAMPED ? "clamped" : "simple",
	                      beam->moment == HAWSER_MOMENT_BALANCED ? "balanced" : "free");
	if (beam->time > 0.0)
		hawser__table_comment(table, "units: length %.10g m, time %.10g s, speed %.10g m/s",
		                      beam->length, beam->time, cli_beam_per_speed(beam));
	if (beam->across != 0.0)
		hawser__table_comment(table, "weight across the travel, scaled %.6g, deflects the beam "
		                             "statically and does not enter these small motions",
		                      beam->across);
	hawser__table_comment(table, "size %d, relative error of the discretisation about %.1e", v->size,
	                      v->error);
	comment_limits(table, v);
}

static void comment_events(struct hawser__table *table, const struct cli_beam_variant *v)
{
	for (int k = 0; k < v->sweep.events; k++) {
		const struct hawser_beam_event *event = &v->sweep.event[k];
		char speed[48];

		say_speed(speed, event->speed, &v->beam);
		hawser__table_comment(table, "%s at v = %s: growing modes %d, beyond it %d; frequency %.8g%s",
		                      hawser_beam_event_name(event->kind), speed, event->growing[0],
		                      event->growing[1], event->im*cli_beam_per_rate(&v->beam),
		                      v->beam.time > 0.0 ? " rad/s" : "");
	}
}

void cli_beam_comments(struct hawser__table *table, const void *of)
{
	const struct cli_beam_result *result = of;

	for (int i = 0; i < result->variants; i++)
		comment_beam(table, result, &result->variant[i]);
	if (*result->warning)
		hawser__table_comment(table, "warning: %s", result->warning);
	for (int i = 0; i < result->variants && result->kind == CLI_BEAM_SWEEP; i++)
		comment_events(table, &result->variant[i]);
	if (result->kind == CLI_BEAM_BOUNDARY)
		cli_beam_boundary_comments(table, result);
	if (result->kind == CLI_BEAM_MOTION)
		cli_beam_motion_comments(table, result);
}
