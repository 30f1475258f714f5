/* cli/frame/picture.c - options about the picture of a command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/view.h"
#include "core/report.h"

/* cm: smaller, the texts have no room; larger, a PNG has over 10^8 points */
#define LEAST 3.0
#define MOST 120.0
enum { TITLE = 200 }; /* bytes of a title: it is one line */

enum hawser_status cli_store_title(void *field, const struct cli_option *option,
                                   const char *const *values, struct hawser_report *report)
{
	size_t length = strlen(values[0]);

	if (!length || length > TITLE)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s: write a text of 1 to %d bytes", option->name, TITLE);
	for (size_t i = 0; i < length; i++)
		if ((unsigned char)values[0][i] < ' ')
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
			                    "--%s: the text has a control character, such as a line break",
			                    option->name);
	((struct hawser__picture_choice *)field)->title = values[0];
	return HAWSER_OK;
}

/* A finite number up to `until`; *next is behind it. */
static int number(double *value, const char *text, char until, const char **next)
{
	char *end;

	*value = strtod(text, &end);
	*next = end + 1;
	return end != text && *end == until && isfinite(*value);
}

enum hawser_status cli_store_size(void *field, const struct cli_option *option,
                                  const char *const *values, struct hawser_report *report)
{
	struct hawser__picture_choice *choice = field;
	const char *next = values[0];
	double width = 0.0, height = 0.0;

	if (!number(&width, next, 'x', &next) || !number(&height, next, '\0', &next))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: write width and height in cm, such as 12x8", option->name,
		                    values[0]);
	if (!(width >= LEAST && width <= MOST && height >= LEAST && height <= MOST))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: width and height must be from %g to %g cm", option->name,
		                    values[0], LEAST, MOST);
	choice->width = width;
	choice->height = height;
	return HAWSER_OK;
}

enum hawser_status cli_store_range(void *field, const struct cli_option *option,
                                   const char *const *values, struct hawser_report *report)
{
	struct hawser__picture_range *range = field;
	const char *next = values[0], *second;
	double low = -INFINITY, high = INFINITY;
	int good = strchr(next, ':') != NULL && strcmp(next, ":") != 0;

	if (good && *next != ':')
		good = number(&low, next, ':', &next);
	else
		next++;
	second = next;
	if (good && *second)
		good = number(&high, second, '\0', &next);
	if (!good)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: write two numbers in the unit of the axis, such as 0:2.5; one of "
		                    "them may be left out", option->name, values[0]);
	if (!(low < high))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s: the first number must be less than the second", option->name,
		                    values[0]);
	range->given = 1;
	range->text = values[0];
	range->low = low;
	range->high = high;
	return HAWSER_OK;
}

enum hawser_status cli_picture_choose(struct cli_common *common, struct hawser_report *report)
{
	const struct hawser__picture_choice *choice = &common->picture;
	const char *name = choice->title ? "title" : choice->range[0].given ? "xrange"
	                   : choice->range[1].given ? "yrange" : choice->width > 0.0 ? "size" : NULL;

	if (name && !common->plot && !common->gp)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s is of a picture: give --plot FILE too", name);
	if (common->gp &&
	    (strlen(common->gp) < 4 || strcmp(common->gp + strlen(common->gp) - 3, ".gp") != 0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--gp %s: the name of the script must end in .gp", common->gp);
	if (common->gp && !common->plot) {
		common->plot = common->gp;
		common->gp = NULL;
	}
	hawser__picture_choose(choice);
	return HAWSER_OK;
}
