/* cli/beam/cmd_beam.c - hawser beam: a beam or string that travels along itself, its eigenvalues, safe
 * speeds, stability boundaries and motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/beam/beam_result.h"
#include "cli/frame/view.h"
#include "core/report.h"

#define PAST 1.2 /* of a sweep without an end, times the limit speed; chosen */

struct settings {
	struct cli_common common;
	const char *from, *to, *vary, *method, *boundary;
	const char *until, *every, *initial, *integrator;
	double x, tolerance;
	int points, n, size, bifurcation, coordinates;
};
static const struct settings defaults = {.method = "legendre", .points = 100, .n = 6, .x = 0.5,
	.integrator = "adams", .coordinates = 12};

static const struct cli_option options[] = {
	CLI_TEXT_WITH(from, "VALUE",
	              "first speed of a sweep, or first value of the boundary's key (0)",
	              .needs = "to"),
	CLI_TEXT_OPTION(to, "VALUE", "last speed of a sweep (with a picture 1.2 v_crit), or last value of "
	                "the boundary's key"),
	{"points", 0, "N", "samples of a sweep, before refinement (100)", CLI_COUNT(points)},
	{"modes", 'n', "N", "number of modes, counted from the lowest (6)", CLI_INTEGER(n), .most = 100},
	CLI_TEXT_WITH(boundary, "KEY", "compute v_crit over this key of the scene",
	              .needs = "to"),
	CLI_TEXT_OPTION(vary, "KEY=A,B", "repeat for up to eight values of a key of the scene"),
	CLI_HEADING("Boundary"),
	{"bifurcation", 0, "", "with --boundary: compute v_bif too", CLI_FLAG(bifurcation),
	 .needs = "boundary"},
	CLI_HEADING("Free motion"),
	CLI_TEXT_WITH(until, "TIME", "integrate the free motion up to this time",
	              .excludes = "to"),
	CLI_TEXT_WITH(every, "TIME", "interval between output rows (a 500th of the duration)",
	              .needs = "until"),
	CLI_TEXT_WITH(initial, "FILE",
	              "initial shape: lines of x, y and optionally dy/dt (0.01 sin(pi x))",
	              .needs = "until"),
	{"x", 0, "NUMBER", "place of the reported deflection, as a part of the length (0.5)",
	 CLI_POSITIVE(x), .needs = "until"},
	{"coordinates", 0, "N", "modes at rest that serve as coordinates of the motion (12)",
	 CLI_INTEGER(coordinates), .needs = "until"},
	CLI_TEXT_WITH(integrator, "NAME", "of the motion: adams, gauss, radau or bdf (adams)",
	              .needs = "until"),
	CLI_TOLERANCE_OPTION("relative tolerance of the integrator (1e-11)"),
	CLI_HEADING("Discretisation"),
	CLI_TEXT_OPTION(method, "NAME", "discretisation: legendre, sine or hermite (legendre)"),
	{"basis", 0, "N", "number of functions or elements (as many as the modes need)",
	 CLI_INTEGER(size)},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Prints the eigenvalues at the scene's speed, the lowest speed at which a mode grows (v_crit, also",
	"for the first mode alone) and the lowest at which the first frequency is 0 (v_bif). --to sweeps",
	"the speed and locates every change of stability. --boundary computes v_crit as a curve over a key",
	"of the scene, such as beam.rho. --until integrates the free motion, with its energy.",
	NULL,
};

/* --- options --- */

static enum hawser_status choose_method(const struct hawser_beam_method **method, const char *name,
                                        struct hawser_report *report)
{
	const char *words[8];
	int count = 0, k;
	enum hawser_status status;

	for (; hawser_beam_method(count); count++)
		words[count] = hawser_beam_method(count)->name;
	status = cli_choose(&k, "beam", "method", name, words, count, report);
	*method = hawser_beam_method(status ? 0 : k);
	return status;
}

static enum hawser_status number(double *value, const char *text, const char *option,
                                 const char *unit, struct hawser_report *report)
{
	return cli_quantity(value, text, unit, CLI_ANY, "beam", option, report);
}

/* One value of --vary, up to the comma at `end`. */
static enum hawser_status add_variant(struct cli_beam_result *result, const char *begin,
                                      const char *end, struct hawser_report *report)
{
	struct cli_beam_variant *v = &result->variant[result->variants];
	char text[64];
	enum hawser_status status;

	if (result->variants == CLI_BEAM_VARIANTS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam", "--vary: at most %d values",
		                    CLI_BEAM_VARIANTS);
	snprintf(text, sizeof text, "%.*s", (int)(end - begin), begin);
	status = number(&v->value, text, "vary", cli_key_unit(result->vary), report);
	v->scene = result->scene;
	if (!status)
		status = hawser_scene_set(&v->scene, result->vary, v->value, report);
	result->variants += !status;
	return status;
}

