/* cli/curves/frf_waves.c - hawser frf of a net with waves: displacements and tensions per metre of
 * the amplitude of a wave, over the frequency.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_waves.h>

#include "cli/curves/frf_waves.h"
#include "cli/frame/mesh_net.h"
#include "cli/frame/progress.h"
#include "core/report.h"
#include "output/curves/plot_motions.h"

enum { PROBES = 8, DRAWN = 6, EACH_PROBE = 6, EACH_CABLE = 4, LABEL = 3*HAWSER_NET_NAME, SEA = 1 };
enum { POINTS = 200 }; /* without --max-points */
static const double SIGMAS = 3.0; /* of a tension: at its mean, slack counts as probable; chosen */

struct result {
	const struct cli_common *common;
	struct cli_mesh mesh;
	struct hawser_net_waves waves;
	struct hawser_net_probe probe[PROBES];
	char name[PROBES][2*HAWSER_NET_NAME];
	int probes;
};

int cli_waves_in(const struct cli_common *common)
{
	struct hawser_net net;
	int waves;

	if (cli_kind(common) != HAWSER_KIND_NET || cli_mesh_open(&net, common, NULL) != HAWSER_OK)
		return 0;
	waves = net.water.waves.count;
	hawser_net_clear(&net);
	return waves > 0;
}

/* Nodes that can move; else the middles of cables. */
static void probes(struct result *result)
{
	const struct hawser_net *net = &result->mesh.net;

	for (int i = 0; i < net->nodes && result->probes < PROBES; i++) {
		if (net->node[i].held[0] && net->node[i].held[1] && net->node[i].held[2] &&
		    (!net->node[i].body || net->node[i].support))
			continue;
		result->probe[result->probes] = (struct hawser_net_probe){i, -1, 0.0};
		snprintf(result->name[result->probes++], sizeof *result->name, "%s", net->node[i].name);
	}
	for (int i = 0, none = !result->probes; i < net->cables && i < PROBES && none; i++) {
		result->probe[result->probes] = (struct hawser_net_probe){-1, i, 0.5};
		snprintf(result->name[result->probes++], sizeof *result->name, "%s_mid", net->cable[i].name);
	}
}

/* --- columns: of probes, then of cables --- */

HAWSER__OF(numbers, int, struct result, EACH_PROBE*of->probes + EACH_CABLE*of->waves.cables)

static void name(char *text, size_t size, const void *context, int k)
{
	static const char *const end[] = {"from", "to", "from_phase", "to_phase"};
	const struct result *of = context;
	int cable = (k - EACH_PROBE*of->probes)/EACH_CABLE;

	if (k < EACH_PROBE*of->probes)
		snprintf(text, size, "%s_%c%s", of->name[k/EACH_PROBE], "xyz"[k%3],
		         k%EACH_PROBE < 3 ? "" : "_phase");
	else
		snprintf(text, size, "%s_T_%s", of->mesh.net.cable[cable].name,
		         end[(k - EACH_PROBE*of->probes)%EACH_CABLE]);
}

static enum hawser__unit unit(const void *context, int k)
{
	const struct result *of = context;

	if (k < EACH_PROBE*of->probes)
		return k%EACH_PROBE < 3 ? HAWSER__NONE : HAWSER__RADIAN;
	return (k - EACH_PROBE*of->probes)%EACH_CABLE < 2 ? HAWSER__NEWTON_M : HAWSER__RADIAN;
}

static double number(const void *context, const void *parent, size_t row, int k)
{
	const struct result *of = context;
	const struct hawser_net_waves *waves = &of->waves;
	size_t probe = (row*(size_t)waves->probes + (size_t)(k/EACH_PROBE))*3 + (size_t)(k%3), cable;

	(void)parent;
	if (k < EACH_PROBE*of->probes)
		return k%EACH_PROBE < 3 ? waves->x[probe] : waves->phase[probe];
	k -= EACH_PROBE*of->probes;
	cable = 2*(row*(size_t)waves->cables + (size_t)(k/EACH_CABLE)) + (size_t)(k%2);
	return k%EACH_CABLE < 2 ? waves->T[cable] : waves->T_phase[cable];
}

static const struct hawser__vector waves_vector = {
	.shown = "PLACE_x", .count = numbers, .name = name, .number = number, .unit = unit};

