/* response/locus/locus_events.c - special points of a locus: zeros of test functions along it.
 *
 *   cusp        w f''(v, v); of resonances, the parameter's part of the tangent
 *   degenerate  the cubic coefficient of the normal form
 *   double      the derivative of the critical eigenvalue, zero where its multiplier is double (1:1,
 *               1:2)
 *   fold        determinant of F_y; of resonances this is a branch point if the orientation changes too
 *   doubling    determinant of Hill's matrix of motions of twice the period
 *   unity, half, third, quarter  the angle of a torus less 0, pi, 2 pi/3, pi/2
 *   pairs       number of further complex pairs of multipliers outside the unit circle
 *
 * At the ends of the locus of a torus (1:1 and 1:2) the equations become singular, and the locus is an
 * even function of the angle's distance from 0 or pi. The end is extrapolated in the square of that
 * distance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "continuation/false_position.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/locus/locus_walk.h"

#define OUTSIDE 1e-7      /* logarithm of the modulus of a multiplier that counts as unstable */
#define CROSSING 1e-5     /* the same of one that is on the unit circle where a count changes */
#define SINGLE 1e-2       /* width of a bracket in which one pair crosses, relative to the step */
#define POLE 1e-3         /* a test function that is larger, relative to the ends of its bracket, where
                           * its sign changes has a pole there and no zero */
#define CLOSE 1e-11       /* width of a bracket, relative to the step */
#define FAR 0.03          /* largest distance of kappa from its end in the extrapolation */
#define NEARBY 0.002      /* distance at which the equations are too nearly singular to begin there */
#define DOUBLE 1e-4       /* distance below which round-off decides the sign of the normal form: it
                           * grows with the third power of 1/distance; chosen */
enum { MOST = 60, NODES = 4 };

static const enum hawser_locus_special special[LOCUS_TESTS] = {
	[LOCUS_TEST_CUSP] = HAWSER_LOCUS_CUSP, [LOCUS_TEST_DEGENERATE] = HAWSER_LOCUS_DEGENERATE,
	[LOCUS_TEST_DOUBLE] = HAWSER_LOCUS_ONE_ONE, [LOCUS_TEST_FOLD] = HAWSER_LOCUS_WITH_FOLD,
	[LOCUS_TEST_DOUBLING] = HAWSER_LOCUS_WITH_DOUBLING, [LOCUS_TEST_THIRD] = HAWSER_LOCUS_ONE_THREE,
	[LOCUS_TEST_QUARTER] = HAWSER_LOCUS_ONE_FOUR, [LOCUS_TEST_PAIRS] = HAWSER_LOCUS_WITH_TORUS,
	[LOCUS_TEST_UNITY] = HAWSER_LOCUS_ONE_ONE, [LOCUS_TEST_HALF] = HAWSER_LOCUS_ONE_TWO,
	[LOCUS_TEST_START] = HAWSER_LOCUS_START
};

/* --- tests --- */

/* A determinant relative to the one at the start, whose logarithm is in *reference (0: unknown). */
static double relative(double sign, double size, double *reference)
{
	if (*reference == 0.0)
		*reference = size;
	return sign*exp(fmax(-600.0, fmin(600.0, size - *reference)));
}

/* Index of the multiplier next to the critical one. */
static int critical(const struct hawser__locus *locus)
{
	double angle = 2.0*M_PI*locus->kappa, best = INFINITY;
	int which = 0;

	for (int i = 0; i < 2*locus->n; i++) {
		double d = hypot(locus->log_modulus[i], remainder(locus->argument[i] - angle, 2.0*M_PI));

		if (d < best) {
			best = d;
			which = i;
		}
	}
	return which;
}

static int is_complex(double argument)
{
	return argument != 0.0 && fabs(argument) < M_PI;
}

/* Count what is outside; *nearest: the logarithm of the modulus of the further pair that is next to the
 * unit circle. */
