/* net/statics/catenary.c - see net/statics/catenary.h.
 *
 * u, h   components of F along p and across it
 * e      |p|*L/2, so that the component of t along p is u + e at S = 0 and u - e at S = L
 * k      sqrt(h^2 + soft^2)
 * T1, T2 tensions at S = 0 and S = L
 * a      integral of 1/T: (asinh((u + e)/k) - asinh((u - e)/k))/|p|
 *
 * Everything is written without division by |p| and without differences of close numbers, so that a
 * string of no weight and a deep catenary go through the same formulas.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>

#include "core/vec3.h"
#include "net/statics/catenary.h"

/* The integrals, and the directions they belong to. */
struct parts {
	double along[3], across[3]; /* unit vectors: of p, and of the part of F across it */
	double u, h, k2, T1, T2, a;
	double A, B, C; /* second derivatives: along along, along across, across across */
};

/* Unit vectors along p and across it. Without p, along F; without either, any. */
static void directions(struct parts *s, const double p[3], const double F[3])
{
	double w = sqrt(hawser__dot(p, p)), f = sqrt(hawser__dot(F, F)), least;
	int axis = 0;

	for (int k = 0; k < 3; k++)
		s->along[k] = w > 0.0 ? p[k]/w : f > 0.0 ? F[k]/f : k == 1;
	s->u = hawser__dot(F, s->along);
	for (int k = 0; k < 3; k++)
		s->across[k] = F[k] - s->u*s->along[k];
	s->u += hawser__dot(s->across, s->along); /* what round-off left */
	s->h = sqrt(hawser__dot(s->across, s->across));
	if (s->h > 1e-14*f) {
		for (int k = 0; k < 3; k++)
			s->across[k] /= s->h;
		return;
	}
	s->h = 0.0;
	for (int k = 1; k < 3; k++)
		axis = fabs(s->along[k]) < fabs(s->along[axis]) ? k : axis;
	least = s->along[axis];
	for (int k = 0; k < 3; k++)
		s->across[k] = ((k == axis) - least*s->along[k])/sqrt(1.0 - least*least);
}

static void integrals(struct parts *s, const struct hawser__net_catenary *cable, const double F[3])
{
	double L = cable->length0, e, u, v, x, z, X, sum, product;

	directions(s, cable->p, F);
	e = sqrt(hawser__dot(cable->p, cable->p))*L/2.0;
	s->k2 = s->h*s->h + cable->soft*cable->soft;
	s->k2 = fmax(s->k2, 1e-200*fmax(1.0, e*e));
	s->T1 = sqrt(s->k2 + (s->u + e)*(s->u + e));
	s->T2 = sqrt(s->k2 + (s->u - e)*(s->u - e));
	sum = s->T1 + s->T2;
	product = s->T1*s->T2;
	u = fabs(s->u); /* a, A and C are even in u */
	v = u - e;
	x = sqrt(s->k2 + v*v);
	x = (1.0 + 2.0*u/sum)/(v >= 0.0 ? v + x : s->k2/(x - v));
	z = 2.0*e*x;
	s->a = L*x*(z > 1e-8 ? log1p(z)/z : 1.0 - z/2.0);
	X = u > e ? s->k2*(s->k2 + 2.0*(u*u + e*e))/(product + (u - e)*(u + e))
	          : product + (e - u)*(e + u);
	s->A = L*(s->k2 + X)/(sum*product);
	s->B = -2.0*s->h*s->u*L/(sum*product);
	s->C = fmax(s->a - s->h/s->k2*s->h*s->A, 0.0);
}

static double spring(double chord[3], double (*flexibility)[3], double density, const double F[3])
{
	for (int i = 0; chord && i < 3; i++)
		chord[i] = F[i]/density;
	for (int i = 0; flexibility && i < 3; i++)
		for (int j = 0; j < 3; j++)
			flexibility[i][j] = i == j ? 1.0/density : 0.0;
	return hawser__dot(F, F)/(2.0*density);
}

double hawser__catenary(double chord[3], double (*flexibility)[3],
                        const struct hawser__net_catenary *cable, const double F[3])
{
	double L = cable->length0, e = sqrt(hawser__dot(cable->p, cable->p))*L/2.0, sum;
	struct parts s;

	if (cable->density > 0.0)
		return spring(chord, flexibility, cable->density, F);
	integrals(&s, cable, F);
	sum = s.T1 + s.T2;
	for (int i = 0; chord && i < 3; i++)
		chord[i] = 2.0*s.u*L/sum*s.along[i] + s.h*s.a*s.across[i] + F[i]*(L/cable->EA);
	for (int i = 0; flexibility && i < 3; i++)
		for (int j = 0; j < 3; j++)
			flexibility[i][j] = (i == j ? s.a + L/cable->EA : 0.0) +
				(s.A - s.a)*s.along[i]*s.along[j] + (s.C - s.a)*s.across[i]*s.across[j] +
				s.B*(s.along[i]*s.across[j] + s.across[i]*s.along[j]);
	return L*(s.u*(s.u/sum) + sum/4.0) + s.k2*s.a/2.0 + L/(2.0*cable->EA)*(hawser__dot(F, F) + e*e/3.0);
}

double hawser__catenary_stretch(const struct hawser__net_catenary *cable, const double F[3])
{
	struct parts s;

	integrals(&s, cable, F);
	return (cable->length0*(s.u*(s.u/(s.T1 + s.T2)) + (s.T1 + s.T2)/4.0) + s.k2*s.a/2.0)/cable->EA;
}

void hawser__catenary_stiffness(double stiffness[3][3], const struct hawser__net_catenary *cable,
                                const double F[3])
{
	double c = cable->length0/cable->EA, most, determinant, n, A, B, C;
	struct parts s;

	if (cable->density > 0.0) {
		for (int i = 0; i < 3; i++)
			for (int j = 0; j < 3; j++)
				stiffness[i][j] = i == j ? cable->density : 0.0;
		return;
	}
	integrals(&s, cable, F);
	/* Of the flexibility without c; what round-off leaves of a difference must not be negative. */
	determinant = s.A*s.C - s.B*s.B;
	most = s.A + s.C;
	determinant = fmax(determinant, 0.0) + c*most + c*c;
	A = (s.C + c)/determinant;
	B = -s.B/determinant;
	C = (s.A + c)/determinant;
	n = 1.0/(s.a + c);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			stiffness[i][j] = (i == j ? n : 0.0) + (A - n)*s.along[i]*s.along[j] +
				(C - n)*s.across[i]*s.across[j] +
				B*(s.along[i]*s.across[j] + s.across[i]*s.along[j]);
}

void hawser__catenary_point(double x[3], double t[3], const struct hawser__net_catenary *cable,
                            const double F[3], double S)
{
	struct hawser__net_catenary part = *cable;
	double mean[3];

	part.length0 = S;
	for (int k = 0; k < 3; k++) {
		t[k] = F[k] + cable->p[k]*(cable->length0/2.0 - S);
		mean[k] = F[k] + cable->p[k]*(cable->length0 - S)/2.0;
		x[k] = 0.0;
	}
	if (S > 0.0)
		hawser__catenary(x, NULL, &part, mean);
}