/* Objects by name, of the columns that end in the same name. */
static void response_json(struct hawser__json *json, json_t *to, const void *of)
{
	const struct result *result = of;
	json_t *into = hawser__json_object(json, to, "response"), *list;

	for (int k = 0; k < numbers(result); k++) {
		char text[HAWSER__NAME_SIZE];

		name(text, sizeof text, result, k);
		list = hawser__json_array(json, into, text);
		for (int row = 0; row < result->waves.points; row++)
			hawser__json_number(json, list, NULL, number(result, NULL, (size_t)row, k));
	}
	into = hawser__json_object(json, to, "size");
	for (int p = 0; p < result->probes; p++)
		hawser__json_numbers(json, into, result->name[p], result->waves.size[p], 3, 1.0);
	into = hawser__json_object(json, to, "tension_size");
	for (int c = 0; c < result->waves.cables; c++)
		hawser__json_numbers(json, into, result->mesh.net.cable[c].name, result->waves.T_size[c], 2,
		                     1.0);
	into = hawser__json_object(json, to, "tension_mean");
	for (int c = 0; c < result->waves.cables; c++)
		hawser__json_numbers(json, into, result->mesh.net.cable[c].name,
		                     result->waves.T_mean + 2*c, 2, 1.0);
}

#define ROWS_OF(member) HAWSER__ALONG(struct result, waves.member)
#define ONE(member) HAWSER__IN(struct result, waves.member)
const struct hawser__field cli_waves_field[] = {
	{"omega", "Omega", "frequency of the waves", ROWS_OF(omega), .unit = HAWSER__RADIAN_S},
	{"spectrum", "S", "of a sea: spectrum of the elevation, m^2 s", ROWS_OF(spectrum), .when = SEA},
	{NULL, "", "per metre of the amplitude of a wave: displacements of nodes and middles of cables, "
	 "tensions at the ends of cables; phases: behind the crest at x = z = 0",
	 HAWSER__VECTOR_OF(waves_vector)},
	{"response", NULL, "the same, by the names of the columns without units",
	 HAWSER__CALLS(response_json), .from = HAWSER__IN_PARENT},
	{"height", NULL, "that the linear drag belongs to: of regular waves, or Hs", ONE(height),
	 .unit = HAWSER__METRE},
	{"touching", NULL, "contacts with obstacles, which stay", ONE(touching)},
	{"interrupted", NULL, "whether the run ended early",
	 HAWSER__FLAG_AT(struct result, waves.interrupted), .from = HAWSER__IN_PARENT},
	HAWSER__END,
};
static const struct hawser__list row_list = {
	.field = cli_waves_field, .count_at = offsetof(struct result, waves.points)};
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__ARRAYS_OF(row_list)},
	HAWSER__END,
};
#undef ONE
#define ONE(member) HAWSER__AT(struct result, waves.member)
static const struct hawser__field stats_field[] = {
	{"unknowns", NULL, "of the mesh", ONE(unknowns)},
	{"iterations", NULL, "for the linear drag", ONE(iterations)},
	{"change", NULL, "largest relative change of it in the last one", ONE(change)},
	HAWSER__END,
};

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_si_head(result->common, "frf", "linear response to waves", result,
	                   result->waves.spectrum ? SEA : 0u);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_net_waves *waves = &result->waves;
	const char *what = waves->spectrum ? "standard deviation" : "largest amplitude";

	hawser__table_comment(table, "per metre of the amplitude of a wave; linear drag for %s = %g m, "
	                      "to %.1e in %d iterations", waves->spectrum ? "Hs" : "waves of height",
	                      waves->height, waves->change, waves->iterations);
	if (!waves->spectrum)
		hawser__table_comment(table, "--nonlinear: the response of a model with the whole force of the "
		                      "water");
	if (waves->touching)
		hawser__table_comment(table, "%d nodes touch obstacles, and go on touching them",
		                      waves->touching);
	for (int p = 0; p < result->probes; p++)
		hawser__table_comment(table, "%s: %s (%.6g, %.6g, %.6g) m", result->name[p], what,
		                      waves->size[p][0], waves->size[p][1], waves->size[p][2]);
	for (int c = 0; c < waves->cables; c++)
		hawser__table_comment(table, "%s: tensions %.6g and %.6g N at its ends, %s %.6g and %.6g N",
		                      result->mesh.net.cable[c].name, waves->T_mean[2*c],
		                      waves->T_mean[2*c + 1], what, waves->T_size[c][0],
		                      waves->T_size[c][1]);
	cli_mesh_comment(table, &result->mesh);
	if (waves->interrupted)
		hawser__table_comment(table, "interrupted after %d frequencies", waves->points);
}

