/* study/plan/cost.c - the size of a model, and the points and processor time of its response, by
 * formulas: nothing is traced for them.
 *
 *    n        coordinates of the model
 *    points   of one curve. Its longest step requires a certain number over the range (and at most
 *             1 % of Omega a step); each resonance adds some around its peak. Its folds become
 *             sharper as it bends, which about doubles that number for each factor e by which the
 *             bend exceeds the width.
 *    time     a point takes POINT n^2 s where a factorisation of the reference matrix (below) takes
 *             REFERENCE s: orbit, multipliers and the search for events. bench/plan-times and
 *             bench/defaults.py compare this with the times of runs; nine of ten are within the
 *             factor DOUBT.
 *    work     of full-order models: of the first draft (accuracy_full.c) DRAFT n^3 s as counted
 *             (hawser_orbit_work) where the motion is a tenth of the distance of the supports; less
 *             as a smaller one has fewer harmonics, and more by what the factors e of the bends add
 *
 * Tensor entries are counted, not computed. The cable is symmetric to its plane, so that a term of
 * the energy with an odd number of out-of-plane coordinates is zero. All other entries count.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdio.h>

#include "core/progress.h"
#include "study/accuracy/survey.h"

/* The longest step relative to the range, which hawser frf and hawser compare use. */
static const double step = 0.005;
/* Points around the peak of a resonance, and further ones for each factor e of bend over width: fits to
 * the scenes of bench/plan-times. */
static const double each = 22.0, each_fold = 12.0;
/* Seconds of a point over n^2, of a full-order one (by balance) over n^2, and of closed forms
 * for a mode: likewise. */
#define POINT 1.9e-5
#define POINT_FULL 1.0e-5
#define CLOSED 5e-3
#define REFERENCE 5e-5  /* s: the reference matrix, where these were measured */
#define DOUBT 3.0        /* factor of the times that are stated; bench/plan-times */
/* Curves of a search for an accuracy, with the weighing of modes and the peaks that are traced again,
 * and of `chosen`, for the modes that are kept in the end; and the seconds of a choice among CHOICES
 * modes, with the cube of their number: in the mean of those scenes. */
#define SEARCHED 5.0
#define CHOSEN 2.6
#define CHOICE 0.1
#define CHOICES 26
/* s of work: of this, 1.0 to 3.7e-5 in 31 responses of random and shipped scenes (bench/defaults.py),
 * but 0.6 and 0.8e-5 of two taut stays; where the motion is LARGE, relative to the distance. */
#define DRAFT 2.5e-5
#define LARGE 0.1
#define COUNTED 2.0 /* s over work where the reference matrix takes REFERENCE: the same runs */

/* 1: the i-th of the modes at `index` is out of the plane. */
static int out(const struct hawser_survey *survey, const int *index, int i)
{
	return survey->plan->modes.mode[index ? index[i] : i].plane == HAWSER_OUT_OF_PLANE;
}

/* A model that no load drives has no response. */
static void foresee(struct hawser_plan_row *row, const struct hawser_survey *survey, const int *index)
{
	const double *load = survey->plan->load;
	int driven = !load || survey->raw.harmonics == 0;

	for (int j = 0; j < row->n && j < survey->plan->modes.n && !driven; j++)
		driven = load[index ? index[j] : j] != 0.0;
	if (driven || survey->scene->travel.fluctuation > 0.0)
		return;
	row->status = HAWSER_ERR_ARGUMENT;
	snprintf(row->foreseen, sizeof row->foreseen, "the model has no forcing: the load drives none of "
	         "its modes");
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
	foresee(row, survey, index);
}

/* Without resonances. */
static double least_points(double from, double to, double longest)
{
	return fmax(1.0/longest, fabs(log(to/from))*step/(0.01*longest));
}

/* Number of the resonances in the range, the factors e by which their bends there exceed the widths,
 * and the largest motion. */
