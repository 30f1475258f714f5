/* cli/motion/cmd_integrate.c - hawser integrate: the response in time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/exact.h"
#include "cli/motion/integrate_net.h"
#include "cli/motion/integrate_result.h"
#include "cli/motion/integrate_span.h"
#include "cli/model/label.h"
#include "cli/model/state.h"
#include "cli/model/made.h"
#include "cli/frame/progress.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *load, *motion, *omega, *omega_to, *until, *every, *after, *initial, *resume, *method;
	double rtol, atol;
	const char *model;
	int n, spectrum, partial, error, lyapunov, elements;
	struct cli_integrate_net net; /* of nets only */
};
static const struct settings defaults = {
	.until = "100T", .every = "0.01T", .rtol = 1e-10, .atol = 1e-13,
};

static const struct cli_option options[] = {
	{"Omega", 0, "FREQUENCY", "forcing frequency; required if there is a load",
	 CLI_TEXT_FOR(omega, CLI_MODELLED | CLI_NET)},
	{"until", 0, "TIME", "end of the run (100T)", CLI_TEXT(until)},
	{"every", 0, "TIME", "interval between output rows (0.01T)", CLI_TEXT(every)},
	{"modes", 'n', "N",
	 "number of modes (the scene's model.modes); of nets: a model in place of the mesh",
	 CLI_INTEGER_FOR(n, CLI_MODELLED | CLI_NET), .excludes = "model=fe"},
	{"initial", 0, "FILE",
	 "state, or FILE#LABEL of a response, to start from (rest)", CLI_TEXT(initial),
	 .excludes = "model=fe, continue"},
	{"method", 0, "NAME", "integrator: gauss, radau, adams, bdf or auto (auto)", CLI_TEXT(method)},
	CLI_HEADING("Load and ends"),
	{"Omega-to", 0, "FREQUENCY", "slow sweep: the frequency changes linearly to this one",
	 CLI_TEXT_FOR(omega_to, CLI_MODELLED), .needs = "Omega",
	 .excludes = "model=fe, continue, spectrum, after, lyapunov"},
	{"load", 0, "FILE", "table of the load over time, in place of the section load; of ropeways: "
	 "passing or drive", CLI_TEXT_FOR(load, CLI_MODELLED), .excludes = "model=fe"},
	{"motion", 0, "FILE", "table of the displacements of the ends over time",
	 CLI_TEXT_FOR(motion, CLI_MODELLED), .excludes = "model=fe"},
	CLI_HEADING("Length of the run"),
	{"after", 0, "TIME", "the rows begin at this time, when the transient has decayed (0)",
	 CLI_TEXT_FOR(after, CLI_MODELLED), .excludes = "model=fe"},
	{"continue", 0, "FILE", "continue the run whose JSON result this file is",
	 CLI_TEXT_FOR(resume, CLI_MODELLED), .excludes = "model=fe"},
	{"partial", 0, "", "write what was computed also if the run fails",
	 CLI_FLAG_FOR(partial, CLI_MODELLED), .excludes = "model=fe"},
	CLI_HEADING("Accuracy"),
	{"rtol", 0, "NUMBER", "relative tolerance (1e-10)", CLI_POSITIVE(rtol)},
	{"atol", 0, "NUMBER", "absolute tolerance, scaled (1e-13)",
	 CLI_POSITIVE_FOR(atol, CLI_MODELLED), .excludes = "model=fe"},
	{"error", 0, "", "estimate the error by a second run with other tolerances",
	 CLI_FLAG_FOR(error, CLI_MODELLED | CLI_NET), .excludes = "model=fe"},
	{"no-error", 0, "", "rods: without the two runs for the errors",
	 CLI_FLAG_FOR(net.skip_error, CLI_ROD)},
	{"step", 0, "TIME", "nets, rods and --model fe: longest step, or auto",
	 CLI_TEXT_FOR(net.step, CLI_MESHES | CLI_SPAN)},
	CLI_HEADING("Contents of results"),
	{"spectrum", 0, "", "write the spectrum to the table, and to JSON",
	 CLI_FLAG_FOR(spectrum, CLI_MODELLED), .excludes = "model=fe"},
	{"lyapunov", 0, "", "Lyapunov exponents of the motion after --after, with their errors",
	 CLI_FLAG_FOR(lyapunov, CLI_MODELLED), .excludes = "model=fe"},
	{"probe", 0, "NAMES", "nets: nodes, or cable:part (all free nodes); rods: start, end, lengths",
	 CLI_TEXT_FOR(net.probe, CLI_MESHES)},
	{"state", 0, "FILE", "nets, rods: write the last state, for --initial",
	 CLI_TEXT_FOR(net.state, CLI_MESHES)},
	{"vtk", 0, "STEM", "nets, rods: write STEM-00000.vtk and so on, one a row",
	 CLI_TEXT_FOR(net.vtk, CLI_MESHES)},
	{"animate", 0, "FILE.gif", "nets, rods: write an animation",
	 CLI_TEXT_FOR(net.animate, CLI_MESHES)},
	{"frames", 0, "N", "of the animation, at most (100)",
	 CLI_COUNT_FOR(net.frames, CLI_MESHES)},
	CLI_HEADING("Models of other kinds"),
	CLI_LIBRARY_OPTION,
	{"model", 0, "NAME", "rom, or fe: a mesh of cable elements (rom)",
	 CLI_TEXT_FOR(model, CLI_MODELLED), .words = "rom|fe"},
	{"elements", 0, "N", "elements of the mesh of --model fe (120)",
	 CLI_INTEGER_FOR(elements, CLI_SPAN), .needs = "model=fe"},
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple of a natural frequency, 0.6w1.",
	"TIME: a number (s), \"3 min\", or periods of the forcing, 50T (without forcing, of w1).",
	NULL,
};

