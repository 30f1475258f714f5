/* cli/motion/integrate_net.c - hawser integrate of a scene of kind `net`: places in time, and
 * the energy. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "cli/motion/integrate_net.h"
#include "cli/frame/mesh_net.h"
#include "cli/frame/progress.h"
#include "core/report.h"
#include "output/curves/plot_motions.h"
#include "output/drawing/animate.h"
#include "output/report/vtk.h"

enum { PATH = 4096, DRAWN = 3, TOLD = 8 }; /* probes drawn, and told in comments */
enum { ROWS = 200 }; /* of a run without --every, as hawser_net_integrate has (net_motion.h) */

struct result {
	const struct cli_common *common;
	const struct cli_integrate_net *settings;
	struct cli_mesh mesh;
	struct hawser_net_motion motion;
	struct cli_contacts contacts;
	struct cli_events events;
	struct hawser_net_probe probe[CLI_PROBES];
	struct cli_probed probed;
	enum hawser_status failed; /* of a frame */
	struct hawser_report of_frame;
	struct cli_film film;
};

/* --- probes: J, or c1:0.25 --- */

static enum hawser_status add(void *to, const char *name, struct hawser_report *report)
{
	struct result *result = to;
	const struct hawser_net *net = &result->mesh.net;
	struct hawser_net_probe *probe = &result->probe[result->probed.probes - 1];
	const char *colon = strchr(name, ':');
	char *end = NULL;

	*probe = (struct hawser_net_probe){.node = -1, .cable = -1};
	for (int i = 0; i < net->nodes; i++)
		if (strcmp(net->node[i].name, name) == 0)
			probe->node = i;
	for (int i = 0; i < net->cables && colon; i++)
		if (strlen(net->cable[i].name) == (size_t)(colon - name) &&
		    strncmp(net->cable[i].name, name, (size_t)(colon - name)) == 0)
			probe->cable = i;
	if (probe->cable >= 0) {
		probe->part = strtod(colon + 1, &end);
		if (end == colon + 1 || *end || !(probe->part >= 0.0 && probe->part <= 1.0))
			probe->cable = -1;
	}
	return probe->node >= 0 || probe->cable >= 0 ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "--probe %s: neither a node of the "
		               "net nor a place of a cable, such as c1:0.25 for a quarter of the length of "
		               "cable c1", name);
}

/* Without --probe: all nodes that are not held. */
static enum hawser_status probes(struct result *result, struct hawser_report *report)
{
	const char *given = result->settings->probe;
	const struct hawser_net *net = &result->mesh.net;
	const struct cli_probe_adder by = {add, &result->probed, result};
	enum hawser_status status = cli_probes_add(&by, given, report);

	for (int i = 0; i < net->nodes && !given && result->probed.probes < CLI_PROBES && !status; i++) {
		int held = net->node[i].held[0] && net->node[i].held[1] && net->node[i].held[2];

		for (int k = 0; k < net->dynamics.releases; k++)
			held = held && net->dynamics.release[k] != i;
		if (!held)
			status = cli_probes_add(&by, net->node[i].name, report);
	}
	if (!status && result->probed.probes == 0 && net->cables > 0) {
		char name[CLI_PROBE_NAME];

		snprintf(name, sizeof name, "%s:0.5", net->cable[0].name);
		status = cli_probes_add(&by, name, report);
	}
	return status;
}

/* --- VTK: one file a row --- */

static enum hawser_status write_vtk(const char *stem, const struct hawser_net_frame *frame,
                                    struct hawser_report *report)
{
	double *state = calloc((size_t)frame->nodes + 1, sizeof *state);
	const struct hawser__vtk_scalar tension = {"tension_N", frame->T};
	const struct hawser__vtk_scalar mark[] = {{"contact", state}, {"r_N_N", frame->r_N},
	                                          {"r_T_N", frame->r_T}};
	char path[PATH], title[64];
	enum hawser_status status = state ? HAWSER_OK : hawser__no_memory(report, "integrate");

