/* cli/tools/cmd_check.c - hawser check: what is wrong with a scene, or what it is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/beam/beam_result.h"
#include "cli/frame/progress.h"
#include "cli/plan/plan_result.h"
#include "cli/frame/kinds.h"

static const struct cli_option options[] = {
	CLI_SET_OPTION,
	CLI_HELP_OPTION,
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"Reads a scene of any kind as the other commands do: its first error, with file, line and column,",
	"and status 1; or the kind of the scene, what it has, and the commands that take it. Of a span its",
	"equilibrium and modes are computed too, to say what a model of it contains, and why.",
	NULL,
};

static void print_good(const struct cli_common *common, int index)
{
	printf("%s%s:%s %s, %swithout errors%s\n", cli_colour(stdout, CLI_PLACE), cli_input_name(common),
	       cli_colour(stdout, CLI_PLAIN), cli_kind_record(index)->one, cli_colour(stdout, CLI_GOOD),
	       cli_colour(stdout, CLI_PLAIN));
}

/* What models of the motions of a span contain. The scene may be of statics alone. */
static void print_models(const struct cli_common *common)
{
	struct hawser_report report = {0};
	struct cli_model model = {0};
	struct cli_plan_result result = {.common = common, .model = &model};
	enum hawser_status status = cli_model_load(&model, common, 0, &report);
	double from, to;

	if (!status)
		status = cli_range(&from, &to, NULL, NULL, "check", &model, &report);
	if (!status)
		status = hawser_plan_make(&result.plan, &model.statics, &model.scene, NULL, 0, from, to,
		                          &report);
	if (status)
		printf("  %sno model of its motions:%s %s\n", cli_colour(stdout, CLI_WARNING),
		       cli_colour(stdout, CLI_PLAIN), report.message);
	else
		cli_plan_print_decisions(stdout, &result);
	hawser_plan_clear(&result.plan);
	cli_model_clear(&model);
}

static enum hawser_status check_cable(const struct cli_common *common,
                                      const struct hawser_scene *scene, struct hawser_report *report)
{
	const int kind = scene->travel.present ? CLI_NUMBER_TRAVELLING : CLI_NUMBER_CABLE;
	struct hawser_statics statics;
	enum hawser_status status = hawser_statics_scene(&statics, scene, report);

	if (status)
		return status;
	cli_warn_wake(scene, &statics);
	print_good(common, kind);
	printf("  H: %.6g N, sag: %.6g m, unstretched length: %.6g m\n", statics.H, statics.sag,
	       statics.length0);
	print_models(common);
	cli_kind_print(stdout, kind, cli_is_forced(scene));
	return HAWSER_OK;
}

static enum hawser_status check_beam(const struct cli_common *common, const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	struct hawser_beam beam;
	enum hawser_status status = hawser_beam_scene(&beam, scene, report);

	if (status)
		return status;
	cli_warn_doubts(scene);
	print_good(common, CLI_NUMBER_BEAM);
	cli_beam_print_scales(stdout, scene, &beam);
	cli_kind_print(stdout, CLI_NUMBER_BEAM, 1);
	return HAWSER_OK;
}

static enum hawser_status check_span(const struct cli_common *common, struct hawser_report *report)
{
	struct hawser_scene scene;
	enum hawser_status status = cli_read_scene(&scene, common, report);

	if (status)
		return status;
	status = scene.beam.form ? check_beam(common, &scene, report)
	                         : check_cable(common, &scene, report);
	hawser_scene_clear(&scene);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct cli_common *common = context;
	const struct cli_kind_record *kind;
	enum hawser_status status;
	char text[CLI_SCENE_FACTS];
	int forced = 1;

	for (int i = 0; (kind = cli_kind_record(i)); i++) {
		if (!kind->look || kind->kind != cli_kind(common))
			continue;
		status = kind->look(text, &forced, common, report);
		if (status)
			return status;
		print_good(common, i);
		fputs(text, stdout);
		cli_kind_print(stdout, i, forced);
		return HAWSER_OK;
	}
	return check_span(common, report);
}

const struct cli_command cli_check = {
	"check", "SCENE", "What is wrong with a scene, or what it is", notes, options, NULL,
	sizeof(struct cli_common), 1, run, NULL,
	.takes = CLI_EVERY,
};
