/* rod/element.c - strains, forces and tangent of an element of a geometrically exact rod.
 *
 *   psi = log(R1' R2), k = psi/h, Rm = R1 exp(psi/2), w = Rm'(x2 - x1)/h
 *   N = EA (w - w0), M = EI (k - k0), mu = h N x w
 *   a = M + Jr(psi/2)'mu/2
 *   f2 = -f1 = Rm N, m2 = Ji(psi)'a, m1 = exp(psi/2) mu - Ji(psi) a
 *
 * The relative rotation is interpolated, not a total rotation vector, which is neither objective nor
 * without singularities: a rigid turn leaves w and k as they are, by any angle and any number of
 * turns, and they depend on nothing but the two nodes (Crisfield and Jelenic 1999). With one point
 * there is no locking, and the error is of order h^2. m1 and m2 are in the sections' own axes, so
 * that K is symmetric only at an equilibrium with conservative loads.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "rod/mesh.h"
#include "rod/so3.h"

#define SMALL 1e-4 /* rad, of half an angle: series to 1e-17 */

int hawser__rod_strain(struct hawser__rod_strain *at, const struct hawser__rod_element *el,
                       const struct hawser__rod_node node[2])
{
	double between[4], middle[4], part, d[3];

	hawser__quaternion_between(between, node[0].q, node[1].q);
	(void)hawser__quaternion_log(at->psi, between);
	/* (1 + q)/|1 + q| is exp(psi/2), as q = exp(psi) */
	part = 1.0/sqrt(2.0 + 2.0*between[0]);
	for (int i = 0; i < 4; i++)
		at->half[i] = part*((i == 0) + between[i]);
	hawser__quaternion_mul(middle, node[0].q, at->half);
	hawser__quaternion_matrix(at->R, middle);
	for (int i = 0; i < 3; i++) {
		at->k[i] = at->psi[i]/el->h;
		d[i] = (node[1].x[i] - node[0].x[i])/el->h;
	}
	hawser__apply_left(at->w, at->R, d);
	for (int i = 0; i < 3; i++) {
		at->N[i] = el->EA[i]*(at->w[i] - el->w0[i]);
		at->M[i] = el->EI[i]*(at->k[i] - el->k0[i]);
	}
	return !(between[0] > 0.0);
}

/* At rest w0 is the mean of exp(k0 s) e1 over the length: what is along k0 stays, what is across it is
 * multiplied by S = sin(f/2)/(f/2), f = |k0| h. Returns S, and f dS/df. */
static double shorter(double *by, double f)
{
	double half = 0.5*f, S = half < SMALL ? 1.0 - half*half/6.0 : sin(half)/half;

	*by = half < SMALL ? -half*half/3.0 : cos(half) - S;
	return S;
}

void hawser__rod_stretch(struct hawser__rod_element *el, double h)
{
	double k = sqrt(hawser__dot(el->k0, el->k0)), by, S = shorter(&by, k*h);

	el->h = h;
	for (int i = 0; i < 3; i++)
		el->w0[i] = (i == 0 ? S : 0.0) + (k > 0.0 ? (1.0 - S)*el->k0[0]*el->k0[i]/(k*k) : 0.0);
}

void hawser__rod_strain_by_length(struct hawser__rod_strain *at, const struct hawser__rod_element *el)
{
	double k = sqrt(hawser__dot(el->k0, el->k0)), by;

	(void)shorter(&by, k*el->h);
	for (int i = 0; i < 3; i++) {
		double rest = (i == 0 ? by : 0.0) - (k > 0.0 ? by*el->k0[0]*el->k0[i]/(k*k) : 0.0);

		at->N[i] = -el->EA[i]*(at->w[i] + rest)/el->h;
		at->M[i] = -el->EI[i]*at->k[i]/el->h;
	}
}

double hawser__rod_energy_by_length(const struct hawser__rod_element *el,
                                    const struct hawser__rod_strain *at)
{
	struct hawser__rod_strain by = *at;
	double sum = 0.0;

	/* h W, and N . (w - w0) = (w - w0) . EA (w - w0), of which N' has half twice */
	hawser__rod_strain_by_length(&by, el);
	for (int i = 0; i < 3; i++)
		sum += (0.5*at->N[i] + el->h*by.N[i])*(at->w[i] - el->w0[i]) +
		       (0.5*at->M[i] + el->h*by.M[i])*(at->k[i] - el->k0[i]);
	return sum;
}

