/* cli/statics/statics_speeds.c - hawser statics --speeds: steady states over the travel speed,
 * with the tension held (a taut and a slack one, which end in a fold), and with the length held.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/view.h"
#include "core/report.h"
#include "output/drawing/figure.h"

/* Last speed of a curve that ends in a fold, relative to the limit. */
static const double nearly = 1.0 - 1e-12;
/* Default end of a curve without a limit and of one with a limit: multiples of the speed of transverse
 * waves and of the limit. */
static const double beyond_waves = 2.0, beyond_limit = 1.25;

static const struct cli_speeds_kind {
	const char *hold, *state;
	enum hawser_hold kept;
	enum hawser_branch branch;
} kinds[CLI_SPEEDS_KINDS] = {
	{"tension", "taut", HAWSER_HOLD_TENSION, HAWSER_BRANCH_TAUT},
	{"tension", "slack", HAWSER_HOLD_TENSION, HAWSER_BRANCH_SLACK},
	{"length", "", HAWSER_HOLD_LENGTH, HAWSER_BRANCH_TAUT},
};

/* Position in the range, from 0 to 1. Near a fold the state depends on sqrt(limit - v): the points
 * are denser there, so that the state changes evenly. */
static double part_of(const struct cli_speeds_curve *curve, int i)
{
	double part = (double)i/(curve->points - 1);

	return curve->folds ? part*(2.0 - part) : part;
}

static enum hawser_status fill_curve(struct cli_speeds_curve *curve, const struct cli_speeds_kind *kind,
                                     const struct cli_speeds *speeds, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int i;

	for (i = 0; i < curve->points && !status; i++) {
		double speed = speeds->from + (curve->to - speeds->from)*part_of(curve, i);
		const struct hawser_motion motion = {
			.speed = speed, .fluctuation = speeds->fluctuation, .hold = kind->kept};

		status = hawser_statics_travel(curve->state + i, &speeds->span, speeds->given,
		                               speeds->value, kind->branch, &motion, report);
		/* at speed 0 the solver does not set it */
		curve->state[i].motion.speed = speed;
	}
	return status;
}

/* If no tension is given, T0 of the cable at rest is held, also by the slack state. */
static enum hawser_status settle(struct cli_speeds *speeds, const struct hawser_scene *scene,
                                 struct hawser_report *report)
{
	struct hawser_statics rest;
	struct hawser_equivalent equal;
	enum hawser_status status = hawser_statics_equivalent(&equal, scene, report);
	double V = scene->travel.fluctuation;

	if (status)
		return status;
	speeds->span = equal.span;
	speeds->given = equal.given;
	speeds->value = equal.value;
	speeds->fluctuation = V;
	status = hawser_statics_solve(&rest, &speeds->span, speeds->given, speeds->value,
	                              equal.branch, report);
	if (status)
		return status;
	if (speeds->given != HAWSER_GIVEN_H && speeds->given != HAWSER_GIVEN_T1) {
		speeds->given = HAWSER_GIVEN_T0;
		speeds->value = rest.T0;
	}
	speeds->folds = speeds->given != HAWSER_GIVEN_H;
	status = hawser_statics_limit(&speeds->limit, &speeds->span, speeds->given, speeds->value,
	                              equal.branch, HAWSER_HOLD_TENSION, report);
	if (status)
		return status;
	speeds->limit = sqrt(fmax(speeds->limit*speeds->limit - 0.5*V*V, 0.0));
	if (speeds->to == 0.0)
		speeds->to = fmin(speeds->folds ? beyond_limit*speeds->limit
		                                : beyond_waves*sqrt(rest.T0/speeds->span.rho),
		                  0.999*sqrt(speeds->span.EA/speeds->span.rho));
	if (speeds->from < speeds->to && (!speeds->folds || speeds->from < speeds->limit*nearly))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
	                    "speeds from %.10g m/s to %.10g m/s are no range of steady states: with the "
	                    "tension held they end at %.10g m/s", speeds->from, speeds->to,
	                    speeds->limit);
}

enum hawser_status cli_speeds_fill(struct cli_speeds *speeds, const struct hawser_scene *scene,
                                   int points, struct hawser_report *report)
{
	enum hawser_status status = settle(speeds, scene, report);
	int k;

	for (k = 0; k < CLI_SPEEDS_KINDS && !status; k++) {
		struct cli_speeds_curve *curve = &speeds->curve[k];

		if (kinds[k].branch == HAWSER_BRANCH_SLACK && !speeds->folds)
			continue;
		curve->hold = kinds[k].hold;
		curve->name = kinds[k].state;
		curve->folds = speeds->folds && kinds[k].kept == HAWSER_HOLD_TENSION
		               && speeds->to >= speeds->limit*nearly;
		curve->to = curve->folds ? speeds->limit*nearly : speeds->to;
		curve->points = points;
		curve->state = calloc((size_t)points, sizeof *curve->state);
		if (!curve->state)
			return hawser__no_memory(report, "statics");
		status = fill_curve(curve, &kinds[k], speeds, report);
	}
	return status;
}

void cli_speeds_clear(struct cli_speeds *speeds)
{
	int k;

	for (k = 0; k < CLI_SPEEDS_KINDS; k++)
		free(speeds->curve[k].state);
	memset(speeds, 0, sizeof *speeds);
}

