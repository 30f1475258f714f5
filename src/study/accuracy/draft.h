/* study/accuracy/draft.h - the curves of full-order models by which a basis is chosen: see
 * accuracy_full.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_DRAFT_H
#define HAWSER_STUDY_DRAFT_H

#include "study/accuracy/accuracy.h"
#include "study/accuracy/carry.h"
#include "study/compare/curve.h"

#define HAWSER__SAFETY_BASIS 3.0 /* factor on the difference, calibrated by bench/accuracy.c */
#define HAWSER__MARGIN 1.3 /* on the distance of two bases at the marks, and on that of a response whose
                            * error is wanted, by bench/practical.py: there are points between, and
                            * peaks are read there */
#define HAWSER__A_PART 0.5 /* of what can be borne, for a part of the range; chosen */
#define HAWSER__MIDDLING 12      /* functions per component from which on a failure is not attributed to
                                  * the basis, but to the tolerance or the motion; chosen */
#define HAWSER__MORE_POINTS 1.2  /* of a response, over those of its draft or of the modes; chosen */

/* The draft of one basis: its curve; or, as long as they are near it, the counterparts of marks of the
 * curve of a smaller basis. The orbits are those of its curve, when the search has left it. */
struct hawser__draft {
	struct hawser_rom rom;
	struct hawser__drawn_curve curve;
	struct hawser__orbits orbits;
	int functions, points;
	double work;
	double until;      /* its part up to the present end of the range */
	int largest[2];    /* columns of the peaks of the traced curve, when the search has left it */
};

/* The last curve that was traced, and the orbits at its marks. */
struct hawser__traced {
	struct hawser__drawn_curve curve;
	struct hawser__orbits orbits;
	enum hawser_frf_end end;
	int functions, *mark, marks;
	double work; /* that it took */
};

/* What a trace is watched for. */
struct hawser__draft_watch {
	const struct hawser_accuracy_options *options;
	struct hawser_accuracy *a;
	double before; /* work of the traces that have ended */
	double next;   /* work of another draft, over that of this one; of counterparts: theirs, in all */
	double began;  /* s, hawser__wall_seconds: when the first of those traces began */
	int expected;  /* points of the trace, or marks; 0: not known */
	const struct hawser_rom *rom; /* of the trace */
	const struct hawser__draft *chosen; /* of a draft: the basis before it, whose response follows if
	                                     * the two agree; functions 0: none */
	int n;         /* coordinates of the model whose response follows; of marks: functions of theirs */
	int drafts;    /* 1: it is a draft, which may be given up */
	int afforded;  /* 1: it was ended where the rest of the range is more than can be borne, */
	int vain;      /* or, 1, where the curve comes no farther */
	double farthest, until; /* frequency that it has reached, work until there */
	int turned;    /* and points */
	double most;   /* work of all, after which the range ends; 0: not limited */
};

/* The orbits of the last curve become those of *chosen if it is that one's. */
void hawser__traced_give(struct hawser__traced *traced, struct hawser__draft *chosen);

void hawser__traced_clear(struct hawser__traced *traced);

void hawser__draft_clear(struct hawser__draft *draft);

/* Work of what follows the drafts, by one of them with the same kind of model. */
double hawser__draft_follows(const struct hawser_accuracy_options *options, int n, int points,
                             double work);

/* The scaled frequency that the first points of a curve have got to in a range. */
double hawser__draft_reach(const struct hawser_frf *frf, int points,
                           const struct hawser_frf_options *range);

/* For the progress of a trace; data: struct hawser__draft_watch. Ends a draft when the work that is
 * foreseen is more than can be borne, or with options->partial when that of the part so far is or
 * the curve wanders, or where the cable is slack from early on; tells the time left. */
int hawser__draft_watch_trace(void *data, const struct hawser_progress_state *state);

/* The range ends with the first `found` marks of a curve, a->until: 1: it does, if they are not few and
 * have a resonance that compares with those of the whole. */
int hawser__traced_part(struct hawser__traced *traced, struct hawser_accuracy *a, int found,
                        const struct hawser_frf_options *range);

/* What the time left of counterparts is told by: the search, the basis before, whose response follows
 * if the two agree, and the work until then. */
struct hawser__draft_told {
	const struct hawser_accuracy_options *options;
	const struct hawser__draft *chosen;
	double before;
};

/* The counterparts of the marks in the model of *draft, if there are, and how far they are from the
 * curve; INFINITY: too far. told: NULL, or what a time left is told by. enough: error that a basis may
 * have. most: 0, or work: where some have none, or it takes more than that, the range may end before
 * (a->until), and *traced with it. Told to stop, a->frf.end says so. */
enum hawser_status hawser__draft_carry(struct hawser__draft *draft, double *away,
                                       struct hawser__traced *traced, struct hawser_accuracy *a,
                                       const struct hawser__draft_told *told,
                                       const struct hawser_frf_options *settled, double enough,
                                       double most, struct hawser_report *report);

/* draft_marks.c: whether the range ends where marks have no counterparts in the next basis, of n
 * coordinates after `own`, or where that is too far away: two larger bases, one to be drawn and one
 * that it agrees with, and the response would take more than can be borne. */
int hawser__marks_partial(const struct hawser_accuracy_options *options,
                          const struct hawser__traced *traced, int own, int n, double work);
/* draft_marks.c: error [2] of a basis whose marks are moved by the next one: that, and with the factor
 * of safety by what the one after it moves them further where they are moved farthest, if there is
 * one. The second one is that of the displacements with the largest peaks. */
enum hawser_status hawser__marks_error(double *error, struct hawser_accuracy *a,
                                       const struct hawser__traced *traced,
                                       const struct hawser__drawn_curve *chosen,
                                       const struct hawser__draft *next, double moved, int functions,
                                       const struct hawser_accuracy_bases *of,
                                       const struct hawser_frf_options *settled,
                                       struct hawser_report *report);
/* draft_marks.c: the range ends with the marks that the next basis moves by at most `enough`, if they
 * are a part that can stand alone; *moved is then theirs. */
enum hawser_status hawser__marks_shorten(double *moved, struct hawser__traced *traced,
                                         struct hawser_accuracy *a, struct hawser__draft *next,
                                         const struct hawser__drawn_curve *chosen, double enough,
                                         const struct hawser_frf_options *frf,
                                         struct hawser_report *report);

/* The same basis with a draft of its own, in place of the last one, with which it is compared, and
 * the orbits of which become those of *chosen if they are. */
enum hawser_status hawser__draft_draw(struct hawser__draft *next, double *moved,
                                      struct hawser__traced *traced,
                                      struct hawser__draft *chosen, struct hawser_accuracy *a,
                                      const struct hawser_accuracy_options *options,
                                      const struct hawser_frf_options *settled, double before,
                                      struct hawser_report *report);

#endif
