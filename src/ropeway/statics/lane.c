/* ropeway/statics/lane.c - one lane of a ropeway as a line: its sheaves, its carriers, its tension.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/statics/line.h"

enum { CARRIERS = 100000 }; /* most of a lane: more is a mistake in the spacing */

double hawser__apparent(const struct hawser_ropeway *rw, double T, double speed)
{
	return T - rw->rho*speed*speed*(1.0 + T/rw->EA);
}

double hawser__actual(const struct hawser_ropeway *rw, double P, double speed)
{
	double thrust = rw->rho*speed*speed;

	return (P + thrust)/(1.0 - thrust/rw->EA);
}

/* The circle of the battery, or the circles of its sheaves, which touch it from within and are
 * placed on both sides of the point at which the rope has the slope of the frame. */
static void battery(struct hawser_line *line, const struct hawser_ropeway_tower *tower, int side,
                    double slope)
{
	int count = tower->sheaves ? tower->sheaves : 1;
	double centre[2] = {tower->at[0], tower->at[1] - side*tower->radius};

	for (int j = 0; j < count; j++) {
		struct hawser_line_sheave *sheave = &line->sheave[line->sheaves++];
		double angle = slope + side*(0.5*(count - 1) - j)*tower->spacing/fmax(tower->radius, 1e-300);
		double inside = tower->sheaves ? tower->radius - tower->sheave : 0.0;

		*sheave = (struct hawser_line_sheave){
			.centre = {centre[0] - side*inside*sin(angle), centre[1] + side*inside*cos(angle)},
			.radius = tower->sheaves ? tower->sheave : tower->radius, .side = side,
			.friction = tower->friction, .inertia = tower->inertia,
			.file_line = tower->file_line};
		if (tower->sheaves)
			snprintf(sheave->name, sizeof sheave->name, "%.20s.%d", tower->name, j + 1);
		else
			snprintf(sheave->name, sizeof sheave->name, "%s", tower->name);
	}
}

static enum hawser_status carriers(struct hawser_line *line, const struct hawser__frame *frame,
                                   const struct hawser__loading *loading, struct hawser_report *report)
{
	const struct hawser_ropeway *rw = frame->ropeway;
	double count =
		loading->mass > 0.0 && rw->spacing > 0.0 ? floor(frame->reach/rw->spacing) + 1.0 : 0.0;

	if (count > CARRIERS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "ropeway",
		                    "carriers.spacing = %.9g m puts more "
		                    "than %d carriers on a lane of %.6g m: give a larger one",
		                    rw->spacing, CARRIERS, 0.5*frame->reach);
	line->mass = calloc((size_t)count + 1, sizeof *line->mass);
	if (!line->mass)
		return hawser__no_memory(report, "ropeway");
	for (int i = 0; i < (int)count; i++)
		if (loading->first + i*rw->spacing > 0.0) /* a carrier at S = 0 hangs on the station */
			line->mass[line->masses++] = (struct hawser_line_mass){
				.S = loading->first + i*rw->spacing, .mass = loading->mass, .hanger = rw->hanger};
	return HAWSER_OK;
}

static enum hawser_status build(struct hawser_ropeway_lane *lane, const struct hawser__frame *frame,
                                const struct hawser__loading *loading, struct hawser_report *report)
{
	const struct hawser_ropeway *rw = frame->ropeway;
	struct hawser_line *line = calloc(1, sizeof *line);

	lane->line = line;
	lane->first = calloc((size_t)rw->towers + 1, sizeof *lane->first);
	if (!line || !lane->first)
		return hawser__no_memory(report, "ropeway");
	*line = (struct hawser_line){.EA = rw->EA, .rho = rw->rho, .g = rw->g, .speed = loading->speed,
		.A = {rw->bottom[0], rw->bottom[1]}, .B = {rw->top[0], rw->top[1]}, .given = HAWSER_LINE_T_A,
		.value = hawser__actual(rw, loading->P, loading->speed), .sliding = loading->sliding,
		.lift = loading->lift || frame->trains};
	line->sheave = calloc((size_t)frame->sheaves + 1, sizeof *line->sheave);
	if (!line->sheave)
		return hawser__no_memory(report, "ropeway");
	for (int i = 0; i < rw->towers; i++) {
		lane->first[i] = line->sheaves;
		battery(line, &rw->tower[i], frame->side[i], frame->slope[i]);
	}
	lane->first[rw->towers] = line->sheaves;
	return carriers(line, frame, loading, report);
}

enum hawser_status hawser__lane_solve(struct hawser_ropeway_lane *lane,
                                      const struct hawser__frame *frame,
                                      const struct hawser__loading *loading,
                                      struct hawser_report *report)
{
	enum hawser_status status;

	memset(lane, 0, sizeof *lane);
	status = build(lane, frame, loading, report);
	if (!status)
		status = hawser_line_solve(&lane->st, lane->line, report);
	if (status)
		hawser__lane_clear(lane);
	return status;
}

void hawser__lane_clear(struct hawser_ropeway_lane *lane)
{
	hawser_line_statics_clear(&lane->st);
	if (lane->line) {
		free(lane->line->sheave);
		free(lane->line->mass);
	}
	free(lane->line);
	free(lane->first);
	free(lane->contact);
	free(lane->span);
	memset(lane, 0, sizeof *lane);
}
