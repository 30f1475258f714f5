/* response/branch/collide.c - see collide.h.
 *
 *    lambda   log |mu| + i arg mu, arg mu in (0, pi): a complex pair of multipliers. Of two real ones
 *             exp(L - d), exp(L + d) near 1 it is L - i d, near -1 L + i (pi + d): the argument goes on
 *             where a pair has met on the real axis
 *    S        Re(lambda_i + lambda_j)
 *    z        cosh(lambda - S/2); of real ones cosh(L - S/2) times cosh d or -cosh d
 *    D        (z_i - z_j)^2
 *    M        (z_i + z_j)/2
 *
 * If the damping is proportional to the mass, all pairs have the same modulus until two of them
 * collide. They then separate in radial direction; one may leave the unit circle, return and
 * collide with the other again. This makes two torus points, between which no station need lie, and
 * the moduli at the stations do not show them. D, M and S, however, are smooth along the branch even
 * at the collision, and the larger growth of the two pairs is S/2 + |Re arcosh(M + sqrt(D)/2)|.
 * They are therefore interpolated through the last stations. The step is too long if the growth,
 * with the error of the interpolation, may exceed the error of the multipliers within it.
 * Differences of lambda itself would have a kink where a pair meets on the real axis; z has none.
 * Elsewhere the square of such a difference is nearly a parabola, as arguments turn evenly, while D is
 * of fourth degree: pairs that pass each other without growth alarm no step.
 *
 * The two multipliers of one pair collide at 1 or -1 and then separate along the real axis: two folds,
 * branch points or period doublings, if one of them reaches the unit circle. The square of lambda less
 * its conjugate plus 0 or 2 pi i shows whether that may happen within a step. Where multipliers are
 * undecided (circle.h) nothing else shows it; elsewhere judge.c looks at it unless D excludes it.
 *
 * Reference: Seyranian and Mailybaev, Multiparameter Stability Theory with Mechanical Applications
 * (2003), ch. 2: perturbation of double eigenvalues.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <string.h>

#include "response/branch/collide.h"
#include "response/floquet/floquet.h"

#define MODULUS 20.0    /* weight of a logarithm of a modulus beside an argument: moduli change
                         * slowly, and tell which pair is which; chosen */
#define SAMPLES 8       /* points within a step at which the growth is evaluated; chosen */
#define TURN 0.5        /* largest change of an argument per step, rad, with which pairs can be
                         * identified; chosen */
/* Factor on the error of D of one pair, which was up to 2.1 times the third difference (random undamped
 * models). */
#define SAFETY 3.0
#define REAL 0.4        /* largest size of the logarithm of a real multiplier that counts as near 1 or
                         * -1; others are those of strong damping; chosen */
#define DEFINITE 0.5    /* least size of a kind that tells something; chosen */
#define COUPLED 2.0     /* factor on the growth that follows from the kinds at one station; chosen */
#define CLOSE 1.0       /* distance at both ends above which pairs do not collide, rad; chosen */
#define MOVES 8.0       /* the same, over what both pairs move at most between stations; chosen */

/* Whether multiplier i is real and near 1, or near -1 (negative: 1). */
static int is_real(const struct hawser__station *station, int i, int negative)
{
	double angle = fabs(station->argument[i]);

	return station->kind[i] != HAWSER__CONDENSED && (negative ? angle >= M_PI : angle == 0.0) &&
	       fabs(station->log_modulus[i]) < REAL;
}

/* The pairs of one station without those of condensed coordinates; returns their number, or -1 where a
 * real multiplier has no partner. All pairs have similar S, so that the largest of the real ones
 * belongs to the smallest: a station lists them by falling modulus. */
static int list(double complex *lambda, const struct hawser__station *station, int m)
{
	int count = 0;

	for (int i = 0; i < m; i++)
		if (station->argument[i] > 0.0 && station->argument[i] < M_PI &&
		    station->kind[i] != HAWSER__CONDENSED)
			lambda[count++] = station->log_modulus[i] + I*station->argument[i];
	for (int negative = 0; negative < 2; negative++)
		for (int i = 0, j = m - 1;; i++, j--) {
			double d;

			while (i < m && !is_real(station, i, negative))
				i++;
			while (j >= 0 && !is_real(station, j, negative))
				j--;
			if (i == j)
				return -1;
			if (i > j)
				break;
			d = 0.5*(station->log_modulus[i] - station->log_modulus[j]);
			lambda[count++] = 0.5*(station->log_modulus[i] + station->log_modulus[j]) +
			                  I*(negative ? M_PI + d : -d);
		}
	return count;
}

