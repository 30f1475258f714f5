/* response/branch/account.c - see account.h.
 *
 * A step is halved by new orbits until each part holds at most one event, and this event explains
 * the change of the count in the part. A fold beside a branch point, and two events in one step,
 * are separated in this way. A part of the smallest length that is still not explained is a
 * remainder: there the count and a test function change at points that differ by the errors of the
 * multipliers (1e-6 at most, method.h), or two events coincide. Remainders that are nearer to each
 * other than these errors can shift them are judged together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/branch/account.h"
#include "response/branch/bracket.h"
#include "response/branch/locate.h"

#define ONE_PLACE 0.02 /* distance, in parts of the bracket, within which a fold and a branch point are
                        * taken for one; chosen */
#define MOST_MEETING 3 /* halvings after which they are no longer; chosen */
#define SMALLEST_PART 1e-7 /* arclength, which is a relative change of the orbit; chosen far above
                            * round-off */
/* Arclength. An error of 1e-6 of a multiplier that changes by 0.01 per unit of arclength, which is
 * slow, shifts the point at which it crosses the unit circle by this. */
#define TOGETHER 1e-4

int hawser__account_crossings(const struct hawser__station *a, const struct hawser__station *b,
                              int *width, int sure)
{
	int count = 0;

	*width = 0;
	for (int k = 0; k < HAWSER_TESTS; k++)
		if (hawser__station_crossed(a, b, k, sure)) {
			count++;
			*width += hawser__event_width(k);
		}
	return count;
}

/* Whether the number of multipliers outside the unit circle may change by `width`, up or down, from
 * a to b. */
static int can_change(const struct hawser__circle *a, const struct hawser__circle *b, int width)
{
	int least = b->unstable - a->unstable - a->at_one, most = b->unstable + b->at_one - a->unstable;

	return (least <= width && width <= most) || (least <= -width && -width <= most);
}

static int explained(const struct hawser__account *account, const struct hawser__station *a,
                     const struct hawser__station *b, int width)
{
	struct hawser__circle before = hawser__station_circle(a, account->sure);
	struct hawser__circle after = hawser__station_circle(b, account->sure);

	return account->uncounted || can_change(&before, &after, width);
}

enum hawser_status hawser__account_init(struct hawser__account *account,
                                        const struct hawser__orbit *orbit,
                                        struct hawser_report *report)
{
	account->uncounted = orbit->unjudged;
	return hawser__station_init(&account->scratch, orbit, report);
}

void hawser__account_clear(struct hawser__account *account)
{
	for (int i = 0; i < HAWSER__DEEPEST; i++)
		hawser__station_clear(&account->station[i]);
	hawser__station_clear(&account->scratch);
	hawser__crossing_clear(&account->crossing);
	free(account->event);
	free(account->state);
	free(account->remainder);
	memset(account, 0, sizeof *account);
}

/* y: its orbit; NULL: none. */
static enum hawser_status add_event(struct hawser__account *account, const struct hawser__orbit *orbit,
                                    const struct hawser_frf_event *event, const double *y,
                                    struct hawser_report *report)
{
	size_t m = (size_t)orbit->m;

	if (hawser__more(&account->event, account->events, sizeof *account->event) ||
	    hawser__more(&account->state, account->events, m*sizeof *account->state))
		return hawser__no_memory(report, "frf");
	account->event[account->events] = *event;
	account->event[account->events].parameter = y && orbit->own == HAWSER__CYCLES /* until recorded */
	                                            ? hawser__orbit_omega(orbit, y)/orbit->rom->time : 0.0;
	account->event[account->events].after = y ? account->events : -1;
	if (y)
		orbit->ops->state(orbit, account->state + (size_t)account->events*m, y);
	account->events++;
	return HAWSER_OK;
}

/* Keep a part as it is, with the events from index `first`; `last` is the index of Omega. */
static enum hawser_status add_remainder(struct hawser__account *account,
                                        const struct hawser__station *a,
                                        const struct hawser__station *b, int first, int last,
                                        struct hawser_report *report)
{
	if (hawser__more(&account->remainder, account->remainders, sizeof *account->remainder))
		return hawser__no_memory(report, "frf");
	account->remainder[account->remainders++] = (struct hawser__remainder){
		.arc = {a->arc, b->arc}, .omega = {a->y[last], b->y[last]},
		.circle = {hawser__station_circle(a, account->sure),
		           hawser__station_circle(b, account->sure)}, .first = first,
		.events = account->events - first};
	return HAWSER_OK;
}

