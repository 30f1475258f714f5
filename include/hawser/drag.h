/* hawser/drag.h - drag of air or water on a line, a body and a ring, with its derivatives.
 *
 * Force per length of a round line of radius r in a fluid that moves at u relative to it, with the unit
 * tangent t = x'/|x'| and the normal part p = u - (u.t) t of the flow:
 *
 *     f = density r cn |p| p + density pi r ct |u.t| (u.t) t
 *
 * cn is referred to the diameter (1.2 for a cylinder), ct to the surface.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_DRAG_H
#define HAWSER_DRAG_H

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_drag {
	double density;    /* kg/m^3, of the fluid */
	double radius;     /* m, of the line, or of the tube of a ring */
	double normal;     /* cn */
	double tangential; /* ct */
};

/* f[3] N/m; and unless they are NULL its derivatives f_u[3][3] by u[3] (m/s), f_x[3][3] by x'[3],
 * whose length does not matter and must not be 0. */
void hawser_drag_line(double f[3], double (*f_u)[3], double (*f_x)[3], const struct hawser_drag *drag,
                      const double u[3], const double x[3]);

/* The drag c*|u|*u of a body, c in N s^2/m^2, and its derivative unless it is NULL. */
void hawser_drag_body(double f[3], double (*f_u)[3], double c, const double u[3]);

/* A rigid ring: a tube bent to a circle. Its drag is the sum over equal segments of that of a line. */
struct hawser_ring {
	double radius;   /* m, of the circle */
	int segments;    /* 0: 32 */
	struct hawser_drag drag; /* of the tube */
};
enum { HAWSER_RING_SEGMENTS = 32 };

/* Force (N) and moment about its centre (N m), and their derivatives unless NULL. */
struct hawser_ring_drag {
	double force[3], moment[3];
	double force_u[3][3], moment_u[3][3];         /* by the flow at the centre */
	double force_spin[3][3], moment_spin[3][3];   /* by the angular velocity */
	double force_turn[3][3], moment_turn[3][3];   /* by a small rotation of the ring, spatial axes */
};
/* In air that moves at u[3] (m/s) relative to the centre, for a ring with this unit vector along
 * its axis and this angular velocity spin[3] (rad/s). */
void hawser_ring_drag(struct hawser_ring_drag *out, const struct hawser_ring *ring, const double u[3],
                      const double axis[3], const double spin[3]);
/* The force f[3] alone, at rest. */
void hawser_ring_force(double f[3], const struct hawser_ring *ring, const double u[3],
                       const double axis[3]);

#ifdef __cplusplus
}
#endif
#endif