/* More rows would not fit in memory as a table. */
static const double most_rows = 2e7;

/* The end of a sweep, and what does not go with it. */
static enum hawser_status sweep(struct hawser_integrate_options *choice,
                                const struct settings *settings, const struct cli_model *model,
                                struct hawser_report *report)
{
	if (model->has_scene && model->scene.travel.present &&
	    (model->scene.travel.fluctuation > 0.0 || model->scene.travel.braking > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                    "--Omega-to %s does not go with a travel speed that changes",
		                    settings->omega_to);
	return cli_frequency(&choice->omega_to, settings->omega_to, "Omega-to", model, report);
}

static int in_periods(const char *text)
{
	size_t length = text ? strlen(text) : 0;

	return length > 0 && text[length - 1] == 'T';
}

static enum hawser_status times(struct hawser_integrate_options *choice, double *period,
                                const struct settings *settings, const struct cli_model *model,
                                const struct cli_label *label, struct hawser_report *report)
{
	int counted = in_periods(settings->until) || in_periods(settings->every);
	enum hawser_status status = HAWSER_OK;

	choice->omega = label->omega;
	if (settings->omega)
		status = cli_frequency(&choice->omega, settings->omega, "Omega", model, report);
	else if (!label->state && ((model->rom.harmonics > 0 && !hawser_rom_autonomous(&model->rom)) ||
	                           model->automatic))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                      "the model is forced: give its frequency with --Omega, such as "
		                      "--Omega 0.9w1");
	else if (!(choice->omega > 0.0) && model->naturals == 0 && counted)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                      "the model has no natural frequency to set the unit of --until and "
		                      "--every: write plain times, without T, or give --Omega");
	if (!status && settings->omega_to)
		status = sweep(choice, settings, model, report);
	if (status)
		return status;
	*period = 2.0*M_PI/(choice->omega > 0.0 ? choice->omega
	                    : model->naturals > 0 ? model->natural[0] : 1.0);
	status = cli_time(&choice->until, settings->until, "until", *period, model, report);
	if (!status)
		status = cli_time(&choice->every, settings->every, "every", *period, model, report);
	if (!status && choice->until/choice->every > most_rows)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                      "--until %s --every %s makes %.3g rows: choose a longer interval",
		                      settings->until, settings->every, choice->until/choice->every);
	if (!(choice->omega > 0.0) && model->naturals == 0)
		*period = choice->until;
	return status;
}

/* Computes result->error by a second run; NULL if that was interrupted. */
static enum hawser_status look_again(struct cli_integrate_result *result,
                                     const struct hawser_trajectory *run,
                                     const struct hawser_rom *rom,
                                     const struct hawser_integrate_options *choice,
                                     struct hawser_report *report)
{
	enum hawser_status status;

	result->error = calloc((size_t)run->rows + 1, sizeof *result->error);
	if (!result->error)
		return hawser__no_memory(report, "integrate");
	status = hawser_integrate_error(result->error, run, rom, choice, report);
	if (!status && run->rows > 0 && isinf(result->error[run->rows - 1])) {
		free(result->error);
		result->error = NULL;
	}
	return status;
}

/* With modes: auto modes are chosen for this range of frequencies, over that of the forcing. */
static const double around[2] = {0.8, 1.25};

/* Ends of the range of the forcing. */
static double lowest(const struct hawser_integrate_options *choice)
{
	return choice->omega_to > 0.0 ? fmin(choice->omega, choice->omega_to) : choice->omega;
}

static double highest(const struct hawser_integrate_options *choice)
{
	return fmax(choice->omega, choice->omega_to);
}

