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
 * A draft tells which basis is good: a curve with long steps and without multipliers, a fifth of the
 * time of a response. Its folds, peaks and some points between them are its marks, and larger bases
 * are asked for the counterparts of these alone (carry.h), a tenth of the time of a draft: what the
 * curve is moved by there is its error. Of the first two bases that agree the smaller one is taken,
 * and its response traced. Where a counterpart is not found or is far away, the larger basis has a
 * draft of its own, with which the next ones are compared, and the two curves are compared as a whole
 * (curve.c). A resonance that the draft lacks has no marks; but it lies above the modes that each of
 * these bases holds.
 *
 * The agreement of two bases that do not resolve the linear modes of the range, or the load, means
 * nothing. Such a basis is skipped without a draft. So is one with as many coordinates as the
 * last: attachments divide the cable into elements, which share the functions out, so that 6 and 8
 * of them may give the same model.
 *
 * With options->partial a draft ends where its response would take more than can be borne, or where
 * the motion cannot be followed, and the range then ends there: a right answer to a part of the
 * question.
 *
 *    work     seconds of a trace, as hawser_orbit_work counts them: what is chosen does not depend
 *             on the machine and what else it does
 *    foreseen work of the whole search and its response; above options->bearable it ends
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "study/accuracy/carry.h"
#include "rom/energy/full_map.h"
#include "study/accuracy/accuracy.h"

#define SAFETY_BASIS 3.0 /* factor on the difference, calibrated by bench/accuracy.c */
#define FINEST 1e-9      /* smallest tolerance of the orbits; chosen, far below any accuracy */
#define COARSEST 1e-6    /* largest one; chosen */
#define MIDDLING 12      /* functions per component from which on a failure is attributed to the
                          * tolerance, not to the basis; chosen */
#define RESOLVED 0.1     /* largest error of the frequencies in the range, relative to the accuracy;
                          * chosen */
#define ROUGHLY 1.0      /* the same for modes up to REACH times the upper end of the range; chosen */
#define LACKS 0.02       /* largest part of the static response to the load that a basis lacks;
                          * chosen */
#define LONG 0.2         /* largest step of a curve for comparison, relative to the range; chosen */
#define MORE_POINTS 1.2 /* of a response, over those of its draft or of the modes; chosen */
#define CARRIED 0.3     /* work of the marks in the next basis over that of a draft; chosen */
#define NEAR 0.1        /* largest distance of marks from the curve that they are carried from: others
                          * are of another curve; chosen */
#define ROUGH 1e-5      /* least tolerance of orbits at marks; chosen, far below the distances */
#define DOUBT 2.0       /* factor of what is foreseen of a draft that has not ended; chosen */
#define A_PART 0.5      /* of what can be borne, for a part of the range; chosen */
#define ASIDE 2         /* points before the one from which the curve cannot be followed; chosen */
#define SLACK_POINTS 50 /* fewest points of which slackness is judged; chosen */
#define FIRST_POINTS 24 /* of a trace, before anything is foreseen; chosen */
#define REACH 2.0        /* 2: the second harmonic of the response may be in resonance with them */

/* Numbers of functions per component, in the order in which they are tried. */
static const int bases[] = {6, 8, 10, 12, 14, 16, 20, 24};
enum { BASES = sizeof bases/sizeof *bases };

/* Whether the basis of the model holds the linear modes and the load. */
static enum hawser_status resolves(int *good, const struct hawser_rom *full,
                                   const struct hawser_accuracy_bases *of, int functions,
                                   struct hawser_report *report)
{
	double lacks = 0.0;
	enum hawser_status status = HAWSER_OK;
	int worst;

	*good = hawser_rom_full_error(&worst, full, of->modes, of->to) <= RESOLVED*of->accuracy &&
	        hawser_rom_full_error(&worst, full, of->modes, REACH*of->to) <= ROUGHLY*of->accuracy;
	if (*good)
		status = hawser_rom_full_lacks(&lacks, &of->modes->statics, of->scene, functions, report);
	*good &= lacks <= LACKS;
	return status;
}

