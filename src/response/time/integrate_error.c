/* response/time/integrate_error.c - error estimate of a trajectory.
 *
 * The tolerances limit the error of a step. The resulting error of the run depends on the motion.
 * The run is therefore repeated with tolerances a hundred times smaller. The distance between the
 * two runs is the error of the first one, except for the error of the second one, which is smaller
 * by about the same factor. The largest distance up to a row counts, since two motions that
 * oscillate about each other coincide at some times.
 *
 * If the tolerances of the second run would be below round-off, it uses another method instead.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "response/time/stepper.h"

#define TIGHTER 0.01 /* tolerance of the second run relative to that of the first: 2 digits */
#define TIGHTEST 1e-15 /* as MIN_RTOL of integrate.c */
/* Factor on the distance: measured (bench/estimates integrate). */
#define SAFETY 3.0
/* Least error in units of the tolerances: in the first steps, which may be the same in both runs,
 * and after these. */
#define BEGINNING 8
#define LEAST_THEN 6.0
#define LEAST 2.0
/* Relative round-off of a step; over a run it accumulates as a random walk. */
#define ROUND_OFF 1e-15

static struct hawser_integrate_options tighter(const struct hawser_integrate_options *options,
                                               const char *method)
{
	struct hawser_integrate_options again = *options;
	double rtol = options->rtol == 0.0 ? HAWSER_DEFAULT_RTOL : options->rtol;
	double atol = options->atol == 0.0 ? HAWSER_DEFAULT_ATOL : options->atol;

	again.rtol = fmax(TIGHTER*rtol, TIGHTEST);
	again.atol = atol*again.rtol/rtol;
	if (again.rtol > 0.5*rtol)
		again.method = strcmp(method, "gauss") ? "gauss" : "adams";
	return again;
}

/* Norm of a - b [m], or of a if b is NULL. */
static double norm(const double *a, const double *b, int m)
{
	double sum = 0.0;

	for (int i = 0; i < m; i++) {
		double part = a[i] - (b ? b[i] : 0.0);

		sum += part*part;
	}
	return sqrt(sum);
}

enum hawser_status hawser_integrate_error(double *error, const struct hawser_trajectory *trajectory,
                                          const struct hawser_rom *rom,
                                          const struct hawser_integrate_options *options,
                                          struct hawser_report *report)
{
	struct hawser_integrate_options again = tighter(options, trajectory->method);
	int m = 2*trajectory->n, rows = trajectory->rows;
	double rtol = options->rtol == 0.0 ? HAWSER_DEFAULT_RTOL : options->rtol, far = 0.0, size = 0.0;
	double atol = options->atol == 0.0 ? HAWSER_DEFAULT_ATOL : options->atol;
	struct hawser_trajectory second;
	enum hawser_status status;

	if (rows < 1)
		return HAWSER_OK;
	/* a run that was interrupted or failed has fewer rows than requested */
	again.until = fmax(trajectory->time[rows - 1], again.begin + again.every);
	status = hawser_integrate(&second, rom, &again, report);
	for (int row = 0; row < rows; row++)
		size = fmax(size, norm(trajectory->state + (size_t)row*m, NULL, m));
	for (int row = second.rows; row < rows; row++)
		error[row] = INFINITY; /* the second run was interrupted */
	for (int row = 0; row < rows && row < second.rows; row++) {
		double steps = (double)trajectory->steps*row/rows;

		far = fmax(far, norm(trajectory->state + (size_t)row*m, second.state + (size_t)row*m, m));
		error[row] = size > 0.0 ? SAFETY*far/size + ROUND_OFF*(1.0 + sqrt(steps)) +
		                          (rtol + atol/size)*(steps < BEGINNING ? LEAST_THEN : LEAST) : 0.0;
	}
	hawser_trajectory_clear(&second);
	return status;
}
