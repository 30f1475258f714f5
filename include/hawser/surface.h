/* hawser/surface.h - obstacles that the nodes of a mesh may touch: planes, segments, circles, and beds
 * by their heights.
 *
 * x and z are horizontal, y is upwards. The gap g of a point is its distance from the surface, below 0
 * inside the obstacle; its gradient n is a unit vector towards the free side. Segments and circles are
 * in the plane of x and y and extend along z: they are strips and cylinders.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SURFACE_H
#define HAWSER_SURFACE_H

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_SURFACE_NAME = 32 }; /* size of a name, with the NUL at its end */

enum hawser_surface_kind {
	HAWSER_SURFACE_PLANE = 0, HAWSER_SURFACE_SEGMENT, HAWSER_SURFACE_CIRCLE,
	HAWSER_SURFACE_PROFILE, HAWSER_SURFACE_GRID /* beds with heights */
};

/* Where cables are. ABOVE, BELOW: of a circle, which way they pass it; LEFT, RIGHT: of a segment
 * that is vertical; INSIDE: of a circle, which is then a pipe; AROUND: of a circle, where the
 * places of nodes lead the cables, as a belt. Planes have their normal instead. */
enum hawser_surface_side {
	HAWSER_SIDE_ABOVE = 0, HAWSER_SIDE_BELOW, HAWSER_SIDE_LEFT, HAWSER_SIDE_RIGHT, HAWSER_SIDE_INSIDE,
	HAWSER_SIDE_AROUND
};

/* What a circle does. FREE: it turns without resistance, so that friction does not change tensions;
 * DRIVE: a motor holds or turns it. */
enum hawser_surface_rotation { HAWSER_SURFACE_LOCKED = 0, HAWSER_SURFACE_FREE, HAWSER_SURFACE_DRIVE };

/* A bed: heights over the points of a grid, linear between them along x and along z. At its lines it
 * is rounded by parabolas; beyond its first and last points it goes on as it is there. */
struct hawser_heights {
	int nx, nz;        /* points along x and along z; nz 1: the heights are the same for all z */
	double *x, *z;     /* m [nx], [nz], rising */
	double *round_x, *round_z; /* m [nx], [nz]: at this distance from a line its rounding begins */
	double *y;         /* m [nz][nx] */
	int convex;        /* 1: the space above it is convex */
};

struct hawser_surface {
	char name[HAWSER_SURFACE_NAME];
	enum hawser_surface_kind kind;
	enum hawser_surface_side side;
	double at[3];       /* m: a point of the plane, the first end of the segment, the centre, the last
	                     * point of a bed; z of a centre is that of the groove */
	int groove;         /* 1: of a circle, holds nodes that touch at z = at[2] */
	double to[3];       /* m: the other end of the segment */
	double normal[3];   /* unit vector towards the free side, of planes and segments */
	double radius;      /* m */
	double friction;    /* coefficient */
	double axial;       /* of a plane that moves, coefficient along cables, `friction` is across;
	                     * 0: one for both */
	double stiffness;   /* Pa/m, of planes and beds: force per length over diameter and depth;
	                     * 0: rigid */
	double damping;     /* Pa*s/m, the same over the rate of the depth */
	double velocity[3]; /* m/s of the surface of a plane, along it */
	enum hawser_surface_rotation rotation;
	double inertia;     /* kg*m^2, of a circle that turns freely */
	double speed;       /* m/s of the surface of a segment, to its other end; of a circle,
	                     * counterclockwise; of a profile, towards larger x */
	struct hawser_heights *heights; /* of a profile or grid, else NULL; the net's, as is its file */
	char *file;         /* of a grid, or NULL */
};

/* Make *heights, which the caller frees, of the points x [nx], two or more, and z [nz], one or more,
 * and their heights y [nz][nx], m. round: m from a line of the grid to where its rounding begins, if
 * there is as much room. HAWSER_ERR_ARGUMENT: x or z do not rise, or numbers are not finite. */
enum hawser_status hawser_heights_make(struct hawser_heights **heights /* *heights */, int nx,
                                       const double *x /* [nx] */, int nz,
                                       const double *z /* [nz] */, const double *y /* [nz][nx] */,
                                       double round,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_heights_free(struct hawser_heights *heights);
/* The height of the bed at x, z, m. */
double hawser_heights_at(const struct hawser_heights *heights, double x, double z);

/* The gap of the point x, m. Its gradient goes to normal [3], a unit vector, and the second derivatives
 * to hessian [3][3], 1/m; each may be NULL. At the centre of a circle the gradient is along y. */
double hawser_surface_gap(double *normal /* [3] */, double (*hessian)[3] /* [3][3] */,
                          const struct hawser_surface *surface, const double *x /* [3] */);

/* v [3], m/s: the velocity of the surface where the point x [3] touches it. */
void hawser_surface_velocity(double *v /* [3] */, const struct hawser_surface *surface,
                             const double *x /* [3] */);

/* Move the point x [3] to the surface if it is inside the obstacle or, seen along y (of a vertical
 * segment along x), behind it. Returns 1 if x has changed. */
int hawser_surface_clear_of(double *x /* [3] */, const struct hawser_surface *surface);

/* 1 if all segments of a line between two points of the free side are in it, so that what touches
 * nothing but such surfaces has one equilibrium: of planes, of circles around the cable, and of beds
 * that curve upwards. */
int hawser_surface_convex(const struct hawser_surface *surface);

/* 1 if x [3] is beyond the points of a bed, over which nothing is known of it. */
int hawser_surface_beyond(const struct hawser_surface *surface, const double *x /* [3] */);

/* Of values that the scene gives: sets normal of a segment from its ends and side, scales that of a
 * plane to 1, and checks. HAWSER_ERR_ARGUMENT, with a message that begins with the key: a normal or a
 * segment of length 0, a side that the kind does not have, numbers that are not finite, a velocity
 * that is not along the plane. */
enum hawser_status hawser_surface_settle(struct hawser_surface *surface,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