enum hawser_status hawser_accuracy_basis(struct hawser_rom *rom, int *functions,
                                         const struct hawser_accuracy_bases *of, int coordinates,
                                         struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int most = of->most > 0 ? of->most : bases[BASES - 1];

	*rom = (struct hawser_rom){.n = 0};
	for (int i = 0; !status && i < BASES && bases[i] <= most; i++) {
		int good = 0;

		if (bases[i] <= *functions)
			continue;
		*functions = bases[i];
		status = hawser_rom_build_full(rom, &of->modes->statics, of->scene, bases[i], report);
		if (!status && rom->n > coordinates)
			status = resolves(&good, rom, of, bases[i], report);
		/* the largest basis of all is tried whatever it resolves */
		if (!status && rom->n > coordinates && (good || (of->most == 0 && i + 1 == BASES)))
			return HAWSER_OK;
		hawser_rom_clear(rom);
	}
	return status;
}

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

/* Decide what follows a draft that failed because the basis is too small for the motion, or the
 * tolerance too large. Returns 1 to go on after *functions, with the next basis or with a smaller
 * tolerance and the same basis. */
static int retry(enum hawser_status status, int *functions, struct hawser_frf_options *frf,
                 const struct hawser_accuracy_options *options)
{
	if (status != HAWSER_ERR_CONVERGENCE)
		return 0;
	if (options->frf.tolerance == 0.0 && frf->tolerance > FINEST && *functions >= MIDDLING) {
		frf->tolerance = FINEST;
		(*functions)--;
		return 1;
	}
	return *functions < (options->most_functions > 0 ? options->most_functions : bases[BASES - 1]);
}

/* The draft of one basis: its curve; or, as long as they are near it, the counterparts of marks of the
 * curve of a smaller basis. */
struct draft {
	struct hawser_rom rom;
	struct hawser__drawn_curve curve;
	int functions, points;
	double work;
};

/* The last curve that was traced, and the orbits at its marks. */
struct traced {
	struct hawser__drawn_curve curve;
	struct hawser__orbits orbits;
	enum hawser_frf_end end;
	int functions, *mark, marks;
};

/* What a trace is watched for. */
struct watch {
	const struct hawser_accuracy_options *options;
	struct hawser_accuracy *a;
	double before; /* work of the traces that have ended */
	double next;   /* work of another draft, over that of this one */
	int expected;  /* points of the trace; 0: not known */
	const struct hawser_rom *rom; /* of the trace */
	int n;         /* coordinates of the model whose response follows */
	int drafts;    /* 1: it is a draft, which may be given up */
	int afforded;  /* 1: it was ended where the rest of the range is more than can be borne */
};

static void forget(struct traced *traced)
{
	hawser__curve_clear(&traced->curve);
	hawser__orbits_clear(&traced->orbits);
	free(traced->mark);
	*traced = (struct traced){.functions = 0};
}

static void clear(struct draft *draft)
{
	hawser_rom_clear(&draft->rom);
	hawser__curve_clear(&draft->curve);
	*draft = (struct draft){.functions = 0};
}

/* Work of what follows the drafts, by one of them with the same kind of model. */
static double follows(const struct hawser_accuracy_options *options, int n, int points, double work,
                      const struct hawser_rom *rom)
{
	struct hawser_rom as = *rom;
	struct hawser_orbit_cost judging = {
		.judged = (long)(MORE_POINTS*fmax(points, options->expected))};

	as.n = n;
	return options->after > 0.0 ? options->after*work : work + hawser_orbit_work(&judging, &as);
}

/* Work of the search and the response, if the range ended where the draft is now. */
static double so_far(const struct watch *watch, int points, double work)
{
	return watch->before + work*(1.0 + watch->next) +
	       follows(watch->options, watch->n, points, work, watch->rom);
}

/* Ends a draft when the work that is foreseen is more than can be borne, or where the cable is slack
 * from early on; passes the rest on with the time left. */