/* Move an event that was located by a sure test to the place where the multiplier crosses the unit
 * circle, if there is one in the range. *y is its orbit. */
static enum hawser_status cross(struct hawser__account *account, struct hawser_frf_event *event,
                                const double **y, struct hawser__orbit *orbit,
                                const struct hawser__station *a, const struct hawser__station *b,
                                struct hawser_report *report)
{
	struct hawser_frf_event crossed = *event;
	int found;
	enum hawser_status status = hawser__crossing_find(&account->crossing, &crossed, &found, orbit, a,
	                                                  b, account->tolerance,
	                                                  account->event_tolerance, report);

	if (status || !found || crossed.arc < 0.0 || crossed.omega < account->lo ||
	    crossed.omega > account->hi)
		return status;
	*event = crossed;
	*y = account->crossing.scratch.y;
	return HAWSER_OK;
}

/* Whether Omega of a fold between a and b is an extreme of it, as on one curve. Where it is not,
 * the curve has a gap there: a bifurcation that a small load has broken, across which b was reached. */
static int turns_at(double omega, const struct hawser__account *account,
                    const struct hawser__orbit *orbit, const struct hawser__station *a,
                    const struct hawser__station *b)
{
	int last = orbit->size - 1;
	double way = a->t[last] > 0.0 ? 1.0 : -1.0, farthest = fmax(way*a->y[last], way*b->y[last]);

	return way*omega >= farthest - account->event_tolerance*hawser__orbit_extent(orbit, a->y);
}

/* Locate the event of one kind between a and b if its test function changes sign. */
static enum hawser_status add_located(struct hawser__account *account, struct hawser__orbit *orbit,
                                      const struct hawser__station *a,
                                      const struct hawser__station *b, enum hawser_event_kind kind,
                                      struct hawser_report *report)
{
	int found, last = orbit->size - 1;
	const double *y;
	struct hawser_frf_event event;
	enum hawser_status status = hawser__locate(&event, &found, orbit, &account->scratch, a, b,
	                                           kind, account->sure, account->tolerance,
	                                           account->event_tolerance, report);

	if (status == HAWSER_ERR_CONVERGENCE ||
	    (!status && found && kind == HAWSER_FOLD && !turns_at(event.omega, account, orbit, a, b))) {
		account->gaps++;
		return HAWSER_OK;
	}
	if (status || !found)
		return status;
	event.bracket[0] = a->y[last];
	event.bracket[1] = b->y[last];
	event.unstable[0] = hawser__station_circle(a, account->sure).unstable;
	event.unstable[1] = hawser__station_circle(b, account->sure).unstable;
	y = account->scratch.y;
	if (account->sure && hawser__bracket_needs_sure(a, b, kind) &&
	    (status = cross(account, &event, &y, orbit, a, b, report)))
		return status;
	if ((status = add_event(account, orbit, &event, y, report)))
		return status;
	if (account->watch)
		account->watch(account->context, &event, orbit, y);
	return HAWSER_OK;
}

/* Whether the signs are those of a pitchfork's own branch, with as many unstable multipliers on both
 * sides. */
static int may_meet(const struct hawser__account *account, const struct hawser__station *a,
                    const struct hawser__station *b)
{
	return hawser__station_crossed(a, b, HAWSER_FOLD, account->sure) &&
	       hawser__station_crossed(a, b, HAWSER_BRANCH_POINT, account->sure) &&
	       explained(account, a, b, 0);
}

/* The station at the fraction s of the part, or one of its ends; NULL if the corrector fails. */
static enum hawser_status beside(const struct hawser__station **station, struct hawser__station *own,
                                 struct hawser__orbit *orbit, const struct hawser__station *a,
                                 const struct hawser__station *b, double s, double tolerance,
                                 struct hawser_report *report)
{
	enum hawser_status status;

	*station = s <= 0.0 ? a : s >= 1.0 ? b : own;
	if (*station != own)
		return HAWSER_OK;
	if (!own->memory && (status = hawser__station_init(own, orbit, report)))
		return status;
	own->arc = a->arc + s*(b->arc - a->arc);
	if (hawser__station_inside(own, orbit, a, b, s, tolerance)) {
		*station = NULL;
		return HAWSER_OK;
	}
	return hawser__station_finish(own, orbit, a->t, report);
}

