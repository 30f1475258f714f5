/* rom/build/linear.c - the model for a linear problem: K, D and the harmonics, without tensors.
 *
 * The condensed modes respond to the load and to the changes of speed as in the complete model.
 * Second-order shapes (inertia.h), which that model may have as coordinates, represent condensed
 * modes and are omitted here; hawser_linear_multipliers condenses them in complete models too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include "rom/build/build.h"
#include "rom/condense/load_fields.h"
#include "rom/condense/support.h"
#include "rom/terms/travel.h"

void hawser__rom_held(double *K, const struct hawser_rom *rom, const double *f, double factor)
{
	int n = rom->n, modes = n - rom->inertia.shapes;

	for (int i = 0; modes < n && i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];
		int s = q->l;

		if (q->j < modes && q->k < modes && s >= modes && rom->K[s*n + s] != 0.0)
			K[q->j*n + q->k] += factor*q->value*f[s]/rom->K[s*n + s];
	}
}

/* `energy`: with the stiffness that the motion of supports and what follows the load add. */
static enum hawser_status build(struct hawser_rom *rom, const struct hawser_modes *modes,
                                const struct hawser_scene *scene, int energy,
                                struct hawser_report *report)
{
	int condensed = scene && scene->model.condense == HAWSER_CONDENSE_STATIC;
	struct hawser__load_fields loads = {.count = 0};
	enum hawser_status status = hawser__rom_begin(rom, modes, scene, report);

	if (status)
		return status;
	status = hawser__rom_finish(rom, modes, scene, report);
	if (!status && condensed)
		status = hawser__rom_vary(rom, &loads, modes, modes->n, scene, report);
	if (!status && hawser__support_moves(scene))
		status = hawser__support_forces(rom, modes, modes->n, condensed, scene, report);
	if (!status && energy)
		status = hawser__support_energy(rom, modes, modes, condensed ? &loads : NULL, scene, report);
	hawser__load_fields_clear(&loads);
	if (!status)
		status = hawser_rom_compile(rom, report);
	if (status)
		hawser_rom_clear(rom);
	return status;
}

static enum hawser_status build_with(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser_scene *scene, int energy,
                                     struct hawser_report *report)
{
	struct hawser_modes with;
	enum hawser_status status = hawser__rom_attached(&with, modes, scene, report);

	*rom = (struct hawser_rom){.n = 0};
	if (!status)
		status = build(rom, with.n > 0 ? &with : modes, scene, energy, report);
	hawser_modes_clear(&with);
	return status;
}

enum hawser_status hawser_rom_build_linear(struct hawser_rom *rom, const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report)
{
	struct hawser_modes carrying;
	double *turned;
	enum hawser_status status = hawser__travel_modes(&carrying, &turned, modes, scene, report);

	*rom = (struct hawser_rom){.n = 0};
	if (!status)
		status = build_with(rom, carrying.n > 0 ? &carrying : modes, scene, 1, report);
	if (!status)
		rom->carried = turned;
	else
		free(turned);
	hawser_modes_clear(&carrying);
	return status;
}

enum hawser_status hawser__rom_build_forces(struct hawser_rom *rom, const struct hawser_modes *modes,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report)
{
	return build_with(rom, modes, scene, 0, report);
}
