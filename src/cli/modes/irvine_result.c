/* cli/modes/irvine_result.c - comments and fields of a sweep of the tension.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/modes/modes_result.h"
#include "cli/frame/view.h"

const char *const cli_irvine_units[] = {"normalised", "rad/s", "Hz", "s"};
static const char *const suffix[] = {"_normalised", "_rad_s", "_Hz", "_s"};

const char *cli_irvine_si(enum hawser_given sweep)
{
	return sweep == HAWSER_GIVEN_LENGTH0 || sweep == HAWSER_GIVEN_SAG ? "m" : "N";
}

void cli_irvine_free(struct cli_irvine_result *result)
{
	int k;

	for (k = 0; k < result->sweeps; k++) {
		hawser_irvine_clear(&result->sweep[k].irvine);
		free(result->sweep[k].analytic);
	}
	hawser_scene_clear(&result->scene);
}

double cli_irvine_tension(const struct hawser_irvine_station *station)
{
	return hawser_irvine_value(&station->statics, HAWSER_GIVEN_H);
}

double cli_irvine_in_unit(const struct cli_irvine_result *result, double omega, double H)
{
	const struct hawser_span *span = &result->sweep[0].irvine.span;

	switch (result->unit) {
	case CLI_RAD_S: return omega;
	case CLI_HZ: return omega/(2.0*M_PI);
	case CLI_PERIOD: return 2.0*M_PI/omega;
	default: return omega/(M_PI*sqrt(H/span->rho)/span->d);
	}
}

/* --- comments --- */

static void crossover_comment(struct hawser__table *table, const struct hawser_irvine *irvine,
                              const struct hawser_irvine_crossover *at)
{
	char value[64] = "";

	if (irvine->sweep != HAWSER_GIVEN_H)
		snprintf(value, sizeof value, "%s = %.10g %s, ", hawser_given_name(irvine->sweep),
		         at->value, cli_irvine_si(irvine->sweep));
	hawser__table_comment(table, "%s: in-plane branches %d and %d, %sH = %.10g N, irvine = %.10g, "
	                             "irvine_source = %.10g, omega = %.10g rad/s, gap = %.3g rad/s "
	                             "(relative %.3g)", hawser_crossover_name(at->kind), at->below,
	                      at->above, value, at->H, at->irvine, at->irvine_source, at->omega,
	                      at->gap, at->relative_gap);
}

static double largest_error(const struct hawser_irvine *irvine)
{
	double largest = 0.0;

	for (int k = 0; k < irvine->stations*irvine->branches; k++)
		largest = fmax(largest, irvine->residual[k]);
	return largest;
}

static void sweep_comments(struct hawser__table *table, const struct cli_irvine_result *result,
                           const struct cli_irvine_sweep *sweep)
{
	const struct hawser_irvine *irvine = &sweep->irvine;
	int inserted = 0, k;

	for (k = 0; k < irvine->stations; k++)
		inserted += irvine->station[k].inserted;
	if (result->moving)
		hawser__table_comment(table, "speed = %.12g m/s, fluctuation = %.12g m/s: H, T0, T1 and "
		                             "length0 are those of the steady state, both irvine those of "
		                             "the apparent cable", irvine->speed, irvine->fluctuation);
	hawser__table_comment(table, "sweep: %s from %.12g to %.12g %s, %d stations (%d inserted), %d "
	                             "modal solutions", hawser_given_name(irvine->sweep),
	                      irvine->station[0].value, irvine->station[irvine->stations - 1].value,
	                      cli_irvine_si(irvine->sweep), irvine->stations, inserted,
	                      irvine->solves);
	hawser__table_comment(table, "branches: %d in plane, %d out of plane, numbered at the beginning; "
	                             "least squared correlation %.4f", irvine->in_plane,
	                      irvine->branches - irvine->in_plane, irvine->least_correlation);
	if (result->unit == CLI_NORMALISED && sweep == result->sweep)
		hawser__table_comment(table, "normalised: over pi*sqrt(H/rho)/d, the first frequency of a "
		                             "level string%s", result->moving ? " at rest" : "");
	if (result->common->plot && !sweep->overlays)
		hawser__table_comment(table, "no analytic curves in the picture: %s",
		                      cli_irvine_has_analytic(irvine)
		                          ? "they are the result itself"
		                          : "there is no method \"analytic\"");
	hawser__table_comment(table, "largest estimated relative error of a frequency: %.1e",
	                      largest_error(irvine));
	for (k = 0; k < irvine->crossovers; k++)
		crossover_comment(table, irvine, &irvine->crossover[k]);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_irvine_result *result = of;

	const struct hawser_irvine *irvine = &result->sweep[0].irvine;

	if (result->own.H > 0.0)
		hawser__table_comment(table, "the scene itself: %s = %.10g %s, irvine_source = %.10g",
		                      hawser_given_name(irvine->sweep),
		                      hawser_irvine_value(&result->own, irvine->sweep),
		                      cli_irvine_si(irvine->sweep), result->own.irvine_source);
	for (int k = 0; k < result->sweeps; k++)
		sweep_comments(table, result, &result->sweep[k]);
}