/* On a branch that begins at another one (a pitchfork), Omega turns where the two cross: a fold and a
 * branch point at one place, which no halving separates, and beside which the multipliers are
 * round-off. *done: they are, and this is added as a branch point, located as the fold. */
static enum hawser_status meet(struct hawser__account *account, int *done, struct hawser__orbit *orbit,
                               const struct hawser__station *a, const struct hawser__station *b,
                               int depth, struct hawser_report *report)
{
	int events = account->events, gaps = account->gaps;
	const struct hawser__station *left = NULL, *right = NULL;
	void (*watch)(void *, const struct hawser_frf_event *, const struct hawser__orbit *,
	              const double *) = account->watch;
	enum hawser_status status;

	*done = 0;
	account->watch = NULL;
	status = add_located(account, orbit, a, b, HAWSER_FOLD, report);
	account->watch = watch;
	if (!status && account->events > events) {
		double s = (account->event[events].arc - a->arc)/(b->arc - a->arc);

		status = beside(&left, &account->station[depth], orbit, a, b, s - ONE_PLACE,
		                account->tolerance, report);
		if (!status)
			status = beside(&right, &account->station[depth + 1], orbit, a, b, s + ONE_PLACE,
			                account->tolerance, report);
		*done = !status && left && right && may_meet(account, left, right) &&
		        explained(account, a, left, 0) && explained(account, right, b, 0);
		account->event[events].kind = HAWSER_BRANCH_POINT;
		account->event[events].turns = 1;
		if (*done && watch)
			watch(account->context, &account->event[events], orbit, account->scratch.y);
	}
	account->events = events + *done;
	account->gaps = gaps;
	return status;
}

/* Locate what can be located in a part that cannot be halved further. */
static enum hawser_status leave(struct hawser__account *account, struct hawser__orbit *orbit,
                                const struct hawser__station *a, const struct hawser__station *b,
                                struct hawser_report *report)
{
	int first = account->events;

	for (int k = 0; k < HAWSER_TESTS; k++) {
		enum hawser_status status = HAWSER_OK;

		if (hawser__station_crossed(a, b, k, account->sure))
			status = add_located(account, orbit, a, b, k, report);
		if (status)
			return status;
	}
	return add_remainder(account, a, b, first, orbit->size - 1, report);
}

/* A new station between a and b, at one of three positions; *failed is set if the corrector fails
 * at all of them. */
static enum hawser_status halve(struct hawser__station *middle, int *failed,
                                struct hawser__orbit *orbit, const struct hawser__station *a,
                                const struct hawser__station *b, double tolerance,
                                struct hawser_report *report)
{
	static const double place[] = {0.5, 0.43, 0.59};
	enum hawser_status status;

	*failed = 1;
	if (!middle->memory && (status = hawser__station_init(middle, orbit, report)))
		return status;
	for (int i = 0; *failed && i < 3; i++) {
		*failed = hawser__station_inside(middle, orbit, a, b, place[i], tolerance);
		middle->arc = a->arc + place[i]*(b->arc - a->arc);
	}
	return *failed ? HAWSER_OK : hawser__station_finish(middle, orbit, a->t, report);
}

static enum hawser_status resolve(struct hawser__account *account, struct hawser__orbit *orbit,
                                  const struct hawser__station *a, const struct hawser__station *b,
                                  int depth, struct hawser_report *report)
{
	int width, count = hawser__account_crossings(a, b, &width, account->sure);
	int events = account->events, failed, met;
	int gaps = account->gaps;
	enum hawser_status status;

	if (count == 0 && explained(account, a, b, 0))
		return HAWSER_OK;
	if (count == 1 && explained(account, a, b, width)) {
		for (int k = 0; k < HAWSER_TESTS; k++)
			if (hawser__station_crossed(a, b, k, account->sure) &&
			    (status = add_located(account, orbit, a, b, k, report)))
				return status;
		if (account->events > events)
			return HAWSER_OK;
		if (account->gaps > gaps)
			return add_remainder(account, a, b, account->events, orbit->size - 1, report);
	}
	if (count == 2 && depth < MOST_MEETING && may_meet(account, a, b)) {
		status = meet(account, &met, orbit, a, b, depth, report);
		if (status || met)
			return status;
	}
	if (depth == HAWSER__DEEPEST || b->arc - a->arc < SMALLEST_PART)
		return leave(account, orbit, a, b, report);
	status = halve(&account->station[depth], &failed, orbit, a, b, account->tolerance, report);
	if (status)
		return status;
	if (failed) {
		account->gaps++;
		return add_remainder(account, a, b, account->events, orbit->size - 1, report);
	}
	status = resolve(account, orbit, a, &account->station[depth], depth + 1, report);
	return status ? status : resolve(account, orbit, &account->station[depth], b, depth + 1,
	                                 report);
}

