/* ropeway/statics/line.h - internal: parts of hawser_line_solve().
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_LINE_H
#define HAWSER_ROPEWAY_LINE_H

#include <hawser/obstacles.h>
#include <hawser/ropeway.h>

#include "core/hold.h"
#include "ropeway/statics/rope.h"

/* --- march.c: the rope laid from end A over its sheaves to end B --- */

/* Why there is no rope. */
enum hawser__fault {
	HAWSER__NO_FAULT = 0,
	HAWSER__FAULT_TOO_LOW, /* the tension is too low to come down to the target `to` behind `from` */
	HAWSER__FAULT_LOST     /* the sheaves that the rope presses were not found */
};

struct hawser__march {
	const struct hawser_line *line;
	const double *A;             /* [2] */
	struct hawser__rope rope;
	struct hawser__target *target; /* [sheaves + 1], end B last */
	struct hawser__path *start;  /* [sheaves + 1] begin of the path of each sheave that is pressed,
	    A first */
	int *index, *pieces, *pending; /* [sheaves +
	                                   1] its sheave; pieces laid before; mass pending there */
	char *off;                   /* [sheaves] 1: the rope passes this sheave without contact */
	char *kept;                  /* [sheaves] another such set */
	struct hawser__rope_trace trace;
	int sheaves;
	int slack_behind;            /* the span behind this sheave (-1: A) is slack; -2: none is */
	enum hawser__fault fault;
	int from, to;                /* sheaves of a fault */
	int iterations;              /* ropes laid */
	struct hawser__rope_point begin, end; /* ends A and B */
	double miss;                 /* m, how far from B the rope ends */
	struct hawser__hold hold;
};

enum hawser_status hawser__march_open(struct hawser__march *march, struct hawser_line_statics *st,
                                      const struct hawser_line *line, struct hawser_report *report);
void hawser__march_clear(struct hawser__march *march);
/* Lay the rope with P at A. Returns 1 if it reaches B in equilibrium, pressing each sheave that
 * is not `off`. */
int hawser__march(struct hawser__march *march, double P);
/* The least index whose sheave the rope penetrates without contact, by more than round-off; -1:
 * none. Sets the clearances of the sheaves without contact. */
int hawser__march_clearances(struct hawser__march *march);
/* The sheaves that the rope presses, by looking ahead from each. Slower than hawser__march, and
 * sure. Sets `off`. */
int hawser__march_ahead(struct hawser__march *march, double P);

enum hawser_status hawser__line_check(const struct hawser_line *line, struct hawser_report *report);
enum { HAWSER__LINE_CALLED = HAWSER_LINE_NAME + 44 }; /* size of such a name */
/* "sheave 3 (p2, line 7)", or "end A" for a number below 0, "end B" for one above the last. */
const char *hawser__line_name(char text[HAWSER__LINE_CALLED], const struct hawser_line *line,
                              int sheave);
/* Friction coefficient that acts on a sheave; > 0: the tension grows towards B. */
double hawser__line_grip(const struct hawser_line *line, int sheave);
/* S at the first and at the last point of contact with a sheave that is touched. */
void hawser__line_touch(double *from, double *to, const struct hawser_line_statics *st, int sheave);
/* Convert what the march has laid to the result, and check it. */
void hawser__line_finish(struct hawser_line_statics *st, struct hawser__march *march);
void hawser__line_release(struct hawser_line_statics *st);
/* The arc of a piece on a sheave. */
struct hawser__arc hawser__line_arc(const struct hawser_line *line,
                                    const struct hawser_line_piece *piece, double T0);
/* The rope at rest that has the shape of the line's; without masses. */
struct hawser__rope hawser__line_rope(const struct hawser_line *line);

/* --- history.c: friction that follows from the order in which a rope is paid in and out --- */

/* Walk the path of contact.sliding: history. st->held, st->path and st->line[0] are set; the caller
 * releases st. HAWSER_ERR_NO_SOLUTION (the report says at which value of the path), _CONVERGENCE,
 * _MEMORY. */
enum hawser_status hawser__obstacles_history(struct hawser_obstacles_statics *st,
                                             const struct hawser_obstacles *obstacles,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- frame.c: what the states of a ropeway have in common: the sides and the inclinations of
 * its batteries, and the length of its rope --- */

struct hawser__frame {
	const struct hawser_ropeway *ropeway;
	int *side;        /* [towers] 1 support, -1 compression */
	double *slope;    /* [towers] rad, of the rope at the tower */
	double tension;   /* N, at the bottom: of the catenaries */
	double reach;     /* m: no rope of this line is longer */
	int sheaves;      /* of all towers */
	int trains;       /* 1: some towers have trains of sheaves */
	double reference; /* m, unstretched length of the loop: of the empty rope, or as given */
};

/* Sides and slopes, from catenaries that are joined at the towers and carry the carriers of lane
 * `up` as weight per length; B 6.2.2, (6.8). `reference` is not set. */
enum hawser_status hawser__frame_open(struct hawser__frame *frame, const struct hawser_ropeway *ropeway,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__frame_clear(struct hawser__frame *frame);

enum { HAWSER__TENSION_GIVEN = 120 };
/* What the scene gives as tension of the bottom station, for the end of a message. Returns `text`. */
const char *hawser__tension_given(char text[HAWSER__TENSION_GIVEN], const struct hawser_ropeway *rw);
/* ", line 7,", or "" where the line is not known. */
enum { HAWSER__FILE_LINE = 24 };
const char *hawser__file_line(char text[HAWSER__FILE_LINE], int line);
/* Set the file's name before the message of a failure that belongs to the scene. Returns `status`. */
enum hawser_status hawser__in_file(struct hawser_report *report, enum hawser_status status,
                                   const char *name /* or NULL */);

/* What the rope carries and how it moves. */
struct hawser__loading {
	double mass;      /* kg of a carrier; 0: none */
	double first;     /* m, S of the first one */
	double P;         /* N, at end A: T - rho v^2 |x'| */
	double speed;     /* m/s */
	enum hawser_line_sliding sliding;
	int lift;         /* 1: sheaves that are not pressed are no error */
};

/* lane.c. Build the line of a lane and solve it. */
enum hawser_status hawser__lane_solve(struct hawser_ropeway_lane *lane,
                                      const struct hawser__frame *frame,
                                      const struct hawser__loading *loading,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__lane_clear(struct hawser_ropeway_lane *lane);
/* contact.c: fill in contacts, spans and carriers of a lane that is solved. */
enum hawser_status hawser__lane_describe(struct hawser_ropeway_lane *lane,
                                         const struct hawser__frame *frame,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* T - rho v^2 |x'| of a tension T (N), and back. */
double hawser__apparent(const struct hawser_ropeway *ropeway, double T, double speed);
double hawser__actual(const struct hawser_ropeway *ropeway, double P, double speed);

/* state.c: the state for a phase, with a frame whose reference is known. */
enum hawser_status hawser__ropeway_state(struct hawser_ropeway_statics *st,
                                         const struct hawser__frame *frame,
                                         const struct hawser_ropeway_options *options, double phase,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* state.c: set the reference. */
enum hawser_status hawser__frame_refer(struct hawser__frame *frame,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
