/* rom/energy/full.c - the full-order model: the strain energy without expansion, with all functions
 * of a basis.
 *
 * Nothing is expanded in the displacement and nothing is condensed, so that the motion converges to
 * that of the cable as the basis is refined. Reduced models are compared with it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "rom/build/build.h"
#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"
#include "rom/condense/support.h"

/* Coordinates per function: two displacements in the plane, one out of it. With the default, orbits
 * near the first resonance have a relative error of 1e-6, also with a deep sag
 * (doc/theory-rom.md). With bending stiffness three elements or more, which resolve the layers at held
 * ends, share the functions. */
enum { COMPONENTS = 3, FUNCTIONS_DEFAULT = 16, FUNCTIONS_BENT = 24 };

/* A default basis that lacks more than this part of the static response to the load becomes the next
 * larger one; chosen. */
static const double lacking = 0.01;

static int all_finite(const struct hawser_rom_exact *exact)
{
	double sum = 0.0;

	for (size_t i = 0; i < (size_t)exact->points*2*exact->in; i++)
		sum += exact->slope[i];
	for (size_t i = 0; i < (size_t)exact->points*exact->out; i++)
		sum += exact->slope_z[i];
	return isfinite(sum);
}

/* `order`: quadrature points in each element of the grid, see exact.c. The force of a wind is exact
 * too: its terms would be too many. */
static enum hawser_status build(struct hawser_rom *rom, const struct hawser_modes *modes,
                                const struct hawser_scene *given, int order,
                                struct hawser_report *report)
{
	struct hawser_scene own = given ? *given : (struct hawser_scene){.g = 0.0};
	const struct hawser_scene *scene = given ? &own : NULL;
	enum hawser_status status;

	own.wind.form = HAWSER_WIND_EXACT;

	*rom = (struct hawser_rom){0};
	status = hawser__rom_begin(rom, modes, scene, report);
	if (status)
		return status;
	status = hawser__exact_new(&rom->exact, modes, order, report);
	if (!status && !all_finite(rom->exact))
		status = hawser__fail(report, HAWSER_ERR_NAN, "rom",
		                      "the slopes of the modes are not finite: solve the modes first");
	if (!status)
		status = hawser__rom_finish(rom, modes, scene, report);
	if (!status && scene && scene->wind.present && scene->wind.wake.present)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                      "wind.wake contradicts the exact strain energy: set "
		                      "model.energy=quartic");
	if (!status && hawser__support_moves(scene))
		status = hawser__support_forces(rom, modes, modes->n, 0, scene, report);
	if (!status && hawser__support_moves(scene))
		status = hawser__exact_support(rom->exact, modes, scene, report);
	if (!status)
		status = hawser_rom_compile(rom, report);
	if (status)
		hawser_rom_clear(rom);
	return status;
}

enum hawser_status hawser_rom_build_exact(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report)
{
	return build(rom, modes, scene, modes->grid.order, report);
}

/* Of the strains in each element: hawser_modes_basis. */
static int polynomials(const struct hawser_modes *modes)
{
	return (modes->basis + 1)/modes->grid.elements;
}

static enum hawser_status by_default(int *each, const struct hawser_statics *statics,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	static const int larger[] = {FUNCTIONS_DEFAULT, 18, 20, FUNCTIONS_BENT};
	double lacks = 1.0;
	enum hawser_status status = HAWSER_OK;

	*each = FUNCTIONS_BENT;
	if (statics->bending.EI > 0.0)
		return HAWSER_OK;
	for (size_t i = 0; !status && lacks > lacking && i < sizeof larger/sizeof *larger; i++) {
		*each = larger[i];
		status = hawser_rom_full_lacks(&lacks, statics, scene, *each, report);
	}
	return status;
}

enum hawser_status hawser_rom_build_full(struct hawser_rom *rom,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene, int functions,
                                         struct hawser_report *report)
{
	int each = functions;
	int most = HAWSER_ROM_MAX/COMPONENTS;
	struct hawser_modes modes;
	enum hawser_status status = functions ? HAWSER_OK : by_default(&each, statics, scene, report);

	*rom = (struct hawser_rom){0};
	if (status)
		return status;
	if (each < 1 || each > most)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a full-order model of %d functions a component: give 1 to %d, "
		                    "for at most %d coordinates (model.basis)", each, most,
		                    HAWSER_ROM_MAX);
	status = hawser_modes_basis(&modes, statics, each, each, report);
	if (!status)
		status = build(rom, &modes, scene, polynomials(&modes), report);
	hawser_modes_clear(&modes);
	return status;
}
