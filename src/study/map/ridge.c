/* study/map/ridge.c - see ridge.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "study/map/ridge.h"

#define PART 0.2      /* largest distance from the vertex at which a point counts as the least stable
                       * one, relative to half the locked part: growth differs by 2 %; chosen */
#define WITHIN 0.3    /* the same relative to half the unstable part; chosen */
#define ASIDE 0.3     /* second point from a first one in the locked part, relative to its half;
                       * chosen */
#define UNLIKE 10.0   /* largest ratio of the measured to the expected curvature that is used */
#define CLEAR 0.3     /* decay at the vertex, relative to the mean decay, above which a prediction
                       * closes a tongue; chosen */
#define ROUND_OFF 1e-9 /* of the exponents, relative to Omega */
#define TOUCHING 2e-8 /* smallest growth, relative to Omega, that is told: beneath it round-off of two
                       * multipliers that meet is as large */
#define SPREAD 1e-3   /* weight of the moduli against arguments where several multipliers are
                       * candidates: of equal arguments the pair that differs the most */
#define UNEQUAL 5.0   /* weight of the difference of two displacements against their sizes: at
                       * neighbouring points they are alike; chosen */
#define ALIKE 0.1     /* distance of two places that are one, relative to the points'; chosen */
enum { MOST = 12 };   /* points; chosen: six are usual, and more mean another shape */

static double wrapped(double angle)
{
	return remainder(angle, 2.0*M_PI);
}

/* The two multipliers of the resonance: those of its component with the arguments that the
 * frequencies at rest suggest. Returns 0 if the coordinates are not coupled. */
