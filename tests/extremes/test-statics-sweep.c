/* Statics from each of the five given quantities, at rest and travelling, with every pair of parameters
 * varied up to their limits, against the catenary in quadruple precision.
 *
 * Stated error (doc/theory-statics.md): every result is exact for inputs changed by a few units in the
 * last place. The error is therefore compared with the effect of one such unit of each input.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/extremes/sweep.h"
#include "tests/extremes/statics-quad.h"

#define COUNT(a) ((int)(sizeof(a)/sizeof(a)[0]))

static const double units = 4.0; /* in the last place, of each input */

/* Ends of the axes; d and g are odd, so that nothing is exact by chance. */
static const double d = 238.5, g = 9.81;

static const double extensibility[] = {0.0, 1e-17, 1e-14, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 0.5};
static const double slopes[] = {-1e9, -1e3, -20.0, -1.0, -0.04, -1e-9, 0.0, 1e-12, 1e-3, 0.3, 3.0,
                                50.0, 1e6, 1e9};
static const double delta[] = {1e-9, 1e-7, 1e-4, 1e-2, 0.3, 1.0, 3.0, 10.0, 25.0, 50.0};
static const double masses[] = {1e-3, 6.0, 1e3};
static const double lengths[] = {0.5, 0.9, 1.0 - 1e-3, 1.0 - 1e-6, 1.0 - 1e-9, 1.0 - 1e-12,
                                 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 1.0 + 1e-12, 1.0 + 1e-9, 1.0 + 1e-6,
                                 1.0 + 1e-3, 1.1, 2.0, 10.0, 100.0};
static const double sags[] = {1e-10, 1e-7, 1e-4, 1e-2, 0.3, 1.0, 10.0, 100.0};
static const double tensions[] = {1e-2, 0.1, 0.3, 0.5, 0.7, 1.0, 3.0, 30.0, 1e3, 1e6, 1e9};
static const double branches[] = {0.0, 1.0};
static const double paces[] = {0.0, 1e-8, 1e-3, 0.3, 0.9, 0.99, 1.0 - 1e-6, 1.0 - 1e-9, 1.0 + 1e-9,
                               1.1, 3.0};
static const double swings[] = {0.0, 1e-8, 1e-2, 0.5, 1.0};

static enum hawser_given given_of(const void *context)
{
	return *(const enum hawser_given *)context;
}

static struct quad_span quad_of(const struct hawser_span *span, enum hawser_given given, double value)
{
	return (struct quad_span){value, isinf(span->EA) ? (quad)0 : 1/(quad)span->EA,
	                          (quad)span->rho*span->g, span->d, span->h, 0, given};
}

/* x: extensibility, slope, given value (delta for H; otherwise lengths over the chord, tensions over
 * w d, sags over d), mass, branch. The extensibility is H/EA for given H, otherwise w d/EA. */
static void at_rest(struct sweep_point *point, const double *x, void *context)
{
	enum hawser_given given = given_of(context);
	struct hawser_span span = {INFINITY, x[3], g, d, x[1]*d};
	double weight = span.rho*g*d, value = x[2]*weight;
	struct hawser_statics st;
	struct quad_span exact;

	if (given == HAWSER_GIVEN_H)
		value = weight/x[2];
	else if (given == HAWSER_GIVEN_LENGTH0)
		value = x[2]*hypot(d, span.h);
	else if (given == HAWSER_GIVEN_SAG)
		value = x[2]*d;
	/* a sag below the round-off of the positions of the ends */
	point->skip = given == HAWSER_GIVEN_SAG && x[2] < 1e-15*hypot(1.0, x[1]);
	if (x[0] > 0.0)
		span.EA = (given == HAWSER_GIVEN_H ? value : weight)/x[0];
	point->status = hawser_statics_solve(&st, &span, given, value, (enum hawser_branch)(int)x[4],
	                                     &point->report);
	if (point->status)
		return;
	exact = quad_of(&span, given, value);
	quad_judge(&point->error, &point->stated, &st, &exact, units);
}

