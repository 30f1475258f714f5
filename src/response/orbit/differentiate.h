/* response/orbit/differentiate.h - derivatives of periodic functions that are sampled at
 * equidistant phases, through their Fourier coefficients.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_DIFFERENTIATE_H
#define HAWSER_RESPONSE_DIFFERENTIATE_H

struct hawser__differentiate {
	int rows, width;     /* number of phases and of functions */
	void *analyse, *sum; /* plans of FFTW */
	void *coefficient;   /* [rows/2 + 1][width] complex */
};

/* Makes the plans for `width` functions at `rows` phases, unless they are made; *rates is zero
 * before the first call. 1: no memory. */
int hawser__differentiate_prepare(struct hawser__differentiate *rates, int rows, int width);
void hawser__differentiate_release(struct hawser__differentiate *rates);

/* derivative [rows][width], by the phase in rad, times `scale`, of value [rows][width]. */
void hawser__differentiate(const struct hawser__differentiate *rates, double *derivative,
                           double *value, double scale);

#endif
