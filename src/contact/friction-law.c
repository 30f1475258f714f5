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

/* F at z, whose r is given; with D not NULL also the derivatives of r - F by z. */
static void law(double F[3], double *D, const struct hawser__friction_touch *touch, double sigma,
                const double r[3], const double z[3])
{
	double dp, by_kappa, p = maximum(&dp, z[0], 0.0, sigma), kappa, m;

	if (sigma == 0.0 && z[0] <= 0.0)
		p = dp = 0.0;
	kappa = touch->mu*p;
	m = maximum(&by_kappa, kappa, length2(z[1], z[2]), sigma);
	F[0] = r[0] - p;
	for (int k = 1; k < 3; k++)
		F[k] = touch->fixed & 1U << k ? 0.0 : r[k] - (m > 0.0 ? kappa*z[k]/m : 0.0);
	if (D)
		slopes(D, z, touch->mu, dp, kappa, m, by_kappa);
}

double hawser__touch_law(double F[3], const struct hawser__friction_touch *touch, double sigma)
{
	double z[3];

	for (int k = 0; k < 3; k++)
		z[k] = touch->r[k] - touch->rho*touch->w[k];
	law(F, NULL, touch, sigma, touch->r, z);
	return F[0]*F[0] + F[1]*F[1] + F[2]*F[2];
}

/* Cr and Cu of D. */
static void derivatives(struct hawser__touch_rows *rows, const struct hawser__friction_touch *touch,
                        const double D[9])
{
	for (int i = 0; i < 9; i++) {
		rows->Cr[i] = (i%4 == 0 ? 1.0 : 0.0) - D[i];
		rows->Cu[i] = touch->rho*D[i];
	}
	for (int i = 1; i < 3; i++)
		for (int j = 0; j < 3 && touch->fixed & 1U << i; j++) {
			rows->Cr[3*i + j] = 0.0;
			rows->Cu[3*i + j] = i == j ? touch->rho : 0.0;
		}
}

void hawser__touch_linearise(struct hawser__touch_rows *rows,
                             const struct hawser__friction_touch *touch,
                             double sigma, const double *from)
{
	const double *r = from ? from : touch->r, *w = from ? from + 3 : touch->w;
	double z[3], D[9];

	for (int k = 0; k < 3; k++)
		z[k] = r[k] - touch->rho*w[k];
	law(rows->G, D, touch, sigma, r, z);
	derivatives(rows, touch, D);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			double by_r = 0.0, by_w = 0.0;

			for (int k = 0; k < 3; k++) {
				by_r += rows->Cr[3*i + k]*touch->H[3*k + j];
				by_w += rows->Cu[3*i + k]*touch->H[3*k + j];
			}
			rows->CrH[3*i + j] = by_r;
			rows->CuH[3*i + j] = by_w;
		}
	for (int i = 0; i < 3 && from; i++)
		for (int k = 0; k < 3; k++)
			rows->G[i] += rows->Cr[3*i + k]*(touch->r[k] - r[k]) +
			              rows->Cu[3*i + k]*(touch->w[k] - w[k]);
}

const double *hawser__step_from(const struct hawser__step_law *law, const struct hawser_friction *of,
                                int contact)
{
	return law->elsewhere ? of->from[contact] : NULL;
}

enum hawser_contact_state hawser__touch_state(const struct hawser__friction_touch *touch)
{
	const double rho = touch->rho, kappa = touch->mu*(touch->r[0] - rho*touch->w[0]);
	double tangent = hypot(touch->r[1] - rho*touch->w[1], touch->r[2] - rho*touch->w[2]);

	if (touch->r[0] - rho*touch->w[0] <= 0.0)
		return HAWSER_CONTACT_OPEN;
	return tangent <= kappa && kappa > 0.0 ? HAWSER_CONTACT_STICK : HAWSER_CONTACT_SLIP;
}
