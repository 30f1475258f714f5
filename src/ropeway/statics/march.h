/* ropeway/statics/march.h - internal: the rope laid from end A over its sheaves to end B.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_MARCH_H
#define HAWSER_ROPEWAY_MARCH_H

#include "core/hold.h"
#include "ropeway/statics/rope.h"

/* Why there is no rope. */
enum hawser__fault {
	HAWSER__NO_FAULT = 0,
	HAWSER__FAULT_TOO_LOW, /* the tension is too low to come down to the target `to` behind `from` */
	HAWSER__FAULT_LOST     /* the sheaves that the rope presses were not found */
};

struct hawser__march {
	const struct hawser_line *line;
	const double *A;             /* [2] */
	struct hawser__rope rope;
	struct hawser__target *target; /* [sheaves + 1], end B last */
	struct hawser__path *start;  /* [sheaves + 1] begin of the path of each sheave that is pressed,
	    A first */
	int *index, *pieces, *pending; /* [sheaves +
	                                   1] its sheave; pieces laid before; mass pending there */
	char *off;                   /* [sheaves] 1: the rope passes this sheave without contact */
	char *kept;                  /* [sheaves] another such set */
	struct hawser__rope_trace trace;
	int sheaves;
	int slack_behind;            /* the span behind this sheave (-1: A) is slack; -2: none is */
	enum hawser__fault fault;
	int from, to;                /* sheaves of a fault */
	int iterations;              /* ropes laid */
	struct hawser__rope_point begin, end; /* ends A and B */
	double miss;                 /* m, how far from B the rope ends */
	struct hawser__hold hold;
};

enum hawser_status hawser__march_open(struct hawser__march *march, struct hawser_line_statics *st,
                                      const struct hawser_line *line, struct hawser_report *report);
void hawser__march_clear(struct hawser__march *march);
/* Lay the rope with P at A. Returns 1 if it reaches B in equilibrium, pressing each sheave that
 * is not `off`. */
int hawser__march(struct hawser__march *march, double P);
/* The least index whose sheave the rope penetrates without contact, by more than round-off; -1:
 * none. Sets the clearances of the sheaves without contact. */
int hawser__march_clearances(struct hawser__march *march);
/* The sheaves that the rope presses, by looking ahead from each. Slower than hawser__march, and
 * sure. Sets `off`. */
int hawser__march_ahead(struct hawser__march *march, double P);

#endif