double hawser__rod_energy(const struct hawser__rod_element *el, const struct hawser__rod_strain *at)
{
	double sum = 0.0;

	for (int i = 0; i < 3; i++)
		sum += at->N[i]*(at->w[i] - el->w0[i]) + at->M[i]*(at->k[i] - el->k0[i]);
	return 0.5*el->h*sum;
}

/* What the tangent needs besides. */
struct parts {
	struct hawser__so3 half, whole; /* psi/2, psi */
	double Jh[9], Ji[9], E[9];      /* Jr(psi/2), Ji(psi), exp(psi/2) */
	double mu[3], a[3];
};

/* mu and a; half and whole get their values. */
static void share(struct parts *p, const struct hawser__rod_element *el,
                  const struct hawser__rod_strain *at)
{
	double half[3], once[3], twice[3];

	for (int i = 0; i < 3; i++)
		half[i] = 0.5*at->psi[i];
	hawser__so3_values(&p->half, half);
	hawser__so3_values(&p->whole, at->psi);
	hawser__cross(p->mu, at->N, at->w);
	for (int i = 0; i < 3; i++)
		p->mu[i] *= el->h;
	hawser__cross(once, half, p->mu);
	hawser__cross(twice, half, once);
	for (int i = 0; i < 3; i++)
		p->a[i] = at->M[i] + 0.5*(p->mu[i] + p->half.a*once[i] + p->half.b*twice[i]);
}

static void put(double *K, int row, int column, const double block[9], double factor)
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			K[(3*row + i)*HAWSER__ROD_PAIR + 3*column + j] = factor*block[3*i + j];
}

/* Matrices that do not depend on which node moves. */
struct tangent {
	const struct parts *p;
	double Q[9];        /* derivative of mu over w */
	double JQ[9], EQ[9]; /* Jr(psi/2)'Q/2, exp(psi/2)Q */
	double Da[9];       /* of psi: part of the derivative of a */
	double D2[9], D1[9]; /* of psi: parts of those of m2 and m1 */
	double ws[9], Ns[9]; /* skew matrices of w and N */
};

static void prepare(struct tangent *t, const struct parts *p, const struct hawser__rod_element *el,
                    const struct hawser__rod_strain *at)
{
	double part[9], mu[9];

	t->p = p;
	hawser__skew(t->ws, at->w);
	hawser__skew(t->Ns, at->N);
	for (int i = 0; i < 9; i++)
		t->Q[i] = el->h*(t->Ns[i] - t->ws[i]*el->EA[i % 3]);
	hawser__mul_left(t->JQ, p->Jh, t->Q);
	hawser__mul(t->EQ, p->E, t->Q);
	hawser__so3_djr_left(t->Da, &p->half, p->mu);
	for (int i = 0; i < 9; i++) {
		t->JQ[i] *= 0.5;
		t->Da[i] = 0.25*t->Da[i] + (i % 4 == 0 ? el->EI[i/4]/el->h : 0.0);
	}
	hawser__so3_dji_left(t->D2, &p->whole, p->a);
	hawser__so3_dji(t->D1, &p->whole, p->a);
	hawser__skew(mu, p->mu);
	hawser__mul(part, mu, p->Jh);
	hawser__mul(mu, p->E, part);
	for (int i = 0; i < 9; i++)
		t->D1[i] = -0.5*mu[i] - t->D1[i];
}

