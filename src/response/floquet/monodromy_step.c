/* response/floquet/monodromy_step.c - the transition matrix of one step of one component (monodromy.h).
 *
 *    S      nodes per step, 8        w     coordinates of the component
 *    h      step in time             a     mean damping of the component
 *
 * Displacements are scaled by their frequencies. The transition matrix of an undamped coordinate is
 * then a rotation, whatever its frequency, and the QR iteration is as accurate as possible.
 *
 * Error estimate: in a step of z = h w rad of an oscillator w, the last Legendre coefficient of h
 * x'' is 15 z j_7(z/2), about 5.8e-8 z^8; the error of the step is 2.2e-19 z^17 (from the Pade
 * approximation of exp). The coefficient is computed, and the error follows from it. If K varies,
 * both depend on the same decay of the coefficients.
 *
 * Overdamped coordinates that decay within a step, as those of a full-order model with damping by its
 * stiffness, need a method that lets them decay: Radau IIA, whose error is 7.4e-18 z^16. z is then
 * x exp(at/2) with the least damping, since z would grow beyond any step with the mean. What counts is
 * the error of motions that outlast some steps: the coefficient of those that the matrix of the step
 * leaves.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>

#include "core/report.h"
#include "response/floquet/monodromy.h"

#define S HAWSER__NODES
/* Coefficient of the last node polynomial in the solution over a step of one radian. */
#define LAST_COEFFICIENT 5.8e-8
#define RADAU_ERROR 7.4e-18 /* error of such a step with Radau's nodes; it grows with its 16th power */
#define OUTLAST 4 /* steps that motions outlast whose error counts; chosen, half of the fewest */
#define DECAY 6.0 /* largest rate of decay in a step of which Gauss' nodes are accurate, to 4e-6 */

/* The rate at which the damping that differs between coordinates separates motions; of an
 * overdamped coordinate z both grows and decays. */
static double spread(const struct hawser__component *c, const struct hawser__variational *system)
{
	double most = 0.0;

	for (int p = 0; p < c->w; p++) {
		int at = c->member[p]*(c->n + 1);
		double over = 0.25*c->damping*c->damping - 0.5*system->K[at];

		most = fmax(most, fabs(0.5*system->D[at] - c->damping) + 2.0*sqrt(fmax(over, 0.0)));
	}
	return most;
}

/* The mean damping, with which the product keeps its norm; where others decay within a step
 * (see above), that of the slowest motion. Such steps are those of a stiff model, which need not
 * resolve everything, and the most steps of others. */
double hawser__component_damping(struct hawser__component *c, const struct hawser__monodromy *monodromy,
                                 const struct hawser__variational *system)
{
	int stiff = monodromy->fastest < INFINITY && !monodromy->haste;
	double steps = stiff ? monodromy->steps : fmax(monodromy->steps, monodromy->most);
	double apart, least = INFINITY;

	for (int p = 0; p < c->w; p++) {
		int at = c->member[p]*(c->n + 1);
		double own = 0.5*system->D[at];

		c->damping += own/c->w;
		least = fmin(least, own - sqrt(fmax(own*own - 2.0*system->K[at], 0.0)));
	}
	apart = spread(c, system);
	c->overdamped = apart*c->h*monodromy->steps > DECAY*steps;
	c->damping = c->overdamped ? least : c->damping;
	c->table = c->overdamped ? &monodromy->radau : &monodromy->gauss;
	return apart;
}

/* Column q of K - a D/2 + a^2/4 and of D - a, for z, at node i. */
static void columns_at(double *stiff, double *damp, const struct hawser__monodromy *monodromy,
                       const struct hawser__component *c, int i, int q)
{
	for (int p = 0; p < c->w; p++) {
		size_t e = (size_t)i*c->n*c->n + (size_t)c->member[p]*c->n + c->member[q];

		stiff[p] = monodromy->stiff[e] - 0.5*c->damping*monodromy->damp[e];
		damp[p] = monodromy->damp[e];
	}
	stiff[q] += 0.25*c->damping*c->damping;
	damp[q] -= c->damping;
}