/* --- fields --- */

enum { MOVING = 1, OTHER = 2, ONE = 4, SEVERAL = 8 }; /* OTHER: the swept quantity is not H */

HAWSER__LABELS(crossover_name, hawser_crossover_name, enum hawser_crossover_kind)
HAWSER__LABELS(plane_name, hawser_plane_name, enum hawser_plane)
HAWSER__LABELS(symmetry_name, hawser_symmetry_name, enum hawser_symmetry)
HAWSER__LABELS(family_name, hawser_family_name, enum hawser_family)
HAWSER__LABELS(sweep_name, hawser_given_name, enum hawser_given)

/* Number of branches of a plane in the sweep that has most of them. */
static int most(const void *context, enum hawser_plane plane)
{
	const struct cli_irvine_result *result = context;
	int count = 0;

	for (int k = 0; k < result->sweeps; k++) {
		const struct hawser_irvine *irvine = &result->sweep[k].irvine;
		int here = plane == HAWSER_IN_PLANE ? irvine->in_plane
		                                    : irvine->branches - irvine->in_plane;

		count = here > count ? here : count;
	}
	return count;
}

static int most_in(const void *context)
{
	return most(context, HAWSER_IN_PLANE);
}

static int most_out(const void *context)
{
	return most(context, HAWSER_OUT_OF_PLANE);
}

static void branch_name(char *text, size_t size, const void *context, int k)
{
	const struct cli_irvine_result *result = context;

	snprintf(text, size, "%d%s", k + 1,
	         result->unit == CLI_NORMALISED ? suffix[result->unit] : "");
}

static enum hawser__unit branch_unit(const void *context, int k)
{
	static const enum hawser__unit unit[] = {
		[CLI_NORMALISED] = HAWSER__NONE, [CLI_RAD_S] = HAWSER__RADIAN_S, [CLI_HZ] = HAWSER__HZ,
		[CLI_PERIOD] = HAWSER__SECOND};

	(void)k;
	return unit[((const struct cli_irvine_result *)context)->unit];
}

HAWSER__OF(value_unit, const char *, struct cli_irvine_result,
	cli_irvine_si(of->sweep[0].irvine.sweep))

static void value_name(char *text, size_t size, const void *context)
{
	const struct cli_irvine_result *result = context;
	enum hawser_given sweep = result->sweep[0].irvine.sweep;

	snprintf(text, size, "%s_%s", hawser_given_name(sweep), cli_irvine_si(sweep));
}

/* Branch k of a plane in the unit of the table; NAN if the sweep has fewer branches. */
static double frequency(const void *context, const void *parent, size_t i, int first, int end)
{
	const struct hawser_irvine *irvine = &((const struct cli_irvine_sweep *)parent)->irvine;

	return first >= end ? NAN
	       : cli_irvine_in_unit(context, irvine->omega[i*(size_t)irvine->branches + (size_t)first],
	                            cli_irvine_tension(&irvine->station[i]));
}

static double in_frequency(const void *context, const void *parent, size_t i, int k)
{
	return frequency(context, parent, i, k, ((const struct cli_irvine_sweep *)parent)->irvine.in_plane);
}

