/* water/sea.c - spectra, and the waves of a sea (hawser/waves.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include <hawser/waves.h>

#include "core/random.h"
#include "core/report.h"
#include "core/settle.h"
#include "water/water.h"

/* The form of the spectrum over w = omega/omega_p. */
static double form(double gamma, double w)
{
	double s = w < 1.0 ? 0.07 : 0.09, d = (w - 1.0)/s, w4 = w*w*w*w;

	return exp(-1.25/w4 + log(gamma)*exp(-0.5*d*d))/(w4*w);
}

/* Integral of w^power form(w) from a to b on one side of the peak, over log w by Gauss's rule with five
 * points on panels of 0.02, within which the peak is a polynomial to 1e-14. */
static double side(double gamma, double power, double a, double b)
{
	static const double at[3] = {0.0, 0.5384693101056831, 0.9061798459386640};
	static const double weight[3] = {128.0/225.0, 0.4786286704993665, 0.2369268850561891};
	int panels = (int)ceil(log(b/a)/0.02);
	double width = log(b/a)/panels, sum = 0.0;

	for (int i = 0; i < panels; i++)
		for (int j = -2; j <= 2; j++) {
			double w = a*exp(width*(i + 0.5*(1.0 + (j < 0 ? -at[-j] : at[j]))));

			sum += 0.5*width*weight[abs(j)]*pow(w, power + 1.0)*form(gamma, w);
		}
	return sum;
}

/* Below w = 0.2 the form is below 1e-336; above w = 20 it is w^-5 (1 - 1.25 w^-4 + ...). */
static double integral(double gamma, double power, double a, double b)
{
	const double least = 0.2, most = 20.0;
	double below = fmin(fmax(a, least), 1.0), sum = 0.0, end = fmin(b, most);

	if (end > below && below < 1.0)
		sum += side(gamma, power, below, fmin(end, 1.0));
	if (end > 1.0 && a < end)
		sum += side(gamma, power, fmax(a, 1.0), end);
	if (b > most) {
		double p = power - 4.0, from = fmax(a, most);

		sum += (pow(b, p) - pow(from, p))/p - 1.25*(pow(b, p - 4.0) - pow(from, p - 4.0))/(p - 4.0) +
		       0.78125*(pow(b, p - 8.0) - pow(from, p - 8.0))/(p - 8.0);
	}
	return sum;
}

void hawser_jonswap_of(struct hawser_jonswap *spectrum, double Hs, double Tp, double gamma)
{
	double omega_p = 2.0*acos(-1.0)/Tp;

	*spectrum = (struct hawser_jonswap){omega_p, gamma, 0.0};
	spectrum->scale = Hs*Hs/16.0/(omega_p*integral(gamma, 0.0, 0.0, INFINITY));
}

double hawser_jonswap_at(const struct hawser_jonswap *spectrum, double omega)
{
	return omega > 0.0 ? spectrum->scale*form(spectrum->gamma, omega/spectrum->omega_p) : 0.0;
}

double hawser_jonswap_moment(const struct hawser_jonswap *spectrum, double power, double from,
                             double to)
{
	double unit = spectrum->omega_p;

	return spectrum->scale*pow(unit, power + 1.0)*
	       integral(spectrum->gamma, power, from/unit, to/unit);
}

static void settle(struct hawser_waves_given *given)
{
	hawser__settle(&given->gamma, 3.3);
	hawser__settle(&given->g, 9.81);
	hawser__settle_count(&given->components, 400);
	if (given->range[1] == 0.0) {
		given->range[0] = acos(-1.0)/given->Tp;
		given->range[1] = 10.0*given->range[0];
	}
}

static enum hawser_status check(const struct hawser_waves_given *given, struct hawser_report *report)
{
	int sea = given->Hs > 0.0 && given->Tp > 0.0;

	if (!(given->depth > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "waves", "waves need water.depth, above 0 m "
		                    "(.inf: deep water), not %g m", given->depth);
	if (!sea && !(given->height > 0.0 && given->period > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "waves", "waves need a height and a period, "
		                    "or Hs and Tp of a sea, above 0");
	if (!sea) {
		double most = hawser__wave_highest(2.0*acos(-1.0)/given->period, given->depth, given->g);

		if (given->height > most)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "waves", "waves of %g s break at a "
			                    "height of %.3g m, and theirs is %g m", given->period, most,
			                    given->height);
	}
	if (sea && !(given->gamma >= 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "waves", "gamma of the sea is %g; it is 1 or "
		                    "more", given->gamma);
	if (sea && given->components < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "waves", "a sea of %d components",
		                    given->components);
	if (sea && !(given->range[0] > 0.0 && given->range[0] < given->range[1]))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "waves", "frequencies of the sea from %g to "
		                    "%g rad/s do not rise from above 0", given->range[0], given->range[1]);
	return HAWSER_OK;
}

static void components(struct hawser_waves *waves, const struct hawser_waves_given *given)
{
	const double turn = 2.0*acos(-1.0), from = given->range[0];
	double width = (given->range[1] - from)/waves->count;
	struct hawser_jonswap spectrum;
	uint64_t random = (uint64_t)given->seed;
	int drawn = given->seed >= 0;

	hawser_jonswap_of(&spectrum, given->Hs, given->Tp, given->gamma);
	for (int i = 0; i < waves->count; i++) {
		double a = from + width*i, b = i + 1 < waves->count ? a + width : INFINITY, omega;

		omega = a + width*(drawn ? hawser__random(&random) : 0.5);
		waves->wave[i] = (struct hawser_wave){
			sqrt(2.0*hawser_jonswap_moment(&spectrum, 0.0, i ? a : 0.0, b)), omega,
			hawser_wave_number(omega, given->depth, given->g),
			drawn ? turn*hawser__random(&random) : 0.0};
	}
}

enum hawser_status hawser_waves_make(struct hawser_waves *waves,
                                     const struct hawser_waves_given *asked,
                                     struct hawser_report *report)
{
	struct hawser_waves_given given = *asked;
	int sea = given.Hs > 0.0;
	enum hawser_status status;

	*waves = (struct hawser_waves){0};
	settle(&given);
	if ((status = check(&given, report)) != HAWSER_OK)
		return status;
	*waves = (struct hawser_waves){
		NULL, sea ? given.components : 1, {cos(given.heading), sin(given.heading)}, given.depth,
		given.surface, given.ramp, given.stretching};
	if ((waves->wave = malloc((size_t)waves->count*sizeof *waves->wave)) == NULL)
		return hawser__no_memory(report, "waves");
	if (sea) {
		components(waves, &given);
	} else {
		double omega = 2.0*acos(-1.0)/given.period;

		waves->wave[0] = (struct hawser_wave){given.height/2.0, omega,
			hawser_wave_number(omega, given.depth, given.g), given.phase};
	}
	return HAWSER_OK;
}

void hawser_waves_clear(struct hawser_waves *waves)
{
	if (waves == NULL)
		return;
	free(waves->wave);
	*waves = (struct hawser_waves){0};
}
