/* response/integrate_error.c - how far a trajectory is from the true one.
 *
 * Tolerances are of a step. What a whole run makes of them depends on the motion, so the run is
 * done again with tolerances a hundred times as tight, and the distance of the two is the error,
 * but for what the second one is off by: the errors of the methods fall about with their
 * tolerances. The largest distance up to a row counts, for two motions that swing about each other
 * meet now and then.
 *
 * Where the second run would be beyond round-off it is done with another method.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/stepper.h"

#define TIGHTER 0.01 /* tolerance of the second run, of the first: 2 digits */
#define TIGHTEST 1e-15 /* as MIN_RTOL of integrate.c */
/* On the distance: measured (bench/estimates integrate). */
#define SAFETY 3.0
/* Of the tolerances, at least: in the first steps, which both runs may take alike, and after these. */
#define BEGINNING 8
#define LEAST_THEN 6.0
#define LEAST 2.0
/* Of a row: what a step adds by rounding, relative, as a random walk. */
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

/* Of a - b [m], or of a where b is NULL. */
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
	/* a run that was interrupted, or failed, has fewer rows than asked for */
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
