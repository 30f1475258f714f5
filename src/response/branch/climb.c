/* response/branch/climb.c - branches that climb without end.
 *
 * Without damping a resonance has no peak. Beside its frequency, a multiple or a fraction of it the
 * curve approaches the free motions of a mode and follows them to ever larger amplitudes, while the
 * frequency hardly changes. Such a branch leaves the range after so many points that it is not worth
 * waiting for. It is recognised by its last points: all multipliers are on the unit circle within their
 * error, the amplitude grows, and at the present rate the end of the range is thousands of points away.
 *
 * With damping, however small, multipliers are inside the circle, or the amplitude passes a peak; where
 * the damping is less than the error of the multipliers, that peak is not reached.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "response/branch/trace.h"

#define WINDOW 200 /* number of points looked at; folds and peaks take fewer, 10 to 60 */
#define FAR 5000   /* number of points beyond which the end of the range is out of reach; a smooth
                    * curve takes some 100 for a change of Omega by a factor of 2; chosen */
#define WEAK 0.01  /* mean decay a period of a model that is called undamped: a damping ratio of 0.16 %
                    * at the forcing frequency; a resonance then bends 600 times the static amplitude */
#define CHECKS 4   /* parts of the window over each of which the amplitude has to grow; chosen */

static const struct hawser_frf_point *point(const struct hawser__trace *trace, int back)
{
	return &trace->frf->point[trace->frf->points - 1 - back];
}

static double amplitude(const struct hawser__trace *trace, int back, int j)
{
	const struct hawser_frf *frf = trace->frf;

	return frf->coordinate[(size_t)(frf->points - 1 - back)*(size_t)frf->n + (size_t)j];
}

/* Index of the coordinate with the largest relative change of its amplitude over the window. */
static int most_changed(const struct hawser__trace *trace)
{
	double most = -1.0;
	int best = 0;

	for (int j = 0; j < trace->frf->n; j++) {
		double change = fabs(amplitude(trace, 0, j) - amplitude(trace, WINDOW, j))/
		                fmax(amplitude(trace, WINDOW, j), 1e-300);

		if (change > most) {
			most = change;
			best = j;
		}
	}
	return best;
}

static int grows(const struct hawser__trace *trace, int j)
{
	int step = WINDOW/CHECKS;

	for (int i = 0; i < CHECKS; i++)
		if (!(amplitude(trace, i*step, j) > amplitude(trace, (i + 1)*step, j)))
			return 0;
	return 1;
}

/* Number of points to the end of the range that Omega approaches, at the rate of the window. */
static double points_left(const struct hawser__trace *trace)
{
	double now = point(trace, 0)->parameter, change = now - point(trace, WINDOW)->parameter;
	double left = change > 0.0 ? trace->hi - now : now - trace->lo;

	return left*WINDOW/fmax(fabs(change), 1e-300);
}

/* Mean decay of the multipliers of the last point, -log|mu|: by Liouville's formula that of the damping
 * over a period, which is exact where single multipliers are not. */
static double decay(const struct hawser_frf *frf)
{
	const double *multiplier = frf->multiplier + ((size_t)frf->points - 1)*4*(size_t)frf->n;
	double sum = 0.0;

	for (int i = 0; i < 2*frf->n; i++)
		sum -= multiplier[2*i];
	return sum/(2*frf->n);
}

int hawser__trace_undamped(const struct hawser__trace *trace)
{
	return trace->frf->points > 0 && point(trace, 0)->undecided > 0 && decay(trace->frf) < WEAK;
}

enum hawser_status hawser__trace_climbs(const struct hawser__trace *trace)
{
	const struct hawser_frf *frf = trace->frf;
	int j;

	if (frf->points <= WINDOW || !hawser__trace_undamped(trace) || !(points_left(trace) > FAR))
		return HAWSER_OK;
	for (int back = 0; back <= WINDOW; back++)
		if (point(trace, back)->undecided == 0)
			return HAWSER_OK;
	j = most_changed(trace);
	if (!grows(trace, j))
		return HAWSER_OK;
	return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf", frf->points, 0.0,
	                       "the curve climbs without end near %s: over the last %d points "
	                       "coordinate %d grew by a factor %.3g and %s changed by %.2g of "
	                       "itself, so that the end of the range is %.0f points away at this "
	                       "rate; without damping a resonance has no peak: give the model damping, "
	                       "or end the range before the resonance",
	                       hawser__orbit_where(trace->orbit, point(trace, 0)->parameter).text,
	                       WINDOW, j + 1,
	                       amplitude(trace, 0, j)/amplitude(trace, WINDOW, j),
	                       trace->options.family ? "the parameter" : "Omega",
	                       fabs(point(trace, 0)->parameter/point(trace, WINDOW)->parameter - 1.0),
	                       points_left(trace));
}