/* d of a real pair, 0 of others. */
static double apart(double complex lambda)
{
	return fmax(0.0, fmax(-cimag(lambda), cimag(lambda) - M_PI));
}

/* `lambda`, or of a pair that was complex at `from` the conjugate whose argument is in 0 to pi. */
static double complex reflect(double complex lambda, double complex from)
{
	double angle = fabs(cimag(lambda));

	return apart(from) > 0.0 ? lambda
	       : creal(lambda) + I*(angle > M_PI ? 2.0*M_PI - angle : angle);
}

/* The index of what is next to z, of those that are numbers and, unless `partner` is NULL, have none
 * yet; -1: none. Moduli hardly change, and tell pairs apart where their damping differs. */
static int nearest_to(double complex z, const double complex *of, const double complex *partner,
                      int count)
{
	double least = INFINITY;
	int best = -1;

	for (int i = 0; i < count; i++) {
		double radial = MODULUS*(creal(of[i]) - creal(z)), turned = cimag(of[i]) - cimag(z);
		double square = radial*radial + turned*turned;

		if (square < least && (!partner || isnan(creal(partner[i])))) {
			least = square;
			best = i;
		}
	}
	return best;
}

/* Order next [count] like expected [count]; room is [count]. Those that are nearest to each
 * other are identified first: in the order of the list, a pair would take the place of another that it
 * only passes. Returns the largest distance. */
static double match(double complex *next, const double complex *expected, double complex *room,
                    int count)
{
	double worst = 0.0;

	for (int i = 0; i < count; i++)
		room[i] = NAN;
	for (int left = count, before = 0; left > 0;) {
		if (left == before)
			return INFINITY;
		before = left;
		for (int i = 0; i < count; i++) {
			int j = isnan(creal(room[i])) ? nearest_to(expected[i], next, NULL, count) : -1;

			if (j < 0 || nearest_to(next[j], expected, room, count) != i)
				continue;
			room[i] = next[j];
			next[j] = NAN;
			worst = fmax(worst, cabs(room[i] - expected[i]));
			left--;
		}
	}
	memcpy(next, room, (size_t)count*sizeof *next);
	return worst;
}

/* The rate at which the logarithm of a pair changes from one station to the next, `along` apart. If it
 * was expected beyond 0 or pi, at from + rate along, `to` is the conjugate of where it went. */
static double complex rate_of(double complex from, double complex to, double complex rate, double along)
{
	double angle = cimag(from + rate*along);
	int passed = apart(from) == 0.0 && apart(to) == 0.0 && (angle < 0.0 || angle > M_PI);

	return !passed ? (to - from)/along
	       : conj(conj(to) + (angle > M_PI ? 2.0*M_PI*I : 0.0) - from)/along;
}

/* Interpolate values g [4] at the four stations at arclengths s: value at `at`, and *error, the
 * contribution of the third difference. */
static double complex interpolate(double *error, const double complex *g, const double *s, double at)
{
	double complex d[4] = {g[3], g[2], g[1], g[0]};
	double x[4] = {s[3], s[2], s[1], s[0]};

	for (int k = 1; k < 4; k++)
		for (int i = 3; i >= k; i--)
			d[i] = (d[i] - d[i - 1])/(x[i] - x[i - k]);
	*error = cabs(d[3]*(at - x[0])*(at - x[1])*(at - x[2]));
	return d[0] + (at - x[0])*(d[1] + (at - x[1])*d[2]);
}

/* Position of the extreme of the parabola through the real parts of g at stations b and c, the ends of
 * a step, and at a, or of the nearer end of the step. */
static double turning_point(const double complex *g, const double *s, int a, int b, int c)
{
	double first = creal(g[b] - g[c])/(s[b] - s[c]);
	double second = (creal(g[a] - g[b])/(s[a] - s[b]) - first)/(s[a] - s[c]);
	double at = second != 0.0 ? 0.5*(s[b] + s[c] - first/second) : s[b];

	return fmax(s[b], fmin(s[c], at));
}

