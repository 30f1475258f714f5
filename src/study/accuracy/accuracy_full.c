/* study/accuracy/accuracy_full.c - full-order models of increasing bases, for an accuracy that no
 * condensed model reaches.
 *
 * A condensed model lacks terms of the energy that no further modes replace. A full-order model has
 * all terms; its error is that of its basis. This error mostly decreases so fast that the
 * difference of two successive bases is far larger than the error of the second. An exception is a
 * harmonic of the response near resonance with a high mode, whose frequency only a large basis has
 * accurately. Successive differences are then of similar size (B Table 4.4, line 2: 1.2e-4 from 12
 * to 14 functions, 1.5e-4 from 14 to 16). Therefore the estimated error is a multiple of the
 * difference.
 *
 * A draft tells which basis is good: a curve with long steps and without multipliers, a fifth of
 * the time of a response. Its folds, peaks and some points between them are its marks, and larger
 * bases are asked for the counterparts of these alone (carry.h), a tenth of the time of a draft:
 * what the curve is moved by there is its error. Of the first two bases that agree the smaller one
 * is taken, and its response traced, through the orbits of its draft, which is traced then if it has
 * none. Where a counterpart is not found or is far away, the larger basis has a draft of its own, with
 * which the next ones are compared, and the two curves are compared as a whole (curve.c). A resonance
 * that the draft lacks has no marks; but it lies above the modes that each of these bases holds.
 *
 * Where the curve of a condensed model is near enough to the draft and its bases to each other, that
 * response is the answer, and the sum of the distances its error: an estimate of first order, which
 * called for the exact energy, is up to six times the true error, or there is none (dampers).
 *
 * With options->partial a draft ends where its response would take more than can be borne, or where
 * the motion cannot be followed, and the range then ends there: a right answer to a part of the
 * question. So it does at the last mark that has a counterpart near enough, if more drafts would take
 * too much.
 *
 *    work     seconds of a trace, as hawser_orbit_work counts them: what is chosen does not depend
 *             on the machine and what else it does
 *    foreseen work of the whole search and its response; above options->bearable it ends
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/cover.h>
#include <math.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "study/accuracy/draft.h"
#include "study/accuracy/landmark.h"

#define FINEST 1e-9      /* smallest tolerance of the orbits; chosen, far below any accuracy */
#define COARSEST 1e-7    /* largest one; chosen: with 1e-6 orbits near folds of a stay with a damping
                          * ratio of 0.3 % are known to 1e-2 */
#define LOCATING 0.2    /* of what can be borne, for the peaks of a draft; chosen */
#define AT_LEAST 0.5    /* of what can be borne, for the response whatever the drafts took; chosen */
#define OF_BASIS 0.3    /* of the distance of a response from a draft, by the basis of that; chosen */
#define CHECKING 0.2    /* of what can be borne, for the marks in a larger basis, where the range may
                         * be shortened; chosen */

/* The last condensed model, its response with its marks (NULL: none that counts), and its distance. */
struct condensed {
	struct hawser_rom rom;
	struct hawser_frf frf;
	const struct hawser__marks *marks;
	double off, near; /* from the exact energy's; near enough to be the answer */
	int lent;         /* 1: the response is the caller's */
};

/* In harmonic balance, the tolerance limits the error of every orbit, which is larger than that of
 * folds and peaks. A larger tolerance is therefore sufficient. */
static struct hawser_frf_options settle(const struct hawser_accuracy_options *options,
                                        double accuracy)
{
	struct hawser_frf_options frf = hawser__accuracy_settle(options, accuracy);

	if (options->frf.tolerance == 0.0)
		frf.tolerance = fmin(fmax(1e-3*accuracy, FINEST), COARSEST);
	return frf;
}

/* No model reached the accuracy: fail with the reason of the last model. */
static enum hawser_status lost(const struct hawser_accuracy *a, struct hawser_report *report)
{
	struct hawser_report last;

	if (!report)
		return HAWSER_ERR_CONVERGENCE;
	last = *report;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "accuracy", last.iteration,
	                       last.residual, "an accuracy of %g is not reached with condensed models, "
	                       "and the full-order one that was to replace them fails: %s", a->asked,
	                       last.message);
}

/* Decide what follows a draft, begun or not, that failed because the basis is too small for the motion,
 * or the tolerance too large. Returns 1 to go on after *functions, with the next basis or with a
 * smaller tolerance and the same basis. */
