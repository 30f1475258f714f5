/* study/accuracy/estimate.c - the estimated error of a fidelity: of condensed models as hawser frf
 * states it (plan/foresee.c), of raw ones from their effective cubic coefficients.
 *
 *    j           a mode whose primary resonance is in the range;  s  any mode, j included
 *    omega_s     frequency;  beta_s  coefficient of u_j^2 in the equation of s
 *    gamma_N     effective cubic coefficient of mode j in a model of the first N modes
 *    a           amplitude at the peak, f/(c omega_j)
 *    M           number of modes of the plan
 *
 * All models have the same linear modes, so that a resonance begins at the same frequency in each.
 * They differ in how much it bends, 3 gamma a^2/(8 omega_j) at the peak. The relative difference of
 * two models there is
 *
 *    (3/8) |gamma_N - gamma| a^2/omega_j^2.
 *
 * gamma follows from beta_s for any number of modes (scales.c). The raw model of N modes has its
 * own C_jjjj and the responses of the N modes. The best one known has in addition the static
 * responses of all others: those up to M one by one, and R, the sum of those above M, from the
 * condensation of a model of M modes. The dynamic response is the static one times 1 + q/(3 (1 -
 * q)), q = (2 omega_j/omega_s)^2. The uncertainty of gamma has two parts: the dynamic responses of
 * the transverse modes above M, estimated as those of the last quarter below M with the factor at
 * omega_M; and those of the longitudinal modes, which are nearly all of R. The longitudinal motion
 * that mode j drives has twice its wave number, so that its q is about epsilon.
 *
 * The estimate neglects the exchange of energy between modes, which is looked for separately
 * (partners), and terms of higher order than a^2, as the method of multiple scales does. For a
 * cubic spring the latter are 0.42 times the square of the relative bend (the next term of the
 * Duffing backbone, -15/256).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/choose/weigh.h"
#include "study/accuracy/accuracy.h"
#include "study/accuracy/scales.h"
#include "study/accuracy/survey.h"

/* Smallest peak of a directly excited mode, relative to the largest peak; chosen. */
static const double faint = 1e-4;

/* beta_s of mode j, the coefficient of u_j^2 in the equation of s. */
static double beta_of(const struct hawser_rom *raw, int s, int j)
{
	for (int i = 0; i < raw->quads; i++)
		if (raw->Q[i].j == s && raw->Q[i].k == j && raw->Q[i].l == j)
			return raw->Q[i].value;
	return 0.0;
}

static double own_cubic(const struct hawser_rom *rom, int j)
{
	for (int i = 0; i < rom->cubics; i++)
		if (rom->C[i].j == j && rom->C[i].k == j && rom->C[i].l == j && rom->C[i].m == j)
			return rom->C[i].value;
	return 0.0;
}

/* Effective cubic coefficient of a model of the first n modes. */
static double effective(const struct hawser_survey *survey, int j, int n, int condensed)
{
	const struct hawser_modes *modes = &survey->plan->modes;
	double gamma = own_cubic(condensed ? survey->condensed : &survey->raw, j);

	for (int s = 0; s < modes->n; s++) {
		double beta = beta_of(&survey->raw, s, j), w = modes->mode[s].omega;

		if (s < n)
			gamma += hawser__returned(beta, w, modes->mode[j].omega);
		else if (condensed)
			gamma += hawser__returned_static(beta, w);
	}
	return gamma;
}

static double doubt_of(const struct hawser_survey *survey, int j)
{
	const struct hawser_modes *modes = &survey->plan->modes;
	double q = pow(2.0*modes->mode[j].omega/modes->mode[modes->n - 1].omega, 2), tail = 0.0;
	double rest = own_cubic(survey->condensed, j) - own_cubic(&survey->raw, j);

	for (int s = 3*modes->n/4; s < modes->n; s++)
		tail += fabs(hawser__returned_static(beta_of(&survey->raw, s, j), modes->mode[s].omega));
	if (q >= 1.0)
		return INFINITY;
	return tail*q/(3.0*(1.0 - q)) + fabs(rest)*modes->statics.epsilon;
}

/* Find a mode whose frequency is within the bend and the width of the resonance of one, two or
 * three times the frequency of this mode; for the ratio one, the frequencies must not be equal. A
 * force that is not zero by symmetry must act on it: its own load, beta_s, or a cubic term of even
 * parity. */
static void find_partner(struct hawser_plan_resonance *resonance, const struct hawser_survey *survey)
{
	const struct hawser_modes *modes = &survey->plan->modes;
	int j = resonance->mode;
	double width = fabs(resonance->peak_omega - resonance->omega) +
	               survey->raw.D[(size_t)j*survey->raw.n + j];

	resonance->partner = -1;
	for (int order = 1; order <= 3; order++)
		for (int s = 0; s < modes->n; s++) {
			double beta = beta_of(&survey->raw, s, j);

			if (s == j || fabs(modes->mode[s].omega - order*resonance->omega) > order*width ||
			    (order == 2 && beta == 0.0) ||
			    (order == 3 && !modes->statics.space &&
			     modes->mode[s].plane != modes->mode[j].plane))
				continue;
			resonance->partner = s;
			resonance->order = order;
			return;
		}
}

