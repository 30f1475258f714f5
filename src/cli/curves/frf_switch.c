/* cli/curves/frf_switch.c - the branches that begin at bifurcations of a frequency response
 * (--branches), and what is said of those that are not found.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_cover.h"
#include "cli/frame/view.h"
#include "core/grow.h"
#include "core/report.h"

#define SAME 1e-4 /* relative distance of two events that are taken for one; chosen */
enum { MOST_BORN = 24 };

/* --- what is missing --- */

/* Returns 1 when out of memory. */
static int miss(struct cli_cover *cover, const char *format, ...) HAWSER_PRINTF(2, 3);
static int miss(struct cli_cover *cover, const char *format, ...)
{
	va_list values;

	if (hawser__more(&cover->missed, cover->misses, sizeof *cover->missed))
		return 1;
	va_start(values, format);
	vsnprintf(cover->missed[cover->misses++].text, sizeof cover->missed->text, format, values);
	va_end(values);
	return 0;
}

/* "period-doubling at Omega = 1.4 rad/s" */
struct event_text {
	char text[120];
};
static struct event_text name_of(const struct cli_frf_result *result,
                                 const struct hawser_frf_event *event)
{
	struct event_text name;

	if (result->over)
		snprintf(name.text, sizeof name.text, "%s at %.90s", hawser_event_name(event->kind),
		         cli_frf_place(result, event->omega, event->parameter).text);
	else
		snprintf(name.text, sizeof name.text, "%s at Omega = %.9g%s",
		         hawser_event_name(event->kind), event->omega*cli_per_omega(result->model),
		         cli_unit(result->model, " rad/s"));
	return name;
}

/* --- which events --- */

static int has_event(const struct hawser_frf *frf, const struct hawser_frf_event *event)
{
	for (int e = 0; e < frf->events; e++)
		if (fabs(frf->event[e].parameter - event->parameter) < SAME*fabs(event->parameter))
			return 1;
	return 0;
}

/* Whether cycles end there that one of the branches has followed. */
static int is_end(const struct cli_cover *cover, const struct hawser_frf_event *event)
{
	for (int k = 0; k < cover->borns; k++) {
		const struct hawser_frf *born = cover->born[k];

		if (born->end == HAWSER_END_HOPF &&
		    fabs(born->event[born->events - 1].parameter - event->parameter) <=
		    SAME*fabs(event->parameter))
			return 1;
	}
	return 0;
}

/* The same for branch points. */
static int meets(const struct hawser_frf *frf, double parameter)
{
	for (int e = 0; e < frf->events; e++)
		if (frf->event[e].kind == HAWSER_BRANCH_POINT &&
		    fabs(frf->event[e].parameter/parameter - 1.0) < SAME)
			return 1;
	return 0;
}

static const struct hawser_frf *branch_of(const struct cli_frf_result *result, int branch)
{
	for (int k = 0; k < result->others; k++)
		if (result->other[k].frf->branch == branch)
			return result->other[k].frf;
	return result->frf;
}

/* Whether a branch begins at this event, which none of the branches has led to yet. */
static int begins(const struct cli_cover *cover, const struct cli_frf_result *result,
                  const struct hawser_frf *frf, int e)
{
	const struct hawser_frf_event *event = &frf->event[e];

	if (event->kind == HAWSER_HOPF)
		return frf->end != HAWSER_END_HOPF && !is_end(cover, event);
	if (event->kind == HAWSER_PERIOD_DOUBLING) { /* where a branch may have come back to this one */
		for (int k = 0; k < cover->borns; k++)
			if (cover->born[k]->parent == frf->branch &&
			    (frf->swing ? has_event(cover->born[k], event)
			                : meets(cover->born[k], event->parameter)))
				return 0;
		return 1;
	}
	if (event->kind != HAWSER_BRANCH_POINT)
		return 0;
	for (int k = 0; k < cover->borns; k++)
		if (fabs(cover->born[k]->born_at - event->parameter) < SAME*fabs(event->parameter) ||
		    (cover->born[k] != frf && has_event(cover->born[k], event)))
			return 0;
	/* a branch comes back to its own parent */
	return frf->parent == 0 || !has_event(branch_of(result, frf->parent), event);
}

/* Whether equilibria are unstable in the whole range, so that no Hopf point leads to cycles, as those
 * of wakes are. */
static int grows_everywhere(const struct hawser_frf *frf)
{
	int all = frf->swing && frf->points > 0 && frf->point[0].omega == 0.0;

	for (int i = 0; i < frf->points; i++)
		all = all && frf->point[i].unstable > 1;
	for (int e = 0; e < frf->events; e++)
		all = all && frf->event[e].kind != HAWSER_HOPF;
	return all;
}

/* --- follow them --- */

/* Room for one more branch. Returns NULL when out of memory. */
static struct hawser_frf *add_born(struct cli_cover *cover)
{
	size_t count = (size_t)cover->borns + 1, all = (size_t)cover->of.branches + count;
	struct hawser_frf **born = realloc(cover->born, count*sizeof *born), *frf;
	struct cli_frf_result *other = realloc(cover->other, all*sizeof *other);

