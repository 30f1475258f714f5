/* response/time/collocated.c - see collocated.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "response/time/collocated.h"

#define S HAWSER__NODES
#define SAFETY 0.9 /* factor on the step, so that an error slightly too large does not repeat it;
                    * chosen */

int hawser__collocated_open(struct hawser__collocated *of, const struct hawser__stepper *problem,
                            const struct hawser__collocated_rule *rule, const double *y0)
{
	size_t n = (size_t)problem->rom->n, size = sizeof(double);

	of->base = *problem;
	of->rule = rule;
	of->from = hawser__hold(&of->hold, 2*n, size);
	of->to = hawser__hold(&of->hold, 2*n, size);
	of->low = hawser__hold(&of->hold, 2*n, size);
	of->alpha = hawser__hold(&of->hold, S*n, size);
	of->trial = hawser__hold(&of->hold, S*n, size);
	of->slope = hawser__hold(&of->hold, S*n, size);
	of->stage = hawser__hold(&of->hold, S*2*n, size);
	if (of->hold.short_of_memory)
		return -1;
	memcpy(of->to, y0, 2*n*sizeof *y0);
	of->begin = of->end = of->base.reached = problem->begin;
	of->next = hawser__stepper_first(problem);
	return 0;
}

int hawser__collocated_predict(struct hawser__collocated *of, double h)
{
	int n = of->base.rom->n;
	double p[S];

	if (of->step == 0.0) {
		double phase = hawser__stepper_phase(&of->base, of->end, of->end_low);

		if (hawser__stepper_acceleration(&of->base, of->slope, of->end, phase, of->to, of->to + n))
			return -1;
		for (int i = 1; i < S; i++)
			memcpy(of->slope + i*n, of->slope, (size_t)n*sizeof(double));
		return 0;
	}
	for (int i = 0; i < S; i++) {
		hawser__legendre(p, 1.0 + 2.0*of->table.node[i]*h/of->step, S);
		for (int k = 0; k < n; k++) {
			double sum = 0.0;

			for (int m = S - 1; m >= 0; m--)
				sum += p[m]*of->alpha[m*n + k];
			of->slope[i*n + k] = sum;
		}
	}
	return 0;
}

void hawser__collocated_transform(const struct hawser__collocated *of, double *out, const double *x,
                                  int stride)
{
	int n = of->base.rom->n;

	for (int m = 0; m < S; m++)
		for (int k = 0; k < n; k++) {
			double sum = 0.0;

			for (int i = 0; i < S; i++)
				sum += of->table.transform[m][i]*x[i*stride + k];
			out[m*n + k] = sum;
		}
}

double hawser__collocated_error(const struct hawser__collocated *of, const double *alpha, double h,
                                const double *weight)
{
	int n = of->base.rom->n;
	double worst = 0.0;

	for (int k = 0; k < n; k++) {
		const double *a = alpha + k;
		double top = fabs(a[(S - 1)*n]), second = fabs(a[(S - 2)*n]);
		double above = fabs(a[(S - 3)*n]) + fabs(a[(S - 4)*n]);
		double decay = above > 0.0 ? fmin(1.0, sqrt((top + second)/above)) : 1.0;
		double left_out = h*decay*fmax(top, decay*second)/(2*S + 1);

		worst = fmax(worst, left_out/weight[n + k]);
		worst = fmax(worst, h*left_out/(2*S + 3)/weight[k]);
	}
	return worst;
}

double hawser__collocated_longer(double error)
{
	return SAFETY*pow(fmax(error, 1e-30), -1.0/(S + 1));
}

void hawser__collocated_add(double *sum, double *low, double term)
{
	double old = *sum, all = term + *low;

	*sum = old + all;
	*low = all - (*sum - old);
}

/* Time left until the end of the run. */
static double left_over(const struct hawser__collocated *of)
{
	return of->base.until - of->end - of->end_low;
}

static void accept(struct hawser__collocated *of, double h)
{
	double *swap = of->alpha;

	of->alpha = of->trial;
	of->trial = swap;
	memcpy(of->from, of->to, 2*(size_t)of->base.rom->n*sizeof *of->from);
	of->rule->accept(of, h);
	of->begin = of->end;
	of->begin_low = of->end_low;
	if (h == left_over(of)) {
		of->end = of->base.until; /* to the last bit */
		of->end_low = 0.0;
	} else {
		hawser__collocated_add(&of->end, &of->end_low, h);
	}
	of->step = of->base.step = h;
	of->base.reached = of->end;
	of->base.steps++;
}

/* The length of the next step: the last steps before `until` get equal lengths, so that none is
 * very short. */
static double attempt(const struct hawser__collocated *of)
{
	double left = left_over(of);
	double next = hawser__stepper_limited(&of->base, of->next);

	if (next >= left)
		return left;
	return next > left/2.0 ? left/2.0 : next;
}

enum hawser_status hawser__collocated_step(struct hawser__stepper *stepper,
                                           struct hawser_report *report)
{
	struct hawser__collocated *of = (struct hawser__collocated *)stepper;
	double shortest = DBL_EPSILON*(16.0*of->end + stepper->until - of->end);

	for (;;) {
		double h = attempt(of), error;

		if (of->next < shortest)
			return hawser__stepper_escaped(stepper, of->to, of->end, of->next, report);
		if (of->rule->solve(of, h)) {
			of->next = h/2.0;
			continue;
		}
		hawser__collocated_transform(of, of->trial, of->slope, stepper->rom->n);
		error = hawser__collocated_error(of, of->trial, h, of->rule->weight(of));
		if (!(error <= 1.0)) {
			of->next = h*fmax(0.2, isfinite(error) ? of->rule->factor(of, error) : 0.0);
			continue;
		}
		accept(of, h);
		if (h == of->next)
			of->next = h*of->rule->factor(of, error);
		return HAWSER_OK;
	}
}

enum hawser_status hawser__collocated_advance(struct hawser__stepper *stepper, double *y, double t,
                                              struct hawser_report *report)
{
	struct hawser__collocated *of = (struct hawser__collocated *)stepper;
	enum hawser_status status;

	while (of->end < t) {
		if (stepper->steps >= stepper->max_steps)
			return hawser__stepper_too_long(stepper, of->end, report);
		if ((status = hawser__collocated_step(stepper, report)))
			return status;
	}
	if (of->end == t && (of->end_low == 0.0 || of->step == 0.0))
		memcpy(y, of->to, 2*(size_t)stepper->rom->n*sizeof *y);
	else
		of->rule->interpolate(of, y, (t - of->begin - of->begin_low)/of->step);
	return HAWSER_OK;
}
