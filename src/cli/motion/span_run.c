/* cli/motion/span_run.c - see integrate_span.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/motion/integrate_span.h"
#include "core/report.h"

static const double most_rows = 1e7; /* as many as hawser_net_integrate keeps */

int cli_driven(const struct hawser_scene *scene)
{
	int any = scene->load.present || scene->loads > 0;

	for (int i = 0; i < 6; i++)
		any |= scene->support[i/3].present && scene->support[i/3].motion[i % 3] != 0.0;
	return any;
}

static enum hawser_status times(struct cli_span_run *run, const struct cli_span_texts *texts,
                                const char *command, struct hawser_report *report)
{
	const struct cli_model *model = &run->model;
	const double unit = model->rom.time, period = run->period/unit;
	enum hawser_status status = cli_time(&run->until, texts->until, "until", period, model, report);

	if (!status)
		status = cli_time(&run->every, texts->every, "every", period, model, report);
	if (!status && texts->after)
		status = cli_time(&run->after, texts->after, "after", period, model, report);
	if (!status && texts->step && strcmp(texts->step, "auto") == 0)
		run->step = -1.0;
	else if (!status && texts->step)
		status = cli_time(&run->step, texts->step, "step", period, model, report);
	run->until *= unit;
	run->every *= unit;
	run->after *= unit;
	run->step *= run->step > 0.0 ? unit : 1.0;
	if (!status && run->until/run->every > most_rows)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                      "--until %s --every %s makes %.3g rows: choose a longer interval",
		                      texts->until, texts->every, run->until/run->every);
	if (!status && run->after >= run->until)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                      "--after %s is not before the end of the run, --until %s", texts->after,
		                      texts->until);
	return status;
}

/* Whether the ends already move when the run begins, which jerks the cable. */
static void look(struct cli_span_run *run)
{
	double most = 0.0;

	for (int end = 0; end < 2; end++) {
		const double *x = run->model.scene.support[end].motion;
		double size2 = x[0]*x[0] + x[1]*x[1] + x[2]*x[2];

		if (run->model.scene.support[end].present)
			most = fmax(most, sqrt(size2)*run->model.scene.support[end].harmonic*run->Omega*
			                  fabs(sin(run->model.scene.support[end].phase)));
	}
	if (most > 0.0)
		snprintf(run->warning, sizeof run->warning, "motion: at t = 0 the ends already move, with "
		         "%.4g m/s, and the cable hangs still: they jerk it, which sends waves along it; a "
		         "phase of 0 or 180 degrees does not", most);
}

enum hawser_status cli_span_run(struct cli_span_run *run, const struct cli_common *common,
                                const struct cli_span_texts *texts, const char *command,
                                struct hawser_report *report)
{
	struct cli_model *model = &run->model;
	enum hawser_status status = cli_model_or_scene(model, common, 0, report);
	const struct hawser_scene *scene = &model->scene;
	int forced;

	if (!status && !model->has_scene)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                      "%s is no scene of a span: a mesh of cable elements is made of "
		                      "one, give that", common->input);
	if (!status && scene->beam.form != HAWSER_BEAM_NONE)
		status = hawser__fail(report, HAWSER_ERR_SCENE, command,
		                      "%s is a scene of a beam: that is for hawser beam", scene->name);
	if (!status)
		status = hawser_statics_scene(&model->statics, scene, report);
	if (!status)
		status = cli_choice_prepare(model, report);
	if (status)
		return status;
	forced = cli_driven(scene);
	if (forced && !texts->omega)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                    "the span is forced: give the frequency with --Omega, such as --Omega "
		                    "0.9w1");
	if (!forced && texts->omega)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                    "--Omega %s: the scene has neither a load nor moving ends: add a section "
		                    "load, or leave --Omega out", texts->omega);
	if (forced)
		status = cli_frequency(&run->Omega, texts->omega, "Omega", model, report);
	run->Omega /= model->rom.time;
	run->period = 2.0*M_PI/(forced ? run->Omega : model->natural[0]/model->rom.time);
	look(run);
	return status ? status : times(run, texts, command, report);
}
