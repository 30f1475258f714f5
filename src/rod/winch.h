/* rod/winch.h - a rod whose first segment lengthens at its start: length in time, mesh, inertia.
 *
 * The elements of the segment have constant shares of its length l(t), so that nodes move through the
 * material. Material is at the distance s from the start, s' = l'; a node at s = l sigma, s' = l'
 * sigma. The velocity of the material at a node is that of the node and (1 - sigma) l' dx/ds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_WINCH_H
#define HAWSER_ROD_WINCH_H

#include "core/hold.h"
#include "rod/mesh.h"

struct hawser__rod_motion;

struct hawser__rod_winch {
	const struct hawser_rod_winch *as; /* NULL: there is none, and nothing else is set */
	int elements;              /* of the first segment */
	double *part;              /* [elements] of the segment */
	double *left;              /* [elements+1] of the segment, beyond each of its nodes: 1 - sigma */
	double *curve;             /* [rows] of lengths: second derivatives; of speeds: length there */
	double from, first;        /* s, m: when the motion begins (0), and the length then */
	double length, speed, rate; /* l, l', l'' of the state: m, m/s, m/s2 */
	double (*slip)[6], (*slip0)[6]; /* [nodes] m/s: velocity of the material less that of the node;
	                            * N m: the spin that comes in, d(J)/dt w; 0: before the step */
	double power, store;       /* W, J: of the ledger, see motion_winch.c */
	double over;               /* m, paid out or in faster than waves run, so far without a break */
	struct hawser__hold hold;
};

/* Memory, and the length at the time `from`, that of the mesh; fails if the length is too short before
 * `until`. */
enum hawser_status hawser__rod_winch_open(struct hawser__rod_winch *winch,
                                          const struct hawser__rod_mesh *mesh, double from,
                                          double until, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* After a state is read, which had this length: fails if the winch has another one then. */
enum hawser_status hawser__rod_winch_same(const struct hawser__rod_motion *motion, double length,
                                          const char *path, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__rod_winch_clear(struct hawser__rod_winch *winch);
/* l, l', l'' at time t. */
void hawser__rod_winch_at(double l[3], const struct hawser__rod_winch *winch, double t);
/* Lengths of the elements, places s and masses of the nodes at time t. */
void hawser__rod_winch_set(struct hawser__rod_motion *motion, double t);
/* Add to the velocities those with which the state at t = 0 lengthens: of the rod at rest, or of its
 * equilibrium. 1: the latter is not determined. */
int hawser__rod_winch_begin(struct hawser__rod_motion *motion, int rest);

/* --- motion_winch.c --- */

/* slip, of the state. */
void hawser__rod_winch_slip(struct hawser__rod_motion *motion);
/* Subtract from mesh->r the inertia that the nodes' own masses leave out; and its derivatives. */
void hawser__rod_winch_form(struct hawser__rod_motion *motion, int tangent);
/* Kinetic energy that is not of the masses of the nodes with the mean velocity of their material. */
double hawser__rod_winch_kinetic(const struct hawser__rod_motion *motion);
/* power and store, of the state. */
void hawser__rod_winch_power(struct hawser__rod_motion *motion);
/* After a step: 1 if the rod has been paid out or in for too long faster than waves run. */
int hawser__rod_winch_watch(struct hawser__rod_motion *motion);
/* m/s: of the material through the middle of element e. */
double hawser__rod_winch_through(const struct hawser__rod_motion *motion, int e);

#endif
