/* cli/curves/frf_result.c - comments of a frequency response, in SI if the model has units.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/backbone/backbone.h"
#include "cli/model/exact.h"
#include "cli/curves/frf_cover.h"
#include "cli/curves/frf_lift.h"
#include "cli/curves/frf_tori.h"
#include "cli/frame/view.h"
#include "cli/model/certificate.h"
#include "cli/backbone/mms_result.h"

struct cli_place cli_frf_place(const struct cli_frf_result *result, double omega, double parameter)
{
	struct cli_place place;

	if (result->over)
		snprintf(place.text, sizeof place.text, "%.60s = %.12g%s%.20s", result->over->axis.key,
		         parameter, *result->over->axis.unit ? " " : "", result->over->axis.unit);
	else
		snprintf(place.text, sizeof place.text, "Omega = %.12g%s",
		         omega*cli_per_omega(result->model), cli_unit(result->model, " rad/s"));
	return place;
}

/* The reason why the curve ended, as text. */
static const char *sentence(enum hawser_frf_end end)
{
	switch (end) {
	case HAWSER_END_RANGE: return "the curve reached an end of the range";
	case HAWSER_END_RETURNED: return "the curve came back to the end of the range where it began; "
		                         "the other end was not reached";
	case HAWSER_END_CLOSED: return "the curve closed on itself";
	case HAWSER_END_MAX_POINTS: return "the limit --max-points was reached";
	case HAWSER_END_INTERRUPTED: return "interrupted; the curve is incomplete";
	case HAWSER_END_AT_REST: return "the motion shrinks to rest";
	case HAWSER_END_SLACK: return "the cable goes slack; beyond, the model's motion is not the "
		                      "cable's (--slack follow shows it)";
	case HAWSER_END_UNSTABLE: return "more multipliers are unstable than --unstable allows";
	case HAWSER_END_LOST: return "unstable motions that could not be followed further";
	case HAWSER_END_WORK: return "it took the most work that is done unasked; --max-points N goes on";
	case HAWSER_END_MEETS: return "the branch meets another one; beyond, it repeats itself in reverse";
	case HAWSER_END_HOPF: return "the cycles shrink to the equilibrium of a Hopf point";
	case HAWSER_END_HOMOCLINIC: return "the period grows without a limit";
	case HAWSER_END_FAILED: return "the corrector failed; the curve is incomplete";
	}
	return "";
}

int cli_frf_direction(const struct hawser_frf *frf)
{
	return frf->points > 0 ? frf->point[frf->points - 1].direction : 0;
}

/* --- table --- */

static double largest_error(const struct hawser_frf *frf)
{
	double largest = 0.0;
	int i;

	for (i = 0; i < frf->points; i++)
		if (!(frf->point[i].error <= largest))
			largest = frf->point[i].error;
	return largest;
}

/* "branch 2 " for a further branch, else "". */
static const char *branch_name(char text[24], const struct cli_frf_result *result)
{
	text[0] = '\0';
	if (result->frf->branch > 1)
		snprintf(text, 24, "branch %d ", result->frf->branch);
	return text;
}

/* ", frequency 1 rad/s, l1 = -0.5 (supercritical)": of a Hopf point. */
static const char *tell_hopf(char *text, size_t size, const struct cli_frf_result *result,
                             const struct hawser_frf_event *event)
{
	*text = '\0';
	if (event->kind == HAWSER_HOPF && event->hopf.l1 == 0.0)
		snprintf(text, size, ", frequency %.12g%s, l1 = 0 (undecided: terms of higher order decide)",
		         event->hopf.omega*cli_per_omega(result->model), cli_unit(result->model, " rad/s"));
	else if (event->kind == HAWSER_HOPF)
		snprintf(text, size, ", frequency %.12g%s, l1 = %.9g (%s), d(A_%d^2) = %.6g%s",
		         event->hopf.omega*cli_per_omega(result->model), cli_unit(result->model, " rad/s"),
		         event->hopf.l1, event->hopf.l1 < 0.0 ? "supercritical" : event->hopf.l1 > 0.0
		         ? "subcritical" : "undecided", event->hopf.coordinate + 1,
		         event->hopf.swing*pow(result->model->rom.length, 2),
		         event->hopf.turning ? ", rotating" : "");
	return text;
}

static void comment_event(struct hawser__table *table, const struct cli_frf_result *result, int k)
{
	char of[24], more[176];
	const struct hawser_frf_event *event = &result->frf->event[k];
	double per_omega = cli_per_omega(result->model);

	if (event->kind == HAWSER_UNEXPLAINED)
		hawser__table_comment(table, "%sevent: unexplained between %s and %.12g: the "
		                      "number of unstable multipliers changes from %d to %d, and no "
		                      "located event explains it, label %d", branch_name(of, result),
		                      cli_frf_place(result, event->bracket[0], event->bracket[0]).text,
		                      event->bracket[1]*(result->over ? 1.0 : per_omega),
		                      event->unstable[0], event->unstable[1], event->label);
	else
		hawser__table_comment(table, "%sevent%s: %s at %s%s (relative error %.1e)%s, label %d",
		                      branch_name(of, result),
		                      event->located ? "" : " not located",
		                      hawser_event_name(event->kind),
		                      cli_frf_place(result, event->omega, event->parameter).text,
		                      event->suspected ? " (suspected)" : "", event->error,
		                      tell_hopf(more, sizeof more, result, event), event->label);
}

