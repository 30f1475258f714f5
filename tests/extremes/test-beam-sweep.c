/* Travelling beams with every pair of parameters varied up to their limits.
 *
 * A level beam has constant coefficients. y is a sum of exp(s x), where s are the roots of
 *
 *   (theta - r^2 v^2) s^4 - 2 r^2 v l s^3 + (v^2 - T - r^2 l^2) s^2 + (c + 2 l) v s + l (l + c) = 0
 *
 * and l is an eigenvalue if the determinant of y and y'' at both ends vanishes. The determinant
 * is evaluated in extended precision, without any function of the library. Static speeds and
 * eigenvalues at rest have closed forms. Upright beams: one discretisation against another.
 *
 * Stated error: the discretisation error of hawser_beam_size, plus condition times backward
 * error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>

#include <hawser/beam.h>

#include "tests/extremes/sweep.h"

#define COUNT(a) ((int)(sizeof(a)/sizeof(a)[0]))

typedef long double complex wide;

static const long double circle_half = 3.14159265358979323846264338327950288L;
static const double tolerance = 1e-9; /* of the discretisation */
static const double round_off = 4e-16; /* of M, C and K */

static const double thetas[] = {1e-8, 1e-6, 1e-4, 1e-2, 1.0, 100.0, 1e4};
static const double drags[] = {0.0, 1e-6, 1e-2, 1.0, 2.0*3.14159265358979323846, 10.0, 100.0, 1e3};
static const double inertias[] = {0.0, 1e-12, 1e-6, 1e-4, 1e-2, 1.0};
static const double paces[] = {0.0, 1e-8, 1e-3, 0.3, 0.9, 0.999, 1.0 - 1e-6, 1.0 - 1e-9};
static const double sizes[] = {1.0, 30.0, 100.0, 200.0, 400.0};
static const double modes[] = {1.0, 2.0, 5.0, 12.0, 30.0};
static const double weights[] = {0.0, 1e-9, 1e-3, 0.1, 0.5, 0.9};

/* The error stated by hawser_beam_size for an eigenvalue of this modulus. It is that of the square,
 * relative to the sum of the square and of (1e-3 w1)^2, where w1 is the first frequency at rest. */
static double relative(double error, const struct hawser_beam *beam, double modulus)
{
	double k2 = (double)(circle_half*circle_half);
	double least = 1e-6*k2*(beam->tension + k2*beam->theta)/(1.0 + k2*beam->rotary);

	return error*(1.0 + least/(modulus*modulus));
}

/* As many functions as the modes need, and at least `least`. *error is the remaining error. */
static enum hawser_status discretise(struct hawser_beam_integrals *is, double *error, int row,
                                     const struct hawser_beam *beam, int count, int least,
                                     struct hawser_report *report)
{
	int size;
	double asked = row == 1 && beam->weight > 0.0 ? 1e-6 : tolerance; /* sines converge slowly */
	enum hawser_status status = hawser_beam_size(&size, error, hawser_beam_method(row), beam,
	                                             count, asked, report);

	*error = fmax(*error, 0.01*asked); /* smaller estimates are not meaningful */
	if (status)
		return status;
	return hawser_beam_method(row)->fill(is, beam->ends, size > least ? size : least, report);
}

/* --- level: the determinant --- */

static void quartic(wide *root, const wide *a)
{
	wide b[5];

	for (int k = 0; k < 5; k++)
		b[k] = a[k]/a[4];
	for (int k = 0; k < 4; k++)
		root[k] = (k < 2 ? 1.0L : powl(1.0L + cabsl(b[2]), 0.5L))*cexpl(I*(0.4L + 1.5L*k));
	for (int n = 0; n < 200; n++) { /* Aberth */
		long double moved = 0.0L;

		for (int k = 0; k < 4; k++) {
			wide z = root[k], f = (((z + b[3])*z + b[2])*z + b[1])*z + b[0];
			wide g = ((4.0L*z + 3.0L*b[3])*z + 2.0L*b[2])*z + b[1], pull = 0.0L, step;

			for (int j = 0; j < 4; j++)
				pull += j == k ? 0.0L : 1.0L/(z - root[j]);
			if (f == 0.0L)
				continue;
			step = 1.0L/(g/f - pull);
			root[k] -= step;
			moved = fmaxl(moved, cabsl(step)/cabsl(root[k]));
		}
		if (moved < 1e-18L)
			break;
	}
}

