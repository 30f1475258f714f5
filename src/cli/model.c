/* cli/model.c - from what the user named, a scene or a reduced-model file, to a model.
 *
 * Which of the two a file is, its content says: a reduced-model file is a JSON object with the key
 * "hawser_rom" (a scene may be JSON too, which is YAML).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/cli.h"
#include "core/report.h"

static const char marker[] = "\"hawser_rom\"";

static enum hawser_status refuse(struct hawser_report *report, const char *name, int error)
{
	return hawser__fail(report, HAWSER_ERR_IO, "model", "cannot read %s: %s",
	                    strcmp(name, "-") == 0 ? "standard input" : name, strerror(error));
}

/* First character that is not white space is {, and the marker follows anywhere. */
static int has_marker(FILE *stream)
{
	size_t matched = 0;
	int c;

	do
		c = getc(stream);
	while (c == ' ' || c == '\t' || c == '\n' || c == '\r');
	if (c != '{')
		return 0;
	while (matched < sizeof marker - 1 && (c = getc(stream)) != EOF)
		matched = c == marker[matched] ? matched + 1 : c == marker[0];
	return matched == sizeof marker - 1;
}

/* Replace standard input by a file with the same content, so that it can be read twice. */
static int spool_stdin(void)
{
	FILE *copy = tmpfile();
	char buffer[4096];
	size_t got;
	int done;

	if (!copy)
		return 0;
	while ((got = fread(buffer, 1, sizeof buffer, stdin)) > 0)
		if (fwrite(buffer, 1, got, copy) != got)
			break;
	done = !ferror(stdin) && !ferror(copy) && fflush(copy) == 0 &&
	       dup2(fileno(copy), STDIN_FILENO) >= 0;
	fclose(copy);
	clearerr(stdin);
	return done && fseek(stdin, 0, SEEK_SET) == 0;
}

static enum hawser_status is_model(int *model, const char *path, struct hawser_report *report)
{
	int standard = strcmp(path, "-") == 0;
	FILE *stream;

	if (standard && !spool_stdin())
		return refuse(report, path, errno);
	stream = standard ? stdin : fopen(path, "r");
	if (!stream)
		return refuse(report, path, errno);
	*model = has_marker(stream);
	if (standard)
		rewind(stdin);
	else
		fclose(stream);
	return HAWSER_OK;
}

enum hawser_status cli_scene_load(struct hawser_scene *scene, const struct cli_common *common,
                                  int n, struct hawser_report *report)
{
	const char *set[CLI_SETS + 1];
	char modes[32];
	int sets = common->sets;

	memcpy(set, common->set, (size_t)sets*sizeof *set);
	if (n > 0) {
		snprintf(modes, sizeof modes, "model.modes=%d", n);
		set[sets++] = modes;
	}
	return hawser_scene_open(scene, common->input, set, (size_t)sets, report);
}

struct hawser_modes_options cli_modes_options(const struct hawser_scene *scene)
{
	struct hawser_modes_options options = {0};

	options.n = scene->model.modes;
	options.basis = scene->model.basis;
	/* left to the method where the user has not asked for one */
	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	return options;
}

static enum hawser_status from_scene(struct cli_model *model, const struct cli_common *common,
                                     int n, struct hawser_report *report)
{
	enum hawser_status status = cli_scene_load(&model->scene, common, n, report);
	struct hawser_modes_options options;

	model->has_scene = !status;
	if (!status)
		status = hawser_statics_scene(&model->statics, &model->scene, report);
	options = cli_modes_options(&model->scene);
	if (!status)
		status = hawser_modes_solve(&model->modes, &model->statics, &options, report);
	if (!status)
		status = hawser_rom_build(&model->rom, &model->modes, &model->scene, report);
	return status;
}

static enum hawser_status from_file(struct cli_model *model, const struct cli_common *common,
                                    int n, struct hawser_report *report)
{
	if (common->sets > 0 || n > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
		                    "%s is a reduced-model file: %s applies to scenes only",
		                    common->input, common->sets > 0 ? "--set" : "--modes");
	return hawser_rom_open(&model->rom, common->input, report);
}

enum hawser_status cli_model_load(struct cli_model *model, const struct cli_common *common, int n,
                                  struct hawser_report *report)
{
	enum hawser_status status;
	int is_file = 0;

	memset(model, 0, sizeof *model);
	status = is_model(&is_file, common->input, report);
	if (!status)
		status = is_file ? from_file(model, common, n, report)
		                 : from_scene(model, common, n, report);
	if (!status) {
		model->natural = calloc((size_t)model->rom.n, sizeof *model->natural);
		status = model->natural ? cli_natural(model->natural, &model->naturals, &model->rom, report)
		                        : hawser__no_memory(report, "model");
	}
	if (status)
		cli_model_clear(model);
	return status;
}

void cli_model_clear(struct cli_model *model)
{
	if (!model)
		return;
	hawser_rom_clear(&model->rom);
	hawser_modes_clear(&model->modes);
	hawser_scene_clear(&model->scene);
	free(model->natural);
	memset(model, 0, sizeof *model);
}

double cli_per_length(const struct cli_model *model)
{
	return model->rom.scaled ? model->rom.length : 1.0;
}

double cli_per_omega(const struct cli_model *model)
{
	return model->rom.scaled ? 1.0/model->rom.time : 1.0;
}
