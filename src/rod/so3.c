/* rod/so3.c - see so3.h.
 *
 *   a = (1 - cos t)/t^2, b = (t - sin t)/t^3, c = (1 - (t/2) cot(t/2))/t^2, t = |v|
 *
 * and their derivatives over t, which cancel near 0: Taylor series up to t = 1, whose first term left
 * out is below round-off there; closed forms beyond, where no more than two digits cancel.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "rod/so3.h"

/* Of c: |B_2k|/(2k)!, k = 1, 2, .., with Bernoulli's numbers B. */
static const double bernoulli[] = {
	1.0/12.0, 1.0/720.0, 1.0/30240.0, 1.0/1209600.0, 1.0/47900160.0, 691.0/1307674368000.0,
	1.0/74724249600.0, 3617.0/10670622842880000.0, 43867.0/5109094217170944000.0,
	174611.0/802857662698291200000.0, 77683.0/14101100039391805440000.0};
enum { TERMS = 9, BERNOULLI = sizeof bernoulli/sizeof *bernoulli };
#define SMALL 1.0 /* rad, largest |v| of the series: 1/20! and (1/2pi)^22 are below round-off */

void hawser__quaternion_mul(double c[4], const double a[4], const double b[4])
{
	c[0] = a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3];
	c[1] = a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2];
	c[2] = a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1];
	c[3] = a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0];
}

void hawser__quaternion_exp(double q[4], const double v[3])
{
	double half = 0.5*sqrt(hawser__dot(v, v));
	double part = half > 1e-4 /* its next term, half^4/240, is below round-off */
		? 0.5*sin(half)/half : 0.5 - half*half/12.0;

	q[0] = cos(half);
	for (int i = 0; i < 3; i++)
		q[i + 1] = part*v[i];
}

double hawser__quaternion_log(double v[3], const double q[4])
{
	double length = sqrt(q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);
	double turn = 2.0*atan2(length, q[0]);
	double part = length > 0.0 ? turn/length : 2.0;

	for (int i = 0; i < 3; i++)
		v[i] = part*q[i + 1];
	return turn;
}

void hawser__quaternion_between(double c[4], const double a[4], const double b[4])
{
	const double back[4] = {a[0], -a[1], -a[2], -a[3]};

	hawser__quaternion_mul(c, back, b);
}

void hawser__quaternion_turn(double q[4], const double v[3])
{
	double by[4], to[4], length;

	hawser__quaternion_exp(by, v);
	hawser__quaternion_mul(to, q, by);
	length = sqrt(to[0]*to[0] + to[1]*to[1] + to[2]*to[2] + to[3]*to[3]);
	for (int i = 0; i < 4; i++)
		q[i] = to[i]/length;
}

void hawser__quaternion_matrix(double R[9], const double q[4])
{
	double w = q[0], x = q[1], y = q[2], z = q[3];

	R[0] = 1.0 - 2.0*(y*y + z*z);
	R[1] = 2.0*(x*y - w*z);
	R[2] = 2.0*(x*z + w*y);
	R[3] = 2.0*(x*y + w*z);
	R[4] = 1.0 - 2.0*(x*x + z*z);
	R[5] = 2.0*(y*z - w*x);
	R[6] = 2.0*(x*z - w*y);
	R[7] = 2.0*(y*z + w*x);
	R[8] = 1.0 - 2.0*(x*x + y*y);
}

/* Shepperd 1978: the largest of the four components first. */
void hawser__quaternion_of(double q[4], const double R[9])
{
	double trace = R[0] + R[4] + R[8], square[4] = {trace, R[0], R[4], R[8]}, length = 0.0;
	int most = 0;

	for (int i = 1; i < 4; i++)
		if (square[i] > square[most])
			most = i;
	if (most == 0) {
		q[0] = 1.0 + trace;
		q[1] = R[7] - R[5];
		q[2] = R[2] - R[6];
		q[3] = R[3] - R[1];
	} else {
		int i = most - 1, j = most % 3, k = (most + 1) % 3;

		q[0] = R[3*k + j] - R[3*j + k];
		q[i + 1] = 1.0 + 2.0*R[4*i] - trace;
		q[j + 1] = R[3*j + i] + R[3*i + j];
		q[k + 1] = R[3*k + i] + R[3*i + k];
	}
	for (int i = 0; i < 4; i++)
		length += q[i]*q[i];
	length = (q[0] < 0.0 ? -1.0 : 1.0)*sqrt(length);
	for (int i = 0; i < 4; i++)
		q[i] /= length;
}

