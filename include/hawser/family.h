/* hawser/family.h - models that depend on a parameter, so that periodic motions can be followed in it.
 *
 * The models of a family have the same coordinates, in the same order and with the same signs. Their
 * units may depend on the parameter, continuously. A motion is then nearly the same physical motion in
 * two models of nearly the same parameter if its coordinates are nearly the same.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_FAMILY_H
#define HAWSER_FAMILY_H

#include <hawser/rom_source.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_rom_family {
	double omega; /* > 0, frequency of the excitation, in rad/s if the models have units: a model has
	               * the scaled frequency omega times its unit of time */
	/* *rom becomes the model at the value p of the parameter. It stays as it is at least until the
	 * function has been called for six other values. */
	enum hawser_status (*model)(void *context, const struct hawser_rom **rom, double p,
	                            struct hawser_report *report);
	void *context;
};

/* Models over two parameters, at one frequency. */
struct hawser_rom_plane {
	double omega; /* as in hawser_rom_family */
	/* *rom becomes the model at the values p. It stays as it is at least until the function has been
	 * called for eight other pairs of values; the first model stays as long as the plane. */
	enum hawser_status (*model)(void *context, const struct hawser_rom **rom, const double p[2],
	                            struct hawser_report *report);
	void *context;
	void (*close)(void *context); /* of hawser_plane_close; NULL: nothing to release */
};
/* Release a plane of any of the functions below and of hawser/scene_family.h. */
void hawser_plane_close(struct hawser_rom_plane *plane);

/* The factors by which a model may be multiplied. */
enum hawser_factor {
	HAWSER_FACTOR_LOAD = 0, /* all harmonics, each to its load_power */
	HAWSER_FACTOR_DAMPING   /* D */
};
const char *hawser_factor_name(enum hawser_factor factor); /* "load", "damping" */

/* The family of the models that are `rom` but for one factor, which is the parameter; `rom` is used as
 * long as the family is. Release with hawser_factor_close. HAWSER_ERR_MEMORY. */
enum hawser_status hawser_factor_open(struct hawser_rom_family *family, const struct hawser_rom *rom,
                                      enum hawser_factor factor, double omega,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_factor_close(struct hawser_rom_family *family);

/* The models of a family, each multiplied by a factor: place 0 or 1 of the parameters is the factor,
 * the other is that of `family`, which is used as long as the plane is. HAWSER_ERR_MEMORY. */
enum hawser_status hawser_plane_open(struct hawser_rom_plane *plane,
                                     const struct hawser_rom_family *family,
                                     enum hawser_factor factor, int place,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* The family of the models of a file over its parameter `name`, which is used, as is the text of
 * `source`, as long as the family is. Release with hawser_parameter_close. HAWSER_ERR_ARGUMENT (no such
 * parameter), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_parameter_open(struct hawser_rom_family *family,
                                         const struct hawser_rom_source *source, const char *name,
                                         double omega, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_parameter_close(struct hawser_rom_family *family);
/* The same over two parameters. */
enum hawser_status hawser_parameter_plane_open(struct hawser_rom_plane *plane,
                                               const struct hawser_rom_source *source,
                                               const char *const name[2], double omega,
                                               struct hawser_report *report) HAWSER_MUST_CHECK;

/* Export the equilibria and limit cycles of a family that nothing excites to AUTO-07p: the files
 * of hawser_rom_export_auto follow the equilibria from `begin` over `from` to `to` of the options,
 * then the limit cycles from their Hopf points. PAR(1) is the parameter, `name` in its outputs;
 * coefficients are interpolated in it to round-off. u [n]: near the first equilibrium, or NULL.
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_CONVERGENCE (no equilibrium; coefficients that are not smooth in
 * the range), HAWSER_ERR_IO, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_family_export_auto(const struct hawser_rom_family *family, const char *name,
                                             double begin, const double *u, const char *stem,
                                             const struct hawser_auto_options *options,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif

#endif
