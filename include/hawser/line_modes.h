/* hawser/line_modes.h - natural modes of a rope over sheaves, about its statics (line.h).
 *
 * On a sheave the rope moves along the circle (slip), or not at all (stick), or the sheave turns with
 * it (roll); a groove holds it out of the plane. Between sheaves it is the cable of modes.h. The
 * theory, with the reason why the tension does not resist sliding along a circle, is in
 * doc/theory-ropeway-modes.md.
 *
 * Scaled as in modes.h, with the units below: s = S/length, T/force, t/time. A mode is Phi = P e + Q n
 * + B z in the frame of the rope's tangent e, normalised so that the integral of Phi.Phi over the
 * whole rope, plus the point masses and freedoms times their displacements squared, is 1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_LINE_MODES_H
#define HAWSER_LINE_MODES_H

#include <hawser/line.h>
#include <hawser/modes.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_line_contact_kind {
	HAWSER_LINE_SLIP = 0, /* the rope slides along the circles: a rope that runs */
	HAWSER_LINE_STICK,    /* the points in contact do not move: a rope at rest */
	HAWSER_LINE_ROLL      /* each sheave turns by itself with the rope on it, and with its inertia */
};
const char *hawser_line_contact_name(enum hawser_line_contact_kind kind); /* "slip" */

enum { HAWSER_LINE_LANES = 2 };

/* A body that moves with one coordinate and carries ends of the rope, such as a carriage on rails
 * under the constant pull of a counterweight, or a wheel that the ropes of two lanes leave on both
 * sides. Ends that no freedom moves are fixed. */
struct hawser_line_freedom {
	char name[HAWSER_LINE_NAME];
	double mass; /* kg, or of a rotation its moment of inertia over the radius squared; may be 0 */
	double stiffness; /* N/m, of the body itself, of either sign; 0: none */
	double end[HAWSER_LINE_LANES][2][3]; /* displacements of ends A and B of each lane along x, y and
	                                      * z, per unit of the coordinate */
};

struct hawser_line_modes_options {
	int n;            /* number of modes of both planes together, >= 1; 0: 6 */
	enum hawser_line_contact_kind contact;
	double tolerance; /* required relative error of each frequency, 0: 1e-9 */
	int extra;        /* nodes of each element more than the program's choice */
	int loose;        /* 1: no groove: the rope may move along the axes of the sheaves */
	int printed;      /* 1: without the curvature term of the constraints, as B (3.109) has it: for
	                   * comparison only, since these are not the frequencies of the rope */
	int backward[HAWSER_LINE_LANES]; /* 1: the rope of this lane runs from B to A */
	const struct hawser_line_freedom *freedom; /* [freedoms] or NULL */
	int freedoms;
};

/* A piece of the rope: that of the statics, with its grid. */
struct hawser_line_modes_piece {
	int lane, piece;  /* index of the piece in the statics of its lane */
	int sheave;       /* -1: free */
	int span;         /* number of the free rope between two sheaves or ends, from 0 over all lanes, to
	                   * which it belongs; -1 on a sheave */
	int first;        /* its first point; it has grid.points */
	double s0;        /* scaled arclength of its beginning in its lane */
	struct hawser_grid grid; /* with s from the beginning of the piece; 0 points: an arc of no length */
};

/* State of the rope at a point, unscaled. */
struct hawser_line_modes_point {
	double S, x[2];   /* m; S in its lane */
	double angle;     /* rad */
	double T;         /* N, the actual tension */
	double stretch;   /* |x'| = 1 + T/EA */
	double curvature; /* 1/m, of the angle by S */
};

struct hawser_line_modes {
	const struct hawser_line_statics *lane[HAWSER_LINE_LANES]; /* the caller's; not released */
	int lanes;
	enum hawser_line_contact_kind contact;
	int gyroscopic;             /* 0: real modes, parts is 1; 1: complex modes of a rope that runs,
	                             * parts is 2: real, imaginary */
	int n, pieces, spans, points, masses, freedoms;
	int unknowns;               /* values of a mode: displacements at all points and of all bodies */
	int iterations;             /* of the eigenvalue solver, most of any group of spans */
	double length_unit, force_unit, time_unit; /* m, N, s */
	double rho, epsilon, delta, nu; /* kg/m; scaled force/EA, weight of lane 0, speed */
	struct hawser_mode *mode;   /* [n] by ascending frequency; symmetry and moments are not set */
	struct hawser_line_modes_piece *piece; /* [pieces] of all lanes, in the order of the rope */
	struct hawser_line_modes_point *point; /* [points] */
	double *weight;             /* [points] of the quadrature over s */
	double *shape;              /* [n][parts][points][3] P, Q, B */
	double *slope;              /* [n][parts][points][3] a, b, c: derivatives by s in the local frame:
	                             * (P' - kappa Q, Q' + kappa P, B'). On a sheave Q is 0 and a alone has
	                             * strain energy: b = kappa P is the turning of the tangent */
	double *share;              /* [n][spans] of the kinetic energy: rope and carriers of each span */
	double *mass_at;            /* [n][parts][masses][3] displacements of the masses along x, y, z:
	                             * of a carrier with a hanger, of its mass; lanes one after the other */
	double *freedom_at;         /* [n][parts][freedoms] coordinates of the freedoms */
};

/* Real modes of a rope at rest in one lane, or in two that share freedoms; with speed, of the apparent
 * rope (complex modes: hawser_line_modes_running). *modes is overwritten; release it with
 * hawser_line_modes_clear. `lane` [lanes] are solved statics with equal EA, rho and speed.
 * Statuses: HAWSER_ERR_ARGUMENT (options, statics, freedoms that move an end in the plane and out of
 * it, a mass on a sheave of radius 0), HAWSER_ERR_NO_SOLUTION (the equilibrium is not stable: a
 * frequency is imaginary, or the rope is slack), HAWSER_ERR_CONVERGENCE, HAWSER_ERR_NAN,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_line_modes_solve(struct hawser_line_modes *modes,
                                           const struct hawser_line_statics *const *lane, int lanes,
                                           const struct hawser_line_modes_options *options,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
/* Complex modes of a rope that runs, whose lines have a speed: about its steady state, with the
 * Coriolis force (doc/theory-ropeway-modes.md); positive frequencies, the conjugates are left out.
 * Carriers are at rest where they are. At speed 0 real modes with imaginary parts that are 0. Statuses
 * as above; HAWSER_ERR_ARGUMENT also with contact: stick, since a rope that sticks does not run. */
enum hawser_status hawser_line_modes_running(struct hawser_line_modes *modes,
                                             const struct hawser_line_statics *const *lane, int lanes,
                                             const struct hawser_line_modes_options *options,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_line_modes_clear(struct hawser_line_modes *modes);

/* shape [3 parts]: P, Q, B (of a complex mode the real parts first), and slope [3 parts]: a, b, c, of
 * mode k at s, scaled, in a lane; slope may be NULL. At a break point: of the piece that begins
 * there. */
void hawser_line_modes_at(double *shape, double *slope, const struct hawser_line_modes *modes, int k,
                          int lane, double s);

#ifdef __cplusplus
}
#endif
#endif