static int add_up(double *bends, double *motion, const struct hawser_survey *survey)
{
	const struct hawser_plan *plan = survey->plan;
	double low = fmin(plan->from, plan->to), high = fmax(plan->from, plan->to);
	int count = 0;

	*bends = *motion = 0.0;
	for (int i = 0; i < plan->resonances; i++) {
		const struct hawser_plan_resonance *at = &plan->resonance[i];
		double width = survey->raw.D[(size_t)at->mode*survey->raw.n + at->mode], omega;

		if (!(at->omega > low && at->omega < high))
			continue;
		count++;
		*motion = fmax(*motion, at->motion*hawser__within(&omega, plan, at)/at->peak);
		*bends += fmax(0.0, log(fabs(omega - at->omega)/width));
	}
	return count;
}

static double points_of(const struct hawser_survey *survey, double longest)
{
	const struct hawser_plan *plan = survey->plan;
	double bends, motion;
	int count = add_up(&bends, &motion, survey);

	return least_points(fmin(plan->from, plan->to), fmax(plan->from, plan->to), longest) +
	       each*count + each_fold*bends;
}

double hawser__draft_foreseen(const struct hawser_survey *survey, int n)
{
	double bends, motion;

	add_up(&bends, &motion, survey);
	return DRAFT*pow(n, 3.0)*(1.0 + bends)/(1.0 + fmax(0.0, log10(LARGE/fmax(motion, 1e-10))));
}

/* How much slower this machine is than that of the constants: the least time of a factorisation. */
double hawser__plan_slowness(void)
{
	enum { ORDER = 48, RUNS = 12 };
	double matrix[ORDER*ORDER], least = INFINITY;
	lapack_int pivot[ORDER];

	for (int run = 0; run < RUNS; run++) {
		double start;

		for (int i = 0; i < ORDER*ORDER; i++)
			matrix[i] = i % (ORDER + 1) == 0 ? ORDER : 1.0/(1 + i % 7);
		start = hawser__processor_seconds();
		for (int times = 0; times < 4; times++)
			(void)LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, ORDER, ORDER, matrix, ORDER, pivot);
		least = fmin(least, hawser__processor_seconds() - start);
	}
	return least/REFERENCE;
}

static void take(struct hawser_plan_row *row, double points, double seconds)
{
	row->points = round(points);
	row->seconds = seconds;
	row->least = seconds/DOUBT;
	row->most = seconds*DOUBT;
	row->estimated = 1;
}

static void state(struct hawser_plan_row *row, const struct hawser_survey *survey, double before,
                  double curves, double point, double longest)
{
	double points = points_of(survey, longest);

	take(row, points, survey->slowness*(before + curves*points*point*row->n*row->n));
}

void hawser__estimate_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	state(row, survey, 0.0, 1.0, POINT, step);
}

void hawser__estimate_full_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	state(row, survey, 0.0, 1.0, POINT_FULL, step);
}

/* Of full-order models after `row`, by their work: their response is the answer, or that of `row`. */
void hawser__estimate_work(struct hawser_plan_row *row, const struct hawser_survey *survey, double work,
                           double longest)
{
	take(row, longest > 0.0 ? points_of(survey, longest) : row->points,
	     row->seconds + COUNTED*survey->slowness*work);
}

void hawser__estimate_chosen_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	state(row, survey, CHOICE, CHOSEN, POINT, step);
}

void hawser__estimate_auto_cost(struct hawser_plan_row *row, const struct hawser_survey *survey,
                                double candidates, double longest)
{
	state(row, survey, CHOICE*pow(candidates/CHOICES, 3.0), SEARCHED, POINT, longest);
}

void hawser__estimate_closed_cost(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	take(row, NAN, survey->slowness*CLOSED*row->n);
}

void hawser_plan_model(struct hawser_plan_row *row, const struct hawser_rom *rom, double from,
                       double to, const double *natural, int naturals)
{
	double points = least_points(from, to, step);

	*row = (struct hawser_plan_row){.n = rom->n, .quads = rom->quads, .cubics = rom->cubics,
	                                .omega_error = NAN, .worst = -1};
	for (int k = 0; k < naturals; k++)
		points += natural[k] > fmin(from, to) && natural[k] < fmax(from, to) ? each + each_fold : 0.0;
	take(row, points, hawser__plan_slowness()*points*POINT*rom->n*rom->n);
}
