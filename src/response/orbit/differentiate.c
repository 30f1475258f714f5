/* response/orbit/differentiate.c - see differentiate.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <complex.h>
#include <stddef.h>
#include <stdlib.h>

#include <fftw3.h>

#include "response/orbit/differentiate.h"
#include "response/time/planner.h"

void hawser__differentiate_release(struct hawser__differentiate *rates)
{
	hawser__planner_lock();
	if (rates->analyse)
		fftw_destroy_plan(rates->analyse);
	if (rates->sum)
		fftw_destroy_plan(rates->sum);
	hawser__planner_unlock();
	free(rates->coefficient);
	*rates = (struct hawser__differentiate){0};
}

int hawser__differentiate_prepare(struct hawser__differentiate *rates, int rows, int width)
{
	double *sample;
	fftw_complex *coefficient;

	if (rates->rows == rows && rates->width == width)
		return 0;
	hawser__differentiate_release(rates);
	sample = hawser__planner_array((size_t)rows*width, sizeof *sample);
	rates->coefficient = coefficient = hawser__planner_array((size_t)(rows/2 + 1)*width,
	                                                         sizeof *coefficient);
	if (sample && coefficient && !hawser__planner_begin()) {
		/* estimated plans do not depend on measured times, and thus results do not */
		rates->analyse = fftw_plan_many_dft_r2c(1, &rows, width, sample, NULL, width, 1,
		                                           coefficient, NULL, width, 1,
		                                           FFTW_ESTIMATE | FFTW_UNALIGNED);
		rates->sum = fftw_plan_many_dft_c2r(1, &rows, width, coefficient, NULL, width, 1,
		                                       sample, NULL, width, 1,
		                                       FFTW_ESTIMATE | FFTW_UNALIGNED);
		hawser__planner_unlock();
	}
	free(sample);
	if (!rates->analyse || !rates->sum) {
		hawser__differentiate_release(rates);
		return 1;
	}
	rates->rows = rows;
	rates->width = width;
	return 0;
}

void hawser__differentiate(const struct hawser__differentiate *rates, double *derivative,
                             double *value, double scale)
{
	fftw_complex *coefficient = rates->coefficient;
	int rows = rates->rows, width = rates->width;

	fftw_execute_dft_r2c(rates->analyse, value, coefficient);
	for (int k = 0; k <= rows/2; k++) {
		double factor = 2*k == rows ? 0.0 : k*scale/rows; /* the highest sine is not sampled */

		for (int j = 0; j < width; j++) {
			double complex own = coefficient[(size_t)k*width + j];

			coefficient[(size_t)k*width + j] = CMPLX(-factor*cimag(own), factor*creal(own));
		}
	}
	fftw_execute_dft_c2r(rates->sum, coefficient, derivative);
}
