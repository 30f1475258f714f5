/* cli/modes/campbell_result.c - comments and fields of a Campbell diagram.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/modes/modes_result.h"

double cli_campbell_in_unit(const struct cli_campbell_result *result, double omega)
{
	return result->hertz ? omega/(2.0*M_PI) : omega;
}

void cli_campbell_free(struct cli_campbell_result *result)
{
	hawser_campbell_clear(&result->campbell);
	hawser_scene_clear(&result->scene);
	free(result->resonance);
}

static const char *plane_word(enum hawser_plane plane)
{
	return plane == HAWSER_IN_PLANE ? "in" : "out";
}

/* --- the table --- */

static void crossover_comments(struct hawser__table *table, const struct hawser_campbell *campbell)
{
	int k;

	for (k = 0; k < campbell->crossovers; k++) {
		const struct hawser_campbell_crossover *at = &campbell->crossover[k];

		hawser__table_comment(table, "%s: in-plane branches %d and %d, speed = %.10g m/s, omega = "
		                             "%.10g rad/s, gap = %.3g rad/s (relative %.3g)",
		                      hawser_crossover_name(at->kind), at->below, at->above, at->speed,
		                      at->omega, at->gap, at->relative_gap);
	}
}

static void resonance_comments(struct hawser__table *table, const struct cli_campbell_result *result)
{
	int k;

	if (result->harmonics > 0)
		hawser__table_comment(table, "excitation: n*2*pi*v/%.10g m, n up to %d; meetings with the "
		                             "branches are interpolated", result->spacing,
		                      result->harmonics);
	for (k = 0; k < result->resonances; k++) {
		const struct hawser_campbell_resonance *at = &result->resonance[k];

		hawser__table_comment(table, "resonance: harmonic %d with %s %d at %.8g m/s, omega = %.8g "
		                             "rad/s", at->harmonic,
		                      plane_word(result->campbell.branch[at->branch].plane),
		                      result->campbell.branch[at->branch].number, at->speed, at->omega);
	}
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_campbell_result *result = of;
	const struct hawser_campbell *campbell = &result->campbell;
	int inserted = 0, k;

	for (k = 0; k < campbell->stations; k++)
		inserted += campbell->station[k].inserted;
	hawser__table_comment(table, "sweep: speed from %.12g to %.12g m/s with the %s held, %d stations "
	                             "(%d inserted), %d modal solutions", campbell->station[0].speed,
	                      campbell->station[campbell->stations - 1].speed,
	                      result->scene.travel.hold == HAWSER_HOLD_LENGTH ? "length" : "tension",
	                      campbell->stations, inserted, campbell->solves);
	hawser__table_comment(table, "travel.speed of the scene is not used; travel.fluctuation = %.10g "
	                             "m/s is, by its mean square", result->scene.travel.fluctuation);
	if (result->scene.damping.kind != HAWSER_DAMPING_NONE)
		hawser__table_comment(table, "the scene's damping is left out: eigenvalues of the undamped "
		                             "cable");
	hawser__table_comment(table, "limit = %.12g m/s, end of the steady state%s", campbell->limit,
	                      campbell->criticals ? ""
	                      : ", by longitudinal waves: with the length or H held transverse waves set "
	                        "no limit, with T0 or T1 held (a counterweight) they do");
	for (k = 0; k < campbell->criticals; k++)
		hawser__table_comment(table, "critical: %s at %.12g m/s, %s",
		                      hawser_critical_name(campbell->critical[k].kind),
		                      campbell->critical[k].speed,
		                      hawser_plane_name(campbell->critical[k].plane));
	hawser__table_comment(table, "branches: %d in plane, %d out of plane, numbered at the beginning; "
	                             "least squared correlation %.4f; %d stations where they could not "
	                             "be told apart", campbell->in_plane,
	                      campbell->branches - campbell->in_plane, campbell->least_correlation,
	                      campbell->unsure);
	crossover_comments(table, campbell);
	resonance_comments(table, result);
}

/* --- fields --- */

HAWSER__LABELS(critical_name, hawser_critical_name, enum hawser_critical_kind)
HAWSER__LABELS(crossover_name, hawser_crossover_name, enum hawser_crossover_kind)
HAWSER__LABELS(plane_name, hawser_plane_name, enum hawser_plane)
HAWSER__LABELS(family_name, hawser_family_name, enum hawser_family)
HAWSER__LABELS(side_name, plane_word, enum hawser_plane)

enum { IN_RAD_S = 1, IN_HERTZ = 2, SPACED = 4 };

/* Eigenvalues: branches at stations. */
#define OF(member) HAWSER__ALONG(struct hawser_campbell, member)
#define STATION(member) HAWSER__OUTER(struct hawser_campbell, station, \
                                      struct hawser_campbell_station, member)
#define BRANCH(member) HAWSER__INNER(struct hawser_campbell, branch, struct hawser_irvine_branch, \
                                     member)
