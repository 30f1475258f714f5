/* hawser/transient.h - a ropeway that starts, brakes or runs: the motion of its rope along the line.
 *
 * The rope moves along its lanes as a chain of masses and springs on top of the exact statics of each
 * phase; each span's sag has one coordinate. Model and limits: doc/theory-ropeway-transient.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TRANSIENT_H
#define HAWSER_TRANSIENT_H

#include <hawser/ropeway.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_transient_event {
	HAWSER_TRANSIENT_START = 0, /* from rest to drive.speed in drive.ramp */
	HAWSER_TRANSIENT_STOP,      /* drive.brake acts from t = 0 on the rope that runs at drive.speed */
	HAWSER_TRANSIENT_RUN        /* at drive.speed */
};

struct hawser_transient_options {
	enum hawser_transient_event event;
	int load_case;     /* index of a case */
	int tolerate;      /* 1: a drive that slips, a battery that is not pressed and a carriage
	                    * beyond its stops are counted and not refused; the rope then slips */
	double until;      /* s; 0: 20 s after the ramp or the stop; of RUN two spacings of carriers */
	double every;      /* s, between rows; 0: a 500th of `until` */
	double step;       /* s; 0: half the time in which a wave passes a mean element */
	int elements;      /* of each span, odd; 0: 7 */
	double damping;    /* ratio to critical damping of a wave along the rope that runs around the
	                    * loop in one period, by losses in the rope; 0: none */
	int phases;        /* of the statics, equidistant over the spacing; 0: 200 */
	int threads;       /* of the statics; 0: hawser's default */
	int skip_error;    /* 1: without the second run that estimates the error */
};
void hawser_transient_settle(struct hawser_transient_options *options);

struct hawser_transient_row {
	double t;              /* s */
	double travelled;      /* m, of the rope at the drive since t = 0 */
	double speed, wheel;   /* m/s, of the rope at the drive and of the bullwheel's surface */
	double force;          /* N, of the bullwheel on the rope, in the direction of running */
	double motor;          /* N, at the bullwheel's circumference: of the drive or of the brake */
	double limit;          /* N, largest |force| before the rope slips; NAN without drive.friction */
	double needed_friction; /* of the drive bullwheel */
	double slip_arc;       /* rad, on which the rope slips on the drive bullwheel; NAN: as above */
	double T_up, T_down;   /* N, of the lanes at the drive */
	double T_bottom_up, T_bottom_down; /* N, at the bottom bullwheel */
	double travel, travel_speed; /* m, m/s, of the carriage, towards the line */
	double T_min, T_max;   /* N, in all spans */
	double pressing;       /* N, least of all batteries */
	double acceleration;   /* m/s^2, largest of the rope along the line, with its sign */
};

/* Least and largest value over time, and when. */
struct hawser_transient_range {
	double min, max, at_min, at_max; /* at: s */
};
struct hawser_transient_place {
	int lane, index;       /* of a span or of a tower, from the bottom station */
	struct hawser_transient_range T;        /* N, in a span; on both sides of a tower */
	struct hawser_transient_range other;    /* of a span: growth of its sag, m; of a tower: force
	                                         * that presses the rope on its battery, N */
	struct hawser_transient_range acceleration; /* m/s^2, of the rope there */
};

/* J. kinetic + stored = work + slow - dissipated since t = 0. */
struct hawser_transient_energy {
	double kinetic, stored;  /* changes since t = 0; stored: by tensions other than of statics */
	double work;             /* of drive or brake */
	double slow;             /* of weights and tensions of the statics whose phase changes */
	double dissipated;       /* on batteries, at the bottom bullwheel, by slip on the drive, in
	                          * the rope */
	double exchanged;        /* part of `slow`: of carriers that pass from node to node */
	double closure;          /* largest defect of the balance over the largest term */
};

struct hawser_transient {
	const struct hawser_ropeway *ropeway; /* the caller's; not released */
	struct hawser_transient_options options; /* as used */
	struct hawser_transient_row *row;     /* [rows] */
	int rows, spans, towers;
	struct hawser_transient_place *span;  /* [spans] of both lanes */
	struct hawser_transient_place *tower; /* [towers] of both lanes */
	struct hawser_transient_energy energy;
	/* Of all steps: */
	struct hawser_transient_range force, T, needed_friction, slip_arc, travel, acceleration;
	double mass;             /* kg, that moves with the rope at t = 0, with wheels and sheaves */
	double rest_force;       /* N, of the drive that holds the ropeway at t = 0 without friction */
	double stopped_at;       /* s, when the rope at the drive comes to rest for good; NAN: never */
	double slipped;          /* m, of rope on the bullwheel */
	double creep;            /* largest |T_up - T_down|/EA: difference of the rope's speeds on the
	                          * bullwheel by its stretch, over the speed */
	long slips, lifts, stops; /* steps in which the rope slipped, a battery was not pressed, .. */
	double lifts_at;         /* s, the first one; NAN */
	long steps, solves;
	double error_force, error_T, error_travel; /* N, N, m: from a run with half the elements and
	                                            * steps twice as long; NAN: skipped */
};

/* HAWSER_ERR_ARGUMENT: a key that the event needs is missing or 0; HAWSER_ERR_NO_SOLUTION: the statics
 * has no solution, the rope slips on the drive, leaves a battery, becomes slack, the carriage reaches a
 * stop; HAWSER_ERR_CONVERGENCE, _NAN, _MEMORY. The report says where, when and by how much. */
enum hawser_status hawser_transient_solve(struct hawser_transient *run,
                                          const struct hawser_ropeway *ropeway,
                                          const struct hawser_transient_options *options /* or NULL */,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_transient_clear(struct hawser_transient *run);

/* --- a carrier passes a battery, at constant speed: exact statics --- */

struct hawser_passing_row {
	double t;              /* s; 0: the carrier is in the middle of the contact */
	double phase, S;       /* m: of the carriers; of this carrier on its lane */
	double x[2];           /* m, of the carrier's grip */
	int state;             /* of struct hawser_line_carrier */
	double angle_before, angle_after; /* rad, slopes of the rope at the carrier */
	double carried;        /* N, of the carrier's weight by the battery */
	struct hawser_ropeway_contact contact; /* at the tower */
};
struct hawser_passing {
	int lane, tower, rows;
	struct hawser_passing_row *row; /* [rows] */
};
/* The carrier passes from `reach` (m; 0: a radius of the battery, at least 2 m) before the contact to
 * as far behind it, in `points` states (0: 201). */
enum hawser_status hawser_passing_solve(struct hawser_passing *passing,
                                        const struct hawser_ropeway *ropeway, int load_case,
                                        int lane, int tower, double reach, int points,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_passing_clear(struct hawser_passing *passing);

#ifdef __cplusplus
}
#endif
#endif