/* The scenes of the variants; *key holds the name, and the caller frees it. */
static enum hawser_status read_variants(struct cli_beam_result *result, char **key, const char *vary,
                                        struct hawser_report *report)
{
	const char *equals = vary ? strchr(vary, '=') : NULL;
	enum hawser_status status = HAWSER_OK;

	result->variants = 0;
	if (!vary) {
		result->variant[result->variants++].scene = result->scene;
		return HAWSER_OK;
	}
	if (!equals || equals == vary || !equals[1])
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                    "--vary %s: write KEY=A,B, such as beam.rho=0,10", vary);
	*key = strndup(vary, (size_t)(equals - vary));
	if (!*key)
		return hawser__no_memory(report, "beam");
	result->vary = *key;
	for (const char *at = equals + 1; !status; ) {
		size_t length = strcspn(at, ",");

		status = add_variant(result, at, at + length, report);
		if (!at[length])
			break;
		at += length + 1;
	}
	return status;
}

static enum hawser_status load(struct cli_beam_result *result, const struct settings *settings,
                               struct hawser_report *report)
{
	const struct cli_common *common = &settings->common;
	enum hawser_status status = choose_method(&result->method, settings->method, report);

	if (!status)
		status = cli_outputs_check(common, report);
	if (!status)
		status = cli_read_scene(&result->scene, common, report);
	if (!status)
		cli_warn_doubts(&result->scene);
	result->n = settings->n;
	result->boundary = settings->boundary;
	if (settings->until)
		result->kind = CLI_BEAM_MOTION;
	else
		result->kind = settings->boundary ? CLI_BEAM_BOUNDARY
		        : settings->to || common->plot || common->gp ? CLI_BEAM_SWEEP : CLI_BEAM_EIGENVALUES;
	return status;
}

/* --- work --- */

/* A larger tolerance for the methods that converge slowly. */
static double tolerance_of(const struct hawser_beam_method *method)
{
	return strcmp(method->name, "legendre") == 0 ? 1e-11 : 1e-6;
}

static enum hawser_status discretise(struct cli_beam_variant *v, const struct cli_beam_result *result,
                                     int size, struct hawser_report *report)
{
	/* with strong drag, waves shorter than all these modes become unstable at the highest speeds */
	double drag = v->beam.theta > 0.0 ? v->beam.drag/sqrt(v->beam.theta) : 0.0;
	int modes = result->n + (int)fmin(60.0, 0.15*pow(drag, 0.75));
	enum hawser_status status = hawser_beam_size(&v->size, &v->error, result->method, &v->beam, modes,
	                                             tolerance_of(result->method), report);

	if (size > 0 || (status == HAWSER_ERR_CONVERGENCE && v->error < 1e-3))
		status = HAWSER_OK; /* the error is stated in the result */
	if (size > 0)
		v->size = size;
	if (!status)
		status = result->method->fill(&v->integrals, v->beam.ends, v->size, report);
	return status;
}

static enum hawser_status eigenvalues(struct cli_beam_variant *v, int n, struct hawser_report *report)
{
	v->eigenvalue = malloc((size_t)n*sizeof *v->eigenvalue);
	if (!v->eigenvalue)
		return hawser__no_memory(report, "beam");
	return hawser_beam_eigenvalues(v->eigenvalue, NULL, &v->found, &v->integrals, &v->beam, n, report);
}

/* Where a sweep ends that was given no end: beyond the limit speed, or that of the scene. */
static double last_speed(const struct cli_beam_variant *v)
{
	double to = isfinite(v->limits.v_crit) ? PAST*v->limits.v_crit : v->limits.searched;

	return fabs(v->beam.speed) > fabs(to) ? v->beam.speed : to;
}

static enum hawser_status sweep(struct cli_beam_variant *v, const struct cli_beam_result *result,
                                const struct settings *settings, struct hawser_report *report)
{
	struct hawser_beam_sweep_options choice = {.points = settings->points, .branches = result->n};
	const char *unit = v->beam.time > 0.0 ? "m/s" : "1";
	enum hawser_status status = number(&choice.to, settings->to, "to", unit, report);

	if (!status)
		status = number(&choice.from, settings->from, "from", unit, report);
	choice.from /= cli_beam_per_speed(&v->beam);
	choice.to = settings->to ? choice.to/cli_beam_per_speed(&v->beam) : last_speed(v);
	return status ? status : hawser_beam_sweep(&v->sweep, &v->integrals, &v->beam, &choice, report);
}

