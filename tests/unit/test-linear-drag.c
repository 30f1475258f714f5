/* Linear drag in place of |r| r: closed forms of Gaussian velocities on a line, in a plane and in
 * space; with means and any covariance against sums over a grid; orbits against the work of |r|
 * r.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "water/water.h"

#include "core/vec3.h"
#include "tests/tap.h"

static const double none[3] = {0.0};

static void closed(void)
{
	const double pi = acos(-1.0), s = 1.7, U = 1.3;
	const double factor[4] = {0.0, sqrt(8.0/pi), 1.5*sqrt(pi/2.0), 4.0/3.0*sqrt(8.0/pi)};
	double C[3][3];

	for (int n = 1; n <= 3; n++) {
		const double cov[3][3] = {{s*s}, {0.0, n > 1 ? s*s : 0.0}, {0.0, 0.0, n > 2 ? s*s : 0.0}};

		hawser__drag_random(C, cov, none);
		close_to(C[0][0], factor[n]*s, 1e-13, "Gaussian, as in all directions of its space");
		ok(fabs(C[0][1]) + fabs(C[0][2]) + fabs(C[1][2]) < 1e-14, "no coupling");
	}
	hawser__drag_random(C, (const double [3][3]){{s*s}}, (const double [3]){-U, 0.0, 0.0});
	close_to(C[0][0], 2.0*(U*erf(U/(s*sqrt(2.0))) + s*sqrt(2.0/pi)*exp(-0.5*U*U/(s*s))), 1e-13,
	         "with a mean on a line");
	close_to(C[2][2], 0.5*C[0][0], 1e-13, "across, the mean of the speed");
	hawser__drag_random(C, (const double [3][3]){{0.0}}, (const double [3]){0.0, -U, 0.0});
	close_to(C[1][1], 2.0*U, 1e-14, "a mean alone");
	hawser__drag_random(C, (const double [3][3]){{0.0}}, none);
	ok(C[0][0] == 0.0 && C[2][1] == 0.0, "at rest: nothing");
}

/* Sums over 32^3 points of a square root L of the covariance. */
static void summed(void)
{
	enum { EACH = 32 };

	for (int n = 0; n < 5; n++) {
		const double size[3] = {1.0, n & 1 ? 0.3 : 0.01, n & 2 ? 0.7 : 0.0};
		const double mean[3] = {n == 4 ? 9.0 : 0.8*(n > 1), n == 2 ? 0.0 : 0.4, n == 3 ? 0.5 : 0.0};
		double L[3][3], cov[3][3] = {{0.0}}, C[3][3], want[3][3] = {{0.0}}, worst = 0.0, all = 0.0;

		for (int i = 0; i < 9; i++)
			L[i/3][i%3] = sin(3.1*i + 1.0)*size[i%3];
		for (int i = 0; i < 27; i++)
			cov[i/9][i/3%3] += L[i/9][i%3]*L[i/3%3][i%3];
		hawser__drag_random(C, (const double (*)[3])cov, mean);
		for (int i = 0; i < EACH*EACH*EACH; i++) {
			double x[3] = {i/EACH/EACH, i/EACH%EACH, i%EACH}, r[3], weight, speed;

			for (int k = 0; k < 3; k++)
				x[k] = 12.0/EACH*(x[k] + 0.5 - 0.5*EACH);
			weight = exp(-0.5*hawser__dot(x, x));
			all += weight;
			for (int k = 0; k < 3; k++)
				r[k] = mean[k] + hawser__dot(L[k], x);
			speed = hawser__norm(r);
			for (int k = 0; k < 9; k++)
				want[k/3][k%3] += weight*((k%4 == 0 ? speed : 0.0) + r[k/3]*r[k%3]/speed);
		}
		for (int k = 0; k < 9; k++)
			worst = fmax(worst, fabs(C[k/3][k%3] - want[k/3][k%3]/all));
		ok(worst < 1e-3*hawser__norm(C[0]), "Gaussian, mean and covariance %d: within %.1e", n,
		   worst/hawser__norm(C[0]));
	}
}

static void orbit(void)
{
	double re[3] = {2.0, 0.0, 0.0}, im[3] = {0.0}, C[3][3];

	hawser__drag_orbit(C, re, im, none);
	close_to(C[0][0], 16.0/(3.0*acos(-1.0)), 1e-7, "a line: 8/(3 pi)");
	im[2] = 2.0;
	hawser__drag_orbit(C, re, im, none);
	close_to(C[0][0], 2.0, 1e-12, "a circle");
	re[1] = 0.5;
	im[0] = 0.7;
	for (int n = 0; n < 2; n++) {
		const double mean[3] = {0.4*n, 0.2*n, -0.1*n};
		double work = 0.0, linear = 0.0;

		hawser__drag_orbit(C, re, im, mean);
		for (int i = 0; i < 4000; i++) {
			double q = acos(-1.0)*(i + 0.5)/2000.0, r[3], part[3];

			for (int k = 0; k < 3; k++) {
				part[k] = re[k]*cos(q) + im[k]*sin(q);
				r[k] = mean[k] + part[k];
			}
			work += hawser__norm(r)*hawser__dot(r, part);
			for (int k = 0; k < 3; k++)
				linear += part[k]*hawser__dot(C[k], part);
		}
		close_to(linear, work, 1e-10, "an ellipse: the work of |r| r");
	}
	hawser__drag_orbit(C, none, none, (const double [3]){0.0, 0.0, -1.4});
	close_to(C[1][1], 1.4, 1e-15, "a mean alone");
}

CASE(unit_linear_drag)
{
	closed();
	summed();
	orbit();
	return done_testing();
}
