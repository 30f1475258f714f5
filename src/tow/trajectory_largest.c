/* tow/trajectory_largest.c - the largest speed, acceleration, jerk and snap of a path.
 *
 * The squared norm is a polynomial within a piece (or smooth): samples, then a golden section about
 * the best. Jumps are at ends of pieces, which are samples on both sides.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "tow/trajectory.h"

enum { SAMPLES = 24,  /* of a piece: a squared norm of degree 26 has at most 13 maxima */
       SECTIONS = 40, /* of the golden section: a width of 0.618^40 = 4e-9, an error of its square */
       STEPS = 2000   /* samples of a flight that is not made of pieces */ };
#define GOLDEN 0.6180339887498949 /* (sqrt(5) - 1)/2 */

struct search {
	struct hawser_path_largest *largest;
	const struct hawser_path *path;
	struct hawser_report *report;
};

static enum hawser_status norms(double norm[HAWSER_PATH_ORDERS], const struct search *s, double t)
{
	double state[HAWSER_PATH_ORDERS][3];
	enum hawser_status status = hawser_path_at(state, s->path, t, s->report);

	for (int k = 0; k < HAWSER_PATH_ORDERS && !status; k++) {
		norm[k] = hypot(hypot(state[k][0], state[k][1]), state[k][2]);
		if (!isfinite(norm[k]))
			status = hawser__fail(s->report, HAWSER_ERR_NAN, "trajectory", "a derivative of the "
			                      "path at %.10g s is beyond double precision", t);
		else if (k && norm[k] > s->largest->value[k]) {
			s->largest->value[k] = norm[k];
			s->largest->t[k] = t;
		}
	}
	return status;
}

/* Between two times about a sample that is larger than its neighbours in this order. */
static enum hawser_status refine(const struct search *s, int order, double low, double high)
{
	double norm[2][HAWSER_PATH_ORDERS], t[2];
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < SECTIONS && !status; i++) {
		t[0] = high - GOLDEN*(high - low);
		t[1] = low + GOLDEN*(high - low);
		status = norms(norm[0], s, t[0]);
		if (!status)
			status = norms(norm[1], s, t[1]);
		if (norm[0][order] > norm[1][order])
			high = t[1];
		else
			low = t[0];
	}
	return status;
}

static enum hawser_status piece(const struct search *s, double from, double to, int samples)
{
	double norm[3][HAWSER_PATH_ORDERS], step = (to - from)/samples;
	enum hawser_status status = norms(norm[0], s, from);

	if (!status)
		status = norms(norm[1], s, from + step);
	for (int i = 2; i <= samples && !status; i++) {
		/* the end of a piece, not the beginning of the next one, whose derivatives may differ */
		status = norms(norm[2], s, i < samples ? from + i*step : nextafter(to, from));
		for (int k = 1; k < HAWSER_PATH_ORDERS && !status; k++)
			if (norm[1][k] >= norm[0][k] && norm[1][k] >= norm[2][k] &&
			    norm[1][k] > 0.9*s->largest->value[k]) /* others cannot be the largest */
				status = refine(s, k, from + (i - 2)*step, from + i*step);
		memmove(norm[0], norm[1], 2*sizeof norm[0]);
	}
	return status;
}

enum hawser_status hawser_path_largest(struct hawser_path_largest *largest,
                                             const struct hawser_path *trajectory, double from,
                                             double to, struct hawser_report *report)
{
	struct search s = {largest, trajectory, report};
	double end = fmin(to, trajectory->ramp_time);
	enum hawser_status status = HAWSER_OK;

	memset(largest, 0, sizeof *largest);
	for (int k = 1; k < HAWSER_PATH_ORDERS; k++)
		largest->t[k] = from;
	if (!(from < to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "trajectory",
		                    "the range of time from %.10g to %.10g s is empty", from, to);
	for (int i = 0; i < trajectory->pieces && !status; i++) {
		double low = fmax(from, trajectory->time[i]), high = fmin(to, trajectory->time[i + 1]);

		if (low < high)
			status = piece(&s, low, high, SAMPLES);
	}
	if (trajectory->kind == HAWSER_PATH_WAYPOINTS)
		return status;
	if (from < end)
		status = piece(&s, from, end, STEPS);
	return status || !(to > end) ? status : piece(&s, fmax(from, end), to, 2);
}
