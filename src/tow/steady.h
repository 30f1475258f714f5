/* tow/steady.h - internal to the steady states of a towed body: the frame, the loads, the string.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TOW_STEADY_H
#define HAWSER_TOW_STEADY_H

#include <hawser/tow.h>

#include "rod/mesh.h"
#include "rod/so3.h"

/* A frame in which the state is at rest: it moves at a velocity, or turns about the axis y through
 * its origin. */
struct hawser__tow_frame {
	const struct hawser_tow *tow;
	double velocity[3]; /* m/s */
	double spin;        /* rad/s about y */
	double lift;        /* m, in water: height of its axes */
};

/* steady.c: fail for a point at the height y below the bed of the water: of the cable at s from the
 * towing point, or of the body (s NaN), at the time t or in a steady state (NaN). */
enum hawser_status hawser__tow_above_bed(const struct hawser_tow *tow, double y, double s, double t,
                                         const char *stage, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* The flow relative to a point at rest in the frame, and weight and inertia per mass there. */
void hawser__tow_flow(double u[3], const struct hawser__tow_frame *frame, const double x[3]);
void hawser__tow_gravity(double w[3], const struct hawser__tow_frame *frame, const double x[3]);

/* Where a direction t between `from` and the flow u (at most a half turn apart) has no force across
 * it: force(F, context, t) is drag that vanishes across t where t is along u, and `weight` is along
 * `from`. */
void hawser__tow_direction(double t[3], const double weight[3], const double u[3],
                           void (*drag)(double f[3], const void *context, const double t[3]),
                           const void *context, int bisections);
enum { HAWSER__BISECTIONS = 60 /* of an angle of at most pi: to 3e-18 of it, less than round-off */ };

/* steady_body.c: the force of the body on the cable if its free end is at x, and its axis; the
 * moment that is left over offset times force. Returns 0 if the attitude of a ring was not found. Of
 * several attitudes one that is stable is taken. */
struct hawser__tow_end {
	double force[3], axis[3], centre[3], residual;
	int raised; /* of the cable as a rod: elements whose EI was raised */
};
/* The same from the attitude end->axis at a place near by; all 0: none is known. `coarse`
 * 1: less exactly, for a sign. */
int hawser__tow_body_near(struct hawser__tow_end *end, const struct hawser__tow_frame *frame,
                          const double x[3], int coarse);
int hawser__tow_body_at(struct hawser__tow_end *end, const struct hawser__tow_frame *frame,
                        const double x[3]);

/* steady_string.c: the cable from its free end at x, where the body pulls, up to the towing point,
 * which is top[3]; n[3] the tension there. With point not NULL the points [elements+1] from the
 * towing point on. Each part of the cable has parts*its elements/2 steps. */
void hawser__tow_string(double top[3], double n[3], struct hawser_tow_point *point,
                        const struct hawser__tow_frame *frame, const double x[3],
                        const struct hawser__tow_end *end, int parts);
int hawser__tow_elements(const struct hawser_tow *tow);

/* A ring with its axis a, its joint at x: what it pulls with, its moment about the joint, and their
 * derivatives by x and by a small rotation. */
struct hawser__tow_ring {
	double centre[3], n[3], moment[3];
	double n_x[3][3], n_turn[3][3], moment_x[3][3], moment_turn[3][3];
};
void hawser__tow_ring_at(struct hawser__tow_ring *to, const struct hawser__tow_frame *frame,
                         const double x[3], const double a[3]);
/* The derivative of end->force by x, of a ring at the attitude that it has. */
void hawser__tow_body_slope(double n_x[3][3], const struct hawser__tow_frame *frame, const double x[3],
                            const struct hawser__tow_end *end);

/* steady_rod.c: the cable as a rod, with parts times the elements of the scene, from the shape of a
 * string or of a rod with the elements of the scene: point [elements+1] from the towing point on,
 * which stays where it is. *body is that of the string, and becomes that of the rod. */
enum hawser_status hawser__tow_bend(struct hawser_tow_point *point, struct hawser__tow_end *body,
                                    const struct hawser__tow_frame *frame,
                                    const struct hawser_tow_point *string, int parts,
                                    struct hawser_report *report);

/* steady_orbit.c: the free end and the body there. */
enum hawser_status hawser__tow_orbit(struct hawser_tow_steady *steady,
                                     struct hawser__tow_frame *frame, double end[3],
                                     struct hawser__tow_end *body, struct hawser_report *report);

/* --- steady_rod.c: the cable as a rod in a steady state: what its files share --- */

struct hawser__tow_rod {
	const struct hawser__tow_frame *frame;
	struct hawser_rod rod;
	struct hawser__rod_mesh mesh;
	double rigid;                  /* P */
	double spring[2];              /* N/m, N m/rad of the joint; 0: none */
	double pull[3];                /* N, that holds its ends at one place; corrected as those of rigid
	                                * directions */
	int last, end;                 /* node of the cable's end, of the ring */
	int raised;                    /* elements whose EI was raised, as the mesh does not show it */
	int moves;                     /* 1: for a motion: a ring on a joint has a node, too */
	int links;                     /* 1: end and last are different nodes */
	const struct hawser__tow_end *hung; /* on a joint without moment, or a mass */
	struct hawser__tow_end now;    /* the body in the state */
};

/* Drag per length of element e (N/m), and unless NULL its derivatives by flow and chord. */
void hawser__tow_rod_drag(double f[3], double (*f_u)[3], double (*f_d)[3],
                          const struct hawser__tow_rod *b, int e);
/* Forces that are not balanced into mesh.r, and the matrix. */
void hawser__tow_rod_assemble(struct hawser__tow_rod *b);

/* 1: the body has no moment on the cable. */
int hawser__tow_hangs(const struct hawser_tow *tow);
/* steady_rod.c: the state of a rod with parts times the elements, from the shape of a string; b->frame
 * and b->moves are set, b->hung is for a body without moment. Release it with hawser__tow_rod_close,
 * also on failure. */
enum hawser_status hawser__tow_rod_solve(struct hawser__tow_rod *b,
                                         const struct hawser_tow_point *string, int parts,
                                         const struct hawser__tow_end *body,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__tow_rod_close(struct hawser__tow_rod *b);
/* steady.c: the start of a motion of *tow, whose path is straight or an orbit; body is the string's. */
enum hawser_status hawser__tow_rod_start(struct hawser__tow_rod *b, struct hawser__tow_frame *frame,
                                         struct hawser__tow_end *body, const struct hawser_tow *tow,
                                         int parts, struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
