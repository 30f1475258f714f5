/* ropeway/transient/transient_rows.c - what a run shows of the state at the end of a step, its
 * extremes, and what is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "ropeway/transient/transient.h"

#define AT_REST 1e-4 /* of drive.speed: slower is at rest */

/* --- rows and extremes --- */

static void widen(struct hawser_transient_range *range, double value, double t)
{
	if (!(value >= range->min)) {
		range->min = value;
		range->at_min = t;
	}
	if (!(value <= range->max)) {
		range->max = value;
		range->at_max = t;
	}
}

/* Tensions of a span: its ends and its least and largest by statics, each with what the elements have
 * above it. The rope that runs has rho q^2 more. */
static void span_tensions(double T[4], const struct hawser__chain *chain, int k)
{
	const struct hawser__slow_span *slow = &chain->now.span[k];
	int lane = k/chain->slow->spans, first = k%chain->slow->spans*chain->m + 1;
	const double *tau = chain->tension + lane*(chain->E + 1) + first;
	double low = INFINITY, high = -INFINITY, q = chain->q[2*chain->E], thrust = chain->rw->rho*q*q;

	for (int i = 0; i < chain->m; i++) {
		low = fmin(low, tau[i]);
		high = fmax(high, tau[i]);
	}
	T[0] = slow->T_min + low + thrust;
	T[1] = slow->T_max + high + thrust;
	T[2] = slow->T_from + tau[0] + thrust;
	T[3] = slow->T_to + tau[chain->m - 1] + thrust;
}

static double largest_rate(const struct hawser__chain *chain)
{
	double most = 0.0;

	for (int i = 0; i < chain->N; i++)
		if (i != 1 && fabs(chain->rate[i]) > fabs(most))
			most = chain->rate[i];
	return most;
}

void hawser__transient_row(struct hawser_transient_row *row, const struct hawser__chain *chain)
{
	const struct hawser_ropeway *rw = chain->rw;
	int top = 2*chain->E, spans = chain->slow->spans;
	double P[2], thrust = rw->rho*chain->q[top]*chain->q[top], T[4];

	hawser__chain_top(P, chain);
	*row = (struct hawser_transient_row){.t = chain->t, .travelled = chain->u[top],
		.speed = chain->q[top], .wheel = chain->wheel, .force = chain->drive, .motor = chain->motor,
		.limit = rw->drive ? chain->traction : NAN, .T_up = P[0] + thrust, .T_down = P[1] + thrust,
		.travel = chain->start.travel + chain->u[1], .travel_speed = chain->q[1], .T_min = INFINITY,
		.T_max = -INFINITY, .pressing = INFINITY, .acceleration = largest_rate(chain)};
	row->needed_friction = fabs(log(P[0]/P[1]))/rw->wrap;
	row->slip_arc = !rw->drive ? NAN
	                : chain->at_drive.rope ? rw->wrap
	                : rw->drive_friction > 0.0 ? row->needed_friction*rw->wrap/rw->drive_friction : 0.0;
	for (int k = 0; k < 2*spans; k++) {
		span_tensions(T, chain, k);
		row->T_min = fmin(row->T_min, T[0]);
		row->T_max = fmax(row->T_max, T[1]);
		if (k%spans == 0)
			*(k ? &row->T_bottom_down : &row->T_bottom_up) = T[2];
	}
	for (int i = 0; i < 2*chain->slow->towers; i++)
		row->pressing = fmin(row->pressing, hawser__chain_pressing(chain, i/chain->slow->towers,
		                                                           i%chain->slow->towers, 0));
	if (chain->slow->towers == 0)
		row->pressing = NAN;
}

static void place_extremes(struct hawser_transient *run, const struct hawser__chain *chain)
{
	int spans = chain->slow->spans, towers = chain->slow->towers;
	double T[4];

	for (int k = 0; k < 2*spans; k++) {
		struct hawser_transient_place *span = &run->span[k];
		int first = k%spans*chain->m;

		span_tensions(T, chain, k);
		widen(&span->T, T[0], chain->t);
		widen(&span->T, T[1], chain->t);
		widen(&span->other, chain->sag_middle[k] - chain->still[k], chain->t);
		for (int e = first; e <= first + chain->m; e++)
			widen(&span->acceleration, chain->rate[hawser__chain_node(chain, k/spans, e)], chain->t);
		if (k%spans < spans - 1)
			widen(&run->tower[k/spans*towers + k%spans].T, T[3], chain->t);
		if (k%spans > 0)
			widen(&run->tower[k/spans*towers + k%spans - 1].T, T[2], chain->t);
	}
	for (int i = 0; i < 2*towers; i++) {
		int node = hawser__chain_node(chain, i/towers, (i%towers + 1)*chain->m);

		widen(&run->tower[i].other, hawser__chain_pressing(chain, i/towers, i%towers, 0), chain->t);
		widen(&run->tower[i].acceleration, chain->rate[node], chain->t);
	}
}

