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
	const struct hawser__tow_end *hung; /* on a joint without moment, or a mass */
	struct hawser__tow_end now;    /* the body in the state */
};

/* Drag per length of element e (N/m), and unless NULL its derivatives by flow and chord. */
void hawser__tow_rod_drag(double f[3], double (*f_u)[3], double (*f_d)[3],
                          const struct hawser__tow_rod *b, int e);
/* Forces that are not balanced into mesh.r, and the matrix. */
void hawser__tow_rod_assemble(struct hawser__tow_rod *b);

#endif
