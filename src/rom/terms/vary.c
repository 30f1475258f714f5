/* rom/terms/vary.c - terms of the restoring force that vary with the phase and are not linear: the Q of
 * harmonics, and the moving supports of a model with the exact energy. See vary.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/hot.h"
#include "rom/terms/ends.h"
#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"
#include "rom/terms/vary.h"

int hawser__rom_varies(const struct hawser_rom *rom)
{
	if (rom->exact)
		return rom->exact->supports > 0 && !rom->ends->given;
	for (int h = 0; h < rom->harmonics; h++)
		if (rom->harmonic[h].quads > 0)
			return 1;
	return 0;
}

enum { TOGETHER = 16, /* harmonics of the same indices at once */
       STATES = 8, VECS = STATES/HAWSER_BLOCK };

/* Harmonics of the same indices: each entry is the sum of theirs, and is applied once. */
struct group {
	int count;
	const struct hawser_quad *Q[TOGETHER];
	double wave[TOGETHER][STATES];
};

static void add_to(struct group *group, const struct hawser_harmonic *harmonic, const double *tau,
                   int states)
{
	for (int i = 0; i < states; i++)
		group->wave[group->count][i] = harmonic->phase == HAWSER_COS ? cos(harmonic->k*tau[i])
		                               : sin(harmonic->k*tau[i]);
	group->Q[group->count++] = harmonic->Q;
}

/* Add the terms to restoring [n] and, unless NULL, to tangent [n][n], at u [n]. */
static void vary_by(const struct group *group, int quads, double *restoring, double *tangent,
                    const double *u, int n)
{
	for (int i = 0; i < quads; i++) {
		const struct hawser_quad *q = &group->Q[0][i];
		double value = 0.0, x = u[q->k], y = u[q->l];

		for (int g = 0; g < group->count; g++)
			value += group->wave[g][0]*group->Q[g][i].value;
		restoring[q->j] += value*x*y;
		if (!tangent)
			continue;
		tangent[q->j*n + q->k] += value*y;
		tangent[q->j*n + q->l] += value*x;
	}
}

/* The same at STATES states, whose values are next to each other; entries of the same j and k, which
 * follow one another, share what they multiply. */
HAWSER_HOT
static void vary_states(const struct group *group, int quads, double *restoring, double *tangent,
                        const double *u, int n)
{
	const struct hawser_quad *q = group->Q[0];
	hawser__vec *force = (hawser__vec *)restoring, *slope = (hawser__vec *)tangent;

	for (int i = 0; i < quads;) {
		int j = q[i].j, k = q[i].k;
		const hawser__vec *x = (const hawser__vec *)u + VECS*k;
		hawser__vec sum[VECS] = {{0.0}};

		for (; i < quads && q[i].j == j && q[i].k == k; i++) {
			const hawser__vec *y = (const hawser__vec *)u + VECS*q[i].l;
			hawser__vec value[VECS] = {{0.0}};

			for (int g = 0; g < group->count; g++)
				for (int v = 0; v < VECS; v++)
					value[v] += ((const hawser__vec *)group->wave[g])[v]*group->Q[g][i].value;
			for (int v = 0; v < VECS; v++) {
				sum[v] += value[v]*y[v];
				if (slope)
					slope[VECS*(j*n + q[i].l) + v] += value[v]*x[v];
			}
		}
		for (int v = 0; v < VECS; v++) {
			force[VECS*j + v] += sum[v]*x[v];
			if (slope)
				slope[VECS*(j*n + k) + v] += sum[v];
		}
	}
}

/* The first harmonic with the same indices as h. A model that is not compiled does not know it. */
static int first_like(const struct hawser_rom *rom, int h)
{
	return rom->kernel && h < rom->kernel->harmonics ? rom->kernel->alike[h] : h;
}

/* One state, or STATES of them. */
static void vary(const struct hawser_rom *rom, double *restoring, double *tangent, const double *u,
                 const double *tau, int states)
{
	for (int h = 0; h < rom->harmonics; h++) {
		struct group group = {.count = 0};
		int quads = rom->harmonic[h].quads;

		if (quads == 0 || first_like(rom, h) != h)
			continue;
		for (int g = h; g < rom->harmonics; g++) {
			if (first_like(rom, g) == h)
				add_to(&group, &rom->harmonic[g], tau, states);
			if (group.count < TOGETHER && (g + 1 < rom->harmonics || group.count == 0))
				continue;
			if (states > 1)
				vary_states(&group, quads, restoring, tangent, u, rom->n);
			else
				vary_by(&group, quads, restoring, tangent, u, rom->n);
			group.count = 0;
		}
	}
}

void hawser__rom_vary_at(const struct hawser_rom *rom, double *restoring, double *tangent,
                         const double *u, double tau)
{
	double s[HAWSER__SUPPORT_MOST];

	/* those of a history: hawser__rom_history */
	if (rom->exact && rom->exact->supports > 0 && !rom->ends->given) {
		hawser__ends_at(rom, s, &(struct hawser_rom_moment){.tau = tau});
		hawser__exact_vary(rom->exact, restoring, tangent, u, s);
	}
	vary(rom, restoring, tangent, u, &tau, 1);
}

void hawser__rom_vary_eight(const struct hawser_rom *rom, double *restoring, double *tangent,
                            const double *u, int first, int count)
{
	double tau[STATES];

	for (int i = 0; i < STATES; i++)
		tau[i] = 2.0*M_PI*(first + i)/count;
	vary(rom, restoring, tangent, u, tau, STATES);
}

void hawser__rom_vary_lane(const struct hawser_rom *rom, double *restoring, double *tangent,
                           const double *u, double tau, int stride)
{
	double own_u[HAWSER_ROM_MAX] = {0.0}, force[HAWSER_ROM_MAX] = {0.0};
	double T[HAWSER_ROM_MAX*HAWSER_ROM_MAX];
	int n = rom->n;

	for (int j = 0; j < n; j++)
		own_u[j] = u[j*stride];
	for (int i = 0; tangent && i < n*n; i++)
		T[i] = 0.0;
	hawser__rom_vary_at(rom, force, tangent ? T : NULL, own_u, tau);
	for (int j = 0; j < n; j++)
		restoring[j*stride] += force[j];
	for (int i = 0; tangent && i < n*n; i++)
		tangent[i*stride] += T[i];
}

void hawser__rom_vary_all(const struct hawser_rom *rom, double *restoring, double *tangent,
                          const double *u, int count)
{
	size_t n = (size_t)rom->n;

	if (!hawser__rom_varies(rom))
		return;
	for (int i = 0; i < count; i++) {
		size_t at = (size_t)i*n;

		hawser__rom_vary_at(rom, restoring + at, tangent ? tangent + at*n : NULL, u + at,
		                    2.0*M_PI*i/count);
	}
}
