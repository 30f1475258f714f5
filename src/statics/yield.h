/* statics/yield.h - internal to the statics stage: ends on springs, which give way.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_YIELD_H
#define HAWSER_STATICS_YIELD_H

#include <hawser/statics.h>

/* force[2]: of the cable at ends A and B, in the direction of +S, along x, y, z. */
void hawser__end_forces(double force[2][3], const struct hawser_statics *st);

/* Whether an end of the scene is on springs. */
int hawser__on_springs(const struct hawser_scene *scene);

/* Displacements of the ends of *equal, which is the span between the places of the scene, at the
 * unstretched length equal->value: sets the members from `yields` on, and chord[3], between the ends
 * where they are, along x, y, z. rest[2]: forces as above where the ends are at their places.
 * HAWSER_ERR_NO_SOLUTION if an end moves by more than a tenth of the distance of the ends. */
enum hawser_status hawser__yield(struct hawser_equivalent *equal, double chord[3],
                                 const struct hawser_scene *scene, double rest[2][3],
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

/* Set st->moved and st->imbalance. */
void hawser__yield_moved(struct hawser_statics *st, const struct hawser_equivalent *equal);

#endif
