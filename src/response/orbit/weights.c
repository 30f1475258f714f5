/* response/orbit/weights.c - see weights.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "response/orbit/weights.h"

int hawser__weights_init(struct hawser__weights *weights, const struct hawser__stepper *stepper)
{
	int n = stepper->rom->n;
	double lowest = INFINITY;

	if (!(weights->weight = calloc(6*(size_t)n, sizeof(double))))
		return -1;
	weights->past = weights->weight + 2*n;
	weights->now = weights->past + 2*n;
	for (int k = 0; k < n; k++)
		if (stepper->rom->K[k*n + k] > 0.0)
			lowest = fmin(lowest, sqrt(stepper->rom->K[k*n + k]));
	weights->forget = isfinite(lowest) ? lowest/(2.0*M_PI) : 0.0;
	return 0;
}

void hawser__weights_clear(struct hawser__weights *weights)
{
	free(weights->weight);
}

void hawser__weights_set(struct hawser__weights *weights, const struct hawser__stepper *stepper,
                         const double *y, const double *stage, int count, double h)
{
	int n = stepper->rom->n;
	double keep = exp(-h*weights->forget);

	for (int k = 0; k < 2*n; k++) {
		double size = fmax(fabs(y[k]), keep*weights->past[k]);

		for (int i = 0; i < count; i++)
			size = fmax(size, fabs(stage[i*2*n + k]));
		if (k >= n)
			size = fmax(size, sqrt(fmax(stepper->rom->K[(k - n)*(n + 1)], 0.0))*
			                  weights->now[k - n]);
		weights->now[k] = size;
		weights->weight[k] = stepper->rtol*size + stepper->atol;
	}
}

void hawser__weights_keep(struct hawser__weights *weights)
{
	double *swap = weights->past;

	weights->past = weights->now;
	weights->now = swap;
}