static enum hawser_status boundary(struct cli_beam_variant *v, const struct cli_beam_result *result,
                                   const struct settings *settings, struct hawser_report *report)
{
	struct hawser_beam_scene_key key = {&v->scene, settings->boundary};
	const struct hawser_beam_family family = {hawser_beam_scene_family, &key};
	struct hawser_beam_boundary_options choice = {.modes = result->n};
	const char *unit = cli_key_unit(settings->boundary);
	enum hawser_status status = number(&choice.to, settings->to, "to", unit, report);
	double unused;

	if (!status)
		status = number(&choice.from, settings->from, "from", unit, report);
	if (!status)
		status = hawser_scene_get(&v->scene, &unused, settings->boundary, report);
	for (int turn = 0; !status && turn <= settings->bifurcation; turn++) {
		choice.bifurcation = turn;
		status = hawser_beam_boundary(&v->boundary[turn], &v->integrals, &family, &choice, report);
	}
	return status;
}

static enum hawser_status motion(struct cli_beam_variant *v, const struct settings *settings,
                                 const struct cli_beam_result *result, struct hawser_report *report)
{
	struct hawser_beam_motion_options choice = {.x = settings->x, .modes = settings->coordinates,
		.method = settings->integrator, .rtol = settings->tolerance};
	int dimensional = v->beam.time > 0.0;
	const char *unit = dimensional ? "s" : "1";
	double *shape = NULL, scale = dimensional ? v->beam.time : 1.0;
	enum hawser_status status = number(&choice.until, settings->until, "until", unit, report);

	if (!status && settings->every)
		status = number(&choice.every, settings->every, "every", unit, report);
	else
		choice.every = choice.until/500.0;
	choice.until /= scale;
	choice.every /= scale;
	if (!status && settings->initial)
		status = cli_beam_shape(&shape, &choice, settings->initial, &v->beam, report);
	if (!status)
		status = hawser_beam_motion(&v->motion, result->method, v->size, &v->beam, &choice, report);
	free(shape);
	return status;
}

static enum hawser_status compute(struct cli_beam_variant *v, struct cli_beam_result *result,
                                  const struct settings *settings, struct hawser_report *report)
{
	enum hawser_status status = hawser_beam_scene(&v->beam, &v->scene, report);

	if (!status)
		status = discretise(v, result, settings->size, report);
	if (!status)
		status = eigenvalues(v, result->n, report);
	if (!status)
		status = hawser_beam_limits(&v->limits, &v->integrals, &v->beam, result->n, report);
	if (!status && result->kind == CLI_BEAM_SWEEP)
		status = sweep(v, result, settings, report);
	if (!status && result->kind == CLI_BEAM_MOTION)
		status = motion(v, settings, result, report);
	if (!status && result->kind == CLI_BEAM_BOUNDARY)
		status = boundary(v, result, settings, report);
	if (!status && cli_beam_slack(result->warning, sizeof result->warning, &v->beam))
		cli_warn(result->warning);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_beam_result *result = calloc(1, sizeof *result);
	enum hawser_status status;
	char *key = NULL;

	if (!result)
		return hawser__no_memory(report, "beam");
	result->common = &settings->common;
	status = load(result, settings, report);
	if (!status)
		status = read_variants(result, &key, settings->vary, report);
	for (int i = 0; !status && i < result->variants; i++)
		status = compute(&result->variant[i], result, settings, report);
	if (!status)
		status = cli_show(&settings->common, &cli_beam_showing, result, report);
	for (int i = 0; i < CLI_BEAM_VARIANTS; i++) {
		hawser_beam_integrals_clear(&result->variant[i].integrals);
		hawser_beam_sweep_clear(&result->variant[i].sweep);
		hawser_beam_motion_clear(&result->variant[i].motion);
		hawser_beam_boundary_clear(&result->variant[i].boundary[0]);
		hawser_beam_boundary_clear(&result->variant[i].boundary[1]);
		free(result->variant[i].eigenvalue);
	}
	hawser_scene_clear(&result->scene);
	free(result);
	free(key);
	return status;
}

const struct cli_command cli_beam = {
	"beam", "SCENE", "Travelling beam or string: eigenvalues, safe speeds, stability, motion", notes,
	options, &defaults, sizeof(struct settings), 1, run, cli_beam_listing,
	.takes = CLI_BEAM,
};
