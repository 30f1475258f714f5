/* ropeway/statics/state.c - the state of both lanes for one phase: tension, carriage, drive, and
 * what is refused.
 *
 * The carriage pulls with the force W on two ropes. A rope that runs around the bullwheel at the
 * speed v also needs the change of its momentum, 2 rho v^2 |x'|, so that W = 2 P with P = T - rho
 * v^2 |x'|: P is W/2 at any speed, and T larger. With a fixed carriage the length of the loop is
 * given; the length that the rope needs falls with its tension, so that the tension is bracketed.
 *
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "continuation/false_position.h"
#include "core/report.h"
#include "core/settle.h"
#include "ropeway/statics/line.h"

#define PI 3.14159265358979323846 /* to the digits of a double */
#define CLOSED 1e-10 /* accepted error of the loop's length over itself: some 1e-5 of the strain */
#define WIDER 1.25   /* steps of the tension until it is bracketed: a loaded rope rarely needs more than
                      * three of them */
enum { TRIES = 100, PHASES = 200 }; /* tensions: ten are usual; phases: 0.5 % of a spacing apart */

void hawser_ropeway_settle(struct hawser_ropeway_options *options)
{
	hawser__settle_count(&options->phases, PHASES);
}

/* The loads of a lane. */
static struct hawser__loading loading_of(const struct hawser_ropeway *rw, int lane, int load_case,
                                         double phase, double P, int lift)
{
	int moves = rw->sliding == HAWSER_ROPEWAY_REST ? 0 : rw->sliding == HAWSER_ROPEWAY_REVERSE ? -1 : 1;
	int toward = lane == HAWSER_ROPEWAY_UP ? moves : -moves;
	double down = rw->phase_down - (phase - rw->phase), first = phase;

	if (lane == HAWSER_ROPEWAY_DOWN && rw->spacing > 0.0) {
		first = fmod(down, rw->spacing);
		first += first < 0.0 ? rw->spacing : 0.0;
	}
	return (struct hawser__loading){
		.mass = load_case < 0 ? 0.0 : rw->load_case[load_case].mass[lane], .first = first,
		.P = P*(1.0 + toward*rw->bottom_friction), .speed = moves ? rw->speed : 0.0,
		.sliding = toward > 0 ? HAWSER_LINE_TOWARD_B
		           : toward < 0 ? HAWSER_LINE_TOWARD_A : HAWSER_LINE_NONE, .lift = lift};
}

/* Solve both lanes for P at the bottom station; load_case -1: no carriers. The report names the
 * lane. */
static enum hawser_status solve_lanes(struct hawser_ropeway_statics *st,
                                      const struct hawser__frame *frame, int load_case,
                                      double phase, double P, int lift,
                                      struct hawser_report *report)
{
	const struct hawser_ropeway *rw = frame->ropeway;
	struct hawser_report inner;
	char given[HAWSER__TENSION_GIVEN] = "";
	double tension = 0.0;

	st->loop0 = 0.0;
	for (int i = 0; i < rw->lanes; i++) {
		const struct hawser__loading loading = loading_of(rw, i, load_case, phase, P, lift);
		enum hawser_status status = hawser__lane_solve(&st->lane[i], frame, &loading, &inner);

		if (status == HAWSER_ERR_NO_SOLUTION)
			hawser__tension_given(given, rw);
		if (status && load_case < 0)
			return hawser__fail(report, status, "ropeway", "the rope without carriers, lane %s: "
			                    "%.440s%s", i ? "down" : "up", inner.message, given);
		if (status)
			return hawser__fail(report, status, "ropeway", "case %s, phase %.9g m, lane %s: "
			                    "%.440s%s", rw->load_case[load_case].name, phase,
			                    i ? "down" : "up", inner.message, given);
		st->loop0 += st->lane[i].st.length0;
		tension += st->lane[i].st.T_B/rw->lanes;
	}
	if (rw->lanes == 2)
		st->loop0 += PI*rw->bottom_radius /
		                 (1.0 + hawser__actual(rw, P, st->lane[0].line->speed)/rw->EA) +
		             PI*rw->top_radius/(1.0 + tension/rw->EA);
	return HAWSER_OK;
}

static void clear_lanes(struct hawser_ropeway_statics *st)
{
	for (int i = 0; i < HAWSER_ROPEWAY_LANES; i++)
		hawser__lane_clear(&st->lane[i]);
}

/* The same for a fixed carriage: P is found from the length of the loop. Sheaves may be without
 * contact on the way. */
