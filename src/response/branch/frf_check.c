/* response/branch/frf_check.c - whether a frequency response can be traced with these options.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/shooting.h"
#include "response/branch/trace.h"
#include "rom/file/entries.h"

/* Whether any excitation of the model is not zero. */
static int driven(const struct hawser_rom *rom)
{
	int found = 0;

	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];

		for (int j = 0; harmonic->f && j < rom->n; j++)
			found |= harmonic->f[j] != 0.0;
		found |= harmonic->D || harmonic->K || harmonic->quads > 0 ||
		         harmonic->terms > 0;
	}
	return found;
}

static enum hawser_status check_numbers(const struct hawser_frf_options *options,
                                        struct hawser_report *report)
{
	if (!(options->tolerance >= 1e-13 && options->tolerance <= 1e-2))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "tolerance %g: must be between 1e-13 and 1e-2",
		                    options->tolerance);
	if (options->segments < 0 || options->segments > HAWSER_MAX_SEGMENTS || options->max_points < 1 ||
	    !(options->step_max > 0.0) || !(options->event_tolerance > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "segments %d (0 to %d), max points %d (1 or more), largest step %g "
		                    "and event tolerance %g (positive): one is out of range",
		                    options->segments, HAWSER_MAX_SEGMENTS, options->max_points,
		                    options->step_max, options->event_tolerance);
	return HAWSER_OK;
}

/* A range of a parameter. */
static enum hawser_status check_family(const struct hawser_rom *rom,
                                       const struct hawser_frf_options *options,
                                       struct hawser_report *report)
{
	const char *method = options->method;

	if (!(options->family->omega > 0.0 || hawser_rom_autonomous(rom)) || options->from == options->to ||
	    !isfinite(options->from) || !isfinite(options->to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "parameter from %.9g to %.9g at Omega %.9g%s: both ends must be finite "
		                    "and different, and Omega positive", options->from, options->to,
		                    HAWSER_SHOWN(rom, options->family->omega));
	if (method && options->family->omega == 0.0 &&
	    strcmp(method, hawser__shooting_method.about.name) != 0 &&
	    strcmp(method, hawser__balance_method.about.name) != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "limit cycles are followed by shooting or by harmonic balance: leave out "
		                    "--method");
	if (method && strcmp(method, hawser__scales_method.about.name) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "motions are followed in a parameter by harmonic balance, or by "
		                    "shooting: leave out --method");
	if (options->begin != 0.0 && !(options->begin >= fmin(options->from, options->to) &&
	                               options->begin <= fmax(options->from, options->to)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "start at %.9g, outside the range of the parameter from %.9g to %.9g",
		                    options->begin, options->from, options->to);
	return HAWSER_OK;
}

static enum hawser_status check_range(const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report)
{
	if (!(options->from > 0.0) || !(options->to > 0.0) || options->from == options->to ||
	    !isfinite(options->from) || !isfinite(options->to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "frequency range from %.9g%s to %.9g%s: both ends must be "
		                    "positive, finite and different",
		                    HAWSER_SHOWN(rom, options->from), HAWSER_SHOWN(rom, options->to));
	if (options->begin != 0.0 && !(options->begin >= fmin(options->from, options->to) &&
	                               options->begin <= fmax(options->from, options->to)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "start at %.9g%s, outside the range from %.9g%s to %.9g%s",
		                    HAWSER_SHOWN(rom, options->begin),
		                    HAWSER_SHOWN(rom, options->from), HAWSER_SHOWN(rom, options->to));
	return HAWSER_OK;
}

enum hawser_status hawser__frf_check(const struct hawser_rom *rom,
                                     const struct hawser_frf_options *options,
                                     struct hawser_report *report)
{
	int free = options->family && options->family->omega == 0.0; /* equilibria and limit cycles */
	enum hawser_status status;

	if (rom->ramp)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "the speed of this cable changes once and for all (travel.braking), "
		                    "so nothing repeats itself: integrate it in time, or set "
		                    "travel.braking=0");
	if (rom->harmonics == 0 && !free)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "the model has no forcing: give the scene a load (a net: with "
		                    "harmonic.multiple), a moving support or a travel.fluctuation, or the "
		                    "model file a harmonic; what moves by itself is followed with --over "
		                    "KEY=FROM:TO");
	if (!free && !driven(rom))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "the model has no forcing: the load does no work on any of the %d "
		                    "modes kept; give it another direction or extent, or keep more "
		                    "modes", rom->n);
	if ((status = options->family ? check_family(rom, options, report)
	                              : check_range(rom, options, report)))
		return status;
	if ((status = check_numbers(options, report)))
		return status;
	return hawser__numbers_check(rom, HAWSER_ERR_NAN, report);
}
