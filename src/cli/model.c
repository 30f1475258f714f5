/* cli/model.c - read the scene or reduced-model file of the command line, and compute the model.
 *
 * The content decides whether a file is a scene or a reduced-model file: a reduced-model file is a
 * JSON object with the key "hawser_rom", or with "n" and "K" and without "cable" (a scene may also
 * be JSON, which is YAML). The keys are searched for without a JSON parser, so that a damaged model
 * file is reported as a model file. A file that is not a regular file can be read only once; it is
 * copied first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/kinds.h"
#include "cli/rom_ropeway.h"
#include "core/report.h"

/* Number of listed modes if the program chooses the modes. */
static const int listed = 12;

static enum hawser_status refuse(struct hawser_report *report, const char *name, int error)
{
	return hawser__fail(report, hawser__unreadable(error), "model", "cannot read %s: %s",
	                    strcmp(name, "-") == 0 ? "standard input" : name, strerror(error));
}

/* Skip a string of JSON after its opening quote; word gets its first characters, with escapes
 * unchanged. */
static void read_string(char *word, size_t size, FILE *stream)
{
	size_t length = 0;
	int c;

	while ((c = getc(stream)) != EOF && c != '"') {
		if (c == '\\')
			(void)getc(stream);
		if (length + 1 < size)
			word[length++] = (char)c;
	}
	word[length] = '\0';
}

static int skip_blanks(FILE *stream)
{
	int c;

	do
		c = getc(stream);
	while (c == ' ' || c == '\t' || c == '\n' || c == '\r');
	return c;
}

/* Decide by the keys of the outermost object. */
static int is_model(FILE *stream)
{
	int c = skip_blanks(stream), depth = 1, n = 0, K = 0;
	char word[16];

	if (c != '{')
		return 0;
	while (depth > 0 && (c = getc(stream)) != EOF) {
		depth += (c == '{' || c == '[') - (c == '}' || c == ']');
		if (c != '"')
			continue;
		read_string(word, sizeof word, stream);
		if (depth != 1 || (c = skip_blanks(stream)) != ':') {
			if (c != '"')
				ungetc(c, stream);
			continue;
		}
		if (strcmp(word, "hawser_rom") == 0 || strcmp(word, "cable") == 0)
			return *word == 'h';
		n |= strcmp(word, "n") == 0;
		K |= strcmp(word, "K") == 0;
	}
	return n && K;
}

/* A file with the same content that can be read twice, or NULL. */
static FILE *copy_of(FILE *stream)
{
	FILE *copy = tmpfile();
	char buffer[4096];
	size_t got;

	if (!copy)
		return NULL;
	while ((got = fread(buffer, 1, sizeof buffer, stream)) > 0)
		if (fwrite(buffer, 1, got, copy) != got)
			break;
	if (!ferror(stream) && !ferror(copy) && fseek(copy, 0, SEEK_SET) == 0)
		return copy;
	fclose(copy);
	return NULL;
}

enum hawser_status cli_hold_input(const char *path, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	FILE *copy;

	if (!path || strcmp(path, "-") != 0 || lseek(STDIN_FILENO, 0, SEEK_CUR) == 0)
		return HAWSER_OK;
	errno = 0;
	copy = copy_of(stdin);
	if (!copy)
		return refuse(report, path, errno ? errno : EIO);
	if (dup2(fileno(copy), STDIN_FILENO) < 0 || fseek(stdin, 0, SEEK_SET) != 0)
		status = refuse(report, path, errno);
	fclose(copy);
	clearerr(stdin);
	return status;
}

static enum hawser_status open_input(FILE **input, int *copied, const char *path,
                                     struct hawser_report *report)
{
	int standard = strcmp(path, "-") == 0;
	FILE *stream = standard ? stdin : fopen(path, "r");
	enum hawser_status status = HAWSER_OK;
	struct stat info;

	*input = stream;
	*copied = 0;
	if (!stream)
		return refuse(report, path, errno);
	if (!standard && fstat(fileno(stream), &info) == 0 && S_ISREG(info.st_mode))
		return HAWSER_OK;
	errno = 0;
	*input = copy_of(stream);
	*copied = 1;
	if (!*input)
		status = refuse(report, path, errno ? errno : EIO);
	if (!standard)
		fclose(stream);
	return status;
}

/* Read from `stream` or, if it is NULL, open the file by its name. */
static enum hawser_status load_scene(struct hawser_scene *scene, FILE *stream,
                                     const struct cli_common *common, int n,
                                     struct hawser_report *report)
{
	const char *name = cli_input_name(common);
	const char *set[CLI_SETS + 1];
	char modes[32];
	int sets = common->sets;
	enum hawser_status status;

