/* rom/terms/terms.c - forces that are products of any coordinates and velocities, such as u'^3, u^2
 * u', u^5.
 *
 *    x_i      a coordinate or a velocity
 *    term     value * product of x_i;  d/dx_i = value * product of the others, once for each occurrence
 *
 * The compiled kernel (kernel.h) has the terms of cables, of second and third order in the
 * coordinates, and those of winds (terms.h). Others are the exception and are evaluated one by one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdio.h>

#include "core/hot.h"
#include "core/report.h"
#include "rom/energy/kernel.h"
#include "rom/file/plug.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"

int hawser__rom_more(const struct hawser_rom *rom)
{
	for (int h = 0; h < rom->harmonics; h++)
		if (rom->harmonic[h].terms > 0)
			return 1;
	return rom->terms > 0 || rom->plug;
}

struct state {
	const double *u, *v; /* [n] */
	int n, stride;
};

/* Of all lanes; one state stands in all of them. */
HAWSER_PART void get_lanes(hawser__vec *to, const double *from, int stride)
{
	*to = stride == HAWSER_LANES ? *(const hawser__vec *)from
	                             : (hawser__vec){*from, *from, *from, *from};
}

HAWSER_PART void take_off(double *to, int stride, hawser__vec part)
{
	if (stride == HAWSER_LANES)
		*(hawser__vec *)to -= part;
	else
		*to -= part[0];
}

/* force -= s term, by_omega -= ds term. The product of all factors but one is that of those before
 * it times that of those behind it. */
HAWSER_PART void subtract_term(const struct hawser__more *to, const struct hawser_term *term,
                               const struct state *x, const double *factor_s, const double *factor_ds)
{
	hawser__vec factor[HAWSER_TERM_FACTORS], before[HAWSER_TERM_FACTORS], whole, behind, s, ds;
	int displacements = term->factors - term->rates;

	get_lanes(&whole, &term->value, 1);
	get_lanes(&s, factor_s, x->stride);
	get_lanes(&ds, factor_ds, x->stride);
	behind = s*to->sign;
	for (int i = 0; i < term->factors; i++) {
		get_lanes(&factor[i], (i < displacements ? x->u : x->v) + term->factor[i]*x->stride, x->stride);
		before[i] = whole;
		whole *= factor[i];
	}
	take_off(to->force + term->j*x->stride, x->stride, s*whole);
	if (to->by_omega)
		take_off(to->by_omega + term->j*x->stride, x->stride, ds*whole);
	for (int i = term->factors - 1; (to->by_u || to->by_v) && i >= 0; i--) {
		double *matrix = i < displacements ? to->by_u : to->by_v;

		if (matrix)
			take_off(matrix + (term->j*x->n + term->factor[i])*x->stride, x->stride,
			         before[i]*behind);
		/* cppcheck-suppress uninitvar ; it is filled above */
		behind *= factor[i];
	}
}

/* The terms of these indices; NULL: all. */
HAWSER_HOT static void subtract_terms(const struct hawser__more *to, const struct hawser_term *term,
                                    const int *index, int terms, const struct state *x,
                                    const double *s, const double *ds)
{
	for (int i = 0; i < terms; i++)
		subtract_term(to, &term[index ? index[i] : i], x, s, ds);
}

/* All but those of hawser__rates_add. */
static void add_others(const struct hawser_rom *rom, const struct hawser__more *to, const double *u,
                       const double *v, const double *tau, double omega)
{
	static const double one[] = {1.0, 1.0, 1.0, 1.0}, zero[] = {0.0, 0.0, 0.0, 0.0};
	const struct state x = {u, v, rom->n, to->stride};

	if (rom->plug)
		hawser__plug_add(rom, to, u, v, tau, omega);
	if (rom->terms > 0)
		subtract_terms(to, rom->term, rom->kernel->other, rom->kernel->others, &x, one, zero);
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];
		double s[HAWSER_LANES], ds[HAWSER_LANES];

		for (int lane = 0; harmonic->terms > 0 && lane < to->stride; lane++) {
			double angle = harmonic->k*tau[lane];

			s[lane] = harmonic->phase == HAWSER_COS ? cos(angle) : sin(angle);
			for (int p = 0; p < harmonic->omega_power; p++)
				s[lane] *= omega;
			ds[lane] = harmonic->omega_power*s[lane]/omega;
		}
		subtract_terms(to, harmonic->term, NULL, harmonic->terms, &x, s, ds);
	}
}

void hawser__rom_more_add(const struct hawser_rom *rom, const struct hawser__more *to,
                          const double *u, const double *v, const double *tau, double omega)
{
	if (rom->terms > 0 && rom->kernel->rates)
		hawser__rates_add(rom->kernel->rates, to, v, 1);
	add_others(rom, to, u, v, tau, omega);
}

