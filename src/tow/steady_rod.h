/* tow/steady_rod.h - the cable as a rod in a steady state: what its files share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TOW_STEADY_ROD_H
#define HAWSER_TOW_STEADY_ROD_H

#include "rod/mesh.h"
#include "tow/steady.h"

struct hawser__tow_rod {
	const struct hawser__tow_frame *frame;
	struct hawser_rod rod;
	struct hawser__rod_mesh mesh;
	double rigid;                  /* P */
	double spring[2];              /* N/m, N m/rad of the joint; 0: none */
	double pull[3];                /* N, that holds its ends at one place; corrected as those of rigid
	                                * directions */
	int last, end;                 /* node of the cable's end, of the ring */
	int raised;                    /* elements whose EI was raised, as the mesh does not show it */
	int moves;                     /* 1: for a motion: a ring on a joint has a node, too */
	int links;                     /* 1: end and last are different nodes */
	const struct hawser__tow_end *hung; /* on a joint without moment, or a mass */
	struct hawser__tow_end now;    /* the body in the state */
};

/* Drag per length of element e (N/m), and unless NULL its derivatives by flow and chord. */
void hawser__tow_rod_drag(double f[3], double (*f_u)[3], double (*f_d)[3],
                          const struct hawser__tow_rod *b, int e);
/* Forces that are not balanced into mesh.r, and the matrix. */
void hawser__tow_rod_assemble(struct hawser__tow_rod *b);

/* 1: the body has no moment on the cable. */
int hawser__tow_hangs(const struct hawser_tow *tow);
/* steady_rod.c: the state of a rod with parts times the elements, from the shape of a string; b->frame
 * and b->moves are set, b->hung is for a body without moment. Release it with hawser__tow_rod_close,
 * also on failure. */
enum hawser_status hawser__tow_rod_solve(struct hawser__tow_rod *b,
                                         const struct hawser_tow_point *string, int parts,
                                         const struct hawser__tow_end *body,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__tow_rod_close(struct hawser__tow_rod *b);
/* steady.c: the start of a motion of *tow, whose path is straight or an orbit; body is the string's. */
enum hawser_status hawser__tow_rod_start(struct hawser__tow_rod *b, struct hawser__tow_frame *frame,
                                         struct hawser__tow_end *body, const struct hawser_tow *tow,
                                         int parts, struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
