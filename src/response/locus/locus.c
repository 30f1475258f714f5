/* response/locus/locus.c - the loci through the bifurcations of a response; see hawser/locus.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/names.h"
#include "core/report.h"
#include "core/settle.h"
#include "response/branch/record.h"
#include "response/switch/slower.h"
#include "response/locus/locus_own.h"
#include "response/locus/locus_responses.h"
#include "response/locus/locus_walk.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"

#define SAME 1e-6 /* distance in Omega of an event that a curve passes, relative to the range; chosen */
/* Part of a search that is done after the first response, and after the others; of shipped scenes. */
#define FIRST 0.1
#define RESPONSES 0.2

const char *hawser_locus_special_name(enum hawser_event_kind kind, enum hawser_locus_special special)
{
	static const char *const plain[HAWSER_LOCUS_SPECIALS] = {
		"cusp", "generalised-period-doubling", "1:1", "1:2", "1:3", "1:4", NULL, NULL, NULL, NULL,
		"bogdanov-takens", "start"};
	static const char *const resonance[HAWSER_LOCUS_SPECIALS] = {
		[HAWSER_LOCUS_CUSP] = "turning-point", [HAWSER_LOCUS_DEGENERATE] = "branch-point",
		[HAWSER_LOCUS_WITH_FOLD] = "fold", [HAWSER_LOCUS_WITH_DOUBLING] = "period-doubling",
		[HAWSER_LOCUS_WITH_TORUS] = "torus", [HAWSER_LOCUS_START] = "start"};
	static const char *const with[4][3] = { /* enum hawser_event_kind; fold, doubling, torus */
		{"fold-fold", "fold-flip", "fold-torus"}, {"fold-flip", "flip-flip", "flip-torus"},
		{"fold-torus", "flip-torus", "torus-torus"}, {"branch-fold", "branch-flip", "branch-torus"}};

	if (kind == HAWSER_HOPF && special == HAWSER_LOCUS_DEGENERATE)
		return "generalised-hopf";
	if (special == HAWSER_LOCUS_WITH_HOPF || (kind == HAWSER_HOPF && special == HAWSER_LOCUS_WITH_FOLD))
		return kind == HAWSER_HOPF && special == HAWSER_LOCUS_WITH_HOPF ? "double-hopf" : "zero-hopf";
	if (special == HAWSER_LOCUS_TAKENS)
		return plain[special];
	if (kind == HAWSER_RESONANCE && (unsigned)special < HAWSER_LOCUS_SPECIALS && resonance[special])
		return resonance[special];
	if ((unsigned)special >= HAWSER_LOCUS_SPECIALS || (unsigned)kind > HAWSER_BRANCH_POINT)
		return "unknown";
	if (special == HAWSER_LOCUS_DEGENERATE && kind == HAWSER_BRANCH_POINT)
		return "degenerate-branch-point";
	if (special == HAWSER_LOCUS_DEGENERATE && kind == HAWSER_TORUS)
		return "chenciner";
	return plain[special] ? plain[special] : with[kind][special - HAWSER_LOCUS_WITH_FOLD];
}

HAWSER__NAMES(hawser_locus_end_name, enum hawser_locus_end, "end of the frequency range",
	"end of the parameter's range", "closed", "resonance", "no frequency", "max_points",
	"interrupted", "failed", "most work")

void hawser_locus_settle(struct hawser_locus_options *options)
{
	hawser__settle(&options->tolerance, 1e-9);
	hawser__settle(&options->step_max, 0.02);
	hawser__settle_count(&options->max_points, 2000);
}

static enum hawser_status check(const struct hawser_locus_options *o, struct hawser_report *report)
{
	int own = o->plane && o->plane->omega == 0.0;
	int known = (unsigned)o->kind <= HAWSER_BRANCH_POINT ||
	            o->kind == (own ? HAWSER_HOPF : HAWSER_RESONANCE);

