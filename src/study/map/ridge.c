/* study/map/ridge.c - see ridge.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/ridge.h"

#define PART 0.2      /* largest distance from the vertex at which a point counts as the least stable
                       * one, relative to half the locked part: growth differs by 2 %; chosen */
#define WITHIN 0.3    /* the same relative to half the unstable part; chosen */
#define ASIDE 0.3     /* second point from a first one in the locked part, relative to its half;
                       * chosen */
#define UNLIKE 10.0   /* largest ratio of the measured to the expected curvature that is used */
#define CLEAR 0.3     /* decay at the vertex, relative to the mean decay, above which a prediction
                       * that is off by its last change closes a tongue; chosen */
#define ROUND_OFF 1e-9 /* of the exponents, relative to Omega */
#define TOUCHING 2e-8 /* smallest growth, relative to Omega, that is told: beneath it round-off of two
                       * multipliers that meet is as large */
#define SPREAD 1e-3   /* weight of the moduli against arguments where several multipliers are
                       * candidates: of equal arguments the pair that differs the most */
enum { MOST = 12 };   /* points; chosen: six are usual, and more mean another shape */

static double wrapped(double angle)
{
	return remainder(angle, 2.0*M_PI);
}

/* The arguments that the multipliers of the resonance are expected to have. */
static void expect(double to[2], const struct hawser__ridge *ridge, const double *exponents)
{
	const struct hawser__combination *of = &ridge->of;
	int by_courses = of->turn[0] != of->turn[1];
	double turn = 2.0*M_PI/exponents[0], off = ridge->at - ridge->origin;

	to[0] = by_courses ? ridge->anchor[0] + of->turn[0]*off : turn*exponents[1 + of->j];
	to[1] = by_courses ? ridge->anchor[1] + of->turn[1]*off : -of->sign*turn*exponents[1 + of->k];
}

/* The two multipliers of the resonance: those of its component with the arguments expected. Returns
 * 0 if the coordinates are not coupled. */
static int pick(int pair[2], const struct hawser__ridge *ridge, const double *exponents, int n)
{
	const struct hawser__combination *of = &ridge->of;
	const double *part = exponents + 1 + n, *modulus = part + n;
	const double *argument = modulus + 2*n;
	double best = INFINITY, expected[2];

	expect(expected, ridge, exponents);

	if (part[of->j] != part[of->k])
		return 0;
	for (int a = 0; a < 2*n; a++)
		for (int b = 0; b < 2*n; b++) {
			double off;

			if (a == b || part[a/2] != part[of->j] || part[b/2] != part[of->j])
				continue;
			off = fabs(wrapped(argument[a] - expected[0])) +
			      fabs(wrapped(argument[b] - expected[1])) -
			      SPREAD*fmin(fabs(modulus[a] - modulus[b]), 1.0);
			if (off < best) {
				best = off;
				pair[0] = a;
				pair[1] = b;
			}
		}
	return isfinite(best);
}

/* The vertex of the parabola through the points, of curvature slope^2 unless three points tell
 * another one. */
static void fit(struct hawser__ridge *ridge)
{
	const double *t = ridge->place, *Q = ridge->Q;
	double bend = ridge->slope*ridge->slope, tilt = (Q[0] - Q[1])/(t[0] - t[1]);

	if (ridge->points > 2) {
		double own = -(tilt - (Q[1] - Q[2])/(t[1] - t[2]))/(t[0] - t[2]);

		if (own > bend/UNLIKE && own < bend*UNLIKE)
			bend = own;
	}
	ridge->before = ridge->top;
	ridge->centre = 0.5*(t[0] + t[1]) + 0.5*tilt/bend;
	ridge->top = Q[0] + bend*(t[0] - ridge->centre)*(t[0] - ridge->centre);
}

/* With one point: r and the slope tell where r is 0, or its growth how wide the locked part is. */
static void begin(struct hawser__ridge *ridge, double real, double imaginary)
{
	ridge->top = 0.0;
	ridge->centre = fabs(imaginary) > fabs(real)
	                ? ridge->place[0] - imaginary/ridge->slope
	                : ridge->place[0] + ASIDE*fabs(real/ridge->slope);
}

/* The next arguments are expected from those of the latest point, in the order that the vertex
 * tells. */
static void anchor(struct hawser__ridge *ridge, double first, double second)
{
	double side = ridge->slope*(ridge->place[0] - ridge->centre);
	int turned = wrapped(first - second)*side < 0.0;

	ridge->origin = ridge->place[0];
	ridge->anchor[turned] = first;
	ridge->anchor[!turned] = second;
}

double hawser__ridge_half(const struct hawser__ridge *ridge)
{
	double above = ridge->top - 4.0*ridge->mean*ridge->mean*(ridge->mean < 0.0);

	return ridge->points > 1 ? sqrt(fmax(above, 0.0))/fabs(ridge->slope) : 0.0;
}