/* The largest of a curve. */
static double highest(const double *value, int stride, int rows)
{
	double most = 0.0;

	for (int i = 0; i < rows; i++)
		most = fmax(most, value[i*stride]);
	return most;
}

/* Add a curve with its label, text of the scene; NULL: as the curves before it are called. */
static void add_curve(struct hawser__motions *shown, int panel, int colour, const double *value,
                      char label[LABEL], const char *text)
{
	struct hawser__motion_panel *to = &shown->panel[panel];
	FILE *stream = text ? fmemopen(label, LABEL, "w") : NULL;

	*label = '\0';
	if (stream) {
		hawser__picture_literal(stream, text, 0);
		fclose(stream);
	}
	if (to->curves < HAWSER__MOTION_CURVES)
		to->curve[to->curves++] = (struct hawser__motion_curve){label, colour, value};
}

/* The picture says on what the response depends. */
static struct hawser__axis frequency_axis(const struct hawser_net_waves *waves)
{
	char text[LABEL];

	snprintf(text, sizeof text, "Frequency of the waves {/Symbol W}%s",
	         waves->touching ? ", contacts stay" : "");
	return hawser__axis_of(text, "rad/s", 0.0);
}

/* Displacements, without those below a thousandth of the largest, and tensions at the upper ends of
 * cables; of a sea, their spectra below. */
static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;
	const struct hawser_net_waves *waves = &result->waves;
	const int points = waves->points, cables = waves->cables < DRAWN ? waves->cables : DRAWN;
	const double most = highest(waves->x, 1, 3*points*waves->probes);
	double *spectrum = calloc((size_t)points*(size_t)(cables + 1), sizeof *spectrum);
	char label[3*DRAWN][LABEL];
	struct hawser__motions shown = {
		points, waves->spectrum ? 3 : 2, waves->omega,
		frequency_axis(waves), {
		{hawser__axis_of("Motion", "m/m", 0.0), 3*waves->probes, 0, {{0}}},
		{hawser__axis_of("Tension", "N/m", highest(waves->T, 1, 2*points*waves->cables)),
		 2*waves->cables, 0, {{0}}},
		{hawser__axis_of("Spectrum", "kN^2 s", 0.0), 1, 0, {{0}}}}};
	enum hawser_status status;
	int colour = 0;

	if (!spectrum)
		return hawser__no_memory(report, "picture");
	for (int k = 0; k < 3*result->probes && colour < DRAWN; k++) {
		char text[LABEL];

		snprintf(text, sizeof text, "%s %c", result->name[k/3], "xyz"[k%3]);
		if (highest(&waves->x[k], 3*waves->probes, points) > 1e-3*most) {
			add_curve(&shown, 0, colour + 1, &waves->x[k], label[colour], text);
			colour++;
		}
	}
	for (int c = 0; c < cables; c++) {
		int end = waves->T_mean[2*c + 1] > waves->T_mean[2*c];

		for (int i = 0; i < points && waves->spectrum; i++) {
			double T = waves->T[2*(i*waves->cables + c) + end];

			spectrum[c*points + i] = 1e-6*T*T*waves->spectrum[i];
		}
		add_curve(&shown, 1, colour + c + 1, &waves->T[2*c + end], label[DRAWN + c],
		          result->mesh.net.cable[c].name);
		add_curve(&shown, 2, colour + c + 1, &spectrum[c*points], label[2*DRAWN + c], NULL);
	}
	status = hawser__plot_motions(path, &shown, report);
	free(spectrum);
	return status;
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &row_list,
                                           .fields = result_field, .stats = stats_field,
                                           .draw = draw};