	if (!known || !(o->plane || (o->from > 0.0 && o->to > 0.0)) ||
	    o->from == o->to || !isfinite(o->from - o->to) || o->parameter_from == o->parameter_to ||
	    !isfinite(o->parameter_from - o->parameter_to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
		                    "a locus of kind %d, Omega from %.9g to %.9g, parameter from %.9g to "
		                    "%.9g: loci are those of folds, period doublings, tori, branch points and "
		                    "resonances, of models without a load Hopf points; ranges must be finite "
		                    "and not empty, and frequencies positive",
		                    (int)o->kind, o->from, o->to, o->parameter_from, o->parameter_to);
	if (!(o->at >= fmin(o->parameter_from, o->parameter_to) &&
	      o->at <= fmax(o->parameter_from, o->parameter_to)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
		                    "the curves begin at %.9g of the parameter (--at), outside its range "
		                    "from %.9g to %.9g: choose a value in the range", o->at,
		                    o->parameter_from, o->parameter_to);
	return HAWSER_OK;
}

static enum hawser_status check_model(const struct hawser_rom *rom, enum hawser_event_kind kind,
                                      struct hawser_report *report)
{
	if (rom->drag)
		return hawser__drag_refuse(rom, "a locus of bifurcations", report);
	if (rom->plug && kind == HAWSER_RESONANCE)
		return hawser__more_refuse(rom, "a locus of resonances", report);
	return hawser__periods_refuse(rom, "a locus of two parameters", report);
}

void hawser__locus_list_clear(struct hawser__locus_list *list)
{
	free(list->point);
	free(list->coordinate);
	free(list->state);
	free(list->event);
	*list = (struct hawser__locus_list){.points = 0};
}

/* --- results --- */

static enum hawser_status make_room(struct hawser_locus *to, const struct hawser__locus_list part[2],
                                    struct hawser_report *report)
{
	size_t n = (size_t)to->n, points = (size_t)to->points + part[0].points + part[1].points;
	size_t events = (size_t)to->events + part[0].events + part[1].events;

	return hawser__resize(&to->point, points, sizeof *to->point) ||
	       hawser__resize(&to->coordinate, points, n*sizeof(double)) ||
	       hawser__resize(&to->state, points, 2*n*sizeof(double)) ||
	       hawser__resize(&to->curve, (size_t)to->curves + 1, sizeof *to->curve) ||
	       hawser__resize(&to->event, events, sizeof *to->event)
	       ? hawser__no_memory(report, "locus") : HAWSER_OK;
}

static void copy_point(struct hawser_locus *to, const struct hawser__locus_list *from, int i, int sign)
{
	size_t n = (size_t)to->n, k = (size_t)to->points++;

	to->point[k] = from->point[i];
	to->point[k].arc *= sign;
	memcpy(to->coordinate + k*n, from->coordinate + (size_t)i*n, n*sizeof(double));
	memcpy(to->state + k*2*n, from->state + (size_t)i*2*n, 2*n*sizeof(double));
}

enum hawser_status hawser__locus_join(struct hawser_locus *to, const struct hawser__locus_list part[2],
                                      struct hawser_report *report)
{
	enum hawser_status status = make_room(to, part, report);
	struct hawser_locus_curve *curve;
	int first = to->points;

	if (status)
		return status;
	curve = &to->curve[to->curves++];
	*curve = (struct hawser_locus_curve){.first = first, .first_event = to->events};
	curve->end[0] = part[1].points ? part[1].end : part[0].end;
	curve->end[1] = part[0].end;
	memcpy(curve->message, *part[0].message ? part[0].message : part[1].message,
	       sizeof curve->message);
	for (int e = part[1].events - 1; e >= 0; e--) {
		struct hawser_locus_event *event = &to->event[to->events++];

		*event = part[1].event[e];
		event->arc = -event->arc;
		event->after = first + part[1].points - 2 - event->after;
		event->after = event->after < first ? first : event->after;
	}
	for (int i = part[1].points - 1; i > 0; i--)
		copy_point(to, &part[1], i, -1);
	for (int e = 0; e < part[0].events; e++) {
		to->event[to->events] = part[0].event[e];
		to->event[to->events++].after += to->points;
	}
	for (int i = 0; i < part[0].points; i++)
		copy_point(to, &part[0], i, 1);
	curve->points = to->points - first;
	curve->events = to->events - curve->first_event;
	return HAWSER_OK;
}

/* Whether a curve passes the start value of the parameter at this Omega, begins or ends there: a motion
 * and its mirror image have the same. */
static int is_known(const struct hawser_locus *locus, double omega, const double extent[2])
{
	for (int e = 0; e < locus->events; e++)
		if (locus->event[e].kind == HAWSER_LOCUS_START &&
		    fabs(locus->event[e].omega - omega) < SAME*extent[0])
			return 1;
	for (int i = 0; i < locus->points; i++)
		if (fabs(locus->point[i].omega - omega) < SAME*extent[0] &&
		    fabs(locus->point[i].parameter - locus->at) < SAME*extent[1])
			return 1;
	return 0;
}

static enum hawser_status add_lost(struct hawser_locus *locus, double omega,
                                   struct hawser_report *report)
{
	if (hawser__more(&locus->lost_at, locus->lost, sizeof *locus->lost_at))
		return hawser__no_memory(report, "locus");
	locus->lost_at[locus->lost++] = omega;
	return HAWSER_OK;
}

/* The curve through an event of a response. */
static enum hawser_status trace_from(struct hawser_locus *locus, struct hawser__locus_walk *walk,
                                     const struct hawser_frf *frf, int event,
                                     struct hawser_report *report)
{
	struct hawser__locus_list part[2] = {{.points = 0}, {.points = 0}};
	int failed;
	enum hawser_status status = hawser__locus_begin(walk, frf, event, &failed);

	if (status || failed)
		return status ? status : add_lost(locus, frf->event[event].parameter, report);
	if (is_known(locus, walk->start.z[LOCUS_OMEGA], walk->locus->extent))
		return HAWSER_OK; /* a resonance, which was interpolated before */
	status = hawser__locus_follow(walk, &part[0], 1);
	hawser__span_stage(&walk->span, 0.5*(walk->span.from + walk->span.to), walk->span.to);
	if (!status && part[0].end != HAWSER_LOCUS_CLOSED && !walk->stopped)
		status = hawser__locus_follow(walk, &part[1], -1);
	if (!status)
		status = hawser__locus_join(locus, part, report);
	hawser__locus_list_clear(&part[0]);
	hawser__locus_list_clear(&part[1]);
	return status;
}

/* --- the events of the responses --- */

struct start {
	int response, event; /* -1: none */
};

/* The event of that kind next to `near`, if only one is asked for. */
static struct start nearest(const struct hawser__locus_responses *all,
                            const struct hawser_locus_options *options)
{
	struct start best = {-1, -1};
	double least = INFINITY;

	for (int k = 0; options->near != 0.0 && k <= all->cover.branches; k++) {
		const struct hawser_frf *frf = hawser__locus_response(all, k);

		for (int e = 0; e < frf->events; e++) {
			double away = fabs(frf->event[e].parameter - options->near);

			if (frf->event[e].kind == options->kind && away < least) {
				best = (struct start){k, e};
				least = away;
			}
		}
	}
	return best;
}

/* Number of a response's events of that kind before this one. */
static int count_before(const struct hawser_frf *frf, enum hawser_event_kind kind, int event)
{
	int count = 0;

	for (int e = 0; e < event; e++)
		count += frf->event[e].kind == kind;
	return count;
}

/* After the responses, the curves from each of their events are what is to be done. */
static void tell_part(struct hawser__locus_walk *walk, const struct hawser_frf *frf, int event)
{
	enum hawser_event_kind kind = walk->options->kind;
	double each = (1.0 - RESPONSES)/count_before(frf, kind, frf->events);
	double done = RESPONSES + each*count_before(frf, kind, event);

	hawser__span_stage(&walk->span, done, done + each);
}

static enum hawser_status trace_events(struct hawser_locus *locus, struct hawser__locus_walk *walk,
                                       const struct hawser_frf *frf, int only, int *any,
                                       struct hawser_report *report)
{
	for (int e = 0; e < frf->events && !walk->stopped; e++) {
		enum hawser_status status;

		if (frf->event[e].kind != walk->options->kind || (only >= 0 && e != only))
			continue;
		*any = 1;
		if (is_known(locus, frf->event[e].parameter, walk->locus->extent))
			continue;
		if (hawser__locus_refused(walk))
			break;
		tell_part(walk, frf, e);
		if ((status = trace_from(locus, walk, frf, e, report)))
			return status;
	}
	return HAWSER_OK;
}

static enum hawser_status trace_all(struct hawser_locus *locus, struct hawser__locus_walk *walk,
                                    const struct hawser__locus_responses *all,
                                    struct hawser_report *report)
{
	const struct hawser_locus_options *o = walk->options;
	struct start only = nearest(all, o);
	int any = 0;

	walk->costly |= all->cover.costly;
	for (int k = 0; k <= all->cover.branches; k++) {
		const struct hawser_frf *frf = hawser__locus_response(all, k);
		enum hawser_status status = HAWSER_OK;

		walk->costly |= frf->end == HAWSER_END_WORK;
		if (only.response < 0 || only.response == k)
			status = trace_events(locus, walk, frf, only.event, &any, report);
		if (status)
			return status;
	}
	locus->interrupted = walk->stopped;
	locus->costly = walk->costly;
	if (locus->costly && locus->curves == 0 && locus->lost == 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "locus",
		                    "the work of the response at the parameter %.9g came to its limit before "
		                    "a locus was begun: take fewer modes (-n) or a narrower range, or lift the "
		                    "limit (--max-points)", o->at);
	if (!any && !locus->interrupted)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "locus",
		                    "the response at the parameter %.9g has no %s in this range%s: begin "
		                    "at another value (--at), or change the range", o->at,
		                    hawser_event_name(o->kind), o->plane ? "" : " of frequencies");
	if (locus->curves == 0 && !locus->interrupted)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "locus",
		                    "no curve could be begun at the %s of the response%s",
		                    hawser_event_name(o->kind),
		                    o->kind == HAWSER_BRANCH_POINT
		                    ? ": branch points are followed where a symmetry of the motion breaks"
		                    : "; begin at another value (--at)");
	return HAWSER_OK;
}

