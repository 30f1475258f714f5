/* Waves in rods that lengthen: the string with a uniformly moving end against its exact modes; a heavy
 * chain against collocation of the equation of small motions. Errors fall with the mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <gsl/gsl_sf_bessel.h>

#include "rod/so3.h"
#include "tests/rod-chain.h"

#define PI 3.14159265358979323846

/* --- the string with a moving end (Balazs 1961) --- */

static const double string_l = 2.0, string_v = 3.0, string_T = 100.0, string_rho = 1.0;

static double string_c(double EA)
{
	return sqrt(string_T*(1.0 + string_T/EA)/string_rho);
}

/* y = cos(k ln(c t + x)) - cos(k ln(c t - x)), k = 2 pi n/ln((c + v)/(c - v)), t counted from when the
 * length was 0; y and its derivatives by t and x. */
static void balazs(double y[3], double c, double x, double t)
{
	double k = 4.0*PI/log((c + string_v)/(c - string_v)), p = c*t + x, q = c*t - x;

	y[0] = cos(k*log(p)) - cos(k*log(q));
	y[1] = c*k*(-sin(k*log(p))/p + sin(k*log(q))/q);
	y[2] = k*(-sin(k*log(p))/p - sin(k*log(q))/q);
}

static void string_guide(void *data, struct hawser__rod_guide *to, double t)
{
	(void)data;
	memset(to, 0, sizeof *to);
	to->q[0] = 1.0;
	to->x[0] = -string_l - string_v*t;
	to->v[0] = -string_v;
}

static double string(int elements, int steps, double *energy)
{
	const double EA = 1e5, strain = string_T/EA, wave = string_c(EA), size = 1e-6, until = 0.6;
	const double began = string_l/string_v;
	struct chain c = cable(string_l/(1.0 + strain), string_rho, EA, 1e-7, string_v/(1.0 + strain),
	                       elements);
	double worst = 0.0;

	memcpy(c.rod.tangent, (const double [3]){1.0, 0.0, 0.0}, sizeof c.rod.tangent);
	memcpy(c.rod.normal, (const double [3]){0.0, 1.0, 0.0}, sizeof c.rod.normal);
	c.rod.at[0] = -string_l;
	c.rod.hold[1] = HAWSER_ROD_HINGED;
	c.rod.g = 0.0;
	c.rod.rho_inf = 1.0;
	chain_open(&c, until, 1);
	c.motion.guide[0] = string_guide;
	for (int i = 0; i <= elements; i++) {
		double x = string_l*(1.0 - (double)i/elements), y[3];

		balazs(y, wave, x, began);
		c.mesh.node[i].x[0] = -x;
		c.mesh.node[i].x[1] = size*y[0];
		hawser__quaternion_exp(c.mesh.node[i].q, (const double [3]){0.0, 0.0, -size*y[2]});
		c.motion.velocity[i][0] = -string_v*x/string_l;
		c.motion.velocity[i][1] = size*(y[1] + y[2]*string_v*x/string_l);
	}
	chain_begin(&c);
	chain_go(&c, until, steps);
	for (int i = 0; i <= elements; i++) {
		double x = -c.mesh.node[i].x[0], y[3];

		balazs(y, wave, x, began + until);
		worst = fmax(worst, fabs(c.mesh.node[i].x[1]/size - y[0]));
	}
	*energy = c.motion.energy_lost/c.motion.most_energy;
	chain_close(&c);
	return worst;
}

static void strings(void)
{
	double energy, first = string(20, 400, &energy), second = string(40, 800, &energy);

	ok(second < 0.02 && first > 3.5*second && first < 4.5*second, "a string whose end moves at 0.3 of "
	   "its waves' speed: off the exact mode, of size 2, by %.2e, %.2e", first, second);
}

/* --- a heavy chain that hangs from the winch: small motions by collocation --- */

enum { TERMS = 14 };
#define ZERO 2.404825557695773 /* of J0 */

/* w'' of y(S, t) = w(xi, t), xi = S/l from the free end, at Chebyshev's points; w = 0 at xi = 1:
 *   w_tt = 2 b xi w_txi + (b' - b^2) xi w_xi - b^2 xi^2 w_xixi + (g - l'')/l (xi w_xi)_xi
 * D: the matrix of d/dxi. */
static void collocate(double *a, const double *w, const double *v, double (*D)[TERMS], const double *xi,
                      const double l[3])
{
	double b = l[1]/l[0], b1 = l[2]/l[0] - b*b, first[TERMS], second[TERMS], rate[TERMS];

	for (int pass = 0; pass < 2; pass++)
		for (int i = 0; i < TERMS; i++) {
			(pass ? second : first)[i] = 0.0;
			for (int j = 0; j < TERMS; j++)
				(pass ? second : first)[i] += D[i][j]*(pass ? first[j] : w[j]);
		}
	for (int i = 0; i < TERMS; i++) {
		rate[i] = 0.0;
		for (int j = 0; j < TERMS; j++)
			rate[i] += D[i][j]*v[j];
		a[i] = 2.0*b*xi[i]*rate[i] + (b1 - b*b)*xi[i]*first[i] - b*b*xi[i]*xi[i]*second[i] +
		       (9.81 - l[2])/l[0]*(first[i] + xi[i]*second[i]);
	}
	a[0] = 0.0; /* xi = 1 */
}

