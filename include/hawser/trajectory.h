/* hawser/trajectory.h - the path of a towing point in time: position and its derivatives up to
 * snap.
 *
 * A path through waypoints is made of polynomials in time, one between two waypoints: those with
 * the least integral of the squared snap (or jerk, or acceleration), or those of least degree with
 * given derivatives. Straight flight and circles begin with a ramp of the speed. Axes: x and z are
 * horizontal, y is upwards.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TRAJECTORY_H
#define HAWSER_TRAJECTORY_H

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Orders of derivative: 0 position (m), 1 velocity (m/s), 2 acceleration, 3 jerk, 4 snap (m/s^4). */
enum { HAWSER_PATH_ORDERS = 5, HAWSER_PATH_GIVEN = 7 };

/* What a path through waypoints minimises: the integral of |u''''|^2, |u'''|^2 or |u''|^2 by time;
 * or nothing, and each piece is the polynomial of least degree with the derivatives given at its
 * ends. */
enum hawser_minimise {
	HAWSER_MINIMISE_SNAP = 0, HAWSER_MINIMISE_JERK, HAWSER_MINIMISE_ACCELERATION,
	HAWSER_MINIMISE_NOTHING
};
const char *hawser_minimise_name(enum hawser_minimise minimise);

/* A point that is passed at a time, and derivatives that are given there. */
struct hawser_waypoint {
	double t;                                  /* s */
	double at[HAWSER_PATH_GIVEN][3];     /* [order][axis] m, m/s, m/s^2, ... */
	int given[HAWSER_PATH_GIVEN];        /* 1: at[order] is prescribed; [0] always is */
};

/* How the speed grows from 0 in a ramp. SMOOTH: a polynomial of degree 7, with acceleration, jerk
 * and snap continuous at both ends. ERF: (1 - erf(6 - 12 (t/T)^0.6))/2, D 5.2.2 with T = 32 s. */
enum hawser_path_ramp { HAWSER_PATH_RAMP_SMOOTH = 0, HAWSER_PATH_RAMP_ERF };

enum hawser_path_kind {
	HAWSER_PATH_WAYPOINTS = 0, HAWSER_PATH_STRAIGHT, HAWSER_PATH_ORBIT
};
const char *hawser_path_name(enum hawser_path_kind kind);

struct hawser_path {
	enum hawser_path_kind kind;
	double from, to;       /* s, where it is defined; `to` is infinite but for waypoints */
	/* Waypoints: pieces; each a polynomial in tau, which is -1 and 1 at its ends. */
	enum hawser_minimise minimise;
	int pieces, degree;    /* largest degree */
	double *time;          /* [pieces+1] s; owned */
	double *coefficient;   /* [pieces][3][degree+1] m, of powers of tau; owned */
	int smooth;            /* derivatives up to this order are continuous at waypoints */
	double cost;           /* integral of the squared norm of what is minimised (of snap if nothing),
	                        * m^2/s^7 of snap, m^2/s^5 of jerk, m^2/s^3 of acceleration */
	double error;          /* estimated relative error of the coefficients by round-off */
	/* All kinds: start, m; of an orbit its centre. */
	double origin[3];
	/* Straight flight and orbits. */
	double velocity[3];    /* m/s, of straight flight */
	double radius, speed;  /* m, m/s, of an orbit; speed > 0 turns x toward z */
	double ramp_time;      /* s; 0: full speed at once */
	enum hawser_path_ramp ramp;
};

/* A path through `count` waypoints point[count] in the order of time. Where a derivative is not
 * given, it is free: at an end the natural condition holds, between them the derivative is
 * continuous, and so are all others up to twice the order of what is minimised, less 2. *trajectory
 * is overwritten; release it with hawser_path_clear. On failure it is all zero.
 * HAWSER_ERR_ARGUMENT: times that do not increase or are too close for their digits, less
 * conditions than needed, derivatives that cannot be given, a number that is not finite;
 * HAWSER_ERR_CONVERGENCE: times so uneven that round-off spoils the result; HAWSER_ERR_MEMORY.
 * report->iteration is the index of the waypoint that an argument is about, or -1. */
enum hawser_status hawser_path_waypoints(struct hawser_path *trajectory,
                                               const struct hawser_waypoint *point,
                                               int count, enum hawser_minimise minimise,
                                               struct hawser_report *report) HAWSER_MUST_CHECK;

/* Straight flight from `start` (m) at this velocity (m/s), reached after `ramp_time` (s; 0: at
 * once). */
enum hawser_status hawser_path_straight(struct hawser_path *trajectory,
                                              const double start[3], const double velocity[3],
                                              double ramp_time, enum hawser_path_ramp ramp,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;

/* A horizontal circle about `centre` (m), begun at centre + [radius, 0, 0]. */
enum hawser_status hawser_path_orbit(struct hawser_path *trajectory,
                                           const double centre[3], double radius, double speed,
                                           double ramp_time, enum hawser_path_ramp ramp,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* Position and derivatives at a time, state [HAWSER_PATH_ORDERS][3]. At a waypoint, those after
 * it. HAWSER_ERR_ARGUMENT: a time outside of the path. */
enum hawser_status hawser_path_at(double (*state)[3], const struct hawser_path *trajectory,
                                        double t, struct hawser_report *report) HAWSER_MUST_CHECK;

/* Largest norms of velocity, acceleration, jerk and snap in a range of time, and when. */
struct hawser_path_largest {
	double value[HAWSER_PATH_ORDERS], t[HAWSER_PATH_ORDERS]; /* by order; [0] is unused */
};
enum hawser_status hawser_path_largest(struct hawser_path_largest *largest,
                                             const struct hawser_path *trajectory, double from,
                                             double to, struct hawser_report *report)
	HAWSER_MUST_CHECK;

void hawser_path_clear(struct hawser_path *trajectory);

#ifdef __cplusplus
}
#endif
#endif
