/* study/plan/foresee.c - the error that hawser frf would state of modes that are kept, before anything is
 * traced: the same sum (accuracy/fixed.c), in motions that are foreseen instead of computed.
 *
 *    u      [ROWS][n] a motion of all modes over a period
 *    a      amplitude of a resonance at its peak by multiple scales or, where its backbone leaves the
 *           range before, there
 *    Gamma  the backbone is omega + Gamma a^2
 *
 * The motions are those of the primary resonances, each alone, to second order in a, so that the modes
 * that answer at 2 Omega and in the mean have their part; and the linear response at both ends of the
 * range, no mode of which moves more than the largest resonance. What resonances share with each other
 * is not foreseen (decide.c and the column `meets` name such modes).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/primary.h>

#include "core/report.h"
#include "rom/choose/drive.h"
#include "rom/choose/weigh.h"
#include "study/accuracy/accuracy.h"
#include "study/accuracy/survey.h"

enum { ROWS = 32 }; /* phases of a period: resolves 16 harmonics */
#define FAINT 0.25  /* smallest motion beside the largest that is weighed; chosen, below the half of
                     * the peaks whose error hawser frf states */

/* Largest amplitude of a resonance within the range, and its frequency there. */
static double within(double *omega, const struct hawser_plan *plan,
                     const struct hawser_plan_resonance *at)
{
	double gamma = (at->peak_omega - at->omega)/(at->peak*at->peak), a = at->peak;
	double room = gamma > 0.0 ? fmax(plan->from, plan->to) - at->omega
	                          : at->omega - fmin(plan->from, plan->to);

	if (fabs(gamma)*a*a > room)
		a = sqrt(room/fabs(gamma));
	*omega = at->omega + gamma*a*a;
	return a;
}

/* Near an internal resonance the second order of another mode has no bound: at most the amplitude of
 * this one. u [ROWS] with this stride. */
static void limit(double *u, int stride, double a)
{
	double most = 0.0;

	for (int t = 0; t < ROWS; t++)
		most = fmax(most, fabs(u[t*stride]));
	for (int t = 0; t < ROWS && most > a; t++)
		u[t*stride] *= a/most;
}

/* A resonance: by its modulation equation, or by its mode alone where another one is in exact resonance
 * with it. */
static enum hawser_status resonate(double *u, double a, const struct hawser_survey *survey,
                                   const struct hawser_plan_resonance *at,
                                   struct hawser_report *report)
{
	const struct hawser_rom *rom = survey->condensed;
	struct hawser_report unused;
	struct hawser_primary primary;
	enum hawser_status status = hawser_primary_derive(&primary, rom, at->mode, &unused);
	double x[2];

	if (status == HAWSER_ERR_MEMORY)
		return hawser__no_memory(report, "plan");
	if (!status)
		for (int i = 0; i < 2; i++) /* a quarter of a period behind the load */
			x[i] = (i ? -0.5 : 0.5)*a*primary.load[!i]/hypot(primary.load[0], primary.load[1]);
	for (int t = 0; t < ROWS; t++) {
		double *row = u + (size_t)t*(size_t)rom->n, tau = 2.0*M_PI*t/ROWS;

		if (status)
			row[at->mode] = a*sin(tau);
		else
			hawser_modulation_motion(&primary.modulation, row, x, tau);
	}
	for (int j = 0; j < rom->n; j++)
		limit(u + j, rom->n, a);
	if (!status)
		hawser_primary_clear(&primary);
	return HAWSER_OK;
}

/* The linear response, with amplitudes of at most `most`. */
static enum hawser_status respond(double *u, double most, double omega,
                                  const struct hawser_survey *survey, struct hawser_report *report)
{
	int n = survey->condensed->n;
	double complex *a = malloc((size_t)n*sizeof *a);
	enum hawser_status status = a ? hawser__respond(survey->condensed, a, omega, report)
	                              : hawser__no_memory(report, "plan");

	for (int t = 0; !status && t < ROWS; t++)
		for (int j = 0; j < n; j++)
			u[t*n + j] = creal(a[j]*fmin(1.0, most/fmax(cabs(a[j]), 1e-300))*
			                   cexp(I*2.0*M_PI*t/ROWS));
	free(a);
	return status;
}

