/* response/balance_error.c - how far a corrected orbit is from the true branch.
 *
 *   r   defects of the orbit y; those of the active pairs are what the corrector left, the others
 *       tell what is missing
 *   d   the missing pairs' first-order answers to their defects (balance_active.c)
 *
 * The orbit y + d leaves other defects r' to the active pairs; the equations of these, solved once
 * more, say by how much they would move. The norm of the inverse Jacobian times that of the defects
 * would be a bound, and a useless one: the matrix has the narrow resonances of every harmonic with
 * every lightly damped coordinate in it, and overstates the error of a full-order orbit by up to
 * 1e5. What it is still wanted for is round-off: a matrix that is nearly singular determines
 * nothing, however small the defects.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "response/balance.h"

#define ESTIMATE_RESIDUAL 1e-2
#define ROUND_OFF 4e-15

/* at += d. Returns |d|^2, as a state's. */
static double add_missing(struct hawser__balance *balance, int order)
{
	int n = balance->base.n;
	double omega = balance->at[balance->base.size - 1], sum = 0.0;

	for (int h = 0; h <= balance->reach; h++)
		for (int j = 0; j < n; j++) {
			double answer[2];

			if (h <= balance->order && balance->active[h*n + j])
				continue;
			sum += pow(hawser__balance_missing(balance, answer, h, j, omega), 2);
			if (h > order)
				continue;
			balance->at[hawser__cos(n, h, j)] = answer[0];
			if (h)
				balance->at[hawser__sin(n, h, j)] = answer[1];
		}
	return sum;
}

static void swap(double **a, double **b)
{
	double *keep = *a;

	*a = *b;
	*b = keep;
}

/* Defects of the orbit with the missing pairs, in other_defect; the orbit and its samples are as
 * they were. */
static double complete(struct hawser__balance *balance)
{
	size_t size = (size_t)balance->base.size*sizeof(double);
	int order = balance->reach < balance->top ? balance->reach : balance->top;
	double missing;

	memcpy(balance->kept, balance->at, size);
	missing = add_missing(balance, order);
	swap(&balance->defect, &balance->other_defect);
	swap(&balance->base.samples, &balance->other_samples);
	hawser__balance_defects(balance, order);
	swap(&balance->defect, &balance->other_defect);
	swap(&balance->base.samples, &balance->other_samples);
	memcpy(balance->at, balance->kept, size);
	return missing;
}

double hawser__balance_error(struct hawser__orbit *orbit, double residual)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int n = orbit->n, P = balance->unknowns;
	double omega = balance->at[orbit->size - 1], sum = complete(balance);
	double *x = balance->rhs;

	(void)residual; /* its parts are in the defects */
	for (int i = 0; i < P; i++)
		x[i] = -balance->other_defect[balance->slot[i]]*balance->row_scale[i];
	x[P] = 0.0;
	hawser__balance_invert(balance, x, ESTIMATE_RESIDUAL);
	for (int i = 0; i < P; i++) {
		int h = (balance->slot[i]/n + 1)/2;
		double part = x[i]*balance->col_scale[i];

		sum += part*part*(h ? 0.5 : 1.0)*(1.0 + h*h*omega*omega);
	}
	return sqrt(sum)/orbit->X + fabs(x[P]) +
	       ROUND_OFF*hawser__balance_norm_inverse(balance);
}
