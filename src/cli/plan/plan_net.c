/* cli/plan/plan_net.c - hawser plan of a scene of kind `net`: text, table and JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/mesh_net.h"
#include "cli/plan/plan_result.h"
#include "cli/frame/view.h"
#include "core/report.h"

/* --- fields --- */

HAWSER__LABELS(basis_name, hawser_net_basis_name, enum hawser_net_basis)

static const char *by_name(int written)
{
	return written ? "user" : "default";
}

#define OF(member) HAWSER__AT(struct hawser_net_plan_job, member)
#define MAYBE(member) OF(member), .flags = HAWSER__NULL
const struct hawser__field cli_plan_net_row[] = {
	{"name", "job", "statics, modes or integrate", OF(name)},
	{"method", "method", "that is taken", OF(method)},
	{"unknowns", "unknowns", "of the model", OF(unknowns)},
	{"count", "count", "iterations or steps", MAYBE(count)},
	{"counted", "counted", "what is counted", OF(counted)},
	{"time_secs", "time_s", "processor time of the command, all included (s)", MAYBE(seconds)},
	{"least_time_secs", "least_time_s", "lower bound of the time (s)", MAYBE(least)},
	{"most_time_secs", "most_time_s", "upper bound of the time (s)", MAYBE(most)},
	{"time_by", "time_by", "source of the time: run or estimate; empty: it cannot be done",
	 HAWSER__LABEL_AT(struct hawser_net_plan_job, basis, basis_name)},
	{"memory_bytes", "memory_bytes", "memory, about", MAYBE(bytes)},
	{"why", NULL, "why this method, or why it cannot be done", OF(why)},
	HAWSER__END,
};
#undef MAYBE
#undef OF
static size_t jobs(const void *parent)
{
	(void)parent;
	return HAWSER_NET_JOBS;
}

static const void *job_row(void *row, const void *parent, size_t i)
{
	return memcpy(row, &((const struct cli_plan_net_result *)parent)->plan.job[i],
	              sizeof(struct hawser_net_plan_job));
}

static const struct hawser__list jobs_list = {
	.field = cli_plan_net_row, .count = jobs, .row = job_row,
	.size = HAWSER__MADE_SIZE(struct hawser_net_plan_job)};

#define OF(member) HAWSER__AT(struct hawser_net_decision, member)
static const struct hawser__field decision_field[] = {
	{"subject", NULL, "what may be modelled", OF(subject)},
	{"modelled", NULL, "whether it is", HAWSER__FLAG_AT(struct hawser_net_decision, modelled)},
	{"why", NULL, "why", OF(why)},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct cli_plan_net_cable, at.member)
#define MAYBE(member) OF(member), .flags = HAWSER__NULL
static const struct hawser__field cable_field[] = {
	{"name", NULL, "of the cable", HAWSER__AT(struct cli_plan_net_cable, name)},
	{"elements", NULL, "of its mesh", OF(elements)},
	{"slack", NULL, "elements without tension in the equilibrium", OF(slack)},
	{"length0", NULL, "unstretched length (m)", MAYBE(length0)},
	{"sag", NULL, "largest vertical distance from the chord (m)", MAYBE(sag)},
	{"reach", NULL, "the sag, or a tenth of the largest one of all cables (m)", MAYBE(reach)},
	{"T_min", NULL, "least tension (N)", MAYBE(T_min)},
	{"T_max", NULL, "largest tension (N)", MAYBE(T_max)},
	{"strain", NULL, "largest strain", MAYBE(strain)},
	{"position_error", NULL, "of the mesh, against exact catenaries (m)", MAYBE(error)},
	{"tension_error", NULL, "of the mesh, over T_max", MAYBE(tension_error)},
	{"elements_wanted", NULL, "for an error of 0.1 % of the reach; 0: not known", OF(wanted)},
	HAWSER__END,
};
#undef MAYBE
#undef OF

#define OF(member) HAWSER__AT(struct cli_setting, member)
static const struct hawser__field setting_field[] = {
	{"name", NULL, "key or option", OF(name)},
	{"value", NULL, "in use", OF(value)},
	{"unit", NULL, "of the value", OF(unit)},
	{"by", NULL, "user or default", HAWSER__LABEL_AT(struct cli_setting, written, by_name)},
	{"doc", NULL, "what it is", OF(doc)},
	HAWSER__END,
};
#undef OF

static void warnings(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_plan_net_result *result = of;
	json_t *list = hawser__json_array(json, into, "warnings");

	for (int i = 0; i < result->plan.warnings; i++)
		hawser__json_text(json, list, NULL, result->plan.warning[i]);
}