/* The family over the first parameter of a plane. */
struct across {
	const struct hawser_rom_plane *plane;
	double at;
};

static enum hawser_status model_across(void *context, const struct hawser_rom **rom, double first,
                                       struct hawser_report *report)
{
	const struct across *across = context;
	const double p[2] = {first, across->at};

	return across->plane->model(across->plane->context, rom, p, report);
}

/* Progress of the responses. */
struct told {
	const struct hawser_progress *progress;
	struct hawser__span *span;
};

static int tell(void *data, const struct hawser_progress_state *state)
{
	struct told *told = data;
	struct hawser_progress_state shown = *state;

	hawser__span_foretell(told->span, &shown);
	return hawser__told_to_stop(told->progress, &shown);
}

static enum hawser_status trace_locus(struct hawser_locus *locus,
                                      const struct hawser_rom_family *family,
                                      const struct hawser_locus_options *options,
                                      struct hawser_report *report)
{
	struct hawser_locus_options own = *options;
	struct hawser_frf_options choice = {.method = NULL};
	struct across line = {own.plane, own.at};
	struct hawser_rom_family across = {own.plane ? own.plane->omega : 0.0, model_across, &line};
	struct hawser__locus system = {.n = 0};
	struct hawser__locus_walk walk = {.span = {.began = hawser__wall_seconds(), .to = FIRST}};
	struct told told = {&own.progress, &walk.span};
	struct hawser__locus_responses all = {.first = &locus->response};
	enum hawser_status status;

