/* bench/estimates-catenary.c - hawser statics against the elastic catenary in quadruple precision
 * (estimates.h).
 *
 * Unknowns are m, ln a and ln H as in src/statics/catenary.h. The two closures and the equation of
 * the given quantity are solved by Newton's method with difference quotients, starting from the
 * result to be tested; a step gains a dozen digits. exp and related functions are computed by
 * series after halving of the argument, with + - * / only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench/estimates.h"
#include "tests/modes-shooting.h" /* quad, quad_sqrt */
#include "tests/statics-draw.h"

enum { HALVINGS = 12, TERMS = 18, QUANTITIES = 6 };

struct span_quad {
	quad EA, w, d, h; /* h >= 0 */
};

static quad absolute(quad x)
{
	return x < 0 ? -x : x;
}

/* exp(x) - 1 */
static quad quad_expm1(quad x)
{
	quad y = x/(1 << HALVINGS), term = y, sum = y;

	for (int k = 2; k < TERMS; k++) {
		term *= y/k;
		sum += term;
	}
	for (int k = 0; k < HALVINGS; k++)
		sum *= 2 + sum;
	return sum;
}

static quad quad_sinh(quad x)
{
	quad e = quad_expm1(x);

	return (e + e/(1 + e))/2;
}

static quad quad_cosh(quad x)
{
	quad e = quad_expm1(x);

	return 1 + e*e/(1 + e)/2;
}

static quad quad_asinh(quad y)
{
	quad x = (quad)asinh((double)y);

	for (int k = 0; k < 3; k++)
		x -= (quad_sinh(x) - y)/quad_cosh(x);
	return x;
}

/* q[QUANTITIES]: H, T0, T1, length0, length, sag, at m, a and H; T0 is that of the lower end. */
static void quantities(quad *q, const struct span_quad *span, quad m, quad a, quad H)
{
	quad eps = H/span->EA, up = m + a, low = m - a, slope = span->h/span->d, c = quad_asinh(slope);
	quad sl = quad_sinh(low), su = quad_sinh(up), cl = quad_cosh(low), cu = quad_cosh(up), x, y;
	quad unit = H/span->w, sc = slope, cc = quad_cosh(c);

	q[0] = H;
	q[1] = H*cl;
	q[2] = H*cu;
	q[3] = 2*unit*quad_cosh(m)*quad_sinh(a);
	/* the integral of 1 + eps sqrt(1 + u^2) over u = sinh(angle) is that of cosh + eps cosh^2 over
	 * the angle */
	q[4] = q[3] + unit*eps*(a + quad_cosh(2*m)*quad_sinh(2*a)/2);
	x = c - low + eps*(sc - sl);
	y = cc - cl + eps*(sc*sc - sl*sl)/2;
	q[5] = unit*(slope*x - y);
	(void)su;
}

/* Residuals [3]. */
static void defects(quad *f, const struct span_quad *span, int given, quad value, quad m, quad la,
                    quad lH)
{
	quad a = 1 + quad_expm1(la), H = 1 + quad_expm1(lH), eps = H/span->EA, q[QUANTITIES];
	quad b = span->w*span->d/(2*H), sm = quad_sinh(m), cm = quad_cosh(m), sa = quad_sinh(a);

	quantities(q, span, m, a, H);
	f[0] = (a + eps*cm*sa)/b - 1;
	f[1] = sm*sa*(1 + eps*cm*quad_cosh(a))/b - span->h/span->d;
	f[2] = q[given]/value - 1;
}

static quad det(const quad M[3][3])
{
	return M[0][0]*(M[1][1]*M[2][2] - M[1][2]*M[2][1]) - M[0][1]*(M[1][0]*M[2][2] - M[1][2]*M[2][0]) +
	       M[0][2]*(M[1][0]*M[2][1] - M[1][1]*M[2][0]);
}

static quad quad_log(double x)
{
	quad y = log(x);

	for (int k = 0; k < 3; k++)
		y -= 1 - x/(1 + quad_expm1(y));
	return y;
}

