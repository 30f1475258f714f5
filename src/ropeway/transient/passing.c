/* ropeway/transient/passing.c - a carrier passes a battery at constant speed: exact statics of the
 * running rope around the phases at which it is there. The carrier is in the span, at the first
 * point of contact with its kink, on the arc, or at the last point (struct hawser_line_carrier).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/transient.h>

#include "core/report.h"
#include "ropeway/statics/line.h"

enum { POINTS = 201, MOST = 100000 }; /* rows by default, for a smooth curve; more are a mistake */

/* S of the first and the last point of contact with a tower, in the state of one phase. */
static void extent(double S[2], const struct hawser_ropeway_lane *lane, int tower)
{
	S[0] = lane->span[tower].S_to;
	S[1] = lane->span[tower + 1].S_from;
}

/* The phase of lane up at which a carrier of a lane is at S. */
static double phase_of(const struct hawser_ropeway *rw, int lane, double S)
{
	double phase = lane == HAWSER_ROPEWAY_UP ? S : rw->phase + rw->phase_down - S;

	return phase - rw->spacing*floor(phase/rw->spacing);
}

/* The carrier of a lane that is nearest to S. */
static int nearest(const struct hawser_ropeway_lane *lane, double S)
{
	int best = 0;

	for (int i = 1; i < lane->carriers; i++)
		if (fabs(lane->line->mass[i].S - S) < fabs(lane->line->mass[best].S - S))
			best = i;
	return best;
}

static enum hawser_status one_row(struct hawser_passing_row *row, const struct hawser_passing *passing,
                                  const struct hawser__frame *frame,
                                  const struct hawser_ropeway_options *options, double S,
                                  struct hawser_report *report)
{
	struct hawser_ropeway_statics st;
	double phase = phase_of(frame->ropeway, passing->lane, S);
	const struct hawser_ropeway_lane *lane = &st.lane[passing->lane];
	const struct hawser_line_carrier *carrier;
	enum hawser_status status = hawser__ropeway_state(&st, frame, options, phase, report);
	int i;

	if (status)
		return status;
	i = nearest(lane, S);
	carrier = &lane->st.carrier[i];
	*row = (struct hawser_passing_row){.phase = phase, .S = lane->line->mass[i].S,
		.x = {carrier->x[0], carrier->x[1]}, .state = carrier->state,
		.angle_before = carrier->angle_before, .angle_after = carrier->angle_after,
		.carried = carrier->carried, .contact = lane->contact[passing->tower]};
	hawser_ropeway_statics_clear(&st);
	return HAWSER_OK;
}

/* The contact's extent with a carrier in its middle: it is widest, or there are two contacts. */
static enum hawser_status find(double S[2], const struct hawser_passing *passing,
                               const struct hawser__frame *frame,
                               const struct hawser_ropeway_options *options,
                               struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	S[0] = S[1] = 0.0;
	for (int i = 0; i < 4 && !status; i++) { /* the first is of any phase, and each moves it by less */
		struct hawser_ropeway_statics st;

		status = hawser__ropeway_state(&st, frame, options,
		                               phase_of(frame->ropeway, passing->lane, 0.5*(S[0] + S[1])),
		                               report);
		if (status)
			break;
		extent(S, &st.lane[passing->lane], passing->tower);
		hawser_ropeway_statics_clear(&st);
	}
	return status;
}

static enum hawser_status solve(struct hawser_passing *passing, const struct hawser__frame *frame,
                                const struct hawser_ropeway_options *options, double reach, int points,
                                struct hawser_report *report)
{
	const struct hawser_ropeway *rw = frame->ropeway;
	double S[2], middle, toward = passing->lane == HAWSER_ROPEWAY_UP ? 1.0 : -1.0;
	enum hawser_status status = find(S, passing, frame, options, report);

	if (status)
		return status;
	middle = 0.5*(S[0] + S[1]);
	reach = reach > 0.0 ? reach : fmax(rw->tower[passing->tower].radius, 2.0);
	reach = fmin(reach, 0.5*rw->spacing - 0.5*(S[1] - S[0])) + 0.5*(S[1] - S[0]);
	if (!(reach > 0.0))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "passing", "carriers.spacing = %.6g "
		                                                               "m is not "
		                    "above the contact with tower %s, %.6g m: no carrier passes it alone",
		                    rw->spacing, rw->tower[passing->tower].name, S[1] - S[0]);
	passing->row = calloc((size_t)points, sizeof *passing->row);
	if (!passing->row)
		return hawser__no_memory(report, "passing");
	for (int i = 0; i < points && !status; i++) {
		double from = (points > 1 ? 2.0*i/(points - 1) - 1.0 : 0.0)*reach;

		status = one_row(&passing->row[i], passing, frame, options, middle + toward*from, report);
		passing->row[i].t = from/rw->speed;
		passing->rows = i + 1;
	}
	return status;
}

enum hawser_status hawser_passing_solve(struct hawser_passing *passing, const struct hawser_ropeway *rw,
                                        int load_case, int lane, int tower, double reach, int points,
                                        struct hawser_report *report)
{
	const struct hawser_ropeway_options options = {.load_case = load_case, .tolerate = 1};
	struct hawser__frame frame;
	enum hawser_status status;

	*passing = (struct hawser_passing){.lane = lane, .tower = tower};
	points = points > 0 ? points : POINTS;
	if (load_case < 0 || load_case >= rw->cases || lane < 0 || lane >= rw->lanes || tower < 0 ||
	    tower >= rw->towers || points > MOST || !isfinite(reach))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "passing", "load case %d of %d, lane %d "
		                                                            "of %d, "
		                    "tower %d of %d, %d points, reach %g m: there is no such place",
		                    load_case, rw->cases, lane, rw->lanes, tower, rw->towers, points, reach);
	if (!(rw->speed > 0.0) || rw->sliding == HAWSER_ROPEWAY_REST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "passing", "a carrier passes a battery "
		                                                            "of a rope "
		                    "that runs: give top.drive.speed above 0, without sliding: rest");
	if (!(rw->spacing > 0.0) || !(rw->load_case[load_case].mass[lane] > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "passing", "case %s has no carriers on "
		                                                            "lane %s: "
		                    "give carriers.spacing and carriers.mass", rw->load_case[load_case].name,
		                    lane ? "down" : "up");
	status = hawser__frame_open(&frame, rw, report);
	if (!status)
		status = hawser__frame_refer(&frame, report);
	if (!status)
		status = solve(passing, &frame, &options, reach, points, report);
	hawser__frame_clear(&frame);
	if (status)
		hawser_passing_clear(passing);
	return hawser__in_file(report, status, rw->name);
}

void hawser_passing_clear(struct hawser_passing *passing)
{
	if (!passing)
		return;
	free(passing->row);
	memset(passing, 0, sizeof *passing);
}