/* The free end at time `until`, from the first mode, w = J0(j sqrt(xi)), at rest, by the method of
 * Runge and Kutta. */
static double chebyshev(const struct hawser__rod_winch *winch, double until, int steps)
{
	double xi[TERMS], D[TERMS][TERMS], w[TERMS], v[TERMS], k[4][2][TERMS], h = until/steps;

	for (int i = 0; i < TERMS; i++) {
		xi[i] = 0.5*(1.0 + cos(PI*i/(TERMS - 1)));
		w[i] = gsl_sf_bessel_J0(ZERO*sqrt(xi[i]));
		v[i] = 0.0;
	}
	for (int i = 0; i < TERMS; i++) {
		D[i][i] = 0.0;
		for (int j = 0; j < TERMS; j++) {
			double ci = i % (TERMS - 1) ? 1.0 : 2.0, cj = j % (TERMS - 1) ? 1.0 : 2.0;

			if (i == j)
				continue;
			D[i][j] = ci/cj*((i + j) % 2 ? -1.0 : 1.0)/(xi[i] - xi[j]);
			D[i][i] -= D[i][j];
		}
	}
	for (int n = 0; n < steps; n++) {
		for (int s = 0; s < 4; s++) {
			double part = s == 0 ? 0.0 : s == 3 ? h : 0.5*h, l[3], at[TERMS], by[TERMS];

			for (int i = 0; i < TERMS; i++) {
				at[i] = w[i] + (s ? part*k[s - 1][0][i] : 0.0);
				by[i] = v[i] + (s ? part*k[s - 1][1][i] : 0.0);
			}
			memcpy(k[s][0], by, sizeof by);
			hawser__rod_winch_at(l, winch, n*h + part);
			collocate(k[s][1], at, by, D, xi, l);
		}
		for (int i = 0; i < TERMS; i++) {
			w[i] += h/6.0*(k[0][0][i] + 2.0*k[1][0][i] + 2.0*k[2][0][i] + k[3][0][i]);
			v[i] += h/6.0*(k[0][1][i] + 2.0*k[1][1][i] + 2.0*k[2][1][i] + k[3][1][i]);
		}
	}
	return w[TERMS - 1];
}

static double heavy(int elements, int steps, double to, double *exact)
{
	double row[3][2] = {{0.0, 0.0}, {2.0, to}, {6.0, 0.3*to}};
	const double EA = 1e7, size = 1e-5, until = 5.0;
	struct chain c = cable(6.0, 1.0, EA, 1e-7, 0.0, elements);
	double y = 0.0, end;

	c.rod.winch = (struct hawser_rod_winch){.on = 1, .row = row, .rows = 3};
	chain_open(&c, until, 1);
	for (int i = 1; i <= elements; i++) {
		double h = 6.0/elements, below = h*(elements - i + 0.5);

		y += h*(1.0 + 9.81*below/EA);
		c.mesh.node[i].x[0] = size*gsl_sf_bessel_J0(ZERO*sqrt(1.0 - (double)i/elements));
		c.mesh.node[i].x[1] = -y;
	}
	for (int i = 0; i <= elements; i++) {
		double root = sqrt(1.0 - (double)i/elements);
		double slope = 0.5*ZERO*(root > 0.0 ? gsl_sf_bessel_J1(ZERO*root)/root : 0.5*ZERO);

		hawser__quaternion_turn(c.mesh.node[i].q, (const double [3]){0.0, 0.0, size*slope/6.0});
	}
	chain_begin(&c);
	*exact = chebyshev(&c.motion.winch, until, 2000);
	chain_go(&c, until, steps);
	end = c.mesh.node[elements].x[0]/size;
	chain_close(&c);
	return end - *exact;
}

static void chains(void)
{
	for (int in = 0; in < 2; in++) {
		double exact, first = heavy(12, 500, in ? -0.9 : 2.5, &exact);
		double second = heavy(48, 500, in ? -0.9 : 2.5, &exact);

		ok(fabs(second) < 2e-3 && fabs(first) > 8.0*fabs(second), "a heavy chain that is %s: its end, "
		   "at %.5f by Chebyshev's points, off by %.2e and %.2e", in ? "hauled in" : "paid out", exact,
		   first, second);
	}
}

CASE(property_rod_winch)
{
	strings();
	chains();
	return done_testing();
}