/* Largest displacement in the shape of a mode, per unit of its coordinate. */
static double largest_motion(const struct hawser_modes *modes, int j)
{
	double most = 0.0;

	for (int i = 0; i < modes->grid.points; i++) {
		const double *phi = modes->shape + ((size_t)j*modes->grid.points + i)*3;

		most = fmax(most, hypot(hypot(phi[0], phi[1]), phi[2]));
	}
	return most;
}

static void resonate(struct hawser_plan_resonance *out, const struct hawser_survey *survey, int j)
{
	struct hawser__resonance resonance = hawser__resonance_of(survey->condensed, j);
	struct hawser__scales scales;

	/* the coefficient by a second derivation, with the uncertainty due to the modes above */
	resonance.cubic = effective(survey, j, survey->plan->modes.n, 1);
	scales = hawser__scales_solve(&resonance);
	*out = (struct hawser_plan_resonance){
		.mode = j, .omega = resonance.omega, .peak = scales.peak,
		.peak_omega = scales.peak_omega, .folds = scales.folds,
		.motion = scales.peak*largest_motion(&survey->plan->modes, j), .cubic = resonance.cubic,
		.unlocked = own_cubic(&survey->raw, j), .doubt = doubt_of(survey, j),
	};
	find_partner(out, survey);
}

enum hawser_status hawser__find_resonances(struct hawser_plan *plan,
                                           const struct hawser_survey *survey,
                                           struct hawser_report *report)
{
	double low = fmin(plan->from, plan->to), high = fmax(plan->from, plan->to), most = 0.0;
	int n = plan->modes.n;

	plan->resonance = calloc((size_t)n, sizeof *plan->resonance);
	if (!plan->resonance)
		return hawser__no_memory(report, "plan");
	for (int j = 0; j < n; j++)
		most = fmax(most, fabs(plan->load[j]));
	for (int j = 0; j < n; j++) {
		double w = plan->modes.mode[j].omega;

		if (!(w > low && w < high && fabs(plan->load[j]) > faint*most))
			continue;
		/* without damping the peak is infinite */
		if (survey->condensed->D[(size_t)j*survey->condensed->n + j] > 0.0)
			resonate(&plan->resonance[plan->resonances++], survey, j);
		else
			plan->undamped++;
	}
	return HAWSER_OK;
}

/* --- rows --- */

/* The largest error over the resonances, for a model with these coefficients. */
static void worst_of(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	const struct hawser_plan *plan = survey->plan;

	row->omega_error = plan->resonances ? 0.0 : NAN;
	for (int i = 0; i < plan->resonances; i++) {
		const struct hawser_plan_resonance *at = &plan->resonance[i];
		double off = fabs(effective(survey, at->mode, row->n, 0) - at->cubic) + at->doubt;
		double error = 0.375*off*pow(at->peak/at->omega, 2);

		if (at->mode >= row->n)
			error = INFINITY;
		if (error > row->omega_error || row->worst < 0) {
			row->omega_error = error;
			row->worst = at->mode;
		}
	}
}

/* Why the worst resonance has this error. */
static void explain(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	const struct hawser_plan *plan = survey->plan;
	int j = row->worst;

	if (j < 0)
		snprintf(row->why, sizeof row->why, plan->undamped
		         ? "none: a resonance without damping has no peak to go by"
		         : "no resonance in the range");
	else if (isinf(row->omega_error))
		snprintf(row->why, sizeof row->why, "mode %d resonates in the range and is not in it",
		         j + 1);
	else
		for (int i = 0; i < plan->resonances; i++)
			if (plan->resonance[i].mode == j)
				snprintf(row->why, sizeof row->why, "mode %d: cubic coefficient %.4g, with all "
				         "modes %.4g", j + 1, effective(survey, j, row->n, 0),
				         plan->resonance[i].cubic);
}

/* What hawser frf would state of a condensed model of these modes. */
static void state(struct hawser_plan_row *row, const struct hawser_survey *survey, const int *kept)
{
	struct hawser_accuracy_fixed fixed;
	struct hawser_report report = {.message = ""};

	if (hawser__foresee(&fixed, survey, kept, row->n, &report)) {
		snprintf(row->why, sizeof row->why, "not estimated: %.180s", report.message);
		return;
	}
	row->omega_error = fixed.estimated;
	snprintf(row->why, sizeof row->why, "modes left out %.1e, modes not looked at %.1e; what no mode "
	         "makes up for %.1e", fixed.rest, fixed.beyond, fixed.truncation);
}

/* A resonance whose mode is not kept. */
static void miss(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	for (int i = survey->plan->resonances - 1; i >= 0; i--)
		if (survey->plan->resonance[i].mode >= row->n) {
			row->omega_error = INFINITY;
			row->worst = survey->plan->resonance[i].mode;
			snprintf(row->why, sizeof row->why, "mode %d resonates in the range and is not in it",
			         row->worst + 1);
		}
}

static int sized(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	hawser__count_entries(row, survey, NULL, (int)row->choice.number);
	return hawser__scene_driven(survey->scene);
}