/* The determinant of (y, y'' at 0; y, y'' at 1), each column divided by its largest exponential, over
 * the Vandermonde determinant of the s, so that equal roots are not zeros. */
static wide determinant(const struct hawser_beam *beam, wide l)
{
	long double v = beam->speed, r2 = beam->rotary;
	const wide a[5] = {l*(l + beam->drag), (beam->drag + 2.0L*l)*v,
	                   v*v - beam->tension - r2*l*l, -2.0L*r2*v*l, beam->theta - r2*v*v};
	wide s[4], m[4][4], det = 1.0L;

	quartic(s, a);
	for (int k = 0; k < 4; k++) {
		long double up = fmaxl(creall(s[k]), 0.0L);

		m[0][k] = cexpl(-up);
		m[1][k] = s[k]*s[k]*m[0][k];
		m[2][k] = cexpl(s[k] - up);
		m[3][k] = s[k]*s[k]*m[2][k];
	}
	for (int k = 0; k < 4; k++) { /* elimination */
		int top = k;

		for (int j = k + 1; j < 4; j++)
			top = cabsl(m[j][k]) > cabsl(m[top][k]) ? j : top;
		for (int c = 0; c < 4; c++) {
			wide swap = m[k][c];

			m[k][c] = m[top][c];
			m[top][c] = swap;
		}
		det *= (top == k ? 1.0L : -1.0L)*m[k][k];
		for (int j = k + 1; j < 4; j++)
			for (int c = 3; c >= k; c--)
				m[j][c] -= m[j][k]/m[k][k]*m[k][c];
	}
	for (int j = 0; j < 4; j++)
		for (int k = j + 1; k < 4; k++)
			det /= s[k] - s[j];
	return det;
}

/* Relative distance of l from the nearest (also double) eigenvalue, by Muller's method. */
static double off(const struct hawser_beam *beam, wide l)
{
	wide x[3] = {l*(1.0L + 1e-6L), l*(1.0L - 1e-6L*I), l}, f[3];

	for (int k = 0; k < 3; k++)
		f[k] = determinant(beam, x[k]);
	for (int n = 0; n < 30; n++) {
		wide h0 = x[1] - x[0], h1 = x[2] - x[1], d0, d1, a, b, root, step;

		if (h0 == 0.0L || h1 == 0.0L || f[2] == 0.0L)
			break;
		d0 = (f[1] - f[0])/h0;
		d1 = (f[2] - f[1])/h1;
		a = (d1 - d0)/(h1 + h0);
		b = a*h1 + d1;
		root = csqrtl(b*b - 4.0L*f[2]*a);
		step = -2.0L*f[2]/(cabsl(b + root) > cabsl(b - root) ? b + root : b - root);
		x[0] = x[1];
		x[1] = x[2];
		x[2] += step;
		f[0] = f[1];
		f[1] = f[2];
		f[2] = determinant(beam, x[2]);
		if (cabsl(step) < 1e-18L*cabsl(x[2]))
			break;
	}
	return (double)(cabsl(l - x[2])/cabsl(x[2]));
}

/* x: theta, drag, rotary, speed over the first static speed, modes, least number of functions. */
static struct hawser_beam level_beam(const double *x)
{
	double k2 = (double)(circle_half*circle_half), bars = INFINITY;
	struct hawser_beam beam = {.theta = x[0], .tension = 1.0, .drag = x[1], .rotary = x[2]};

	if (x[2] > 0.0)
		bars = sqrt(x[0]/x[2]);
	beam.speed = x[3]*fmin(sqrt((1.0 + k2*x[0])/(1.0 + k2*x[2])), bars);
	return beam;
}