static enum hawser__ridge_state judge(struct hawser__ridge *ridge, double omega)
{
	double locked = sqrt(fmax(ridge->top, 0.0))/fabs(ridge->slope);
	double growth = ridge->mean + 0.5*sqrt(fmax(ridge->top, 0.0));
	double most = ridge->mean + 0.5*sqrt(fmax(ridge->top + fabs(ridge->top - ridge->before), 0.0));
	double off = fabs(ridge->place[0] - ridge->centre), half = hawser__ridge_half(ridge);
	double closest = ROUND_OFF*omega/fabs(ridge->slope);

	if (off <= closest || (off <= PART*locked && (growth <= 0.0 || off <= WITHIN*half)))
		return growth > TOUCHING*omega ? HAWSER__RIDGE_UNRESOLVED : HAWSER__RIDGE_CLOSED;
	if (ridge->points > 2 && most < CLEAR*ridge->mean && ridge->clamped == 0)
		return HAWSER__RIDGE_CLOSED;
	return ridge->points >= MOST || ridge->clamped > 1 ? HAWSER__RIDGE_LOST
	                                                  : HAWSER__RIDGE_GOES_ON;
}

enum hawser__ridge_state hawser__ridge_take(struct hawser__ridge *ridge, const double *exponents,
                                            int n)
{
	const double *modulus = exponents + 1 + 2*n, *argument = modulus + 2*n;
	double rate = exponents[0]/(2.0*M_PI), real, imaginary;
	enum hawser__ridge_state state = HAWSER__RIDGE_GOES_ON;
	int pair[2] = {0, 0}, worse;

	if (ridge->points == 0) {
		ridge->origin = ridge->at;
		ridge->anchor[0] = ridge->anchor[1] = ridge->of.angle;
	}
	if (!pick(pair, ridge, exponents, n))
		return HAWSER__RIDGE_CLOSED;
	real = rate*(modulus[pair[0]] - modulus[pair[1]]);
	imaginary = rate*wrapped(argument[pair[0]] - argument[pair[1]]);
	for (int i = 2; i > 0; i--) {
		ridge->place[i] = ridge->place[i - 1];
		ridge->Q[i] = ridge->Q[i - 1];
	}
	ridge->place[0] = ridge->at;
	ridge->Q[0] = real*real - imaginary*imaginary;
	worse = modulus[pair[0]] > modulus[pair[1]] ? pair[0] : pair[1];
	ridge->growth = rate*modulus[worse];
	ridge->angle = argument[worse];
	ridge->mean = 0.5*rate*(modulus[pair[0]] + modulus[pair[1]]);
	if (++ridge->points == 1)
		begin(ridge, real, imaginary);
	else
		fit(ridge);
	if (!isfinite(ridge->centre))
		return HAWSER__RIDGE_LOST;
	anchor(ridge, argument[pair[0]], argument[pair[1]]);
	ridge->clamped += ridge->centre < ridge->low || ridge->centre > ridge->high;
	if (ridge->points > 1)
		state = judge(ridge, exponents[0]);
	ridge->at = fmin(fmax(ridge->centre, ridge->low), ridge->high);
	if (state == HAWSER__RIDGE_GOES_ON && ridge->at == ridge->place[0])
		return ridge->points > 1 ? HAWSER__RIDGE_LOST : HAWSER__RIDGE_CLOSED;
	return state;
}

/* --- what became of them --- */

enum hawser_status hawser__ridge_note(struct hawser__ridge_log *log,
                                      const struct hawser__combination *of, int found,
                                      const double at[2], struct hawser_report *report)
{
	size_t c = 0;

	for (; c < log->count; c++)
		if (log->item[c].of[0] == of->j && log->item[c].of[1] == of->k &&
		    log->item[c].sign == of->sign && log->item[c].order == of->m) {
			log->found[c] |= found != 0;
			return HAWSER_OK;
		}
	if (hawser__more(&log->item, (long)log->count, sizeof *log->item) ||
	    hawser__more(&log->found, (long)log->count, 1))
		return hawser__no_memory(report, "map");
	log->item[c] = (struct hawser_tongue){{of->j, of->k}, of->sign, of->m, {at[0], at[1]}};
	log->found[log->count++] = found != 0;
	return HAWSER_OK;
}

void hawser__ridge_unresolved(struct hawser_tongues *to, struct hawser__ridge_log *log)
{
	*to = (struct hawser_tongues){0, log->item, log->above};
	for (size_t c = 0; c < log->count; c++)
		if (!log->found[c])
			to->item[to->count++] = to->item[c];
	free(log->found);
	*log = (struct hawser__ridge_log){.item = NULL};
}