/* Columns of the turn of node `n`: P is the derivative of psi, T that of the turn of the middle. */
static void turns(double *K, const struct tangent *t, const struct hawser__rod_element *el,
                  const struct hawser__rod_strain *at, int n, const double P[9], const double T[9])
{
	double W[9], A[9], B[9], part[9], f[9], m[9];

	hawser__mul(W, t->ws, T);
	hawser__mul(part, t->Ns, T);
	for (int i = 0; i < 9; i++)
		part[i] = el->EA[i/3]*W[i] - part[i];
	hawser__mul(f, at->R, part);
	put(K, 0, 2*n + 1, f, -1.0);
	put(K, 2, 2*n + 1, f, 1.0);
	hawser__mul(A, t->JQ, W);
	hawser__mul(B, t->Da, P);
	for (int i = 0; i < 9; i++)
		A[i] += B[i];
	hawser__mul_left(m, t->p->Ji, A);
	hawser__mul(part, t->D2, P);
	for (int i = 0; i < 9; i++)
		m[i] += part[i];
	put(K, 3, 2*n + 1, m, 1.0);
	hawser__mul(m, t->EQ, W);
	hawser__mul(B, t->D1, P);
	hawser__mul(part, t->p->Ji, A);
	for (int i = 0; i < 9; i++)
		m[i] += B[i] - part[i];
	put(K, 1, 2*n + 1, m, 1.0);
}

/* Columns of the places of both nodes. */
static void places(double *K, const struct tangent *t, const struct hawser__rod_element *el,
                   const struct hawser__rod_strain *at)
{
	double W[9], A[9], part[9], f[9], m[9];

	for (int i = 0; i < 9; i++)
		W[i] = at->R[3*(i % 3) + i/3]/el->h;
	for (int i = 0; i < 9; i++)
		part[i] = el->EA[i/3]*W[i];
	hawser__mul(f, at->R, part);
	for (int n = 0; n < 2; n++) {
		put(K, 0, 2*n, f, n ? -1.0 : 1.0);
		put(K, 2, 2*n, f, n ? 1.0 : -1.0);
	}
	hawser__mul(A, t->JQ, W);
	hawser__mul_left(m, t->p->Ji, A);
	put(K, 3, 2, m, 1.0);
	put(K, 3, 0, m, -1.0);
	hawser__mul(m, t->EQ, W);
	hawser__mul(part, t->p->Ji, A);
	for (int i = 0; i < 9; i++)
		m[i] -= part[i];
	put(K, 1, 2, m, 1.0);
	put(K, 1, 0, m, -1.0);
}

static void tangent(double *K, struct parts *p, const struct hawser__rod_element *el,
                    const struct hawser__rod_strain *at)
{
	struct tangent t;
	double P[9], T[9];

	hawser__so3_derivatives(&p->half);
	hawser__so3_derivatives(&p->whole);
	hawser__so3_jr(p->Jh, &p->half);
	hawser__so3_ji(p->Ji, &p->whole);
	hawser__quaternion_matrix(p->E, at->half);
	prepare(&t, p, el, at);
	places(K, &t, el, at);
	for (int i = 0; i < 9; i++)
		P[i] = -p->Ji[3*(i % 3) + i/3];
	hawser__mul(T, p->Jh, P);
	for (int i = 0; i < 9; i++)
		T[i] = 0.5*T[i] + p->E[3*(i % 3) + i/3];
	turns(K, &t, el, at, 0, P, T);
	hawser__mul(T, p->Jh, p->Ji);
	for (int i = 0; i < 9; i++)
		T[i] *= 0.5;
	turns(K, &t, el, at, 1, p->Ji, T);
}

void hawser__rod_forces(double *f, double *K, const struct hawser__rod_element *el,
                        const struct hawser__rod_strain *at)
{
	struct parts p;
	double once[3], twice[3], turned[3], again[3];

	share(&p, el, at);
	hawser__apply(f + 6, at->R, at->N);
	hawser__cross(once, at->psi, p.a);
	hawser__cross(twice, at->psi, once);
	hawser__cross(turned, at->half + 1, p.mu);
	hawser__cross(again, at->half + 1, turned);
	for (int i = 0; i < 3; i++) {
		f[i] = -f[6 + i];
		f[9 + i] = p.a[i] - 0.5*once[i] + p.whole.c*twice[i];
		f[3 + i] = p.mu[i] + 2.0*(at->half[0]*turned[i] + again[i]) -
		           (p.a[i] + 0.5*once[i] + p.whole.c*twice[i]);
	}
	if (K)
		tangent(K, &p, el, at);
}