static void fill_system(struct hawser__monodromy *monodromy, const struct hawser__component *c)
{
	int w = c->w, wide = S*w;
	double h = c->h, *k = monodromy->product, *d = k + w;

	for (int i = 0; i < S; i++)
		for (int q = 0; q < w; q++) {
			double *at = monodromy->matrix + (size_t)q*wide + (size_t)i*w;
			double *rhs = monodromy->rhs + (size_t)q*wide + (size_t)i*w;

			columns_at(k, d, monodromy, c, i, q);
			for (int j = 0; j < S; j++) {
				double twice = h*h*c->table->twice[i][j], once = h*c->table->once[i][j];

				for (int p = 0; p < w; p++)
					at[(size_t)j*w*wide + p] = twice*k[p] + once*d[p];
			}
			at[(size_t)i*w*wide + q] += 1.0;
			for (int p = 0; p < w; p++) {
				rhs[p] = -k[p]/monodromy->scale[c->member[q]];
				rhs[(size_t)w*wide + p] = -c->table->node[i]*h*k[p] - d[p];
			}
		}
}

/* The transition matrix of the step [2w][2w] from the accelerations in rhs; returns the estimated
 * error, from the last coefficients [w][2w]. */
static double read_step(struct hawser__monodromy *monodromy, const struct hawser__component *c)
{
	int w = c->w, wide = S*w, m = 2*w;
	double h = c->h, worst = 0.0, *last = monodromy->product, *left = last + (size_t)w*m;
	const struct hawser__collocation *table = c->table;

	for (int q = 0; q < m; q++) {
		const double *a = monodromy->rhs + (size_t)q*wide;

		for (int p = 0; p < w; p++) {
			double once = 0.0, twice = 0.0, sum = 0.0;
			double scale = monodromy->scale[c->member[p]];

			for (int i = 0; i < S; i++) {
				once += table->end_once[i]*a[i*w + p];
				twice += table->end_twice[i]*a[i*w + p];
				sum += table->transform[S - 1][i]*a[i*w + p];
			}
			last[(size_t)p*m + q] = sum;
			twice = h*h*twice + (q == p + w ? h : 0.0);
			monodromy->step[(size_t)p*m + q] = scale*twice + (q == p);
			monodromy->step[(size_t)(w + p)*m + q] = h*once + (q == p + w);
		}
	}
	for (int k = 0; k < OUTLAST && c->overdamped; k++) {
		double *before = last;

		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, w, m, m, 1.0, before, m,
		            monodromy->step, m, 0.0, left, m);
		last = left;
		left = before;
	}
	for (int q = 0; q < m; q++)
		worst = fmax(worst, h*cblas_dnrm2(w, last + q, m)/LAST_COEFFICIENT);
	return c->overdamped ? RADAU_ERROR*worst*worst : HAWSER__STEP_ERROR*pow(worst, 17.0/8.0);
}

/* K and D at the nodes of a step. */
static void evaluate(struct hawser__monodromy *monodromy, const struct hawser__variational *system,
                     int step)
{
	int n2 = system->n*system->n, columns = 2*monodromy->order + 1;
	const double *table = monodromy->table + (size_t)step*S*columns;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, S, n2, 2*system->order + 1, 1.0,
	            table, columns, system->K, n2, 0.0, monodromy->stiff, n2);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, S, n2, 2*system->order_d + 1, 1.0,
	            table, columns, system->D, n2, 0.0, monodromy->damp, n2);
}

enum hawser_status hawser__monodromy_step(struct hawser__monodromy *monodromy, double *error,
                                          const struct hawser__variational *system,
                                          const struct hawser__component *c, int step,
                                          struct hawser_report *report)
{
	int wide = S*c->w;

	monodromy->operations += 1.2*pow(wide, 3.0); /* 2/3 to factorise, 1/2 for the 2 w right sides */
	evaluate(monodromy, system, step);
	fill_system(monodromy, c);
	if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, wide, 2*c->w, monodromy->matrix, wide,
	                       monodromy->pivot, monodromy->rhs, wide))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "floquet",
		                    "a step of the variational equations at Omega %.9g is "
		                    "singular: its numbers lie too far apart", system->omega);
	*error += read_step(monodromy, c);
	return HAWSER_OK;
}
