/* cli/report/cmd_report.c - hawser report: what is known of a scene, in one page.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>
#include <strings.h>

#include "cli/frame/progress.h"
#include "cli/report/report.h"
#include "cli/frame/view.h"
#include "cli/frame/within.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *output, *title, *parts;
	struct cli_report_given given;
};
static const struct settings defaults = {.output = "report.html"};

static const struct cli_option options[] = {
	{"output", 'o', "FILE", "the report in HTML, - is standard output (report.html)",
	 CLI_TEXT(output)},
	{"title", 0, "TEXT", "its title (\"Report of\" and the name of the scene)", CLI_TEXT(title)},
	{"parts", 0, "LIST", "some of its parts only, such as \"statics, modes\"", CLI_TEXT(parts)},
	{"from", 0, "FREQUENCY", "one end of the range of the response (0.6w1)", CLI_TEXT(given.from)},
	{"to", 0, "FREQUENCY", "the other end (3.3w1)", CLI_TEXT(given.to)},
	{"modes", 'n', "N", "number of modes (the commands' own)", CLI_INTEGER(given.n)},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Runs what the scene calls for and writes one file with pictures, tables, the scene and every",
	"setting. The page needs no network; values can be read off its curves, which can be enlarged.",
	"LIST: plan, statics, worst, cases, modes, irvine, campbell, frf, tow, trajectory, beam, speeds.",
	NULL,
};

static int is_html(const char *path)
{
	size_t length = strlen(path);

	return (length > 5 && strcasecmp(path + length - 5, ".html") == 0) ||
	       (length > 4 && strcasecmp(path + length - 4, ".htm") == 0);
}

static enum hawser_status check(const struct settings *settings, struct hawser_report *report)
{
	const struct cli_common *common = &settings->common;
	const char *other = common->json ? "json" : common->tsv ? "tsv" : common->plot ? "plot" : NULL;
	struct cli_output output = {"output", settings->output};
	enum hawser_status status;

	if (other)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "report",
		                    "a report is one file, --output: leave --%s out (the commands it shows "
		                    "have it)", other);
	if (strcmp(settings->output, "-") != 0 && !is_html(settings->output))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "report", "--output %s: a report is HTML, "
		                    "which a browser prints as PDF: write a name that ends in .html, or - for "
		                    "standard output", settings->output);
	status = cli_outputs_check_with(common, &output, 1, report);
	if (!status)
		status = hawser__file_check(settings->output, report);
	if (!status)
		status = hawser__picture_check("report.svg", report);
	return status;
}

static enum hawser_status run_parts(struct cli_report_page *page, const struct settings *settings,
                                    struct hawser_report *report)
{
	const struct cli_report_part *part[CLI_REPORT_PARTS];
	char text[CLI_WARNING_SIZE];
	int count;
	enum hawser_status status = cli_report_choose(part, &count, &page->scene, &page->has_scene,
	                                              &settings->common, settings->parts, report);

	for (int i = 0; i < count && !status; i++) {
		struct cli_report_result *result = &page->result[page->results++];

		cli_progress_note(settings->common.quiet, "%s (%d of %d)", part[i]->title, i + 1, count);
		status = cli_report_run(result, part[i], &settings->common, &settings->given, report);
		if (!status && result->failure) {
			snprintf(text, sizeof text, "the report has no %s: %s", part[i]->name, result->failure);
			cli_warn(text);
		}
	}
	return status;
}

static enum hawser_status write_page(const char *path, const struct cli_report_page *page,
                                     struct hawser_report *report)
{
	struct hawser__file file = {0};
	enum hawser_status status;

	cli_writing(strcmp(path, "-") != 0);
	status = hawser__file_begin(&file, path, report);
	if (status)
		return status;
	cli_report_write(file.stream, page);
	return hawser__file_commit(&file, report);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_report_page page = {.common = &settings->common, .title = settings->title};
	const struct hawser_document *document;
	const char *input = cli_input_name(&settings->common), *name = strrchr(input, '/');
	char title[300];
	enum hawser_status status = check(settings, report);

	if (status)
		return status;
	snprintf(title, sizeof title, "Report of %s", name ? name + 1 : input);
	if (!page.title)
		page.title = title;
	status = cli_document(&document, &settings->common, report);
	if (status)
		return status;
	page.text = document->text;
	page.size = document->length;
	cli_document_within(settings->common.input, document);
	status = cli_report_folder_open(report);
	if (!status)
		status = run_parts(&page, settings, report);
	if (!status)
		status = write_page(settings->output, &page, report);
	if (!status && strcmp(settings->output, "-") != 0)
		cli_progress_note(settings->common.quiet, "wrote %s", settings->output);
	cli_document_within(NULL, NULL);
	cli_report_folder_close();
	cli_temporary(NULL);
	for (int i = 0; i < page.results; i++)
		cli_report_result_clear(&page.result[i]);
	if (page.has_scene)
		hawser_scene_clear(&page.scene);
	return status;
}

/* A report has no columns of its own; the list is that of its parts. */
static const struct hawser__field part_field[] = {
	{.key = "statics", .doc = "hawser statics: of all but towed bodies and beams"},
	{.key = "worst", .doc = "hawser statics --worst: of ropeways"},
	{.key = "cases", .doc = "hawser statics --cases: of spans with cases"},
	{.key = "modes", .doc = "hawser modes: of spans, nets and ropeways"},
	{.key = "damped", .doc = "hawser modes --damped: of spans with dampers"},
	{.key = "irvine", .doc = "hawser irvine: of spans at rest"},
	{.key = "campbell", .doc = "hawser campbell: of travelling cables"},
	{.key = "frf", .doc = "hawser frf: of spans with a load, moving ends or a fluctuating speed"},
	{.key = "tow", .doc = "hawser tow steady: of a towed cable"},
	{.key = "trajectory", .doc = "hawser trajectory: of a path through waypoints"},
	{.key = "beam", .doc = "hawser beam: of a travelling beam or string"},
	{.key = "speeds", .doc = "hawser beam --plot: over the speed, to 1.2 times v_crit"},
	{.key = "plan", .doc = "hawser plan: of spans and nets"},
	HAWSER__END,
};
static const struct cli_listing listing[] = {{"Parts:", part_field, 1}, {NULL, NULL, 0}};

const struct cli_command cli_report = {
	"report", "SCENE", "Pictures, tables and settings of all that a scene calls for, in one page",
	notes, options, &defaults, sizeof(struct settings), 1, run, listing,
	.takes = CLI_EVERY,
};
