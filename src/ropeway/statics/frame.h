/* ropeway/statics/frame.h - what the states of a ropeway have in common: the sides and the
 * inclinations of its batteries, and the length of its rope.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_FRAME_H
#define HAWSER_ROPEWAY_FRAME_H

#include <hawser/ropeway.h>

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