static int watch_trace(void *data, const struct hawser_progress_state *state)
{
	struct watch *watch = data;
	struct hawser_progress_state shown = *state;
	const struct hawser_frf *frf = state->frf;
	int points = frf ? frf->points : 0, most = watch->expected;
	double work = points > 0 ? hawser_orbit_work(&frf->cost, watch->rom) : 0.0;

	if (most > 0 && points >= FIRST_POINTS) {
		double whole = work*fmax((double)most/points, 1.0);

		if (watch->drafts)
			watch->a->foreseen = so_far(watch, points, whole);
		shown.fraction = fmin((double)points/most, 1.0);
		shown.left = state->seconds*fmax((double)most/points - 1.0, 0.0);
	}
	watch->afforded = watch->options->partial && watch->drafts && points >= FIRST_POINTS &&
	                  so_far(watch, points, work) > watch->options->bearable*
	                  (watch->a->foreseen > watch->options->bearable ? A_PART : 1.0);
	if (watch->afforded)
		return 1;
	if (watch->options->bearable > 0.0 && watch->drafts && !watch->options->partial &&
	    fmax(watch->before + work, watch->a->foreseen/DOUBT) > watch->options->bearable) {
		watch->a->costly = 1;
		return 1;
	}
	if (watch->drafts && points >= SLACK_POINTS && hawser__mostly_slack(frf))
		return 1;
	return hawser__told_to_stop(&watch->options->frf.progress, &shown);
}

/* Whether the range ends with this draft: at its last point but some, as the response must reach it. */
static int ends_range(struct hawser_accuracy *a, const struct watch *watch, int functions,
                      enum hawser_status status, const struct hawser_report *why)
{
	int failed = status == HAWSER_ERR_CONVERGENCE && functions >= MIDDLING;

	if (!watch->options->partial || a->frf.points < FIRST_POINTS || !(failed || watch->afforded))
		return 0;
	a->until = a->frf.point[a->frf.points - 1 - (failed ? ASIDE : 0)].omega;
	snprintf(a->beyond, sizeof a->beyond, "%s", failed ? why->message : "");
	a->frf.end = HAWSER_END_RANGE;
	return 1;
}

/* Trace the draft of the model in *draft; a->frf and *traced become its curve. */
static enum hawser_status draw(struct draft *draft, struct traced *traced, struct hawser_accuracy *a,
                               const struct hawser_accuracy_options *options,
                               const struct hawser_frf_options *settled, double before,
                               int expected, struct hawser_report *report)
{
	struct watch watch = {options, a, before, CARRIED, expected, &draft->rom, draft->rom.n, 1, 0};
	struct hawser_frf_options frf = *settled;
	struct hawser_report why = {.message = ""};
	struct hawser__trace_watch keep;
	enum hawser_status status;

	*traced = (struct traced){.functions = 0};
	keep = hawser__orbits_watch(&traced->orbits);
	frf.unjudged = frf.skip_events = 1;
	frf.samples = HAWSER_NONE;
	frf.most_unstable = 0;
	frf.step_max = LONG;
	frf.progress = (struct hawser_progress){watch_trace, &watch};
	hawser_frf_clear(&a->frf);
	status = hawser__frf_trace(&a->frf, &draft->rom, &frf, &keep, &why);
	if (ends_range(a, &watch, draft->functions, status, &why))
		status = HAWSER_OK;
	else if (status && report)
		*report = why;
	draft->points = a->frf.points;
	draft->work = hawser_orbit_work(&a->frf.cost, &draft->rom);
	a->slack = !status && !a->costly && hawser__mostly_slack(&a->frf);
	if (!status)
		status = hawser__curve_copy(&traced->curve, &a->frf, report);
	if (status || !(traced->mark = malloc(((size_t)a->frf.points + 1)*sizeof(int))))
		return status ? status : hawser__no_memory(report, "accuracy");
	traced->functions = draft->functions;
	traced->end = a->frf.end;
	return hawser__curve_marks(traced->mark, &traced->marks, &traced->curve, report);
}

/* The counterparts of the marks in the model of *draft, if there are, and how far they are from the
 * curve. */
static enum hawser_status carry(struct draft *draft, double *away, const struct traced *traced,
                                const struct hawser_statics *statics,
                                const struct hawser_frf_options *settled,
                                struct hawser_report *report)
{
	struct hawser_frf_options frf = *settled;
	struct hawser_frf found = {.n = 0};
	int lost = 1, rows, columns;
	double *map = NULL;
	enum hawser_status status = HAWSER_OK;