/* Index of the multiplier of pair lambda of the station: of the larger one of a real pair. */
static int index_of(const struct hawser__station *station, int m, double complex lambda)
{
	double argument = fmax(0.0, fmin(cimag(lambda), M_PI)), least = INFINITY;
	int best = 0;

	for (int i = 0; i < m; i++) {
		double off = fabs(station->log_modulus[i] - creal(lambda) - apart(lambda));
		double angle = fmin(fabs(station->argument[i]), M_PI);

		if (angle == argument && station->kind[i] != HAWSER__CONDENSED && off < least) {
			least = off;
			best = i;
		}
	}
	return best;
}

/* Error of the multipliers of pair i at both ends of the step, lambda [4][count]; -1 if it is outside
 * the unit circle at one of them. */
static double bound_within(const double complex *lambda, int count, int i,
                           const struct hawser__station *const station[4], int step, int m)
{
	double bound = 0.0;

	for (int k = step; k < step + 2; k++) {
		double here = station[k]->bound[index_of(station[k], m, lambda[k*count + i])];

		if (creal(lambda[k*count + i]) + apart(lambda[k*count + i]) > here)
			return -1.0;
		bound = fmax(bound, here);
	}
	return bound;
}

/* Largest growth of pairs a and b where they meet, by the station: none of pairs of one kind. The
 * ratio r^2 of the other kind's part of an eigenvector to that of its own kind is the larger, the
 * nearer and the more strongly coupled pairs of the other kind are, and includes all of them. Two that
 * are alone, at a distance g, grow by g r/(1 - r^2) where they meet; COUPLED times this is allowed for.
 * Infinite where the kinds tell nothing. */
static double growth_of(const struct hawser__station *station, int m, double complex a,
                        double complex b)
{
	double of_a = station->kind[index_of(station, m, a)];
	double of_b = station->kind[index_of(station, m, b)];
	double sure = fmax(fabs(of_a), fabs(of_b)), r2 = (1.0 - sure)/(1.0 + sure);

	if (fmin(fabs(of_a), fabs(of_b)) < DEFINITE)
		return INFINITY;
	return of_a*of_b > 0.0 ? 0.0 : COUPLED*fabs(cimag(a - b))*sqrt(r2)/(1.0 - r2);
}

/* Whether pairs i and j are too weakly coupled to leave the unit circle within the step. */
static int are_apart(const double complex *lambda, int count, int i, int j,
                     const struct hawser__station *const station[4], const double *within,
                     int step, int m)
{
	double bound = fmax(within[i], within[j]);

	for (int k = step; k < step + 2; k++) {
		double complex a = lambda[k*count + i], b = lambda[k*count + j];

		if (!(0.5*creal(a + b) + growth_of(station[k], m, a, b) < bound))
			return 0;
	}
	return 1;
}

/* Position of sample e within the step; the first is where D has its extreme. */
static double place_of(const double complex D[4], const double *s, int step, int e)
{
	return e > 0 ? s[step] + (s[step + 1] - s[step])*e/SAMPLES
	             : turning_point(D, s, step - 1, step, step + 1);
}

/* sinh^2 of |Re arcosh z|. What is real and beyond 1 or -1 does not count: that is one pair's
 * matter. */
static double square_growth(double complex z)
{
	double x = fmax(-1.0, fmin(creal(z), 1.0)), y = cimag(z);
	double q = x*x + y*y - 1.0, root = sqrt(q*q + 4.0*y*y);

	return y == 0.0 ? 0.0 : q > 0.0 ? 0.5*(root + q) : 2.0*y*y/(root - q);
}

/* z of a pair. */
static double complex cosh_of(double complex lambda, double half)
{
	double d = apart(lambda), off = creal(lambda) - half;

	return d == 0.0 ? ccosh(lambda - half) : cosh(off)*(cimag(lambda) < 0.0 ? cosh(d) : -cosh(d));
}

/* Whether pairs i and j, which are inside the unit circle at both ends of the step, may be outside
 * between them; lambda [4][count]. If one of them is outside at an end: whether they may meet. */
