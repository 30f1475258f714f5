/* cli/statics_marks.c - the points of the profile and the attachments of a static solution, along the
 * axes of the scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "cli/statics_loaded.h"

struct hawser__place cli_place(const struct hawser_statics *st, const struct hawser_profile_point *in)
{
	const double at[3] = {in->x, in->y, 0.0}, along[3] = {1.0, in->slope, 0.0};
	double place[3], tangent[3];

	hawser_statics_to_global(st, place, at);
	hawser_statics_to_global(st, tangent, along);
	return (struct hawser__place){in->S, place[0], place[1], in->T, tangent[1]/tangent[0], place[2]};
}

static const char *mark_name(const void *of)
{
	return ((const struct cli_mark *)of)->name;
}

#define OF(member) HAWSER__AT(struct cli_mark, member)
const struct hawser__field cli_mark_field[] = {
	{"name", NULL, "its name, or empty", HAWSER__TEXT_BY(mark_name)},
	{"S", NULL, "unstretched arclength from end A", OF(before.S), .unit = HAWSER__METRE},
	{"x", NULL, "distance from end A", OF(before.x), .unit = HAWSER__METRE},
	{"y", NULL, "height above end A", OF(before.y), .unit = HAWSER__METRE},
	{"z", NULL, "distance from the vertical plane through the ends", OF(before.z),
	 .unit = HAWSER__METRE},
	{"mass", NULL, "point mass, kg", OF(mass)},
	{"T_before", NULL, "tension on the side of end A", OF(before.T), .unit = HAWSER__NEWTON},
	{"T_after", NULL, "tension on the side of end B", OF(after.T), .unit = HAWSER__NEWTON},
	{"slope_before", NULL, "dy/dx on the side of end A", OF(before.slope)},
	{"slope_after", NULL, "dy/dx on the side of end B", OF(after.slope)},
	HAWSER__END,
};
#undef OF

int cli_marks_fill(struct cli_mark *mark, const struct hawser_statics *st,
                   const struct hawser_scene *scene)
{
	for (int i = 0; i < st->attachments; i++) {
		const struct hawser_attached *a = &st->attached[i];
		struct hawser_profile_point at = hawser_statics_at(st, a->S);

		mark[i] = (struct cli_mark){.name = scene->attach[a->index].name, .mass = a->mass,
		                            .after = cli_place(st, &at)};
		at.slope -= st->delta*a->m;
		at.T = st->H*hypot(1.0, at.slope);
		mark[i].before = cli_place(st, &at);
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
