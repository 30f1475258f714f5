/* beam/change.c - the speed at which the number of growing pairs, or of real pairs, changes.
 *
 * The number alone defines the change. Bisection on the number would need 43 eigenvalue problems
 * for 13 digits. For faster convergence each pair has an indicator g, a smooth function of the
 * speed that is positive if and only if the pair is counted:
 *
 *   AXIS    a complex pair begins to grow    g = re minus the round-off threshold
 *   ZERO    a real eigenvalue crosses zero   g = -l1 l2, which is smooth where re has a square root
 *                                            because the pair has just become real
 *   DOUBLE  a complex pair becomes real      g = (l1 - l2)^2/4, the discriminant
 *
 * Let k - 1 be the smaller of the two numbers. The k-th largest g of all pairs is continuous and
 * changes sign with the number. Its zero is found by Chandrupatla's method (Advances in
 * Engineering Software 28 (1997) 145): inverse quadratic interpolation if the last three points
 * permit it, otherwise bisection. Only the number decides on which side of the change a point
 * lies; g selects the next point. All steps are bisections in two cases: g is constant on one
 * side (the real part of an undamped beam below flutter), or g jumps (growing pairs become real
 * and are paired differently).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "beam/sample.h"

#define BRACKET 1e-13     /* final width, relative to the larger speed */
#define LEAST_SPEED 1e-3  /* lower limit of the speed that BRACKET is multiplied by */
#define STEP 0.9          /* smallest step relative to the final width: two of them enclose the zero */
enum { SLOW = 4 };        /* successive steps that do not halve the bracket, before a bisection */

enum indicator { AXIS, ZERO, DOUBLE };

/* One end of the bracket. */
struct side {
	double speed, g, im;
	int number;
};

struct search {
	const struct hawser__beam_solver *solver;
	enum hawser__beam_counted counted;
	enum indicator indicator;
	int rank;
};

static int number(const struct hawser__beam_sample *sample, enum hawser__beam_counted counted)
{
	return counted == HAWSER__BEAM_REAL ? sample->real : sample->growing;
}

static double indicate(const struct hawser__beam_pair *pair, enum indicator indicator)
{
	double half = 0.5*(pair->re[0] - pair->re[1]);

	if (indicator == AXIS)
		return pair->growth;
	if (indicator == ZERO)
		return pair->im > 0.0 ? -(pair->re[0]*pair->re[0] + pair->im*pair->im)
		                      : -pair->re[0]*pair->re[1];
	return pair->im > 0.0 ? -pair->im*pair->im : half*half;
}

static int watched(const struct hawser__beam_solver *solver, const struct hawser__beam_sample *sample)
{
	return sample->pairs < solver->watched ? sample->pairs : solver->watched;
}

/* The rank-th largest indicator; NAN if there are fewer pairs. */
static double ranked(const struct search *search, const struct hawser__beam_sample *sample)
{
	int pairs = watched(search->solver, sample);

	for (int p = 0; p < pairs; p++) {
		double g = indicate(&sample->pair[p], search->indicator);
		int above = 0, equal = 0;

		for (int q = 0; q < pairs; q++) {
			double other = indicate(&sample->pair[q], search->indicator);

			above += other > g;
			equal += other == g;
		}
		if (above < search->rank && search->rank <= above + equal)
			return g;
	}
	return NAN;
}

/* Imaginary part of the growing pair with the smallest real part, which is the pair that has just
 * become unstable. */
static double least_growing(const struct hawser__beam_sample *sample)
{
	double least = INFINITY, im = 0.0;

	for (int p = 0; p < sample->pairs; p++)
		if (sample->pair[p].growing && sample->pair[p].re[0] < least) {
			least = sample->pair[p].re[0];
			im = sample->pair[p].im;
		}
	return im;
}

static struct side side_of(const struct search *search, const struct hawser__beam_sample *sample)
{
	return (struct side){sample->speed, ranked(search, sample), least_growing(sample),
	                     number(sample, search->counted)};
}

