/* ropeway/expand/expand_ends.c - the energy of the points at which the rope meets a circle.
 *
 *   U, phi      displacement along the circle, and change of slope of the free rope there
 *   kappa       curvature of the circle, signed as that of the rope: -side/R
 *   gap         kappa minus the curvature of the free rope
 *   psi         phi - kappa U, by which the free rope turns away from the circle
 *   X           where the free rope begins (or ends) if it is continued to the material point that
 *               left the circle in the statics
 *
 * The point at which the rope leaves the circle moves by p = psi/gap. Its continuation back to the
 * material point is the involute of the circle, X = C(U + p) - p C'(U + p), along which the rope
 * has the same energy as on its true path. To third order, in the frame of the circle,
 *
 *   X_n = kappa U^2/2 - psi^2/(2 gap),   X_t = U - kappa^2 U^3/6 + psi^3/(3 gap) + kappa/gap psi^2
 *   U/2
 *
 * and the energy is that of the free rope whose end is moved there: F.X of the tension at its end,
 * with minus where it begins. The groove holds the rope aside up to where it leaves the circle, so
 * that with the slope chi it has z = - chi p at the material point, and X_t has p chi^2/2 more.
 * (doc/theory-ropeway-response.md)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ropeway/expand/expand.h"

static double at(const struct hawser__lexpand_end *end, enum hawser__lexpand_form form, int j)
{
	return end->form[form][j];
}

/* Third derivative of the product of three forms. */
static double three(const struct hawser__lexpand_end *end, const enum hawser__lexpand_form form[3],
                    const int index[3])
{
	double sum = 0.0;

	for (int a = 0; a < 3; a++)
		for (int b = 0; b < 3; b++)
			if (a != b)
				sum += at(end, form[0], index[a])*at(end, form[1], index[b])*
				       at(end, form[2], index[3 - a - b]);
	return sum;
}

/* Fourth derivative of the product of one form and three others. */
static double four(const struct hawser__lexpand_end *end, enum hawser__lexpand_form first,
                   const enum hawser__lexpand_form form[3], const int index[4])
{
	double sum = 0.0;

	for (int a = 0; a < 4; a++) {
		int rest[3], r = 0;

		for (int b = 0; b < 4; b++)
			if (b != a)
				rest[r++] = index[b];
		sum += at(end, first, index[a])*three(end, form, rest);
	}
	return sum;
}

static const enum hawser__lexpand_form UUU[3] = {HAWSER__FORM_U, HAWSER__FORM_U, HAWSER__FORM_U};
static const enum hawser__lexpand_form OOO[3] = {HAWSER__FORM_OPENING, HAWSER__FORM_OPENING,
                                                 HAWSER__FORM_OPENING};
static const enum hawser__lexpand_form OOU[3] = {HAWSER__FORM_OPENING, HAWSER__FORM_OPENING,
                                                 HAWSER__FORM_U};
static const enum hawser__lexpand_form AAO[3] = {HAWSER__FORM_ASIDE, HAWSER__FORM_ASIDE,
                                                 HAWSER__FORM_OPENING};
static const enum hawser__lexpand_form NUU[3] = {HAWSER__FORM_ACROSS, HAWSER__FORM_U, HAWSER__FORM_U};

static double sign_of(const struct hawser__lexpand_end *end)
{
	return end->end ? 1.0 : -1.0;
}

static int moves(const struct hawser__lexpand *t, const struct hawser__lexpand_end *end)
{
	return end->smooth && !t->held;
}

static double end_third(const struct hawser__lexpand *t, const struct hawser__lexpand_end *end,
                        const int index[3])
{
	double kappa = end->kappa, sum;

	sum = -end->along*kappa*kappa/6.0*three(end, UUU, index) + 0.5*kappa*three(end, NUU, index);
	if (moves(t, end))
		sum += -end->T/(6.0*end->gap)*three(end, OOO, index) -
		       0.5*end->T/end->gap*three(end, AAO, index);
	return sign_of(end)*sum;
}

static double end_fourth(const struct hawser__lexpand *t, const struct hawser__lexpand_end *end,
                         const int index[4])
{
	double kappa = end->kappa, sum;

	sum = -end->across*kappa*kappa*kappa/24.0*four(end, HAWSER__FORM_U, UUU, index) -
	      kappa*kappa/6.0*four(end, HAWSER__FORM_ALONG, UUU, index);
	if (moves(t, end))
		sum += four(end, HAWSER__FORM_ALONG, OOO, index)/(3.0*end->gap) +
		       0.5*kappa/end->gap*four(end, HAWSER__FORM_ALONG, OOU, index) +
		       0.5*four(end, HAWSER__FORM_ALONG, AAO, index)/end->gap;
	return sign_of(end)*sum;
}

double hawser__lexpand_ends_third(const struct hawser__lexpand *t, int j, int k, int l)
{
	const int index[3] = {j, k, l};
	double sum = 0.0;

	for (int i = 0; i < t->ends; i++)
		sum += end_third(t, &t->end[i], index);
	for (int i = 0; i < t->weights; i++)
		sum += t->mass[i].third*t->mass[i].u[j]*t->mass[i].u[k]*t->mass[i].u[l];
	return sum;
}

double hawser__lexpand_ends_fourth(const struct hawser__lexpand *t, const int index[4])
{
	double sum = 0.0;

	for (int i = 0; i < t->ends; i++)
		sum += end_fourth(t, &t->end[i], index);
	for (int i = 0; i < t->weights; i++) {
		const double *u = t->mass[i].u;

		sum += t->mass[i].fourth*u[index[0]]*u[index[1]]*u[index[2]]*u[index[3]];
	}
	return sum;
}

void hawser__lexpand_lift(double lift[2], const struct hawser__lexpand *t,
                          const struct hawser__lexpand_end *end, int j, int k)
{
	double Uj = at(end, HAWSER__FORM_U, j), Uk = at(end, HAWSER__FORM_U, k);

	lift[0] = end->kappa*Uj*Uk;
	lift[1] = 0.0;
	if (!moves(t, end))
		return;
	lift[0] -= (at(end, HAWSER__FORM_OPENING, j)*at(end, HAWSER__FORM_OPENING, k) +
	            at(end, HAWSER__FORM_ASIDE, j)*at(end, HAWSER__FORM_ASIDE, k))/end->gap;
	lift[1] = -(at(end, HAWSER__FORM_ASIDE, j)*at(end, HAWSER__FORM_OPENING, k) +
	            at(end, HAWSER__FORM_ASIDE, k)*at(end, HAWSER__FORM_OPENING, j))/end->gap;
}

double hawser__lexpand_push(const struct hawser__lexpand *t, const struct hawser__lexpand_end *end,
                            int j, int k)
{
	double Uj = at(end, HAWSER__FORM_U, j), Uk = at(end, HAWSER__FORM_U, k), kappa = end->kappa;
	double energy = -end->along*kappa*kappa*Uj*Uk +
		kappa*(at(end, HAWSER__FORM_ACROSS, j)*Uk + at(end, HAWSER__FORM_ACROSS, k)*Uj);

	if (moves(t, end))
		energy += end->T*kappa/end->gap*(at(end, HAWSER__FORM_OPENING, j)*
		                                 at(end, HAWSER__FORM_OPENING, k) +
		                                 at(end, HAWSER__FORM_ASIDE, j)*at(end, HAWSER__FORM_ASIDE, k));
	return -sign_of(end)*energy;
}