static int retry(enum hawser_status status, int *functions, struct hawser_frf_options *frf,
                 const struct hawser_accuracy_options *options, const struct hawser_accuracy *a)
{
	if (status != HAWSER_ERR_CONVERGENCE || (!a->frf.points && *functions >= HAWSER__MIDDLING))
		return 0;
	if (options->frf.tolerance == 0.0 && frf->tolerance > FINEST && *functions >= HAWSER__MIDDLING) {
		frf->tolerance = FINEST;
		(*functions)--;
		return 1;
	}
	return *functions < hawser__accuracy_largest(options->most_functions, &a->modes.statics);
}

/* Whether the distance of a response is rather that of the draft from the next basis, and a draft of
 * that one can be borne. */
static int is_rough(const struct condensed *condensed, double moved,
                    const struct hawser__draft *chosen, const struct hawser__draft *next, double work,
                    double bearable)
{
	double drawn = chosen->work*pow((double)next->rom.n/chosen->rom.n, 3.0);

	return condensed->lent && moved > OF_BASIS*condensed->off && work + drawn < AT_LEAST*bearable;
}

/* The distance of the condensed response from the draft a->frf, peaks of which are located as well as
 * those of a response. */
static enum hawser_status compare_condensed(struct condensed *condensed,
                                            const struct hawser_accuracy *a,
                                            const struct hawser_rom *rom,
                                            const struct hawser_frf_options *settled,
                                            double bearable, struct hawser_report *report)
{
	struct hawser__marks found = {.count = 0};
	struct hawser_frf_options located = *settled;
	enum hawser_status status = HAWSER_OK;

	condensed->off = INFINITY;
	located.most_work = LOCATING*bearable;
	if (!condensed->marks || hawser__accuracy_cut(a) || isfinite(a->until))
		return HAWSER_OK;
	status = hawser__marks_find(&found, &a->frf, rom, &located,
	                            HAWSER__LOCATED*(condensed->lent ? HAWSER__BASIS_PART : 1.0)*a->asked,
	                            report);
	if (!status)
		status = hawser__marks_distance(&condensed->off, condensed->marks, &found, report);
	condensed->off = (condensed->lent ? HAWSER__MARGIN : 1.0)*condensed->off +
	                 hawser__marks_located(&found);
	hawser__marks_clear(&found);
	return status;
}

/* Whether what follows a draft, after this work, is more than can be borne: a->foreseen, a->costly. */
static int is_costly(struct hawser_accuracy *a, const struct hawser__draft *draft,
                     const struct hawser_accuracy_options *options, double work)
{
	a->foreseen = work + hawser__draft_follows(options, draft->rom.n, draft->points, draft->work);
	a->costly = options->bearable > 0.0 && !options->partial && a->foreseen > options->bearable;
	return a->costly;
}

/* The same in a search among bases. Where the error of a response is wanted, no other follows. */
static int ends_search(struct hawser_accuracy *a, const struct hawser__draft *draft,
                       const struct hawser_accuracy_options *options, double work)
{
	return !options->response && !options->partial && is_costly(a, draft, options, work);
}

/* A draft of the chosen basis, which has none: a response through the orbits of its draft is traced in
 * less than half the time. */
static enum hawser_status guide(struct hawser__draft *chosen, struct hawser__traced *traced,
                                struct hawser_accuracy *a,
                                const struct hawser_accuracy_options *options,
                                struct hawser_frf_options *frf, double *work,
                                struct hawser_report *report)
{
	const struct hawser__draft before = *chosen;
	struct hawser__draft none = {.functions = 0};
	struct hawser_report why;
	double moved;
	enum hawser_status status;

	if (hawser__accuracy_cut(a) || is_costly(a, chosen, options, *work))
		return HAWSER_OK;
	status = hawser__draft_draw(chosen, &moved, traced, &none, a, options, frf, *work, &why);
	*work += chosen->work;
	if (isfinite(a->until))
		frf->to = a->until;
	if (status == HAWSER_ERR_CONVERGENCE) { /* without one, then */
		chosen->points = before.points;
		chosen->work = before.work;
		chosen->until = before.until;
		return HAWSER_OK;
	}
	if (status && report)
		*report = why;
	return status;
}

/* Points and work of a draft of which a part remains. */
static void shrink(struct hawser__draft *draft, int points, double share)
{
	draft->points = points;
	draft->work *= share;
	draft->until *= share;
}