	*away = INFINITY;
	frf.tolerance = fmax(frf.tolerance, ROUGH);
	if (traced->orbits.count != traced->curve.points)
		return HAWSER_OK;
	status = hawser__full_map(&map, &rows, &columns, statics, traced->functions, draft->functions,
	                          report);
	if (!status && rows == draft->rom.n && columns == traced->orbits.n)
		status = hawser__carry(&found, &lost, &draft->rom, &traced->orbits, traced->mark,
		                       traced->marks, map, &frf, report);
	free(map);
	draft->work = hawser_orbit_work(&found.cost, &draft->rom);
	if (!status && found.points > 0)
		status = hawser__curve_copy(&draft->curve, &found, report);
	if (!status && !lost)
		status = hawser__curve_points_distance(away, &traced->curve, traced->mark, NULL,
		                                       &draft->curve, report);
	hawser_frf_clear(&found);
	return status;
}

/* Ends the range where the first two bases stop to agree: at the last mark up to which they do, if there
 * are enough before it. The curve of *next then ends there, and is near. */
static enum hawser_status agree(struct draft *next, double *away, const struct traced *traced,
                                struct hawser_accuracy *a, struct hawser_frf_options *settled,
                                struct hawser_report *report)
{
	int found = next->curve.points;
	double off = INFINITY;
	enum hawser_status status = HAWSER_OK;

	while (!status && next->curve.points > 0 && SAFETY_BASIS*off > a->asked) {
		next->curve.points--;
		status = hawser__curve_points_distance(&off, &traced->curve, traced->mark, NULL,
		                                       &next->curve, report);
	}
	if (status || next->curve.points == 0 ||
	    traced->mark[next->curve.points - 1] < FIRST_POINTS) {
		next->curve.points = found;
		return status;
	}
	a->until = settled->to = a->frf.point[traced->mark[next->curve.points - 1]].omega;
	snprintf(a->beyond, sizeof a->beyond, "bases of %d and %d functions differ beyond: the motion has "
	         "short waves", traced->functions, next->functions);
	*away = off;
	return HAWSER_OK;
}

/* The same basis with a draft of its own, in place of the last one, with which it is compared. */
static enum hawser_status draw_again(struct draft *next, double *moved, struct traced *traced,
                                     const struct draft *chosen, struct hawser_accuracy *a,
                                     const struct hawser_accuracy_options *options,
                                     const struct hawser_frf_options *settled, double before,
                                     struct hawser_report *report)
{
	struct traced last = *traced;
	enum hawser_status status;

	*moved = INFINITY;
	hawser__curve_clear(&next->curve);
	status = draw(next, traced, a, options, settled, before,
	              last.functions ? (int)(MORE_POINTS*chosen->points) : options->expected, report);
	if (!status && !hawser__accuracy_cut(a) && last.functions && last.functions == chosen->functions &&
	    traced->end == last.end)
		status = hawser__curve_distance(moved, &last.curve, &traced->curve, report);
	forget(&last);
	return status;
}

/* The first bases of which two agree: *chosen is the smaller one, *moved the distance of the two,
 * and *checked the coordinates of the larger. If no two agree, the last ones. */
static enum hawser_status choose(struct draft *chosen, double *moved, int *checked,
                                 struct hawser_accuracy *a, const struct hawser_scene *scene,
                                 const struct hawser_accuracy_options *options,
                                 struct hawser_frf_options *frf, double *work,
                                 struct hawser_report *report)
{
	const struct hawser_accuracy_bases of = {&a->modes, scene, a->choice.to, a->asked,
	                                         options->most_functions};
	struct traced traced = {.functions = 0};
	enum hawser_status status = HAWSER_OK;
	int functions = 0;

	while (!status) {
		struct draft next = {.functions = 0};
		double away = INFINITY;
		int again = 0;

		status = hawser_accuracy_basis(&next.rom, &functions, &of, chosen->rom.n, report);
		if (status || next.rom.n == 0)
			break;
		a->functions = next.functions = functions;
		if (traced.functions)
			status = carry(&next, &away, &traced, &a->modes.statics, frf, report);
		*work += next.work;
		if (!status && isfinite(a->until) && next.curve.points > 0 && chosen->functions ==
		    traced.functions && !(SAFETY_BASIS*away <= a->asked))
			status = agree(&next, &away, &traced, a, frf, report);
		if (!status && away <= NEAR) {
			next.points = chosen->points;
			next.work = chosen->work*pow((double)next.rom.n/chosen->rom.n, 2.0);
			status = hawser__curve_points_distance(moved, &traced.curve, traced.mark,
			                                       chosen->curve.points ? &chosen->curve : NULL,
			                                       &next.curve, report);
		} else if (!status) {
			status = draw_again(&next, moved, &traced, chosen, a, options, frf, *work, report);
			*work += next.work;
			again = retry(status, &functions, frf, options);
			if (isfinite(a->until))
				frf->to = a->until;
		}
		if (again) {
			status = HAWSER_OK;
			clear(&next);
			continue;
		}
		*checked = next.rom.n;
		if (status || hawser__accuracy_cut(a) || SAFETY_BASIS**moved <= a->asked) {
			clear(&next);
			break;
		}
		clear(chosen);
		*chosen = next;
	}
	forget(&traced);
	return status;
}