/* A steady state. */
struct row {
	const char *hold, *state;
	double speed, T0, T1, H, sag, length0, length, apparent, nu;
};
#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_speed_field[] = {
	{"hold", "hold", "tension or length", OF(hold)},
	{"state", "state", "taut or slack", OF(state), .flags = HAWSER__OMIT},
	{"speed", "speed", "travel speed", OF(speed), .unit = HAWSER__METRE_S, .axis = "Speed"},
	{"T0", "T0", "tension at end A", OF(T0), .unit = HAWSER__NEWTON,
	 .axis = "Tension {/:Italic T}_0"},
	{"T1", "T1", "tension at end B", OF(T1), .unit = HAWSER__NEWTON},
	{"H", "H", "horizontal tension", OF(H), .unit = HAWSER__NEWTON},
	{"sag", "sag", "largest vertical distance from the chord", OF(sag),
	 .unit = HAWSER__METRE, .axis = "Sag"},
	{"length0", "length0", "unstretched length", OF(length0), .unit = HAWSER__METRE},
	{"length", "length", "stretched length", OF(length), .unit = HAWSER__METRE},
	{"apparent_H", "apparent_H", "H of the apparent cable", OF(apparent), .unit = HAWSER__NEWTON},
	{"nu", "nu", "speed over that of transverse waves", OF(nu)},
	HAWSER__END,
};
#undef OF

static size_t states(const void *parent)
{
	size_t count = 0;

	for (int k = 0; k < CLI_SPEEDS_KINDS; k++)
		count += (size_t)((const struct cli_speeds *)parent)->curve[k].points;
	return count;
}

/* Curve after curve. */
static const void *state_row(void *to, const void *parent, size_t i)
{
	const struct cli_speeds_curve *curve = ((const struct cli_speeds *)parent)->curve;
	const struct hawser_statics *state;
	struct hawser_statics actual;

	for (; i >= (size_t)curve->points; curve++)
		i -= (size_t)curve->points;
	state = &curve->state[i];
	actual = hawser_statics_actual(state);
	*(struct row *)to = (struct row){
		.hold = curve->hold, .state = curve->name, .speed = state->motion.speed, .T0 = actual.T0,
		.T1 = actual.T1, .H = actual.H, .sag = actual.sag, .length0 = actual.length0,
		.length = actual.length, .apparent = state->H, .nu = state->motion.nu};
	return to;
}
static const struct hawser__list state_list = {
	.field = cli_speed_field, .size = HAWSER__MADE_SIZE(struct row), .count = states,
	.row = state_row};
const struct hawser__field cli_speeds_member[] = {
	{"speeds", NULL, "with --speeds: steady states", HAWSER__OBJECTS_OF(state_list)},
	HAWSER__END,
};

void cli_speeds_rows(struct hawser__table *table, const struct cli_speeds *speeds)
{
	struct hawser__view view = cli_si_view(0);

	if (speeds->folds)
		hawser__table_comment(table, "tension held: %s = %.12g N, the taut and the slack state end "
		                             "together at %.12g m/s", hawser_given_name(speeds->given),
		                      speeds->value, speeds->limit);
	else
		hawser__table_comment(table, "tension held: H = %.12g N, no fold ends the steady state",
		                      speeds->value);
	hawser__fields_table(table, &state_list, speeds, &view);
}

/* A quantity of the states over the speed, 0: sag, 1: tension. */
static void draw_states(struct hawser__figure *figure, const struct cli_speeds *speeds, int quantity)
{
	static const char *const style[CLI_SPEEDS_KINDS] = {"with lines lt 1", "with lines lt 1 dt (9,5)",
	                                                    "with lines lt 2"};
	static const char *const title[CLI_SPEEDS_KINDS] = {"tension held: taut", "tension held: slack",
	                                                    "length held"};

	for (int k = 0; k < CLI_SPEEDS_KINDS; k++) {
		const struct hawser_statics *state = speeds->curve[k].state;

		for (int i = 0; i < speeds->curve[k].points; i++)
			hawser__figure_put(figure, state[i].motion.speed,
			                   quantity ? hawser_statics_actual(&state[i]).T0 : state[i].sag);
		hawser__figure_draw(figure, title[k], "%s", style[k]);
	}
	if (speeds->folds)
		hawser__figure_upright(figure, "limit speed", speeds->limit,
		                       "lc rgb '#909090' lw 1.2 dt (3,3)");
}

enum hawser_status cli_speeds_draw(const char *path, const struct cli_speeds *speeds,
                                   struct hawser_report *report)
{
	static const char *const shown[] = {"speed", "sag", "T0"};
	struct hawser__view view = cli_si_view(0);
	struct hawser__figure figure = {0};
	struct hawser__axis axis[3];
	double largest = 0.0;
	enum hawser_status status = hawser__figure_begin(&figure, path, 16.0, 12.8, report);

	if (status)
		return status;
	for (int k = 0; k < CLI_SPEEDS_KINDS; k++)
		for (int i = 0; i < speeds->curve[k].points; i++)
			largest = fmax(largest, hawser_statics_actual(&speeds->curve[k].state[i]).T0);
	for (int k = 0; k < 3; k++)
		axis[k] = hawser__fields_axis(cli_speed_field, shown[k], &view, largest);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, 0.63, 0.97,
		.x = {&axis[0], .tics = 8, .bare = 1}, .y = {&axis[1], .logarithmic = 1, .tics = 6,
		                                             .room = 0.1}});
	draw_states(&figure, speeds, 0);
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.13, 0.97, 0.235, 0.575,
		.x = {&axis[0], .tics = 8}, .y = {&axis[2], .zero = 1, .tics = 6, .room = 0.08}});
	draw_states(&figure, speeds, 1);
	return hawser__figure_finish(&figure, report);
}