static enum hawser_status fit_length(struct hawser_ropeway_statics *st,
                                     const struct hawser__frame *frame, int load_case, double phase,
                                     double *P, struct hawser_report *report)
{
	struct hawser__bracketed in = {0.0, 0.0, 0.0, 0.0, 0};
	double x = *P, excess, enough = CLOSED*frame->reference;
	int low = 0, high = 0;

	for (int i = 0; i < TRIES; i++) {
		enum hawser_status status = solve_lanes(st, frame, load_case, phase, x, 1, report);

		if (status)
			return status;
		*P = x;
		excess = st->loop0 - frame->reference;
		if (fabs(excess) <= enough || (low && high && in.b - in.a <= 1e-15*in.b))
			return HAWSER_OK;
		clear_lanes(st);
		if (low && high) {
			hawser__false_position_take(&in, x, excess);
		} else if (excess > 0.0) {
			in.a = x;
			in.fa = excess;
			low = 1;
		} else {
			in.b = x;
			in.fb = excess;
			high = 1;
		}
		x = low && high ? hawser__false_position(&in, i) : low ? x*WIDER : x/WIDER;
	}
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "ropeway", TRIES, excess,
	                       "phase %.9g m: after %d "
	                       "tensions the loop is still %.3g m longer than tension.length0 allows",
	                       phase, TRIES, excess);
}

enum hawser_status hawser__frame_refer(struct hawser__frame *frame, struct hawser_report *report)
{
	struct hawser_ropeway empty = *frame->ropeway;
	struct hawser__frame with = *frame;
	struct hawser_ropeway_statics st;
	enum hawser_status status;

	frame->reference = empty.value;
	if (empty.tension == HAWSER_ROPEWAY_LENGTH0)
		return HAWSER_OK;
	memset(&st, 0, sizeof st);
	empty.sliding = HAWSER_ROPEWAY_REST;
	with.ropeway = &empty;
	status =
		solve_lanes(&st, &with, -1, 0.0,
	                empty.tension == HAWSER_ROPEWAY_COUNTERWEIGHT ? 0.5*empty.value : empty.value,
	                1, report);
	frame->reference = st.loop0;
	clear_lanes(&st);
	return status;
}

static void drive(struct hawser_ropeway_statics *st)
{
	const struct hawser_ropeway *rw = st->ropeway;
	const struct hawser_line_statics *up = &st->lane[0].st, *down = &st->lane[1].st;
	double speed = st->lane[0].line->speed;

	st->drive_margin = NAN;
	if (st->lanes < 2)
		return;
	st->force = up->T_B - down->T_B;
	st->power = st->force*(rw->sliding == HAWSER_ROPEWAY_REVERSE ? -speed : speed);
	st->needed_friction = fabs(log(hawser__apparent(rw, up->T_B, speed)/
	                               hawser__apparent(rw, down->T_B, speed)))/rw->wrap;
	if (!rw->drive)
		return;
	st->drive_margin = rw->drive_friction - st->needed_friction;
	st->slips = st->drive_margin < 0.0;
}

static void carriage(struct hawser_ropeway_statics *st, const struct hawser__frame *frame, double P)
{
	const struct hawser_ropeway *rw = st->ropeway;

	st->T0 = hawser__actual(rw, P, st->lane[0].line->speed);
	st->weight = 2.0*P;
	if (rw->tension > HAWSER_ROPEWAY_T0)
		return;
	st->travel = 0.5*(st->loop0 - frame->reference)*(1.0 + st->T0/rw->EA);
	st->stopped = rw->stops && (st->travel < rw->travel[0] || st->travel > rw->travel[1]);
}

/* What is wrong with this state, if anything. */
static enum hawser_status judge(struct hawser_ropeway_statics *st, const struct hawser__frame *frame,
                                int tolerate, struct hawser_report *report)
{
	const struct hawser_ropeway *rw = st->ropeway;
	const char *load_case = rw->load_case[st->load_case].name;
	char line[HAWSER__FILE_LINE];

	for (int i = 0; i < st->lanes; i++)
		for (int k = 0; k < rw->towers; k++) {
			const struct hawser_ropeway_contact *c = &st->lane[i].contact[k];

			if (c->touches)
				continue;
			st->lifted++;
			if (!tolerate)
				return hawser__fail(
					report, HAWSER_ERR_NO_SOLUTION, "ropeway",
					"case %s, phase %.9g m, lane %s: the rope lifts off the %s battery of tower "
					"%s%s at (%.6g, %.6g) m: it passes %.4g m %s it; move the tower, change its "
					"battery or the tension, or see the state with --tolerate",
					load_case, st->phase, i ? "down" : "up",
					frame->side[k] > 0 ? "support" : "compression", rw->tower[k].name,
					hawser__file_line(line, rw->tower[k].file_line), rw->tower[k].at[0],
					rw->tower[k].at[1], c->clearance, frame->side[k] > 0 ? "above" : "below");
		}
	if (st->slips && !tolerate)
		return hawser__fail(
			report, HAWSER_ERR_NO_SOLUTION, "ropeway",
			"case %s, phase %.9g m: the rope slips "
			"on the drive bullwheel: %.6g N against %.6g N need a friction of %.4g, and "
			"drive.friction%s is %.4g, %.4g too little; see the state with --tolerate",
			load_case, st->phase, st->lane[0].st.T_B, st->lane[1].st.T_B, st->needed_friction,
			hawser__file_line(line, rw->drive_line), rw->drive_friction, -st->drive_margin);
	if (st->stopped && !tolerate) {
		double stop = st->travel < rw->travel[0] ? rw->travel[0] : rw->travel[1];

		return hawser__fail(
			report, HAWSER_ERR_NO_SOLUTION, "ropeway",
			"case %s, phase %.9g m: the "
			"counterweight is at its stop: the carriage would be at %.4g m, %.4g m beyond "
			"tension.travel%s = %.4g m; see the state with --tolerate",
			load_case, st->phase, st->travel, fabs(st->travel - stop),
			hawser__file_line(line, rw->tension_line), stop);
	}
	return HAWSER_OK;
}

