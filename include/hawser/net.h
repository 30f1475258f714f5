/* hawser/net.h - structures of cables: a scene of kind `net`, and its statics.
 *
 * A net is a graph: cables between nodes, some of which are held by supports. Axes as for spans: x
 * and z horizontal, y upwards. No initial shape is asked for. Cables carry tension only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_H
#define HAWSER_NET_H

#include <stddef.h>
#include <hawser/document.h>
#include <hawser/status.h>
#include <hawser/surface.h>
#include <hawser/water.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_NET_NAME = 32 }; /* size of a name, with the NUL at its end */

/* What fixes the unstretched length of a cable. */
enum hawser_net_given {
	HAWSER_NET_LENGTH0 = 0,   /* unstretched length, m */
	HAWSER_NET_TENSION,       /* mean of the tension over the elements in the equilibrium, N */
	HAWSER_NET_FORCE_DENSITY, /* tension over the length of the cable, N/m */
	HAWSER_NET_SAG            /* largest vertical distance from the chord, m */
};

struct hawser_net_node {
	char name[HAWSER_NET_NAME];
	int placed;         /* 1 if the scene gives x */
	double x[3];        /* m; of a support, or a start that statics does not need */
	unsigned char held[3]; /* 1 if a support holds this direction */
	int support;        /* 1 if the scene names it in `supports` */
	double mass;        /* kg */
	double hung, hanger; /* kg, m: of the scene, which is read as a node and a cable of their own */
	struct hawser_water_buoy buoy; /* its mass is in `mass` too */
	int body;           /* 1 + number of the rigid body it is of, which holds it; 0: none */
	double damper[3];   /* N s/m, to the ground, along x, y, z */
	double spring[3];   /* N/m, to the ground, without force in the equilibrium */
	char *table;        /* file with the motion of the support, or NULL */
};

enum { HAWSER_NET_LAW = 16 }; /* most rows of a table of EA */
struct hawser_net_cable {
	char name[HAWSER_NET_NAME];
	int from, to;       /* nodes */
	double EA, rho;     /* N, kg/m per unstretched length; EA of the first row of the law, if any */
	double law[HAWSER_NET_LAW][2]; /* [rows] strain and tension (N), both rising, from (0, 0) on; linear
	                     * between, and beyond the last row as before it */
	int rows;           /* 0: T = EA*strain */
	double dynamic, viscosity; /* N, N s: a spring of EA `dynamic` in line with one beside a dashpot, so
	                     * that all are EA at rest; 0: none */
	struct hawser_water_line line;
	const struct hawser_wind *wind; /* its section in the wind, of net->wind; NULL: it is not in it */
	int rod;            /* 1 + number of the body of which it is a straight part, without tension; 0:
	                     * none */
	double axial;       /* s, of its own, beside that of the net: a damper */
	double damper;      /* N s/m, of the scene, and in `axial` too */
	enum hawser_net_given given;
	double value;       /* of what is given */
	int elements, elements_given; /* elements_given: 1 if the scene has them, 0: the default */
};

/* A load, or the motion of a support. */
struct hawser_net_load {
	int node, cable;    /* one of them; the other is -1 */
	double value[3];    /* N of a node, N/m of a cable per unstretched length; of a motion m */
	int harmonic;       /* 0: constant; 1: value*cos(Omega*t + phase) */
	int multiple;       /* of the frequency of a response, in place of Omega: for models (net_rom.h);
	                     * 0: Omega is given */
	double Omega, phase;
	double wavelength;  /* m, of a cable: the phase falls by 2*pi over this unstretched length from its
	                     * end `from` on; 0: it is the same everywhere */
	double extent[2];   /* parts of the unstretched length of a cable between which it acts; 0, 0:
	                     * all of it */
	double (*along)[3]; /* [elements + 1] N: a harmonic load of a cable on the nodes of its mesh, from
	                     * end to end, in place of value; or NULL. Owned by the net */
};

/* What `dynamics` asks for, for time integration. */
struct hawser_net_dynamics {
	char *from;         /* file of the initial state; NULL: the equilibrium */
	int *release;       /* [releases] nodes whose supports are taken away at t = 0 */
	int releases;
	char scheme[HAWSER_NET_NAME]; /* as the scene has it; "" if it has none */
	double rho_inf;     /* -1 if the scene has none */
	double step;        /* s; 0: chosen by the program */
	int surfaces_start; /* 1: surfaces of obstacles are at rest before t = 0 */
};

/* How a support comes to its place, for friction that depends on the way. */
struct hawser_net_path {
	int node;
	double (*x)[3];     /* [points] m, from the beginning on; the last one is before the node's place */
	int points;
};

/* About which state of contact modes are. SLIP: nodes that touch move along the obstacles; STICK: those
 * that touch one with friction do not move; STATICS: each as the statics has it. */
enum hawser_net_contact_modes {
	HAWSER_NET_MODES_STATICS = 0, HAWSER_NET_MODES_SLIP, HAWSER_NET_MODES_STICK
};