	hawser_locus_settle(&own);
	if (own.plane && own.plane->omega == 0.0)
		return hawser__own_locus(locus, &own, report);
	status = hawser__locus_open(&system, family, &own, report);
	locus->n = system.n;
	if (!status)
		status = check_model(system.rom, own.kind, report);
	choice.from = own.from;
	choice.to = own.to;
	choice.tolerance = own.tolerance;
	if (hawser__is_watched(&own.progress))
		choice.progress = (struct hawser_progress){tell, &told};
	choice.samples = HAWSER_NONE;
	choice.most_work = own.most_work;
	choice.skip_events = own.kind == HAWSER_RESONANCE;
	if (!status && own.kind == HAWSER_RESONANCE)
		status = hawser__locus_choose_harmonic(&system, own.harmonic, report);
	locus->harmonic = system.harmonic;
	if (own.plane)
		choice.family = &across;
	if (own.first) {
		choice.start = own.first->start;
		choice.along = own.first->along;
		choice.begin = own.first->begin;
	}
	if (!status)
		status = hawser__locus_responses_trace(&all, system.rom, &choice, &walk.span,
		                                       (const double[2]){FIRST, RESPONSES}, report);
	system.spent = all.cover.work + hawser_orbit_work(&locus->response.cost, system.rom);
	system.extent[0] = fabs(own.to - own.from);
	system.extent[1] = fabs(own.parameter_to - own.parameter_from);
	if (!status)
		status = hawser__locus_walk_open(&walk, &system, &own, report);
	for (int k = 0; !status && own.kind == HAWSER_RESONANCE && k <= all.cover.branches; k++)
		status = hawser__locus_find_resonances(&walk, hawser__locus_response(&all, k));
	if (!status && locus->response.end != HAWSER_END_INTERRUPTED)
		status = trace_all(locus, &walk, &all, report);
	locus->interrupted |= locus->response.end == HAWSER_END_INTERRUPTED;
	locus->solves = system.solves;
	hawser_cover_clear(&all.cover);
	hawser__locus_walk_close(&walk);
	hawser__locus_close(&system);
	return status;
}

