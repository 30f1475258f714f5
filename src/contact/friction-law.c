/* contact/friction-law.c - the law of a contact as an equation F(r, w) = 0, and its derivatives.
 *
 * z    r - rho w, components N and T
 * p    max(z_N, 0); kappa = mu p
 * m    max(kappa, |z_T|), so that kappa z_T/m is z_T projected on the disc of radius kappa
 *
 * Alart and Curnier (1991): F_N = r_N - p, F_T = r_T - kappa z_T/m. F is 0 exactly where Signorini's
 * and Coulomb's laws hold, for any rho > 0. Both maxima are smoothed by sigma,
 *   max(a, b) = (a + b + sqrt((a - b)^2 + 4 sigma^2))/2,
 * which gives r_N rho w_N = sigma^2 (Chen and Harker 1993, Kanzow 1996): along the path sigma -> 0 many
 * contacts change their state at once, while with sigma = 0 and a stiff cable the border of a slipping
 * zone moves by one node an iteration.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "contact/friction.h"

static double length2(double a, double b)
{
	return sqrt(a*a + b*b);
}

/* max(a, b) smoothed; da: its derivative by a. */
static double maximum(double *da, double a, double b, double sigma)
{
	double root = sqrt((a - b)*(a - b) + 4.0*sigma*sigma);

	*da = root > 0.0 ? 0.5*(1.0 + (a - b)/root) : 1.0;
	return 0.5*(a + b + root);
}

/* Derivatives of F by z_N (one number a row) and z_T: D row-major 3x3. */
static void slopes(double D[9], const double z[3], double mu, double dp, double kappa, double m,
                   double by_kappa)
{
	double length = length2(z[1], z[2]), factor = m > 0.0 ? kappa/m : 0.0;
	double along = m > 0.0 && length > 0.0 ? factor*(1.0 - by_kappa)/(m*length) : 0.0;
	double on = m > 0.0 ? (1.0 - factor*by_kappa)/m*mu*dp : 0.0;

	memset(D, 0, 9*sizeof *D);
	D[0] = dp;
	for (int i = 1; i < 3; i++) {
		D[3*i] = z[i]*on;
		for (int j = 1; j < 3; j++)
			D[3*i + j] = (i == j ? factor : 0.0) - along*z[i]*z[j];
	}
}

void hawser__touch_law(struct hawser__touch *touch, double sigma, int derivatives)
{
	const double rho = touch->rho;
	double z[3], dp, by_kappa, p, kappa, m, D[9];

	for (int k = 0; k < 3; k++)
		z[k] = touch->r[k] - rho*touch->w[k];
	p = maximum(&dp, z[0], 0.0, sigma);
	if (sigma == 0.0 && z[0] <= 0.0)
		p = dp = 0.0;
	kappa = touch->mu*p;
	m = maximum(&by_kappa, kappa, length2(z[1], z[2]), sigma);
	touch->F[0] = touch->r[0] - p;
	for (int k = 1; k < 3; k++)
		touch->F[k] = touch->r[k] - (m > 0.0 ? kappa*z[k]/m : 0.0);
	for (int k = 1; k < 3; k++)
		if (touch->fixed & 1U << k)
			touch->F[k] = 0.0;
	if (!derivatives)
		return;
	slopes(D, z, touch->mu, dp, kappa, m, by_kappa);
	for (int i = 0; i < 9; i++) {
		touch->Cr[i] = (i%4 == 0 ? 1.0 : 0.0) - D[i];
		touch->Cu[i] = rho*D[i];
	}
	for (int i = 1; i < 3; i++)
		if (touch->fixed & 1U << i)
			for (int j = 0; j < 3; j++) {
				touch->Cr[3*i + j] = 0.0;
				touch->Cu[3*i + j] = i == j ? rho : 0.0;
			}
}

enum hawser_contact_state hawser__touch_state(const struct hawser__touch *touch)
{
	const double rho = touch->rho, kappa = touch->mu*(touch->r[0] - rho*touch->w[0]);
	double tangent = hypot(touch->r[1] - rho*touch->w[1], touch->r[2] - rho*touch->w[2]);

	if (touch->r[0] - rho*touch->w[0] <= 0.0)
		return HAWSER_CONTACT_OPEN;
	return tangent <= kappa && kappa > 0.0 ? HAWSER_CONTACT_STICK : HAWSER_CONTACT_SLIP;
}

double hawser__touch_error(struct hawser__touch *touch)
{
	hawser__touch_law(touch, 0.0, 0);
	return sqrt(touch->F[0]*touch->F[0] + touch->F[1]*touch->F[1] + touch->F[2]*touch->F[2]);
}