static void begin(struct hawser_ropeway_statics *st, const struct hawser__frame *frame,
                  const struct hawser_ropeway_options *options, double phase)
{
	*st = (struct hawser_ropeway_statics){.ropeway = frame->ropeway, .phase = phase,
	                                      .load_case = options->load_case,
	                                      .lanes = frame->ropeway->lanes};
}

/* The state for P at the bottom station, but with a fixed carriage. lift 1: batteries may be without
 * contact on the way. */
static enum hawser_status complete(struct hawser_ropeway_statics *st, const struct hawser__frame *frame,
                                   const struct hawser_ropeway_options *options, double P, int lift,
                                   struct hawser_report *report)
{
	const struct hawser_ropeway *rw = frame->ropeway;
	enum hawser_status status = rw->tension > HAWSER_ROPEWAY_T0
		? fit_length(st, frame, options->load_case, st->phase, &P, report)
		: solve_lanes(st, frame, options->load_case, st->phase, P, lift, report);

	for (int i = 0; i < rw->lanes && !status; i++)
		status = hawser__lane_describe(&st->lane[i], frame, report);
	if (status)
		return status;
	drive(st);
	carriage(st, frame, P);
	return judge(st, frame, options->tolerate, report);
}

enum hawser_status hawser__ropeway_state(struct hawser_ropeway_statics *st,
                                         const struct hawser__frame *frame,
                                         const struct hawser_ropeway_options *options, double phase,
                                         struct hawser_report *report)
{
	const struct hawser_ropeway *rw = frame->ropeway;
	double speed = rw->sliding == HAWSER_ROPEWAY_REST ? 0.0 : rw->speed, P = 0.5*rw->value;
	enum hawser_status status;

	begin(st, frame, options, phase);
	if (rw->tension == HAWSER_ROPEWAY_T0 || rw->tension == HAWSER_ROPEWAY_EMPTY)
		P = hawser__apparent(rw, rw->value, rw->tension == HAWSER_ROPEWAY_T0 ? speed : 0.0);
	if (rw->tension == HAWSER_ROPEWAY_LENGTH0)
		P = frame->tension;
	if (!(P > 0.0))
		return hawser__fail(
			report, HAWSER_ERR_NO_SOLUTION, "ropeway",
			"tension.T0 = %.9g N is not above "
			"rho*speed^2 = %.9g N: the rope cannot run around its bullwheels at drive.speed",
			rw->value, rw->rho*speed*speed);
	status = complete(st, frame, options, P, options->tolerate, report);
	if (status == HAWSER_ERR_NO_SOLUTION && !st->lifted && !options->tolerate) {
		/* A battery that the rope does not press: the state without it says by how much. */
		struct hawser_report other = {0};

		hawser_ropeway_statics_clear(st);
		begin(st, frame, options, phase);
		(void)complete(st, frame, options, P, 1, &other);
		if (st->lifted && report)
			*report = other;
	}
	if (status)
		hawser_ropeway_statics_clear(st);
	return status;
}

enum hawser_status hawser_ropeway_solve(struct hawser_ropeway_statics *st,
                                        const struct hawser_ropeway *rw,
                                        const struct hawser_ropeway_options *options, double phase,
                                        struct hawser_report *report)
{
	struct hawser_ropeway_options own = options ? *options : (struct hawser_ropeway_options){0};
	struct hawser__frame frame;
	enum hawser_status status;

	memset(st, 0, sizeof *st);
	hawser_ropeway_settle(&own);
	if (own.load_case < 0 || own.load_case >= rw->cases || !isfinite(phase) || phase < 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "ropeway",
		                    "load case %d of %d, phase %g m: the case "
		                    "must exist, and the phase be finite and not negative",
		                    own.load_case, rw->cases, phase);
	status = hawser__frame_open(&frame, rw, report);
	if (!status)
		status = hawser__frame_refer(&frame, report);
	if (!status)
		status = hawser__ropeway_state(st, &frame, &own, phase, report);
	hawser__frame_clear(&frame);
	return hawser__in_file(report, status, rw->name);
}

void hawser_ropeway_statics_clear(struct hawser_ropeway_statics *st)
{
	if (!st)
		return;
	clear_lanes(st);
	memset(st, 0, sizeof *st);
}
