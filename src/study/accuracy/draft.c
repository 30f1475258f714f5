/* study/accuracy/draft.c - see draft.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "rom/energy/full_map.h"
#include "study/accuracy/draft.h"

#define LONG 0.2        /* largest step of a curve for comparison, relative to the range; chosen */
#define CARRIED 0.3     /* work of the marks in the next basis over that of a draft; chosen */
/* For the time left alone, relative to the work of a draft: the work after the first draft until two
 * bases agree (0.1 with deep-sag.yaml, rope.yaml and inclined.yaml, 3 with conductor.yaml),
 * and that after a further draft. */
#define AGAIN 1.0
#define CHECKED 0.5
#define UNSURE 4.0      /* factor of two times left, the mean of which is right within its root */
#define ROUGH 0.01      /* tolerance of orbits at marks over the error that a basis may have; chosen:
                         * the largest distances of bases are the same with a tenth of it */
#define JUDGING 1.5e-7  /* s of a set of multipliers, over the cube of the number of coordinates */
#define DOUBT 2.0       /* factor of what is foreseen of a draft that has not ended; chosen */
#define ASIDE 2         /* points before the one from which the curve cannot be followed; chosen */
#define SLACK_POINTS 50 /* fewest points of which slackness is judged; chosen */
#define UNSEEN 0.035    /* distance of two drafts, relative to the accuracy, that is not seen between
                         * their points: 4.9e-4 at a peak of deep-sag where 4.4e-5 was */
#define TURNED 100      /* points without an advance, */
#define IN_VAIN 0.05    /* and work, of what can be borne, after which a curve may be said to wander; */
#define CREEPING 40     /* points with steps that are shorter */
#define SHORT 0.02      /* than this on the average: then at once; chosen */
#define BEGINNING 0.25  /* of what can be borne, for the first orbit of a draft; chosen */
#define NEAR 0.1        /* largest distance of marks from the curve that they are carried from: others
                          * are of another curve; chosen */
#define SIMILAR 0.3     /* height of a resonance over that of the largest one; chosen */
#define LEAST_MARKS 12  /* fewest marks with which the range may end; chosen */
#define FIRST_POINTS 24 /* of a trace, before anything is foreseen; chosen */

void hawser__traced_clear(struct hawser__traced *traced)
{
	hawser__curve_clear(&traced->curve);
	hawser__orbits_clear(&traced->orbits);
	free(traced->mark);
	*traced = (struct hawser__traced){.functions = 0};
}

void hawser__traced_give(struct hawser__traced *traced, struct hawser__draft *chosen)
{
	memcpy(chosen->largest, traced->curve.largest, sizeof chosen->largest);
	if (traced->functions == 0 || traced->functions != chosen->functions)
		return;
	chosen->orbits = traced->orbits;
	traced->orbits = (struct hawser__orbits){.n = 0};
}

void hawser__draft_clear(struct hawser__draft *draft)
{
	hawser_rom_clear(&draft->rom);
	hawser__orbits_clear(&draft->orbits);
	hawser__curve_clear(&draft->curve);
	*draft = (struct hawser__draft){.functions = 0};
}

/* Work of what follows the drafts, by one of them with the same kind of model. */
double hawser__draft_follows(const struct hawser_accuracy_options *options, int n, int points,
                             double work)
{
	return options->after > 0.0 ? options->after*work
	       : work + JUDGING*pow(n, 3.0)*HAWSER__MORE_POINTS*points;
}

/* Work of the search and the response, if the range ended where the draft is now. Where the error of a
 * response is wanted, that is mostly the answer. */
static double so_far(const struct hawser__draft_watch *watch, int points, double work)
{
	return watch->before + work*(1.0 + watch->next) +
	       (watch->options->response ? 0.0
	        : hawser__draft_follows(watch->options, watch->n, points, work));
}

/* Whether a draft is more than can be borne, of which a part is of no use either. The range of one that
 * follows a part ends there, so that what it needs is known to a factor. Once a trace has more points
 * than were expected, the work that is foreseen is a lower bound. */
