/* rom/choose/drive.c - excitation of the modes of a model, for their selection: loads, the varying
 * speed of a travelling cable, and the coupling of modes by its gyroscopic terms.
 *
 *   F_j   sum of f_j Omega^power over the harmonics k; a sine contributes -i f_j
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/choose/drive.h"

double complex hawser__drive(const struct hawser_rom *rom, int j, int k, double omega)
{
	double complex sum = 0.0;

	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *h = &rom->harmonic[p];

		if (h->k == k && h->f)
			sum += h->f[j]*pow(omega, h->omega_power)*(h->phase == HAWSER_SIN ? -I : 1.0);
	}
	return sum;
}

static int couples(const struct hawser_rom *rom)
{
	for (int i = 0; i < rom->n*rom->n; i++)
		if (i%(rom->n + 1) && rom->D[i] != 0.0)
			return 1;
	return 0;
}

/* (K - Omega^2 + i Omega D) a = F with its off-diagonal terms. */
static enum hawser_status solve(const struct hawser_rom *rom, double complex *a, double omega,
                                struct hawser_report *report)
{
	int n = rom->n, singular;
	double complex *matrix = malloc((size_t)n*(size_t)n*sizeof *matrix);
	int *pivot = malloc((size_t)n*sizeof *pivot);
	enum hawser_status status = matrix && pivot ? HAWSER_OK : hawser__no_memory(report, "choose");

	for (int i = 0; !status && i < n*n; i++)
		matrix[i] = rom->K[i] + I*omega*rom->D[i] - (i%(n + 1) ? 0.0 : omega*omega);
	if (!status) {
		singular = (int)LAPACKE_zgesv(LAPACK_ROW_MAJOR, n, 1, matrix, n, pivot, a, 1);
		if (hawser__lapack_starved(singular))
			status = hawser__no_memory(report, "choose");
		else if (singular)
			status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "choose",
			                      "the linear response at Omega %.9g is infinite (undamped "
			                      "resonance): add damping", omega/rom->time);
	}
	free(matrix);
	free(pivot);
	return status;
}

enum hawser_status hawser__respond(const struct hawser_rom *rom, double complex *a, double omega,
                                   struct hawser_report *report)
{
	int n = rom->n, together = couples(rom);

	for (int j = 0; j < n; j++) {
		double K = rom->K[j*(n + 1)], D = rom->D[j*(n + 1)];

		a[j] = hawser__drive(rom, j, 1, omega);
		if (!together)
			a[j] /= K - omega*omega + I*omega*D;
	}
	return together ? solve(rom, a, omega, report) : HAWSER_OK;
}

enum hawser_status hawser__drives(const struct hawser_rom *rom, double *load,
                                  struct hawser_report *report)
{
	int n = rom->n;
	double complex *a = malloc((size_t)n*sizeof *a);
	enum hawser_status status = a ? HAWSER_OK : hawser__no_memory(report, "choose");

	for (int j = 0; !status && j < n; j++) {
		double w = sqrt(rom->K[j*(n + 1)]);

		load[j] = cabs(hawser__drive(rom, j, 1, w));
		if (!couples(rom))
			continue;
		status = hawser__respond(rom, a, w, report);
		/* by the amplitude at w; where nothing damps the mode, that says what drives it, and how
		 * strongly its own force, or the static force of this amplitude */
		if (!status && rom->D[j*(n + 1)] != 0.0)
			load[j] = cabs(a[j])*w*rom->D[j*(n + 1)];
		else if (!status && load[j] == 0.0)
			load[j] = cabs(a[j])*w*w;
	}
	free(a);
	return status;
}

void hawser__vary(const struct hawser_rom *rom, double *R, double *J, const double *u,
                  const double *rate, double tau, double omega)
{
	int n = rom->n;

	for (int i = 0; i < n*n; i++)
		if (i%(n + 1) && rom->D[i] != 0.0)
			R[i/n] += rom->D[i]*omega*rate[i%n];
	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *h = &rom->harmonic[p];
		double wave = pow(omega, h->omega_power)
		              *(h->phase == HAWSER_SIN ? sin(h->k*tau) : cos(h->k*tau));

		for (int i = 0; h->D && i < n*n; i++)
			R[i/n] += wave*h->D[i]*omega*rate[i%n];
		for (int i = 0; h->K && i < n*n; i++) {
			R[i/n] += wave*h->K[i]*u[i%n];
			if (h->omega_power == 0)
				J[i] += wave*h->K[i];
		}
		for (int i = 0; i < h->quads; i++) {
			const struct hawser_quad *q = &h->Q[i];

			R[q->j] += wave*q->value*u[q->k]*u[q->l];
			J[q->j*n + q->k] += wave*q->value*u[q->l];
			J[q->j*n + q->l] += wave*q->value*u[q->k];
		}
	}
}

double hawser__sway(const struct hawser_rom *rom, int s, int p, int m)
{
	double sum = 0.0;

	for (int i = 0; i < rom->harmonics; i++) {
		const struct hawser_harmonic *h = &rom->harmonic[i];

		if (h->D && h->k == m)
			sum += 0.5*fabs(h->D[s*rom->n + p]);
	}
	return sum*fabs(sqrt(rom->K[s*(rom->n + 1)]) - sqrt(rom->K[p*(rom->n + 1)]));
}