/* The mean of the drag of a current and waves, which is more than that of the current. */
static void warn_mean(const struct hawser_water *water)
{
	double most = 0.0;

	for (int i = 0; i < water->levels; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(water->current[i].u[k]));
	if (most > 0.0)
		cli_warn("this response is about the equilibrium in the current alone, and the mean drag of a "
		         "current with waves is larger: of mean places and tensions, use hawser integrate");
}

/* The end of a cable that waves may make slack, for which linear equations do not hold. */
static void warn_slack(const struct result *result)
{
	const struct hawser_net_waves *waves = &result->waves;
	double factor = waves->spectrum ? SIGMAS : 1.0, worst = 0.0;
	char text[CLI_WARNING_SIZE];
	int at = 0;

	for (int k = 0; k < 2*waves->cables; k++) {
		double part = factor*waves->T_size[k/2][k%2]/waves->T_mean[k];

		if (waves->T_mean[k] > 0.0 && part > worst) {
			worst = part;
			at = k;
		}
	}
	if (worst <= 1.0)
		return;
	snprintf(text, sizeof text, "cable %s may become slack: its tension of %.4g N at the end '%s' "
	         "varies by %.4g N%s, and the response to waves is linear: use hawser integrate",
	         result->mesh.net.cable[at/2].name, waves->T_mean[at], at%2 ? "to" : "from",
	         waves->T_size[at/2][at%2], waves->spectrum ? " (standard deviation)" : "");
	cli_warn(text);
}

/* Contacts that waves may open or close: the equations of a linear response keep them. */
static void warn_contacts(const struct hawser_net_waves *waves)
{
	char text[CLI_WARNING_SIZE];

	if (!waves->touching)
		return;
	snprintf(text, sizeof text, "this response is linear: %d nodes touch obstacles and go on touching "
	         "them, and no other node comes to touch one: use hawser integrate where waves lift or "
	         "drop a cable", waves->touching);
	cli_warn(text);
}

/* Options of curves are refused. */
static enum hawser_status check(const struct cli_common *common, struct hawser_report *report)
{
	static const char *const curve[] = {
		"at", "start", "continue", "from-label", "switch", "period", "tori", "over", "Omega", "sweep",
		"backbone", "branches", "method", "segments", "modes", "peaks", "certificate", "step"};

	for (int i = 0; i < common->givens; i++)
		for (size_t k = 0; k < sizeof curve/sizeof *curve; k++)
			if (!strcmp(common->given[i]->name, curve[k]))
				return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf", "--%s is for curves, and the "
				                    "response to the waves of %s is linear: give --from, --to and "
				                    "--max-points, or --nonlinear", curve[k], cli_input_name(common));
	return cli_outputs_check(common, report);
}

enum hawser_status cli_waves_response(const struct cli_common *common, const char *from, const char *to,
                                      int points, struct hawser_report *report)
{
	struct result *result = calloc(1, sizeof *result);
	struct cli_watch watch = {{.quiet = common->quiet}, "frf"};
	struct hawser_net_waves_options options = {
		.points = points > 0 ? points : POINTS, .progress = {cli_watch, &watch}};
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "frf");
	result->common = common;
	status = check(common, report);
	if (!status)
		status = cli_mesh_open(&result->mesh.net, common, report);
	if (!status)
		probes(result);
	options.probe = result->probe;
	options.probes = result->probes;
	if (!status)
		status = cli_quantity(&options.from, from, "rad/s", CLI_ABOVE_ZERO, "frf", "from", report);
	if (!status)
		status = cli_quantity(&options.to, to, "rad/s", CLI_ABOVE_ZERO, "frf", "to", report);
	if (!status)
		status = hawser_net_waves_solve(&result->waves, &result->mesh.net, &options, report);
	cli_progress_end(&watch.progress);
	if (!status && result->waves.points == 0)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf", "interrupted before the first "
		                      "frequency");
	if (!status)
		status = hawser_net_mesh_error(&result->mesh.error, &result->mesh.net, NULL, report);
	if (!status) {
		warn_mean(&result->mesh.net.water);
		warn_slack(result);
		warn_contacts(&result->waves);
	}
	if (!status)
		status = cli_show(common, &showing, result, report);
	hawser_net_waves_clear(&result->waves);
	hawser_net_clear(&result->mesh.net);
	free(result);
	return status;
}
