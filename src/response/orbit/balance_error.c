/* response/orbit/balance_error.c - distance of a corrected orbit from the true branch.
 *
 *   r   defects of the orbit y: of the active pairs the residual of the corrector, of the others the
 *       truncation
 *   d   first-order responses of the missing pairs to their defects (balance_active.c)
 *
 * The orbit y + d has new defects r' in the equations of the active pairs. Solving these equations
 * once more gives the correction of the active pairs. This is one sweep of the block Gauss-Seidel
 * iteration towards the true orbit. In a sweep the missing pairs are treated one by one and do not
 * respond to the active ones, so that a second sweep follows. If the second sweep is not much
 * smaller, the estimate is increased by the sum of further sweeps with the same ratio.
 *
 * The norm of the inverse Jacobian times the norm of the defects would be a bound, but far too
 * large: it contains the narrow resonances of every harmonic with every lightly damped coordinate
 * and overstates the error of a full-order orbit by up to 1e5. It is used for round-off only, since
 * a nearly singular matrix determines no orbit, however small the defects are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "response/orbit/balance.h"

#define ESTIMATE_RESIDUAL 1e-2 /* relative residual of the solution: two digits of an error */
/* relative round-off of the defects, which are differences of terms about ten times as large */
#define ROUND_OFF 6e-14
#define SLOWEST 0.1 /* largest ratio of two sweeps that is extrapolated: then ten more sweeps */
/* The error of an amplitude, or of the state at one phase, may exceed the root mean square over
 * all phases (by at most 3.1 in 5300 numbers; bench/estimates frf). */
#define SAFETY 4.0

/* at += d up to harmonic `order`. Returns the sum of squares of the rest of d, as that of a state. */
static double add_missing(struct hawser__balance *balance, int order)
{
	int n = balance->base.n;
	double omega = hawser__orbit_omega(&balance->base, balance->at), sum = 0.0;

	for (int h = 0; h <= balance->reach; h++)
		for (int j = 0; j < n; j++) {
			double answer[2], size;

			if (h <= balance->order && balance->active[h*n + j])
				continue;
			size = hawser__balance_missing(balance, answer, h, j, omega);
			if (h > order) {
				sum += size*size;
				continue;
			}
			balance->at[hawser__cos(n, h, j)] += answer[0];
			if (h)
				balance->at[hawser__sin(n, h, j)] += answer[1];
		}
	return sum;
}

static void swap(double **a, double **b)
{
	double *keep = *a;

	*a = *b;
	*b = keep;
}

/* at += the correction of the active pairs. */
static void add_active(struct hawser__balance *balance)
{
	int P = balance->unknowns;
	double *x = balance->rhs;

	for (int i = 0; i < P; i++)
		x[i] = -balance->defect[balance->slot[i]]*balance->row_scale[i];
	x[P] = 0.0;
	hawser__balance_invert(balance, x, ESTIMATE_RESIDUAL);
	for (int i = 0; i < P; i++)
		balance->at[balance->slot[i]] += x[i]*balance->col_scale[i];
	balance->at[balance->base.size - 1] += x[P]*balance->base.W;
}

/* Square of the distance of a and b: of their states relative to X, and of their Omega relative to
 * W. */
static double distance2(const struct hawser__balance *balance, const double *a, const double *b)
{
	const struct hawser__orbit *orbit = &balance->base;
	int n = orbit->n, last = orbit->size - 1;
	double sum = 0.0, turn = (a[last] - b[last])/orbit->W, omega = hawser__orbit_omega(orbit, a);

	for (int i = 0; i < last; i++) {
		int h = (i/n + 1)/2;
		double part = a[i] - b[i];

		sum += part*part*(h ? 0.5 : 1.0)*(1.0 + h*h*omega*omega);
	}
	return sum/(orbit->X*orbit->X) + turn*turn;
}

/* Two sweeps. The orbit, its samples and its defects are restored. */
static double sweep(struct hawser__balance *balance)
{
	size_t size = (size_t)balance->base.size*sizeof(double);
	int order = balance->reach < balance->top ? balance->reach : balance->top;
	double rest, far[2] = {0.0};

	memcpy(balance->orbit, balance->at, size);
	rest = add_missing(balance, order);
	swap(&balance->defect, &balance->other_defect);
	swap(&balance->base.samples, &balance->other_samples);
	for (int k = 0; k < 2; k++) {
		memcpy(balance->before, k ? balance->at : balance->orbit, size);
		if (k) {
			hawser__balance_defects(balance, order);
			(void)add_missing(balance, order);
		}
		hawser__balance_defects(balance, order);
		add_active(balance);
		far[k] = distance2(balance, balance->at, balance->before);
	}
	rest = rest/(balance->base.X*balance->base.X) + distance2(balance, balance->at, balance->orbit);
	swap(&balance->defect, &balance->other_defect);
	swap(&balance->base.samples, &balance->other_samples);
	memcpy(balance->at, balance->orbit, size);
	(void)hawser__orbit_place(&balance->base, balance->at[balance->base.size - 1]);
	if (far[1] == 0.0)
		return sqrt(rest);
	return sqrt(rest) + sqrt(far[1])/fmax(1.0 - sqrt(far[1]/far[0]), SLOWEST);
}

double hawser__balance_error(struct hawser__orbit *orbit, double residual)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;

	(void)residual; /* the defects contain it */
	orbit->round_off = ROUND_OFF*hawser__balance_norm_inverse(balance);
	balance->doubt = SAFETY*sweep(balance) + orbit->round_off;
	return balance->doubt;
}