	for (int i = 0; i < frame->nodes && frame->state && !status; i++)
		state[i] = frame->state[i];
	snprintf(path, sizeof path, "%s-%05d.vtk", stem, frame->row);
	snprintf(title, sizeof title, "hawser, t = %.9g s", frame->t);
	if (!status)
		status = hawser__vtk_write(path, &(struct hawser__vtk){
			.title = title, .points = frame->nodes, .lines = frame->elements, .x = frame->x,
			.end = frame->end, .scalars = 1, .scalar = &tension, .marks = frame->state ? 3 : 0,
			.mark = mark}, report);
	free(state);
	return status;
}

static int frame(void *data, const struct hawser_net_frame *frame)
{
	struct result *result = data;
	const struct cli_integrate_net *settings = result->settings;
	int wrong = settings->animate ? cli_film_add(&result->film, frame) : 0;

	if (wrong)
		result->failed = hawser__fail(&result->of_frame, HAWSER_ERR_IO, "integrate",
		                              "cannot write %s: %s", settings->animate, strerror(wrong));
	else if (settings->vtk)
		result->failed = write_vtk(settings->vtk, frame, &result->of_frame);
	return result->failed != HAWSER_OK;
}

/* --- results --- */

/* What is shown of the probes, and of the contacts at the end. */
static void gather(struct result *result)
{
	const struct hawser_net_motion *motion = &result->motion;

	result->probed.rows = motion->rows;
	result->probed.x = (const double (*)[3])motion->x;
	result->probed.T = motion->T;
	result->probed.pull = (const double (*)[3])motion->pull;
	for (int p = 0; p < motion->probes; p++) {
		int at = result->probe[p].node;
		const unsigned char *held = at < 0 ? NULL : result->mesh.net.node[at].held;

		if (held && (held[0] || held[1] || held[2]))
			result->probed.held[result->probed.holds++] = p;
	}
	result->contacts = (struct cli_contacts){&result->mesh.net, motion->contact, motion->contacts, 0.0};
	result->events = (struct cli_events){&result->mesh.net, motion->failure, motion->winch,
	                                     motion->failures, motion->winches};
	for (int i = 0; i < motion->rows && motion->apart; i++)
		result->contacts.apart = fmax(result->contacts.apart, motion->apart[i]);
}

/* The range of `rows` values, `stride` apart. */
static void range(double *low, double *high, const double *value, int rows, int stride)
{
	*low = INFINITY;
	*high = -INFINITY;
	for (int i = 0; i < rows; i++) {
		*low = fmin(*low, value[(size_t)i*(size_t)stride]);
		*high = fmax(*high, value[(size_t)i*(size_t)stride]);
	}
}

static void probe_comment(struct hawser__table *table, const struct result *result, int p)
{
	const struct hawser_net_motion *motion = &result->motion;
	double y[2], T[2];

	range(&y[0], &y[1], &motion->x[p][1], motion->rows, 3*motion->probes);
	range(&T[0], &T[1], &motion->T[p], motion->rows, motion->probes);
	T[0] = T[0] > 1e-12*T[1] ? T[0] : 0.0; /* round-off of no tension */
	hawser__table_comment(table, "%s: largest tension there %.9g to %.9g N, y %.9g to %.9g m",
	                      result->probed.name[p], T[0], T[1], y[0], y[1]);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_net_motion *motion = &result->motion;

	hawser__table_comment(table, "%ld steps, %ld made shorter for their error, %ld halved; %ld "
	                      "changes of elements between slack and taut", motion->steps,
	                      motion->rejected, motion->splits, motion->switches);
	hawser__table_comment(table, "energy ledger closed to %.1e of its largest term",
	                      motion->closure);
	hawser__table_comment(table, "positions to some %.1e m: %s", motion->error, motion->checked
	                      ? "from another, coarser run"
	                      : "the local errors of all steps, if they do not grow (--error looks)");
	if (motion->front_axial > 0.0 && !isnan(motion->shock))
		hawser__table_comment(table, "fronts behind which the cable is slack: damping.axial is %.3g "
		                      "s, half the time in which a wave passes an element; with all of it, "
		                      "positions differ by up to %.1e m", motion->front_axial, motion->shock);
	else if (!isnan(motion->shock))
		hawser__table_comment(table, "fronts behind which the cable is slack: with damping.axial = "
		                      "%.3g s, positions differ by up to %.1e m; without, their energy "
		                      "stays in the mesh", motion->shock_axial, motion->shock);
	for (int p = 0; p < motion->probes && p < TOLD; p++)
		probe_comment(table, result, p);
	cli_mesh_comment(table, &result->mesh);
	if (result->mesh.net.surfaces)
		hawser__table_comment(table, "contacts: penetration, and gap of what touches, at most %.1e m; "
		                      "laws of contact and friction to %.1e", result->contacts.apart,
		                      motion->laws);
	for (int k = 0; k < 3; k++)
		if (motion->still[k])
			hawser__table_comment(table, "no motion along %c in the model: nothing drives it",
			                      "xyz"[k]);
	cli_events_comments(table, &result->events);
	if (motion->interrupted)
		hawser__table_comment(table, "interrupted at %.6g s", motion->reached);
}

