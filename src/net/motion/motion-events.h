/* net/motion/motion-events.h - cables that part, and winches, in the time steps of a mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MOTION_EVENTS_H
#define HAWSER_NET_MOTION_EVENTS_H

#include "net/motion/motion.h"

struct hawser__motion_events {
	const struct hawser_net *net;
	int *spare;              /* [failures] node of the mesh that the loose end gets */
	double *parted, *tension; /* [failures] s, N: when it parted, and at what; NAN: not yet */
	int over;                /* of the step that is tried: 1 + the failure that is at its tension */
	int due;                 /* of the last step: the same */
	double cut;              /* s: the step that is tried must not be longer; 0: no limit */
	int cuts;                /* of it so far */
	double *length0, *before; /* [winches] m: of the cable now, and at the end of the last step */
	double wound;            /* s: the time of these lengths */
	double offset;           /* J: of the potential, which the ledger counts from the reference */
	int still[3];            /* directions in which nothing moves */
};

/* More nodes than the net's for the loose ends, without elements and held, at the end of the mesh;
 * before the motion is opened. */
void hawser__events_spare(struct hawser__mesh *mesh, const struct hawser_net *net);
/* Sets motion->events, if the net has failures or winches. initial: a file of a state, or NULL. */
enum hawser_status hawser__events_open(struct hawser__motion *motion, const struct hawser_net *net,
                                       const int still[3], const char *initial,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__events_clear(struct hawser__motion_events *events);
/* The next time at which a cable parts, or `end`. */
double hawser__events_next(const struct hawser__motion *motion, double end);
/* After a trial step: 1 if it is not too long for the tensions at which cables part. */
int hawser__events_fits(struct hawser__motion *motion, double h);
/* Let part what is due at the state. */
enum hawser_status hawser__events_part(struct hawser__motion *motion, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* The lengths that winches have at time t; their work goes to the ledger. */
void hawser__events_wind(struct hawser__motion *motion, double t);
/* A step is done: what is due, and the lengths of winches at its end. */
void hawser__events_finish(struct hawser__motion *motion);
/* 1 if a cable is to part at the state. */
int hawser__events_due(const struct hawser__motion *motion);
/* When cables parted, and the lengths at the end. */
enum hawser_status hawser__events_result(struct hawser_net_motion *to,
                                         const struct hawser__motion *motion,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* Loose ends that are not yet loose are where their nodes are: places x [nodes]. */
void hawser__events_places(double (*x)[3], const struct hawser__motion *motion);

#endif
