/* cli/statics/obstacles_fill.c - the rows that hawser statics shows of a span over obstacles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "core/report.h"

enum { HALVINGS = 60 }; /* to the last digit of a place */

static const char *const side_name[] = {"above", "below"};
static const char *const rotation_name[] = {"locked", "free", "drive"};

/* S at which the rope has this x (by_slope 0) or this slope angle, which grows with S within the
 * piece. */
static double place(const struct hawser_line_statics *st, double low, double high, double value,
                    int by_slope)
{
	for (int i = 0; i < HALVINGS; i++) {
		double S = 0.5*(low + high), x[2], angle;

		hawser_line_at(st, x, &angle, NULL, NULL, NULL, S);
		*((by_slope ? angle : x[0]) < value ? &low : &high) = S;
	}
	return 0.5*(low + high);
}

/* Largest vertical distance from the chord: where the slope is that of the chord. */
static double sag_of(const struct hawser_line_statics *st, const struct hawser_line_piece *piece)
{
	double dx = piece->x1[0] - piece->x0[0], slope = (piece->x1[1] - piece->x0[1])/dx, x[2];

	hawser_line_at(st, x, NULL, NULL, NULL, NULL,
	               place(st, piece->S0, piece->S1, atan(slope), 1));
	return fmax(piece->x0[1] + slope*(x[0] - piece->x0[0]) - x[1], 0.0);
}

/* Free piece k of a line, or NULL. */
static const struct hawser_line_piece *free_piece(const struct hawser_line_statics *st, int k)
{
	for (int i = 0; i < st->pieces; i++)
		if (st->piece[i].sheave < 0 && k-- == 0)
			return &st->piece[i];
	return NULL;
}

static int same_contacts(const struct hawser_line_statics *a, const struct hawser_line_statics *b)
{
	int same = a->line->sheaves == b->line->sheaves;

	for (int i = 0; i < a->line->sheaves && same; i++)
		same = a->contact[i].touches == b->contact[i].touches;
	return same;
}

/* Horizontal tension of span k of a limit that has the same contacts, else NAN. */
static double limit_H(const struct cli_obstacles *of, int toward, int k)
{
	const struct hawser_obstacles_limit *limit = &of->st.slide[toward];
	const struct hawser_line_piece *piece;

	if (!of->st.friction || limit->status || !same_contacts(&of->st.st, &limit->st))
		return NAN;
	piece = free_piece(&limit->st, k);
	return piece ? piece->T0*cos(piece->angle0) : NAN;
}

static void fill_spans(struct cli_obstacles *of)
{
	const struct hawser_line_statics *st = &of->st.st;
	const char *before = "A";
	int sheave = 0;

	for (const struct hawser_line_piece *piece; (piece = free_piece(st, of->spans)); of->spans++) {
		struct cli_obstacle_span *to = &of->span[of->spans];
		const char *behind;

		while (sheave < of->obstacles && !of->obstacle[sheave].touches)
			sheave++;
		behind = sheave < of->obstacles ? of->obstacle[sheave++].name : "B";
		snprintf(to->name, sizeof to->name, "%s to %s", before, behind);
		before = behind;
		to->label = to->name;
		to->H = piece->T0*cos(piece->angle0);
		to->T_from = piece->T0;
		to->T_to = piece->T1;
		to->angle_from = piece->angle0;
		to->angle_to = piece->angle1;
		to->length0 = piece->S1 - piece->S0;
		to->sag = sag_of(st, piece);
		memcpy(to->from, piece->x0, sizeof to->from);
		memcpy(to->to, piece->x1, sizeof to->to);
		for (int k = 0; k < 2; k++)
			to->H_toward[k] = limit_H(of, k, of->spans);
	}
}

static void fill_obstacle(struct cli_obstacle *to, const struct cli_obstacles *of, int i)
{
	const struct hawser_line_sheave *sheave = &of->scene.line.sheave[i];
	const struct hawser_line_contact *c = &of->st.st.contact[i];
	double mean = 0.5*(c->angle_in + c->angle_out);

	*to = (struct cli_obstacle){.name = sheave->name, .side = side_name[sheave->side < 0],
		.rotation = rotation_name[of->scene.obstacle[i].rotation], .touches = c->touches, .c = *c};
	if (!c->touches)
		return;
	to->H_in = c->T_in*cos(c->angle_in);
	to->H_out = c->T_out*cos(c->angle_out);
	to->pressing = sheave->side*(c->force[1]*cos(mean) - c->force[0]*sin(mean));
	for (int k = 0; k < 2; k++) {
		double angle = k ? c->angle_out : c->angle_in, *at = k ? to->to : to->from;

		at[0] = sheave->centre[0] - sheave->side*sheave->radius*sin(angle);
		at[1] = sheave->centre[1] + sheave->side*sheave->radius*cos(angle);
	}
}

static void fill_points(struct cli_obstacles *of, int points)
{
	const struct hawser_line_statics *st = &of->st.st, *clear = &of->st.clear.st;

	for (; of->points < points; of->points++) {
		struct cli_obstacle_point *to = &of->point[of->points];
		double x[2];

		to->S = st->length0*of->points/(points - 1);
		hawser_line_at(st, x, &to->angle, &to->T, NULL, NULL, to->S);
		to->x = x[0];
		to->y = x[1];
		to->y_clear = NAN;
		if (of->st.clear.status)
			continue;
		hawser_line_at(clear, x, NULL, NULL, NULL, NULL,
		               place(clear, 0.0, clear->length0, to->x, 0));
		to->y_clear = x[1];
	}
}

enum hawser_status cli_obstacles_fill(struct cli_obstacles *of, int points,
                                      struct hawser_report *report)
{
	enum hawser_status status = cli_read_obstacles(&of->scene, of->common, report);

	if (!status)
		status = hawser_obstacles_solve(&of->st, &of->scene, report);
	if (status)
		return status;
	of->obstacle = calloc((size_t)of->scene.line.sheaves, sizeof *of->obstacle);
	of->span = calloc((size_t)of->st.st.pieces + 1, sizeof *of->span);
	of->point = calloc((size_t)points + 1, sizeof *of->point);
	if (!of->obstacle || !of->span || !of->point)
		return hawser__no_memory(report, "statics");
	for (; of->obstacles < of->scene.line.sheaves; of->obstacles++)
		fill_obstacle(&of->obstacle[of->obstacles], of, of->obstacles);
	fill_spans(of);
	fill_points(of, points);
	return HAWSER_OK;
}

void cli_obstacles_warn(const struct cli_obstacles *of)
{
	char text[CLI_WARNING_SIZE];

	for (int i = 0; i < of->obstacles; i++) {
		if (of->obstacle[i].touches)
			continue;
		snprintf(text, sizeof text, "the rope does not touch obstacle %s: it passes at a distance of "
		         "%.4g m", of->obstacle[i].name, of->obstacle[i].c.clearance);
		cli_warn(text);
	}
}

void cli_obstacles_clear(struct cli_obstacles *of)
{
	hawser_obstacles_statics_clear(&of->st);
	hawser_obstacles_clear(&of->scene);
	free(of->obstacle);
	free(of->span);
	free(of->point);
}