static void level(struct sweep_point *point, const double *x, void *row)
{
	struct hawser_beam beam = level_beam(x);
	struct hawser_beam_eigenvalue value[64];
	struct hawser_beam_integrals is = {0};
	int count = (int)x[4], found = 0;
	double error = 0.0;

	point->skip = sweep_left_out(29, 1);
	if (point->skip)
		return;
	point->status = discretise(&is, &error, *(int *)row, &beam, count, (int)x[5], &point->report);
	if (!point->status)
		point->status = hawser_beam_eigenvalues(value, NULL, &found, &is, &beam, count,
		                                        &point->report);
	for (int k = 0; !point->status && k < found; k += k + 1 < found && k + 3 >= found ? 1 : 3)
		sweep_keep(point, off(&beam, value[k].re + I*value[k].im),
		     relative(error, &beam, hypot(value[k].re, value[k].im)) +
		     value[k].condition*(value[k].residual + round_off));
	hawser_beam_integrals_clear(&is);
}

/* --- closed forms --- */

static int by_modulus(const void *left, const void *right)
{
	double a = cabs(*(const double complex *)left), b = cabs(*(const double complex *)right);

	return (a > b) - (a < b);
}

/* The count lowest eigenvalues at rest with im >= 0, by their modulus. */
static void at_rest(double complex *value, const struct hawser_beam *beam, int count)
{
	enum { TERMS = 200 };
	static double complex all[2*TERMS];
	int n = 0;

	for (int j = 1; j <= TERMS; j++) {
		long double k2 = j*j*circle_half*circle_half, M = 1.0L + beam->rotary*k2, c = beam->drag;
		long double K = k2*(beam->tension + beam->theta*k2), D = c*c - 4.0L*M*K;

		if (D < 0.0L) {
			all[n++] = (double complex)((-c + I*sqrtl(-D))/(2.0L*M));
		} else {
			all[n++] = (double)(-2.0L*K/(c + sqrtl(D)));
			all[n++] = (double)(-(c + sqrtl(D))/(2.0L*M));
		}
	}
	qsort(all, (size_t)n, sizeof *all, by_modulus);
	memcpy(value, all, (size_t)count*sizeof *value);
}

static void resting(struct sweep_point *point, const double *x, void *row)
{
	struct hawser_beam beam = level_beam(x);
	struct hawser_beam_eigenvalue value[64];
	struct hawser_beam_integrals is = {0};
	double complex exact[64];
	int count = (int)x[4], found = 0;
	double error = 0.0;

	point->skip = sweep_left_out(29, 1);
	if (point->skip)
		return;
	beam.speed = 0.0;
	point->status = discretise(&is, &error, *(int *)row, &beam, count, (int)x[5], &point->report);
	if (!point->status)
		point->status = hawser_beam_eigenvalues(value, NULL, &found, &is, &beam, count,
		                                        &point->report);
	at_rest(exact, &beam, count);
	for (int k = 0; !point->status && k < found; k++) {
		double e = INFINITY;

		for (int j = 0; j < count; j++) /* equal moduli come in either order */
			if (cabs(exact[j]) < cabs(exact[k])*1.001 && cabs(exact[j]) > cabs(exact[k])*0.999)
				e = fmin(e, cabs(value[k].re + I*value[k].im - exact[j])/cabs(exact[j]));
		sweep_keep(point, e, relative(error, &beam, cabs(exact[k])) +
		               value[k].condition*(value[k].residual + round_off));
	}
	hawser_beam_integrals_clear(&is);
}

