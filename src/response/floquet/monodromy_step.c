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
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/floquet/monodromy.h"

#define S HAWSER__NODES
/* Coefficient of the last node polynomial in the solution over a step of one radian. */
#define LAST_COEFFICIENT 5.8e-8

/* K - a D/2 + a^2/4 and D - a, for z, at node i. */
static double stiff_at(const struct hawser__monodromy *monodromy,
                       const struct hawser__component *c, int i, int p, int q)
{
	size_t e = (size_t)i*c->n*c->n + (size_t)c->member[p]*c->n + c->member[q];

	return monodromy->stiff[e] - 0.5*c->damping*monodromy->damp[e] +
	       (p == q ? 0.25*c->damping*c->damping : 0.0);
}

static double damp_at(const struct hawser__monodromy *monodromy,
                      const struct hawser__component *c, int i, int p, int q)
{
	return monodromy->damp[(size_t)i*c->n*c->n + (size_t)c->member[p]*c->n + c->member[q]] -
	       (p == q ? c->damping : 0.0);
}

static void fill_system(struct hawser__monodromy *monodromy, const struct hawser__component *c)
{
	int w = c->w, wide = S*w;
	double h = c->h;

	memset(monodromy->matrix, 0, (size_t)wide*wide*sizeof(double));
	for (int i = 0; i < S; i++)
		for (int q = 0; q < w; q++)
			for (int p = 0; p < w; p++) {
				double k = stiff_at(monodromy, c, i, p, q);
				double d = damp_at(monodromy, c, i, p, q);
				double *at = monodromy->matrix + (size_t)q*wide + (size_t)i*w + p;
				double *rhs = monodromy->rhs + (size_t)q*wide + (size_t)i*w + p;

				for (int j = 0; j < S; j++)
					at[(size_t)j*w*wide] = h*h*monodromy->gauss.twice[i][j]*k +
					                       h*monodromy->gauss.once[i][j]*d;
				at[(size_t)i*w*wide] += p == q;
				rhs[0] = -k/monodromy->scale[c->member[q]];
				rhs[(size_t)w*wide] = -monodromy->gauss.node[i]*h*k - d;
			}
}

/* The transition matrix of the step [2w][2w] from the accelerations in rhs; returns the estimated
 * error. */
static double read_step(struct hawser__monodromy *monodromy, const struct hawser__component *c)
{
	int w = c->w, wide = S*w;
	double h = c->h, worst = 0.0;
	const struct hawser__collocation *gauss = &monodromy->gauss;

	for (int q = 0; q < 2*w; q++) {
		const double *a = monodromy->rhs + (size_t)q*wide;
		double last2 = 0.0;

		for (int p = 0; p < w; p++) {
			double once = 0.0, twice = 0.0, last = 0.0;
			double scale = monodromy->scale[c->member[p]];

			for (int i = 0; i < S; i++) {
				once += gauss->end_once[i]*a[i*w + p];
				twice += gauss->end_twice[i]*a[i*w + p];
				last += gauss->transform[S - 1][i]*a[i*w + p];
			}
			last2 += last*last;
			twice = h*h*twice + (q == p + w ? h : 0.0);
			monodromy->step[(size_t)p*2*w + q] = scale*twice + (q == p);
			monodromy->step[(size_t)(w + p)*2*w + q] = h*once + (q == p + w);
		}
		worst = fmax(worst, last2);
	}
	return HAWSER__STEP_ERROR*pow(h*sqrt(worst)/LAST_COEFFICIENT, 17.0/8.0);
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
