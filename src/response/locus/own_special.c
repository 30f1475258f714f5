/* response/locus/own_special.c - special points of the loci of autonomous models.
 *
 *    s        position between two points of the locus, where a test passes 0: false position
 *
 * Those of Hopf points: the first Lyapunov coefficient is 0 (generalised Hopf, Bautin); a real
 * eigenvalue is 0 too (zero-Hopf); another pair is on the axis (double Hopf). Of folds of equilibria:
 * another eigenvalue is 0 (Bogdanov-Takens), or a pair is on the axis (zero-Hopf). Of cycles: the third
 * coefficient of the normal form is 0 (generalised period doubling, Chenciner's point); another
 * multiplier is 1 or -1, or another pair on the unit circle; the angle of a torus is 2 pi/3 or pi/2.
 *
 * A curve ends where the frequency of Hopf points is 0 (Bogdanov-Takens), the angle of a torus 0 or pi
 * (1:1, 1:2), and turns back where the second coefficient of a fold is 0 (cusp). Their squares are
 * extrapolated.
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., chapters 8 and 9.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "continuation/false_position.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/locus/locus_own.h"

#define ARRIVED 1e-12 /* of s */
#define ROUND_OFF 1e-9 /* of tests of cycles, relative, and of s; chosen */
#define POLE 1e-3     /* of a test, relative to its ends, that has a pole there and no zero; chosen */
#define CIRCLE 1e-5   /* largest distance of a pair from the unit circle; chosen */
#define SLOW 0.1      /* of its largest value, below which what vanishes may do so; chosen */
#define CERTAIN 1e-6  /* part of a step that is the least error stated; chosen */
#define BEYOND 1e-3   /* largest way to where it vanishes, in ranges; chosen */
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
		.parameter = spot->at[1]*own->line.extent[1], .angle = hawser__own_angle(spot),
		.own = spot->omega*own->time/spot->time,
		.arc = list->point[list->points - 1].arc + hawser__own_distance(spot->at, own->here.at),
		.error = error, .after = list->points - 1};
	return HAWSER_OK;
}

/* own->trial becomes the point between here and next at which the test passes 0. */
static enum hawser_status locate(struct hawser__own *own, int *found, int test, double *error,
                                 struct hawser_report *report)
{
	double length = hawser__own_distance(own->here.at, own->next.at), last = 0.0;
	struct hawser__bracketed in = {.a = 0.0, .b = 1.0, .fa = own->here.test[test],
		.fb = own->next.test[test]};
	double close = own->line.cycles ? ROUND_OFF : ARRIVED, most, f = NAN;

	most = fmax(fabs(in.fa), fabs(in.fb));
	*found = 0;
	for (int i = 0; i < LOCATE && in.b - in.a > close; i++) {
		double s = hawser__false_position(&in, i);
		enum hawser_status status = hawser__own_at(own, s, found, report);

		if (!status && !*found && fabs(f) <= POLE*most) { /* the equations are singular there */
			status = hawser__own_at(own, last, found, report);
			i = LOCATE;
		}
		if (status || !*found)
			return status;
		last = s;
		f = own->trial.test[test];
		*error = fmax(own->trial.error, length*(in.b - in.a));
		if (!(fabs(f) > close*most) || fabs(f) > most/POLE)
			break;
		hawser__false_position_take(&in, s, f);
	}
	*error = fmin(*error, fmax(own->trial.error, CERTAIN*length));
	*found = fabs(f) <= POLE*most &&
	         (test != HAWSER__OWN_PAIR || own->trial.beside_pair < CIRCLE);
	return HAWSER_OK;
}

static int changes(const struct hawser__own *own, int test)
{
	return own->here.test[test]*own->next.test[test] < 0.0;
}

/* Whether the tests tell where the count of unstable multipliers changes. */
int hawser__own_explained(const struct hawser__own *own)
{
	int more = abs(own->next.unstable - own->here.unstable);

	return more == 0 || changes(own, HAWSER__OWN_PAIR) || changes(own, HAWSER__OWN_ONE) ||
	       changes(own, HAWSER__OWN_MINUS);
}

