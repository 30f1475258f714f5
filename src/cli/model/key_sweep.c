/* cli/model/key_sweep.c - see key_sweep.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
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
	                    "--over %s: write KEY=FROM:TO, KEY=FROM:TO:POINTS with 2 to %d points or "
	                    "KEY=[A, B, ...], with units of one kind or none, such as \"%s\"", of->over,
	                    most(of), of->example);
}

/* The number at *at, before one of the letters `ends`, to which *at is moved, in the unit of the first
 * one; 0 if there is none, or its unit is of another kind. */
static int number_at(double *value, const char **at, const char *ends, struct cli_key_sweep *of,
                     int first)
{
	char *end, text[96];
	const char *begin = *at;
	size_t length, unit;
	struct hawser_report detail;

	*value = strtod(*at, &end);
	if (end == *at || !isfinite(*value))
		return 0;
	end += strspn(end, " ");
	length = unit = strcspn(end, ends);
	while (unit > 0 && end[unit - 1] == ' ')
		unit--;
	if (unit >= sizeof of->si)
		return 0;
	if (first)
		snprintf(of->si, sizeof of->si, "%.*s", (int)unit, end);
	*at = end + length;
	if (strlen(of->si) == unit && strncmp(end, of->si, unit) == 0)
		return 1;
	snprintf(text, sizeof text, "%.*s", (int)(end + unit - begin), begin);
	return unit > 0 && *of->si && !hawser_unit_parse(value, text, of->si, &detail);
}

/* A, B, ...] */
static enum hawser_status read_list(struct cli_key_sweep *of, const char *at,
                                    struct hawser_report *report)
{
	int good = 1;

	of->points = 1;
	for (const char *comma = at; (comma = strchr(comma, ',')) != NULL; comma++)
		of->points++;
	of->value = of->points > most(of) ? NULL : calloc((size_t)of->points, sizeof *of->value);
	if (!of->value)
		return of->points > most(of) ? wrong(of, report) : hawser__no_memory(report, of->command);
	for (int i = 0; i < of->points && good; i++)
		good = number_at(&of->value[i], &at, ",]", of, i == 0) &&
		       *at++ == (i + 1 < of->points ? ',' : ']');
	return good && !*at ? HAWSER_OK : wrong(of, report);
}

/* FROM:TO, and behind it :POINTS and :log, each or none. */
static enum hawser_status read_range(struct cli_key_sweep *of, const char *at,
                                     struct hawser_report *report)
{
	double from, to;
	char *end;
	long points = CLI_KEY_SWEEP_POINTS;

	if (!number_at(&from, &at, ":", of, 1) || *at++ != ':' || !number_at(&to, &at, ":", of, 0) ||
	    from == to)
		return wrong(of, report);
	if (*at == ':' && strcmp(at, ":log") != 0) {
		points = strtol(at + 1, &end, 10);
		if (end == at + 1 || points < 2 || points > most(of))
			return wrong(of, report);
		at = end;
	}
	if (*at && strcmp(at, ":log") != 0)
		return wrong(of, report);
	of->logarithmic |= *at != '\0';
	of->points = (int)points;
	return cli_key_sweep_place(of, from, to, report);
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
	const char *equals = strchr(of->over, '='), *values = equals ? equals + 1 : "";
	size_t length = equals ? (size_t)(equals - of->over) : 0;

	if (length == 0 || length >= sizeof of->key)
		return wrong(of, report);
	snprintf(of->key, sizeof of->key, "%.*s", (int)length, of->over);
	return *values == '[' ? read_list(of, values + 1, report) : read_range(of, values, report);
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