/* A further branch. */
static void comment_branch(struct hawser__table *table, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;
	const struct hawser_frf_point *last = &frf->point[frf->points - 1];
	double per_omega = cli_per_omega(result->model);

	hawser__table_comment(table, "branch %d: from %s to %.12g%s, %d points, "
	                      "end: %s - %s%s%s", frf->branch,
	                      cli_frf_place(result, frf->point[0].omega, frf->point[0].parameter).text,
	                      result->over ? last->parameter : last->omega*per_omega,
	                      result->over ? "" : cli_unit(result->model, " rad/s"), frf->points,
	                      hawser_frf_end_name(frf->end), sentence(frf->end), *frf->lost ? ": " : "",
	                      frf->lost);
	if (frf->parent > 0 && frf->swing)
		hawser__table_comment(table, "branch %d: %s, from branch %d at %s", frf->branch,
		                      last->omega > 0.0 ? "limit cycles" : "equilibria", frf->parent,
		                      cli_frf_place(result, frf->born, frf->born_at).text);
	else if (frf->parent > 0)
		hawser__table_comment(table, "branch %d: of period %d, from branch %d at %s", frf->branch,
		                      frf->period, frf->parent,
		                      cli_frf_place(result, frf->born, frf->born_at).text);
	if (!frf->swing)
		cli_fixed_comments(table, &result->error, result->frf->branch);
	for (int k = 0; k < frf->events; k++)
		comment_event(table, result, k);
}

void cli_frf_comments(struct hawser__table *table, const void *of)
{
	const struct cli_frf_result *result = of;
	char text[CLI_WARNING_SIZE];
	const struct hawser_frf *frf = result->frf;
	const struct cli_model *model = result->model;
	double per_omega = cli_per_omega(model);
	const char *rad_s = cli_unit(result->model, " rad/s");
	int k, note;

	if (result->over && result->over->omega == 0.0)
		hawser__table_comment(table, "range: %s to %.12g, nothing excites the model",
		                      cli_frf_place(result, 0.0, result->over->from).text,
		                      result->over->to);
	else if (result->over)
		hawser__table_comment(table, "range: %s to %.12g, at Omega = %.12g%s",
		                      cli_frf_place(result, 0.0, result->over->from).text,
		                      result->over->to, result->over->omega, rad_s);
	else
		hawser__table_comment(table, "range: Omega from %.12g to %.12g%s",
		                      result->from*per_omega, result->to*per_omega, rad_s);
	if (frf->period > 1)
		hawser__table_comment(table, "motions of %d periods of the load", frf->period);
	cli_choice_comments(table, model);
	cli_basis_comment(table, model);
	cli_exact_comment(table, model);
	cli_drag_comment(table, model, "at every instant; no describing function");
	cli_fixed_comments(table, &result->error, result->frf->branch);
	cli_certificate_comments(table, result);
	if (result->scales)
		cli_mms_equations(table, result->scales);
	for (k = 0; k < model->naturals; k++)
		hawser__table_comment(table, "natural frequency w%d = %.12g%s",
		                      cli_natural_number(model, k), model->natural[k]*per_omega, rad_s);
	for (k = 0; k < frf->events; k++)
		comment_event(table, result, k);
	if (result->highest > 0)
		hawser__table_comment(table, "the highest %d of %d peaks of displacements, as this is a "
		                      "terminal (--peaks: all peaks; --tsv FILE: the points)",
		                      result->highest, cli_frf_displacements(result));
	else
		cli_frf_peak_comments(table, result);
	for (k = 0; k < result->sweeps; k++)
		hawser__table_comment(table, "sweep %+d: %d frequencies%s", result->sweep[k].direction,
		                      result->sweep[k].run.points,
		                      result->sweep[k].run.interrupted ? ", interrupted" : "");
	if (frf->points > 0)
		hawser__table_comment(table, "largest estimated error of a point: %.1e",
		                      largest_error(frf));
	if (frf->sampled > 0 && !isfinite(frf->sample_gap))
		hawser__table_comment(table,
		                      "%d points computed again by another method: not all were found "
		                      "again, so far are these from the model's motions", frf->sampled);
	else if (frf->sampled > 0)
		hawser__table_comment(table, "%d points computed again by another method: off by %.1e at "
		                      "most, stability %s", frf->sampled, frf->sample_gap,
		                      frf->sample_disagreements ? "NOT the same" : "the same");
	cli_tori_comments(table, result);
	if (result->backbone)
		cli_backbone_comments(table, result);
	cli_speeding_comment(table, model, fmax(result->from, result->to));
	cli_frf_lift_comment(table, result);
	hawser__table_comment(table, "end: %s - %s%s%s", hawser_frf_end_name(frf->end),
	                      sentence(frf->end), *frf->lost ? ": " : "", frf->lost);
	hawser__table_comment(table, "%d points", frf->points);
	for (k = 0; k < result->others; k++) {
		comment_branch(table, &result->other[k]);
		if (result->highest == 0)
			cli_frf_peak_comments(table, &result->other[k]);
	}
	for (k = 0; (note = cli_frf_note(text, sizeof text, result, k)) >= 0; k++)
		if (note > 0)
			hawser__table_comment(table, "warning: %s", text);
	for (k = 0; k < result->misses; k++)
		hawser__table_comment(table, "warning: %s", result->missed[k].text);
	if (frf->undecided > 0 && (frf->undecided == frf->points || !cli_frf_damped(result)))
		hawser__table_comment(table, "%d of %d points have undecided multipliers: their moduli "
		                      "differ from 1 by less than their error, as without damping. "
		                      "They are not in unstable", frf->undecided, frf->points);
}