	memcpy(set, common->set, (size_t)sets*sizeof *set);
	if (n > 0) {
		snprintf(modes, sizeof modes, "model.modes=%d", n);
		set[sets++] = modes;
	}
	status = stream ? hawser_scene_read(scene, stream, name, set, (size_t)sets, report)
	                : hawser_scene_open(scene, common->input, set, (size_t)sets, report);
	if (!status)
		cli_warn_doubts(scene);
	return status;
}

/* Only hawser beam and hawser map accept beams. */
static enum hawser_status refuse_beam(struct hawser_scene *scene, const struct cli_common *common,
                                      struct hawser_report *report)
{
	const char *name = cli_input_name(common);

	if (!scene->beam.form)
		return HAWSER_OK;
	hawser_scene_clear(scene);
	return hawser__fail(report, HAWSER_ERR_SCENE, "model",
	                    "%s is a scene of a beam: that is for hawser beam", name);
}

enum hawser_status cli_scene_load(struct hawser_scene *scene, const struct cli_common *common,
                                  int n, struct hawser_report *report)
{
	enum hawser_status status = load_scene(scene, NULL, common, n, report);

	return status ? status : refuse_beam(scene, common, report);
}

struct hawser_modes_options cli_modes_options(const struct hawser_scene *scene)
{
	struct hawser_modes_options options = {0};

	options.n = scene->model.modes == HAWSER_MODES_AUTO ? listed : scene->model.modes;
	options.basis = scene->model.basis;
	/* the method chooses the basis if the user gave none */
	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	return options;
}

/* The full-order model. */
static enum hawser_status from_basis(struct cli_model *model, int n, struct hawser_report *report)
{
	enum hawser_status status;

	if (n > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
		                    "--modes %d: the exact energy (model.energy) is on all functions "
		                    "of a basis: say how many a component with model.basis", n);
	status = hawser_rom_build_full(&model->rom, &model->statics, &model->scene,
	                               model->scene.model.basis, report);
	return status ? status : cli_basis_check(model, 0.0, report);
}

/* How much of a model is made from a scene. */
enum extent { NOTHING, ENTRIES, WHOLE };

static enum hawser_status from_scene(struct cli_model *model, FILE *stream,
                                     const struct cli_common *common, int n, enum extent extent,
                                     struct hawser_report *report)
{
	enum hawser_status status = load_scene(&model->scene, stream, common, n, report);
	struct hawser_modes_options options;

	if (!status && extent != NOTHING)
		status = refuse_beam(&model->scene, common, report);
	model->has_scene = !status;
	if (extent == NOTHING)
		return status;
	if (!status)
		status = hawser_statics_scene(&model->statics, &model->scene, report);
	if (!status && model->scene.model.modes == HAWSER_MODES_AUTO)
		return cli_choice_prepare(model, report);
	options = cli_modes_options(&model->scene);
	if (!status && model->scene.model.energy == HAWSER_ENERGY_EXACT)
		return from_basis(model, n, report);
	if (!status)
		status = hawser_modes_solve(&model->modes, &model->statics, &options, report);
	if (!status)
		status = extent == WHOLE || model->modes.n <= CLI_JUDGED
		         ? hawser_rom_build(&model->rom, &model->modes, &model->scene, report)
		         : hawser_rom_build_entries(&model->rom, &model->modes, &model->scene,
		                                    report);
	if (!status)
		status = cli_known(model, model->modes.mode[model->modes.n - 1].omega, report);
	return status;
}

/* Replace the name of the copy in a message by the name that the user gave. */
static void rename_input(struct hawser_report *report, const char *name)
{
	static const char stand_in[] = "<stdin>";
	char said[sizeof report->message];

	if (strcmp(name, "-") == 0 ||
	    strncmp(report->message, stand_in, sizeof stand_in - 1) != 0)
		return;
	memcpy(said, report->message, sizeof said);
	snprintf(report->message, sizeof report->message, "%s%s", name, said + sizeof stand_in - 1);
}

/* The library opens a model by its name, and "-" is a legal name: the copy replaces standard
 * input. */
static enum hawser_status from_copy(struct hawser_rom_source *source, FILE *copy, const char *name,
                                    struct hawser_report *report)
{
	int saved = dup(STDIN_FILENO);
	enum hawser_status status;

	if (dup2(fileno(copy), STDIN_FILENO) < 0 || fseek(stdin, 0, SEEK_SET) != 0)
		status = refuse(report, name, errno);
	else
		status = hawser_rom_source_open(source, "-", report);
	if (saved >= 0) {
		(void)dup2(saved, STDIN_FILENO);
		close(saved);
	}
	clearerr(stdin);
	return status;
}

