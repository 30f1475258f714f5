/* cli/statics/statics_fields.c - the quantities of a static solution, for hawser statics.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/statics/statics_kinds.h"

#define OF(member) HAWSER__AT(struct hawser_statics, member)
/* Quantities in JSON and in the comments. */
const struct hawser__field cli_statics_field[] = {
	{"H", NULL, "tension across the static force (horizontal)", OF(H), .unit = HAWSER__NEWTON},
	{"T0", NULL, "tension at end A", OF(T0), .unit = HAWSER__NEWTON},
	{"T1", NULL, "tension at end B", OF(T1), .unit = HAWSER__NEWTON},
	{"V0", NULL, "component against the static force at end A", OF(V0), .unit = HAWSER__NEWTON},
	{"V1", NULL, "the same at end B", OF(V1), .unit = HAWSER__NEWTON},
	{"length0", NULL, "unstretched length", OF(length0), .unit = HAWSER__METRE},
	{"length", NULL, "stretched length", OF(length), .unit = HAWSER__METRE},
	{"sag", NULL, "largest distance from the chord along the static force", OF(sag),
	 .unit = HAWSER__METRE},
	{"eta", NULL, "V0/H", OF(eta)},
	{"epsilon", NULL, "H/EA", OF(epsilon)},
	{"delta", NULL, "rho g d/H", OF(delta)},
	/* infinite for an inextensible cable; JSON has no infinity */
	{"irvine", NULL, "Irvine's parameter lambda", OF(irvine),
	 .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"irvine_source", NULL, "the same for steep cables", OF(irvine_source),
	 .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"closure", NULL, "distance of the profile from end B", OF(closure), .unit = HAWSER__METRE},
	{"error", NULL, "estimated relative error by round-off", OF(error)},
	HAWSER__END,
};
#undef OF