static int is_costly(const struct hawser__draft_watch *watch, int points, double work)
{
	double bearable = watch->options->bearable, spent = watch->before + work;
	double doubt = points < watch->expected ? DOUBT : 1.0;

	if (isfinite(watch->a->until))
		return spent > DOUBT*bearable;
	if (watch->options->partial)
		return points < FIRST_POINTS && spent > bearable;
	return fmax(spent, watch->a->foreseen/doubt) > bearable;
}

/* Whether the curve has turned back and come no farther in as much work as it took to get there, or
 * creeps since. */
static int wanders(struct hawser__draft_watch *watch, const struct hawser_frf *frf, double work)
{
	double reach = hawser__draft_reach(frf, frf->points, &watch->options->frf), since;
	int points;

	if (reach != watch->farthest) {
		watch->farthest = reach;
		watch->turned = frf->points;
		watch->until = work;
	}
	points = frf->points - watch->turned;
	since = frf->point[frf->points - 1].arc - frf->point[watch->turned - 1].arc;
	watch->vain = (points > TURNED && work > 2.0*watch->until &&
	               work - watch->until > IN_VAIN*watch->options->bearable) ||
	              (points > CREEPING && since < SHORT*points);
	return watch->vain;
}

/* The fraction and the time left of the whole search, of which `done` is done: between what remains if
 * nothing comes in between and what there is until the range ends. Where these are far apart, the time
 * is that of the former if only the response remains, and else not known. */
static void tell_left(struct hawser_progress_state *state, const struct hawser__draft_watch *watch,
                      double done, double all)
{
	double left = fmax(all - done, 0.0), most = fmax(watch->most - done, 0.0);
	int limited = watch->most > 0.0, unsure = limited && most > UNSURE*left;

	if (!(done > 0.0))
		return;
	if (limited && !unsure && most > 0.0)
		left = sqrt(fmin(left, most)*most);
	state->fraction = done/(done + left);
	state->left = watch->drafts && unsure ? INFINITY
	              : (hawser__wall_seconds() - watch->began)*left/done;
}

/* The same while `work` of this trace is done and `left` remains of it; what follows is estimated from
 * `whole`, its work up to the end of the range. */
static void foretell(struct hawser_progress_state *state, const struct hawser__draft_watch *watch,
                     double work, double left, double whole)
{
	const struct hawser__draft *chosen = watch->chosen;
	double done = watch->before + work, all = done + left;

	if (watch->drafts && chosen->functions)
		all += hawser__draft_follows(watch->options, chosen->rom.n, chosen->points, chosen->until);
	else if (watch->drafts)
		all += hawser__draft_follows(watch->options, watch->n, watch->expected, whole);
	if (watch->drafts)
		all += (chosen->functions ? CHECKED : AGAIN)*whole;
	tell_left(state, watch, done, all);
}

/* While the marks are asked for, the work of which is `next`: that, a draft of the chosen basis unless
 * it has one, and its response remain. */
static int watch_marks(void *data, const struct hawser_progress_state *state)
{
	const struct hawser__draft_watch *watch = data;
	const struct hawser__draft *chosen = watch->chosen;
	struct hawser_progress_state shown = *state;

	tell_left(&shown, watch, watch->before + watch->next*state->done/watch->expected, watch->before +
	     watch->next + (chosen->functions != watch->n ? chosen->until : 0.0) +
	     hawser__draft_follows(watch->options, chosen->rom.n, chosen->points, chosen->until));
	return hawser__told_to_stop(&watch->options->frf.progress, &shown);
}

/* The whole work of a trace. The fraction that is done is the mean of two estimates: by the number of
 * points, which crowd at peaks, and by the range of Omega, in which folds turn back; by_range is NAN or
 * 0 if it is not known. */
static double whole_of(double work, double by_points, double by_range)
{
	return work/(0.5*(by_points + (by_range > 0.0 ? by_range : by_points)));
}

/* Ends a draft when the work that is foreseen is more than can be borne, or with options->partial when
 * that of the part so far is or the curve wanders, or where the cable is slack from early on; tells the
 * time left. */
