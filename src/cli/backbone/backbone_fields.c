/* cli/backbone/backbone_fields.c - the fields of a backbone beside a frequency response.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/backbone/backbone.h"

HAWSER__LABELS(backbone_end, cli_backbone_end, enum hawser_backbone_end)

#define OF(member) HAWSER__AT(struct hawser_backbone_point, member)
const struct hawser__field cli_backbone_free_field[] = {
	{"Omega", "Omega", "frequency of the free motion", OF(omega), .unit = HAWSER__RAD_S,
	 .axis = "Frequency {/:Italic Ω}"},
	{"energy", "energy", "its energy", OF(energy), .unit = HAWSER__J, .axis = "Energy"},
	{NULL, "stable", "whether it is stable",
	 HAWSER__NOT_AT(struct hawser_backbone_point, unstable)},
	{"unstable", "unstable", "multipliers outside the unit circle", OF(unstable)},
	CLI_AMPLITUDE(HAWSER__VECTOR_ALONG, struct cli_backbone, run.probe),
	CLI_COORDINATES(HAWSER__VECTOR_ALONG, struct cli_backbone, run.coordinate),
	{"residual", "residual", "defect of the orbit, relative", OF(residual)},
	{"mesh", "mesh", "truncation error of the orbit, relative", OF(mesh)},
	{"truncation", NULL, "the same as mesh", OF(mesh)},
	{"energy_gap", NULL, "largest change of the energy over half a period, relative",
	 OF(energy_gap)},
	{NULL, "backbone", "mode", HAWSER__IN(struct cli_backbone, mode), .flags = HAWSER__FROM_1},
	HAWSER__END,
};
#undef OF
const struct hawser__list cli_backbone_free_list =
	HAWSER__STORED_ROWS(struct cli_backbone, run.point, run.points, cli_backbone_free_field);

const struct hawser__field cli_backbone_field[] = {
	{"mode", NULL, "from 1", HAWSER__AT(struct cli_backbone, mode), .flags = HAWSER__FROM_1},
	{"end", NULL, "why it ends", HAWSER__LABEL_AT(struct cli_backbone, run.end, backbone_end)},
	{"multiple_scales", NULL, "change of Omega over a^2, by multiple scales",
	 HAWSER__AT(struct cli_backbone, gamma), .unit = HAWSER__RAD_S_M2,
	 .flags = HAWSER__OMIT | HAWSER__INFINITE},
	{"points", NULL, "free motions", HAWSER__OBJECTS_OF(cli_backbone_free_list)},
	HAWSER__END,
};