/* What a node does at the obstacles. */
enum hawser_net_contact_state { HAWSER_NET_OPEN = 0, HAWSER_NET_SLIP, HAWSER_NET_STICK };

/* Friction in statics: none, but that of surfaces that move; that of the way of the supports; that of a
 * way from where lines hang loose, which the reader makes. */
enum hawser_net_sliding { HAWSER_NET_NO_SLIDING = 0, HAWSER_NET_HISTORY, HAWSER_NET_PULLED };

/* `contact` of the scene. */
struct hawser_net_contact_given {
	int history;        /* enum hawser_net_sliding, see there */
	int steps;          /* of the way, between two of its points */
	double restitution; /* of impacts */
	enum hawser_net_contact_modes modes;
	struct hawser_net_path *path; /* [paths] */
	int paths;
};

/* In motions a cable parts at the node of its mesh next to a place, at a time or a tension. */
struct hawser_net_failure {
	int cable;
	double part;        /* of its unstretched length, from its end `from`: 0 and 1 are its ends */
	double time;        /* s; negative: by the tension */
	double tension;     /* N, of an element there, with damping; 0: by the time */
};

/* In motions the unstretched length of a cable changes, by the same part in all its elements. */
struct hawser_net_winch {
	int cable, end;     /* end: 0 `from`, 1 `to`: where the material comes from */
	double speed, rise; /* m/s of the unstretched length, positive pays out, which it has after
	                     * `rise` (s): speed*(q - sin(2 pi q)/(2 pi)), q = t/rise */
	double tension;     /* N: held instead, by a speed that is `limit` where the tension differs */
	double limit;       /* m/s, by HAWSER_NET_WINCH_BAND of it, and linear between */
};
#define HAWSER_NET_WINCH_BAND 0.05

/* A mass that moves along a fixed direction relative to a node, on a spring and a damper between
 * both. Across this direction it moves with the node, whose `mass` has its mass too. */
struct hawser_net_absorber {
	char name[HAWSER_NET_NAME];
	int node;
	double mass, stiffness, damping; /* kg, N/m, N s/m */
	double direction[3]; /* a unit vector */
};

/* Nodes that a rigid body holds together. A support among them is a hinge, two are an axis. */
struct hawser_net_body {
	char name[HAWSER_NET_NAME];
	int *node, nodes;   /* [nodes] of the net */
	double mass, inertia[3]; /* kg; kg m^2, about its axes: beside the masses of nodes and rods */
	double bearing;     /* m^2: of each of its nodes on an obstacle that gives way, beside the diameter
	                     * times half of the elements of rods and lines there */
	double centre[3];   /* m, of that mass */
	double axes[3][3];  /* rows: unit vectors; those of the scene where it is as in the scene */
};

struct hawser_net {
	char *name;         /* of the file */
	double g;
	int g_given;        /* 1 if the scene has it, 0: the default */
	struct hawser_net_node *node;   /* [nodes] */
	struct hawser_net_cable *cable; /* [cables] */
	struct hawser_net_load *load;   /* [loads] */
	struct hawser_net_load *motion; /* [motions] of supports */
	int nodes, cables, loads, motions;
	int *order;         /* [nodes + cables] numbers of the nodes, then of the cables, by name; NULL if
	                     * the net is not from a scene of its kind */
	double alpha;       /* viscous force per unstretched length and velocity, kg/(m s) */
	double axial;       /* Kelvin-Voigt: T = EA*(strain + axial*its rate), s */
	int axial_given;    /* 1 if the scene has it, if 0 */
	double mass_rate;   /* 1/s: damping by this times the mass, and */
	double ratio;       /* damping ratio of each mode: both of models alone (net_rom.h) */
	struct hawser_net_dynamics dynamics;
	struct hawser_surface *surface; /* [surfaces] the obstacles */
	int surfaces;
	struct hawser_net_contact_given contact;
	struct hawser_net_failure *failure; /* [failures] */
	struct hawser_net_winch *winch; /* [winches] */
	int failures, winches;
	struct hawser_net_absorber *absorber; /* [absorbers] */
	int absorbers;
	struct hawser_net_body *body; /* [bodies] */
	int bodies;
	struct hawser_water water;
	struct hawser_wind *wind; /* [winds] the wind, then those with the sections of cables of their own
	                           * (scene.h); owned */
	int winds;                /* 0: none */
};