int hawser__draft_watch_trace(void *data, const struct hawser_progress_state *state)
{
	struct hawser__draft_watch *watch = data;
	struct hawser_progress_state shown = *state;
	const struct hawser_frf *frf = state->frf;
	int points = frf ? frf->points : 0, most = watch->expected;
	int limited = watch->drafts && watch->options->bearable > 0.0;
	double work = points > 0 ? hawser_orbit_work(&frf->cost, watch->rom) : 0.0;

	if (most > 0 && points >= FIRST_POINTS) {
		double whole = work*fmax((double)most/points, 1.0);

		if (watch->drafts)
			watch->a->foreseen = so_far(watch, points > most ? points : most, whole);
		whole = whole_of(work, fmin((double)points/most, 1.0), state->fraction);
		foretell(&shown, watch, work, whole - work, whole);
	}
	watch->afforded = limited && watch->options->partial && points >= FIRST_POINTS &&
	                  ((isfinite(watch->a->until)
	                    ? watch->before + work > DOUBT*watch->options->bearable
	                    : so_far(watch, points, work) > watch->options->bearable*
	                      (watch->a->foreseen > watch->options->bearable ? HAWSER__A_PART : 1.0)) ||
	                   wanders(watch, frf, work));
	if (watch->afforded)
		return 1;
	if (limited && is_costly(watch, points, work)) {
		watch->a->costly = 1;
		if (points > 0 && !(watch->a->foreseen > 0.0)) /* of too few points to foresee it well */
			watch->a->foreseen = so_far(watch, points > most ? points : most,
			                            work*fmax((double)most/points, 1.0));
		return 1;
	}
	if (watch->drafts && points >= SLACK_POINTS && hawser__mostly_slack(frf))
		return 1;
	return hawser__told_to_stop(&watch->options->frf.progress, &shown);
}

double hawser__draft_reach(const struct hawser_frf *frf, int points,
                           const struct hawser_frf_options *range)
{
	double farthest = frf->point[0].omega;

	for (int i = 1; i < points; i++)
		farthest = (range->to > range->from ? fmax : fmin)(farthest, frf->point[i].omega);
	return farthest;
}

/* Whether the range ends with this draft: as far as it has got, or some points before one that cannot
 * be computed. */
static int ends_range(struct hawser_accuracy *a, const struct hawser__draft_watch *watch,
                      int functions, enum hawser_status status, const struct hawser_report *why)
{
	int failed = status == HAWSER_ERR_CONVERGENCE && functions >= HAWSER__MIDDLING;
	double aside = a->asked/HAWSER__SAFETY_BASIS;

	if (!watch->options->partial || a->frf.points < FIRST_POINTS || !(failed || watch->afforded))
		return 0;
	/* at a fold a little before it: that of another basis is elsewhere, by less than two may differ */
	a->until = hawser__draft_reach(&a->frf, a->frf.points - (failed ? ASIDE : 0), &watch->options->frf)*
	           (watch->options->frf.to > watch->options->frf.from ? 1.0 - aside : 1.0 + aside);
	snprintf(a->beyond, sizeof a->beyond, "%s", failed ? why->message
	         : watch->vain ? "there the curve turns back, and comes no farther in as much work as it "
	           "took to get there, or by very short steps only; "
	           "--set model.energy=exact follows it" : "");
	a->frf.end = HAWSER_END_RANGE;
	return 1;
}

static double log_omega(const struct hawser__drawn_curve *curve, int i)
{
	return curve->value[(size_t)i*((size_t)curve->width + 1)];
}

/* The part of a curve that begins where it does and ends where it first reaches log Omega = `to`. */
static struct hawser__drawn_curve part(const struct hawser__drawn_curve *curve, double to, double way)
{
	struct hawser__drawn_curve so_far = *curve;

	for (int i = curve->points; i-- > 0;)
		if (way*(log_omega(curve, i) - to) >= 0.0)
			so_far.points = i + 1;
	return so_far;
}