static int pick(int pair[2], const struct hawser__combination *of, const double *exponents, int n)
{
	const double *frequency = exponents + 1, *part = frequency + n, *modulus = part + n;
	const double *argument = modulus + 2*n;
	double first = 2.0*M_PI*(frequency[of->j] + of->moved[0])/exponents[0];
	double second = -of->sign*2.0*M_PI*(frequency[of->k] + of->moved[1])/exponents[0];
	double best = INFINITY;

	if (part[of->j] != part[of->k])
		return 0;
	for (int a = 0; a < 2*n; a++)
		for (int b = 0; b < 2*n; b++) {
			double off;

			if (a == b || part[a/2] != part[of->j] || part[b/2] != part[of->j])
				continue;
			off = fabs(wrapped(argument[a] - first)) + fabs(wrapped(argument[b] - second)) -
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

double hawser__ridge_half(const struct hawser__ridge *ridge)
{
	double above = ridge->top - 4.0*ridge->mean*ridge->mean*(ridge->mean < 0.0);

	return ridge->points > 1 ? sqrt(fmax(above, 0.0))/fabs(ridge->slope) : 0.0;
}

static enum hawser__ridge_state judge(struct hawser__ridge *ridge, double omega)
{
	double locked = sqrt(fmax(ridge->top, 0.0))/fabs(ridge->slope);
	double growth = ridge->mean + 0.5*sqrt(fmax(ridge->top, 0.0));
	double off = fabs(ridge->place[0] - ridge->centre), half = hawser__ridge_half(ridge);
	double closest = ROUND_OFF*omega/fabs(ridge->slope);

	if (off <= closest || (off <= PART*locked && (growth <= 0.0 || off <= WITHIN*half)))
		return growth > TOUCHING*omega ? HAWSER__RIDGE_UNRESOLVED : HAWSER__RIDGE_CLOSED;
	if (ridge->points > 2 && growth < CLEAR*ridge->mean && ridge->clamped == 0)
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

	if (!pick(pair, &ridge->of, exponents, n))
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
	ridge->clamped += ridge->centre < ridge->low || ridge->centre > ridge->high;
	if (ridge->points > 1)
		state = judge(ridge, exponents[0]);
	ridge->at = fmin(fmax(ridge->centre, ridge->low), ridge->high);
	if (state == HAWSER__RIDGE_GOES_ON && ridge->at == ridge->place[0])
		return ridge->points > 1 ? HAWSER__RIDGE_LOST : HAWSER__RIDGE_CLOSED;
	return state;
}

/* --- resonances between two points --- */

/* Two points, and the frequencies of the motion at both. */
struct between {
	const double *exponents[2];
	double *w[2];    /* [n] */
	double *used[2]; /* [2n] multipliers that belong to one of them */
};

static double argument(const struct between *of, int n, int point, int c)
{
	return of->exponents[point][1 + 4*n + c];
}

/* The pair of multipliers to which c belongs is taken. */
static void use(const struct between *of, int n, int point, int c)
{
	const double *part = of->exponents[point] + 1 + n;
	double closest = INFINITY;
	int other = c;

	of->used[point][c] = 1.0;
	for (int k = 0; k < 2*n; k++) {
		double off = fabs(wrapped(argument(of, n, point, k) + argument(of, n, point, c)));

		if (of->used[point][k] > 0.0 || part[k/2] != part[c/2] || !(off < closest))
			continue;
		closest = off;
		other = k;
	}
	of->used[point][other] = 1.0;
}

/* The multipliers c of mode j: of those not used, those whose displacements from its frequency at
 * rest are the most alike at both points, and the smallest. Returns their measure, of angles off. */
static double choose(int c[2], double off[2], const struct between *of, int n, int j)
{
	double least = INFINITY;

	for (int a = 0; a < 2*n; a++) {
		const double *e = of->exponents[0], *f = of->exponents[1];
		double first = wrapped(argument(of, n, 0, a) - 2.0*M_PI*e[1 + j]/e[0]);

		if (of->used[0][a] > 0.0 || e[1 + n + a/2] != e[1 + n + j])
			continue;
		for (int b = 0; b < 2*n; b++) {
			double second, measure;

			if (of->used[1][b] > 0.0 || f[1 + n + b/2] != f[1 + n + j])
				continue;
			second = wrapped(argument(of, n, 1, b) - 2.0*M_PI*f[1 + j]/f[0]);
			measure = UNEQUAL*fabs(first - second) + fabs(first) + fabs(second);
			if (!(measure < least))
				continue;
			least = measure;
			memcpy(c, (int[2]){a, b}, 2*sizeof *c);
			memcpy(off, (double[2]){first, second}, 2*sizeof *off);
		}
	}
	return least;
}

/* Frequencies of the motion: those at rest, displaced to arguments of multipliers of their
 * component, the surest first; a pair of multipliers belongs to one of them. */
static void displace(struct between *of, int n)
{
	for (int k = 0; k < 2; k++)
		for (int j = 0; j < n; j++)
			of->w[k][j] = NAN;
	for (int round = 0; round < n; round++) {
		double least = INFINITY, off[2] = {0.0, 0.0}, best_off[2] = {0.0, 0.0};
		int mode = -1, c[2] = {0, 0}, best[2] = {0, 0};

		for (int j = 0; j < n; j++) {
			double measure = isnan(of->w[0][j]) ? choose(c, off, of, n, j) : INFINITY;

			if (!(measure < least))
				continue;
			least = measure;
			mode = j;
			memcpy(best, c, sizeof best);
			memcpy(best_off, off, sizeof best_off);
		}
		if (mode < 0)
			break;
		for (int k = 0; k < 2; k++) {
			const double *e = of->exponents[k];

			of->w[k][mode] = e[1 + mode] + best_off[k]*e[0]/(2.0*M_PI);
			use(of, n, k, best[k]);
		}
	}
	for (int j = 0; j < n; j++)
		for (int k = 0; k < 2 && isnan(of->w[k][j]); k++)
			of->w[k][j] = of->exponents[k][1 + j];
}

/* Resonances between the points, by the frequencies u at the one and v at the other. Returns their
 * number, with m from *first on, and the sums at both. */
static int orders(int *first, double sum[2], const struct hawser__combination *pair,
                  const double *a, const double *b, const double *u, const double *v)
{
	double low, high;

	sum[0] = u[pair->j] + pair->sign*u[pair->k];
	sum[1] = v[pair->j] + pair->sign*v[pair->k];
	low = fmin(fabs(sum[0])/a[0], fabs(sum[1])/b[0]);
	high = fmax(fabs(sum[0])/a[0], fabs(sum[1])/b[0]);
	*first = (int)fmax(ceil(low), 1.0);
	return sum[0]*sum[1] > 0.0 ? (int)fmax(floor(high) - *first + 1.0, 0.0) : 0;
}

/* What the motion adds to the frequency of mode j between the points. */
static double moved_at(const struct between *of, int j)
{
	return 0.5*(of->w[0][j] - of->exponents[0][1 + j] + of->w[1][j] - of->exponents[1][1 + j]);
}

/* Where a detuning that changes linearly is 0. */
static double zero(const double r[2])
{
	return r[0]/(r[0] - r[1]);
}

/* By the frequencies at rest, and by those of the motion where these tell another place. */
static enum hawser_status pair_of(const struct hawser__combination *pair,
                                  const struct between *of_it, int *above,
                                  const struct hawser__ridge_taker *taker,
                                  struct hawser_report *report)
{
	const double *a = of_it->exponents[0], *b = of_it->exponents[1];
	enum hawser_status status = HAWSER_OK;
	int first[2], count[2];
	double sum[2][2];

	count[0] = orders(&first[0], sum[0], pair, a, b, a + 1, b + 1);
	count[1] = orders(&first[1], sum[1], pair, a, b, of_it->w[0], of_it->w[1]);
	for (int way = 0; way < 2; way++)
		for (int m = first[way]; m < first[way] + count[way] && !status; m++) {
			struct hawser__combination of = *pair;
			double r[2], other[2] = {fabs(sum[0][0]) - m*a[0], fabs(sum[0][1]) - m*b[0]};

			*above |= m > HAWSER__RIDGE_HIGHEST;
			if (m > HAWSER__RIDGE_HIGHEST)
				break;
			r[0] = fabs(sum[way][0]) - m*a[0];
			r[1] = fabs(sum[way][1]) - m*b[0];
			if (r[0] == r[1] || (way > 0 && m >= first[0] && m < first[0] + count[0] &&
			                     fabs(zero(r) - zero(other)) < ALIKE))
				continue;
			if (sum[way][0] < 0.0) {
				of.j = pair->k;
				of.k = pair->j;
			}
			of.m = m;
			for (int k = 0; k < 2 && way > 0; k++)
				of.moved[k] = moved_at(of_it, k ? of.k : of.j);
			status = taker->found(taker->context, &of, zero(r), r[1] - r[0], report);
		}
	return status;
}

enum hawser_status hawser__ridge_find(const double *a, const double *b, int n, int *above,
                                      const struct hawser__ridge_taker *taker,
                                      struct hawser_report *report)
{
	const double *part[2] = {a + 1 + n, b + 1 + n};
	double *room = calloc(6*(size_t)n, sizeof *room);
	struct between of = {{a, b}, {room, room + n}, {room + 2*n, room + 4*n}};
	enum hawser_status status = room ? HAWSER_OK : hawser__no_memory(report, "hill");

	if (room)
		displace(&of, n);
	for (int j = 0; j < n; j++)
		for (int k = j; k < n; k++) {
			if (part[0][j] != part[0][k] && part[1][j] != part[1][k])
				continue;
			for (int sign = 1; sign >= (j == k ? 1 : -1) && !status; sign -= 2)
				status = pair_of(&(struct hawser__combination){j, k, sign, 0, {0.0, 0.0}}, &of,
				                 above, taker, report);
		}
	free(room);
	return status;
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
	if (log->count == log->room) {
		size_t more = log->room ? 2*log->room : 64;
		void *item = realloc(log->item, more*sizeof *log->item), *known;

		log->item = item ? item : log->item;
		known = realloc(log->found, more);
		log->found = known ? known : log->found;
		if (!item || !known)
			return hawser__no_memory(report, "map");
		log->room = more;
	}
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
