/* response/branch/vanish.c - see vanish.h.
 *
 *    A   size of an orbit
 *    W   Omega at which the equilibrium has a multiplier 1: a branch of motions begins there
 *    f   product of (1 - mu)/(1 + |mu|) over the multipliers mu at rest: smooth in Omega, zero at W
 *
 * If there is no load, rest is a solution at every Omega. Near W, A^2 is proportional to Omega - W
 * if motions of opposite signs are equivalent (pitchfork), otherwise A is (transcritical). The
 * continuation never reaches W, since its metric is relative to the size of the orbit, in which W
 * is infinitely far away. The branch therefore ends if A is a small fraction of its largest value
 * and one of the two laws extrapolates A to zero at a zero of f. This zero is located by the linear
 * problem alone and has no extrapolation error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <hawser/linear.h>

#include "core/report.h"
#include "response/branch/vanish.h"

#define SMALL 0.01     /* of the largest size: the relative error of the laws is about the square of
                        * this */
#define AGREEMENT 0.1  /* largest distance from W, relative to the length of the extrapolation;
                        * chosen */
#define NEAREST 1e-7   /* the same relative to Omega, if the extrapolation is shorter; chosen */
#define MOST_HALVINGS 100 /* of the distance: more are useless because of round-off */
#define ROUND_OFF 4e-16  /* relative error of Omega after bisection */

struct rest {
	struct hawser_linear *linear;
	const struct hawser_rom *rom;
	double *log_modulus, *argument; /* [m] */
	int m;
};

static enum hawser_status test(double *f, struct rest *rest, double omega,
                               struct hawser_report *report)
{
	enum hawser_status status = hawser_linear_multipliers(rest->linear, rest->log_modulus,
	                                                      rest->argument, NULL, rest->rom,
	                                                      omega, report);

	*f = 1.0;
	for (int i = 0; !status && i < rest->m; i++) {
		double log_modulus = rest->log_modulus[i], angle = rest->argument[i];

		if (angle == 0.0)
			*f *= -tanh(0.5*log_modulus);
		else /* |1 - mu|/(1 + |mu|), the square root of the factor of the pair */
			*f *= hypot(tanh(0.5*log_modulus),
			            sin(0.5*angle)/cosh(0.5*log_modulus));
	}
	return status;
}

/* Logarithm of the real multiplier nearest to 1. */
static double critical(const struct rest *rest)
{
	double least = INFINITY;

	for (int i = 0; i < rest->m; i++)
		if (rest->argument[i] == 0.0 && fabs(rest->log_modulus[i]) < fabs(least))
			least = rest->log_modulus[i];
	return least;
}

/* Bisect [a, b], at whose ends f has the signs of fa and -fa. */
static enum hawser_status bisect(double *at, struct rest *rest, double a, double b, double fa,
                                 struct hawser_report *report)
{
	for (int i = 0; i < MOST_HALVINGS; i++) {
		double f;
		enum hawser_status status;

		*at = 0.5*(a + b);
		if (*at == a || *at == b)
			break;
		if ((status = test(&f, rest, *at, report)))
			return status;
		if (f == 0.0)
			break;
		if ((f < 0.0) == (fa < 0.0))
			a = *at;
		else
			b = *at;
	}
	return HAWSER_OK;
}

/* The zero of f near `guess`, the end of an extrapolation over `length`. */
static enum hawser_status locate(int *found, struct hawser_frf_event *event, struct rest *rest,
                                 double guess, double length, struct hawser_report *report)
{
	double reach = AGREEMENT*fabs(length) + NEAREST*guess, a = guess - reach, b = guess + reach;
	double fa, fb, at, change, error;
	enum hawser_status status;

	*found = 0;
	if (!(a > 0.0))
		return HAWSER_OK;
	if ((status = test(&fa, rest, a, report)))
		return status;
	change = critical(rest);
	if ((status = test(&fb, rest, b, report)) || (fa < 0.0) == (fb < 0.0))
		return status;
	change = fabs(critical(rest) - change);
	if ((status = bisect(&at, rest, a, b, fa, report)) ||
	    (status = hawser_linear_multipliers(rest->linear, rest->log_modulus, rest->argument,
	                                        &error, rest->rom, at, report)))
		return status;
	*found = 1;
	*event = (struct hawser_frf_event){.kind = HAWSER_BRANCH_POINT, .omega = at, .parameter = at,
		.located = 1, .bracket = {a, b},
		.error = fmin((b - a)/at, ROUND_OFF + error*((b - a)/at)/change)};
	if (!isfinite(change)) /* the multipliers are complex at one end */
		event->error = (b - a)/at;
	return HAWSER_OK;
}