HAWSER__OF(error_from, const char *, struct result,
	of->motion.checked ? "another run" : "local errors")

HAWSER__GIVEN(fronts, struct result, of->motion.front_axial > 0.0)

static void still_json(struct hawser__json *json, json_t *to, const void *of)
{
	json_t *into = hawser__json_array(json, to, "still");

	for (int k = 0; k < 3; k++)
		if (((const struct result *)of)->motion.still[k])
			hawser__json_text(json, into, NULL, (const char *[]){"x", "y", "z"}[k]);
}

enum { SURFACES = 1 };
#define ROWS_OF(member) HAWSER__ALONG(struct result, motion.member)
#define ONE(member) HAWSER__IN(struct result, motion.member)
#define PART(member, fields) {"", NULL, "", HAWSER__PART_OF(struct result, member, fields), \
	.from = HAWSER__IN_PARENT
#define JOULE .unit = HAWSER__J  /* an energy */
#define TOUCH .when = SURFACES   /* with obstacles */
const struct hawser__field cli_net_motion_field[] = {
	{"scheme", NULL, "of time integration", ONE(scheme)},
	{"times", "t", "time", ROWS_OF(time), .unit = HAWSER__SECOND},
	PART(probed, cli_probed_field)},
	{NULL, "", "of each probe: its place, and the largest tension there",
	 HAWSER__VECTOR_OF(cli_probed_vector)},
	{NULL, "", "of each probe that is a support: what the cables pull on it",
	 HAWSER__VECTOR_OF(cli_pulled_vector), .unit = HAWSER__NEWTON},
	{"energy.kinetic", "kinetic", "kinetic energy", ROWS_OF(kinetic), JOULE},
	{"energy.potential", "potential", "of strain, weight and constant loads, since the beginning",
	 ROWS_OF(potential), JOULE},
	{"energy.work", "work", "of harmonic loads, moving supports and surfaces, and water, since the "
	 "beginning", ROWS_OF(work), JOULE},
	{"energy.dissipated", "dissipated", "by damping, drag of water, friction and impacts, since the "
	 "beginning", ROWS_OF(dissipated), JOULE},
	{"energy.closure", NULL, "largest error of this ledger over its largest term", ONE(closure)},
	{"energy.friction", "friction", "with obstacles: dissipated by friction", ROWS_OF(friction), JOULE,
	 .place = 1, TOUCH},
	{"energy.impacts", "impacts", "by impacts", ROWS_OF(impacts), JOULE, .place = 1, TOUCH},
	{"error.position", NULL, "estimated error of places", ONE(error), .unit = HAWSER__METRE},
	{"error.from", NULL, "another run or local errors", HAWSER__TEXT_BY(error_from),
	 .from = HAWSER__IN_PARENT},
	{"error.shock", NULL, "by fronts behind which the cable is slack; null: none", ONE(shock),
	 .unit = HAWSER__METRE, .flags = HAWSER__NULL},
	{"error.front_axial", NULL, "damping.axial of these fronts", ONE(front_axial),
	 .unit = HAWSER__SECOND, .given = fronts},
	PART(mesh, cli_mesh_field)},
	{"slack", "slack", "number of elements without tension", ROWS_OF(slack)},
	PART(events, cli_events_field)},
	{"still", NULL, "axes along which nothing moves the net", HAWSER__CALLS(still_json),
	 .from = HAWSER__IN_PARENT},
	{"touching", "touching", "with obstacles: number of contacts", ROWS_OF(touching), TOUCH},
	{"sliding", "sliding", "of these, those that slip", ROWS_OF(sliding), TOUCH},
	{"apart", "apart", "largest penetration, or gap of what touches, since the last row",
	 ROWS_OF(apart), .unit = HAWSER__METRE, .place = 2, TOUCH},
	{"laws", NULL, "largest relative residual of the laws of contact and friction", ONE(laws), TOUCH},
	PART(contacts, cli_apart_field), TOUCH},
	{"interrupted", NULL, "whether the run ended early",
	 HAWSER__FLAG_AT(struct result, motion.interrupted), .from = HAWSER__IN_PARENT},
	HAWSER__END,
};
#undef ONE
static const struct hawser__list row_list = {
	.field = cli_net_motion_field, .count_at = offsetof(struct result, motion.rows)};
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__ARRAYS_OF(row_list)},
	HAWSER__END,
};
#define OF(member) HAWSER__AT(struct result, motion.member)
static const struct hawser__field stats_field[] = {
	{"unknowns", NULL, "of the mesh", OF(unknowns)},
	{"steps", NULL, "of the scheme", OF(steps)},
	{"iterations", NULL, "of Newton's method", OF(iterations)},
	{"rejected", NULL, "steps made shorter for their error", OF(rejected)},
	{"splits", NULL, "steps made in halves", OF(splits)},
	{"switches", NULL, "of elements between slack and taut", OF(switches)},
	HAWSER__END,
};
#undef OF

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_si_head(result->common, "integrate", result->motion.scheme, &result->probed,
	                   (result->mesh.net.surfaces ? SURFACES : 0u) |
	                   (result->motion.failures ? CLI_FAILURES : 0u) |
	                   (result->motion.winches ? CLI_WINCHES : 0u));
}

