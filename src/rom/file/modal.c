/* rom/file/modal.c - a model in the coordinates of its own modes. With M the mass by whose inverse the
 * equations were multiplied (the unit matrix if there is none), M K must be symmetric: V of M K v =
 * omega^2 M v, V' M V = 1, and u = V q. An equation j becomes the sum over j of W[i][j], W = V' M,
 * and each coordinate of a product a sum over the modes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "rom/file/entries.h"

enum { MOST = 24 };                            /* n^4 entries of C, and as many products each */
static const double symmetric = 1e-9, small = 1e-13; /* relative; what is smaller is round-off */

double hawser_rom_off_diagonal(const struct hawser_rom *rom)
{
	double off = 0.0, most = 0.0;

	for (int j = 0; j < rom->n; j++)
		for (int k = 0; k < rom->n; k++)
			*(j == k ? &most : &off) = fmax(j == k ? most : off, fabs(rom->K[j*rom->n + k]));
	return off > 0.0 ? off/most : 0.0;
}

struct change {
	int n;
	double *V, *W; /* [n][n] V[j*n + i]: coordinate j in mode i; W[i*n + j] */
	double *work;  /* [n][n] */
};

static enum hawser_status check(const struct hawser_rom *rom, struct hawser_report *report)
{
	const char *has = rom->terms > 0 ? "terms" : rom->plug ? "a function" : rom->first ? "first_order"
	                  : rom->exact ? "the exact energy" : rom->ramp || rom->history ? "a history"
	                  : rom->drag ? "drag" : rom->shapes.points > 0 ? "shapes" : NULL;

	for (int h = 0; h < rom->harmonics && !has; h++)
		has = rom->harmonic[h].terms > 0 ? "terms" : NULL;
	if (!has && rom->n <= MOST)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "K is not diagonal, and a model with %s is "
	                    "not brought into the coordinates of its modes: give it in these",
	                    has ? has : "more than 24 coordinates");
}

/* The largest part of each mode is positive. */
static void orient(struct change *change)
{
	int n = change->n;

	for (int i = 0; i < n; i++) {
		double most = 0.0;

		for (int j = 0; j < n; j++)
			if (fabs(change->V[j*n + i]) > fabs(most)*(1.0 + symmetric))
				most = change->V[j*n + i];
		for (int j = 0; most < 0.0 && j < n; j++)
			change->V[j*n + i] = -change->V[j*n + i];
	}
}

/* M K and M, of which the modes follow, into V and work. */
static enum hawser_status modes(struct change *change, double *value, const struct hawser_rom *rom,
                                struct hawser_report *report)
{
	int n = change->n;
	double *A = change->V, *M = change->work, most = 0.0, skew = 0.0;

	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			double sum = 0.0;

			for (int k = 0; k < n; k++)
				sum += (rom->mass ? rom->mass[i*n + k] : i == k)*rom->K[k*n + j];
			A[i*n + j] = sum;
			M[i*n + j] = rom->mass ? rom->mass[i*n + j] : i == j;
			most = fmax(most, fabs(sum));
		}
	for (int i = 0; i < n; i++)
		for (int j = 0; j < i; j++)
			skew = fmax(skew, fabs(A[i*n + j] - A[j*n + i]));
	if (skew > symmetric*most)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "K%s is not symmetric (by %.3g): the "
		                    "model has no real modes, in whose coordinates it is wanted",
		                    rom->mass ? " times the mass" : "", skew);
	if (LAPACKE_dsygvd(LAPACK_ROW_MAJOR, 1, 'V', 'U', n, A, n, M, n, value))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "rom", "the modes of the model were not "
		                    "found: is its mass positive definite?");
	orient(change);
	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			double sum = 0.0;

			for (int k = 0; k < n; k++)
				sum += change->V[k*n + i]*(rom->mass ? rom->mass[k*n + j] : k == j);
			change->W[i*n + j] = sum;
		}
	return HAWSER_OK;
}

/* W A V in place of A; and W f in place of f. */
static void turn_matrix(const struct change *change, double *A)
{
	int n = change->n;

	for (int i = 0; A && i < n; i++)
		for (int j = 0; j < n; j++) {
			change->work[i*n + j] = 0.0;
			for (int k = 0; k < n; k++)
				change->work[i*n + j] += change->W[i*n + k]*A[k*n + j];
		}
	for (int i = 0; A && i < n; i++)
		for (int j = 0; j < n; j++) {
			A[i*n + j] = 0.0;
			for (int k = 0; k < n; k++)
				A[i*n + j] += change->work[i*n + k]*change->V[k*n + j];
		}
}

