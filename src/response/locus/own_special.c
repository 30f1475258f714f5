/* response/locus/own_special.c - special points of the loci of autonomous models.
 *
 *    s        position between two points of the locus, where a test passes 0: false position
 *
 * Those of Hopf points: the first Lyapunov coefficient is 0 (generalised Hopf, Bautin); a real
 * eigenvalue is 0 too (zero-Hopf); another pair is on the axis (double Hopf); the frequency is 0
 * (Bogdanov-Takens), where the curve ends: its square is extrapolated. Of folds of equilibria: another
 * eigenvalue is 0 (Bogdanov-Takens), or a pair is on the axis (zero-Hopf).
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., chapter 8.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "continuation/false_position.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/locus/locus_own.h"

#define ARRIVED 1e-12 /* of s */
#define SLOW 0.1      /* of the frequency at the start, below which it may vanish; chosen */
#define CERTAIN 1e-6  /* part of a step that is the least error stated; chosen */
enum { LOCATE = 60 }; /* tries; chosen */

static enum hawser_status add_special(struct hawser__own *own, enum hawser_locus_special kind,
                                      const struct hawser__own_spot *spot, double error,
                                      struct hawser_report *report)
{
	struct hawser__locus_list *list = own->list;

	if (hawser__more(&list->event, list->events, sizeof *list->event))
		return hawser__no_memory(report, "locus");
	list->event[list->events++] = (struct hawser_locus_event){
		.kind = kind, .omega = spot->at[0]*own->line.extent[0],
		.parameter = spot->at[1]*own->line.extent[1], .angle = spot->angle,
		.own = spot->omega*own->time/spot->time,
		.error = error, .after = list->points - 1};
	return HAWSER_OK;
}

/* own->trial becomes the point between here and next at which the test passes 0. */
static enum hawser_status locate(struct hawser__own *own, int *found, int test, double *error,
                                 struct hawser_report *report)
{
	const double *a = own->here.at, *b = own->next.at;
	double direction[2] = {b[0] - a[0], b[1] - a[1]}, length = hawser__own_distance(a, b);
	struct hawser__bracketed in = {.a = 0.0, .b = 1.0, .fa = own->here.test[test],
		.fb = own->next.test[test]};

	*found = 0;
	for (int i = 0; i < LOCATE && in.b - in.a > ARRIVED; i++) {
		double s = hawser__false_position(&in, i), f;
		double base[2] = {a[0] + s*direction[0], a[1] + s*direction[1]};
		enum hawser_status status = hawser__own_across(own, &own->trial, found, base, direction, length,
		                                 s < 0.5 ? &own->here : &own->next, report);

		if (status || !*found)
			return status;
		f = own->trial.test[test];
		*error = fmax(own->trial.error, length*(in.b - in.a));
		if (!(fabs(f) > ARRIVED*fmax(fabs(own->here.test[test]), fabs(own->next.test[test]))))
			break;
		hawser__false_position_take(&in, s, f);
	}
	*error = fmin(*error, fmax(own->trial.error, CERTAIN*length));
	return HAWSER_OK;
}

static int changes(const struct hawser__own *own, int test)
{
	return own->here.test[test]*own->next.test[test] < 0.0;
}

/* Whether the tests tell where the count of unstable eigenvalues changes: a pair that becomes real
 * within a step has none at one end. */
int hawser__own_explained(const struct hawser__own *own)
{
	int more = abs(own->next.unstable - own->here.unstable);

	return own->line.cycles || more == 0 || changes(own, more%2 ? HAWSER__OWN_REAL : HAWSER__OWN_PAIR);
}

/* A real eigenvalue and a pair may both be next to the axis and become each other: the count of
 * unstable eigenvalues tells which test passes 0. */
enum hawser_status hawser__own_specials(struct hawser__own *own, struct hawser_report *report)
{
	int more = abs(own->next.unstable - own->here.unstable), hopf = own->line.kind == HAWSER_HOPF;
	static const enum hawser_locus_special name[2][HAWSER__OWN_TESTS] = {
		{HAWSER_LOCUS_DEGENERATE, HAWSER_LOCUS_TAKENS, HAWSER_LOCUS_WITH_HOPF},
		{HAWSER_LOCUS_DEGENERATE, HAWSER_LOCUS_WITH_FOLD, HAWSER_LOCUS_WITH_HOPF}};
	enum hawser_status status = HAWSER_OK;

	for (int test = 0; test < HAWSER__OWN_TESTS && !status; test++) {
		double error = 0.0;
		int found;

		if (!changes(own, test) || (test == HAWSER__OWN_REAL && more%2 == 0) ||
		    (test == HAWSER__OWN_PAIR && more < 2))
			continue;
		status = locate(own, &found, test, &error, report);
		if (!status && found)
			status = add_special(own, name[hopf][test], &own->trial, error, report);
	}
	return status;
}

/* Where the frequency of Hopf points falls to 0: its square is extrapolated from the last two. */
enum hawser_status hawser__own_takens(struct hawser__own *own, struct hawser_report *report)
{
	double now = pow(own->here.omega, 2), before = pow(own->prev.omega, 2);
	double share = now/(before - now);

	if (own->line.kind != HAWSER_HOPF || !(own->here.omega < SLOW*own->first_omega && now < before))
		return HAWSER_OK;
	hawser__own_copy(&own->trial, &own->here, own->line.n);
	for (int k = 0; k < 2; k++)
		own->trial.at[k] += share*(own->here.at[k] - own->prev.at[k]);
	own->trial.omega = 0.0;
	*own->list->message = '\0';
	own->list->end = HAWSER_LOCUS_NO_FREQUENCY;
	return add_special(own, HAWSER_LOCUS_TAKENS, &own->trial,
	                   share*share*hawser__own_distance(own->here.at, own->prev.at), report);
}

