/* study/cost.c - how large a model is, and what its response should take.
 *
 * Entries are counted: a term of the energy with an odd number of out-of-plane coordinates is
 * zero, as the cable is the same seen from either side of its plane. All others are kept.
 *
 * Time is a number of points times the time of a point. A point's time is offset + slope*work,
 * where the work of a model is the operations of one stage of an orbit's integration with its
 * derivative: 6 an entry of the tensors, 8 n^3 for the product with the tangent, and another 2 n^3
 * as the share of what is done once a point (the factorisation, the multipliers). Offset and slope
 * are measured at plan time with a few points of two small condensed models of the scene, so that
 * the machine, its load, the tolerance and the method are in them.
 *
 * The full-order model's point is dense algebra with matrices of its coordinates: its time is that of
 * a point of a small one, by harmonic balance, times the cube of the ratio of the coordinates.
 *
 * The number of points: the longest step allows 1/step of them over the range, and 1 % of Omega at
 * most; every resonance adds what going round its peak takes, and about as many again for every
 * e-fold by which its bend exceeds its width, as the turns about folds get sharper.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <time.h>

#include "core/report.h"
#include "study/survey.h"

static const double step = 0.005;      /* as hawser frf and hawser compare have it */
static const double each = 22.0;       /* points of a resonance */
static const double each_fold = 12.0;  /* more for every e-fold of bend over width */
enum { warm = 4, timed = 16 };         /* points that are left out, and that are run, in a trial */
enum { full_trial = 6, full_timed = 9 }; /* the same of the full-order model, functions and points */

/* Is the i-th of the modes at `index` one out of the plane? */
static int out(const struct hawser_survey *survey, const int *index, int i)
{
	return survey->plan->modes.mode[index ? index[i] : i].plane == HAWSER_OUT_OF_PLANE;
}

void hawser__count_entries(struct hawser_plan_row *row, const struct hawser_survey *survey,
                           const int *index, int n)
{
	row->n = n;
	row->quads = row->cubics = 0;
	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			for (int l = k; l < n; l++) {
				int odd = out(survey, index, j) ^ out(survey, index, k) ^ out(survey, index, l);

				row->quads += !odd;
				for (int m = l; m < n; m++)
					row->cubics += odd == out(survey, index, m);
			}
}

double hawser__work(int n, double entries)
{
	return 6.0*entries + 10.0*pow(n, 3);
}

/* --- the trial --- */

static double seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

struct stopwatch {
	double start, end;
	int points;
};

static int lap(void *context, const struct hawser_frf *frf)
{
	struct stopwatch *watch = context;

	if (frf->points <= warm)
		watch->start = seconds();
	watch->end = seconds();
	watch->points = frf->points;
	return 0;
}

/* Follow the response of a model for some points. */
static enum hawser_status clock_points(double *point_seconds, const struct hawser_rom *rom,
                                       const struct hawser_plan *plan, const char *method,
                                       int points, struct hawser_report *report)
{
	struct hawser_frf_options options = hawser_frf_defaults();
	struct stopwatch watch = {0.0, 0.0, 0};
	struct hawser_frf frf;
	enum hawser_status status;

	options.method = method;
	options.from = plan->from;
	options.to = plan->to;
	options.step_max = step;
	options.max_points = points;
	options.progress = lap;
	options.progress_context = &watch;
	status = hawser_frf_trace(&frf, rom, &options, report);
	*point_seconds = (watch.end - watch.start)/(watch.points > warm ? watch.points - warm : 1);
	hawser_frf_clear(&frf);
	return status;
}

static enum hawser_status try_size(struct hawser_plan_trial *trial,
                                   const struct hawser_survey *survey,
                                   const struct hawser_plan *plan, int n,
                                   struct hawser_report *report)
{
	struct hawser_modes first = plan->modes; /* the first n of them: nothing is copied */
	struct hawser_scene scene = *survey->scene;
	struct hawser_rom rom;
	enum hawser_status status;

	first.n = n;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	status = hawser_rom_build(&rom, &first, &scene, report);
	if (status)
		return status;
	trial->n = n;
	trial->work = hawser__work(n, rom.quads + rom.cubics);
	status = clock_points(&trial->point_seconds, &rom, plan, NULL, timed, report);
	hawser_rom_clear(&rom);
	return status;
}

enum hawser_status hawser__survey_time(struct hawser_survey *survey, struct hawser_plan *plan,
                                       struct hawser_report *report)
{
	int small = plan->modes.n < 4 ? plan->modes.n : 4, large = plan->modes.n < 10 ? plan->modes.n : 10;
	enum hawser_status status = try_size(&plan->trial[0], survey, plan, small, report);
	const struct hawser_plan_trial *trial = plan->trial;

	if (!status)
		status = try_size(&plan->trial[1], survey, plan, large, report);
	if (status)
		return status;
	survey->slope = trial[1].point_seconds/trial[1].work;
	if (trial[1].work > trial[0].work)
		survey->slope = fmax(0.0, (trial[1].point_seconds - trial[0].point_seconds)/
		                          (trial[1].work - trial[0].work));
	survey->offset = fmax(0.0, trial[0].point_seconds - survey->slope*trial[0].work);
	return HAWSER_OK;
}

/* --- the estimate --- */

static double points_of(const struct hawser_survey *survey, int n)
{
	const struct hawser_plan *plan = survey->plan;
	double points = fmax(1.0/step, fabs(log(plan->to/plan->from))/0.01);

	for (int i = 0; i < plan->resonances; i++) {
		const struct hawser_plan_resonance *at = &plan->resonance[i];
		double width = survey->raw.D[(size_t)at->mode*survey->raw.n + at->mode];
		double bend = fabs(at->peak_omega - at->omega);

		if (at->mode < n)
			points += each + each_fold*fmax(0.0, log(bend/width));
	}
	return points;
}

void hawser__estimate_full_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	struct hawser_rom rom;
	double each_point;

	row->points = points_of(survey, survey->plan->modes.n);
	if (hawser_rom_build_full(&rom, &survey->plan->modes.statics, survey->scene, full_trial, NULL))
		return;
	if (!clock_points(&each_point, &rom, survey->plan, "balance", full_timed, NULL))
		row->seconds = row->points*each_point*pow((double)row->n/rom.n, 3);
	hawser_rom_clear(&rom);
}

void hawser__estimate_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	double work = hawser__work(row->n, (double)row->quads + (double)row->cubics);

	row->points = points_of(survey, row->n);
	row->seconds = survey->build_seconds*pow((double)row->n/survey->plan->modes.n, 4) +
	               row->points*(survey->offset + survey->slope*work);
}