static enum hawser_locus_special name_of(const struct hawser__own_line *line, int test)
{
	static const enum hawser_locus_special cycle[HAWSER__OWN_TESTS] = {HAWSER_LOCUS_DEGENERATE,
		HAWSER_LOCUS_WITH_FOLD, HAWSER_LOCUS_WITH_DOUBLING, HAWSER_LOCUS_WITH_TORUS,
		HAWSER_LOCUS_ONE_THREE, HAWSER_LOCUS_ONE_FOUR, HAWSER_LOCUS_START};
	static const enum hawser_locus_special rest[HAWSER__OWN_TESTS] = {HAWSER_LOCUS_DEGENERATE,
		HAWSER_LOCUS_TAKENS, HAWSER_LOCUS_TAKENS, HAWSER_LOCUS_WITH_HOPF,
		[HAWSER__OWN_START] = HAWSER_LOCUS_START};

	if (line->kind == HAWSER_HOPF && test == HAWSER__OWN_ONE)
		return HAWSER_LOCUS_WITH_FOLD;
	if (!line->cycles)
		return rest[test];
	if (line->kind == HAWSER_FOLD && test == HAWSER__OWN_ONE)
		return HAWSER_LOCUS_ONE_ONE;
	return line->kind == HAWSER_PERIOD_DOUBLING && test == HAWSER__OWN_MINUS ? HAWSER_LOCUS_ONE_TWO
	       : cycle[test];
}

enum hawser_status hawser__own_specials(struct hawser__own *own, struct hawser_report *report)
{
	struct hawser__locus_list *list = own->list;
	int first = list->events;
	enum hawser_status status = HAWSER_OK;

	for (int test = 0; test < HAWSER__OWN_TESTS && !status; test++) {
		double error = 0.0;
		int found;

		if (!changes(own, test) || (test == HAWSER__OWN_START && own->list->points == 1))
			continue;
		status = locate(own, &found, test, &error, report);
		if (!status && found)
			status = add_special(own, name_of(&own->line, test), &own->trial, error, report);
	}
	hawser__locus_sort(list, first);
	return status;
}

/* The square of what vanishes is extrapolated from the last two points. */
enum hawser_status hawser__own_end(struct hawser__own *own, int *found, struct hawser_report *report)
{
	double now = pow(own->here.vanish, 2), before = pow(own->prev.vanish, 2);
	double share = now/(before - now);
	enum hawser_locus_special kind = own->line.kind == HAWSER_HOPF ? HAWSER_LOCUS_TAKENS
	                                 : own->line.kind == HAWSER_FOLD ? HAWSER_LOCUS_CUSP
	                                 : cos(own->here.angle) > 0.0 ? HAWSER_LOCUS_ONE_ONE
	                                 : HAWSER_LOCUS_ONE_TWO;

	*found = fabs(own->here.vanish) < SLOW*own->most && now < before &&
	         share*hawser__own_distance(own->here.at, own->prev.at) < BEYOND;
	if (!*found)
		return HAWSER_OK;
	hawser__own_copy(&own->trial, &own->here, own->line.n);
	for (int k = 0; k < 2; k++)
		own->trial.at[k] += share*(own->here.at[k] - own->prev.at[k]);
	if (own->line.kind == HAWSER_HOPF)
		own->trial.omega = 0.0;
	if (own->line.kind == HAWSER_TORUS)
		own->trial.angle = cos(own->here.angle) > 0.0 ? 0.0 : M_PI;
	if (own->line.kind != HAWSER_FOLD) { /* a fold goes on */
		*own->list->message = '\0';
		own->list->end = own->line.kind == HAWSER_HOPF ? HAWSER_LOCUS_NO_FREQUENCY
		                                               : HAWSER_LOCUS_RESONANCE;
	}
	return add_special(own, kind, &own->trial,
	                   share*share*hawser__own_distance(own->here.at, own->prev.at), report);
}