static double out_frequency(const void *context, const void *parent, size_t i, int k)
{
	const struct hawser_irvine *irvine = &((const struct cli_irvine_sweep *)parent)->irvine;

	return frequency(context, parent, i, irvine->in_plane + k, irvine->branches);
}
static const struct hawser__vector
	in_plane = {.shown = "J_UNIT", .count = most_in, .name = branch_name, .number = in_frequency,
	            .unit = branch_unit},
	out_of_plane = {.shown = "J_UNIT", .count = most_out, .name = branch_name,
	                .number = out_frequency, .unit = branch_unit};

HAWSER__NUMBERS_BY(tension, cli_irvine_tension)
HAWSER__NUMBERS_BY(string, hawser_irvine_string)
#define OF(member) HAWSER__AT(struct hawser_irvine_station, member)
static const struct hawser__field station_field[] = {
	{NULL, "speed", "travel speed", HAWSER__IN(struct cli_irvine_sweep, irvine.speed),
	 .unit = HAWSER__METRE_S, .when = MOVING},
	{"value", "KEY", "swept quantity, N or m, such as H_N or sag_m", OF(value),
	 .named = value_name, .si = value_unit},
	{"H", NULL, "horizontal tension", HAWSER__BY(tension), .unit = HAWSER__NEWTON},
	{"irvine", "irvine", "lambda, Irvine's parameter, see hawser-statics(1)", OF(statics.irvine)},
	{"irvine_source", "irvine_source", "lambda by the source's definition, which pictures show",
	 OF(statics.irvine_source)},
	{NULL, "H", "horizontal tension, if another quantity is swept", HAWSER__BY(tension),
	 .unit = HAWSER__NEWTON, .when = OTHER},
	{"string", NULL, "pi sqrt(H/rho)/d, by which frequencies are normalised", HAWSER__BY(string),
	 .unit = HAWSER__RADIAN_S},
	{"inserted", "inserted", "whether the refinement added the station",
	 HAWSER__FLAG_AT(struct hawser_irvine_station, inserted)},
	{NULL, "in_", "frequency of an in-plane branch in the unit of --unit, such as in_1_normalised",
	 HAWSER__VECTOR_OF(in_plane), .flags = HAWSER__NULL},
	{NULL, "out_", "the same out of plane, such as out_1_normalised",
	 HAWSER__VECTOR_OF(out_of_plane), .flags = HAWSER__NULL},
	HAWSER__END,
};
#undef OF
static const struct hawser__list station_list = HAWSER__STORED_ROWS(
	struct cli_irvine_sweep, irvine.station, irvine.stations, station_field);