/* Trace the draft of the model in *draft; a->frf and *traced become its curve. */
static enum hawser_status draw(struct hawser__draft *draft, struct hawser__traced *traced,
                               struct hawser_accuracy *a,
                               const struct hawser_accuracy_options *options,
                               const struct hawser_frf_options *settled, double before,
                               const struct hawser__draft *chosen, struct hawser_report *report)
{
	const int expected = chosen->functions ? (int)(HAWSER__MORE_POINTS*chosen->points)
	                                       : options->expected;
	struct hawser__draft_watch watch = {options, a, before, CARRIED, a->began, expected, &draft->rom,
	                                    chosen, draft->rom.n, .drafts = 1,
	                                    .most = options->partial ? options->bearable : 0.0};
	struct hawser_frf_options frf = *settled;
	struct hawser_report why = {.message = ""};
	struct hawser_progress_state told;
	struct hawser__trace_watch keep;
	enum hawser_status status;

	*traced = (struct hawser__traced){.functions = 0};
	keep = hawser__orbits_watch(&traced->orbits);
	keep.first = BEGINNING*options->bearable;
	frf.unjudged = 2;
	frf.skip_events = 1;
	frf.samples = HAWSER_NONE;
	frf.most_unstable = 0;
	frf.step_max = LONG;
	frf.progress = (struct hawser_progress){hawser__draft_watch_trace, &watch};
	hawser_frf_clear(&a->frf);
	status = hawser__frf_trace(&a->frf, &draft->rom, &frf, &keep, &why);
	if (ends_range(a, &watch, draft->functions, status, &why))
		status = HAWSER_OK;
	else if (status == HAWSER_ERR_CONVERGENCE && a->frf.end == HAWSER_END_INTERRUPTED)
		return HAWSER_OK; /* without a point; the search ends */
	else if (status && report)
		*report = why;
	draft->points = a->frf.points;
	draft->work = a->frf.points > 0 ? hawser_orbit_work(&a->frf.cost, &draft->rom) : keep.first;
	a->slack = !status && !a->costly && hawser__mostly_slack(&a->frf);
	if (!status)
		status = hawser__curve_copy(&traced->curve, &a->frf, report);
	if (status || !(traced->mark = malloc(((size_t)a->frf.points + 1)*sizeof(int))))
		return status ? status : hawser__no_memory(report, "accuracy");
	/* folds lead back into the range, which ends where it first does */
	if (isfinite(a->until))
		traced->curve = part(&traced->curve, log(a->until), settled->to > settled->from ? 1.0 : -1.0);
	draft->points = traced->curve.points;
	draft->until = draft->work*traced->curve.points/fmax(a->frf.points, 1.0);
	told = hawser__progress_state("response", "points", a->frf.points, a->began);
	foretell(&told, &watch, draft->work, 0.0, draft->until);
	if (hawser__told_to_stop(&options->frf.progress, &told))
		a->frf.end = HAWSER_END_INTERRUPTED;
	traced->functions = draft->functions;
	traced->work = draft->until;
	traced->end = a->frf.end;
	return hawser__curve_marks(traced->mark, &traced->marks, &traced->curve, report);
}

/* Whether the part of a curve has a resonance that compares with those of the whole. */
static int resounds(const struct hawser__drawn_curve *whole, const struct hawser__drawn_curve *so_far)
{
	int does = 0;

	for (int k = 0; k < 2; k++) {
		double most[2] = {0.0, 0.0};

		for (int i = 0; i < whole->points; i++) {
			double *own = &most[i >= so_far->points];

			*own = fmax(*own, whole->value[(size_t)i*((size_t)whole->width + 1) + whole->largest[k]]);
		}
		does |= whole->largest[k] > 0 && most[0] > SIMILAR*most[1];
	}
	return does;
}

int hawser__traced_part(struct hawser__traced *traced, struct hawser_accuracy *a, int found,
                        const struct hawser_frf_options *range)
{
	double way = range->to > range->from ? 1.0 : -1.0, aside = 1.0 - way*a->asked/HAWSER__SAFETY_BASIS;
	struct hawser__drawn_curve so_far;
	double until;

	if (found < LEAST_MARKS)
		return 0;
	if (found == traced->marks)
		return 1;
	until = hawser__draft_reach(&a->frf, traced->mark[found - 1] + 1, range)*aside;
	so_far = part(&traced->curve, log(until), way);
	if (!resounds(&traced->curve, &so_far))
		return 0;
	a->until = until;
	a->beyond[0] = '\0';
	traced->work *= (double)so_far.points/traced->curve.points;
	traced->curve = so_far;
	while (traced->marks > 0 && traced->mark[traced->marks - 1] >= so_far.points)
		traced->marks--;
	return 1;
}