/* The first bases of which two agree: *chosen is the smaller one, *moved the distance of the two,
 * error [2] that of the smaller one, of all and of the largest peaks, and *checked the coordinates of
 * the larger. If no two agree, the last ones of which anything is known. */
static enum hawser_status choose(struct hawser__draft *chosen, double *moved, double *error,
                                 int *checked, struct condensed *condensed,
                                 struct hawser_accuracy *a, const struct hawser_scene *scene,
                                 const struct hawser_accuracy_options *options,
                                 struct hawser_frf_options *frf, double *work,
                                 struct hawser_report *report)
{
	/* error of a basis */
	const double enough = condensed->lent ? HAWSER__BASIS_PART*a->asked : a->asked;
	const struct hawser_accuracy_bases of = {&a->modes, scene, a->choice.to, enough,
	                                         options->most_functions};
	struct hawser__traced traced = {.functions = 0};
	enum hawser_status status = HAWSER_OK;
	int functions = condensed->lent ? hawser__accuracy_fewest(&a->modes.statics) : 0, largest[2];

	while (!status) {
		struct hawser__draft next = {.functions = 0};
		const struct hawser__draft_told told = {options, chosen, *work};
		double away = INFINITY;
		int again = 0, partial, points = traced.curve.points;

		status = hawser_accuracy_basis(&next.rom, &functions, &of, chosen->rom.n, report);
		if (status || next.rom.n == 0)
			break;
		a->functions = next.functions = functions;
		partial = hawser__marks_partial(options, &traced, chosen->rom.n, next.rom.n, *work);
		if (traced.functions)
			status = hawser__draft_carry(&next, &away, &traced, a, &told, frf, enough,
			                             partial ? CHECKING*options->bearable : 0.0, report);
		*work += next.work;
		if (traced.functions) { /* as many points, each of which takes longer */
			next.points = chosen->points;
			next.work = chosen->work*pow((double)next.rom.n/chosen->rom.n, 2.0);
			next.until = chosen->until*pow((double)next.rom.n/chosen->rom.n, 2.0);
		}
		if (!status && isfinite(away))
			status = hawser__curve_points_distance(moved, &traced.curve, traced.mark,
			                                       chosen->curve.points ? &chosen->curve : NULL,
			                                       &next.curve, 0, report);
		if (!status && isfinite(away) && partial && !(HAWSER__SAFETY_BASIS**moved <= enough))
			status = hawser__marks_shorten(moved, &traced, a, &next, &chosen->curve,
			                               enough/HAWSER__SAFETY_BASIS, frf, report);
		if (isfinite(a->until))
			frf->to = a->until;
		if (traced.curve.points < points) {
			shrink(chosen, traced.curve.points, (double)traced.curve.points/points);
			shrink(&next, traced.curve.points, (double)traced.curve.points/points);
		}
		if (!status && isfinite(away) &&
		    !is_rough(condensed, *moved, chosen, &next, *work, options->bearable)) {
			condensed->off += *moved;
		} else if (!status && (a->frf.end == HAWSER_END_INTERRUPTED ||
		                       ends_search(a, &next, options, *work + next.work))) {
			hawser__draft_clear(&next); /* of which nothing is known */
			break;
		} else if (!status) {
			away = INFINITY;
			status = hawser__draft_draw(&next, moved, &traced, chosen, a, options, frf, *work, report);
			*work += next.work;
			again = !(options->bearable > 0.0 && *work >= options->bearable) &&
			        retry(status, &functions, frf, options, a);
			if (isfinite(a->until))
				frf->to = a->until;
			if (!status)
				status = compare_condensed(condensed, a, &next.rom, frf, options->bearable,
				                           report);
		}
		if (again) {
			status = HAWSER_OK;
			hawser__draft_clear(&next);
			continue;
		}
		*checked = next.rom.n;
		error[0] = error[1] = HAWSER__SAFETY_BASIS**moved;
		if (status || hawser__accuracy_cut(a) || *error <= enough) {
			if (!status && isfinite(away))
				status = hawser__marks_error(error, a, &traced, &chosen->curve, &next, *moved,
				                             functions, &of, frf, report);
			hawser__draft_clear(&next);
			break;
		}
		hawser__draft_clear(chosen);
		*chosen = next;
		if (ends_search(a, chosen, options, *work)) /* and so is any larger basis */
			break;
	}
	memcpy(largest, traced.curve.largest, sizeof largest); /* of which the second error is */
	if (!status && chosen->functions && chosen->functions != traced.functions &&
	    chosen->orbits.count == 0 && !options->response && options->after == 0.0 && *error <= enough)
		status = guide(chosen, &traced, a, options, frf, work, report);
	hawser__traced_give(&traced, chosen);
	memcpy(chosen->largest, largest, sizeof largest);
	hawser__traced_clear(&traced);
	return status;
}