static void series(struct hawser__so3 *at, double square)
{
	double a = 0.0, b = 0.0, da = 0.0, db = 0.0, c = 0.0, dc = 0.0;

	/* a = 1/2! - t^2/4! + .., b = 1/3! - t^2/5! + .., by Horner's rule in the factors of the
	 * factorials. */
	for (int k = TERMS; k >= 1; k--) {
		double after_a = 1.0/((2*k + 1)*(2*k + 2)), after_b = 1.0/((2*k + 2)*(2*k + 3));

		da = -after_a*(2*k*1.0 + square*da);
		db = -after_b*(2*k*1.0 + square*db);
		a = -after_a*(1.0 + a)*square;
		b = -after_b*(1.0 + b)*square;
	}
	at->a = 0.5*(1.0 + a);
	at->b = (1.0 + b)/6.0;
	at->da = 0.5*da;
	at->db = db/6.0;
	for (int k = BERNOULLI - 1; k >= 0; k--) {
		c = c*square + bernoulli[k];
		if (k > 0)
			dc = dc*square + 2*k*bernoulli[k];
	}
	at->c = c;
	at->dc = dc;
}

void hawser__so3_at(struct hawser__so3 *at, const double v[3])
{
	double square = hawser__dot(v, v), t = sqrt(square), s, c, u;

	for (int i = 0; i < 3; i++)
		at->v[i] = v[i];
	if (t <= SMALL) {
		series(at, square);
		return;
	}
	s = sin(t);
	c = cos(t);
	u = 0.5*t/tan(0.5*t);
	at->a = (1.0 - c)/square;
	at->b = (t - s)/(square*t);
	at->da = (s - 2.0*t*at->a)/(square*t);
	at->db = ((1.0 - c) - 3.0*t*t*at->b)/(square*square);
	at->c = (1.0 - u)/square;
	/* u' = u/t - t/(4 sin^2(t/2)), and 4 sin^2(t/2) = 2(1 - cos t) */
	at->dc = (-u + 0.5*square/(1.0 - c) - 2.0*(1.0 - u))/(square*square);
}

/* J = 1 + p v~ + q v~v~ */
static void matrix(double J[9], const double v[3], double p, double q)
{
	double square = hawser__dot(v, v);

	hawser__skew(J, v);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			J[3*i + j] = p*J[3*i + j] + q*v[i]*v[j];
	for (int i = 0; i < 3; i++)
		J[4*i] += 1.0 - q*square;
}

void hawser__so3_jr(double J[9], const struct hawser__so3 *at)
{
	matrix(J, at->v, -at->a, at->b);
}

void hawser__so3_ji(double J[9], const struct hawser__so3 *at)
{
	matrix(J, at->v, 0.5, at->c);
}

/* Derivative of u + p v x u + q v x (v x u), where p' = dp |v| and q' = dq |v|. */
static void derivative(double D[9], const double v[3], const double u[3], double p, double q,
                       double dp, double dq)
{
	double once[3], twice[3], along = hawser__dot(v, u);

	hawser__cross(once, v, u);
	hawser__cross(twice, v, once);
	hawser__skew(D, u);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			D[3*i + j] = -p*D[3*i + j] + (dp*once[i] + dq*twice[i])*v[j] +
			             q*(v[i]*u[j] - 2.0*u[i]*v[j]);
	for (int i = 0; i < 3; i++)
		D[4*i] += q*along;
}

void hawser__so3_djr_left(double D[9], const struct hawser__so3 *at, const double u[3])
{
	derivative(D, at->v, u, at->a, at->b, at->da, at->db);
}

void hawser__so3_dji_left(double D[9], const struct hawser__so3 *at, const double u[3])
{
	derivative(D, at->v, u, -0.5, at->c, 0.0, at->dc);
}

void hawser__so3_dji(double D[9], const struct hawser__so3 *at, const double u[3])
{
	derivative(D, at->v, u, 0.5, at->c, 0.0, at->dc);
}
