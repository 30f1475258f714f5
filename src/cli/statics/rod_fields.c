/* cli/statics/rod_fields.c - columns and keys of the statics of a rod.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/statics/statics_kinds.h"

/* the end of a field's row */
#define NEWTON .unit = HAWSER__NEWTON       /* a force */
#define MOMENT .unit = HAWSER__NEWTON_METRE /* a moment */
#define METRE .unit = HAWSER__METRE         /* a length */

#define OF(member) HAWSER__AT(struct hawser_rod_point, member)
static const struct hawser__field point_field[] = {
	{"s", "s", "unstretched length from the start", OF(s), METRE},
	{"x", "x", "place", OF(x[0]), METRE},
	{"y", "y", "height", OF(x[1]), METRE},
	{"z", "z", "place", OF(x[2]), METRE},
	{"T", "T", "tension, the force along e1", OF(N[0]), NEWTON},
	{"Q2", "Q2", "shear force along e2", OF(N[1]), NEWTON},
	{"Q3", "Q3", "shear force along e3", OF(N[2]), NEWTON},
	{"M1", "M1", "torque, about e1", OF(M[0]), MOMENT},
	{"M2", "M2", "bending moment about e2", OF(M[1]), MOMENT},
	{"M3", "M3", "bending moment about e3", OF(M[2]), MOMENT},
	{"k1", "k1", "twist per length, with that at rest", OF(k[0]), .unit = HAWSER__PER_M},
	{"k2", "k2", "curvature about e2, with that at rest", OF(k[1]), .unit = HAWSER__PER_M},
	{"k3", "k3", "curvature about e3, with that at rest", OF(k[2]), .unit = HAWSER__PER_M},
	{"qw", "qw", "quaternion of the turn from the axes x, y, z to e1, e2, e3", OF(q[0])},
	{"qx", "qx", "its component along x", OF(q[1])},
	{"qy", "qy", "its component along y", OF(q[2])},
	{"qz", "qz", "its component along z", OF(q[3])},
	HAWSER__END,
};
#undef OF

const struct hawser__list cli_rod_point_list = HAWSER__STORED_ROWS(
	struct cli_rod, st.point, st.points, point_field);

#define OF(member) HAWSER__AT(struct hawser_rod_statics, member)
static const struct hawser__field start_field[] = {
	{"force", NULL, "force of the support on the rod, [x, y, z]", OF(force[0]), NEWTON},
	{"moment", NULL, "moment of the support on the rod, [x, y, z]", OF(moment[0]), MOMENT},
	HAWSER__END,
};
static const struct hawser__field end_field[] = {
	{"force", NULL, "force of the support on the rod, [x, y, z]", OF(force[1]), NEWTON},
	{"moment", NULL, "moment of the support on the rod, [x, y, z]", OF(moment[1]), MOMENT},
	HAWSER__END,
};
const struct hawser__field cli_rod_number_field[] = {
	{"T_min", NULL, "least tension", OF(T_min), NEWTON},
	{"T_max", NULL, "largest tension", OF(T_max), NEWTON},
	{"M_max", NULL, "largest moment", OF(M_max), MOMENT},
	{"M_max_s", NULL, "where it is", OF(M_max_s), METRE},
	{"strain", NULL, "largest part of its length by which an element is stretched, shortened or "
	 "sheared", OF(strain)},
	{"energy", NULL, "energy of strain", OF(energy), .unit = HAWSER__J},
	{"wet", NULL, "in water: unstretched length in it", OF(wet), METRE, .when = CLI_ROD_WATER},
	{"residual", NULL, "largest force that is not balanced", OF(residual), NEWTON},
	{"increment", NULL, "last increment of the iteration, in lengths of the rod and rad",
	 OF(increment)},
	HAWSER__END,
};
static const struct hawser__field count_field[] = {
	{"elements", NULL, "number of elements", OF(elements)},
	{"steps", NULL, "load steps, or steps of the damped motion", OF(steps)},
	{"iterations", NULL, "iterations of all steps", OF(iterations)},
	{"flow", NULL, "whether a damped motion has led to the equilibrium",
	 HAWSER__FLAG_AT(struct hawser_rod_statics, flow)},
	{"other", NULL, "how far a point is in another equilibrium, to which the whole load at once "
	 "leads; 0: none is known", OF(other), METRE},
	{"jump", NULL, "part of the load up to which it can be raised from none without a jump to this "
	 "equilibrium; 0: the whole load", OF(jump)},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct cli_rod, member), .flags = HAWSER__NULL
static const struct hawser__field error_field[] = {
	{"position", NULL, "largest error of a place; null: not known", OF(error_x), METRE},
	{"force", NULL, "largest error of a force in a section", OF(error_N), NEWTON},
	{"moment", NULL, "largest error of a moment in a section", OF(error_M), MOMENT},
	HAWSER__END,
};
#undef OF

#define PART(fields) HAWSER__PART_OF(struct cli_rod, st, fields)
const struct hawser__field cli_rod_field[] = {
	{"start", NULL, "the start of the rod", PART(start_field)},
	{"end", NULL, "the end of the rod", PART(end_field)},
	{"", NULL, "", PART(cli_rod_number_field)},
	{"", NULL, "", PART(count_field)},
	{"stable", NULL, "whether the equilibrium is stable; null: loads without a potential, such as "
	 "moments and a current", HAWSER__FLAG_AT(struct cli_rod, stable), .flags = HAWSER__NULL},
	{"mesh_error", NULL, "estimated from twice as many elements", HAWSER__OBJECT_OF(error_field)},
	{"profile_columns", NULL, "columns of the profile", HAWSER__KEYS_OF(cli_rod_point_list)},
	{"profile", NULL, "nodes of the mesh: lists of these columns",
	 HAWSER__ROWS_OF(cli_rod_point_list)},
	HAWSER__END,
};
#undef PART

const struct cli_listing cli_rod_listing[] = {
	{"Columns of a rod:", point_field, 0},
	{"Keys of JSON of a rod:", cli_rod_field, 1},
	{NULL, NULL, 0},
};
