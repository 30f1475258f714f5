/* rom/condense/inertia.h - inertia of the condensed modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_INERTIA_H
#define HAWSER_ROM_INERTIA_H

#include <hawser/rom.h>

#include "rom/condense/condense.h"

/* Number of lowest modes of the cable that are treated by the choice of modes: shapes are
 * orthogonal to them. */
enum { HAWSER__LOWEST = 32 };

/* *with becomes the modes of `modes` followed by second-order shapes as further ones (number 0), if
 * their inertia matters at the amplitudes that load[modes->n] and damping[modes->n] cause;
 * `condensed` belongs to the same modes. If it does not matter, or a mode has neither load nor
 * damping, with->n is 0. *inertia has the errors without and with the shapes. Clear *with.
 * Statuses: HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__inertia_extend(struct hawser_modes *with,
                                          struct hawser_rom_inertia *inertia,
                                          const struct hawser_modes *modes,
                                          const struct hawser__condensed *condensed,
                                          const double *load, const double *damping,
                                          double allowed, struct hawser_report *report);

/* Amplitude of mode j (the resonance, limited to the validity of the energy), for the modal load and
 * damping. inertia_amplitude.c. */
double hawser__inertia_amplitude(const struct hawser_modes *modes, int j, double load,
                                 double damping);

/* Largest relative error of resonance frequencies by the neglected inertia of condensed modes: a
 * small part of the accuracy; chosen. inertia_amplitude.c. */
double hawser__inertia_allowed(const struct hawser_scene *scene);

/* --- inertia_choice.c: which second-order shapes become coordinates: see inertia.c --- */

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