	if (born)
		cover->born = born;
	if (other)
		cover->other = other;
	if (!born || !other || !(frf = calloc(1, sizeof *frf)))
		return NULL;
	cover->other[all - 1] = (struct cli_frf_result){.frf = frf};
	cover->born[cover->borns++] = frf;
	return frf;
}

static void drop_born(struct cli_cover *cover)
{
	struct hawser_frf *frf = cover->born[--cover->borns];

	hawser_frf_clear(frf);
	free(frf);
}

/* The branch at event e of `from` (below 0: the cycles beside unstable equilibria), with its peaks. A
 * branch that is not found is a miss. */
static enum hawser_status follow(struct cli_cover *cover, struct cli_frf_result *result,
                                 const struct hawser_frf *from, int e,
                                 const struct hawser_frf_options *options,
                                 struct cli_progress *progress, cli_peaks_function *peaks,
                                 struct hawser_report *report)
{
	struct event_text at = {"equilibrium, which is unstable"};
	struct hawser_report why = {.message = ""};
	struct hawser_landmark *peak = NULL;
	struct hawser_frf *frf = add_born(cover);
	struct cli_frf_result *one;
	enum hawser_status status;

	if (!frf)
		return hawser__no_memory(report, "frf");
	if (e >= 0)
		at = name_of(result, &from->event[e]);
	result->other = cover->other;
	one = &cover->other[result->others];
	*one = *result;
	one->frf = frf;
	one->peak = NULL;
	one->peaks = one->others = one->gaps = one->misses = 0;
	status = hawser_branch_switch(frf, &result->model->rom, from, e, options, &why);
	if (status == HAWSER_ERR_MEMORY)
		return hawser__no_memory(report, "frf");
	if (frf->points < 2) {
		drop_born(cover);
		return miss(cover, "the branch beside the %s (branch %d) was not found: %s", at.text,
		            from->branch, status ? why.message : "it ends at once")
		       ? hawser__no_memory(report, "frf") : HAWSER_OK;
	}
	frf->branch = ++result->others + 1;
	if (status && miss(cover, "branch %d, from the %s, is incomplete: %s", frf->branch, at.text,
	                   why.message))
		return hawser__no_memory(report, "frf");
	status = !cli_label_plain(frf, result->model) || result->over ? HAWSER_OK
	         : peaks(&peak, one, progress, options, status || frf->end == HAWSER_END_FAILED, report);
	one->peak = peak;
	return status;
}

static enum hawser_status doubt(struct cli_cover *cover, const struct cli_frf_result *result,
                                const struct hawser_frf *from, const struct hawser_frf_event *event,
                                struct hawser_report *report)
{
	return miss(cover, "the branch beside the %s (branch %d) was not looked for: the event is %s",
	            name_of(result, event).text, from->branch,
	            event->located ? "not confirmed by the multipliers" : "not located")
	       ? hawser__no_memory(report, "frf") : HAWSER_OK;
}

/* How deep branches are followed without an option: those of rest are all that there is. */
static int own_depth(const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;
	size_t count = (size_t)frf->points*(size_t)frf->n;

	for (size_t i = 0; i < count; i++)
		if (frf->coordinate[i] != 0.0)
			return 0;
	return count > 0;
}

/* The number of `switched`, a label of one of the branches so far, or 0. */
static enum hawser_status find_label(int *label, const char *switched, struct cli_frf_result *result,
                                     struct hawser_report *report)
{
	*label = 0;
	if (!switched || cli_switch_elsewhere(switched))
		return HAWSER_OK;
	*label = (int)strtol(switched, NULL, 10);
	cli_label_all(result);
	for (int k = 0; k <= result->others; k++) {
		const struct hawser_frf *frf = k ? result->other[k - 1].frf : result->frf;

		for (int e = 0; e < frf->events; e++)
			if (frf->event[e].label == *label && (frf->event[e].kind == HAWSER_PERIOD_DOUBLING ||
			                                      frf->event[e].kind == HAWSER_HOPF ||
			                                      frf->event[e].kind == HAWSER_BRANCH_POINT))
				return HAWSER_OK;
	}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
	                    "--switch %s: no branch begins there: give the label of a period doubling, a "
	                    "branch point or a Hopf point of this response, which its table's head lists",
	                    switched);
}

