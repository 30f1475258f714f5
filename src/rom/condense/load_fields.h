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

/* Those that matter, K-orthogonal to the first `moving` modes. Clear *fields, on failure too.
 * HAWSER_ERR_SCENE: a load that is not on the cable. */
enum hawser_status hawser__load_fields_make(struct hawser__load_fields *fields,
                                            const struct hawser_modes *modes, int moving,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__load_fields_clear(struct hawser__load_fields *fields);

#endif
