/* hawser/net.h - structures of cables: a scene of kind `net`, and its statics.
 *
 * A net is a graph: cables between nodes, some of which are held by supports. Axes as for spans: x
 * and z horizontal, y upwards. No initial shape is asked for. Cables carry tension only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_H
#define HAWSER_NET_H

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_NET_NAME = 32 }; /* size of a name, with the NUL at its end */

/* What fixes the unstretched length of a cable. */
enum hawser_net_given {
	HAWSER_NET_LENGTH0 = 0,   /* unstretched length, m */
	HAWSER_NET_TENSION,       /* mean of the tension over the elements in the equilibrium, N */
	HAWSER_NET_FORCE_DENSITY, /* tension over length of each element, N/m */
	HAWSER_NET_SAG            /* largest vertical distance from the chord, m */
};

struct hawser_net_node {
	char name[HAWSER_NET_NAME];
	int placed;         /* 1 if the scene gives x */
	double x[3];        /* m; of a support, or a start that statics does not need */
	unsigned char held[3]; /* 1 if a support holds this direction */
	int support;        /* 1 if the scene names it in `supports` */
	double mass;        /* kg */
	char *table;        /* file with the motion of the support, or NULL */
};

struct hawser_net_cable {
	char name[HAWSER_NET_NAME];
	int from, to;       /* nodes */
	double EA, rho;     /* N, kg/m per unstretched length */
	enum hawser_net_given given;
	double value;       /* of what is given */
	int elements;
};

/* A load, or the motion of a support. */
struct hawser_net_load {
	int node, cable;    /* one of them; the other is -1 */
	double value[3];    /* N of a node, N/m of a cable per unstretched length; of a motion m */
	int harmonic;       /* 0: constant; 1: value*cos(Omega*t + phase) */
	double Omega, phase;
};

/* What `dynamics` asks for, for time integration. */
struct hawser_net_dynamics {
	char *from;         /* file of the initial state; NULL: the equilibrium */
	int *release;       /* [releases] nodes whose supports are taken away at t = 0 */
	int releases;
	char scheme[HAWSER_NET_NAME]; /* as the scene has it; "" if it has none */
	double rho_inf;     /* -1 if the scene has none */
	double step;        /* s; 0: chosen by the program */
};

struct hawser_net {
	char *name;         /* of the file */
	double g;
	struct hawser_net_node *node;   /* [nodes] */
	struct hawser_net_cable *cable; /* [cables] */
	struct hawser_net_load *load;   /* [loads] */
	struct hawser_net_load *motion; /* [motions] of supports */
	int nodes, cables, loads, motions;
	double alpha;       /* viscous force per unstretched length and velocity, kg/(m s) */
	double axial;       /* Kelvin-Voigt: T = EA*(strain + axial*its rate), s */
	struct hawser_net_dynamics dynamics;
};

void hawser_net_clear(struct hawser_net *net);

#ifdef __cplusplus
}
#endif
#endif