static const double round_off = 1e-9; /* of a value that does not change, relative; chosen */

/* Probe p as a curve of a panel, if its value changes. */
static int add_probe(struct hawser__motion_panel *panel, const char *label, int colour,
                     const double *value, int rows)
{
	double low, high;

	range(&low, &high, value, rows, panel->stride);
	if (!(high - low > round_off*fmax(fabs(low), fabs(high))))
		return 0;
	panel->curve[panel->curves++] = (struct hawser__motion_curve){label, colour, value};
	return 1;
}

/* Heights and largest tensions of the first probes in which they change, and the energies. */
static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;
	const struct hawser_net_motion *motion = &result->motion;
	const int rows = motion->rows;
	struct hawser__motion_panel height = {.axis = hawser__axis_of("Height {/:Italic y}", "m", 0.0),
	                                      .stride = 3*motion->probes};
	struct hawser__motion_panel tension = {.stride = motion->probes};
	struct hawser__motions shown = {
		.rows = rows, .time = motion->time, .axis = hawser__axis_of("Time {/:Italic t}", "s", 0.0)};
	char label[DRAWN][3*CLI_PROBE_NAME] = {""};
	double *sum = malloc(((size_t)rows + 1)*sizeof *sum), most = 0.0, low, high;
	enum hawser_status status;

	for (int p = 0, drawn = 0; p < motion->probes && drawn < DRAWN; p++) {
		FILE *to = fmemopen(label[drawn], sizeof label[drawn], "w");
		int any;

		if (to) {
			hawser__picture_literal(to, result->probed.name[p], 0);
			fclose(to);
		}
		any = add_probe(&height, label[drawn], drawn + 1, &motion->x[p][1], rows);
		any |= add_probe(&tension, label[drawn], drawn + 1, &motion->T[p], rows);
		drawn += any;
	}
	for (int i = 0; i < rows*motion->probes; i++)
		most = fmax(most, motion->T[i]);
	tension.axis = hawser__axis_of("Tension {/:Italic T}", "N", most);
	if (height.curves + tension.curves == 0) /* nothing moves */
		height.curve[height.curves++] = (struct hawser__motion_curve){
			"the first probe, which does not move", 1, motion->x[0] + 1};
	if (height.curves > 0)
		shown.panel[shown.panels++] = height;
	if (tension.curves > 0)
		shown.panel[shown.panels++] = tension;
	range(&low, &high, motion->kinetic, rows, 1);
	if (high > round_off*most) /* J over N: of a motion by a nanometre */
		shown.panel[shown.panels++] = (struct hawser__motion_panel){
			hawser__axis_of("Energy", "J", high), 1, 3,
			{{"kinetic", 4, motion->kinetic}, {"potential", 5, motion->potential}, {"sum", 6, sum}}};
	for (int i = 0; i < rows && sum; i++)
		sum[i] = motion->kinetic[i] + motion->potential[i];
	status = sum ? hawser__plot_motions(path, &shown, report) : hawser__no_memory(report, "picture");
	free(sum);
	return status;
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &row_list,
                                           .fields = result_field, .stats = stats_field,
                                           .draw = draw};