static int grows_together(const double complex *lambda, int count, int i, int j, const double *s,
                          const double *within, int step)
{
	double complex D[4], M[4], S[4];
	double bound = fmax(within[i], within[j]), side;

	for (int k = 0; k < 4; k++) {
		double complex a = lambda[k*count + i], b = lambda[k*count + j];
		double half = 0.5*creal(a + b);
		double complex z = cosh_of(a, half), of_b = cosh_of(b, half);

		S[k] = 2.0*half;
		D[k] = (z - of_b)*(z - of_b);
		M[k] = 0.5*(z + of_b);
	}
	side = creal(D[step]) < 0.0 ? -1.0 : 1.0;
	for (int e = 0; e <= SAMPLES; e++) {
		double at = place_of(D, s, step, e), off_D, off_M, off_S, least;
		double complex sum = interpolate(&off_S, S, s, at), middle = interpolate(&off_M, M, s, at);
		double complex difference = interpolate(&off_D, D, s, at);

		if (within[i] < 0.0 || within[j] < 0.0) {
			if (!(side*creal(difference) > SAFETY*off_D))
				return 1;
			continue;
		}
		least = sinh(bound - 0.5*(creal(sum) + off_S));
		if (least < 0.0 ||
		    square_growth(middle + 0.5*csqrt(difference - off_D)) > least*least)
			return 1;
	}
	return 0;
}

/* out [4]: pair i at the stations, where bit k of `turned` is set with the conjugate's argument. */
static void turn(double complex *out, const double complex *lambda, int count, int i, double centre,
                 int turned)
{
	for (int k = 0; k < 4; k++) {
		double complex own = lambda[k*count + i];

		out[k] = turned >> k & 1 ? conj(own) + 2.0*I*centre : own;
	}
}

/* The same with arguments that go on beyond 0 or pi: of the values that mean the same, those that lie
 * most nearly on a parabola. Returns 0 where this doesn't help: a real pair, or one that passes 0 or pi
 * within the step. */
static int unroll(double complex *out, const double complex *lambda, int count, int i, const double *s,
                  int step)
{
	double centre = cimag(lambda[step*count + i]) > 0.5*M_PI ? M_PI : 0.0, least = INFINITY;
	int best = 0;

	for (int k = 0; k < 4; k++)
		if (apart(lambda[k*count + i]) > 0.0)
			return 0;
	for (int turned = 0; turned < 16; turned++) {
		double error;

		turn(out, lambda, count, i, centre, turned);
		(void)interpolate(&error, out, s, 0.5*(s[step] + s[step + 1]));
		if (error < least) {
			least = error;
			best = turned;
		}
	}
	turn(out, lambda, count, i, centre, best);
	return (best >> step & 1) == (best >> (step + 1) & 1);
}

/* Whether a and b [4], which may meet within the step, grow by no more than `bound` there. */
static int pass(const double complex *a, const double complex *b, const double *s, int step,
                double bound)
{
	double complex Q[4], S[4];
	double turns = 2.0*M_PI*round(cimag(a[step] - b[step])/(2.0*M_PI));

	for (int k = 0; k < 4; k++) {
		double complex gap = a[k] - b[k] - I*turns;

		Q[k] = gap*gap;
		S[k] = creal(a[k] + b[k]);
	}
	for (int e = 0; e < SAMPLES; e++) {
		double at = place_of(Q, s, step, e), off_Q, off_S;
		double complex sum = interpolate(&off_S, S, s, at), square = interpolate(&off_Q, Q, s, at);

		if (0.5*(creal(sum) + off_S + creal(csqrt(square + SAFETY*off_Q))) > bound)
			return 0;
	}
	return 1;
}

/* The same as grows_together, of complex pairs that don't meet their own conjugates within the step: by
 * the square of the difference of lambda, a parabola where arguments turn evenly, as D is not. */
static int passes_by(const double complex *lambda, int count, int i, int j, const double *s,
                     const double *within, int step)
{
	double complex a[4], b[4], conjugate[4];
	double bound = fmax(within[i], within[j]);

	if (!unroll(a, lambda, count, i, s, step) || !unroll(b, lambda, count, j, s, step))
		return 0;
	for (int k = 0; k < 4; k++)
		conjugate[k] = conj(b[k]);
	return pass(a, b, s, step, bound) && pass(a, conjugate, s, step, bound);
}

/* How far pair i goes from one station to the next, at most; lambda [4][count]. */
static double move_of(const double complex *lambda, int count, int i)
{
	double most = 0.0;

	for (int k = 0; k < 3; k++)
		most = fmax(most, cabs(lambda[(k + 1)*count + i] - lambda[k*count + i]));
	return most;
}

