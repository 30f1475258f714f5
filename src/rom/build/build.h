/* rom/build/build.h - the parts that every model of a cable has, whatever its energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_BUILD_H
#define HAWSER_ROM_BUILD_H

#include <hawser/rom.h>

/* HAWSER_ERR_ARGUMENT if the modes are complex. */
enum hawser_status hawser__rom_real(const struct hawser_modes *modes,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* A model of modes->n coordinates with units, K and, if `scene` is not NULL, D. On failure the
 * model is zero, or must be cleared by the caller. */
enum hawser_status hawser__rom_begin(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser_scene *scene,
                                     struct hawser_report *report);

/* For a model of `modes`: the modes with the static shapes of dampers (dampers.h); with->n = 0 if
 * none are needed. HAWSER_ERR_ARGUMENT for attachments that a reduced model cannot have. */
enum hawser_status hawser__rom_attached(struct hawser_modes *with, const struct hawser_modes *modes,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report);

/* hawser_rom_build whose coordinates are `modes` and no others, for estimates: dampers act on them
 * without the shapes of their kinks. It refuses the same scenes. */
enum hawser_status hawser__rom_of_modes(struct hawser_rom *rom, const struct hawser_modes *modes,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The scene's damping, added to D: on the diagonal but for attachments. Statuses of hawser_modes_solve,
 * which damping ratios with absorbers call. */
enum hawser_status hawser__rom_damping(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       const struct hawser_scene *scene,
                                       struct hawser_report *report);

/* K [n][n] += factor * the stiffness that the second-order shapes add to the modes if a harmonic's
 * force f [n] displaces them statically by f_s/K_ss. Does nothing if the model has no shapes. */
void hawser__rom_held(double *K, const struct hawser_rom *rom, const double *f, double factor);

/* hawser_rom_build_linear without the terms of the energy by moving supports, which are the last
 * harmonics of a model. */
enum hawser_status hawser__rom_build_forces(struct hawser_rom *rom,
                                            const struct hawser_modes *modes,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report);

/* The attachment whose stroke shape point p of a model of these statics is, or -1: those of absorbers
 * follow the points of the cable. */
int hawser__rom_stroke_point(const struct hawser_statics *statics, int p);

/* Load, labels and probes. */
enum hawser_status hawser__rom_finish(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene,
                                      struct hawser_report *report);

#endif
