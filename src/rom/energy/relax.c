/* rom/energy/relax.c - minimum of the energy of a model over some of its coordinates.
 *
 *   y     coordinates: the held ones are given, the others sought
 *   R, T  restoring force and tangent at y, of all coordinates
 *
 * Newton's method. The energy of a cable in tension is convex, and its minimum is then found from
 * everywhere. Where T is not positive definite (in compression, or beyond the range of tensors) a
 * step with a shifted T descends, and a line search halves steps that do not reduce the energy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <string.h>

#include "rom/energy/law.h"

enum { STEPS = 40, HALVINGS = 12 }; /* most Newton steps; halvings of a step that does not reduce
                                     * the energy; chosen */
#define SMALL 1e-9 /* last Newton step, relative to the size of the motion; chosen */
#define SURE 1e-4  /* smaller steps, relative, are accepted without a check of the energy, which is
                    * then round-off */
#define PART 0.02  /* fraction of a motion at which the quadratic terms are measured; chosen small */

int hawser__relax_new(struct hawser__relax *w, const struct hawser_rom *rom)
{
	size_t N = (size_t)rom->n;

	*w = (struct hawser__relax){.rom = rom, .N = rom->n};
	w->freed = hawser__hold(&w->hold, N, sizeof *w->freed);
	w->y = hawser__hold(&w->hold, N, sizeof(double));
	w->trial = hawser__hold(&w->hold, N, sizeof(double));
	w->rest = hawser__hold(&w->hold, N, sizeof(double));
	w->R = hawser__hold(&w->hold, N, sizeof(double));
	w->T = hawser__hold(&w->hold, N*N, sizeof(double));
	w->step = hawser__hold(&w->hold, N, sizeof(double));
	w->matrix = hawser__hold(&w->hold, N*N, sizeof(double));
	return w->hold.short_of_memory;
}

void hawser__relax_clear(struct hawser__relax *w)
{
	hawser__hold_clear(&w->hold);
	*w = (struct hawser__relax){.N = 0};
}

void hawser__relax_place(struct hawser__relax *w)
{
	const struct hawser_rom *rom = w->rom;
	int N = w->N;

	for (int i = 0; i < w->frees; i++)
		w->y[w->freed[i]] = 0.0;
	for (int i = 0; i < N; i++)
		w->trial[i] = PART*w->y[i];
	hawser_rom_restoring(rom, w->R, w->trial);
	cblas_dscal(N, -1.0, w->trial, 1);
	hawser_rom_restoring(rom, w->step, w->trial);
	for (int k = 0; k < w->frees; k++) {
		int i = w->freed[k];

		w->y[i] = -0.5*(w->R[i] + w->step[i])/(PART*PART*rom->K[(size_t)i*((size_t)N + 1)]);
	}
}

/* -(T + more K)^-1 R of the relaxed coordinates; returns 0 if the matrix is not positive definite.
 * It is stored by columns, since for rows LAPACKE allocates a transposed copy and prints to
 * standard output if it gets no memory. */
static int solve(struct hawser__relax *w, double more)
{
	int m = w->frees, lda = m > 0 ? m : 1;

	for (int i = 0; i < m; i++) {
		size_t row = (size_t)w->freed[i]*(size_t)w->N;

		w->step[i] = -w->R[w->freed[i]];
		for (int k = 0; k <= i; k++)
			w->matrix[(size_t)k*(size_t)m + (size_t)i] = w->T[row + (size_t)w->freed[k]];
		w->matrix[(size_t)i*((size_t)m + 1)] += more*w->rom->K[row + (size_t)w->freed[i]];
	}
	return LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', m, w->matrix, lda) == 0 &&
	       LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'L', m, 1, w->matrix, lda, w->step, lda) == 0;
}

/* A Newton step; if T is not positive definite, a shorter descent step with a shifted T. Returns 1
 * for a Newton step, -1 for a shifted one, 0 for none. */
static int newton(struct hawser__relax *w)
{
	hawser_rom_tangent(w->rom, w->R, w->T, w->y);
	if (solve(w, 0.0))
		return 1;
	for (double more = 0.01; more < 100.0; more *= 10.0)
		if (solve(w, more))
			return -1;
	return 0;
}

/* Line search: halve the step until the energy decreases. */
static void go(struct hawser__relax *w, double size)
{
	double before = hawser_rom_energy(w->rom, w->y, w->rest), part = 1.0;

	for (int i = 0; i < HALVINGS; i++, part *= 0.5) {
		memcpy(w->trial, w->y, (size_t)w->N*sizeof *w->trial);
		for (int k = 0; k < w->frees; k++)
			w->trial[w->freed[k]] += part*w->step[k];
		if (cblas_dnrm2(w->frees, w->step, 1) < SURE*size ||
		    hawser_rom_energy(w->rom, w->trial, w->rest) < before)
			break;
	}
	memcpy(w->y, w->trial, (size_t)w->N*sizeof *w->y);
}

int hawser__relax(struct hawser__relax *w, double size)
{
	for (int i = 0; i < STEPS; i++) {
		int way = newton(w);

		if (way == 0)
			return 0;
		if (way > 0 && !(cblas_dnrm2(w->frees, w->step, 1) > SMALL*size))
			return 1;
		go(w, size);
	}
	return 0;
}

void hawser__relax_along(struct hawser__relax *w, int held, double du)
{
	const double *T = w->T + (size_t)held*(size_t)w->N;
	int m = w->frees, lda = m > 0 ? m : 1;

	for (int i = 0; i < m; i++) {
		w->y[w->freed[i]] += w->step[i];
		w->step[i] = -du*T[w->freed[i]];
	}
	w->y[held] += du;
	/* with a factor of the right size this cannot fail */
	if (LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'L', m, 1, w->matrix, lda, w->step, lda) == 0)
		for (int i = 0; i < m; i++)
			w->y[w->freed[i]] += w->step[i];
}