/* The initial state, if the user gives one; last->state owns it. */
static enum hawser_status choose_start(struct hawser_integrate_options *choice,
                                       struct cli_last *last, const struct settings *settings,
                                       const struct cli_model *model, const struct cli_label *label,
                                       struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (settings->initial && !label->state)
		status = cli_state_open(&last->state, settings->initial, model, report);
	else if (settings->resume)
		status = cli_last_open(last, settings->resume, "integrate", model,
		                       &settings->common, report);
	choice->initial = label->state ? label->state : last->state;
	if (status || !settings->resume)
		return status;
	choice->begin = last->t;
	if (last->swept)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                    "--continue %s: that run is a sweep, and its phase of the forcing is not "
		                    "known; --initial starts from its last state anew", settings->resume);
	if (fabs(choice->omega - last->omega) > 1e-9*last->omega)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                    "--continue %s: that run has Omega = %.12g, and this one would have %.12g; "
		                    "--initial starts from its last state anew", settings->resume,
		                    last->omega*cli_per_omega(model), choice->omega*cli_per_omega(model));
	return HAWSER_OK;
}

/* With the exact energy, where the modes asked for are not good enough or fail (so_far: their status):
 * only a run from rest under the load of the scene, at one frequency. */
static enum hawser_status better(struct cli_integrate_result *result, struct cli_model *model,
                                 struct hawser_integrate_options *choice,
                                 const struct hawser_integrate_options *fresh, double **state,
                                 double after, const struct settings *settings,
                                 enum hawser_status so_far, struct hawser_report *report)
{
	struct hawser_integrate_options begin = *fresh;
	enum hawser_status status;

	if (settings->initial || settings->resume || settings->load || settings->motion ||
	    settings->omega_to || cli_interrupted() || !(fresh->omega > 0.0) ||
	    (so_far && so_far != HAWSER_ERR_CONVERGENCE))
		return so_far;
	if (!so_far && (status = cli_integrate_judge(result, report)))
		return status;
	if (!cli_exact_calls(model, so_far ? NULL : &result->model_error))
		return so_far;
	status = cli_integrate_exact(result, model, &begin, state, after, report);
	if (status || !model->exact.functions)
		return status ? status : so_far;
	*choice = begin;
	return HAWSER_OK;
}

static enum hawser_status solve(struct hawser_trajectory *run, struct cli_integrate_result *result,
                                struct cli_model *model, const struct settings *settings,
                                struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = settings->common.quiet}, "integrate"};
	struct hawser_integrate_options choice = {0}, fresh;
	struct cli_last last = {.state = NULL};
	double after = 0.0;
	struct cli_label label = {.state = NULL};
	enum hawser_status status = HAWSER_OK;
	char path[4096];

	if (settings->initial && cli_label_split(path, sizeof path, settings->initial))
		status = cli_label_open(&label, "initial", settings->initial, NULL, model, &settings->common,
		                        report);
	if (!status)
		status = times(&choice, &result->period, settings, model, &label, report);

	if (!status && model->automatic)
		status = cli_choice_build(model, around[0]*lowest(&choice), around[1]*highest(&choice),
		                          report);
	if (!status)
		status = cli_known(model, highest(&choice), report);
	if (!status)
		status = choose_start(&choice, &last, settings, model, &label, report);
	if (status) {
		cli_last_clear(&last);
		cli_label_clear(&label);
		return status;
	}
	choice.rtol = settings->rtol;
	choice.atol = settings->atol;
	choice.method = settings->method;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	result->rest = !settings->initial && !settings->resume && !settings->after;
	result->omega = choice.omega;
	result->every = choice.every;
	if (settings->after)
		status = cli_time(&after, settings->after, "after", result->period, model, report);
	fresh = choice;
	if (!status && settings->after)
		status = cli_integrate_settle(&last.state, &choice, after, &model->rom, report);
	result->forcing = choice;
	if (!status)
		status = hawser_integrate(run, &model->rom, &choice, report);
	status = better(result, model, &choice, &fresh, &last.state, after, settings, status, report);
	if (!status && settings->error && !run->interrupted)
		status = look_again(result, run, &model->rom, &choice, report);
	if (!status && settings->lyapunov && !run->interrupted)
		status = cli_integrate_exponents(result, !settings->after, &choice, report);
	cli_progress_end(&watch.progress);
	cli_last_clear(&last);
	cli_label_clear(&label);
	return status;
}

void cli_integrate_warn(struct cli_model *model, double omega,
                        const struct cli_integrate_result *result)
{
	char text[CLI_WARNING_SIZE];

	cli_known_warn(model, omega);
	cli_made_breaking_warn(model, omega);
	cli_fixed_warn(&result->model_error);
	cli_exact_warn(model);
	cli_range_warn(model, cli_range_reach(NULL, model, result->run.state, result->run.rows,
	                                      2*result->run.n));
	if (cli_integrate_slack(text, sizeof text, result))
		cli_caution("slack in parts", text);
	if (cli_integrate_moves(text, sizeof text, result))
		cli_warn(text);
	if (cli_integrate_wind(text, sizeof text, result))
		cli_warn(text);
}