static void turn_force(const struct change *change, double *f)
{
	int n = change->n;

	for (int i = 0; f && i < n; i++) {
		change->work[i] = 0.0;
		for (int k = 0; k < n; k++)
			change->work[i] += change->W[i*n + k]*f[k];
	}
	if (f)
		memcpy(f, change->work, (size_t)n*sizeof *f);
}

static double largest(const double *value, size_t count)
{
	double most = 0.0;

	for (size_t i = 0; i < count; i++)
		most = fmax(most, fabs(value[i]));
	return most;
}

/* The dense tensor [n][n]...[n] with `factors` coordinates, of one entry more. */
static void spread(const struct change *change, double *dense, int j, const int *factor, int factors,
                   double value)
{
	int n = change->n, all = 1, digit;

	for (int f = 0; f < factors; f++)
		all *= n;
	for (int at = 0; at < all; at++) {
		double product = value;

		digit = at;
		for (int f = factors - 1; f >= 0; f--, digit /= n)
			product *= change->V[factor[f]*n + digit%n];
		for (int i = 0; i < n; i++)
			dense[(size_t)i*(size_t)all + (size_t)at] += change->W[i*n + j]*product;
	}
}

/* A list in place of Q or C, of *count entries with so many indices; NULL if memory is short. */
static void *turn_entries(const struct change *change, void *list, int *count, int indices)
{
	size_t n = (size_t)change->n, all = indices == 3 ? n*n*n : n*n*n*n;
	double *dense = calloc(all, sizeof *dense), least;
	void *turned = dense ? hawser__entries_room(indices, all) : NULL;
	int kept = 0;

	for (int i = 0; turned && i < *count; i++) {
		struct hawser__entry entry = hawser__entry(list, indices, i);

		spread(change, dense, entry.index[0], entry.index + 1, indices - 1, entry.value);
	}
	least = turned ? small*largest(dense, all) : 0.0;
	for (size_t i = 0; turned && i < all; i++) {
		struct hawser__entry entry = {.value = dense[i]};
		size_t at = i;

		for (int k = indices - 1; k >= 0; k--, at /= n)
			entry.index[k] = (int)(at%n);
		if (fabs(dense[i]) > least)
			hawser__entry_put(turned, indices, kept++, entry);
	}
	free(dense);
	free(list);
	*count = kept;
	return turned;
}

static enum hawser_status turn(const struct change *change, struct hawser_rom *rom,
                               const double *value, struct hawser_report *report)
{
	int n = change->n;
	enum hawser_status status = HAWSER_OK;

	if (rom->quads && !(rom->Q = turn_entries(change, rom->Q, &rom->quads, 3)))
		status = hawser__no_memory(report, "rom");
	if (rom->cubics && !(rom->C = turn_entries(change, rom->C, &rom->cubics, 4)))
		status = hawser__no_memory(report, "rom");
	turn_matrix(change, rom->D);
	for (int i = 0; i < n*n; i++)
		rom->K[i] = i%(n + 1) ? 0.0 : value[i/(n + 1)];
	for (int h = 0; h < rom->harmonics && !status; h++) {
		struct hawser_harmonic *harmonic = &rom->harmonic[h];

		turn_force(change, harmonic->f);
		turn_matrix(change, harmonic->D);
		turn_matrix(change, harmonic->K);
		if (harmonic->quads &&
		    !(harmonic->Q = turn_entries(change, harmonic->Q, &harmonic->quads, 3)))
			status = hawser__no_memory(report, "rom");
	}
	free(rom->mass);
	rom->mass = NULL;
	if (!status)
		status = hawser__entries_merge(rom, report);
	return status ? status : hawser_rom_compile(rom, report);
}

enum hawser_status hawser_rom_modal(struct hawser_rom *rom, double *V, struct hawser_report *report)
{
	size_t n = (size_t)rom->n;
	struct change change = {rom->n, V, malloc(n*n*sizeof(double)), malloc(n*n*sizeof(double))};
	double *value = malloc(n*sizeof *value);
	enum hawser_status status = check(rom, report);

	if (!status && (!change.W || !change.work || !value))
		status = hawser__no_memory(report, "rom");
	if (!status)
		status = modes(&change, value, rom, report);
	if (!status)
		status = turn(&change, rom, value, report);
	free(change.W);
	free(change.work);
	free(value);
	return status;
}
