/* study/accuracy/carry.h - orbits of a curve as those of another model: see carry.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CARRY_H
#define HAWSER_STUDY_CARRY_H

#include <hawser/frf.h>

#include "response/branch/trace.h"

/* The orbits which[count] of another model, `rom`, which moves by map [rom->n][orbits->n] as that of
 * the orbits does: each is the point nearest to that orbit on the curve of `rom`, in the plane normal
 * to the other curve. *lost: 1: one of them was not found, or it is far away, or the caller stopped the
 * search (frf->end says so); it ends there. `frf` becomes these points, with the arclength of the other
 * curve; clear it, whatever the status.
 * Statuses: HAWSER_ERR_MEMORY, HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser__carry(struct hawser_frf *frf, int *lost, const struct hawser_rom *rom,
                                 const struct hawser__orbits *orbits, const int *which, int count,
                                 const double *map, const struct hawser_frf_options *options,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