/* The response of the chosen basis. */
static enum hawser_status follow(struct hawser_accuracy *a, struct hawser__marks *marks,
                                 const struct hawser_scene *scene,
                                 const struct hawser_accuracy_options *options,
                                 const struct hawser_frf_options *settled, int functions,
                                 double work, struct hawser_report *report)
{
	struct watch watch = {options, a, work, 0.0, options->expected, &a->rom, a->rom.n, 0, 0};
	struct hawser_frf_options frf = *settled;
	enum hawser_status status;

	frf.progress = (struct hawser_progress){watch_trace, &watch};
	status = hawser__accuracy_attempt(a, marks, scene, functions, &frf, report);
	if (status == HAWSER_ERR_CONVERGENCE && options->frf.tolerance == 0.0 && frf.tolerance > FINEST) {
		frf.tolerance = FINEST;
		status = hawser__accuracy_attempt(a, marks, scene, functions, &frf, report);
	}
	a->traced.progress = options->frf.progress;
	return status;
}

enum hawser_status hawser__accuracy_full(struct hawser_accuracy *a, struct hawser__marks *marks,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	struct hawser_frf_options frf = settle(options, a->asked);
	struct draft chosen = {.functions = 0};
	double moved = INFINITY, work = 0.0, start = hawser__wall_seconds();
	int checked = 0;
	enum hawser_status status = choose(&chosen, &moved, &checked, a, scene, options, &frf, &work,
	                                   report);
	int ended = status || hawser__accuracy_cut(a) || !chosen.functions;

	if (!ended) {
		a->foreseen = work + follows(options, chosen.rom.n, chosen.points, chosen.work,
		                             &chosen.rom);
		a->costly = options->bearable > 0.0 && !options->partial && a->foreseen > options->bearable;
	}
	if (ended || a->costly || (options->agreed && !(SAFETY_BASIS*moved <= a->asked))) {
		clear(&chosen);
		return status == HAWSER_ERR_CONVERGENCE ? lost(a, report) : status;
	}
	hawser_rom_clear(&a->rom);
	a->rom = chosen.rom;
	a->functions = chosen.functions;
	chosen.rom = (struct hawser_rom){.n = 0};
	if (options->after > 0.0) {
		a->estimated = fmax(SAFETY_BASIS*moved, 0.1*a->asked);
		a->checked = checked;
	} else {
		status = follow(a, marks, scene, options, &frf, chosen.functions, work, report);
		if (!status) {
			struct hawser_accuracy_try *this = &a->attempt[a->tries - 1];

			this->seconds = hawser__wall_seconds() - start;
			this->moved = moved;
			this->checked = checked;
			if (!hawser__accuracy_cut(a) && isfinite(moved))
				hawser__accuracy_claim(a, SAFETY_BASIS*moved, marks);
		}
	}
	clear(&chosen);
	return status == HAWSER_ERR_CONVERGENCE ? lost(a, report) : status;
}

enum hawser_status hawser_accuracy_exact(struct hawser_accuracy *accuracy,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report)
{
	double start = hawser__wall_seconds();
	struct hawser__marks marks = {0};
	enum hawser_status status = hawser__accuracy_begin(accuracy, statics, scene, options, report);

	if (!status && accuracy->choice.exact.n == 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "accuracy",
		                      "an inextensible cable has no full-order model");
	if (!status)
		status = hawser__accuracy_full(accuracy, &marks, scene, options, report);
	accuracy->reached = accuracy->estimated <= accuracy->asked && !hawser__accuracy_cut(accuracy);
	accuracy->seconds = hawser__wall_seconds() - start;
	hawser__marks_clear(&marks);
	return status;
}