static void rest(void)
{
	static const char *const names[] = {"", "statics/H", "statics/T0", "statics/T1",
	                                    "statics/length0", "statics/sag"};
	const struct sweep_axis value[] = {
		[HAWSER_GIVEN_H] = {"delta", 0.3, delta, COUNT(delta), 2},
		[HAWSER_GIVEN_T0] = {"tension", 3.0, tensions, COUNT(tensions), 2},
		[HAWSER_GIVEN_T1] = {"tension", 3.0, tensions, COUNT(tensions), 2},
		[HAWSER_GIVEN_LENGTH0] = {"length0", 1.0 + 1e-3, lengths, COUNT(lengths), 1},
		[HAWSER_GIVEN_SAG] = {"sag", 0.01, sags, COUNT(sags), 2},
	};

	for (enum hawser_given given = HAWSER_GIVEN_H; given <= HAWSER_GIVEN_SAG; given++) {
		const struct sweep_axis axis[] = {
			{"extensibility", 1e-4, extensibility, COUNT(extensibility), 2},
			{"slope", 0.04, slopes, COUNT(slopes), 1},
			value[given],
			{"mass", 6.0, masses, COUNT(masses), 0},
			{"branch", 0.0, branches, COUNT(branches), 0},
		};
		int tension = given == HAWSER_GIVEN_T0 || given == HAWSER_GIVEN_T1;

		sweep_pairs(names[given], axis, tension ? 5 : 4, at_rest, &given);
	}
}

/* x: speed over the limit, w d/EA, slope, T over w d (length: T of the cable at rest), fluctuation over
 * the speed. The given quantity is also the quantity held: T0 or T1, length0, or H. */
static void travelling(struct sweep_point *point, const double *x, void *context)
{
	enum hawser_given given = given_of(context);
	int length = given == HAWSER_GIVEN_LENGTH0;
	struct hawser_motion motion = {.hold = length ? HAWSER_HOLD_LENGTH : HAWSER_HOLD_TENSION};
	struct hawser_span span = {INFINITY, 6.0, g, d, x[2]*d};
	double weight = span.rho*g*d, value = x[3]*weight, limit, fast;
	struct hawser_statics st;
	struct quad_span exact;

	span.EA = weight/x[1];
	if (length) {
		point->status = hawser_statics_solve(&st, &span, HAWSER_GIVEN_T0, value,
		                                     HAWSER_BRANCH_TAUT, &point->report);
		if (point->status)
			return;
		value = st.length0;
	}
	point->status = hawser_statics_limit(&limit, &span, given, value, HAWSER_BRANCH_TAUT,
	                                     motion.hold, &point->report);
	if (point->status)
		return;
	motion.speed = x[0]*limit;
	motion.fluctuation = x[4]*motion.speed;
	point->status = hawser_statics_travel(&st, &span, given, value, HAWSER_BRANCH_TAUT, &motion,
	                                      &point->report);
	fast = x[0]*sqrt(1.0 + 0.5*x[4]*x[4]);
	if (point->status) {
		if (fast < 1.0 - 0.5e-9) /* refused below the limit */
			point->status = HAWSER_OK;
		point->error = NAN;
		return;
	}
	exact = quad_of(&span, given, value);
	exact.p = (quad)span.rho*((quad)motion.speed*motion.speed
	                         + (quad)motion.fluctuation*motion.fluctuation/2);
	quad_judge(&point->error, &point->stated, &st, &exact, units);
}

static void travels(void)
{
	static const char *const names[] = {"", "travel/H", "travel/T0", "travel/T1", "travel/length0"};
	const struct sweep_axis axis[] = {
		{"pace", 0.3, paces, COUNT(paces), 2},
		{"extensibility", 1e-4, extensibility + 2, COUNT(extensibility) - 2, 2},
		{"slope", 0.04, slopes + 1, COUNT(slopes) - 2, 1},
		{"tension", 3.0, tensions + 3, COUNT(tensions) - 4, 2},
		{"swing", 0.0, swings, COUNT(swings), 1},
	};

	for (enum hawser_given given = HAWSER_GIVEN_H; given <= HAWSER_GIVEN_LENGTH0; given++)
		sweep_pairs(names[given], axis, COUNT(axis), travelling, &given);
}

CASE(extremes_statics_sweep)
{
	rest();
	travels();
	sweep_again("H held close to sqrt(EA/rho)", travelling,
	      (double[]){0.99332184144200475, 1e-4, 0.04, 1e6, 0.0}, &(enum hawser_given){HAWSER_GIVEN_H});
	sweep_again("just below the limit, large strain", travelling,
	      (double[]){1.0 - 1e-9, 0.5, 0.04, 3.0, 0.0}, &(enum hawser_given){HAWSER_GIVEN_T0});
	return done_testing();
}