static enum hawser_status count(struct hawser__locus *locus, int *unstable, int *pairs,
                                double *nearest)
{
	enum hawser_status status = hawser__locus_multipliers(locus);
	int own = locus->kind == HAWSER_RESONANCE ? -1 : critical(locus);
	int torus = locus->kind == HAWSER_TORUS;

	*unstable = *pairs = 0;
	*nearest = INFINITY;
	for (int i = 0; !status && i < 2*locus->n; i++) {
		int mine = i == own || (torus && locus->log_modulus[i] == locus->log_modulus[own] &&
		                        locus->argument[i] == -locus->argument[own]);
		int two = is_complex(locus->argument[i]), out = locus->log_modulus[i] > OUTSIDE;

		if (mine)
			continue;
		*unstable += out;
		*pairs += out && two && locus->argument[i] > 0.0;
		if (two && fabs(locus->log_modulus[i]) < fabs(*nearest))
			*nearest = locus->log_modulus[i];
	}
	return status;
}

void hawser__locus_test_angle(const struct hawser__locus *locus,
                              struct hawser__locus_station *station)
{
	double kappa = station->z[LOCUS_KAPPA];

	if (locus->kind != HAWSER_TORUS)
		return;
	station->test[LOCUS_TEST_UNITY] = kappa;
	station->test[LOCUS_TEST_HALF] = kappa - 0.5;
	station->test[LOCUS_TEST_THIRD] = kappa - 1.0/3.0;
	station->test[LOCUS_TEST_QUARTER] = kappa - 0.25;
}

/* So near 1:1 or 1:2 the multiplier is nearly double: the coefficient is divided by a rate that
 * vanishes there, and its sign is that of round-off. */
static int beside_end(double kappa)
{
	return fmin(fabs(kappa), fabs(fabs(kappa) - 0.5)) < DOUBLE;
}

enum hawser_status hawser__locus_test(struct hawser__locus_walk *walk,
                                      struct hawser__locus_station *station)
{
	struct hawser__locus *locus = walk->locus;
	double *test = station->test, nearest, sign, size;
	enum hawser_event_kind kind = locus->kind;
	int resonance = kind == HAWSER_RESONANCE;
	double complex rate = locus->g_kappa/(-I*locus->omega);
	enum hawser_status status;

	for (int k = 0; k < LOCUS_TESTS; k++)
		test[k] = NAN;
	test[LOCUS_TEST_START] = station->z[LOCUS_PARAMETER] - walk->options->at;
	if (walk->options->skip_events)
		return HAWSER_OK;
	status = count(locus, &station->point.unstable, &station->pairs, &nearest);
	if (status)
		return status;
	test[LOCUS_TEST_PAIRS] = nearest;
	if (kind == HAWSER_FOLD)
		test[LOCUS_TEST_CUSP] = locus->second;
	if (resonance)
		test[LOCUS_TEST_CUSP] = station->t[LOCUS_PARAMETER];
	if (kind != HAWSER_TORUS && !resonance)
		test[LOCUS_TEST_DOUBLE] = creal(rate);
	hawser__locus_test_angle(locus, station);
	if (kind != HAWSER_FOLD) {
		test[LOCUS_TEST_DEGENERATE] = hawser__locus_normal_form(locus, &sign, &size);
		if (kind == HAWSER_TORUS && beside_end(station->z[LOCUS_KAPPA]))
			test[LOCUS_TEST_DEGENERATE] = NAN;
		if (sign != 0.0)
			test[LOCUS_TEST_FOLD] = relative(sign, size, &walk->reference[0]);
	}
	if (kind != HAWSER_PERIOD_DOUBLING) {
		size = hawser__locus_determinant(locus, 0.5, &sign);
		test[LOCUS_TEST_DOUBLING] = relative(sign, size, &walk->reference[1]);
	}
	return HAWSER_OK;
}

/* --- location --- */

static enum hawser_status locus_add_event(struct hawser__locus_list *list,
                                          const struct hawser_locus_event *event,
                                          struct hawser_report *report)
{
	if (hawser__more(&list->event, list->events, sizeof *list->event))
		return hawser__no_memory(report, "locus");
	list->event[list->events++] = *event;
	return HAWSER_OK;
}