#define OF(member) HAWSER__AT(struct hawser_net_plan, member)
#define MAYBE(member) OF(member), .flags = HAWSER__NULL
static const struct hawser__field size_field[] = {
	{"nodes", NULL, "of the scene", OF(nodes)},
	{"supports", NULL, "of them", OF(supports)},
	{"elements", NULL, "of the mesh", OF(elements)},
	{"mesh_nodes", NULL, "of the mesh", OF(mesh_nodes)},
	{"unknowns", NULL, "of the mesh", OF(unknowns)},
	{"catenary_unknowns", NULL, "of exact catenaries: the joints alone", OF(joint_unknowns)},
	{"until", NULL, "end of the motion (s)", OF(until)},
	{"every", NULL, "interval of its rows (s)", OF(every)},
	{"step", NULL, "mean step of the motion (s)", MAYBE(step)},
	{"first_omega", NULL, "lowest natural frequency (rad/s)", MAYBE(first)},
	{"axial_omega", NULL, "fastest axial vibration of the mesh (rad/s)", MAYBE(axial)},
	{"load_omega_min", NULL, "lowest frequency of loads and supports (rad/s); 0: none", OF(slowest)},
	{"load_omega_max", NULL, "highest of them (rad/s)", OF(fastest)},
	{"elements_per_wave", NULL, "elements in a wave of that frequency, fewest", MAYBE(resolved)},
	{"decisions", NULL, "what is modelled",
	 HAWSER__STORED(struct hawser_net_plan, decision, decisions, decision_field)},
	HAWSER__END,
};
static const struct hawser__field own_field[] = {
	{"own_time_secs", NULL, "processor time of the plan (s)", MAYBE(seconds)},
	HAWSER__END,
};
#undef MAYBE
#undef OF
HAWSER__LABELS(kind_word, hawser_kind_name, enum hawser_kind)
const struct hawser__field cli_plan_net_fields[] = {
	{"kind", NULL, "net", HAWSER__WORD_OF(HAWSER_KIND_NET, kind_word)},
	{"", NULL, "", HAWSER__PART_OF(struct cli_plan_net_result, plan, size_field)},
	{"cables", NULL, "their meshes", HAWSER__STORED(struct cli_plan_net_result, cable, cables,
	 cable_field)},
	{"jobs", NULL, "what commands cost", HAWSER__OBJECTS_OF(jobs_list)},
	{"warnings", NULL, "texts", .kind = HAWSER__CALL, .call = warnings},
	{"settings", NULL, "in use", HAWSER__STORED_WITHIN(struct cli_plan_net_result, setting, settings,
	                                                   setting_field)},
	{"", NULL, "", HAWSER__PART_OF(struct cli_plan_net_result, plan, own_field)},
	HAWSER__END,
};

/* --- settings --- */

static struct cli_setting *setting(struct cli_plan_net_result *result, const char *name, int written,
                                   const char *unit, const char *doc)
{
	struct cli_setting *now = &result->setting[result->settings++];

	*now = (struct cli_setting){.unit = unit, .doc = doc, .written = written};
	snprintf(now->name, sizeof now->name, "%s", name);
	return now;
}
#define VALUE(now, ...) \
	((void)snprintf((now)->value, sizeof ((struct cli_setting *)0)->value, __VA_ARGS__))

static void elements(struct cli_plan_net_result *result)
{
	int least = INT_MAX, most = 0, given = 1;
	struct cli_setting *now;

	for (int c = 0; c < result->net.cables; c++) {
		const struct hawser_net_cable *cable = &result->net.cable[c];

		least = cable->elements < least ? cable->elements : least;
		most = cable->elements > most ? cable->elements : most;
		given = given && cable->elements_given;
	}
	now = setting(result, "cables.*.elements", given, "", "of each cable; "
	              "without it at least 20, and as many as tensions to 1e-3 need");
	if (least == most)
		VALUE(now, "%d", most);
	else
		VALUE(now, "%d to %d", least, most);
}

static void settings(struct cli_plan_net_result *result)
{
	const struct hawser_net *net = &result->net;
	const struct hawser_net_dynamics *d = &net->dynamics;
	const struct cli_plan_net *given = result->given;
	double step = result->options.motion.step != 0.0 ? result->options.motion.step : d->step;

	VALUE(setting(result, "g", net->g_given, "m/s^2", "acceleration of gravity, downwards"), "%.10g",
	      net->g);
	elements(result);
	VALUE(setting(result, "statics --method", 0, "", "exact catenaries, then the mesh"), "automatic");
	VALUE(setting(result, "statics tolerance", 0, "", "force that is not balanced, over all loads"),
	      "1e-10");
	VALUE(setting(result, "modes --modes", given->modes > 0, "", "number of modes"), "%d",
	      given->modes > 0 ? given->modes : 6);
	VALUE(setting(result, "modes tolerance", 0, "", "relative change of the last iteration"), "1e-13");
	VALUE(setting(result, "integrate --until", given->until != NULL, "s", "end of the motion; plan "
	              "takes ten periods, integrate wants it given"), "%.6g", result->plan.until);
	VALUE(setting(result, "integrate --every", 0, "s", "interval of the rows: a 200th"), "%.6g",
	      result->plan.every);
	VALUE(setting(result, "dynamics.scheme", given->scheme || *d->scheme, "", "of time "
	              "integration"), "%s",
	      result->plan.job[2].method);
	if (strcmp(result->plan.job[2].method, "alpha") == 0)
		VALUE(setting(result, "dynamics.rho_inf", d->rho_inf >= 0.0, "", "spectral radius at large "
		              "steps"),
		      "%.6g", d->rho_inf >= 0.0 ? d->rho_inf : 0.9);
	if (step > 0.0)
		VALUE(setting(result, "dynamics.step", 1, "s", "longest step"), "%.6g", step);
	else
		VALUE(setting(result, "dynamics.step", given->step != NULL, "", "by the local error"), "auto");
	VALUE(setting(result, "integrate --rtol", given->rtol > 0.0, "", "local error of a position "
	              "over the longest cable"), "%g", given->rtol > 0.0 ? given->rtol : 1e-7);
	VALUE(setting(result, "Newton's method", 0, "", "ends at this part of the largest force"), "1e-12");
}
#undef VALUE

