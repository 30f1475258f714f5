/* study/plan/foresee.c - the error that hawser frf would state of modes that are kept, before anything
 * is traced: the same sum (accuracy/fixed.c), in motions that are foreseen instead of computed.
 *
 *    u      [ROWS][n] a motion of all modes over a period
 *    a      amplitude of a resonance at its peak by multiple scales or, where its backbone leaves the
 *           range before, there
 *    Gamma  the backbone is omega + Gamma a^2
 *    beta   coefficient of u_j^2 in the equation of another mode
 *
 * The motions are those of the primary resonances, each alone, to second order in a, so that the modes
 * that answer at 2 Omega and in the mean have their part, with their damping: the expansion without
 * it has no bound where 2 Omega meets a mode. And the linear response at both ends of the range, no
 * mode of which moves more than the largest resonance. What resonances share with each other is not
 * foreseen (the column `meets` names such modes).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/choose/drive.h"
#include "rom/choose/weigh.h"
#include "study/accuracy/accuracy.h"
#include "study/accuracy/survey.h"

enum { ROWS = 32 }; /* phases of a period: resolves 16 harmonics */
#define FAINT 0.25  /* smallest motion beside the largest that is weighed; chosen, below the half of
                     * the peaks whose error hawser frf states */

double hawser__within(double *omega, const struct hawser_plan *plan,
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

/* u_s for a sin(tau) of mode j: u_s'' + D u_s' + omega_s^2 u_s = -beta_s a^2/2 (1 - cos 2 tau), for
 * j itself too. */
static void answer(double *u, const struct hawser_rom *rom, int j, double a, double omega)
{
	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];
		size_t diagonal = (size_t)q->j*((size_t)rom->n + 1);
		double half = 0.5*q->value*a*a, K = rom->K[diagonal];
		double complex twice = half/(K - 4.0*omega*omega + 2.0*I*omega*rom->D[diagonal]);

		for (int t = 0; q->k == j && q->l == j && t < ROWS; t++)
			u[t*rom->n + q->j] += creal(twice*cexp(4.0*I*M_PI*t/ROWS)) - half/K;
	}
}

/* The linear response with no amplitude above `most`; with mode j, unless it is negative, at its own
 * resonance of this amplitude, and what answers it. */
static enum hawser_status respond(double *u, double most, int j, double omega,
                                  const struct hawser_survey *survey, struct hawser_report *report)
{
	const struct hawser_rom *rom = survey->condensed;
	double complex *a = malloc((size_t)rom->n*sizeof *a);
	enum hawser_status status = a ? hawser__respond(rom, a, omega, report)
	                              : hawser__no_memory(report, "plan");

	for (int s = 0; !status && s < rom->n; s++)
		a[s] *= fmin(1.0, most/fmax(cabs(a[s]), 1e-300));
	if (!status && j >= 0)
		a[j] = -I*most;
	for (int t = 0; !status && t < ROWS; t++)
		for (int s = 0; s < rom->n; s++)
			u[t*rom->n + s] = creal(a[s]*cexp(2.0*I*M_PI*t/ROWS));
	if (!status && j >= 0)
		answer(u, rom, j, most, omega);
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
		double *omega = &survey->omega[survey->motions++];
		double a = hawser__within(omega, plan, &plan->resonance[i]);

		most = fmax(most, a);
		status = respond(u, a, plan->resonance[i].mode, *omega, survey, report);
	}
	for (int end = 0; !status && end < 2; end++, u += size) {
		survey->omega[survey->motions] = end ? plan->to : plan->from;
		status = respond(u, most > 0.0 ? most : HUGE_VAL, -1, survey->omega[survey->motions++], survey,
		                 report);
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
