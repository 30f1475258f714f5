/* cli/statics/statics_marks.c - the points of the profile and the attachments of a static
 * solution, along the axes of the scene. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/statics/statics_kinds.h"

struct hawser__spot cli_place(const struct hawser_statics *st, const struct hawser_profile_point *in)
{
	const double at[3] = {in->x, in->y, in->z}, along[3] = {1.0, in->slope, 0.0};
	double place[3], tangent[3];

	hawser_statics_to_global(st, place, at);
	for (int c = 0; c < 3; c++)
		place[c] += st->moved[0][c];
	hawser_statics_to_global(st, tangent, st->space ? in->tangent : along);
	return (struct hawser__spot){in->S, place[0], place[1], in->T, tangent[1]/tangent[0], place[2]};
}

HAWSER__OF(mark_name, const char *, struct cli_mark, of->name)

#define OF(member) HAWSER__AT(struct cli_mark, member)
const struct hawser__field cli_mark_field[] = {
	{"name", NULL, "its name, or empty", HAWSER__TEXT_BY(mark_name)},
	{"S", NULL, "unstretched arclength from end A", OF(before.S), .unit = HAWSER__METRE},
	{"x", NULL, "distance from end A", OF(before.x), .unit = HAWSER__METRE},
	{"y", NULL, "height above end A", OF(before.y), .unit = HAWSER__METRE},
	{"z", NULL, "distance from the vertical plane through the places of the ends", OF(before.z),
	 .unit = HAWSER__METRE},
	{"mass", NULL, "point mass, kg", OF(mass)},
	{"T_before", NULL, "tension on the side of end A", OF(before.T), .unit = HAWSER__NEWTON},
	{"T_after", NULL, "tension on the side of end B", OF(after.T), .unit = HAWSER__NEWTON},
	{"slope_before", NULL, "dy/dx on the side of end A", OF(before.slope)},
	{"slope_after", NULL, "dy/dx on the side of end B", OF(after.slope)},
	{"kink", NULL, "angle between the tangents on both sides", OF(kink), .unit = HAWSER__RADIAN},
	HAWSER__END,
};
#undef OF

static double kink_of(const struct hawser_statics *st, const struct hawser_profile_point *a,
                      const struct hawser_profile_point *b)
{
	double cross[3], dot = 0.0;

	if (!st->space)
		return fabs(atan(b->slope) - atan(a->slope));
	for (int c = 0; c < 3; c++) {
		cross[c] = a->tangent[(c + 1)%3]*b->tangent[(c + 2)%3] -
		           a->tangent[(c + 2)%3]*b->tangent[(c + 1)%3];
		dot += a->tangent[c]*b->tangent[c];
	}
	return atan2(hypot(hypot(cross[0], cross[1]), cross[2]), dot);
}

int cli_marks_fill(struct cli_mark *mark, const struct hawser_statics *st,
                   const struct hawser_scene *scene)
{
	for (int i = 0; i < st->attachments; i++) {
		const struct hawser_attached *a = &st->attached[i];
		struct hawser_profile_point after = hawser_statics_at(st, a->S);
		struct hawser_profile_point before = hawser_statics_before(st, i);

		mark[i] = (struct cli_mark){.name = scene->attach[a->index].name, .mass = a->mass,
		                            .kink = kink_of(st, &before, &after),
		                            .after = cli_place(st, &after),
		                            .before = cli_place(st, &before)};
	}
	return st->attachments;
}

void cli_marks_comments(struct hawser__table *table, const struct cli_mark *mark, int marks)
{
	for (int i = 0; i < marks; i++, mark++)
		hawser__table_comment(table, "attachment %s%sat S = %.10g m: mass %.10g kg, x = %.10g m, "
		                      "y = %.10g m, T = %.10g and %.10g N on either side", mark->name,
		                      *mark->name ? " " : "", mark->before.S, mark->mass, mark->before.x,
		                      mark->before.y, mark->before.T, mark->after.T);
}
