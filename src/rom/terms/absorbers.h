/* rom/terms/absorbers.h - absorbers of attachments in a reduced model: see absorbers.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ABSORBERS_H
#define HAWSER_ROM_ABSORBERS_H

#include <hawser/rom.h>

/* Stiffness of the spring of the absorber at attachment i, and of its cubic term, scaled; 0 without
 * an absorber. */
double hawser__absorber_stiffness(const struct hawser_statics *statics, int i);
double hawser__absorber_cubic(const struct hawser_statics *statics, int i);

/* 1 if an absorber has a damper or a cubic spring: its force is then not that of its mode. */
int hawser__absorber_forced(const struct hawser_statics *statics, int i);
/* 1 if any absorber has a cubic spring. */
int hawser__has_cubic(const struct hawser_statics *statics);

/* Add to K [n][n], n = modes->n, the energy of the springs, without the cubic term. */
void hawser__absorbers_stiffen(double *K, const struct hawser_modes *modes);

/* Add to D [n][n] the dampers of absorbers, and take from it what the damping of the scene, mass times
 * M plus stiffness times K (scaled), would do to absorbers. */
void hawser__absorbers_damp(double *D, const struct hawser_modes *modes, double mass,
                            double stiffness);

/* D [n][n], zero on entry, of the damping ratios of the scene: those of the modes whose absorbers are
 * held. Statuses of hawser_modes_solve. */
enum hawser_status hawser__absorbers_ratio(double *D, const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report);

/* Fourth derivative of the energy of the cubic springs by the coordinates index [4] of modes. */
double hawser__absorbers_fourth(const struct hawser_modes *modes, const int index[4]);

/* Force [n] and, unless NULL, tangent [n][n] += those of the cubic springs at u [n]; and their energy.
 * cubic [absorbers], stroke [absorbers][n]. */
void hawser__cubics_add(double *restoring, double *tangent, const double *u, int n,
                        const double *cubic, const double *stroke, int absorbers);
double hawser__cubics_energy(const double *u, int n, const double *cubic, const double *stroke,
                             int absorbers);

#endif