/* The response of the chosen basis. */
static enum hawser_status follow(struct hawser_accuracy *a, struct hawser__marks *marks,
                                 const struct hawser_scene *scene,
                                 const struct hawser_accuracy_options *options,
                                 const struct hawser_frf_options *settled,
                                 struct hawser__draft *chosen, double work,
                                 struct hawser_report *report)
{
	const int points = (int)(HAWSER__MORE_POINTS*chosen->points);
	struct hawser__draft_watch watch = {options, a, work, 0.0, a->began, points, &a->rom,
	                                    chosen, a->rom.n, .drafts = 0};
	struct hawser_frf_options frf = *settled;
	enum hawser_status status;

	frf.progress = (struct hawser_progress){hawser__draft_watch_trace, &watch};
	if (options->partial)
		frf.most_work = fmax(options->bearable - work, AT_LEAST*options->bearable);
	watch.most = options->partial ? work + frf.most_work : 0.0;
	status = hawser__accuracy_attempt(a, marks, scene, chosen->functions, &frf,
	                                  &chosen->orbits, report);
	if (status == HAWSER_ERR_CONVERGENCE && options->frf.tolerance == 0.0 && frf.tolerance > FINEST) {
		frf.tolerance = FINEST;
		status = hawser__accuracy_attempt(a, marks, scene, chosen->functions, &frf,
	                                  &chosen->orbits, report);
	}
	a->traced.progress = options->frf.progress;
	if (!status && hawser_cover_needed(&a->frf, &a->traced))
		a->frf.back = hawser__orbits_back(&chosen->orbits, settled->to);
	if (!status && a->frf.end == HAWSER_END_WORK) {
		a->until = a->traced.to = hawser__draft_reach(&a->frf, a->frf.points, settled);
		a->beyond[0] = '\0';
		a->frf.end = HAWSER_END_RANGE;
	}
	return status;
}

static void take_back(struct hawser_rom *rom, struct condensed *condensed)
{
	hawser_rom_clear(rom);
	if (!condensed->lent)
		*rom = condensed->rom;
	condensed->rom = (struct hawser_rom){.n = 0};
}

/* Whether the condensed response is near enough to the exact energy's: then it is the answer. */
static int is_right(struct hawser_accuracy *a, struct condensed *condensed, double error, int checked)
{
	error += condensed->off;
	if (!condensed->marks || isfinite(a->until) ||
	    !(error + hawser__marks_located(condensed->marks) <= condensed->near))
		return 0;
	take_back(&a->rom, condensed);
	hawser_frf_clear(&a->frf);
	if (!condensed->lent)
		a->frf = condensed->frf;
	condensed->frf = (struct hawser_frf){.n = 0};
	a->functions = 0;
	a->attempt[a->tries - 1].moved = condensed->off;
	a->attempt[a->tries - 1].checked = checked;
	hawser__accuracy_claim(a, error, condensed->marks);
	return 1;
}

/* error [2], column [2]: as of choose. */
static void claim(struct hawser_accuracy *a, const double *error, const int *column,
                  const struct hawser__marks *marks)
{
	struct hawser_landmark largest[2];
	int same = 1;

	hawser__largest_peaks(largest, &a->frf, marks->item, marks->count);
	for (int k = 0; k < 2; k++) {
		int own = 1 + hawser__peak_column(&largest[k]);

		same &= own > 0 && (own == column[0] || own == column[1]);
	}
	hawser__accuracy_claim(a, error[same], marks);
	a->largest = same ? a->estimated : 0.0;
	hawser__accuracy_claim(a, *error, marks);
}

static enum hawser_status search(struct hawser_accuracy *a, struct hawser__marks *marks,
                                 struct condensed *condensed, struct hawser__draft *chosen,
                                 const struct hawser_scene *scene,
                                 const struct hawser_accuracy_options *options,
                                 struct hawser_report *report)
{
	struct hawser_frf_options frf = settle(options, a->asked);
	double moved = INFINITY, error[2] = {INFINITY, INFINITY}, work = 0.0;
	double start = a->began = hawser__wall_seconds();
	int checked = 0;
	enum hawser_status status = choose(chosen, &moved, error, &checked, condensed, a, scene, options,
	                                   &frf, &work, report);

