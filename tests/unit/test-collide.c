/* Collisions of multipliers between stations: pairs that pass each other are no collision, pairs that
 * meet and separate along the radius are one, and condensed coordinates take no part; nor do pairs
 * of one kind, and of two that are weakly coupled.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "response/branch/collide.h"
#include "response/floquet/floquet.h"
#include "tests/tap.h"

#define PAIRS 3
#define DECAY (-0.02) /* logarithm of the modulus of every pair before a collision */

static struct hawser__station station[4];
static double logs[4][2*PAIRS], arguments[4][2*PAIRS], bounds[4][2*PAIRS], kinds[4][2*PAIRS];
static double turning[4][2*PAIRS];
static double arc[4] = {0.0, 0.385, 0.77, 1.155};
static int followed;

static void set_pair(int k, int i, double log_modulus, double argument)
{
	for (int side = 0; side < 2; side++) {
		logs[k][2*i + side] = log_modulus;
		arguments[k][2*i + side] = side ? -argument : argument;
		bounds[k][2*i + side] = 1e-9;
		kinds[k][2*i + side] = 0.0;
	}
}

static int collide(int step)
{
	const struct hawser__station *all[4];
	double complex work[7*PAIRS];

	for (int k = 0; k < 4; k++) {
		station[k].log_modulus = logs[k];
		station[k].argument = arguments[k];
		station[k].bound = bounds[k];
		station[k].kind = kinds[k];
		station[k].turning = memset(turning[k], 0, sizeof turning[k]);
		station[k].arc = arc[k];
		all[k] = &station[k];
	}
	return hawser__collide(&followed, all, step, 2*PAIRS, work);
}

/* One pair at rest and two that run past it, listed in the order of their arguments, as a station
 * lists them. */
static void check_passing(void)
{
	for (int k = 0; k < 4; k++) {
		double at[PAIRS] = {1.2385, 1.05 + 0.0731*k, 1.41 - 0.0877*k};

		for (int i = 0; i < PAIRS; i++) {
			int place = 0;

			for (int o = 0; o < PAIRS; o++)
				place += at[o] < at[i];
			set_pair(k, place, DECAY, at[i]);
		}
	}
	ok(!collide(2) && !collide(1) && followed == (HAWSER__ALONE | HAWSER__TOGETHER),
	   "pairs that pass each other do not collide, and are followed");
}

/* Moduli and arguments of two pairs with the difference sqrt(D). */
static void set_two(int k, double D)
{
	double complex half = 0.5*csqrt(D);

	set_pair(k, 0, DECAY + creal(half), 1.1 + cimag(half));
	set_pair(k, 1, DECAY - creal(half), 1.1 - cimag(half));
	set_pair(k, 2, DECAY, 2.9);
}

/* D = a - b (s - s0)^2 is negative at the stations and positive in the middle of the step. */
static void check_collision(double top, int step, int expected, const char *what)
{
	for (int k = 0; k < 4; k++)
		set_two(k, top - 0.0731*pow(k - step - 0.5, 2));
	ok(collide(step) == expected, "%s", what);
}

/* Two pairs of the first random model of property/undamped, which collide in the second step. In the
 * third, one of them leaves the circle at -1 and returns: its argument has a kink there. */
static void check_beside_one(void)
{
	static const double at[4] = {5.29903, 5.35975, 5.46904, 5.66578};
	static const double argument[4][2] = {{3.136242, 3.093852}, {3.126726, 3.103207},
	                                      {3.109657, 3.119987}, {3.078350, 3.132426}};

	memcpy(arc, at, sizeof arc);
	for (int k = 0; k < 4; k++) {
		set_pair(k, 0, 0.0, argument[k][0]);
		set_pair(k, 1, 0.0, argument[k][1]);
		set_pair(k, 2, 0.0, 1.9);
	}
	ok(collide(1), "two pairs that collide, of which one meets the real axis in the next step");
	memcpy(arc, (double[4]){0.0, 0.385, 0.77, 1.155}, sizeof arc);
}

/* A pair of one kind runs through another at a rate that changes so much that the interpolation is not
 * sure. */
static void check_kinds(double kind, double other, int expected, const char *what)
{
	static const double off[4] = {-0.5, -0.45, -0.17, 0.17};

	for (int k = 0; k < 4; k++) {
		set_pair(k, 0, DECAY, 1.2385);
		set_pair(k, 1, DECAY, 2.2);
		set_pair(k, 2, DECAY, 1.2385 + off[k]);
		kinds[k][4] = kinds[k][5] = kind;
		kinds[k][0] = kinds[k][1] = other;
	}
	ok(collide(2) == expected, "a pair that runs irregularly through another is %s", what);
}

/* A damped pair passes -1 with other rates of growth within `width` of it: log mu = DECAY +- width
 * there. The others are at rest. */
static void check_alone(double width, int expected, const char *what)
{
	for (int k = 0; k < 4; k++) {
		double off = 0.0731*(k - 2.5);

		set_pair(k, 0, DECAY, 0.8);
		set_pair(k, 1, DECAY, 1.9);
		set_pair(k, 2, DECAY, M_PI - sqrt(off*off - width*width));
	}
	ok(!collide(2) && (followed & HAWSER__ALONE) == expected, "%s", what);
}

/* A pair that meets the real axis is not followed. */
static void check_real(void)
{
	set_pair(3, 2, DECAY, M_PI);
	(void)collide(2);
	ok(!(followed & HAWSER__ALONE), "a pair that has met the real axis at one station is not followed");
}

/* Real multipliers, one of them outside, and a pair that comes no nearer; then two pairs of which
 * one is outside at both ends, and which may meet and part again in between. */
static void check_outside(void)
{
	for (int k = 0; k < 4; k++) {
		set_pair(k, 0, DECAY, 0.4 + 0.0131*k);
		set_pair(k, 1, DECAY, 2.9);
		set_pair(k, 2, DECAY, 0.0);
		logs[k][4] += 0.0523;
		logs[k][5] -= 0.0523;
	}
	ok(!collide(2) && followed == HAWSER__TOGETHER, "one outside that meets no other is followed");
	for (int k = 0; k < 4; k++)
		set_two(k, 0.0731*pow(k - 2.5, 2) - 0.0023);
	ok(!collide(2) && followed == 0, "two that may meet, one of them outside, are not");
}

CASE(unit_collide)
{
	check_passing();
	check_collision(0.0101, 2, 1, "two pairs that collide and grow between two stations are found");
	check_collision(0.0101, 1, 1, "from the stations on both sides too");
	check_collision(0.0009, 2, 0, "so slightly that they stay inside the circle, they are not");
	check_collision(0.0009, 1, 0, "and with stations on both sides");
	check_beside_one();
	check_kinds(0.0, 0.0, 1, "looked at");
	check_kinds(HAWSER__CONDENSED, 0.0, 0, "left out where it is condensed");
	check_kinds(-0.93, -0.71, 0, "left out where both are of one kind");
	check_kinds(0.93, -0.71, 1, "looked at where they are not");
	check_kinds(0.93, 0.3, 1, "or where the kind of one is not sure");
	check_kinds(0.999, -0.93, 0, "left out where they are weakly coupled");
	check_alone(0.0, 1, "a damped pair that passes -1 is followed");
	check_alone(0.015, 1, "also if it meets the real axis less far than the damping reaches");
	check_alone(0.03, 0, "if it may leave the circle there within the step, it is not");
	check_real();
	check_outside();
	return done_testing();
}