static void speeds(struct sweep_point *point, const double *x, void *row)
{
	struct hawser_beam beam = level_beam(x);
	struct hawser_beam_integrals is = {0};
	double speed[2048], error = 0.0;
	int count = (int)x[4], found = 0, buckled = 0;

	point->skip = sweep_left_out(7, 1);
	if (point->skip)
		return;
	beam.drag = 0.0;
	point->status = discretise(&is, &error, *(int *)row, &beam, count, (int)x[5], &point->report);
	if (!point->status)
		point->status = hawser_beam_static_speeds(speed, &found, &buckled, &is, &beam,
		                                          &point->report);
	if (!point->status && (found < count || buckled))
		sweep_keep(point, NAN, 0.0);
	for (int k = 0; !point->status && k < count; k++) {
		double exact = INFINITY, e = INFINITY, k2;

		/* with rotary inertia they need not rise with the number of half-waves */
		for (int j = 1; j <= 400; j++) {
			k2 = (double)(j*j*circle_half*circle_half);
			exact = sqrt((beam.tension + beam.theta*k2)/(1.0 + beam.rotary*k2));
			e = fmin(e, fabs(speed[k]/exact - 1.0));
		}
		sweep_keep(point, e, error + round_off);
	}
	hawser_beam_integrals_clear(&is);
}

/* x: weight, theta, drag, rotary, speed over the wave speed at the least tension, modes. The second
 * method (sines) against the first. */
static void upright(struct sweep_point *point, const double *x, void *rows)
{
	struct hawser_beam beam = {.theta = x[1], .tension = 1.0, .weight = x[0], .drag = x[2],
	                           .rotary = x[3], .speed = x[4]*sqrt(1.0 - x[0])};
	struct hawser_beam_eigenvalue value[2][64];
	int count = (int)x[5], found[2] = {0};
	double error[2] = {0.0};

	/* sines need hundreds of functions for so little stiffness */
	point->skip = (!sweep_long() && x[1] < 1e-3) || sweep_left_out(23, 4);
	if (point->skip)
		return;
	for (int turn = 0; turn < 2 && !point->status; turn++) {
		struct hawser_beam_integrals is = {0};

		point->status = discretise(&is, error + turn, ((int *)rows)[turn], &beam, count, 0,
		                           &point->report);
		if (!point->status)
			point->status = hawser_beam_eigenvalues(value[turn], NULL, found + turn, &is, &beam,
			                                        count, &point->report);
		hawser_beam_integrals_clear(&is);
	}
	for (int k = 0; !point->status && k < found[0]; k++) {
		double e = INFINITY;

		for (int j = 0; j < found[1]; j++)
			e = fmin(e, hypot(value[0][k].re - value[1][j].re, value[0][k].im - value[1][j].im)
			            /hypot(value[1][j].re, value[1][j].im));
		sweep_keep(point, e,
		           relative(error[0] + error[1], &beam, hypot(value[0][k].re, value[0][k].im)) +
		               value[0][k].condition*(value[0][k].residual + round_off));
	}
}

CASE(extremes_beam_sweep)
{
	const struct sweep_axis axis[] = {{"theta", 1.0, thetas, COUNT(thetas), 1},
	                                  {"drag", 0.0, drags, COUNT(drags), 1},
	                                  {"inertia", 0.0, inertias, COUNT(inertias), 0},
	                                  {"pace", 0.3, paces, COUNT(paces), 0},
	                                  {"modes", 5.0, modes, COUNT(modes), 0},
	                                  {"functions", 1.0, sizes, COUNT(sizes), 0}};
	const struct sweep_axis up[] = {{"weight", 0.5, weights, COUNT(weights), 0},
	                                {"theta", 1.0, thetas, COUNT(thetas), 0},
	                                axis[1], axis[2], axis[3], axis[4]};
	int rows[] = {0, 1, 2};

	for (int k = 0; hawser_beam_method(k); k++)
		printf("# %d %s\n", k, hawser_beam_method(k)->name);
	sweep_pairs("beam/level", axis, 6, level, rows);
	sweep_pairs("beam/rest", axis, 6, resting, rows);
	sweep_pairs("beam/static", axis, 6, speeds, rows);
	sweep_pairs("beam/upright", up, 6, upright, rows);
	sweep_again("layers of a moving beam", level, (double[]){1e-6, 0.0, 0.0, 0.3, 5.0, 1.0}, rows);
	return done_testing();
}
