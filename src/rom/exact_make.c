/* rom/exact_make.c - the tables of exact.h from modes on a grid, whatever method they come from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include "rom/exact.h"

void hawser__exact_free(struct hawser_rom_exact *exact)
{
	if (!exact)
		return;
	free(exact->index);
	free(exact->weight);
	free(exact->strain);
	free(exact->slope);
	free(exact->slope_z);
	free(exact->pairs_in);
	free(exact->pairs_out);
	free(exact->mixed);
	free(exact);
}

static double *array(int a, int b)
{
	return calloc((size_t)a*b + 1, sizeof(double));
}

static struct hawser_rom_exact *allocate(const struct hawser_modes *modes)
{
	struct hawser_rom_exact *exact = calloc(1, sizeof *exact);
	int points = modes->grid.points, in = 0, out;

	if (!exact)
		return NULL;
	for (int j = 0; j < modes->n; j++)
		in += modes->mode[j].plane == HAWSER_IN_PLANE;
	out = modes->n - in;
	exact->n = modes->n;
	exact->in = in;
	exact->out = out;
	exact->points = points;
	exact->index = calloc((size_t)modes->n, sizeof *exact->index);
	exact->weight = array(points, 1);
	exact->strain = array(points, 1);
	exact->slope = array(points, 2*in);
	exact->slope_z = array(points, out);
	exact->pairs_in = array(points, 3*in*(in + 1)/2);
	exact->pairs_out = array(points, out*(out + 1)/2);
	exact->mixed = array(points, 2*in*out);
	if (exact->index && exact->weight && exact->strain && exact->slope && exact->slope_z &&
	    exact->pairs_in && exact->pairs_out && exact->mixed)
		return exact;
	hawser__exact_free(exact);
	return NULL;
}

/* The tables of products, at point p. */
static void multiply(struct hawser_rom_exact *exact, int p)
{
	int in = exact->in, out = exact->out, at = 0, many = in*(in + 1)/2;
	const double *a = exact->slope + (size_t)p*2*in, *b = a + in;
	const double *c = exact->slope_z + (size_t)p*out;
	double *pair = exact->pairs_in + (size_t)p*3*many, *mixed = exact->mixed + (size_t)p*2*in*out;
	double *pair_z = exact->pairs_out + (size_t)p*(out*(out + 1)/2);

	for (int k = 0; k < in; k++)
		for (int j = 0; j <= k; j++, at++) {
			pair[at] = a[j]*a[k];
			pair[many + at] = a[j]*b[k] + b[j]*a[k];
			pair[2*many + at] = b[j]*b[k];
		}
	for (int k = 0; k < out; k++)
		for (int j = 0; j <= k; j++)
			*pair_z++ = c[j]*c[k];
	for (int j = 0; j < in; j++)
		for (int k = 0; k < out; k++) {
			mixed[j*out + k] = a[j]*c[k];
			mixed[(in + j)*out + k] = b[j]*c[k];
		}
}

struct hawser_rom_exact *hawser__exact_new(const struct hawser_modes *modes)
{
	struct hawser_rom_exact *exact = allocate(modes);
	int next = 0, next_z, points = modes->grid.points;

	if (!exact)
		return NULL;
	next_z = exact->in;
	for (int j = 0; j < modes->n; j++)
		exact->index[modes->mode[j].plane == HAWSER_IN_PLANE ? next++ : next_z++] = j;
	for (int p = 0; p < points; p++) {
		exact->weight[p] = modes->grid.weight[p]/modes->statics.epsilon;
		exact->strain[p] = hawser_statics_frame(&modes->statics, modes->grid.s[p]).strain;
		for (int i = 0; i < exact->n; i++) {
			const double *slope = modes->slope +
			                      ((size_t)exact->index[i]*points + p)*3;

			if (i < exact->in) {
				exact->slope[(size_t)p*2*exact->in + i] = slope[0];
				exact->slope[((size_t)p*2 + 1)*exact->in + i] = slope[1];
			} else {
				exact->slope_z[(size_t)p*exact->out + i - exact->in] = slope[2];
			}
		}
		multiply(exact, p);
	}
	return exact;
}