void hawser__estimate_raw(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	if (!sized(row, survey))
		return;
	worst_of(row, survey);
	explain(row, survey);
	hawser__estimate_cost(row, survey);
}

void hawser__estimate_condensed(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	if (!sized(row, survey))
		return;
	state(row, survey, NULL);
	miss(row, survey);
	hawser__estimate_cost(row, survey);
}

/* The modes that matter most by the first look, index [modes] in ascending order: at most `count`, and
 * no more than leave `accuracy` to the others. Returns their number. */
static int first(int *index, const struct hawser_plan *plan, int count, double accuracy)
{
	int n = plan->modes.n, kept = 0;
	double rest = 0.0;

	for (int j = 0; j < n; j++)
		rest += plan->mode[j].measure;
	for (; kept < count && kept < n && rest > accuracy; kept++) {
		int best = -1, at = kept;

		for (int j = 0; j < n; j++) {
			int taken = 0;

			for (int i = 0; i < kept; i++)
				taken |= index[i] == j;
			if (!taken && (best < 0 || plan->mode[j].measure > plan->mode[best].measure))
				best = j;
		}
		if (!(plan->mode[best].measure > HAWSER__NEGLIGIBLE))
			break;
		rest -= plan->mode[best].measure;
		for (; at > 0 && index[at - 1] > best; at--)
			index[at] = index[at - 1];
		index[at] = best;
	}
	return kept;
}

static void unchosen(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	if (hawser__scene_driven(survey->scene))
		snprintf(row->why, sizeof row->why, "not available: %.180s", *survey->unweighed
		         ? survey->unweighed : "modes are not chosen with a motion of supports");
}

/* The N most important modes, by the first estimate of the motions. */
void hawser__estimate_chosen(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	int *index = calloc((size_t)survey->plan->modes.n, sizeof *index);

	if (index && survey->plan->chosen) {
		hawser__count_entries(row, survey, index,
		                      first(index, survey->plan, (int)row->choice.number, 0.0));
		state(row, survey, index);
		hawser__estimate_chosen_cost(row, survey);
	} else {
		unchosen(row, survey);
	}
	free(index);
}

/* The modes that the first estimate keeps; a search traces two or three models until the last one, and
 * goes on with full-order ones if none is good enough. */
void hawser__estimate_auto(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	const struct hawser_plan *plan = survey->plan;
	int *index = calloc((size_t)plan->modes.n, sizeof *index);
	double asked = row->choice.number > 0.0 ? row->choice.number/100.0
	               : survey->scene->model.accuracy;
	struct hawser_accuracy_options options = {.most = 0};
	struct hawser_plan_row full = {.n = 0};
	struct hawser_accuracy_fixed fixed;

	if (index && plan->chosen) {
		double last = plan->modes.mode[plan->modes.n - 1].omega;
		double among = plan->modes.n*hawser__accuracy_reach(fmax(plan->from, plan->to), asked)/last;

		among = fmin(among, HAWSER__AMONG);

		row->omega_error = asked;
		hawser__count_entries(row, survey, index,
		                      first(index, plan, HAWSER__FIRST, HAWSER__NEXT*asked));
		hawser__estimate_auto_cost(row, survey, among,
		                           hawser__accuracy_settle(&options, asked).step_max);
		if (!hawser__foresee(&fixed, survey, index, row->n, NULL) &&
		    HAWSER__SAFETY_ORDER*fixed.truncation > asked)
			hawser__estimate_work(row, survey,
			                      HAWSER__SEARCHED*hawser__draft_of(&full, survey, 0, asked), 0.0);
		snprintf(row->why, sizeof row->why, "what is asked for; modes as the first look has them");
	} else {
		unchosen(row, survey);
	}
	free(index);
}

/* A full-order model has three components per function of the basis, and no tensors. */
void hawser__estimate_full(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	row->n = 3*(int)row->choice.number;
	if (hawser__scene_driven(survey->scene))
		hawser__estimate_cost(row, survey);
	snprintf(row->why, sizeof row->why, "reference of the other fidelities");
}

void hawser__estimate_scales(struct hawser_plan_row *row, const struct hawser_survey *survey)
{
	const struct hawser_plan *plan = survey->plan;

	if (!sized(row, survey))
		return;
	state(row, survey, NULL);
	miss(row, survey);
	hawser__estimate_closed_cost(row, survey);
	for (int i = 0; i < plan->resonances; i++) {
		const struct hawser_plan_resonance *at = &plan->resonance[i];
		double bend = fabs(at->peak_omega/at->omega - 1.0);
		double error = at->partner >= 0 ? bend : 0.42*bend*bend;

		if (!(error > row->omega_error))
			continue;
		row->omega_error = error;
		row->worst = at->mode;
		if (at->partner >= 0)
			snprintf(row->why, sizeof row->why, "mode %d bends by %.2g %% and meets mode %d: it "
			         "is not alone", at->mode + 1, 100.0*bend, at->partner + 1);
		else
			snprintf(row->why, sizeof row->why, "mode %d bends by %.2g %%: terms of the next "
			         "order", at->mode + 1, 100.0*bend);
	}
}
