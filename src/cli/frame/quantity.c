/* cli/frame/quantity.c - parse quantities: in SI, and frequencies and times in the scale of a model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/cli.h"
#include "core/report.h"

/* Reads the number (1 if there is none, as in "w1") and returns the text after it. */
static const char *split(double *number, const char *text)
{
	char *end;

	*number = strtod(text, &end);
	if (end == text)
		*number = 1.0;
	return end + strspn(end, " \t");
}

static enum hawser_status no_unit(struct hawser_report *report, const char *text,
                                  const char *option, const char *instead)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "quantity",
	                    "--%s %s: the model has no unit of time; write a plain number in the "
	                    "model's own unit, or %s", option, text, instead);
}

static enum hawser_status check(double value, const char *text, const char *option,
                                struct hawser_report *report)
{
	if (isfinite(value) && value > 0.0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "quantity",
	                    "--%s %s: must be greater than zero and finite", option, text);
}

/* 1 if the text is "w3"; then the index is 3. */
static int natural_index(const char *rest, int *index)
{
	char *end;
	long value;

	if (rest[0] != 'w' || rest[1] < '0' || rest[1] > '9')
		return 0;
	value = strtol(rest + 1, &end, 10);
	*index = value > 0 && value < 100000 ? (int)value : 0;
	return *end == '\0';
}

enum hawser_status cli_quantity(double *value, const char *text, const char *unit, enum cli_sign sign,
                                const char *command, const char *option,
                                struct hawser_report *report)
{
	struct hawser_report detail = {0};
	enum hawser_status status;

	if (!text)
		return HAWSER_OK;
	status = hawser_unit_parse(value, text, unit, &detail);
	if (status)
		return hawser__fail(report, status, command, "--%s: %s", option, detail.message);
	if (isfinite(*value) && (sign == CLI_ANY || *value > 0.0 ||
	                         (sign == CLI_NOT_NEGATIVE && *value == 0.0)))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
	                    sign == CLI_ANY ? "--%s %s: must be finite"
	                    : sign == CLI_NOT_NEGATIVE ? "--%s %s: must be finite and not negative"
	                    : "--%s %s: must be greater than zero and finite", option, text);
}

enum hawser_status cli_frequency(double *omega, const char *text, const char *option,
                                 const struct cli_model *model, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	struct hawser_report detail = {0};
	const char *rest = split(omega, text);
	int index;

	if (natural_index(rest, &index)) {
		if (model->naturals == 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "quantity",
			                    "--%s %s: the model has no natural frequency; write a number",
			                    option, text);
		if (index > 1 && model->naturals == 1)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "quantity",
			                    "--%s %s: the model has one natural frequency, w1", option, text);
		if (index < 1 || index > model->naturals)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "quantity",
			                    "--%s %s: the model has natural frequencies w1 to w%d", option,
			                    text, model->naturals);
		*omega *= model->natural[index - 1];
	} else if (model->rom.scaled) {
		status = hawser_unit_parse(omega, text, "rad/s", &detail);
		*omega *= model->rom.time;
	} else if (*rest || rest == text) {
		return no_unit(report, text, option, "a multiple of a natural frequency, such as 0.6w1");
	}
	if (status)
		return hawser__fail(report, status, "quantity",
		                    "--%s: %s (or write a multiple of a natural frequency, such as 0.6w1)",
		                    option, detail.message);
	return check(*omega, text, option, report);
}

enum hawser_status cli_time(double *time, const char *text, const char *option, double period,
                            const struct cli_model *model, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	struct hawser_report detail = {0};
	const char *rest = split(time, text);

	if (strcmp(rest, "T") == 0) {
		*time *= period;
	} else if (model->rom.scaled) {
		status = hawser_unit_parse(time, text, "s", &detail);
		*time /= model->rom.time;
	} else if (*rest || rest == text) {
		return no_unit(report, text, option, "a number of periods, such as 50T");
	}
	if (status)
		return hawser__fail(report, status, "quantity",
		                    "--%s: %s (or write a number of periods, such as 50T)", option,
		                    detail.message);
	return check(*time, text, option, report);
}

enum hawser_status cli_range(double *from, double *to, const char *from_text, const char *to_text,
                             const char *command, const struct cli_model *model,
                             struct hawser_report *report)
{
	const double beside = 1.25; /* ratio of an end that nobody gave to the scene's own frequency */
	double own = cli_passing(model);
	enum hawser_status status = cli_frequency(from, from_text ? from_text : "0.6w1", "from", model,
	                                          report);

	if (!status)
		status = cli_frequency(to, to_text ? to_text : "3.3w1", "to", model, report);
	if (!status && !to_text && *from < cli_modes_end(model))
		*to = fmin(*to, cli_modes_end(model));
	if (!status && own > 0.0 && !from_text)
		*from = fmin(*from, own/beside);
	if (!status && own > 0.0 && !to_text)
		*to = fmax(*to, own*beside);
	if (!status && *from == *to)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                      "--from %s and --to %s are the same frequency",
		                      from_text ? from_text : "0.6w1", to_text ? to_text : "3.3w1");
	return status;
}