/* --- table and JSON --- */

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_plan_net_result *result = of;
	const struct hawser_net_plan *plan = &result->plan;

	hawser__table_comment(table, "%d nodes, %d supports, %d cables, %d elements, %d unknowns; "
	                      "motion until %.6g "
	                      "s", plan->nodes, plan->supports, plan->cables, plan->elements,
	                      plan->unknowns, plan->until);
	for (int i = 0; i < plan->decisions; i++)
		hawser__table_comment(table, "%s: %s: %s", plan->decision[i].modelled ? "modelled" : "left out",
		                      plan->decision[i].subject, plan->decision[i].why);
	for (int i = 0; i < plan->warnings; i++)
		hawser__table_comment(table, "warning: %s", plan->warning[i]);
	for (int i = 0; i < result->settings; i++) {
		const struct cli_setting *at = &result->setting[i];

		hawser__table_comment(table, "%s: %s = %s%s%s", at->written ? "yours" : "default", at->name,
		                      at->value, *at->unit ? " " : "", at->unit);
	}
}

static struct cli_head head(const void *of)
{
	return cli_si_head(((const struct cli_plan_net_result *)of)->common, "plan",
	                   "time_s is measured where time_by is run", NULL, 0);
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &jobs_list,
                                           .fields = cli_plan_net_fields};

/* --- the command --- */

static enum hawser_status options_of(struct cli_plan_net_result *result, struct hawser_report *report)
{
	const struct cli_plan_net *given = result->given;
	struct hawser_net_motion_options *motion = &result->options.motion;
	enum hawser_status status = HAWSER_OK;
	int known = !given->scheme;

	result->options.seconds = given->limit;
	result->options.modes = given->modes;
	motion->tolerance = given->rtol;
	motion->scheme = given->scheme;
	if (given->until)
		status = cli_quantity(&motion->until, given->until, "s", CLI_ABOVE_ZERO, "plan", "until",
		                      report);
	if (!status && given->step && strcmp(given->step, "auto") == 0)
		motion->step = -1.0;
	else if (!status)
		status = cli_quantity(&motion->step, given->step, "s", CLI_ABOVE_ZERO, "plan", "step", report);
	for (int i = 0; !known && hawser_net_scheme(i); i++)
		known = strcmp(hawser_net_scheme(i)->name, given->scheme) == 0;
	return status || known ? status
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, "plan", "--method %s: the schemes of nets are "
		               "energy, alpha, theta, euler and cvode", given->scheme);
}

/* What differs from run to run. */
static void forget(struct hawser_net_plan *plan)
{
	plan->seconds = plan->step = NAN;
	for (int i = 0; i < HAWSER_NET_JOBS; i++) {
		struct hawser_net_plan_job *job = &plan->job[i];

		job->seconds = job->least = job->most = job->count = NAN;
		job->basis = HAWSER_NET_BASIS_NONE;
	}
}

static enum hawser_status rows(struct cli_plan_net_result *result, struct hawser_report *report)
{
	result->cables = result->net.cables;
	result->cable = calloc((size_t)result->cables + 1, sizeof *result->cable);
	if (!result->cable)
		return hawser__no_memory(report, "plan");
	for (int c = 0; c < result->cables; c++)
		result->cable[c] = (struct cli_plan_net_cable){result->net.cable[c].name,
		                                               result->plan.cable[c]};
	settings(result);
	if (result->common->reproducible)
		forget(&result->plan);
	return HAWSER_OK;
}

enum hawser_status cli_plan_net(const struct cli_common *common, const struct cli_plan_net *given,
                                struct hawser_report *report)
{
	struct cli_plan_net_result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "plan");
	result->common = common;
	result->given = given;
	status = options_of(result, report);
	if (!status)
		status = cli_mesh_open(&result->net, common, report);
	if (!status)
		status = hawser_net_plan_make(&result->plan, &result->net, &result->options, report);
	if (!status)
		status = rows(result, report);
	if (!status && (common->json || common->tsv))
		status = cli_show(common, &showing, result, report);
	else if (!status)
		cli_plan_net_print(stdout, result);
	hawser_net_plan_clear(&result->plan);
	hawser_net_clear(&result->net);
	free(result->cable);
	free(result);
	return status;
}
