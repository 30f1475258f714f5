/* response/floquet/periodic.c - Floquet multipliers of x' = A(t) x for any periodic matrix.
 *
 * Steps of collocation at 8 Gauss nodes (order 16, A-stable) yield the segments for
 * hawser_floquet_product, so that multipliers of 1 and 1e-65 both keep their digits. A need not be
 * that of a model, nor smooth at the ends of steps: discontinuities there (Meissner's equation)
 * cause no error. The number of steps is doubled until the logarithms no longer change.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/linear.h>

#include "core/report.h"
#include "response/orbit/collocation.h"

#define S HAWSER__NODES
#define STILL 1e-13 /* largest change of a logarithm, absolute or relative, whichever is larger:
                     * some hundred units of round-off */

enum { FIRST = 8, MOST = 2048 };

struct periodic {
	void (*matrix)(void *context, double *A, double t);
	void *context;
	int m;
	double period;
	struct hawser__collocation table;
	double *A;       /* [S][m][m] at the nodes */
	double *system;  /* [S m][S m] column-major */
	double *rates;   /* [m][S m] column-major: those at the nodes for each column of x0 */
	int *pivot;
	double *segment; /* [steps][m][m] */
};

/* K_i - h sum a_ij A_i K_j = A_i x0, x0 the columns of the identity. */
static int step(struct periodic *p, double *end, double t, double h)
{
	int m = p->m, size = S*m;

	for (int i = 0; i < S; i++)
		p->matrix(p->context, p->A + (size_t)i*m*m, t + h*p->table.node[i]);
	for (int i = 0; i < S; i++)
		for (int r = 0; r < m; r++)
			for (int c = 0; c < m; c++) {
				double a = p->A[((size_t)i*m + r)*m + c];

				p->rates[(size_t)c*size + i*m + r] = a;
				for (int j = 0; j < S; j++)
					p->system[(size_t)(j*m + c)*size + i*m + r] =
						(i == j && r == c) - h*p->table.once[i][j]*a;
			}
	if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, size, m, p->system, size, p->pivot, p->rates, size))
		return 1;
	for (int r = 0; r < m; r++)
		for (int c = 0; c < m; c++) {
			double sum = 0.0;

			for (int j = 0; j < S; j++)
				sum += p->table.end_once[j]*p->rates[(size_t)c*size + j*m + r];
			end[r*m + c] = (r == c) + h*sum;
		}
	return 0;
}

static enum hawser_status with_steps(struct periodic *p, double *log_modulus, double *argument,
                                     int steps,
                                     struct hawser_report *report)
{
	size_t square = (size_t)p->m*p->m;

	for (int k = 0; k < steps; k++)
		if (step(p, p->segment + (size_t)k*square, p->period*k/steps, p->period/steps))
			return hawser__fail(report, HAWSER_ERR_NAN, "periodic",
			                    "step %d of %d has no solution: is the matrix finite?", k + 1,
			                    steps);
	for (size_t e = 0; e < (size_t)steps*square; e++)
		if (!isfinite(p->segment[e]))
			return hawser__fail(report, HAWSER_ERR_NAN, "periodic",
			                    "the matrix is not finite at some time of the period");
	return hawser_floquet_product(log_modulus, argument, p->segment, steps, p->m, report);
}

static double change(const double *now, const double *before, int m)
{
	double most = 0.0;

	for (int i = 0; i < m; i++)
		most = fmax(most, fabs(now[i] - before[i])/fmax(1.0, fabs(now[i])));
	return most;
}

static enum hawser_status double_steps(struct periodic *p, double *log_modulus, double *argument,
                                       double *error, double *before, struct hawser_report *report)
{
	double last = INFINITY;
	enum hawser_status status = HAWSER_OK;

	for (int steps = FIRST; !status && steps <= MOST; steps *= 2) {
		memcpy(before, log_modulus, (size_t)p->m*sizeof *before);
		status = with_steps(p, log_modulus, argument, steps, report);
		*error = steps > FIRST ? change(log_modulus, before, p->m) : INFINITY;
		/* or until round-off prevents a further decrease */
		if (*error <= STILL || (last < 1e-9 && *error >= 0.5*last))
			break;
		last = *error;
	}
	return status;
}

enum hawser_status hawser_periodic_multipliers(double *log_modulus, double *argument, double *error,
                                               void (*matrix)(void *context, double *A, double t),
                                               void *context, int m, double period,
                                               struct hawser_report *report)
{
	struct periodic p = {.matrix = matrix, .context = context, .m = m, .period = period};
	size_t square = (size_t)m*m, size = (size_t)S*m;
	double *memory;
	enum hawser_status status;

	if (m < 1 || !(period > 0.0 && isfinite(period)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "periodic",
		                    "%d states with the period %g: both must be positive", m, period);
	memory = calloc(S*square + size*size + size*m + MOST*square + m, sizeof *memory);
	p.pivot = malloc(size*sizeof *p.pivot);
	if (!memory || !p.pivot) {
		free(memory);
		free(p.pivot);
		return hawser__no_memory(report, "periodic");
	}
	p.A = memory;
	p.system = p.A + S*square;
	p.rates = p.system + size*size;
	p.segment = p.rates + size*m;
	hawser__collocation_make(&p.table);
	memset(log_modulus, 0, (size_t)m*sizeof *log_modulus);
	status = double_steps(&p, log_modulus, argument, error, p.segment + MOST*square, report);
	free(memory);
	free(p.pivot);
	return status;
}
