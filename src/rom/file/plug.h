/* rom/file/plug.h - a model whose forces are a function (hawser/plugin.h). See plug.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_PLUG_H
#define HAWSER_ROM_PLUG_H

#include <hawser/rom_source.h>

#include "rom/terms/morison.h"
#include "rom/terms/terms.h"

enum { HAWSER_PLUG_WAVES = 5 }; /* multiples of the frequency, from 0, whose forces at rest are known */

/* Equations u' = g become u'' = g_u u' + r (g - u') with the relaxation r, as those of files do
 * (read_own.c); the model `first` has u'' = g. */
#define HAWSER__RATES_ALONE (-1.0)

struct hawser_rom_plug {
	const struct hawser_plugin *of;
	double *parameter; /* [of->parameters] */
	double *K, *D;     /* [n][n] the linear part that the model has */
	double relaxation; /* of equations of first order; HAWSER__RATES_ALONE: see below */
	int still;         /* 1: the function does not depend on phase and frequency */
	double *wave;      /* [HAWSER_PLUG_WAVES][2][n] cos and sin of the forces that its harmonics have */
	struct hawser__rom_morison *water; /* in place of `of`: the force of the water on a net */
};

/* The model of `of` with the values of parameter [of->parameters]. HAWSER_ERR_ARGUMENT (a wrong
 * derivative), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__plug_make(struct hawser_rom *rom, const struct hawser_rom_source *source,
                                     struct hawser_report *report);
/* Give a model, not yet compiled, the force of `water`, which it takes over, on failure too. Its mean
 * damping and its harmonics at rest, at this frequency, become those of the model, and K stays.
 * HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__plug_join(struct hawser_rom *rom, struct hawser__rom_morison *water,
                                     double omega, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__plug_free(struct hawser_rom_plug *plug);

/* What the function has beyond the linear part and the harmonics of the model. */
void hawser__plug_add(const struct hawser_rom *rom, const struct hawser__more *to, const double *u,
                      const double *v, const double *tau, double omega);

#endif