/* The parameters of --set. */
static enum hawser_status set_parameters(struct hawser_rom_source *source,
                                         const struct cli_common *common, struct hawser_report *report)
{
	char name[32], names[160] = "none", *end;

	for (int i = 0, used = 0; i < source->parameters && used < (int)sizeof names; i++)
		used += snprintf(names + used, sizeof names - (size_t)used, "%s%s", i ? ", " : "",
		                 source->parameter[i].name);
	for (int i = 0; i < common->sets; i++) {
		const char *equals = strchr(common->set[i], '=');
		double value = strtod(equals + 1, &end);
		int known = 0;

		snprintf(name, sizeof name, "%.*s", (int)(equals - common->set[i]), common->set[i]);
		if (end == equals + 1 || *end || !isfinite(value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
			                    "--set %s: write NAME=NUMBER for a parameter of a model file",
			                    common->set[i]);
		hawser_rom_source_set(source, name, value, &known);
		if (!known)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
			                    "--set %s: %s has these parameters: %s", common->set[i],
			                    common->input, names);
	}
	return HAWSER_OK;
}

static enum hawser_status from_file(struct cli_model *model, FILE *copy,
                                    const struct cli_common *common, int n,
                                    struct hawser_report *report)
{
	enum hawser_status status;

	if (n > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
		                    "%s is a reduced-model file: --modes applies to scenes only",
		                    common->input);
	status = copy ? from_copy(&model->source, copy, common->input, report)
	              : hawser_rom_source_open(&model->source, common->input, report);
	if (!status)
		status = set_parameters(&model->source, common, report);
	if (!status)
		status = hawser_rom_source_model(&model->rom, &model->source, report);
	if (copy && status)
		rename_input(report, common->input);
	if (model->source.parameters == 0)
		hawser_rom_source_clear(&model->source);
	return status;
}

/* The model of a library. */
static enum hawser_status from_library(struct cli_model *model, const struct cli_common *common, int n,
                                       struct hawser_report *report)
{
	enum hawser_status status;

	if (n > 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
		                    "%s is a library: --modes applies to scenes only", common->library);
	status = cli_library_open(&model->source, common->library, report);
	if (!status)
		status = set_parameters(&model->source, common, report);
	return status ? status : hawser_rom_source_model(&model->rom, &model->source, report);
}

static enum hawser_status from_scene_or_ropeway(struct cli_model *model, FILE *stream,
                                                const struct cli_common *common, int n,
                                                enum extent extent, struct hawser_report *report)
{
	return cli_kind_of(common->input, CLI_ROPEWAY) == CLI_ROPEWAY
	       ? cli_rom_ropeway_load(model, common, n, report)
	       : from_scene(model, stream, common, n, extent, report);
}

static enum hawser_status load(struct cli_model *model, const struct cli_common *common, int n,
                               enum extent extent, struct hawser_report *report)
{
	FILE *stream;
	int copied;
	enum hawser_status status;

	memset(model, 0, sizeof *model);
	model->reproducible = common->reproducible;
	if ((status = cli_rom_ropeway_check(common, report)))
		return status;
	if (common->library) {
		status = from_library(model, common, n, report);
		if (!status)
			status = cli_natural(model, report);
		if (status)
			cli_model_clear(model);
		return status;
	}
	if ((status = open_input(&stream, &copied, common->input, report)))
		return status;
	if (is_model(stream)) {
		rewind(stream);
		status = from_file(model, copied ? stream : NULL, common, n, report);
	} else {
		rewind(stream);
		status = from_scene_or_ropeway(model, stream, common, n, extent, report);
	}
	fclose(stream);
	if (!status && !model->automatic && model->rom.n > 0)
		status = cli_natural(model, report);
	if (status)
		cli_model_clear(model);
	return status;
}

enum hawser_status cli_model_load(struct cli_model *model, const struct cli_common *common, int n,
                                  struct hawser_report *report)
{
	return load(model, common, n, WHOLE, report);
}

enum hawser_status cli_model_entries(struct cli_model *model, const struct cli_common *common, int n,
                                     struct hawser_report *report)
{
	return load(model, common, n, ENTRIES, report);
}

enum hawser_status cli_model_or_scene(struct cli_model *model, const struct cli_common *common,
                                      int n, struct hawser_report *report)
{
	return load(model, common, n, NOTHING, report);
}

void cli_model_clear(struct cli_model *model)
{
	if (!model)
		return;
	hawser_accuracy_clear(&model->accuracy);
	hawser_rom_clear(&model->rom);
	hawser_rom_source_clear(&model->source);
	hawser_modes_clear(&model->modes);
	hawser_scene_clear(&model->scene);
	cli_rom_ropeway_free(model->ropeway);
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
