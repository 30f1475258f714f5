/* cli/plan/plan_fields.c - the fields of a plan: fidelities, modes, resonances, decisions, settings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/plan/plan_result.h"
#include "cli/frame/view.h"

/* 1 if the load drives mode j. */
static int is_driven(const struct cli_plan_result *result, int j)
{
	double most = 0.0;

	for (int k = 0; k < result->plan.modes.n; k++)
		most = fmax(most, fabs(result->plan.load[k]));
	return most > 0.0 && fabs(result->plan.load[j]) > 1e-12*most;
}

/* --- fields --- */

HAWSER__LABELS(plane_name, hawser_plane_name, enum hawser_plane)
HAWSER__LABELS(symmetry_name, hawser_symmetry_name, enum hawser_symmetry)
HAWSER__LABELS(reason_name, hawser_reason_name, enum hawser_reason)

static const struct hawser__field family_field[] = {
	{"family", NULL, "the fidelity without its number", HAWSER__AT(struct hawser_fidelity, name)},
	HAWSER__END,
};
/* A row of the plan, with the meaning of its time. */
struct row {
	struct hawser_plan_row at;
	const char *name, *kind;
};
#define OF(member) HAWSER__AT(struct row, at.member)
#define MAYBE(member) OF(member), .flags = HAWSER__NULL | HAWSER__MISSING
static const struct hawser__field row_field[] = {
	{"name", "fidelity", "the fidelity", HAWSER__AT(struct row, name)},
	{"", NULL, "", HAWSER__THROUGH(struct row, at.choice.fidelity, family_field)},
	{"number", NULL, "its number, such as that of modes", OF(choice.number)},
	{"unknowns", "unknowns", "coordinates of the model", OF(n)},
	{"Q_entries", "Q_entries", "entries of the quadratic tensor", OF(quads)},
	{"C_entries", "C_entries", "entries of the cubic tensor", OF(cubics)},
	{"points", "points", "of the curve", MAYBE(points)},
	{"time_secs", "time_s", "processor time of model and response (s)", MAYBE(seconds)},
	{"least_time_secs", "least_time_s", "lower bound of the time (s)", MAYBE(least)},
	{"most_time_secs", "most_time_s", "upper bound of the time (s)", MAYBE(most)},
	{"time_by", "time_by", "source of points and time: estimate", HAWSER__AT(struct row, kind)},
	{"time_is", "time_is", "estimate", HAWSER__AT(struct row, kind)},
	{"fails", NULL, "whether the response ends with an error",
	 HAWSER__FLAG_AT(struct row, at.status)},
	{"foreseen", NULL, "why it fails, or what else its user should know", OF(foreseen)},
	{"Omega_error", "Omega_error", "estimated error of folds and peaks, relative; "
	 "missing: a mode is left out",
	 MAYBE(omega_error)},
	{"worst_mode", "worst_mode", "mode whose resonance has the largest Omega_error", OF(worst),
	 .flags = HAWSER__NULL | HAWSER__FROM_1},
	{"why", NULL, "what the estimate of the error rests on", OF(why)},
	HAWSER__END,
};
#undef MAYBE
#undef OF
static const void *fidelity_row(void *to, const void *parent, size_t i)
{
	const struct hawser_plan_row *at = &((const struct hawser_plan *)parent)->row[i];

	*(struct row *)to = (struct row){*at, at->choice.name, at->estimated ? "estimate" : ""};
	return to;
}
static const struct hawser__list row_list = HAWSER__MADE_ROWS(
	struct row, row_field, struct hawser_plan, rows, fidelity_row);

#define OF(member) HAWSER__AT(struct hawser_plan_decision, member)
static const struct hawser__field decision_field[] = {
	{"subject", NULL, "what may be modelled", OF(subject)},
	{"modelled", NULL, "whether it is", HAWSER__FLAG_AT(struct hawser_plan_decision, modelled)},
	{"why", NULL, "why", OF(why)},
	HAWSER__END,
};
#undef OF