/* scratch = the point at the share s of the step, with its tests. */
static enum hawser_status at(struct hawser__locus_walk *walk, double s, int *failed)
{
	struct hawser__locus_station *to = &walk->scratch;
	struct hawser__node a = {walk->here.z, walk->here.t}, b = {walk->next.z, walk->next.t};
	struct hawser__metric metric;
	enum hawser_status status;

	memset(to->z, 0, 2*(size_t)walk->room*sizeof(double));
	hawser__locus_weights(walk->weight, walk->locus, walk->here.z);
	metric = (struct hawser__metric){walk->locus->size, walk->weight};
	hawser__curve_between(to->z, to->t, &a, &b, s, &metric);
	memset(walk->spare, 0, (size_t)walk->room*sizeof(double));
	for (int k = 0; k < walk->locus->size; k++)
		walk->spare[k] = walk->weight[k]*to->t[k];
	to->arc = walk->here.arc + s*(walk->next.arc - walk->here.arc);
	status = hawser__locus_correct(walk, to, walk->spare, failed);
	walk->locus->closeness = INFINITY; /* the tangent by the derivatives here, not those before */
	return status || *failed ? status : hawser__locus_finish(walk, to, walk->here.t);
}

static double apart(const struct hawser__locus *locus, const double *a, const double *b)
{
	return fmax(fabs(a[0] - b[0])/locus->extent[0], fabs(a[1] - b[1])/locus->extent[1]);
}

/* Between these ends one pair crosses the unit circle: the logarithm of its modulus changes its sign,
 * and is looked at from here on instead of the number of pairs. */
static int is_one_pair(const struct hawser__bracketed *in, const double ends[2])
{
	return in->b - in->a < SINGLE && (ends[0] < 0.0) != (ends[1] < 0.0);
}

/* Locate the zero of a test; *found 0: there is none. */
static enum hawser_status locate(struct hawser__locus_walk *walk, int test, int *found,
                                 struct hawser_locus_event *event)
{
	struct hawser__bracketed in = {.a = 0.0, .b = 1.0};
	double value = INFINITY, last[2] = {walk->here.z[0], walk->here.z[1]}, gap = INFINITY, most;
	double ends[2] = {walk->here.test[test], walk->next.test[test]};
	int pairs = walk->here.pairs, counted = test == LOCUS_TEST_PAIRS;

	in.fa = counted ? -1.0 : ends[0];
	in.fb = counted ? 1.0 : ends[1];
	most = fmax(fabs(in.fa), fabs(in.fb));
	*found = 0;
	for (int i = 0; i < MOST && in.b - in.a > CLOSE; i++) {
		double s = counted ? 0.5*(in.a + in.b) : hawser__false_position(&in, i);
		int failed;
		enum hawser_status status = at(walk, s, &failed);

		if (status || failed)
			return status;
		value = walk->scratch.test[test];
		if (!isfinite(value))
			return HAWSER_OK;
		gap = apart(walk->locus, walk->scratch.z, last);
		memcpy(last, walk->scratch.z, sizeof last);
		if (counted) {
			int beyond = walk->scratch.pairs != pairs;

			ends[beyond] = value;
			hawser__false_position_take(&in, s, beyond ? 1.0 : -1.0);
			if ((counted = !is_one_pair(&in, ends)))
				continue;
			in = (struct hawser__bracketed){.a = in.a, .b = in.b, .fa = ends[0], .fb = ends[1]};
			most = fmax(fabs(in.fa), fabs(in.fb));
			continue;
		}
		if (fabs(value) <= 1e-12*most)
			break;
		hawser__false_position_take(&in, s, value);
	}
	*found = test == LOCUS_TEST_PAIRS ? fabs(value) < CROSSING : fabs(value) <= POLE*most;
	*event = (struct hawser_locus_event){
		.kind = special[test], .omega = walk->scratch.z[LOCUS_OMEGA],
		.parameter = walk->scratch.z[LOCUS_PARAMETER],
		.angle = 2.0*M_PI*walk->scratch.z[LOCUS_KAPPA], .arc = walk->scratch.arc,
		.error = fmin(gap, (in.b - in.a)*apart(walk->locus, walk->here.z, walk->next.z)) +
		         walk->options->tolerance,
		.after = walk->list->points - 1};
	if (test == LOCUS_TEST_DOUBLE && walk->locus->kind == HAWSER_PERIOD_DOUBLING)
		event->kind = HAWSER_LOCUS_ONE_TWO;
	if (test == LOCUS_TEST_FOLD && walk->locus->kind == HAWSER_RESONANCE &&
	    walk->next.orientation != walk->here.orientation)
		event->kind = HAWSER_LOCUS_DEGENERATE;
	return HAWSER_OK;
}