/* Largest mean square of a motion in a plane. */
static double mean_square(const double *u, const struct hawser_modes *modes)
{
	double sum[2] = {0.0};

	for (int i = 0; i < ROWS*modes->n; i++)
		sum[modes->mode[i % modes->n].plane == HAWSER_OUT_OF_PLANE] += u[i]*u[i];
	return fmax(sum[0], sum[1]);
}

static void swap(struct hawser_survey *survey, int i, int j)
{
	size_t size = (size_t)ROWS*(size_t)survey->condensed->n;
	double *a = survey->u + (size_t)i*size, *b = survey->u + (size_t)j*size, omega = survey->omega[i];

	survey->omega[i] = survey->omega[j];
	survey->omega[j] = omega;
	for (size_t k = 0; i != j && k < size; k++) {
		double x = a[k];

		a[k] = b[k];
		b[k] = x;
	}
}

/* The largest motion first; those that are not FAINT beside it stay. */
static void keep_strong(struct hawser_survey *survey)
{
	size_t size = (size_t)ROWS*(size_t)survey->condensed->n;
	const struct hawser_modes *modes = &survey->plan->modes;
	int kept = 1;
	double most;

	for (int i = 1; i < survey->motions; i++)
		if (mean_square(survey->u + (size_t)i*size, modes) > mean_square(survey->u, modes))
			swap(survey, 0, i);
	most = mean_square(survey->u, modes);
	for (int i = 1; i < survey->motions; i++)
		if (mean_square(survey->u + (size_t)i*size, modes) >= FAINT*FAINT*most)
			swap(survey, kept++, i);
	survey->motions = kept;
}

enum hawser_status hawser__foresee_motions(struct hawser_survey *survey, struct hawser_report *report)
{
	const struct hawser_plan *plan = survey->plan;
	size_t size = (size_t)ROWS*(size_t)survey->condensed->n;
	double *u = calloc(((size_t)plan->resonances + 2)*size, sizeof *u), most = 0.0;
	enum hawser_status status = HAWSER_OK;

	survey->u = u;
	survey->omega = calloc((size_t)plan->resonances + 2, sizeof *survey->omega);
	if (!u || !survey->omega)
		return hawser__no_memory(report, "plan");
	for (int i = 0; !status && i < plan->resonances; i++, u += size) {
		double a = within(&survey->omega[survey->motions++], plan, &plan->resonance[i]);

		most = fmax(most, a);
		status = resonate(u, a, survey, &plan->resonance[i], report);
	}
	for (int end = 0; !status && end < 2; end++, u += size) {
		survey->omega[survey->motions++] = end ? plan->to : plan->from;
		status = respond(u, most > 0.0 ? most : HUGE_VAL, end ? plan->to : plan->from, survey, report);
	}
	if (!status)
		keep_strong(survey);
	return status;
}

void hawser__foresee_clear(struct hawser_survey *survey)
{
	if (survey->choice)
		hawser_choice_clear(survey->choice);
	free(survey->choice);
	free(survey->u);
	free(survey->omega);
}

enum hawser_status hawser__foresee(struct hawser_accuracy_fixed *fixed,
                                   const struct hawser_survey *survey, const int *kept, int count,
                                   struct hawser_report *report)
{
	struct hawser_choice *choice = survey->choice;
	enum hawser_status status = HAWSER_OK;

	*fixed = (struct hawser_accuracy_fixed){.estimated = NAN};
	if (!choice)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "plan", "%s", survey->unweighed);
	for (int j = 0; j < choice->n; j++)
		choice->mode[j].kept = !kept && j < count;
	for (int i = 0; kept && i < count; i++)
		choice->mode[kept[i]].kept = 1;
	hawser_choice_forget(choice);
	for (int i = 0; !status && i < survey->motions; i++) {
		/* where no mode that is kept moves there is nothing to weigh by */
		status = hawser__weigh(choice, survey->u + (size_t)i*ROWS*(size_t)choice->n, ROWS,
		                       survey->omega[i], 0.0, 1, HAWSER__BY_PLANE, HAWSER__BY_PLANE, NULL,
		                       report);
		status = status == HAWSER_ERR_NAN ? HAWSER_OK : status;
	}
	if (!status)
		hawser__accuracy_add_up(fixed, choice, 0.0);
	return status;
}
