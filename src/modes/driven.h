/* modes/driven.h - what the modes that are not kept do under a force that oscillates at the frequency
 * W, of any structure whose static solutions are known:
 *
 *    field[0] + W^2 field[1] + sum_s force[s] H_s(W) field[2 + s]
 *
 * with H_s of rom/condense/known.c. See driven.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_DRIVEN_H
#define HAWSER_MODES_DRIVEN_H

#include <stddef.h>

#include <hawser/status.h>

/* The structure. A displacement is a row of `width` numbers. */
struct hawser__driven_by {
	const void *of;
	size_t width;
	/* x'My of each of the rows x [count][width], part [count]; and to = P K^-1 M from, where P takes
	 * the kept modes out of a displacement. */
	void (*products)(const void *of, double *part, const double *x, int count, const double *y);
	enum hawser_status (*follow)(const void *of, double *to, const double *from,
	                             struct hawser_report *report);
};

struct hawser__driven {
	int known;                /* motions s, of frequencies omega2^(1/2), ascending */
	double *omega2, *force;   /* [known] */
	size_t width;
	double *field;            /* [2 + known][width] */
	double reach;             /* below this frequency they are modes, all that the force drives */
};
static inline double *hawser__driven_field(const struct hawser__driven *driven, int i)
{
	return driven->field + (size_t)i*driven->width;
}

/* Room for it, zero; the caller fills field[0], P K^-1 b of the force b. Then the rest. Clear, on
 * failure too. */
enum hawser_status hawser__driven_open(struct hawser__driven *driven, size_t width,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__driven_find(struct hawser__driven *driven,
                                       const struct hawser__driven_by *by,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__driven_clear(struct hawser__driven *driven);

#endif