void hawser__transient_extremes(struct hawser_transient *run, const struct hawser__chain *chain,
                                const struct hawser_transient_row *row)
{
	place_extremes(run, chain);
	widen(&run->force, row->force, row->t);
	widen(&run->T, row->T_min, row->t);
	widen(&run->T, row->T_max, row->t);
	widen(&run->needed_friction, row->needed_friction, row->t);
	widen(&run->slip_arc, row->slip_arc, row->t);
	widen(&run->travel, row->travel, row->t);
	widen(&run->acceleration, row->acceleration, row->t);
	if (fabs(row->speed) > AT_REST*run->ropeway->speed)
		run->stopped_at = NAN;
	else if (isnan(run->stopped_at))
		run->stopped_at = row->t;
	run->creep = fmax(run->creep, fabs(row->T_up - row->T_down)/run->ropeway->EA);
}

/* --- what is refused --- */

static const char *lane_name(int lane)
{
	return lane ? "down" : "up";
}

static enum hawser_status judge_batteries(struct hawser_transient *run,
                                          const struct hawser__chain *chain, int tolerate,
                                          struct hawser_report *report)
{
	const struct hawser_ropeway *rw = chain->rw;
	int towers = chain->slow->towers;
	char line[HAWSER__FILE_LINE];

	for (int i = 0; i < 2*towers; i++) {
		double pressing = hawser__chain_pressing(chain, i/towers, i%towers, 0);
		const struct hawser_ropeway_tower *tower = &rw->tower[i%towers];

		if (pressing > 0.0)
			continue;
		if (!tolerate)
			return hawser__fail(
				report, HAWSER_ERR_NO_SOLUTION, "transient",
				"t = %.6g s, lane %s: the rope leaves the battery of tower %s%s: it would have to be "
				"held with %.6g N, and is pressed on with %.6g N by the statics of this phase; "
				"move the "
				"tower, change the tension, ramp or brake, or see the run with --tolerate", chain->t,
				lane_name(i/towers), tower->name, hawser__file_line(line, tower->file_line), -pressing,
				chain->now.tower[i].pressing);
		run->lifts++;
		run->lifts_at = isnan(run->lifts_at) ? chain->t : run->lifts_at;
		return HAWSER_OK;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__transient_judge(struct hawser_transient *run,
                                           const struct hawser__chain *chain,
                                           const struct hawser_transient_row *row,
                                           struct hawser_report *report)
{
	const struct hawser_ropeway *rw = chain->rw;
	int tolerate = run->options.tolerate;
	char line[HAWSER__FILE_LINE];

	if (!isfinite(row->force) || !isfinite(row->T_max) || !isfinite(row->travel))
		return hawser__fail(report, HAWSER_ERR_NAN, "transient", "t = %.6g s: the force of the drive, "
		                    "a tension or the carriage's travel is not a number", chain->t);
	for (int k = 0; k < 2*chain->slow->spans; k++) {
		double T[4];

		span_tensions(T, chain, k);
		if (!(T[0] > 0.0))
			return hawser__fail(
				report, HAWSER_ERR_NO_SOLUTION, "transient",
				"t = %.6g s, lane %s, span %d: the rope becomes slack (%.6g N): give a larger tension, "
				"a longer ramp or a weaker brake", chain->t, lane_name(k/chain->slow->spans),
				k%chain->slow->spans, T[0]);
	}
	if (chain->at_drive.rope && !tolerate)
		return hawser__fail(
			report, HAWSER_ERR_NO_SOLUTION, "transient",
			"t = %.6g s: the rope slips on the whole drive bullwheel: %.6g N against %.6g N, and "
			"drive.friction%s = %.4g holds at most e^(%.4g) between them; see the run with --tolerate",
			chain->t, row->T_up, row->T_down, hawser__file_line(line, rw->drive_line),
			rw->drive_friction, rw->drive_friction*rw->wrap);
	run->slips += chain->at_drive.rope != 0;
	if (rw->stops && (row->travel < rw->travel[0] || row->travel > rw->travel[1])) {
		if (!tolerate)
			return hawser__fail(
				report, HAWSER_ERR_NO_SOLUTION, "transient",
				"t = %.6g s: the carriage is at its stop: %.4g m, with tension.travel%s from %.4g m to "
				"%.4g m; see the run with --tolerate", chain->t, row->travel,
				hawser__file_line(line, rw->tension_line), rw->travel[0], rw->travel[1]);
		run->stops++;
	}
	return judge_batteries(run, chain, tolerate, report);
}