static int changes(const struct hawser__locus_walk *walk, int test)
{
	double a = walk->here.test[test], b = walk->next.test[test];

	if (test == LOCUS_TEST_PAIRS)
		return walk->here.pairs != walk->next.pairs;
	if (test == LOCUS_TEST_START && walk->list->points == 1)
		return 0;
	return isfinite(a) && isfinite(b) && (a < 0.0) != (b < 0.0);
}

void hawser__locus_sort(struct hawser__locus_list *list, int first)
{
	for (int i = first + 1; i < list->events; i++)
		for (int k = i; k > first && list->event[k].arc < list->event[k - 1].arc; k--) {
			struct hawser_locus_event keep = list->event[k];

			list->event[k] = list->event[k - 1];
			list->event[k - 1] = keep;
		}
}

enum hawser_status hawser__locus_find_events(struct hawser__locus_walk *walk)
{
	struct hawser__locus_list *list = walk->list;
	int first = list->events;

	for (int k = 0; k < LOCUS_TESTS; k++) {
		struct hawser_locus_event event;
		int found;
		enum hawser_status status;

		if (!changes(walk, k))
			continue;
		status = locate(walk, k, &found, &event);
		if (!status && found)
			status = locus_add_event(list, &event, walk->report);
		if (status)
			return status;
	}
	hawser__locus_sort(list, first);
	return HAWSER_OK;
}

/* The value at x = 0 of the polynomial through `count` nodes. */
static double extrapolate(const double *x, const double *y, int count)
{
	double p[NODES];

	memcpy(p, y, (size_t)count*sizeof *p);
	for (int k = 1; k < count; k++)
		for (int i = 0; i < count - k; i++)
			p[i] = (x[i + k]*p[i] - x[i]*p[i + 1])/(x[i + k] - x[i]);
	return p[0];
}

enum hawser_status hawser__locus_resonance(struct hawser__locus_walk *walk, double kappa)
{
	struct hawser__locus_station *to = &walk->scratch;
	int early = fabs(walk->here.z[LOCUS_KAPPA] - kappa) < NEARBY && walk->known > 1;
	const struct hawser__locus_station *from = early ? &walk->prev : &walk->here;
	double far = fmin(FAR, fabs(from->z[LOCUS_KAPPA] - kappa));
	double x[NODES], y[2][NODES], z[2], less[2];
	int side = kappa > 0.0 ? -1 : 1, failed;
	struct hawser_locus_event event;

	hawser__locus_station_copy(walk, to, from);
	memset(walk->spare, 0, (size_t)walk->room*sizeof(double));
	walk->spare[LOCUS_KAPPA] = 1.0;
	for (int i = 0; i < NODES; i++) {
		double distance = far*(NODES - i)/NODES;
		enum hawser_status status;

		to->z[LOCUS_KAPPA] = kappa + side*distance;
		status = hawser__locus_correct(walk, to, walk->spare, &failed);
		if (status || failed)
			return status;
		x[i] = distance*distance;
		y[0][i] = to->z[0];
		y[1][i] = to->z[1];
	}
	for (int k = 0; k < 2; k++) {
		z[k] = extrapolate(x, y[k], NODES);
		less[k] = extrapolate(x + 1, y[k] + 1, NODES - 1);
	}
	event = (struct hawser_locus_event){
		.kind = kappa > 0.0 ? HAWSER_LOCUS_ONE_TWO : HAWSER_LOCUS_ONE_ONE, .omega = z[0],
		.parameter = z[1], .angle = 2.0*M_PI*kappa, .arc = walk->next.arc,
		.error = apart(walk->locus, z, less) + walk->options->tolerance,
		.after = walk->list->points - 1};
	return locus_add_event(walk->list, &event, walk->report);
}