static enum hawser_status write_result(struct cli_integrate_result *result, struct cli_model *model,
                                       struct hawser_report *report)
{
	enum hawser_status status = cli_integrate_fill(result, report);

	if (status)
		return status;
	cli_integrate_warn(model, result->omega, result);
	return cli_show(result->common, &cli_integrate_showing, result, report);
}

/* Whether it is of a net, and of its model. */
static int of_net(const struct settings *settings)
{
	return settings->n > 0 && cli_kind(&settings->common) == HAWSER_KIND_NET;
}

/* A kind whose motion is not that of a model. */
static enum hawser_status run_kind(const struct settings *settings, const struct cli_part *part,
                                   struct hawser_report *report)
{
	struct cli_integrate_net net = settings->net;

	if (settings->omega)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "--Omega %s is of a model of the "
		                    "net: give -n, too; the mesh has the frequencies of the scene",
		                    settings->omega);
	net.common = &settings->common;
	net.until = settings->until != defaults.until ? settings->until : NULL;
	net.every = settings->every != defaults.every ? settings->every : NULL;
	net.scheme = settings->method;
	net.initial = settings->initial;
	net.error = settings->error;
	net.tolerance = settings->rtol != defaults.rtol ? settings->rtol : 0.0;
	return part->run(&net, report);
}

/* --model fe; what is of reduced models does not go with it. */
static enum hawser_status run_span(const struct settings *settings, struct hawser_report *report)
{
	const struct cli_integrate_span span = {
		.texts = {.omega = settings->omega, .until = settings->until, .every = settings->every,
		          .step = settings->net.step},
		.scheme = settings->method, .elements = settings->elements,
		.tolerance = settings->rtol != defaults.rtol ? settings->rtol : 0.0};

	return cli_integrate_span(&settings->common, &span, report);
}

/* The load of a ropeway has a name. */
static struct settings with_lane(const struct settings *given)
{
	struct settings settings = *given;

	if (given->load && cli_kind(&given->common) == HAWSER_KIND_ROPEWAY) {
		settings.common.lane.load = given->load;
		settings.load = NULL;
	}
	return settings;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings own = with_lane(context), *settings = &own;
	const struct cli_integrate_net *net = &settings->net;
	struct hawser_report second = {0};
	struct cli_model model = {0};
	struct cli_integrate_result result = {.common = &settings->common, .model = &model,
	                                      .spectrum = settings->spectrum};
	const struct cli_output state = {"state", net->state};
	const struct cli_part *part = cli_part(&cli_integrate, &settings->common);
	enum hawser_status status = cli_outputs_check_with(&settings->common, &state, 1, report);

	if (!status)
		status = hawser__file_check(net->state, report);
	if (!status && part->run && !of_net(settings))
		return run_kind(settings, part, report);
	if (!status && settings->model && strcmp(settings->model, "fe") == 0)
		return run_span(settings, report);
	if (!status && net->step)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                      "--step is for the mesh of --model fe: give that");
	if (!status)
		status = cli_state_check("initial", settings->initial, &settings->common, report);
	if (!status)
		status = cli_state_check("load", settings->load, &settings->common, report);
	if (!status)
		status = cli_state_check("motion", settings->motion, &settings->common, report);
	if (!status)
		status = cli_state_check("continue", settings->resume, &settings->common, report);
	if (!status)
		status = cli_model_load(&model, &settings->common, settings->n, report);
	if (!status)
		status = cli_label_exact(&model, settings->initial ? settings->initial : settings->resume,
		                         report);
	if (!status && (settings->load || settings->motion))
		status = cli_load_history(&model, settings->load, settings->motion, report);
	if (!status && settings->load && settings->omega && model.rom.harmonics == 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                      "--load %s replaces the harmonic load: leave out --Omega",
		                      settings->load);
	if (!status)
		status = solve(&result.run, &result, &model, settings, report);
	if (!status)
		status = write_result(&result, &model, report);
	else if (settings->partial && result.run.rows > 1) {
		result.failed = 1;
		if (write_result(&result, &model, &second))
			cli_report_also(report, &second);
	}
	cli_integrate_free(&result);
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_integrate = {
	"integrate", "SCENE|MODEL", "Response in time, from rest or from a given state", notes, options,
	&defaults, sizeof(struct settings), 1, run, cli_integrate_listing,
	.takes = CLI_MODELS, .part = CLI_PART(integrate),
};
