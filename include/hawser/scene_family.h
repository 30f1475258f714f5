/* hawser/scene_family.h - the models of a scene over one of its keys, such as the tension.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_FAMILY_H
#define HAWSER_SCENE_FAMILY_H

#include <hawser/family.h>
#include <hawser/net_rom.h>
#include <hawser/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The family of the models of a scene over one of its keys, at `omega` rad/s. The coordinates are the
 * lowest modes at the value `at`; at other values of the range, which includes it, they are the modes
 * that these become: modes may cross each other, and are followed by their shapes. Condensed modes are
 * condensed, but without coordinates for their inertia. `scene` is used as long as the family is.
 * Release with hawser_scene_family_close. HAWSER_ERR_ARGUMENT (a key that is no number, a scene with
 * model.modes: auto, or with the full-order model); of the statics and modes at `at`. */
enum hawser_status hawser_scene_family_open(struct hawser_rom_family *family,
                                            const struct hawser_scene *scene, const char *key,
                                            double from, double to, double at, double omega,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_scene_family_close(struct hawser_rom_family *family);
/* The same over two keys: arrays of both. Release with hawser_plane_close. */
enum hawser_status hawser_scene_plane_open(struct hawser_rom_plane *plane,
                                           const struct hawser_scene *scene,
                                           const char *const key[2], const double from[2],
                                           const double to[2], const double at[2], double omega,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same of a net, which `make` gives at a value of the parameter, with the same elements; the family
 * clears it. Coordinates are those of the options at the value `first`, in its units. Release with
 * hawser_net_family_close. HAWSER_ERR_NO_SOLUTION: the modes become others. */
struct hawser_net_at {
	enum hawser_status (*make)(void *context, struct hawser_net *net, double p,
	                           struct hawser_report *report);
	void *context;
};
enum hawser_status hawser_net_family_open(struct hawser_rom_family *family,
                                          const struct hawser_net_at *at,
                                          const struct hawser_net_rom_options *options, double from,
                                          double to, double first, double omega,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_family_close(struct hawser_rom_family *family);

#ifdef __cplusplus
}
#endif

#endif
