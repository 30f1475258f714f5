/* rom/condense/answer.c - displacement and strain of the modes that are not kept, at an instant. See
 * answer_make.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <string.h>

#include "rom/terms/ends.h"
#include "rom/terms/history.h"
#include "rom/energy/kernel.h"
#include "rom/condense/known.h"

/* Factor of the force of a harmonic, or its time derivative. */
static double wave(const struct hawser_harmonic *h, const struct hawser_rom_moment *moment, int rate)
{
	double complex turn = cexp(I*h->k*moment->tau)*(h->phase == HAWSER_SIN ? -I : 1.0);
	double size = pow(moment->omega, h->omega_power);

	return rate ? creal(I*h->k*moment->omega*turn)*size : creal(turn)*size;
}

/* The factors of the ramp, or their time derivatives. */
static void slope_factors(double s[HAWSER_RAMP_TERMS], const struct hawser_ramp *ramp, double t,
                          int rate)
{
	int over = t >= ramp->time;
	double part = t/ramp->time;

	hawser__ramp_factors(s, ramp, t, over);
	if (!rate)
		return;
	s[HAWSER_RAMP_LINEAR] = over ? 0.0 : 1.0/ramp->time;
	s[HAWSER_RAMP_SQUARE] = over ? 0.0 : 2.0*part/ramp->time;
	s[HAWSER_RAMP_RATE] = 0.0;
}

/* out[count] += what the series of known modes omits (known.c): their shapes, whose values at one
 * point are `apart` numbers from one mode to the next. */
static void add_known(double *out, const struct hawser_rom *rom, const struct hawser_harmonic *h,
                      const double *from, size_t apart, int count,
                      const struct hawser_rom_moment *moment, int rate)
{
	double W = h->k*moment->omega;
	double complex turn = cexp(I*h->k*moment->tau)*(h->phase == HAWSER_SIN ? -I : 1.0)*
	                      pow(moment->omega, h->omega_power)*(rate ? I*W : 1.0);

	for (int s = 0; s < rom->known.modes; s++) {
		double factor;

		if (h->known[s] == 0.0)
			continue;
		factor = h->known[s]*creal(turn*hawser__rom_known_lacks(&rom->known, s, W));
		for (int i = 0; i < count; i++)
			out[i] += factor*from[(size_t)s*apart + (size_t)i];
	}
}

/* out[count] += factor * from, for the static response and, times (k Omega)^2, for the correction,
 * which is stored `apart` numbers behind it. */
static void add_harmonic(double *out, const struct hawser_harmonic *h, const double *from,
                         size_t apart, int count, const struct hawser_rom_moment *moment, int rate)
{
	double factor = wave(h, moment, rate), inertia = pow(h->k*moment->omega, 2)*factor;

	for (int i = 0; i < count; i++)
		out[i] += factor*from[i] + inertia*from[apart + (size_t)i];
}

static void add_ramp(double *out, const double *from, int count, double factor)
{
	for (int i = 0; i < count; i++)
		out[i] += factor*from[i];
}

/* out[count] += the numbers from `at` on of what is stored at the shape points or (line) along the
 * line. Returns whether there are any. */
static int add_all(double *out, const struct hawser_rom *rom, int line, size_t at, int count,
                   const struct hawser_rom_moment *moment, int rate)
{
	size_t apart = line ? (size_t)rom->line.points : 4*(size_t)rom->shapes.points;
	const double *known = line ? rom->known.line : rom->known.shape;
	double s[HAWSER_RAMP_TERMS];
	int any = 0;

	for (int i = 0; i < rom->harmonics; i++) {
		const struct hawser_harmonic *h = &rom->harmonic[i];
		const double *from = line ? h->answer_line : h->answer;

		if (!from)
			continue;
		add_harmonic(out, h, from + at, apart, count, moment, rate);
		if (h->known && known)
			add_known(out, rom, h, known + at, apart, count, moment, rate);
		any = 1;
	}
	if (rom->ramp)
		slope_factors(s, rom->ramp, moment->time, rate);
	for (int i = 0; rom->ramp && i < HAWSER_RAMP_TERMS; i++) {
		const double *from = line ? rom->ramp->term[i].answer_line : rom->ramp->term[i].answer;

		if (from)
			add_ramp(out, from + at, count, s[i]);
		any |= from != NULL;
	}
	for (int i = 0; rom->history && i < rom->history->terms; i++) {
		const struct hawser_ramp_term *term = &rom->history->term[i];
		const double *from = line ? term->answer_line : term->answer;

		if (from)
			add_ramp(out, from + at, count,
			         hawser__history_factor(rom->history, i, moment->time, rate));
		any |= from != NULL;
	}
	return any;
}

void hawser__rom_answer_shape(const struct hawser_rom *rom, double local[3], int p,
                              const struct hawser_rom_moment *moment, int rate)
{
	(void)add_all(local, rom, 0, 4*(size_t)p, 3, moment, rate);
}

double hawser__rom_answer_slope(const struct hawser_rom *rom, int p,
                                const struct hawser_rom_moment *moment)
{
	double strain = 0.0;

	(void)add_all(&strain, rom, 0, 4*(size_t)p + 3, 1, moment, 0);
	return strain;
}

double hawser__rom_answer_strain(const struct hawser_rom *rom, int place,
                                 const struct hawser_rom_moment *moment)
{
	double strain = 0.0;

	if (rom->line.points == 0)
		return hawser__rom_answer_slope(rom, place, moment);
	(void)add_all(&strain, rom, 1, (size_t)place, 1, moment, 0);
	return strain;
}

int hawser__rom_answer_strains(const struct hawser_rom *rom, double *extra,
                               const struct hawser_rom_moment *moment)
{
	int any = rom->ends != NULL, places = hawser__rom_tension_places(rom);

	if (rom->ends)
		hawser__ends_at(rom, extra + places, moment);
	memset(extra, 0, (size_t)places*sizeof *extra);
	if (rom->exact)
		return any;
	if (rom->line.points > 0)
		return add_all(extra, rom, 1, 0, rom->line.points, moment, 0) || any;
	for (int p = 0; p < rom->shapes.points; p++)
		any |= add_all(extra + p, rom, 0, 4*(size_t)p + 3, 1, moment, 0);
	return any;
}