#define OF(member) HAWSER__ALONG(struct hawser_irvine, member)
static const struct hawser__field cell_field[] = {
	{"omega", NULL, "frequency at each station", OF(omega), .unit = HAWSER__RADIAN_S},
	{"residual", NULL, "its error estimate, relative; from 1 on the sweep fails", OF(residual)},
	{"symmetry", NULL, "of the shape; mixed if the cable travels",
	 HAWSER__LABEL_ALONG(struct hawser_irvine, symmetry, symmetry_name)},
	{"family", NULL, "transverse or longitudinal",
	 HAWSER__LABEL_ALONG(struct hawser_irvine, family, family_name)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list cell_list =
	HAWSER__MATRIX_COLUMN(struct hawser_irvine, stations, branches, cell_field);
static const struct hawser__field branch_field[] = {
	{"plane", NULL, "in-plane or out-of-plane",
	 HAWSER__LABEL_AT(struct hawser_irvine_branch, plane, plane_name)},
	{"number", NULL, "from 1 in its plane, by frequency at the first station",
	 HAWSER__AT(struct hawser_irvine_branch, number)},
	{"", NULL, "", HAWSER__ARRAYS_OF(cell_list)},
	HAWSER__END,
};

#define OF(member) HAWSER__AT(struct hawser_irvine_crossover, member)
static const struct hawser__field crossover_field[] = {
	{"kind", NULL, "crossing or veering",
	 HAWSER__LABEL_AT(struct hawser_irvine_crossover, kind, crossover_name)},
	{"plane", NULL, "in-plane", HAWSER__WORD_OF(HAWSER_IN_PLANE, plane_name)},
	{"numbers", NULL, "of the two branches; above those of branches they go on",
	 HAWSER__INTEGER_PAIR_AT(struct hawser_irvine_crossover, below, above)},
	{"value", NULL, "swept quantity, N or m", OF(value)},
	{"H", NULL, "horizontal tension", OF(H), .unit = HAWSER__NEWTON},
	{"irvine", NULL, "lambda there", OF(irvine)},
	{"irvine_source", NULL, "lambda by the source's definition", OF(irvine_source)},
	{"omega", NULL, "mean of the two frequencies", OF(omega), .unit = HAWSER__RADIAN_S},
	{"gap", NULL, "between them", OF(gap), .unit = HAWSER__RADIAN_S},
	{"relative_gap", NULL, "over omega", OF(relative_gap)},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct cli_irvine_sweep, irvine.member)
static const struct hawser__field branches_field[] = {
	{"branches", NULL, "of frequencies",
	 HAWSER__STORED(struct hawser_irvine, branch, branches, branch_field)},
	{"crossovers", NULL, "where two in-plane branches are closest",
	 HAWSER__STORED(struct hawser_irvine, crossover, crossovers, crossover_field)},
	HAWSER__END,
};
static const struct hawser__field sweep_field[] = {
	{"speed", NULL, "travel speed", OF(speed), .unit = HAWSER__METRE_S},
	{"least_correlation", NULL, "least squared correlation of an in-plane branch's shapes at "
	 "neighbouring stations without crossover", OF(least_correlation)},
	{"stations", NULL, "of the sweep", HAWSER__OBJECTS_OF(station_list)},
	{"", NULL, "", HAWSER__PART_OF(struct cli_irvine_sweep, irvine, branches_field)},
	HAWSER__END,
};
#undef OF

static const struct hawser__field irvine_field[] = {
	{"method", NULL, "for modes", HAWSER__AT(struct cli_irvine_result, sweep[0].irvine.method)},
	{"sweep", NULL, "swept quantity",
	 HAWSER__LABEL_AT(struct cli_irvine_result, sweep[0].irvine.sweep, sweep_name)},
	{"", NULL, "", HAWSER__PART_OF(struct cli_irvine_result, sweep[0], sweep_field), .when = ONE},
	{"diagrams", NULL, "with several speeds: a list of what follows method and sweep",
	 HAWSER__STORED_WITHIN(struct cli_irvine_result, sweep, sweeps, sweep_field), .when = SEVERAL,
	 .flags = HAWSER__BRIEF},
	HAWSER__END,
};
static double solves(const void *of)
{
	const struct cli_irvine_result *result = of;
	int sum = 0;

	for (int k = 0; k < result->sweeps; k++)
		sum += result->sweep[k].irvine.solves;
	return sum;
}
static const struct hawser__field cost_field[] = {
	{"solves", NULL, "modal solutions", HAWSER__COUNT_BY(solves)},
	HAWSER__END,
};
const struct cli_listing cli_irvine_listing[] = {
	{"Columns of the table:", station_field, 0},
	{"Columns of ropeways:", cli_track_field, 0},
	{"Keys of JSON:", irvine_field, 1},
	{"Keys of JSON of ropeways:", cli_track_member, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_irvine_result *result = of;
	enum hawser_given sweep = result->sweep[0].irvine.sweep;

	return (struct cli_head){
		result->common, "irvine", result->sweep[0].irvine.method, &result->scene,
		{.scale = hawser__si, .context = result,
		 .options = (result->moving ? MOVING : 0u) | (sweep != HAWSER_GIVEN_H ? OTHER : 0u) |
		            (result->sweeps == 1 ? ONE : SEVERAL)}, NULL, NULL, NULL};
}

static void rows(struct hawser__table *table, const void *of)
{
	const struct cli_irvine_result *result = of;
	struct cli_head shown = head(of);

	hawser__fields_columns(table, station_field, &shown.view);
	for (int k = 0; k < result->sweeps; k++)
		hawser__fields_rows(table, NULL, &station_list, &result->sweep[k], &shown.view);
}

const struct cli_showing cli_irvine_showing = {
	.head = head, .comments = comments, .more = rows, .fields = irvine_field, .stats = cost_field,
	.draw = cli_irvine_draw};
