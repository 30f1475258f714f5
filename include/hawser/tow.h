/* hawser/tow.h - a towed body: its scene, and the steady state in straight flight and in an orbit.
 *
 * A scene with the section `tow` (hawser-scene(5), TOW). Axes: x and z are horizontal, y is
 * upwards.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TOW_H
#define HAWSER_TOW_H

#include <stddef.h>

#include <hawser/document.h>
#include <hawser/drag.h>
#include <hawser/rod.h>
#include <hawser/trajectory.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A part of the cable, from the towing point on. */
struct hawser_tow_segment {
	double length;      /* m, unstretched */
	double rho;         /* kg/m */
	double EA, EI;      /* N, N m^2; EA may be infinite, EI 0 */
	double GJ, GA;      /* N m^2, N; 0: GJ that of EI, no shear */
	double diameter;    /* m */
	double normal, tangential; /* drag coefficients cn, ct */
	double lift, strouhal;     /* of vortex shedding, ck and St; lift 0: none */
	int elements;       /* 0: HAWSER_TOW_ELEMENTS */
	double added_normal, added_tangential; /* added mass over that of the water displaced */
};
enum { HAWSER_TOW_ELEMENTS = 100 };

/* How the end of a cable with EI holds a ring; a cable without EI holds it by a joint. */
enum hawser_tow_joint {
	HAWSER_TOW_CLAMPED = 0, /* to the end of the cable */
	HAWSER_TOW_JOINT,       /* without moment */
	HAWSER_TOW_SPRING       /* moment: `torsion` times the angle between ring and cable */
};

enum hawser_tow_body_kind { HAWSER_TOW_NO_BODY = 0, HAWSER_TOW_MASS, HAWSER_TOW_RING };

/* At the free end. A ring hangs on rigid links without drag, its centre `offset` from the end. */
struct hawser_tow_body {
	enum hawser_tow_body_kind kind;
	double mass;             /* kg */
	double CdA;              /* m^2, of a mass: drag coefficient times area */
	double offset;           /* m, of a ring */
	enum hawser_tow_joint joint;
	double torsion;          /* N m/rad, of a spring */
	double inertia;          /* kg m^2, of a mass, about any axis; 0: a point */
	struct hawser_ring ring; /* with the density of the air */
	double volume;           /* m^3, of a mass in water: a sphere where the surface cuts it */
	double added;            /* its added mass over that of the water displaced */
};

struct hawser_tow {
	char *name;                         /* file name; owned */
	struct hawser_path path;            /* of the towing point */
	struct hawser_waypoint *waypoint;   /* [waypoints] of the path, with what is given; owned */
	int waypoints;                      /* 0: straight flight or orbit */
	int clamped;                        /* 1: the towing point clamps a cable with EI, downwards */
	double g;                           /* m/s^2 */
	double density, wind[3];            /* kg/m^3 and m/s, of the air; in water the density of that */
	struct hawser_water water;          /* in place of air; density 0: none */
	struct hawser_waypoint *gust;       /* [gusts] wind in time, m/s in at[0], linear
	                                     * between; owned */
	int gusts;                          /* 0: constant */
	struct hawser_tow_segment *segment; /* [segments] from the towing point; owned */
	int segments;                       /* 0: the scene has no cable */
	struct hawser_tow_body body;
	struct hawser_rod_winch winch;      /* at the towing point: pays out the first segment, in time */
};


/* Read the scene and apply `nset` overrides "path=value", such as "tow.orbit.radius=80". *tow is
 * overwritten; release it with hawser_tow_clear. On failure it is all zero. Statuses: as
 * hawser_scene_open, and those of the path. */
