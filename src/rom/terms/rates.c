/* rom/terms/rates.c - terms of second and third order in velocities alone, by contraction.
 *
 *   z     velocities v_k, then the products v_k v_l, k <= l, then v_k v_l v_m, k <= l <= m
 *   P, W  force = z P with the products of z only, derivative (j, k) = z W without those of three
 *
 * A wind on n modes has almost all n^2 (n + 1) (n + 5)/6 of them: as full matrices they are products
 * with all states of an orbit at once, some hundred times as fast as one by one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "rom/energy/kernel.h"
#include "rom/terms/terms.h"

enum {
	FEW = 20,    /* terms that are as fast one by one; chosen */
	MOST = 40,   /* coordinates: the matrices take 15 MB */
	ROOM = 65536 /* of z, on the stack */
};

struct hawser__rates {
	int n, pairs, length; /* of z */
	double *P;            /* [length - n][n] */
	double *W;            /* [n + pairs][n][n] */
	struct hawser__hold hold;
};

static int pair(int k, int l)
{
	return k <= l ? l*(l + 1)/2 + k : k*(k + 1)/2 + l;
}

static int is_rate(const struct hawser_term *term)
{
	return term->rates == term->factors && (term->rates == 2 || term->rates == 3);
}

static void put(struct hawser__rates *rates, const struct hawser_term *term)
{
	int n = rates->n, three = term->factors == 3, most = 0, product;
	const int *of = term->factor;

	for (int f = 1; f < term->factors; f++)
		most = of[f] > of[most] ? f : most;
	product = pair(of[0], of[1]);
	if (three)
		product = rates->pairs + of[most]*(of[most] + 1)*(of[most] + 2)/6 +
		          pair(of[(most + 1)%3], of[(most + 2)%3]);
	rates->P[product*n + term->j] += term->value;
	for (int f = 0; f < term->factors; f++) {
		int a = of[f == 0], row = three ? n + pair(a, of[f == 2 ? 1 : 2]) : a;

		rates->W[((size_t)row*n + term->j)*n + of[f]] += term->value;
	}
}

static struct hawser__rates *open_rates(const struct hawser_rom *rom)
{
	struct hawser__rates *rates = calloc(1, sizeof *rates);
	size_t n = (size_t)rom->n, pairs = n*(n + 1)/2;

	if (!rates)
		return NULL;
	rates->n = rom->n;
	rates->pairs = (int)pairs;
	rates->length = (int)(n + pairs + pairs*(n + 2)/3);
	rates->P = hawser__hold(&rates->hold, ((size_t)rates->length - n)*n, sizeof(double));
	rates->W = hawser__hold(&rates->hold, (n + pairs)*n*n, sizeof(double));
	if (!rates->hold.short_of_memory) {
		hawser__rates_fill(rates, rom);
		return rates;
	}
	hawser__rates_free(rates);
	return NULL;
}

int hawser__rates_make(struct hawser_rom_kernel *kernel, const struct hawser_rom *rom)
{
	int count = 0, worth;

	for (int i = 0; i < rom->terms; i++)
		count += is_rate(&rom->term[i]);
	worth = count > FEW && rom->n <= MOST;
	kernel->other = hawser__hold(&kernel->hold, (size_t)rom->terms + 1, sizeof *kernel->other);
	kernel->rates = worth ? open_rates(rom) : NULL;
	for (int i = 0; kernel->other && i < rom->terms; i++)
		if (!worth || !is_rate(&rom->term[i]))
			kernel->other[kernel->others++] = i;
	return kernel->other && (kernel->rates || !worth);
}

void hawser__rates_fill(struct hawser__rates *rates, const struct hawser_rom *rom)
{
	size_t n = (size_t)rates->n;

	memset(rates->P, 0, ((size_t)rates->length - n)*n*sizeof(double));
	memset(rates->W, 0, (n + (size_t)rates->pairs)*n*n*sizeof(double));
	for (int i = 0; i < rom->terms; i++)
		if (is_rate(&rom->term[i]))
			put(rates, &rom->term[i]);
}

void hawser__rates_free(struct hawser__rates *rates)
{
	if (rates)
		hawser__hold_clear(&rates->hold);
	free(rates);
}

static void multiply(double *z, const struct hawser__rates *rates, const double *v)
{
	const double *two = z + rates->n;
	double *next = z + rates->n;

	memcpy(z, v, (size_t)rates->n*sizeof *z);
	for (int l = 0; l < rates->n; l++)
		for (int k = 0; k <= l; k++)
			*next++ = v[k]*v[l];
	for (int m = 0; m < rates->n; m++)
		for (int p = 0; p < (m + 1)*(m + 2)/2; p++)
			*next++ = two[p]*v[m];
}

/* to [count][columns] += factor times columns from `first` on of z, `rows` of them, times M. */
static void add(double *to, double factor, const struct hawser__rates *rates, const double *z,
                int first, int rows, const double *M, int columns, int count)
{
	if (count == 1)
		cblas_dgemv(CblasRowMajor, CblasTrans, rows, columns, factor, M, columns, z + first, 1, 1.0,
		            to, 1);
	else
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, count, columns, rows, factor,
		            z + first, rates->length, M, columns, 1.0, to, columns);
}

/* Four states, next to each other. */
static void add_lanes(const struct hawser__rates *rates, const struct hawser__more *to,
                      const double *v)
{
	enum { LANES = HAWSER_LANES };
	double own_v[MOST*LANES] = {0.0}, force[MOST*LANES] = {0.0}, by_v[MOST*MOST*LANES];
	const struct hawser__more own = {.force = force, .by_v = to->by_v ? by_v : NULL, .sign = to->sign,
	                                 .stride = 1};
	int n = rates->n;

	if (to->by_v)
		memset(by_v, 0, (size_t)n*n*LANES*sizeof *by_v);
	for (int i = 0; i < n*LANES; i++)
		own_v[i%LANES*n + i/LANES] = v[i];
	hawser__rates_add(rates, &own, own_v, LANES);
	for (int i = 0; i < n*LANES; i++)
		to->force[i] += force[i%LANES*n + i/LANES];
	for (int i = 0; to->by_v && i < n*n*LANES; i++)
		to->by_v[i] += by_v[i%LANES*n*n + i/LANES];
}

void hawser__rates_add(const struct hawser__rates *rates, const struct hawser__more *to,
                       const double *v, int count)
{
	int n = rates->n, length = rates->length, most = ROOM/length;
	double z[ROOM];

	if (to->stride > 1) {
		add_lanes(rates, to, v);
		return;
	}
	for (int first = 0, some; first < count; first += some) {
		some = count - first < most ? count - first : most;
		for (int r = 0; r < some; r++)
			multiply(z + (size_t)r*length, rates, v + ((size_t)first + r)*n);
		add(to->force + (size_t)first*n, -1.0, rates, z, n, length - n, rates->P, n, some);
		if (to->by_v)
			add(to->by_v + (size_t)first*n*n, -to->sign, rates, z, 0, n + rates->pairs, rates->W,
			    n*n, some);
	}
}
