/* water/linear.c - see water/water.h.
 *
 * Gaussian velocities. In the principal axes of the covariance r_i = s_i x_i, where x has the
 * mean m and the covariance I. With x = p e, |e| = 1, the derivative J = |r| I + r r'/|r| is p
 * times a function of e, so that the integral over p is closed, and |r| = 0, where J has an edge,
 * is the origin. What is left is an integral over the directions e, by Gauss's rule on parts of
 * the quadrants: velocities along a line or in a plane have edges where e is at right angles to
 * it. Where the mean is many times the rest J is smooth, and Gauss's rule for x takes over.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/vec3.h"
#include "water/water.h"

/* Gauss's rule with eight points on -1 to 1. */
enum { POINTS = 8 };
static const double gauss_at[POINTS/2] = {
	0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
static const double gauss_weight[POINTS/2] = {
	0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

/* Point i of panels of equal width between a and b, and its weight. */
static double node(double *weight, int i, int panels, double a, double b)
{
	double width = (b - a)/panels, half = 0.5*width;
	int p = i%POINTS, k = p < POINTS/2 ? p : p - POINTS/2;

	*weight = half*gauss_weight[k];
	return a + width*(i/POINTS) + half*(1.0 + (p < POINTS/2 ? gauss_at[k] : -gauss_at[k]));
}

/* C += weight (|r| I + r r'/|r|) */
static void add(double C[3][3], const double r[3], double weight)
{
	double speed = hawser__norm(r);

	for (int i = 0; i < 3 && speed > 0.0; i++)
		for (int j = 0; j < 3; j++)
			C[i][j] += weight*((i == j ? speed : 0.0) + r[i]*r[j]/speed);
}

/* Eigenvalues and rows of eigenvectors of a symmetric matrix, by Jacobi's rotations; descending. */
static void principal(double value[3], double e[3][3], const double A[3][3])
{
	static const int pair[3][2] = {{0, 1}, {0, 2}, {1, 2}};
	double a[3][3];

	memcpy(a, A, sizeof a);
	for (int i = 0; i < 9; i++)
		e[i/3][i%3] = i%4 == 0;
	for (int sweep = 0; sweep < 3*8; sweep++) {
		int p = pair[sweep%3][0], q = pair[sweep%3][1];
		double angle = 0.5*atan2(2.0*a[p][q], a[p][p] - a[q][q]), c = cos(angle), s = sin(angle);

		for (int k = 0; k < 3; k++) { /* rows, then columns */
			double u = a[p][k], v = a[q][k], f = e[p][k], g = e[q][k];

			a[p][k] = c*u + s*v;
			a[q][k] = c*v - s*u;
			e[p][k] = c*f + s*g;
			e[q][k] = c*g - s*f;
		}
		for (int k = 0; k < 3; k++) {
			double u = a[k][p], v = a[k][q];

			a[k][p] = c*u + s*v;
			a[k][q] = c*v - s*u;
		}
	}
	for (int i = 0; i < 3; i++)
		value[i] = fmax(a[i][i], 0.0);
	for (int k = 0; k < 3; k++) {
		int p = pair[k%2 ? 2 : 0][0], q = p + 1;

		if (value[p] < value[q]) {
			double keep = value[p], row[3];

			value[p] = value[q];
			value[q] = keep;
			memcpy(row, e[p], sizeof row);
			memcpy(e[p], e[q], sizeof row);
			memcpy(e[q], row, sizeof row);
		}
	}
}

/* B in the axes e: C = e' B e. */
static void back(double C[3][3], const double B[3][3], const double e[3][3])
{
	for (int i = 0; i < 9; i++) {
		C[i/3][i%3] = 0.0;
		for (int k = 0; k < 9; k++)
			C[i/3][i%3] += e[k/3][i/3]*B[k/3][k%3]*e[k%3][i%3];
	}
}

/* The integral of p^n exp(-|p e - m|^2/2), n = 2 or 3, over (2 pi)^(n/2); dot: e.m */
static double radial(int n, double dot, double square)
{
	const double pi = acos(-1.0);
	double I0 = sqrt(pi/2.0)*erfc(-dot/sqrt(2.0)), edge = exp(-0.5*dot*dot);
	double I1 = edge + dot*I0, I2 = dot*I1 + I0;

	return exp(-0.5*(square - dot*dot))*(n == 2 ? I2/(2.0*pi)
	                                            : (dot*I2 + 2.0*I1)/(2.0*pi*sqrt(2.0*pi)));
}

/* Directions of the plane (n = 2) or of space. */
static void directions(double B[3][3], int n, const double s[3], const double m[3])
{
	const double pi = acos(-1.0);
	double square = hawser__dot(m, m);

	for (int i = 0; i < (n == 3 ? 4*POINTS : 1); i++) {
		double weight = 1.0, z = n == 3 ? node(&weight, i, 4, -1.0, 1.0) : 0.0;
		double wide = sqrt((1.0 - z)*(1.0 + z));

		for (int j = 0; j < 8*POINTS*(n == 2 ? 2 : 1); j++) {
			double turn, angle = node(&turn, j, n == 2 ? 16 : 8, 0.0, 2.0*pi);
			double e[3] = {wide*cos(angle), wide*sin(angle), 0.0}, r[3];

			if (n == 3) { /* z along the largest */
				e[2] = e[1];
				e[1] = e[0];
				e[0] = z;
			}
			for (int k = 0; k < 3; k++)
				r[k] = s[k]*e[k];
			add(B, r, weight*turn*radial(n, hawser__dot(e, m), square));
		}
	}
}

/* Large means: panels over the largest part, three points over the others. */
static void far(double B[3][3], const double s[3], const double U[3])
{
	static const double at[3] = {0.0, 1.7320508075688772, -1.7320508075688772};
	static const double share[3] = {2.0/3.0, 1.0/6.0, 1.0/6.0};

	for (int i = 0; i < 12*POINTS; i++) {
		double weight, x = node(&weight, i, 12, -8.0, 8.0);

		weight *= exp(-0.5*x*x)/sqrt(2.0*acos(-1.0));
		for (int j = 0; j < 9; j++) {
			const double r[3] = {U[0] + s[0]*x, U[1] + s[1]*at[j/3], U[2] + s[2]*at[j%3]};

			add(B, r, weight*share[j/3]*share[j%3]);
		}
	}
}

void hawser__drag_random(double C[3][3], const double cov[3][3], const double mean[3])
{
	const double small = 1e-6, pi = acos(-1.0);
	double s[3], e[3][3], U[3], m[3] = {0.0}, B[3][3] = {{0.0}}, size;
	int n = 3, beyond = 0;

	principal(s, e, cov);
	for (int k = 0; k < 3; k++) {
		s[k] = sqrt(s[k]);
		U[k] = hawser__dot(e[k], mean);
	}
	size = s[0] + hawser__norm(mean);
	while (n > 1 && s[n - 1] <= small*size && fabs(U[n - 1]) <= small*size)
		n--;
	for (int k = 0; k < n; k++) {
		m[k] = s[k] > 0.0 ? U[k]/s[k] : INFINITY;
		beyond += !(fabs(m[k]) < 6.0);
	}
	if (n == 1) {
		double speed = fabs(U[0]);

		if (s[0] > small*size)
			speed = U[0]*erf(m[0]/sqrt(2.0)) + s[0]*sqrt(2.0/pi)*exp(-0.5*m[0]*m[0]);
		for (int k = 0; k < 3; k++)
			B[k][k] = k ? speed : 2.0*speed;
	} else if (beyond) {
		far(B, s, U);
	} else {
		directions(B, n, s, m);
		if (n == 2) /* E |r| across: half the trace of J is 3/2 of it in a plane */
			B[2][2] = (B[0][0] + B[1][1])/3.0;
	}
	back(C, (const double (*)[3])B, (const double (*)[3])e);
}

void hawser__drag_orbit(double C[3][3], const double re[3], const double im[3], const double mean[3])
{
	const double turn = 2.0*acos(-1.0);
	double work = 0.0, square = 0.0;

	for (int i = 0; i < 16*POINTS; i++) {
		double weight, q = node(&weight, i, 16, 0.0, turn), r[3], part[3];

		for (int k = 0; k < 3; k++) {
			part[k] = re[k]*cos(q) + im[k]*sin(q);
			r[k] = mean[k] + part[k];
		}
		work += weight*hawser__norm(r)*hawser__dot(r, part);
		square += weight*hawser__dot(part, part);
	}
	for (int k = 0; k < 9; k++)
		C[k/3][k%3] = k%4 ? 0.0 : square > 0.0 ? work/square : hawser__norm(mean);
}
