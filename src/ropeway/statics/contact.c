/* ropeway/statics/contact.c - what the rope of a lane does at its towers and between them.
 *
 * A span is the rope between two towers: from the last point at which it touches the one to the
 * first at which it touches the next. A tower that it does not touch divides it where it is
 * nearest.
 *
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/statics/line.h"

/* Where the rope touches a sheave. Pieces without length are not in the list: then it is the end of
 * a piece that is at the sheave's circle. */
static void touch(double S[2], const struct hawser_line_statics *st, int sheave)
{
	const struct hawser_line_sheave *at = &st->line->sheave[sheave];
	double nearest = INFINITY;
	int found = 0;

	S[0] = S[1] = 0.0;

	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];
		double gap =
			fabs(hypot(piece->x1[0] - at->centre[0], piece->x1[1] - at->centre[1]) - at->radius);

		if (piece->sheave == sheave) {
			S[0] = found ? S[0] : piece->S0;
			S[1] = piece->S1;
			found = 1;
		} else if (!found && gap < nearest) {
			nearest = gap;
			S[0] = S[1] = piece->S1;
		}
	}
}

/* S of the place at which the rope crosses the vertical through x. */
static double crossing(const struct hawser_line_statics *st, double x)
{
	double low = 0.0, high = st->length0, at[2];

	for (int i = 0; i < 60; i++) { /* to the last digit of S */
		double S = 0.5*(low + high);

		hawser_line_at(st, at, NULL, NULL, NULL, NULL, S);
		*(at[0] < x ? &low : &high) = S;
	}
	return 0.5*(low + high);
}

/* A tower that is not touched: T, slope and distance of the rope that passes. S gets the place. */
static void untouched(struct hawser_ropeway_contact *to, double S[2],
                      const struct hawser_ropeway_lane *lane, int tower,
                      const struct hawser_ropeway *rw)
{
	double at[2], angle, T;

	S[0] = S[1] = crossing(&lane->st, rw->tower[tower].at[0]);
	hawser_line_at(&lane->st, at, &angle, &T, NULL, NULL, S[0]);
	to->T_in = to->T_out = to->T_out_min = to->T_out_max = T;
	to->angle_in = to->angle_out = angle;
	to->clearance = INFINITY;
	for (int j = lane->first[tower]; j < lane->first[tower + 1]; j++)
		to->clearance = fmin(to->clearance, lane->st.contact[j].clearance);
}

/* The tower's contact is the sum of those of its sheaves. */
static void contact(struct hawser_ropeway_contact *to, double S[2],
                    const struct hawser_ropeway_lane *lane, int tower,
                    const struct hawser__frame *frame)
{
	const struct hawser_ropeway *rw = frame->ropeway;
	double lowest = 1.0, highest = 1.0, P[2], mean, at[2];

	S[0] = S[1] = 0.0;
	to->pressure = INFINITY;
	for (int j = lane->first[tower]; j < lane->first[tower + 1]; j++) {
		const struct hawser_line_contact *c = &lane->st.contact[j];

		if (!c->touches)
			continue;
		touch(at, &lane->st, j);
		if (!to->touches++) {
			to->T_in = c->T_in;
			to->angle_in = c->angle_in;
			S[0] = at[0];
		}
		S[1] = at[1];
		to->T_out = c->T_out;
		to->angle_out = c->angle_out;
		to->wrap += c->wrap;
		for (int k = 0; k < 2; k++)
			to->reaction[k] += c->force[k];
		to->pressure = fmin(to->pressure, c->pressure_min);
		to->sheave_force = fmax(to->sheave_force, hypot(c->force[0], c->force[1]));
		to->sheave_wrap = fmax(to->sheave_wrap, c->wrap);
		lowest *= c->T_out_min/c->T_out;
		highest *= c->T_out_max/c->T_out;
	}
	if (!to->touches) {
		to->pressure = 0.0;
		untouched(to, S, lane, tower, rw);
		return;
	}
	to->T_out_min = to->T_out*lowest;
	to->T_out_max = to->T_out*highest;
	mean = 0.5*(to->angle_in + to->angle_out);
	to->pressing = frame->side[tower]*(to->reaction[1]*cos(mean) - to->reaction[0]*sin(mean));
	for (int k = 0; k < 2; k++)
		P[k] = hawser__apparent(rw, k ? to->T_out : to->T_in, lane->line->speed);
	to->margin = rw->tower[tower].friction*to->wrap - fabs(log(P[1]/P[0]));
}

/* Length of the rope from S0 to S1, within one piece: Gauss' rule with 5 points, since the stretch
 * is nearly linear. */
