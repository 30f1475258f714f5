/* rom/condense/load_fields.h - the static response of the condensed modes to the load, as fields
 * of the energy: see load_fields.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_LOAD_FIELDS_H
#define HAWSER_ROM_LOAD_FIELDS_H

#include <hawser/rom.h>

#include "rom/condense/fields.h"

/* Field i has the factor cos(k tau), or sin(k tau) if sine[i]. */
struct hawser__load_fields {
	int count;
	double *strain; /* [count][points of the grid][3] a, b, c */
	enum hawser_plane plane[HAWSER__LOAD_FIELDS];
	int k[HAWSER__LOAD_FIELDS], sine[HAWSER__LOAD_FIELDS];
};

/* Variation of the stiffness of the first `moving` modes by the static response of the others to the
 * load and to the changes of the speed: added to the harmonics and the ramp of a model, which must
 * exist. The responses to the load that matter as fields, K-orthogonal to these modes, are in *fields,
 * zero on entry. Clear it, on failure too. HAWSER_ERR_SCENE: a load that is not on the cable. */
enum hawser_status hawser__rom_vary(struct hawser_rom *rom, struct hawser__load_fields *fields,
                                    const struct hawser_modes *modes, int moving,
                                    const struct hawser_scene *scene,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__load_fields_clear(struct hawser__load_fields *fields);

#endif
