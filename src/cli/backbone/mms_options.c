/* cli/backbone/mms_options.c - parse resonant modes and a range about them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/backbone/mms_result.h"
#include "core/report.h"

enum { MOST_BASE = 6 }; /* of orders 1/2 and 1/3; chosen */

/* The base is the least common denominator of the orders. */
enum hawser_status cli_mms_read(struct hawser_resonance *resonance, int *base, const char *text,
                                const struct hawser_rom *rom, struct hawser_report *report)
{
	const char *rest = text;
	int of[HAWSER_RESONANT_MOST] = {0};

	*resonance = (struct hawser_resonance){.count = 0};
	*base = 1;
	while (*rest) {
		char *end;
		long mode = strtol(rest, &end, 10), order = *end == ':' ? strtol(end + 1, &end, 10) : 0;
		long parts = *end == '/' ? strtol(end + 1, &end, 10) : 1;
		int at;

		if (resonance->count == HAWSER_RESONANT_MOST || mode < 1 || mode > rom->n || order < 1 ||
		    order > INT_MAX/MOST_BASE || parts < 1 || parts > 3)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "mms",
			                    "--resonant %s: write mode:order, at most %d times, such as 1:1,4:2 or "
			                    "1:1/2,4:1; the model has modes 1 to %d", text,
			                    HAWSER_RESONANT_MOST, rom->n);
		for (at = resonance->count++; at > 0 && resonance->mode[at - 1] > mode - 1; at--) {
			resonance->mode[at] = resonance->mode[at - 1];
			resonance->order[at] = resonance->order[at - 1];
			of[at] = of[at - 1];
		}
		resonance->mode[at] = (int)mode - 1;
		resonance->order[at] = (int)order;
		of[at] = (int)parts;
		*base = *base%parts ? *base*(int)parts : *base;
		rest = end + strspn(end, " ,");
	}
	for (int r = 0; r < resonance->count; r++)
		/* NOLINTNEXTLINE(clang-analyzer-core.DivideZero): the loop above has set it */
		resonance->order[r] *= *base/of[r];
	for (int r = resonance->count - 1; r >= 0; r--)
		if (resonance->omega0 == 0.0 || resonance->order[r] == 1)
			resonance->omega0 =
			        sqrt(rom->K[(size_t)resonance->mode[r]*((size_t)rom->n + 1)])/resonance->order[r];
	return HAWSER_OK;
}

enum hawser_status cli_mms_mode(int *mode, int asked, const struct hawser_rom *rom,
                                struct hawser_report *report)
{
	*mode = asked ? asked - 1 : hawser_primary_strongest(rom);
	if (*mode >= rom->n)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "mms",
		                    "--mode %d: the model has modes 1 to %d", asked, rom->n);
	if (*mode < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "mms",
		                    "the load drives no damped mode at its own frequency: name one with "
		                    "--mode, or give the scene a damping (ropeways: --damping)");
	return HAWSER_OK;
}

enum hawser_status cli_mms_range(double *from, double *to, const struct cli_mms_range *range,
                                 const struct cli_model *model, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*from = fmax(range->centre - range->half, 0.05*range->centre);
	*to = range->centre + range->half;
	if (range->from)
		status = cli_frequency(from, range->from, "from", model, report);
	if (!status && range->to)
		status = cli_frequency(to, range->to, "to", model, report);
	if (!status && !(fabs(*to - *from) > 1e-9**to))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "mms",
		                      "--from %s and --to %s are the same frequency", range->from,
		                      range->to);
	return status;
}