void hawser__rom_more_left(const struct hawser_rom *rom, const struct hawser__more *all,
                           const double *u, const double *v, int count, double omega)
{
	size_t n = (size_t)rom->n;

	cblas_dscal((int)n*count, -1.0, all->force, 1);
	if (rom->terms > 0 && rom->kernel->rates)
		hawser__rates_add(rom->kernel->rates, all, v, count);
	if (rom->drag)
		hawser__drag_add(rom->drag, all->force, all->by_v, 1.0, v, count);
	for (int r = 0; r < count; r++) {
		double tau = 2.0*M_PI*r/count;
		const struct hawser__more to = {.force = all->force + r*n,
			.by_u = all->by_u ? all->by_u + r*n*n : NULL,
			.by_v = all->by_v ? all->by_v + r*n*n : NULL,
			.by_omega = all->by_omega ? all->by_omega + r*n : NULL, .sign = -1.0, .stride = 1};

		add_others(rom, &to, u + r*n, v + r*n, &tau, omega);
	}
	cblas_dscal((int)n*count, -1.0, all->force, 1);
}

double hawser__rom_weighed(const struct hawser_rom *rom, const double *w, int j)
{
	double sum = 0.0;

	if (!rom->mass)
		return w[j];
	for (int k = 0; k < rom->n; k++)
		sum += rom->mass[j*rom->n + k]*w[k];
	return sum;
}

/* A term of order d has the integral of u . term(s u) ds from 0 to 1, the term at u over d + 1. */
double hawser__terms_potential(const struct hawser_rom *rom, const double *u)
{
	double sum = 0.0;

	for (int i = 0; i < rom->terms; i++) {
		const struct hawser_term *term = &rom->term[i];
		double product = term->value*hawser__rom_weighed(rom, u, term->j);

		for (int f = 0; f < term->factors; f++)
			product *= u[term->factor[f]];
		sum += term->rates == 0 ? product/(term->factors + 1) : 0.0;
	}
	return sum;
}

enum hawser_status hawser__more_refuse(const struct hawser_rom *rom, const char *what,
                                       struct hawser_report *report)
{
	if (!hawser__rom_more(rom))
		return HAWSER_OK;
	if (rom->plug && rom->plug->water)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%s has no force of the water, which depends on places, velocities "
		                    "and the frequency: hawser frf, orbit and integrate compute it from "
		                    "the scene", what);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
	                    "%s takes models with D, K, Q and C only; this one %s, which hawser frf%s, "
	                    "hawser integrate, hawser locus (--over a parameter, --kind fold and others) "
	                    "and hawser map --quantity amplitude take", what,
	                    rom->plug ? "is a function" : "has terms besides",
	                    rom->plug ? " (by shooting)" : "");
}

int hawser__rom_periods(const struct hawser_rom *rom)
{
	return rom->periods > 1 ? rom->periods : 1;
}

enum hawser_status hawser__periods_refuse(const struct hawser_rom *rom, const char *what,
                                          struct hawser_report *report)
{
	if (hawser__rom_periods(rom) == 1)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
	                    "%s takes models of one period, and this one has periods %d: write the "
	                    "harmonics as multiples of Omega/%d, and give frequencies of that", what,
	                    rom->periods, rom->periods);
}

static enum hawser_status check(const struct hawser_term *term, int count, int n, const char *of,
                                struct hawser_report *report)
{
	for (int i = 0; i < count; i++) {
		const struct hawser_term *t = &term[i];
		int wrong = t->j < 0 || t->j >= n || t->factors < 1 || t->factors > HAWSER_TERM_FACTORS ||
		            t->rates < 0 || t->rates > t->factors || !isfinite(t->value);

		for (int f = 0; !wrong && f < t->factors; f++)
			wrong = t->factor[f] < 0 || t->factor[f] >= n;
		if (wrong)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "%sterms: entry %d of equation %d has %d factors and the value %g; "
			                    "indices must be 0 to %d, factors 1 to %d and the value finite", of,
			                    i, t->j, t->factors, t->value, n - 1, HAWSER_TERM_FACTORS);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__terms_check(const struct hawser_rom *rom, struct hawser_report *report)
{
	enum hawser_status status = check(rom->term, rom->terms, rom->n, "", report);
	char of[32];

	for (int h = 0; !status && h < rom->harmonics; h++) {
		snprintf(of, sizeof of, "harmonics[%d], ", h);
		status = check(rom->harmonic[h].term, rom->harmonic[h].terms, rom->n, of, report);
	}
	return status;
}
