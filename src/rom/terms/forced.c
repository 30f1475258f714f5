/* rom/terms/forced.c - acceleration of the forced model and its exact derivatives.
 *
 * tau = Omega t is the phase. A harmonic adds s(tau) * (f - D v - K u) with
 * s = Omega^omega_power * cos|sin(k tau); its Q is added to the restoring force (vary.h). A ramp
 * adds the same with s, s^2 and ds/dt of a time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "rom/terms/drag.h"
#include "rom/terms/history.h"
#include "rom/energy/kernel.h"
#include "rom/build/model.h"
#include "rom/terms/terms.h"
#include "rom/terms/vary.h"

static double factor(const struct hawser_harmonic *harmonic, double tau, double omega)
{
	double wave = harmonic->phase == HAWSER_COS ? cos(harmonic->k*tau) : sin(harmonic->k*tau);

	for (int p = 0; p < harmonic->omega_power; p++)
		wave *= omega;
	return wave;
}

/* y -= scale * matrix * x, for a dense [n][n] matrix, column by column: no sum waits for itself. */
static void subtract_product(double *y, double scale, const double *matrix, const double *x, int n)
{
	for (int k = 0; k < n; k++)
		for (int j = 0; j < n; j++)
			y[j] -= scale*matrix[j*n + k]*x[k];
}

/* += s (f - D v - K u) */
static void add_term(double *acceleration, const struct hawser_ramp_term *term, double s,
                     const double *u, const double *v, int n)
{
	for (int j = 0; term->f && j < n; j++)
		acceleration[j] += s*term->f[j];
	if (term->D)
		subtract_product(acceleration, s, term->D, v, n);
	if (term->K)
		subtract_product(acceleration, s, term->K, u, n);
	for (int i = 0; i < term->quads; i++) {
		const struct hawser_quad *q = &term->Q[i];

		acceleration[q->j] -= s*q->value*u[q->k]*u[q->l];
	}
}

static void add_harmonic(double *acceleration, const struct hawser_harmonic *harmonic, double s,
                         const double *u, const double *v, int n)
{
	const struct hawser_ramp_term term = {.f = harmonic->f, .D = harmonic->D,
	                                      .K = harmonic->K};

	add_term(acceleration, &term, s, u, v, n);
}

/* acceleration holds the restoring force on entry. by_v [n][n]: NULL, or += the derivative of drag. */
static void finish(const struct hawser_rom *rom, double *acceleration, double *by_v, const double *u,
                   const double *v, double tau, double omega)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;

	for (int j = 0; j < rom->n; j++)
		acceleration[j] = -acceleration[j];
	for (int i = 0; i < kernel->d_entries; i++)
		acceleration[kernel->d_j[i]] -= kernel->d_val[i]*v[kernel->d_k[i]];
	for (int h = 0; h < rom->harmonics; h++)
		add_harmonic(acceleration, &rom->harmonic[h], factor(&rom->harmonic[h], tau, omega), u,
		             v, rom->n);
	if (rom->drag)
		hawser__drag_add(rom->drag, acceleration, by_v, -1.0, v, 1);
}

void hawser_rom_acceleration(const struct hawser_rom *rom, double *acceleration, const double *u,
                             const double *v, double tau, double omega)
{
	hawser_rom_restoring(rom, acceleration, u);
	hawser__rom_vary_at(rom, acceleration, NULL, u, tau);
	finish(rom, acceleration, NULL, u, v, tau, omega);
	if (hawser__rom_more(rom))
		hawser__rom_more_add(rom, &(struct hawser__more){.force = acceleration, .stride = 1}, u, v,
		                     &tau, omega);
}

void hawser_rom_acceleration_jacobian(const struct hawser_rom *rom, double *acceleration,
                                      double *by_u, double *by_v, double *by_omega,
                                      const double *u, const double *v, double tau, double omega)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	int n = rom->n;

	hawser_rom_tangent(rom, acceleration, by_u, u);
	hawser__rom_vary_at(rom, acceleration, by_u, u, tau);
	for (int i = 0; i < n*n; i++) {
		by_u[i] = -by_u[i];
		by_v[i] = 0.0;
	}
	finish(rom, acceleration, by_v, u, v, tau, omega);
	for (int j = 0; j < n; j++)
		by_omega[j] = 0.0;
	for (int i = 0; i < kernel->d_entries; i++)
		by_v[kernel->d_j[i]*n + kernel->d_k[i]] -= kernel->d_val[i];
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];
		double s = factor(harmonic, tau, omega);

		for (int i = 0; harmonic->K && i < n*n; i++)
			by_u[i] -= s*harmonic->K[i];
		for (int i = 0; harmonic->D && i < n*n; i++)
			by_v[i] -= s*harmonic->D[i];
		if (harmonic->omega_power > 0)
			add_harmonic(by_omega, harmonic, harmonic->omega_power*s/omega, u, v, n);
	}
	if (hawser__rom_more(rom))
		hawser__rom_more_add(rom, &(struct hawser__more){.force = acceleration, .by_u = by_u,
		                     .by_v = by_v, .by_omega = by_omega, .sign = 1.0, .stride = 1}, u, v,
		                     &tau, omega);
}

void hawser__rom_term(const struct hawser_ramp_term *term, double s, double *acceleration,
                      double *by_u, double *by_v, const double *u, const double *v, int n)
{
	add_term(acceleration, term, s, u, v, n);
	for (int i = 0; by_u && term->K && i < n*n; i++)
		by_u[i] -= s*term->K[i];
	for (int i = 0; by_v && term->D && i < n*n; i++)
		by_v[i] -= s*term->D[i];
	for (int i = 0; by_u && i < term->quads; i++) {
		const struct hawser_quad *q = &term->Q[i];

		by_u[q->j*n + q->k] -= s*q->value*u[q->l];
		by_u[q->j*n + q->l] -= s*q->value*u[q->k];
	}
}

void hawser__ramp_factors(double s[HAWSER_RAMP_TERMS], const struct hawser_ramp *ramp, double t,
                          int over)
{
	double part = over ? 1.0 : t/ramp->time;

	s[HAWSER_RAMP_LINEAR] = part;
	s[HAWSER_RAMP_SQUARE] = part*part;
	s[HAWSER_RAMP_RATE] = over ? 0.0 : 1.0/ramp->time;
}

void hawser__rom_ramp(const struct hawser_rom *rom, double *acceleration, double *by_u, double *by_v,
                      const double *u, const double *v, double t, int over)
{
	double s[HAWSER_RAMP_TERMS];

	hawser__ramp_factors(s, rom->ramp, t, over);
	for (int p = 0; p < HAWSER_RAMP_TERMS; p++)
		hawser__rom_term(&rom->ramp->term[p], s[p], acceleration, by_u, by_v, u, v, rom->n);
}

double hawser__rom_ramp_energy(const struct hawser_rom *rom, const double *u, double t)
{
	double s[HAWSER_RAMP_TERMS], energy = 0.0;

	hawser__ramp_factors(s, rom->ramp, t, t >= rom->ramp->time);
	for (int p = HAWSER_RAMP_LINEAR; p <= HAWSER_RAMP_SQUARE; p++) {
		const struct hawser_ramp_term *term = &rom->ramp->term[p];

		for (int j = 0; j < rom->n; j++) {
			double force = term->f ? term->f[j] : 0.0;

			for (int k = 0; term->K && k < rom->n; k++)
				force -= 0.5*term->K[j*rom->n + k]*u[k];
			energy -= s[p]*force*u[j];
		}
	}
	return energy;
}
