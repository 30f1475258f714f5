/* rom/forced.c - acceleration of the forced model and its exact derivatives.
 *
 * tau = Omega t is the phase. A harmonic adds s(tau) * (f - D v - K u) with
 * s = Omega^omega_power * cos|sin(k tau).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "rom/kernel.h"

static double factor(const struct hawser_harmonic *harmonic, double tau, double omega)
{
	double wave = harmonic->phase == HAWSER_COS ? cos(harmonic->k*tau) : sin(harmonic->k*tau);

	for (int p = 0; p < harmonic->omega_power; p++)
		wave *= omega;
	return wave;
}

/* y -= scale * matrix * x, for a dense [n][n] matrix. */
static void subtract_product(double *y, double scale, const double *matrix, const double *x, int n)
{
	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			y[j] -= scale*matrix[j*n + k]*x[k];
}

static void add_harmonic(double *acceleration, const struct hawser_harmonic *harmonic, double s,
                         const double *u, const double *v, int n)
{
	for (int j = 0; harmonic->f && j < n; j++)
		acceleration[j] += s*harmonic->f[j];
	if (harmonic->D)
		subtract_product(acceleration, s, harmonic->D, v, n);
	if (harmonic->K)
		subtract_product(acceleration, s, harmonic->K, u, n);
}

/* acceleration holds the restoring force on entry. */
static void finish(const struct hawser_rom *rom, double *acceleration, const double *u,
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
}

void hawser_rom_acceleration(const struct hawser_rom *rom, double *acceleration, const double *u,
                             const double *v, double tau, double omega)
{
	hawser_rom_restoring(rom, acceleration, u);
	finish(rom, acceleration, u, v, tau, omega);
}

void hawser_rom_acceleration_jacobian(const struct hawser_rom *rom, double *acceleration,
                                      double *by_u, double *by_v, double *by_omega,
                                      const double *u, const double *v, double tau, double omega)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	int n = rom->n;

	hawser_rom_tangent(rom, acceleration, by_u, u);
	finish(rom, acceleration, u, v, tau, omega);
	for (int i = 0; i < n*n; i++) {
		by_u[i] = -by_u[i];
		by_v[i] = 0.0;
	}
	for (int j = 0; j < n; j++)
		by_omega[j] = 0.0;
	for (int i = 0; i < kernel->d_entries; i++)
		by_v[kernel->d_j[i]*n + kernel->d_k[i]] = -kernel->d_val[i];
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
}
