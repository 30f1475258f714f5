/* rom/condense/inertia_choice.h - which second-order shapes become coordinates: see inertia.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_INERTIA_CHOICE_H
#define HAWSER_ROM_INERTIA_CHOICE_H

#include <hawser/rom.h>

enum { HAWSER__INERTIA_MOST = 8,    /* largest number of shapes; chosen */
       HAWSER__INERTIA_PAIRS = 48 }; /* largest number of pairs that are examined; chosen to limit the
                                      * cost */
/* Ignored effect of a pair, relative to the allowed error; largest expected slope of a motion (r.m.s.),
 * within the expansion; chosen. */
#define HAWSER__INERTIA_TRIFLE 0.01
#define HAWSER__INERTIA_SLOPE 0.15

/* Of `count` weighted motions of condensed modes, square [count] their products in mass with
 * themselves, the error by each: as many vibrations in the space of as many shapes as leave an error of
 * at most `allowed`, as combination [shapes][count] of these, of mass 1, and omega [shapes]. The
 * products of the shapes in mass and in stiffness, and `cross`, those of motions with shapes in mass,
 * are given, [count][count] each: the shapes may be the motions. */
enum hawser_status hawser__inertia_choose(struct hawser_rom_inertia *inertia, double *combination,
                                          double *omega, const double *square, const double *cross,
                                          const double *mass, const double *stiffness, int count,
                                          double allowed,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
