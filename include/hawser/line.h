/* hawser/line.h - a rope in a vertical plane that passes over and under sheaves: the statics of
 * a line.
 *
 * The rope runs from end A to end B, x horizontal and increasing, y upwards. Between two
 * contacts it is an elastic catenary with point masses; on a sheave it is an arc. Everything is
 * exact: there is no mesh. S is the unstretched arclength from end A; angles are slopes of the
 * rope, atan(dy/dx).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_LINE_H
#define HAWSER_LINE_H

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_LINE_NAME = 32 }; /* size of a name, with the NUL at its end */

/* The way in which the rope slides over every sheave with friction, or would begin to. Friction
 * acts against it, so that the tension grows in this direction. */
enum hawser_line_sliding {
	HAWSER_LINE_NONE = 0,     /* no tangential force: friction is only reported as an interval */
	HAWSER_LINE_TOWARD_A,
	HAWSER_LINE_TOWARD_B,
	HAWSER_LINE_HELD          /* each sheave by itself: its `grip` says how much friction acts, and
	                           * which way; a rope at rest whose history is known */
};

struct hawser_line_sheave {
	char name[HAWSER_LINE_NAME];
	double centre[2];  /* m */
	double radius;     /* m; 0: a point */
	int side;          /* 1: the rope passes above (support); -1: below (compression) */
	double friction;   /* coefficient, >= 0 */
	double grip;       /* of HAWSER_LINE_HELD: the part of the friction that acts, from -friction to
	                    * friction; > 0: the tension grows towards B */
	double inertia;    /* kg m^2, of the sheave about its axis; 0: none */
	int file_line;     /* of the scene's file, for messages; 0: not known */
};

struct hawser_line_mass {
	double S;          /* m, unstretched arclength from end A */
	double mass;       /* kg */
	double hanger;     /* m, length of the pendulum by which it hangs; 0: on the rope */
	double body;       /* kg, which have inertia but no weight: that is in rho and g; of modes only */
	double hung;       /* N, with which the body pulls at the hanger; of models only */
};

enum hawser_line_given {
	HAWSER_LINE_T_A = 0, /* tension at end A, N */
	HAWSER_LINE_T_B,     /* tension at end B, N */
	HAWSER_LINE_LENGTH0  /* unstretched length, m */
};

struct hawser_line {
	double EA, rho, g;     /* N, kg/m per unstretched length, m/s^2 */
	double speed;          /* m/s along the rope, 0: at rest */
	double A[2], B[2];     /* m */
	enum hawser_line_given given;
	double value;          /* of what is given */
	enum hawser_line_sliding sliding;
	struct hawser_line_sheave *sheave; /* [sheaves] in the order in which the rope meets them */
	struct hawser_line_mass *mass;     /* [masses] by ascending S. Masses beyond the unstretched length
	                                    * of a line whose tension is given are not on it */
	int sheaves, masses;
	int lift;              /* 0: a sheave that the rope does not press is an error; 1: the rope
	                        * passes it without contact */
};

/* A part of the rope between two break points (ends, tangent points, masses): a catenary or an arc. */
struct hawser_line_piece {
	int sheave;            /* -1: free */
	int mass;              /* mass at its beginning, -1: none */
	double S0, S1;         /* m, unstretched */
	double x0[2], x1[2];   /* m, of its ends */
	double angle0, angle1; /* slopes at its ends, rad */
	double T0, T1;         /* tensions at its ends, N; with speed the actual ones */
};

/* What the rope does at a sheave. */
struct hawser_line_contact {
	int touches;           /* 0: no contact */
	double T_in, T_out;    /* N, before and behind */
	double angle_in, angle_out; /* rad, slopes of the free rope before and behind */
	double wrap;           /* rad, angle of contact (a sum, if a mass divides the arc) */
	double force[2];       /* N, of the sheave on the rope */
	double pressure_min;   /* N/m, least normal force per length on the arc (bare rope) */
	double margin;         /* friction*wrap - |ln(T_out/T_in)|: at rest the rope does not slide if >= 0.
	                        * With speed, of T - rho v^2 */
	double T_out_min, T_out_max; /* N: tensions behind which friction allows at this T_in */
	double clearance;      /* m, of a sheave that is not touched: distance from the rope */
};

/* Where a mass is, and what carries it. */
struct hawser_line_carrier {
	int present;           /* 0: beyond the end of the rope */
	int sheave;            /* on or at this sheave; -1: in a span */
	int state;             /* 0: in a span, or below a compression sheave between two arcs; 1: at
	                        * the first point of contact; 2: on the arc; 3: at the last point */
	double x[2];           /* m */
	double T_before, T_after; /* N */
	double angle_before, angle_after; /* rad */
	double carried;        /* N, normal force of the sheave on the rope at this point */
};

struct hawser_line_statics {
	const struct hawser_line *line; /* the caller's; not released */
	int pieces;
	struct hawser_line_piece *piece;     /* [pieces] from A to B */
	struct hawser_line_contact *contact; /* [sheaves] */
	struct hawser_line_carrier *carrier; /* [masses] */
	double T_A, T_B;           /* N */
	double angle_A, angle_B;   /* rad */
	double length0, length;    /* m, unstretched and stretched */
	double reaction_A[2], reaction_B[2]; /* N, of the ends on the rope */
	double closure;            /* m: largest distance of the rope from what it has to meet */
	double balance;            /* N: largest defect of the balance of forces at break points and of the
	                            * whole rope */
	int iterations;
};

/* Solve. HAWSER_ERR_ARGUMENT (invalid line), HAWSER_ERR_NO_SOLUTION: the rope lifts off a
 * sheave or does not reach it, or the tension is below the least one (the report says which
 * sheave, where, and by how much); HAWSER_ERR_CONVERGENCE, HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_line_solve(struct hawser_line_statics *st, const struct hawser_line *line,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_line_statics_clear(struct hawser_line_statics *st);

/* State at S: position [2], slope angle, tension, stretch |x'| = 1 + T/EA, curvature per
 * unstretched length (d angle/dS). At a break point: of the piece that begins there. Any
 * pointer may be NULL. */
void hawser_line_at(const struct hawser_line_statics *st, double x[2], double *angle, double *T,
                    double *stretch, double *curvature, double S);

#ifdef __cplusplus
}
#endif
#endif