/* Whether the pairs may meet within the step; lambda [2][count]: at both ends of it. */
static int near_by(const double complex *lambda, int count, int i, int j, double moves)
{
	double apart = fmin(cabs(lambda[i] - lambda[j]), cabs(lambda[count + i] - lambda[count + j]));

	return apart < CLOSE && apart < MOVES*moves;
}

/* Whether the multipliers of pair i, which are inside the unit circle at both ends of the step, may
 * have met at 1 or -1, separated and left it. */
static int grows_alone(const double complex *lambda, int count, int i, const double *s,
                       const double *within, int step)
{
	double from = cimag(lambda[step*count + i]), to = cimag(lambda[(step + 1)*count + i]);
	double centre = from + to > M_PI ? M_PI : 0.0;
	double bound = within[i];
	double complex D[4], S[4];

	if (bound < 0.0 || fmin(fabs(from - centre), fabs(to - centre)) >= 0.5*CLOSE)
		return 0;
	for (int k = 0; k < 4; k++) {
		double complex own = lambda[k*count + i];
		double d = apart(own), turned = cimag(own) - centre;

		D[k] = d > 0.0 ? 4.0*d*d : -4.0*turned*turned;
		S[k] = 2.0*creal(own);
	}
	for (int e = 0; e < SAMPLES; e++) {
		double at = place_of(D, s, step, e), off_D, off_S;
		double complex sum = interpolate(&off_S, S, s, at);
		double complex difference = interpolate(&off_D, D, s, at);

		if (0.5*(creal(sum) + off_S + creal(csqrt(difference + SAFETY*off_D))) > bound)
			return 1;
	}
	return 0;
}

int hawser__collide(int *followed, const struct hawser__station *const station[4], int step, int m,
                    double complex *lambda)
{
	double complex *expected = lambda + 4*(m/2), *rate = expected + 2*(m/2);
	/* [count] of bound_within and move_of, once all are matched */
	double s[4], *within = (double *)expected, *move = within + m/2;
	int count = 0, found = 0;
	int undecided = station[step]->circle.undecided > 0 && station[step + 1]->circle.undecided > 0;

	for (int k = 0; k < 4 && (k == 0 || count > 0); k++) {
		double complex *here = lambda + k*count, *before = here - count;
		int now = list(here, station[k], m); /* none or -1: nothing can be followed */

		s[k] = station[k]->arc;
		if (k == 0)
			count = now > 0 ? now : 0;
		else if (now != count)
			count = 0;
		for (int i = 0; i < count; i++)
			if (k == 0)
				rate[i] = I*station[0]->turning[index_of(station[0], m, here[i])];
			else
				expected[i] = reflect(before[i] + rate[i]*(s[k] - s[k - 1]), before[i]);
		if (k > 0 && count > 0 && match(here, expected, expected + count, count) > TURN)
			count = 0;
		for (int i = 0; k > 0 && i < count; i++) {
			rate[i] = rate_of(before[i], here[i], rate[i], s[k] - s[k - 1]);
			station[k]->turning[index_of(station[k], m, here[i])] =
				apart(before[i]) + apart(here[i]) > 0.0 ? 0.0 : cimag(rate[i]);
		}
	}
	*followed = count > 0 ? HAWSER__ALONE | HAWSER__TOGETHER : 0;
	for (int i = 0; i < count; i++) {
		within[i] = bound_within(lambda, count, i, station, step, m);
		move[i] = move_of(lambda, count, i);
	}
	for (int i = 0; i < count && !found; i++) {
		int alone = grows_alone(lambda, count, i, s, within, step);

		found = alone && undecided;
		if (alone || within[i] < 0.0)
			*followed &= ~HAWSER__ALONE;
		for (int j = 0; j < i && !found; j++) {
			int out = within[i] < 0.0 || within[j] < 0.0;
			int meet = near_by(lambda + step*count, count, i, j, move[i] + move[j]) &&
			           (out || !are_apart(lambda, count, i, j, station, within, step, m)) &&
			           grows_together(lambda, count, i, j, s, within, step) &&
			           (out || !passes_by(lambda, count, i, j, s, within, step));

			found = meet && !out;
			*followed &= meet && out ? ~HAWSER__TOGETHER : ~0;
		}
	}
	return found;
}
