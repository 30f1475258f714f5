/* hawser/net_modes.h - natural modes of a net about its equilibrium.
 *
 * K*phi = omega^2*M*phi over the nodes of the mesh: K is the second derivative of the energy at the
 * equilibrium, M the mean of the consistent and the lumped mass matrix. Supports stand still. Slack
 * elements have no stiffness. Nodes that touch obstacles keep touching (contact.modes), and K has the
 * curvature of the obstacles times their forces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MODES_H
#define HAWSER_NET_MODES_H

#include <hawser/net.h>
#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A plane that maps the equilibrium onto itself, or that it lies in. */
struct hawser_net_plane {
	double point[3];  /* m */
	double normal[3]; /* of length 1 */
	/* How well it holds: the largest distance of a node's image from its partner, or of a node from
	 * the plane that the net lies in, m; the largest relative difference of the stiffness, tension or
	 * mass of partners. */
	double places, elements;
};

/* Symmetry of the equilibrium: of places, stiffness, tension, mass and held directions. Nodes are
 * mapped to nodes, cables to cables with as many elements; places may differ by 1e-4 of the size of
 * the net, stiffness and mass by 1e-3, tensions by 1e-2. */
enum { HAWSER_NET_MIRRORS = 3 };
struct hawser_net_symmetry {
	int flat, straight; /* 1: it lies in `plane`; on a line, and `plane` is one of many */
	struct hawser_net_plane plane;
	int mirrors;        /* other planes of symmetry, at right angles to each other */
	struct hawser_net_plane mirror[HAWSER_NET_MIRRORS];
	int turns;          /* the largest number n for which a turn by 2*pi/n about an axis, vertical or
	                     * normal to `plane`, maps the net onto itself; 1: none */
	double axis[3], centre[3];
};

struct hawser_net_modes {
	int n, nodes, points; /* modes; nodes of the scene; points: those of the mesh on cables, as in
	                       * struct hawser_net_statics */
	double *omega;        /* [n] rad/s, ascending */
	double *mass;         /* [n] kg, of a shape whose largest displacement of a node is 1 */
	double (*share)[3];   /* [n] of the mass, that moves along x, y, z; the sum is 1 */
	double *along;        /* [n] of the kinetic energy of cables, that of motion along them */
	double *residual;     /* [n] bound of the relative error of omega, as that of the mesh; that of the
	                       * mesh itself is not in it */
	double *corners;      /* [n] rad/s: where cables slide over circles, the square of this may be
	                       * missing in omega^2 or too much, by the corners of the mesh; it falls
	                       * with the length of the elements. Else 0 */
	struct hawser_net_symmetry symmetry;
	/* [n][1 + HAWSER_NET_MIRRORS] part of the kinetic energy that is symmetric minus the part that is
	 * antisymmetric, -1 to 1: to the plane of the net (1: in it, -1: normal to it), then to each mirror
	 * plane; NAN without that plane. A displacement is mirrored as a vector. */
	double (*parity)[1 + HAWSER_NET_MIRRORS];
	int *waves;           /* [n] with turns n >= 3, or 2 and no mirror plane: displacements 2*pi/n apart
	                       * are as cos(2*pi*waves/n); 0 to n/2. -1: unknown */
	int *pair;            /* [n] the other mode of two with this frequency, from 0 (n: the next mode,
	                       * which is not among these); -1: none */
	/* rad/s: K - below^2*M has `counted` negative eigenvalues, as many as modes were found: n, and more
	 * of equal frequency. So none is missed. 0: these are all modes of the mesh; -1: round-off prevents
	 * the count. */
	double below;
	int counted;
	double (*shape)[3];   /* [n*nodes] */
	double (*point)[3];   /* [n*points] */
	double (*place)[3];   /* [points] m, of the equilibrium */
	int *cable;           /* [points] */
	double *S;            /* [points] m, unstretched length from the end `from` of the cable */
	int slack;            /* elements without tension, which have no stiffness */
	/* Of nets with obstacles; else none: */
	enum hawser_net_contact_modes how;
	struct hawser_net_contact *contact; /* [contacts] as in the statics; `sticks`: in the modes */
	int contacts;
	unsigned char *state; /* [points] enum hawser_net_contact_state; NULL without obstacles */
	int doubtful;         /* touches without gap and without force: the modes are those without them,
	                       * and others with them */
	int barely;           /* a point with one, if doubtful is above 0 */
	const char *method;       /* "block Lanczos"; of a mesh with few unknowns "dense" */
	int unknowns, iterations; /* iterations: solutions with the factors of K */
	void *held; /* memory of the arrays */
};
/* The first n modes; 0: 6, or all if there are fewer. Of two equal frequencies the modes are chosen
 * symmetric or antisymmetric to the planes that there are. HAWSER_ERR_NO_SOLUTION if elements are
 * slack and the net is not held without them, if one is neither slack nor taut, or if nothing that
 * moves has a mass, or if the equilibrium on its obstacles is not stable; HAWSER_ERR_ARGUMENT for
 * contact.modes: stick where nothing can stick; HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser_net_modes_solve(struct hawser_net_modes *modes, const struct hawser_net *net,
                                          int n, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_modes_clear(struct hawser_net_modes *modes);

/* What a parity is called: symmetric from 0.98 on (99 % of the energy), antisymmetric up to -0.98,
 * else mixed; to the plane of a net, in-plane and out-of-plane. NULL for NAN, and for a mixed mode
 * of a plane net. */
const char *hawser_net_side(double parity);
const char *hawser_net_plane_side(double parity);

#ifdef __cplusplus
}
#endif
#endif