	if (status || hawser__accuracy_cut(a) || !chosen->functions ||
	    is_right(a, condensed, *error, checked))
		return status;
	if (condensed->lent)
		a->attempt[0].moved = condensed->off;
	if (a->costly || is_costly(a, chosen, options, work) ||
	    (options->agreed && !(*error <= a->asked))) {
		condensed->near = 1.0; /* far off, and stated */
		if (condensed->lent && is_right(a, condensed, *error, checked))
			a->functions = chosen->functions;
		return HAWSER_OK;
	}
	hawser_rom_clear(&a->rom);
	a->rom = chosen->rom;
	a->functions = chosen->functions;
	chosen->rom = (struct hawser_rom){.n = 0};
	if (options->after > 0.0) {
		a->estimated = fmax(*error, HAWSER__LEAST_CLAIM*a->asked);
		a->checked = checked;
		return HAWSER_OK;
	}
	status = follow(a, marks, scene, options, &frf, chosen, work, report);
	if (!status) {
		struct hawser_accuracy_try *this = &a->attempt[a->tries - 1];

		this->seconds = hawser__wall_seconds() - start;
		this->moved = moved;
		this->checked = checked;
		if (!hawser__accuracy_cut(a) && isfinite(moved))
			claim(a, error, chosen->largest, marks);
	}
	return status;
}

enum hawser_status hawser__accuracy_full(struct hawser_accuracy *a, struct hawser__marks *marks,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	struct hawser__draft chosen = {.functions = 0};
	struct condensed condensed = {a->rom, a->frf, .off = INFINITY, .near = a->asked,
	                              .lent = options->response != NULL};
	enum hawser_status status;

	if (a->tries > 0 && !hawser__accuracy_cut(a))
		condensed.marks = marks;
	if (condensed.lent && options->near > 0.0)
		condensed.near = options->near;
	a->rom = (struct hawser_rom){.n = 0};
	a->frf = (struct hawser_frf){.n = 0};
	status = search(a, marks, &condensed, &chosen, scene, options, report);
	if (a->rom.n == 0)
		take_back(&a->rom, &condensed);
	if (!condensed.lent) {
		hawser_rom_clear(&condensed.rom);
		hawser_frf_clear(&condensed.frf);
	}
	hawser__draft_clear(&chosen);
	return status == HAWSER_ERR_CONVERGENCE ? lost(a, report) : status;
}

/* The candidates of a search without modes, and the response to begin with. */
static enum hawser_status begin(struct hawser_accuracy *a, struct hawser__marks *marks,
                                const struct hawser_statics *statics,
                                const struct hawser_scene *scene,
                                const struct hawser_accuracy_options *options,
                                struct hawser_report *report)
{
	const struct hawser_frf_options settled = hawser__accuracy_settle(options, a->asked);
	double from = options->frf.from, to = options->frf.to;
	enum hawser_status status = hawser__accuracy_candidates(&a->modes, statics, scene, from, to,
	                                                        a->asked, HAWSER__FEWEST, report);

	a->choice.to = fmax(from, to);
	if (status || !options->response)
		return status;
	status = hawser__marks_find(marks, options->response, options->rom, &settled,
	                            HAWSER__LOCATED*a->asked, report);
	if (status)
		return status;
	a->rom = *options->rom;
	a->frf = *options->response;
	a->attempt[a->tries++] = (struct hawser_accuracy_try){.modes = a->rom.n, .moved = NAN};
	return HAWSER_OK;
}

enum hawser_status hawser_accuracy_exact(struct hawser_accuracy *accuracy,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	double start = hawser__wall_seconds();
	struct hawser__marks marks = {0};
	enum hawser_status status = hawser__accuracy_begin(accuracy, scene, options, report);

	if (!status && !(statics->epsilon > 0.0))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                      "an inextensible cable has no full-order model");
	if (!status)
		status = begin(accuracy, &marks, statics, scene, options, report);
	if (!status)
		status = hawser__accuracy_full(accuracy, &marks, scene, options, report);
	accuracy->reached = (options->response && !accuracy->full
	                     ? accuracy->estimated < 1.0 : accuracy->estimated <= accuracy->asked) &&
	                    !hawser__accuracy_cut(accuracy);
	accuracy->seconds = hawser__wall_seconds() - start;
	hawser__marks_clear(&marks);
	return status;
}