/* Whether all terms are products of two factors at least, which are nothing at rest. */
static int only_products(const struct hawser_rom *rom)
{
	for (int i = 0; i < rom->terms; i++)
		if (rom->term[i].factors < 2)
			return 0;
	for (int h = 0; h < rom->harmonics; h++)
		for (int i = 0; i < rom->harmonic[h].terms; i++)
			if (rom->harmonic[h].term[i].factors < 2)
				return 0;
	return 1;
}

/* *bare: rom without these; *harmonic is its memory. */
static enum hawser_status strip(struct hawser_rom *bare, struct hawser_harmonic **harmonic,
                                const struct hawser_rom *rom, struct hawser_report *report)
{
	*bare = *rom;
	*harmonic = malloc(((size_t)rom->harmonics + 1)*sizeof **harmonic);
	if (!*harmonic)
		return hawser__no_memory(report, "frf");
	for (int h = 0; h < rom->harmonics; h++) {
		(*harmonic)[h] = rom->harmonic[h];
		(*harmonic)[h].terms = 0;
	}
	bare->harmonic = *harmonic;
	bare->terms = 0;
	return HAWSER_OK;
}

static enum hawser_status search(const struct hawser__shrinking *s, int *found,
                                 struct hawser_frf_event *event, const struct hawser_rom *rom,
                                 struct hawser_report *report)
{
	struct hawser_rom bare;
	struct hawser_harmonic *harmonic;
	struct rest rest = {.rom = rom, .m = 2*rom->n};
	enum hawser_status status = strip(&bare, &harmonic, rom, report);

	if (!status && only_products(rom))
		rest.rom = &bare;
	if (!status)
		status = hawser_linear_open(&rest.linear, rom->n, report);
	if (status) {
		free(harmonic);
		return status;
	}
	rest.log_modulus = malloc(2*(size_t)rest.m*sizeof(double));
	if (!rest.log_modulus)
		status = hawser__no_memory(report, "frf");
	else
		rest.argument = rest.log_modulus + rest.m;
	for (int power = 2; power > 0 && !status && !*found; power--) {
		double last = pow(s->size[1], power), before = pow(s->size[0], power);
		double length = (s->omega[1] - s->omega[0])*last/(before - last);

		status = locate(found, event, &rest, s->omega[1] + length, length, report);
	}
	free(rest.log_modulus);
	free(harmonic);
	hawser_linear_free(rest.linear);
	return status;
}

enum hawser_status hawser__vanish(struct hawser__shrinking *shrinking, int *found,
                                  struct hawser_frf_event *event, const struct hawser_rom *rom,
                                  double size, double omega,
                                  struct hawser_report *report)
{
	enum hawser_status status;

	*found = 0;
	shrinking->size[0] = shrinking->size[1];
	shrinking->omega[0] = shrinking->omega[1];
	shrinking->size[1] = size;
	shrinking->omega[1] = omega;
	shrinking->largest = fmax(shrinking->largest, size);
	shrinking->known++;
	if (shrinking->known < 2 || !(size > 0.0 && size < shrinking->size[0] &&
	                              size < SMALL*shrinking->largest) ||
	    hawser_rom_loaded(rom) || rom->exact)
		return HAWSER_OK;
	status = search(shrinking, found, event, rom, report);
	/* if the linear problem cannot be solved, the branch is followed further */
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}