#define PLANE(function) HAWSER__INNER_LABEL(struct hawser_campbell, branch, \
                                            struct hawser_irvine_branch, plane, function)
#define RE "Real part"
#define IM "Imaginary part"
static const struct hawser__field cell_field[] = {
	{NULL, "speed", "travel speed", STATION(speed), .unit = HAWSER__METRE_S, .axis = "Speed"},
	{NULL, "plane", "in or out", PLANE(side_name)},
	{NULL, "branch", "number, from 1 at the first station", BRANCH(number)},
	{"re", NULL, "real part", OF(re), .unit = HAWSER__RADIAN_S},
	{"im", NULL, "imaginary part", OF(im), .unit = HAWSER__RADIAN_S},
	{NULL, "re", "real part", OF(re), .unit = HAWSER__RADIAN_S, .when = IN_RAD_S, .axis = RE},
	{NULL, "im", "imaginary part", OF(im), .unit = HAWSER__RADIAN_S, .when = IN_RAD_S, .axis = IM},
	{NULL, "re", "real part, with --unit Hz", OF(re), .unit = HAWSER__HERTZ, .when = IN_HERTZ,
	 .axis = RE},
	{NULL, "im", "imaginary part, with --unit Hz", OF(im), .unit = HAWSER__HERTZ, .when = IN_HERTZ,
	 .axis = IM},
	{"plane", NULL, "in-plane or out-of-plane", PLANE(plane_name)},
	{"branch", NULL, "number, from 1 at the first station", BRANCH(number)},
	{"place", "place", "by frequency in its plane, from 1", OF(place), .flags = HAWSER__FROM_1},
	{"family", "family", "transverse or longitudinal",
	 HAWSER__LABEL_ALONG(struct hawser_campbell, family, family_name)},
	{"downstream", "downstream", "share of downstream waves in the kinetic energy", OF(downstream)},
	{"residual", "residual", "error estimate, relative", OF(residual)},
	{NULL, "inserted", "1: added by the refinement", STATION(inserted)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list
	cell_list = HAWSER__MATRIX_ROWS(struct hawser_campbell, stations, branches, cell_field),
	station_cells = HAWSER__MATRIX_PART(struct hawser_campbell, branches, cell_field);

struct station {
	double speed, nu, T0, H, sag;
	int inserted, unsure;
};
#define OF(member) HAWSER__AT(struct station, member)
static const struct hawser__field station_field[] = {
	{"speed", NULL, "travel speed", OF(speed), .unit = HAWSER__METRE_S},
	{"nu", NULL, "travel speed over that of transverse waves on the apparent cable", OF(nu)},
	{"T0", NULL, "tension at end A", OF(T0), .unit = HAWSER__NEWTON},
	{"apparent_H", NULL, "horizontal tension of the apparent cable", OF(H), .unit = HAWSER__NEWTON},
	{"sag", NULL, "largest vertical distance from the chord", OF(sag), .unit = HAWSER__METRE},
	{"inserted", NULL, "whether the refinement added it",
	 HAWSER__FLAG_AT(struct station, inserted)},
	{"unsure", NULL, "whether branches could not be distinguished before it",
	 HAWSER__FLAG_AT(struct station, unsure)},
	{"eigenvalues", NULL, "of each branch", HAWSER__OBJECTS_OF(station_cells)},
	HAWSER__END,
};
#undef OF

static const void *station_row(void *to, const void *parent, size_t i)
{
	const struct hawser_campbell_station *at = &((const struct hawser_campbell *)parent)->station[i];
	struct hawser_statics actual = hawser_statics_actual(&at->statics);

	*(struct station *)to = (struct station){
		.speed = at->speed, .nu = at->statics.motion.nu, .T0 = actual.T0, .H = at->statics.H,
		.sag = at->statics.sag, .inserted = at->inserted, .unsure = at->unsure};
	return to;
}
static const struct hawser__list stations_list = HAWSER__MADE_ROWS(
	struct station, station_field, struct hawser_campbell, stations, station_row);

#define OF(member) HAWSER__AT(struct hawser_critical, member)
static const struct hawser__field critical_field[] = {
	{"speed", NULL, "where it is", OF(speed), .unit = HAWSER__METRE_S},
	{"kind", NULL, "divergence, flutter or no-steady-state",
	 HAWSER__LABEL_AT(struct hawser_critical, kind, critical_name)},
	{"plane", NULL, "of the motion", HAWSER__LABEL_AT(struct hawser_critical, plane, plane_name)},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct hawser_campbell_crossover, member)
static const struct hawser__field crossover_field[] = {
	{"kind", NULL, "veering or crossing",
	 HAWSER__LABEL_AT(struct hawser_campbell_crossover, kind, crossover_name)},
	{"plane", NULL, "in-plane", HAWSER__WORD_OF(HAWSER_IN_PLANE, plane_name)},
	{"numbers", NULL, "of the two branches",
	 HAWSER__INTEGER_PAIR_AT(struct hawser_campbell_crossover, below, above)},
	{"speed", NULL, "where it is", OF(speed), .unit = HAWSER__METRE_S},
	{"omega", NULL, "mean of the two frequencies", OF(omega), .unit = HAWSER__RADIAN_S},
	{"gap", NULL, "between them", OF(gap), .unit = HAWSER__RADIAN_S},
	{"relative_gap", NULL, "gap over omega", OF(relative_gap)},
	HAWSER__END,
};
#undef OF

static const struct hawser__field campbell_field[] = {
	{"method", NULL, "for modes", HAWSER__AT(struct hawser_campbell, method)},
	{"least_correlation", NULL, "least squared correlation of a branch's shapes at neighbours",
	 HAWSER__AT(struct hawser_campbell, least_correlation)},
	{"unsure", NULL, "stations before which branches could not be distinguished",
	 HAWSER__AT(struct hawser_campbell, unsure)},
	{"critical", NULL, "critical speeds within the range",
	 HAWSER__STORED(struct hawser_campbell, critical, criticals, critical_field)},
	{"limit", NULL, "end of the steady state", HAWSER__AT(struct hawser_campbell, limit),
	 .unit = HAWSER__METRE_S},
	{"crossovers", NULL, "where in-plane branches are closest",
	 HAWSER__STORED(struct hawser_campbell, crossover, crossovers, crossover_field)},
	HAWSER__END,
};

struct resonance {
	struct hawser_campbell_resonance at;
	struct hawser_irvine_branch branch;
};
#define OF(member) HAWSER__AT(struct resonance, member)
static const struct hawser__field resonance_field[] = {
	{"harmonic", NULL, "of the passing frequency", OF(at.harmonic)},
	{"plane", NULL, "of the branch", HAWSER__LABEL_AT(struct resonance, branch.plane, plane_name)},
	{"branch", NULL, "its number", OF(branch.number)},
	{"speed", NULL, "where it is", OF(at.speed), .unit = HAWSER__METRE_S},
	{"omega", NULL, "frequency there", OF(at.omega), .unit = HAWSER__RADIAN_S},
	HAWSER__END,
};
#undef OF

static const void *resonance_row(void *to, const void *parent, size_t k)
{
	const struct cli_campbell_result *result = parent;
	const struct hawser_campbell_resonance *at = &result->resonance[k];

	*(struct resonance *)to = (struct resonance){*at, result->campbell.branch[at->branch]};
	return to;
}
static const struct hawser__list resonance_list = HAWSER__MADE_ROWS(
	struct resonance, resonance_field, struct cli_campbell_result, resonances, resonance_row);

static const struct hawser__field speeds_field[] = {
	{"speeds", NULL, "stations of the sweep", HAWSER__OBJECTS_OF(stations_list)},
	HAWSER__END,
};
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__PART_OF(struct cli_campbell_result, campbell, campbell_field)},
	{"spacing", NULL, "of the excitation", HAWSER__AT(struct cli_campbell_result, spacing),
	 .unit = HAWSER__METRE, .when = SPACED},
	{"resonances", NULL, "crossings of its harmonics with branches",
	 HAWSER__OBJECTS_OF(resonance_list),
	 .when = SPACED},
	{"", NULL, "", HAWSER__PART_OF(struct cli_campbell_result, campbell, speeds_field)},
	HAWSER__END,
};
static const struct hawser__field cost_field[] = {
	{"solves", NULL, "modal solutions", HAWSER__AT(struct cli_campbell_result, campbell.solves)},
	{"basis", NULL, "most functions per component",
	 HAWSER__AT(struct cli_campbell_result, campbell.basis)},
	HAWSER__END,
};
const struct cli_listing cli_campbell_listing[] = {
	{"Columns of the table:", cell_field, 0},
	{"Columns of ropeways:", cli_track_field, 0},
	{"Keys of JSON:", result_field, 1},
	{"Keys of JSON of ropeways:", cli_track_member, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_campbell_result *result = of;

	return (struct cli_head){
		result->common, "campbell", result->campbell.method, &result->scene,
		cli_si_view((result->hertz ? IN_HERTZ : IN_RAD_S) | (result->harmonics ? SPACED : 0u)),
		&result->campbell, NULL, NULL};
}

struct hawser__axis cli_campbell_axis(const char *column,
                                      const struct cli_campbell_result *result)
{
	const struct hawser__view view = head(result).view;

	return hawser__fields_axis(cell_field, column, &view, 0.0);
}

const struct cli_showing cli_campbell_showing = {
	.head = head, .comments = comments, .rows = &cell_list, .fields = result_field,
	.stats = cost_field, .draw = cli_campbell_draw};