enum hawser_status cli_cover_switch(struct cli_cover *cover, struct cli_frf_result *result,
                                    const struct hawser_frf_options *options, int depth,
                                    const char *switched, struct cli_progress *progress,
                                    cli_peaks_function *peaks, struct hawser_report *report)
{
	struct cli_watch watch = {*progress, "frf: branches"};
	struct hawser_frf_options choice = *options;
	int level[MOST_BORN + 1] = {0}, left = 0, label;
	enum hawser_status status;

	if ((status = find_label(&label, switched, result, report)))
		return status;
	if (depth == 0)
		depth = label ? 1 : result->over ? 0 : own_depth(result);
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	if (depth > 0 && grows_everywhere(result->frf)) {
		const struct hawser_frf *rests = result->frf;

		status = follow(cover, result, rests, -1, &choice, progress, peaks, report);
		if (!status && cover->borns > 0 && cover->born[0]->points > 0 &&
		    cover->born[0]->point[0].parameter != rests->point[0].parameter &&
		    cover->born[0]->point[0].parameter != rests->point[rests->points - 1].parameter)
			status = follow(cover, result, rests, -2, &choice, progress, peaks, report);
		for (int k = 0; k < cover->borns; k++)
			level[k] = 1;
	}
	for (int k = 0; !status && depth > 0 && k <= result->others; k++) {
		int born = k - 1 - cover->of.branches, before;
		const struct hawser_frf *from = k ? result->other[k - 1].frf : result->frf;

		if (born >= 0 && level[born] >= depth)
			continue;
		for (int e = 0; e < from->events && !status && !cli_interrupted(); e++) {
			const struct hawser_frf_event *event = &from->event[e];

			if (!begins(cover, result, from, e) || (label && born < 0 && event->label != label))
				continue;
			before = cover->borns;
			if (!event->located || event->suspected)
				status = doubt(cover, result, from, event, report);
			else if (before == MOST_BORN)
				left++;
			else
				status = follow(cover, result, from, e, &choice, progress, peaks, report);
			if (cover->borns > before)
				level[before] = born < 0 ? 1 : level[born] + 1;
		}
	}
	if (!status && left > 0 && miss(cover, "branches: %d are followed, the most; those beside %d more "
	                                "events were not looked for", MOST_BORN, left))
		status = hawser__no_memory(report, "frf");
	result->missed = cover->missed;
	result->misses = cover->misses;
	*progress = watch.progress;
	return status;
}

/* --- the branch at a label of another result --- */

int cli_switch_elsewhere(const char *text)
{
	return text && strchr(text, '#');
}

enum hawser_status cli_switch_check(const char *text, const char *other, struct hawser_report *report)
{
	char *end;
	long label = strtol(text, &end, 10);

	if (!cli_switch_elsewhere(text) && (*end || label < 1 || label > 1000000000))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--switch %s: write a label of this response, or FILE#LABEL", text);
	if (cli_switch_elsewhere(text) && other)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--switch %s says where to start, and so does --%s: give one of them", text,
		                    other);
	return HAWSER_OK;
}

enum hawser_status cli_switch_period(struct cli_label *label, int period, const char *text,
                                     const struct cli_model *model, struct hawser_report *report)
{
	if (period > 1 && model->automatic)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--period %d: modes are chosen for motions of one period of the load: give "
		                    "a number of modes", period);
	if (period && text && period % label->period)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--period %d: the motion at --from-label %s has %d periods of the load: "
		                    "give a multiple", period, text, label->period);
	label->period = period ? period : label->period;
	return HAWSER_OK;
}

/* The label is a branch of one point, which is the event. */
enum hawser_status cli_switch_trace(struct hawser_frf *frf, const struct cli_frf_result *result,
                                    const struct cli_label *label,
                                    const struct hawser_frf_options *options, const char *text,
                                    struct hawser_report *report)
{
	static const enum hawser_event_kind kinds[] = {HAWSER_BRANCH_POINT, HAWSER_PERIOD_DOUBLING,
		HAWSER_HOPF};
	const struct cli_model *model = result->model;
	const char *over = result->over ? result->over->axis.key : NULL;
	int own = over && hawser_rom_autonomous(&model->rom), k = 0;
	double at = over ? label->parameter : label->omega;
	struct hawser_frf_event event = {.omega = label->omega, .parameter = at, .located = 1,
		.hopf.omega = label->omega};
	struct hawser_frf_point point = {.omega = label->omega, .parameter = at};
	const struct hawser_frf from = {.n = model->rom.n, .points = 1, .point = &point,
		.state = label->state, .period = label->period, .branch = 1, .events = 1, .event = &event,
		.event_state = label->state};
	enum hawser_status status;

	/* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): kinds has 3 */
	while (k < 2 + own && strcmp(label->kind, hawser_event_name(kinds[k])) != 0)
		k++;
	if (k == 2 + own || strcmp(label->over, over ? over : "") != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--switch %s: no branch begins there: give the label of a period doubling "
		                    "or a branch point %s", text, own
		                    ? "or a Hopf point over the same parameter"
		                    : over ? "over the same parameter" : "of a response over the frequency");
	event.kind = kinds[k];
	if (event.kind == HAWSER_HOPF)
		point.omega = 0.0;
	if (!(at >= fmin(options->from, options->to) && at <= fmax(options->from, options->to)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--switch %s: that event is at %s = %.9g%s, which is not in the range: "
		                    "give a range that has it", text, over ? over : "Omega",
		                    at*(over ? 1.0 : cli_per_omega(model)),
		                    over ? "" : cli_unit(model, " rad/s"));
	status = hawser_branch_switch(frf, &model->rom, &from, 0, options, report);
	frf->parent = 0;
	frf->branch = 1;
	return status;
}
