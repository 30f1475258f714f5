/* cli/curves/frf_notes.c - what a frequency response says about itself on standard error, in JSON
 * and in its table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include "cli/model/exact.h"
#include "cli/model/fixed.h"
#include "cli/model/made.h"
#include "cli/curves/frf_cover.h"
#include "cli/curves/frf_lift.h"
#include "cli/frame/view.h"
#include "core/append.h"

/* Number of branches that end where the cable becomes slack. */
static int ends_slack(const struct cli_frf_result *result)
{
	int count = result->frf->end == HAWSER_END_SLACK;

	for (int k = 0; k < result->others; k++)
		count += result->other[k].frf->end == HAWSER_END_SLACK;
	return count;
}

static double place_of(const struct cli_frf_result *result, const struct hawser_frf_point *point)
{
	return result->over ? point->parameter : point->omega*cli_per_omega(result->model);
}

/* Append to text [size], of which `used` are used. */
static int append(char *text, size_t size, int used, const struct cli_frf_result *result,
                  const char *before)
{
	const struct hawser_frf *frf = result->frf;

	if (frf->end != HAWSER_END_SLACK || used >= (int)size)
		return used;
	return used + snprintf(text + used, size - (size_t)used, "%s%.9g", before,
	                       place_of(result, &frf->point[frf->points - 1]));
}

static int slack_ends(char *text, size_t size, const struct cli_frf_result *result)
{
	char first[120];
	int used;

	snprintf(first, sizeof first, "slack: the least tension falls to zero at %.60s = ",
	         result->over ? result->over->axis.key : "Omega");
	used = append(text, size, 0, result, first);
	for (int k = 0; k < result->others; k++)
		used = append(text, size, used, &result->other[k], used ? ", " : first);
	if (used < (int)size)
		snprintf(text + used, size - (size_t)used, "%s%s, where the curve ends: a cable bears no "
		         "compression, and beyond the model's motion is not the cable's (--slack follow "
		         "shows it)", result->over ? " " : "",
		         result->over ? result->over->axis.unit : cli_unit(result->model, " rad/s"));
	return 1;
}

static int gaps(char *text, size_t size, const struct cli_frf_result *result)
{
	const char *taut = ends_slack(result) ? "that keeps the cable taut " : "";
	double per_omega = cli_per_omega(result->model);

	snprintf(text, size, "gaps: no periodic motion %swas found between Omega =", taut);
	for (int k = 0; k < result->gaps; k++)
		hawser__append(text, size, k ? ", " : " ", "%.9g and %.9g", result->gap[2*k]*per_omega,
		               result->gap[2*k + 1]*per_omega);
	hawser__append(text, size, cli_unit(result->model, " rad/s"),
	               ": begin one there with --at, or look with --sweep both");
	return result->gaps > 0;
}

static int lost(char *text, size_t size, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;

	for (int k = 0; frf->end != HAWSER_END_LOST && k < result->others; k++)
		frf = result->other[k].frf;
	if (frf->end != HAWSER_END_LOST)
		return 0;
	snprintf(text, size, "branch %d ends at Omega = %.9g%s among unstable motions, which can't be "
	         "observed (%d unstable multipliers); the next could not be computed: %s", frf->branch,
	         frf->point[frf->points - 1].omega*cli_per_omega(result->model),
	         cli_unit(result->model, " rad/s"), frf->point[frf->points - 1].unstable, frf->lost);
	return 1;
}

static int slack(char *text, size_t size, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;
	int at = 0, count = 0, slower = -1;

	if (!frf->tension)
		return 0;
	if (ends_slack(result))
		return slack_ends(text, size, result);
	for (int i = 0; i < frf->points; i++) {
		double missing = cli_speeding_tension(result->model, frf->point[i].omega);

		if (slower < 0 && frf->tension[2*i] < missing)
			slower = i;
		count += frf->tension[2*i] < 0.0;
		if (frf->tension[2*i] < frf->tension[2*at])
			at = i;
	}
	if (count == 0 && slower >= 0)
		snprintf(text, size, "slack: at Omega = %.9g%s the model's least tension is %.4g N, and the "
		         "change of speed takes about %.4g N more, which it has not: model.condense: static "
		         "and model.energy: exact have it",
		         frf->point[slower].omega*cli_per_omega(result->model),
		         cli_unit(result->model, " rad/s"),
		         frf->tension[2*slower],
		         cli_speeding_tension(result->model, frf->point[slower].omega));
	if (count == 0)
		return slower >= 0;
	snprintf(text, size, "slack: the model's tension falls to %.4g N at %s = %.9g%s%s, and below "
	         "zero at %d of %d points; a cable bears no compression, so the response there is not "
	         "that of a cable", frf->tension[2*at], result->over ? result->over->axis.key : "Omega",
	         place_of(result, &frf->point[at]), result->over ? " " : "",
	         result->over ? result->over->axis.unit : cli_unit(result->model, " rad/s"), count,
	         frf->points);
	return 1;
}

