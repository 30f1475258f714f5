/* hawser/rod.h - a geometrically exact rod: a scene of kind `rod`, and its statics.
 *
 * The rod bends, twists, shears and stretches by any amount; strains are small, and stresses are linear
 * in them. s is the unstretched length from its start. The axes of its sections are e1 (tangent), e2
 * and e3 = e1 x e2; those of the scene are x, y (upwards) and z. Forces N along and moments M about e1,
 * e2, e3 are those of the part beyond s on the part before it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_H
#define HAWSER_ROD_H

#include <stddef.h>
#include <hawser/document.h>
#include <hawser/status.h>
#include <hawser/water.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_rod_hold {
	HAWSER_ROD_CLAMPED = 0, /* place and axes of the end are held */
	HAWSER_ROD_HINGED,      /* its place is held */
	HAWSER_ROD_FREE
};

struct hawser_rod_segment {
	double length, rho;  /* m, kg/m */
	double EA, GA[2];    /* N; GA along e2 and e3 */
	double EI[2], GJ;    /* N m^2; EI about e2 and e3 */
	double curvature[3]; /* 1/m, at rest: twist, about e2 and about e3 */
	double inertia[3];   /* kg m, of a unit length about e1, e2, e3; all 0: not given */
	struct hawser_water_line line; /* in the water; its diameter is that of its outside */
	int elements;
};

struct hawser_rod_load {
	int distributed;     /* 1: per unit of length, from `from` to `to` */
	double from, to;     /* m; of a load at a point, both its place */
	double force[3], moment[3]; /* N, N m, or per m */
	int follower;        /* 1: in the axes of the section, which turn; 0: of the scene */
	double (*factor)[2]; /* [factors] s, 1: in time, linear between; two at one time: a jump */
	int factors;         /* 0: constant */
};

/* How an end moves: it rotates about its position, and follows a path. */
struct hawser_rod_drive {
	double axis[3], speed, rise; /* of length 1; rad/s, 0: no spin; s, from 0 to the full speed:
	                              * (t - sin(2 pi t/rise) rise/(2 pi))/rise of it; 0: at once */
	char *path;                  /* file of displacements over time: lines t x y z; NULL: none */
};

/* The start is a winch: the first segment lengthens, all its elements in proportion. The length at time
 * t is that of the segment at t = 0 plus the length paid out. */
struct hawser_rod_winch {
	int on;               /* 0: there is none */
	double speed, rise;   /* m/s paid out, without rows; s, from 0 to the speed, as those of spins */
	double (*row)[2];     /* [rows] s and m/s or m: speeds, between which the acceleration is
	                       * 1 - cos, or lengths, with a spline between that is at rest at its ends */
	int rows, lengths;    /* lengths: 1, the rows are lengths */
	double least;         /* m, of the length; 0: 5 % of that at t = 0 */
};

struct hawser_rod {
	char *name;                         /* of the file */
	double g;                           /* m/s^2, against y */
	struct hawser_rod_segment *segment; /* [segments] from the start */
	int segments;
	double length;                      /* m */
	struct hawser_rod_load *load;       /* [loads] */
	int loads;
	enum hawser_rod_hold hold[2];       /* of start and end */
	double at[3], tangent[3], normal[3]; /* m, 1, 1: start at rest: place, e1, e2 */
	int placed, turned;                 /* 1: the end is moved, or turned, to the next three */
	double end_at[3], end_tangent[3], end_normal[3];
	double alpha;                       /* 1/s: damping force per mass and velocity */
	double rho_inf, step;               /* of time integration; step in s; 0 (rho_inf: -1): not given */
	int from_rest;                      /* 1: a motion begins in the shape at rest, though held */
	struct hawser_rod_drive drive[2];   /* how start and end move, where they are held */
	struct hawser_rod_winch winch;      /* at the start, which is held */
	struct hawser_water water;          /* density 0: none */
};

/* Read a scene of kind `rod`; `set` has overrides, such as "rod.EI=2 kN m^2". */
enum hawser_status hawser_rod_open(struct hawser_rod *rod, const char *path,
                                   const char *const *set /* [nset] */, size_t nset,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same from a document that was read before. */
enum hawser_status hawser_rod_of(struct hawser_rod *rod,
                                 const struct hawser_document *from,
                                 const char *const *set, size_t nset,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_rod_clear(struct hawser_rod *rod);

/* --- statics --- */

struct hawser_rod_options {
	int refine;        /* elements times this; 0: 1 */
	int steps;         /* load steps to begin with, made shorter where they fail; 0: 1 */
	double tolerance;  /* of the last increment, in lengths of the rod and rad; 0: 1e-9 */
	int skip_error;    /* 1: do not solve again with twice as many elements */
};
void hawser_rod_settle(struct hawser_rod_options *options);

struct hawser_rod_point {
	double s, x[3];    /* m */
	double q[4];       /* quaternion (w, x, y, z): from the axes of the section to the scene's */
	double N[3], M[3]; /* N, N m: along and about e1, e2, e3; before a load at this point */
	double k[3];       /* 1/m, twist and curvature, those at rest too */
};

struct hawser_rod_statics {
	int points;
	struct hawser_rod_point *point;  /* [points] nodes of the mesh */
	double (*rest)[3];               /* [points] m, their places without loads */
	double force[2][3], moment[2][3]; /* N, N m: of the supports on the rod at start and end, scene's
	                                   * axes */
	double T_min, T_max;   /* N, of N along e1 */
	double strain;         /* largest part of the length by which an element is stretched, shortened or
	                        * sheared */
	double M_max, M_max_s; /* N m, m: largest moment, and where */
	double energy;         /* J, of strain */
	double wet;            /* m, unstretched length in the water */
	double residual;       /* N: largest force that is not balanced */
	double increment;      /* the last one, see tolerance */
	int elements, steps, iterations;
	int flow;              /* 1: by damped motion, since Newton's method failed */
	double jump;           /* part of the load up to which it can be raised from none, where the rod
	                        * has no equilibrium near by, and this one is another; 0: all of it */
	double other;          /* m: how far a point is in another equilibrium, to which the whole load
	                        * at once leads; 0: none is known */
	int judged, negative;  /* judged: 1, the loads have a potential; negative: directions that lower
	                        * the energy: 0 is a stable equilibrium */
	int checked;           /* 1: mesh errors are estimated, from twice as many elements: */
	double error_x, error_N, error_M; /* m, N, N m: largest of places, forces, moments */
	struct hawser_report unchecked; /* why not */
};

/* HAWSER_ERR_NO_SOLUTION: no equilibrium found; HAWSER_ERR_ARGUMENT, _CONVERGENCE, _NAN, _MEMORY. */
enum hawser_status hawser_rod_solve(struct hawser_rod_statics *st, const struct hawser_rod *rod,
                                    const struct hawser_rod_options *options /* or NULL */,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_rod_statics_clear(struct hawser_rod_statics *st);

#ifdef __cplusplus
}
#endif
#endif
