/* cli/model/key_sweep.c - see key_sweep.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/key_sweep.h"
#include "core/report.h"

static int most(const struct cli_key_sweep *of)
{
	return of->most > 0 ? of->most : CLI_KEY_SWEEP_MOST;
}

static enum hawser_status wrong(const struct cli_key_sweep *of, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, of->command,
	                    "--over %s: write KEY=FROM:TO:POINTS with 2 to %d points and the same unit in "
	                    "both, such as \"%s\"", of->over, most(of), of->example);
}

/* KEY=FROM:TO:POINTS: numbers in SI, or with a unit that both have. */
static enum hawser_status split(double *from, double *to, struct cli_key_sweep *of,
                                struct hawser_report *report)
{
	const char *equals = strchr(of->over, '='), *colon, *second;
	char *end;
	size_t length, unit;
	long points;

	if (!equals || (length = (size_t)(equals - of->over)) == 0 || length >= sizeof of->key)
		return wrong(of, report);
	snprintf(of->key, sizeof of->key, "%.*s", (int)length, of->over);
	*from = strtod(equals + 1, &end);
	colon = strchr(equals, ':');
	if (!colon || end == equals + 1 || end > colon)
		return wrong(of, report);
	end += strspn(end, " ");
	unit = (size_t)(colon - end);
	if (unit >= sizeof of->si)
		return wrong(of, report);
	snprintf(of->si, sizeof of->si, "%.*s", (int)unit, end);
	*to = strtod(colon + 1, &end);
	second = strchr(colon + 1, ':');
	if (!second || end == colon + 1 || end > second)
		return wrong(of, report);
	end += strspn(end, " ");
	if ((size_t)(second - end) != unit || strncmp(end, of->si, unit) != 0)
		return wrong(of, report);
	points = strtol(second + 1, &end, 10);
	if (end == second + 1 || *end || points < 2 || points > most(of) || !isfinite(*from) ||
	    !isfinite(*to) || *from == *to)
		return wrong(of, report);
	of->points = (int)points;
	return HAWSER_OK;
}

enum hawser_status cli_key_sweep_place(struct cli_key_sweep *of, double from, double to,
                                       struct hawser_report *report)
{
	if (of->logarithmic && !(from > 0.0 && to > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, of->command, "%s%s: from %.9g to %.9g "
		                    "there are no equal ratios: give values above 0",
		                    of->over ? "--over " : "--log", of->over ? of->over : "", from, to);
	of->value = calloc((size_t)of->points, sizeof *of->value);
	if (!of->value)
		return hawser__no_memory(report, of->command);
	for (int i = 0; i < of->points; i++) {
		double part = (double)i/(of->points - 1);

		of->value[i] = i + 1 == of->points ? to : of->logarithmic ? from*pow(to/from, part)
		                                                          : from + part*(to - from);
	}
	return HAWSER_OK;
}

enum hawser_status cli_key_sweep_read(struct cli_key_sweep *of, struct hawser_report *report)
{
	double from = 0.0, to = 0.0;
	enum hawser_status status = split(&from, &to, of, report);

	return status ? status : cli_key_sweep_place(of, from, to, report);
}

void cli_key_sweep_at(struct cli_common *common, char set[CLI_KEY_SWEEP_SET],
                      const struct cli_key_sweep *of, const struct cli_common *own, double value)
{
	*common = *own;
	snprintf(set, CLI_KEY_SWEEP_SET, "%s=%.17g%s%s", of->key, value, *of->si ? " " : "", of->si);
	if (common->sets < CLI_SETS)
		common->set[common->sets++] = set;
}

enum hawser_status cli_key_sweep_blame(struct hawser_report *report, enum hawser_status status,
                                       const struct cli_key_sweep *of, const char *set)
{
	char message[sizeof report->message];
	size_t length = strlen(set);

	if (!status || !report || strncmp(report->message, "--set ", 6) != 0 ||
	    strncmp(report->message + 6, set, length) != 0)
		return status;
	memcpy(message, report->message, sizeof message);
	snprintf(report->message, sizeof report->message, "--over %s, at %s%.420s", of->key,
	         set + strlen(of->key) + 1, message + 6 + length);
	return status;
}
