/* rod/so3.c - see so3.h.
 *
 *   a = (1 - cos t)/t^2, b = (t - sin t)/t^3, c = (1 - (t/2) cot(t/2))/t^2, t = |v|
 *
 * and their derivatives over t, which cancel near 0: Taylor series in t^2 up to t = 1, whose first
 * term left out is below round-off there; closed forms beyond, where no more than two digits cancel.
 * Most elements and steps turn by less than a tenth of a radian, for which six terms are enough: these
 * series take much of the time of a motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "rod/so3.h"

#define SMALL 1.0  /* rad^2, largest of the long series: 1/22! and (1/2pi)^22 are below round-off */
#define TINY 0.01  /* rad^2, largest of the short ones: TINY^6/14!, (TINY/39)^6, (TINY/4)^6/13 are */
enum { LONG = 10, SHORT = 6, BERNOULLI = 11, SINES = 9, ARCS = 6 }; /* terms */
/* 1/(k + 2)! with signs: cos, then sin. */
static const double of_a[LONG] = {
	1.0/2.0, -1.0/24.0, 1.0/720.0, -1.0/40320.0, 1.0/3628800.0, -1.0/479001600.0, 1.0/87178291200.0,
	-1.0/20922789888000.0, 1.0/6402373705728000.0, -1.0/2432902008176640000.0};
static const double of_b[LONG] = {
	1.0/6.0, -1.0/120.0, 1.0/5040.0, -1.0/362880.0, 1.0/39916800.0, -1.0/6227020800.0,
	1.0/1307674368000.0, -1.0/355687428096000.0, 1.0/121645100408832000.0,
	-1.0/51090942171709440000.0};
/* Of atan(x)/x, with alternating signs. */
static const double of_arc[ARCS] = {1.0, 1.0/3.0, 1.0/5.0, 1.0/7.0, 1.0/9.0, 1.0/11.0};
/* Of c: |B_2k|/(2k)!, k = 1, 2, .., with Bernoulli's numbers B. */
static const double of_c[BERNOULLI] = {
	1.0/12.0, 1.0/720.0, 1.0/30240.0, 1.0/1209600.0, 1.0/47900160.0, 691.0/1307674368000.0,
	1.0/74724249600.0, 3617.0/10670622842880000.0, 43867.0/5109094217170944000.0,
	174611.0/802857662698291200000.0, 77683.0/14101100039391805440000.0};

void hawser__quaternion_exp(double q[4], const double v[3])
{
	double square = 0.25*hawser__dot(v, v), part = 0.0;

	if (square <= 0.25*SMALL) {
		double cosine = 0.0;

		for (int k = (square <= 0.25*TINY ? SHORT : SINES) - 1; k >= 0; k--) {
			cosine = cosine*square + of_a[k];
			part = part*square + of_b[k];
		}
		q[0] = 1.0 - square*cosine;
		part = 0.5 - 0.5*square*part;
	} else {
		double half = sqrt(square);

		q[0] = cos(half);
		part = 0.5*sin(half)/half;
	}
	for (int i = 0; i < 3; i++)
		q[i + 1] = part*v[i];
}

double hawser__quaternion_log(double v[3], const double q[4])
{
	double square = q[1]*q[1] + q[2]*q[2] + q[3]*q[3], length = sqrt(square), part;

	if (q[0] > 0.0 && square <= 0.25*TINY*q[0]*q[0]) {
		double u = square/(q[0]*q[0]), sum = 0.0;

		for (int k = ARCS - 1; k >= 0; k--)
			sum = of_arc[k] - u*sum;
		part = 2.0*sum/q[0];
	} else {
		part = length > 0.0 ? 2.0*atan2(length, q[0])/length : 2.0;
	}
	for (int i = 0; i < 3; i++)
		v[i] = part*q[i + 1];
	return part*length;
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

void hawser__so3_values(struct hawser__so3 *at, const double v[3])
{
	double square = hawser__dot(v, v), t, a = 0.0, b = 0.0, c = 0.0;

	for (int i = 0; i < 3; i++)
		at->v[i] = v[i];
	if (square > SMALL) {
		t = sqrt(square);
		at->a = (1.0 - cos(t))/square;
		at->b = (t - sin(t))/(square*t);
		at->c = (1.0 - 0.5*t/tan(0.5*t))/square;
		return;
	}
	if (square > TINY)
		c = of_c[BERNOULLI - 1];
	for (int k = (square <= TINY ? SHORT : LONG) - 1; k >= 0; k--) {
		a = a*square + of_a[k];
		b = b*square + of_b[k];
		c = c*square + of_c[k];
	}
	at->a = a;
	at->b = b;
	at->c = c;
}

void hawser__so3_derivatives(struct hawser__so3 *at)
{
	double square = hawser__dot(at->v, at->v), t, one, u, a = 0.0, b = 0.0, c = 0.0;

	if (square > SMALL) {
		t = sqrt(square);
		one = square*at->a;     /* 1 - cos t */
		u = 1.0 - square*at->c; /* u' = u/t - t/(4 sin^2(t/2)), and 4 sin^2(t/2) = 2(1 - cos t) */
		at->da = (sin(t) - 2.0*t*at->a)/(square*t);
		at->db = (one - 3.0*square*at->b)/(square*square);
		at->dc = (-u + 0.5*square/one - 2.0*(1.0 - u))/(square*square);
		return;
	}
	if (square > TINY)
		c = 2*(BERNOULLI - 1)*of_c[BERNOULLI - 1];
	for (int k = (square <= TINY ? SHORT : LONG) - 1; k >= 1; k--) {
		a = a*square + 2*k*of_a[k];
		b = b*square + 2*k*of_b[k];
		c = c*square + 2*k*of_c[k];
	}
	at->da = a;
	at->db = b;
	at->dc = c;
}

void hawser__so3_at(struct hawser__so3 *at, const double v[3])
{
	hawser__so3_values(at, v);
	hawser__so3_derivatives(at);
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