/* Frequencies of the motion become those of the load. */
static void in_loads(struct hawser_locus *locus, int periods)
{
	for (int i = 0; i < locus->points; i++)
		locus->point[i].omega *= periods;
	for (int e = 0; e < locus->events; e++)
		locus->event[e].omega *= periods;
	for (int i = 0; i < locus->lost; i++)
		locus->lost_at[i] *= periods;
	hawser__frf_in_loads(&locus->response, periods, 0);
}

/* With models whose base frequency is that of motions of so many periods of the load of `rom`. */
static enum hawser_status trace_slower(struct hawser_locus *locus,
                                       const struct hawser_rom_family *family,
                                       const struct hawser_locus_options *options, int periods,
                                       const struct hawser_rom *rom, struct hawser_report *report)
{
	struct hawser_locus_options slow = *options;
	struct hawser_frf_options first = {.from = 0.0};
	struct hawser__slower slower;
	int own = hawser__rom_periods(rom);
	enum hawser_status status;

	if (periods%own || options->kind == HAWSER_RESONANCE || (periods > own && !options->first))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
		                    "loci of motions of %d periods of the load are those of their folds, "
		                    "period doublings, tori and branch points, and begin at such a motion: "
		                    "give a label of one (--from-label)", periods);
	if (options->first)
		first = *options->first;
	first.begin /= periods;
	slow.first = options->first ? &first : NULL;
	slow.from /= periods;
	slow.to /= periods;
	slow.near /= periods;
	status = hawser__slower_open(&slower, rom, family, periods/own, report);
	if (!status)
		status = trace_locus(locus, &slower.family, &slow, report);
	in_loads(locus, periods);
	hawser__slower_close(&slower);
	return status;
}

enum hawser_status hawser_locus_trace(struct hawser_locus *locus,
                                      const struct hawser_rom_family *family,
                                      const struct hawser_locus_options *options,
                                      struct hawser_report *report)
{
	const struct hawser_rom *rom;
	int periods = options->periods;
	enum hawser_status status;

	*locus = (struct hawser_locus){.kind = options->kind, .at = options->at};
	if ((status = check(options, report)))
		return status;
	if (options->plane)
		return trace_locus(locus, family, options, report);
	if ((status = family->model(family->context, &rom, options->at, report)))
		return status;
	periods = periods > hawser__rom_periods(rom) ? periods : hawser__rom_periods(rom);
	return periods > 1 ? trace_slower(locus, family, options, periods, rom, report)
	                   : trace_locus(locus, family, options, report);
}

void hawser_locus_clear(struct hawser_locus *locus)
{
	if (!locus)
		return;
	free(locus->point);
	free(locus->coordinate);
	free(locus->state);
	free(locus->curve);
	free(locus->event);
	free(locus->lost_at);
	hawser_frf_clear(&locus->response);
	*locus = (struct hawser_locus){.n = 0};
}
