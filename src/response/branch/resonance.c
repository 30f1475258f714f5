/* response/branch/resonance.c - the modes of a response that are near resonance at a multiple of the
 * forcing frequency.
 *
 * A mode whose frequency lies in the range of Omega, or slightly outside, is resonant at its own
 * frequency (p = 1). The reference frequency is that of the mode with the largest ratio of load to
 * damping. Another mode whose frequency differs from 2 or 3 times the reference frequency by at
 * most the fraction NEAR is in resonance with its products (1:2, 1:3).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "response/time/flow.h"
#include "response/backbone/modulation.h"

/* Relative distance from the range, and from a multiple, that counts as near; chosen. */
#define BESIDE 0.1
#define NEAR 0.1

enum { HIGHEST = 3 };

/* Magnitude of the load on mode s at its own frequency. */
static double met(const struct hawser_rom *rom, int s)
{
	double complex unused;
	double omega = sqrt(hawser__stiffness(rom, s));
	double damping = fabs(rom->D[(size_t)s*((size_t)rom->n + 1)]);

	return cabs(hawser__load(&unused, rom, s, 1, omega))/(omega*fmax(damping, 1e-6*omega));
}

static double reference(const struct hawser_rom *rom, double lo, double hi)
{
	double best = 0.0, omega0 = 0.0;

	for (int s = 0; s < rom->n; s++) {
		double omega = sqrt(fmax(hawser__stiffness(rom, s), 0.0));

		if (omega >= lo && omega <= hi && met(rom, s) > best) {
			best = met(rom, s);
			omega0 = omega;
		}
	}
	return omega0;
}

/* The multiple of omega0 that is near the frequency of the mode, or 0. */
static int order_of(double omega, double omega0, double lo, double hi)
{
	if (omega >= lo && omega <= hi)
		return 1;
	for (int p = 2; p <= HIGHEST; p++)
		if (fabs(omega/(p*omega0) - 1.0) <= NEAR)
			return p;
	return 0;
}

enum hawser_status hawser_resonance_find(struct hawser_resonance *resonance,
                                         const struct hawser_rom *rom, double from, double to,
                                         struct hawser_report *report)
{
	double lo = fmin(from, to)*(1.0 - BESIDE), hi = fmax(from, to)*(1.0 + BESIDE);

	*resonance = (struct hawser_resonance){.omega0 = reference(rom, lo, hi)};
	if (!(resonance->omega0 > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "multiple scales",
		                    "the load drives no mode between %.6g and %.6g%s: choose a range with a "
		                    "natural frequency, or name the resonant modes", lo/rom->time,
		                    HAWSER_SHOWN(rom, hi));
	for (int s = 0; s < rom->n; s++) {
		int p = order_of(sqrt(fmax(hawser__stiffness(rom, s), 0.0)), resonance->omega0, lo, hi);

		if (!p)
			continue;
		if (resonance->count == HAWSER_RESONANT_MOST)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "multiple scales",
			                    "more than %d modes are near 1, 2 or 3 times the forcing "
			                    "frequency: choose a narrower range, or name the resonant ones",
			                    HAWSER_RESONANT_MOST);
		resonance->mode[resonance->count] = s;
		resonance->order[resonance->count++] = p;
	}
	return HAWSER_OK;
}
