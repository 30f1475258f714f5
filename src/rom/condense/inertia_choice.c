/* rom/condense/inertia_choice.c - see inertia.h; of motions it knows their products alone.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "rom/condense/inertia.h"

#define DEPENDENT 1e-10 /* relative mass of linearly dependent motions: far above round-off */

struct choosing {
	int count, own;      /* motions; vibrations */
	double *value;       /* [count] omega^2, 0 if used */
	double *combination; /* [count][own] of the motions */
	double *part;        /* [count][own] products of motions and vibrations in mass */
	double *square;      /* [count] what is left of the error of a motion */
	double *gram, *half; /* [count][count] work */
};

/* The vibration modes: orthonormal in mass, diagonal in stiffness. */
static enum hawser_status vibrate(struct choosing *c, const double *cross, const double *mass,
                                  const double *stiffness, struct hawser_report *report)
{
	int count = c->count, info;

	memcpy(c->gram, mass, (size_t)count*(size_t)count*sizeof *mass);
	info = LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'V', 'L', count, c->gram, count, c->value);
	while (!info && c->own < count && c->value[count - 1 - c->own] > DEPENDENT*c->value[count - 1])
		c->own++;
	for (int x = 0; x < count; x++)
		for (int i = 0; i < c->own; i++)
			c->half[x*c->own + i] = c->gram[x*count + count - c->own + i]/
			                        sqrt(c->value[count - c->own + i]);
	if (!info && c->own > 0) {
		cblas_dsymm(CblasRowMajor, CblasLeft, CblasLower, count, c->own, 1.0, stiffness, count, c->half,
		            c->own, 0.0, c->part, c->own);
		cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, c->own, c->own, count, 1.0, c->half,
		            c->own, c->part, c->own, 0.0, c->gram, c->own);
		info = LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'V', 'L', c->own, c->gram, c->own, c->value);
	}
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "rom");
	if (info || c->own == 0)
		return hawser__fail(report, HAWSER_ERR_NAN, "rom", "the second-order shapes of %d motions of "
		                    "condensed modes could not be computed: check EA, rho and the tension",
		                    count);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, count, c->own, c->own, 1.0, c->half, c->own,
	            c->gram, c->own, 0.0, c->combination, c->own);
	cblas_dsymm(CblasRowMajor, CblasLeft, CblasLower, count, c->own, 1.0, cross, count, c->combination,
	            c->own, 0.0, c->part, c->own);
	return HAWSER_OK;
}

/* The vibration that contributes most to the motion with the largest remainder; its contribution is
 * taken from all of them. */
static int take(struct choosing *c)
{
	size_t row = cblas_idamax(c->count, c->square, 1);
	double most = -1.0;
	int best = 0;

	for (int i = 0; i < c->own; i++)
		if (c->value[i] > 0.0 && fabs(c->part[(int)row*c->own + i]) > most) {
			most = fabs(c->part[(int)row*c->own + i]);
			best = i;
		}
	for (int x = 0; x < c->count; x++)
		c->square[x] -= c->part[x*c->own + best]*c->part[x*c->own + best];
	return best;
}

static double largest(const struct choosing *c)
{
	double most = 0.0;

	for (int x = 0; x < c->count; x++)
		most = fmax(most, c->square[x]);
	return most;
}

enum hawser_status hawser__inertia_choose(struct hawser_rom_inertia *inertia, double *combination,
                                          double *omega, const double *square, const double *cross,
                                          const double *mass, const double *stiffness, int count,
                                          double allowed, struct hawser_report *report)
{
	size_t n = (size_t)count;
	struct hawser__hold hold = {.last = NULL};
	struct choosing c = {.count = count, .value = hawser__hold(&hold, n, sizeof(double)),
		.combination = hawser__hold(&hold, n*n, sizeof(double)),
		.part = hawser__hold(&hold, n*n, sizeof(double)),
		.square = hawser__hold(&hold, n, sizeof(double)),
		.gram = hawser__hold(&hold, n*n, sizeof(double)),
		.half = hawser__hold(&hold, n*n, sizeof(double))};
	enum hawser_status status = hold.short_of_memory ? hawser__no_memory(report, "rom") : HAWSER_OK;

	*inertia = (struct hawser_rom_inertia){.shapes = 0};
	for (int x = 0; x < count && !status; x++)
		c.square[x] = square[x];
	if (!status)
		inertia->shift = inertia->left = largest(&c);
	if (!status && inertia->left > allowed)
		status = vibrate(&c, cross, mass, stiffness, report);
	while (!status && inertia->left > allowed && inertia->shapes < HAWSER__INERTIA_MOST &&
	       inertia->shapes < c.own) {
		int best = take(&c);

		for (int x = 0; x < count; x++)
			combination[inertia->shapes*count + x] = c.combination[x*c.own + best];
		omega[inertia->shapes++] = sqrt(c.value[best]);
		c.value[best] = 0.0;
		inertia->left = largest(&c);
	}
	hawser__hold_clear(&hold);
	return status;
}