static int positive(const struct search *search, const struct hawser__beam_sample *sample,
                    enum indicator indicator)
{
	int pairs = watched(search->solver, sample), count = 0;

	for (int p = 0; p < pairs; p++)
		count += indicate(&sample->pair[p], indicator) > 0.0;
	return count;
}

/* Select the indicator and the rank from the samples with the smaller and with the larger number. */
static void choose(struct search *search, const struct hawser__beam_sample *fewer,
                   const struct hawser__beam_sample *more)
{
	if (search->counted == HAWSER__BEAM_REAL)
		search->indicator = DOUBLE;
	else
		search->indicator = positive(search, more, ZERO) > positive(search, fewer, ZERO) ? ZERO : AXIS;
	search->rank = positive(search, fewer, search->indicator) + 1;
}

static enum hawser_status look(struct side *side, const struct search *search, double speed,
                               struct hawser_report *report)
{
	struct hawser__beam_sample sample;
	enum hawser_status status = search->solver->solve(&sample, search->solver->context, speed, report);

	if (!status) {
		*side = side_of(search, &sample);
		hawser__beam_sample_clear(&sample);
	}
	return status;
}

/* The next point, as a fraction of the way from a, the newest end, to b; c is the end replaced
 * last. */
static double next(const struct side *a, const struct side *b, const struct side *c)
{
	double chi = (a->speed - b->speed)/(c->speed - b->speed), phi = (a->g - b->g)/(c->g - b->g);

	if (!(a->g*b->g < 0.0 && phi*phi < chi && (1.0 - phi)*(1.0 - phi) < 1.0 - chi))
		return 0.5;
	return a->g/(b->g - a->g)*c->g/(b->g - c->g)
	       + (c->speed - a->speed)/(b->speed - a->speed)*a->g/(c->g - a->g)*b->g/(c->g - b->g);
}

/* Shrink the bracket [before, beyond] to its final width. */
static enum hawser_status enclose(struct side *before, struct side *beyond,
                                  const struct search *search, struct hawser_report *report)
{
	struct side *newest = beyond, *other = before, c = *before;
	double width = fabs(beyond->speed - before->speed);
	double enough = BRACKET*fmax(fmax(fabs(before->speed), fabs(beyond->speed)), LEAST_SPEED);
	int first = before->number, slow = 0;
	enum hawser_status status = HAWSER_OK;

	for (int steps = 0; !status && width > enough; steps++) {
		double part = steps > 1 && slow < SLOW ? next(newest, other, &c) : 0.5;
		double least = STEP*enough/width, speed;
		struct side got;

		part = fmin(fmax(part, fmin(least, 0.5)), fmax(1.0 - least, 0.5));
		speed = newest->speed + part*(other->speed - newest->speed);
		if (speed == newest->speed || speed == other->speed)
			break;
		status = look(&got, search, speed, report);
		if (status)
			break;
		newest = got.number == first ? before : beyond;
		other = newest == before ? beyond : before;
		c = *newest;
		*newest = got;
		slow = fabs(beyond->speed - before->speed) > 0.5*width ? slow + 1 : 0;
		width = fabs(beyond->speed - before->speed);
	}
	return status;
}

enum hawser_status hawser__beam_change(struct hawser__beam_change *change,
                                       const struct hawser__beam_solver *solver,
                                       const struct hawser__beam_sample *a,
                                       const struct hawser__beam_sample *b,
                                       enum hawser__beam_counted counted,
                                       struct hawser_report *report)
{
	struct search search = {.solver = solver, .counted = counted};
	struct side before, beyond;
	int more = number(b, counted) > number(a, counted);
	enum hawser_status status;

	choose(&search, more ? a : b, more ? b : a);
	before = side_of(&search, a);
	beyond = side_of(&search, b);
	status = enclose(&before, &beyond, &search, report);
	/* A pair that passes zero is real: so near the change its imaginary part may be round-off. */
	if (search.indicator == ZERO)
		beyond.im = 0.0;
	*change = (struct hawser__beam_change){0.5*(before.speed + beyond.speed), beyond.speed,
	                                       before.number, beyond.number, beyond.im};
	return status;
}
