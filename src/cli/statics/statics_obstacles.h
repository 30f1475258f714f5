/* cli/statics/statics_obstacles.h - what hawser statics and modes show of a span over obstacles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_OBSTACLES_H
#define HAWSER_CLI_STATICS_OBSTACLES_H

#include "cli/statics/statics_kinds.h"

enum { CLI_OBSTACLES_SPAN = 2*HAWSER_LINE_NAME + 4 };

/* An obstacle, and what the rope does there. */
struct cli_obstacle {
	const char *name, *side, *rotation;
	int touches;
	struct hawser_line_contact c;
	double H_in, H_out;     /* N, horizontal tensions before and behind */
	double pressing;        /* N, force by which the rope is pressed on the circle */
	double from[2], to[2];  /* m, first and last point of contact */
};

/* A free part of the rope. */
struct cli_obstacle_span {
	char name[CLI_OBSTACLES_SPAN]; /* "A to s0" */
	const char *label;             /* the same */
	double H, T_from, T_to, angle_from, angle_to, length0, sag;
	double from[2], to[2];         /* m */
	double H_toward[2];            /* N, about to slide toward A, toward B; NAN: not known */
};

/* A point of the rope, and the height of the same rope without obstacles. */
struct cli_obstacle_point {
	double S, x, y, angle, T, y_clear;
};

struct cli_obstacles {
	const struct cli_common *common;
	int spans_wanted;               /* 1: table of the spans */
	struct hawser_obstacles scene;
	struct hawser_obstacles_statics st;
	struct cli_obstacle *obstacle;  /* [obstacles] */
	struct cli_obstacle_span *span; /* [spans] */
	struct cli_obstacle_point *point; /* [points] */
	int obstacles, spans, points;
};

enum { CLI_OBSTACLES_FRICTION = 1, CLI_OBSTACLES_CLEAR = 2 }; /* bits of the view */

/* obstacles_fill.c: read the scene and solve it; rows from the state, with this number of points. */
enum hawser_status cli_obstacles_fill(struct cli_obstacles *of, int points,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Warnings of obstacles that the rope passes without contact. */
void cli_obstacles_warn(const struct cli_obstacles *of);
void cli_obstacles_clear(struct cli_obstacles *of);

/* obstacles_fields.c */
extern const struct hawser__list cli_obstacle_span_list, cli_obstacle_point_list;
extern const struct hawser__field cli_obstacle_field[], cli_obstacles_field[];
unsigned cli_obstacles_view(const struct cli_obstacles *of);

#endif
