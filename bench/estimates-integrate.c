/* bench/estimates-integrate.c - hawser integrate against extrapolation (Gragg, Bulirsch and Stoer) in
 * extended precision (estimates.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "bench/estimates.h"

enum { COLUMNS = 8, ROOM = 64 };
/* In radians of the fastest coordinate: a macro step, and the longest run. */
static const double macro = 0.4, longest = 1500.0;

typedef long double real;

/* rate [2n] of y [2n]. */
static void rate_of(real *rate, const struct hawser_rom *rom, const real *y, real t, real omega)
{
	int n = rom->n;
	const real *u = y, *v = y + n;

	for (int j = 0; j < n; j++) {
		real sum = 0.0L;

		for (int k = 0; k < n; k++)
			sum -= rom->K[j*n + k]*u[k] + rom->D[j*n + k]*v[k];
		rate[j] = v[j];
		rate[n + j] = sum;
	}
	for (int e = 0; e < rom->quads; e++)
		rate[n + rom->Q[e].j] -= rom->Q[e].value*u[rom->Q[e].k]*u[rom->Q[e].l];
	for (int e = 0; e < rom->cubics; e++)
		rate[n + rom->C[e].j] -= rom->C[e].value*u[rom->C[e].k]*u[rom->C[e].l]*u[rom->C[e].m];
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *p = &rom->harmonic[h];
		real wave = p->phase == HAWSER_COS ? cosl(p->k*omega*t) : sinl(p->k*omega*t);

		wave *= powl(omega, p->omega_power);
		for (int j = 0; j < n; j++) {
			real sum = p->f ? p->f[j] : 0.0L;

			for (int k = 0; k < n; k++)
				sum -= (p->K ? p->K[j*n + k]*u[k] : 0.0L) + (p->D ? p->D[j*n + k]*v[k] : 0.0L);
			rate[n + j] += wave*sum;
		}
	}
}

static void midpoint(real *out, const struct hawser_rom *rom, const real *y, real t, real H,
                     int steps, real omega)
{
	int m = 2*rom->n;
	real h = H/steps, rate[ROOM], old[ROOM], now[ROOM];

	rate_of(rate, rom, y, t, omega);
	for (int i = 0; i < m; i++) {
		old[i] = y[i];
		now[i] = y[i] + h*rate[i];
	}
	for (int k = 1; k < steps; k++) {
		rate_of(rate, rom, now, t + k*h, omega);
		for (int i = 0; i < m; i++) {
			real next = old[i] + 2.0L*h*rate[i];

			old[i] = now[i];
			now[i] = next;
		}
	}
	rate_of(rate, rom, now, t + H, omega);
	for (int i = 0; i < m; i++)
		out[i] = 0.5L*(now[i] + old[i] + h*rate[i]);
}

static void advance(real *y, const struct hawser_rom *rom, real t, real H, real omega)
{
	real table[COLUMNS][ROOM];
	int m = 2*rom->n;

	for (int j = 0; j < COLUMNS; j++) {
		midpoint(table[j], rom, y, t, H, 2*(j + 1), omega);
		for (int k = j - 1; k >= 0; k--) {
			real ratio = (real)((j + 1)*(j + 1))/((k + 1)*(k + 1)) - 1.0L;

			for (int i = 0; i < m; i++)
				table[k][i] = table[k + 1][i] + (table[k + 1][i] - table[k][i])/ratio;
		}
	}
	memcpy(y, table[0], (size_t)m*sizeof *y);
}

int estimate_integrate(struct tally *tally, struct chance *chance)
{
	static const char *const methods[] = {NULL, "gauss", "radau", "adams", "bdf"};
	struct hawser_integrate_options options = {.method = methods[chance_int(chance, 0, 4)]};
	struct hawser_trajectory run = {.n = 0};
	struct hawser_rom rom;
	double fastest = 0.0, *error = NULL, size = 0.0;
	real y[ROOM] = {0.0L};
	int refused, steps, m;

	if (estimate_model(&rom, chance, 0))
		return 1;
	m = 2*rom.n;
	for (int j = 0; j < rom.n; j++)
		fastest = fmax(fastest, sqrt(rom.K[j*rom.n + j]));
	options.omega = sqrt(rom.K[0])*chance_between(chance, 0.5, 1.8);
	options.until = fmin(2.0*M_PI/options.omega*chance_log(chance, 1.0, 60.0), longest/fastest);
	options.every = options.until/chance_int(chance, 4, 20);
	if (chance_unit(chance) < 0.6) {
		options.rtol = chance_log(chance, 1e-12, 1e-4);
		options.atol = 1e-3*options.rtol;
	}
	refused = hawser_integrate(&run, &rom, &options, NULL) != HAWSER_OK;
	error = calloc((size_t)run.rows + 1, sizeof *error);
	refused = refused || !error || m > ROOM ||
	          hawser_integrate_error(error, &run, &rom, &options, NULL);
	for (int i = 0; !refused && i < m; i++)
		y[i] = run.state[i]; /* rest is not 0 for coordinates that are not modes */
	for (int row = 0; !refused && row < run.rows; row++) {
		double sum = 0.0;

		for (int i = 0; i < m; i++)
			sum += pow(run.state[(size_t)row*m + i], 2);
		size = fmax(size, sqrt(sum));
	}
	for (int row = 1; !refused && row < run.rows; row++) {
		double before = run.time[row - 1], span = run.time[row] - before, sum = 0.0;

		steps = (int)ceil(fastest*span/macro);
		for (int k = 0; k < steps; k++)
			advance(y, &rom, (real)before + (real)span*k/steps, (real)span/steps, options.omega);
		for (int i = 0; i < m; i++) {
			double at = run.state[(size_t)row*m + i];

			sum += pow((double)(at - y[i]), 2);
		}
		tally_note(tally, sqrt(sum)/size, error[row], "%s, rtol %.2g, row %d of %d, %g periods, n %d",
		           run.method, options.rtol, row, run.rows,
		           options.until*options.omega/(2.0*M_PI), rom.n);
	}
	free(error);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	return refused;
}