/* Where the branches with this end do so, after `before`; returns their number. */
static int list_ends(char *text, size_t size, const struct cli_frf_result *result,
                     enum hawser_frf_end end, const char *before)
{
	int count = 0;

	snprintf(text, size, "%s", before);
	for (int k = 0; k <= result->others; k++) {
		const struct hawser_frf *frf = k ? result->other[k - 1].frf : result->frf;

		if (frf->end == end && frf->points > 0)
			hawser__append(text, size, count++ ? ", " : " ", "branch %d at %.9g%s", frf->branch,
			               place_of(result, &frf->point[frf->points - 1]),
			               result->over ? "" : cli_unit(result->model, " rad/s"));
	}
	return count;
}

static int unstable(char *text, size_t size, const struct cli_frf_result *result)
{
	if (result->observed == 0 ||
	    list_ends(text, size, result, HAWSER_END_UNSTABLE, "unstable: the curve ends on") == 0)
		return 0;
	hawser__append(text, size, ", ", "where more than %d multipliers are unstable, so that nobody "
	               "observes the motion (--unstable N follows it on)", result->observed);
	return 1;
}

static int work(char *text, size_t size, const struct cli_frf_result *result)
{
	if (list_ends(text, size, result, HAWSER_END_WORK, "time: the curve ends on") == 0) {
		snprintf(text, size, "time: the search for further branches ends");
		if (!result->costly)
			return 0;
	}
	hawser__append(text, size, ", ", "since it takes more than some %.0f s, as counted: fewer modes "
	               "(-n) or a narrower range take less, --max-points N goes on", result->allowed);
	return 1;
}

static int unsearched(char *text, size_t size, const struct cli_frf_result *result)
{
	snprintf(text, size, "gaps: further branches are not searched for, as the model may be off by more "
	         "than 100 %% (--set model.energy=quartic searches all the same)");
	return result->unsearched;
}

/* Responses of which no motion is stable, branches included. */
static int none_stable(char *text, size_t size, const struct cli_frf_result *result)
{
	int points = 0, shedding = result->over && result->model->has_scene &&
	                           result->model->scene.wind.wake.present;

	for (int c = 0; c <= result->others; c++) {
		const struct hawser_frf *frf = c ? result->other[c - 1].frf : result->frf;

		for (int i = 0; i < frf->points; i++)
			if (frf->point[i].unstable <= 0)
				return 0;
		points += frf->points;
	}
	snprintf(text, size, "stability: none of these %d motions is stable, %s", points, !shedding
	         ? "and what is observed is another one: hawser integrate finds it, --start follows it "
	           "from there, --branches and --tori what begins on this curve"
	         : result->others == 0 ? "as wakes grow from rest at every speed: --branches 1 follows "
	           "the motion that they come to"
	         : "as each mode has a wake of its own, and those that rest here grow: keep only "
	           "the modes up to the one that is locked in (-n): higher ones hardly change its motion");
	return points > 1 && (shedding || !result->over) && !result->chosen;
}

int cli_frf_damped(const struct cli_frf_result *result)
{
	const struct hawser_rom *rom = &result->model->rom;

	for (int i = 0; i < rom->n*rom->n; i++)
		if (rom->D[i] != 0.0)
			return 1;
	return 0;
}

static int undecided(char *text, size_t size, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;

	snprintf(text, size, "stability: %d of %d points have multipliers whose moduli differ from 1 by "
	         "less than their error: whether these motions are stable is not known",
	         frf->undecided, frf->points);
	return frf->undecided > 0 && frf->undecided < frf->points && cli_frf_damped(result);
}

enum { SLACK = 0, UNDECIDED = 7 };

int cli_frf_note(char *text, size_t size, const struct cli_frf_result *result, int k)
{
	static int (*const note[])(char *, size_t, const struct cli_frf_result *) = {
		[SLACK] = slack, cli_frf_lift, lost, unstable, work, gaps, unsearched,
		[UNDECIDED] = undecided, none_stable};

	return k < (int)(sizeof note/sizeof *note) ? note[k](text, size, result) : -1;
}

void cli_frf_warn(struct cli_model *model, const struct cli_frf_result *result)
{
	char text[CLI_WARNING_SIZE];
	int note;

	cli_basis_warn(result->model);
	cli_made_warn(result->model);
	cli_made_breaking_warn(result->model, result->over ? result->over->omega
	                                                   : fmax(result->from, result->to));
	cli_known_warn(result->model, fmax(result->from, result->to));
	cli_fixed_warn_worst(result);
	cli_exact_warn(result->model);
	cli_range_warn_frf(model, result);
	for (int k = 0; (note = cli_frf_note(text, sizeof text, result, k)) >= 0; k++)
		if (note > 0 && k == SLACK)
			cli_caution(ends_slack(result) ? "ends slack" : "slack in parts", text);
		else if (note > 0 && k == UNDECIDED)
			cli_caution("stability undecided in parts", text);
		else if (note > 0)
			cli_warn(text);
	for (int k = 0; k < result->misses; k++)
		cli_warn(result->missed[k].text);
}
