/* modes/label.h - norm, sign and classification of modes, for all methods.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_LABEL_H
#define HAWSER_MODES_LABEL_H

#include <stddef.h>

#include <hawser/modes.h>

/* Values of a shape: [parts][points][3]. */
static inline size_t hawser__modes_row(const struct hawser_modes *modes)
{
	return 3*(size_t)modes->grid.points*(modes->gyroscopic ? 2 : 1);
}

/* Allocate n modes on a grid of `points` nodes; modes->gyroscopic and ->statics are set. Status:
 * _MEMORY. */
enum hawser_status hawser__modes_allocate(struct hawser_modes *modes, int n, int points,
                                          struct hawser_report *report);

/* A copy with `more` further modes at the end, all zero. Status: _MEMORY. */
enum hawser_status hawser__modes_extend(struct hawser_modes *with, const struct hawser_modes *modes,
                                        int more, struct hawser_report *report);

/* Set sign, norm, family, symmetry and participation of real mode k from its shape and slope; returns
 * its norm before. */
double hawser__mode_label(struct hawser_modes *modes, int k);

/* Fill the remaining members of all modes from their plane, eigenvalue, shape and slope. Statics and
 * grid must be set. Status: _NAN. */
enum hawser_status hawser__modes_label(struct hawser_modes *modes, struct hawser_report *report);

/* damping.ratio of a mode; a shape that is no mode (number 0) has the last one. */
double hawser__damping_ratio(const struct hawser_scene *scene, const struct hawser_mode *mode);

/* The points that may have a mass: the attachments, then both ends if one is on springs. */
struct hawser__point {
	double s, m; /* scaled */
};
int hawser__points(const struct hawser_statics *statics);
struct hawser__point hawser__point(const struct hawser_statics *statics, int i);

/* Displacement of point i in mode k along x, y, z. */
void hawser__modes_attached(double u[3], const struct hawser_modes *modes, int k, int i);

/* The part of its mass that moves with the point, and the displacement of that of the absorber at it,
 * if there is one: mass `absorber`, u plus the stroke in mode k. */
double hawser__point_bare(const struct hawser_statics *statics, int i);
double hawser__point_absorber(const struct hawser_statics *statics, int i);
void hawser__modes_absorber(double w[3], const struct hawser_modes *modes, int k, int i,
                            const double u[3]);

/* Stroke of the absorber at attachment i in mode k; 0 if there is none. */
static inline double hawser__stroke(const struct hawser_modes *modes, int k, int i)
{
	return modes->stroke && i < modes->statics.attachments
	       ? modes->stroke[k*modes->statics.attachments + i] : 0.0;
}

#endif