enum hawser_status hawser_tow_open(struct hawser_tow *tow, const char *path, const char *const *set,
                                   size_t nset, struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same from a document that was read before. */
enum hawser_status hawser_tow_of(struct hawser_tow *tow,
                                 const struct hawser_document *from,
                                 const char *const *set, size_t nset,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_tow_clear(struct hawser_tow *tow);

/* A point of the cable. */
struct hawser_tow_point {
	double s;       /* m, unstretched length from the towing point */
	double x[3];    /* m */
	double tension; /* N */
	double along[3]; /* unit vector along the cable, away from the towing point; of a rod e1 */
	double curvature; /* 1/m, of a rod; 0 of a string */
};

/* One of the steady states of an orbit. */
struct hawser_tow_state {
	double radius;      /* m, of the free end about the axis of the orbit */
	double lag;         /* rad, angle about the axis by which the free end is behind the towing point */
	double depth;       /* m, of the free end below the towing point */
	double tension_top; /* N */
};
enum { HAWSER_TOW_STATES = 16 };

/* The steady state at the path's speed, at the instant at which the towing point is at its start (of
 * an orbit: at centre + [radius, 0, 0]). With EI the cable is a rod, else a string. */
struct hawser_tow_steady {
	struct hawser_tow_point *point; /* [points] from the towing point to the free end; owned */
	int points;
	double tension_top, tension_end; /* N */
	double end[3];        /* m, the free end */
	double centre[3];     /* m, of mass of the body; the free end without a body */
	double axis[3];       /* unit vector: of the ring, from the free end to its centre; of a mass and
	                       * without a body: along the cable at its end */
	double attitude[4];   /* quaternion (w, x, y, z) that turns -y into `axis`, without twist */
	double rotation[3];   /* rad, the same as a rotation vector */
	double tilt;          /* rad, its angle; negative if the free end is behind the towing point along
	                       * the direction of flight (at rest: toward -x) */
	double body_force[3]; /* N, of the body on the cable */
	struct hawser_tow_state state; /* of an orbit, else only its depth and tension */
	struct hawser_tow_state other[HAWSER_TOW_STATES]; /* [others] further steady states of an orbit */
	int others;
	double spin;          /* rad/s of the steady frame about y; 0 in straight flight */
	double residual;      /* largest of: distance of the end of the cable from the towing point over the
	                       * length, moment on the body over offset times force; of a rod: of its
	                       * forces and moments, over the largest force and that times the length */
	double mesh_error;    /* m, largest change of a point if the number of elements is halved, and the
	                       * error of a point and of the body's centre by the segments of a ring */
	double ring_error;    /* error by the segments of a ring: of its force, relative, and of its axis,
	                       * rad, the larger; 0 without a ring, NAN: not known */
	int bent;             /* 1: a rod, 0: a string */
	int raised;           /* elements of the finer mesh, which has twice those of the scene, whose EI is
	                       * below 1 % of the tension times their squared length and was raised to it */
	double bending;       /* m, largest sqrt(EI/T): bending matters within a few times this length of
	                       * the ends (a string has no bending); 0 without EI */
};

/* Solve. *steady is overwritten; release it with hawser_tow_steady_clear. HAWSER_ERR_ARGUMENT: a
 * path that has no steady state, no cable, a horizontal wind in an orbit; HAWSER_ERR_NO_SOLUTION;
 * HAWSER_ERR_CONVERGENCE; HAWSER_ERR_MEMORY. */
enum hawser_status hawser_tow_steady_solve(struct hawser_tow_steady *steady,
                                           const struct hawser_tow *tow,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_tow_steady_clear(struct hawser_tow_steady *steady);

/* --- in time --- */

struct hawser_tow_options {
	double until;      /* s, end of the motion; 0: that of the path */
	double step;       /* s; 0: as the local error allows */
	double tolerance;  /* m, local error of a step; 0: 1e-6 of the cable's length */
	double every;      /* s between samples; 0: a 500th of the time */
	double rho_inf;    /* of the integration; 0: 0.8 */
	int refine;        /* elements times this; 0: 1 */
	int (*progress)(void *data, double t, double until); /* or NULL; not 0 ends the motion there */
	void *data;
	const char *initial; /* a file of hawser_tow_state_write, at whose state and time the motion
	                      * begins; NULL: the steady state */
};

struct hawser_tow_sample {
	double t;            /* s */
	double top[3];       /* m, towing point */
	double end[3], body[3]; /* m, the cable's end, the body's centre */
	double attitude[4];  /* quaternion (w, x, y, z) that turns -y into the body's axis, by its axes */
	double tilt;         /* rad, angle of the body's axis to the vertical */
	double tension_top, tension_end; /* N */
	double kinetic, strain, height; /* J, energies; height: potential energy of the weight */
	double towed, air;   /* J, work of the towing point and of air or water since the beginning */
	double winch;        /* J, work of the winch, with the energy of the material paid out */
	double length;       /* m, unstretched length of the cable */
};
/* At the middle of an element. */
struct hawser_tow_range {
	double s;            /* m, unstretched length from the towing point; with a winch its mean over
	                      * the time */
	double least, mean, most; /* N, tension over the time */
	double bent;         /* 1/m, mean curvature of its two nodes, largest over the time */
};

struct hawser_tow_motion {
	struct hawser_tow_sample *sample; /* [samples] */
	int samples;
	struct hawser_tow_range *range;   /* [elements] */
	int elements;
	double (*shape)[3];  /* [samples][elements+1] m, places of the nodes */
	long steps, rejected, iterations;
	double shortest;     /* s, shortest step, except those shortened to end at a sample */
	double step_error;   /* m, sum of the local errors of the steps, largest of all points */
	double closure;      /* energy lost or gained by the steps, over the largest energy */
	double momentum;     /* largest error of the balance of momentum, over the largest momentum */
	double frequency;    /* Hz, largest of vortex shedding; 0: none */
	int interrupted;     /* 1: progress ended it */
	double *state;       /* [states] for hawser_tow_state_write: the last one */
	int states;
	int raised;          /* elements whose EI is below 1 % of the tension at the start times the square
	                      * of their length and was raised to that */
};

/* The motion from the steady state at the path's first velocity. EA and EI are needed.
 * HAWSER_ERR_ARGUMENT: what the scene lacks, a step that vortex shedding would alias, a state of
 * another cable; HAWSER_ERR_IO: a state cannot be read;
 * HAWSER_ERR_NO_SOLUTION, _CONVERGENCE, _NAN, _MEMORY. */
enum hawser_status hawser_tow_move(struct hawser_tow_motion *motion, const struct hawser_tow *tow,
                                   const struct hawser_tow_options *options /* or NULL */,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* The last state, from which options.initial goes on. HAWSER_ERR_IO. */
enum hawser_status hawser_tow_state_write(const struct hawser_tow_motion *motion, const char *path,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_tow_motion_clear(struct hawser_tow_motion *motion);

#ifdef __cplusplus
}
#endif
#endif