/* The exact quantities of the problem of *st; returns 0 if Newton's method does not converge. */
static int solve(double *exact, const struct hawser_statics *st, double value)
{
	int falls = st->span.h < 0.0, settled = 0;
	int given = st->given == HAWSER_GIVEN_T0 ? 1 + falls : st->given == HAWSER_GIVEN_T1 ? 2 - falls :
	            st->given == HAWSER_GIVEN_LENGTH0 ? 3 : st->given == HAWSER_GIVEN_SAG ? 5 : 0;
	double p = asinh(st->V0/st->H), r = asinh(st->V1/st->H);
	struct span_quad span = {st->span.EA, (quad)st->span.rho*st->span.g, st->span.d,
	                         fabs(st->span.h)};
	/* for taut cables r - p cancels: a follows from the length */
	quad m = fabs(p + r)/2, a = quad_asinh((quad)st->length0*span.w/(2*st->H)/quad_cosh(m));
	quad z[3] = {m, quad_log((double)a), quad_log(st->H)}, q[QUANTITIES];

	for (int i = 0; i < 14 && !settled; i++) {
		quad f[3], g[3], J[3][3], step[3], D;

		defects(f, &span, given, value, z[0], z[1], z[2]);
		for (int k = 0; k < 3; k++) {
			quad y[3] = {z[0], z[1], z[2]}, h = (quad)1e-14*(k ? 1 : absolute(z[0]) + (quad)1e-12);

			y[k] += h;
			defects(g, &span, given, value, y[0], y[1], y[2]);
			for (int j = 0; j < 3; j++)
				J[j][k] = (g[j] - f[j])/h;
		}
		D = det(J);
		for (int k = 0; k < 3; k++) {
			quad M[3][3];

			memcpy(M, J, sizeof M);
			for (int j = 0; j < 3; j++)
				M[j][k] = f[j];
			step[k] = det(M)/D;
			z[k] -= step[k];
		}
		settled = absolute(step[2]) < (quad)1e-20 && absolute(step[1]) < (quad)1e-20;
	}
	quantities(q, &span, z[0], 1 + quad_expm1(z[1]), 1 + quad_expm1(z[2]));
	for (int k = 0; k < QUANTITIES; k++)
		exact[k] = (double)q[k];
	if (falls) {
		exact[1] = (double)q[2];
		exact[2] = (double)q[1];
	}
	return settled;
}

struct hawser_span estimate_span(struct chance *chance, double *H)
{
	struct hawser_span span = {.rho = chance_log(chance, 1e-2, 1e3), .g = 9.81,
	                           .d = chance_log(chance, 1.0, 1e3)};
	double slope = chance_unit(chance) < 0.3 ? 0.0 : chance_log(chance, 1e-3, 20.0);
	double delta = chance_log(chance, 1e-6, 20.0);

	span.h = (chance_unit(chance) < 0.5 ? -1.0 : 1.0)*slope*span.d;
	*H = span.rho*span.g*span.d/delta;
	span.EA = *H/chance_log(chance, 1e-12, 0.1);
	return span;
}

int estimate_statics(struct tally *tally, struct chance *chance)
{
	static const char *const name[] = {"H", "T0", "T1", "length0", "length", "sag"};
	double H, value, exact[QUANTITIES];
	struct hawser_span span = estimate_span(chance, &H);
	enum hawser_given given = (enum hawser_given)chance_int(chance, HAWSER_GIVEN_H,
	                                                        HAWSER_GIVEN_SAG);
	struct hawser_statics st;

	if (hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL))
		return 1;
	value = value_of(&st, given);
	if (hawser_statics_solve(&st, &span, given, value, branch_of(&st, given), NULL))
		return 1;
	if (!solve(exact, &st, value)) {
		tally_note(tally, NAN, 1.0, "no exact answer");
		return 0;
	}
	const double got[] = {st.H, st.T0, st.T1, st.length0, st.length, st.sag};

	for (int k = 0; k < QUANTITIES; k++)
		tally_note(tally, fabs(got[k]/exact[k] - 1.0), st.error,
		           "%s from %s, epsilon %.2g, delta %.2g, hs %.3g", name[k],
		           given > HAWSER_GIVEN_H && given < HAWSER_GIVEN_LENGTH0 ? name[given - 1] :
		           given == HAWSER_GIVEN_LENGTH0 ? "length0" :
		           given == HAWSER_GIVEN_SAG ? "sag" : "H", st.epsilon, st.delta, st.hs);
	return 0;
}
