/* cli/motion/probes_mesh.c - times, and places, tensions and moments of probes in time, of nets and
 * rods.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include "cli/frame/cli.h"
#include "cli/motion/integrate_net.h"
#include "core/report.h"

enum hawser_status cli_integrate_times(double *until, double *every, double *step,
                                       const struct cli_integrate_net *settings, const char *kind,
                                       struct hawser_report *report)
{
	const int by_error = settings->step && strcmp(settings->step, "auto") == 0;
	enum hawser_status status;

	if (!settings->until)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "the scene is a %s: give the "
		                    "end of its motion, such as --until \"10 s\"", kind);
	status = cli_quantity(until, settings->until, "s", CLI_ABOVE_ZERO, "integrate", "until", report);
	if (!status)
		status = cli_quantity(every, settings->every, "s", CLI_ABOVE_ZERO, "integrate", "every",
		                      report);
	if (by_error)
		*step = -1.0;
	else if (!status)
		status = cli_quantity(step, settings->step, "s", CLI_ABOVE_ZERO, "integrate", "step", report);
	return status;
}

enum hawser_status cli_probes_add(const struct cli_probe_adder *by, const char *text,
                                  struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	while (text && !status) {
		size_t length = strcspn(text, ",");
		char *name;

		if (by->probed->probes == CLI_PROBES || length >= CLI_PROBE_NAME || length == 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "--probe: at most %d places, "
			                    "with commas between them, of at most %d characters", CLI_PROBES,
			                    CLI_PROBE_NAME - 1);
		name = by->probed->name[by->probed->probes];
		snprintf(name, CLI_PROBE_NAME, "%.*s", (int)length, text);
		by->probed->probes++;
		status = by->add(by->result, name, report);
		text = text[length] ? text + length + 1 : NULL;
	}
	return status;
}

enum { PLACE = 3 }; /* numbers of a probe: x, y, z, the tension, of rods the moment */

static int each(const struct cli_probed *of)
{
	return of->M ? PLACE + 2 : PLACE + 1;
}

HAWSER__OF(numbers, int, struct cli_probed, each(of)*of->probes)

static void name(char *text, size_t size, const void *context, int k)
{
	const struct cli_probed *of = context;

	snprintf(text, size, "%s_%c", of->name[k/each(of)], "xyzTM"[k % each(of)]);
}

static enum hawser__unit unit(const void *context, int k)
{
	k %= each(context);
	return k < PLACE ? HAWSER__METRE : k == PLACE ? HAWSER__NEWTON : HAWSER__NEWTON_METRE;
}

static double number(const void *context, const void *parent, size_t row, int k)
{
	const struct cli_probed *of = context;
	size_t at = row*(size_t)of->probes + (size_t)(k/each(of));

	(void)parent;
	k %= each(of);
	return k < PLACE ? of->x[at][k] : k == PLACE ? of->T[at] : of->M[at];
}

const struct hawser__vector cli_probed_vector = {
	.shown = "PROBE_x", .count = numbers, .name = name, .number = number, .unit = unit};

HAWSER__OF(pulls, int, struct cli_probed, PLACE*of->holds)

static void pull_name(char *text, size_t size, const void *context, int k)
{
	const struct cli_probed *of = context;

	snprintf(text, size, "%s_F%c", of->name[of->held[k/PLACE]], "xyz"[k % PLACE]);
}

static double pull(const void *context, const void *parent, size_t row, int k)
{
	const struct cli_probed *of = context;

	(void)parent;
	return of->pull[row*(size_t)of->probes + (size_t)of->held[k/PLACE]][k % PLACE];
}

const struct hawser__vector cli_pulled_vector = {
	.shown = "SUPPORT_Fx", .count = pulls, .name = pull_name, .number = pull};

/* The array `key` of probe p: `width` numbers a row, or, with width 0, one that is no array. */
static void array(struct hawser__json *json, json_t *into, const char *key,
                  const struct cli_probed *of, int p, const double *value, int width)
{
	json_t *list = value ? hawser__json_array(json, into, key) : NULL;

	for (int at = p; value && at < of->rows*of->probes; at += of->probes)
		if (width)
			hawser__json_numbers(json, list, NULL, value + width*at, width, 1.0);
		else
			hawser__json_number(json, list, NULL, value[at]);
}

static void probes_json(struct hawser__json *json, json_t *to, const void *row)
{
	const struct cli_probed *of = row;
	json_t *into = hawser__json_object(json, to, "probes");

	for (int p = 0; p < of->probes; p++) {
		json_t *one = hawser__json_object(json, into, of->name[p]);

		if (of->s)
			hawser__json_number(json, one, "s", of->s[p]);
		array(json, one, "x", of, p, of->x[0], PLACE);
		array(json, one, "v", of, p, of->v ? of->v[0] : NULL, PLACE);
		array(json, one, "T", of, p, of->T, 0);
		array(json, one, "M", of, p, of->M, 0);
		for (int i = 0; i < of->holds; i++)
			array(json, one, "F", of, p, of->held[i] == p ? of->pull[0] : NULL, PLACE);
	}
}

const struct hawser__field cli_probed_field[] = {
	{"probes", NULL, "by name: x (m), T (N), of supports F (N); of rods s (m), v (m/s), M (N.m) too",
	 HAWSER__CALLS(probes_json)},
	HAWSER__END,
};
