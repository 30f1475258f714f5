/* rom/terms/damping.c - the damping of a scene as the matrix D of a model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "modes/label.h"
#include "rom/terms/absorbers.h"
#include "rom/build/build.h"
#include "rom/terms/dampers.h"

enum hawser_status hawser__rom_damping(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       const struct hawser_scene *scene,
                                       struct hawser_report *report)
{
	const double t = modes->time_unit, rho = modes->statics.span.rho;
	int ratio = scene->damping.kind == HAWSER_DAMPING_RATIO && modes->stroke;
	int rayleigh = scene->damping.kind == HAWSER_DAMPING_RAYLEIGH;
	double alpha = scene->damping.kind == HAWSER_DAMPING_ALPHA ? scene->damping.alpha*t/rho : 0.0;
	enum hawser_status status = ratio ? hawser__absorbers_ratio(rom->D, modes, scene, report)
	                                  : HAWSER_OK;

	for (int j = 0; !ratio && j < rom->n; j++) {
		double *d = &rom->D[j*rom->n + j];
		double omega = rom->carried ? sqrt(rom->K[j*rom->n + j]) : modes->mode[j].omega;

		switch (scene->damping.kind) {
		case HAWSER_DAMPING_NONE:
			break;
		case HAWSER_DAMPING_ALPHA: /* d/sqrt(rho H) = t/rho, with the actual mass */
			*d = scene->damping.alpha*t/rho*(1.0 - modes->statics.motion.mach2);
			break;
		case HAWSER_DAMPING_RAYLEIGH:
			*d = scene->damping.mass*t + scene->damping.stiffness/t*omega*omega;
			break;
		case HAWSER_DAMPING_RATIO:
			*d = 2.0*hawser__damping_ratio(scene, &modes->mode[j])*omega;
			break;
		}
	}
	if (modes->statics.attachments > 0 || modes->statics.elastic)
		hawser__dampers_add(rom->D, modes, alpha);
	if (modes->stroke)
		hawser__absorbers_damp(rom->D, modes, rayleigh ? scene->damping.mass*t : alpha,
		                       rayleigh ? scene->damping.stiffness/t : 0.0);
	return status;
}
