/* cli/statics/statics_loaded.c - what hawser statics shows of a span with a static load or a change of
 * temperature, besides the quantities of every span.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "core/vec3.h"

HAWSER__OF(state_word, const char *, struct cli_loaded,
	of->state == HAWSER_STATE_LOADED ? "loaded" : "reference")

#define OF(member) HAWSER__AT(struct hawser_statics, member)
static const struct hawser__field reference_field[] = {
	{"H", NULL, "horizontal tension", OF(H), .unit = HAWSER__NEWTON},
	{"T0", NULL, "tension at end A", OF(T0), .unit = HAWSER__NEWTON},
	{"T1", NULL, "tension at end B", OF(T1), .unit = HAWSER__NEWTON},
	{"length0", NULL, "unstretched length", OF(length0), .unit = HAWSER__METRE},
	{"sag", NULL, "largest vertical distance from the chord", OF(sag), .unit = HAWSER__METRE},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct cli_loaded, member)
const struct hawser__field cli_loaded_field[] = {
	{"swing_angle", NULL, "from the vertical plane to that of the cable, about the chord", OF(swing),
	 .unit = HAWSER__RADIAN},
	{"sag_vertical", NULL, "largest vertical distance from the chord", OF(sag_vertical),
	 .unit = HAWSER__METRE},
	{"blowout", NULL, "largest distance from the vertical plane through the ends", OF(blowout),
	 .unit = HAWSER__METRE},
	{"force", NULL, "weight and static load per unstretched length, N/m", OF(force)},
	{"pull_A", NULL, "force of the cable on support A along x, y, z", OF(pull[0]),
	 .unit = HAWSER__NEWTON},
	{"pull_B", NULL, "the same on support B", OF(pull[1]), .unit = HAWSER__NEWTON},
	{"moved_A", NULL, "displacement of end A on its springs along x, y, z", OF(moved[0]),
	 .unit = HAWSER__METRE},
	{"moved_B", NULL, "the same of end B", OF(moved[1]), .unit = HAWSER__METRE},
	{"imbalance", NULL, "largest force by which springs and cable differ", OF(imbalance),
	 .unit = HAWSER__NEWTON},
	{"tension_given", NULL, "state to which the given tension belongs", HAWSER__TEXT_BY(state_word)},
	{"reference", NULL, "without static load and change of temperature, at rest",
	 HAWSER__PART_OF(struct cli_loaded, reference, reference_field)},
	HAWSER__END,
};
#undef OF

void cli_moved_comment(struct hawser__table *table, const char *name, const struct cli_loaded *loaded)
{
	for (int k = 0; k < 2; k++)
		hawser__table_comment(table, "%s: moved_%c = %.10g, %.10g, %.10g m, along x, y, z", name,
		                      "AB"[k], loaded->moved[k][0], loaded->moved[k][1],
		                      loaded->moved[k][2]);
}

void cli_loaded_comments(struct hawser__table *table, const struct cli_loaded *loaded)
{
	const struct hawser__view view = cli_si_view(0);
	const struct hawser_statics *rest = &loaded->reference;

	hawser__fields_comments(table, cli_loaded_field, loaded, &view);
	for (int k = 0; k < 2; k++)
		hawser__table_comment(table, "pull_%c = %.10g, %.10g, %.10g N, of the cable on its support, "
		                      "along x, y, z", "AB"[k], loaded->pull[k][0], loaded->pull[k][1],
		                      loaded->pull[k][2]);
	if (loaded->elastic)
		cli_moved_comment(table, "ends on springs", loaded);
	hawser__table_comment(table, "the given tension is that of the %s state (tension.state)",
	                      state_word(loaded));
	hawser__table_comment(table, "reference state, without static load and change of temperature: "
	                      "H = %.10g N, T0 = %.10g N, T1 = %.10g N, sag = %.10g m, "
	                      "length0 = %.12g m", rest->H, rest->T0, rest->T1, rest->sag,
	                      rest->length0);
}

/* Force of the cable on a support: along the cable from end A, against it at end B. */
static void pull_of(double pull[3], const struct hawser_statics *st, double H, double V, double sign)
{
	const double in[3] = {sign*H, sign*V, 0.0};

	hawser_statics_to_global(st, pull, in);
}

/* The largest of n.x and -n.x over the profile, n along x, y, z. */
static double farthest(const struct hawser_statics *st, const double along[3])
{
	double n[3], most[2];

	hawser_statics_from_global(st, n, along);
	hawser_statics_farthest(&most[0], st, n);
	for (int c = 0; c < 3; c++)
		n[c] = 0.0 - n[c];
	hawser_statics_farthest(&most[1], st, n);
	return fmax(most[0], most[1]);
}

/* down: with the position it gives the vertical distance below the chord; aside: from the vertical
 * plane through the ends, positive towards z. */
static void directions(double down[3], double aside[3], const struct hawser_statics *st)
{
	const double in[3] = {st->span.d, st->span.h, 0.0};
	double chord[3], level;

	hawser_statics_to_global(st, chord, in);
	level = hypot(chord[0], chord[2]);
	for (int c = 0; c < 3; c++) {
		down[c] = c == 1 ? -1.0 : chord[c]/level*(chord[1]/level);
		aside[c] = c == 1 ? 0.0 : c == 2 ? chord[0]/level : -chord[2]/level;
	}
}

/* The same quantities of a cable in space, which is at rest. */
static void fill_space(struct cli_loaded *loaded, const struct hawser_statics *st)
{
	const double ends[2] = {0.0, st->length0};
	double down[3], aside[3];

	directions(down, aside, st);
	loaded->sag_vertical = farthest(st, down);
	loaded->blowout = farthest(st, aside);
	for (int end = 0; end < 2; end++) {
		struct hawser_profile_point at = hawser_statics_at(st, ends[end]);

		for (int c = 0; c < 3; c++)
			loaded->pull[end][c] = (end ? -at.T : at.T)*at.tangent[c];
		hawser_statics_to_global(st, loaded->pull[end], loaded->pull[end]);
	}
}

enum hawser_status cli_loaded_fill(struct cli_loaded *loaded, const struct hawser_statics *st,
                                   const struct hawser_scene *scene, struct hawser_report *report)
{
	static const double along[3] = {0.0, 1.0, 0.0};
	const struct hawser_statics actual = hawser_statics_actual(st);
	struct hawser_held held[2];
	double up[3], down[3], aside[3];

	loaded->present = scene->static_load.present || scene->wind.present ||
	                  scene->temperature.present;
	loaded->state = scene->tension.state;
	loaded->elastic = hawser_statics_held(held, scene);
	loaded->imbalance = st->imbalance;
	memcpy(loaded->moved, st->moved, sizeof loaded->moved);
	hawser_statics_to_global(st, up, along);
	directions(down, aside, st);
	/* each point of the cable is at most `sag` from its point of the chord, against `up` */
	loaded->sag_vertical = st->sag*fabs(hawser__dot(up, down));
	loaded->blowout = st->sag*fabs(hawser__dot(up, aside));
	loaded->swing = st->turned || st->space ? st->swing : 0.0;
	for (int i = 0; i < 3; i++)
		loaded->force[i] = 0.0 - actual.span.rho*actual.span.g*up[i];
	if (st->space) {
		fill_space(loaded, st);
	} else {
		pull_of(loaded->pull[0], st, actual.H, actual.V0, 1.0);
		pull_of(loaded->pull[1], st, st->H*(actual.T1/st->T1), actual.V1, -1.0);
	}
	return loaded->present ? hawser_statics_reference(&loaded->reference, scene, report) : HAWSER_OK;
}