static double stretched(const struct hawser_line_statics *st, double S0, double S1)
{
	static const double place[] = {0.0, 0.5384693101056831, 0.9061798459386640};
	static const double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
	double sum = 0.0, stretch;

	for (int i = 0; i < 3; i++)
		for (int side = -1; side <= (i ? 1 : -1); side += 2) {
			hawser_line_at(st, NULL, NULL, NULL, &stretch, NULL,
			               0.5*(S0 + S1 + side*place[i]*(S1 - S0)));
			sum += weight[i]*stretch;
		}
	return 0.5*(S1 - S0)*sum;
}

/* Vertical distance of a point from the chord of the span, and the largest of a piece from S0 to S1. */
static double below(const struct hawser_ropeway_span *span, const double x[2])
{
	double part = (x[0] - span->from[0])/(span->to[0] - span->from[0]);

	return span->from[1] + part*(span->to[1] - span->from[1]) - x[1];
}

static double deepest(const struct hawser_line_statics *st, const struct hawser_ropeway_span *span,
                      double S0, double S1)
{
	double chord = atan2(span->to[1] - span->from[1], span->to[0] - span->from[0]), low = S0, high = S1;
	double x[2], angle;

	for (int i = 0; i < 30; i++) { /* the distance is flat there: 1e-9 of S is enough */
		double S = 0.5*(low + high);

		hawser_line_at(st, NULL, &angle, NULL, NULL, NULL, S);
		*(angle < chord ? &low : &high) = S;
	}
	hawser_line_at(st, x, NULL, NULL, NULL, NULL, 0.5*(low + high));
	return below(span, x);
}

/* The least tension of a piece: at its lowest point or its lower end. */
static double lowest(const struct hawser_line_piece *piece, const struct hawser_line *line)
{
	const struct hawser_ropeway rope = {.EA = line->EA, .rho = line->rho};

	if (piece->sheave >= 0 || !(piece->angle0 < 0.0 && piece->angle1 > 0.0))
		return fmin(piece->T0, piece->T1);
	return hawser__actual(&rope, hawser__apparent(&rope, piece->T0, line->speed)*cos(piece->angle0),
	                      line->speed);
}

static void span_ends(struct hawser_ropeway_span *span, const struct hawser_line_statics *st,
                      const struct hawser_ropeway_contact *from,
                      const struct hawser_ropeway_contact *to)
{
	hawser_line_at(st, span->from, NULL, NULL, NULL, NULL, span->S_from);
	hawser_line_at(st, span->to, NULL, NULL, NULL, NULL, span->S_to);
	span->T_from = from ? from->T_out : st->T_A;
	span->T_to = to ? to->T_in : st->T_B;
	span->angle_from = from ? from->angle_out : st->angle_A;
	span->angle_to = to ? to->angle_in : st->angle_B;
	span->length0 = span->S_to - span->S_from;
	span->T_max = fmax(span->T_from, span->T_to);
	span->T_min = fmin(span->T_from, span->T_to);
}

/* `piece`: where to begin in the list of pieces; moved on. */
static void describe_span(struct hawser_ropeway_span *span, const struct hawser_line_statics *st,
                          int *piece)
{
	for (; *piece < st->pieces; ++*piece) {
		const struct hawser_line_piece *one = &st->piece[*piece];
		double S0 = fmax(one->S0, span->S_from), S1 = fmin(one->S1, span->S_to);

		if (one->S0 >= span->S_to)
			break;
		if (!(S1 > S0))
			continue;
		span->length += stretched(st, S0, S1);
		span->sag = fmax(span->sag, deepest(st, span, S0, S1));
		span->T_max = fmax(span->T_max, fmax(one->T0, one->T1)); /* T is convex in S */
		span->T_min = fmin(span->T_min, lowest(one, st->line));
		if (one->S1 > span->S_to)
			break;
	}
}

enum hawser_status hawser__lane_describe(struct hawser_ropeway_lane *lane,
                                         const struct hawser__frame *frame,
                                         struct hawser_report *report)
{
	const struct hawser_ropeway *rw = frame->ropeway;
	int towers = rw->towers, piece = 0;
	double S[2] = {0.0, 0.0};

	lane->contact = calloc((size_t)towers + 1, sizeof *lane->contact);
	lane->span = calloc((size_t)towers + 1, sizeof *lane->span);
	if (!lane->contact || !lane->span)
		return hawser__no_memory(report, "ropeway");
	for (int i = 0; i < towers; i++) {
		contact(&lane->contact[i], S, lane, i, frame);
		lane->span[i].S_to = S[0];
		lane->span[i + 1].S_from = S[1];
	}
	lane->span[towers].S_to = lane->st.length0;
	for (int i = 0; i <= towers; i++) {
		span_ends(&lane->span[i], &lane->st, i ? &lane->contact[i - 1] : NULL,
		          i < towers ? &lane->contact[i] : NULL);
		describe_span(&lane->span[i], &lane->st, &piece);
	}
	while (lane->carriers < lane->line->masses && lane->st.carrier[lane->carriers].present)
		lane->carriers++;
	return HAWSER_OK;
}