/* Read a scene of kind `net`; `set` has overrides, such as "cables.c1.EA=100 MN". */
enum hawser_status hawser_net_open(struct hawser_net *net, const char *path,
                                   const char *const *set /* [nset] */, size_t nset,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same from a document that was read before. */
enum hawser_status hawser_net_of(struct hawser_net *net,
                                 const struct hawser_document *from,
                                 const char *const *set, size_t nset,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_clear(struct hawser_net *net);

/* --- statics --- */

struct hawser_net_options {
	const char *method; /* a row of hawser_net_method; NULL: the first */
	double tolerance;   /* of the largest force that is not balanced, over weight and loads; 0: 1e-10 */
	int iterations;     /* most; 0: the method's own */
};

/* What a cable has come to. */
struct hawser_net_member {
	/* N, along the cable; and at its ends `from` and `to`. Tensions of nodes follow from the balance of
	 * the halves of elements there: their error is of second order in the length of elements. */
	double T_min, T_max, T_from, T_to;
	double length0, length;            /* m */
	double wet;                        /* m, unstretched length in water */
	int slack;                         /* number of elements without tension */
};

/* A node of the mesh on a cable. */
struct hawser_net_point {
	int cable;
	double S;    /* m, unstretched length from the end `from` */
	double x[3]; /* m */
	double T;    /* N */
};

/* A node of the mesh that touches an obstacle. */
struct hawser_net_contact {
	int surface;        /* of the net */
	int node, cable;    /* a node of the net, or one on a cable; the other is -1 */
	double S;           /* m, on the cable, from its end `from` */
	double length0;     /* m: half of the elements at the node, its part of the unstretched length */
	double x[3];        /* m */
	double r;           /* N: force of the obstacle along its normal, > 0 */
	double friction[3]; /* N: its force along the surface */
	int sticks;         /* 1: it stays where it is; 0: it slides, or would without resistance */
};

struct hawser_net_statics {
	int nodes, cables, points, unknowns, contacts;
	double (*x)[3];        /* [nodes] positions */
	double (*reaction)[3]; /* [nodes] forces of the supports on the net, N; 0 where nothing is held */
	struct hawser_net_member *member; /* [cables] */
	struct hawser_net_contact *contact; /* [contacts] touches: nodes of the net, then along cables */
	struct hawser_net_body *body; /* [bodies] as they are now, without a list of nodes */
	int bodies;
	double apart;          /* m: largest penetration of an obstacle, or gap of a node that touches */
	struct hawser_net_point *point;   /* [points] along cable 0, cable 1 and so on */
	double energy;         /* J: strain energy minus loads times positions */
	double gap;            /* J: the energy is at most this above the least one, friction held as it
	                        * is; infinite where it touches a circle from outside, or a segment: there
	                        * may be other equilibria */
	double residual;       /* N: largest component of a force that is not balanced */
	double floor;          /* N: what round-off allows */
	const char *method;
	int iterations;
};
/* The only equilibrium of the net: cables carry tension only. */
enum hawser_status hawser_net_solve(struct hawser_net_statics *st, const struct hawser_net *net,
                                    const struct hawser_net_options *options /* or NULL */,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_statics_clear(struct hawser_net_statics *st);

/* Error of the tensions by the mesh: of those at the ends of cables, and of the largest ones. */
struct hawser_net_mesh_error {
	double tension; /* over T_max of the cable, or 0.01 of the largest T_max if that is more; NAN: not
	                 * known */
	int cable;      /* with the largest error; -1: none has one */
	int exact;      /* 1: against exact catenaries; 0: by meshes with fewer elements */
};
/* st: the equilibrium of the net, or NULL: it is found here. Where there is none, tension is NAN, and
 * the status HAWSER_OK. */
enum hawser_status hawser_net_mesh_error(struct hawser_net_mesh_error *error,
                                         const struct hawser_net *net,
                                         const struct hawser_net_statics *st /* or NULL */,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* Choose the elements of cables whose number is not given, so that this error is below 1e-3, at most
 * 400 a cable. A net without equilibrium stays as it is. */
enum hawser_status hawser_net_refine(struct hawser_net *net, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* The tangent stiffness of the equilibrium at nodes that move together, as a rigid body, while all
 * other free nodes follow. Contacts stay as they are; those of these nodes themselves are not
 * counted. */
struct hawser_net_stiffness {
	int size;         /* 3: motions along x, y, z; 6: turns about x, y, z through `about` too */
	double about[3];  /* m */
	double K[6][6];   /* row: force (N) or moment (N m) of the outside on the body; column: motion, of
	                   * 1 m or 1 rad. A body turns with the forces on it: its lines keep their ends */
	double force[6];  /* N, N m: of the outside on the body, in the equilibrium */
	double asymmetry; /* largest |K_ij - K_ji| over sqrt(|K_ii K_jj|) + |K_ij| + |K_ji|: of friction
	                   * that slides, or of turns, where moments act; else round-off */
};
/* Of the nodes node [nodes], and all others of their rigid bodies; about [3], m, or NULL: size 3, or
 * of a body 6 about its hinge or, without one, the mean of its nodes in the equilibrium. A net without
 * equilibrium fails as hawser_net_solve does. */
enum hawser_status hawser_net_stiffness_of(struct hawser_net_stiffness *stiffness,
                                           const struct hawser_net *net,
                                           const int *node, int nodes, const double *about,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

struct hawser_net_method {
	const char *name, *summary, *source;
};
const struct hawser_net_method *hawser_net_method(int index); /* NULL beyond the last */

#ifdef __cplusplus
}
#endif
#endif