/* The counterparts of the marks in the model of *draft, if there are, and how far they are from the
 * curve. */
enum hawser_status hawser__draft_carry(struct hawser__draft *draft, double *away,
                                       struct hawser__traced *traced, struct hawser_accuracy *a,
                                       const struct hawser__draft_told *told,
                                       const struct hawser_frf_options *settled, double enough,
                                       double most, struct hawser_report *report)
{
	const double larger = pow((double)draft->rom.n/fmax(traced->orbits.n, 1), 2.0);
	struct hawser__draft_watch watch;
	struct hawser_frf_options frf = *settled;
	struct hawser_frf found = {.n = 0};
	int lost = 1, rows, columns;
	double *map = NULL;
	enum hawser_status status = HAWSER_OK;

	*away = INFINITY;
	frf.tolerance = fmax(frf.tolerance, ROUGH*enough);
	frf.most_work = most;
	if (traced->orbits.count < traced->curve.points)
		return HAWSER_OK;
	if (told) {
		watch = (struct hawser__draft_watch){told->options, a, told->before,
		                                     CARRIED*larger*traced->work, a->began,
		                                     traced->marks, &draft->rom, told->chosen,
		                                     traced->functions, .drafts = 1};
		watch.most = told->options->partial ? told->options->bearable : 0.0;
		frf.progress = (struct hawser_progress){watch_marks, &watch};
	}
	status = hawser__full_map(&map, &rows, &columns, &a->modes.statics, traced->functions,
	                          draft->functions, report);
	if (!status && rows == draft->rom.n && columns == traced->orbits.n)
		status = hawser__carry(&found, &lost, &draft->rom, &traced->orbits, traced->mark,
		                       traced->marks, map, &frf, report);
	free(map);
	draft->work = hawser_orbit_work(&found.cost, &draft->rom);
	if (found.end == HAWSER_END_INTERRUPTED)
		a->frf.end = HAWSER_END_INTERRUPTED;
	if (lost && (found.end == HAWSER_END_INTERRUPTED || !(most > 0.0)))
		found.points = 0;
	if (!status && found.points > 0)
		status = hawser__curve_copy(&draft->curve, &found, report);
	if (!status && found.points > 0)
		status = hawser__curve_points_distance(away, &traced->curve, traced->mark, NULL,
		                                       &draft->curve, 0, report);
	if (!(*away <= NEAR) || (lost && !hawser__traced_part(traced, a, found.points, settled)))
		*away = INFINITY;
	if (isfinite(*away))
		draft->curve.points = traced->marks;
	else
		hawser__curve_clear(&draft->curve);
	hawser_frf_clear(&found);
	return status;
}

/* The same basis with a draft of its own, in place of the last one, with which it is compared. */
enum hawser_status hawser__draft_draw(struct hawser__draft *next, double *moved,
                                      struct hawser__traced *traced,
                                      struct hawser__draft *chosen, struct hawser_accuracy *a,
                                      const struct hawser_accuracy_options *options,
                                      const struct hawser_frf_options *settled, double before,
                                      struct hawser_report *report)
{
	struct hawser__traced last = *traced;
	enum hawser_status status;

	*moved = INFINITY;
	hawser__curve_clear(&next->curve);
	status = draw(next, traced, a, options, settled, before, chosen, report);
	if (isfinite(a->until))
		last.curve = part(&last.curve, log(a->until), settled->to > settled->from ? 1.0 : -1.0);
	if (!status && !hawser__accuracy_cut(a) && last.functions && last.functions == chosen->functions &&
	    traced->end == last.end)
		status = hawser__curve_distance(moved, &last.curve, &traced->curve, report);
	*moved = fmax(*moved, UNSEEN*a->asked);
	hawser__traced_give(&last, chosen);
	hawser__traced_clear(&last);
	return status;
}
