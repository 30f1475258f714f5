/* ropeway/transient/transient.h - internal: the chain of masses and springs of a ropeway in motion.
 *
 * Lane up has the index 0, lane down 1. A lane's nodes are numbered from the bottom bullwheel (0)
 * to the drive (E); its elements 1 to E, element e between nodes e - 1 and e. q is the speed of the
 * rope, > 0 in the direction of running: up on lane up, down on lane down.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_TRANSIENT_H
#define HAWSER_ROPEWAY_TRANSIENT_H

#include <hawser/transient.h>

#include "core/hold.h"
#include "ropeway/statics/line.h"

/* What a span has from the statics of a phase. */
struct hawser__slow_span {
	double content;            /* m, unstretched, from a fixed place of a battery to that of the next */
	double T_from, T_to, T_min, T_max; /* N, without the rope's speed */
};
struct hawser__slow_tower {
	double normal;             /* N, integral of the normal force */
	double pressing, turn;     /* N; rad: angle_in - angle_out */
};

/* Statics without friction at equidistant phases over the spacing, and means over them. */
struct hawser__slow {
	int phases, spans, towers; /* of a lane */
	double spacing;            /* m; 0: one state */
	double *force, *travel;    /* [phases] N, m: of the drive, of the carriage */
	double *rest;              /* [phases] m, of the loop, besides the contents of the spans */
	double *T_top;             /* [phases][2] N */
	struct hawser__slow_span *span;   /* [phases][2][spans] */
	struct hawser__slow_tower *tower; /* [phases][2][towers] */
	/* Means [2][spans]: */
	double *length, *elastic, *sagging, *chord, *tension, *mass; /* m; m/N by stretch; m/N by sag; m; N;
	                                                              * kg: twice that of a sine of
	                                                              * amplitude 1, with carriers */
	double *sheaves;           /* [2][towers] kg, inertia of turning sheaves over radius squared */
	int *side;                 /* [towers] */
	struct hawser__hold hold; /* its arrays */
};
enum hawser_status hawser__slow_open(struct hawser__slow *slow, const struct hawser_ropeway *rw,
                                     const struct hawser_transient_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__slow_clear(struct hawser__slow *slow);

/* The statics at one phase, by linear interpolation. */
struct hawser__slow_now {
	double force, travel, T_top[2], rest;
	struct hawser__slow_span *span;   /* [2][spans] */
	struct hawser__slow_tower *tower; /* [2][towers] */
};
enum hawser_status hawser__slow_now_open(struct hawser__slow_now *now, const struct hawser__slow *slow,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__slow_now_clear(struct hawser__slow_now *now);
void hawser__slow_at(struct hawser__slow_now *now, const struct hawser__slow *slow, double phase);

/* Which of two laws of friction hold at the drive: rope on bullwheel, bullwheel on motor or brake. Each
 * -1, 0, 1: 0 sticks; else the sign of the force of the second on the first. */
struct hawser__drive_state {
	int rope, motor;
};

struct hawser__chain {
	const struct hawser_ropeway *rw;
	const struct hawser__slow *slow;
	double loads[2];           /* kg, of a carrier of each lane */
	int m, E, N;               /* elements of a span, of a lane; unknowns: B, X, nodes in pairs, D */
	double h, loss;            /* s; s: tension by the rate of strain, over EA */
	/* State at the end of a step: [N] travel (m) and speed (m/s) of the rope past each node; number
	 * 1 is the carriage. [2][spans] coordinates of sag, m, m/s. Wheel: m/s. */
	double *u, *q, *sag, *sag_q, wheel, t;
	double *d, *tension;       /* [2][E + 1] m: content of each element by statics; N: excess, of
	                            * the mean of the step */
	double *mass;              /* [N] kg, at the middle of the step */
	double *rate, *solved;     /* [N] m/s^2, m/s: means of the last step */
	double *sag_middle, *sag_solved; /* [2][spans] m, m/s: means of the step */
	double *still;             /* [2][spans] m, coordinate of sag that belongs to the statics */
	double *bound;             /* [N] N, of friction at this node; 0: none */
	int *state;                /* [N] -1, 0, 1: sign of the speed of a node that slides, 0: it sticks */
	double *band, *rhs;        /* [N][4], [N] of the step's equations */
	double *alpha, *kappa;     /* [2][E + 1] tension of an element: alpha - kappa*flow into it */
	double *c, *gamma, *K, *M, *press; /* [2][spans] m/N of an element; of the sag: m/m, N/m, kg; N/m */
	double *lump;              /* [N] kg, of rope, wheels and sheaves */
	double top_mass[2];        /* kg, of each lane in the node of the drive */
	double wheel_mass;         /* kg, of the bullwheel and the drive */
	double carriage;           /* kg; 0: it is fixed */
	/* Law of the drive: speed that motor or brake holds, N that it has for it. */
	double reference, motor_most;
	double traction;           /* N, of the step */
	double drive, motor;       /* N, mean of the step: on the rope, of the motor */
	struct hawser__drive_state at_drive;
	struct hawser__slow_now now, start;
	double work, slow_work, dissipated, exchanged, slip; /* J; m */
	long steps, solves;
};

/* Number of a node. */
static inline int hawser__chain_node(const struct hawser__chain *chain, int lane, int e)
{
	return e == 0 ? 0 : e == chain->E ? 2*chain->E : 2*e + lane;
}

enum hawser_status hawser__chain_open(struct hawser__chain *chain, const struct hawser_ropeway *rw,
                                      const struct hawser__slow *slow,
                                      const struct hawser_transient_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__chain_clear(struct hawser__chain *chain);
/* At rest without friction, or running steadily at `speed`. */
enum hawser_status hawser__chain_begin(struct hawser__chain *chain, double speed,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Statics, masses and bounds at the phase that belongs to a travel of the rope (m). */
void hawser__chain_place(struct hawser__chain *chain, double travelled);
/* Bounds of friction from the tensions of the step. */
void hawser__chain_bounds(struct hawser__chain *chain);
/* Force that presses the rope on a battery, N; normal 1: integral of the normal force. */
double hawser__chain_pressing(const struct hawser__chain *chain, int lane, int tower, int normal);
/* One step of length h: the law of the drive is set before. */
enum hawser_status hawser__chain_step(struct hawser__chain *chain,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
double hawser__chain_kinetic(const struct hawser__chain *chain, const double *mass);
double hawser__chain_stored(const struct hawser__chain *chain);
/* Tension of an element by content, sag and carriage at the end of the step, N, above statics. */
double hawser__chain_excess(const struct hawser__chain *chain, int lane, int e);
/* Tensions of the lanes at the bullwheel of the drive in the last step, N, without the rope's speed. */
void hawser__chain_top(double T[2], const struct hawser__chain *chain);

/* transient_rows.c: the row of the last step; the extremes with it; and what is refused. */
void hawser__transient_row(struct hawser_transient_row *row, const struct hawser__chain *chain);
void hawser__transient_extremes(struct hawser_transient *run, const struct hawser__chain *chain,
                                const struct hawser_transient_row *row);
enum hawser_status hawser__transient_judge(struct hawser_transient *run,
                                           const struct hawser__chain *chain,
                                           const struct hawser_transient_row *row,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