/* Whether events of these widths, each in either direction, can explain the change of the count
 * from a to b. */
static int attainable(const struct hawser_frf_event *event, int events, int change,
                      const struct hawser__circle *a, const struct hawser__circle *b)
{
	int width;

	if (events == 0)
		return b->unstable - a->unstable - a->at_one <= change &&
		       change <= b->unstable + b->at_one - a->unstable;
	width = hawser__event_width(event->kind);
	return attainable(event + 1, events - 1, change - width, a, b) ||
	       attainable(event + 1, events - 1, change + width, a, b);
}

/* Judge remainders [from, end) together. */
static enum hawser_status judge(struct hawser__account *account, const struct hawser__orbit *orbit,
                                int from, int end, struct hawser_report *report)
{
	const struct hawser__remainder *a = &account->remainder[from];
	const struct hawser__remainder *b = &account->remainder[end - 1];
	int first = a->first, events = b->first + b->events - first;
	const struct hawser__circle *before = &a->circle[0], *after = &b->circle[1];
	double middle = 0.5*(a->omega[0] + b->omega[1]);

	for (int i = first; i < first + events; i++) {
		account->event[i].unstable[0] = before->unstable;
		account->event[i].unstable[1] = after->unstable;
	}
	if (account->uncounted || attainable(account->event + first, events, 0, before, after))
		return HAWSER_OK;
	account->unresolved++;
	for (int i = first; i < first + events; i++)
		account->event[i].suspected = 1;
	if (can_change(before, after, 0))
		return HAWSER_OK;
	return add_event(account, orbit, &(struct hawser_frf_event){
		.kind = HAWSER_UNEXPLAINED, .omega = middle, .arc = 0.5*(a->arc[0] + b->arc[1]),
		.residual = 1.0, .error = 0.5*fabs(b->omega[1] - a->omega[0])/fmax(fabs(middle), orbit->floor),
		.bracket = {a->omega[0], b->omega[1]},
		.unstable = {before->unstable, after->unstable}}, NULL, report);
}

static int by_arc(const void *a, const void *b)
{
	double x = ((const struct hawser_frf_event *)a)->arc;
	double y = ((const struct hawser_frf_event *)b)->arc;

	return (x > y) - (x < y);
}

/* The events of a step by the sure test functions or by the others. */
static enum hawser_status find_events(struct hawser__account *account, struct hawser__orbit *orbit,
                                      const struct hawser__station *a,
                                      const struct hawser__station *b, int sure,
                                      struct hawser_report *report)
{
	enum hawser_status status;

	account->events = account->remainders = account->unresolved = account->gaps = 0;
	account->sure = sure;
	status = resolve(account, orbit, a, b, 0, report);
	for (int i = 0, end; !status && i < account->remainders; i = end) {
		for (end = i + 1; end < account->remainders; end++)
			if (account->remainder[end].arc[0] - account->remainder[end - 1].arc[1] >
			    TOGETHER)
				break;
		status = judge(account, orbit, i, end, report);
	}
	return status;
}

enum hawser_status hawser__account_step(struct hawser__account *account, struct hawser__orbit *orbit,
                                        const struct hawser__station *a,
                                        const struct hawser__station *b,
                                        struct hawser_report *report)
{
	int sure = hawser__station_unsure(a, b);
	enum hawser_status status = find_events(account, orbit, a, b, sure, report);

	/* Two pairs of a nearly undamped model that collide are undecided at the collision only. */
	if (!status && !sure && account->unresolved > 0 && account->gaps == 0)
		status = find_events(account, orbit, a, b, 1, report);
	if (!status && account->events > 1)
		qsort(account->event, (size_t)account->events, sizeof *account->event, by_arc);
	return status;
}