enum { CHOSEN = 1 };
struct mode {
	double omega;
	enum hawser_plane plane;
	enum hawser_symmetry symmetry;
	int driven;
	struct hawser_plan_mode at;
};
#define OF(member) HAWSER__AT(struct mode, member)
static const struct hawser__field mode_field[] = {
	{"index", NULL, "from 1", .kind = HAWSER__INDEX},
	{"omega", NULL, "natural frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"plane", NULL, "in-plane or out-of-plane", HAWSER__LABEL_AT(struct mode, plane, plane_name)},
	{"symmetry", NULL, "of the shape", HAWSER__LABEL_AT(struct mode, symmetry, symmetry_name)},
	{"driven", NULL, "whether the load drives it", HAWSER__FLAG_AT(struct mode, driven)},
	{"kept", NULL, "whether the scene's model has it", HAWSER__FLAG_AT(struct mode, at.kept)},
	{"worth", NULL, "whether it is worth keeping", HAWSER__FLAG_AT(struct mode, at.worth),
	 .when = CHOSEN},
	{"reason", NULL, "why", HAWSER__LABEL_AT(struct mode, at.reason, reason_name), .when = CHOSEN},
	{"measure", NULL, "what leaving it out should cost", OF(at.measure), .when = CHOSEN,
	 .flags = HAWSER__NULL | HAWSER__MISSING},
	HAWSER__END,
};
#undef OF

static const void *mode_row(void *to, const void *parent, size_t j)
{
	const struct cli_plan_result *result = parent;
	const struct hawser_mode *mode = &result->plan.modes.mode[j];

	*(struct mode *)to = (struct mode){
		.omega = mode->omega, .plane = mode->plane, .symmetry = mode->symmetry,
		.driven = is_driven(result, (int)j), .at = result->plan.mode[j]};
	return to;
}
static const struct hawser__list mode_list = HAWSER__MADE_ROWS(
	struct mode, mode_field, struct cli_plan_result, plan.modes.n, mode_row);

#define OF(member) HAWSER__AT(struct hawser_plan_resonance, member)
static const struct hawser__field resonance_field[] = {
	{"mode", NULL, "from 1", OF(mode), .flags = HAWSER__FROM_1},
	{"omega", NULL, "its natural frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"peak_Omega", NULL, "where the peak is", OF(peak_omega), .unit = HAWSER__RAD_S},
	{"motion", NULL, "largest displacement of the cable there", OF(motion), .unit = HAWSER__M},
	{"folds", NULL, "0 or 2", OF(folds)},
	{"cubic", NULL, "effective cubic coefficient, scaled", OF(cubic)},
	{"cubic_unlocked", NULL, "without the answer of other modes", OF(unlocked)},
	{"cubic_doubt", NULL, "how well it is known", OF(doubt),
	 .flags = HAWSER__NULL | HAWSER__MISSING},
	{"meets", NULL, "a mode that may exchange energy with it", OF(partner),
	 .flags = HAWSER__NULL | HAWSER__FROM_1},
	{"order", NULL, "ratio of their frequencies", OF(order), .flags = HAWSER__OMIT},
	HAWSER__END,
};
#undef OF

/* There is no order without a resonance partner. */
static const void *resonance_row(void *to, const void *parent, size_t i)
{
	struct hawser_plan_resonance *row = to;

	*row = ((const struct hawser_plan *)parent)->resonance[i];
	if (row->partner < 0)
		row->order = HAWSER__NO_INTEGER;
	return row;
}
static const struct hawser__list resonance_list = HAWSER__MADE_ROWS(
	struct hawser_plan_resonance, resonance_field, struct hawser_plan, resonances, resonance_row);

static const char *written_name(int written)
{
	return written ? "user" : "default";
}
struct settings {
	struct cli_setting setting[CLI_SETTINGS], *first;
	int count;
};
#define OF(member) HAWSER__AT(struct cli_setting, member)
static const struct hawser__field setting_field[] = {
	{"name", NULL, "key or option", OF(name)},
	{"value", NULL, "in use", OF(value)},
	{"unit", NULL, "of the value", OF(unit)},
	{"by", NULL, "user or default", HAWSER__LABEL_AT(struct cli_setting, written, written_name)},
	{"doc", NULL, "what it is", OF(doc)},
	HAWSER__END,
};
#undef OF
static const struct hawser__field settings_field[] = {
	{"settings", NULL, "in use", HAWSER__STORED(struct settings, first, count, setting_field)},
	HAWSER__END,
};

static void settings_json(struct hawser__json *json, json_t *into, const void *row)
{
	struct settings settings;
	struct hawser__view view = cli_si_view(0);

	settings.first = settings.setting;
	settings.count = cli_plan_settings(settings.setting, row);
	hawser__fields_json(json, into, settings_field, &settings, &view);
}

static const struct hawser__field decisions_field[] = {
	{"from", NULL, "end of the range of Omega", HAWSER__AT(struct hawser_plan, from),
	 .unit = HAWSER__RAD_S},
	{"to", NULL, "its other end", HAWSER__AT(struct hawser_plan, to), .unit = HAWSER__RAD_S},
	{"decisions", NULL, "what is modelled",
	 HAWSER__STORED(struct hawser_plan, decision, decisions, decision_field)},
	HAWSER__END,
};
static const struct hawser__field fidelities_field[] = {
	{"resonances", NULL, "primary resonances in the range", HAWSER__OBJECTS_OF(resonance_list)},
	{"fidelities", NULL, "as asked for", HAWSER__OBJECTS_OF(row_list)},
	{"own_time_secs", NULL, "processor time of the plan (s)",
	 HAWSER__AT(struct hawser_plan, seconds),
	 .flags = HAWSER__NULL | HAWSER__MISSING},
	HAWSER__END,
};
#define PLAN(fields) {"", NULL, "", HAWSER__PART_OF(struct cli_plan_result, plan, fields)}
static const struct hawser__field result_field[] = {
	PLAN(decisions_field),
	{"modes", NULL, "those looked at", HAWSER__OBJECTS_OF(mode_list)},
	PLAN(fidelities_field),
	{"settings", NULL, "in use", HAWSER__CALLS(settings_json), .inner = setting_field},
	HAWSER__END,
};

const struct cli_listing cli_plan_listing[] = {
	{"Columns of the table:", row_field, 0},
	{"Keys of JSON:", result_field, 1},
	{"Columns of the table of a net:", cli_plan_net_row, 0},
	{"Keys of JSON of a net:", cli_plan_net_fields, 1},
	{"Columns of the table of a ropeway:", cli_plan_ropeway_row, 0},
	{"Columns of the table of a reduced model:", cli_plan_model_field, 0},
	{"Keys of JSON of a reduced model:", cli_plan_model_member, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_plan_result *result = of;
	struct cli_head head = cli_model_head(
		result->common, "plan",
		"Omega_error and time_s are estimates", result->model, result->plan.chosen ? CHOSEN : 0u);

	head.rows = &result->plan;
	return head;
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_plan_result *result = of;
	const struct hawser_plan *plan = &result->plan;
	struct cli_setting setting[CLI_SETTINGS];
	int settings = cli_plan_settings(setting, result);

	hawser__table_comment(table, "range: Omega from %.12g to %.12g rad/s",
	                      plan->from*cli_per_omega(result->model),
	                      plan->to*cli_per_omega(result->model));
	for (int i = 0; i < plan->decisions; i++)
		hawser__table_comment(table, "%s: %s: %s",
		                      plan->decision[i].modelled ? "modelled" : "left out",
		                      plan->decision[i].subject, plan->decision[i].why);
	for (int i = 0; i < settings; i++)
		hawser__table_comment(table, "%s: %s = %s%s%s", setting[i].written ? "yours" : "default",
		                      setting[i].name, setting[i].value, *setting[i].unit ? " " : "",
		                      setting[i].unit);
	for (int i = 0; i < plan->rows; i++)
		if (*plan->row[i].foreseen)
			hawser__table_comment(table, "%s%s: %s", plan->row[i].choice.name,
			                      plan->row[i].status ? " fails" : "", plan->row[i].foreseen);
	if (isfinite(plan->seconds))
		hawser__table_remark(table, "plan's own processor time: %.2g s", plan->seconds);
}

const struct cli_showing cli_plan_showing = {
	.head = head, .comments = comments, .rows = &row_list, .fields = result_field};
