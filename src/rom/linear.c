/* rom/linear.c - the model of a linear question: K, D and the harmonics, no tensors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "rom/build.h"

enum hawser_status hawser_rom_build_linear(struct hawser_rom *rom, const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report)
{
	enum hawser_status status = hawser__rom_begin(rom, modes, scene, report);

	if (status)
		return status;
	status = hawser__rom_finish(rom, modes, scene, report);
	if (!status)
		status = hawser_rom_compile(rom, report);
	if (status)
		hawser_rom_clear(rom);
	return status;
}