/* --- the run --- */

static enum hawser_status options_of(struct hawser_net_motion_options *options,
                                     const struct result *result, struct hawser_report *report)
{
	const struct cli_integrate_net *settings = result->settings;
	enum hawser_status status;
	int known = 0;

	status = cli_integrate_times(&options->until, &options->every, &options->step, settings, "net",
	                             report);
	if (status || !settings->scheme)
		return status;
	for (int i = 0; hawser_net_scheme(i); i++)
		known |= strcmp(hawser_net_scheme(i)->name, settings->scheme) == 0;
	options->scheme = settings->scheme;
	return known ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "--method %s: the schemes of nets "
		               "are energy, alpha, theta, euler and cvode", settings->scheme);
}

static enum hawser_status solve(struct result *result, struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = result->common->quiet}, "integrate"};
	struct hawser_net_motion_options options = {
		.initial = result->settings->initial, .tolerance = result->settings->tolerance,
		.check = result->settings->error, .probe = result->probe, .frame = frame, .data = result,
		.progress = {cli_watch, &watch}};
	enum hawser_status status = hawser__animate_check(result->settings->animate, "integrate", report);

	if (!status)
		status = cli_mesh_open(&result->mesh.net, result->common, report);
	if (!status)
		status = probes(result, report);
	options.probes = result->probed.probes;
	if (!status)
		status = options_of(&options, result, report);
	result->film.room = result->settings->frames > 0 ? result->settings->frames
	                                                 : HAWSER__ANIMATE_FRAMES;
	result->film.last = options.every > 0.0 ? floor(options.until/options.every + 1e-9) : ROWS;
	if (result->film.room > result->film.last + 1.0)
		result->film.room = (int)result->film.last + 1;
	if (!status)
		status = hawser_net_integrate(&result->motion, &result->mesh.net, &options, report);
	cli_progress_end(&watch.progress);
	if (!status)
		status = hawser_net_mesh_error(&result->mesh.error, &result->mesh.net, NULL, report);
	if (!status && result->failed) {
		*report = result->of_frame;
		status = result->failed;
	}
	for (int i = 0; i < result->film.rows && !status; i++) /* of the first probe */
		memcpy(result->film.mark[i], result->motion.x[(long)result->film.row[i]*result->motion.probes],
		       sizeof *result->film.mark);
	if (!status && result->settings->animate)
		status = cli_film_write(result->settings->animate, &result->film, &result->mesh.net, report);
	return status;
}

enum hawser_status cli_integrate_net(const void *context, struct hawser_report *report)
{
	const struct cli_integrate_net *settings = context;
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "integrate");
	result->common = settings->common;
	result->settings = settings;
	status = solve(result, report);
	if (!status) {
		char text[CLI_WARNING_SIZE];

		cli_mesh_warning(text, &result->mesh);
		if (*text)
			cli_warn(text);
		cli_motion_warnings(&result->mesh.net, &result->motion);
		gather(result);
	}
	if (!status && settings->state)
		status = hawser_net_state_write(&result->motion, settings->state, report);
	if (!status)
		status = cli_show(settings->common, &showing, result, report);
	hawser_net_motion_clear(&result->motion);
	hawser_net_clear(&result->mesh.net);
	cli_film_clear(&result->film);
	free(result);
	return status;
}
