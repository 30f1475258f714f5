/* response/time/spectrum.c - one-sided amplitude spectrum with a Hann window, by FFTW.
 *
 *    w_i  = (1 - cos(2 pi i/N))/2, the periodic Hann window, sum N/2
 *    A_b  = 2 |sum_i w_i (x_i - m) exp(-2 pi i b/N)| / sum w     (without the factor 2 at the Nyquist
 *           bin)
 *
 * m is the mean weighted by the window, so that bin 0 is zero and a constant has no effect. A tone
 * half-way between two bins has 8/(3 pi) = 0.849 of its amplitude on both: the scalloping loss of
 * the window. At a distance of d bins from a bin it has sin(pi d)/(pi d (1 - d^2)), which is 1 -
 * (pi^2/6 - 1) d^2 for small d. If the window has a whole number of its periods, nothing is lost,
 * and nothing leaks to distant bins. N samples represent N intervals: the sample at the end of the
 * last period is the first one of the next window.
 *
 * FFTW's planner is not thread-safe and is called under a lock; the transforms are not.
 *
 * Reference: Harris, On the use of windows for harmonic analysis with the DFT, Proc. IEEE 66
 * (1978).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdlib.h>

#include <fftw3.h>

#include <hawser/integrate.h>

#include "core/report.h"
#include "response/time/planner.h"

#define WHERE "spectrum"

static enum hawser_status check(const double *samples, int rows, double dt,
                                struct hawser_report *report)
{
	if (rows < 4)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "a spectrum of %d samples: at least 4 are needed, so lengthen the "
		                    "run or shorten the output interval", rows);
	if (!(dt > 0.0) || !isfinite(dt))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the sampling interval is %g: it must be positive", dt);
	for (int i = 0; i < rows; i++)
		if (!isfinite(samples[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, WHERE, "sample %d is %g", i,
			                    samples[i]);
	return HAWSER_OK;
}

static double hann(int i, int rows)
{
	double s = sin(M_PI*i/rows);

	return s*s;
}

static double mean_of(const double *samples, int rows)
{
	double mean = 0.0;

	for (int i = 0; i < rows; i++)
		mean += hann(i, rows)*samples[i];
	return mean/(rows/2.0);
}

static void apply_window(double *windowed, const double *samples, int rows)
{
	double mean = mean_of(samples, rows);

	for (int i = 0; i < rows; i++)
		windowed[i] = hann(i, rows)*(samples[i] - mean);
}

/* Distance from a bin, in bins, that counts as round-off: an interval written with 12 digits has an
 * error of 1e-12, so that 1e6 periods differ by 1e-6 bins. The loss of amplitude is then below
 * 1e-12. */
static const double on_bin = 1e-6;

/* Fraction of the amplitude that a sine `off` bins from a bin lacks there; |off| < 1. */
static double scalloping(double off)
{
	double x = M_PI*off;

	return fabs(off) < 1e-4 ? (M_PI*M_PI/6.0 - 1.0)*off*off : 1.0 - sin(x)/(x*(1.0 - off*off));
}

static struct hawser_spectrum_window window_of(int rows, double period)
{
	double periods = rows/period, off = periods - fmax(1.0, round(periods));

	off = fabs(off) <= on_bin ? 0.0 : off;
	return (struct hawser_spectrum_window){rows, periods, off, scalloping(off)};
}

struct hawser_spectrum_window hawser_spectrum_window(int most, double period)
{
	struct hawser_spectrum_window best = window_of(most, period);

	for (int rows = most - 1; rows >= most - most/2 && best.off != 0.0; rows--) {
		struct hawser_spectrum_window next = window_of(rows, period);

		if (fabs(next.off) < fabs(best.off))
			best = next;
	}
	return best;
}

/* Of an array of hawser__planner_array, which is freed: its transform, *line [rows/2 + 1]. */
static enum hawser_status transform_windowed(fftw_complex **line, double *windowed, int rows,
                                             struct hawser_report *report)
{
	fftw_plan plan = NULL;

	*line = hawser__planner_array((size_t)rows/2 + 1, sizeof **line);
	if (windowed && *line && !hawser__planner_begin()) {
		plan = fftw_plan_dft_r2c_1d(rows, windowed, *line, FFTW_ESTIMATE);
		hawser__planner_unlock();
	}
	if (plan) {
		fftw_execute(plan);
		hawser__planner_lock();
		fftw_destroy_plan(plan);
		hawser__planner_unlock();
	}
	free(windowed);
	return plan ? HAWSER_OK : hawser__no_memory(report, WHERE);
}

enum hawser_status hawser_spectrum(double *frequency, double *amplitude, int *bins,
                                   const double *samples, int rows, double dt,
                                   struct hawser_report *report)
{
	enum hawser_status status = check(samples, rows, dt, report);
	fftw_complex *line = NULL;
	double *windowed;

	if (status)
		return status;
	windowed = hawser__planner_array((size_t)rows, sizeof *windowed);
	if (windowed)
		apply_window(windowed, samples, rows);
	status = transform_windowed(&line, windowed, rows, report);
	*bins = rows/2 + 1;
	for (int b = 0; b < *bins && !status; b++) {
		int alone = b == 0 || 2*b == rows; /* bins without a mirror image, bin 0 and the Nyquist
		                                    * bin */

		frequency[b] = b/(rows*dt);
		amplitude[b] = cabs(line[b])*(alone ? 2.0 : 4.0)/rows;
	}
	free(line);
	return status;
}

/* The derivative of the windowed samples. */
static void apply_slope(double *windowed, const double *samples, const double *rates, int rows,
                        double dt)
{
	double mean = mean_of(samples, rows);

	for (int i = 0; i < rows; i++)
		windowed[i] = hann(i, rows)*rates[i] +
		              M_PI/(rows*dt)*sin(2.0*M_PI*i/rows)*(samples[i] - mean);
}

/* A line at f above the Nyquist frequency appears at f_b = m f_s - f or f - m f_s, and its rate as
 * that of f: the transform of the rates, less i omega_b that of the samples, is m omega_s times the
 * line. Lines at their own frequency fall out. */
enum hawser_status hawser_spectrum_folded(double *amplitude, double *frequency,
                                          const double *samples, const double *rates, int rows,
                                          double dt, struct hawser_report *report)
{
	enum hawser_status status = check(samples, rows, dt, report);
	fftw_complex *line = NULL, *slope = NULL;
	double *windowed[2];

	*amplitude = *frequency = 0.0;
	if (!status)
		status = check(rates, rows, dt, report);
	if (status)
		return status;
	windowed[0] = hawser__planner_array((size_t)rows, sizeof *windowed[0]);
	windowed[1] = hawser__planner_array((size_t)rows, sizeof *windowed[1]);
	if (windowed[0] && windowed[1]) {
		apply_window(windowed[0], samples, rows);
		apply_slope(windowed[1], samples, rates, rows, dt);
	}
	status = transform_windowed(&line, windowed[0], rows, report);
	if (!status)
		status = transform_windowed(&slope, windowed[1], rows, report);
	else
		free(windowed[1]);
	for (int b = 1; 2*b < rows && !status; b++) {
		double f = b/(rows*dt);
		double folded = cabs(slope[b] - I*2.0*M_PI*f*line[b])*4.0/rows*dt/(2.0*M_PI);

		if (folded > *amplitude) {
			*amplitude = folded;
			*frequency = f;
		}
	}
	free(line);
	free(slope);
	return status;
}
